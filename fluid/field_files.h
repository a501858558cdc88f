// Velocities on equal cells, as files that engines and analysts read.
//
//     const auto grid = windrow::field_grid(wind->view());
//     if (auto written = windrow::write_field("wind.fga", windrow::FieldFormat::fga, grid); !written)
//         return puts(written.error().c_str()), 2;
//
// | format | read by | holds |
// |---|---|---|
// | fga | Unreal Engine: vector fields of Niagara and Cascade | text; z up, left-handed, centimetres |
// | vf  | Unity: vector fields of the Visual Effect Graph | floats; y up, left-handed, metres: z is mirrored |
// | raw | any engine: a 3D texture of halfs, x, y, z, 0 | metres a second, x fastest; its size, place and time in NAME.raw.json |
// | npz | numpy: arrays velocity, obstacle, origin, cell_size, time | [z, y, x, component], little-endian |
// | vti | ParaView, VTK: cells of ImageData | velocity, and obstacle where there is one |
//
// raw, npz and vti have the axes of the library. A file appears when it is complete.
#pragma once

#include "api.h"
#include "result.h"
#include "setting.h"
#include "view.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace windrow {

/// A field on cells of one size, x fastest, then y, then z.
struct FieldGrid {
    glm::ivec3 cells{0};
    glm::vec3 cell_size{1.0f};         ///< [m] along each axis
    glm::dvec3 origin{0.0};            ///< [m] world position of the low corner
    double time = 0.0;                 ///< [s]
    std::vector<glm::vec4> velocity{}; ///< [m/s] one a cell, w = 0
    std::vector<float> obstacle{};     ///< 1 inside obstacles, else 0; empty: none
};

/// The cells of a wind. Where its rows are of unequal thickness, what it is at the centres of equal cells: as many rows as cells of
/// its size fill its height. `obstacle` is of the wind's own cells (Wind::write_obstacles); empty: none.
[[nodiscard]] WINDROW_API FieldGrid field_grid(const WindView& air, std::span<const float> obstacle = {});

enum class FieldFormat : std::uint8_t { fga, vf, raw, npz, vti };
template <>
inline constexpr std::array<const char*, 5> k_words<FieldFormat>{"fga", "vf", "raw", "npz", "vti"};

/// "fga", which is also the suffix of its files.
[[nodiscard]] inline const char* name_of(FieldFormat format) {
    return k_words<FieldFormat>[static_cast<std::size_t>(format)];
}

/// Writes a file, by an atomic write. An error names the file and the reason: it cannot be written, or the format cannot hold so many
/// cells (65,535 along an axis; npz: 4 GiB).
[[nodiscard]] WINDROW_API Result<void> write_field(const std::filesystem::path& file, FieldFormat format, const FieldGrid& grid);

} // namespace windrow
