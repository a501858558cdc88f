#include "cli/flags.h"

#include "fluid/message.h"
#include "scene/number_text.h"

#include <utility>

namespace windrow::cli {

using detail::message;

std::optional<std::int64_t> read_count(const std::string& text, const char* flag, std::int64_t most, const Console& console) {
    const auto number = scene::parse_whole_number(text);
    if (number && *number >= 1 && *number <= most)
        return *number;
    console.complain(message(flag, " is ", text.empty() ? "empty" : text, ": give a whole number from 1 to ", most, "."));
    return std::nullopt;
}

std::optional<Simd> read_simd(const std::string& text, const Console& console) {
    constexpr std::pair<const char*, Simd> k_levels[] = {
        {"best", Simd::best}, {"baseline", Simd::baseline}, {"avx2", Simd::avx2}, {"avx512", Simd::avx512}};
    for (const auto& [name, level] : k_levels) {
        if (text != name)
            continue;
        if (runs(level))
            return level;
        console.complain(message("--simd is ", name, ", which this machine does not run: give best or baseline."));
        return std::nullopt;
    }
    console.complain(message("--simd is ", text.empty() ? "empty" : text, ": give best, baseline, avx2 or avx512."));
    return std::nullopt;
}

std::optional<double> read_seconds(const std::string& text, const Console& console) {
    const auto seconds = scene::parse_number(text);
    if (seconds && *seconds > 0.0 && *seconds <= k_most_seconds)
        return seconds;
    console.complain(message("--seconds is ", text.empty() ? "empty" : text, ": give a number above 0, at most ",
                             scene::figure(k_most_seconds), " s."));
    return std::nullopt;
}

} // namespace windrow::cli
