// Boxes of wind for the tests of the export.
#pragma once

#include "fluid/vdb/vdb_export.h"
#include "tests/own_folder.h"

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace windrow::vdb_test {

using test::OwnFolder;
using test::text_of;

/// A box with a wind of its own.
struct WindBox {
    glm::ivec3 cells{0};
    float cell_size = 1.0f;
    glm::dvec3 origin{0.0};
    std::vector<glm::vec4> field;

    [[nodiscard]] vdb::VelocityGrid grid() const {
        return {.cells = cells, .cell_size = cell_size, .origin = origin, .field = field};
    }
    [[nodiscard]] glm::vec3 at(int i, int j, int k) const {
        return field[Box{.cells = cells, .cell_size = cell_size, .boundaries = {}}.index(i, j, k)];
    }
    /// visit(i, j, k) for each cell
    template <class Visit>
    void for_each(const Visit& visit) const {
        for (int k = 0; k < cells.z; ++k)
            for (int j = 0; j < cells.y; ++j)
                for (int i = 0; i < cells.x; ++i)
                    visit(i, j, k);
    }
    [[nodiscard]] glm::dvec3 centre(int i, int j, int k) const {
        return origin + (glm::dvec3(i, j, k) + 0.5) * double(cell_size);
    }
};

inline WindBox uniform_air(glm::ivec3 cells, glm::vec3 wind) {
    return {.cells = cells, .field = std::vector<glm::vec4>(std::size_t(cells.x) * cells.y * cells.z, glm::vec4(wind, 0.0f))};
}

/// Sizes from 6.1e-5 to 10^4 m/s, both signs: the values that half holds with its full 11 bits.
inline WindBox random_air(glm::ivec3 cells) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> exponent(std::log(6.2e-5f), std::log(1e4f));
    auto value = [&] { return std::exp(exponent(random)) * (random() % 2 == 0 ? 1.0f : -1.0f); };
    WindBox air = uniform_air(cells, glm::vec3(0.0f));
    for (glm::vec4& velocity : air.field) {
        const float x = value(), y = value(), z = value();
        velocity = {x, y, z, 99.0f};
    }
    return air;
}

} // namespace windrow::vdb_test
