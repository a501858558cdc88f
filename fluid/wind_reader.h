// What a host reads of a wind, the same on the CPU (wind.h) and on a device (vulkan/wind.h): code that takes a WindReader serves
// both.
//
// On the CPU it is the wind of this frame with `advance`, of the last step with `step`. On a device it is what was read back
// last, some frames ago; a call that needs cells which are not there returns an error that says what to set. Nothing is ever
// zero because a backend lacks it.
#pragma once

#include "ambient.h"
#include "api.h"
#include "diagnostics.h"
#include "drag_field.h"
#include "obstacle_force.h"
#include "obstacles.h"
#include "result.h"
#include "textures.h"
#include "view.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

namespace windrow {

class WINDROW_API WindReader {
  public:
    virtual ~WindReader();

    /// Cells to sample on the CPU, with `velocity`, `felt` and textures; of this frame, and of the frame before for motion
    /// vectors. Valid until the next change of the wind, or recording. On a device: with vulkan::Settings::queries of cells or
    /// box, once a frame has come back; the frame before is in its textures alone. (Wind::view returns it without the Result.)
    [[nodiscard]] Result<WindView> view() const { return read_view(); }
    [[nodiscard]] Result<WindView> previous_view() const { return read_previous_view(); }
    /// [m/s] The air's own cells, laid out as box.h says; w as WindView::field has it.
    [[nodiscard]] Result<std::span<const glm::vec4>> cells() const;
    /// [m/s] Wind at a world point: trilinear between cell centres, beside surfaces as view.h says, as a vertex stage samples the textures; it fades to ambient
    /// over the blend zone (view.h). Where no cells can be read, the ambient wind. A point that is not finite gets the mean wind.
    [[nodiscard]] virtual glm::vec3 velocity(glm::dvec3 position) const = 0;
    /// The same for many points; `velocities` holds as many.
    void velocity(std::span<const glm::dvec3> positions, std::span<glm::vec3> velocities) const;
    /// The ambient wind around the box, of this frame.
    [[nodiscard]] virtual const AmbientWind& ambient_wind() const = 0;

    /// Position of the textures relative to `anchor` [m] (one that is not finite counts as 0), now and in the frame before.
    [[nodiscard]] virtual WindowBlock window_block(glm::dvec3 anchor) const = 0;
    /// The same with the ambient wind: all inputs of shaders/coupling/windrow_wind.glsl beside the textures.
    [[nodiscard]] virtual FrameBlock frame_block(glm::dvec3 anchor, const Sampling& sampling = {}) const = 0;

    /// 1 for each cell whose centre is inside an obstacle, else 0; box().cell_count() values or the call is rejected. Of the last
    /// step; of now where the last step placed none, and on a device (see there). A plate has no inside. Where set_floor has moved a
    /// box with rows of its own, 0 until the next step.
    virtual Result<void> write_obstacles(std::span<float> cells) const = 0;
    /// [m^2/s^2] Pressure over the air's density (1.2 kg/m^3) at the end of the last step, relative to that outside of the box, or
    /// to its mean where no boundary is open; box().cell_count() values or the call is rejected. 0 in still air, before the first
    /// step and with Scheme::stable_fluids. Without that of volume sources. Solves once, in the scratch of the step: no other call
    /// may read this wind meanwhile. Allocates a field. A device rejects it.
    virtual Result<void> write_pressure(std::span<float> cells) = 0;
    /// What the air did to an obstacle in the last step or tick; rejects a stale handle. 0 before the first step, while the air
    /// sleeps, and for an obstacle outside of the box (ObstacleForce::in_box). On a device with vulkan::Settings::forces.
    [[nodiscard]] virtual Result<ObstacleForce> force_on(ObstacleId id) const = 0;
    /// What the air does to a deposit of drag, of the cells as they are after the last step or tick; rejects a stale handle. On a device
    /// of those that were read back last, with vulkan::Settings::queries of cells.
    [[nodiscard]] virtual Result<DragForce> force_on(DragId id) const = 0;
    /// Report of the last step or tick; on a device of the last one that was read back. stepped = false before the first.
    [[nodiscard]] virtual Diagnostics diagnostics() const = 0;
    /// Bytes that the wind has allocated: on a device, of its memory.
    [[nodiscard]] virtual std::uint64_t memory_bytes() const = 0;

  protected:
    WindReader() = default;
    WindReader(const WindReader&) = default;
    WindReader& operator=(const WindReader&) = default;

  private:
    [[nodiscard]] virtual Result<WindView> read_view() const = 0;
    [[nodiscard]] virtual Result<WindView> read_previous_view() const = 0;
};

} // namespace windrow
