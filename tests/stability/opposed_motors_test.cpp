// Motors that blow against each other, to 1000 m/s: all values stay finite and bounded. Sub-steps carry what they can, the cap
// limits the rest. One raw step, however far the air moves in it, stays finite too.

#include "tests/stability/watch.h"

namespace {

using namespace windrow;
using namespace windrow::test;

constexpr glm::ivec3 k_opposed_cells(24, 12, 16);
constexpr float k_opposed_speed = 1000.0f;

/// Puts the motors in; what is returned is called before each step of dt.
using Opponents = std::function<void(double dt)> (*)(Wind& wind);

std::function<void(double)> fans(Wind& wind) {
    drive(wind, {-3.0, 0.0, 0.0}, {1.0f, 0.0f, 0.0f}, k_opposed_speed);
    drive(wind, {3.0, 0.0, 0.0}, {-1.0f, 0.0f, 0.0f}, k_opposed_speed);
    drive(wind, {0.0, 2.0, 0.0}, {0.0f, -1.0f, 0.2f}, k_opposed_speed, 1.0f);
    return [](double) {};
}

// Cylinders, so that the speed is the same all along; at the mouth they are a fan of 1000 m/s.
std::function<void(double)> jets(Wind& wind) {
    const auto jet = [&](glm::dvec3 position, glm::vec3 direction) {
        added(wind, JetMotor{.position = position,
                             .direction = direction,
                             .length = 5.0f,
                             .start_radius = 1.5f,
                             .end_radius = 1.5f,
                             .law = Drive{k_opposed_speed, 1e6f}});
    };
    jet({-8.0, 0.3, 0.0}, {1.0f, 0.0f, 0.0f});
    jet({8.0, -0.2, 0.4}, {-1.0f, 0.1f, 0.0f});
    jet({0.0, 0.0, 7.0}, {0.0f, 0.0f, -1.0f});
    return [](double) {};
}

// Two bodies that fly to and fro and meet in the middle.
std::function<void(double)> wakes(Wind& wind) {
    const WakeMotor body{.position = {0.0, 0.0, 0.0}, .radius = 2.0f, .law = WakeDrive{.per_metre = 1e4f}};
    const MotorId one = added(wind, body), other = added(wind, body);
    return [&wind, one, other, at = 0.0, sign = 1.0](double dt) mutable {
        at += sign * static_cast<double>(k_opposed_speed) * dt;
        sign = -sign;
        EXPECT_TRUE(wind.motors().move(one, {at, 0.2, 0.0}));
        EXPECT_TRUE(wind.motors().move(other, {-at, 0.2, 0.1}));
    };
}

// All kinds with a target, and a whirl between them.
std::function<void(double)> all_kinds(Wind& wind) {
    drive(wind, {-4.0, 0.0, 0.0}, {1.0f, 0.0f, 0.0f}, k_opposed_speed);
    added(wind, JetMotor{.position = {9.0, 0.0, 0.0},
                         .direction = {-1.0f, 0.0f, 0.0f},
                         .start_radius = 1.5f,
                         .end_radius = 1.5f,
                         .law = Drive{k_opposed_speed, 1e6f}});
    added(wind,
          VortexMotor{.axis = {0.2f, 1.0f, 0.0f}, .radius = 4.0f, .half_length = 3.0f, .law = Drive{k_opposed_speed, 1e6f}});
    return wakes(wind);
}

constexpr struct {
    const char* name;
    Opponents add;
} k_opponents[] = {{"fans", fans}, {"jets", jets}, {"wakes", wakes}, {"all", all_kinds}};

// 1000 m/s are 14.3 cells in 1/70 s and 16.7 in 1/60 s: eight parts carry 16 along each axis. In 1 s that is 16 m/s.
constexpr struct {
    const char* name;
    float max_cfl;
    double dt;
    bool capped;
} k_manners[] = {{"substeps", 2.0f, 1.0 / 70.0, false},
                 {"capped", 2.0f, 1.0 / 60.0, true},
                 {"capped_1_s", 2.0f, 1.0, true},
                 {"raw", 1e6f, 1.0 / 60.0, false}};

TEST(OpposedMotors, OfAThousandMetresASecond) {
    for (const auto& opponents : k_opponents)
        for (const auto& manner : k_manners) {
            Worst worst;
            for (const BoundaryKind kind : k_kinds) {
                if (!whole_sweeps() && kind != BoundaryKind::open && kind != BoundaryKind::no_slip)
                    continue;
                Wind wind = made({.cells = k_opposed_cells,
                                  .boundaries = Boundaries::all(kind),
                                  .jump_speed = 0.0f,
                                  .max_cfl = manner.max_cfl});
                const auto prepare = opponents.add(wind);
                const double carried = std::sqrt(3.0) * 8.0 * static_cast<double>(manner.max_cfl) / manner.dt;
                Watch watch(wind, std::min(double(k_opposed_speed), carried));
                for (int n = 0; n < shortened(250); ++n) {
                    prepare(manner.dt);
                    watch.step(manner.dt);
                }
                EXPECT_EQ(watch.max_substeps() > 1, manner.max_cfl == 2.0f);
                if (manner.capped) {
                    EXPECT_GT(watch.capped_steps(), 0);
                }
                worst.meet(watch);
            }
            worst.judge(std::string("opposed_1000_mps_") + opponents.name + '_' + manner.name, {k_input_energy, k_speed_factor});
        }
}

TEST(OpposedMotors, OfAStorm) {
    for (int kind = 0; kind < 4; ++kind)
        for (const bool raw : {false, true}) {
            Wind wind =
                made({.cells = k_opposed_cells, .boundaries = Boundaries::all(k_kinds[kind]), .max_cfl = raw ? 1e6f : 2.0f});
            drive(wind, {-3.0, 0.0, 0.0}, {1.0f, 0.0f, 0.0f}, 50.0f);
            drive(wind, {3.0, 0.0, 0.0}, {-1.0f, 0.0f, 0.0f}, 50.0f);
            drive(wind, {0.0, 2.0, 0.0}, {0.0f, -1.0f, 0.2f}, 50.0f, 1.0f);
            Watch watch(wind, 50.0);
            watch.run(2'000, [](int n) { return n % 100 < 50 ? 1.0 / 60.0 : 1.0; });
            watch.judge(std::string("opposed_50_mps_") + k_kind_names[kind] + (raw ? "_raw" : ""),
                        {k_input_energy, k_opposed_factor});
        }
}

TEST(OpposedMotors, OneAloneOfAThousandMetresASecond) {
    for (int kind = 0; kind < 4; ++kind) {
        Wind wind = made({.cells = k_opposed_cells, .boundaries = Boundaries::all(k_kinds[kind])});
        drive(wind, {0.3, 0.2, 0.1}, {1.0f, 0.1f, 0.0f}, k_opposed_speed, 1.0f);
        Watch watch(wind, double(k_opposed_speed));
        watch.run(1'000, 1.0 / 60.0);
        watch.judge(std::string("one_1000_mps_") + k_kind_names[kind], {k_input_energy, 1.5});
    }
}

} // namespace
