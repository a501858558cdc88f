// Wind as OpenVDB files, for Blender, Houdini and every other reader of .vdb.
//
//     auto written = windrow::vdb::write(windrow::vdb::grid_of(wind), "wind.vdb", {.time = 1.5});
//     if (!written)
//         std::cerr << written.error() << '\n';
//
// A file is written beside its name, checked, and renamed (fluid/files/new_file.h): a full disk leaves the file of that name as it was
// and nothing else behind, and of two writers of one name the last wins. Files of the same wind and frame are equal: the tag that
// OpenVDB fills at random is a hash of it. Different files may be written by different threads at once.
#pragma once

#include "../api.h"
#include "../box.h"
#include "../result.h"
#include "../wind.h"

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace windrow::vdb {

/// A scalar to write as a grid of floats.
struct NamedScalar {
    /// As Options::name; another name than all other grids of the file.
    std::string name;
    /// Stored as windrow_units: "1/s".
    std::string units;
    /// One finite value a cell, as VelocityGrid::field.
    std::span<const float> values{};
    /// Background value, finite. Default 0.
    float outside = 0.0f;
};

/// The same of vectors, which Options::form and Options::up treat as the velocity; background 0.
struct NamedVector {
    std::string name;
    std::string units;
    std::span<const glm::vec4> values{};
};

/// The wind to write: a box of cells, in memory of the caller.
struct VelocityGrid {
    /// Cells along x, y, z; the limits of Box::cells.
    glm::ivec3 cells{0};
    /// [m] Edge of a cell; the limits of Box::cell_size.
    float cell_size = 1.0f;
    /// [m] World position of the low corner of the box, finite. Stored in double: exact 10^6 m away.
    glm::dvec3 origin{0.0};
    /// [m/s] One value a cell at its centre, x fastest, then y, then z; w is ignored. Rejected unless it is cells.x * cells.y *
    /// cells.z values, all finite: one NaN would spread through a reader's filters without a word.
    std::span<const glm::vec4> field{};
    /// [m] Thickness of a cell along y, where all have one that is not cell_size. Default 0: cell_size.
    float cell_height = 0.0f;
    /// Rows of the box; null: all are cell_size thick. A grid has voxels of one size: they are as thick as the lowest row (at most 2048
    /// of them), linear in height between the rows' centres.
    std::shared_ptr<const RowTable> rows{};
    /// [m/s] Background value of the grid, which readers take outside of the cells and blend to within half a cell of the edge. One
    /// value at all heights. Default 0; grid_of gives the ambient wind at the height of the box's middle, without gusts.
    glm::vec3 outside{0.0f};
    /// 1 inside obstacles, else 0, one value a cell as in `field`; written as k_obstacle_grid where some are not 0. Empty: none.
    std::vector<float> obstacle{};
    /// There was no memory for `obstacle`: rejected.
    bool lacks_obstacle = false;
    /// Further grids over the same cells.
    std::vector<NamedScalar> scalars{};
    std::vector<NamedVector> vectors{};
};

/// Name of the grid of floats that is 1 inside obstacles and 0 in the air.
inline constexpr const char* k_obstacle_grid = "obstacle";

/// The air of a wind on either backend, with the cells inside its obstacles. Good until its next step or recording. The error says
/// why no cells can be read.
[[nodiscard]] WINDROW_API Result<VelocityGrid> grid_of(const WindControl& wind, const WindReader& air);
/// The same on the CPU, which always has cells.
[[nodiscard]] WINDROW_API VelocityGrid grid_of(const Wind& wind);

enum class Form : std::uint8_t {
    one_vector,    ///< One grid of vectors, `name`: what Blender, Houdini and renderers look for first. The default.
    three_scalars, ///< Three grids of floats, `name`.x, `name`.y, `name`.z, for readers without vector grids.
};

enum class Precision : std::uint8_t {
    full, ///< 32 bits: the solver's values to the bit. The default.
    half, ///< 16 bits, half the disk: within 2^-11 of the value above 6.1e-5 m/s, within 3e-8 m/s below; rejected above 65504 m/s.
};

enum class UpAxis : std::uint8_t {
    y, ///< As in Windrow and in Houdini. The default.
    z, ///< As in Blender: places and velocities (x, y, z) become (x, -z, y), a turn that keeps right-handed things right-handed.
};

enum class Format : std::uint8_t {
    openvdb, ///< .vdb, compressed. The default.
    nanovdb, ///< .nvdb, for renderers on a GPU: 32 bits, not compressed, without Windrow's own metadata. Where has_nanovdb().
};

/// Whether this build writes NanoVDB (Debian: libnanovdb-dev).
[[nodiscard]] WINDROW_API bool has_nanovdb();

struct Options {
    /// Name of the grid, not empty, without '/' and control characters. Default "vel": Blender 3.4 takes velocity, vel and v for
    /// the velocity of a volume, Houdini's fluids call it vel.
    std::string name = "vel";
    /// Grids of the velocity. Default one_vector.
    Form form = Form::one_vector;
    /// Bits of a value. Default full. half rejects winds above 65504 m/s.
    Precision precision = Precision::full;
    /// Axis that points up in the file. Default y.
    UpAxis up = UpAxis::y;
    /// [s] Time of the wind, finite; stored as windrow_time. Default 0.
    double time = 0.0;
    /// Number of the frame, any; stored as windrow_frame. Default 0.
    int frame = 0;
    /// Default openvdb. nanovdb is rejected where has_nanovdb() is false.
    Format format = Format::openvdb;
};

enum class Problem : std::uint8_t {
    none,          ///< It is written.
    rejected,      ///< A field of the grid, the options or the sequence cannot be used.
    cannot_write,  ///< The file cannot be made there: no such folder, no permission, a folder in its place.
    disk_full,     ///< The disk cannot hold it: full, broken, a quota or a limit reached.
    out_of_memory, ///< No memory, or no file handle. The grid needs about as much memory again as the field, and there was none.
};

/// Result<void> that also says which kind of trouble it was, for a caller that answers each in its own way.
class [[nodiscard]] WriteResult : public Result<void> {
  public:
    WriteResult() = default;
    WriteResult(Problem problem, std::string message) : Result<void>(Error{std::move(message)}), problem_(problem) {}

    [[nodiscard]] Problem problem() const noexcept { return problem_; }

  private:
    Problem problem_ = Problem::none;
};

/// Writes one file, all cells active, also where the wind is uniform. Cell (0, 0, 0) is voxel (0, 0, 0), its centre where the
/// voxel's is; with UpAxis::z cell (i, j, k) is voxel (i, cells.z - 1 - k, j). Folders are not made. The error lists every
/// reason, one per line.
WINDROW_API WriteResult write(const VelocityGrid& grid, const std::filesystem::path& file, const Options& options = {});

/// Names the frames of a sequence: folder / prefix 0001 .vdb (.nvdb with Format::nanovdb), as Blender and Houdini ($F4) number theirs.
///
///     const windrow::vdb::Sequence sequence{.folder = "out", .options = {.up = windrow::vdb::UpAxis::z}};
///     sequence.write(windrow::vdb::grid_of(wind), frame, time);
struct WINDROW_API Sequence {
    /// Folder of the files; must exist. Default: the current folder.
    std::filesystem::path folder{};
    /// Begins each file's name. Without '/' and control characters, and not ending in a digit, which would run into the number.
    std::string prefix = "wind_";
    /// Digits that the number is padded to with zeros, 1 to 9. Default 4; a longer number is not cut, but sorts elsewhere.
    int digits = 4;
    /// For every file; `time` and `frame` are set by write.
    Options options{};

    [[nodiscard]] std::filesystem::path path(int frame) const;
    /// Writes one frame; rejects a negative number, and what vdb::write rejects.
    WriteResult write(const VelocityGrid& grid, int frame, double time) const;
};

} // namespace windrow::vdb
