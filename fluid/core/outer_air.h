// What is around the box of a wind on a device, where that is another wind: D and p of its padded cells, as the CPU's cells have
// them (fluid/cpu/outer_wind.h). The host makes them from the outer wind, and the device takes them.
#pragma once

#include "fluid/api.h"
#include "fluid/box.h"
#include "fluid/parallel.h"
#include "fluid/window.h"

#include <glm/vec4.hpp>
#include <memory>
#include <span>

namespace windrow {

class Wind;

class OuterAir {
  public:
    virtual ~OuterAir() = default;
    /// What it holds becomes the outer wind of now, in a window.
    virtual void renew(const Window& window, const ParallelFor& parallel_for) = 0;
    /// The box has moved: cells that stay keep their values.
    virtual void move_to(const Window& window, const ParallelFor& parallel_for) = 0;
    /// Whether it holds values in that window.
    [[nodiscard]] virtual bool holds(const Window& window) const = 0;
    /// A step begins, which goes `way` of the way to the outer wind of now; it ends.
    virtual void begin_step(const Window& window, float way, const ParallelFor& parallel_for) = 0;
    virtual void end_step() = 0;
    /// D [m/s] and p [m^2/s^2] of now, and the box that they are of.
    [[nodiscard]] virtual std::span<const glm::vec4> values() const = 0;
    [[nodiscard]] virtual CellIndex origin() const = 0;
    /// Those that the step ends with, from begin_step to end_step.
    [[nodiscard]] virtual std::span<const glm::vec4> values_at_end() const = 0;
    virtual void restore(std::span<const float> values, CellIndex origin) = 0;
    virtual void shift_origin(CellIndex by) = 0;
};

/// Of a box inside the cells of `outer`, which outlives it and keeps its pressure from now on. Throws std::bad_alloc.
[[nodiscard]] WINDROW_INTERNAL std::unique_ptr<OuterAir> outer_air_of(const Box& box, const Wind& outer);

/// Where no wind comes to be inside it, an outer wind keeps no pressure, as before.
class WINDROW_INTERNAL OuterUndo {
  public:
    explicit OuterUndo(std::shared_ptr<const Wind> outer);
    OuterUndo(const OuterUndo&) = delete;
    OuterUndo& operator=(const OuterUndo&) = delete;
    ~OuterUndo();
    void succeed() { outer_.reset(); }

  private:
    std::shared_ptr<const Wind> outer_; ///< null: nothing is to be undone
};

} // namespace windrow
