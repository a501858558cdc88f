// The one place that Assimp is called from: checked bytes to triangles.
#pragma once

#include "fluid/result.h"
#include "vegetation/fur/mesh_weld.h"

#include <map>
#include <string>

namespace windrow::vegetation::fur {

/// `files`: the bytes that Assimp may see, by name; `name` is one of them, and its ending says what it is: obj, gltf.
/// Nothing else is opened. Nodes place their meshes. `owner` is for sentences. Rejects what Assimp rejects, and more triangles than k_max_triangles.
[[nodiscard]] windrow::Result<Soup> import_soup(const std::map<std::string, std::string>& files, const std::string& name,
                                                const std::string& owner);

} // namespace windrow::vegetation::fur
