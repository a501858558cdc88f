#include "fluid/shapes/voxel_grid.h"

#include "fluid/core/message.h"
#include "fluid/solids/content.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <tuple>
#include <utility>

namespace windrow {
namespace {

Result<void> check(const VoxelData& data) {
    for (int axis = 0; axis < 3; ++axis)
        if (data.cells[axis] < 1 || data.cells[axis] > VoxelGrid::k_max_axis_cells)
            return Error{detail::message("the voxel grid has ", data.cells, " cells: give 1 to ", VoxelGrid::k_max_axis_cells,
                                         " along each axis.")};
    const std::size_t count = static_cast<std::size_t>(data.cells.x) * data.cells.y * data.cells.z;
    if (count > VoxelGrid::k_max_cells)
        return Error{detail::message("the voxel grid has ", data.cells, " cells, ", count, " in all: give at most ",
                                     VoxelGrid::k_max_cells, ", by larger cells or by several grids.")};
    if (data.closed.size() != count)
        return Error{detail::message("the voxel grid has ", data.cells, " cells and ", data.closed.size(), " values: give ",
                                     count, ", one a cell.")};
    if (std::all_of(data.closed.begin(), data.closed.end(), [](std::uint8_t value) { return value == 0; }))
        return Error{"the voxel grid has no closed cell: close one at least."};
    return {};
}

bool within(glm::vec3 point, glm::ivec3 cells) {
    return glm::all(glm::lessThanEqual(glm::vec3(0.0f), point)) && glm::all(glm::lessThanEqual(point, glm::vec3(cells)));
}

} // namespace

VoxelGrid::VoxelGrid(VoxelData data) : data_(std::move(data)) {
    for (std::uint8_t& value : data_.closed)
        value = value != 0 ? 1 : 0;
    hash_ = detail::content_hash(data_.closed) + static_cast<std::uint64_t>(data_.cells.x) * 8191 +
            static_cast<std::uint64_t>(data_.cells.y);
    for (glm::ivec3 count = data_.cells; std::max({count.x, count.y, count.z}) > 1;) {
        const glm::ivec3 fine = std::exchange(count, (count + 1) / 2);
        Level level{.count = count, .holds = std::vector<std::uint8_t>(static_cast<std::size_t>(count.x) * count.y * count.z)};
        for (int k = 0; k < fine.z; ++k)
            for (int j = 0; j < fine.y; ++j)
                for (int i = 0; i < fine.x; ++i)
                    level.holds[index(count, glm::ivec3(i, j, k) / 2)] |=
                        holds(static_cast<int>(levels_.size()), glm::ivec3(i, j, k));
        levels_.push_back(std::move(level));
    }
    thickness_ = least_row();
}

Result<std::shared_ptr<const VoxelGrid>> VoxelGrid::create(VoxelData data) {
    return detail::where_memory_lasts([&]() -> Result<std::shared_ptr<const VoxelGrid>> {
        if (auto checked = check(data); !checked)
            return checked.failure();
        return std::shared_ptr<const VoxelGrid>(new VoxelGrid(std::move(data)));
    });
}

int VoxelGrid::least_row() const {
    int least = std::max({data_.cells.x, data_.cells.y, data_.cells.z});
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        glm::ivec3 cell(0);
        for (cell[v] = 0; cell[v] < data_.cells[v]; ++cell[v])
            for (cell[u] = 0; cell[u] < data_.cells[u]; ++cell[u])
                for (int n = 0, row = 0; n <= data_.cells[axis]; ++n) {
                    cell[axis] = n;
                    if (n < data_.cells[axis] && closed(cell)) {
                        ++row;
                    } else {
                        least = row > 0 ? std::min(least, row) : least;
                        row = 0;
                    }
                }
    }
    return least;
}

