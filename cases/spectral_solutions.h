// Pseudo-spectral solutions of flows that have no closed form: the truths of cases and tests, each solved once in a program. For
// programs that link FFTW.
//
// 80^3 points are less than 5e-4 from finer ones at the end (64^3 are 3e-3 from it); 128^2 points, 2e-4 from 96^2.
#pragma once

#include "cases/flows.h"
#include "cases/reference/spectral_flow.h"

#include <functional>
#include <memory>

namespace windrow::cases {

using SpectralSolution = std::unique_ptr<const reference::SpectralFlow>;

[[nodiscard]] inline SpectralSolution solved(glm::ivec3 points, double viscosity,
                                             const std::function<glm::dvec3(glm::dvec3)>& start,
                                             const reference::SpectralFlow::Force& force, double end, int steps) {
    auto flow = std::make_unique<reference::SpectralFlow>(points, viscosity);
    flow->start(start);
    flow->set_force(force);
    flow->run(end, steps);
    return flow;
}

/// Taylor and Green's vortices in space, when they have stretched into sheets but the flow is still smooth.
inline constexpr double k_sheets_end = 3.0, k_sheets_viscosity = 1.0 / 200.0; ///< [s], [m^2/s]
[[nodiscard]] inline const reference::SpectralFlow& taylor_green_3d_end() {
    static const auto flow = solved(glm::ivec3(80), k_sheets_viscosity, taylor_green_3d_start, {}, k_sheets_end, 30);
    return *flow;
}

[[nodiscard]] inline SpectralSolution solved(const ForcedVortices& forced, int points, int steps) {
    return solved(
        {points, points, 1}, ForcedVortices::k_viscosity, ForcedVortices::start,
        [forced](glm::dvec3 x, double t) { return forced.force(x, t); }, ForcedVortices::k_end, steps);
}
[[nodiscard]] inline const reference::SpectralFlow& forced_vortices_end() {
    static const auto flow = solved(ForcedVortices{}, 128, 200);
    return *flow;
}

} // namespace windrow::cases
