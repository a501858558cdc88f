// What is true at the end of a flow, at the cell centres of any grid.
#pragma once

#include "cases/pareto_flow.h"
#include "fluid/parallel.h"
#include "fluid/result.h"
#include "fluid/simd.h"

#include <cstdint>
#include <functional>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

namespace windrow::cases {

struct CellTruth {
    std::vector<glm::dvec3> velocity;  ///< [m/s]
    std::vector<std::uint8_t> counted; ///< whether an error counts the cell
    double perturbation = 0.0;         ///< [m/s] |velocity - ambient wind|, summed over these
};

class FlowTruth {
  public:
    /// Runs the reference where there is no exact end; nothing inside where `stopped` said so.
    [[nodiscard]] static Result<std::optional<FlowTruth>> find(const ParetoFlow& flow, Simd simd, const ParallelFor& parallel_for,
                                                               const std::function<bool()>& stopped);
    /// At the cell centres of a grid. Out of a reference by cubic interpolation, one-sided at the boundaries: its error falls
    /// as the fourth power of the reference's cells, faster than the reference's own.
    [[nodiscard]] CellTruth at_centres(glm::ivec3 cells) const;

  private:
    FlowTruth(const ParetoFlow& flow, const AmbientWind& ambient) : flow_(&flow), ambient_(ambient) {}
    [[nodiscard]] glm::dvec3 sample(glm::dvec3 cell) const;

    const ParetoFlow* flow_;
    AmbientWind ambient_; ///< at the flow's end
    std::vector<glm::vec4> reference_;
};

/// |u - truth| / |truth - ambient wind|
[[nodiscard]] double flow_error(std::span<const glm::vec4> u, const CellTruth& truth);

} // namespace windrow::cases
