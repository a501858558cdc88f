// Cases: flows whose truth is known, run at several resolutions. `windrow verify` runs all, tests run them one by one.
#pragma once

#include "cases/backend_wind.h"
#include "fluid/parallel.h"
#include "fluid/simd.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace windrow::cases {

/// How the library is to run; no error depends on the threads.
struct VerifySetting {
    Simd simd = Simd::best;
    ParallelFor parallel_for{};
    Backend backend{};
    /// Asked now and then by a case that is long on a device; true ends it.
    std::function<bool()> stopped = [] { return false; };
};

/// Which backends can run a case.
enum class RunsOn : std::uint8_t {
    all,   ///< it asks for whole steps, or for one stage of them
    cpu,   ///< it asks for pieces that a device runs only inside a step
    device ///< it compares a device with the CPU
};

/// One error and its bound.
struct VerifyRow {
    glm::ivec3 cells{0};
    double cfl = 0.0;   ///< largest component of the wind * dt / h; 0 where nothing is carried
    double error = 0.0; ///< as the case's `what` defines it
    double bound = 0.0; ///< the largest error admitted
    /// What tells this row from others of the same resolution: a time step, a distance. Orders are taken between rows of one
    /// label. Empty where a resolution gives one row.
    std::string label{};
};

/// A line of a plot; a plot has one panel or more.
struct PlotCurve {
    std::string plot, panel, line; ///< of a case's curves, the plot is named by the case
    std::vector<glm::dvec2> points;
};

/// What one resolution gave: a row, or one under each of some labels; curves where there is something to plot.
struct VerifyRows {
    std::vector<VerifyRow> rows;
    std::vector<PlotCurve> curves{};

    VerifyRows(VerifyRow row) : rows{std::move(row)} {}
    VerifyRows(std::vector<VerifyRow> all) : rows(std::move(all)) {}
};

struct VerifyCase {
    std::string name;
    std::string what;   ///< the flow and how its error is taken, in a sentence
    std::string source; ///< where the flow and its truth are from
    std::string reason; ///< why these bounds
    /// Its bounds only guard against change: figures of this library and a fifth more. What holds it to the truth is the order.
    bool guards = false;
    double min_order = 0.0; ///< between neighbouring resolutions; 0: none is asked, since the error is rounding
    RunsOn runs_on = RunsOn::all;
    std::vector<int> sizes{}; ///< resolutions, coarse to fine: the cell is as 1 / size
    std::function<VerifyRows(const VerifySetting& setting, int size)> run{};
};

/// A row of a case that is known to miss its bound.
struct NotMet {
    std::string_view name, label;
};
/// All of them, in verify_case.cpp: the one place that expects a miss. A row that meets its bound must leave it.
[[nodiscard]] std::span<const NotMet> not_met();

/// All cases, in the order in which they run.
[[nodiscard]] std::span<const VerifyCase> verify_cases();

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

/// The cases whose truth is a spectral solution by FFTW, whether or not the program has them.
inline constexpr const char* k_spectral_names[] = {"taylor_green_3d", "forced_flow"};
/// Where they are, and what else is compared with FFTW.
inline constexpr const char* k_where_fftw_is = "the program windrow-fftw, which is built beside windrow and not installed";

// The families; each in a file of its own.
[[nodiscard]] std::vector<VerifyCase> flow_cases();
[[nodiscard]] std::vector<VerifyCase> spectral_cases(); ///< in programs that link windrow_fftw, else none
[[nodiscard]] std::vector<VerifyCase> transition_cases();
[[nodiscard]] std::vector<VerifyCase> cavity_cases();
[[nodiscard]] std::vector<VerifyCase> window_cases();
[[nodiscard]] std::vector<VerifyCase> motor_cases();
[[nodiscard]] std::vector<VerifyCase> jet_cases();
[[nodiscard]] std::vector<VerifyCase> wave_cases();
[[nodiscard]] std::vector<VerifyCase> tracer_cases();
[[nodiscard]] std::vector<VerifyCase> diffusion_cases();
[[nodiscard]] std::vector<VerifyCase> wall_cases();
[[nodiscard]] std::vector<VerifyCase> poisson_cases();
[[nodiscard]] std::vector<VerifyCase> projection_cases();
[[nodiscard]] std::vector<VerifyCase> canopy_cases();
[[nodiscard]] std::vector<VerifyCase> parity_cases(); ///< where Vulkan is built in

} // namespace windrow::cases
