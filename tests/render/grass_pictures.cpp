// Pictures of the seven looks, for eyes: not a test.
//
//     windrow_grass_pictures [FOLDER [WIDTH [NAME]]]      default: looks, 640, all
#include "examples/render/grass_looks.h"
#include "tests/render/grass_stage.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace {

constexpr glm::dvec3 k_eye{4.0e5, 120.0, -2.5e5};
constexpr float k_path = 75.6f; // [m] from the corner: a step to the eye's right
constexpr double k_frame = 1.0 / 30.0;

render::Ground hills() {
    return {.corner = k_eye - glm::dvec3(75.0, 0.0, 135.0),
            .heights = *grass::HeightMap::create({151, 151}, 1.0f, [](glm::vec2 p) {
                const float x = p.x - 75.0f, z = p.y - 135.0f;
                const float far = 1.0f - std::exp(-(x * x + z * z) / (20.0f * 20.0f));
                return far * (3.0f * (1.0f - std::cos(0.032f * z + 0.006f * x)) +
                              1.3f * std::sin(0.05f * x + 0.6f) * std::sin(0.04f * z)) +
                       0.1f * std::sin(0.4f * x) * std::sin(0.37f * z);
            })};
}

void draw(const render::GrassLook& look, const std::filesystem::path& folder, int width) {
    render::Scene scene;
    scene.ground = hills();
    scene.ground.grown = *render::mask_of(look, look.layers.front(), scene.ground.heights, k_path);
    scene.look = look.layers.front().settings.look;
    const float grown = look.layers.front().settings.field.blade.stalk.length;
    scene.camera.position = k_eye + glm::dvec3(0.0, 0.65 + 1.1 * static_cast<double>(grown), 0.0);
    scene.camera.target = scene.camera.position + glm::dvec3(0.0, -1.3, -10.0);
    scene.camera.exposure = 0.86f;
    scene.fog.base = k_eye.y;
    windrow::Config& wind = scene.wind.wind;
    wind.cells = {32, 8, 32};
    wind.cell_size = 0.75f;
    wind.sides = windrow::Sides::open_over_floor();
    wind.centre = k_eye + glm::dvec3(0.0, 3.0, -9.0);
    wind.ambient = {look.wind.x, 0.0f, look.wind.y};
    wind.profile = windrow::LogProfile{};
    wind.gusts = {.intensity = 0.4f, .length = 12.0f};
    scene.wind.sampling = {.detail = 0.5f, .detail_length = 0.5f};
    render::test::GrassStage stage(scene, {.width = width, .height = width * 9 / 16, .anchor = k_eye});
    (void)stage.wind->set_floor(k_eye.y);
    for (const render::LookLayer& layer : look.layers)
        stage.grow(*render::mask_of(look, layer, scene.ground.heights, k_path), layer.settings);
    stage.blow(1.5, k_frame);
    for (int frame = 0; frame < 2; ++frame)
        stage.draw(scene.camera, k_frame);
    (void)render::write_png(stage.renderer->images().picture(), folder / (look.name + ".png"));
    std::printf("%-12s", look.name.c_str());
    for (const auto& layer : stage.layers)
        std::printf(" %zu blades (%d chunks, %d left out)", stage.drawn(*layer), layer->report().colour_chunks,
                    layer->report().left_out);
    double all = 0.0;
    for (const render::StageTime& stage_time : stage.renderer->clock().times()) {
        std::printf(" %s %.0f", stage_time.name, 1e-3 * stage_time.us);
        all += 1e-3 * stage_time.us;
    }
    std::printf(" = %.0f ms\n", all);
}

} // namespace

int main(int count, char** arguments) {
    const std::filesystem::path folder = count > 1 ? arguments[1] : "looks";
    const int width = count > 2 ? std::atoi(arguments[2]) : 640;
    std::filesystem::create_directories(folder);
    for (const render::GrassLook& look : render::grass_looks())
        if (count < 4 || look.name == arguments[3])
            draw(look, folder, width);
    return ::testing::UnitTest::GetInstance()->ad_hoc_test_result().Failed() ? 1 : 0;
}
