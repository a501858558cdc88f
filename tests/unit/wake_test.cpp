// A wake: a body that passes. It acts only while it moves, leaves no gap however fast it is, and gives the air the same
// impulse at any frame rate. Asked of the sources stage alone, and once of the whole step.

#include "fluid/core/numerics.h"
#include "tests/winds.h"

namespace {

using namespace windrow;
using namespace windrow::test;

glm::dvec3 impulse_of(const Wind& wind) {
    return sum_of(wind.field()) * std::pow(double(wind.box().cell_size), 3);
}

// Moves a new body along `path`(t), t in [0, seconds], at so many steps a second.
void pass(Wind& wind, WakeMotor body, const std::function<glm::dvec3(double)>& path, double seconds, double rate_hz) {
    body.position = path(0.0);
    const MotorId id = added(wind, body);
    const int steps = static_cast<int>(std::lround(seconds * rate_hz));
    for (int n = 1; n <= steps; ++n) {
        ASSERT_TRUE(wind.motors().move(id, path(n / rate_hz)));
        wind.step(1.0 / rate_hz);
    }
    ASSERT_TRUE(wind.motors().remove(id));
}

double volume_of_ball_weight(double radius) {
    return 32.0 * std::numbers::pi / 105.0 * std::pow(radius, 3);
}

TEST(Wake, ABodyThatStandsAddsExactlyNothing) {
    const glm::vec3 ambient(1.0f, 2.0f, 3.0f);
    for (const WakeMotor& body :
         {WakeMotor{.radius = 3.0f, .law = WakeForce{1e4f}}, WakeMotor{.radius = 3.0f, .law = WakeDrive{.per_metre = 1e4f}}}) {
        Wind wind = sources_only({8, 8, 8}, 1.0f, ambient);
        const MotorId id = added(wind, body);
        for (int n = 0; n < 100; ++n) {
            ASSERT_TRUE(wind.motors().move(id, body.position));
            EXPECT_EQ(wind.step(1.0 / 60.0).motors_in_reach, 0);
        }
        EXPECT_EQ(largest_off(wind.field(), ambient), 0.0);

        // It did stand in reach: one step of motion shows.
        ASSERT_TRUE(wind.motors().move(id, {0.5, 0.0, 0.0}));
        EXPECT_EQ(wind.step(1.0 / 60.0).motors_in_reach, 1);
        EXPECT_GT(glm::length(impulse_of(wind) - 512.0 * glm::dvec3(ambient)), 0.1);
        const Field moved = copy(wind.field());
        EXPECT_EQ(wind.step(1.0 / 60.0).motors_in_reach, 0) << "and stands again";
        EXPECT_EQ(cells_that_differ(moved, wind.field()), 0u);
    }
}

TEST(Wake, ImpulseASecondIsLinearInTheSpeed) {
    double low = 1e30, high = 0.0;
    for (const double speed : {0.01, 0.3, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0}) {
        Wind wind = sources_only({72, 12, 12});
        const double seconds = 1.0;
        // The start is that of the centre of a cell for every speed; short paths feel where in the cell they lie.
        pass(
            wind, {.radius = 3.0f, .law = WakeForce{0.7f}}, [&](double t) { return glm::dvec3(-25.5 + speed * t, 0.2, -0.3); },
            seconds, 60.0);
        const double each = impulse_of(wind).x / (speed * seconds);
        low = std::min(low, each);
        high = std::max(high, each);
    }
    WINDROW_EXPECT_FIGURE("wake_linear_in_speed", high / low - 1.0, 0.01);
}

TEST(Wake, ImpulseOfAPathDoesNotDependOnTheFrameRate) {
    const auto circle = [](double t) { return glm::dvec3(7.0 * std::cos(2.0 * t), 0.3, 7.0 * std::sin(2.0 * t)); };
    for (const bool drives : {false, true}) {
        const WakeMotor body{.radius = 1.2f, .law = drives ? decltype(WakeMotor::law)(WakeDrive{}) : WakeForce{}};
        Wind fine = sources_only({24, 10, 24});
        pass(fine, body, circle, 1.0, 960.0);
        const double size = std::sqrt(energy_of(fine.field()));
        double worst = 0.0, worst_field = 0.0;
        for (const double rate : {30.0, 45.0, 60.0, 72.0, 120.0, 144.0, 240.0}) {
            Wind wind = sources_only({24, 10, 24});
            pass(wind, body, circle, 1.0, rate);
            worst = std::max(worst, glm::length(impulse_of(wind) - impulse_of(fine)) / glm::length(impulse_of(fine)));
            Field difference = copy(wind.field());
            for (std::size_t n = 0; n < difference.size(); ++n)
                difference[n] -= fine.field()[n];
            worst_field = std::max(worst_field, std::sqrt(energy_of(difference)) / size);
        }
        const std::string name = drives ? "wake_drive" : "wake_force";
        WINDROW_EXPECT_FIGURE(name + "_impulse_30_to_240_hz", worst, 0.02);
        WINDROW_EXPECT_FIGURE(name + "_field_30_to_240_hz", worst_field, 0.03);
    }
}

// In the whole step too. In a periodic box nothing else changes the sum.
TEST(Wake, TheWholeStepGivesTheSameImpulse) {
    const auto circle = [](double t) { return glm::dvec3(6.0 * std::cos(1.5 * t), 0.3, 6.0 * std::sin(1.5 * t)); };
    const double strength = 0.2;
    double smallest = 1e30, largest = 0.0;
    glm::dvec3 mean(0.0);
    std::vector<glm::dvec3> impulses;
    for (const double rate : {30.0, 45.0, 60.0, 72.0, 120.0, 144.0, 240.0}) {
        Wind wind = made({.cells = {24, 12, 24},
                          .boundaries = Boundaries::all(BoundaryKind::periodic),
                          .viscosity = 0.0f,
                          .relaxation_time = 0.0f});
        pass(wind, {.radius = 2.0f, .law = WakeForce{float(strength)}}, circle, 1.0, rate);
        impulses.push_back(impulse_of(wind));
        mean += impulses.back() / 7.0;
        smallest = std::min(smallest, glm::length(impulses.back()));
        largest = std::max(largest, glm::length(impulses.back()));
    }
    double worst = 0.0;
    for (const glm::dvec3& impulse : impulses)
        worst = std::max(worst, glm::length(impulse - mean) / glm::length(mean));
    // The chord of the path times strength and volume: what the sources gave.
    const double given = strength * volume_of_ball_weight(2.0) * glm::length(circle(1.0) - circle(0.0));
    WINDROW_EXPECT_FIGURE("wake_whole_step_30_to_240_hz", worst, 0.02);
    WINDROW_EXPECT_FIGURE("wake_whole_step_against_given",
                          std::max(std::abs(largest / given - 1.0), std::abs(smallest / given - 1.0)), 0.02);
}

TEST(Wake, ADriveFollowsItsClosedFormAndPiecesOfThePathAddUp) {
    Random random(31);
    double worst = 0.0;
    for (int trial = 0; trial < 30; ++trial) {
        const glm::vec3 ambient = random.vector(4.0f);
        const WakeDrive law{.per_metre = static_cast<float>(random.spread(0.05, 20.0)),
                            .entrainment = random.uniform(0.0f, 2.0f)};
        const float radius = random.uniform(1.5f, 3.0f);
        const glm::dvec3 start = random.point(4.0), velocity = random.direction() * random.spread(0.5, 30.0);
        const double seconds = 0.5;
        for (const int pieces : {1, 2, 7, 60}) {
            Wind wind = sources_only({16, 14, 15}, 1.0f, ambient);
            pass(
                wind, {.radius = radius, .law = law}, [&](double t) { return start + velocity * t; }, seconds, pieces / seconds);
            for_each_cell(wind, [&](glm::dvec3 centre, std::size_t n) {
                const double path = numerics::windrow_wake_path(glm::vec3(centre), glm::vec3(start),
                                                                glm::vec3(start + velocity * seconds), radius);
                const double share = -std::expm1(-double(law.per_metre) * path);
                const glm::dvec3 expected =
                    glm::dvec3(ambient) + share * (double(law.entrainment) * velocity - glm::dvec3(ambient));
                worst = std::max(worst, glm::length(glm::dvec3(wind.field()[n]) - expected) / (1.0 + glm::length(velocity)));
            });
        }
    }
    WINDROW_EXPECT_FIGURE("wake_drive_error", worst,
                          2e-4); // relative to the body's speed; positions are kept to 1/65536 of a cell
}

TEST(Wake, AFastBodyLeavesNoGap) {
    // Along an axis every cell on the way must get the same; askew, the planes across the way.
    Random random(32);
    for (const float radius : {0.5f, 1.5f, 3.0f}) {
        Wind straight = sources_only({64, 8, 8});
        pass(
            straight, {.radius = radius, .law = WakeForce{}}, [](double t) { return glm::dvec3(-25.0 + 50.0 * t, 0.5, 0.5); },
            1.0, 30.0);
        float least = 1e30f, most = 0.0f;
        for (double x = -20.5; x <= 20.5; x += 1.0) {
            const float u = straight.velocity({x, 0.5, 0.5}).x;
            least = std::min(least, u);
            most = std::max(most, u);
        }
        const std::string name = "wake_50_mps_30_hz_radius_" + std::to_string(radius).substr(0, 3);
        EXPECT_GE(figure(name + "_along_axis", least / most, 0.999), 0.999);

        double worst = 1.0;
        for (int trial = 0; trial < 8; ++trial) {
            glm::dvec3 direction = random.direction() * glm::dvec3(1.0, 0.5, 0.5);
            direction = glm::normalize(
                glm::dvec3(std::copysign(std::max(std::abs(direction.x), 0.75), direction.x), direction.y, direction.z));
            const glm::dvec3 through = random.point(1.0);
            Wind wind = sources_only({64, 64, 64});
            pass(
                wind, {.radius = radius, .law = WakeForce{}}, [&](double t) { return through + direction * (50.0 * t - 25.0); },
                1.0, 30.0);
            double low = 1e30, high = 0.0;
            for (int i = 18; i < 46; ++i) {
                double sum = 0.0;
                for (int k = 0; k < 64; ++k)
                    for (int j = 0; j < 64; ++j)
                        sum += glm::dot(glm::dvec3(wind.field()[wind.box().index(i, j, k)]), direction);
                low = std::min(low, sum);
                high = std::max(high, sum);
            }
            worst = std::min(worst, low / high);
        }
        EXPECT_GE(figure(name + "_askew", worst, 0.9), 0.9);
    }
}

TEST(Wake, AThinBodyIsWidenedAndKeepsItsImpulse) {
    Random random(33);
    double worst = 0.0, mean = 0.0;
    const int trials = 60;
    for (int trial = 0; trial < trials; ++trial) {
        const float h = static_cast<float>(random.spread(0.1, 4.0)), radius = h * static_cast<float>(random.spread(0.02, 1.5));
        Wind wind = sources_only({32, 32, 32}, h);
        const glm::dvec3 start = random.point(1.0) * double(h), velocity = random.direction() * 12.0 * double(h);
        pass(
            wind, {.radius = radius, .law = WakeForce{3.0f}}, [&](double t) { return start + velocity * (t - 0.5); }, 1.0, 60.0);
        const double given = 3.0 * volume_of_ball_weight(radius) * glm::length(velocity);
        const double ratio = glm::dot(impulse_of(wind), glm::normalize(velocity)) / given;
        worst = std::max(worst, std::abs(ratio - 1.0));
        mean += ratio / trials;
    }
    WINDROW_EXPECT_FIGURE("thin_wake_impulse", worst, 0.03);
    WINDROW_EXPECT_FIGURE("thin_wake_impulse_mean", std::abs(mean - 1.0), 0.005);
}

TEST(Wake, MoveSweepsAndSetDoesNot) {
    const auto swept = [](bool move) {
        Wind wind = sources_only({32, 8, 8});
        WakeMotor body{.position = {-10.0, 0.0, 0.0}, .radius = 1.5f, .law = WakeForce{}};
        const MotorId id = added(wind, body);
        body.position.x = 10.0;
        EXPECT_TRUE(move ? wind.motors().move(id, body.position) : wind.motors().set(id, body));
        wind.step(0.25); // 80 m/s
        return wind;
    };
    EXPECT_EQ(energy_of(swept(false).field()), 0.0) << "set carries the body over";
    const Wind moved = swept(true);
    EXPECT_GT(moved.velocity({0.0, 0.0, 0.0}).x, 0.5) << "move drags it along";

    // A path begins where the body was added, and after a set where it was set.
    Wind wind = sources_only({32, 8, 8});
    WakeMotor body{.position = {-10.0, 0.0, 0.0}, .radius = 1.5f, .law = WakeForce{}};
    const MotorId id = added(wind, body);
    body.position = {2.0, 0.0, 0.0};
    ASSERT_TRUE(wind.motors().set(id, body));
    ASSERT_TRUE(wind.motors().move(id, {10.0, 0.0, 0.0}));
    wind.step(0.25);
    EXPECT_EQ(wind.velocity({-6.0, 0.0, 0.0}).x, 0.0f);
    EXPECT_GT(wind.velocity({6.0, 0.0, 0.0}).x, 0.5f);
}

TEST(Wake, SeveralMovesInAStepSweepTheStraightWayOnce) {
    const auto pushed = [](int moves) {
        Wind wind = sources_only({32, 8, 8});
        const MotorId id = added(wind, WakeMotor{.position = {-8.0, 0.0, 0.0}, .radius = 1.5f, .law = WakeForce{}});
        for (int n = 1; n <= moves; ++n)
            EXPECT_TRUE(wind.motors().move(id, {-8.0 + 16.0 * n / moves, 0.0, 0.0}));
        wind.step(1.0 / 60.0);
        return copy(wind.field());
    };
    EXPECT_EQ(cells_that_differ(pushed(1), pushed(5)), 0u);
}

} // namespace
