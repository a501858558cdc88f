// Meshes from formulas: sheets, spheres, a wing. Closed ones turn their outside outwards; all stand ready to wear shells.
#pragma once

#include "../../coupling/drag.h"
#include "mesh.h"

namespace windrow::vegetation::fur {

/// A sheet in x and z at y = 0, facing up, its uv from (0, 0) at the least x and z to (1, 1).
struct Sheet {
    static constexpr const char* k_name = "sheet";
    static constexpr const char* k_meaning = "A sheet facing up.";
    glm::vec2 size{1.0f};
    int columns = 1;
    int rows = 1;
    float wave = 0.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("size", &Sheet::size, {1e-3, 1e4, "m"}, "Along x and z."),
            Setting("columns", &Sheet::columns, {1.0, 1024.0},
                    "Cells along x; 1 x 1 has four vertices, whose shells lean as one."),
            Setting("rows", &Sheet::rows, {1.0, 1024.0}, "Cells along z."),
            Setting("wave", &Sheet::wave, {0.0, 1e3, "m"},
                    "Amplitude of a gently hanging cloth, at most a tenth of the shorter side."),
        };
    }
};
[[nodiscard]] Result<Mesh> sheet(const Sheet& settings);

/// A sphere by longitude and latitude, on the origin, poles up and down. (sectors + 1) (stacks - 1) + 2 vertices: the seam of the
/// map is doubled, a pole is one vertex, with u = 1/2.
struct GlobeSphere {
    static constexpr const char* k_name = "globe_sphere";
    static constexpr const char* k_meaning = "A sphere by longitude and latitude.";
    float radius = 0.5f;
    int sectors = 26;
    int stacks = 20;

    static constexpr auto settings() {
        return std::tuple{
            Setting("radius", &GlobeSphere::radius, {1e-3, 1e3, "m"}, "Of the sphere."),
            Setting("sectors", &GlobeSphere::sectors, {3.0, 1024.0},
                    "Around; 26 with 20 stacks has 515 vertices, as many as Unity's sphere."),
            Setting("stacks", &GlobeSphere::stacks, {2.0, 1024.0}, "From pole to pole."),
        };
    }
};
[[nodiscard]] Result<Mesh> globe_sphere(const GlobeSphere& settings);

/// A sphere of even cells: a cube's faces, cut by equal angles and blown up. 6 cells^2 + 2 positions and 12 cells^2 triangles;
/// vertices on the cube's edges are doubled, since each face has its own map from (0, 0) to (1, 1).
struct CubeSphere {
    static constexpr const char* k_name = "cube_sphere";
    static constexpr const char* k_meaning = "A sphere of even cells.";
    float radius = 0.5f;
    int cells = 8;

    static constexpr auto settings() {
        return std::tuple{
            Setting("radius", &CubeSphere::radius, {1e-3, 1e3, "m"}, "Of the sphere."),
            Setting("cells", &CubeSphere::cells, {1.0, 512.0}, "Along an edge of the cube that it is blown up from."),
        };
    }
};
[[nodiscard]] Result<Mesh> cube_sphere(const CubeSphere& settings);

/// A bird's wing, spread: root at x = 0, tip at x = span, leading edge towards +z, top up. A closed sheet, thickest at the
/// leading edge, cambered, bent down towards the tip, swept back, its trailing edge cut into feathers. u runs from root to tip
/// and v from the leading to the trailing edge, so that feathers lie along v on the arm and along u at the tip.
struct Wing {
    static constexpr const char* k_name = "wing";
    static constexpr const char* k_meaning = "A bird's wing, spread along x from its root at 0, its leading edge towards +z.";
    float span = 1.0f;
    float chord = 0.35f;
    float thickness = 0.1f;
    float sweep = 0.25f;
    float droop = 0.12f;
    int feathers = 9;
    int columns = 54;
    int rows = 12;
    bool left = false;

    static constexpr auto settings() {
        return std::tuple{
            Setting("span", &Wing::span, {1e-2, 100.0, "m"}, "From root to tip."),
            Setting("chord", &Wing::chord, {1e-3, 100.0, "m"}, "At the root, at most the span."),
            Setting("thickness", &Wing::thickness, {0.005, 0.3}, "Fraction of the chord, at a fifth of it."),
            Setting("sweep", &Wing::sweep, k_fraction_range, "Fraction of the span by which the tip is behind the root."),
            Setting("droop", &Wing::droop, {0.0, 0.5}, "Fraction of the span by which the tip hangs down."),
            Setting("feathers", &Wing::feathers, {0.0, 40.0}, "Notches of the trailing edge."),
            Setting("columns", &Wing::columns, {4.0, 512.0}, "Cells along the span; 6 a feather make all notches alike."),
            Setting("rows", &Wing::rows, {2.0, 256.0}, "Cells along the chord."),
            Setting("left", &Wing::left, "Spread along -x instead, as in a mirror."),
        };
    }
};
[[nodiscard]] Result<Mesh> wing(const Wing& settings);

void check_rules(windrow::detail::Reasons& reasons, const windrow::detail::FieldPath& path, const Sheet& sheet);
void check_rules(windrow::detail::Reasons& reasons, const windrow::detail::FieldPath& path, const Wing& wing);

} // namespace windrow::vegetation::fur
