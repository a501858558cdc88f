// Strands that lean on a plane of four vertices: C17; and away from a foot: C21.
#include "coupling/plant_numerics.h"
#include "fluid/ambient.h"
#include "tests/figure.h"

#include <algorithm>
#include <cmath>
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

TEST(Strand, TheTranslateFormIsWindTimesMask) {
    const glm::vec2 uv{0.3f, 0.7f}, lean{0.05f, -0.02f};
    EXPECT_EQ(windrow_strand_root(uv, lean, windrow_mask_power(0.0f, 2.0f)), uv);
    EXPECT_EQ(windrow_strand_root(uv, lean, windrow_mask_power(1.0f, 2.0f)), uv - lean);
    EXPECT_EQ(windrow_strand_root(uv, lean, windrow_mask_power(0.5f, 2.0f)), uv - 0.25f * lean);
}

TEST(Strand, IsPushedOutwardByAFootAndNoFurther) {
    double off = 0.0;
    for (int n = 0; n < 360; ++n) {
        const double turn = n * 3.14159265358979323846 / 180.0;
        for (const float r : {0.05f, 0.2f, 0.39f}) {
            const glm::vec2 out{static_cast<float>(std::cos(turn)), static_cast<float>(std::sin(turn))};
            const glm::vec2 load = windrow_radial_load(r * out, 0.4f, 1.2f);
            ASSERT_GT(glm::dot(load, out), 0.0f);
            off = std::max(off, static_cast<double>(std::abs(load.x * out.y - load.y * out.x) / glm::length(load)));
        }
        const glm::vec2 beyond{0.4f * static_cast<float>(std::cos(turn)), 0.4000001f * static_cast<float>(std::sin(turn))};
        ASSERT_LE(glm::length(windrow_radial_load(1.001f * beyond, 0.4f, 1.2f)), 0.0f);
    }
    WINDROW_EXPECT_FIGURE("plants/strand/radial_push_off_outward_degrees", off * 57.29578, 5.0);
    EXPECT_EQ(windrow_radial_load(glm::vec2(0.0f), 0.4f, 1.2f), glm::vec2(0.0f));
    EXPECT_NEAR(glm::length(windrow_radial_load({1e-4f, 0.0f}, 0.4f, 1.2f)), 1.2f, 1e-5);
}

} // namespace
} // namespace windrow
