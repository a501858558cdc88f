#include "tests/fields.h"

#include "fluid/operators.h"

#include <algorithm>
#include <cstring>
#include <glm/common.hpp>
#include <numbers>

namespace windrow::test {

std::size_t cell_count(glm::ivec3 cells) {
    return static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y) * static_cast<std::size_t>(cells.z);
}

Field white_noise(glm::ivec3 cells, float size, std::uint32_t seed) {
    Random random(seed);
    Field field(cell_count(cells));
    for (glm::vec4& u : field)
        u = glm::vec4(random.vector(size), 0.0f);
    return field;
}

Field smooth_noise(glm::ivec3 cells, float size, std::uint32_t seed) {
    Random random(seed);
    struct NoiseWave {
        glm::dvec3 number, amplitude;
        double phase;
    };
    std::vector<NoiseWave> waves;
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
                for (const NoiseWave& wave : waves) {
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

Field shear_layer(glm::ivec3 cells, float size, std::uint32_t seed) {
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

Field projected(Field field, const Box& box) {
    auto work = Workspace::create({.box = box});
    project(*work, field);
    return field;
}

double energy_of(std::span<const glm::vec4> field) {
    double sum = 0.0;
    for (const glm::vec4& u : field)
        sum += 0.5 * glm::dot(glm::dvec3(u), glm::dvec3(u));
    return sum;
}

double largest_speed(std::span<const glm::vec4> field) {
    float largest = 0.0f;
    for (const glm::vec4& u : field) {
        const float squared = u.x * u.x + u.y * u.y + u.z * u.z;
        if (!(squared <= largest))
            largest = squared;
    }
    return std::sqrt(static_cast<double>(largest));
}

bool all_finite(std::span<const glm::vec4> field) {
    return std::all_of(field.begin(), field.end(),
                       [](const glm::vec4& u) { return std::isfinite(u.x) && std::isfinite(u.y) && std::isfinite(u.z); });
}

std::size_t cells_that_differ(std::span<const glm::vec4> a, std::span<const glm::vec4> b) {
    if (a.size() != b.size())
        return std::max(a.size(), b.size());
    std::size_t count = 0;
    for (std::size_t n = 0; n < a.size(); ++n)
        count += std::memcmp(&a[n], &b[n], sizeof a[n]) != 0;
    return count;
}

Field copy(std::span<const glm::vec4> field) {
    return {field.begin(), field.end()};
}

} // namespace windrow::test
