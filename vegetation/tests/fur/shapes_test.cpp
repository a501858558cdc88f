// Shapes from formulas: counts, closedness, outside outwards; what a host may get wrong is rejected.
#include "tests/figure.h"
#include "vegetation/fur/shapes.h"
#include "vegetation/tests/fur/surface.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace windrow::vegetation::fur {
namespace {

using test::Surface;
using test::surface_of;

constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();

// A vertex' normal lies before all of its triangles.
void expect_round(const Result<Mesh>& mesh, const std::string& name) {
    WINDROW_EXPECT_FIGURE("shells/shapes/" + name + "/inward", surface_of(*mesh).inward, 0.0);
}

void expect_closed(const Result<Mesh>& mesh, const std::string& name) {
    ASSERT_TRUE(mesh) << mesh.error();
    const auto valid = validate(*mesh);
    EXPECT_TRUE(valid) << valid.error();
    const Surface surface = surface_of(*mesh);
    EXPECT_EQ(surface.open, 0u) << name;
    EXPECT_EQ(surface.euler(), 2) << name;
    EXPECT_GT(surface.volume, 0.0) << name;
    EXPECT_EQ(surface.split, 0.0) << name;
}

TEST(ShellShapes, OnePlaneHasFourVerticesAndFacesUp) {
    const auto plane = sheet({});
    ASSERT_TRUE(plane);
    EXPECT_TRUE(validate(*plane));
    EXPECT_EQ(plane->vertices.size(), 4u);
    EXPECT_EQ(plane->triangles(), 2u);
    for (std::size_t i = 0; i < plane->indices.size(); i += 3) {
        const auto at = [&](std::size_t k) { return plane->vertices[plane->indices[i + k]].position; };
        EXPECT_GT(glm::cross(at(1) - at(0), at(2) - at(0)).y, 0.0f);
    }
    EXPECT_EQ(sheet({.columns = 7, .rows = 3})->vertices.size(), 32u);
}

// The normals of a cloth are those of its formula: second order in the cell's size against its triangles'.
TEST(ShellShapes, AClothsNormalsAreThoseOfItsTriangles) {
    double errors[3];
    for (int level = 0; level < 3; ++level) {
        const auto cloth = sheet({.columns = 24 << level, .rows = 24 << level, .wave = 0.05f});
        ASSERT_TRUE(cloth);
        Mesh made = *cloth;
        for (MeshVertex& vertex : made.vertices)
            vertex.normal = glm::vec3(0.0f);
        smooth_normals(made);
        errors[level] = 0.0;
        for (std::size_t i = 0; i < made.vertices.size(); ++i) {
            const glm::vec2 uv = made.vertices[i].uv;
            if (uv.x > 0.01f && uv.x < 0.99f && uv.y > 0.01f && uv.y < 0.99f) // at the rim triangles lie on one side only
                errors[level] = std::max(errors[level],
                                         static_cast<double>(glm::length(made.vertices[i].normal - cloth->vertices[i].normal)));
        }
    }
    const double order = std::log2(errors[1] / errors[2]);
    WINDROW_EXPECT_FIGURE("shells/shapes/cloth_normals/1.9_less_order", 1.9 - order, 0.0);
}

TEST(ShellShapes, SpheresAreClosed) {
    const auto globe = globe_sphere({});
    expect_closed(globe, "globe");
    expect_round(globe, "globe");
    EXPECT_EQ(globe->vertices.size(), 515u);
    EXPECT_EQ(globe->triangles(), 988u);
    expect_closed(globe_sphere({.sectors = 3, .stacks = 2}), "min_globe");
    const auto cube = cube_sphere({});
    expect_closed(cube, "cube_sphere");
    expect_round(cube, "cube_sphere");
    EXPECT_EQ(surface_of(*cube).points, 386u);
    EXPECT_EQ(cube->triangles(), 768u);
    expect_closed(cube_sphere({.cells = 1}), "min_cube_sphere");
    expect_closed(cube_sphere({.cells = 37}), "odd_cube_sphere");
}

TEST(ShellShapes, SpheresHaveTheirVolume) {
    double errors[3];
    for (int level = 0; level < 3; ++level) {
        const double exact = 4.0 / 3.0 * std::numbers::pi * 0.125;
        errors[level] = 1.0 - surface_of(*cube_sphere({.cells = 8 << level})).volume / exact;
    }
    WINDROW_EXPECT_FIGURE("shells/shapes/cube_sphere_volume/1.95_less_order", 1.95 - std::log2(errors[1] / errors[2]), 0.0);
}

TEST(ShellShapes, AWingIsClosedAndThin) {
    const auto bird = wing({});
    expect_closed(bird, "wing");
    expect_closed(wing({.feathers = 0, .columns = 4, .rows = 2}), "min_wing");
    expect_closed(wing({.left = true}), "left_wing");
    // At a sharp corner of a sheet one normal stands for faces of opposite sides, and cannot lie before all.
    WINDROW_EXPECT_FIGURE("shells/shapes/wing/behind", surface_of(*bird).behind, 1e-3);
    const double area = 1.0 * 0.35; // of the box around it, which it does not fill
    WINDROW_EXPECT_FIGURE("shells/shapes/wing_mean_thickness_m", surface_of(*bird).volume / area, 0.035);
}

TEST(ShellShapes, WhatIsWrongIsRejected) {
    const auto rejected = [](const Result<Mesh>& mesh, const char* field) {
        ASSERT_FALSE(mesh) << field;
        EXPECT_NE(mesh.error().find(field), std::string::npos) << mesh.error();
        EXPECT_NE(mesh.error().find(": give "), std::string::npos) << mesh.error();
    };
    rejected(sheet({.size = {k_nan, 1.0f}}), "sheet.size is (nan, 1) m");
    rejected(sheet({.columns = 0}), "sheet.columns");
    rejected(sheet({.rows = 100'000}), "sheet.rows");
    rejected(sheet({.wave = 0.2f}), "sheet.wave");
    rejected(globe_sphere({.radius = -1.0f}), "sphere.radius");
    rejected(globe_sphere({.sectors = 2}), "sphere.sectors");
    rejected(globe_sphere({.stacks = 5000}), "sphere.stacks");
    rejected(cube_sphere({.cells = 0}), "sphere.cells");
    rejected(wing({.chord = 2.0f}), "wing.chord");
    rejected(wing({.thickness = 0.0f}), "wing.thickness");
    rejected(wing({.feathers = -1}), "wing.feathers");
}

} // namespace
} // namespace windrow::vegetation::fur
