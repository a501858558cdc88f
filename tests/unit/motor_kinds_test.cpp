// Regions, jets, whirls and sources of air, asked of the sources stage alone: closed forms of weights, laws and times, in double.

#include "fluid/operators.h"
#include "fluid/wind_state.h"
#include "tests/winds.h"

#include <variant>

namespace {

using namespace windrow;
using namespace windrow::test;

const double k_swirl = 25.0 * std::sqrt(5.0) / 16.0; // 1 over the largest value of s (1 - s^2)^2

// --- Closed forms, from the text of motor.h --------------------------------------------------------------------------

// A motor's weight at a place, and what it asks for there at full strength 1.
struct WeightedWay {
    double weight;
    glm::dvec3 way;
};

// Along a column's axis and across it.
struct ColumnForm {
    glm::dvec3 direction;
    double length, start, end;
    [[nodiscard]] double along(glm::dvec3 p) const { return glm::dot(p, direction); }
    [[nodiscard]] double radius(glm::dvec3 p) const { return start + (end - start) * std::clamp(along(p) / length, 0.0, 1.0); }
    [[nodiscard]] double weight(glm::dvec3 p) const {
        const glm::dvec3 off = p - along(p) * direction;
        return biweight(std::pow(2.0 * along(p) / length - 1.0, 2)) * biweight(glm::dot(off, off) / std::pow(radius(p), 2));
    }
};

double weight_of(const Region& region, glm::dvec3 p) {
    if (const auto* sphere = std::get_if<Sphere>(&region))
        return biweight(glm::dot(p, p) / std::pow(double(sphere->radius), 2));
    if (const auto* capsule = std::get_if<Capsule>(&region)) {
        const glm::dvec3 axis(capsule->half_axis),
            off = p - std::clamp(glm::dot(p, axis) / glm::dot(axis, axis), -1.0, 1.0) * axis;
        return biweight(glm::dot(off, off) / std::pow(double(capsule->radius), 2));
    }
    if (const auto* box = std::get_if<AlignedBox>(&region)) {
        const glm::dvec3 s = p / glm::dvec3(box->half_size);
        return biweight(s.x * s.x) * biweight(s.y * s.y) * biweight(s.z * s.z);
    }
    const auto& cone = std::get<Cone>(region);
    const glm::dvec3 axis(cone.axis);
    return ColumnForm{glm::normalize(axis), glm::length(axis), cone.start_radius, cone.end_radius}.weight(p);
}

WeightedWay push_of(const DirectionalMotor& motor, glm::dvec3 p) {
    return {weight_of(motor.region, p), glm::normalize(glm::dvec3(motor.direction))};
}

ColumnForm column_of(const JetMotor& motor) {
    return {glm::normalize(glm::dvec3(motor.direction)), motor.length, motor.start_radius, motor.end_radius};
}

// Rays from the tip in which the mantle's lines meet; the section's radius times the speed along the axis stays.
WeightedWay push_of(const JetMotor& motor, glm::dvec3 p) {
    const ColumnForm column = column_of(motor);
    const glm::dvec3 tip = column.direction * (-column.start * column.length / (column.end - column.start));
    const glm::dvec3 ray = column.start == column.end ? column.direction : (p - tip) / column.along(p - tip);
    return {column.weight(p), column.start / column.radius(p) * ray};
}

WeightedWay push_of(const VortexMotor& motor, glm::dvec3 p) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(motor.axis));
    const double along = glm::dot(p, axis), radius = motor.radius;
    const glm::dvec3 off = p - along * axis;
    const double s2 = glm::dot(off, off) / (radius * radius), axial = biweight(std::pow(along / double(motor.half_length), 2));
    const bool drive = std::holds_alternative<Drive>(motor.law);
    return {drive ? axial * biweight(s2 * s2) : axial,
            biweight(s2) * (k_swirl / radius * glm::cross(axis, off) + double(motor.lift) * axis)};
}

WeightedWay push_of(const Motor& motor, glm::dvec3 p) {
    if (const auto* jet = std::get_if<JetMotor>(&motor))
        return push_of(*jet, p);
    if (const auto* vortex = std::get_if<VortexMotor>(&motor))
        return push_of(*vortex, p);
    return push_of(std::get<DirectionalMotor>(motor), p);
}

