// Motors that come and go in every step, and motors that are elsewhere in every step: each step sees forces and sources that the
// history knows nothing of.

#include "tests/stability/watch.h"

namespace {

using namespace windrow;
using namespace windrow::test;

constexpr glm::ivec3 k_churned_cells(20, 12, 16);
constexpr float k_churn_speed = 30.0f;

Envelope some_envelope(Random& random) {
    return random.integer(0, 1) == 0 ? Envelope{} : Envelope{.attack = 0.01f, .hold = 0.02f, .decay = 0.01f};
}

/// Any kind of motor, anywhere in the box and near it. Sources are so weak that their flow is below k_churn_speed in free air, ten of
/// them together.
Motor some_motor(Random& random) {
    const glm::dvec3 position = random.point(10.0);
    const glm::vec3 direction(random.direction());
    switch (random.integer(0, 5)) {
    case 0:
        return DirectionalMotor{.position = position,
                                .direction = direction,
                                .region = Sphere{random.uniform(0.5f, 4.0f)},
                                .law = Drive{k_churn_speed, 1e6f},
                                .envelope = some_envelope(random)};
    case 1:
        return JetMotor{.position = position,
                        .direction = direction,
                        .start_radius = 1.5f,
                        .end_radius = 2.5f,
                        .law = Drive{k_churn_speed, 1e3f},
                        .envelope = some_envelope(random)};
    case 2:
        return VortexMotor{.position = position, .axis = direction, .law = Drive{-k_churn_speed, 1e3f}};
    case 3:
        return OmniMotor{.position = position, .radius = 2.0f, .speed = random.uniform(-2.0f, 2.0f)};
    case 4:
        return PressureMotor{.position = position, .radius = 2.0f, .speed = random.uniform(-2.0f, 2.0f), .duration = 0.05f};
    default:
        return WakeMotor{.position = position, .radius = 1.0f, .law = WakeDrive{.per_metre = 1.0f}};
    }
}

TEST(MotorChurn, BornAndKilledInEveryStep) {
    for (int kind = 0; kind < 4; ++kind)
        for (const Scheme scheme : {Scheme::second_order, Scheme::stable_fluids}) {
            Wind wind = made({.cells = k_churned_cells, .boundaries = Boundaries::all(k_kinds[kind]), .scheme = scheme});
            Watch watch(wind, double(k_churn_speed));
            Random random(61);
            std::vector<MotorId> living;
            for (int n = 0; n < shortened(800); ++n) {
                for (const MotorId id : living)
                    (void)wind.motors().remove(id); // some have ended by themselves
                living.clear();
                const int count = random.integer(0, 10); // none at times: the history alone is left
                for (int m = 0; m < count; ++m)
                    living.push_back(added(wind, some_motor(random)));
                for (const MotorId id : living)
                    if (wind.motors().find(id)->index() ==
                        1) { // a wake acts while it moves: at k_churn_speed at most, for 1/60 s
                        ASSERT_TRUE(wind.motors().move(id, position_of(*wind.motors().find(id)) + 0.5 * random.direction()));
                    }
                watch.step(n % 4 == 3 ? 0.25 : 1.0 / 60.0);
            }
            EXPECT_LE(wind.motors().slots().size(), 10u); // slots are used again
            watch.judge(std::string("churn_") + k_kind_names[kind] + (scheme == Scheme::stable_fluids ? "_stable_fluids" : ""),
                        {k_input_energy, k_opposed_factor});
        }
}

TEST(MotorChurn, MovedFarInEveryStep) {
    for (int kind = 0; kind < 4; ++kind) {
        Wind wind = made({.cells = k_churned_cells, .boundaries = Boundaries::all(k_kinds[kind]), .jump_speed = 0.0f});
        Random random(62);
        std::vector<MotorId> motors;
        for (int n = 0; n < 12; ++n)
            motors.push_back(added(wind, some_motor(random)));
        motors.push_back(added(wind, WakeMotor{.radius = 2.0f, .law = WakeDrive{.per_metre = 1.0f}}));
        const double dt = 1.0 / 60.0, farthest = 12.0;
        const double fastest = 2.0 * std::sqrt(3.0) * farthest / dt; // of the wakes: from one corner to another
        Watch watch(wind, fastest);
        for (int n = 0; n < shortened(800); ++n) {
            for (const MotorId id : motors)
                (void)wind.motors().move(id, random.point(farthest)); // bursts have ended
            watch.step(dt);
        }
        watch.judge(std::string("moved_far_") + k_kind_names[kind], {k_input_energy, k_opposed_factor});
    }
}

} // namespace
