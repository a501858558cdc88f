// The errors of `windrow verify` as JSON.
#pragma once

#include "cli/verify/verify_result.h"

#include <span>
#include <string>

namespace windrow::cli {

/// {"cases": [{name, backend, grid, cfl, error, order, bound, least_order, pass}, ...]}: an entry a resolution. `bound` is the
/// largest error admitted; `order` is null at the first resolution, `least_order` also where the error is rounding and no order
/// is asked.
[[nodiscard]] std::string verify_json(std::span<const VerifyCase> cases, std::span<const VerifiedCase> verified);

} // namespace windrow::cli
