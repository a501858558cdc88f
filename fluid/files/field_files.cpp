// Writers of field_files.h. Based on the published descriptions: FGA (JangaFX, VectorayGen), VF (VectorFieldFile, revision 1),
// NPY 1.0 (numpy.lib.format), ZIP (PKWARE APPNOTE 6.3, stored entries), VTK XML ImageData 1.0.
#include "fluid/field_files.h"

#include "fluid/core/bytes.h"
#include "fluid/core/message.h"
#include "fluid/files/new_file.h"
#include "fluid/textures.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

namespace windrow {
namespace {

using detail::message;

template <class Number>
void put(std::string& bytes, Number value) {
    if constexpr (sizeof value == 2) {
        bytes += static_cast<char>(value & 0xff);
        bytes += static_cast<char>(value >> 8);
    } else {
        std::byte at[sizeof value];
        detail::store_number(at, value);
        bytes.append(reinterpret_cast<const char*>(at), sizeof value);
    }
}

std::size_t index_of(const FieldGrid& grid, int i, int j, int k) {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(grid.cells.y) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(grid.cells.x) +
           static_cast<std::size_t>(i);
}

// --- fga: Unreal's x, y, z are x, z, y here, which also changes the hand ---------------------------------------------------
std::string fga(const FieldGrid& grid) {
    constexpr double k_centimetres = 100.0;
    std::string text;
    const auto row = [&](double x, double y, double z) {
        char digits[40];
        for (const double number : {x, y, z}) { // seven digits, as a float has
            const auto end =
                std::to_chars(digits, digits + sizeof digits, static_cast<float>(number), std::chars_format::general, 7).ptr;
            text.append(digits, end).append(1, ',');
        }
        text += '\n';
    };
    const glm::dvec3 low = k_centimetres * grid.origin;
    const glm::dvec3 high = low + k_centimetres * glm::dvec3(grid.cell_size) * glm::dvec3(grid.cells);
    row(grid.cells.x, grid.cells.z, grid.cells.y);
    row(low.x, low.z, low.y);
    row(high.x, high.z, high.y);
    for (int j = 0; j < grid.cells.y; ++j)
        for (int k = 0; k < grid.cells.z; ++k)
            for (int i = 0; i < grid.cells.x; ++i) {
                const glm::dvec3 u = k_centimetres * glm::dvec3(grid.velocity[index_of(grid, i, j, k)]);
                row(u.x, u.z, u.y);
            }
    return text;
}

// --- vf: the z axis mirrored -----------------------------------------------------------------------------------------------
std::string vf(const FieldGrid& grid) {
    std::string bytes = "VF_V";
    for (int axis = 0; axis < 3; ++axis)
        put(bytes, static_cast<std::uint16_t>(grid.cells[axis]));
    for (int k = grid.cells.z - 1; k >= 0; --k)
        for (int j = 0; j < grid.cells.y; ++j)
            for (int i = 0; i < grid.cells.x; ++i) {
                const glm::vec4 u = grid.velocity[index_of(grid, i, j, k)];
                put(bytes, u.x);
                put(bytes, u.y);
                put(bytes, -u.z);
            }
    return bytes;
}

// --- raw -------------------------------------------------------------------------------------------------------------------
std::string raw(const FieldGrid& grid) {
    std::string bytes;
    bytes.reserve(grid.velocity.size() * 8);
    for (const glm::vec4& u : grid.velocity)
        for (int component = 0; component < 4; ++component)
            put(bytes, to_half(u[component]));
    return bytes;
}
std::string raw_words(const FieldGrid& grid) {
    const auto list = [](const auto& values) { return message("[", values.x, ", ", values.y, ", ", values.z, "]"); };
    return message("{\n    \"format\": \"rgba16f\",\n    \"order\": \"x fastest, then y, then z\",\n    \"components\": ",
                   "\"velocity x, y, z [m/s], 0\",\n    \"size\": ", list(grid.cells),
                   ",\n    \"cell_size\": ", list(grid.cell_size), ",\n    \"origin\": ", list(grid.origin),
                   ",\n    \"time\": ", grid.time, "\n}\n");
}

// --- npz -------------------------------------------------------------------------------------------------------------------
std::uint32_t crc32(std::string_view bytes) {
    std::uint32_t sum = 0xffffffffu;
    for (const char letter : bytes) {
        sum ^= static_cast<unsigned char>(letter);
        for (int bit = 0; bit < 8; ++bit)
            sum = (sum >> 1) ^ ((sum & 1u) != 0 ? 0xedb88320u : 0u);
    }
    return ~sum;
}

struct ZipEntry {
    std::string name;
    std::string bytes;
};

/// An array of NPY 1.0. `shape` is a tuple of Python's.
ZipEntry npy(std::string_view name, const char* kind, std::string_view shape, std::string bytes) {
    std::string head = message("{'descr': '", std::string_view(kind), "', 'fortran_order': False, 'shape': ", shape, ", }");
    head.append((64 - (10 + head.size() + 1) % 64) % 64, ' ');
    head += '\n';
    std::string all = "\x93NUMPY";
    all.append("\x01\x00", 2);
    put(all, static_cast<std::uint16_t>(head.size()));
    return {message(name, ".npy"), all + head + bytes};
}

/// Entries that are stored, not packed; below 4 GiB.
std::string zip(const std::vector<ZipEntry>& entries) {
    constexpr std::uint16_t k_version = 20, k_first_day = 33; // 1 January 1980
    std::string bytes, directory;
    for (const ZipEntry& entry : entries) {
        const auto at = static_cast<std::uint32_t>(bytes.size()), size = static_cast<std::uint32_t>(entry.bytes.size());
        std::string common;
        put(common, k_version);
        for (const std::uint16_t number :
             {std::uint16_t{0}, std::uint16_t{0}, std::uint16_t{0}, k_first_day}) // flags, stored, time, day
            put(common, number);
        put(common, crc32(entry.bytes));
        put(common, size);
        put(common, size);
        put(common, static_cast<std::uint16_t>(entry.name.size()));
        put(common, std::uint16_t{0});
        put(bytes, std::uint32_t{0x04034b50});
        bytes += common + entry.name + entry.bytes;
        put(directory, std::uint32_t{0x02014b50});
        put(directory, k_version);
        directory += common;
        for (int n = 0; n < 3; ++n) // comment, disk, kind of content
            put(directory, std::uint16_t{0});
        put(directory, std::uint32_t{0});
        put(directory, at);
        directory += entry.name;
    }
    const auto begin = static_cast<std::uint32_t>(bytes.size());
    bytes += directory;
    put(bytes, std::uint32_t{0x06054b50});
    put(bytes, std::uint32_t{0}); // disks
    put(bytes, static_cast<std::uint16_t>(entries.size()));
    put(bytes, static_cast<std::uint16_t>(entries.size()));
    put(bytes, static_cast<std::uint32_t>(directory.size()));
    put(bytes, begin);
    put(bytes, std::uint16_t{0});
    return bytes;
}

std::string floats(const FieldGrid& grid) {
    std::string bytes;
    bytes.reserve(grid.velocity.size() * 12);
    for (const glm::vec4& u : grid.velocity)
        for (int component = 0; component < 3; ++component)
            put(bytes, u[component]);
    return bytes;
}
std::string flags(const FieldGrid& grid) {
    std::string bytes;
    for (const float cell : grid.obstacle)
        bytes += cell != 0.0f ? '\1' : '\0';
    return bytes;
}

std::string npz(const FieldGrid& grid) {
    const auto numbers = [](std::initializer_list<double> values) {
        std::string bytes;
        for (const double value : values)
            put(bytes, value);
        return bytes;
    };
    const std::string shape = message(grid.cells.z, ", ", grid.cells.y, ", ", grid.cells.x);
    const glm::dvec3 size(grid.cell_size);
    std::vector<ZipEntry> entries{npy("velocity", "<f4", message("(", shape, ", 3)"), floats(grid)),
                                  npy("origin", "<f8", "(3,)", numbers({grid.origin.x, grid.origin.y, grid.origin.z})),
                                  npy("cell_size", "<f8", "(3,)", numbers({size.x, size.y, size.z})),
                                  npy("time", "<f8", "()", numbers({grid.time}))};
    if (!grid.obstacle.empty())
        entries.push_back(npy("obstacle", "|b1", message("(", shape, ")"), flags(grid)));
    return zip(entries);
}

// --- vti -------------------------------------------------------------------------------------------------------------------
std::string vti(const FieldGrid& grid) {
    const std::string extent = message("0 ", grid.cells.x, " 0 ", grid.cells.y, " 0 ", grid.cells.z);
    const std::string velocity = floats(grid), obstacle = flags(grid);
    std::string text =
        message("<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
                "header_type=\"UInt64\">\n<ImageData WholeExtent=\"",
                extent, "\" Origin=\"", grid.origin.x, " ", grid.origin.y, " ", grid.origin.z, "\" Spacing=\"", grid.cell_size.x,
                " ", grid.cell_size.y, " ", grid.cell_size.z,
                "\">\n<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">",
                grid.time, "</DataArray>\n</FieldData>\n<Piece Extent=\"", extent,
                "\">\n<CellData Vectors=\"velocity\">\n<DataArray type=\"Float32\" Name=\"velocity\" "
                "NumberOfComponents=\"3\" format=\"appended\" offset=\"0\"/>\n");
    if (!obstacle.empty())
        text +=
            message("<DataArray type=\"UInt8\" Name=\"obstacle\" format=\"appended\" offset=\"", velocity.size() + 8, "\"/>\n");
    text += "</CellData>\n</Piece>\n</ImageData>\n<AppendedData encoding=\"raw\">\n_";
    put(text, static_cast<std::uint64_t>(velocity.size()));
    text += velocity;
    if (!obstacle.empty()) {
        put(text, static_cast<std::uint64_t>(obstacle.size()));
        text += obstacle;
    }
    return text + "\n</AppendedData>\n</VTKFile>\n";
}

} // namespace

FieldGrid field_grid(const WindView& air, std::span<const float> obstacle) {
    const Box& box = air.box();
    FieldGrid grid{.cells = box.cells, .cell_size = glm::vec3(box.cell_size), .origin = air.origin()};
    if (!box.rows) {
        grid.velocity.assign(air.field().begin(), air.field().end());
        grid.obstacle.assign(obstacle.begin(), obstacle.end());
        return grid;
    }
    const float height = box.size().y;
    grid.cells.y = static_cast<int>(std::clamp(std::round(height / box.cell_size), 1.0f, 65535.0f));
    grid.cell_size.y = height / static_cast<float>(grid.cells.y);
    const std::size_t count =
        static_cast<std::size_t>(grid.cells.x) * static_cast<std::size_t>(grid.cells.y) * static_cast<std::size_t>(grid.cells.z);
    grid.velocity.resize(count);
    grid.obstacle.resize(obstacle.empty() ? 0 : count);
    std::vector<glm::dvec3> centres(static_cast<std::size_t>(grid.cells.x));
    const std::span<const float> rows = box.rows->centres();
    for (int k = 0; k < grid.cells.z; ++k)
        for (int j = 0; j < grid.cells.y; ++j) {
            for (int i = 0; i < grid.cells.x; ++i)
                centres[static_cast<std::size_t>(i)] = grid.origin + glm::dvec3(grid.cell_size) * (glm::dvec3(i, j, k) + 0.5);
            const std::size_t at = index_of(grid, 0, j, k);
            air.velocity(centres, std::span(grid.velocity).subspan(at, centres.size()));
            if (obstacle.empty())
                continue;
            const float y = grid.cell_size.y * (static_cast<float>(j) + 0.5f); // the nearest row
            const auto above = std::lower_bound(rows.begin(), rows.end(), y);
            auto nearest = above == rows.end() ? above - 1 : above;
            if (nearest != rows.begin() && y - *(nearest - 1) < *nearest - y)
                --nearest;
            for (int i = 0; i < grid.cells.x; ++i)
                grid.obstacle[at + static_cast<std::size_t>(i)] =
                    obstacle[box.index(i, static_cast<int>(nearest - rows.begin()), k)];
        }
    return grid;
}

Result<void> write_field(const std::filesystem::path& file, FieldFormat format, const FieldGrid& grid) {
    return detail::where_memory_lasts([&]() -> Result<void> {
        const std::size_t count = static_cast<std::size_t>(grid.cells.x) * static_cast<std::size_t>(grid.cells.y) *
                                  static_cast<std::size_t>(grid.cells.z);
        const int most = std::max({grid.cells.x, grid.cells.y, grid.cells.z}),
                  least = std::min({grid.cells.x, grid.cells.y, grid.cells.z});
        if (least < 1 || most > 65535 || grid.velocity.size() != count ||
            (!grid.obstacle.empty() && grid.obstacle.size() != count))
            return Error{message(file.string(), ": the grid has ", grid.cells, " cells, ", grid.velocity.size(),
                                 " velocities and ", grid.obstacle.size(),
                                 " cells of obstacles: give one for each of 1 to 65535 cells along an axis.")};
        constexpr std::array k_makers{fga, vf, raw, npz, vti};
        if (static_cast<std::size_t>(format) >= k_makers.size())
            return Error{message(file.string(), ": there is no format ", static_cast<int>(format), ".")};
        constexpr std::size_t k_bytes_a_cell = 13, k_head = 4096; // of npz, whose sizes have 32 bits
        if (format == FieldFormat::npz && count > (0xffffffffu - k_head) / k_bytes_a_cell)
            return Error{message(file.string(), ": npz holds less than 4 GiB: give fewer cells than ", count, ".")};
        const auto written = detail::write_file("field", file, k_makers[static_cast<std::size_t>(format)](grid));
        if (!written || format != FieldFormat::raw)
            return written;
        auto words = file;
        return detail::write_file("field", words += ".json", raw_words(grid));
    });
}

} // namespace windrow
