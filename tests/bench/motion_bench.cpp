// What plants in motion cost on the CPU, each beside its error and beside a plain copy of as many bytes.
//
//     windrow_motion_bench [rounds]
//
//   springs       1e6 springs in float, targets of their own, a step each: four arrays read, two of them written; beside
//                 a copy that moves as many bytes. Plain, with remainders, and in double; error: against double after 600 steps
//                 at 60 Hz.
//   cascade       70,000 rows of 10 stages (1,000 bodies: position and rotation of each stage), a step each; error as above.
//   shells        the pose of each of 200 shells on those bodies, read from the stages as the vertex stage does.
//   the source's  the same 200 shells as Bloodelic's stylised fur moves them: each frame every shell goes a fraction of the
//                 way to its target.
//   ground        128 x 128 texels with no walker, with 8 and with 64.
// All take turns within a round; the least time of the rounds counts. 1 and 2 threads.
#include "coupling/cascade_step.h"
#include "coupling/ground_memory.h"
#include "coupling/motion_numerics.h"
#include "coupling/spring.h"
#include "fluid/thread_pool.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace windrow;

constexpr std::size_t k_springs = 1000000, k_bodies = 1000, k_parts = 7, k_rows = k_bodies * k_parts;
constexpr int k_stages = 10, k_shells = 200;
constexpr double k_dt = 1.0 / 60.0;

// Tells the compiler that someone reads what lies there.
void read_by_someone(const void* what) {
    asm volatile("" : : "r"(what) : "memory");
}

template <class Real>
std::vector<Real> random_numbers(std::size_t count, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<Real> unit(-1, 1);
    std::vector<Real> numbers(count);
    std::generate(numbers.begin(), numbers.end(), [&] { return unit(random); });
    return numbers;
}

template <class Real>
struct Springs {
    std::vector<Real> place, velocity, before, now, place_rest, velocity_rest;
    explicit Springs(std::size_t count)
        : place(random_numbers<Real>(count, 1)), velocity(count), before(random_numbers<Real>(count, 2)),
          now(random_numbers<Real>(count, 3)), place_rest(count), velocity_rest(count) {}
    void step(const SpringStep& step, bool compensated, ParallelFor loop) {
        SpringBatch<Real> batch{place, velocity, before, now};
        if (compensated) {
            batch.place_remainder = place_rest;
            batch.velocity_remainder = velocity_rest;
        }
        if (!advance_springs<Real>(step, batch, loop))
            std::exit(2);
        read_by_someone(place.data());
    }
};

// Largest difference from double after ten seconds at 60 Hz, targets going to and fro.
double spring_error(bool compensated) {
    constexpr std::size_t k_few = 1000;
    const SpringStep step = *spring_step(springs::wheat, k_dt);
    Springs<float> single(k_few);
    Springs<double> truth(k_few);
    for (std::size_t n = 0; n < k_few; ++n) {
        truth.place[n] = static_cast<double>(single.place[n]);
        truth.before[n] = static_cast<double>(single.before[n]);
        truth.now[n] = static_cast<double>(single.now[n]);
    }
    for (int frame = 0; frame < 600; ++frame) {
        single.step(step, compensated, {});
        truth.step(step, false, {});
        if (frame % 30 == 0) {
            std::swap(single.before, single.now);
            std::swap(truth.before, truth.now);
        }
    }
    double worst = 0.0;
    for (std::size_t n = 0; n < k_few; ++n)
        worst = std::max(worst, std::abs(static_cast<double>(single.place[n]) - truth.place[n]));
    return worst;
}