using Law = std::variant<Force, Drive>;

// The air after `seconds` of a motor that stands at the origin of p.
glm::dvec3 air_after(const Motor& motor, const Law& law, glm::dvec3 p, glm::dvec3 before, double seconds) {
    const auto [weight, way] = push_of(motor, p);

    if (const auto* force = std::get_if<Force>(&law))
        return before + seconds * double(force->acceleration) * weight * way;
    const auto& drive = std::get<Drive>(law);
    return before - std::expm1(-double(drive.rate) * weight * seconds) * (double(drive.speed) * way - before);
}

enum class MotorForm { sphere, capsule, box, cone, jet, cylinder, vortex };
constexpr MotorForm k_forms[] = {MotorForm::sphere, MotorForm::capsule,  MotorForm::box,   MotorForm::cone,
                                 MotorForm::jet,    MotorForm::cylinder, MotorForm::vortex};
constexpr const char* k_form_name[] = {"sphere", "capsule", "box", "cone", "jet", "cylinder", "vortex"};

Motor some_motor(MotorForm form, const Law& law, Random& random, const Envelope& envelope = {}) {
    const glm::dvec3 place = random.point(3.0);
    const glm::vec3 direction(random.direction() * random.spread(1e-3, 1e3));
    const float start = random.uniform(1.6f, 4.0f), end = random.uniform(1.6f, 4.0f), length = random.uniform(3.2f, 9.0f);
    if (form == MotorForm::vortex)
        return VortexMotor{place, direction, start + 2.0f, 0.5f * length, random.uniform(-2.0f, 2.0f), law, envelope};
    if (form == MotorForm::jet || form == MotorForm::cylinder)
        return JetMotor{place, direction, length, start, form == MotorForm::cylinder ? start : end, law, envelope, k_steady};
    const Region regions[] = {Sphere{start}, Capsule{.half_axis = random.vector(4.0f), .radius = start},
                              AlignedBox{{start, end, length}}, Cone{length * glm::vec3(random.direction()), start, end}};
    return DirectionalMotor{place, direction, regions[static_cast<int>(form)], law, envelope, k_steady};
}

// --- Where they act, and how much --------------------------------------------------------------------------------------

TEST(MotorKinds, FollowTheirClosedFormsInAHundredRotations) {
    for (const MotorForm form : k_forms)
        for (const bool drives : {false, true}) {
            const Law law = drives ? Law(Drive{.speed = 5.0f, .rate = 6.0f}) : Law(Force{5.0f});
            Random random(static_cast<std::uint32_t>(form) + 40);
            double worst = 0.0, worst_angle = 0.0;
            int outside = 0, inside = 0;
            for (int trial = 0; trial < 100; ++trial) {
                const double seconds = random.real(0.02, 0.5);
                const Motor motor = some_motor(form, law, random);
                const glm::vec3 ambient = drives ? random.vector(3.0f) : glm::vec3(0.0f);
                Wind wind = sources_only({18, 16, 17}, 1.0f, ambient);
                added(wind, motor);
                wind.step(seconds);
                for_each_cell(wind, [&](glm::dvec3 centre, std::size_t n) {
                    const glm::dvec3 p = centre - position_of(motor), u(wind.field()[n]);
                    const glm::dvec3 expected = air_after(motor, law, p, glm::dvec3(ambient), seconds);
                    worst = std::max(worst, glm::length(u - expected) / 5.0);
                    const glm::dvec3 given = u - glm::dvec3(ambient), asked = expected - glm::dvec3(ambient);
                    if (glm::length(asked) > 0.05)
                        worst_angle =
                            std::max(worst_angle, std::atan2(glm::length(glm::cross(given, asked)), glm::dot(given, asked)));
                    // Clear of the rounding of positions: zero round about as well.
                    bool clear = push_of(motor, p).weight == 0.0;
                    for (int side = 0; clear && side < 6; ++side) {
                        glm::dvec3 beside = p;
                        beside[side / 2] += side % 2 == 0 ? 1e-3 : -1e-3;
                        clear = push_of(motor, beside).weight == 0.0;
                    }
                    if (clear) {
                        ASSERT_EQ(wind.field()[n], glm::vec4(ambient, 0.0f));
                        ++outside;
                    }
                    inside += push_of(motor, p).weight > 1e-6;
                });
            }
            EXPECT_GT(outside, 100000);
            EXPECT_GT(inside, 5000);
            const std::string name = std::string(k_form_name[static_cast<int>(form)]) + (drives ? "_drive" : "_force");
            // Positions are kept to 1/65536 of a cell.
            WINDROW_EXPECT_FIGURE("kind_error_" + name, worst, form <= MotorForm::box && !drives ? 2e-5 : 1e-4);
            WINDROW_EXPECT_FIGURE("kind_direction_deg_" + name, worst_angle * 180.0 / pi, 0.1);
        }
}

