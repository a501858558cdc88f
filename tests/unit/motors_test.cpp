// The list of motors: handles, what is refused, and that a refusal changes nothing.

#include "fluid/wind.h"
#include "tests/fields.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace {

using namespace windrow;
using namespace windrow::test;

constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
constexpr float k_infinity = std::numeric_limits<float>::infinity();

MotorId added(Motors& motors, const Motor& motor) {
    const auto id = motors.add(motor);
    EXPECT_TRUE(id) << id.error();
    return id ? *id : MotorId{};
}

// --- Handles ---------------------------------------------------------------------------------------------------------

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

TEST(Motors, AStaleHandleIsRefusedAndMovesNoStranger) {
    Motors motors;
    const MotorId first = added(motors, DirectionalMotor{.turbulence = k_steady});
    ASSERT_TRUE(motors.remove(first));
    const MotorId stranger = added(motors, DirectionalMotor{.position = {9.0, 9.0, 9.0}, .turbulence = k_steady});
    ASSERT_EQ(stranger.slot, first.slot) << "the slot is used again, or this test shows nothing";
    EXPECT_NE(stranger.generation, first.generation);

    const MotorId unknown{.slot = 77, .generation = 1};
    for (const MotorId id : {first, MotorId{}, unknown}) {
        const auto refused = motors.move(id, {0.0, 0.0, 0.0});
        ASSERT_FALSE(refused);
        EXPECT_NE(refused.error().find("motor " + std::to_string(id.slot) + " of generation " + std::to_string(id.generation)),
                  std::string::npos)
            << refused.error();
        EXPECT_NE(refused.error().find("add()"), std::string::npos) << refused.error();
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
    auto wind = Wind::create({});
    ASSERT_TRUE(wind);
    const Wind taken = *std::move(wind);
    EXPECT_DEATH(wind->step(0.1), "moved from");
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
    auto wind = Wind::create({.cells = {8, 8, 8}, .stages = {true, false, false, false, false}});
    ASSERT_TRUE(wind);
    for (std::uint32_t n = 0; n < Motors::k_capacity; ++n)
        added(wind->motors(),
              DirectionalMotor{.position = {0.5, 0.5, 0.5}, .region = Sphere{3.0f}, .law = Force{0.25f}, .turbulence = k_steady});
    const Diagnostics report = wind->step(0.5);
    EXPECT_EQ(report.motors_in_reach, 4096);
    EXPECT_EQ(wind->field()[wind->box().index(4, 4, 4)].x, 4096.0f * 0.25f * 0.5f);
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

// --- Refusals --------------------------------------------------------------------------------------------------------

struct Refusal {
    const char* field; ///< with its value
    Motor motor;
};

std::vector<Refusal> every_refusal() {
    std::vector<Refusal> list;
    const auto position = [&](const char* field, glm::dvec3 value) {
        list.push_back({field, DirectionalMotor{.position = value, .turbulence = k_steady}});
        list.push_back({field, WakeMotor{.position = value}});
    };
    const auto directional = [&](const char* field, DirectionalMotor motor) { list.push_back({field, motor}); };
    const auto wake = [&](const char* field, WakeMotor motor) { list.push_back({field, motor}); };
    const double far_off = 1e13;
    position("motor.position is (nan, 0, 0)", {std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0});
    position("motor.position is (0, inf, 0)", {0.0, std::numeric_limits<double>::infinity(), 0.0});
    position("motor.position is (0, 0, -1e+13)", {0.0, 0.0, -far_off});
    directional("motor.direction is (0, 0, 0)", {.direction = glm::vec3(0.0f)});
    directional("motor.direction is (0, nan, 1)", {.direction = {0.0f, k_nan, 1.0f}});
    directional("motor.direction is (inf, 0, 0)", {.direction = {k_infinity, 0.0f, 0.0f}});
    for (const auto& [text, radius] : {std::pair{" is 0 m:", 0.0f},
                                       {" is -1 m:", -1.0f},
                                       {" is nan m:", k_nan},
                                       {" is inf m:", k_infinity},
                                       {" is 2e+06 m:", 2e6f}}) {
        static std::vector<std::string> kept(64); // The list keeps pointers.
        static std::size_t used = 0;
        const auto field = [&, end = text](const char* name) {
            return (kept[used++ % kept.size()] = std::string(name) + end).c_str();
        };
        directional(field("motor.region.sphere.radius"), {.region = Sphere{radius}});
        directional(field("motor.region.capsule.radius"), {.region = Capsule{.radius = radius}});
        wake(field("motor.radius"), {.radius = radius});
    }
    directional("motor.region.capsule.half_axis is (nan, 0, 0)", {.region = Capsule{.half_axis = {k_nan, 0.0f, 0.0f}}});
    directional("motor.region.capsule.half_axis is (0, 2e+06, 0)", {.region = Capsule{.half_axis = {0.0f, 2e6f, 0.0f}}});
    directional("motor.region.capsule.half_axis is (3e+38, 3e+38, 0)", {.region = Capsule{.half_axis = {3e38f, 3e38f, 0.0f}}});
    directional("motor.region.box.half_size is (1, 0, 1)", {.region = AlignedBox{{1.0f, 0.0f, 1.0f}}});
    directional("motor.region.box.half_size is (1, 1, -1)", {.region = AlignedBox{{1.0f, 1.0f, -1.0f}}});
    directional("motor.region.box.half_size is (nan, 1, 1)", {.region = AlignedBox{{k_nan, 1.0f, 1.0f}}});
    directional("motor.region.box.half_size is (1, 2e+06, 1)", {.region = AlignedBox{{1.0f, 2e6f, 1.0f}}});
    directional("motor.law.force.acceleration is nan", {.law = Force{k_nan}});
    directional("motor.law.force.acceleration is -inf", {.law = Force{-k_infinity}});
    directional("motor.law.force.acceleration is 2e+06", {.law = Force{2e6f}});
    directional("motor.law.drive.speed is nan", {.law = Drive{.speed = k_nan}});
    directional("motor.law.drive.speed is -20000", {.law = Drive{.speed = -2e4f}});
    directional("motor.law.drive.rate is -1", {.law = Drive{.rate = -1.0f}});
    directional("motor.law.drive.rate is nan", {.law = Drive{.rate = k_nan}});
    directional("motor.law.drive.rate is inf", {.law = Drive{.rate = k_infinity}});
    wake("motor.law.force.strength is -1", {.law = WakeForce{-1.0f}});
    wake("motor.law.force.strength is nan", {.law = WakeForce{k_nan}});
    wake("motor.law.force.strength is 20000", {.law = WakeForce{2e4f}});
    wake("motor.law.drive.per_metre is -1", {.law = WakeDrive{.per_metre = -1.0f}});
    wake("motor.law.drive.per_metre is inf", {.law = WakeDrive{.per_metre = k_infinity}});
    wake("motor.law.drive.entrainment is 2.5", {.law = WakeDrive{.entrainment = 2.5f}});
    wake("motor.law.drive.entrainment is nan", {.law = WakeDrive{.entrainment = k_nan}});
    return list;
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
        const Config sources_only{.cells = {12, 10, 8},
                                  .stages = {.settling = false, .diffusion = false, .advection = false, .projection = false}};
        Wind wind = *Wind::create(sources_only), later = *Wind::create(sources_only);
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

TEST(Motors, RefusalsNameFieldAndValueAndChangeNothing) {
    const Motor sound = DirectionalMotor{.position = {0.25, 0.5, 0.75}, .law = Force{3.0f}, .turbulence = k_steady};
    auto wind = Wind::create({.cells = {12, 10, 8}}), untouched = Wind::create({.cells = {12, 10, 8}});
    ASSERT_TRUE(wind && untouched);
    const MotorId id = added(wind->motors(), sound);
    added(untouched->motors(), sound);
    for (const Refusal& refusal : every_refusal()) {
        const auto valid = validate(refusal.motor);
        ASSERT_FALSE(valid) << refusal.field;
        EXPECT_EQ(valid.error().find(refusal.field), 0u) << valid.error();
        EXPECT_NE(valid.error().find(": give "), std::string::npos) << valid.error();
        EXPECT_EQ(std::count(valid.error().begin(), valid.error().end(), '\n'), 0) << valid.error();
        const auto add = wind->motors().add(refusal.motor);
        const auto set = wind->motors().set(id, refusal.motor);
        ASSERT_FALSE(add) << refusal.field;
        ASSERT_FALSE(set) << refusal.field;
        EXPECT_EQ(add.error(), valid.error());
        EXPECT_EQ(set.error(), valid.error());
        if (const glm::dvec3 position = position_of(refusal.motor); position != glm::dvec3(0.0)) {
            EXPECT_FALSE(wind->motors().move(id, position));
        }
        ASSERT_EQ(wind->motors().count(), 1);
        const auto& kept = std::get<DirectionalMotor>(*wind->motors().find(id));
        ASSERT_EQ(kept.position, glm::dvec3(0.25, 0.5, 0.75));
        ASSERT_EQ(std::get<Force>(kept.law).acceleration, 3.0f);
    }
    for (int n = 0; n < 5; ++n) {
        wind->step(0.1);
        untouched->step(0.1);
    }
    EXPECT_EQ(cells_that_differ(wind->field(), untouched->field()), 0u);
}

TEST(Motors, AllReasonsComeAtOnce) {
    const auto valid = validate(DirectionalMotor{.position = {1e13, 0.0, 0.0},
                                                 .direction = glm::vec3(0.0f),
                                                 .region = Capsule{.half_axis = {k_nan, 0.0f, 0.0f}, .radius = 0.0f},
                                                 .law = Drive{.speed = k_nan, .rate = -1.0f},
                                                 .turbulence = k_steady});
    ASSERT_FALSE(valid);
    EXPECT_EQ(std::count(valid.error().begin(), valid.error().end(), '\n'), 5) << valid.error();
}

TEST(Motors, LimitsThemselvesAreAccepted) {
    for (const Motor& motor : std::vector<Motor>{
             DirectionalMotor{.position = {1e12, 0.0, 0.0}, .region = Sphere{1e6f}, .law = Force{1e6f}, .turbulence = k_steady},
             DirectionalMotor{
                 .region = Sphere{std::numeric_limits<float>::denorm_min()}, .law = Force{-1e6f}, .turbulence = k_steady},
             DirectionalMotor{.region = Capsule{.half_axis = glm::vec3(0.0f), .radius = 1e6f},
             .law = Drive{.speed = -1e4f, .rate = 1e6f},
             .turbulence = k_steady},
             DirectionalMotor{
                 .region = AlignedBox{glm::vec3(1e6f)}, .law = Drive{.speed = 1e4f, .rate = 0.0f}, .turbulence = k_steady},
             WakeMotor{.radius = 1e6f, .law = WakeForce{1e4f}},
             WakeMotor{.law = WakeDrive{.per_metre = 1e4f, .entrainment = 2.0f}},
             WakeMotor{.law = WakeDrive{.per_metre = 0.0f, .entrainment = 0.0f}}}) {
        const auto valid = validate(motor);
        EXPECT_TRUE(valid) << valid.error();
    }
}

} // namespace
