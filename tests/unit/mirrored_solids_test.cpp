// A mirror changes left and right of bodies and nothing else: what they close is the mirror image. A face that is drawn by whoever has its
// low cell, with that one's motion, is another one in the mirror where bodies touch, overlap or pass each other.
#include "fluid/solids/solids.h"
#include "tests/any_wind.h"
#include "tests/figure.h"

#include <cmath>
#include <map>
#include <tuple>

namespace windrow {
namespace {

using test::Chance;

std::vector<PlacedObstacle> any_bodies(Chance& chance, glm::ivec3 cells) {
    constexpr int k_round_and_flat = 6; // shapes of the table that are their own mirror image
    const auto shapes = test::scenario_parts::scenario_shapes();
    std::vector<PlacedObstacle> bodies;
    const int count = chance.whole(1, 3);
    for (int n = 0; n < count; ++n) {
        const auto kind = static_cast<std::size_t>(chance.whole(0, k_round_and_flat - 1));
        PlacedObstacle body{.shape = test::resized(shapes[kind].shape, chance.size(0.15, 1.2)),
                            .slot = static_cast<std::uint32_t>(n),
                            .generation = 1};
        body.position = glm::vec3(glm::dvec3(cells) * (0.5 + 0.35 * chance.in_cube()));
        if (chance.happens(0.6)) {
            const glm::vec3 axis = glm::normalize(glm::vec3(chance.in_cube()));
            body.axes = glm::mat3_cast(glm::angleAxis(static_cast<float>(chance.between(0.0, 3.0)), axis));
        }
        if (chance.happens(0.6))
            body.velocity = glm::vec3(4.0 * chance.in_cube());
        if (chance.happens(0.3))
            body.spin = glm::vec3(3.0 * chance.in_cube());
        bodies.push_back(body);
    }
    return bodies;
}

// From low to high x.
PlacedObstacle mirrored(PlacedObstacle body, glm::ivec3 cells) {
    glm::mat3 mirror(1.0f);
    mirror[0][0] = -1.0f;
    body.position.x = static_cast<float>(cells.x) - body.position.x;
    body.axes = mirror * body.axes * mirror;
    if (auto* const rod = std::get_if<Capsule>(&body.shape))
        rod->half_axis.x = -rod->half_axis.x;
    body.velocity.x = -body.velocity.x;
    body.spin = glm::vec3(body.spin.x, -body.spin.y, -body.spin.z);
    return body;
}

/// Of a face; of a cell inside, as axis 3, `wall` is the number of its body.
struct MirroredFace {
    float closed = 0.0f, wall = 0.0f;
};
using MirroredFaces = std::map<std::tuple<int, int, int, int>, MirroredFace>;

MirroredFaces faces_of(std::span<const PlacedObstacle> bodies, glm::ivec3 cells, bool as_mirrored) {
    const Box box{.cells = cells, .cell_size = 1.0f};
    Solids solids(box, cells.x);
    solids.place(bodies);
    MirroredFaces faces;
    for (const ClosedFace& face : solids.faces()) {
        glm::ivec3 low(face.place[0], face.place[1], face.place[2]);
        float wall = face.wall;
        if (as_mirrored) {
            low.x = cells.x - (face.axis == 0 ? 2 : 1) - low.x;
            wall = face.axis == 0 ? -wall : wall;
        }
        if (!face.ends_box())
            faces[{low.x, low.y, low.z, face.axis}] = {face.closed, wall};
    }
    for (const Solids::InsideCell& cell : solids.inside()) {
        const int x = as_mirrored ? cells.x - 1 - cell.place.x : cell.place.x;
        faces[{x, cell.place.y, cell.place.z, 3}] = {1.0f, static_cast<float>(bodies[cell.body].slot)};
    }
    return faces;
}

// A place that is rounded, and an edge of a plate that just passes a line of centres, may differ by more in one row of two hundred.
TEST(MirroredSolids, HoldTheMirroredFacesAndCells) {
    int differing = 0;
    constexpr std::uint32_t k_rows = 400;
    for (std::uint32_t seed = 1; seed <= k_rows; ++seed) {
        Chance chance(seed);
        const int x = 2 * chance.whole(4, 9), y = chance.whole(6, 12);
        const glm::ivec3 cells(x, y, 2 * chance.whole(4, 9));
        const std::vector<PlacedObstacle> bodies = any_bodies(chance, cells);
        std::vector<PlacedObstacle> others;
        for (const PlacedObstacle& body : bodies)
            others.insert(others.begin(), mirrored(body, cells)); // bodies come in an order of places
        const MirroredFaces faces = faces_of(bodies, cells, false);
        MirroredFaces images = faces_of(others, cells, true);
        bool same = true;
        for (const auto& [place, face] : faces) {
            const MirroredFace image = images[place];
            same = same && std::abs(face.closed - image.closed) < 0.02f && std::abs(face.wall - image.wall) < 0.1f;
        }
        differing += same && images.size() < faces.size() + 3 ? 0 : 1;
    }
    WINDROW_EXPECT_FIGURE("mirrored_solids_rows_that_differ", differing, 2.0);
}

} // namespace
} // namespace windrow
