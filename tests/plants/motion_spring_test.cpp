// The damped oscillator: against a fine numerical integration, at its limits, and that time may be cut as one likes.
#include "coupling/motion_numerics.h"
#include "coupling/spring.h"
#include "fluid/thread_pool.h"
#include "tests/figure.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace windrow {
namespace {

struct State {
    double place = 0.0, velocity = 0.0;
};

SpringStep step_of(const SpringClass& spring, double duration) {
    const auto step = spring_step(spring, duration);
    EXPECT_TRUE(step) << (step ? "" : step.error());
    return step ? *step : SpringStep{};
}

State advanced(State s, const SpringStep& step, double before, double now) {
    double place = s.place, velocity = s.velocity;
    EXPECT_TRUE(advance_springs<double>(
        step, {std::span(&place, 1), std::span(&velocity, 1), std::span(&before, 1), std::span(&now, 1)}));
    return {place, velocity};
}

// Runge and Kutta's fourth order, without any of the closed forms.
State integrated(State s, const SpringClass& spring, double duration, double before, double now, int steps) {
    const double omega = 2.0 * std::numbers::pi * spring.frequency_hz, h = duration / steps;
    const auto slope = [&](State at, double time) {
        const double target = before + (now - before) * time / duration;
        return State{at.velocity, -2.0 * spring.damping * omega * at.velocity - omega * omega * (at.place - target)};
    };
    const auto moved = [](State at, State by, double t) { return State{at.place + t * by.place, at.velocity + t * by.velocity}; };
    for (int n = 0; n < steps; ++n) {
        const double t = n * h;
        const State a = slope(s, t), b = slope(moved(s, a, h / 2), t + h / 2), c = slope(moved(s, b, h / 2), t + h / 2),
                    d = slope(moved(s, c, h), t + h);
        s.place += h / 6 * (a.place + 2 * b.place + 2 * c.place + d.place);
        s.velocity += h / 6 * (a.velocity + 2 * b.velocity + 2 * c.velocity + d.velocity);
    }
    return s;
}

// The bound: RK4 with omega h = 2 pi / 5000 (times damping) errs by (omega h)^5 a step, 1e-12 over the run, and rounds 5000
// times.
TEST(MotionSpring, EqualsAFineIntegrationForEveryDamping) {
    double worst = 0.0;
    for (const double damping : {0.0, 0.05, 0.12, 0.5, 0.99, 1.0 - 1e-9, 1.0, 1.0 + 1e-9, 1.01, 1.5, 4.0})
        for (const double duration : {0.001, 0.1, 1.0, 2.5}) {
            const SpringClass spring{1.0, damping};
            const State start{0.7, -2.0};
            const State exact = advanced(start, step_of(spring, duration), 0.2, -1.1);
            const State fine = integrated(start, spring, duration, 0.2, -1.1, 20000);
            const double omega = 2.0 * std::numbers::pi;
            worst = std::max({worst, std::abs(exact.place - fine.place), std::abs(exact.velocity - fine.velocity) / omega});
        }
    WINDROW_EXPECT_FIGURE("motion/spring/against_rk4", worst, 1e-12);
}

// Over twelve decades of omega h, one step equals its two halves: what a cancellation near zeta = 1 or near h = 0 would break.
TEST(MotionSpring, TwoHalfStepsAreOneStep) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1.0, 1.0), decade(-8.0, 4.0), closeness(-16.0, 2.0);
    double worst = 0.0;
    for (int n = 0; n < 20000; ++n) {
        const double sign = n % 2 == 0 ? 1.0 : -1.0;
        const SpringClass spring{1.0, std::abs(1.0 + sign * std::pow(10.0, closeness(random)))};
        const double duration = std::pow(10.0, decade(random)), omega = 2.0 * std::numbers::pi;
        const State start{unit(random), omega * unit(random)};
        const double before = unit(random), now = unit(random), middle = 0.5 * (before + now);
        const SpringStep half = step_of(spring, 0.5 * duration);
        const State once = advanced(start, step_of(spring, duration), before, now);
        const State twice = advanced(advanced(start, half, before, middle), half, middle, now);
        // A creeping spring follows a moving target at a distance of 2 zeta / (omega h): rounding is relative to that.
        const double size = 1.0 + 2.0 * spring.damping / (omega * duration) * std::min(1.0, duration);
        worst =
            std::max({worst, std::abs(once.place - twice.place) / size, std::abs(once.velocity - twice.velocity) / omega / size});
    }
    WINDROW_EXPECT_FIGURE("motion/spring/halves", worst, 1e-13);
}

