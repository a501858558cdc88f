#include "fluid/cpu/kernels/kernels.h"

namespace windrow {
namespace cpu {

const Kernels* kernels_for(Simd level) {
#if defined(WINDROW_X86_LEVELS)
    const bool has_avx512 =
        __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq");
    const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
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
    return cpu::kernels_for(Simd::best)->name;
}

} // namespace windrow
