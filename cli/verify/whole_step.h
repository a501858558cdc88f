// The whole step as the cases take it: raw, with nothing on top of the method.
#pragma once

#include "cli/verify/cell_values.h"
#include "fluid/wind.h"

namespace windrow::cli {

/// No settling, no sub-steps; the box's low corner lies at the origin.
inline Config raw_config(const Box& box, double viscosity, const VerifySetting& setting) {
    Config config{.cells = box.cells, .cell_size = box.cell_size, .sides = box.sides};
    config.centre = 0.5 * static_cast<double>(box.cell_size) * glm::dvec3(box.cells);
    config.viscosity = static_cast<float>(viscosity);
    config.settling_time = 0.0f;
    config.max_cfl = 1e5f;
    config.simd = setting.simd;
    config.parallel_for = setting.parallel_for;
    return config;
}

/// A wind of a config that is known to be legal.
inline Wind wind_of(const Config& config) {
    return *Wind::create(config);
}

} // namespace windrow::cli
