// All cases of `windrow verify`, and what this release knows to miss: bounds from theory, from experiments or from finer grids that no
// tuning of their own may move.
#include "cases/verify_case.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace windrow::cases {

std::span<const VerifyCase> verify_cases() {
    static const std::vector<VerifyCase> k_cases = [] {
        std::vector<VerifyCase> cases;
        for (const auto family : {
                 flow_cases, spectral_cases, transition_cases, cavity_cases, window_cases, motor_cases, jet_cases, wave_cases,
                     tracer_cases, diffusion_cases, wall_cases, poisson_cases, projection_cases, canopy_cases
#if WINDROW_WITH_VULKAN
                     ,
                     parity_cases
#endif
             }) {
            std::vector<VerifyCase> more = family();
            cases.insert(cases.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
        }
        return cases;
    }();
    return k_cases;
}

std::span<const NotMet> not_met() {
    return {}; // as NotMet{"abc_flow", ""}, with the figure in a comment
}

std::string_view VerifiedRow::verdict() const {
    if (pass)
        return guards ? "unchanged" : "pass";
    return expected ? "not met" : guards ? "CHANGED" : "FAIL";
}

bool VerifiedCase::well() const {
    return std::all_of(rows.begin(), rows.end(), [](const VerifiedRow& row) { return row.pass || row.expected; });
}

std::vector<std::string> VerifiedCase::met_unexpectedly() const {
    std::vector<std::string> labels;
    for (const VerifiedRow& row : rows) {
        const std::string& label = row.row.label;
        const bool misses = std::any_of(rows.begin(), rows.end(),
                                        [&](const VerifiedRow& other) { return other.row.label == label && !other.pass; });
        if (row.expected && !misses && std::find(labels.begin(), labels.end(), label) == labels.end())
            labels.push_back(label);
    }
    return labels;
}

VerifiedRow judge(const VerifyCase& one, const VerifiedCase& verified, std::size_t level, const VerifyRow& row,
                  std::span<const NotMet> known) {
    VerifiedRow judged{.row = row,
                       .level = level,
                       .pass = row.error <= row.bound, // a NaN is within no bound
                       .guards = one.guards,
                       .expected = std::any_of(known.begin(), known.end(), [&](const NotMet& miss) {
                           return miss.name == one.name && miss.label == row.label;
                       })};
    const auto coarser = std::find_if(verified.rows.rbegin(), verified.rows.rend(), [&](const VerifiedRow& other) {
        return other.level < level && other.row.label == row.label;
    });
    if (coarser == verified.rows.rend())
        return judged;
    const double refined = static_cast<double>(one.sizes[level]) / one.sizes[coarser->level];
    const double order = std::log(coarser->row.error / row.error) / std::log(refined);
    if (std::isfinite(order))
        judged.order = order;
    if (one.min_order > 0.0 && row.error > 0.0)
        judged.pass = judged.pass && order >= one.min_order;
    return judged;
}

} // namespace windrow::cases
