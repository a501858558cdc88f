#include "fluid/obstacle_grid.h"

#include "fluid/portable_math.h"

#include <algorithm>
#include <bit>

namespace windrow::detail {

void ObstacleGrid::reserve(std::size_t count) {
    if (count <= nodes_.size())
        return;
    std::vector<Node> nodes;
    nodes.reserve(count);
    nodes.assign(nodes_.begin(), nodes_.end());
    nodes.resize(count);
    std::vector<std::uint32_t> heads(std::bit_ceil(2 * count), k_none);
    nodes_.swap(nodes);
    heads_.swap(heads);
    for (std::uint32_t item = 0; item < nodes_.size(); ++item)
        if (nodes_[item].level >= 0)
            link(item);
}

void ObstacleGrid::insert(std::uint32_t item, glm::dvec3 centre, double radius) {
    Node& node = nodes_[item];
    node.level = std::clamp(numerics::ceil_log2(2.0 * radius / finest_), 0, k_levels - 1);
    node.cell = cell_of(centre, node.level, 0.0);
    link(item);
    ++on_level_[static_cast<std::size_t>(node.level)];
    ++count_;
}

void ObstacleGrid::link(std::uint32_t item) {
    Node& node = nodes_[item];
    std::uint32_t& head = heads_[bucket_of(node.cell, node.level)];
    node.before = k_none;
    node.next = head;
    if (head != k_none)
        nodes_[head].before = item;
    head = item;
}

void ObstacleGrid::erase(std::uint32_t item) {
    Node& node = nodes_[item];
    (node.before != k_none ? nodes_[node.before].next : heads_[bucket_of(node.cell, node.level)]) = node.next;
    if (node.next != k_none)
        nodes_[node.next].before = node.before;
    --on_level_[static_cast<std::size_t>(node.level)];
    --count_;
    node.level = -1;
}

std::size_t ObstacleGrid::bucket_of(CellIndex cell, int level) const {
    std::uint64_t hash = static_cast<std::uint64_t>(level);
    for (int axis = 0; axis < 3; ++axis) {
        hash = (hash ^ static_cast<std::uint64_t>(cell[axis])) * 0x9e3779b97f4a7c15; // Knuth's multiplicative hash
        hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash & (heads_.size() - 1));
}

double ObstacleGrid::cells_in(glm::dvec3 low, glm::dvec3 high) const {
    double cells = 0.0;
    for (int level = 0; level < k_levels; ++level)
        if (on_level_[static_cast<std::size_t>(level)] > 0) {
            const glm::dvec3 along = glm::floor((high - low) / width(level)) + 3.0; // at most
            cells += along.x * along.y * along.z;
        }
    return cells;
}

} // namespace windrow::detail
