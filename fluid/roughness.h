// Rough ground: the drag of what covers it, and the mixing by turbulence that hands it on to the air above.
//
//     auto wind = windrow::Wind::create({.boundaries = windrow::Boundaries::open_over_floor(), .ambient = {8.0f, 0.0f, 0.0f},
//                                        .profile = windrow::LogProfile{}, .roughness = windrow::Roughness{.length = 0.1f}});
#pragma once

#include "api.h"
#include "result.h"
#include "setting.h"
#include "shapes/height_map.h"

#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <tuple>

namespace windrow {

/// Roughness lengths by place: water here, a wood there. Beyond its edge the lengths of the edge go on.
struct RoughnessMap {
    std::shared_ptr<const HeightMap> lengths{}; ///< [m] where a height map has heights; null is rejected
    /// [m] Each component -1e12 to 1e12, default (0, 0, 0). World place of its first pixel; y does not count.
    glm::dvec3 position{0.0};
    /// Each component 1e-6 to 100000, default (1, 1, 1). Factor on its size along x and z, the metres of a pixel, and, y, on the
    /// lengths.
    glm::vec3 scale{1.0f};

    static constexpr auto settings() {
        return std::tuple{
            Setting("file", &RoughnessMap::lengths,
                    "Picture of 8 or 16 bits beside the scene, PGM, PNG or a raw square of 16 bits: a pixel a metre, black is 0 "
                    "m, white 1 m, rows along z. A "
                    "TIFF of floats or an ASCII grid (.asc) has metres. Lengths below 1e-6 m are 1e-6 m."),
            Setting("position", &RoughnessMap::position, k_world_range, "World place of its first pixel; y does not count."),
            Setting("scale", &RoughnessMap::scale, {1e-6, 1e5},
                    "Factor on its size along x and z, the metres of a pixel, and, y, on the lengths."),
        };
    }
};

/// Rough ground. The floor, grounds and the tops of obstacles slow the air by the law of the wall, with the stress
/// (kappa |u| / log(1 + z / z0))^2 for a wind u at the height z above them. The columns of air above are mixed by eddies as large as
/// their height allows. A log profile of the same roughness is in balance with it. The ambient wind has its own: a rougher or a
/// smoother ground changes the wind, an equal one leaves it as it is, gusts too. No-slip surfaces have viscosity instead, and bodies
/// that move are smooth. A box that is periodic along y has no floor. The flow of volume sources feels no
/// stress itself. One pass a step.
struct Roughness {
    /// [m] 1e-6 to 100, default 0.03. Roughness length z0: about a tenth of the height of what is on the ground. 0.0002 water,
    /// 0.03 short grass, 0.1 crops, 0.3 bushes, 1 wood.
    float length = 0.03f;
    /// [m] 0 (no limit) to 100000, default 0. Longest mixing length. Over open ground eddies grow with the height; among
    /// buildings, which the grid resolves, about a twentieth of their height leaves the wakes unsteady.
    float longest_mixing = 0.0f;
    /// Lengths by place, instead of one. Default none.
    std::optional<RoughnessMap> map{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("length", &Roughness::length, {1e-6, 100.0, "m"},
                    "Roughness length z0: about a tenth of the height of what is on the ground. 0.0002 water, 0.03 short grass, "
                    "0.1 crops, 0.3 bushes, 1 wood."),
            Setting("longest_mixing", &Roughness::longest_mixing, {.min = 0.0, .max = 1e5, .unit = "m", .zero = "no limit"},
                    "Longest mixing length. Over open ground eddies grow with the height; among buildings, which the grid "
                    "resolves, about a twentieth of their height leaves the wakes unsteady."),
            Setting("map", &Roughness::map, "Lengths by place, instead of one. Default none."),
        };
    }
};

/// All reasons why it is invalid, one per line.
[[nodiscard]] WINDROW_API Result<void> validate(const Roughness& roughness);
namespace detail {
class Reasons;
struct FieldPath;
} // namespace detail
WINDROW_API void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const RoughnessMap& map);

} // namespace windrow
