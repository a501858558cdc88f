// The clouds' shadow from a map about the eye, against each point's own: hills under clouds, drawn with and without the map.
#include "tests/figure.h"
#include "vegetation/tests/render/grass_stage.h"

#include <algorithm>
#include <cmath>

namespace windrow::vegetation::render {
namespace {

constexpr glm::dvec3 k_shaded_corner{2e5, 5.0, -7e4}; // [m]

PictureF shaded_ground(int cloud_texels, float cover) {
    Scene scene;
    scene.ground = {.corner = k_shaded_corner, .heights = *HeightMap::create({101, 101}, 30.0f, [](glm::vec2 p) {
                                                   return 60.0f * std::sin(0.004f * p.x) * std::cos(0.003f * p.y);
                                               })};
    scene.clouds = {.cover = cover, .size = 300.0f};
    scene.wind.wind.cells = {8, 4, 8};
    scene.wind.wind.centre = k_shaded_corner + glm::dvec3(1500.0, 2.0, 1500.0);
    test::GrassStage stage(scene, {.width = 320,
                                   .height = 180,
                                   .samples = 1,
                                   .shadow_texels = 64,
                                   .quality = {.cloud_texels = cloud_texels},
                                   .anchor = k_shaded_corner});
    Camera camera; // the map ends within the picture
    camera.position = k_shaded_corner + glm::dvec3(1500.0, 70.0, 2600.0);
    camera.target = k_shaded_corner + glm::dvec3(1500.0, 20.0, 2400.0);
    stage.draw(camera, 1.0 / 30.0);
    stage.draw(camera, 1.0 / 30.0);
    return stage.renderer->images().light_picture();
}

TEST(CloudMap, ShadesAsEachPointByItself) {
    const PictureF map = shaded_ground(512, 0.5f), own = shaded_ground(0, 0.5f), clear = shaded_ground(512, 0.0f);
    double worst = 0.0, darkest = 1.0;
    for (std::size_t n = 0; n < map.values.size(); ++n) {
        if (own.values[n] == clear.values[n])
            continue;
        worst = std::max(worst, std::abs(static_cast<double>(map.values[n] / own.values[n]) - 1.0));
        darkest = std::min(darkest, static_cast<double>(own.values[n] / clear.values[n]));
    }
    WINDROW_EXPECT_FIGURE("render/cloud_map/off_each_points_own", worst, 0.004); // half floats are off by 0.001
    EXPECT_LT(darkest, 0.75);                                                    // there is shadow
}

} // namespace
} // namespace windrow::vegetation::render
