// A field of grass in the renderer: it stands on the drawn ground, casts a shadow, moves as its motion vectors say, and lies
// where someone walked.
#include "tests/figure.h"
#include "vegetation/grass/grass_block.h"
#include "vegetation/tests/render/grass_stage.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace windrow::vegetation::render {
namespace {

constexpr glm::dvec3 k_corner{4e5, 30.0, -2.5e5}; // [m]
constexpr double k_frame = 1.0 / 30.0;            // [s]
constexpr int k_layer_width = 320, k_layer_height = 240;

// 24 m x 24 m of bumps, a corner two metres.
Ground bumps() {
    return {.corner = k_corner, .heights = *HeightMap::create({13, 13}, 2.0f, [](glm::vec2 p) {
                                    return 0.7f * std::sin(1.3f * p.x) * std::cos(1.1f * p.y);
                                })};
}

Scene scene_of(const Ground& ground) {
    Scene scene;
    scene.ground = ground;
    windrow::Config& config = scene.wind.wind;
    config.cells = {16, 8, 16};
    config.centre = k_corner + glm::dvec3(12.0, 4.0, 12.0);
    config.boundaries = windrow::Boundaries::open_over_floor();
    config.floor = k_corner.y;
    config.ambient = {2.0f, 0.0f, 0.7f};
    config.gusts = {.intensity = 0.5f, .length = 6.0f};
    return scene;
}

RenderSettings small_picture() {
    return {.width = k_layer_width, .height = k_layer_height, .samples = 1, .shadow_texels = 256, .anchor = k_corner};
}

grass::PlacementMask everywhere(const Ground& ground) {
    return *grass::PlacementMask::create({33, 33}, ground.heights.extent(), 1.0f);
}

Camera camera_at(double x, double z, double turn = 0.0) {
    Camera camera;
    camera.position = k_corner + glm::dvec3(x, 1.6, z);
    camera.target = camera.position + glm::dvec3(10.0 * std::sin(turn), -2.5, -10.0 * std::cos(turn));
    return camera;
}

double share_darker(const PictureF& lit, const PictureF& shaded) {
    std::size_t count = 0;
    for (std::size_t n = 1; n < lit.values.size(); n += 3)
        count += shaded.values[n] < 0.9f * lit.values[n];
    return static_cast<double>(count) / (static_cast<double>(lit.values.size()) / 3.0);
}

int pixels_apart(const Picture8& a, const Picture8& b, int by) {
    int count = 0;
    for (std::size_t pixel = 0; pixel < a.values.size(); pixel += 3) {
        int most = 0;
        for (std::size_t channel = 0; channel < 3; ++channel)
            most = std::max(most, std::abs(int{a.values[pixel + channel]} - int{b.values[pixel + channel]}));
        count += most > by;
    }
    return count;
}

// The bilinear surface, on which grass stands, and the triangles that are drawn lie a quarter of a texel's twist apart at most; a
// root lies on neither, but on the lower.
TEST(GrassLayer, RootsLieOnTheDrawnGroundOrBelowIt) {
    const Ground ground = bumps();
    const auto heights = ground.heights.heights();
    double twist = 0.0, apart = 0.0, above = 0.0, below = 0.0;
    for (std::size_t z = 0; z < 12; ++z)
        for (std::size_t x = 0; x < 12; ++x) {
            const std::size_t at = 13 * z + x;
            twist = std::max(twist,
                             std::abs(static_cast<double>(heights[at] - heights[at + 1] - heights[at + 13] + heights[at + 14])));
        }
    const grass::PlacementMask mask = everywhere(ground);
    const grass::Block block = grass::block_of({}, ground.heights, mask);
    for (int z = 0; z < block.cells.y; ++z)
        for (int x = 0; x < block.cells.x; ++x) {
            const grass::BladeRecord blade = grass::blade_at(block, ground.heights, mask, {x, z});
            const glm::vec2 place(blade.x, blade.z);
            const double drawn = static_cast<double>(ground.heights.drawn_height(place));
            apart = std::max(apart, std::abs(static_cast<double>(ground.heights.height(place)) - drawn));
            above = std::max(above, static_cast<double>(blade.y) - drawn);
            below = std::max(below, drawn - static_cast<double>(blade.y));
        }
    WINDROW_EXPECT_FIGURE("render/grass/surfaces_apart_over_a_quarter_twist", apart / (0.25 * twist), 1.0 + 1e-5);
    windrow::test::figure("render/grass/surfaces_apart_m", apart);
    WINDROW_EXPECT_FIGURE("render/grass/roots_above_the_drawn_ground_m", above, 0.0);
    WINDROW_EXPECT_FIGURE("render/grass/roots_below_it_over_a_quarter_twist", below / (0.25 * twist), 1.0 + 1e-5);
}

TEST(GrassLayer, IsDrawnAndShadesItself) {
    const Ground ground = bumps();
    std::optional<PictureF> light[3];
    for (int shadows = 0; shadows <= 2; ++shadows) {
        test::GrassStage stage(scene_of(ground), small_picture());
        const Camera camera = camera_at(12.0, 22.0);
        stage.draw(camera, k_frame);
        const Picture8 bare = stage.renderer->images().picture();
        GrassLayer& grass = stage.grow(everywhere(ground), {.field = {.density = 14.0f}, .shadows = shadows});
        stage.draw(camera, k_frame);
        EXPECT_GT(grass.report().colour_chunks, 0);
        EXPECT_EQ(grass.report().left_out, 0);
        EXPECT_EQ(grass.report().shadow_chunks > 0, shadows > 0);
        light[shadows] = stage.renderer->images().light_picture();
        const int drawn = pixels_apart(bare, stage.renderer->images().picture(), 6);
        if (shadows == 0) {
            windrow::test::figure("render/grass/share_of_pixels_changed",
                                  drawn / static_cast<double>(k_layer_width * k_layer_height));
            EXPECT_GT(drawn, k_layer_width * k_layer_height / 5);
        }
    }
    // Pixels that lose a tenth of their light and more: a meadow shades itself, and the far map adds what lies beyond the near
    // one.
    for (int shadows = 1; shadows <= 2; ++shadows) {
        const double share = share_darker(*light[0], *light[shadows]);
        windrow::test::figure(shadows == 1 ? "render/grass/share_shaded_by_one_map" : "render/grass/share_shaded_by_both_maps",
                              share);
        EXPECT_GT(share, 0.02);
    }
}

// With springs, and bent by the wind at once.
class GrassLayerMotion : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Springs, GrassLayerMotion, testing::Bool());

