// The meadows that frame_bench.cpp measures, and frames of them, timed.
#pragma once

#include "vegetation/program/scene_renderer.h"
#include "vegetation/program/stage_table.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace windrow::vegetation::bench {

struct FrameCase {
    double metres = 500.0;        ///< [m] side of a level field of 36 blade places a square metre: 9,000,000
    glm::ivec3 cells{32, 16, 32}; ///< of the air, 0.5 m each
    bool moves = false;           ///< the eye walks, 2 m/s; else it stands in the middle, 1.7 m high
    bool walker = true;           ///< someone walks before the eye, with a wake, on ground that remembers
    grass::GrassSettings grass{};
    program::SceneRendererSettings scene_renderer{};
};

/// A case that is ready to be drawn: settled, its chunks made by a first frame.
class FrameStage {
  public:
    /// Ends the program with a sentence where the machine lacks something.
    explicit FrameStage(const FrameCase& wanted);

    /// Draws a frame, `timed` or to warm up.
    void draw(bool timed);
    [[nodiscard]] const program::SceneRenderer& scene_renderer() const { return *scene_renderer_; }
    /// Stages of the timed frames, by the device's clock; the last is the frame, their sum.
    [[nodiscard]] std::vector<program::StageFigures> stages() const { return table_.figures(); }
    /// [ms] Timed frames on the wall's clock, recording, submission and waiting included: mean.
    [[nodiscard]] double wall() const { return wall_ / static_cast<double>(timed_); }
    /// [ms] Median of the timed frames: on a machine with other work the mean tells of that too.
    [[nodiscard]] double median() const;
    [[nodiscard]] double places() const;

  private:
    std::unique_ptr<program::PictureScene> scene_{};
    std::unique_ptr<program::SceneRenderer> scene_renderer_{};
    program::StageTable table_{};
    double wall_ = 0.0;
    int timed_ = 0;
};

/// Draws frames of all in turn, so that what else the machine does slows all of them: `warm` untimed ones, then `frames`.
void draw_in_turn(std::span<const std::unique_ptr<FrameStage>> stages, int warm, int frames);

} // namespace windrow::vegetation::bench
