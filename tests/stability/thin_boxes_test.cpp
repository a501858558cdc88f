// Hard cases stay finite: boxes one cell thick along one, two or all axes, with each boundary kind and with mixes of them.

#include "tests/stability/watch.h"

#include <cstdint>

namespace {

using namespace windrow;
using namespace windrow::test;

std::string name_of(glm::ivec3 cells) {
    return std::to_string(cells.x) + 'x' + std::to_string(cells.y) + 'x' + std::to_string(cells.z);
}

std::vector<Boundaries> kinds_and_mixes() {
    std::vector<Boundaries> list;
    for (const BoundaryKind kind : k_kinds)
        list.push_back(Boundaries::all(kind));
    list.push_back(Boundaries::open_over_floor());
    Boundaries tunnel = Boundaries::all(BoundaryKind::no_slip); // open ends, walls that run along
    tunnel.x_low = tunnel.x_high = Boundary{};
    tunnel.y_low.wall_velocity = {10.0f, 0.0f, -5.0f};
    list.push_back(tunnel);
    Boundaries ring = Boundaries::all(BoundaryKind::periodic); // with a floor and a lid of another kind
    ring.y_low.kind = BoundaryKind::no_slip;
    ring.y_high.kind = BoundaryKind::open;
    list.push_back(ring);
    Boundaries corner; // a wall opposite each open boundary
    corner.x_low.kind = corner.z_high.kind = BoundaryKind::free_slip;
    corner.y_low.kind = BoundaryKind::no_slip;
    list.push_back(corner);
    return list;
}

// Even steps keep a motor's flow in its place, uneven ones stir it.
double even(int) {
    return 1.0 / 60.0;
}
double uneven(int n) {
    return n % 10 == 0 ? 1.0 : 0.02;
}

/// Three cells across at most, and itself beyond some of its sides: see Lines.
bool a_line_of_its_own(glm::ivec3 cells, const Boundaries& boundaries) {
    int narrow = 0, wrapped = 0;
    for (int axis = 0; axis < 3; ++axis) {
        narrow += cells[axis] <= 3 ? 1 : 0;
        wrapped += boundaries.periodic(axis) ? 1 : 0;
    }
    return narrow >= 2 && wrapped > 0 && wrapped < 3;
}

void run(Worst& worst, const Config& config, float rate, double (*dt_of)(int), int steps) {
    Config about_the_origin = config;
    about_the_origin.floor = -0.5 * config.cells.y;
    Wind wind = made(about_the_origin);
    ASSERT_TRUE(wind.set_velocity(white_noise(config.cells, 5.0f, 33)));
    drive(wind, glm::dvec3(0.1), {1.0f, 1.0f, -1.0f}, 20.0f, 2.0f, rate);
    Watch watch(wind, 20.0);
    watch.run(steps, dt_of);
    worst.meet(watch);
}

TEST(ThinBoxes, BearAMotorAndEveryViscosity) {
    for (const glm::ivec3 cells :
         {glm::ivec3(1, 12, 16), glm::ivec3(16, 1, 12), glm::ivec3(12, 16, 1), glm::ivec3(1, 1, 24), glm::ivec3(24, 1, 1),
          glm::ivec3(1, 24, 1), glm::ivec3(1, 1, 1), glm::ivec3(2, 2, 2), glm::ivec3(3, 2, 1)})
        for (const Scheme scheme : {Scheme::second_order, Scheme::stable_fluids}) {
            Worst worst;
            for (const Boundaries& boundaries : kinds_and_mixes())
                for (const float viscosity : {0.0f, 1.0f, 1e3f})
                    for (double (*const dt_of)(int) : {even, uneven})
                        if (!a_line_of_its_own(cells, boundaries))
                            run(worst,
                                {.cells = cells,
                                 .boundaries = boundaries,
                                 .ambient = {3.0f, 1.0f, -2.0f},
                                 .viscosity = viscosity,
                                 .scheme = scheme},
                                1e6f, dt_of, 300);
            worst.judge("thin_" + name_of(cells) + (scheme == Scheme::stable_fluids ? "_stable_fluids" : ""),
                        {k_input_energy, k_opposed_factor});
        }
}

// Rooms a few cells wide: between no-slip walls two cells apart a motor of default rate once drove the wind to 121 times its own
// speed, since ghosts of the other sign stood where the advection reads.
TEST(ThinBoxes, NarrowRooms) {
    for (const glm::ivec3 cells : {glm::ivec3(2, 24, 24), glm::ivec3(4, 24, 4), glm::ivec3(6, 24, 6)})
        for (const float rate : {4.0f, 1e6f}) {
            Worst worst;
            for (const Boundaries& boundaries : kinds_and_mixes())
                run(worst, {.cells = cells, .boundaries = boundaries, .ambient = {3.0f, 1.0f, -2.0f}}, rate, even, 300);
            worst.judge("narrow_" + name_of(cells) + (rate > 4.0f ? "_rate_1e6" : "_rate_4"), {k_input_energy, k_opposed_factor});
        }
}

// A known limit. In a line of cells that has only itself beyond its sides, the wind across is a mere passenger of the wind along,
// which a motor two cells wide sets against itself from cell to cell, out of the projection's sight: where that converges for
// good, cubic reads feed the passenger, to 70 times the motor's speed. Linear ones do not. Stated; that it stays finite is asked.
TEST(ThinBoxes, Lines) {
    for (const glm::ivec3 cells : {glm::ivec3(1, 24, 1), glm::ivec3(2, 24, 2), glm::ivec3(24, 1, 1), glm::ivec3(1, 1, 24)})
        for (const Interpolation interpolation : {Interpolation::cubic, Interpolation::linear}) {
            Worst worst;
            for (const Boundaries& boundaries : kinds_and_mixes())
                for (double (*const dt_of)(int) : {even, uneven})
                    if (a_line_of_its_own(cells, boundaries))
                        run(worst,
                            {.cells = cells,
                             .boundaries = boundaries,
                             .ambient = {3.0f, 1.0f, -2.0f},
                             .interpolation = interpolation},
                            1e6f, dt_of, 1'000);
            const std::string name = "line_" + name_of(cells);
            if (interpolation == Interpolation::linear) {
                worst.judge(name + "_linear", {k_input_energy, k_opposed_factor});
            } else {
                EXPECT_TRUE(std::isfinite(figure("stability/" + name + "/energy", worst.energy())));
                EXPECT_TRUE(std::isfinite(figure("stability/" + name + "/max", worst.max())));
            }
        }
}

// In a box one cell thick the wind across it is a mere passenger of a flat flow, and a white start leaves cells where that flow
// converges for good. By default it settles; the raw step lets the passenger grow (largest |u| 5.5 of the start was seen).
TEST(ThinBoxes, WhiteNoise) {
    for (const glm::ivec3 cells : {glm::ivec3(1, 32, 32), glm::ivec3(32, 1, 32), glm::ivec3(32, 32, 1)}) {
        Worst by_default, raw;
        for (std::uint32_t seed = 1; seed <= 3; ++seed)
            for (const double dt : {0.1, 0.5, 2.0})
                for (const bool settles : {true, false}) {
                    Wind wind = made({.cells = cells,
                                      .boundaries = Boundaries::all(BoundaryKind::periodic),
                                      .relaxation_time = settles ? 20.0f : 0.0f,
                                      .max_cfl = settles ? 2.0f : 1e6f});
                    ASSERT_TRUE(wind.set_velocity(projected(white_noise(cells, 1.0f, seed), wind.box())));
                    Watch watch(wind);
                    watch.run(1'000, dt);
                    (settles ? by_default : raw).meet(watch);
                }
        by_default.judge("thin_noise_" + name_of(cells), {1.001, 1.5});
        EXPECT_TRUE(std::isfinite(figure("stability/thin_noise_raw_" + name_of(cells) + "/energy", raw.energy())));
        EXPECT_TRUE(std::isfinite(figure("stability/thin_noise_raw_" + name_of(cells) + "/max", raw.max())));
    }
}

} // namespace
