// What wind on coats costs: clouds that drift, where strands feel the wind, with and without it.
#include "vegetation/bench/fur_scenes.h"
#include "vegetation/bench/fur_tables.h"

#include <cmath>
#include <cstdio>

namespace windrow::vegetation::bench {
namespace {

FurCase plane_case(std::string name, int cells, fur::WindAt at) {
    fur::CoatSettings coat = fur(32);
    coat.wind_at = at;
    coat.comb = {};
    return {.name = std::move(name),
            .coats = {{.mesh = sheet_of(2.0f, cells), .settings = coat}},
            .from = {0.0, 1.3, 2.2},
            .to = {0.0, 0.0, 0.1},
            .view_deg = 40.0f,
            .gusts = 0.8f,
            .gust_length = 2.0f};
}

} // namespace

void clouds_table(const FurRun& run) {
    std::vector<FurCase> cases;
    for (const int layers : {128, 16}) {
        FurCase wanted{.name = "cloud, " + std::to_string(layers) + " shells"};
        wanted.coats.push_back({.mesh = sheet_of(200.0f, 8), .settings = cloud(layers), .place = {0.0, 60.0, 0.0}});
        wanted.from = {0.0, 0.0, 150.0};
        wanted.to = {0.0, 50.0, 0.0};
        wanted.view_deg = 55.0f;
        cases.push_back(std::move(wanted));
    }
    const Measured of =
        measured(run, "Clouds", "200 m x 200 m, 28 m high, heaps of 50 m, 4 cel steps, march 4", std::move(cases));
    print_times(of, 1);
    print_counts(of);
}

void wind_at_table(const FurRun& run) {
    std::vector<FurCase> cases;
    for (const auto& [name, at] :
         {std::pair{"wind at the strand", fur::WindAt::strand}, std::pair{"at each shell", fur::WindAt::shell},
          std::pair{"at each pixel", fur::WindAt::pixel}}) {
        cases.push_back(fur_scene(name, 32));
        cases.back().coats.front().settings.wind_at = at;
    }
    const Measured of = measured(run, "Where the wind is felt", "fur of 32 layers on the sphere", std::move(cases));
    print_times(of);
    print_counts(of);
}

void plane_table(const FurRun& run) {
    std::vector<FurCase> cases;
    cases.push_back(plane_case("4 vertices, at each pixel", 1, fur::WindAt::pixel));
    cases.push_back(plane_case("128 x 128 cells, at the strand", 128, fur::WindAt::strand));
    cases.push_back(plane_case("4 vertices, at the strand", 1, fur::WindAt::strand));
    const Measured of = measured(run, "A plane of four vertices against a fine one",
                                 "2 m x 2 m of fur, 32 layers; gusts 0.8 of 2 m", std::move(cases));
    print_times(of);
    print_counts(of);
    // All three have had the same wind for as many frames.
    const render::PictureF fine = of.stages[1]->light();
    const auto off = [&](FurStage& stage) {
        const render::PictureF other = stage.light();
        double sum = 0.0, all = 0.0;
        for (std::size_t n = 0; n < fine.values.size(); ++n) {
            sum += std::abs(fine.values[n] - other.values[n]);
            all += fine.values[n];
        }
        return sum / all;
    };
    const double pixel = off(*of.stages[0]), strand = off(*of.stages[2]);
    std::printf("\nMean difference of light from the fine plane's: four vertices, at each pixel %.4f, at the strand %.4f\n",
                pixel, strand);
}

void wind_table(const FurRun& run) {
    std::vector<FurCase> cases;
    const auto add = [&](const char* name, glm::ivec3 cells) {
        cases.push_back(fur_scene(name, 32));
        cases.back().wind = cells.x > 0;
        cases.back().cells = cells;
        cases.back().coats.front().settings.levels.shadow_shells = 16;
    };
    add("off: no step is recorded, nothing blows", {});
    add("on, 16 x 16 x 16", glm::ivec3(16));
    add("on, 32 x 16 x 32", {32, 16, 32});
    const Measured of = measured(run, "Wind on and off", "fur of 32 layers on the sphere, shadow of 16", std::move(cases));
    print_times(of);
    std::printf("\n| | the wind's stage, of the frame |\n|---|---|\n");
    for (const auto& stage : of.stages)
        std::printf("| %s | %.1f %% |\n", stage->wanted().name.c_str(), 100.0 * stage->median("wind") / stage->median("frame"));
}

} // namespace windrow::vegetation::bench
