#include "cli/verify/verify_result.h"

#include <algorithm>
#include <cmath>

namespace windrow::cli {

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
    if (one.least_order > 0.0 && row.error > 0.0)
        judged.pass = judged.pass && order >= one.least_order;
    return judged;
}

} // namespace windrow::cli
