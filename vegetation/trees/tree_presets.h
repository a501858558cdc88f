// Kinds of tree by name. Sizes and forms are typical ones of grown trees in the open, ours.
#pragma once

#include "tree_settings.h"

#include <span>
#include <string_view>

namespace windrow::vegetation::trees {

struct TreeKind {
    TreeSettings tree{};
    TreeLook look{};
    TreeLevels levels{};
};

/// "oak": broad, crooked, dark. "birch": slender, light, hanging twigs, a white stem. "spruce": a cone of whorls. "bush": hazel
/// from the ground up. Rejects other names with a list of these.
[[nodiscard]] windrow::Result<TreeKind> preset(std::string_view name);
[[nodiscard]] std::span<const std::string_view> preset_names();

} // namespace windrow::vegetation::trees
