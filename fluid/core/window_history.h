// Position of the box, now and in the last two steps.
#pragma once

#include "fluid/api.h"
#include "fluid/view.h"
#include "fluid/wind.h"
#include "fluid/window.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <utility>

namespace windrow {

namespace detail {
[[nodiscard]] inline bool can_follow(const Boundaries& boundaries, int axis) {
    return !boundaries.periodic(axis) && !boundaries.has_solid(axis);
}
/// Those asked for; else all that can.
[[nodiscard]] inline glm::bvec3 axes_that_follow(const Config& config, const Boundaries& boundaries) {
    return config.follow_axes.value_or(
        glm::bvec3(can_follow(boundaries, 0), can_follow(boundaries, 1) && !config.rows, can_follow(boundaries, 2)));
}
/// Origin, in rows, of a box whose low y face is at a height [m], to whole rows.
[[nodiscard]] inline std::int64_t floor_row(const Window& window, double height) {
    return static_cast<std::int64_t>(std::floor(height / window.units().y + 0.5));
}
/// The box of a valid config.
[[nodiscard]] WINDROW_INTERNAL Box box_of(const Config& config);
} // namespace detail

/// Position of a box, and the point that it follows.
/// The world's origin has moved: every place in it moves by the same way.
struct OriginShift {
    CellIndex cells{0};
    glm::dvec3 offset{0.0}; ///< [m] as `cells`

    void move(glm::dvec3& place) const { place += offset; }
    void move(Window& window) const {
        window.origin_cells += cells;
        window.shifted += cells;
    }
    /// A whole period of the gusts leaves their phase as it was, to the bit.
    [[nodiscard]] glm::dvec3 moved_phase(glm::dvec3 phase, double period) const {
        return {phase.x + std::remainder(offset.x, period), phase.y, phase.z + std::remainder(offset.z, period)};
    }
    void move(AmbientWind& wind) const {
        (void)wind.set_ground(wind.ground() + offset.y); // within the range: the box is
        wind.set_phase(moved_phase(wind.phase(), wind.period()));
    }
};

struct BoxPlace {
    glm::dvec3 point{0.0}; ///< [m] to whole cells
    CellIndex origin_cells{0};
};

struct WindowHistory {
    /// `rows` of the box outlive it; null: it has none of its own.
    explicit WindowHistory(const Config& config, const RowTable* rows = nullptr)
        : window{config.cells, config.cell_size, {}, rows}, point(config.centre),
          follow_axes(detail::axes_that_follow(config, config.boundaries)) {
        if (config.boundaries.y_low.solid()) // it stands on the floor, whatever the centre's height
            point.y = config.floor + 0.5 * window.size().y;
        window.origin_cells = window.centred_on(point);
        if (config.boundaries.y_low.solid())
            window.origin_cells.y = detail::floor_row(window, config.floor);
        previous = stepped = {point, window.origin_cells};
    }

    Window window;
    glm::dvec3 point{0.0}; ///< [m] what the box is centred on, to whole cells
    BoxPlace stepped;      ///< in the last step
    BoxPlace previous;     ///< in the step before that
    glm::bvec3 follow_axes;

    void shift_origin(const OriginShift& shift) {
        shift.move(window);
        shift.move(point);
        for (BoxPlace* const place : {&stepped, &previous}) {
            shift.move(place->point);
            place->origin_cells += shift.cells;
        }
    }
    void note_step() { previous = std::exchange(stepped, {point, window.origin_cells}); }
    /// Position of the box around a point: it keeps its place on axes that do not follow.
    [[nodiscard]] CellIndex around(glm::dvec3 centre) const {
        CellIndex origin = window.centred_on(centre);
        for (int axis = 0; axis < 3; ++axis)
            if (!follow_axes[axis])
                origin[axis] = window.origin_cells[axis];
        return origin;
    }
    /// A shift after which no cell is one that was in the box.
    [[nodiscard]] bool leaves(CellIndex shift) const {
        if (window.rows != nullptr) // along y the steps are those of its lowest rows
            return std::abs(static_cast<double>(shift.y)) * window.units().y >= window.size().y ||
                   glm::any(glm::greaterThanEqual(glm::abs(CellIndex(shift.x, 0, shift.z)), CellIndex(window.cells)));
        return glm::any(glm::greaterThanEqual(glm::abs(shift), CellIndex(window.cells)));
    }
    /// The blend zone of `width` [cells] about a point, which ends `inset` cells before the box. A width of nearly nothing, over which
    /// no quotient is finite, is a millionth of a cell.
    [[nodiscard]] BlendZone blend_zone(glm::dvec3 about, float width, float inset) const {
        BlendZone zone{.point = about, .reach = glm::vec3(0.0f), .width = width > 0.0f ? std::max(width, 1e-6f) : 0.0f};
        for (int axis = 0; axis < 3; ++axis) {
            const float reach = 0.5f * static_cast<float>(window.cells[axis]) - inset;
            if (width > 0.0f && follow_axes[axis] && reach >= width + 1.0f)
                zone.reach[axis] = reach;
        }
        return zone;
    }
};

} // namespace windrow
