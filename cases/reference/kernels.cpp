// The level is the solver's word for it, so that both run on the same instructions.
#include "cases/reference/kernels.h"

#include <string_view>

namespace windrow::reference {

const Kernels& kernels_for(Simd level) {
    const std::string_view name = name_of(level);
#if defined(WINDROW_X86_LEVELS)
    if (name == "avx512")
        return avx512::k_kernels;
    if (name == "avx2")
        return avx2::k_kernels;
#endif
    static_cast<void>(name);
    return baseline::k_kernels;
}

} // namespace windrow::reference
