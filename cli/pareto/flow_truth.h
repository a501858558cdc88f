// What is true at the end of a flow, at the cell centres of any grid.
#pragma once

#include "cli/pareto/pareto_flow.h"
#include "fluid/parallel.h"
#include "fluid/result.h"
#include "fluid/simd.h"

#include <cstdint>
#include <functional>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

namespace windrow::cli {

class FlowTruth {
  public:
    /// Runs the reference where there is no exact end; nothing inside where `stopped` said so.
    [[nodiscard]] static Result<std::optional<FlowTruth>> find(const ParetoFlow& flow, Simd simd, const ParallelFor& parallel_for,
                                                               const std::function<bool()>& stopped);
    /// [m/s] At the cell centres of a grid. Out of a reference by cubic interpolation, one-sided at the sides: its error falls
    /// as the fourth power of the reference's cells, faster than the reference's own.
    [[nodiscard]] std::vector<glm::dvec3> at_centres(glm::ivec3 cells) const;

  private:
    explicit FlowTruth(const ParetoFlow& flow) : flow_(&flow) {}
    [[nodiscard]] glm::dvec3 sample(glm::dvec3 cell) const;

    const ParetoFlow* flow_;
    std::vector<glm::vec4> reference_;
};

/// |u - truth|_2 / |truth - mean|_2
[[nodiscard]] double flow_error(const ParetoFlow& flow, std::span<const glm::vec4> u, std::span<const glm::dvec3> truth);

} // namespace windrow::cli
