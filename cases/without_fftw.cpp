// What FFTW's part is in a program that does not link windrow_fftw: nothing.
#include "cases/reference/fftw_projection.h"
#include "cases/verify_case.h"

namespace windrow {

std::vector<cases::VerifyCase> cases::spectral_cases() {
    return {};
}

std::unique_ptr<reference::FftwProjection> reference::FftwProjection::create(glm::ivec3, float) {
    return nullptr;
}

} // namespace windrow
