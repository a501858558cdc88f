// Bodies that touch or overlap are one solid (fluid/solids/together.h): the same form as one body and in parts that overlap, or stand
// beside each other, on the floor, on ground and on other bodies.
#include "fluid/solids/together.h"
#include "tests/figure.h"
#include "tests/unit/drawn_ground.h"

#include <functional>
#include <random>

namespace windrow {
namespace {

using namespace test;
using Bodies = std::vector<PlacedObstacle>;

PlacedObstacle block(glm::vec3 low, glm::vec3 high, glm::vec3 by = glm::vec3(0.0f)) {
    PlacedObstacle body;
    body.shape = Block{.half_size = 0.5f * (high - low)};
    body.position = 0.5f * (low + high) + by;
    return body;
}

// Closed blocks, each by itself, in one mesh.
PlacedObstacle mesh(glm::vec3 at, std::initializer_list<std::pair<glm::vec3, glm::vec3>> blocks) {
    MeshData data;
    for (const auto& [low, high] : blocks)
        data = both(data, box_mesh(0.5f * (high - low), 0.5f * (low + high)));
    PlacedObstacle body;
    body.shape = MeshShape{mesh_of(std::move(data))};
    body.position = at;
    return body;
}

PlacedObstacle cylinder(glm::vec3 foot, float radius, float length) {
    PlacedObstacle body;
    body.shape = Cylinder{.radius = radius, .half_length = 0.5f * length};
    body.position = foot + glm::vec3(0.0f, 0.5f * length, 0.0f);
    return body;
}

PlacedObstacle voxels(glm::ivec3 cells, glm::vec3 low, const std::function<bool(glm::ivec3)>& closed) {
    VoxelData data{cells, {}};
    for_each_cell(cells, [&](int i, int j, int k) { data.closed.push_back(closed({i, j, k}) ? 1 : 0); });
    PlacedObstacle body;
    body.shape = VoxelShape{grid_of(std::move(data)), 1.0f};
    body.position = low + 0.5f * glm::vec3(cells);
    return body;
}

PlacedObstacle level_ground(float height) {
    PlacedObstacle body;
    body.shape = Ground{heights_of({2, 2}, 80.0f, [&](double, double) { return static_cast<double>(height); })};
    body.position = {-20.0f, 0.0f, -20.0f};
    return body;
}

// The largest difference over the wind's speed of two sets of bodies, in cells outside of them, after some steps in which they move.
double winds_apart(const Bodies& one, const Bodies& other, glm::dvec3 velocity = glm::dvec3(0.0)) {
    constexpr double k_speed = 6.18, k_step = 1.0 / 60.0;
    Wind winds[] = {wind_over({}), wind_over({})};
    std::vector<float> inside[2];
    for (int n = 0; n < 2; ++n) {
        std::vector<std::pair<ObstacleId, glm::dvec3>> bodies;
        for (const PlacedObstacle& body : n == 0 ? one : other) {
            const Obstacle obstacle = standing(body, winds[n].origin());
            const auto id = winds[n].obstacles().add(obstacle);
            EXPECT_TRUE(id) << id.error();
            bodies.emplace_back(*id, obstacle.position);
        }
        for (int step = 1; step <= 12; ++step) {
            for (std::size_t body = 0; body < bodies.size() && velocity != glm::dvec3(0.0); ++body)
                EXPECT_TRUE(winds[n].obstacles().move(bodies[body].first, bodies[body].second + k_step * step * velocity));
            EXPECT_TRUE(winds[n].step(k_step).stepped);
        }
        inside[n].resize(winds[n].box().cell_count());
        EXPECT_TRUE(winds[n].write_obstacles(inside[n]));
    }
    double worst = 0.0;
    for (std::size_t cell = 0; cell < inside[0].size(); ++cell)
        if (inside[0][cell] < 0.5f && inside[1][cell] < 0.5f)
            worst =
                std::max(worst, double(glm::distance(glm::dvec3(winds[0].field()[cell]), glm::dvec3(winds[1].field()[cell]))));
    return worst / k_speed;
}

constexpr float k_places[] = {0.0f, 0.31f, 0.5f, 0.77f}; // against the cells

// By the sum of what each closes, the first four are .34, .72, .43 and .44 apart.
TEST(Together, AFormIsTheSameInWhateverParts) {
    struct Case {
        const char* name;
        double bound;
        std::function<std::pair<Bodies, Bodies>(glm::vec3)> forms;
    };
    const auto ell = [](glm::ivec3 cell) { return cell.z < 4 || cell.x < 4; };
    const Case cases[] = {
        {"twice", 1e-4,
         [](glm::vec3 at) {
             const PlacedObstacle whole = block({-2, 0, -2}, {2, 4, 2}, at);
             return std::pair(Bodies{whole}, Bodies{whole, whole});
         }},
        {"overlapping", 1e-4,
         [](glm::vec3 at) {
             return std::pair(Bodies{block({-2, 0, -2}, {2, 4, 2}, at)},
                              Bodies{block({-2, 0, -2}, {1, 4, 2}, at), block({-1, 0, -2}, {2, 4, 2}, at)});
         }},
        {"with_one_inside", 1e-4,
         [](glm::vec3 at) {
             PlacedObstacle ball;
             ball.shape = Sphere{.radius = 1.3f};
             ball.position = at + glm::vec3(0.2f, 2.0f, 0.0f);
             return std::pair(Bodies{block({-2, 0, -2}, {2, 4, 2}, at)},
                              Bodies{block({-2, 0, -2}, {2, 4, 2}, at), block({-1.3f, 0, -1.1f}, {1.2f, 2.5f, 1.3f}, at), ball});
         }},
        {"ell", 0.01, // a corner of the air between the arms is a corner of two walls here, and round there
         [&](glm::vec3 at) {
             return std::pair(Bodies{block({-4, 0, -4}, {4, 4, 0}, at), block({-4, 0, 0}, {0, 4, 4}, at)},
                              Bodies{voxels({8, 4, 8}, at - glm::vec3(4, 0, 4), ell)});
         }},
        {"ell_overlapping", 1e-4,
         [](glm::vec3 at) {
             return std::pair(Bodies{block({-4, 0, -4}, {4, 4, 0}, at), block({-4, 0, 0}, {0, 4, 4}, at)},
                              Bodies{block({-4, 0, -4}, {4, 4, 0}, at), block({-4, 0, -4}, {0, 4, 4}, at)});
         }},
        {"ell_of_a_mesh", 1e-4,
         [&](glm::vec3 at) {
             return std::pair(Bodies{mesh(at, {{{-4, 0, -4}, {4, 4, 0}}, {{-4, 0, 0}, {0, 4, 4}}})},
                              Bodies{voxels({8, 4, 8}, at - glm::vec3(4, 0, 4), ell)});
         }},
        {"stair_of_a_mesh", 0.02, // what is left of a side is in pieces of 1/128 of the mesh
         [](glm::vec3 at) {
             return std::pair(
                 Bodies{mesh(at, {{{-3, 0, -2}, {0, 1, 2}}, {{-1, 0, -2}, {1, 2, 2}}, {{1, 0, -2}, {3, 3, 2}}})},
                 Bodies{voxels({6, 3, 4}, at - glm::vec3(3, 0, 2), [](glm::ivec3 cell) { return cell.y <= cell.x / 2; })});
         }},
        {"sunk_in_the_floor", 1e-4,
         [](glm::vec3 at) {
             return std::pair(Bodies{block({-2, 0, -2}, {2, 4, 2}, at)}, Bodies{block({-2, -3, -2}, {2, 4, 2}, at)});
         }},
        {"sunk_in_ground", 1e-3,
         [](glm::vec3 at) {
             return std::pair(Bodies{level_ground(2.0f), block({-2, 2, -2}, {2, 6, 2}, at)},
                              Bodies{level_ground(2.0f), block({-2, -3, -2}, {2, 6, 2}, at)});
         }},
        {"on_ground_at_the_floor", 1e-3,
         [](glm::vec3 at) {
             return std::pair(Bodies{block({-2, 0, -2}, {2, 4, 2}, at)},
                              Bodies{level_ground(0.0f), block({-2, 0, -2}, {2, 4, 2}, at)});
         }},
        {"tower_of_two", 0.1, // round, and the seam between rows of cells
         [](glm::vec3 at) {
             return std::pair(Bodies{cylinder(at, 2.0f, 6.0f)},
                              Bodies{cylinder(at, 2.0f, 3.0f), cylinder(at + glm::vec3(0, 3, 0), 2.0f, 3.0f)});
         }},
        {"other_order", 1e-6,
         [](glm::vec3 at) {
             PlacedObstacle one, other;
             one.shape = Sphere{.radius = 1.6f};
             other.shape = Sphere{.radius = 2.0f};
             one.position = at + glm::vec3(-1.0f, 3.5f, 0.0f);
             other.position = at + glm::vec3(1.0f, 3.1f, 0.4f);
             return std::pair(Bodies{one, other}, Bodies{other, one});
         }},
    };
    for (const Case& one : cases) {
        double worst = 0.0;
        for (const float shift : k_places) {
            const auto [form, same] = one.forms(glm::vec3(14.0f, 0.0f, 14.0f) + shift * glm::vec3(1.0f, 0.0f, 0.7f));
            worst = std::max(worst, winds_apart(form, same));
        }
        WINDROW_EXPECT_FIGURE(std::string("together/") + one.name, worst, one.bound);
    }
}

// What moves together, and over what rests. Drawn one by one .09, .35, .15 and .5.
TEST(Together, MovesAsOneBody) {
    const auto worst = [](const std::function<std::pair<Bodies, Bodies>(glm::vec3)>& forms) {
        double most = 0.0;
        for (const float shift : k_places) {
            const auto [form, same] = forms(glm::vec3(14.0f, 0.0f, 14.0f) + shift * glm::vec3(1.0f, 0.0f, 0.7f));
            most = std::max(most, winds_apart(form, same, {3.0, 0.0, 0.0}));
        }
        return most;
    };
    const double halves = worst([](glm::vec3 at) {
        return std::pair(Bodies{block({-2, 0, -2}, {2, 4, 2}, at)},
                         Bodies{block({-2, 0, -2}, {0, 4, 2}, at), block({0, 0, -2}, {2, 4, 2}, at)});
    });
    const double car = worst([](glm::vec3 at) {
        return std::pair(Bodies{block({-3, 0, -1}, {3, 1.5f, 1}, at), block({-2, 0, -1}, {1, 3, 1}, at)},
                         Bodies{block({-3, 0, -1}, {3, 1.5f, 1}, at), block({-2, 1.5f, -1}, {1, 3, 1}, at)});
    });
    const double floor = worst([](glm::vec3 at) {
        return std::pair(Bodies{block({-2, 0, -2}, {2, 4, 2}, at)}, Bodies{block({-2, -3, -2}, {2, 4, 2}, at)});
    });
    WINDROW_EXPECT_FIGURE("together/halves_that_move", halves, 0.05); // the air that a body uncovers is found body by body
    WINDROW_EXPECT_FIGURE("together/car_of_two_blocks", car, 0.05);
    WINDROW_EXPECT_FIGURE("together/moves_on_the_floor", floor, 1e-4);
}

// Two blocks that overlap close what one does, at any angle; in a box that is periodic, and while they come, go and rest.
TEST(Together, CloseWhatOneBodyCloses) {
    std::mt19937 chance(5);
    const auto part = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(chance); };
    double worst = 0.0, worst_kept = 0.0;
    for (int n = 0; n < 40; ++n) {
        const Box box = box_of(n % 4 == 3 ? Boundaries::all(BoundaryKind::periodic) : Boundaries{});
        const glm::vec3 half(part(1.0f, 4.0f), part(1.0f, 4.0f), part(1.0f, 4.0f));
        const glm::vec3 middle =
            n % 4 == 3 ? glm::vec3(part(0.0f, 1.0f), 10.0f, 14.0f) : glm::vec3(part(13.0f, 14.0f), 10.0f, 14.0f);
        const float angle = n % 2 == 0 ? 0.0f : part(0.0f, 3.0f);
        const glm::mat3 axes(glm::mat3_cast(glm::angleAxis(angle, glm::normalize(glm::vec3(0.1f, 1.0f, 0.2f)))));
        const float cut = part(-0.6f, 0.5f) * half.x, over = part(0.1f, 0.4f) * half.x;
        const auto of = [&](float low, float high) {
            PlacedObstacle body = block({low, -half.y, -half.z}, {high, half.y, half.z});
            body.position = middle + axes * body.position;
            body.axes = axes;
            return body;
        };
        Bodies parts{of(-half.x, cut + over), of(cut, half.x)};
        const Bodies whole{of(-half.x, half.x)};
        worst = std::max(worst, apart(drawn_from(whole, box), drawn_from(parts, box)));

        PlacedObstacle ball;
        ball.shape = Sphere{.radius = 1.5f};
        ball.position = middle + glm::vec3(0.0f, half.y, 0.0f);
        Solids solids(box, box.cells.x);
        solids.place(parts);
        parts.push_back(ball); // beside both
        solids.place(parts);
        worst_kept = std::max(worst_kept, apart(drawn_by(solids), drawn_from(parts, box)));
        parts.erase(parts.begin());
        parts.back().velocity = {1.0f, 0.0f, 0.0f};
        solids.place(parts);
        worst_kept = std::max(worst_kept, apart(drawn_by(solids), drawn_from(parts, box)));
        const glm::ivec3 shift = n % 4 == 3 ? glm::ivec3(0) : glm::ivec3(2, 0, -1); // a periodic box never moves
        for (PlacedObstacle& body : parts)
            body.position -= glm::vec3(shift);
        solids.place(parts, shift);
        worst_kept = std::max(worst_kept, apart(drawn_by(solids), drawn_from(parts, box)));
    }
    WINDROW_EXPECT_FIGURE("together/closed_apart", worst, 3e-3); // places are rounded to 1/4096 of a cell
    WINDROW_EXPECT_FIGURE("together/closed_apart_where_kept", worst_kept, 3e-3);
}

// An L as blocks, as a mesh of two and as voxels has the same sharp edges (fluid/solids/edges.h); a seam, the foot of a wall and a round
// mesh have none.
TEST(Together, HasTheSharpEdgesOfTheWholeAlone) {
    const auto joined = [](const Bodies& bodies, float floor = -100.0f) {
        Together together;
        together.begin(bodies[0], 1.0f, 3.0f);
        together.add_wall(1, false, floor - bodies[0].position.y);
        for (std::size_t n = 1; n < bodies.size(); ++n)
            together.add(bodies[n], bodies[n].position - bodies[0].position, false);
        together.end();
        return together;
    };
    const auto edge = [](const Together& together, const PlacedObstacle& first, glm::vec3 place) {
        const glm::vec3 of_axis = together.edges_at(place - first.position, glm::vec3(1.0f));
        return std::max({of_axis.x, of_axis.y, of_axis.z});
    };
    const glm::vec3 at(0.0f);
    const Bodies blocks{block({-4, 0, -4}, {4, 4, 0}), block({-4, 0, 0}, {0, 4, 4})},
        meshes{mesh(at, {{{-4, 0, -4}, {4, 4, 0}}, {{-4, 0, 0}, {0, 4, 4}}})},
        grids{voxels({8, 4, 8}, {-4, 0, -4}, [](glm::ivec3 cell) { return cell.z < 4 || cell.x < 4; })};
    const Together as_blocks = joined(blocks, 0.0f), as_mesh = joined(meshes, 0.0f), as_voxels = joined(grids, 0.0f);
    Random random(5);
    double worst = 0.0, sum = 0.0;
    for (int n = 0; n < 3000; ++n) {
        const glm::vec3 place = random.vector(5.0f) + glm::vec3(0.0f, 3.0f, 0.0f);
        const float one = edge(as_blocks, blocks[0], place), other = edge(as_mesh, meshes[0], place),
                    third = edge(as_voxels, grids[0], place);
        worst = std::max({worst, double(std::abs(one - other)), double(std::abs(other - third))});
        sum += double(one) / 3000.0;
    }
    WINDROW_EXPECT_FIGURE("together/edges_apart", worst, 0.02); // where others cover an edge in part it is found place by place
    EXPECT_GT(sum, 0.02);

    const float at_corner = edge(as_blocks, blocks[0], {4.2f, 2.0f, -4.2f}),
                at_foot = edge(as_blocks, blocks[0], {4.2f, 0.1f, -2.0f}),
                at_inner_corner = edge(as_blocks, blocks[0], {0.2f, 2.0f, 0.2f});
    EXPECT_EQ(at_corner, 1.0f);
    EXPECT_EQ(at_foot, 0.0f);
    EXPECT_EQ(at_inner_corner, 0.0f);
    const Bodies halves{block({-2, 0, -2}, {0, 4, 2}), block({0, 0, -2}, {2, 4, 2})};
    EXPECT_EQ(edge(joined(halves), halves[0], {0.0f, 2.0f, -2.1f}), 0.0f);
    PlacedObstacle ball;
    ball.shape = MeshShape{mesh_of(ball_mesh(3.0f, 2))};
    const Bodies balls{ball};
    const Together round = joined(balls);
    for (int n = 0; n < 300; ++n)
        EXPECT_EQ(edge(round, balls[0], 3.1f * glm::normalize(random.vector(1.0f))), 0.0f);
}

// Bodies that are near and do not touch close their sum: a gap narrower than a cell stays open.
TEST(Together, LeavesAGapOpen) {
    const PlacedObstacle left = block({8, 0, 10}, {12.3f, 6, 16}), right = block({12.7f, 0, 10}, {16, 6, 16});
    Solids solids(box_of(), box_of().cells.x);
    solids.place(Bodies{left, right});
    const ClosedFace* const between = solids.face(static_cast<std::uint32_t>(box_of().index(12, 2, 12)), 2);
    ASSERT_NE(between, nullptr);
    EXPECT_NEAR(between->closed, 0.6, 1e-3);
}

} // namespace
} // namespace windrow
