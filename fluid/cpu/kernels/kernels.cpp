#include "fluid/cpu/kernels/kernels.h"

namespace windrow::cpu {

const Kernels& best_kernels() {
#if defined(WINDROW_X86_LEVELS)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq"))
        return avx512::k_kernels;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return avx2::k_kernels;
#endif
    return baseline::k_kernels;
}

} // namespace windrow::cpu
