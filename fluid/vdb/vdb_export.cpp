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

#include "fluid/core/bytes.h"
#include "fluid/core/message.h"
#include "fluid/files/streamed_file.h"
#include "fluid/vdb/even_grid.h"
#include "fluid/vdb/grid_rules.h"
#include "fluid/version.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <glm/common.hpp>
#include <new>
#include <openvdb/openvdb.h>
#if WINDROW_WITH_NANOVDB
#include <nanovdb/util/IO.h>
#include <nanovdb/util/OpenToNanoVDB.h>
#endif
#include <ostream>
#include <sstream>
#include <string_view>

namespace windrow::vdb {

namespace {

using windrow::detail::message;
using windrow::detail::Reasons;
using windrow::detail::StreamedFile;

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

struct GridList {
    const VelocityGrid& source;
    double thickness;
    const Options& options;
    openvdb::GridPtrVec grids{};

    void add(openvdb::GridBase::Ptr grid, const std::string& name, const std::string& units) {
        grid->setName(name);
        grid->setCreator("windrow " WINDROW_VERSION_STRING);
        grid->setSaveFloatAsHalf(options.precision == Precision::half);
        grid->insertMeta("windrow_time", openvdb::DoubleMetadata(options.time));
        grid->insertMeta("windrow_frame", openvdb::Int32Metadata(options.frame));
        grid->insertMeta("windrow_units", openvdb::StringMetadata(units + ", length m, time s"));
        grid->insertMeta("windrow_up_axis", openvdb::StringMetadata(options.up == UpAxis::y ? "y" : "z"));
        grids.push_back(std::move(grid));
    }

    void add_scalar(std::span<const float> values, float outside, const std::string& name, const std::string& units) {
        add(dense_grid<openvdb::FloatGrid>(source, thickness, options, outside, [&](std::size_t cell) { return values[cell]; }),
            name, units);
    }

