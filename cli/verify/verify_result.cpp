#include "cli/verify/verify_result.h"

#include <algorithm>
#include <cmath>

namespace windrow::cli {

bool VerifiedCase::pass() const {
    return std::all_of(rows.begin(), rows.end(), [](const VerifiedRow& row) { return row.pass; });
}

VerifiedRow judge(const VerifyCase& one, const VerifiedCase& verified, std::size_t level, const VerifyRow& row) {
    VerifiedRow judged{.row = row, .level = level, .pass = row.error <= row.bound}; // a NaN is within no bound
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
