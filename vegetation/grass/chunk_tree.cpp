#include "vegetation/grass/chunk_tree.h"

#include <algorithm>

namespace windrow::vegetation::grass {

glm::ivec2 cells_of(const HeightMap& heights, const GrassSettings& settings) {
    const glm::dvec2 cells = glm::dvec2(heights.extent()) * static_cast<double>(settings.density);
    return glm::max(glm::ivec2(glm::floor(cells + 1e-3)), glm::ivec2(1)); // rounding takes no cell away
}

float distance_to(const ChunkBox& box, glm::vec3 point) {
    return glm::length(glm::max(glm::max(box.low - point, point - box.high), glm::vec3(0.0f)));
}

bool may_see(const Planes& planes, const ChunkBox& box) {
    return std::none_of(planes.begin(), planes.end(), [&](const glm::vec4& plane) {
        // The corner of the box that lies farthest along the plane's inner side.
        const glm::vec3 corner(plane.x > 0.0f ? box.high.x : box.low.x, plane.y > 0.0f ? box.high.y : box.low.y,
                               plane.z > 0.0f ? box.high.z : box.low.z);
        return windrow::numerics::windrow_beyond_plane(plane, corner, 0.0f);
    });
}

ChunkTree::ChunkTree(const HeightMap& heights, const PlacementMask& mask, const GrassSettings& settings, float reach)
    : reach_(reach) {
    cells_ = cells_of(heights, settings);
    chunks_ = (cells_ + settings.chunk_cells - 1) / settings.chunk_cells;
    chunk_side_ = static_cast<float>(settings.chunk_cells) / settings.density;
    edge_ = glm::vec2(cells_) / settings.density;
    for (glm::ivec2 size = chunks_;; size = (size + 1) / 2) {
        levels_.push_back({size, std::vector<Node>(static_cast<std::size_t>(size.x) * size.y)});
        if (size == glm::ivec2(1))
            break;
    }
    refresh(heights, mask, {glm::vec2(0.0f), heights.extent()});
}

void ChunkTree::refresh(const HeightMap& heights, const PlacementMask& mask, const Touched& touched) {
    if (touched.high.x < touched.low.x || touched.high.y < touched.low.y)
        return;
    glm::ivec2 first = glm::clamp(glm::ivec2(glm::floor(touched.low / chunk_side_)), glm::ivec2(0), chunks_ - 1);
    glm::ivec2 last = glm::clamp(glm::ivec2(glm::floor(touched.high / chunk_side_)), glm::ivec2(0), chunks_ - 1);
    for (int level = 0; level < static_cast<int>(levels_.size()); ++level) {
        Level& here = levels_[static_cast<std::size_t>(level)];
        for (int z = first.y; z <= last.y; ++z)
            for (int x = first.x; x <= last.x; ++x) {
                Node made;
                if (level == 0) {
                    const glm::vec2 low = chunk_side_ * glm::vec2(x, z), high = glm::min(low + chunk_side_, edge_);
                    if (mask.grows(low, high)) {
                        const glm::vec2 range = heights.range(low, high);
                        made = {range.x, range.y};
                    }
                } else {
                    const glm::ivec2 below = levels_[static_cast<std::size_t>(level) - 1].size;
                    for (int child = 0; child < 4; ++child) {
                        const glm::ivec2 at = 2 * glm::ivec2(x, z) + glm::ivec2(child & 1, child >> 1);
                        if (at.x >= below.x || at.y >= below.y || !node(level - 1, at).grows())
                            continue;
                        const Node& part = node(level - 1, at);
                        made = made.grows() ? Node{std::min(made.low, part.low), std::max(made.high, part.high)} : part;
                    }
                }
                here.nodes[static_cast<std::size_t>(z) * here.size.x + x] = made;
            }
        first /= 2;
        last /= 2;
    }
}

const ChunkTree::Node& ChunkTree::node(int level, glm::ivec2 at) const {
    const Level& here = levels_[static_cast<std::size_t>(level)];
    return here.nodes[static_cast<std::size_t>(at.y) * here.size.x + at.x];
}

ChunkBox ChunkTree::box_of(int level, glm::ivec2 at) const {
    const Node& part = node(level, at);
    const float side = chunk_side_ * static_cast<float>(1 << level);
    const glm::vec2 low = side * glm::vec2(at), high = glm::min(low + side, edge_);
    return {glm::vec3(low.x, part.low, low.y) - reach_, glm::vec3(high.x, part.high, high.y) + reach_};
}

void ChunkTree::visible(const Planes& planes, glm::vec3 eye, float distance, std::vector<Chunk>& found) const {
    found.clear();
    walk(static_cast<int>(levels_.size()) - 1, glm::ivec2(0), planes, eye, distance, found);
    const auto nearness = [&](Chunk chunk) { return distance_to(box(chunk), eye); };
    std::sort(found.begin(), found.end(), [&](Chunk a, Chunk b) {
        const float to_a = nearness(a), to_b = nearness(b);
        // A fixed order among equals: the same view draws the same picture.
        return to_a != to_b ? to_a < to_b : a.at.y != b.at.y ? a.at.y < b.at.y : a.at.x < b.at.x;
    });
}

void ChunkTree::walk(int level, glm::ivec2 at, const Planes& planes, glm::vec3 eye, float distance,
                     std::vector<Chunk>& found) const {
    const glm::ivec2 size = levels_[static_cast<std::size_t>(level)].size;
    if (at.x >= size.x || at.y >= size.y || !node(level, at).grows())
        return;
    const ChunkBox whole = box_of(level, at);
    if (!(distance_to(whole, eye) < distance) || !may_see(planes, whole))
        return;
    if (level == 0) {
        found.push_back({at});
        return;
    }
    for (int child = 0; child < 4; ++child)
        walk(level - 1, 2 * at + glm::ivec2(child & 1, child >> 1), planes, eye, distance, found);
}

} // namespace windrow::vegetation::grass
