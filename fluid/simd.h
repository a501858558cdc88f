// SIMD level of the hot loops. The same source is compiled for each level and selected at run time. Each level gives one result
// for any number of threads; levels differ by rounding.
#pragma once

#include "api.h"
#include "setting.h"

#include <cstdint>

namespace windrow {

enum class Simd : std::uint8_t {
    /// The best level of this machine. The default.
    best,
    /// Of every machine (SSE2 on x86): the same bits on all of them, for lockstep and replays (docs/promises.md).
    baseline,
    avx2,   ///< AVX2 with FMA.
    avx512, ///< AVX-512 F, VL, DQ.
};

template <>
inline constexpr std::array<const char*, 4> k_words<Simd>{"best", "baseline", "avx2", "avx512"};

/// True if this machine supports a level; `best` always.
[[nodiscard]] WINDROW_API bool runs(Simd level);
/// "baseline", "avx2", "avx512"; for `best` the level that it stands for here.
[[nodiscard]] WINDROW_API const char* name_of(Simd level);

} // namespace windrow
