// Strands on a plane of four vertices: each leans by the wind at its own place, and away from a foot.
#include "coupling/plant_numerics.h"
#include "fluid/ambient.h"
#include "tests/figure.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <optional>

namespace windrow {
namespace {

using namespace numerics;

// A plane of 4 m whose strands are 0.1 m long, at 256 texels a metre; the wind gusts over it.
constexpr double k_texels = 256.0;
constexpr float k_length = 0.1f;

class Plane {
  public:
    Plane() {
        auto made = AmbientWind::create({.mean = {6.0f, 0.0f, 2.0f}, .gusts = {.intensity = 0.3f, .length = 6.0f}});
        EXPECT_TRUE(made) << made.error();
        wind_ = *made;
    }
    /// [m] Lean of the tip of the strand that stands at uv [m].
    [[nodiscard]] glm::vec2 lean(glm::vec2 uv, float h) const {
        const WindrowDrag drag{{0.2f, 0.0f, 1.0f, 1.57079633f}};
        const glm::vec3 load = windrow_drag_bend(drag, {0.0f, 1.0f, 0.0f}, wind_->velocity({uv.x, 0.05, uv.y}), 1.0f);
        return k_length * windrow_strand_lean({load.x, load.z}, h, 1.57079633f);
    }

  private:
    std::optional<AmbientWind> wind_;
};

TEST(Strand, LeansByTheWindOfItsOwnPlaceOnFourVertices) {
    const Plane plane;
    double once_most = 0.0, twice_most = 0.0, lean_most = 0.0;
    for (int n = 0; n < 100; ++n) {
        const glm::vec2 root{0.2f + 0.36f * static_cast<float>(n % 10), 0.2f + 0.36f * static_cast<float>(n / 10)};
        for (const float h : {0.25f, 0.5f, 1.0f}) {
            const glm::vec2 seen = root + plane.lean(root, h); // where wind times mask puts the strand
            lean_most = std::max(lean_most, static_cast<double>(glm::length(seen - root)) * k_texels);
            const glm::vec2 once = windrow_strand_root(seen, plane.lean(seen, h), 1.0f);
            const glm::vec2 twice = windrow_strand_root(seen, plane.lean(once, h), 1.0f);
            once_most = std::max(once_most, static_cast<double>(glm::length(once - root)) * k_texels);
            twice_most = std::max(twice_most, static_cast<double>(glm::length(twice - root)) * k_texels);
        }
    }
    test::figure("plants/strand/largest_lean_texels", lean_most);
    WINDROW_EXPECT_FIGURE("plants/strand/error_of_one_look_up_texels", once_most, 1.0);
    WINDROW_EXPECT_FIGURE("plants/strand/error_of_two_look_ups_texels", twice_most, 0.1);
}

// Numbers by hand: (1 - r^2/R^2)^2 is 0.5625 halfway out, and comes to 0 without an edge.
TEST(Strand, IsPushedOutwardByAFootAndNoFurther) {
    const glm::vec2 halfway = windrow_radial_load({-0.12f, 0.16f}, 0.4f, 1.2f);
    EXPECT_NEAR(halfway.x, -0.6 * 0.5625 * 1.2, 1e-6);
    EXPECT_NEAR(halfway.y, 0.8 * 0.5625 * 1.2, 1e-6);
    EXPECT_LE(glm::length(windrow_radial_load({0.0f, 0.399f}, 0.4f, 1.2f)), 1e-4f);
    EXPECT_EQ(windrow_radial_load({0.0f, -0.401f}, 0.4f, 1.2f), glm::vec2(0.0f));
    EXPECT_EQ(windrow_radial_load(glm::vec2(0.0f), 0.4f, 1.2f), glm::vec2(0.0f));
    EXPECT_NEAR(glm::length(windrow_radial_load({1e-4f, 0.0f}, 0.4f, 1.2f)), 1.2f, 1e-5);
}

} // namespace
} // namespace windrow