// The response is smooth in zeta: at a distance delta from 1 it differs by delta times a slope of order omega h, and by rounding.
// A form that divides by sqrt(|1 - zeta^2|) would differ by 1e-8 there.
TEST(MotionSpring, IsContinuousAtCriticalDamping) {
    double steepest = 0.0;
    for (const double duration : {0.02, 0.2, 2.0}) {
        const State critical = advanced({1.0, 3.0}, step_of({1.0, 1.0}, duration), 0.0, 0.5);
        for (int k = 2; k <= 16; ++k)
            for (const double sign : {-1.0, 1.0}) {
                const double delta = std::pow(10.0, -k);
                const State near = advanced({1.0, 3.0}, step_of({1.0, 1.0 + sign * delta}, duration), 0.0, 0.5);
                steepest = std::max(steepest, std::abs(near.place - critical.place) / (delta + 1e-15));
            }
    }
    WINDROW_EXPECT_FIGURE("motion/spring/critical_slope", steepest, 4.0);
}

TEST(MotionSpring, RestsToTheBitAndEndsAtTheTarget) {
    for (const double duration : {0.0, 1e-9, 1.0 / 60.0, 1.0, 1e6, 1e300}) {
        float place = 0.3f, velocity = 0.0f;
        const float target = 0.3f;
        ASSERT_TRUE(advance_springs<float>(step_of(springs::wheat, duration), {std::span(&place, 1), std::span(&velocity, 1),
                                                                               std::span(&target, 1), std::span(&target, 1)}));
        EXPECT_EQ(place, 0.3f) << duration;
        EXPECT_EQ(velocity, 0.0f) << duration;
    }
    const State stayed = advanced({0.7, 2.0}, step_of(springs::wheat, 0.0), 0.1, 5.0);
    EXPECT_EQ(stayed.place, 0.7);
    EXPECT_EQ(stayed.velocity, 2.0);
    for (const double damping : {0.05, 1.0, 30.0}) {
        const State ended = advanced({0.7, 2.0}, step_of({2.5, damping}, 1e6), 0.1, 0.4);
        EXPECT_NEAR(ended.place, 0.4, 1e-5) << damping; // behind a target that creeps by 0.3 in 1e6 s
        EXPECT_NEAR(ended.velocity, 3e-7, 1e-12) << damping;
    }
}

// --- Any frame rate ----------------------------------------------------------------------------------------------------------

constexpr int k_rates[] = {15, 30, 60, 144, 1000};
constexpr int k_seconds = 8;

// Targets that are linear over each second, which every rate cuts into whole frames.
std::vector<double> targets_of(std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::vector<double> targets(k_seconds + 1);
    std::generate(targets.begin(), targets.end(), [&] { return unit(random); });
    return targets;
}

double target_at(const std::vector<double>& targets, int rate, int frame) {
    const int second = std::min(frame / rate, k_seconds - 1);
    const double share = static_cast<double>(frame - second * rate) / rate;
    return targets[second] + share * (targets[second + 1] - targets[second]);
}

enum class SpringArithmetic { plain, compensated };

// Places at each whole second.
template <class Real>
std::vector<double> history(const SpringClass& spring, int rate, SpringArithmetic way, std::uint32_t seed) {
    const std::vector<double> targets = targets_of(seed);
    const SpringStep step = step_of(spring, 1.0 / rate);
    Real place = 0, velocity = 0, place_rest = 0, velocity_rest = 0;
    std::vector<double> places;
    for (int frame = 0; frame < k_seconds * rate; ++frame) {
        const Real before = static_cast<Real>(target_at(targets, rate, frame)),
                   now = static_cast<Real>(target_at(targets, rate, frame + 1));
        SpringBatch<Real> batch{std::span(&place, 1), std::span(&velocity, 1), std::span(&before, 1), std::span(&now, 1)};
        if (way == SpringArithmetic::compensated) {
            batch.place_remainder = std::span(&place_rest, 1);
            batch.velocity_remainder = std::span(&velocity_rest, 1);
        }
        EXPECT_TRUE(advance_springs<Real>(step, batch));
        if ((frame + 1) % rate == 0)
            places.push_back(static_cast<double>(place));
    }
    return places;
}

