// Grass too far to be drawn: its ground waves in the wind as blades before it do, without a seam.
#include "tests/figure.h"
#include "vegetation/tests/render/grass_stage.h"

#include <cmath>

namespace windrow::vegetation::render {
namespace {

constexpr float k_cut = 40.0f; // [m] where blades end
constexpr float k_even = 25.0f;
constexpr int k_width = 320, k_height = 180;
constexpr double k_eye = 6.0, k_view_deg = 30.0;

Scene windy_plain(float wave) {
    Scene scene;
    scene.ground = {.corner = {-100.0, 0.0, -100.0},
                    .heights = *HeightMap::create({26, 26}, 8.0f, std::vector<float>(676, 0.0f))};
    scene.wind.wind.cells = {8, 4, 8};
    scene.wind.wind.centre = {0.0, 2.0, 0.0};
    scene.wind.wind.ambient = {3.0f, 0.0f, 2.0f};
    scene.wind.wind.profile = windrow::LogProfile{.roughness_length = 0.05f};
    scene.wind.wind.gusts = {.intensity = 0.4f, .length = 10.0f};
    scene.look.even_from = k_even;
    scene.look.wave = wave;
    scene.look.dryness = 0.0f;
    scene.look.variation = 0.0f;
    scene.fog.density = 0.0f;
    scene.clouds.cover = 0.0f;
    scene.plants.stalk.length = 0.4f;
    return scene;
}

// Green light over a band of distances: its mean, and how far it changes in time (standard deviation), in tiles as high as the
// band that are small beside a gust and hold dozens of blades.
constexpr int k_tile = 16; // [px]
struct Band {
    double mean = 0.0, moves = 0.0;
};

int row_at(double distance) {
    // The camera looks level; its middle row is the horizon.
    const double tangent = k_eye / distance;
    return static_cast<int>(0.5 * k_height * (1.0 + tangent / std::tan(0.5 * k_view_deg * 0.017453292519943295)));
}

Band band_of(const std::vector<PictureF>& pictures, double near, double far) {
    Band band;
    int count = 0;
    for (int column = 0; column < k_width; column += k_tile) {
        double sum = 0.0, squares = 0.0;
        for (const PictureF& picture : pictures) {
            double tile = 0.0;
            int points = 0;
            for (int y = row_at(far); y < row_at(near); ++y)
                for (int x = column; x < column + k_tile; ++x, ++points)
                    tile += static_cast<double>(
                        picture.values[3 * (static_cast<std::size_t>(y) * k_width + static_cast<std::size_t>(x)) + 1]);
            tile /= points;
            sum += tile;
            squares += tile * tile;
        }
        const auto n = static_cast<double>(pictures.size());
        band.mean += sum / n;
        band.moves += squares / n - sum / n * (sum / n);
        ++count;
    }
    band.mean /= count;
    band.moves = std::sqrt(band.moves / count);
    return band;
}

std::vector<PictureF> pictures_of(float wave, bool blades) {
    test::GrassStage stage(windy_plain(wave), {.width = k_width, .height = k_height, .samples = 4, .shadow_texels = 64});
    const auto mask = *grass::PlacementMask::create({33, 33}, stage.scene.ground.heights.extent(), 1.0f);
    grass::GrassSettings field{.density = 6.0f, .split_distance = 8.0f, .cut_distance = k_cut, .fade_from = 0.75f};
    field.blade.stalk.length = 0.4f;
    if (blades)
        stage.grow(mask, {.field = field, .look = stage.scene.look, .shadows = 0});
    Camera camera;
    camera.position = {0.0, k_eye, 0.0};
    camera.target = {0.0, k_eye, -10.0};
    camera.view_deg = static_cast<float>(k_view_deg);
    std::vector<PictureF> pictures;
    for (int frame = 0; frame < 12; ++frame) {
        stage.draw(camera, 0.25); // gusts pass within 3 s
        pictures.push_back(stage.renderer->images().light_picture());
    }
    return pictures;
}

TEST(FarGrass, WavesInGustsAndIsStillWithout) {
    const Band still = band_of(pictures_of(0.0f, false), k_cut, 80.0), waves = band_of(pictures_of(0.6f, false), k_cut, 80.0);
    windrow::test::figure("render/far_grass/moves_of_its_light", waves.moves / waves.mean);
    EXPECT_LT(still.moves, 1e-6 * still.mean);  // rounding of the mean
    EXPECT_GT(waves.moves, 0.005 * waves.mean); // several gusts lie in each tile
}

TEST(FarGrass, HasNoSeamWhereBladesEnd) {
    const std::vector<PictureF> with = pictures_of(0.6f, true), without = pictures_of(0.6f, false);
    const Band blades = band_of(with, 0.78 * k_cut, 0.95 * k_cut), ground = band_of(without, 0.78 * k_cut, 0.95 * k_cut);
    windrow::test::figure("render/far_grass/blades_move", blades.moves / blades.mean);
    windrow::test::figure("render/far_grass/ground_moves", ground.moves / ground.mean);
    WINDROW_EXPECT_FIGURE("render/far_grass/mean_of_blades_over_ground_less_1", std::abs(blades.mean / ground.mean - 1.0), 0.05);
    WINDROW_EXPECT_FIGURE("render/far_grass/moves_of_blades_over_ground_less_1", std::abs(blades.moves / ground.moves - 1.0),
                          0.05);
}

} // namespace
} // namespace windrow::vegetation::render