TEST(MotorKinds, TheSameBitsAtTenWorldPositions) {
    Random random(50);
    for (int trial = 0; trial < 6; ++trial) {
        std::vector<Motor> motors;
        for (const MotorForm form : k_forms)
            motors.push_back(some_motor(form, trial % 2 == 0 ? Law(Force{4.0f}) : Law(Drive{}), random));
        motors.push_back(OmniMotor{.position = random.point(4.0), .radius = 3.0f});
        const auto blown = [&](glm::dvec3 centre) {
            Wind wind = sources_only({20, 16, 18}, 1.0f, {1.0f, 0.0f, 2.0f}, centre);
            for (Motor motor : motors) {
                std::visit([&](auto& kind) { kind.position += centre; }, motor);
                added(wind, motor);
            }
            wind.step(0.1);
            return wind;
        };
        Wind first = blown(glm::dvec3(0.0));
        const auto first_expansion = first.state().cells.sources.expansion();
        for (int n = 0; n < 10; ++n) {
            Wind other = blown(glm::round(random.direction() * random.spread(10.0, 1e6)));
            EXPECT_EQ(cells_that_differ(first.field(), other.field()), 0u);
            const auto expansion = other.state().cells.sources.expansion();
            EXPECT_TRUE(std::equal(expansion.begin(), expansion.end(), first_expansion.begin(), first_expansion.end()));
        }
    }
}

// --- Jets --------------------------------------------------------------------------------------------------------------

TEST(MotorKinds, AJetsSectionsPassTheSameMomentumAlongRaysFromItsTip) {
    Random random(51);
    double worst_momentum = 0.0, worst_ray = 0.0;
    for (int trial = 0; trial < 40; ++trial) {
        const Motor motor = some_motor(trial % 4 == 0 ? MotorForm::cylinder : MotorForm::jet, Force{1.0f}, random);
        const auto& jet = std::get<JetMotor>(motor);
        const ColumnForm column = column_of(jet);
        Wind wind = sources_only({18, 18, 18});
        added(wind, motor);
        wind.step(1.0);
        const glm::dvec3 tip = column.direction * (-column.start * column.length / (column.end - column.start));
        for_each_cell(wind, [&](glm::dvec3 centre, std::size_t n) {
            const glm::dvec3 p = centre - jet.position;
            const double weight = column.weight(p);
            if (weight < 0.05)
                return;
            // pi r^2 u^2 of the section through this cell against that of the nozzle.
            const glm::dvec3 u = glm::dvec3(wind.field()[n]) / weight;
            const double momentum = std::pow(column.along(u) * column.radius(p) / column.start, 2);
            worst_momentum = std::max(worst_momentum, std::abs(momentum - 1.0));
            const glm::dvec3 ray = column.start == column.end ? column.direction : glm::normalize(p - tip);
            worst_ray = std::max(worst_ray, glm::length(glm::cross(u, ray)) / glm::length(u));
        });
    }
    WINDROW_EXPECT_FIGURE("jet_section_momentum", worst_momentum, 1e-3); // of cells down to a weight of 0.05
    WINDROW_EXPECT_FIGURE("jet_ray_sine", worst_ray, 1e-4);
}

// --- Whirls ------------------------------------------------------------------------------------------------------------