double cascade_error() {
    auto step = CascadeStep::create(k_stages);
    if (!step || !step->set(k_stages / 0.25, k_dt))
        std::exit(2);
    std::vector<float> single(k_stages, 0.0f);
    std::vector<double> truth(k_stages, 0.0);
    double worst = 0.0;
    for (int frame = 0; frame < 600; ++frame) {
        const auto body = [](int f) { return static_cast<float>(std::sin(0.05 * f)); };
        const float before = body(frame), now = body(frame + 1);
        const double before_double = static_cast<double>(before), now_double = static_cast<double>(now);
        if (!advance_cascades<float>(*step, {single, std::span(&before, 1), std::span(&now, 1)}) ||
            !advance_cascades<double>(*step, {truth, std::span(&before_double, 1), std::span(&now_double, 1)}))
            std::exit(2);
        for (std::size_t i = 0; i < truth.size(); ++i)
            worst = std::max(worst, std::abs(static_cast<double>(single[i]) - truth[i]));
    }
    return worst;
}

struct TurnsTaken {
    std::string name;
    double count = 0.0; // of what it moves
    std::function<void()> run;
    double min = std::numeric_limits<double>::infinity(); // [s]
};

void hold(std::vector<TurnsTaken>& contests, int rounds) {
    for (int round = 0; round < rounds; ++round)
        for (TurnsTaken& contest : contests) {
            const auto begin = std::chrono::steady_clock::now();
            contest.run();
            const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
            contest.min = std::min(contest.min, took.count());
        }
}

// The source's way, Strategy II: shells on animation shells, each going a share of the way to its target, for positions and
// rotations.
void source_shells(std::vector<float>& shells, const std::vector<float>& bodies, ParallelFor loop) {
    loop(static_cast<int>(k_bodies), [&](int body) {
        float* const own = &shells[static_cast<std::size_t>(body) * k_shells * k_parts];
        constexpr int group = k_shells / k_stages;
        for (int i = 0; i < k_shells; ++i) {
            const int target = i % group == 0 ? i - group : i - i % group;
            const float* const to =
                target < 0 ? &bodies[static_cast<std::size_t>(body) * k_parts] : own + target * static_cast<int>(k_parts);
            float* const at = own + i * static_cast<int>(k_parts);
            float squared = 0.0f;
            for (std::size_t p = 0; p < k_parts; ++p)
                at[p] += 0.3f * (to[p] - at[p]);
            for (std::size_t p = 3; p < k_parts; ++p)
                squared += at[p] * at[p];
            const float scale = 1.0f / std::sqrt(squared);
            for (std::size_t p = 3; p < k_parts; ++p)
                at[p] *= scale;
        }
        read_by_someone(own);
    });
}

