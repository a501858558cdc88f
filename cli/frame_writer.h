// Keeps frames of a run: a picture, a VDB, files of engines.
#pragma once

#include "cli/film_request.h"
#include "cli/output_file.h"
#include "cli/pictures.h"
#include "cli/playback.h"
#include "fluid/field_files.h"
#include "scene/frame_files.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace windrow::cli {

class VdbFrames;

class FrameWriter {
  public:
    /// `folder` stands. The numbers of frames get as many digits as the last one needs, at least four.
    FrameWriter(const scene::Scene& scene, std::filesystem::path folder, bool images, bool vdb, std::vector<FieldFormat> fields,
                const Frames& frames, const ParallelFor& parallel_for);
    ~FrameWriter();
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    /// Writes frame_0000.png, vel_0000.vdb and wind_0000.fga of the n-th frame from 0, whole or not at all.
    [[nodiscard]] Fault write(Playback& playback, std::int64_t n);
    /// After each step of dt [s]: what a frame shows of the way here.
    [[nodiscard]] Fault follow(const Playback& playback, double dt);
    /// What it has gathered beside its files, as bytes.
    [[nodiscard]] Result<std::vector<std::byte>> save() const;
    /// Goes on from there after `count` frames, whose files are looked for.
    [[nodiscard]] Result<void> load(std::span<const std::byte> bytes, const Playback& playback, std::int64_t count);
    /// Writes contact_sheet.png of the pictures so far, twelve at most, evenly spread.
    [[nodiscard]] Fault write_contact_sheet();

    /// [s] Wall-clock time that each took.
    [[nodiscard]] double picture_seconds() const { return picture_seconds_; }
    [[nodiscard]] double vdb_seconds() const { return vdb_seconds_; }
    /// Pictures and VDB files so far.
    [[nodiscard]] std::size_t pictures() const { return pictures_.size(); }
    [[nodiscard]] std::size_t vdbs() const { return vdbs_; }
    [[nodiscard]] std::size_t fields() const { return fields_written_; }
    [[nodiscard]] const std::vector<FieldFormat>& field_formats() const { return fields_; }
    [[nodiscard]] bool has_contact_sheet() const { return contact_sheet_; }
    /// Once all frames are written: what another run left in the folder (scene/frame_files.h).
    [[nodiscard]] std::string clear_other_frames(scene::Extent extent) const;

  private:
    [[nodiscard]] Fault write_picture(const Playback& playback, std::int64_t frame);
    [[nodiscard]] Fault write_vdb(Playback& playback, std::int64_t frame);
    [[nodiscard]] Fault write_fields(const Playback& playback, std::int64_t frame);
    /// Files of each frame.
    [[nodiscard]] std::vector<scene::FrameFiles> kept_files() const;
    [[nodiscard]] scene::FrameFiles files_of(FieldFormat format) const;
    [[nodiscard]] scene::FrameFiles images_of() const;

    const scene::Scene* scene_;
    std::filesystem::path folder_;
    bool images_;
    bool vdb_;
    std::vector<FieldFormat> fields_; ///< a file of each
    std::size_t fields_written_ = 0;
    std::int64_t first_, last_; ///< numbers
    int digits_;
    std::vector<std::filesystem::path> pictures_;
    std::optional<FrameParts> parts_; ///< of the pictures
    std::size_t vdbs_ = 0;
    bool contact_sheet_ = false;
    double picture_seconds_ = 0.0;
    double vdb_seconds_ = 0.0;
    std::unique_ptr<VdbFrames> vdb_frames_; ///< null: none are written
};

} // namespace windrow::cli
