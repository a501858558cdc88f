// Boundaries whose kind changes while it blows through them: what was beyond a side is gone at once, and the pressure that stood
// against a wall with it.

#include "tests/stability/watch.h"

namespace {

using namespace windrow;
using namespace windrow::test;

constexpr glm::ivec3 k_changing_cells(16, 9, 12);

Boundary& side_of(Boundaries& boundaries, int number) {
    Boundary* const ordered[6] = {&boundaries.x_low,  &boundaries.x_high, &boundaries.y_low,
                                  &boundaries.y_high, &boundaries.z_low,  &boundaries.z_high};
    return *ordered[number];
}

/// Boundaries all of a kind; walls that carry the air along run at `speed`.
Boundaries all_of(BoundaryKind kind, float speed) {
    Boundaries boundaries = Boundaries::all(kind);
    for (int n = 0; n < 6 && kind == BoundaryKind::no_slip; ++n) {
        glm::vec3 velocity(speed);
        velocity[n / 2] = 0.0f;
        side_of(boundaries, n).wall_velocity = velocity;
    }
    return boundaries;
}

// Wind of 17 m/s across the box, a fan and noise; to and fro every third step, so that a history grows in between.
TEST(ChangingSides, EveryKindToEveryKind) {
    for (int from = 0; from < 4; ++from)
        for (int to = 0; to < 4; ++to) {
            if (from == to)
                continue;
            for (const Scheme scheme : {Scheme::second_order, Scheme::stable_fluids}) {
                Wind wind = made({.cells = k_changing_cells,
                                  .boundaries = all_of(k_kinds[from], 10.0f),
                                  .ambient = {15.0f, 5.0f, -6.0f},
                                  .viscosity = 0.5f,
                                  .scheme = scheme});
                ASSERT_TRUE(wind.set_velocity(white_noise(k_changing_cells, 8.0f, 51)));
                drive(wind, {2.0, 1.0, 0.0}, {1.0f, 0.0f, 0.5f}, 20.0f);
                Watch watch(wind, 20.0); // the fan's; wind outside and walls are slower
                for (int n = 0; n < shortened(400); ++n) {
                    if (n % 3 == 2) {
                        ASSERT_TRUE(wind.set_boundaries(all_of(k_kinds[n % 6 == 2 ? to : from], 10.0f)));
                    }
                    watch.step(n % 7 == 0 ? 0.3 : 1.0 / 60.0);
                }
                watch.judge(std::string("boundaries_") + k_kind_names[from] + "_to_" + k_kind_names[to] +
                                (scheme == Scheme::stable_fluids ? "_stable_fluids" : ""),
                            {k_input_energy, k_opposed_factor});
            }
        }
}

// One side alone, the others as they are; periodic ones change in pairs.
TEST(ChangingSides, OneSideAtATime) {
    for (const BoundaryKind others : {BoundaryKind::open, BoundaryKind::free_slip, BoundaryKind::no_slip}) {
        Wind wind = made({.cells = k_changing_cells, .boundaries = Boundaries::all(others), .ambient = {15.0f, 5.0f, -6.0f}});
        drive(wind, {-3.0, 0.0, 1.0}, {-1.0f, 0.2f, 0.5f}, 20.0f);
        Watch watch(wind, 20.0);
        for (int n = 0; n < shortened(600); ++n) {
            Boundaries boundaries = Boundaries::all(others);
            side_of(boundaries, (n / 2) % 6).kind = k_kinds[(n / 12) % 3];
            ASSERT_TRUE(wind.set_boundaries(boundaries));
            watch.step(1.0 / 60.0);
        }
        watch.judge(std::string("sides_one_by_one_others_") + k_kind_names[static_cast<int>(others)],
                    {k_input_energy, k_opposed_factor});
    }
}

Boundaries random_sides(Random& random, float wall_speed) {
    Boundaries boundaries;
    for (int axis = 0; axis < 3; ++axis) {
        const bool periodic = random.integer(0, 3) == 0;
        for (int end = 0; end < 2; ++end) {
            Boundary& side = side_of(boundaries, 2 * axis + end);
            side.kind = periodic ? BoundaryKind::periodic : static_cast<BoundaryKind>(random.integer(0, 2));
            if (side.kind == BoundaryKind::no_slip) {
                side.wall_velocity = random.vector(wall_speed);
                side.wall_velocity[axis] = 0.0f;
            }
        }
    }
    return boundaries;
}

TEST(ChangingSides, AnyMixToAnyMix) {
    Wind wind = made({.cells = {20, 11, 16}, .ambient = {5.0f, 2.0f, -3.0f}, .viscosity = 0.5f});
    drive(wind, {2.0, 1.0, 0.0}, {1.0f, 0.0f, 0.5f}, 20.0f);
    Watch watch(wind, 20.0);
    Random random(34);
    for (int n = 0; n < shortened(3'000); ++n) {
        if (n % 5 == 0) {
            EXPECT_TRUE(wind.set_boundaries(random_sides(random, 10.0f)));
        }
        watch.step(random.spread(1e-3, 0.5));
    }
    watch.judge("sides_any_mix", {k_input_energy, k_opposed_factor});
}

} // namespace