TEST(MotorKinds, AWhirlTurnsRightHandedFastestAt447OfItsRadius) {
    Random random(52);
    const VortexMotor whirl{.radius = 4.0f, .half_length = 4.0f, .law = Force{2.0f}};
    Wind wind = sources_only({72, 4, 72}, 0.125f);
    added(wind, whirl);
    wind.step(0.5);
    double fastest = 0.0, at = 0.0;
    for_each_cell(wind, [&](glm::dvec3 centre, std::size_t n) {
        if (const double speed = glm::length(glm::dvec3(wind.field()[n])); speed > fastest) {
            fastest = speed;
            at = std::hypot(centre.x, centre.z) / 4.0;
        }
    });
    WINDROW_EXPECT_FIGURE("whirl_fastest_at_share_of_radius_off", std::abs(at - 1.0 / std::sqrt(5.0)), 0.005);
    WINDROW_EXPECT_FIGURE("whirl_fastest_off", std::abs(fastest - 1.0), 1e-3); // 2 m/s^2 for half a second

    for (int trial = 0; trial < 100; ++trial) {
        const glm::dvec3 axis = random.direction();
        const auto turned = [&](float acceleration) {
            Wind air = sources_only({12, 12, 12});
            added(air, VortexMotor{.axis = glm::vec3(axis), .radius = 5.0f, .half_length = 5.0f, .law = Force{acceleration}});
            air.step(0.5);
            return air;
        };
        const Wind right = turned(2.0f), left = turned(-2.0f);
        for_each_cell(right, [&](glm::dvec3 p, std::size_t n) {
            const glm::dvec3 turning = glm::cross(axis, p);
            const glm::dvec3 u(right.field()[n]);
            ASSERT_EQ(glm::vec3(left.field()[n]), -glm::vec3(right.field()[n]))
                << "a negative acceleration turns it the other way";
            if (glm::length(u) > 1e-3) {
                ASSERT_GT(glm::dot(u, turning), 0.999 * glm::length(u) * glm::length(turning)) << "right-handed";
            }
        });
    }
}

TEST(MotorKinds, AWhirlPutsInNextToNoDivergence) {
    double divergence_of[3];
    for (int level = 0; level < 3; ++level) {
        const float radius = 5.0f * static_cast<float>(1 << level);
        Wind wind = sources_only({48, 12, 48});
        const VortexMotor whirl{.position = {0.3, 0.1, -0.2}, .radius = radius, .half_length = 5.0f, .law = Force{1.0f}};
        added(wind, whirl);

        wind.step(1.0);

        auto work = Workspace::create({.box = wind.box()});
        std::vector<float> put_in(wind.box().cell_count());
        divergence(*work, wind.field(), put_in);
        float largest = 0.0f;
        for (const float d : put_in)
            largest = std::max(largest, std::abs(d));
        divergence_of[level] = largest; // max |u| = 1 m/s, cells of 1 m
        figure("whirl_divergence_at_" + std::to_string(5 << level) + "_cells", largest);
    }
    WINDROW_EXPECT_FIGURE("whirl_divergence_20_cells", divergence_of[2], 4e-3); // of max |u| / h
    EXPECT_GE(figure("whirl_divergence_order", std::log2(divergence_of[1] / divergence_of[2]), 1.9), 1.9);
}

// --- Thin regions: widened, their impulse kept ---------------------------------------------------------------------------

// The impulse that a thin motor should give along its axis (about it, for a whirl), times 1 s and 1 m/s^2.
double impulse_of(const Motor& motor) {
    if (const auto* vortex = std::get_if<VortexMotor>(&motor)) // axial 16/15 H; across, 2 pi R^3 times 1/24
        return 16.0 / 15.0 * double(vortex->half_length) * pi / 12.0 * k_swirl * std::pow(double(vortex->radius), 3);
    if (const auto* jet = std::get_if<JetMotor>(&motor)) { // pi r^2 / 3 times r0 / r, along 8 L / 15
        const ColumnForm c = column_of(*jet);
        return 8.0 / 15.0 * c.length * pi / 3.0 * c.start * 0.5 * (c.start + c.end);
    }
    const Region& region = std::get<DirectionalMotor>(motor).region;
    const auto ball = [](double radius) { return 32.0 * pi / 105.0 * std::pow(radius, 3); };
    if (const auto* sphere = std::get_if<Sphere>(&region))
        return ball(sphere->radius);
    if (const auto* capsule = std::get_if<Capsule>(&region))
        return ball(capsule->radius) +
               2.0 * pi / 3.0 * std::pow(double(capsule->radius), 2) * glm::length(glm::dvec3(capsule->half_axis));
    if (const auto* box = std::get_if<AlignedBox>(&region))
        return std::pow(16.0 / 15.0, 3) * double(box->half_size.x) * box->half_size.y * box->half_size.z;
    const auto& cone = std::get<Cone>(region);
    const double a = 0.5 * (double(cone.start_radius) + double(cone.end_radius)), b = a - double(cone.start_radius);
    return 8.0 * pi / 45.0 * glm::length(glm::dvec3(cone.axis)) * (a * a + b * b / 7.0);
}

