// A window of 32 x 16 x 32 that follows, inside a large fixed box: what the rim has not reached is the same air. With the
// pressure, which reaches everywhere, the error is stated against the distance from the rim.

#include "tests/winds.h"

namespace {

using namespace windrow;
using namespace windrow::test;

constexpr glm::ivec3 k_window(32, 16, 32), k_large(128, 16, 128);

glm::ivec3 lattice_origin(const Wind& wind) {
    return glm::ivec3(glm::round(wind.origin()));
}

double largest_component(std::span<const glm::vec4> field) {
    float largest = 0.0f;
    for (const glm::vec4& u : field)
        largest = std::max({largest, std::abs(u.x), std::abs(u.y), std::abs(u.z)});
    return double(largest);
}

void stir(Wind& wind) {
    EXPECT_TRUE(wind.motors().add(DirectionalMotor{.position = {-2.0, 1.0, 3.0},
                                                   .direction = {1.0f, 0.3f, 0.0f},
                                                   .region = Sphere{3.0f},
                                                   .law = Force{6.0f},
                                                   .turbulence = k_steady}));
    EXPECT_TRUE(wind.motors().add(DirectionalMotor{.position = {5.0, -2.0, -4.0},
                                                   .direction = {0.0f, 0.0f, 1.0f},
                                                   .region = Capsule{},
                                                   .law = Drive{.speed = 3.0f},
                                                   .turbulence = k_steady}));
}

/// Compares the window's cells with the large box's cells at the same place.
template <class Body>
void for_each_shared_cell(const Wind& window, const Wind& large, const Body& body) {
    const glm::ivec3 offset = lattice_origin(window) - lattice_origin(large);
    for_each_cell(k_window, [&](int i, int j, int k) {
        body(glm::ivec3(i, j, k), glm::dvec3(window.field()[window.box().index(i, j, k)]),
             glm::dvec3(large.field()[large.box().index(i + offset.x, j + offset.y, k + offset.z)]));
    });
}

// The blend zone reaches ceil(CFL) + 2 cells further into the window in each step, counted from the position of the box then.
void compare_beyond_reach(const std::string& name, double dt, glm::dvec3 walk, int steps) {
    const glm::vec3 ambient(1.5f, 0.0f, -0.5f);
    const Config base{.cells = k_large,
                      .ambient = ambient,
                      .viscosity = 0.0f,
                      .relaxation_time = 0.0f,
                      .max_cfl = 1e6f,
                      .stages = {.relaxation = false, .diffusion = false, .projection = false}};
    Wind large = made(base);
    Config small = base;
    small.cells = k_window;
    Wind window = made(small);
    Field start = smooth_noise(k_large, 1.0f, 61);
    for (glm::vec4& u : start)
        u += glm::vec4(ambient, 0.0f);
    ASSERT_TRUE(large.set_velocity(start));
    window.set_velocity([&](glm::dvec3 centre) {
        return glm::vec3(start[large.box().index(int(std::floor(centre.x)) + 64, int(std::floor(centre.y)) + 8,
                                                 int(std::floor(centre.z)) + 64)]);
    });
    stir(large);
    stir(window);

    glm::ivec3 low = lattice_origin(window), high = low + k_window;
    double worst = 0.0, squares = 0.0, all = 0.0, near_rim = 0.0;
    double largest_cfl = 0.0;
    int compared = 0;
    for (int n = 1; n <= steps; ++n) {
        ASSERT_TRUE(window.follow(walk * double(n)));
        low = glm::max(low, lattice_origin(window));
        high = glm::min(high, lattice_origin(window) + k_window);
        const double before = largest_component(large.field()), after = double(large.step(dt).max_speed);
        ASSERT_EQ(window.step(dt).substeps, 1);
        const double cfl = std::max(before, after) * dt; // cells of 1 m
        const int reach = int(std::ceil(cfl)) + 2;
        largest_cfl = std::max(largest_cfl, cfl);
        low += glm::ivec3(reach, 0, reach); // y has the same sides in both
        high -= glm::ivec3(reach, 0, reach);
    }
    const glm::ivec3 origin = lattice_origin(window);
    for_each_shared_cell(window, large, [&](glm::ivec3 cell, glm::dvec3 a, glm::dvec3 b) {
        const glm::ivec3 place = cell + origin;
        const double error = glm::length(a - b);
        near_rim = std::max(near_rim, error);
        if (place.x < low.x || place.x >= high.x || place.z < low.z || place.z >= high.z)
            return;
        worst = std::max(worst, error);
        squares += error * error;
        all += glm::dot(b - glm::dvec3(ambient), b - glm::dvec3(ambient));
        ++compared;
    });
    figure(name + "_largest_cfl", largest_cfl);
    EXPECT_GT(compared, 300) << "cells beyond the reach of the blend zone";
    EXPECT_GT(near_rim, 0.01) << "the rim differs, or this test shows nothing";
    WINDROW_EXPECT_FIGURE(name + "_largest", worst / largest_speed(large.field()), 1e-6);
    WINDROW_EXPECT_FIGURE(name + "_relative_l2", std::sqrt(squares / all), 1e-5);
}

TEST(WindowLarge, BeyondTheReachOfTheRimTheAirIsTheSame) {
    compare_beyond_reach("large_grid_standing", 0.2, {0.0, 0.0, 0.0}, 4);
    compare_beyond_reach("large_grid_walking", 0.2, {1.0, 0.0, -0.5}, 4);
    compare_beyond_reach("large_grid_running", 0.2, {-3.0, 0.0, 2.0}, 4);
    compare_beyond_reach("large_grid_long_steps", 0.5, {1.0, 0.0, 0.0}, 2);
}

// The pressure reaches everywhere. A breeze with a fan in it, a player who walks: the inner half must be good.
TEST(WindowLarge, WithPressureTheErrorFallsAwayFromTheRim) {
    const Config base{.cells = k_large, .ambient = {2.0f, 0.0f, 0.0f}, .viscosity = 0.0f, .relaxation_time = 0.0f};
    Wind large = made(base);
    Config small = base;
    small.cells = k_window;
    Wind window = made(small);
    stir(large);
    stir(window);
    std::vector<double> errors(16, 0.0), counts(16, 0.0);
    double inner = 0.0, inner_all = 0.0;
    for (int n = 1; n <= 120; ++n) {
        ASSERT_TRUE(window.follow(glm::dvec3(1.4, 0.0, 0.4) * (n / 30.0)));
        large.step(1.0 / 30.0);
        window.step(1.0 / 30.0);
        if (n < 60)
            continue;
        for_each_shared_cell(window, large, [&](glm::ivec3 cell, glm::dvec3 a, glm::dvec3 b) {
            const int distance = std::min({cell.x, cell.z, k_window.x - 1 - cell.x, k_window.z - 1 - cell.z});
            const glm::dvec3 own = b - glm::dvec3(base.ambient);
            errors[distance] += glm::dot(a - b, a - b);
            counts[distance] += 1.0;
            if (distance >= 8) {
                inner += glm::dot(a - b, a - b);
                inner_all += glm::dot(own, own);
            }
        });
    }
    for (const int distance : {0, 1, 2, 4, 8, 12, 15})
        figure("large_grid_pressure_rms_error_mps_at_" + std::to_string(distance),
               std::sqrt(errors[distance] / counts[distance]));
    WINDROW_EXPECT_FIGURE("large_grid_pressure_inner_half", std::sqrt(inner / inner_all), 0.005);
    EXPECT_LT(errors[15] / counts[15], errors[0] / counts[0]);
}

} // namespace
