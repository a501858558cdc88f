// Winds to start a test from, random numbers that every standard library gives alike, and what tests ask of a field.
#pragma once

#include "fluid/box.h"
#include "fluid/motor.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <random>
#include <span>
#include <vector>

namespace windrow::test {

/// For closed forms, and wherever an order is measured.
inline constexpr Turbulence k_steady{.intensity = 0.0f};

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

[[nodiscard]] std::size_t cell_count(glm::ivec3 cells);
/// Each component of each cell by itself, uniform in [-size, size].
[[nodiscard]] Field white_noise(glm::ivec3 cells, float size, std::uint32_t seed);
/// A few long waves with random phases, periodic in the box, largest component about `size`.
[[nodiscard]] Field smooth_noise(glm::ivec3 cells, float size, std::uint32_t seed);
/// Two streams in x that pass each other, two cells thick, with a ripple that lets them roll up.
[[nodiscard]] Field shear_layer(glm::ivec3 cells, float size, std::uint32_t seed);
/// The field without its divergence: what a step leaves behind anyway, so that a budget starts from it.
[[nodiscard]] Field projected(Field field, const Box& box);
/// Sum of |u|^2 / 2 over the cells, in double.
[[nodiscard]] double energy_of(std::span<const glm::vec4> field);
/// Largest |u|; NaN where any component is NaN.
[[nodiscard]] double largest_speed(std::span<const glm::vec4> field);
[[nodiscard]] bool all_finite(std::span<const glm::vec4> field);
/// Cells that differ in any bit.
[[nodiscard]] std::size_t cells_that_differ(std::span<const glm::vec4> a, std::span<const glm::vec4> b);
[[nodiscard]] Field copy(std::span<const glm::vec4> field);

} // namespace windrow::test