// Sampled at cell centres, a region of 1.5 cells gives a few per cent more or less as it lies; over all places the mean is right.
TEST(MotorKinds, WideningKeepsTheImpulse) {
    using ThinMotor = std::function<Motor(float radius, float length, const glm::dvec3& position, const glm::vec3& axis)>;
    const auto region = [](auto region_of) -> ThinMotor {
        return [=](float radius, float length, const glm::dvec3& position, const glm::vec3& axis) {
            return DirectionalMotor{position, axis, region_of(radius, length, axis), Force{1.0f}, {}, k_steady};
        };
    };
    const auto jet = [](auto end_of) -> ThinMotor {
        return [=](float radius, float length, const glm::dvec3& position, const glm::vec3& axis) {
            return JetMotor{position, axis, length, radius, end_of(radius, length), Force{1.0f}, {}, k_steady};
        };
    };
    // Of each place, `length` is 6 or 1 cells: long, and too short for the cells as well.
    const std::tuple<const char*, double, ThinMotor> thin_motors[] = {
        {"sphere", 0.1, region([](float radius, float, glm::vec3) { return Sphere{radius}; })},
        {"capsule", 0.04, region([](float radius, float length, glm::vec3 axis) {
             return Capsule{0.4f * length * axis, radius};
         })},
        {"box", 0.04, region([](float radius, float, glm::vec3) { return AlignedBox{glm::vec3(radius)}; })},
        {"flat_box", 0.02, region([](float radius, float, glm::vec3) { return AlignedBox{glm::vec3(4.0f, radius, 4.0f)}; })},
        {"cone", 0.1, region([](float radius, float length, glm::vec3 axis) {
             return Cone{length * axis, radius, 1.5f};
         })},
        {"jet", 0.1, jet([](float, float) { return 1.5f; })},
        {"cylinder", 0.1, jet([](float radius, float) { return radius; })},
        {"vortex", 0.1, [](float radius, float length, const glm::dvec3& position, const glm::vec3& axis) {
             return VortexMotor{position, axis, radius, 0.5f * length, 0.0f, Force{1.0f}};
         }}};
    for (const auto& [form, bound, motor_of] : thin_motors) {
        double all_worst = 0.0, worst_mean = 0.0;
        for (const float radius : {0.1f, 0.2f, 0.4f, 0.75f, 1.1f, 1.5f}) {
            Random random(53);
            double worst = 0.0, mean = 0.0;
            for (int place = 0; place < 64; ++place) {
                const glm::dvec3 axis = random.direction(), position = random.point(1.0);
                const Motor motor = motor_of(radius, place % 2 == 0 ? 6.0f : 1.0f, position, glm::vec3(axis));
                Wind wind = sources_only({20, 20, 20});
                added(wind, motor);
                wind.step(1.0);
                double given = 0.0;
                for_each_cell(wind, [&](glm::dvec3 centre, std::size_t n) {
                    const glm::dvec3 u(wind.field()[n]);
                    given += glm::dot(axis, std::holds_alternative<VortexMotor>(motor) ? glm::cross(centre - position, u) : u);
                });
                const double ratio = given / impulse_of(motor);
                worst = std::max(worst, std::abs(ratio - 1.0));
                mean += ratio / 64.0;
            }
            const std::string name = std::string("widened_") + form + "_" + std::to_string(radius).substr(0, 4);
            figure(name + "_worst", worst);
            figure(name + "_mean", mean - 1.0);
            all_worst = std::max(all_worst, worst);
            worst_mean = std::max(worst_mean, std::abs(mean - 1.0));
        }
        WINDROW_EXPECT_FIGURE(std::string("widened_") + form + "_worst", all_worst, bound);
        WINDROW_EXPECT_FIGURE(std::string("widened_") + form + "_mean", worst_mean, 0.005);
    }
}

