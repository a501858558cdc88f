// The classic scheme in ducts: walls that slip, that drag and that move, periodic ends, viscosity, uneven steps, linear and cubic.
#include "fluid/wind.h"
#include "tests/bits/stories.h"

namespace windrow::bits {
namespace {

Boundaries duct_boundaries() {
    Boundaries boundaries = Boundaries::all(BoundaryKind::free_slip);
    boundaries.x_low.kind = boundaries.x_high.kind = BoundaryKind::periodic;
    boundaries.z_high.kind = BoundaryKind::open;
    boundaries.y_low.kind = BoundaryKind::no_slip;
    boundaries.y_low.wall_velocity = {1.5f, 0.0f, 0.0f};
    return boundaries;
}

void flow(Hashes& hashes, const std::string& name, const Config& config) {
    Wind wind = must(Wind::create(config));
    Numbers numbers(21);
    std::vector<glm::vec4> noise(wind.box().cell_count());
    for (glm::vec4& cell : noise)
        cell = {numbers.between(-2.0f, 2.0f), numbers.between(-2.0f, 2.0f), numbers.between(-2.0f, 2.0f), 0.0f};
    must(wind.set_velocity(noise));
    (void)must(wind.motors().add(VortexMotor{.position = {1.0, 0.0, 0.5}, .radius = 3.0f}));
    (void)must(wind.motors().add(DirectionalMotor{.position = {-2.0, 1.0, 0.0}, .law = Force{20.0f}}));
    (void)must(wind.obstacles().add({.position = {2.5, -0.5, 1.0}, .shape = Sphere{1.4f}}));
    for (int step = 0; step < 60; ++step) {
        if (step == 40 && config.boundaries.y_high.solid()) {
            Boundaries changed = config.boundaries;
            changed.y_high.kind = BoundaryKind::no_slip;
            must(wind.set_boundaries(changed));
        }
        (void)wind.step(step % 9 == 8 ? 0.15 : step % 2 == 0 ? 1.0 / 60.0 : 1.0 / 37.0);
    }
    hashes.add(name + "/cells", std::as_bytes(wind.field()));
    hashes.add(name + "/snapshot", must(wind.save()));
}

} // namespace

std::vector<Hash> duct(Simd level, ParallelFor parallel_for) {
    Hashes hashes("duct");
    Config config{.cells = {19, 9, 13},
                  .boundaries = duct_boundaries(),
                  .ambient = admissible_ambient(duct_boundaries(), {3.0f, 0.0f, 1.0f}),
                  .viscosity = 0.4f,
                  .scheme = Scheme::stable_fluids,
                  .simd = level,
                  .parallel_for = parallel_for};
    flow(hashes, "stable_fluids_cubic", config);
    config.interpolation = Interpolation::linear;
    flow(hashes, "stable_fluids_linear", config);
    config.scheme = Scheme::second_order;
    config.viscosity = 3.0f;
    flow(hashes, "second_order_linear", config);
    config.cells = {16, 12, 24};
    config.cell_size = 0.7f;
    config.boundaries = Boundaries::all(BoundaryKind::periodic);
    config.pressure_solves = 3;
    flow(hashes, "periodic", config);
    return hashes.list();
}

} // namespace windrow::bits