struct Named {
    const char* name;
    SpringClass spring;
};
constexpr Named k_classes[] = {{"grass", springs::grass},   {"wheat", springs::wheat}, {"alfalfa", springs::alfalfa},
                               {"reed", springs::reed},     {"leaf", springs::leaf},   {"twig", springs::twig},
                               {"branch", springs::branch}, {"trunk", springs::trunk}, {"critical", {2.0, 1.0}},
                               {"creeping", {2.0, 5.0}}};

// The largest difference between any rate and one step a second, over 16 random targets.
template <class Real>
double spread(const SpringClass& spring, SpringArithmetic way) {
    double worst = 0.0;
    for (std::uint32_t seed = 0; seed < 16; ++seed) {
        const std::vector<double> truth = history<double>(spring, 1, SpringArithmetic::plain, seed);
        for (const int rate : k_rates) {
            const std::vector<double> places = history<Real>(spring, rate, way, seed);
            for (std::size_t n = 0; n < truth.size(); ++n)
                worst = std::max(worst, std::abs(places[n] - truth[n]));
        }
    }
    return worst;
}

// A frame's parts are short enough for ripples, and its filter passes no more than the frames can show.
TEST(MotionSpring, SwingsInPartsOfAFrame) {
    for (const auto& [duration, parts] : {std::pair{1.0 / 144.0, 1.0f},
                                          {1.0 / 60.0, 1.0f},
                                          {1.0 / 30.0, 2.0f},
                                          {1.0 / 24.0, 3.0f},
                                          {0.05, 3.0f},
                                          {2.0, 8.0f},
                                          {0.0, 1.0f}}) {
        const auto swing = swing_step(springs::grass, duration);
        ASSERT_TRUE(swing) << swing.error();
        EXPECT_EQ(swing->parts.x, parts) << duration;
        EXPECT_FLOAT_EQ(swing->parts.x * swing->parts.y, static_cast<float>(duration));
        const auto part = spring_step(springs::grass, duration / static_cast<double>(parts))->block();
        EXPECT_EQ(swing->spring.place, part.place);
        const double passed_hz = std::min(3.0, duration > 0.0 ? 0.15 / duration : 3.0);
        const auto smoothing = spring_step({passed_hz, std::sqrt(0.5)}, duration / static_cast<double>(parts))->block();
        EXPECT_NEAR(swing->smoothing.place.x, smoothing.place.x, 1e-6) << duration;
    }
    for (const double duration : {-1.0, std::nan(""), HUGE_VAL})
        EXPECT_FALSE(swing_step(springs::grass, duration)) << duration;
    EXPECT_FALSE(swing_step({0.0, 0.2}, 0.01));
}

// Four springs a quarter of an octave apart about their class; a plant takes the one nearest to its own frequency.
TEST(MotionSpring, HasFourBandsAboutItsClass) {
    const auto bands = *spring_bands(springs::wheat);
    double product = 1.0;
    for (const SpringClass& band : bands) {
        EXPECT_EQ(band.damping, springs::wheat.damping);
        product *= band.frequency_hz / springs::wheat.frequency_hz;
    }
    EXPECT_NEAR(product, 1.0, 1e-14);
    for (int n = 0; n < 3; ++n)
        EXPECT_NEAR(bands[n + 1].frequency_hz / bands[n].frequency_hz, std::pow(2.0, 0.25), 1e-14);
    for (double quickness = 0.3; quickness < 3.0; quickness *= 1.01) {
        int nearest = 0;
        const auto off = [&](int n) {
            return std::abs(std::log(bands[n].frequency_hz / springs::wheat.frequency_hz / quickness));
        };
        for (int n = 1; n < 4; ++n)
            nearest = off(n) < off(nearest) ? n : nearest;
        EXPECT_EQ(numerics::windrow_spring_band(static_cast<float>(quickness)), nearest) << quickness;
    }
    for (const double limit : {1e-4, 1000.0}) {
        const auto kept = *spring_bands({limit, 0.1});
        for (const SpringClass& band : kept)
            EXPECT_TRUE(validate(band)) << band.frequency_hz;
    }
    // Ripples are filtered as those of the class, whatever the band; a band is a spring of its own.
    const auto swings = swing_steps(springs::wheat, 1.0 / 24.0);
    ASSERT_TRUE(swings) << swings.error();
    for (std::size_t n = 0; n < bands.size(); ++n) {
        EXPECT_EQ((*swings)[n].smoothing.place, swing_step(springs::wheat, 1.0 / 24.0)->smoothing.place) << n;
        EXPECT_EQ((*swings)[n].spring.place, swing_step(bands[n], 1.0 / 24.0)->spring.place) << n;
    }
    for (const SpringClass& wrong : {SpringClass{std::nan(""), 0.1}, {-5.0, 0.1}, {1.0, std::nan("")}}) {
        EXPECT_FALSE(spring_bands(wrong));
        EXPECT_FALSE(swing_steps(wrong, 0.01));
    }
    EXPECT_FALSE(swing_steps(springs::wheat, -1.0));
}

