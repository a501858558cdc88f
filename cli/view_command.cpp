#include "cli/view_command.h"

#include "cli/flags.h"
#if WINDROW_WITH_VIEW
#include "vegetation/view/view.h"
#endif
#if WINDROW_WITH_VDB
#include "fluid/vdb/vdb_export.h"
#endif

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace windrow::cli {

#if WINDROW_WITH_VIEW
namespace {

namespace shown = vegetation::view;
using vegetation::program::Backend;

/// "1280x720".
glm::ivec2 read_window_size(const std::string& text) {
    constexpr int k_least = 160, k_most = 8192;
    int width = 0, height = 0;
    char cross = 0, rest = 0;
    if (std::sscanf(text.c_str(), "%d%c%d%c", &width, &cross, &height, &rest) != 3 || cross != 'x' ||
        std::min(width, height) < k_least || std::max(width, height) > k_most)
        reject("--size is \"", text, "\": give it as WIDTHxHEIGHT, ", k_least, " to ", k_most, " pixels each.");
    return {width, height};
}

#if WINDROW_WITH_VDB
/// The cells of the air, as `windrow run --vdb` writes them without more.
windrow::Result<void> write_vdb(const std::filesystem::path& file, const WindControl& control, const WindReader& reader) {
    const auto grid = vdb::grid_of(control, reader);
    if (!grid)
        return grid.failure();
    return vdb::write(*grid, file, {});
}
#endif

int run_view(const shown::ViewRequest& request, const Console& console) {
    const auto summary = shown::view(request, [&](const std::string& line) { console.out << line << std::endl; });
    if (!summary) {
        console.complain(summary.error());
        return summary.failure().fault == windrow::Fault::rejected ? k_exit_wrong_use : k_exit_machine;
    }
    const auto rounded = [](double value) { return std::round(1e3 * value) / 1e3; };
    const double frames = std::max(summary->frames, 1);
    console.out << summary->device << ": " << summary->frames << " frames in " << rounded(summary->seconds) << " s, "
                << rounded(summary->cpu_seconds / frames) << " s of CPU a frame, " << rounded(summary->panel_ms)
                << " ms of it for the panel and the window; " << summary->resizes << " resizes";
    if (request.validation)
        console.out << "; " << summary->messages << " messages of validation";
    console.out << '\n';
    return summary->messages > 0 ? k_exit_out_of_bounds : k_exit_well;
}

} // namespace
#endif

void add_view(CLI::App& app, std::function<int()>& chosen, const Console& console) {
    CLI::App* const view = app.add_subcommand("view", "Open a window on a scene: play it, change it, save it");
#if WINDROW_WITH_VIEW
    const auto request = std::make_shared<shown::ViewRequest>();
    Flags flags(*view);
    flags
        .value("SCENE.json", "", "Scene file, or a recording: its log, events.log, or the folder with that and start.wind",
               [request](const std::string& text) {
                   if (text.empty())
                       reject("SCENE.json is empty: name a scene file, or a recording.");
                   request->scene = text;
               })
        ->required();
#if WINDROW_WITH_VDB
    request->write_vdb = write_vdb;
#endif
    flags.value("--size", "WIDTHxHEIGHT", "Of the window in pixels; default 1280x720",
                [request](const std::string& text) { request->size = read_window_size(text); });
    flags.value("--look", "NAME", "full or draft; default full on a GPU, draft on a software device",
                [request](const std::string& text) {
                    if (text != "full" && text != "draft")
                        reject("--look is \"", text, "\": give full or draft.");
                    request->look = text == "full" ? shown::Look::full : shown::Look::draft;
                });
    flags.value("--backend", "NAME", "What runs the air, cpu or vulkan; default vulkan on a GPU, cpu on a software device",
                [request](const std::string& text) {
                    if (text != "cpu" && text != "vulkan")
                        reject("--backend is \"", text, "\": give cpu or vulkan.");
                    request->backend = text == "cpu" ? Backend::cpu : Backend::vulkan;
                });
    view->add_flag("--paused", request->paused, "Begin at rest");
    view->add_flag("!--no-panel", request->panel, "Begin without panels; F1 shows them");
    view->add_flag("--validation", request->validation,
                   "Report messages of Vulkan's validation layer; exit code 1 where there are any");
    view->callback([request, &chosen, &console] { chosen = [request, &console] { return run_view(*request, console); }; });
#else
    view->allow_extras()->callback([] {
        reject("view opens a window, which is not built in: install libglfw3-dev and libimgui-dev, and build again with "
               "WINDROW_VEGETATION=ON.");
    });
    (void)chosen;
    (void)console;
#endif
}

} // namespace windrow::cli
