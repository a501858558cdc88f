// The tables of fur_bench.cpp: each draws its cases in turn and prints markdown.
#pragma once

#include "vegetation/bench/fur_stage.h"

#include <filesystem>
#include <string>

namespace windrow::vegetation::bench {

struct FurRun {
    glm::ivec2 size{1920, 1080};
    int warm = 100, frames = 1000;
    std::string device{};             ///< with its driver
    std::filesystem::path pictures{}; ///< empty: none are written
};

void scenes_table(const FurRun& run);
void layers_table(const FurRun& run);
void order_table(const FurRun& run);
void shadow_table(const FurRun& run);
void body_table(const FurRun& run);
void lamps_table(const FurRun& run);
void clouds_table(const FurRun& run);
void wind_at_table(const FurRun& run);
void plane_table(const FurRun& run);
void wind_table(const FurRun& run);

/// What a table's cases cost: filled by `measured`.
struct Measured {
    FurStages stages{};
    std::vector<CoatCosts> costs{};
};

/// Draws the cases in turn, then counts each and writes its picture. Prints the table's head before: what the figures belong to.
[[nodiscard]] Measured measured(const FurRun& run, const char* title, const char* settings, std::vector<FurCase> cases);
/// Medians of the stages in ms, and the ratio of each row's frame and colour pass to those of row `over`.
void print_times(const Measured& of, std::size_t over = 0);
/// By the counters: vertices and fragments of the coats in the colour pass.
void print_counts(const Measured& of);

} // namespace windrow::vegetation::bench