TEST(MotionSpring, IsTheSameAtAnyFrameRate) {
    for (const Named& named : k_classes) {
        const std::string name = std::string("motion/spring/rates/") + named.name;
        WINDROW_EXPECT_FIGURE(name + "/double", spread<double>(named.spring, SpringArithmetic::plain), 1e-11);
        WINDROW_EXPECT_FIGURE(name + "/float_with_remainders", spread<float>(named.spring, SpringArithmetic::compensated), 1e-6);
        test::figure(name + "/float",
                     spread<float>(named.spring, SpringArithmetic::plain)); // rounding of 8000 steps: stated, no claim
    }
}

// What shaders run: the text in float, vectors of two and three, whose components are springs of their own.
TEST(MotionSpring, ShaderTextMovesVectorsAsTheBatchMovesNumbers) {
    const SpringStep step = step_of(springs::reed, 1.0 / 60.0);
    const auto block = std::bit_cast<numerics::WindrowSpringStep>(step.block());
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    const auto vector = [&] { return glm::vec3(unit(random), unit(random), unit(random)); };
    glm::vec3 place = vector(), velocity = vector();
    for (int n = 0; n < 100; ++n) {
        const glm::vec3 before = vector(), now = vector();
        glm::vec3 batch_place = place, batch_velocity = velocity;
        ASSERT_TRUE(advance_springs<float>(step, {std::span(&batch_place.x, 3), std::span(&batch_velocity.x, 3),
                                                  std::span(&before.x, 3), std::span(&now.x, 3)}));
        const glm::vec3 grown = place + numerics::windrow_spring_place(block, place, velocity, before, now);
        const glm::vec3 faster = velocity + numerics::windrow_spring_velocity(block, place, velocity, before, now);
        const glm::vec2 grown_2 = glm::vec2(place) + numerics::windrow_spring_place(block, glm::vec2(place), glm::vec2(velocity),
                                                                                    glm::vec2(before), glm::vec2(now));
        EXPECT_EQ(grown, batch_place);
        EXPECT_EQ(faster, batch_velocity);
        EXPECT_EQ(grown_2, glm::vec2(grown));
        place = grown;
        velocity = faster;
    }
}

// --- Motion vectors ------------------------------------------------------------------------------------------------------------

// The velocity of the state is that of the motion: a frame's displacement over its time is the mean of the velocities at its ends
// to the second order in the frame's time.
TEST(MotionSpring, DisplacementOfAFrameIsItsVelocity) {
    double errors[3];
    for (int k = 0; k < 3; ++k) {
        const double h = 0.04 / (1 << k);
        const SpringStep step = step_of(springs::wheat, h);
        State s{1.0, 0.0};
        errors[k] = 0.0;
        for (double time = 0.0; time < 1.0 - 0.5 * h; time += h) {
            const State next = advanced(s, step, 0.0, 0.0);
            errors[k] = std::max(errors[k], std::abs((next.place - s.place) / h - 0.5 * (s.velocity + next.velocity)));
            s = next;
        }
    }
    const double slope = std::log2(errors[1] / errors[2]);
    test::figure("motion/spring/displacement_slope", slope);
    EXPECT_NEAR(slope, 2.0, 0.1);
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2.0, 0.1);
}

// --- Batches -------------------------------------------------------------------------------------------------------------------

