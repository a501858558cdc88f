// The settings of a wind as C++: what an artist found, for the programmer who embeds the wind.
//
//     auto text = windrow::scene::write_cpp(wind.config());
//     // windrow::Config{.cells = {48, 16, 48}, .cell_size = 0.75f, .ambient = {3.4f, 0.0f, 4.2f}}
#pragma once

#include "fluid/config.h"

#include <string>

namespace windrow::scene {

/// An expression of windrow::Config with designated initialisers: each setting of a scene file that differs from its default, with
/// the digits that name it. Rejects a map of roughness, whose lengths are a file's.
[[nodiscard]] Result<std::string> write_cpp(const Config& config);

} // namespace windrow::scene
