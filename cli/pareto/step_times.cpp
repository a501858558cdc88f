#include "cli/pareto/step_times.h"

#include "cases/reference/stam.h"
#include "cli/bench/contest.h"
#include "cli/pareto/flow_wind.h"
#include "cli/verify/cell_values.h"

#include <algorithm>
#include <deque>
#include <span>
#include <vector>

namespace windrow::cli {
namespace {

constexpr int k_sweeps = 40;
constexpr int k_most_age = 60; // steps before the field is laid in anew

/// Steps a field that is laid in anew before it grows old. A first step has no history and costs less, so one is made that is
/// not timed.
class Stepper {
  public:
    Stepper(int most_age, std::function<void()> lay_in) : most_age_(most_age), age_(most_age), lay_in_(std::move(lay_in)) {}

    [[nodiscard]] Contestant contestant(std::function<void()> step) {
        return {.run =
                    [this, step] {
                        step();
                        ++age_;
                    },
                .prepare =
                    [this, step] {
                        if (age_ < most_age_)
                            return;
                        lay_in_();
                        step();
                        age_ = 1;
                    }};
    }

  private:
    int most_age_, age_;
    std::function<void()> lay_in_;
};

} // namespace

Result<std::optional<GridTimes>> measure_steps(const ParetoFlow& flow, glm::ivec3 cells, double seconds, Simd simd,
                                               const ParallelFor& parallel_for, const Backend& backend,
                                               const std::function<bool()>& stopped) {
    const Box box = box_of(flow, cells);
    const int steps = steps_of(flow, cells, 1.0), most_age = std::min(steps, k_most_age);
    const double dt = flow.end / steps;
    const Solves solves = solves_of(flow, backend.kind());
    const auto methods = pareto_methods(solves);
    const CellVelocities start =
        flow.start ? velocities_of(box, flow.start) : CellVelocities(box.cell_count(), glm::vec4(glm::vec3(flow.mean), 0.0f));

    Contest contest;
    std::deque<FlowWind> winds; // contestants point to these two
    std::deque<Stepper> steppers;
    const auto enter = [&](const Method& method, const Backend& on) -> Result<std::size_t> {
        auto made = FlowWind::create(flow, cells, {.method = method, .simd = simd, .parallel_for = parallel_for}, on);
        if (!made)
            return Error{made.error()};
        FlowWind& wind = winds.emplace_back(*std::move(made));
        return contest.add(steppers.emplace_back(most_age, [&wind] { wind.begin(); }).contestant([&wind, dt] { wind.step(dt); }));
    };
    std::optional<reference::ComposedStep> composed;
    if (solves == Solves::all) {
        auto made = composed_step(flow, cells, simd, parallel_for);
        if (!made)
            return Error{made.error()};
        if (const auto fits = made->start(start); !fits)
            return Error{fits.error()};
        composed.emplace(*std::move(made));
    }
    Stepper composed_stepper(most_age, [&] { static_cast<void>(composed->start(start)); }); // the motors were accepted
    std::vector<std::size_t> numbers;
    for (const Method& method : methods) {
        if (solves == Solves::all) {
            numbers.push_back(contest.add(composed_stepper.contestant([&, method] { composed->step(method, dt); })));
            continue;
        }
        const auto number = enter(method, backend);
        if (!number)
            return Error{number.error()};
        numbers.push_back(*number);
    }
    // What the default method is compared with.
    const bool wind_too = solves == Solves::all || !backend.is_cpu();
    const auto wind_number = wind_too ? enter(k_default_method, {}) : Result<std::size_t>(0);
    if (!wind_number)
        return Error{wind_number.error()};
    reference::StamStep stam(cells, box.cell_size, k_sweeps, parallel_for, simd);
    stam.set_ambient(glm::vec3(flow.mean));
    Stepper stam_stepper(most_age, [&] { std::copy(start.begin(), start.end(), stam.velocity().begin()); });
    const std::size_t stam_number = contest.add(stam_stepper.contestant([&] { stam.step(static_cast<float>(dt)); }));
    if (!contest.hold(seconds, stopped))
        return std::optional<GridTimes>();

    GridTimes times{.stam_ms = contest.milliseconds(stam_number).min, .rounds = contest.rounds()};
    for (std::size_t n = 0; n < methods.size(); ++n) {
        const double ratio = contest.ratio(numbers[n], stam_number);
        times.methods.push_back({.vs_stam40 = ratio, .step_ms = ratio * times.stam_ms});
        if (wind_too && methods[n] == k_default_method)
            times.wind_vs_method = contest.ratio(*wind_number, numbers[n]);
    }
    return std::optional(std::move(times));
}

} // namespace windrow::cli
