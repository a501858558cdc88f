#include "cli/bench/obstacle_scenes.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace windrow::cli {
namespace {

constexpr double k_town_surface = 0.03; // of the cells

} // namespace

bool build_block(const BuildingPlace& place, glm::dvec3 position, glm::vec3 half_size) {
    return place.obstacles.add({.position = position, .shape = Block{half_size}}).has_value();
}

bool build_cube(const BuildingPlace& place) {
    return build_block(place, {0.0, place.origin.y + 4.0, 0.0}, glm::vec3(4.0f));
}

bool build_town(const BuildingPlace& place, double length) {
    const glm::ivec3 cells = place.box.cells;
    const glm::vec3 half = glm::vec3(3.0f, 0.125f * static_cast<float>(cells.y) + 1.0f, 3.0f);
    const auto surface = [](glm::vec3 size) { return 2.0f * (size.x + size.z) * size.y + size.x * size.z; };
    const float of_one = surface(2.0f * half) + surface(2.0f * half - glm::vec3(2.0f, 1.0f, 2.0f)); // outside and inside
    const double count = k_town_surface * static_cast<double>(place.box.cell_count()) / static_cast<double>(of_one);
    const int rows = std::max(1, static_cast<int>(std::ceil(std::sqrt(count * cells.z / cells.x))));
    const double along = cells.x * rows / count, across = static_cast<double>(cells.z) / rows;
    bool built = true;
    for (int row = 0; row < rows; ++row)
        for (double x = 0.5 * along; x < length * cells.x; x += along)
            built = built && build_block(place,
                                         place.origin + glm::floor(glm::dvec3(x, 0.0, (row + 0.5) * across)) +
                                             glm::dvec3(0.0, static_cast<double>(half.y), 0.0),
                                         half);
    return built;
}

bool build_hills(const BuildingPlace& place) {
    const glm::vec3 size = glm::vec3(place.box.cells) * place.box.cell_size;
    const auto wave = [](float part) { return std::sin(4.0f * 3.1416f * part); };
    auto map = HeightMap::create(glm::ivec2(place.box.cells.x, place.box.cells.z) + 1, place.box.cell_size, [&](glm::vec2 at) {
        return size.y * (0.19f + 0.09f * (wave(at.x / size.x) + wave(at.y / size.z)));
    });
    return map &&
           place.obstacles.add({.position = place.origin, .shape = Ground{std::make_shared<const HeightMap>(std::move(*map))}})
               .has_value();
}

} // namespace windrow::cli
