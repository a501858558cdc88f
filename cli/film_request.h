// What a run asks of its frames: their times and numbers, and what their VDB files hold. Each takes the place of a key of the
// scene, or adds to it.
#pragma once

#include "cli/flags.h"
#include "fluid/field_files.h"
#include "scene/scene.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace windrow::cli {

struct FilmRequest {
    std::optional<std::int64_t> frames;      ///< default: to the end
    std::optional<double> frames_per_second; ///< default: the scene's
    std::optional<double> from, to;          ///< [s] default: 0, and the scene's duration
    std::int64_t first_frame = 0;            ///< number of the first frame that is kept
    scene::VdbGrids grids{};                 ///< beside those of the scene
    bool nanovdb = false;
    std::optional<double> margin;     ///< [m] default: the scene's
    std::optional<double> voxel_size; ///< [m] default: the scene's
};

/// The frames of one run.
struct Frames {
    scene::FrameTimes times;
    std::int64_t count;
    std::int64_t first; ///< number of the first one
};

/// Adds the flags; the request outlives the parsing.
void add_film(Flags& flags, FilmRequest& request);
/// Adds those of VDB files.
void add_vdb(Flags& flags, CLI::App& command, FilmRequest& request);
/// The formats of --fields.
[[nodiscard]] std::vector<FieldFormat> read_formats(const std::string& text);
/// Rejects flags that exclude each other, and flags of VDB files where none are kept.
void check_film(const FilmRequest& request, bool vdb);
/// Writes into the scene what was asked for; rejects what it, the build or the backend cannot give.
[[nodiscard]] Result<void> apply(const FilmRequest& request, const BackendRequest& backend, scene::Scene& scene);
/// Memory that a VDB file of the scene takes beside the air, where it holds more than the cells. [bytes]
[[nodiscard]] std::uint64_t film_bytes(const scene::Scene& scene);
/// The frames of a scene that `apply` has changed; rejects none, and too many steps.
[[nodiscard]] Result<Frames> frames_of(const FilmRequest& request, const scene::Scene& scene);

} // namespace windrow::cli
