// Viscosity from nothing to 10^4 h^2/dt, across each border between the methods of diffusion (operators.h), with each kind of side.

#include "tests/stability/watch.h"

#include <cstdio>

namespace {

using namespace windrow;
using namespace windrow::test;

constexpr glm::ivec3 k_viscous_cells(16, 12, 20);
constexpr double k_viscous_dt = 0.1;

std::string name_of(const char* what, double number) {
    char text[64];
    std::snprintf(text, sizeof text, "%s_%g", what, number);
    return text;
}

// CFL 1, where a pass of diffusion after the advection would blow up.
TEST(Viscosity, FromNothingToTenThousand) {
    for (int kind = 0; kind < 4; ++kind)
        for (const Scheme scheme : {Scheme::second_order, Scheme::stable_fluids})
            for (const auto& [ratio, method] : {std::pair{0.0, DiffusionMethod::none},
                                                {0.99e-4, DiffusionMethod::none},
                                                {1.01e-4, DiffusionMethod::one_pass},
                                                {1e-3, DiffusionMethod::one_pass},
                                                {0.08, DiffusionMethod::one_pass},
                                                {0.0833, DiffusionMethod::one_pass},
                                                {0.084, DiffusionMethod::implicit},
                                                {0.17, DiffusionMethod::implicit},
                                                {0.24, DiffusionMethod::implicit},
                                                {1.0, DiffusionMethod::implicit},
                                                {100.0, DiffusionMethod::implicit},
                                                {1e4, DiffusionMethod::implicit}}) {
                Wind wind = made({.cells = k_viscous_cells,
                                  .boundaries = Boundaries::all(k_kinds[kind]),
                                  .viscosity = static_cast<float>(ratio / k_viscous_dt),
                                  .relaxation_time = 0.0f,
                                  .scheme = scheme,
                                  .max_cfl = 1e6f});
                ASSERT_TRUE(wind.set_velocity(projected(white_noise(k_viscous_cells, 10.0f, 36), wind.box())));
                Watch watch(wind);
                const int steps = shortened(300);
                for (int n = 0; n < steps; ++n) {
                    const DiffusionMethod used = watch.step(k_viscous_dt).diffusion;
                    const bool pays = method == DiffusionMethod::none && used == DiffusionMethod::one_pass; // what it owed
                    ASSERT_TRUE(used == method || pays) << ratio;
                }
                const std::string name = name_of("viscosity", ratio) + '_' + k_kind_names[kind] +
                                         (scheme == Scheme::stable_fluids ? "_stable_fluids" : "");
                watch.judge(name, {1.001, 1.1});
                if (ratio >= 0.08 && !k_sanitized) { // a wave that a pass turns over instead of damping would stay
                    WINDROW_EXPECT_FIGURE("stability/" + name + "/energy_at_end", watch.energy(), 1e-3);
                }
            }
}

Boundaries running_walls() {
    Boundaries boundaries = Boundaries::all(BoundaryKind::no_slip);
    boundaries.y_low.wall_velocity = {-4.0f, 0.0f, 3.0f};
    boundaries.y_high.wall_velocity = {5.0f, 0.0f, 0.0f};
    boundaries.x_low = boundaries.x_high = Boundary{};
    return boundaries;
}

// Walls that run and a wind from outside, mixed, at cells of another size: what is pulled toward them all passes none of them.
// The layer at the walls is thinner than a cell: with mirrored ghosts of the other sign in the advection, this reached 2.2.
TEST(Viscosity, BetweenWallsThatRun) {
    for (const float cell_size : {0.1f, 1.0f, 10.0f})
        for (const double ratio : {1e-3, 0.08, 0.084, 1.0, 1e4}) {
            Wind wind = made({.cells = k_viscous_cells,
                              .cell_size = cell_size,
                              .boundaries = running_walls(),
                              .ambient = {5.0f, 0.0f, 0.0f},
                              .viscosity = static_cast<float>(ratio * cell_size * cell_size / k_viscous_dt)});
            Watch watch(wind, 5.0);
            watch.run(300, k_viscous_dt);
            watch.judge(name_of("viscosity_walls_run", ratio) + '_' + name_of("h", cell_size),
                        {k_input_energy, 1.5}); // what shear may roll up to
        }
}

// The same in a long duct, where such ghosts let the wind at the walls grow with each cell that it passed, to 6.6 times at the
// end.
TEST(Viscosity, AlongWallsThatRun) {
    Wind wind = made({.cells = {128, 12, 20},
                      .cell_size = 0.1f,
                      .boundaries = running_walls(),
                      .ambient = {5.0f, 0.0f, 0.0f},
                      .viscosity = 1e-4f});
    Watch watch(wind, 5.0);
    watch.run(400, k_viscous_dt);
    watch.judge("viscosity_long_duct", {k_input_energy, 1.5});
}

TEST(Viscosity, AUniformWindBearsAny) {
    // Nothing to diffuse, nothing to project: the stiffest solve must give it back, though ambient is still.
    for (const double ratio : {1.0, 100.0, 1e4, 1e6, 1e8}) {
        Wind wind = made({.cells = k_viscous_cells,
                          .boundaries = Boundaries::all(BoundaryKind::periodic),
                          .viscosity = static_cast<float>(ratio),
                          .relaxation_time = 0.0f});
        wind.set_velocity([](glm::dvec3) { return glm::vec3(1.0f, -0.5f, 0.25f); });
        Watch watch(wind);
        take_steps(watch, 100, 1.0);
        const std::string name = name_of("viscosity_uniform_wind", ratio);
        watch.judge(name, {1.001, 1.001});
        WINDROW_EXPECT_FIGURE("stability/" + name + "/change_mps", largest_off(wind.field(), {1.0f, -0.5f, 0.25f}), 1e-4);
    }
}

} // namespace
