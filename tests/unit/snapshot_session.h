// A wind with a host that moves it, for the tests of snapshots.
#pragma once

#include "tests/winds.h"

namespace windrow::test {

using Bytes = std::vector<std::byte>;

inline Wind loaded(const Bytes& bytes, ParallelFor parallel_for = {}) {
    auto wind = Wind::load(bytes, parallel_for);
    EXPECT_TRUE(wind) << wind.error();
    return wind ? *std::move(wind) : made({});
}

inline Envelope long_gust() {
    return {.attack = 0.25f, .hold = 40.0f, .decay = 0.5f};
}

/// A wind and what its host remembers of it.
struct Session {
    Wind wind;
    std::vector<MotorId> motors;
    Random random{17};

    void add(const Motor& motor) { motors.push_back(added(wind, motor)); }
    void add_all_kinds() {
        const glm::vec3 aslant(1.0f, 0.5f, -2.0f);
        add(DirectionalMotor{.position = {2.0, 1.0, 0.0}, .direction = aslant, .region = Sphere{3.0f}, .law = Force{12.0f}});
        add(WakeMotor{.position = {-3.0, 0.0, 1.0}, .radius = 1.2f});
        add(DirectionalMotor{.position = {0.0, -2.0, 0.0}, .region = Capsule{.half_axis = aslant}, .envelope = long_gust()});
        add(WakeMotor{.position = {1.0, 0.0, 1.0}, .radius = 0.9f, .law = WakeForce{2.0f}, .envelope = long_gust()});
        add(DirectionalMotor{.position = {-1.0, 2.0, 3.0}, .region = AlignedBox{{1.0f, 2.0f, 3.0f}}});
        add(DirectionalMotor{.position = {4.0, 0.0, -3.0}, .region = Cone{}, .law = Drive{.speed = -3.0f, .rate = 2.0f}});
        add(JetMotor{.position = {-4.0, 0.0, 0.0}, .direction = aslant, .envelope = long_gust()});
        add(VortexMotor{.position = {0.0, 0.0, 4.0}, .axis = aslant, .lift = 0.5f, .law = Force{5.0f}});
        add(OmniMotor{.position = {0.0, 1.0, -5.0}, .speed = 3.0f, .envelope = long_gust()});
        add(PressureMotor{.position = {3.0, 1.0, 4.0}, .duration = 0.4f});
        add(DirectionalMotor{.envelope = {.hold = 0.05f}}); // ends by itself
        EXPECT_TRUE(wind.motors().remove(motors[4]));
        EXPECT_TRUE(wind.motors().remove(motors[0])); // two free slots, the later one first
    }
    /// What a host does before a frame.
    void act(int count) {
        for (const std::size_t wake : {1u, 3u})
            for (int n = 0; n < 2 && wake < motors.size(); ++n)
                (void)wind.motors().move(motors[wake], random.point(6.0));
        if (count % 4 == 3) {
            EXPECT_TRUE(wind.follow(random.point(5.0)));
        }
        if (count == 9)
            add(DirectionalMotor{.position = random.point(4.0), .envelope = {.hold = 0.2f}});
        if (count == 13) {
            EXPECT_TRUE(wind.set_ambient(random.vector(4.0f)));
        }
    }
};

} // namespace windrow::test