// --- Sources of air ------------------------------------------------------------------------------------------------------

TEST(MotorKinds, ASourceLetsInItsFlowAndNothingOutsideItsBall) {
    Random random(54);
    double worst = 0.0, worst_flow = 0.0;
    for (int trial = 0; trial < 50; ++trial) {
        const float h = static_cast<float>(random.spread(0.2, 5.0));
        const OmniMotor vent{.position = random.point(2.0) * double(h),
                             .radius = h * random.uniform(2.0f, 5.0f),
                             .speed = random.uniform(-9.0f, 9.0f)};
        Wind wind = sources_only({16, 16, 16}, h);
        added(wind, vent);
        wind.step(0.1);
        const double radius = vent.radius, flow = 4.0 * pi * radius * radius * double(vent.speed);
        const double most = flow / (32.0 * pi / 105.0 * std::pow(radius, 3));
        const auto expansion = wind.state().cells.sources.expansion();
        ASSERT_EQ(expansion.size(), wind.box().cell_count());
        double sum = 0.0;
        for_each_cell(wind, [&](glm::dvec3 centre, std::size_t n) {
            const glm::dvec3 p = centre - vent.position;
            const double squared = glm::dot(p, p) / (radius * radius);
            worst = std::max(worst, std::abs(double(expansion[n]) - most * biweight(squared)) / std::abs(most));
            if (squared > 1.001) {
                ASSERT_EQ(expansion[n], 0.0f);
            }
            sum += expansion[n];
        });
        EXPECT_EQ(energy_of(wind.field()), 0.0) << "without a projection nothing moves";
        worst_flow = std::max(worst_flow, std::abs(sum * std::pow(double(h), 3) / flow - 1.0));
    }
    WINDROW_EXPECT_FIGURE("source_weight_error", worst, 2e-5);
    WINDROW_EXPECT_FIGURE("source_flow_error", worst_flow, 0.03); // sampled at cell centres, two to five cells of radius
}

// --- Times ---------------------------------------------------------------------------------------------------------------

// Steps that add up to `seconds`: even ones at a rate, or, at rate 0, uneven ones.
std::vector<double> steps_of(double seconds, double rate_hz) {
    std::vector<double> steps;
    Random random(55);
    for (double left = seconds; left > 1e-9; left -= steps.back())
        steps.push_back(std::min(left, rate_hz > 0.0 ? 1.0 / rate_hz : random.spread(1e-3, 0.2)));
    return steps;
}

TEST(MotorKinds, AnEnvelopeGivesItsClosedFormAtAnyFrameRate) {
    const Envelope gust{.attack = 0.13f, .hold = 0.41f, .decay = 0.29f};
    const double full = double(gust.attack) / 2.0 + double(gust.hold) + double(gust.decay) / 2.0;
    EXPECT_NEAR(gust.mean(0.0, 10.0) * 10.0, full, 1e-12);
    EXPECT_NEAR(gust.end(), 0.83, 1e-7);
    EXPECT_EQ(gust.mean(0.9, 5.0), 0.0);
    for (const bool drives : {false, true}) {
        double worst = 0.0;
        for (const MotorForm form : {MotorForm::cone, MotorForm::jet, MotorForm::vortex}) {
            const Law law = drives ? Law(Drive{}) : Law(Force{5.0f});
            Random place(56), same_place(56);
            const Motor steady = some_motor(form, law, place), gusty = some_motor(form, law, same_place, gust);
            Wind reference = sources_only({16, 16, 16});
            added(reference, steady);
            reference.step(full);
            for (const double rate : {30.0, 60.0, 144.0, 240.0, 0.0, 1.0}) {
                Wind wind = sources_only({16, 16, 16});
                added(wind, gusty);
                for (const double dt : steps_of(1.0, rate))
                    wind.step(dt);
                EXPECT_EQ(wind.motors().count(), 0) << "it has removed itself";
                const double size = largest_speed(reference.field());
                worst = std::max(worst, largest_apart(wind.field(), reference.field()) / size);
            }
        }
        WINDROW_EXPECT_FIGURE(drives ? "envelope_drive_at_any_rate" : "envelope_force_at_any_rate", worst,
                              1e-5); // rounding of 240 steps
    }
}

