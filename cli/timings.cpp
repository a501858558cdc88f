#include "cli/timings.h"

#include "cli/table.h"
#include "fluid/core/message.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <numeric>
#include <string_view>
#include <type_traits>

namespace windrow::cli {
namespace {

double sum(const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

std::string row(const std::string& name, const std::vector<float>& values, double whole) {
    const double share = whole > 0.0 ? 100.0 * sum(values) / whole : 0.0;
    return detail::message("  ", name, std::string(name.size() < 14 ? 14 - name.size() : 0, ' '),
                           right(to_fixed(quantile(values, 0.0), 3), 10), right(to_fixed(quantile(values, 0.5), 3), 10),
                           right(to_fixed(quantile(values, 0.99), 3), 10), right(to_fixed(share, 0) + " %", 9), "\n");
}

/// Calls visit(row, value) for each figure, each stage among them.
template <class Report, class Visit>
void for_each_figure(const Report& report, const Visit& visit) {
    for_each_row(report, [&](const auto& row, const auto& value) {
        if constexpr (requires { value.rows(); })
            for_each_figure(value, visit);
        else
            visit(row, value);
    });
}

/// "energy_m5_s2"
std::string column(std::string name, std::string_view unit) {
    name += unit.empty() ? "" : "_";
    for (const char letter : unit)
        if (letter != '^')
            name += letter == '/' ? '_' : letter;
    return name;
}

template <class Value>
auto cell(Value value) {
    if constexpr (std::is_enum_v<Value>)
        return k_words<Value>[static_cast<std::size_t>(value)];
    else if constexpr (std::same_as<Value, bool>)
        return value ? 1 : 0;
    else
        return value;
}

} // namespace

void Timings::add(double time, const Diagnostics& diagnostics) {
    // A step asleep has no stages, and its microseconds among the others would make a step look cheaper than it is.
    if (diagnostics.asleep)
        asleep_ms_.push_back(static_cast<float>(diagnostics.times_ms.total));
    for (std::size_t i = 0; i < stage_ms_.size() && !diagnostics.asleep; ++i)
        stage_ms_[i].push_back(static_cast<float>(diagnostics.times_ms.*StageTimes::rows()[i].member));
    substeps_ += diagnostics.substeps;
    largest_cfl_ = std::max(largest_cfl_, diagnostics.cfl);
    largest_speed_ = std::max(largest_speed_, diagnostics.max_speed);
    limited_cells_ += diagnostics.limited_cells;
    limited_steps_ += diagnostics.limited_cells > 0 ? 1 : 0;
    repaired_cells_ += diagnostics.repaired_cells;
    jumps_ += diagnostics.jumps;
    fast_turns_ += diagnostics.fast_turns > 0 ? 1 : 0;
    filled_ += diagnostics.filling_obstacles > 0 ? 1 : 0;
    sealed_ += diagnostics.sealed_rooms > 0 ? 1 : 0;
    motors_lost_ = std::min(diagnostics.motors_lost, motors_lost_.value_or(diagnostics.motors_lost));
    if (diagnostics.repaired_cells > 0 && !first_repair_time_)
        first_repair_time_ = time;
}

double Timings::solver_seconds() const {
    return (sum(stage_ms_.back()) + sum(asleep_ms_)) / 1000.0;
}

float Timings::awake_ms() const {
    return quantile(stage_ms_.back(), 0.5);
}
float Timings::asleep_ms() const {
    return quantile(asleep_ms_, 0.5);
}

std::string Timings::table() const {
    const double whole = sum(stage_ms_.back()) + sum(asleep_ms_);
    std::string text = detail::message("  stage         ", right("min ms", 10), right("median ms", 10), right("99 % ms", 10),
                                       right("share", 9), "\n");
    std::vector<float> rest = stage_ms_.back();
    for (std::size_t i = 0; i < k_stage_count; ++i) {
        text += row(StageTimes::rows()[i].name, stage_ms_[i], whole);
        for (std::size_t k = 0; k < rest.size(); ++k)
            rest[k] -= stage_ms_[i][k];
    }
    // What no stage claims (a moved box, for one) must not hide.
    if (sum(rest) > 0.005 * whole)
        text += row("rest", rest, whole);
    text += row("whole step", stage_ms_.back(), whole);
    return asleep_ms_.empty() ? text : text + row("step asleep", asleep_ms_, whole);
}

float quantile(std::vector<float> values, double q) {
    if (values.empty())
        return 0.0f;
    const double rank = std::ceil(q * static_cast<double>(values.size())) - 1.0;
    const auto nth = values.begin() + static_cast<std::ptrdiff_t>(std::clamp(rank, 0.0, static_cast<double>(values.size() - 1)));
    std::nth_element(values.begin(), nth, values.end());
    return *nth;
}

std::string timings_header() {
    std::string text = "step,time_s";
    for_each_figure(Diagnostics{}, [&](const auto& row, const auto&) { text += "," + column(row.name, row.unit); });
    return text + "\n";
}

std::string timings_row(std::int64_t step, double time, const Diagnostics& diagnostics) {
    std::string text = detail::message(step, ",", time);
    for_each_figure(diagnostics, [&](const auto&, const auto& value) { text += detail::message(",", cell(value)); });
    return text + "\n";
}

} // namespace windrow::cli
