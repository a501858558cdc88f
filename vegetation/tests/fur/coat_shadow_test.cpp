// The shadow of a single cone of a coat overlaps its silhouette as seen from the sun by at least 95 % of their union.
#include "tests/figure.h"
#include "vegetation/tests/fur/stage.h"

#include <cmath>

namespace windrow::vegetation::fur::test {
namespace {

constexpr int k_side = 256; // [pixels]

TEST(CoatShadow, AConesShadowOverlapsItsSilhouette) {
    Stage stage({.width = k_side,
                 .height = k_side,
                 .shadow_texels = 2048,
                 .near_shadow = 3.3f,
                 .sun = {.elevation_deg = 40.0f, .azimuth_deg = 0.0f}});
    // One cell of uv: one cone, as wide as its square.
    CoatSettings cone;
    cone.layers.shells = 96;
    cone.layers.length = 0.6f;
    cone.layers.sag = 0.0f;
    cone.wind_fraction = 0.0f;
    cone.strands_on = StrandsOn::uv;
    cone.strands = {.density = 1.0f, .jitter = 0.0f, .low = 1.0f, .high = 1.0f, .thickness = 0.9f};
    cone.look.root = cone.look.tip = cone.look.second = cone.look.skin = {0.8f, 0.0f, 0.0f};
    cone.look.gloss = cone.look.sheen = 0.0f;
    cone.levels = {.full_until = 1e4f, .shadow_shells = 96};
    stage.dress(square(0.3f), cone, at({0.0, 0.01, 0.0}));
    CoatSettings floor;
    floor.bare = true;
    floor.look.skin = {0.0f, 0.0f, 0.8f};
    floor.levels.shadow_shells = 1;
    stage.dress(square(3.0f), floor, at({0.0, 0.0, 0.0}));

    // The silhouette: the cone as the sun sees it, from so far that rays are even.
    const glm::dvec3 to_sun(stage.renderer->frame_block().sky.sun);
    const render::Camera sun = camera_at(60.0 * to_sun, {0.0, 0.2, 0.0}, 1.3f);
    stage.draw(sun);
    const render::PictureF silhouette = stage.light();
    const render::Camera eye = camera_at({-0.4, 3.0, 0.02}, {-0.4, 0.0, 0.0}, 22.0f);
    stage.draw(eye);
    const render::PictureF shaded = stage.light();

    float lit = 0.0f;
    for (int row = 0; row < k_side; ++row)
        for (int column = 0; column < k_side; ++column)
            lit = std::max(lit, shaded.at(column, row, 2) * (shaded.at(column, row, 0) < 0.01f ? 1.0f : 0.0f));
    float least = lit;
    for (int row = 0; row < k_side; ++row)
        for (int column = 0; column < k_side; ++column)
            if (shaded.at(column, row, 0) < 0.01f && shaded.at(column, row, 2) > 0.0f)
                least = std::min(least, shaded.at(column, row, 2));
    ASSERT_LT(least, 0.8f * lit);
    int both = 0, either = 0, in_shadow = 0;
    for (int row = 0; row < k_side; ++row)
        for (int column = 0; column < k_side; ++column) {
            const glm::vec3 got = radiance(shaded, column, row);
            const glm::dvec3 place = on_level(eye, column, row, k_side, k_side, 0.0);
            if (got.r > 0.01f || !(got.b > 0.0f) || std::max(std::abs(place.x), std::abs(place.z)) > 1.45)
                continue; // the cone itself, or not on the floor
            const bool shadow = got.b < 0.5f * (lit + least);
            const glm::dvec2 on = seen(sun, place, k_side, k_side);
            const int x = static_cast<int>(on.x), y = static_cast<int>(on.y);
            const bool hidden = x >= 0 && y >= 0 && x < k_side && y < k_side && silhouette.at(x, y, 0) > silhouette.at(x, y, 2);
            both += shadow && hidden ? 1 : 0;
            either += shadow || hidden ? 1 : 0;
            in_shadow += shadow ? 1 : 0;
        }
    EXPECT_GT(in_shadow, 500);
    const double overlap = static_cast<double>(both) / std::max(either, 1);
    windrow::test::figure("shells/shadow/pixels", in_shadow);
    EXPECT_GE(windrow::test::figure("shells/shadow/overlap", overlap, 0.95), 0.95); // of the union
}

} // namespace
} // namespace windrow::vegetation::fur::test