TEST(MotorKinds, ABurstLeavesNoAirOverAndEndsAfterTwelveDurations) {
    double worst = 0.0, worst_thrown = 0.0;
    for (const double rate : {30.0, 60.0, 144.0, 240.0, 0.0}) {
        Wind wind = sources_only({12, 12, 12});
        const PressureMotor burst{.radius = 3.0f, .speed = 20.0f, .duration = 0.2f};
        added(wind, burst);
        const std::size_t middle = wind.box().index(6, 6, 6);
        double sum = 0.0, most = 0.0;
        for (const double dt : steps_of(2.5, rate)) {
            const bool stands = wind.motors().count() == 1;
            wind.step(dt);
            const auto expansion = wind.state().cells.sources.expansion();
            ASSERT_TRUE(stands || expansion.empty());
            sum += expansion.empty() ? 0.0 : dt * double(expansion[middle]);
            most = std::max(most, sum);
        }
        EXPECT_EQ(wind.motors().count(), 0);
        worst = std::max(worst, std::abs(sum) / most);
        // Thrown out by the time T: T / e of the first moment's flow, 105 v / (8 R) times the weight.
        const double first = 105.0 * 20.0 / (8.0 * 3.0) * biweight(0.75 / 9.0);
        if (rate > 100.0)
            worst_thrown = std::max(worst_thrown, std::abs(most / (first * 0.2 / std::numbers::e) - 1.0));
    }
    WINDROW_EXPECT_FIGURE("burst_air_left_over", worst, 1e-6);
    WINDROW_EXPECT_FIGURE("burst_air_thrown_out", worst_thrown, 1e-3);
    const PressureMotor burst{.duration = 0.0625f};
    EXPECT_EQ(burst.end(), 0.75);
    EXPECT_EQ(burst.mean(0.0, 1.0), 0.0);
}

TEST(MotorKinds, AMotorThatHasEndedIsGoneAndItsHandleStale) {
    for (const Motor& motor : std::vector<Motor>{
             DirectionalMotor{.envelope = {0.125f, 0.5f, 0.125f}, .turbulence = k_steady},
             JetMotor{.envelope = {0.125f, 0.5f, 0.125f}, .turbulence = k_steady},
             VortexMotor{.envelope = {0.125f, 0.5f, 0.125f}}, OmniMotor{.envelope = {0.125f, 0.5f, 0.125f}},
             WakeMotor{.envelope = {0.125f, 0.5f, 0.125f}}, PressureMotor{.duration = 0.0625f}}) { // all end at 0.75 s
        Wind wind = sources_only({8, 8, 8});
        Motors& motors = wind.motors();
        const MotorId id = added(wind, motor);
        for (int n = 0; n < 6; ++n) {
            ASSERT_NE(motors.find(id), nullptr) << "after " << n << " of 6 steps";
            ASSERT_EQ(motors.count(), 1);
            ASSERT_TRUE(motors.move(id, {0.1 * n, 0.0, 0.0}));
            wind.step(0.125);
        }
        EXPECT_EQ(motors.find(id), nullptr);
        EXPECT_EQ(motors.count(), 0);
        const MotorId next = added(wind, OmniMotor{.position = {7.0, 8.0, 9.0}});
        EXPECT_EQ(next.slot, id.slot) << "the slot is used again";
        EXPECT_NE(next.generation, id.generation);
        EXPECT_FALSE(motors.move(id, {0.0, 0.0, 0.0}));
        EXPECT_FALSE(motors.set(id, motor));
        EXPECT_FALSE(motors.remove(id));
        EXPECT_EQ(position_of(*motors.find(next)), glm::dvec3(7.0, 8.0, 9.0));
        EXPECT_EQ(motors.count(), 1);
    }
}

} // namespace
