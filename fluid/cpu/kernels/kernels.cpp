#include "fluid/cpu/kernels/kernels.h"

#if defined(WINDROW_X86_LEVELS)
#include <cpuid.h>
#endif

namespace windrow {
namespace cpu {
#if defined(WINDROW_X86_LEVELS)
namespace {

// Conversion to halves. Clang 14 does not answer it by __builtin_cpu_supports.
bool has_f16c() {
    unsigned a = 0, b = 0, c = 0, d = 0;
    return __get_cpuid(1, &a, &b, &c, &d) != 0 && (c & bit_F16C) != 0;
}

} // namespace
#endif

const Kernels* kernels_for(Simd level) {
#if defined(WINDROW_X86_LEVELS)
    // Asked once: it takes as long as a query of a point.
    static const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && has_f16c();
    static const bool has_avx512 =
        has_avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq");
    if (has_avx512 && (level == Simd::best || level == Simd::avx512))
        return &avx512::k_kernels;
    if (has_avx2 && (level == Simd::best || level == Simd::avx2))
        return &avx2::k_kernels;
#endif
    return level == Simd::best || level == Simd::baseline ? &baseline::k_kernels : nullptr;
}

} // namespace cpu

bool runs(Simd level) {
    return cpu::kernels_for(level) != nullptr;
}

const char* name_of(Simd level) {
    switch (level) {
    case Simd::baseline:
        return "baseline";
    case Simd::avx2:
        return "avx2";
    case Simd::avx512:
        return "avx512";
    case Simd::best:
        break;
    }
    return cpu::best_kernels().name;
}

} // namespace windrow
