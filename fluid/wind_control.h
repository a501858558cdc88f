// What a host sets of a wind, the same on the CPU (wind.h) and on a device (vulkan/wind.h): code that takes a WindControl serves
// both.
//
//     void open_window(windrow::WindControl& wind) {
//         (void)wind.set_ambient({6.0f, 0.0f, 0.0f});
//         (void)wind.motors().add(windrow::JetMotor{...});
//     }
//
// Time is not here: a wind on the CPU steps at once (Wind::advance), one on a device is recorded (vulkan::Wind::record).
#pragma once

#include "api.h"
#include "box.h"
#include "config.h"
#include "drag_field.h"
#include "motors.h"
#include "obstacles.h"
#include "result.h"

#include <cassert>
#include <functional>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <utility>

namespace windrow {

class EventLog;
class Wind;
class WindCore;

class WINDROW_API WindControl {
  public:
    // --- Motors, obstacles, drag, ambient wind, boundaries: without memory each call fails and the wind is unchanged --------
    [[nodiscard]] Motors& motors();
    [[nodiscard]] const Motors& motors() const;
    /// Bodies and buildings that the air flows around.
    [[nodiscard]] Obstacles& obstacles();
    [[nodiscard]] const Obstacles& obstacles() const;
    /// Plants, hedges, fences and nets that slow the air.
    [[nodiscard]] DragField& drag();
    [[nodiscard]] const DragField& drag() const;
    /// Changes the mean wind [m/s]. All air of the box changes by the difference at once, as under a pressure gradient that is
    /// far wider than the box; entering through the boundaries alone, a new wind would never reach still air. Ramp it for a gust.
    /// Components along axes that a wall closes are dropped. Rejects what is not finite or above 1e4 m/s.
    [[nodiscard]] Result<void> set_ambient(glm::vec3 ambient);
    [[nodiscard]] glm::vec3 ambient() const;
    /// Changes the gusts; the air of the box changes with them at once, so ramp the intensity. Rejects what `validate` rejects.
    /// Allocates when gusts begin. On a device, gusts that begin after a wind without any need vulkan::Settings::gusts.
    [[nodiscard]] Result<void> set_gusts(const Gusts& gusts);
    /// Changes kinds or wall velocities between steps. A changed kind starts the second-order history again. Rejects what
    /// `validate` rejects and a wall across an axis that follows.
    [[nodiscard]] Result<void> set_boundaries(const Boundaries& boundaries);

    // --- Position of the box ------------------------------------------------------------------------------------------
    /// Centres the box on a point, to whole cells, on the axes that follow. Air that stays inside keeps its values to the bit;
    /// new cells hold the ambient wind. A jump beyond the box starts afresh. Rejects a point that is not finite or beyond 1e12
    /// cells. With ticks the box moves in its ticks, with single steps at once.
    Result<void> follow(glm::dvec3 point);
    /// Sets the height [m] of the ground, the box's low y face, to whole cells: Config::floor from now on. For boxes with a wall
    /// there.
    Result<void> set_floor(double height);
    /// The origin of the host's world has moved: every place that the wind holds moves by `offset` [m], which the host adds to all its
    /// own: the box, what it follows, the ground, motors with their paths, obstacles, gusts, frames shown. No air changes, and no box
    /// is left behind, as a jump by `follow` would. Call it between frames. Rejects what is no whole number of cells (along y of lowest
    /// rows). Gusts keep their bits where their period (AmbientWind::period) divides the way, else they go on to rounding.
    Result<void> shift_origin(glm::dvec3 offset);
    /// [m] World position of the box's low corner.
    [[nodiscard]] glm::dvec3 origin() const;
    [[nodiscard]] const Box& box() const;

    // --- Setting the air ----------------------------------------------------------------------------------------------
    /// Sets every cell from a function of its centre's world position; the second-order history starts again, and with ticks
    /// the next frame shows these cells alone, not blended with what was before. Values that are not finite are caught by the
    /// next step. The function may read the wind, and sees it as it was; where it throws, nothing has changed. On a device the cells travel inside the next recording's command buffer; without memory for them it fails.
    Result<void> set_velocity(const std::function<glm::vec3(glm::dvec3 centre)>& velocity_at);
    /// The same from an array laid out as box.h says; rejects another size.
    Result<void> set_velocity(std::span<const glm::vec4> field);
    /// Sets all cells and the history to the ambient wind, as after creation.
    void reset();
    /// Adds every accepted call that changes the wind to `log` from now on; null: no longer. See event_log.h. On a device the log
    /// also has what the host decided for each tick by what was read back (TickRecorded).
    void record_to(EventLog* log);

    /// As it is now: calls above change it.
    [[nodiscard]] const Config& config() const;
    /// The wind around the box, on the CPU; null: none, the ambient wind is around it.
    [[nodiscard]] const std::shared_ptr<const Wind>& outer() const;

  protected:
    explicit WindControl(WindCore& core) : core_(&core) {}
    /// Another name of the same wind.
    WindControl(const WindControl&) = default;
    WindControl& operator=(const WindControl&) = default;
    WindControl(WindControl&& other) noexcept : core_(std::exchange(other.core_, nullptr)) {}
    WindControl& operator=(WindControl&& other) noexcept {
        core_ = std::exchange(other.core_, nullptr);
        return *this;
    }
    ~WindControl() = default;

  private:
    [[nodiscard]] WindCore& core() const {
        assert(core_ != nullptr && "the wind was moved from: only assign to it or destroy it");
        return *core_;
    }
    WindCore* core_;
};

} // namespace windrow
