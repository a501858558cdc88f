// The whole step as the cases take it: raw, with nothing on top of the method.
#pragma once

#include "cases/backend_wind.h"
#include "cases/cell_values.h"

#include <memory>

namespace windrow::cases {

/// No settling, no sub-steps; the box's low corner lies at the origin.
inline Config raw_config(const Box& box, double viscosity, const VerifySetting& setting) {
    Config config{.cells = box.cells, .cell_size = box.cell_size, .boundaries = box.boundaries};
    config.centre = 0.5 * static_cast<double>(box.cell_size) * glm::dvec3(box.cells);
    config.viscosity = static_cast<float>(viscosity);
    config.relaxation_time = 0.0f;
    config.max_cfl = 1e5f;
    config.max_substeps = 1;
    config.simd = setting.simd;
    config.parallel_for = setting.parallel_for;
    return config;
}

/// A wind of a config that is known to be legal. Where the device has no room for it, the backend is told, which ends the command
/// after the case; until then the CPU stands in.
inline std::unique_ptr<BackendWind> wind_of(const Config& config, const VerifySetting& setting) {
    auto wind = BackendWind::create(config, setting.backend);
    if (wind)
        return *std::move(wind);
    setting.backend.note_fault(wind.error());
    return *BackendWind::create(config);
}

} // namespace windrow::cases
