#include "vegetation/bench/frame_stage.h"

#include "vegetation/program/picture_reader.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vulkan/vulkan.h>

namespace windrow::vegetation::bench {
namespace {

void must(const Result<void>& result) {
    if (result)
        return;
    std::fprintf(stderr, "windrow_frame_bench: %s\n", result.error().c_str());
    std::exit(3);
}

std::string scene_of(const FrameCase& wanted) {
    char text[4096];
    const double middle = 0.5 * wanted.metres;
    std::snprintf(
        text, sizeof text, R"({
        "duration": 120,
        "frames_per_second": 60,
        "air": {"cells": [%d, %d, %d], "cell_size": 0.5, "boundaries": {"y_low": "free_slip"}, "ambient": [3.4, 0, 1.3],
                "profile": {"roughness_length": 0.05, "reference_height": 10}, "gusts": {"intensity": 0.35, "length": 14}},
        "paths": {"eye": {"points": [[0, %g, 1.7, %g], [%g, %g, 1.7, %g]]},
                  "target": {"points": [[0, %g, 0.8, %g], [%g, %g, 0.8, %g]]},
                  "walker": {"points": [[0, %g, 0, %g], [120, %g, 0, %g]]}},
        "follow": "eye",
        "floor": 0,
        "motors": [%s],
        "picture": {
            "warm_up": 0.5,
            "camera": {"path": "eye", "target_path": "target", "view_deg": 50, "far": 2000},
            "clouds": {"cover": 0.4},
            "ground": {"corner": [0, 0, 0], "extent": [%g, %g]},
            "grass": [{"name": "grass", "class": "grass"}],
            "walkers": [%s],
            "ground_memory": {}
        }
    })",
        wanted.cells.x, wanted.cells.y, wanted.cells.z, middle, middle, wanted.moves ? 60.0 : 1.0, middle,
        middle - (wanted.moves ? 120.0 : 0.0), middle, middle - 10.0, wanted.moves ? 60.0 : 1.0, middle,
        middle - 10.0 - (wanted.moves ? 120.0 : 0.0), middle - 2.0, middle - 4.0, middle - 2.0, middle - 64.0,
        wanted.walker
            ? R"({"kind": "wake", "path": "walker", "radius": 0.4, "law": {"drive": {"per_metre": 8, "entrainment": 1}}})"
            : "",
        wanted.metres, wanted.metres, wanted.walker ? R"({"path": "walker"})" : "");
    return text;
}

} // namespace

FrameStage::FrameStage(const FrameCase& wanted) {
    auto read = program::read_picture_scene_text(scene_of(wanted), "frame_bench");
    if (!read)
        must(read.failure());
    scene_ = std::make_unique<program::PictureScene>(*std::move(read));
    scene_->picture.grass.front().drawn.field = wanted.grass;
    program::SceneRendererSettings settings = wanted.scene_renderer;
    settings.get_instance_proc_addr = vkGetInstanceProcAddr; // this program's, which counts memory
    auto made = program::SceneRenderer::create(*scene_, settings);
    if (!made)
        must(made.failure());
    scene_renderer_ = *std::move(made);
    must(scene_renderer_->warm_up());
    must(scene_renderer_->draw(false));
    table_ = program::StageTable(*scene_renderer_);
}

void FrameStage::draw(bool timed) {
    const auto start = std::chrono::steady_clock::now();
    must(scene_renderer_->draw(false));
    if (!timed)
        return;
    wall_ += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    ++timed_;
    table_.add(scene_renderer_->frame(), scene_renderer_->times());
}

double FrameStage::median() const {
    const auto all = table_.figures();
    return all.empty() ? wall() : all.back().median;
}

double FrameStage::places() const {
    const auto cells = scene_renderer_->grass().front()->field().tree().cells();
    return static_cast<double>(cells.x) * cells.y;
}

void draw_in_turn(std::span<const std::unique_ptr<FrameStage>> stages, int warm, int frames) {
    for (int n = 0; n < warm + frames; ++n)
        for (const auto& stage : stages)
            stage->draw(n >= warm);
}

} // namespace windrow::vegetation::bench
