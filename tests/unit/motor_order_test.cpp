// Hundreds of motors: what the air feels depends neither on the order in which they were added nor on the threads, and no number
// of them at one place is too many.

#include "fluid/thread_pool.h"
#include "tests/tier.h"
#include "tests/winds.h"

#include <numeric>
#include <variant>

namespace {

using namespace windrow;
using namespace windrow::test;

using Law = std::variant<Force, Drive>;

// All kinds, regions and laws in turn, all over a box of 32 x 16 x 32 m and beyond its sides.
Motor some_motor(int n, Random& random) {
    const glm::dvec3 place = random.point(1.0) * glm::dvec3(18.0, 10.0, 18.0);
    const glm::vec3 direction(random.direction());
    const Law law = n / 6 % 2 == 0 ? Law(Force{random.uniform(-8.0f, 8.0f)}) : Law(Drive{random.uniform(-8.0f, 8.0f), 3.0f});
    const float size = static_cast<float>(random.spread(0.3, 4.0));
    const Envelope envelope =
        n % 5 == 0 ? Envelope{.attack = 0.1f, .hold = random.uniform(0.0f, 0.5f), .decay = 0.2f} : Envelope{};
    switch (n % 6) {
    case 0: {
        const Region regions[] = {Sphere{size}, Capsule{random.vector(3.0f), size}, AlignedBox{glm::vec3(size, 2.0f, 1.0f)},
                                  Cone{4.0f * direction, size, 1.0f}};
        return DirectionalMotor{place, direction, regions[n / 12 % 4], law, envelope, k_steady};
    }
    case 1:
        return WakeMotor{.position = place,
                         .radius = size,
                         .law = n / 6 % 2 == 0 ? decltype(WakeMotor::law)(WakeForce{}) : WakeDrive{},
                         .envelope = envelope};
    case 2:
        return JetMotor{place, direction, 5.0f, 0.5f * size, size, law, envelope, k_steady};
    case 3:
        return VortexMotor{place, direction, size + 1.0f, size, 0.3f, law, envelope};
    case 4:
        return OmniMotor{place, size, random.uniform(-3.0f, 3.0f), envelope};
    default:
        return PressureMotor{place, size, random.uniform(-6.0f, 6.0f), random.uniform(0.05f, 0.3f)};
    }
}

std::vector<Motor> some_motors(int count, std::uint32_t seed) {
    Random random(seed);
    std::vector<Motor> motors;
    for (int n = 0; n < count; ++n)
        motors.push_back(some_motor(n, random));
    return motors;
}

std::vector<int> shuffled(std::vector<int> order, Random& random) {
    for (std::size_t n = order.size(); n > 1; --n)
        std::swap(order[n - 1], order[static_cast<std::size_t>(random.integer(0, static_cast<int>(n) - 1))]);
    return order;
}

std::vector<int> numbers(int count) {
    std::vector<int> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    return order;
}

// A wind with motors under known names.
struct NumberedMotors {
    const std::vector<Motor>& motors;
    Wind wind;
    std::vector<MotorId> ids;

    NumberedMotors(const std::vector<Motor>& given, const ParallelFor& parallel_for)
        : motors(given), wind(*Wind::create({.ambient = {2.0f, 0.0f, 1.0f}, .parallel_for = parallel_for})), ids(given.size()) {}

