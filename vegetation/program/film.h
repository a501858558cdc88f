// A film of what windrow-draw drew: the pictures of one scene, or of several behind one another, as an animated WebP or as MP4.
//
// WebP: key frames alone, as tools/webp_film.py has them for pages and for its reasons. MP4: by the program ffmpeg, H.264 with a key
// frame at each cut, as tools/make_film.py cuts its shots.
#pragma once

#include "fluid/result.h"
#include "scene/frame_files.h"

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace windrow::vegetation::program {

/// The pictures of a scene, numbered from `first` on.
struct Shot {
    std::filesystem::path folder;
    std::int64_t first = 0, count = 0;
};

struct Film {
    std::filesystem::path file; ///< ends in .webp or .mp4
    glm::ivec2 size{0};         ///< [px] of all shots
    double frames_per_second = 0.0;
    std::vector<Shot> shots{};
};

/// A sentence, and whether the machine lacks something; an empty one: no fault.
struct FilmFault {
    std::string sentence;
    bool machine = false;
};

/// What would be found out only once all is drawn: another ending, no such folder, no ffmpeg.
[[nodiscard]] FilmFault fault_of_film(const std::filesystem::path& file);
/// Writes the film whole or not at all.
[[nodiscard]] Result<void> write_film(const Film& film, const scene::FrameFiles& pictures);

} // namespace windrow::vegetation::program