// From the largest block down, nearest first. A block of one kind needs no look at its cells.
float VoxelGrid::distance(glm::vec3 point, std::uint8_t kind, float most) const {
    struct Block {
        glm::ivec3 at;
        int level;
        float square;
    } open[96]; // 12 levels of 7 beside the one that is entered
    float nearest = most * most;
    int count = 0;
    const auto look_at = [&](glm::ivec3 at, int level) {
        if ((holds(level, at) & kind) == 0)
            return;
        const glm::vec3 low = glm::vec3(at * (1 << level)),
                        high = glm::min(glm::vec3((at + 1) * (1 << level)), glm::vec3(data_.cells));
        const glm::vec3 away = glm::max(glm::max(low - point, point - high), glm::vec3(0.0f));
        const float square = glm::dot(away, away);
        if (!(square < nearest))
            return;
        if (holds(level, at) == kind) {
            nearest = square;
            return;
        }
        int n = count++;
        for (; n > 0 && open[n - 1].level == level && open[n - 1].square < square; --n)
            open[n] = open[n - 1];
        open[n] = {at, level, square};
    };
    look_at(glm::ivec3(0), static_cast<int>(levels_.size()));
    while (count > 0) {
        const Block block = open[--count];
        if (!(block.square < nearest))
            continue;
        const int level = block.level - 1;
        const glm::ivec3 first = block.at * 2,
                         blocks = level == 0 ? data_.cells : levels_[static_cast<std::size_t>(level - 1)].count;
        const glm::ivec3 end = glm::min(first + 2, blocks);
        for (int k = first.z; k < end.z; ++k)
            for (int j = first.y; j < end.y; ++j)
                for (int i = first.x; i < end.x; ++i)
                    look_at({i, j, k}, level);
    }
    return std::sqrt(nearest);
}

float VoxelGrid::distance_to(glm::vec3 point, float most) const {
    if (within(point, data_.cells) && closed(glm::min(glm::ivec3(point), data_.cells - 1))) {
        const glm::vec3 out = glm::min(point, glm::vec3(data_.cells) - point);
        return -distance(point, k_open, std::min({out.x, out.y, out.z, most}));
    }
    return distance(point, k_closed, most);
}

// Based on: Amanatides and Woo 1987, "A fast voxel traversal algorithm for ray tracing", Eurographics.
bool VoxelGrid::crosses(glm::vec3 from, glm::vec3 to) const {
    const glm::dvec3 start(from), way = glm::dvec3(to) - start, size(data_.cells);
    double at = 0.0, end = 1.0; // within the grid
    for (int axis = 0; axis < 3; ++axis) {
        if (way[axis] == 0.0) {
            if (start[axis] < 0.0 || start[axis] > size[axis])
                return false;
            continue;
        }
        const double low = -start[axis] / way[axis], high = (size[axis] - start[axis]) / way[axis];
        at = std::max(at, std::min(low, high));
        end = std::min(end, std::max(low, high));
    }
    if (!(at <= end))
        return false;
    glm::ivec3 cell = glm::clamp(glm::ivec3(glm::floor(start + at * way)), glm::ivec3(0), data_.cells - 1);
    while (!closed(cell)) {
        int axis = -1;
        double next = end;
        for (int a = 0; a < 3; ++a) {
            if (way[a] == 0.0)
                continue;
            const double leaves = (cell[a] + (way[a] > 0.0 ? 1 : 0) - start[a]) / way[a];
            if (leaves <= next) {
                next = leaves;
                axis = a;
            }
        }
        if (axis < 0)
            return false;
        cell[axis] += way[axis] > 0.0 ? 1 : -1;
        if (cell[axis] < 0 || cell[axis] >= data_.cells[axis])
            return false;
    }
    return true;
}

std::size_t VoxelGrid::memory_bytes() const {
    std::size_t sum = sizeof(*this) + data_.closed.capacity();
    for (const Level& level : levels_)
        sum += sizeof(level) + level.holds.capacity();
    return sum;
}

std::strong_ordering operator<=>(const VoxelGrid& a, const VoxelGrid& b) {
    if (&a == &b)
        return std::strong_ordering::equal;
    const auto first = [](const VoxelGrid& grid) {
        return std::tuple(grid.hash_, grid.data_.cells.x, grid.data_.cells.y, grid.data_.cells.z);
    };
    const auto order = first(a) <=> first(b);
    return order != 0 ? order : detail::compare_content(a.data_.closed, b.data_.closed);
}

} // namespace windrow