    void add_vector(std::span<const glm::vec4> values, const glm::vec3& beyond, const std::string& name,
                    const std::string& units) {
        const glm::vec3 outside = turned(beyond, options.up);
        const auto value = [&](std::size_t cell) { return turned(glm::vec3(values[cell]), options.up); };
        if (options.form == Form::three_scalars) {
            for (int axis = 0; axis < 3; ++axis)
                add(dense_grid<openvdb::FloatGrid>(source, thickness, options, outside[axis],
                                                   [&](std::size_t cell) { return value(cell)[axis]; }),
                    name + '.' + "xyz"[axis], units);
            return;
        }
        auto grid =
            dense_grid<openvdb::Vec3SGrid>(source, thickness, options, {outside.x, outside.y, outside.z}, [&](std::size_t cell) {
                const glm::vec3 v = value(cell);
                return openvdb::Vec3s(v.x, v.y, v.z);
            });
        // A velocity turns with the object that it belongs to, and does not move with it.
        grid->setVectorType(openvdb::VEC_CONTRAVARIANT_RELATIVE);
        add(std::move(grid), name, units);
    }
};

openvdb::GridPtrVec grids_of(const VelocityGrid& given, const Options& options) {
    const EvenGrid even = even_grid(given);
    const VelocityGrid& source = even.grid;
    GridList list{.source = source, .thickness = even.thickness, .options = options};
    list.add_vector(source.field, source.outside, options.name, "velocity m/s");
    if (std::any_of(source.obstacle.begin(), source.obstacle.end(), [](float value) { return value != 0.0f; }))
        list.add_scalar(source.obstacle, 0.0f, k_obstacle_grid, "obstacle 1");
    for (const NamedVector& vector : source.vectors)
        list.add_vector(vector.values, glm::vec3(0.0f), vector.name, vector.name + " " + vector.units);
    for (const NamedScalar& scalar : source.scalars)
        list.add_scalar(scalar.values, scalar.outside, scalar.name, scalar.name + " " + scalar.units);
    return std::move(list.grids);
}

/// io::File cannot tell a full disk, and io::Stream leaves out the table of grids, so that readers load a file whole to list it.
/// This writes what io::File writes to a stream that can seek.
class SeekableArchive : public openvdb::io::Archive {
  public:
    using openvdb::io::Archive::write;
};

/// OpenVDB gives each file a random tag; here the same content has the same one, so that equal air makes equal files. A UUID of version
/// 8 (RFC 9562) from checksums of what the file is made of.
std::string tag_of(const VelocityGrid& grid, const Options& options) {
    using windrow::detail::checksum, windrow::detail::Hex;
    std::uint64_t first = checksum(std::as_bytes(grid.field));
    std::uint64_t second = checksum(std::as_bytes(std::span(grid.obstacle)));
    const auto mix = [&](std::span<const std::byte> bytes) { second = second * 31 + checksum(bytes); };
    for (const NamedScalar& scalar : grid.scalars)
        mix(std::as_bytes(scalar.values));
    for (const NamedVector& vector : grid.vectors)
        mix(std::as_bytes(vector.values));
    const double numbers[] = {grid.origin.x, grid.origin.y, grid.origin.z, options.time, static_cast<double>(options.frame)};
    mix(std::as_bytes(std::span(numbers)));
    first = (first & ~std::uint64_t{0xf000}) | 0x8000;
    second = (second & ~(std::uint64_t{3} << 62)) | std::uint64_t{2} << 62;
    const std::string digits = message(Hex{static_cast<std::uint32_t>(first >> 32)}, Hex{static_cast<std::uint32_t>(first)},
                                       Hex{static_cast<std::uint32_t>(second >> 32)}, Hex{static_cast<std::uint32_t>(second)});
    return digits.substr(0, 8) + "-" + digits.substr(8, 4) + "-" + digits.substr(12, 4) + "-" + digits.substr(16, 4) + "-" +
           digits.substr(20);
}

/// Behind the magic number, the versions of the format and of OpenVDB, and a flag.
constexpr std::streamoff k_tag_at = 8 + 4 + 8 + 1;

#if WINDROW_WITH_NANOVDB
// NanoVDB writes a file's head last, and its own writer of files does not tell a full disk.
void write_nanovdb(std::ostream& stream, const openvdb::GridPtrVec& grids) {
    std::vector<nanovdb::GridHandle<nanovdb::HostBuffer>> handles;
    const auto convert = [&](const auto& grid) {
        handles.push_back(nanovdb::openToNanoVDB(grid, nanovdb::StatsMode::All, nanovdb::ChecksumMode::Full));
    };
    for (const auto& grid : grids) { // of the two kinds that are made here: conversions of all kinds take a compiler minutes
        if (const auto scalars = openvdb::gridPtrCast<openvdb::FloatGrid>(grid))
            convert(*scalars);
        else
            convert(*openvdb::gridPtrCast<openvdb::Vec3SGrid>(grid));
    }
    // It seeks beyond what is written: room for all of it and for the head, which is smaller than this.
    std::size_t room = 1024;
    for (std::size_t n = 0; n < grids.size(); ++n)
        room += handles[n].size() + grids[n]->getName().size() + 1024;
    std::stringstream bytes(std::string(room, '\0'), std::ios::in | std::ios::out | std::ios::binary);
    nanovdb::io::writeGrids(bytes, handles, nanovdb::io::Codec::NONE);
    const std::string_view written = bytes.view().substr(0, static_cast<std::size_t>(bytes.tellp()));
    stream.write(written.data(), static_cast<std::streamsize>(written.size()));
}
#else
void write_nanovdb(std::ostream&, const openvdb::GridPtrVec&) {}
#endif

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

bool has_nanovdb() {
    return WINDROW_WITH_NANOVDB != 0;
}

WriteResult write(const VelocityGrid& grid, const std::filesystem::path& file, const Options& options) {
    try {
        if (grid.lacks_obstacle)
            return out_of_memory(file.native(), grid);
        if (auto valid = check(grid, file, options); !valid)
            return {Problem::rejected, valid.error()};
        StreamedFile out(file);
        if (out.error() != 0)
            return failure(file, out.error());
        try {
            openvdb::initialize();
            std::ostream stream(&out);
            stream.exceptions(std::ios::failbit | std::ios::badbit);
            const openvdb::GridPtrVec grids = grids_of(grid, options);
            if (options.format == Format::nanovdb) {
                write_nanovdb(stream, grids);
            } else {
                SeekableArchive().write(stream, grids, true);
                const auto end = stream.tellp();
                stream.seekp(k_tag_at);
                stream << tag_of(grid, options);
                stream.seekp(end);
            }
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
    return folder / (prefix + number + (options.format == Format::nanovdb ? ".nvdb" : ".vdb"));
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
