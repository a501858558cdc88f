// A grid of heights: the ground that the air flows over and that plants stand on.
//
//     auto hills = windrow::HeightMap::create({501, 501}, 1.0f, heights);  // 500 m x 500 m
//     if (!hills)
//         return std::fprintf(stderr, "%s\n", hills.error().c_str()), 1;
//     const float y = hills->height({12.5f, 80.0f});                       // [m] between the corners
//     (void)wind.obstacles().add({.shape = windrow::Ground{std::make_shared<const windrow::HeightMap>(*hills)}});
//
// Places are [m] along x and z from the grid's first corner; beyond the edge the ground goes on as on it. The formulas, for C++ and
// shaders: shaders/numerics/height_grid.glsl.
#pragma once

#include "../api.h"
#include "../height_grid.h"
#include "../result.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace windrow {

/// Where a map has no ground, to any depth: the openings of tunnels and cellars. A grid that covers the map whole, however many cells it
/// has; x fastest. An obstacle of the map has these holes; a height is found in one too, and lengths by place have none.
struct HoleMask {
    glm::ivec2 cells{0};              ///< none: no hole
    std::vector<std::uint8_t> open{}; ///< other than 0: a hole
    friend bool operator==(const HoleMask&, const HoleMask&) = default;
};

/// Heights [m] at the corners, x fastest, and how far apart they are [m].
struct HeightData {
    glm::ivec2 corners{0};
    float spacing = 1.0f;
    std::vector<float> heights{};
    HoleMask holes{};
    friend bool operator==(const HeightData&, const HeightData&) = default;
};

class WINDROW_API HeightMap {
  public:
    using Data = HeightData;

    static constexpr int k_max_corners = 16384; ///< along an axis: 1 GiB of heights
    static constexpr float k_highest = 1e5f;    ///< [m] beyond it, a float of a height is coarser than a blade is long
    static constexpr int k_max_parts = 256;     ///< of its ground, and of its holes: each place is compared with them

    /// `heights` [m] at the corners, x fastest: corners.x * corners.y of them, each within +-1e5. Rejects fewer than 2 corners or
    /// more than 16384 along an axis, a spacing [m] that is not 1e-3 to 1e3, another number of heights, and heights that are no
    /// numbers or larger.
    [[nodiscard]] static Result<HeightMap> create(glm::ivec2 corners, float spacing, std::vector<float> heights);
    /// The same from a function of the place [m].
    [[nodiscard]] static Result<HeightMap> create(glm::ivec2 corners, float spacing,
                                                  const std::function<float(glm::vec2 place)>& height);
    /// The same, to be shared, with holes. Rejects memory that is short too, a mask of more than 16384 cells along an axis or of another
    /// number of values, one without ground, and one whose holes cut it into more than k_max_parts rectangles.
    [[nodiscard]] static Result<std::shared_ptr<const HeightMap>> create(HeightData data);

    /// Level ground at height 0: 100 m x 100 m, a corner a metre.
    [[nodiscard]] static HeightMap level();

    [[nodiscard]] float height(glm::vec2 place) const;
    /// [m] On the two triangles of a texel that a renderer draws: at most a quarter of the texel's twist away from `height`.
    [[nodiscard]] float drawn_height(glm::vec2 place) const;
    /// Unit vector, continuous over the whole ground.
    [[nodiscard]] glm::vec3 normal(glm::vec2 place) const;
    /// [m] Lowest and highest within a box of places: of the bilinear surface, corners outside of the box included.
    [[nodiscard]] glm::vec2 range(glm::vec2 low, glm::vec2 high) const;

    /// [m] How far it reaches along x and z.
    [[nodiscard]] glm::vec2 extent() const { return glm::vec2(data_.corners - 1) * data_.spacing; }
    /// A rectangle of it [m].
    struct Part {
        glm::vec2 low{0.0f}, high{0.0f};
    };
    /// Rectangles that together are the ground, and those that together are its holes. Without holes one, and none.
    [[nodiscard]] std::span<const Part> parts() const { return parts_.ground; }
    [[nodiscard]] std::span<const Part> holes() const { return parts_.holes; }
    [[nodiscard]] numerics::WindrowGrid grid() const { return {data_.corners, glm::vec2(data_.spacing)}; }
    [[nodiscard]] std::span<const float> heights() const { return data_.heights; }
    [[nodiscard]] const HeightData& data() const { return data_; }

    [[nodiscard]] std::size_t memory_bytes() const {
        return sizeof(*this) + data_.heights.capacity() * sizeof(float) + data_.holes.open.capacity() +
               (parts_.ground.capacity() + parts_.holes.capacity()) * sizeof(Part);
    }
    /// By what they hold, not by where they are in memory.
    friend bool operator==(const HeightMap& a, const HeightMap& b) { return (a <=> b) == 0; }
    friend std::strong_ordering operator<=>(const HeightMap& a, const HeightMap& b);

  private:
    struct Parts {
        std::vector<Part> ground{}, holes{};
    };
    HeightMap(HeightData data, Parts parts);
    [[nodiscard]] static Result<Parts> parts_of(const HeightData& data);
    [[nodiscard]] numerics::GridView view() const { return {data_.heights.data()}; }

    HeightData data_;
    Parts parts_;
    std::uint64_t hash_; ///< of the heights
};

} // namespace windrow
