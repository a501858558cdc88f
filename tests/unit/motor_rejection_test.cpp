// Every field of every kind of motor against 0, negative values, NaN, infinities and huge ones: what is rejected says which field,
// what value and what to do instead, all reasons at once; and leaves the list as it was.

#include "fluid/core/message.h"
#include "fluid/motors.h"
#include "tests/winds.h"

#include <type_traits>
#include <variant>

namespace {

using namespace windrow;
using namespace windrow::test;

constexpr float k_huge = std::numeric_limits<float>::max(), k_tiny = std::numeric_limits<float>::denorm_min();

// One number of a motor.
struct MotorField {
    std::string name;
    std::function<Motor(float)> with;
    std::vector<float> rejected, accepted;
    bool vector = false; ///< stands in a vector, which is stated whole
};

const std::vector<float> k_not_numbers{k_nan, k_infinity, -k_infinity, k_huge, -k_huge};

std::vector<float> and_also(std::vector<float> values, std::initializer_list<float> more) {
    values.insert(values.end(), more);
    return values;
}

const std::vector<float> k_bad_size = and_also(k_not_numbers, {0.0f, -0.0f, -1.0f, -k_tiny, 1.0001e6f});
const std::vector<float> k_good_size{k_tiny, 1e-6f, 1.0f, 1e6f};

/// A motor of the kind with one number changed.
template <class Kind, class Change>
auto changing(const Change& change) {
    return [change](float value) {
        Kind kind;
        change(kind, value);
        return Motor(kind);
    };
}

// What all kinds of one type share: the place, and the envelope where there is one.
template <class Kind>
void add_common(std::vector<MotorField>& fields) {
    for (int axis = 0; axis < 3; ++axis)
        fields.push_back({"motor.position",
                          changing<Kind>([axis](Kind& kind, float value) { kind.position[axis] = value; }),
                          and_also(k_not_numbers, {1.0001e12f}),
                          {0.0f, -1.0f, -1e12f, 1e11f},
                          true});
    if constexpr (requires(Kind kind) { kind.envelope; }) {
        const auto with = [](float Envelope::*part) {
            return changing<Kind>([part](Kind& kind, float value) {
                kind.envelope = {.attack = 1.0f, .hold = 1.0f, .decay = 1.0f};
                kind.envelope.*part = value;
            });
        };
        const std::vector<float> bad_time = and_also(k_not_numbers, {-1.0f, -k_tiny, 1.0001e9f});
        fields.push_back({"motor.envelope.attack", with(&Envelope::attack), bad_time, {0.0f, k_tiny, 1e9f}});
        fields.push_back({"motor.envelope.delay", with(&Envelope::delay), bad_time, {0.0f, k_tiny, 1e9f}});
        fields.push_back({"motor.envelope.decay", with(&Envelope::decay), bad_time, {0.0f, k_tiny, 1e9f}});
        fields.push_back({"motor.envelope.hold",
                          with(&Envelope::hold),
                          {k_nan, -k_infinity, -1.0f, -k_tiny, -k_huge},
                          {0.0f, k_tiny, 1e9f, k_huge, k_infinity}});
    }
}

// A direction: each component in turn, the others 0, so that 0 makes it no direction.
template <class Kind>
void add_direction(std::vector<MotorField>& fields, const std::string& name, glm::vec3 Kind::*direction) {
    for (int axis = 0; axis < 3; ++axis)
        fields.push_back({name,
                          changing<Kind>([=](Kind& kind, float value) {
                              kind.*direction = glm::vec3(0.0f);
                              (kind.*direction)[axis] = value;
                          }),
                          {0.0f, -0.0f, k_nan, k_infinity, -k_infinity},
                          {k_tiny, -1.0f, k_huge, -k_huge},
                          true});
}

template <class Kind>
void add_size(std::vector<MotorField>& fields, const std::string& name, float Kind::*size) {
    fields.push_back({name, changing<Kind>([=](Kind& kind, float value) { kind.*size = value; }), k_bad_size, k_good_size});
}

template <class Kind>
void add_speed(std::vector<MotorField>& fields, float Kind::*speed) {
    fields.push_back({"motor.speed",
                      changing<Kind>([=](Kind& kind, float value) { kind.*speed = value; }),
                      and_also(k_not_numbers, {1.0001e4f, -1.0001e4f}),
                      {0.0f, -1e4f, 1e4f}});
}

// Force and Drive, of any kind that has the two.
template <class Kind>
void add_laws(std::vector<MotorField>& fields) {
    const auto with = [](auto law_of) { return changing<Kind>([law_of](Kind& kind, float value) { kind.law = law_of(value); }); };
    fields.push_back({"motor.law.force.acceleration",
                      with([](float value) { return Force{value}; }),
                      and_also(k_not_numbers, {1.0001e6f, -1.0001e6f}),
                      {0.0f, -1e6f, 1e6f}});
    fields.push_back({"motor.law.drive.speed",
                      with([](float value) { return Drive{.speed = value}; }),
                      and_also(k_not_numbers, {1.0001e4f, -1.0001e4f}),
                      {0.0f, -1e4f, 1e4f}});
    fields.push_back({"motor.law.drive.rate",
                      with([](float value) { return Drive{.rate = value}; }),
                      and_also(k_not_numbers, {-1.0f, -k_tiny, 1.0001e6f}),
                      {0.0f, -0.0f, 1e6f}});
}

void add_regions(std::vector<MotorField>& fields) {
    const auto with = [](auto region_of) {
        return [region_of](float value) { return DirectionalMotor{.region = region_of(value)}; };
    };
    fields.push_back({"motor.region.sphere.radius", with([](float value) { return Sphere{value}; }), k_bad_size, k_good_size});
    fields.push_back(
        {"motor.region.capsule.radius", with([](float value) { return Capsule{.radius = value}; }), k_bad_size, k_good_size});
    fields.push_back({"motor.region.cone.start_radius", with([](float value) { return Cone{.start_radius = value}; }), k_bad_size,
                      k_good_size});
    fields.push_back(
        {"motor.region.cone.end_radius", with([](float value) { return Cone{.end_radius = value}; }), k_bad_size, k_good_size});
    for (int axis = 0; axis < 3; ++axis) {
        const auto along = [axis](float value, float others) {
            glm::vec3 v(others);
            v[axis] = value;
            return v;
        };
        fields.push_back({"motor.region.box.half_size", with([=](float value) { return AlignedBox{along(value, 1.0f)}; }),
                          k_bad_size, k_good_size, true});
        fields.push_back({"motor.region.capsule.half_axis",
                          with([=](float value) { return Capsule{.half_axis = along(value, 0.0f)}; }),
                          and_also(k_not_numbers, {1.0001e6f, -1.0001e6f}),
                          {0.0f, -1.0f, k_tiny, 1e6f},
                          true});
        fields.push_back({"motor.region.cone.axis",
                          with([=](float value) { return Cone{.axis = along(value, 0.0f)}; }),
                          and_also(k_not_numbers, {0.0f, -0.0f, k_tiny, 1e-7f, 1.0001e6f, -1.0001e6f}),
                          {1.0001e-6f, -1.0f, 1e6f},
                          true});
    }
}

void add_wake_laws(std::vector<MotorField>& fields) {
    const std::vector<float> bad = and_also(k_not_numbers, {-1.0f, -k_tiny, 1.0001e4f}), good{0.0f, -0.0f, 1e4f};
    fields.push_back({"motor.law.force.strength", [](float value) { return WakeMotor{.law = WakeForce{value}}; }, bad, good});
    fields.push_back(
        {"motor.law.drive.per_metre", [](float value) { return WakeMotor{.law = WakeDrive{.per_metre = value}}; }, bad, good});
    fields.push_back({"motor.law.drive.entrainment",
                      [](float value) { return WakeMotor{.law = WakeDrive{.entrainment = value}}; },
                      and_also(k_not_numbers, {-1.0f, -k_tiny, 2.0001f}),
                      {0.0f, -0.0f, 2.0f}});
}

std::vector<MotorField> every_field() {
    std::vector<MotorField> fields;
    add_common<DirectionalMotor>(fields);
    add_direction(fields, "motor.direction", &DirectionalMotor::direction);
    add_regions(fields);
    add_laws<DirectionalMotor>(fields);

    add_common<WakeMotor>(fields);
    add_size(fields, "motor.radius", &WakeMotor::radius);
    add_wake_laws(fields);

    add_common<JetMotor>(fields);
    add_direction(fields, "motor.direction", &JetMotor::direction);
    add_size(fields, "motor.length", &JetMotor::length);
    add_size(fields, "motor.start_radius", &JetMotor::start_radius);
    add_size(fields, "motor.end_radius", &JetMotor::end_radius);
    add_laws<JetMotor>(fields);

    add_common<VortexMotor>(fields);
    add_direction(fields, "motor.axis", &VortexMotor::axis);
    add_size(fields, "motor.radius", &VortexMotor::radius);
    add_size(fields, "motor.half_length", &VortexMotor::half_length);
    const auto lifting = [](float value) { return VortexMotor{.lift = value}; };
    fields.push_back({"motor.lift", lifting, and_also(k_not_numbers, {10.001f, -10.001f}), {0.0f, -10.0f, 10.0f}});
    add_laws<VortexMotor>(fields);

    add_common<OmniMotor>(fields);
    add_size(fields, "motor.radius", &OmniMotor::radius);
    add_speed(fields, &OmniMotor::speed);

    add_common<PressureMotor>(fields);
    add_size(fields, "motor.radius", &PressureMotor::radius);
    add_speed(fields, &PressureMotor::speed);
    const auto lasting = [](float value) { return PressureMotor{.duration = value}; };
    fields.push_back(
        {"motor.duration", lasting, and_also(k_not_numbers, {0.0f, -0.0f, -1.0f, -k_tiny, 1.0001e9f}), {k_tiny, 1.0f, 1e9f}});
    return fields;
}

// A list with each kind in it, in a wind that blows.
struct Blowing {
    Wind wind = *Wind::create({.cells = {12, 10, 8}});
    std::vector<MotorId> ids;
    Blowing() {
        for (const Motor& motor : std::vector<Motor>{DirectionalMotor{}, WakeMotor{}, JetMotor{}, VortexMotor{}, OmniMotor{},
                                                     PressureMotor{.duration = 1.0f}})
            ids.push_back(*wind.motors().add(motor));
        EXPECT_TRUE(wind.motors().remove(ids[2])); // a free slot among them
        ids.erase(ids.begin() + 2);
    }
};

TEST(MotorRejection, EachNamesTheFieldItsValueAndAFixAndChangesNothing) {
    Blowing rejecting, untouched;
    Motors& motors = rejecting.wind.motors();
    const std::size_t memory = motors.memory_bytes();
    int rejections = 0;
    for (const MotorField& field : every_field())
        for (const float value : field.rejected) {
            const Motor motor = field.with(value);
            const auto valid = validate(motor);
            ASSERT_FALSE(valid) << field.name << " took " << value;
            const std::string& text = valid.error();
            EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 0) << text;
            const std::string number = detail::message(value);
            if (field.vector) {
                EXPECT_EQ(text.find(field.name + " is ("), 0u) << text;
                EXPECT_LT(text.find(field.name == "motor.position" ? detail::message(double(value)) : number),
                          text.find(": give "))
                    << text << " does not state " << number;
            } else {
                EXPECT_TRUE(text.starts_with(field.name + " is " + number + ":") ||
                            text.starts_with(field.name + " is " + number + " "))
                    << text << " does not state " << number;
            }
            EXPECT_EQ(text.back(), '.') << text;
            EXPECT_NE(text.find(": give "), std::string::npos) << text;

            const auto add = motors.add(motor);
            const auto set = motors.set(rejecting.ids[rejections % rejecting.ids.size()], motor);
            ASSERT_FALSE(add);
            ASSERT_FALSE(set);
            EXPECT_EQ(add.error(), text);
            EXPECT_EQ(set.error(), text);
            if (field.name == "motor.position") {
                const auto move = motors.move(rejecting.ids.front(), position_of(motor));
                ASSERT_FALSE(move);
                EXPECT_EQ(move.error(), text);
            }
            ++rejections;
        }
    EXPECT_GT(rejections, 500);
    EXPECT_EQ(validate(WakeMotor{.radius = -1.0f}).error().find("motor.radius is -1 m: give "), 0u) << "with its unit";

