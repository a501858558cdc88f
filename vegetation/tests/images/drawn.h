// Small scenes drawn on the software device, and how far two pictures are apart.
//
// The references were drawn by lavapipe: a GPU's rasteriser and texture filter round otherwise, each in its own way. So the tests
// ask Vulkan's loader for lavapipe alone, unless VK_LOADER_DRIVERS_SELECT or VK_ICD_FILENAMES says something else.
#pragma once

#include "pictures/picture_files.h"
#include "vegetation/program/scene_renderer.h"

#include <filesystem>
#include <string>

namespace windrow::vegetation::program::test {

/// Reads vegetation/tests/images/scenes/NAME.json.
[[nodiscard]] windrow::Result<PictureScene> read_scene(const std::string& name);

/// Settles, lets all frames of the scene but the last `drawn` pass without a picture, draws those, and gives the last one, of the
/// scene's end.
[[nodiscard]] windrow::Result<render::Picture8> last_picture(const PictureScene& scene, const SceneRendererSettings& settings,
                                                             int drawn = 3);

/// In 8-bit sRGB, 0 to 255.
struct Apart {
    double mean = 0.0; ///< mean absolute difference, over pixels and channels
    double far = 0.0;  ///< share of pixels with a channel that is off by more than k_far
    int max = 0;       ///< largest difference of a channel

    /// A tenth of the range: what the eye sees in one pixel beside another.
    static constexpr int k_far = 24;
};

/// Of two pictures of one size.
[[nodiscard]] Apart apart(const render::Picture8& a, const render::Picture8& b);
/// Their difference, eight times as strong, on black.
[[nodiscard]] render::Picture8 difference(const render::Picture8& a, const render::Picture8& b);

/// Where a test leaves what it drew: NAME.png, and NAME.ENDING.png.
[[nodiscard]] std::filesystem::path left_behind(const std::string& name, const std::string& ending = "");

} // namespace windrow::vegetation::program::test
