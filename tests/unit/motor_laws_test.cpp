// What a directional motor does to the air, asked of the sources stage alone: the closed forms of its two laws, in double. Those of
// its regions are in motor_kinds_test.cpp.

#include "fluid/gust_tile.h"
#include "tests/winds.h"

namespace {

using namespace windrow;
using namespace windrow::test;

glm::vec4 air_at(const Wind& wind, glm::dvec3 position) {
    const glm::ivec3 cell(glm::floor((position - wind.origin()) / double(wind.box().cell_size)));
    return wind.field()[wind.box().index(cell.x, cell.y, cell.z)];
}

constexpr float k_radius = 3.0f;
double ball_weight(glm::dvec3 p) {
    return biweight(glm::dot(p, p) / (double(k_radius) * k_radius));
}

// --- A uniform force adds f dt a step, and nothing once it is gone ---------------------------------------------------

TEST(MotorLaws, AUniformForceAddsUpAndThenNothing) {
    for (const bool dyadic : {true, false}) {
        Wind wind = sources_only({9, 6, 7});
        const double dt = dyadic ? 1.0 / 64.0 : 1.0 / 60.0;
        const float force = dyadic ? 0.5f : 0.7f;
        const MotorId id =
            added(wind, DirectionalMotor{.region = AlignedBox{glm::vec3(1e6f)}, .law = Force{force}, .turbulence = k_steady});
        take_steps(wind, 1000, dt);
        const double expected = 1000.0 * dt * double(force);
        double worst = 0.0;
        for (const glm::vec4& u : wind.field()) {
            worst = std::max(worst, std::abs(double(u.x) - expected) / expected);
            ASSERT_EQ(u.y, 0.0f);
            ASSERT_EQ(u.z, 0.0f);
        }
        WINDROW_EXPECT_FIGURE(dyadic ? "uniform_force_dyadic" : "uniform_force", worst, dyadic ? 0.0 : 1e-4);

        ASSERT_TRUE(wind.motors().remove(id));
        const Field before = copy(wind.field());
        EXPECT_EQ(wind.step(dt).motors_in_reach, 0);
        EXPECT_EQ(cells_that_differ(before, wind.field()), 0u) << "without a motor the next step adds exactly 0";
    }
}

// --- The force of a directional motor: at the centre, outside, its direction, its place ------------------------------

TEST(MotorLaws, AtTheCentreAForceAddsItsAccelerationTimesTime) {
    double worst = 0.0;
    Random random(3);
    for (const Region& region :
         {Region(Sphere{k_radius}), Region(Capsule{{1.0f, 2.0f, -1.0f}, 2.0f}), Region(AlignedBox{{2.0f, 3.0f, 4.5f}})}) {
        Wind wind = sources_only({15, 15, 15});
        const float force = random.uniform(1.0f, 50.0f);
        added(wind, DirectionalMotor{.position = {0.5, 0.5, 0.5},
                                     .direction = {0.0f, 0.0f, 1.0f},
                                     .region = region,
                                     .law = Force{force},
                                     .turbulence = k_steady});
        take_steps(wind, 10, 1.0 / 60.0);
        const double expected = 10.0 / 60.0 * force;
        worst = std::max(worst, std::abs(air_at(wind, glm::dvec3(0.5)).z - expected) / expected);
    }
    WINDROW_EXPECT_FIGURE("force_at_centre", worst, 1e-6);
}

TEST(MotorLaws, TheSameAirWhereverTheWindowLies) {
    for (const float h : {1.0f, 0.37f}) {
        const glm::dvec3 place = glm::dvec3(10.123456789, -3.3, 1234.56789) * double(h);
        const auto blown = [&](glm::dvec3 centre) {
            Wind wind = sources_only({24, 16, 20}, h);
            EXPECT_TRUE(wind.follow(centre));
            added(wind, DirectionalMotor{.position = place,
                                         .direction = {1.0f, 2.0f, 3.0f},
                                         .region = Sphere{3.1f * h},
                                         .law = Force{5.0f},
                                         .turbulence = k_steady});
            added(wind,
                  DirectionalMotor{
                      .position = place, .region = Capsule{{h, h, 0.0f}, 2.0f * h}, .law = Drive{}, .turbulence = k_steady});
            wind.step(0.1);
            return wind;
        };
        const Wind first = blown(place);
        Random random(16);
        double worst = 0.0;
        int compared = 0;
        for (int n = 0; n < 10; ++n) {
            const Wind other = blown(place + random.point(4.0) * double(h));
            const glm::ivec3 offset(glm::round((first.origin() - other.origin()) / double(h)));
            const glm::ivec3 cells = first.box().cells;
            for_each_cell(cells, [&](int i, int j, int k) {
                const glm::ivec3 there = glm::ivec3(i, j, k) + offset;
                if (glm::any(glm::lessThan(there, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(there, cells)))
                    return;
                const glm::vec4 a = first.field()[first.box().index(i, j, k)];
                const glm::vec4 b = other.field()[other.box().index(there.x, there.y, there.z)];
                worst = std::max(worst, glm::length(glm::dvec3(a) - glm::dvec3(b)));
                compared += a.x != 0.0f;
            });
        }
        EXPECT_GT(compared, 1000);
        WINDROW_EXPECT_FIGURE(h == 1.0f ? "ten_windows_1m" : "ten_windows_0.37m", worst, h == 1.0f ? 0.0 : 1e-5);
    }
}

// --- Drives ----------------------------------------------------------------------------------------------------------

TEST(MotorLaws, ADriveFollowsItsExponential) {
    Random random(7);
    double worst = 0.0;
    for (int trial = 0; trial < 60; ++trial) {
        const glm::vec3 ambient = random.vector(5.0f);
        Wind wind = sources_only({14, 12, 13}, 1.0f, ambient);
        const Drive law{.speed = random.uniform(-9.0f, 9.0f), .rate = static_cast<float>(random.spread(0.01, 100.0))};
        const glm::dvec3 direction = random.direction(), place = random.point(4.0);
        added(wind, DirectionalMotor{.position = place,
                                     .direction = glm::vec3(direction),
                                     .region = Sphere{k_radius},
                                     .law = law,
                                     .turbulence = k_steady});
        const double dt = random.spread(1e-3, 1.0);
        const int steps = random.integer(1, 8);
        take_steps(wind, steps, dt);
        for_each_cell(wind, [&](glm::dvec3 centre, std::size_t n) {
            // Steps compose: n steps of dt are one of n dt.
            const double share = -std::expm1(-double(law.rate) * ball_weight(centre - place) * dt * steps);
            const glm::dvec3 expected = glm::dvec3(ambient) + share * (double(law.speed) * direction - glm::dvec3(ambient));
            worst = std::max(worst, glm::length(glm::dvec3(wind.field()[n]) - expected));
        });
    }
    WINDROW_EXPECT_FIGURE("drive_error", worst,
                          4e-4); // [m/s]; the place is kept to 1/65536 m, and the wind rises by up to 14 m/s within a metre
}

TEST(MotorLaws, DrivesThatOverlapAddTheirExponents) {
    Wind wind = sources_only({7, 7, 7});
    const glm::dvec3 place(0.5);
    added(wind, DirectionalMotor{.position = place,
                                 .direction = {1.0f, 0.0f, 0.0f},
                                 .region = Sphere{2.0f},
                                 .law = Drive{.speed = 6.0f, .rate = 3.0f},
                                 .turbulence = k_steady});
    added(wind, DirectionalMotor{.position = place,
                                 .direction = {0.0f, 1.0f, 0.0f},
                                 .region = Sphere{2.0f},
                                 .law = Drive{.speed = 4.0f, .rate = 1.0f},
                                 .turbulence = k_steady});
    wind.step(0.25);
    const glm::vec4 u = air_at(wind, place);
    const double share = -std::expm1(-1.0); // E = (3 + 1) * 0.25
    EXPECT_NEAR(u.x, share * 6.0 * 0.75, 2e-6);
    EXPECT_NEAR(u.y, share * 4.0 * 0.25, 2e-6);
}

TEST(MotorLaws, ADriveNeverOvershoots) {
    Random random(8);
    double worst = 0.0;
    for (int trial = 0; trial < 2000; ++trial) {
        const float start = random.uniform(-20.0f, 20.0f), speed = static_cast<float>(random.spread(1e-3, 1e4));
        Wind wind = sources_only({3, 3, 3}, 1.0f, {start, 0.0f, 0.0f});
        added(wind, DirectionalMotor{.position = {0.5, 0.5, 0.5},
                                     .region = Sphere{2.0f},
                                     .law = Drive{.speed = speed, .rate = static_cast<float>(random.spread(1e-6, 1e6))},
                                     .turbulence = k_steady});
        wind.step(random.spread(1e-6, 1e3));
        for (const glm::vec4& u : wind.field()) {
            const double low = std::min(start, speed), high = std::max(start, speed);
            worst = std::max({worst, (low - u.x) / std::max(std::abs(low), high), (u.x - high) / std::max(std::abs(low), high)});
        }
    }
    WINDROW_EXPECT_FIGURE("drive_overshoot", worst, 1.8e-7); // U - u rounds at up to twice the speed, the sum once more
}

// --- Turbulence ------------------------------------------------------------------------------------------------------

// The motor's age at the middle of a step says where its eddies are, however the time until then was cut into steps; they travel
// with the motor and at 0.7 of its speed. Truth: the tile, sampled in double.
TEST(MotorLaws, EddiesStandInTheTileWhereTheirTimeHasCarriedThem) {
    const auto tile = GustTile::bake(1);
    double worst = 0.0, largest = 0.0;
    for (const bool force : {false, true})
        for (const float length : {0.0f, 9.0f})
            for (const double first : {0.0, 0.013, 2.4, 60.0}) {
                Wind wind = sources_only({16, 12, 14});
                const glm::vec3 direction = glm::normalize(glm::vec3(1.0f, -2.0f, 0.5f));
                const float intensity = 0.4f, acceleration = 5.0f, speed = 6.0f, rate = 2.0f;
                DirectionalMotor motor{.direction = direction, .region = Sphere{k_radius}};
                if (force)
                    motor.law = Force{acceleration};
                else
                    motor.law = Drive{speed, rate};
                motor.turbulence = {.intensity = intensity, .length = length};
                const MotorId id = added(wind, motor);
                if (first > 0.0)
                    wind.step(first);
                const glm::dvec3 place(1.3, 0.4, -0.7);
                ASSERT_TRUE(wind.motors().move(id, place));
                wind.step(1e-6); // it stands there from now on
                const double dt = 0.05, middle = first + 1e-6 + 0.5 * dt;
                wind.set_velocity([](glm::dvec3) { return glm::vec3(0.0f); });
                wind.step(dt);
                const double along = force ? std::sqrt(2.0 * acceleration * k_radius) : speed;
                const double texel = (length > 0.0f ? double(length) : 2.0 * k_radius) / GustTile::k_longest_texels;
                for_each_cell(wind, [&](glm::dvec3 p, std::size_t n) {
                    const double weight = ball_weight(p - place);
                    const glm::dvec3 carried = 0.7 * along * middle * glm::dvec3(direction);
                    const glm::dvec3 eddy = glm::dvec3(tile->sample((p - place - carried) / texel));
                    const glm::dvec3 push = glm::dvec3(direction) + 2.8 * weight * double(intensity) * eddy;
                    const glm::dvec3 expected =
                        force ? dt * weight * acceleration * push : -std::expm1(-rate * weight * dt) * speed * push;
                    worst = std::max(worst, glm::length(glm::dvec3(wind.field()[n]) - expected));
                    largest = std::max(largest, weight > 0.5 ? glm::length(eddy) : 0.0);
                });
            }
    EXPECT_GT(largest, 1.0) << "no eddy was met";
    WINDROW_EXPECT_FIGURE("motor_eddies_off_the_tile_m_per_s", worst, 2e-4);
}

TEST(MotorLaws, SeedsBlowApartAndNoneIsNone) {
    const auto pushed = [](const Turbulence& turbulence) {
        Wind wind = sources_only({12, 12, 12});
        added(wind, JetMotor{.position = {-3.0, 0.0, 0.0}, .start_radius = 2.0f, .end_radius = 2.0f, .turbulence = turbulence});
        wind.step(0.1);
        return copy(wind.field());
    };
    const Field steady = pushed(k_steady), first = pushed({}), second = pushed({.seed = 1});
    EXPECT_EQ(cells_that_differ(steady, pushed({.intensity = 0.0f, .length = 3.0f, .seed = 9})), 0u);
    for (const auto& [name, a, b] : {std::tuple{"default", &steady, &first}, {"seeds", &first, &second}}) {
        double apart = 0.0, own = 0.0;
        for (std::size_t n = 0; n < steady.size(); ++n) {
            apart += glm::dot((*a)[n] - (*b)[n], (*a)[n] - (*b)[n]);
            own += glm::dot(steady[n], steady[n]);
        }
        // 5 % in each level component and half of that upward; two seeds are independent.
        EXPECT_GT(std::sqrt(apart / own), 0.03) << name;
        EXPECT_LT(std::sqrt(apart / own), 0.2) << name;
    }
}

} // namespace
