// What the tests of the export share: a folder that goes away, and boxes of wind.
#pragma once

#include "fluid/vdb/vdb_export.h"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <system_error>
#include <vector>

namespace windrow::vdb_test {

/// A folder of its own, removed with what is in it.
class Folder {
  public:
    Folder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "windrow_vdb_XXXXXX").string();
        path_ = ::mkdtemp(pattern.data());
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::ptrdiff_t entries() const {
        return std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator());
    }

  private:
    std::filesystem::path path_;
};

/// A box with a wind of its own.
struct Air {
    glm::ivec3 cells{0};
    float cell_size = 1.0f;
    glm::dvec3 origin{0.0};
    std::vector<glm::vec4> field;

    [[nodiscard]] vdb::VelocityGrid grid() const {
        return {.cells = cells, .cell_size = cell_size, .origin = origin, .field = field};
    }
    [[nodiscard]] glm::vec3 at(int i, int j, int k) const {
        return field[Box{.cells = cells, .cell_size = cell_size, .sides = {}}.index(i, j, k)];
    }
    [[nodiscard]] glm::dvec3 centre(int i, int j, int k) const {
        return origin + (glm::dvec3(i, j, k) + 0.5) * double(cell_size);
    }
};

inline Air uniform_air(glm::ivec3 cells, glm::vec3 wind) {
    return {.cells = cells, .field = std::vector<glm::vec4>(std::size_t(cells.x) * cells.y * cells.z, glm::vec4(wind, 0.0f))};
}

/// Sizes from 6.1e-5 to 10^4 m/s, both signs: the values that half holds with its full 11 bits.
inline Air random_air(glm::ivec3 cells) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> exponent(std::log(6.2e-5f), std::log(1e4f));
    auto value = [&] { return std::exp(exponent(random)) * (random() % 2 == 0 ? 1.0f : -1.0f); };
    Air air = uniform_air(cells, glm::vec3(0.0f));
    for (glm::vec4& velocity : air.field) {
        const float x = value(), y = value(), z = value();
        velocity = {x, y, z, 99.0f};
    }
    return air;
}

inline std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace windrow::vdb_test
