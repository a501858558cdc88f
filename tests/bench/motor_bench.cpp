// The motor table: what each kind gives with its default parameters, and what it costs.
//
//     windrow_motor_bench [threads]
//
// Box 32 x 16 x 32 m in cells of 1 m, steps of 1/30 s, each motor in the middle, wakes crossing it at 5 m/s.
//   gives         forces: sum of u h^3 that the sources stage adds in a second; drives: the same into still air after a second.
//                 Whirls: sum of r x u h^3 about the axis. Sources: cubic metres of air that come out a second; bursts: in the
//                 first step, a second.
//   reach         farthest cell centre, from the motor's place, that it touches
//   div put in    rms central divergence of what the sources stage adds in one step (sources: rms of S)
//   div left      rms central divergence after the first whole step, beyond S
//   a motor       sources stage with 1, 30, 300 motors spread over the box, less that of a wind with none, each. Runs of 200
//                 steps take turns, three rounds, least times. Sources bring the projection of their own flow along when S
//                 changes: bursts, in every step.
// Last, the whole step with 300 motors of all kinds against none.
#include "fluid/operators.h"
#include "fluid/thread_pool.h"
#include "fluid/wind.h"
#include "fluid/wind_state.h"
#include "tests/fields.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <string>
#include <variant>
#include <vector>

