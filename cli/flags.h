// Values of flags, read with a sentence of ours where they are wrong: CLI11's own do not tell what would be right.
#pragma once

#include "cli/console.h"
#include "fluid/simd.h"

#include <cstdint>
#include <optional>
#include <string>

namespace windrow::cli {

/// A whole number from 1 to `most`.
[[nodiscard]] std::optional<std::int64_t> read_count(const std::string& text, const char* flag, std::int64_t most,
                                                     const Console& console);
/// [s] The longest that a measurement is asked to take.
inline constexpr double k_most_seconds = 3600.0;
/// The value of --seconds: above 0, at most k_most_seconds.
[[nodiscard]] std::optional<double> read_seconds(const std::string& text, const Console& console);
/// best, baseline, avx2 or avx512, where this machine runs it.
[[nodiscard]] std::optional<Simd> read_simd(const std::string& text, const Console& console);

} // namespace windrow::cli
