// The cascade of stages is exact and independent of the frame rate. For comparison: each stage alone by 1 - e^-z, which is not.
#include "coupling/cascade_step.h"
#include "fluid/thread_pool.h"
#include "tests/figure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace windrow {
namespace {

CascadeStep step_of(int stages, double rate, double duration) {
    auto step = CascadeStep::create(stages);
    EXPECT_TRUE(step);
    EXPECT_TRUE(step->set(rate, duration));
    return *std::move(step);
}

template <class Real>
void advance(const CascadeStep& step, std::vector<Real>& values, Real before, Real now, std::span<Real> remainder = {}) {
    ASSERT_TRUE(advance_cascades<Real>(step, {values, std::span(&before, 1), std::span(&now, 1), remainder}));
}

// Ten stages at 20/s, half a second after a step of the body: exact P(10, 10) = 0.54207. The factor 1 - e^-z of each stage alone
// gives 0.813 at 30 Hz and 0.703 at 60 Hz.
TEST(CascadeStep, TenStagesAfterAStepOfTheBody) {
    std::vector<double> values(10, 0.0);
    advance<double>(step_of(10, 20.0, 0.5), values, 1.0, 1.0);
    WINDROW_EXPECT_FIGURE("cascade/step/p_10_10", std::abs(values.back() - 0.5420702855281473), 1e-14);
    const auto stagewise = [](int rate) {
        std::vector<double> stages(10, 0.0);
        for (int frame = 0; frame < rate / 2; ++frame)
            for (std::size_t i = 0; i < stages.size(); ++i)
                stages[i] += (1.0 - std::exp(-20.0 / rate)) * ((i == 0 ? 1.0 : stages[i - 1]) - stages[i]);
        return stages.back();
    };
    EXPECT_NEAR(test::figure("cascade/step/stagewise_30_hz", stagewise(30)), 0.813, 5e-4);
    EXPECT_NEAR(test::figure("cascade/step/stagewise_60_hz", stagewise(60)), 0.703, 5e-4);
}

// A fine integration of the row itself, target linear over the step. Bound: RK4 at z = 0.002 a step errs by 1e-13 at most.
TEST(CascadeStep, EqualsAFineIntegration) {
    constexpr int k_stages = 12, k_steps = 20000;
    const double rate = 40.0, duration = 1.0, before = -0.5, now = 2.0;
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::vector<double> exact(k_stages);
    std::generate(exact.begin(), exact.end(), [&] { return unit(random); });
    std::vector<double> fine = exact;
    advance<double>(step_of(k_stages, rate, duration), exact, before, now);

    const double h = duration / k_steps;
    const auto slope = [&](const std::vector<double>& y, double time) {
        std::vector<double> s(y.size());
        for (std::size_t i = 0; i < y.size(); ++i)
            s[i] = rate * ((i == 0 ? before + (now - before) * time / duration : y[i - 1]) - y[i]);
        return s;
    };
    const auto moved = [](std::vector<double> y, const std::vector<double>& by, double t) {
        for (std::size_t i = 0; i < y.size(); ++i)
            y[i] += t * by[i];
        return y;
    };
    for (int n = 0; n < k_steps; ++n) {
        const double t = n * h;
        const auto a = slope(fine, t), b = slope(moved(fine, a, h / 2), t + h / 2), c = slope(moved(fine, b, h / 2), t + h / 2),
                   d = slope(moved(fine, c, h), t + h);
        for (std::size_t i = 0; i < fine.size(); ++i)
            fine[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
    }
    double worst = 0.0;
    for (std::size_t i = 0; i < fine.size(); ++i)
        worst = std::max(worst, std::abs(fine[i] - exact[i]));
    WINDROW_EXPECT_FIGURE("cascade/step/against_rk4", worst, 1e-11);
}

// From a tenth of a microsecond to a minute in one step, z up to 1e6, and up to 1000 stages: one step is its two halves.
TEST(CascadeStep, TwoHalfStepsAreOneStep) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    double worst = 0.0;
    for (const int stages : {1, 2, 10, 64, 200, 1000})
        for (double z = 1e-6; z < 2e6; z *= 3.0) {
            std::vector<double> once(static_cast<std::size_t>(stages));
            std::generate(once.begin(), once.end(), [&] { return unit(random); });
            std::vector<double> twice = once;
            const double before = unit(random), now = unit(random), middle = 0.5 * (before + now);
            advance<double>(step_of(stages, z, 1.0), once, before, now);
            const CascadeStep half = step_of(stages, z, 0.5);
            advance<double>(half, twice, before, middle);
            advance<double>(half, twice, middle, now);
            for (std::size_t i = 0; i < once.size(); ++i) {
                ASSERT_TRUE(std::isfinite(once[i])) << stages << " stages, z = " << z;
                worst = std::max(worst, std::abs(once[i] - twice[i]));
            }
        }
    // The weights are exponentials of numbers up to z: rounded by some 1e-16 z where they are not yet nothing, at z about 1000.
    WINDROW_EXPECT_FIGURE("cascade/step/halves", worst, 2e-12);
}

// --- Any frame rate ----------------------------------------------------------------------------------------------------------

constexpr int k_seconds = 4;

enum class CascadeArithmetic { plain, compensated };

template <class Real>
std::vector<double> tips(int stages, double rate, int frames_a_second, std::uint32_t seed, CascadeArithmetic way) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    double targets[k_seconds + 1];
    std::generate(std::begin(targets), std::end(targets), [&] { return unit(random); });
    const CascadeStep step = step_of(stages, rate, 1.0 / frames_a_second);
    std::vector<Real> values(static_cast<std::size_t>(stages), Real{0});
    std::vector<Real> remainder(way == CascadeArithmetic::compensated ? values.size() : 0, Real{0});
    std::vector<double> found;
    for (int frame = 0; frame < k_seconds * frames_a_second; ++frame) {
        const auto target = [&](int f) {
            const int second = std::min(f / frames_a_second, k_seconds - 1);
            const double share = static_cast<double>(f - second * frames_a_second) / frames_a_second;
            return static_cast<Real>(targets[second] + share * (targets[second + 1] - targets[second]));
        };
        advance<Real>(step, values, target(frame), target(frame + 1), remainder);
        if ((frame + 1) % frames_a_second == 0)
            for (const Real value : values)
                found.push_back(static_cast<double>(value));
    }
    return found;
}

