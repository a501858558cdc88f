#include "cli/pareto/step_times.h"

#include "cli/bench/contest.h"
#include "cli/pareto/flow_wind.h"
#include "cli/verify/cell_values.h"
#include "tests/bench/reference/stam.h"

#include <algorithm>
#include <memory>
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
    const CellVelocities start = velocities_of(box, flow.start);
    auto composed = bench::ComposedStep::create(
        {.box = box, .ambient = glm::vec3(flow.mean), .motors = flow.motors, .simd = simd, .parallel_for = parallel_for});
    if (!composed)
        return Error{composed.error()};
    if (const auto fits = composed->start(start); !fits)
        return Error{fits.error()};
    auto wind = flow_wind(flow, cells, k_default_method, simd, parallel_for, {});
    if (!wind)
        return Error{wind.error()};
    bench::StamStep stam(cells, box.cell_size, k_sweeps, parallel_for, simd);
    stam.set_ambient(glm::vec3(flow.mean));

    Contest contest;
    Stepper composed_stepper(most_age, [&] { static_cast<void>(composed->start(start)); });   // the motors were accepted
    Stepper wind_stepper(most_age, [&] { static_cast<void>((*wind)->set_velocity(start)); }); // of the box's size
    Stepper stam_stepper(most_age, [&] { std::copy(start.begin(), start.end(), stam.velocity().begin()); });
    const auto methods = pareto_methods(backend.kind());
    std::vector<std::unique_ptr<CommandWind>> device_winds;
    std::vector<Stepper> device_steppers;
    device_steppers.reserve(methods.size()); // contestants point to them
    std::vector<std::size_t> numbers;
    for (const Method& method : methods) {
        if (backend.is_cpu()) {
            numbers.push_back(contest.add(composed_stepper.contestant([&, method] { composed->step(method, dt); })));
            continue;
        }
        auto made = flow_wind(flow, cells, method, simd, parallel_for, backend);
        if (!made)
            return Error{made.error()};
        CommandWind& device_wind = *device_winds.emplace_back(*std::move(made));
        device_steppers.emplace_back(most_age, [&device_wind, &start] { static_cast<void>(device_wind.set_velocity(start)); });
        numbers.push_back(contest.add(device_steppers.back().contestant([&device_wind, dt] { device_wind.step(dt); })));
    }
    const std::size_t wind_number = contest.add(wind_stepper.contestant([&] { (*wind)->step(dt); }));
    const std::size_t stam_number = contest.add(stam_stepper.contestant([&] { stam.step(static_cast<float>(dt)); }));
    if (!contest.hold(seconds, stopped))
        return std::optional<GridTimes>();

    GridTimes times{.stam_ms = contest.milliseconds(stam_number).min, .rounds = contest.rounds()};
    for (std::size_t n = 0; n < methods.size(); ++n) {
        const double ratio = contest.ratio(numbers[n], stam_number);
        times.methods.push_back({.vs_stam40 = ratio, .step_ms = ratio * times.stam_ms});
        if (methods[n] == k_default_method)
            times.wind_vs_method = contest.ratio(wind_number, numbers[n]);
    }
    return std::optional(std::move(times));
}

} // namespace windrow::cli
