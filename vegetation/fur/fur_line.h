// A coat in a material of an OBJ file: the line `fur COUNT HEIGHT THICKNESS RESOLUTION` of its mtl.
//
//     newmtl coat
//     fur 48 0.419 2.753 11
//
// Based on: Curoe 2024, Shell-textured worlds: the line that his model format adds to the mtl, here with limits and rejections.
#pragma once

#include "../../fluid/result.h"
#include "../../fluid/setting.h"

#include <map>
#include <string>
#include <string_view>

namespace windrow::vegetation::fur {

/// Defaults: Curoe's polar bear.
struct FurLine {
    int shells = 48;
    float height = 0.419f;
    float thickness = 2.753f;
    float resolution = 11.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("shells", &FurLine::shells, {2.0, 4096.0}, "As ShellSettings."),
            Setting("height", &FurLine::height, {1e-6, 100.0},
                    "Of the outermost shell, in the file's own units, as ShellSettings.length."),
            Setting("thickness", &FurLine::thickness, {0.0, 10.0}, "T of the strands' cone."),
            Setting("resolution", &FurLine::resolution, {1.0, 4096.0},
                    "Strands along one unit of uv; above 4096 a strand is below a texel of any map."),
        };
    }

    bool operator==(const FurLine&) const = default;
};

/// The coats of an mtl text by material; materials without the line are not in it. Rejects, with `name` and the line's number:
/// a line with other than four numbers, numbers out of range, a second coat of one material, a coat before any newmtl.
[[nodiscard]] windrow::Result<std::map<std::string, FurLine>> read_fur_lines(std::string_view mtl, const std::string& name);

} // namespace windrow::vegetation::fur
