// What a file gives before it is a mesh: three corners a triangle, not shared.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace windrow::vegetation::fur {

struct Corner {
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f}; ///< of the file; 0 where it has none
    glm::vec2 uv{0.0f};
};

struct SoupPart {
    std::string material;
    std::vector<Corner> corners; ///< three a triangle
    bool has_uv = false;
};

using Soup = std::vector<SoupPart>;

} // namespace windrow::vegetation::fur
