// What a run keeps of each step beside its frames: the wind at points and along lines, and the forces on its obstacles, as tables.
#pragma once

#include "cli/flags.h"
#include "cli/output_file.h"
#include "cli/playback.h"

#include <filesystem>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace windrow::cli {

struct ProbeRequest {
    /// A point, or evenly spaced ones from one end to the other.
    struct Line {
        std::string name;
        glm::dvec3 from{0.0}, to{0.0}; ///< [m]
        int count = 1;
    };
    std::vector<Line> lines;
    bool forces = false;

    [[nodiscard]] bool any() const { return forces || !lines.empty(); }
};

/// Adds --probe and --forces; the request outlives the parsing.
void add_probes(Flags& flags, CLI::App& command, ProbeRequest& request);

class Probes {
  public:
    struct Tables {
        std::string_view probes{}, forces{};
    };
    /// Opens probes.csv and forces.csv where they are asked for; the request outlives it. `begun`: what they hold already, where
    /// a run goes on.
    Probes(const ProbeRequest& request, const std::filesystem::path& folder, KeepText keep, const Tables& begun);
    /// What they hold, where they keep it.
    [[nodiscard]] Tables tables() const;

    /// A row for each point and obstacle that is there, as they are after a step, or before the first.
    [[nodiscard]] Fault follow(const Playback& playback);
    /// Gives the files their names.
    [[nodiscard]] Fault publish();

  private:
    const ProbeRequest* request_;
    std::vector<glm::dvec3> points_;
    std::vector<glm::vec3> found_;
    std::unique_ptr<OutputFile> probes_, forces_; ///< null: not asked for
};

} // namespace windrow::cli
