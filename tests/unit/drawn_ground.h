// What a placement of grounds draws, as the tests of tiles and of holes compare it; and maps of hills for both.
#pragma once

#include "fluid/solids/solids.h"
#include "tests/shapes.h"
#include "tests/winds.h"

#include <map>
#include <set>
#include <tuple>

namespace windrow::test {

// --- What is drawn -----------------------------------------------------------------------------------------------------------

using FaceName = std::tuple<int, int, int, int>;

struct Drawn {
    std::map<FaceName, float> faces{}; ///< closed fractions
    std::set<std::uint32_t> inside{};
    std::vector<glm::vec3> normals{};
    std::map<std::uint32_t, float> near{};

    [[nodiscard]] float closed(const FaceName& name) const {
        const auto at = faces.find(name);
        return at == faces.end() ? 0.0f : at->second;
    }
};

inline Drawn drawn_by(const Solids& solids) {
    Drawn drawn;
    for (const ClosedFace& face : solids.faces())
        drawn.faces[{face.place[0], face.place[1], face.place[2], face.axis}] = face.closed;
    for (const Solids::InsideCell& cell : solids.inside())
        drawn.inside.insert(cell.cell);
    for (const Solids::GhostSource& source : solids.ghost_sources())
        drawn.normals.push_back(source.normal);
    solids.for_each_near([&](std::uint32_t cell, glm::ivec3, float away, std::size_t) {
        const auto [at, is_new] = drawn.near.try_emplace(cell, away);
        at->second = std::min(at->second, away);
    });
    return drawn;
}

inline Box box_of(Boundaries boundaries = {}) {
    return {.cells = {32, 20, 28}, .cell_size = 1.0f, .boundaries = boundaries};
}

inline Drawn drawn_from(std::span<const PlacedObstacle> bodies, const Box& box = box_of()) {
    Solids solids(box, box.cells.x);
    solids.place(bodies);
    return drawn_by(solids);
}

// The largest difference of a face's closed fraction, over all faces of either.
inline double apart(const Drawn& a, const Drawn& b) {
    double most = 0.0;
    for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)})
        for (const auto& [name, closed] : from->faces)
            most = std::max(most, std::abs(double(closed) - double(to->closed(name))));
    return most;
}

// --- Maps --------------------------------------------------------------------------------------------------------------------

// Hills, and a cliff along x = 12 that a seam may cross.
inline double height(double x, double z) {
    return 6.0 + 2.5 * std::sin(0.31 * x) * std::cos(0.23 * z) + (x > 12.0 && z < 8.0 ? 3.0 : 0.0);
}

// A part of the hills, from a corner of a lattice of half metres to another; the whole is from (-64, -64).
inline PlacedObstacle part_of_hills(glm::vec2 low, glm::vec2 high, Beyond beyond = Beyond::nothing, double raised = 0.0) {
    PlacedObstacle body;
    const glm::ivec2 corners = glm::ivec2((high - low) / 0.5f) + 1;
    body.shape = Ground{heights_of(corners, 0.5f,
                                   [&](double x, double z) {
                                       return height(x + static_cast<double>(low.x), z + static_cast<double>(low.y)) + raised;
                                   }),
                        glm::vec3(1.0f), beyond};
    body.position = {low.x, 0.0f, low.y};
    return body;
}

inline std::vector<PlacedObstacle> quarters(glm::vec2 seam) {
    constexpr float k_far = 64.0f;
    return {part_of_hills({-k_far, -k_far}, seam), part_of_hills({seam.x, -k_far}, {k_far, seam.y}),
            part_of_hills({-k_far, seam.y}, {seam.x, k_far}), part_of_hills(seam, {k_far, k_far})};
}

inline PlacedObstacle whole() {
    return part_of_hills({-64.0f, -64.0f}, {64.0f, 64.0f}, Beyond::edge);
}

inline void turn(std::vector<PlacedObstacle>& bodies, float angle, glm::vec3 about) {
    const glm::mat3 axes(glm::mat3_cast(glm::angleAxis(angle, glm::vec3(0.0f, 1.0f, 0.0f))));
    for (PlacedObstacle& body : bodies) {
        body.axes = axes;
        body.position = about + axes * (body.position - about);
    }
}

inline Obstacle standing(const PlacedObstacle& body, glm::dvec3 low) {
    return {.position = low + glm::dvec3(body.position), .shape = body.shape};
}

inline Wind wind_over(std::span<const PlacedObstacle> bodies) {
    Wind wind = made({.cells = {32, 20, 28}, .boundaries = Boundaries::open_over_floor(), .ambient = {6.0f, 0.0f, 1.5f}});
    for (const PlacedObstacle& body : bodies)
        EXPECT_TRUE(wind.obstacles().add(standing(body, wind.origin())));
    return wind;
}

} // namespace windrow::test
