// The scenes that fur_bench.cpp measures.
#pragma once

#include "vegetation/bench/fur_stage.h"

namespace windrow::vegetation::bench {

/// How the coats of the thesis' first generation are set (Styles 2024, 3D fur generation with shell texturing, the measured
/// scene): length 0.319 on a sphere of radius 0.5, attenuation 0.805, density 145 a unit of uv on a grid, lengths 0 to 0.811,
/// thickness 1.01, occlusion 0.27; layers from the innermost outward, no shadow, nothing left out.
[[nodiscard]] fur::CoatSettings thesis_coat(int layers);
/// A brown fur of 6 cm as a user would set it: strands by the surface, combed, march 4, outer layers first. 40 strands a metre: a
/// sphere 100 pixels wide shows them still, where finer ones would be drawn as their mean and not be searched for.
[[nodiscard]] fur::CoatSettings fur(int layers);
/// A heap of clouds on 200 m x 200 m.
[[nodiscard]] fur::CoatSettings cloud(int layers);
/// The skin alone: what receives shadows.
[[nodiscard]] fur::CoatSettings bare_skin();

/// A sphere of radius 0.5 m and 515 vertices, 988 triangles.
[[nodiscard]] fur::Mesh thesis_sphere();
/// A level sheet on y = `y` [m].
[[nodiscard]] Worn floor(float metres, double y);
[[nodiscard]] fur::Mesh sheet_of(float metres, int cells);

/// One sphere in the thesis' coat.
[[nodiscard]] FurCase thesis_scene(std::string name, int layers);
/// The same with a lamp, a plane of 121 vertices and shadows of as many layers.
[[nodiscard]] FurCase thesis_light_scene(std::string name, int layers);
/// 18 spheres over that plane: 9391 vertices.
[[nodiscard]] FurCase thesis_many_scene(std::string name, int layers);
/// A beast of about 3,300 vertices that walks in bones.
[[nodiscard]] FurCase beast_scene(std::string name, int layers);
/// The sphere in `fur`.
[[nodiscard]] FurCase fur_scene(std::string name, int layers);

} // namespace windrow::vegetation::bench
