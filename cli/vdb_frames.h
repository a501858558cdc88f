// VDB files of a run: the wind, and what else the scene's "vdb" asks for. Built with OpenVDB alone.
#pragma once

#include "cli/film_request.h"
#include "cli/output_file.h"
#include "cli/playback.h"
#include "fluid/tracer.h"
#include "fluid/vdb/vdb_export.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace windrow::cli {

class VdbFrames {
  public:
    /// The scene outlives it.
    VdbFrames(const scene::Scene& scene, std::filesystem::path folder, int digits, const ParallelFor& parallel_for);

    /// After each step of dt [s]: the smoke follows the air.
    [[nodiscard]] Fault follow(const Playback& playback, double dt);
    /// Writes vel_0000.vdb, whole or not at all.
    [[nodiscard]] Fault write(Playback& playback, std::int64_t number);

    /// Its smoke as bytes; empty where it has none yet.
    [[nodiscard]] Result<std::vector<std::byte>> save() const;
    /// Goes on from there, with the air of the same moment.
    [[nodiscard]] Result<void> load(std::span<const std::byte> bytes, const Playback& playback);

  private:
    /// The wind's cells, and those inside obstacles in `obstacle_` where they are asked for. Before the first step the cells inside
    /// hold the velocity of bodies that have appeared, 0, as they hold their body's after each step.
    [[nodiscard]] Result<WindView> air_of(const Playback& playback);
    [[nodiscard]] Result<void> find_divergence(const WindView& air, std::span<const PlacedObstacle> obstacles);
    [[nodiscard]] Fault written(const vdb::VelocityGrid& grid, int number, double time);

    const scene::Scene* scene_;
    vdb::Sequence sequence_;
    ParallelFor parallel_for_;
    std::optional<Tracer> smoke_;
    std::optional<Workspace> work_; ///< of the divergence
    std::vector<glm::vec4> first_;
    std::vector<float> obstacle_, divergence_, pressure_;
};

} // namespace windrow::cli