void report(int threads, int rounds) {
    ThreadPool pool(threads);
    const ParallelFor loop = pool.parallel_for();
    const SpringStep step = *spring_step(springs::wheat, k_dt);
    Springs<float> plain(k_springs), kept(k_springs);
    Springs<double> wide(k_springs);
    // 24 bytes a spring pass through memory: a copy of 12 reads 12 and writes 12.
    std::vector<float> from(3 * k_springs, 1.0f), to(3 * k_springs);

    auto cascade = CascadeStep::create(k_stages);
    if (!cascade || !cascade->set(k_stages / 0.25, k_dt))
        std::exit(2);
    std::vector<float> rows = random_numbers<float>(k_rows * k_stages, 4), row_rest(rows.size());
    const std::vector<float> body_before = random_numbers<float>(k_rows, 5), body_now = random_numbers<float>(k_rows, 6);
    std::vector<numerics::WindrowPose> stages(k_bodies * (k_stages + 1)), shells(k_bodies * k_shells);
    std::vector<float> source = random_numbers<float>(k_bodies * k_shells * k_parts, 7);

    std::vector<GroundMemory> grounds;
    std::vector<std::vector<GroundWalker>> walkers;
    for (const int count : {0, 8, 64}) {
        auto made = GroundMemory::create({}, loop);
        if (!made)
            std::exit(2);
        grounds.push_back(*std::move(made));
        std::mt19937 random(8);
        std::uniform_real_distribution<double> place(-15.0, 15.0);
        walkers.emplace_back(static_cast<std::size_t>(count));
        for (GroundWalker& walker : walkers.back())
            walker.previous = walker.position = {place(random), 0.0, place(random)};
    }

    const double texels = 128.0 * 128.0;
    std::vector<TurnsTaken> contests;
    contests.push_back({"copy of 24 bytes a spring", k_springs, [&] {
                            loop(16, [&](int n) {
                                const std::size_t share = from.size() / 16, at = static_cast<std::size_t>(n) * share;
                                std::memcpy(&to[at], &from[at], share * sizeof(float));
                                read_by_someone(&to[at]);
                            });
                        }});
    contests.push_back({"spring, float", k_springs, [&] { plain.step(step, false, loop); }});
    contests.push_back({"spring, float with remainders", k_springs, [&] { kept.step(step, true, loop); }});
    contests.push_back({"spring, double", k_springs, [&] { wide.step(step, false, loop); }});
    contests.push_back({"cascade stage (7 numbers), float", k_bodies * k_stages, [&] {
                            if (!advance_cascades<float>(*cascade, {rows, body_before, body_now}, loop))
                                std::exit(2);
                            read_by_someone(rows.data());
                        }});
    contests.push_back({"cascade stage, with remainders", k_bodies * k_stages, [&] {
                            if (!advance_cascades<float>(*cascade, {rows, body_before, body_now, row_rest}, loop))
                                std::exit(2);
                            read_by_someone(rows.data());
                        }});
    contests.push_back({"shell's pose read from stages", static_cast<double>(k_bodies) * k_shells, [&] {
                            loop(static_cast<int>(k_bodies), [&](int body) {
                                const numerics::WindrowPose* const own = &stages[static_cast<std::size_t>(body) * (k_stages + 1)];
                                numerics::WindrowPose* const into = &shells[static_cast<std::size_t>(body) * k_shells];
                                for (int i = 0; i < k_shells; ++i) {
                                    const float height = static_cast<float>(i) / (k_shells - 1);
                                    const int low = numerics::windrow_cascade_stage(height, k_stages);
                                    into[i] = numerics::windrow_pose_between(
                                        own[low], own[low + 1], numerics::windrow_cascade_fraction(height, k_stages));
                                }
                                read_by_someone(into);
                            });
                        }});
    contests.push_back({"the source's shell (lerp a frame)", static_cast<double>(k_bodies) * k_shells,
                        [&] { source_shells(source, body_now, loop); }});
    const char* const names[] = {"ground texel, no walker", "ground texel, 8 walkers", "ground texel, 64 walkers"};
    for (std::size_t n = 0; n < grounds.size(); ++n)
        contests.push_back({names[n], texels, [&, n] {
                                if (!grounds[n].advance({.duration = k_dt, .walkers = walkers[n], .wind_lean = {0.2f, 0.1f}}))
                                    std::exit(2);
                            }});
    hold(contests, rounds);

    const double copy = contests[0].min;
    std::printf("\n%d thread%s, least of %d rounds\n", threads, threads == 1 ? "" : "s", rounds);
    std::printf("  %-36s %10s %12s %14s\n", "", "ms", "ns each", "of the copy");
    for (const TurnsTaken& contest : contests)
        std::printf("  %-36s %10.3f %12.3f %14.2f\n", contest.name.c_str(), 1e3 * contest.min, 1e9 * contest.min / contest.count,
                    contest.min / copy);
}

} // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 40;
    if (rounds < 1)
        return std::fprintf(stderr, "windrow_motion_bench: '%s' is no number of rounds: give 1 or more.\n", argv[1]), 2;
    std::printf("largest error after 600 steps, of places up to 1: spring %.1e, with remainders %.1e, cascade %.1e\n",
                spring_error(false), spring_error(true), cascade_error());
    for (const int threads : {1, 2})
        report(threads, rounds);
}
