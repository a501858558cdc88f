// A scalar that the wind of a box carries along: smoke, dust, a dye. It does not act on the air.
//
//     auto smoke = windrow::Tracer::create(wind->view());
//     wind->step(dt);
//     smoke->step(wind->view(), wind->obstacles().in_reach(), dt);
//     smoke->blow({0.0, 1.0, 0.0}, 0.5f);                       // 1 within half a metre of a chimney
//     std::span<const float> density = smoke->cells();          // laid out as box.h says
//
// Values are at cell centres. Third order in space, first in time: the wind after a step carries the scalar through it. What leaves
// through an open boundary is lost, and nothing enters there. It moves with the box of the wind.
#pragma once

#include "api.h"
#include "operators.h"
#include "parallel.h"
#include "result.h"
#include "view.h"

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

namespace windrow {

class WINDROW_API Tracer {
  public:
    /// All 0, in the box of a wind.
    [[nodiscard]] static Result<Tracer> create(const WindView& air, const ParallelFor& parallel_for = {});

    /// Carries it through a step of dt [s], with the wind after it; `obstacles` are those of the same step. A dt that is not above 0
    /// carries nothing. Rejects a wind with another number of cells. Without memory it is not carried.
    Result<void> step(const WindView& air, std::span<const PlacedObstacle> obstacles, double dt);
    /// Raises cells to 1 within `radius` [m] of a world point, less within a cell beyond it, and leaves those that hold more. Of the
    /// obstacles of the last step none is in between: cells that open faces within that reach do not join to the point's own stay
    /// as they are. A point inside an obstacle has no side: all are raised.
    void blow(glm::dvec3 point, float radius);

    /// 0 to 1.
    [[nodiscard]] std::span<const float> cells() const { return cells_; }

    /// All of it as bytes, to go on with the wind of the same moment (Wind::save).
    [[nodiscard]] Result<std::vector<std::byte>> save() const;
    /// Goes on to the bit as the one that was saved. `air` and `obstacles` are those of its last step. Rejects bytes that `save` did
    /// not return, and a wind with other cells.
    [[nodiscard]] static Result<Tracer> load(std::span<const std::byte> bytes, const WindView& air,
                                             std::span<const PlacedObstacle> obstacles, const ParallelFor& parallel_for = {});

  private:
    Tracer(const WindView& air, Workspace work);
    void move_to(const Window& window);

    Workspace work_;
    Window window_;
    std::vector<float> cells_, carried_;
    std::vector<std::uint8_t> joined_; ///< scratch of blow: one a cell
};

} // namespace windrow
