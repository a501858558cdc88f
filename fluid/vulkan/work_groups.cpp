#include "fluid/vulkan/work_groups.h"

#include "gpu/device.h"

namespace windrow::vulkan {
namespace {

constexpr std::uint32_t k_cell_group = 128;  // invocations; every device has as many
constexpr std::uint32_t k_solve_group = 256; // of a plane's transform, where the device has them
constexpr std::uint32_t k_tile_lines = 16;   // of a tile that is not a whole plane

} // namespace

Groups cell_group(glm::ivec3 cells) {
    const auto x = std::min(32u, std::bit_ceil(static_cast<std::uint32_t>(cells.x)));
    const auto y = std::min(k_cell_group / x, std::bit_ceil(static_cast<std::uint32_t>(cells.y)));
    // 64: the guaranteed maximum of a group along z.
    return {x, y, std::min(64u, k_cell_group / x / y)};
}

Groups groups_over(glm::ivec3 cells, const Groups& size) {
    return {blocks(static_cast<std::uint32_t>(cells.x), size[0]), blocks(static_cast<std::uint32_t>(cells.y), size[1]),
            blocks(static_cast<std::uint32_t>(cells.z), size[2])};
}

std::uint32_t solve_group(const Device& device) {
    return std::min({k_solve_group, device.limits().maxComputeWorkGroupInvocations, device.limits().maxComputeWorkGroupSize[0]});
}

PlaneTiles tiles_of(const Device& device, std::uint32_t group, glm::ivec3 cells) {
    const auto nx = static_cast<std::uint32_t>(cells.x), nz = static_cast<std::uint32_t>(cells.z);
    // Groups of more than half the invocations compute: 32 products each (WINDROW_TILE_HELD) hold 16 times the group.
    const std::uint32_t most = std::min<std::uint32_t>(
        {WINDROW_TILE_FLOATS, WINDROW_TILE_HELD / 2 * group, device.limits().maxComputeSharedMemorySize / 4});
    PlaneTiles tiles;
    tiles.whole = nx * nz <= most;
    tiles.x = nx;
    tiles.z = tiles.whole ? nz : std::clamp(most / nx, 1u, std::min(k_tile_lines, nz));
    tiles.between_x = std::clamp(most / nz, 1u, std::min(k_tile_lines, nx));
    return tiles;
}

SlabGroups slab_groups(glm::ivec3 cells) {
    const auto nx = static_cast<std::uint32_t>(cells.x), ny = static_cast<std::uint32_t>(cells.y),
               nz = static_cast<std::uint32_t>(cells.z);
    SlabGroups groups;
    groups.lines = nx > 64 && nx <= 256 ? 16 : 8;
    groups.lines_each = nx <= 32 ? 1 : nx <= 64 ? 2 : 4;
    groups.of_lines = nx / 4 * groups.lines / groups.lines_each;
    constexpr std::uint32_t k_wanted = 128, k_most_each = 4; // `held` of products.glsl has room for as many
    const auto of_slab = [&](std::uint32_t each) { return nz / 8 * blocks(ny, each); };
    while (groups.slab_each < k_most_each && of_slab(groups.slab_each) > k_wanted)
        groups.slab_each *= 2;
    groups.of_slab = of_slab(groups.slab_each);
    return groups;
}

bool Passes::fits_in_slabs(const Device& device, glm::ivec3 cells) {
    const SlabGroups groups = slab_groups(cells);
    const std::uint32_t line = groups.lines * static_cast<std::uint32_t>(cells.x),
                        slab = static_cast<std::uint32_t>(cells.y * (cells.z / 2));
    const std::uint32_t floats = std::min<std::uint32_t>(WINDROW_TILE_FLOATS, device.limits().maxComputeSharedMemorySize / 4);
    return cells.x % 8 == 0 && cells.z % 8 == 0 && std::max(line, slab) <= floats &&
           std::max(groups.of_lines, groups.of_slab) <= solve_group(device);
}

} // namespace windrow::vulkan