template <class Real>
double spread(int stages, double rate, CascadeArithmetic way) {
    double worst = 0.0;
    for (std::uint32_t seed = 0; seed < 4; ++seed) {
        const std::vector<double> truth = tips<double>(stages, rate, 1, seed, CascadeArithmetic::plain);
        for (const int frames : {15, 30, 60, 144, 1000}) {
            const std::vector<double> found = tips<Real>(stages, rate, frames, seed, way);
            for (std::size_t n = 0; n < truth.size(); ++n)
                worst = std::max(worst, std::abs(found[n] - truth[n]));
        }
    }
    return worst;
}

// Lags of 0.1 s and 1 s; at 15 Hz the first makes z = 133 of 200 stages.
TEST(CascadeStep, IsTheSameAtAnyFrameRate) {
    for (const int stages : {10, 20, 200})
        for (const double lag : {0.1, 1.0}) {
            const std::string name = "cascade/rates/" + std::to_string(stages) + (lag < 0.5 ? "_short" : "_long");
            WINDROW_EXPECT_FIGURE(name + "/double", spread<double>(stages, stages / lag, CascadeArithmetic::plain), 1e-11);
            WINDROW_EXPECT_FIGURE(name + "/float_with_remainders",
                                  spread<float>(stages, stages / lag, CascadeArithmetic::compensated), 1e-6);
            test::figure(name + "/float", spread<float>(stages, stages / lag, CascadeArithmetic::plain)); // stated, no claim
        }
}

TEST(CascadeStep, RestsToTheBitAndEndsAtTheBody) {
    for (const double duration : {0.0, 1e-9, 1.0 / 60.0, 1.0, 1e6, 1e300}) {
        std::vector<float> values(40, 0.3f);
        advance<float>(step_of(40, 80.0, duration), values, 0.3f, 0.3f);
        EXPECT_EQ(values, std::vector<float>(40, 0.3f)) << duration;
    }
    std::vector<double> values(40, -5.0);
    advance<double>(step_of(40, 80.0, 1e6), values, 0.0, 1.0);
    EXPECT_NEAR(values.back(), 1.0, 1e-6); // half a second behind a body that takes 1e6 s
}

TEST(CascadeStep, ParallelRowsHaveTheSameBits) {
    constexpr std::size_t k_rows = 3001;
    constexpr int k_stages = 10;
    std::mt19937 random(8);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    std::vector<float> start(k_rows * k_stages), before(k_rows), now(k_rows);
    for (std::vector<float>* values : {&start, &before, &now})
        std::generate(values->begin(), values->end(), [&] { return unit(random); });
    const CascadeStep step = step_of(k_stages, 40.0, 1.0 / 60.0);
    std::vector<float> serial = start;
    ASSERT_TRUE(advance_cascades<float>(step, {serial, before, now}));
    ThreadPool pool(3);
    std::vector<float> parallel = start;
    ASSERT_TRUE(advance_cascades<float>(step, {parallel, before, now}, pool.parallel_for()));
    EXPECT_EQ(parallel, serial);
    // And each row is what it would be alone.
    for (const std::size_t row : {std::size_t{0}, std::size_t{255}, std::size_t{256}, k_rows - 1}) {
        std::vector<float> alone(k_stages);
        for (std::size_t i = 0; i < alone.size(); ++i)
            alone[i] = start[i * k_rows + row];
        advance<float>(step, alone, before[row], now[row]);
        for (std::size_t i = 0; i < alone.size(); ++i)
            EXPECT_EQ(alone[i], serial[i * k_rows + row]) << row;
    }
}

TEST(CascadeStep, RejectsWhatIsNoStep) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    for (const int stages : {0, -3, 5000})
        EXPECT_FALSE(CascadeStep::create(stages));
    auto step = CascadeStep::create(3);
    ASSERT_TRUE(step);
    for (const double rate : {0.0, -1.0, nan, infinity})
        EXPECT_NE(step->set(rate, 0.1).error().find("rate"), std::string::npos);
    for (const double duration : {-1e-9, nan, infinity})
        EXPECT_NE(step->set(1.0, duration).error().find("duration"), std::string::npos);
    std::vector<float> values(6), two(2), three(3);
    EXPECT_TRUE(advance_cascades<float>(*step, {values, two, two}));
    EXPECT_FALSE(advance_cascades<float>(*step, {values, three, two}));
    EXPECT_FALSE(advance_cascades<float>(*step, {values, three, three}));
    EXPECT_FALSE(advance_cascades<float>(*step, {values, two, two, three}));
}

} // namespace
} // namespace windrow
