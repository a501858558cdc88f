#include "vegetation/tests/images/drawn.h"

#include "vegetation/program/picture_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace windrow::vegetation::program::test {
namespace {

using windrow::Error;
using windrow::Result;

// Before the first instance is made; what the caller chose stays.
[[maybe_unused]] const bool k_chosen = [] {
    if (std::getenv("VK_ICD_FILENAMES") == nullptr && std::getenv("VK_DRIVER_FILES") == nullptr)
        ::setenv("VK_LOADER_DRIVERS_SELECT", "*lvp*", 0);
    return true;
}();

int between(std::uint8_t a, std::uint8_t b) {
    return std::abs(static_cast<int>(a) - static_cast<int>(b));
}

} // namespace

Result<PictureScene> read_scene(const std::string& name) {
    return read_picture_scene(std::filesystem::path(WINDROW_SOURCE_DIR) / "vegetation/tests/images/scenes" / (name + ".json"));
}

Result<render::Picture8> last_picture(const PictureScene& scene, const SceneRendererSettings& settings, int drawn) {
    auto scene_renderer = SceneRenderer::create(scene, settings);
    if (!scene_renderer)
        return scene_renderer.failure();
    if (auto settled = (*scene_renderer)->warm_up(); !settled)
        return settled.failure();
    const auto frames = static_cast<std::int64_t>(std::llround(scene.air.duration * (*scene_renderer)->frames_per_second())) + 1;
    while ((*scene_renderer)->frame() < frames)
        if (auto done = (*scene_renderer)->frame() < frames - drawn ? (*scene_renderer)->skip() : (*scene_renderer)->draw();
            !done)
            return done.failure();
    return (*scene_renderer)->images().picture();
}

Apart apart(const render::Picture8& a, const render::Picture8& b) {
    Apart found;
    for (std::size_t pixel = 0; pixel < a.values.size() / 3; ++pixel) {
        int most = 0;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const int off = between(a.values[3 * pixel + channel], b.values[3 * pixel + channel]);
            found.mean += off;
            most = std::max(most, off);
        }
        found.far += most > Apart::k_far ? 1.0 : 0.0;
        found.max = std::max(found.max, most);
    }
    found.mean /= static_cast<double>(a.values.size());
    found.far /= static_cast<double>(a.values.size() / 3);
    return found;
}

render::Picture8 difference(const render::Picture8& a, const render::Picture8& b) {
    render::Picture8 made(a.width, a.height);
    for (std::size_t n = 0; n < made.values.size(); ++n)
        made.values[n] = static_cast<std::uint8_t>(std::min(8 * between(a.values[n], b.values[n]), 255));
    return made;
}

std::filesystem::path left_behind(const std::string& name, const std::string& ending) {
    const std::filesystem::path folder = WINDROW_IMAGES_FOLDER;
    std::filesystem::create_directories(folder);
    return folder / (name + (ending.empty() ? "" : "." + ending) + ".png");
}

} // namespace windrow::vegetation::program::test
