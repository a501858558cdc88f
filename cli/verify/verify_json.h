// The errors of `windrow verify` as JSON.
#pragma once

#include "cli/verify/verify_request.h"
#include "cli/verify/verify_result.h"

#include <span>
#include <string>

namespace windrow::cli {

/// {"cases": [{name, label, backend, device, grid, cfl, error, order, bound, least_order, pass}, ...]}: an entry a row. `device`
/// is null on the CPU. `label` tells rows of one resolution apart and is null where there is one; `bound` is the largest error
/// admitted; `order` is null at the first resolution, `least_order` also where no order is asked.
[[nodiscard]] std::string verify_json(const VerifyRequest& request, const std::string& device,
                                      std::span<const VerifiedCase> verified);

} // namespace windrow::cli
