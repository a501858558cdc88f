#include "cli/check/check_command.h"

#include "cli/backend.h"
#include "cli/flags.h"
#include "cli/info_command.h"
#include "cli/output_file.h"
#include "fluid/thread_pool.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

namespace windrow::cli {

using namespace cases;

namespace {

constexpr std::size_t k_kept_messages = 5;
// A software device takes some 3 us a cell and step: with these its stories end within two minutes.
constexpr double k_software_cell_steps = 2.5e6;
// Largest difference from the CPU in the benchmark's flow, over the largest component: as a story's.
constexpr double k_bench_parity = 1e-4;

/// All stories on a device made for them. Returns an exit code that ends the command, or k_exit_well.
int run_stories(const CheckRequest& request, const vulkan::OwnDevice::Settings& settings, const ParallelFor& parallel_for,
                const Console& console, const std::function<int()>& stop_signal, CheckedStories& run) {
    vulkan::OwnDevice::Settings heard = settings;
    heard.on_message = [&run](const std::string& text) {
        ++run.message_count;
        if (run.messages.size() < k_kept_messages)
            run.messages.push_back(text);
    };
    std::unique_ptr<vulkan::OwnDevice> device;
    if (const Fault fault = open_device(heard, device))
        return complain_of(fault, console);
    report_stories_start(run, console);
    const bool cut = device->facts().software && !request.full;
    for (const ParityStory& story : parity_stories()) {
        if (cut && settings.gpu_validation && story.name != k_every_pass_story && story.name != k_obstacles_story)
            continue; // a software device compiles the layer's passes of each grid for minutes
        const auto result = run_parity(*device, cut ? shortened(story, k_software_cell_steps) : story,
                                       {.parallel_for = parallel_for, .stopped = [&] { return stop_signal() != 0; }});
        if (stop_signal() != 0)
            return k_exit_signal + stop_signal();
        if (!result) {
            run.broken.push_back(result.error());
            continue;
        }
        run.stories.push_back(*result);
        report_story(*result, console);
    }
    device.reset(); // the layer tells what was never destroyed
    report_messages(run, console);
    return k_exit_well;
}

} // namespace

bool CheckedStories::pass() const {
    return broken.empty() && message_count == 0 && !stories.empty() &&
           std::all_of(stories.begin(), stories.end(), [](const ParityResult& story) { return story.pass(); });
}

bool CheckResult::pass() const {
    return !runs.empty() && std::all_of(runs.begin(), runs.end(), [](const CheckedStories& run) { return run.pass(); }) &&
           std::all_of(bench.grids.begin(), bench.grids.end(),
                       [](const DeviceGridResult& grid) { return grid.parity <= k_bench_parity; });
}

void add_check(CLI::App& app, std::function<int()>& chosen, const Console& console) {
    CLI::App* const check = app.add_subcommand(
        "check",
        "Hold a Vulkan device against the CPU, under validation where it is installed, and time it; exit 1 where it fails");
    const auto request = std::make_shared<CheckRequest>();
    Flags flags(*check);
    flags.device(request->device);
    flags.seconds(request->seconds, "Time a grid of the benchmark, default 5; on a GPU at least 1000 samples");
    check->add_flag("--gpu-validation", request->gpu_validation, "The stories once more, under GPU-assisted validation");
    check->add_flag("--full", request->full, "All steps of all stories on a software device too: many minutes");
    flags.file("--json", request->json, "File for all figures; written atomically");
    check->callback([=, &chosen, &console] { chosen = interruptible<CheckRequest>(run_check, request, console); });
}

int run_check(const CheckRequest& request, const Console& console, const std::function<int()>& stop_signal) {
    const auto file = request.json ? std::make_unique<OutputFile>(*request.json, "--json") : nullptr;
    if (file)
        if (const auto fault = file->fault())
            return complain_of(fault, console);
    std::unique_ptr<vulkan::OwnDevice> device;
    if (const Fault fault = open_device({.device = request.device}, device))
        return complain_of(fault, console);
    const bool layer = vulkan::has_validation_layer();
    if (request.gpu_validation && !layer) {
        console.complain("--gpu-validation needs VK_LAYER_KHRONOS_validation, which is not installed: install it (Debian: "
                         "vulkan-validationlayers), or drop the flag.");
        return k_exit_machine;
    }
    CheckResult result{.device = device->facts()};
    report_check_start(result.device, console);
    if (result.device.software && !request.full)
        console.warn(
            "a software device runs the large grids for a few steps, and one story under --gpu-validation; --full runs all.");

    const auto pool = make_pool(0, console);
    const auto run_under = [&](const char* name, bool validated, bool gpu) {
        result.runs.push_back({.validation = name, .validated = validated});
        return run_stories(request, {.device = request.device, .validation = validated, .gpu_validation = gpu},
                           pool->parallel_for(), console, stop_signal, result.runs.back());
    };
    if (const int code = run_under(layer ? "core and synchronisation" : "none, the layer is not installed", layer, false);
        code != k_exit_well)
        return code;
    if (request.gpu_validation)
        if (const int code = run_under("GPU-assisted", true, true); code != k_exit_well)
            return code;

    console.out << "\n";
    BenchRequest bench;
    bench.backend = {cases::BackendKind::vulkan, request.device};
    bench.seconds = request.seconds;
    bench.grids.assign(std::begin(k_bench_grids), std::end(k_bench_grids));
    // What the stories found is told whatever becomes of the benchmark.
    const int timed = measure_device(*device, bench, console, stop_signal, result.bench);
    if (timed >= k_exit_signal)
        return timed;
    report_verdict(result, console);
    if (file) {
        file->write(check_json(result));
        if (const auto fault = file->publish())
            return complain_of(fault, console);
        console.out << "In " << request.json->string() << ": all figures.\n";
    }
    return result.pass() ? timed : k_exit_out_of_bounds;
}

} // namespace windrow::cli
