// Pictures of grass: culling changes no pixel, the difference by levels is reported, and grass covers more ground seen from
// above.
#include "tests/figure.h"
#include "vegetation/tests/grass/device.h"
#include "vegetation/tests/grass/picture.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

namespace windrow::vegetation::grass {
namespace {

using windrow::test::Random;
using Pixels = std::vector<std::uint32_t>;

// A pixel and a half of these pictures, so that blades have pixels at all distances.
constexpr float k_min_width = 0.005f;

class GrassPictures : public test::GrassOnTheDevice {
  protected:
    static GrassSettings wide_blades() {
        GrassSettings settings = test::small_field();
        settings.min_width = k_min_width;
        return settings;
    }
    // Over the field, looking at grass or past it.
    test::Eye eye_over_grass(Random& random) const {
        const glm::vec2 grass = random.uniform(0.0f, 1.0f) < 0.5f ? glm::vec2(22.0f, 25.0f) : glm::vec2(60.0f, 85.0f);
        const glm::vec2 place = grass + glm::vec2(random.uniform(-25.0f, 25.0f), random.uniform(-25.0f, 25.0f));
        const glm::vec3 at(place.x, heights.height(place) + random.uniform(0.3f, 6.0f), place.y);
        const glm::vec3 target = glm::vec3(grass.x, heights.height(grass), grass.y) + random.vector(8.0f);
        return test::eye_at(at, target - at, random.uniform(0.4f, 1.4f));
    }
    // What the eye sees, of blades culled for another matrix if one is given.
    Pixels draw(const test::Eye& eye, View view = View::colour, const glm::mat4* culled_for = nullptr) {
        const test::Picture picture(*renders, test::Picture::still(*field));
        run([&](VkCommandBuffer commands) {
            const glm::mat4& seen = culled_for != nullptr ? *culled_for : eye.view_projection;
            EXPECT_TRUE(field->record_cull(commands, {.view_projection = seen, .eye = eye.at, .shadow_view_projection = seen}));
            picture.record(commands, *field, eye.view_projection, view);
        });
        return picture.pixels();
    }
    static std::size_t drawn(const Pixels& pixels) {
        return static_cast<std::size_t>(std::count_if(pixels.begin(), pixels.end(), [](std::uint32_t p) { return p != 0; }));
    }
    static std::size_t changed(const Pixels& a, const Pixels& b) {
        std::size_t count = 0;
        for (std::size_t n = 0; n < a.size(); ++n)
            count += a[n] != b[n];
        return count;
    }
    // A box of 2 km: nothing is outside of it.
    const glm::mat4 everything = glm::orthoRH_ZO(-1e3f, 1e3f, -1e3f, 1e3f, -1e3f, 1e3f);
};

TEST_F(GrassPictures, CullingChangesNoPixel) {
    make_field(wide_blades());
    Random random(31);
    std::size_t pixels = 0, off = 0, off_in_shadow = 0, off_again = 0;
    for (int camera = 0; camera < 8; ++camera) {
        const test::Eye eye = eye_over_grass(random);
        const Pixels culled = draw(eye), whole = draw(eye, View::colour, &everything);
        pixels += drawn(whole);
        off += changed(culled, whole);
        off_again += changed(culled, draw(eye));
        off_in_shadow += changed(draw(eye, View::shadow), draw(eye, View::shadow, &everything));
    }
    windrow::test::figure("grass/pictures/pixels_of_grass", static_cast<double>(pixels));
    EXPECT_GT(pixels, 50'000u);
    WINDROW_EXPECT_FIGURE("grass/pictures/pixels_changed_by_culling", static_cast<double>(off), 0);
    WINDROW_EXPECT_FIGURE("grass/pictures/pixels_changed_by_culling_of_shadows", static_cast<double>(off_in_shadow), 0);
    WINDROW_EXPECT_FIGURE("grass/pictures/pixels_changed_by_drawing_again", static_cast<double>(off_again), 0);
}

TEST_F(GrassPictures, FarBladesLookLikeNearOnes) {
    GrassSettings settings = wide_blades();
    const test::Eye eye = test::eye_at({22.0f, 3.5f, 2.0f}, {0.0f, -0.15f, 1.0f});
    make_field(settings);
    const Pixels levels = draw(eye);
    settings.split_distance = 44.9f; // all near, none morphed before 44 m
    settings.morph_from = 0.98f;
    make_field(settings);
    const Pixels near_only = draw(eye);
    const std::size_t covered = drawn(near_only);
    ASSERT_GT(covered, 10'000u);
    // Reported, not bounded: each blade has a colour of its own here, so that an edge that moves by a part of a pixel counts.
    windrow::test::figure("grass/pictures/share_of_grass_pixels_changed_by_levels",
                          static_cast<double>(changed(levels, near_only)) / static_cast<double>(covered));
    windrow::test::figure("grass/pictures/coverage_with_levels_over_without",
                          static_cast<double>(drawn(levels)) / static_cast<double>(covered));
}

TEST_F(GrassPictures, SeenFromAboveCoversMoreWithTheViewBend) {
    GrassSettings settings = test::small_field();
    settings.blade.width = 0.04f;                                                          // a pixel and more
    const test::Eye eye = test::eye_at({20.0f, 30.0f, 20.0f}, {0.01f, -1.0f, 0.0f}, 0.2f); // straight down, 1 of 10 aside at most
    std::size_t covered[2];
    for (int bends = 0; bends < 2; ++bends) {
        settings.blade.view_bend = bends == 0 ? 0.0f : 0.7f;
        make_field(settings);
        covered[bends] = drawn(draw(eye));
    }
    const auto percent = [](std::size_t pixels) {
        return 100.0 * static_cast<double>(pixels) / static_cast<double>(test::Picture::k_pixels);
    };
    windrow::test::figure("grass/pictures/coverage_from_above_percent", percent(covered[0]));
    windrow::test::figure("grass/pictures/coverage_from_above_with_view_bend_percent", percent(covered[1]));
    EXPECT_GT(covered[0], 0u);
    EXPECT_GT(covered[1], covered[0]);
}

} // namespace
} // namespace windrow::vegetation::grass
