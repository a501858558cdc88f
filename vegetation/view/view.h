// `windrow view`: a window on the wind of a scene, in which it is played, changed and saved.
#pragma once

#include "fluid/result.h"
#include "vegetation/program/air.h"

#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>

namespace windrow::vegetation::view {

/// What the look costs: of a GPU the scene's own, of a software device a draft.
enum class Look { automatic, full, draft };

struct ViewRequest {
    std::filesystem::path scene{};
    glm::ivec2 size{1280, 720}; ///< [px] of the window
    Look look = Look::automatic;
    std::optional<program::Backend> backend{}; ///< default: vulkan on a GPU, cpu on a software device
    bool paused = false;                       ///< it begins at rest
    bool panel = true;
    bool validation = false; ///< of the calls of Vulkan; needs the validation layer
    /// Writes the air as a VDB, where the build can.
    std::function<Result<void>(const std::filesystem::path& file, const WindControl& control, const WindReader& reader)>
        write_vdb{};
};

/// What a session was, for its last words.
struct ViewSummary {
    std::string device{}; ///< its name, and the look
    int frames = 0;
    int resizes = 0;
    double seconds = 0.0;     ///< of the clock on the wall
    double cpu_seconds = 0.0; ///< of all threads, since the first frame
    double panel_ms = 0.0;    ///< CPU of this thread a frame, for the panel, its drawing and the presentation
    int messages = 0;         ///< of validation
};

/// Opens the window and returns when it is closed. `say` receives what a person did, a line each. An error of Fault::system_lacks
/// where the machine has no display or no driver.
[[nodiscard]] Result<ViewSummary> view(const ViewRequest& request, const std::function<void(const std::string& line)>& say);

} // namespace windrow::vegetation::view
