// What tests of a wind begin with: winds and motors that are known to be legal, a wind's cells, and how far they are off.
#pragma once

#include "fluid/wind.h"
#include "tests/fields.h"
#include "tests/figure.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <ostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace windrow::test {

using std::numbers::pi;

inline constexpr float k_nan = std::numeric_limits<float>::quiet_NaN(), k_infinity = std::numeric_limits<float>::infinity();
inline constexpr Stages k_no_stages{
    .sources = false, .relaxation = false, .diffusion = false, .advection = false, .projection = false};
inline constexpr Stages k_sources_only{
    .sources = true, .relaxation = false, .diffusion = false, .advection = false, .projection = false};

struct NamedConfig {
    std::string name;
    Config config{};
};
inline void PrintTo(const NamedConfig& one, std::ostream* stream) {
    *stream << one.name;
}

inline Config with(Config config, const std::function<void(Config&)>& change) {
    change(config);
    return config;
}

inline Wind made(const Config& config) {
    auto wind = Wind::create(config);
    EXPECT_TRUE(wind) << wind.error();
    return *std::move(wind);
}

/// Of all stages, the sources alone.
inline Wind sources_only(glm::ivec3 cells, float cell_size = 1.0f, glm::vec3 ambient = glm::vec3(0.0f),
                         glm::dvec3 centre = glm::dvec3(0.0)) {
    return made({.cells = cells, .cell_size = cell_size, .centre = centre, .ambient = ambient, .stages = k_sources_only});
}

inline MotorId added(Motors& motors, const Motor& motor) {
    const auto id = motors.add(motor);
    EXPECT_TRUE(id) << id.error();
    return id ? *id : MotorId{};
}
inline MotorId added(Wind& wind, const Motor& motor) {
    return added(wind.motors(), motor);
}

inline Diagnostics take_steps(Wind& wind, int count, double dt) {
    Diagnostics last;
    for (int n = 0; n < count; ++n)
        last = wind.step(dt);
    return last;
}

/// [ms] Of all stages, without the whole.
inline double sum_of_stages(const StageTimes& times) {
    double sum = -times.total; // whose row is the last
    for_each_row(times, [&](const auto&, double stage) { sum += stage; });
    return sum;
}

/// The weight of a region at a distance whose square, over the region's own, is `squared` (motor.h).
inline double biweight(double squared) {
    return squared < 1.0 ? (1.0 - squared) * (1.0 - squared) : 0.0;
}

/// Calls visit(i, j, k) for each cell, in the order of box.h.
template <class Visit>
void for_each_cell(glm::ivec3 cells, const Visit& visit) {
    for (int k = 0; k < cells.z; ++k)
        for (int j = 0; j < cells.y; ++j)
            for (int i = 0; i < cells.x; ++i)
                visit(i, j, k);
}

/// Calls visit(centre [m], place in the layout) for each cell.
template <class Visit>
void for_each_cell(const Wind& wind, const Visit& visit) {
    for_each_cell(wind.box().cells,
                  [&](int i, int j, int k) { visit(wind.view().window().centre(i, j, k), wind.box().index(i, j, k)); });
}

/// Largest |u - from|.
inline double largest_off(std::span<const glm::vec4> field, glm::vec3 from) {
    double largest = 0.0;
    for (const glm::vec4& u : field)
        largest = std::max(largest, double(glm::length(glm::vec3(u) - from)));
    return largest;
}

/// Largest |a - b|.
inline double largest_apart(std::span<const glm::vec4> a, std::span<const glm::vec4> b) {
    double largest = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n)
        largest = std::max(largest, glm::length(glm::dvec3(a[n]) - glm::dvec3(b[n])));
    return largest;
}

/// Largest difference of a cell as it is read from the ambient wind at its centre.
inline double off_ambient(const Wind& wind) {
    const WindView view = wind.view();
    double largest = 0.0;
    for_each_cell(view.box().cells, [&](int i, int j, int k) {
        const glm::vec3 inside(view.field()[view.box().index(i, j, k)]);
        largest = std::max(largest, double(glm::length(inside - view.ambient().velocity(view.window().centre(i, j, k)))));
    });
    return largest;
}

inline glm::dvec3 sum_of(std::span<const glm::vec4> field) {
    glm::dvec3 sum(0.0);
    for (const glm::vec4& u : field)
        sum += glm::dvec3(u);
    return sum;
}

} // namespace windrow::test
