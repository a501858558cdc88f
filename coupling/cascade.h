// Lag of fur and shells behind their body: a cascade of first-order stages, each following the one inside it, solved exactly.
//
//     auto tail = windrow::Cascade::create({.stages = 10, .lag = 0.25}, body_pose);
//     (void)tail->advance(frame_seconds, body_pose);
//     upload(tail->shader_poses(anchor), tail->previous_shader_poses(anchor));        // shaders/numerics/cascade.glsl
//     windrow::Pose tip = tail->at(1.0);                                              // or here, at any height
//
// Stages are not shells: if each shell were a stage, 200 shells would lag ten times as long as 20. Here the stages give a fixed
// profile over the height of the fur, and any number of shells reads it. Positions and rotations go through the cascade; scale is
// the body's own. The body moves in straight lines between two frames. Its rotation goes as a quaternion along the chord, not the
// arc: below a radian per frame the difference is below 1 % of the turn.
#pragma once

#include "../fluid/api.h"
#include "../fluid/result.h"
#include "../fluid/setting.h"
#include "cascade_step.h"
#include "motion_blocks.h"

#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace windrow {

/// Pose of a body or a shell.
struct Pose {
    glm::dvec3 position{0.0};                ///< [m] in the world
    glm::dvec4 rotation{0.0, 0.0, 0.0, 1.0}; ///< quaternion x, y, z, w; any length but 0 on input, 1 on output
    double scale = 1.0;                      ///< above 0
};

/// Stages of a cascade and its lag behind the body.
struct CascadeConfig {
    /// 1 to 64, default 10. Number of stages. With more the tip waits and then moves at once, with fewer it drags: its lag
    /// spreads by lag / sqrt(stages). 10 is the choice of Bloodelic's stylised fur.
    int stages = 10;
    /// [s] A number above 0, at most 60, default 0.25. Mean delay of the tip; shells lag in proportion to their height. 0.25 is
    /// visible and ends within a few frames.
    double lag = 0.25;

    static constexpr auto settings() {
        return std::tuple{
            Setting("stages", &CascadeConfig::stages, {1.0, 64.0},
                    "Number of stages. With more the tip waits and then moves at once, with fewer it drags: its lag spreads by "
                    "lag / sqrt(stages). 10 is the choice of Bloodelic's stylised fur."),
            Setting("lag", &CascadeConfig::lag, Range::above(0.0, 60.0, "s"),
                    "Mean delay of the tip; shells lag in proportion to their height. 0.25 is visible and "
                    "ends within a few frames."),
        };
    }
};

/// Rejects stages or lag out of range.
[[nodiscard]] WINDROW_API Result<void> validate(const CascadeConfig& config);
/// Rejects what is not finite, a rotation of length 0, a scale that is not above 0.
[[nodiscard]] WINDROW_API Result<void> validate(const Pose& pose);

class WINDROW_API Cascade {
  public:
    /// All stages rest at the body.
    [[nodiscard]] static Result<Cascade> create(const CascadeConfig& config, const Pose& body);

    /// The body has moved to `body` within `duration` [s], 0 or more. Rejects an invalid pose or duration and changes nothing
    /// then. Does not allocate.
    Result<void> advance(double duration, const Pose& body);
    /// A teleport: all stages at the body, at rest, with no motion vector. Rejects as `validate`.
    Result<void> reset(const Pose& body);
    /// A teleport that takes the lag along: all positions, the last frame's too, move by `offset` [m]. Rejects what is not
    /// finite.
    Result<void> move(glm::dvec3 offset);

    /// The pose at a height of 0 (the body) to 1 (the tip); other heights are clamped.
    [[nodiscard]] Pose at(double height) const;
    /// The same before the last `advance`: the difference is this frame's motion vector.
    [[nodiscard]] Pose previous_at(double height) const;

    /// The body and the stages for shaders, stages + 1 of them; positions relative to `anchor` [m]. Good until the next call.
    [[nodiscard]] std::span<const PoseBlock> shader_poses(glm::dvec3 anchor);
    /// The same before the last `advance`.
    [[nodiscard]] std::span<const PoseBlock> previous_shader_poses(glm::dvec3 anchor);
    [[nodiscard]] const CascadeConfig& config() const { return config_; }

    /// All of it as bytes.
    [[nodiscard]] Result<std::vector<std::byte>> save() const;
    /// Goes on to the bit as the one that was saved. Rejects bytes that `save` did not return.
    [[nodiscard]] static Result<Cascade> load(std::span<const std::byte> bytes);

  private:
    static constexpr std::size_t k_parts = 7; // x, y, z of the position, x, y, z, w of the rotation

    struct Row {
        double body[k_parts] = {};
        std::vector<double> stages; // [stage - 1][part]
        double scale = 1.0;
    };
    Cascade(const CascadeConfig& config, CascadeStep step) : config_(config), step_(std::move(step)) {}
    static void fields(auto& archive, auto& row);
    [[nodiscard]] Pose read(const Row& row, double height) const;
    [[nodiscard]] static std::span<const PoseBlock> poses_of(const Row& row, glm::dvec3 anchor, std::vector<PoseBlock>& poses);

    CascadeConfig config_;
    CascadeStep step_;
    Row now_, before_;
    std::vector<PoseBlock> poses_, previous_poses_;
};

} // namespace windrow
