// Bones for the horse of Debian's glmark2-data, which stands reared on its hind legs: it paws the air, tosses its head, swings
// its tail. It cannot walk without its forelegs on the ground.
//
//     auto horse = fur::read_mesh("examples/scenes/fur/horse.obj", {.size = 2.4f}); // tools/make_meshes.py makes it
//     auto bones = fur::horse_skeleton(2.4f);
#pragma once

#include "vegetation/fur/skeleton.h"

namespace windrow::vegetation::fur {

/// Fits read_mesh of that file with this `size` [m], 1e-3 to 1e3, by the longest edge, which is its height, and no yaw. `hz`: how
/// often it paws, 0 to 5.
[[nodiscard]] Result<Skeleton> horse_skeleton(float size = 1.0f, float hz = 0.7f);

} // namespace windrow::vegetation::fur
