#include "fluid/core/validation.h"
#include "vegetation/fur/mesh_grid.h"
#include "vegetation/fur/shapes.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

namespace windrow::vegetation::fur {
namespace {

constexpr double k_pi = std::numbers::pi;

MeshVertex on_sphere(const glm::dvec3& way, double radius, double u, double v) {
    return {.position = glm::vec3(way * radius), .normal = glm::vec3(way), .uv = {static_cast<float>(u), static_cast<float>(v)}};
}

} // namespace

Result<Mesh> globe_sphere(const GlobeSphere& settings) {
    if (const auto valid = windrow::detail::validate_settings(settings, "sphere"); !valid)
        return valid.failure();

    Mesh mesh;
    mesh.has_uv = true;
    const double radius = static_cast<double>(settings.radius);
    mesh.vertices.push_back(on_sphere({0.0, -1.0, 0.0}, radius, 0.5, 0.0));
    for (int stack = 1; stack < settings.stacks; ++stack)
        for (int sector = 0; sector <= settings.sectors; ++sector) {
            const double v = 1.0 * stack / settings.stacks, u = 1.0 * sector / settings.sectors;
            // The last column is the first to the bit: shells stay closed there.
            const double around = 2.0 * k_pi * (sector % settings.sectors) / settings.sectors, ring = std::sin(k_pi * v);
            mesh.vertices.push_back(
                on_sphere({ring * std::cos(around), -std::cos(k_pi * v), -ring * std::sin(around)}, radius, u, v));
        }
    mesh.vertices.push_back(on_sphere({0.0, 1.0, 0.0}, radius, 0.5, 1.0));

    const auto columns = static_cast<std::uint32_t>(settings.sectors) + 1,
               rings = static_cast<std::uint32_t>(settings.stacks) - 1;
    const auto at = [&](std::uint32_t ring, std::uint32_t column) { return 1 + ring * columns + column; };
    const auto top = static_cast<std::uint32_t>(mesh.vertices.size()) - 1;
    for (std::uint32_t column = 0; column + 1 < columns; ++column) {
        mesh.indices.insert(mesh.indices.end(), {0, at(0, column + 1), at(0, column)});
        for (std::uint32_t ring = 0; ring + 1 < rings; ++ring)
            add_cell(mesh, at(ring, column), at(ring, column + 1), at(ring + 1, column + 1), at(ring + 1, column));
        mesh.indices.insert(mesh.indices.end(), {at(rings - 1, column), at(rings - 1, column + 1), top});
    }
    finish(mesh, "sphere");
    return mesh;
}

Result<Mesh> cube_sphere(const CubeSphere& settings) {
    if (const auto valid = windrow::detail::validate_settings(settings, "sphere"); !valid)
        return valid.failure();

    // Outward, to the right and up of each face; right x up = outward.
    constexpr int k_axes[6][3][3] = {{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                     {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}}, {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                                     {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}};
    const auto axis = [&](int face, int which) {
        const int* a = k_axes[face][which];
        return glm::dvec3(a[0], a[1], a[2]);
    };
    Mesh mesh;
    mesh.has_uv = true;
    const int n = settings.cells;
    // Odd, so that both faces at an edge have the same positions there to the bit.
    const auto slope = [&](int i) {
        const int from_middle = 2 * i - n;
        return std::abs(from_middle) == n ? from_middle / n * 1.0 : std::tan(k_pi / 4.0 * from_middle / n);
    };
    for (int face = 0; face < 6; ++face)
        for (int row = 0; row <= n; ++row)
            for (int column = 0; column <= n; ++column) {
                const glm::dvec3 on_cube = axis(face, 0) + slope(column) * axis(face, 1) + slope(row) * axis(face, 2);
                // x^2 + y^2 + z^2 in the order of size, since a sum's rounding depends on its order.
                glm::dvec3 squares = on_cube * on_cube;
                if (squares.x > squares.y)
                    std::swap(squares.x, squares.y);
                if (squares.y > squares.z)
                    std::swap(squares.y, squares.z);
                if (squares.x > squares.y)
                    std::swap(squares.x, squares.y);
                const double length = std::sqrt(squares.x + squares.y + squares.z);
                mesh.vertices.push_back(
                    on_sphere(on_cube / length, static_cast<double>(settings.radius), 1.0 * column / n, 1.0 * row / n));
            }
    const auto side = static_cast<std::uint32_t>(n) + 1;
    for (std::uint32_t face = 0; face < 6; ++face)
        for (std::uint32_t row = 0; row + 1 < side; ++row)
            for (std::uint32_t column = 0; column + 1 < side; ++column) {
                const std::uint32_t a = (face * side + row) * side + column;
                add_cell(mesh, a, a + 1, a + 1 + side, a + side);
            }
    finish(mesh, "sphere");
    return mesh;
}

} // namespace windrow::vegetation::fur
