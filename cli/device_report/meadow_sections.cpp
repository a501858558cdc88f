// Vertices alone, frames of a meadow, and three pictures.
#include "cli/device_report/meadow.h"
#include "cli/device_report/png.h"
#include "cli/device_report/report_section.h"
#include "cli/output_file.h"
#include "fluid/core/message.h"

#include <algorithm>
#include <utility>

namespace windrow::cli {
namespace {

using detail::message;
using vulkan::Device;

constexpr VkExtent2D k_full_hd{1920, 1080};
constexpr std::uint32_t k_blades[] = {250'000, 1'000'000, 4'000'000};
constexpr const char *k_drawn = "frame of 1920 x 1080", *k_vertices = "vertices alone";
constexpr double k_warm_fraction = 0.3;
constexpr int k_steps = 90, k_quick_steps = 45; // of the wind before it is drawn: three seconds, half of them

struct Prepared {
    std::unique_ptr<Device> device; // before what is made from it
    std::unique_ptr<Meadow> meadow;
};

Result<Prepared> prepare(SectionRun& run) {
    auto device = Device::create(run.own.host());
    if (!device)
        return device.failure();
    auto meadow = Meadow::create(run.own, **device);
    if (!meadow)
        return meadow.failure();
    const bool few = run.quick && run.own.facts().software;
    if (auto blown = (*meadow)->blow(few ? k_quick_steps : k_steps, [&] { return run.clock.stopped(); }); !blown)
        return blown.failure();
    return Prepared{*std::move(device), *std::move(meadow)};
}

bool cannot_draw(SectionRun& run, const char* what) {
    if (!run.own_draws)
        run.leave_out(message(what, ": the device has no queue that draws."));
    return !run.own_draws;
}

// One kind of draws; the seconds that one took, or nothing where it was stopped.
Result<std::optional<double>> measure(SectionRun& run, Prepared& scene, const DrawHost::Target& target,
                                      const std::vector<DrawHost::Draw>& draws, const char* what, double seconds) {
    auto contest = DeviceContest::create(run.own, *scene.device);
    if (!contest)
        return contest.failure();
    const auto draw = [&](VkCommandBuffer commands) { scene.meadow->host().record(commands, target, draws); };
    const bool software = run.own.facts().software; // whose clock rate does not change
    contest->add({.warm = [&, software](VkCommandBuffer commands) { software ? void() : draw(commands); },
                  .run = [&](VkCommandBuffer commands, const auto&) { draw(commands); }});
    const auto held = contest->hold({.seconds = seconds, .warm_seconds = software ? 0.0 : k_warm_fraction * seconds},
                                    [&] { return run.clock.stopped(); });
    if (!held)
        return held.failure();
    if (*held == DeviceContest::End::stopped)
        return std::optional<double>();
    const DeviceSpread us = contest->microseconds(0);
    const double vertices = static_cast<double>(k_blade_vertices) * draws.back().instances;
    run.json["frames"].push_back({{"drawn", what},
                                  {"blades", draws.back().instances},
                                  {"us", spread_json(us)},
                                  {"ns_per_vertex", four_digits(1e3 * us.median / vertices)}});
    return std::optional(1e-6 * us.median);
}

Result<void> save(SectionRun& run, DrawHost& host, const DrawHost::Target& target, const std::vector<DrawHost::Draw>& draws,
                  const char* name, const char* text) {
    if (auto ran = run.own.run([&](VkCommandBuffer commands) { host.record(commands, target, draws); }); !ran)
        return ran;
    const auto pixels = host.pixels(target);
    if (!pixels)
        return pixels.failure();
    OutputFile file(run.folder / name);
    file.write(png_of(static_cast<int>(target.extent.width), static_cast<int>(target.extent.height), *pixels));
    if (const Fault fault = file.publish())
        return Error{fault.sentence};
    run.json["pictures"].push_back({{"file", name}, {"shows", text}});
    return {};
}

} // namespace

Result<void> report_meadow(SectionRun& run) {
    if (cannot_draw(run, "frames"))
        return {};
    auto scene = prepare(run);
    if (!scene)
        return scene.failure();
    DrawHost& host = scene->meadow->host();
    const auto nothing = host.target(k_full_hd, VK_SAMPLE_COUNT_1_BIT, false),
               picture = host.target(k_full_hd, VK_SAMPLE_COUNT_1_BIT);
    if (!nothing || !picture)
        return nothing ? picture.failure() : nothing.failure();
    double blade_seconds = 0.0; // that a blade took before, vertices alone or drawn, the larger
    for (const std::uint32_t blades : k_blades) {
        if (auto looked = scene->meadow->look(Meadow::Eye::walking, k_full_hd, blades); !looked)
            return looked;
        const auto vertices = scene->meadow->vertices(*nothing, blades);
        const auto frame = scene->meadow->frame(*picture, blades);
        if (!vertices || !frame)
            return vertices ? frame.failure() : vertices.failure();
        for (const bool drawn : {false, true}) {
            // A round that warms up, and one that counts. The fewest blades are drawn however little time there is.
            if (blades == k_blades[0] ? run.clock.stopped()
                                      : run.clock.over() || 2.0 * blade_seconds * blades > run.clock.left()) {
                run.leave_out(message(drawn ? "a frame" : "vertices", " of ", blades, " blades: the time is up."));
                run.leave_out_row("frames", {{"drawn", drawn ? k_drawn : k_vertices}, {"blades", blades}}, "time");
                continue;
            }
            const auto took = measure(run, *scene, drawn ? *picture : *nothing, drawn ? *frame : *vertices,
                                      drawn ? k_drawn : k_vertices, 0.12 * run.clock.budget());
            if (!took)
                return took.failure();
            if (!*took)
                return {};
            blade_seconds = std::max(blade_seconds, **took / blades);
        }
    }
    return {};
}

Result<void> report_pictures(SectionRun& run) {
    if (cannot_draw(run, "pictures"))
        return {};
    auto scene = prepare(run);
    if (!scene)
        return scene.failure();
    if (run.clock.stopped())
        return {};
    Meadow& meadow = *scene->meadow;
    DrawHost& host = meadow.host();
    const bool few = run.quick && run.own.facts().software;
    const VkExtent2D extent = few ? VkExtent2D{960, 540} : k_full_hd;
    const std::uint32_t blades = few ? 120'000 : 500'000;
    const auto target = host.target(extent, VK_SAMPLE_COUNT_4_BIT);
    if (!target)
        return target.failure();
    const auto frame = meadow.frame(*target, blades), slices = meadow.slices(*target);
    if (!frame || !slices)
        return frame ? slices.failure() : frame.failure();
    struct View {
        Meadow::Eye eye;
        const char *file, *text;
    };
    constexpr View views[] = {{Meadow::Eye::walking, "meadow.png", "a meadow in gusts, with a walker's wake and a fan"},
                              {Meadow::Eye::above, "meadow_above.png", "the same from above: pale blades lean"}};
    for (const View& view : views) {
        if (auto looked = meadow.look(view.eye, extent, blades); !looked)
            return looked;
        if (auto saved = save(run, host, *target, *frame, view.file, view.text); !saved)
            return saved;
    }
    return save(run, host, *target, *slices, "wind.png", "speed of its wind, from the side and from above");
}

} // namespace windrow::cli
