// Parts of MagicaVoxel files, and whole ones, as tests write them.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace windrow::test {

inline std::string number(int value) {
    std::string bytes(4, '\0');
    for (std::size_t n = 0; n < 4; ++n)
        bytes[n] = static_cast<char>(value >> (8 * n));
    return bytes;
}
inline std::string chunk(const char* name, const std::string& content) {
    return name + number(static_cast<int>(content.size())) + number(0) + content;
}
inline std::string text(const std::string& words) {
    return number(static_cast<int>(words.size())) + words;
}
inline std::string vox_model(glm::ivec3 size, const std::vector<glm::ivec3>& cells) {
    std::string content = number(static_cast<int>(cells.size()));
    for (const glm::ivec3 cell : cells)
        for (const int part : {cell.x, cell.y, cell.z, 79})
            content += static_cast<char>(part);
    return chunk("SIZE", number(size.x) + number(size.y) + number(size.z)) + chunk("XYZI", content);
}
inline std::string vox_file(const std::string& chunks) {
    return "VOX " + number(150) + "MAIN" + number(0) + number(static_cast<int>(chunks.size())) + chunks;
}
/// A node that turns and places its child.
inline std::string vox_place(int node, int child, const std::string& turn, const std::string& way, bool hidden = false) {
    return chunk("nTRN", number(node) + (hidden ? number(1) + text("_hidden") + text("1") : number(0)) + number(child) +
                             number(-1) + number(0) + number(1) + number(2) + text("_t") + text(way) + text("_r") + text(turn));
}
inline std::string vox_shape(int node, int model) {
    return chunk("nSHP", number(node) + number(0) + number(1) + number(model) + number(0));
}

/// A .vox file of one model. `turns`: of the nodes over it, the outermost first, each as the file writes it; `shapes`: nodes that show it.
inline std::string vox(glm::ivec3 size, const std::vector<glm::ivec3>& cells, int models = 1,
                       const std::vector<std::string>& turns = {}, int shapes = 1) {
    std::string chunks;
    for (int n = 0; n < models; ++n)
        chunks += vox_model(size, cells);
    const int depth = static_cast<int>(turns.size());
    for (int n = 0; n < depth; ++n)
        chunks += vox_place(n, n + 1, turns[static_cast<std::size_t>(n)], "0 0 2");
    if (depth > 0) { // a group of the shapes
        std::string group = number(depth) + number(1) + text("_name") + text("all") + number(shapes);
        for (int n = 0; n < shapes; ++n)
            group += number(depth + 1 + n);
        chunks += chunk("nGRP", group);
        for (int n = 0; n < shapes; ++n)
            chunks += vox_shape(depth + 1 + n, 0);
    }
    return vox_file(chunks + chunk("RGBA", std::string(1024, 'c')));
}

} // namespace windrow::test
