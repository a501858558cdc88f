// Maps that take what changes slowly off the pixels, against each pixel's own work: clear sky, clouds, the ground's colour.
#include "tests/fields.h"
#include "tests/figure.h"
#include "vegetation/render/noise_map.h"
#include "vegetation/tests/render/grass_stage.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace windrow::vegetation::render {
namespace {

constexpr glm::dvec3 k_mapped_corner{-3e4, 5.0, 6e4}; // [m]
constexpr Quality k_no_maps{.sky_pixels = 0, .cloud_texels = 0, .cloud_noise_texels = 0, .ground_texels = 0};

using Texels = std::set<std::pair<int, int>>;

Texels texels_of(const TexelRectangle& rectangle) {
    Texels all;
    for (int y = rectangle.first.y; y < rectangle.end.y; ++y)
        for (int x = rectangle.first.x; x < rectangle.end.x; ++x)
            all.emplace(x, y);
    return all;
}

TEST(NoiseMap, FillsEachTexelThatCameInOnce) {
    windrow::test::Random random(5);
    const auto rectangle = [&](int reach) {
        const auto at = [&] { return static_cast<int>(random.bits() % static_cast<unsigned>(2 * reach)) - reach; };
        const glm::ivec2 first(at(), at());
        return TexelRectangle{first, first + 7};
    };
    for (int n = 0; n < 500; ++n) {
        const TexelRectangle filled = rectangle(n % 2 == 0 ? 4 : 12), wanted = rectangle(n % 2 == 0 ? 4 : 12);
        std::vector<TexelRectangle> parts;
        append_unfilled(wanted, filled, parts);
        Texels missing;
        const Texels had = texels_of(filled);
        for (const auto& texel : texels_of(wanted))
            if (!had.contains(texel))
                missing.insert(texel);
        Texels made;
        std::size_t count = 0;
        for (const TexelRectangle& part : parts) {
            EXPECT_FALSE(part.empty());
            const Texels one = texels_of(part);
            count += one.size();
            made.insert(one.begin(), one.end());
        }
        EXPECT_EQ(made, missing);
        EXPECT_EQ(count, missing.size()) << "texels are filled twice";
    }
}

// Level grassy ground under clouds, seen after the eye has walked and jumped: strips were filled, and the map's texels repeat.
PictureF walked_view(const Quality& quality, float cover, double pitch) {
    Scene scene;
    scene.ground = {.corner = k_mapped_corner,
                    .heights = *HeightMap::create({101, 101}, 4.0f, [](glm::vec2 p) { return 2.0f * std::sin(0.05f * p.x); })};
    scene.clouds = {.cover = cover};
    scene.look.even_from = 6.0f; // colours of the meadow from near on
    scene.look.wave = 0.0f;
    scene.wind.wind.cells = {8, 4, 8};
    scene.wind.wind.centre = k_mapped_corner + glm::dvec3(200.0, 2.0, 200.0);
    test::GrassStage stage(
        scene, {.width = 320, .height = 180, .samples = 1, .shadow_texels = 64, .quality = quality, .anchor = k_mapped_corner});
    Camera camera;
    for (const glm::dvec2 place :
         {glm::dvec2(20.0, 30.0), glm::dvec2(23.3, 29.1), glm::dvec2(180.0, 260.0), glm::dvec2(178.0, 266.0)}) {
        camera.position = k_mapped_corner + glm::dvec3(place.x, 12.0, place.y);
        camera.target = camera.position + glm::dvec3(4.0, pitch, -10.0);
        stage.renderer->set_time(30.0 * place.x);
        stage.draw(camera, 1.0 / 30.0);
    }
    return stage.renderer->images().light_picture();
}

double worst_ratio(const PictureF& map, const PictureF& own) {
    double worst = 0.0;
    for (std::size_t n = 0; n < map.values.size(); ++n)
        worst = std::max(worst,
                         std::abs(static_cast<double>(map.values[n]) / std::max(1e-3, static_cast<double>(own.values[n])) - 1.0));
    return worst;
}

TEST(Quality, GroundsColourIsThatOfEachPixel) {
    Quality quality = k_no_maps;
    const PictureF own = walked_view(quality, 0.0f, -6.0);
    quality.ground_texels = 128; // the map ends within the picture
    const PictureF map = walked_view(quality, 0.0f, -6.0);
    EXPECT_NE(map.values, own.values);
    WINDROW_EXPECT_FIGURE("render/quality/ground/off_each_pixels_own", worst_ratio(map, own), 0.05);
}

TEST(Quality, ClearSkyIsThatOfEachPixel) {
    Quality quality = k_no_maps;
    const PictureF own = walked_view(quality, 0.0f, 2.0);
    quality.sky_pixels = 4;
    const PictureF map = walked_view(quality, 0.0f, 2.0);
    EXPECT_NE(map.values, own.values);
    WINDROW_EXPECT_FIGURE("render/quality/clear_sky/off_each_pixels_own", worst_ratio(map, own), 0.03);
}

TEST(Quality, CloudsAreThoseOfEachPixel) {
    Quality quality = k_no_maps;
    const PictureF own = walked_view(quality, 0.5f, 4.0), clear = walked_view(quality, 0.0f, 4.0);
    EXPECT_GT(worst_ratio(clear, own), 0.2); // there are clouds
    quality.cloud_noise_texels = 1024;
    const PictureF map = walked_view(quality, 0.5f, 4.0);
    EXPECT_NE(map.values, own.values);
    WINDROW_EXPECT_FIGURE("render/quality/clouds/off_each_pixels_own", worst_ratio(map, own), 0.1);
}

} // namespace
} // namespace windrow::vegetation::render
