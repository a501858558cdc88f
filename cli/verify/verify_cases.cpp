// All cases of `windrow verify`, and what this release knows to miss: bounds from theory, from experiments or from finer grids that no
// tuning of their own may move.
#include "cli/verify/verify_case.h"

#include <iterator>

namespace windrow::cli {

std::span<const VerifyCase> verify_cases() {
    static const std::vector<VerifyCase> k_cases = [] {
        std::vector<VerifyCase> cases;
        for (const auto family : {
                 flow_cases, spectral_cases, transition_cases, cavity_cases, window_cases, motor_cases, jet_cases, wave_cases,
                     tracer_cases, diffusion_cases, wall_cases, poisson_cases, projection_cases, canopy_cases
#if WINDROW_WITH_VULKAN
                     ,
                     parity_cases
#endif
             }) {
            std::vector<VerifyCase> more = family();
            cases.insert(cases.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
        }
        return cases;
    }();
    return k_cases;
}

std::span<const NotMet> not_met() {
    return {}; // as NotMet{"abc_flow", ""}, with the figure in a comment
}

} // namespace windrow::cli
