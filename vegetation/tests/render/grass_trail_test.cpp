// A walker in the grass: blades lie where he goes, a trail stays, and elsewhere nothing moves. And blades that thin out, as
// pictures.
#include "tests/figure.h"
#include "vegetation/tests/render/grass_stage.h"

#include <algorithm>
#include <cmath>

namespace windrow::vegetation::render {
namespace {

constexpr glm::dvec3 k_trail_corner{-3e4, 12.0, 8e4}; // [m]
constexpr double k_trail_frame = 0.1;                 // [s]

Ground level_ground() {
    return {.corner = k_trail_corner, .heights = *HeightMap::create({13, 13}, 2.0f, std::vector<float>(169, 0.0f))};
}

Scene still_scene(const Ground& ground) {
    Scene scene;
    scene.ground = ground;
    scene.wind.wind.cells = {8, 4, 8};
    scene.wind.wind.centre = k_trail_corner + glm::dvec3(12.0, 2.0, 12.0);
    return scene;
}

Camera camera_over(double height) {
    Camera camera;
    camera.position = k_trail_corner + glm::dvec3(12.0, height, 21.0);
    camera.target = k_trail_corner + glm::dvec3(12.0, 0.0, 12.0);
    return camera;
}

struct Lean {
    double on_the_way = 0.0, beside = 0.0; // [rad] least and most
};

// The walker goes along x = 12 m.
Lean leans(test::GrassStage& stage, GrassLayer& grass) {
    Lean found{1e9, 0.0};
    for (const FieldBlade& blade : stage.values_of<FieldBlade>(grass.visible_blades(), stage.drawn(grass))) {
        const double away = std::abs(static_cast<double>(blade.root.x) - 12.0);
        const double lean = std::hypot(static_cast<double>(blade.bend.x), static_cast<double>(blade.bend.y));
        const bool walked = blade.root.z > 11.0f && blade.root.z < 14.0f;
        if (walked && away > 0.1 && away < 0.25)
            found.on_the_way = std::min(found.on_the_way, lean);
        if (away > 1.5)
            found.beside = std::max(found.beside, lean);
    }
    return found;
}

TEST(GrassTrail, StaysWhereSomeoneWalked) {
    const Ground ground = level_ground();
    test::GrassStage stage(still_scene(ground),
                           {.width = 160, .height = 90, .samples = 1, .shadow_texels = 64, .anchor = k_trail_corner});
    const auto mask = *grass::PlacementMask::create({33, 33}, ground.heights.extent(), 1.0f);
    GrassLayer& grass = stage.grow(mask, {.field = {.density = 10.0f}, .shadows = 0});
    const Camera camera = camera_over(5.0);
    stage.draw(camera, k_trail_frame);
    const Picture8 untouched = stage.renderer->images().picture();
    stage.remember({}, k_trail_corner + glm::dvec3(12.0, 0.0, 12.0));
    stage.draw(camera, k_trail_frame);
    const Lean before = leans(stage, grass);
    EXPECT_EQ(before.on_the_way, 0.0); // still air, nobody yet
    EXPECT_EQ(stage.renderer->images().picture().values, untouched.values);

    windrow::GroundWalker walker{.radius = 0.5f};
    for (double z = 15.0; z > 10.0; z -= 2.5 * k_trail_frame) {
        walker.previous = k_trail_corner + glm::dvec3(12.0, 0.0, z + 2.5 * k_trail_frame);
        walker.position = k_trail_corner + glm::dvec3(12.0, 0.0, z);
        stage.walkers = {walker};
        stage.draw(camera, k_trail_frame);
    }
    const Lean after = leans(stage, grass);
    stage.walkers.clear();
    for (int n = 0; n < 6; ++n) // three seconds: the press is gone, the trail stays
        stage.draw(camera, 0.5);
    const Lean later = leans(stage, grass);
    windrow::test::figure("render/grass/trail_as_he_leaves_rad", after.on_the_way);
    windrow::test::figure("render/grass/trail_after_3_s_rad", later.on_the_way);
    // GroundConfig: at most half of 1.4 rad stays and falls to 1/e in 20 s; less off the middle of the walker's disc.
    EXPECT_LE(later.on_the_way, 0.7);
    EXPECT_GT(later.on_the_way, 0.5 * after.on_the_way);
    EXPECT_GT(after.on_the_way, 0.1);
    WINDROW_EXPECT_FIGURE("render/grass/lean_beside_the_trail_rad", std::max(after.beside, later.beside), 1e-3);
    const Picture8 trodden = stage.renderer->images().picture();
    int changed = 0;
    for (std::size_t n = 0; n < trodden.values.size(); n += 3)
        changed += std::abs(int{trodden.values[n + 1]} - int{untouched.values[n + 1]}) > 6;
    windrow::test::figure("render/grass/share_of_pixels_of_the_trail", changed / (160.0 * 90.0));
    EXPECT_GT(changed, 160 * 90 / 100);

    // Without the memory it is the meadow of before.
    grass.set_ground(nullptr);
    stage.draw(camera, k_trail_frame);
    EXPECT_EQ(stage.renderer->images().picture().values, untouched.values);
}

// From above, where blades hide each other little, a thinned meadow covers as much by fewer blades.
TEST(GrassThinning, CoversAsMuchByFewerBlades) {
    const Ground ground = level_ground();
    const auto mask = *grass::PlacementMask::create({33, 33}, ground.heights.extent(), 1.0f);
    std::size_t blades[2]{};
    double covered[2]{}, areas[2]{};
    for (int thins = 0; thins < 2; ++thins) {
        test::GrassStage stage(still_scene(ground), {.width = 1280, .height = 720, .samples = 1, .anchor = k_trail_corner});
        const Camera camera = camera_over(9.0);
        stage.draw(camera, k_trail_frame);
        const PictureF bare = stage.renderer->images().light_picture();
        grass::GrassSettings field{.density = 6.0f, .cut_distance = 26.0f, .shadow_distance = 0.0f, .thin_from = 5.0f};
        field.blade.width = 0.06f; // wider than the least that is drawn: a pixel is 13 mm
        field.thin_power = thins == 1 ? 1.5f : 0.0f;
        GrassLayer& grass = stage.grow(mask, {.field = field, .shadows = 0});
        stage.draw(camera, k_trail_frame);
        const PictureF grown = stage.renderer->images().light_picture();
        blades[thins] = stage.drawn(grass);
        for (const FieldBlade& blade : stage.values_of<FieldBlade>(grass.visible_blades(), blades[thins]))
            areas[thins] += static_cast<double>(blade.size.x * blade.size.y);
        for (std::size_t n = 1; n < bare.values.size(); n += 3)
            covered[thins] += std::abs(grown.values[n] - bare.values[n]) > 0.02f * bare.values[n];
    }
    windrow::test::figure("render/grass/blades_with_thinning_over_without",
                          static_cast<double>(blades[1]) / static_cast<double>(blades[0]));
    EXPECT_LT(blades[1], 0.6 * static_cast<double>(blades[0]));
    // Some hundred blades are left, of unequal size: their draw scatters by 6 %, of which two are allowed.
    WINDROW_EXPECT_FIGURE("render/grass/area_with_thinning_over_without_less_1", std::abs(areas[1] / areas[0] - 1.0), 0.12);
    // The picture has less of it: wide blades lie over each other and end beyond the picture's rim in larger pieces.
    windrow::test::figure("render/grass/pixels_with_thinning_over_without", covered[1] / covered[0]);
    EXPECT_GT(covered[1], 0.7 * covered[0]);
}

} // namespace
} // namespace windrow::vegetation::render
