// Deposits of drag: what stands in the air and slows it, but is too fine for cells to hold as a body.
//
//     const windrow::PlantDrag bush{.position = {4.0, 0.0, 2.0}, .radius = 1.5f, .height = 2.0f, .area = 3.0f};
//     const windrow::BeltDrag hedge{.start = {-10.0, 0.0, 6.0}, .end = {10.0, 0.0, 6.0}, .height = 3.0f, .resistance = 2.0f};
//
// Within a deposit du/dt = -c |u| u with c [1/m] = C_d a: drag coefficient times frontal area in a volume of air. Its drag area, the
// sum of c over its volume, is spread evenly: over a box along the axes for a plant, over a strip for a belt.
// Based on: Wilson 1985, Journal of Wind Engineering and Industrial Aerodynamics 21 (windbreaks as a momentum sink).
#pragma once

#include "api.h"
#include "result.h"
#include "setting.h"

#include <glm/vec3.hpp>
#include <tuple>
#include <variant>

namespace windrow {

/// A plant, or anything porous that a box along the axes surrounds: a bush, a crown, a net, a scaffold.
struct PlantDrag {
    static constexpr const char* k_name = "plant";
    static constexpr const char* k_meaning = "A plant: a bush, the crown of a tree, a net.";
    /// [m] Each component -1e12 to 1e12, default (0, 0, 0). Its foot.
    glm::dvec3 position{0.0};
    /// [m] A number above 0, at most 10000, default 1. Half of its width along x and z. Below one cell its drag is spread over
    /// two cells.
    float radius = 1.0f;
    /// [m] 0 to 10000, default 0. Height of its lowest leaves over its foot, below `height`: 0 for a bush, the bare stem of a
    /// tree.
    float base = 0.0f;
    /// [m] A number above 0, at most 10000, default 2. Height of its top over its foot.
    float height = 2.0f;
    /// [m^2] 0 (none) to 1e6, default 2. Drag area: drag coefficient times frontal area, of all leaves and twigs together. The
    /// default is half of the default's front of 4 m^2.
    float area = 2.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("position", &PlantDrag::position, k_world_range, "Its foot."),
            Setting("radius", &PlantDrag::radius, Range::above(0.0, 1e4, "m"),
                    "Half of its width along x and z. Below one cell its drag is spread over two cells."),
            Setting("base", &PlantDrag::base, {0.0, 1e4, "m"},
                    "Height of its lowest leaves over its foot, below `height`: 0 for a bush, the bare stem of a tree."),
            Setting("height", &PlantDrag::height, Range::above(0.0, 1e4, "m"), "Height of its top over its foot."),
            Setting(
                "area", &PlantDrag::area, {.min = 0.0, .max = 1e6, .unit = "m^2", .zero = "none"},
                "Drag area: drag coefficient times frontal area, of all leaves and twigs together. The default is half of the "
                "default's front of 4 m^2."),
        };
    }
};

/// A hedge, a row of trees, a fence, a net: a strip between two places.
struct BeltDrag {
    static constexpr const char* k_name = "belt";
    static constexpr const char* k_meaning = "A strip: a hedge, a row of trees, a fence.";
    /// [m] Each component -1e12 to 1e12, default (-5, 0, 0). Its foot at one end.
    glm::dvec3 start{-5.0, 0.0, 0.0};
    /// [m] Each component -1e12 to 1e12, default (5, 0, 0). Its foot at the other end, 1 mm to 1e4 m away along x and z. Between
    /// them the foot rises evenly.
    glm::dvec3 end{5.0, 0.0, 0.0};
    /// [m] A number above 0, at most 10000, default 2. Thickness, across its length. Below two cells its drag is spread over two
    /// cells.
    float width = 2.0f;
    /// [m] A number above 0, at most 10000, default 2. Height over its foot.
    float height = 2.0f;
    /// 0 (none) to 10000, default 2. Sum of c across its thickness, half of the pressure loss coefficient of a screen: 2 is a
    /// fence that is half open (Wilson 1985).
    float resistance = 2.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("start", &BeltDrag::start, k_world_range, "Its foot at one end."),
            Setting("end", &BeltDrag::end, k_world_range,
                    "Its foot at the other end, 1 mm to 1e4 m away along x and z. Between them the foot rises evenly."),
            Setting("width", &BeltDrag::width, Range::above(0.0, 1e4, "m"),
                    "Thickness, across its length. Below two cells its drag is spread over two cells."),
            Setting("height", &BeltDrag::height, Range::above(0.0, 1e4, "m"), "Height over its foot."),
            Setting("resistance", &BeltDrag::resistance, {.min = 0.0, .max = 1e4, .zero = "none"},
                    "Sum of c across its thickness, half of the pressure loss coefficient of a screen: 2 is a fence that is half "
                    "open (Wilson 1985)."),
        };
    }
};

using DragDeposit = std::variant<PlantDrag, BeltDrag>;

/// All reasons why a deposit is invalid, one per line.
[[nodiscard]] WINDROW_API Result<void> validate(const DragDeposit& deposit);
/// [m] Its foot; of a belt, at its first end.
[[nodiscard]] WINDROW_API glm::dvec3 position_of(const DragDeposit& deposit);
namespace detail {
class Reasons;
struct FieldPath;
} // namespace detail
WINDROW_API void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const PlantDrag& plant);
WINDROW_API void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const BeltDrag& belt);

/// What the air does to a deposit: density of air, k_air_density, times the sum over the cells of its drag area there times |u| u.
struct DragForce {
    glm::vec3 force{0.0f}; ///< [N]
    float in_box = 0.0f;   ///< fraction of its drag area that the force is of: the rest is outside of the cells that are read
};

} // namespace windrow