    EXPECT_EQ(motors.count(), 5);
    EXPECT_EQ(motors.memory_bytes(), memory);
    for (int n = 0; n < 5; ++n) {
        rejecting.wind.step(0.05);
        untouched.wind.step(0.05);
    }
    EXPECT_EQ(cells_that_differ(rejecting.wind.field(), untouched.wind.field()), 0u);
    const auto next = motors.add(JetMotor{}), other_next = untouched.wind.motors().add(JetMotor{});
    ASSERT_TRUE(next && other_next);
    EXPECT_TRUE(*next == *other_next) << "rejected motors used up no handle";
}

TEST(MotorRejection, LimitsThemselvesAreTaken) {
    for (const MotorField& field : every_field())
        for (const float value : field.accepted) {
            const auto valid = validate(field.with(value));
            EXPECT_TRUE(valid) << field.name << " rejected " << value << ": " << valid.error();
        }
}

// Whatever is taken may act: no value makes the air anything but finite.
TEST(MotorRejection, WhatIsTakenKeepsTheAirFinite) {
    for (const MotorField& field : every_field())
        for (const float value : field.accepted) {
            Wind wind = *Wind::create({.cells = {8, 8, 8}});
            const MotorId id = added(wind, field.with(value));
            for (int n = 0; n < 3; ++n) {
                if (wind.motors().find(id) != nullptr && std::holds_alternative<WakeMotor>(*wind.motors().find(id))) {
                    ASSERT_TRUE(wind.motors().move(id, {0.3 * n, 0.0, 0.0}));
                }
                const Diagnostics report = wind.step(1.0 / 30.0);
                ASSERT_EQ(report.repaired_cells, 0) << field.name << " = " << value;
                ASSERT_TRUE(all_finite(wind.field())) << field.name << " = " << value;
            }
        }
}

