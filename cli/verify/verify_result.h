// What `windrow verify` finds, and whether it is good.
#pragma once

#include "cli/verify/verify_case.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace windrow::cli {

struct VerifiedRow {
    VerifyRow row;
    std::size_t level = 0; ///< place of its resolution in the case's sizes
    /// From the last resolution before that has a row of this label; nothing at the first, nor where an error is 0 or not finite.
    std::optional<double> order{};
    bool pass = false;
    bool guards = false;   ///< as of its case
    bool expected = false; ///< known to miss its bound
    /// "pass" or "FAIL"; "unchanged" or "CHANGED" where the bound is none of the truth's; "not met" where that is expected.
    [[nodiscard]] std::string_view verdict() const;
};

struct VerifiedCase {
    std::string name;
    std::vector<VerifiedRow> rows{};

    /// Each row is within its bound or expected to miss it.
    [[nodiscard]] bool well() const;
    /// Labels that are expected to miss their bounds and met all of them.
    [[nodiscard]] std::vector<std::string> met_unexpectedly() const;
};

/// Judges a row that `one` gave at its resolution `level`, behind those in `verified`. An error within its bound passes where its
/// order from the resolution before, in the row of the same label, is not below the least; an error of 0 has no order and passes.
/// A row that `known` names is expected to miss.
[[nodiscard]] VerifiedRow judge(const VerifyCase& one, const VerifiedCase& verified, std::size_t level, const VerifyRow& row,
                                std::span<const NotMet> known);

} // namespace windrow::cli
