// A wolf-like beast, far larger than a wolf: capsules for its flesh, and bones that walk. It stands on y = 0 and looks along +z.
#pragma once

#include "vegetation/fur/mesh.h"
#include "vegetation/fur/skeleton.h"

namespace windrow::vegetation::fur {

struct Beast {
    /// [m] At the withers, 0.1 to 20. Default 2: a wolf has 0.8.
    float height = 2.0f;
    /// Cells of the skin along that height, 20 to 120; below, the legs fall apart. Default 23: 3,236 vertices on 2,336 places,
    /// about as many as the horse of the shell fur thesis has (3,269). 40 suits a picture from near.
    int detail = 23;
};

/// Closed, normals from the flesh's slope; without a map of its own (has_uv is false, uv is a box projection).
[[nodiscard]] Result<Mesh> beast_mesh(const Beast& beast = {});

/// Bones that fit the mesh, in a walk of `hz` strides a second, 0 to 5: left hind, left fore, right hind, right fore, a quarter
/// of a stride apart, as wolves set their feet. 0 stands still in mid-stride.
[[nodiscard]] Result<Skeleton> beast_skeleton(const Beast& beast = {}, float hz = 0.8f);

} // namespace windrow::vegetation::fur
