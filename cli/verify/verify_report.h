// What `windrow verify` tells: a table a case, and at the end which cases failed.
#pragma once

#include "cli/console.h"
#include "cli/verify/verify_result.h"

#include <span>

namespace windrow::cli {

/// Name and flow of each case.
void report_list(std::span<const VerifyCase> cases, const Console& console);
/// `device` is empty on the CPU.
void report_setting(int threads, Simd simd, const std::string& device, const Console& console);
/// What a case is, and the head of its table.
void report_case(const VerifyCase& one, const Console& console);
/// One line of it.
void report_row(const VerifyCase& one, const VerifiedRow& row, const Console& console);
/// `left_out` are cases that the backend cannot run.
void report_end(std::span<const VerifiedCase> cases, std::span<const std::string> left_out, const Console& console);

} // namespace windrow::cli
