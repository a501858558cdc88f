// A coat in a material of an OBJ file: the line `fur COUNT HEIGHT THICKNESS RESOLUTION` of its mtl.
//
//     newmtl coat
//     fur 48 0.419 2.753 11
//
// Based on: Curoe 2024, Shell-textured worlds: the line that his model format adds to the mtl, here with limits and refusals.
#pragma once

#include "fluid/result.h"

#include <map>
#include <string>
#include <string_view>

namespace windrow::vegetation::fur {

/// Defaults: Curoe's polar bear.
struct FurLine {
    int shells = 48;          ///< 2 to 4096, as ShellSettings
    float height = 0.419f;    ///< of the outermost shell, in the file's own units, 1e-6 to 100, as ShellSettings.length
    float thickness = 2.753f; ///< T of the strands' cone, 0 to 10, above which strands fill their cells whatever it is
    float resolution = 11.0f; ///< strands along one unit of uv, 1 to 4096, above which a strand is below a texel of any map

    bool operator==(const FurLine&) const = default;
};

/// The coats of an mtl text by material; materials without the line are not in it. Refuses, with `name` and the line's number:
/// a line with other than four numbers, numbers out of range, a second coat of one material, a coat before any newmtl.
[[nodiscard]] windrow::Result<std::map<std::string, FurLine>> read_fur_lines(std::string_view mtl, const std::string& name);

} // namespace windrow::vegetation::fur