TEST(MotionSpring, ParallelBatchesHaveTheSameBits) {
    constexpr std::size_t k_count = 100003;
    std::mt19937 random(9);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    std::vector<float> start(k_count), speed(k_count), before(k_count), now(k_count);
    for (std::vector<float>* values : {&start, &speed, &before, &now})
        std::generate(values->begin(), values->end(), [&] { return unit(random); });
    const SpringStep step = step_of(springs::grass, 1.0 / 60.0);
    std::vector<float> serial = start, serial_speed = speed;
    ASSERT_TRUE(advance_springs<float>(step, {serial, serial_speed, before, now}));
    for (const int threads : {2, 4}) {
        ThreadPool pool(threads);
        std::vector<float> places = start, speeds = speed;
        ASSERT_TRUE(advance_springs<float>(step, {places, speeds, before, now}, pool.parallel_for()));
        EXPECT_EQ(places, serial);
        EXPECT_EQ(speeds, serial_speed);
    }
}

// Left alone for twenty minutes a spring is at 0, not at a denormal number.
TEST(MotionSpring, ComesToRestAtZero) {
    for (const Named& named : k_classes) {
        float place = 1.0f, velocity = 1.0f, place_rest = 0.0f, velocity_rest = 0.0f, kept = 1.0f, kept_velocity = 1.0f;
        const float target = 0.0f;
        const SpringStep step = step_of(named.spring, 1.0 / 60.0);
        for (int frame = 0; frame < 72000; ++frame) {
            const std::span<const float> to(&target, 1);
            ASSERT_TRUE(advance_springs<float>(step, {std::span(&place, 1), std::span(&velocity, 1), to, to}));
            ASSERT_TRUE(advance_springs<float>(step, {std::span(&kept, 1), std::span(&kept_velocity, 1), to, to,
                                                      std::span(&place_rest, 1), std::span(&velocity_rest, 1)}));
        }
        EXPECT_EQ(place, 0.0f) << named.name;
        EXPECT_EQ(velocity, 0.0f) << named.name;
        EXPECT_EQ(kept, 0.0f) << named.name;
        EXPECT_EQ(kept_velocity, 0.0f) << named.name;
    }
}

TEST(MotionSpring, TellsThePlacesOfTheLastFrame) {
    std::vector<float> place = {0.1f, -0.4f, 2.0f}, velocity = {1.0f, 0.0f, -3.0f}, previous(3);
    const std::vector<float> target(3, 0.5f), start = place;
    ASSERT_TRUE(advance_springs<float>(
        step_of(springs::reed, 0.02),
        {.place = place, .velocity = velocity, .target_before = target, .target_now = target, .place_previous = previous}));
    EXPECT_EQ(previous, start);
    EXPECT_NE(place, start);
}

TEST(MotionSpring, RejectsWhatIsNoSpring) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    for (const double frequency : {0.0, -1.0, 2000.0, nan, infinity})
        EXPECT_NE(validate(SpringClass{frequency, 0.1}).error().find("frequency_hz"), std::string::npos);
    for (const double damping : {-0.1, 1e4, nan, infinity})
        EXPECT_NE(validate(SpringClass{1.0, damping}).error().find("damping"), std::string::npos);
    for (const double duration : {-1e-9, nan, infinity})
        EXPECT_FALSE(spring_step(springs::grass, duration));
    for (const Named& named : k_classes)
        EXPECT_TRUE(validate(named.spring)) << named.name;
    float two[2] = {}, three[3] = {};
    const SpringStep step = step_of(springs::grass, 0.1);
    const auto rejected = advance_springs<float>(step, {two, three, two, two});
    ASSERT_FALSE(rejected);
    EXPECT_NE(rejected.error().find("velocity holds 3"), std::string::npos) << rejected.error();
    EXPECT_FALSE(advance_springs<float>(step, {two, two, three, two}));
    EXPECT_FALSE(advance_springs<float>(step, {two, two, two, three}));
    EXPECT_FALSE(advance_springs<float>(step, {two, two, two, two, two, {}}));
    EXPECT_FALSE(advance_springs<float>(step, {two, two, two, two, {}, {}, three}));
    EXPECT_TRUE(advance_springs<float>(step, {}));
}

} // namespace
} // namespace windrow
