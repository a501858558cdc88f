// Voxel grids of obstacles: MagicaVoxel files.
#include "scene/vox_file.h"
#include "tests/fuzz/fuzz_target.h"

#include <cmath>

namespace windrow::fuzz {

ReadOutcome read_input(std::string_view bytes) {
    auto data = scene::read_vox(bytes, "tower.vox");
    if (!data)
        return ReadOutcome::rejected;
    if (data->closed.size() > 65'536) // a grid of them is made in milliseconds, each
        return ReadOutcome::accepted;
    const glm::vec3 size(data->cells);
    const auto grid = VoxelGrid::create(*std::move(data));
    if (!grid)
        return ReadOutcome::rejected;
    require(std::isfinite((*grid)->distance_to(0.5f * size)) && (*grid)->thickness() >= 1,
            "a grid has distances and a thickness");
    (void)(*grid)->crosses(glm::vec3(-1.0f), size);
    return ReadOutcome::accepted;
}

} // namespace windrow::fuzz