    void add(const std::vector<int>& order) {
        for (const int n : order) {
            const MotorId id = added(wind, motors[static_cast<std::size_t>(n)]);
            ids[static_cast<std::size_t>(n)] = id;
        }
    }
    void remove(const std::vector<int>& order) {
        for (const int n : order)
            (void)wind.motors().remove(ids[static_cast<std::size_t>(n)]); // some have ended by themselves
    }
    // Wakes go on along a line each, two moves a step; a motor that has ended stays where it is.
    void step(int from, int to) {
        for (int n = from; n < to; ++n) {
            for (std::size_t m = 0; m < motors.size(); ++m)
                if (std::holds_alternative<WakeMotor>(motors[m]) && wind.motors().find(ids[m]) != nullptr)
                    for (const double part : {0.5, 1.0})
                        (void)wind.motors().move(ids[m], place_of(m, n + part));
            wind.step(1.0 / 30.0);
        }
    }
    [[nodiscard]] glm::dvec3 place_of(std::size_t m, double steps) const {
        const double angle = 0.7 * static_cast<double>(m);
        return position_of(motors[m]) + steps * glm::dvec3(0.3 * std::cos(angle), 0.05, 0.3 * std::sin(angle));
    }
};

TEST(MotorOrder, NeitherTheOrderOfAddingNorTheThreadsChangeABit) {
    const std::vector<Motor> motors = some_motors(300, 60);
    NumberedMotors first(motors, {});
    first.add(numbers(300));
    first.step(0, 20);
    EXPECT_TRUE(all_finite(first.wind.field()));
    EXPECT_GT(largest_speed(first.wind.field()), 3.0);
    Random random(61);
    for (int trial = 0; trial < (test::k_sanitized ? 1 : 5); ++trial) {
        const std::vector<int> order = shuffled(numbers(300), random);
        for (const int threads : {1, 2, 3, 8}) {
            ThreadPool pool(threads);
            NumberedMotors scene(motors, pool.parallel_for());
            scene.add(order);
            EXPECT_FALSE(scene.ids[0] == first.ids[0] && scene.ids[1] == first.ids[1])
                << "the handles differ, or this shows nothing";
            scene.step(0, 20);
            EXPECT_EQ(cells_that_differ(scene.wind.field(), first.wind.field()), 0u)
                << "order " << trial << ", " << threads << " threads";
        }
    }
}

// What has an age or a path begins again when it is added again: all of that is in the half that goes.
TEST(MotorOrder, RemovedAndAddedAgainEqualsAListMadeFresh) {
    const std::vector<Motor> motors = some_motors(300, 62);
    Random random(63);
    std::vector<int> half;
    for (int n = 0; n < 300; ++n) {
        const Motor& motor = motors[static_cast<std::size_t>(n)];
        const bool ages = n % 5 == 0 || std::holds_alternative<PressureMotor>(motor) || std::holds_alternative<WakeMotor>(motor);
        if (ages || random.integer(0, 9) == 0)
            half.push_back(n);
    }
    EXPECT_NEAR(static_cast<double>(half.size()), 150.0, 30.0);
    NumberedMotors again(motors, {}), fresh(motors, {});
    const std::vector<int> order = shuffled(numbers(300), random);
    for (NumberedMotors* scene : {&again, &fresh}) {
        scene->add(order);
        scene->step(0, 10);
    }
    again.remove(shuffled(half, random));
    again.add(shuffled(half, random));
    fresh.remove(shuffled(numbers(300), random));
    EXPECT_EQ(fresh.wind.motors().count(), 0);
    fresh.add(shuffled(numbers(300), random));
    EXPECT_EQ(again.wind.motors().count(), 300);
    again.step(0, 20);
    fresh.step(0, 20);
    EXPECT_EQ(cells_that_differ(again.wind.field(), fresh.wind.field()), 0u);
    EXPECT_EQ(again.wind.motors().count(), fresh.wind.motors().count());
    EXPECT_LT(again.wind.motors().count(), 300) << "some have ended by themselves";
}

// A plane keeps a list of the 512 motors that reach it; beyond that it looks all of them up again in each row.
class MotorCrowd : public testing::TestWithParam<int> {};

TEST_P(MotorCrowd, EqualsTheSumByBruteForce) {
    const int count = GetParam();
    Random random(64);
    std::vector<DirectionalMotor> motors;
    for (int n = 0; n < count; ++n) // low and flat: all of them reach the planes about the middle, few the others
        motors.push_back({.position = random.point(1.0) * glm::dvec3(8.0, 4.0, 0.4),
                          .direction = glm::vec3(random.direction()),
                          .region = Sphere{random.uniform(1.6f, 4.0f)},
                          .law = n % 2 == 0
                                     ? Law(Force{random.uniform(-3.0f, 3.0f)})
                                     : Law(Drive{random.uniform(-9.0f, 9.0f), static_cast<float>(random.spread(0.01, 1.0))}),
                          .turbulence = k_steady});
    Wind wind = *Wind::create({.cells = {20, 12, 16}, .ambient = {1.0f, 2.0f, 3.0f}, .stages = k_sources_only});
    for (const DirectionalMotor& motor : motors)
        ASSERT_TRUE(wind.motors().add(motor));
    const double dt = 0.125;
    EXPECT_EQ(wind.step(dt).motors_in_reach, count);
    double worst = 0.0;
    for_each_cell(wind, [&](glm::dvec3 centre, std::size_t cell) {
        glm::dvec3 force(0.0), toward(0.0);
        double exponent = 0.0, size = 10.0;
        for (const DirectionalMotor& motor : motors) {
            const glm::dvec3 p = centre - motor.position;
            const double weight = biweight(glm::dot(p, p) / std::pow(double(std::get<Sphere>(motor.region).radius), 2));
            if (const auto* push = std::get_if<Force>(&motor.law)) {
                force += weight * double(push->acceleration) * glm::dvec3(motor.direction);
                size += weight * std::abs(double(push->acceleration)) * dt;
            } else {
                const auto& drive = std::get<Drive>(motor.law);
                exponent += weight * double(drive.rate) * dt;
                toward += weight * double(drive.rate) * dt * double(drive.speed) * glm::dvec3(motor.direction);
            }
        }
        glm::dvec3 expected(1.0, 2.0, 3.0);
        if (exponent > 0.0)
            expected -= std::expm1(-exponent) * (toward / exponent - expected);
        expected += dt * force;
        const glm::dvec3 u(wind.field()[cell]);
        worst = std::max(worst, glm::length(u - expected) / size);
    });
    WINDROW_EXPECT_FIGURE("crowd_of_" + std::to_string(count), worst, 1e-5); // positions are kept to 1/65536 m, sums to float
}

// Sums of dyadic numbers are exact: every motor is counted once, in every cell.
TEST_P(MotorCrowd, CountsEachMotorOnce) {
    const int count = GetParam();
    Random random(65);
    Wind wind = *Wind::create({.cells = {9, 7, 8}, .stages = k_sources_only});
    double sum = 0.0;
    for (int n = 0; n < count; ++n) {
        const float acceleration = static_cast<float>(random.integer(-512, 1024)) / 64.0f;
        sum += acceleration;
        ASSERT_TRUE(wind.motors().add(
            DirectionalMotor{.region = AlignedBox{glm::vec3(1e6f)}, .law = Force{acceleration}, .turbulence = k_steady}));
    }
    wind.step(0.125);
    for (const glm::vec4& u : wind.field())
        ASSERT_EQ(u, glm::vec4(static_cast<float>(0.125 * sum), 0.0f, 0.0f, 0.0f));
}

INSTANTIATE_TEST_SUITE_P(Sizes, MotorCrowd, testing::Values(511, 512, 513, 600, 3000), testing::PrintToStringParamName());

} // namespace
