// The ground of a scene's picture: heights from a picture, random hills, or level. Plants and feet stand on it, and where `in_air`
// says so, the air flows over it.
#pragma once

#include "fluid/setting.h"
#include "fluid/shapes/height_map.h"
#include "scene/json_object.h"

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <tuple>

namespace windrow::scene {

/// Rolling ground by chance: the place noise of shaders/numerics in three octaves.
struct Hills {
    double height = 0.0;
    double length = 80.0;
    std::uint32_t seed = 0;

    static constexpr auto settings() {
        return std::tuple{
            Setting("height", &Hills::height, {0.0, 1e4, "m", "level"}, "From the lowest possible place to the highest."),
            Setting("length", &Hills::length, {1.0, 1e5, "m"},
                    "Cell size of the largest octave, about half of the distance between two hilltops."),
            Setting("seed", &Hills::seed, k_seed_range, "Another number, other hills, of 64 kinds."),
        };
    }

    /// [m] At a place from the ground's corner, 0 to `height`.
    [[nodiscard]] float at(glm::vec2 place) const;
};

struct GroundSource {
    std::string file{};
    Hills hills{};
    double low = 0.0;
    double high = 100.0;
    glm::dvec3 corner{-50.0, 0.0, -50.0};
    glm::dvec2 extent{100.0};
    bool in_air = false;
    std::shared_ptr<const HeightMap> heights{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("heights", &GroundSource::file,
                    "Binary PGM of 8 or 16 bits in the scene's folder, named relative to it, first row at the lowest z; at most "
                    "4097 pixels a side, which the extent must make square. Default: level at low."),
            Setting("hills", &GroundSource::hills, "Rolling random ground, upon the heights or upon low."),
            Setting("low", &GroundSource::low, {-1e5, 1e5, "m"}, "Height of black."),
            Setting("high", &GroundSource::high, {-1e5, 1e5, "m"}, "Height of white, above low."),
            Setting("corner", &GroundSource::corner, {-1e9, 1e9, "m"},
                    "Place of the first sample; its y is added to all heights."),
            Setting("extent", &GroundSource::extent, {0.01, 1e5, "m"},
                    "Along x and z. Without heights: in a ratio of whole numbers."),
            Setting("in_air", &GroundSource::in_air,
                    "Whether the air flows over it, as over an obstacle of the shape ground. The box's floor is below it then."),
            Setting("heights", &GroundSource::heights,
                    "The resulting heights, above corner.y. Always there in a scene that was read.", k_not_stored),
        };
    }

    /// [m] In the world, on the triangles that are drawn; beyond the rim that of the rim.
    [[nodiscard]] double height(double x, double z) const;
};

/// Reads a whole object and the file that it names in `folder`, the scene's. Where that is rejected the ground is level, so that
/// what stands on it can be read and judged.
void read_ground(JsonObject object, GroundSource& ground, const std::filesystem::path& folder);

} // namespace windrow::scene
