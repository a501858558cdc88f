// Numbered files of a run's frames, and those that another run left beside them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace windrow::scene {

/// frame_0000.png, vel_0000.vdb: a prefix, a number of at least `digits` digits, a suffix.
struct FrameFiles {
    std::string prefix, suffix;
    int digits = 4;

    [[nodiscard]] std::string name(std::int64_t frame) const;
    /// Whether the name is one that some run gives, whatever its count of digits, but none of this run's: beyond `last`, or with
    /// other digits.
    [[nodiscard]] bool is_of_another_run(std::string_view name, std::int64_t last) const;
};

/// How much of a scene a run kept: a part of a film leaves the frames of others, a whole one takes their place.
enum class Extent : std::uint8_t { part, whole };

/// What a run that is done does with frames of another run in its folder, which a film would show behind its own: a whole scene
/// removes them. A sentence for the user; empty where there are none.
[[nodiscard]] std::string clear_other_frames(const std::filesystem::path& folder, std::span<const FrameFiles> kept,
                                             std::int64_t last, Extent extent);

} // namespace windrow::scene