namespace {

using namespace windrow;
using test::Random;

constexpr double k_dt = 1.0 / 30.0, k_pace = 5.0; // [s], [m/s] of wakes
constexpr Stages k_sources_only{
    .sources = true, .relaxation = false, .diffusion = false, .advection = false, .projection = false};
constexpr Stages k_sources_and_projection{
    .sources = true, .relaxation = false, .diffusion = false, .advection = false, .projection = true};

struct MotorRow {
    const char* name;
    Motor motor;
    const char* gives_unit;
};

std::vector<MotorRow> kinds() {
    return {{"directional, force", DirectionalMotor{.law = Force{}}, "m4/s2"},
            {"directional, drive", DirectionalMotor{}, "m4/s"},
            {"directional cone, drive", DirectionalMotor{.region = Cone{}}, "m4/s"},
            {"wake, force", WakeMotor{.law = WakeForce{}}, "m4/s2"},
            {"wake, drive", WakeMotor{}, "m4/s"},
            {"jet, force", JetMotor{.law = Force{}}, "m4/s2"},
            {"jet, drive", JetMotor{}, "m4/s"},
            {"vortex, force", VortexMotor{.law = Force{}}, "m5/s2"},
            {"vortex, drive", VortexMotor{}, "m5/s"},
            {"omni", OmniMotor{}, "m3/s"},
            {"pressure", PressureMotor{}, "m3/s"}};
}

Wind wind_with(const Stages& stages, const ParallelFor& parallel_for = {}) {
    Config config;
    config.stages = stages;
    config.parallel_for = parallel_for;
    auto wind = Wind::create(config);
    if (!wind)
        std::exit(2);
    return *std::move(wind);
}

bool is_source(const Motor& motor) {
    return std::holds_alternative<OmniMotor>(motor) || std::holds_alternative<PressureMotor>(motor);
}

// A motor in a wind, kept going: wakes go to and fro through the place where they began, bursts last.
struct KeptMotor {
    MotorId id;
    glm::dvec3 place;
    bool wake;
};

KeptMotor add_to(Wind& wind, Motor motor, glm::dvec3 place) {
    std::visit([&](auto& kind) { kind.position = place; }, motor);
    const auto id = wind.motors().add(motor);
    if (!id)
        std::exit(2);
    return {*id, place, std::holds_alternative<WakeMotor>(motor)};
}

void move_wakes(Wind& wind, const std::vector<KeptMotor>& motors, int step) {
    const double turn = std::abs(static_cast<double>((step + 20) % 40 - 20)); // to and fro, ten steps to each side
    for (const KeptMotor& kept : motors)
        if (kept.wake)
            (void)wind.motors().move(kept.id, kept.place + glm::dvec3(k_pace * k_dt * (turn - 10.0), 0.0, 0.0));
}

double rms(std::span<const float> values) {
    double squares = 0.0;
    for (const float v : values)
        squares += static_cast<double>(v) * static_cast<double>(v);
    return std::sqrt(squares / static_cast<double>(values.size()));
}

template <class Visit>
void for_each_cell(const Wind& wind, const Visit& visit) {
    const Box& box = wind.box();
    for (int k = 0; k < box.cells.z; ++k)
        for (int j = 0; j < box.cells.y; ++j)
            for (int i = 0; i < box.cells.x; ++i)
                visit(wind.origin() + (glm::dvec3(i, j, k) + 0.5) * static_cast<double>(box.cell_size), box.index(i, j, k));
}

struct Gift {
    double gives = 0.0, reach = 0.0, put_in = 0.0, left = 0.0;
};

Gift gift_of(const Motor& motor) {
    const glm::dvec3 middle(0.0);
    const bool wake = std::holds_alternative<WakeMotor>(motor), source = is_source(motor),
               whirl = std::holds_alternative<VortexMotor>(motor);
    Gift gift;
    Wind alone = wind_with(k_sources_only), whole = wind_with(Stages{});
    const glm::dvec3 start = wake ? glm::dvec3(-0.5 * k_pace, 0.0, 0.0) : middle;
    const KeptMotor one = add_to(alone, motor, start), two = add_to(whole, motor, start);
    auto work = Workspace::create({.box = alone.box()});
    for (int step = 1; step <= 30; ++step) {
        const glm::dvec3 place = start + glm::dvec3(k_pace * k_dt * step, 0.0, 0.0);
        if (wake)
            (void)alone.motors().move(one.id, place);
        alone.step(k_dt);
        if (step > 1)
            continue;
        if (wake)
            (void)whole.motors().move(two.id, place);
        gift.left = whole.step(k_dt).divergence_rms;
        const std::span<const float> expansion = alone.state().cells.sources.expansion();
        std::vector<float> increment(alone.box().cell_count());
        divergence(*work, alone.field(), increment);
        gift.put_in = source ? rms(expansion) : rms(increment);
        for_each_cell(alone, [&](glm::dvec3 centre, std::size_t n) {
            if (source ? expansion[n] != 0.0f : alone.field()[n] != glm::vec4(0.0f))
                gift.reach = std::max(gift.reach, glm::length(centre - (wake ? place : middle)));
            if (source)
                gift.gives += static_cast<double>(expansion[n]);
        });
    }
    glm::dvec3 impulse(0.0);
    for_each_cell(alone, [&](glm::dvec3 centre, std::size_t n) {
        const glm::dvec3 u(alone.field()[n]);
        impulse += whirl ? glm::cross(centre - middle, u) : u;
    });
    if (!source)
        gift.gives = glm::length(impulse);
    return gift;
}

// Least time of the sources stage in 200 steps. [ms]
double min_sources_ms(Wind& wind, const std::vector<KeptMotor>& motors) {
    double least = 1e30;
    wind.reset();
    for (int step = 0; step < 200; ++step) {
        move_wakes(wind, motors, step);
        least = std::min(least, wind.step(k_dt).times_ms.sources);
    }
    return least;
}

struct Cost {
    double each_us[3];
};

Cost cost_of(Motor motor, const ParallelFor& parallel_for) {
    if (auto* burst = std::get_if<PressureMotor>(&motor))
        burst->duration = 1e3f; // goes on through all the steps
    constexpr int k_counts[] = {0, 1, 30, 300};
    std::vector<Wind> winds;
    std::vector<std::vector<KeptMotor>> motors(4);
    for (int n = 0; n < 4; ++n) {
        winds.push_back(wind_with(k_sources_and_projection, parallel_for));
        Random random(1);
        for (int m = 0; m < k_counts[n]; ++m) {
            const glm::dvec3 place = k_counts[n] == 1 ? glm::dvec3(0.0) : random.point(1.0) * glm::dvec3(14.0, 6.0, 14.0);
            motors[static_cast<std::size_t>(n)].push_back(add_to(winds.back(), motor, place));
        }
    }
    double least[4] = {1e30, 1e30, 1e30, 1e30};
    for (int round = 0; round < 3; ++round)
        for (std::size_t n = 0; n < 4; ++n)
            least[n] = std::min(least[n], min_sources_ms(winds[n], motors[n]));
    Cost cost{};
    for (int n = 0; n < 3; ++n)
        cost.each_us[n] = 1e3 * (least[n + 1] - least[0]) / k_counts[n + 1];
    return cost;
}

void whole_step(const ParallelFor& parallel_for) {
    Wind none = wind_with(Stages{}, parallel_for), crowd = wind_with(Stages{}, parallel_for);
    (void)none.motors().add(DirectionalMotor{.law = Force{0.0f}}); // awake, or there is no step to time
    Random random(2);
    std::vector<KeptMotor> motors;
    const std::vector<MotorRow> all = kinds();
    for (int m = 0; m < 300; ++m) {
        Motor motor = all[static_cast<std::size_t>(m) % all.size()].motor;
        if (auto* burst = std::get_if<PressureMotor>(&motor))
            burst->duration = 1e3f;
        // Weak ones: hundreds of storms in 32 m would be cut into sub-steps, and time those.
        if (auto* vent = std::get_if<OmniMotor>(&motor))
            vent->speed = 0.3f;
        if (auto* burst = std::get_if<PressureMotor>(&motor))
            burst->speed = 0.3f;
        motors.push_back(add_to(crowd, motor, random.point(1.0) * glm::dvec3(14.0, 6.0, 14.0)));
    }
    double least[2] = {1e30, 1e30};
    std::vector<double> times[2];
    int substeps = 1;
    for (int round = 0; round < 3; ++round)
        for (int n = 0; n < 2; ++n) {
            Wind& wind = n == 0 ? none : crowd;
            wind.reset();
            for (int step = 0; step < 200; ++step) {
                if (n == 1)
                    move_wakes(wind, motors, step);
                const Diagnostics done = wind.step(k_dt);
                least[n] = std::min(least[n], done.times_ms.total);
                times[n].push_back(done.times_ms.total);
                substeps = std::max(substeps, done.substeps);
            }
        }
    for (std::vector<double>& list : times)
        std::nth_element(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2), list.end());
    const auto median = [&](int n) { return times[n][times[n].size() / 2]; };
    std::printf("\nwhole step                        least [ms]   median [ms]\n");
    std::printf("  no motor that pushes         %13.3f %13.3f\n", least[0], median(0));
    std::printf("  300 motors, all kinds        %13.3f %13.3f   at most %d sub-steps\n", least[1], median(1), substeps);
}

} // namespace

int main(int argc, char** argv) {
    ThreadPool pool(argc > 1 ? std::atoi(argv[1]) : 1);
    std::printf("32 x 16 x 32 cells of 1 m, steps of 1/30 s, %d thread%s\n\n", pool.size(), pool.size() == 1 ? "" : "s");
    std::printf("%-24s %17s %9s %12s %12s %10s %10s %10s\n", "motor, default", "gives", "reach", "div put in", "div left",
                "1 motor", "30, each", "300, each");
    std::printf("%-24s %17s %9s %12s %12s %10s %10s %10s\n", "", "", "[m]", "[1/s]", "[1/s]", "[us/step]", "[us/step]",
                "[us/step]");
    for (const MotorRow& kind : kinds()) {
        const Gift gift = gift_of(kind.motor);
        const Cost cost = cost_of(kind.motor, pool.parallel_for());
        std::printf("%-24s %11.4g %-5s %9.2f %12.3g %12.3g %10.2f %10.2f %10.2f\n", kind.name, gift.gives, kind.gives_unit,
                    gift.reach, gift.put_in, gift.left, cost.each_us[0], cost.each_us[1], cost.each_us[2]);
    }
    whole_step(pool.parallel_for());
}
