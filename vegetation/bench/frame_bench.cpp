// What a meadow costs a frame: by stage, with and without wind, against the number of blades, with and without culling; how often
// vertices are worked on; where the memory goes.
//
//     windrow_frame_bench [--quick] [--frames N] [--metres M] [--only stages|passes|wind|places|culling|vertices|memory]
//
// A level field of 36 blade places a square metre, settings by default but where a table says otherwise; wind of 32 x 16 x 32
// cells with gusts; someone who walks before the eye and leaves a trail; sun with shadows, clouds. On a GPU 1920 x 1080, fields
// up to 500 m (9,000,000 places), 1000 frames a row after 100 to warm up; on a software device, or with --quick, 640 x 360, 8
// frames after 2, and the table of culling on 50 m (90,000 places). Rows of one table take turns, frame by frame: what else the
// machine does slows them alike, and ratios hold. Times are of the device's clock (Vulkan timestamps): what the CPU does beside
// it is in the column "wall" alone.
#include "fluid/vulkan/own_device.h"
#include "vegetation/bench/counted_memory.h"
#include "vegetation/bench/frame_stage.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

using namespace windrow::vegetation;

namespace {

using windrow::vegetation::bench::FrameCase;
using windrow::vegetation::bench::FrameStage;
using Stages = std::vector<std::unique_ptr<FrameStage>>;

struct Run {
    glm::ivec2 size{1920, 1080};
    int warm = 100, frames = 1000;
    double small_metres = 500.0, metres = 500.0; ///< of the tables of wind and of culling; of the others
    std::string device{}, only{};
    bool software = false;
};

Run run_of(int count, char** arguments) {
    Run run;
    bool quick = false;
    int frames = 0;
    for (int n = 1; n < count; ++n) {
        const bool more = n + 1 < count;
        if (std::strcmp(arguments[n], "--quick") == 0)
            quick = true;
        else if (std::strcmp(arguments[n], "--frames") == 0 && more)
            frames = std::atoi(arguments[++n]);
        else if (std::strcmp(arguments[n], "--metres") == 0 && more)
            run.metres = std::atof(arguments[++n]);
        else if (std::strcmp(arguments[n], "--only") == 0 && more)
            run.only = arguments[++n];
        else {
            std::fprintf(stderr, "windrow_frame_bench [--quick] [--frames N] [--metres M] [--only TABLE]\n");
            std::exit(2);
        }
    }
    const auto devices = windrow::vulkan::list_devices();
    if (!devices) {
        std::fprintf(stderr, "windrow_frame_bench: %s\n", devices.error().c_str());
        std::exit(3);
    }
    // As the engine chooses: a GPU before software.
    const windrow::vulkan::DeviceFacts* chosen = &devices->front();
    for (const auto& device : *devices)
        if (chosen->software && !device.software)
            chosen = &device;
    run.device = chosen->name + ", " + chosen->driver;
    run.software = chosen->software;
    if (quick || run.software) {
        run.size = {640, 360};
        run.warm = 1;
        run.frames = 6;
        run.small_metres = 50.0;
    }
    if (frames > 0)
        run.frames = frames;
    if (!(run.metres >= 16.0 && run.metres <= 500.0)) {
        std::fprintf(stderr, "windrow_frame_bench: --metres is the side of the largest field: give 16 to 500.\n");
        std::exit(2);
    }
    return run;
}

/// What each table belongs to.
void head(const Run& run, const char* title, const char* settings) {
    std::printf("\n## %s\n%s; %d x %d px, 4 samples; %s; %d frames after %d\n", title, run.device.c_str(), run.size.x, run.size.y,
                settings, run.frames, run.warm);
}

std::string field_of(const Run& run) {
    return "field of " + std::to_string(static_cast<int>(run.metres)) + " m";
}

FrameCase base(const Run& run) {
    return {.metres = run.metres,
            .scene_renderer = {.size = run.size, .backend = program::Backend::vulkan}}; // also on a software device
}

void by_stage(const Run& run) {
    head(run, "Frame by stage, ms", (field_of(run) + ", wind 32 x 16 x 32, the eye stands or walks").c_str());
    Stages stages;
    for (const bool moves : {false, true}) {
        FrameCase wanted = base(run);
        wanted.moves = moves;
        stages.push_back(std::make_unique<FrameStage>(wanted));
    }
    draw_in_turn(stages, run.warm, run.frames);
    std::printf("| %-9s | %8s | %8s | %8s | %8s | %8s | %8s |\n|---|---|---|---|---|---|---|\n", "stage", "mean", "median",
                "99 %", "walks", "median", "99 %");
    const auto stands = stages[0]->stages(), walks = stages[1]->stages();
    for (std::size_t n = 0; n < std::min(stands.size(), walks.size()); ++n)
        std::printf("| %-9s | %8.3f | %8.3f | %8.3f | %8.3f | %8.3f | %8.3f |\n", stands[n].name.c_str(), stands[n].mean,
                    stands[n].median, stands[n].max, walks[n].mean, walks[n].median, walks[n].max);
    std::printf("| %-9s | %8.3f |          |          | %8.3f |          |          |\n", "wall", stages[0]->wall(),
                stages[1]->wall());
}

void wind_passes(const Run& run) {
    head(run, "The wind's passes, ms", "field of 16 m, each pass timed; a tick a frame, of 1/60 s");
    FrameCase wanted = base(run);
    wanted.metres = 16.0;
    wanted.scene_renderer.pass_times = true;
    Stages stages;
    stages.push_back(std::make_unique<FrameStage>(wanted));
    std::vector<std::pair<std::string, double>> sums;
    double whole = 0.0;
    int counted = 0;
    for (int n = 0; n < run.warm + run.frames; ++n) {
        stages[0]->draw(n >= run.warm);
        const auto times = stages[0]->scene_renderer().air().pass_times();
        if (n < run.warm || !times)
            continue;
        for (const auto& pass : times->passes) { // a frame without a tick has fewer kinds of them
            auto known = std::find_if(sums.begin(), sums.end(), [&](const auto& sum) { return sum.first == pass.name; });
            if (known == sums.end())
                known = sums.insert(known, {pass.name, 0.0});
            known->second += pass.us;
        }
        whole += times->whole_us;
        ++counted;
    }
    if (counted == 0)
        return (void)std::printf("this device counts no time\n");
    double all = 0.0;
    std::printf("| pass | mean |\n|---|---|\n");
    for (const auto& [name, us] : sums) {
        all += us;
        if (us > 0.0)
            std::printf("| %s | %.4f |\n", name.c_str(), 1e-3 * us / counted);
    }
    std::printf("| all passes | %.4f |\n| with copies and barriers | %.4f |\n", 1e-3 * all / counted, 1e-3 * whole / counted);
}

void wind_on_and_off(const Run& run) {
    char settings[128];
    std::snprintf(settings, sizeof settings, "field of %g m; off: no step is recorded and nothing blows; medians",
                  run.small_metres);
    head(run, "Wind on and off, ms", settings);
    std::printf("| cells | off | on | on - off | wind's stage | on / off |\n|---|---|---|---|---|---|\n");
    for (const glm::ivec3 cells : {glm::ivec3(16), glm::ivec3(32, 16, 32), glm::ivec3(64, 32, 64)}) {
        Stages stages;
        for (const bool wind : {false, true}) {
            FrameCase wanted = base(run);
            wanted.metres = run.small_metres;
            wanted.cells = cells;
            wanted.scene_renderer.wind = wind;
            stages.push_back(std::make_unique<FrameStage>(wanted));
        }
        draw_in_turn(stages, run.warm, run.frames);
        const double off = stages[0]->median(), on = stages[1]->median();
        const auto all = stages[1]->stages();
        std::printf("| %d x %d x %d | %.3f | %.3f | %.3f | %.3f | %.2f |\n", cells.x, cells.y, cells.z, off, on, on - off,
                    all.empty() ? 0.0 : all.front().median, on / off);
    }
}

void against_places(const Run& run) {
    head(run, "Cost against blade places, ms", "wind 32 x 16 x 32; medians");
    std::printf("| field | places | frame | prepare | shadow | colour | over the smallest | grass, MB "
                "|\n|---|---|---|---|---|---|---|---|\n");
    Stages stages;
    for (const double metres : {16.0, 50.0, 160.0, 500.0})
        if (metres <= run.metres) {
            FrameCase wanted = base(run);
            wanted.metres = metres;
            stages.push_back(std::make_unique<FrameStage>(wanted));
        }
    draw_in_turn(stages, run.warm, run.frames);
    for (const auto& stage : stages) {
        const auto all = stage->stages();
        const auto of = [&](const char* name) {
            for (const auto& each : all)
                if (each.name == name)
                    return each.median;
            return 0.0;
        };
        std::printf("| %.0f m | %.0f | %.3f | %.3f | %.3f | %.3f | %.2f | %.1f |\n", std::sqrt(stage->places()) / 6.0,
                    stage->places(), stage->median(), of("prepare"), of("shadow"), of("colour"),
                    stage->median() / stages.front()->median(),
                    1e-6 * static_cast<double>(stage->scene_renderer().memory().grass));
    }
}

struct FrameVariant {
    const char* name;
    grass::Culling culling;
    bool levels, cut;
};

constexpr FrameVariant k_kinds[] = {{"none", grass::Culling::none, false, false},
                                    {"quadtree", grass::Culling::chunks, false, false},
                                    {"quadtree, GPU culling by blade", grass::Culling::blades, false, false},
                                    {"quadtree, GPU culling, levels", grass::Culling::blades, true, false},
                                    {"all of it and the cut at 90 m", grass::Culling::blades, true, true}};

void ablation(const Run& run) {
    char settings[256];
    std::snprintf(settings, sizeof settings,
                  "field of %g m; no shadows of grass, no thinning, 15 vertices a blade without levels, no cut within the field "
                  "without it; medians",
                  run.small_metres);
    head(run, "What culling saves", settings);
    Stages stages;
    const int side = static_cast<int>(std::ceil(run.small_metres / 16.0));
    for (const FrameVariant& kind : k_kinds) {
        FrameCase wanted = base(run);
        wanted.metres = run.small_metres;
        wanted.grass.culling = kind.culling;
        wanted.grass.shadow_distance = 0.0f;
        if (!kind.cut) {
            wanted.grass.cut_distance = 2.0f * static_cast<float>(wanted.metres);
            wanted.grass.fade_from = 0.98f;
            wanted.grass.max_chunks = std::max(160, side * side);
        }
        if (!kind.levels) {
            wanted.grass.split_distance = 0.999f * wanted.grass.cut_distance;
            wanted.grass.morph_from = 0.98f;
        }
        wanted.scene_renderer.counts = true;
        // A record for each blade that stands; where a device has no buffer for that many, those beyond share one.
        wanted.scene_renderer.max_blades =
            static_cast<int>(std::min(4194304.0, std::max(262144.0, 36.0 * wanted.metres * wanted.metres)));
        stages.push_back(std::make_unique<FrameStage>(wanted));
    }
    draw_in_turn(stages, run.warm, run.frames);
    std::printf("| | frame | colour | none / frame | vertices drawn | vertex stage ran | factor | fragments "
                "|\n|---|---|---|---|---|---|---|---|\n");
    for (std::size_t n = 0; n < stages.size(); ++n) {
        const render::VertexCounts counts = stages[n]->scene_renderer().counts();
        double colour = 0.0;
        for (const auto& each : stages[n]->stages())
            if (each.name == "colour")
                colour = each.median;
        std::printf("| %s | %.3f | %.3f | %.2f | %llu | %llu | %.3f | %llu |\n", k_kinds[n].name, stages[n]->median(), colour,
                    stages[0]->median() / stages[n]->median(), static_cast<unsigned long long>(counts.vertices),
                    static_cast<unsigned long long>(counts.invocations),
                    counts.vertices > 0 ? static_cast<double>(counts.invocations) / static_cast<double>(counts.vertices) : 0.0,
                    static_cast<unsigned long long>(counts.fragments));
    }
    std::printf(
        "theirs (GTX 1660 Ti, another scene): none 13.3 ms, quadtree 5.9, and GPU culling 6.7: none / frame 2.25 and 1.99; "
        "11.8, 9.1, 7.1: 1.30 and 1.66\n");
}

void vertex_factors(const Run& run) {
    head(run, "Vertices of the colour pass, by the device's counters",
         (field_of(run) + ", default settings; last frame").c_str());
    FrameCase wanted = base(run);
    wanted.scene_renderer.counts = true;
    FrameStage stage(wanted);
    stage.draw(true);
    const render::VertexCounts of = stage.scene_renderer().counts();
    if (of.vertices == 0)
        return (void)std::printf("this device counts no vertices (pipelineStatisticsQuery)\n");
    std::printf("| vertices drawn | vertex stage ran | factor | fragments |\n|---|---|---|---|\n| %llu | %llu | %.3f | %llu |\n",
                static_cast<unsigned long long>(of.vertices), static_cast<unsigned long long>(of.invocations),
                static_cast<double>(of.invocations) / static_cast<double>(of.vertices),
                static_cast<unsigned long long>(of.fragments));
}

bool memory(const Run& run) {
    head(run, "Device memory, bytes", (field_of(run) + ", default settings").c_str());
    const std::uint64_t before = windrow::vegetation::bench::allocated_bytes();
    const FrameStage stage(base(run));
    const std::uint64_t allocated = windrow::vegetation::bench::allocated_bytes() - before;
    const program::SceneRendererMemory of = stage.scene_renderer().memory();
    const std::uint64_t sum = of.targets + of.wind + of.grass + of.ground_memory + of.room;
    std::printf("| kind | bytes | share |\n|---|---|---|\n");
    const auto row = [sum](const char* name, std::uint64_t bytes) {
        std::printf("| %s | %llu | %.1f %% |\n", name, static_cast<unsigned long long>(bytes),
                    100.0 * static_cast<double>(bytes) / static_cast<double>(sum));
    };
    row("pictures, shadow map, read-backs, heights of the ground", of.targets);
    row("wind", of.wind);
    row("grass", of.grass);
    row("ground's memory", of.ground_memory);
    row("room left in blocks of wind and ground's memory", of.room);
    row("sum", sum);
    row("by vkAllocateMemory", allocated);
    std::printf("%s\n", sum == allocated ? "equal" : "NOT EQUAL: something is allocated that no kind counts");
    return sum == allocated;
}

} // namespace

int main(int count, char** arguments) {
    const Run run = run_of(count, arguments);
    const struct {
        const char* name;
        void (*measure)(const Run&);
    } tables[] = {{"stages", by_stage},       {"passes", wind_passes}, {"wind", wind_on_and_off},
                  {"places", against_places}, {"culling", ablation},   {"vertices", vertex_factors}};
    for (const auto& table : tables)
        if (run.only.empty() || run.only == table.name)
            table.measure(run);
    if (!run.only.empty() && run.only != "memory")
        return 0;
    return memory(run) ? 0 : 1;
}
