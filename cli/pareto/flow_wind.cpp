#include "cli/pareto/flow_wind.h"

namespace windrow::cli {

Result<std::unique_ptr<CommandWind>> flow_wind(const ParetoFlow& flow, glm::ivec3 cells, const Method& method, Simd simd,
                                               const ParallelFor& parallel_for, const Backend& backend) {
    const Box box = box_of(flow, cells);
    auto wind = CommandWind::create({.cells = box.cells,
                                     .cell_size = box.cell_size,
                                     .sides = box.sides,
                                     .centre = 0.5 * static_cast<double>(box.cell_size) * glm::dvec3(box.cells),
                                     .ambient = glm::vec3(flow.mean),
                                     .viscosity = 0.0f,
                                     .settling_time = 0.0f,
                                     .scheme = method.scheme,
                                     .interpolation = method.interpolation,
                                     .max_cfl = 1e5f,
                                     .max_substeps = 1,
                                     .simd = simd,
                                     .parallel_for = parallel_for},
                                    backend);
    for (const Motor& motor : flow.motors)
        if (wind)
            if (const auto added = (*wind)->motors().add(motor); !added)
                return Error{added.error()};
    return wind;
}

} // namespace windrow::cli
