// Winds to start a test from, random numbers that every standard library gives alike, and what tests ask of a field.
#pragma once

#include "fluid/box.h"
#include "fluid/pieces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <numbers>
#include <random>
#include <span>
#include <vector>

namespace windrow::test {

using Field = std::vector<glm::vec4>;

/// The generator is fixed by the standard, its distributions are not: so they are made here.
class Random {
  public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}

    std::uint32_t bits() { return static_cast<std::uint32_t>(engine_()); }
    /// In [low, high), 53 bits.
    double real(double low, double high) {
        const double unit =
            (static_cast<double>(engine_() >> 5) * 67108864.0 + static_cast<double>(engine_() >> 6)) / 9007199254740992.0;
        return low + (high - low) * unit;
    }
    float uniform(float low, float high) { return static_cast<float>(real(low, high)); }
    /// Uniform in the logarithm.
    double spread(double low, double high) { return std::exp(real(std::log(low), std::log(high))); }
    /// In [low, high], both included.
    int integer(int low, int high) { return low + static_cast<int>(real(0.0, static_cast<double>(high - low) + 1.0)); }
    glm::vec3 vector(float size) {
        const float x = uniform(-size, size), y = uniform(-size, size), z = uniform(-size, size);
        return {x, y, z};
    }
    glm::dvec3 point(double size) {
        const double x = real(-size, size), y = real(-size, size), z = real(-size, size);
        return {x, y, z};
    }
    /// Unit vector, every direction alike.
    glm::dvec3 direction() {
        for (;;) {
            const glm::dvec3 p = point(1.0);
            const double length = glm::length(p);
            if (length > 0.05 && length <= 1.0)
                return p / length;
        }
    }

  private:
    std::mt19937 engine_;
};

[[nodiscard]] inline std::size_t cell_count(glm::ivec3 cells) {
    return static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y) * static_cast<std::size_t>(cells.z);
}

/// Each component of each cell by itself, uniform in [-size, size].
[[nodiscard]] inline Field white_noise(glm::ivec3 cells, float size, std::uint32_t seed) {
    Random random(seed);
    Field field(cell_count(cells));
    for (glm::vec4& u : field)
        u = glm::vec4(random.vector(size), 0.0f);
    return field;
}

/// A few long waves with random phases, periodic in the box, largest component about `size`.
[[nodiscard]] inline Field smooth_noise(glm::ivec3 cells, float size, std::uint32_t seed) {
    Random random(seed);
    struct Wave {
        glm::dvec3 number, amplitude;
        double phase;
    };
    std::vector<Wave> waves;
    for (int n = 0; n < 8; ++n) {
        glm::dvec3 number;
        for (int axis = 0; axis < 3; ++axis)
            number[axis] = cells[axis] > 1 ? random.integer(-2, 2) : 0;
        const glm::dvec3 wave = number / glm::dvec3(cells);
        glm::dvec3 amplitude = random.point(1.0);
        if (const double squared = glm::dot(wave, wave); squared > 0.0)
            amplitude -= wave * (glm::dot(wave, amplitude) / squared); // transverse: no divergence
        waves.push_back({number, amplitude, random.real(0.0, 2.0 * std::numbers::pi)});
    }
    Field field(cell_count(cells));
    float largest = 0.0f;
    std::size_t at = 0;
    for (int k = 0; k < cells.z; ++k)
        for (int j = 0; j < cells.y; ++j)
            for (int i = 0; i < cells.x; ++i) {
                glm::dvec3 u(0.0);
                for (const Wave& wave : waves) {
                    const glm::dvec3 place = glm::dvec3(i, j, k) / glm::dvec3(cells);
                    u += wave.amplitude * std::sin(2.0 * std::numbers::pi * glm::dot(wave.number, place) + wave.phase);
                }
                field[at] = glm::vec4(glm::vec3(u), 0.0f);
                for (int axis = 0; axis < 3; ++axis)
                    largest = std::max(largest, std::abs(field[at][axis]));
                ++at;
            }
    for (glm::vec4& u : field)
        u *= size / largest;
    return field;
}

/// Two streams in x that pass each other, two cells thick, with a ripple that lets them roll up.
[[nodiscard]] inline Field shear_layer(glm::ivec3 cells, float size, std::uint32_t seed) {
    Field field = smooth_noise(cells, 0.05f * size, seed);
    for (int k = 0; k < cells.z; ++k)
        for (int j = 0; j < cells.y; ++j)
            for (int i = 0; i < cells.x; ++i) {
                const float z = static_cast<float>(k) + 0.5f, quarter = 0.25f * static_cast<float>(cells.z);
                const float stream = std::tanh((z - quarter) / 2.0f) * std::tanh((3.0f * quarter - z) / 2.0f);
                field[(static_cast<std::size_t>(k) * cells.y + j) * cells.x + i].x += size * stream;
            }
    return field;
}

/// The field without its divergence: what a step leaves behind anyway, so that a budget starts from it.
[[nodiscard]] inline Field projected(Field field, const Box& box) {
    auto work = Workspace::create({.box = box});
    project(*work, field);
    return field;
}

/// Sum of |u|^2 / 2 over the cells, in double.
[[nodiscard]] inline double energy_of(std::span<const glm::vec4> field) {
    double sum = 0.0;
    for (const glm::vec4& u : field)
        sum += 0.5 * glm::dot(glm::dvec3(u), glm::dvec3(u));
    return sum;
}

/// Largest |u|; NaN where any component is NaN.
[[nodiscard]] inline double largest_speed(std::span<const glm::vec4> field) {
    float largest = 0.0f;
    for (const glm::vec4& u : field) {
        const float squared = u.x * u.x + u.y * u.y + u.z * u.z;
        if (!(squared <= largest))
            largest = squared;
    }
    return std::sqrt(static_cast<double>(largest));
}

[[nodiscard]] inline bool all_finite(std::span<const glm::vec4> field) {
    return std::all_of(field.begin(), field.end(),
                       [](const glm::vec4& u) { return std::isfinite(u.x) && std::isfinite(u.y) && std::isfinite(u.z); });
}

/// Cells that differ in any bit.
[[nodiscard]] inline std::size_t cells_that_differ(std::span<const glm::vec4> a, std::span<const glm::vec4> b) {
    if (a.size() != b.size())
        return std::max(a.size(), b.size());
    std::size_t count = 0;
    for (std::size_t n = 0; n < a.size(); ++n)
        count += std::memcmp(&a[n], &b[n], sizeof a[n]) != 0;
    return count;
}

[[nodiscard]] inline Field copy(std::span<const glm::vec4> field) {
    return {field.begin(), field.end()};
}

} // namespace windrow::test
