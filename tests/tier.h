// How much of a sweep a test takes. `./dev test all` takes the whole; `./dev test` and CI take a part that still shows what the
// sweep is for; a sanitizer takes least, since the same steps run fifteen times slower and the first of them hold what it looks
// for.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace windrow::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool k_sanitized = true;
#else
inline constexpr bool k_sanitized = false;
#endif

/// Set by `./dev test all`: WINDROW_TIER=all.
[[nodiscard]] inline bool whole_sweeps() {
    const char* const tier = std::getenv("WINDROW_TIER");
    return tier != nullptr && std::string_view(tier) == "all";
}

/// Of `count` steps or samples: all of them, an eighth, or a twentieth; at least `least`, or all where there are fewer.
[[nodiscard]] inline int sampled(int count, int least) {
    const int part = k_sanitized ? count / 20 : whole_sweeps() ? count : count / 8;
    return std::max(std::min(count, least), part);
}

} // namespace windrow::test
