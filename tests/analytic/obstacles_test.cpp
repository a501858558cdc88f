// Obstacles in the operators: the pressure around bodies against potential flow, and transport that stops at them.
#include "flows.h"

#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <numbers>

namespace windrow {
namespace {

using namespace flows;

PlacedObstacle at(glm::vec3 position, const Shape& shape) {
    PlacedObstacle placed;
    placed.shape = shape;
    placed.position = position;
    return placed;
}

Workspace around(const Box& box, std::span<const PlacedObstacle> obstacles) {
    Workspace work = workspace(box);
    const auto set = work.set_obstacles(obstacles);
    EXPECT_TRUE(set) << set.error();
    return work;
}

// A body that starts with a velocity in air at rest, over the mass that it displaces: added mass.
double added_mass(const Shape& shape, const Box& box, double volume, glm::vec3 off_centre) {
    PlacedObstacle body = at(0.5f * glm::vec3(box.cells) * box.cell_size + off_centre, shape);
    body.velocity = {1.0f, 0.0f, 0.0f};
    Workspace work = around(box, std::span(&body, 1));
    Field velocity(box.cell_count());
    project(work, velocity);
    return -static_cast<double>(work.impulse_on(0).x) / volume;
}

// Potential flow (Lamb 1932, Hydrodynamics, art. 92 and 68): half of the displaced mass for a sphere, all of it for a cylinder.
TEST(Obstacles, ASphereHasHalfItsMassAdded) {
    double error_before = 1.0;
    for (const int cells : {8, 16}) { // a diameter
        const Box box{.cells = glm::ivec3(4 * cells), .cell_size = 1.0f / static_cast<float>(cells)};
        for (const glm::vec3 off : {glm::vec3(0.0f), glm::vec3(0.37f, 0.21f, 0.08f) * box.cell_size}) {
            const double mass = added_mass(Sphere{0.5f}, box, std::numbers::pi / 6.0, off);
            EXPECT_NEAR(mass, 0.5, cells == 16 ? 0.04 : 0.05) << cells << " cells a diameter";
            if (off != glm::vec3(0.0f)) {
                EXPECT_LT(std::abs(mass - 0.5), 0.75 * error_before);
                error_before = std::abs(mass - 0.5);
            }
        }
    }
}

// In two dimensions the far field falls as 1/r, so the box's own boundary counts: p = 0 on a circle of radius b around the
// cylinder makes it (b^2 - a^2) / (b^2 + a^2); here b is that of the circle of the box's area.
TEST(Obstacles, ACylinderHasItsMassAdded) {
    for (const int cells : {8, 16}) {
        const float h = 1.0f / static_cast<float>(cells);
        Box box{.cells = {12 * cells, 1, 12 * cells}, .cell_size = h};
        box.boundaries.y_low = box.boundaries.y_high = {BoundaryKind::free_slip};
        const double in_box = (144.0 / std::numbers::pi - 0.25) / (144.0 / std::numbers::pi + 0.25);
        for (const glm::vec3 off : {glm::vec3(0.0f), glm::vec3(0.37f, 0.0f, 0.08f) * h}) {
            const double mass = added_mass(Cylinder{.radius = 0.5f, .half_length = 10.0f}, box,
                                           std::numbers::pi * 0.25 * static_cast<double>(h), off);
            EXPECT_NEAR(mass, in_box, cells == 16 ? 0.08 : 0.12) << cells << " cells a diameter";
        }
    }
}

// Nearer to 1 in a larger box, as the circle of its area predicts.
TEST(Obstacles, ACylinderHasMoreMassAddedInALargerBox) {
    constexpr int k_cells = 16; // a diameter
    constexpr float k_size = 1.0f / k_cells;
    double offset_before = 0.0;
    for (const int diameters : {6, 12, 24}) {
        Box box{.cells = {diameters * k_cells, 1, diameters * k_cells}, .cell_size = k_size};
        box.boundaries.y_low = box.boundaries.y_high = {BoundaryKind::free_slip};
        const double area = static_cast<double>(diameters * diameters) / std::numbers::pi, in_box = (area - 0.25) / (area + 0.25);
        const double mass = added_mass(Cylinder{.radius = 0.5f, .half_length = 10.0f}, box, std::numbers::pi * 0.25 / k_cells,
                                       glm::vec3(0.37f, 0.0f, 0.08f) * k_size);
        EXPECT_NEAR(mass, in_box, 0.05) << diameters << " diameters";
        const double offset = mass - in_box;
        if (diameters > 6) {
            EXPECT_NEAR(offset, offset_before, 5e-3) << diameters << " diameters";
        }
        offset_before = offset;
    }
}

// A trunk that passes its own images through periodic sides closes the same parts of faces as one between walls.
TEST(Obstacles, ImagesThatOverlapCloseAFaceOnce) {
    std::array<double, 2> mass{};
    for (const bool periodic : {false, true}) {
        Box box{.cells = {24, 2, 24}, .cell_size = 0.25f};
        box.boundaries.y_low = box.boundaries.y_high = {periodic ? BoundaryKind::periodic : BoundaryKind::free_slip};
        mass[periodic] = added_mass(Cylinder{.radius = 0.5f, .half_length = 10.0f}, box, 1.0, {0.09f, 0.0f, 0.02f});
    }
    EXPECT_NEAR(mass[1], mass[0], 1e-4 * mass[0]); // with each image's part once more: 1.3 mass[0]
}

// A rigid body's own motion has no divergence, whatever faces it cuts.
TEST(Obstacles, ABodyThatTurnsInItsShapeMovesNoAir) {
    const Box box{.cells = {24, 24, 24}, .cell_size = 0.5f, .boundaries = Boundaries::all(BoundaryKind::free_slip)};
    PlacedObstacle wheel = at({6.0f, 6.1f, 5.9f}, Cylinder{.radius = 3.0f, .half_length = 1.0f});
    wheel.spin = {0.0f, 2.0f, 0.0f};
    Workspace work = around(box, std::span(&wheel, 1));
    Field velocity(box.cell_count());
    project(work, velocity);
    double largest = 0.0;
    for_each_cell(box.cells, [&](int i, int j, int k) {
        const glm::vec3 place = (glm::vec3(i, j, k) + 0.5f) * box.cell_size - wheel.position;
        if (detail::distance_to(wheel.shape, place) > 0.0f)
            largest = std::max(largest, static_cast<double>(glm::length(velocity[box.index(i, j, k)])));
    });
    // The wheel's edge moves at 6 m/s. A cut face's flux is off by the chord between its corners.
    EXPECT_LT(largest, 0.2);
}

struct Duct {
    Box box;
    PlacedObstacle plate;
    [[nodiscard]] bool first_side(std::size_t n) const {
        const auto x = static_cast<std::size_t>(box.cells.x), y = static_cast<std::size_t>(box.cells.y);
        const glm::vec3 centre = glm::vec3(n % x, n / x % y, n / x / y) + 0.5f;
        return glm::dot(centre * box.cell_size - plate.position, plate.axes[2]) < 0.0f;
    }
};

// A plate of zero thickness across a duct, turned about the vertical.
Duct duct(float degrees) {
    Duct made{.box = {.cells = {48, 6, 24}, .cell_size = 1.0f, .boundaries = Boundaries::all(BoundaryKind::free_slip)},
              .plate = at({24.0f, 3.0f, 12.0f}, Plate{.half_size = {100.0f, 100.0f}})};
    made.plate.axes = glm::mat3(glm::rotate(glm::mat4(1.0f), glm::radians(90.0f + degrees), glm::vec3(0.0f, 1.0f, 0.0f)));
    return made;
}

class PlateAcrossADuct : public ::testing::TestWithParam<std::tuple<float, float>> {};

// The wind blows straight through the plate, so that transport alone is asked. None of the smoke may pass, and none of a
// velocity that is not a wall's.
TEST_P(PlateAcrossADuct, LetsNothingPass) {
    const auto [degrees, cfl] = GetParam();
    const Duct scene = duct(degrees);
    Workspace work = around(scene.box, std::span(&scene.plate, 1));
    Field wind(scene.box.cell_count()), carried = wind, moved = wind;
    std::vector<float> smoke(wind.size()), next(wind.size());
    for (std::size_t n = 0; n < wind.size(); ++n) {
        wind[n] = {1.0f, 0.2f, 0.3f, 0.0f};
        smoke[n] = scene.first_side(n) ? 1.0f : 0.0f;
        carried[n] = {0.0f, smoke[n], 0.0f, 0.0f};
    }
    for (int step = 0; step < 10; ++step) {
        ASSERT_TRUE(advect(work, {.carried = smoke, .velocity = wind, .dt = cfl}, next));
        smoke.swap(next);
        advect(work, {.carried = carried, .velocity = wind, .dt = cfl}, moved);
        carried.swap(moved);
    }
    double passed = 0.0, velocity_passed = 0.0, kept = 0.0;
    for (std::size_t n = 0; n < wind.size(); ++n) {
        (scene.first_side(n) ? kept : passed) += static_cast<double>(smoke[n]);
        if (!scene.first_side(n))
            velocity_passed = std::max(velocity_passed, static_cast<double>(std::abs(carried[n].y)));
    }
    EXPECT_EQ(passed, 0.0);
    EXPECT_EQ(velocity_passed, 0.0);
    EXPECT_GT(kept, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Angles, PlateAcrossADuct,
                         ::testing::Combine(::testing::Values(0.0f, 27.0f, 45.0f, 80.0f),
                                            ::testing::Values(0.1f, 1.0f, 2.0f, 10.0f)));

// With the wind against it, air on both sides stays divergence-free and the plate's faces let no flux pass.
TEST(Obstacles, APlateStopsTheWindThroughADuct) {
    for (const float degrees : {0.0f, 27.0f, 45.0f}) {
        const Duct scene = duct(degrees);
        Workspace work = around(scene.box, std::span(&scene.plate, 1));
        Field velocity(scene.box.cell_count(), glm::vec4(1.0f, 0.0f, 0.0f, 0.0f));
        project(work, velocity);
        // A uniform wind in a closed half is a gradient. A collocated gradient misses it in the cells beside walls, by half.
        for (std::size_t n = 0; n < velocity.size(); ++n)
            if (velocity[n].x > 0.51f || velocity[n].x < -0.51f)
                ADD_FAILURE() << "a cell keeps " << velocity[n].x << " m/s at " << degrees << " degrees";
        EXPECT_LT(rms(velocity), 0.25) << degrees << " degrees";
    }
}

TEST(Obstacles, TheWallsOfARoomWithoutThicknessCloseIt) {
    const Box box{.cells = {20, 20, 20}, .cell_size = 1.0f};
    std::vector<PlacedObstacle> walls;
    const glm::vec3 low(5.3f), high(14.6f), middle = 0.5f * (low + high), half = 0.5f * (high - low);
    for (int axis = 0; axis < 3; ++axis)
        for (const glm::vec3 corner : {low, high}) {
            glm::vec3 place = middle;
            place[axis] = corner[axis];
            PlacedObstacle wall = at(place, Plate{.half_size = {half[(axis + 1) % 3], half[(axis + 2) % 3]}});
            wall.axes = glm::mat3(0.0f);
            wall.axes[0][(axis + 1) % 3] = wall.axes[1][(axis + 2) % 3] = wall.axes[2][axis] = 1.0f;
            walls.push_back(wall);
        }
    Workspace work = around(box, walls);
    Field velocity(box.cell_count(), glm::vec4(3.0f, -1.0f, 2.0f, 0.0f));
    project(work, velocity);
    double inside = 0.0;
    for (int k = 6; k < 14; ++k)
        for (int j = 6; j < 14; ++j)
            for (int i = 6; i < 14; ++i)
                inside = std::max(inside, static_cast<double>(glm::length(velocity[box.index(i, j, k)])));
    EXPECT_LT(inside, 2e-3);
    EXPECT_GT(rms(velocity), 3.0); // the wind goes around
}

} // namespace
} // namespace windrow
