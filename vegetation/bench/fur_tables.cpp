#include "vegetation/bench/fur_tables.h"

#include <cstdio>

namespace windrow::vegetation::bench {

Measured measured(const FurRun& run, const char* title, const char* settings, std::vector<FurCase> cases) {
    std::printf(
        "\n## %s\n%s; %d x %d px, %d sample%s; %s; %d frames after %d; ms, medians; ratios: medians of the turns' ratios\n\n",
        title, run.device.c_str(), run.size.x, run.size.y, cases.front().samples, cases.front().samples == 1 ? "" : "s", settings,
        run.frames, run.warm);
    Measured made;
    for (FurCase& each : cases) {
        each.size = run.size;
        made.stages.push_back(std::make_unique<FurStage>(std::move(each)));
    }
    draw_in_turn(made.stages, run.warm, run.frames);
    for (const auto& stage : made.stages)
        made.costs.push_back(stage->count(run.pictures));
    return made;
}

void print_times(const Measured& of, std::size_t over) {
    const FurStage& base = *of.stages[over];
    std::printf("| | frame | least | wind | prepare | shadow | colour | frame / \"%s\" | colour / same |\n"
                "|---|---|---|---|---|---|---|---|---|\n",
                base.wanted().name.c_str());
    for (const auto& stage : of.stages)
        std::printf("| %s | %.1f | %.1f | %.1f | %.1f | %.1f | %.1f | %.2f | %.2f |\n", stage->wanted().name.c_str(),
                    stage->median("frame"), stage->least("frame"), stage->median("wind"), stage->median("prepare"),
                    stage->median("shadow"), stage->median("colour"), ratio(*stage, base), ratio(*stage, base, "colour"));
}

void print_counts(const Measured& of) {
    if (of.costs.front().colour.vertices == 0)
        return (void)std::printf("\nthis device counts no vertices (pipelineStatisticsQuery)\n");
    std::printf(
        "\n| | vertices | vertex stage ran | factor | with shadows | fragments | a pixel of the coats | written | a pixel "
        "|\n|---|---|---|---|---|---|---|---|---|\n");
    for (std::size_t n = 0; n < of.stages.size(); ++n) {
        const CoatCosts& cost = of.costs[n];
        const auto vertices = static_cast<double>(of.stages[n]->vertices());
        const std::uint64_t shadows = cost.shadow[0].invocations + cost.shadow[1].invocations;
        std::printf(
            "| %s | %.0f | %llu | %.2f | %.2f | %llu | %.1f | %llu | %.2f |\n", of.stages[n]->wanted().name.c_str(), vertices,
            static_cast<unsigned long long>(cost.colour.invocations), static_cast<double>(cost.colour.invocations) / vertices,
            static_cast<double>(cost.colour.invocations + shadows) / vertices,
            static_cast<unsigned long long>(cost.colour.fragments),
            static_cast<double>(cost.colour.fragments) / static_cast<double>(cost.pixels),
            static_cast<unsigned long long>(cost.written), static_cast<double>(cost.written) / static_cast<double>(cost.pixels));
    }
}

} // namespace windrow::vegetation::bench
