// Meshes from formulas: sheets, spheres, a wing. Closed ones turn their outside outwards; all stand ready to wear shells.
#pragma once

#include "vegetation/fur/mesh.h"

namespace windrow::vegetation::fur {

/// A sheet in x and z at y = 0, facing up, its uv from (0, 0) at the least x and z to (1, 1).
struct Sheet {
    glm::vec2 size{1.0f}; ///< [m] along x and z, 1e-3 to 1e4
    int columns = 1;      ///< cells along x, 1 to 1024: 1 x 1 has the 4 vertices whose shells lean as one
    int rows = 1;         ///< along z, 1 to 1024
    float wave = 0.0f;    ///< [m] amplitude of a gently hanging cloth, 0 to a tenth of the shorter side. Default flat
};
[[nodiscard]] Result<Mesh> sheet(const Sheet& settings);

/// A sphere by longitude and latitude, on the origin, poles up and down. (sectors + 1) (stacks - 1) + 2 vertices: the seam of the
/// map is doubled, a pole is one vertex, with u = 1/2.
struct GlobeSphere {
    float radius = 0.5f; ///< [m] 1e-3 to 1e3
    int sectors = 26;    ///< around, 3 to 1024. Default: with 20 stacks 515 vertices, as many as Unity's sphere, on 988 triangles
    int stacks = 20;     ///< from pole to pole, 2 to 1024
};
[[nodiscard]] Result<Mesh> globe_sphere(const GlobeSphere& settings);

/// A sphere of even cells: a cube's faces, cut by equal angles and blown up. 6 cells^2 + 2 positions and 12 cells^2 triangles;
/// vertices on the cube's edges are doubled, since each face has its own map from (0, 0) to (1, 1).
struct CubeSphere {
    float radius = 0.5f; ///< [m] 1e-3 to 1e3
    int cells = 8;       ///< along an edge of the cube, 1 to 512
};
[[nodiscard]] Result<Mesh> cube_sphere(const CubeSphere& settings);

/// A bird's wing, spread: root at x = 0, tip at x = span, leading edge towards +z, top up. A closed sheet, thickest at the
/// leading edge, cambered, bent down towards the tip, swept back, its trailing edge cut into feathers. u runs from root to tip
/// and v from the leading to the trailing edge, so that feathers lie along v on the arm and along u at the tip.
struct Wing {
    float span = 1.0f;      ///< [m] 1e-2 to 100
    float chord = 0.35f;    ///< [m] at the root, 1e-3 to the span
    float thickness = 0.1f; ///< of the chord, 0.005 to 0.3, at a fifth of it
    float sweep = 0.25f;    ///< of the span: how far the tip lies behind the root, 0 to 1
    float droop = 0.12f;    ///< of the span: how far the tip hangs below the arm's height, 0 to 0.5
    int feathers = 9;       ///< notches of the trailing edge, 0 to 40
    int columns = 54;       ///< cells along the span, 4 to 512. Default: 6 a feather, so that all notches are alike
    int rows = 12;          ///< along the chord, 2 to 256
    bool left = false;      ///< spread along -x instead, as in a mirror
};
[[nodiscard]] Result<Mesh> wing(const Wing& settings);

} // namespace windrow::vegetation::fur