TEST(MotorRejection, AllReasonsComeAtOnce) {
    const Envelope bad{-1.0f, k_nan, k_infinity};
    const glm::dvec3 nowhere(1e13, 0.0, 0.0);
    const glm::vec3 none(0.0f);
    const auto reasons = [](const Motor& motor) {
        const auto valid = validate(motor);
        EXPECT_FALSE(valid);
        return valid ? 0 : std::count(valid.error().begin(), valid.error().end(), '\n') + 1;
    };
    EXPECT_EQ(reasons(DirectionalMotor{nowhere, none, Cone{none, 0.0f, k_nan}, Drive{k_nan, -1.0f}, bad}), 10);
    EXPECT_EQ(reasons(WakeMotor{nowhere, 0.0f, WakeDrive{-1.0f, 3.0f}, bad}), 7);
    EXPECT_EQ(reasons(JetMotor{nowhere, none, 0.0f, -1.0f, k_infinity, Drive{k_nan, -1.0f}, bad}), 10);
    EXPECT_EQ(reasons(VortexMotor{nowhere, none, 0.0f, -1.0f, 11.0f, Force{k_nan}, bad}), 9);
    EXPECT_EQ(reasons(OmniMotor{nowhere, 0.0f, 2e4f, bad}), 6);
    EXPECT_EQ(reasons(PressureMotor{nowhere, 0.0f, 2e4f, 0.0f}), 4);
    EXPECT_EQ(reasons(OmniMotor{.envelope = {0.0f, 0.0f, 0.0f}}), 1) << "lasts no time";
}

} // namespace
