// Snapshot of a run: the file from which `windrow run --resume` goes on.
#pragma once

#include "cli/frame_writer.h"
#include "cli/output_file.h"
#include "cli/playback.h"
#include "cli/probes.h"
#include "cli/timings.h"
#include "fluid/saved_parts.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace windrow::cli {

/// What must be equal for the bits to be equal: the version, the scene with the files that it names, the flags, the instructions.
struct RunIdentity {
    std::uint64_t scene = 0; ///< checksum
    std::string flags{};
};
/// Reads the scene's file again.
[[nodiscard]] Result<RunIdentity> identity_of(const scene::Scene& scene, std::string flags);

class RunSnapshot {
  public:
    /// The file in the folder of a run; it need not be there.
    explicit RunSnapshot(const std::filesystem::path& folder) : file_(folder / "run.snapshot") {}

    /// Reads it. False: there is none. Rejects a damaged one and one of another run.
    [[nodiscard]] Result<bool> read(const RunIdentity& run);
    /// Frames that were done; 0 without a snapshot.
    [[nodiscard]] std::int64_t frames() const { return frames_; }
    [[nodiscard]] Probes::Tables tables() const;
    [[nodiscard]] std::string_view timings_csv() const;
    [[nodiscard]] Result<Playback> playback(const scene::Scene& scene, const ParallelFor& threads) const;
    [[nodiscard]] Result<void> restore(FrameWriter& writer, Timings& timings, const Playback& playback) const;

    /// Writes the run after `frames` frames, whole or not at all; `csv` may be null. All files of those frames are on the disk.
    [[nodiscard]] Fault write(const RunIdentity& run, std::int64_t frames, Playback& playback, const FrameWriter& writer,
                              const Probes& probes, const Timings& timings, const OutputFile* csv) const;
    /// Frees its memory.
    void clear();
    /// Removes the file: the run has ended, or another begins.
    void remove() const;

  private:
    [[nodiscard]] std::span<const std::byte> part(std::string_view name) const;

    std::filesystem::path file_;
    std::string bytes_{};
    std::vector<SavedPart> parts_{}; ///< of the bytes
    std::int64_t frames_ = 0;
};

} // namespace windrow::cli
