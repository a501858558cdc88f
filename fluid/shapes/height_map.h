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

/// Heights [m] at the corners, x fastest, and how far apart they are [m].
struct HeightData {
    glm::ivec2 corners{0};
    float spacing = 1.0f;
    std::vector<float> heights{};
    friend bool operator==(const HeightData&, const HeightData&) = default;
};

class WINDROW_API HeightMap {
  public:
    using Data = HeightData;

    static constexpr int k_max_corners = 16384; ///< along an axis: 1 GiB of heights
    static constexpr float k_highest = 1e5f;    ///< [m] beyond it, a float of a height is coarser than a blade is long

    /// `heights` [m] at the corners, x fastest: corners.x * corners.y of them, each within +-1e5. Rejects fewer than 2 corners or
    /// more than 16384 along an axis, a spacing [m] that is not 1e-3 to 1e3, another number of heights, and heights that are no
    /// numbers or larger.
    [[nodiscard]] static Result<HeightMap> create(glm::ivec2 corners, float spacing, std::vector<float> heights);
    /// The same from a function of the place [m].
    [[nodiscard]] static Result<HeightMap> create(glm::ivec2 corners, float spacing,
                                                  const std::function<float(glm::vec2 place)>& height);
    /// The same, to be shared. Rejects memory that is short too.
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
    [[nodiscard]] numerics::WindrowGrid grid() const { return {data_.corners, glm::vec2(data_.spacing)}; }
    [[nodiscard]] std::span<const float> heights() const { return data_.heights; }
    [[nodiscard]] const HeightData& data() const { return data_; }

    [[nodiscard]] std::size_t memory_bytes() const { return sizeof(*this) + data_.heights.capacity() * sizeof(float); }
    /// By what they hold, not by where they are in memory.
    friend bool operator==(const HeightMap& a, const HeightMap& b) { return (a <=> b) == 0; }
    friend std::strong_ordering operator<=>(const HeightMap& a, const HeightMap& b);

  private:
    explicit HeightMap(HeightData data);
    [[nodiscard]] numerics::GridView view() const { return {data_.heights.data()}; }

    HeightData data_;
    std::uint64_t hash_; ///< of the heights
};

} // namespace windrow
