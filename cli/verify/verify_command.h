// `windrow verify`: holds the solver against known solutions.
#pragma once

#include "cases/verify_case.h"
#include "cli/backend.h"
#include "cli/console.h"
#include "fluid/simd.h"
#include "scene/part.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace windrow::cli {

struct VerifyRequest {
    std::vector<cases::VerifyCase> cases{};
    std::vector<std::string> left_out{};                     ///< cases that the backend cannot run
    std::span<const cases::NotMet> known = cases::not_met(); ///< rows that miss their bounds
    bool list = false;                                       ///< tell the cases, run none
    BackendRequest backend{};
    int threads = 0; ///< 0: one a core
    Simd simd = Simd::best;
    std::optional<std::filesystem::path> json{};
    std::optional<std::filesystem::path> plots{}; ///< a folder
    scene::Part part{};                           ///< of the cases, which are that part's already
    std::vector<std::filesystem::path> join{};    ///< files of parts; no case is run
};

/// Adds the command, which chooses among `known`; where it is chosen, `chosen` runs it.
void add_verify(CLI::App& app, std::span<const cases::VerifyCase> known, std::function<int()>& chosen, const Console& console);

/// Returns the exit code: well where each case passes. `stop_signal` is asked between resolutions; anything but 0 ends the run
/// there, and no file is made.
[[nodiscard]] int run_verify(const VerifyRequest& request, const Console& console, const std::function<int()>& stop_signal);

/// Makes the --json file of the whole from those of its parts, each case from one of them. Returns the exit code: 1 where a row is
/// out of bounds.
[[nodiscard]] int join_verify(const VerifyRequest& request, const Console& console);

/// Name and flow of each case.
void report_list(std::span<const cases::VerifyCase> cases, const Console& console);
/// `device` is empty on the CPU.
void report_setting(int threads, Simd simd, const std::string& device, const Console& console);
/// What a case is, and the head of its table.
void report_case(const cases::VerifyCase& one, const Console& console);
/// One line of it.
void report_row(const cases::VerifyCase& one, const cases::VerifiedRow& row, const Console& console);
/// `left_out` are cases that the backend cannot run.
void report_end(std::span<const cases::VerifiedCase> cases, std::span<const std::string> left_out, const Console& console);

/// {"cases": [{name, label, backend, device, grid, cfl, error, order, bound, min_order, pass}, ...]}: an entry a row. `device`
/// is null on the CPU. `label` tells rows of one resolution apart and is null where there is one; `bound` is the largest error
/// admitted; `order` is null at the first resolution, `min_order` also where no order is asked.
[[nodiscard]] std::string verify_json(const VerifyRequest& request, const std::string& device,
                                      std::span<const cases::VerifiedCase> verified);

} // namespace windrow::cli