// One row of blades as wide as 30 pixels, so that none hides another: what the picture says of their motion is the difference of
// their places by the bends that each of the two frames itself had.
TEST_P(GrassLayerMotion, IsTheDifferenceOfPlacesInBothFramesWinds) {
    const Ground ground{.corner = k_corner, .heights = *HeightMap::create({13, 13}, 2.0f, std::vector<float>(169, 0.0f))};
    test::GrassStage stage(scene_of(ground), small_picture());
    auto mask = *grass::PlacementMask::create({97, 97}, ground.heights.extent());
    mask.apply([](glm::vec2 p, float) { return std::abs(p.y - 18.5f) < 0.4f ? 1.0f : 0.0f; });
    grass::GrassSettings field{.density = 1.0f, .jitter = 0.0f, .shadow_distance = 0.0f};
    field.blade = {.width = 0.3f, .rest_bend = 0.0f, .rest_bend_spread = 0.0f};
    field.blade.stalk.length = 1.0f;
    field.blade.stalk.rigidity *= 300.0f;
    GrassLayer& grass = stage.grow(mask, {.field = field, .shadows = 0, .springs = GetParam()});
    stage.blow(1.0, k_frame);
    const Camera before = camera_at(12.0, 22.0), now = camera_at(12.02, 22.0, -0.002);
    for (int frame = 0; frame < (GetParam() ? 20 : 1); ++frame) // springs swing then
        stage.draw(before, k_frame);
    const auto blades_before = stage.values_of<FieldBlade>(grass.visible_blades(), stage.drawn(grass));
    stage.draw(now, k_frame);
    const auto blades = stage.values_of<FieldBlade>(grass.visible_blades(), stage.drawn(grass));
    const PictureF motion = stage.renderer->images().motion_picture();

    using namespace windrow::numerics;
    const grass::Block block = grass::block_of(field, ground.heights, mask);
    const auto seen = [&](const Camera& camera, glm::dvec3 p) {
        const glm::dvec4 clip =
            glm::dmat4(view_projection(camera, static_cast<float>(k_layer_width) / k_layer_height, k_corner)) *
            glm::dvec4(p, 1.0);
        return 0.5 * glm::dvec2(clip) / clip.w + 0.5;
    };
    double worst = 0.0, most = 0.0, apart = 0.0, moved = 0.0;
    int compared = 0;
    for (const FieldBlade& blade : blades) {
        const auto same = std::find_if(blades_before.begin(), blades_before.end(),
                                       [&](const FieldBlade& other) { return other.root == blade.root; });
        if (same == blades_before.end())
            continue;
        for (int axis = 0; axis < 2; ++axis) {
            apart = std::max(apart, std::abs(static_cast<double>(blade.bend[2 + axis] - same->bend[axis])));
            moved = std::max(moved, std::abs(static_cast<double>(blade.bend[axis] - same->bend[axis])));
        }
        const auto point = [&](const FieldBlade& at, float h, float side) {
            const WindrowBladePlant plant =
                windrow_blade_plant(block.blade, {0.0f, 1.0f, 0.0f}, {at.traits.x, at.traits.y}, {at.bend.x, 0.0f, at.bend.y},
                                    {0.0f, 0.0f, 1.0f}); // the class has no view bend
            return glm::dvec3(at.root) + glm::dvec3(windrow_blade_vertex(block.blade, plant, h, side).position);
        };
        const auto motion_at = [&](float h, float side) {
            return seen(now, point(blade, h, side)) - seen(before, point(*same, h, side));
        };
        constexpr float step = 1.0f / 7.0f; // rows of the strip
        for (const float h : {2.0f * step, 3.0f * step, 4.0f * step, 5.0f * step}) {
            const double wide = seen(now, point(blade, h, 1.0f)).x - seen(now, point(blade, h, -1.0f)).x;
            const glm::dvec2 place = seen(now, point(blade, h, 0.0f)), expected = motion_at(h, 0.0f);
            const int column = static_cast<int>(std::floor(place.x * k_layer_width)),
                      row = static_cast<int>(std::floor(place.y * k_layer_height));
            if (std::abs(wide) * k_layer_width < 6.0 || column < 1 || row < 1 || column >= k_layer_width - 1 ||
                row >= k_layer_height - 1)
                continue; // on edge, or out of the picture
            // The centre of a pixel is up to .71 px from the point: error at most that times the gradient, over each triangle there.
            const glm::dvec2 size(k_layer_width, k_layer_height);
            for (int axis = 0; axis < 2; ++axis) {
                double slope = 0.0;
                for (const float next : {h - step, h + step})
                    for (const float side : {-1.0f, 1.0f}) {
                        const glm::dvec2 along = size * (seen(now, point(blade, next, side)) - seen(now, point(blade, h, side)));
                        const glm::dvec2 across = size * (seen(now, point(blade, h, 1.0f)) - seen(now, point(blade, h, -1.0f)));
                        const glm::dvec2 grows(motion_at(next, side)[axis] - motion_at(h, side)[axis],
                                               motion_at(h, 1.0f)[axis] - motion_at(h, -1.0f)[axis]);
                        slope = std::max(slope, glm::length(grows * glm::inverse(glm::dmat2(along, across))));
                    }
                const double error = std::abs(static_cast<double>(motion.at(column, row, axis)) - expected[axis]);
                worst = std::max(worst, error / (0.71 * slope + 1e-6));
                const double by_wind = seen(now, point(blade, h, 0.0f))[axis] - seen(now, point(*same, h, 0.0f))[axis];
                most = std::max(most, std::abs(by_wind) / (0.71 * slope + 1e-6));
            }
            ++compared;
        }
    }
    EXPECT_GT(moved, 1e-3);
    WINDROW_EXPECT_FIGURE("render/grass/bend_before_rad", apart, 1e-6); // the same textures, the same text
    windrow::test::figure("render/grass/motion_compared", compared);
    EXPECT_GE(compared, 8);
    windrow::test::figure("render/grass/motion_of_wind_over_that_of_a_pixel", most);
    EXPECT_GT(most, 2.0); // the bends of one frame in place of both would be seen
    WINDROW_EXPECT_FIGURE("render/grass/motion_over_that_of_a_pixel", worst, 1.0);
}

TEST(GrassLayer, RejectsWhatItCannotDraw) {
    const Ground ground = bumps();
    EXPECT_FALSE(validate(GrassLayerSettings{.field = {.density = -1.0f}}));
    EXPECT_FALSE(validate(GrassLayerSettings{.max_blades = 0}));
    EXPECT_FALSE(validate(GrassLayerSettings{.shadows = 3}));
    EXPECT_FALSE(validate(GrassLayerSettings{.look = {.gloss = 0.0f}}));
    EXPECT_TRUE(validate(GrassLayerSettings{}));
    test::GrassStage stage(scene_of(ground), small_picture());
    const auto other = *grass::PlacementMask::create({33, 33}, {10.0f, 10.0f}, 1.0f);
    const auto rejected = GrassLayer::create(*stage.device, stage.renderer->draw_targets(), ground, other, {});
    ASSERT_FALSE(rejected);
    EXPECT_NE(rejected.error().find("mask"), std::string::npos);
}

} // namespace
} // namespace windrow::vegetation::render
