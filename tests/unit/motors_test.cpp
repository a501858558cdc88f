// The list of motors: handles, capacity, directions, delays. What is rejected is in motor_rejection_test.cpp.

#include "tests/winds.h"

#include <variant>

namespace {

using namespace windrow;
using namespace windrow::test;

TEST(Motors, AHandleNamesItsMotorUntilItIsRemoved) {
    Motors motors;
    EXPECT_EQ(motors.count(), 0);
    const MotorId a = added(motors, DirectionalMotor{.position = {1.0, 0.0, 0.0}, .turbulence = k_steady});
    const MotorId b = added(motors, WakeMotor{.position = {2.0, 0.0, 0.0}});
    EXPECT_FALSE(a == b);
    EXPECT_EQ(motors.count(), 2);
    ASSERT_NE(motors.find(a), nullptr);
    ASSERT_NE(motors.find(b), nullptr);
    EXPECT_EQ(position_of(*motors.find(a)).x, 1.0);
    EXPECT_TRUE(std::holds_alternative<WakeMotor>(*motors.find(b)));

    EXPECT_TRUE(motors.move(a, {5.0, 6.0, 7.0}));
    EXPECT_EQ(position_of(*motors.find(a)), glm::dvec3(5.0, 6.0, 7.0));
    EXPECT_TRUE(motors.set(a, WakeMotor{.position = {3.0, 0.0, 0.0}}));
    EXPECT_TRUE(std::holds_alternative<WakeMotor>(*motors.find(a))) << "the kind may change";

    EXPECT_TRUE(motors.remove(a));
    EXPECT_EQ(motors.find(a), nullptr);
    EXPECT_NE(motors.find(b), nullptr);
    EXPECT_EQ(motors.count(), 1);
}

TEST(Motors, AStaleHandleIsRejectedAndMovesNoStranger) {
    Motors motors;
    const MotorId first = added(motors, DirectionalMotor{.turbulence = k_steady});
    ASSERT_TRUE(motors.remove(first));
    const MotorId stranger = added(motors, DirectionalMotor{.position = {9.0, 9.0, 9.0}, .turbulence = k_steady});
    ASSERT_EQ(stranger.slot, first.slot) << "the slot is used again, or this test shows nothing";
    EXPECT_NE(stranger.generation, first.generation);

    const MotorId unknown{.slot = 77, .generation = 1};
    for (const MotorId id : {first, MotorId{}, unknown}) {
        const auto rejected = motors.move(id, {0.0, 0.0, 0.0});
        ASSERT_FALSE(rejected);
        EXPECT_NE(rejected.error().find("motor " + std::to_string(id.slot) + " of generation " + std::to_string(id.generation)),
                  std::string::npos)
            << rejected.error();
        EXPECT_NE(rejected.error().find("add()"), std::string::npos) << rejected.error();
        EXPECT_FALSE(motors.set(id, DirectionalMotor{.turbulence = k_steady}));
        EXPECT_FALSE(motors.remove(id));
        EXPECT_EQ(motors.find(id), nullptr);
    }
    EXPECT_EQ(motors.count(), 1);
    EXPECT_EQ(position_of(*motors.find(stranger)), glm::dvec3(9.0));
}

TEST(Motors, AHandleOfAnotherWindIsRejected) {
    auto wind = Wind::create({}), other = Wind::create({});
    ASSERT_TRUE(wind && other);
    const MotorId id = added(wind->motors(), OmniMotor{}), stranger = added(other->motors(), WakeMotor{});
    ASSERT_EQ(id.slot, stranger.slot);
    const auto moved = wind->motors().move(stranger, {1.0, 0.0, 0.0});
    ASSERT_FALSE(moved);
    EXPECT_EQ(moved.error(), "motor 0 of generation 1 belongs to another wind: use the handle that add() of this one returned.");
    EXPECT_FALSE(wind->motors().set(stranger, OmniMotor{}));
    EXPECT_FALSE(wind->motors().remove(stranger));
    EXPECT_EQ(wind->motors().find(stranger), nullptr);
    // Sent elsewhere as slot and generation.
    EXPECT_TRUE(wind->motors().move({.slot = id.slot, .generation = id.generation}, {1.0, 0.0, 0.0}));

    // A wind that was loaded knows the handles of the one that was saved, and gives its own.
    auto again = Wind::load(*wind->save());
    ASSERT_TRUE(again);
    EXPECT_TRUE(again->motors().move(id, {2.0, 0.0, 0.0}));
    const MotorId later = added(wind->motors(), OmniMotor{}), own = added(again->motors(), OmniMotor{});
    ASSERT_EQ(later.slot, own.slot);
    EXPECT_FALSE(again->motors().move(later, {2.0, 0.0, 0.0}));
    EXPECT_TRUE(again->motors().move(own, {2.0, 0.0, 0.0}));
}

#ifndef NDEBUG
TEST(WindDeathTest, AWindThatWasMovedFromIsNamed) {
    Wind wind = made({});
    const Wind taken = std::move(wind);
    EXPECT_DEATH(wind.step(0.1), "moved from");
}
#endif

TEST(Motors, EveryGenerationOfASlotIsAnother) {
    Motors motors;
    std::vector<MotorId> past;
    for (int n = 0; n < 1000; ++n) {
        const MotorId id = added(motors, DirectionalMotor{.turbulence = k_steady});
        EXPECT_NE(id.generation, 0u);
        for (const MotorId& old : past)
            ASSERT_FALSE(old == id);
        past.push_back(id);
        ASSERT_TRUE(motors.remove(id));
    }
    for (const MotorId& old : past)
        EXPECT_EQ(motors.find(old), nullptr);
}

TEST(Motors, HoldTheirCapacityAndNoMore) {
    Motors motors;
    std::vector<MotorId> ids;
    for (std::uint32_t n = 0; n < Motors::k_capacity; ++n)
        ids.push_back(added(motors, DirectionalMotor{.position = {double(n), 0.0, 0.0}, .turbulence = k_steady}));
    EXPECT_EQ(motors.count(), 4096);
    const auto one_more = motors.add(DirectionalMotor{.turbulence = k_steady});
    ASSERT_FALSE(one_more);
    EXPECT_NE(one_more.error().find("4096"), std::string::npos) << one_more.error();
    EXPECT_EQ(motors.count(), 4096);
    for (std::size_t n = 0; n < ids.size(); ++n)
        ASSERT_EQ(position_of(*motors.find(ids[n])).x, double(n));
    ASSERT_TRUE(motors.remove(ids[1234]));
    EXPECT_TRUE(motors.add(DirectionalMotor{.turbulence = k_steady}));
    EXPECT_FALSE(motors.add(DirectionalMotor{.turbulence = k_steady}));
    for (std::size_t n = 0; n < ids.size(); ++n)
        EXPECT_EQ(motors.remove(ids[n]).has_value(), n != 1234);
    EXPECT_EQ(motors.count(), 1);
}

TEST(Motors, AllOfThemActAtOnce) {
    Wind wind = sources_only({8, 8, 8});
    for (std::uint32_t n = 0; n < Motors::k_capacity; ++n)
        added(wind,
              DirectionalMotor{.position = {0.5, 0.5, 0.5}, .region = Sphere{3.0f}, .law = Force{0.25f}, .turbulence = k_steady});
    EXPECT_EQ(wind.step(0.5).motors_in_reach, 4096);
    EXPECT_EQ(wind.field()[wind.box().index(4, 4, 4)].x, 4096.0f * 0.25f * 0.5f);
}

TEST(Motors, DirectionsAreNormalised) {
    Motors motors;
    const float tiny = std::numeric_limits<float>::denorm_min(), huge = std::numeric_limits<float>::max();
    const auto direction = [&](glm::vec3 given) {
        const MotorId id = added(motors, DirectionalMotor{.direction = given, .turbulence = k_steady});
        return std::get<DirectionalMotor>(*motors.find(id)).direction;
    };
    EXPECT_EQ(direction({3.0f, 0.0f, -4.0f}), glm::vec3(0.6f, 0.0f, -0.8f));
    EXPECT_EQ(direction({0.0f, tiny, 0.0f}), glm::vec3(0.0f, 1.0f, 0.0f));
    EXPECT_EQ(direction({0.0f, 0.0f, -huge}), glm::vec3(0.0f, 0.0f, -1.0f));
    EXPECT_NEAR(glm::length(direction({huge, huge, huge})), 1.0f, 1e-6f);
    EXPECT_NEAR(glm::length(direction({tiny, tiny, tiny})), 1.0f, 1e-6f);
}

// A motor that waits leaves the air alone, and then does to the bit what one does that is added later.
TEST(Motors, ADelayIsAsAddingItLater) {
    constexpr float k_delay = 0.25f;
    const Envelope gust{.attack = 0.125f, .hold = 0.25f, .decay = 0.125f}, late{gust.attack, gust.hold, gust.decay, k_delay};
    EXPECT_EQ(late.end(), gust.end() + 0.25);
    EXPECT_EQ(late.mean(0.0, 0.25), 0.0);
    EXPECT_EQ(late.mean(0.375, 0.5), gust.mean(0.125, 0.25));
    EXPECT_EQ(late.mean(0.0, 1.0), gust.mean(0.0, 0.75) * 0.75);
    const auto with = [&](auto motor, const Envelope& envelope) {
        motor.envelope = envelope;
        return Motor(motor);
    };
    const auto compare = [&](const auto& kind) {
        Wind wind = sources_only({12, 10, 8}), later = sources_only({12, 10, 8});
        added(wind.motors(), with(kind, late));
        for (int n = 0; n < 8; ++n) {
            if (n == 2)
                added(later.motors(), with(kind, gust));
            later.step(0.125);
            wind.step(0.125);
            EXPECT_TRUE(std::equal(wind.field().begin(), wind.field().end(), later.field().begin())) << "step " << n;
            EXPECT_EQ(largest_speed(wind.field()) > 0.0, n >= 2);
        }
        EXPECT_EQ(wind.motors().count(), 0) << "it has removed itself";
    };
    compare(DirectionalMotor{.turbulence = k_steady});
    compare(JetMotor{.turbulence = k_steady});
    compare(VortexMotor{});
}

} // namespace
