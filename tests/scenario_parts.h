// What the rows of the scenario table (scenarios.h) are made of.
#pragma once

#include "fluid/wind.h"
#include "tests/shapes.h"

#include <functional>
#include <glm/gtc/quaternion.hpp>
#include <ostream>
#include <random>
#include <string>
#include <vector>

namespace windrow::test {

/// What a feature adds to a row.
struct Scenario {
    std::string name;
    std::function<void(Config&)> config{};
    /// Before the first step. Motors and obstacles are added in an order, and named by `Handles`.
    std::function<void(WindControl&)> begin{};
    /// Before step n, from 0.
    std::function<void(WindControl&, int)> step{};
    int steps = 100;
    bool late = false; ///< what it is for comes after more than 24 steps
    /// Two winds that start one rounding apart part by more than 1e-6 in 12 steps.
    bool chaotic = false;
};

inline void PrintTo(const Scenario& row, std::ostream* to) {
    *to << row.name;
}

/// A 16 x 10 x 14 box of the default config in a wind of 6 m/s, which the features change.
inline Config scenario_config() {
    return {.cells = {16, 10, 14}, .ambient = {6.0f, 0.0f, 1.0f}};
}
inline constexpr double k_scenario_step = 1.0 / 30.0; // [s]

/// The only motor or obstacle of a row, or its n-th: handles of winds that are loaded are the same.
inline MotorId motor_id(std::uint32_t slot = 0) {
    return {.slot = slot, .generation = 1};
}
inline ObstacleId obstacle_id(std::uint32_t slot = 0) {
    return {.slot = slot, .generation = 1};
}

enum class Way { rests, moves, turns };

namespace scenario_parts {

struct NamedShape {
    const char* name;
    Shape shape;
};

inline std::vector<NamedShape> scenario_shapes() {
    std::vector<std::uint8_t> corner(27, 1);
    corner[0] = corner[2] = corner[26] = 0;
    return {{"sphere", Sphere{2.3f}},
            {"capsule", Capsule{.half_axis = {1.0f, 2.0f, 0.3f}, .radius = 1.2f}},
            {"block", Block{{2.0f, 2.5f, 1.7f}}},
            {"thin_wall", Block{{0.2f, 3.0f, 4.0f}}},
            {"cylinder", Cylinder{.radius = 1.8f, .half_length = 2.4f}},
            {"plate", Plate{{2.6f, 3.0f}}},
            {"mesh", MeshShape{mesh_of(ball_mesh(2.2f, 2))}},
            {"voxels", VoxelShape{grid_of({.cells = {3, 3, 3}, .closed = corner}), 1.3f}}};
}

inline void must(const auto& result) {
    EXPECT_TRUE(result) << (result ? "" : result.error());
}

/// `at`: where it is at the start [m]; `slot` of its handle.
inline Scenario obstacle_scenario(const NamedShape& kind, Way way, glm::dvec3 at, std::uint32_t slot = 0) {
    const char* const ways[] = {"rests", "moves", "turns"};
    Scenario row{.name = std::string(kind.name) + "_" + ways[static_cast<int>(way)]};
    const glm::quat turned = glm::angleAxis(0.3f, glm::vec3(0.0f, 1.0f, 0.0f));
    row.begin = [=, shape = kind.shape](WindControl& wind) {
        must(wind.obstacles().add({.position = at, .orientation = turned, .shape = shape}));
    };
    if (way == Way::moves)
        row.step = [=](WindControl& wind, int n) {
            must(wind.obstacles().move(obstacle_id(slot), at + glm::dvec3(0.06, 0.0, -0.03) * (n + 1.0)));
        };
    if (way == Way::turns)
        row.step = [=](WindControl& wind, int n) {
            const float angle = 0.3f + 0.04f * static_cast<float>(n + 1);
            must(wind.obstacles().move(obstacle_id(slot), at, glm::angleAxis(angle, glm::vec3(0.0f, 1.0f, 0.0f))));
        };
    return row;
}

/// A tile of the same kind of hills, from a place along x and z to another; all tiles are of one surface.
inline Obstacle tile_of_hills(glm::ivec2 low, glm::ivec2 high, double raised = 0.0) {
    const auto heights = heights_of(high - low + 1, 1.0f, [=](double x, double z) {
        return 1.5 + raised + 1.5 * std::sin(0.3 * (x + low.x)) * std::cos(0.4 * (z + low.y));
    });
    return {.position = {low.x, -4.0, low.y}, .shape = Ground{.heights = heights, .beyond = Beyond::nothing}};
}

inline Obstacle hills(glm::dvec3 corner = {-40.0, -4.0, -40.0}) {
    return {.position = corner, .shape = Ground{heights_of({81, 81}, 1.0f, [](double x, double z) {
                                    return 1.5 + 1.5 * std::sin(0.3 * x) * std::cos(0.4 * z);
                                })}};
}

/// Plants and a hedge: at all defaults, in gusts, in rows of unequal thickness, with the classic split, over rough ground, and in a box
/// that walks past them while one comes, changes and goes.
inline Scenario drag_scenario(const std::string& name) {
    Scenario row{.name = name};
    row.config = [=](Config& c) {
        if (name == "drag_in_gusts")
            c.gusts.intensity = 0.2f;
        if (name == "drag_in_rows") {
            c.boundaries = Boundaries::open_over_floor();
            c.rows = Rows{};
        }
        if (name == "drag_over_rough_ground") {
            c.boundaries = Boundaries::open_over_floor();
            c.profile = LogProfile{};
            c.roughness = Roughness{};
        }
        if (name == "drag_of_stable_fluids")
            c.scheme = Scheme::stable_fluids;
    };
    row.begin = [](WindControl& wind) {
        for (int n = 0; n < 24; ++n)
            must(wind.drag().add(PlantDrag{.position = {1.7 * n - 14.0, 0.6 - 0.1 * n, 0.9 * (n % 7) - 3.0},
                                           .radius = 0.2f + 0.11f * static_cast<float>(n % 5),
                                           .base = 0.3f,
                                           .height = 2.7f,
                                           .area = 1.5f}));
        must(wind.drag().add(BeltDrag{.start = {-3.0, -1.0, -5.0}, .end = {2.0, 0.5, 6.0}, .width = 0.7f, .height = 3.3f}));
    };
    if (name == "drag_walk")
        row.step = [](WindControl& wind, int n) {
            must(wind.follow({0.31 * n, 0.13 * n, -0.27 * n}));
            if (n % 6 == 2)
                must(wind.drag().add(PlantDrag{.position = {0.31 * n + 3.0, 0.0, 1.0}, .radius = 1.4f, .area = 4.0f}));
            if (n % 5 == 3)
                must(wind.drag().set({.slot = 12, .generation = 1}, PlantDrag{.position = {0.2 * n, 0.0, 0.0}, .radius = 2.0f}));
            if (n == 9)
                must(wind.drag().remove({.slot = 11, .generation = 1}));
        };
    if (name == "drag_walk_in_calm_air") // which is filled in the new box, and not moved
        row.step = [](WindControl& wind, int n) {
            if (n % 12 == 2)
                wind.reset();
            must(wind.follow(glm::dvec3(3.0, 0.0, -2.0) * static_cast<double>((n + 10) / 12)));
        };
    return row;
}

} // namespace scenario_parts

} // namespace windrow::test
