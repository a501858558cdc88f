// The only file of the library that includes OpenVDB.
//
// Where values live: cell (i, j, k) is voxel (i, j, k) and both have their centre at origin + ((i, j, k) + 1/2) h, so that
// OpenVDB's map is a scale h and a translation origin + h/2, held in double. With z up, the world is turned a quarter about x,
// (x, y, z) -> (x, -z, y), and the voxels are counted from the turned box's own low corner: voxel (a, b, c) shows cell
// (a, c, cells.z - 1 - b), and the scale stays positive.
//
// Every voxel is written in a leaf, none as a tile: an active tile would say the same in fewer bytes, but readers that walk
// leaves only (points, renderers) would see holes where the wind is uniform.

#include "fluid/vdb/vdb_export.h"

#include "fluid/message.h"
#include "fluid/new_file.h"
#include "fluid/version.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <glm/common.hpp>
#include <new>
#include <openvdb/openvdb.h>
#include <ostream>
#include <string_view>

namespace windrow::vdb {

namespace {

using windrow::detail::message;
using windrow::detail::NewFile;
using windrow::detail::Reasons;

constexpr float k_largest_half = 65504.0f;

// --- What is rejected -------------------------------------------------------------------------------------------------

bool is_plain_name(const std::string& name) {
    return std::none_of(name.begin(), name.end(),
                        [](char letter) { return letter == '/' || static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f; });
}

bool is_finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check_field(const VelocityGrid& grid, const Options& options, Reasons& reasons) {
    std::size_t not_finite = 0;
    std::size_t first = 0;
    float largest = std::max({std::abs(grid.outside.x), std::abs(grid.outside.y), std::abs(grid.outside.z)});
    for (std::size_t index = 0; index < grid.field.size(); ++index) {
        const glm::vec3 value(grid.field[index]);
        if (is_finite(value))
            largest = std::max({largest, std::abs(value.x), std::abs(value.y), std::abs(value.z)});
        else if (not_finite++ == 0)
            first = index;
    }
    if (not_finite != 0) {
        const std::size_t row = static_cast<std::size_t>(grid.cells.x);
        const std::size_t slice = row * static_cast<std::size_t>(grid.cells.y);
        const glm::ivec3 cell(first % row, first % slice / row, first / slice);
        reasons.add("field holds NaN or infinity in ", not_finite, " cells, the first ", cell,
                    ": give finite values (Wind::step sets such cells to ambient).");
    }
    if (options.precision == Precision::half && largest > k_largest_half)
        reasons.add("precision is half and the wind reaches ", largest, " m/s: half ends at ", k_largest_half,
                    ", write it with Precision::full.");
}

Result<void> check(const VelocityGrid& grid, const std::filesystem::path& file, const Options& options) {
    Reasons reasons;
    if (!file.has_filename())
        reasons.add("file is \"", file.string(), "\": end it in a file name, such as wind.vdb.");
    if (options.name.empty() || !is_plain_name(options.name))
        reasons.add("name is \"", options.name, "\": name the grid, without '/' and control characters, such as vel.");
    if (options.form > Form::three_scalars)
        reasons.add("form is ", static_cast<int>(options.form), ": give one_vector or three_scalars.");
    if (options.precision > Precision::half)
        reasons.add("precision is ", static_cast<int>(options.precision), ": give full or half.");
    if (options.up > UpAxis::z)
        reasons.add("up is ", static_cast<int>(options.up), ": give y or z.");
    if (!std::isfinite(options.time))
        reasons.add("time is ", options.time, " s: give a finite time.");
    if (!is_finite(grid.origin))
        reasons.add("origin is ", grid.origin, " m: give finite coordinates.");
    if (options.name == k_obstacle_grid)
        reasons.add("name is \"", k_obstacle_grid, "\", the grid of the cells inside obstacles: give another, such as vel.");
    if (!is_finite(grid.outside))
        reasons.add("outside is ", grid.outside, " m/s: give a finite wind, such as the ambient.");
    const Box box{.cells = grid.cells, .cell_size = grid.cell_size, .boundaries = {}, .rows = grid.rows};
    if (auto valid = validate(box); !valid)
        reasons.add(valid.error());
    else if (grid.field.size() != box.cell_count())
        reasons.add("field holds ", grid.field.size(), " values and cells is ", grid.cells, ", ", box.cell_count(),
                    " in all: give one value a cell.");
    else
        check_field(grid, options, reasons);
    if (!grid.obstacle.empty() && grid.obstacle.size() != grid.field.size())
        reasons.add("obstacle holds ", grid.obstacle.size(), " values and field ", grid.field.size(), ": give as many, or none.");
    if (!std::all_of(grid.obstacle.begin(), grid.obstacle.end(), [](float value) { return value >= 0.0f && value <= 1.0f; }))
        reasons.add("obstacle holds values beyond 0 to 1: give 1 inside obstacles and 0 in the air.");
    if (!reasons.empty())
        return Error{reasons.take()};
    return {};
}

// --- From cells to voxels --------------------------------------------------------------------------------------------

/// 0 - z: still air stays 0 and does not become -0.
template <class Vector>
Vector turned(const Vector& v, UpAxis up) {
    return up == UpAxis::y ? v : Vector(v.x, typename Vector::value_type(0) - v.z, v.y);
}

glm::ivec3 voxels_of(const glm::ivec3& cells, UpAxis up) {
    return up == UpAxis::y ? cells : glm::ivec3(cells.x, cells.z, cells.y);
}

glm::ivec3 cell_at(const glm::ivec3& voxel, const glm::ivec3& cells, UpAxis up) {
    return up == UpAxis::y ? voxel : glm::ivec3(voxel.x, voxel.z, cells.z - 1 - voxel.y);
}

/// Cells that are resampled to voxels of one size; the grid itself where its rows are equal.
struct Resampled {
    VelocityGrid grid;
    double thickness = 0.0; ///< [m] of a voxel along y
    std::vector<glm::vec4> field{};
};

Resampled resampled(const VelocityGrid& source) {
    Resampled even{.grid = source, .thickness = static_cast<double>(source.cell_size)};
    if (!source.rows)
        return even;
    const RowTable& rows = *source.rows;
    const int count = static_cast<int>(std::clamp(std::ceil(rows.top() / rows.step() - 1e-6), 1.0, double{k_max_axis_cells}));
    even.thickness = std::max(rows.step(), rows.top() / count);
    even.grid.rows.reset();
    even.grid.cells.y = count;
    const Box from{.cells = source.cells}, to{.cells = even.grid.cells};
    even.field.resize(to.cell_count());
    even.grid.obstacle.resize(source.obstacle.empty() ? 0 : to.cell_count());
    for (int k = 0; k < to.cells.z; ++k)
        for (int j = 0; j < count; ++j) {
            const double place = std::clamp(rows.place((j + 0.5) * even.thickness) - 0.5, 0.0, rows.count() - 1.0);
            const int below = std::min(static_cast<int>(place), rows.count() - 2), nearest = static_cast<int>(place + 0.5);
            const auto part = static_cast<float>(place - below);
            for (int i = 0; i < to.cells.x; ++i) {
                const glm::vec4 low = source.field[from.index(i, below, k)], high = source.field[from.index(i, below + 1, k)];
                even.field[to.index(i, j, k)] = low + part * (high - low);
                if (!source.obstacle.empty())
                    even.grid.obstacle[to.index(i, j, k)] = source.obstacle[from.index(i, nearest, k)];
            }
        }
    even.grid.field = even.field;
    return even;
}

openvdb::math::Transform::Ptr transform_of(const VelocityGrid& grid, double thickness, UpAxis up) {
    const double h = grid.cell_size;
    const glm::dvec3 size(h, thickness, h), low_cell = glm::dvec3(cell_at(glm::ivec3(0), grid.cells, up));
    const glm::dvec3 centre = turned(grid.origin + (low_cell + 0.5) * size, up);
    auto transform = openvdb::math::Transform::createLinearTransform(h);
    if (thickness != h)
        transform->preScale(up == UpAxis::y ? openvdb::Vec3d(1.0, thickness / h, 1.0) : openvdb::Vec3d(1.0, 1.0, thickness / h));
    transform->postTranslate({centre.x, centre.y, centre.z});
    return transform;
}

/// A grid that ends without memory too: the destructor of OpenVDB's tree collects the nodes in arrays, and one that finds no
/// memory there ends the process. The root frees its nodes without them.
template <class GridType>
typename GridType::Ptr empty_grid(const typename GridType::ValueType& background) {
    return {new GridType(background), [](GridType* grid) {
                grid->tree().root().clear();
                delete grid;
            }};
}

/// `value_at` makes a voxel's value from the index of its cell.
template <class GridType, class ValueAt>
openvdb::GridBase::Ptr dense_grid(const VelocityGrid& source, double thickness, const Options& options,
                                  const typename GridType::ValueType& background, ValueAt value_at) {
    auto grid = empty_grid<GridType>(background);
    grid->setTransform(transform_of(source, thickness, options.up));

    using Leaf = typename GridType::TreeType::LeafNodeType;
    constexpr int size = static_cast<int>(Leaf::DIM);
    const Box box{.cells = source.cells, .cell_size = source.cell_size, .boundaries = {}};
    const glm::ivec3 voxels = voxels_of(source.cells, options.up);
    for (int a = 0; a < voxels.x; a += size)
        for (int b = 0; b < voxels.y; b += size)
            for (int c = 0; c < voxels.z; c += size) {
                Leaf& leaf = *grid->tree().touchLeaf({a, b, c});
                const glm::ivec3 end = glm::min(voxels, glm::ivec3(a, b, c) + size);
                for (int x = a; x < end.x; ++x)
                    for (int y = b; y < end.y; ++y)
                        for (int z = c; z < end.z; ++z) {
                            const glm::ivec3 cell = cell_at({x, y, z}, source.cells, options.up);
                            leaf.setValueOn(Leaf::coordToOffset({x, y, z}), value_at(box.index(cell.x, cell.y, cell.z)));
                        }
            }
    return grid;
}

openvdb::GridPtrVec grids_of(const VelocityGrid& given, const Options& options) {
    const Resampled even = resampled(given);
    const VelocityGrid& source = even.grid;
    openvdb::GridPtrVec grids;
    const glm::vec3 outside = turned(source.outside, options.up);
    const auto velocity = [&](std::size_t cell) { return turned(glm::vec3(source.field[cell]), options.up); };
    if (options.form == Form::one_vector) {
        grids.push_back(dense_grid<openvdb::Vec3SGrid>(source, even.thickness, options, {outside.x, outside.y, outside.z},
                                                       [&](std::size_t cell) {
                                                           const glm::vec3 v = velocity(cell);
                                                           return openvdb::Vec3s(v.x, v.y, v.z);
                                                       }));
        // A velocity turns with the object that it belongs to, and does not move with it.
        grids.back()->setVectorType(openvdb::VEC_CONTRAVARIANT_RELATIVE);
        grids.back()->setName(options.name);
    } else {
        for (int axis = 0; axis < 3; ++axis) {
            grids.push_back(dense_grid<openvdb::FloatGrid>(source, even.thickness, options, outside[axis],
                                                           [&](std::size_t cell) { return velocity(cell)[axis]; }));
            grids.back()->setName(options.name + '.' + "xyz"[axis]);
        }
    }
    if (std::any_of(source.obstacle.begin(), source.obstacle.end(), [](float value) { return value != 0.0f; })) {
        grids.push_back(dense_grid<openvdb::FloatGrid>(source, even.thickness, options, 0.0f,
                                                       [&](std::size_t cell) { return source.obstacle[cell]; }));
        grids.back()->setName(k_obstacle_grid);
    }
    for (const auto& grid : grids) {
        grid->setCreator("windrow " WINDROW_VERSION_STRING);
        grid->setSaveFloatAsHalf(options.precision == Precision::half);
        grid->insertMeta("windrow_time", openvdb::DoubleMetadata(options.time));
        grid->insertMeta("windrow_frame", openvdb::Int32Metadata(options.frame));
        grid->insertMeta("windrow_units", openvdb::StringMetadata("velocity m/s, length m, time s"));
        grid->insertMeta("windrow_up_axis", openvdb::StringMetadata(options.up == UpAxis::y ? "y" : "z"));
    }
    return grids;
}

/// io::File cannot tell a full disk, and io::Stream leaves out the table of grids, so that readers load a file whole to list it.
/// This writes what io::File writes to a stream that can seek.
class SeekableArchive : public openvdb::io::Archive {
  public:
    using openvdb::io::Archive::write;
};

// --- What went wrong -------------------------------------------------------------------------------------------------

WriteResult failure(const std::filesystem::path& file, int error) {
    Problem problem = Problem::cannot_write;
    std::string_view fix = "name a file in a folder that you may write to";
    switch (error) {
    case ENOENT:
    case ENOTDIR:
        fix = "create that folder first";
        break;
    case EISDIR:
    case ENXIO:
        fix = "it is a folder or a device, name a file";
        break;
    case ENAMETOOLONG:
        fix = "shorten it";
        break;
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
        problem = Problem::disk_full;
        fix = "free some space or name another folder";
        break;
    case EIO:
        problem = Problem::disk_full;
        fix = "name a folder on another disk";
        break;
    default:
        if (windrow::detail::machine_lacks(error)) {
            problem = Problem::out_of_memory;
            fix = "end other programs";
        }
    }
    return {problem, message(file.native(), ": ", windrow::detail::reason_of(error), ": ", fix, "; nothing was changed.")};
}

WriteResult out_of_memory(const std::string& file, const VelocityGrid& grid) {
    return {Problem::out_of_memory, message(file, ": the memory for ", grid.cells,
                                            " cells is not available: free some or write fewer cells; nothing was changed.")};
}

} // namespace

bool detail::make_obstacle_room(VelocityGrid& grid) {
    return windrow::detail::memory_lasts([&] { grid.obstacle.resize(grid.field.size()); });
}

WriteResult write(const VelocityGrid& grid, const std::filesystem::path& file, const Options& options) {
    try {
        if (grid.lacks_obstacle)
            return out_of_memory(file.native(), grid);
        if (auto valid = check(grid, file, options); !valid)
            return {Problem::rejected, valid.error()};
        NewFile out(file);
        if (out.error() != 0)
            return failure(file, out.error());
        try {
            openvdb::initialize();
            std::ostream stream(&out);
            stream.exceptions(std::ios::failbit | std::ios::badbit);
            SeekableArchive().write(stream, grids_of(grid, options), true);
        } catch (const std::bad_alloc&) {
            throw;
        } catch (const std::exception& exception) {
            // A stream's own words name no reason; the file knows it.
            if (out.error() == 0)
                return {Problem::cannot_write,
                        message(file.string(), ": OpenVDB could not write it: ", exception.what(), "; nothing was changed.")};
        }
        if (out.error() != 0 || !out.publish())
            return failure(file, out.error());
        return {};
    } catch (const std::exception&) {
        return out_of_memory(file.native(), grid);
    }
}

std::filesystem::path Sequence::path(int frame) const {
    std::string number = std::to_string(frame);
    const auto width = static_cast<std::size_t>(std::max(digits, 1));
    if (number.size() < width)
        number.insert(0, width - number.size(), '0');
    return folder / (prefix + number + ".vdb");
}

WriteResult Sequence::write(const VelocityGrid& grid, int frame, double time) const {
    Reasons reasons;
    if (frame < 0)
        reasons.add("frame is ", frame, ": number the frames from 0 or more.");
    if (digits < 1 || digits > 9)
        reasons.add("digits is ", digits, ": give 1 to 9.");
    if (!is_plain_name(prefix) || (!prefix.empty() && prefix.back() >= '0' && prefix.back() <= '9'))
        reasons.add("prefix is \"", prefix, "\": leave out '/' and control characters and end it in no digit, such as wind_.");
    if (!reasons.empty())
        return {Problem::rejected, reasons.take()};
    try {
        Options frame_options = options;
        frame_options.time = time;
        frame_options.frame = frame;
        return vdb::write(grid, path(frame), frame_options);
    } catch (const std::bad_alloc&) {
        return out_of_memory(folder.native(), grid);
    }
}

} // namespace windrow::vdb
