// What `windrow verify` finds, and whether it is good.
#pragma once

#include "cli/verify/verify_case.h"

#include <optional>
#include <string>
#include <vector>

namespace windrow::cli {

struct VerifiedRow {
    VerifyRow row;
    std::optional<double> order{}; ///< from the resolution before; nothing at the first, nor where an error is 0 or not finite
    bool pass = false;
};

struct VerifiedCase {
    std::string name;
    std::vector<VerifiedRow> rows{};

    [[nodiscard]] bool pass() const;
};

/// Judges what `one` gave at its resolution `level`, behind those in `verified`. An error within its bound passes where its order
/// from the resolution before is not below the least; an error of 0 has no order and passes.
[[nodiscard]] VerifiedRow judge(const VerifyCase& one, const VerifiedCase& verified, std::size_t level, const VerifyRow& row);

} // namespace windrow::cli
