// Lines between the centres of cells, over a ground and past other bodies: exact, whatever a map does elsewhere and however near a
// surface they are.
#include "fluid/solids/solids.h"
#include "tests/shapes.h"
#include "tests/tier.h"
#include "tests/winds.h"

#include <random>
#include <set>

namespace windrow {
namespace {

using namespace test;

// Hills with a cliff of 90 m at x = `cliff`; beyond the map where there is none.
std::shared_ptr<const HeightMap> hills(double cliff) {
    return heights_of({121, 61}, 1.0f, [=](double x, double z) {
        return 3.0 + 2.0 * std::sin(0.31 * x) * std::cos(0.23 * z) + (x > cliff ? 90.0 : 0.0);
    });
}

TEST(GroundLines, LeastRiseIsThatOfDenseSamples) {
    std::mt19937 chance(5);
    const auto part = [&](float from, float to) { return std::uniform_real_distribution<float>(from, to)(chance); };
    const int lines = sampled(20'000, 2'000);
    int blocked = 0;
    double worst = 0.0;
    for (int map = 0; map < 20; ++map) {
        HeightData data{.corners = {5 + map % 7, 3 + map % 5}, .spacing = part(0.3f, 2.0f)};
        for (int n = 0; n < data.corners.x * data.corners.y; ++n)
            data.heights.push_back(part(-2.0f, 2.0f) + (n % 11 == 3 ? 40.0f : 0.0f)); // cliffs
        const Ground ground{heights_of(data), {part(0.5f, 2.0f), part(0.5f, 2.0f), part(0.5f, 2.0f)}};
        const glm::vec2 size = glm::vec2(ground.scale.x, ground.scale.z) * ground.heights->extent();
        for (int n = 0; n < lines / 20; ++n) {
            const auto point = [&] { // beyond the edge too
                const float x = part(-0.3f, 1.3f) * size.x, z = part(-0.3f, 1.3f) * size.y;
                return glm::vec3(x, detail::height_at(ground, {x, 0.0f, z}) + part(0.0f, 3.0f), z);
            };
            const glm::vec3 from = point(), to = n % 3 == 0 ? from + glm::vec3(1.0f, 0.0f, 0.0f) : point();
            constexpr int k_samples = 4000;
            float dense = std::numeric_limits<float>::max(), step = 0.0f, before = 0.0f;
            for (int i = 0; i <= k_samples; ++i) {
                const glm::vec3 at = glm::mix(from, to, static_cast<float>(i) / k_samples);
                const float rise = at.y - detail::height_at(ground, at);
                if (i > 0)
                    step = std::max(step, std::abs(rise - before));
                before = rise;
                dense = std::min(dense, rise);
            }
            const float exact = detail::least_rise(ground, detail::part_of(ground, ground.heights->parts()[0]), from, to);
            // Between two samples the surface rises by no more than what it does between any two.
            EXPECT_LE(exact, dense + 1e-4f) << "map " << map << ", line " << n;
            EXPECT_GE(exact, dense - step - 1e-4f) << "map " << map << ", line " << n;
            worst = std::max(worst, static_cast<double>(std::abs(exact - dense)));
            if (std::abs(dense) > step + 1e-3f) {
                EXPECT_EQ(exact <= 0.0f, dense <= 0.0f);
            }
            blocked += exact <= 0.0f ? 1 : 0;
        }
    }
    EXPECT_GT(blocked, lines / 10);
    EXPECT_LT(blocked, lines);
    figure("ground_lines/off_dense_samples", worst);
}

Wind over(const Shape& ground, float y = -4.3f) {
    Wind wind = made({.cells = {24, 14, 24}, .ambient = {6.0f, 0.0f, 1.0f}});
    EXPECT_TRUE(wind.obstacles().add({.position = {-30.0, static_cast<double>(y), -30.0}, .shape = ground}));
    return wind;
}

// Without exact lines level faces close: distances to the ground shrink by the steepest slope of the whole map.
TEST(GroundLines, ACliffOutsideOfTheBoxChangesNoBit) {
    Wind without = over(Ground{hills(1e9)}), with = over(Ground{hills(110.0)});
    for (int n = 0; n < sampled(60, 6); ++n) {
        without.step(1.0 / 30.0);
        with.step(1.0 / 30.0);
    }
    EXPECT_EQ(largest_apart(without.field(), with.field()), 0.0);
    EXPECT_GT(largest_off(with.field(), {6.0f, 0.0f, 1.0f}), 1.0);
}

using Face = std::tuple<int, int, int, int, float>;
std::set<Face> faces_of(const PlacedObstacle& body, const std::function<bool(glm::ivec3)>& counts) {
    const Box box{.cells = {48, 24, 24}, .cell_size = 1.0f};
    Solids solids(box, box.cells.x);
    solids.place(std::span(&body, 1));
    std::set<Face> found;
    for (const ClosedFace& face : solids.faces())
        if (counts({face.place[0], face.place[1], face.place[2]}))
            found.insert({face.place[0], face.place[1], face.place[2], face.axis, face.closed});
    return found;
}
std::set<Face> faces_over(const Ground& ground, const glm::mat3& axes, const std::function<bool(glm::ivec3)>& counts) {
    PlacedObstacle body;
    body.shape = ground;
    body.position = {-20.0f, 2.3f, -11.0f};
    body.axes = axes;
    return faces_of(body, counts);
}

TEST(GroundLines, ACliffInTheBoxChangesNoFaceTwoCellsAway) {
    const auto far = [](glm::ivec3 cell) { return cell.x < 28 - 2; };
    for (const float turned : {0.0f, 0.02f}) {
        const glm::mat3 axes(glm::mat3_cast(glm::angleAxis(turned, glm::vec3(0.0f, 0.0f, 1.0f))));
        const auto without = faces_over(Ground{hills(1e9)}, axes, far), with = faces_over(Ground{hills(50.0)}, axes, far);
        EXPECT_GT(without.size(), 1000u);
        EXPECT_EQ(without, with) << "turned by " << turned;
    }
}

// A ridge thinner than a cell between two centres closes the face, below its crest and not above.
TEST(GroundLines, ARidgeBetweenTwoCentresClosesFacesBelowItsCrest) {
    const auto ridge = heights_of({481, 241}, 0.25f, [](double x, double) { return std::abs(x - 30.0) < 0.2 ? 9.0 : 0.0; });
    const auto closed = faces_over(Ground{ridge}, glm::mat3(1.0f), [](glm::ivec3 cell) { return cell.x == 9; });
    int whole = 0;
    for (const auto& [x, y, z, axis, fraction] : closed)
        whole += axis == 0 && y > 3 && fraction == 1.0f ? 1 : 0;
    // From height 2.3 up to 11.3 the centres of rows 4 to 10 are below the crest.
    EXPECT_EQ(whole, 7 * 24);
}

// A search that follows the distance in 64 steps ends within a line that runs along a surface at a hundredth of its length.
TEST(ObstacleLines, AreBlockedWhereABodyIsAndNotBesideIt) {
    std::mt19937 chance(7);
    const auto part = [&](float from, float to) { return std::uniform_real_distribution<float>(from, to)(chance); };
    const Shape shapes[] = {Block{{2.0f, 1.0f, 3.0f}}, Cylinder{.radius = 1.5f, .half_length = 2.0f}, Sphere{2.0f},
                            Capsule{.half_axis = {0.5f, 1.5f, 0.2f}, .radius = 0.8f}};
    int blocked = 0, beside = 0;
    for (int n = 0; n < sampled(8'000, 800); ++n) {
        const Shape& shape = shapes[n % 4];
        // A place outside, as near as one ten thousandth or as far as one, and a line along the surface there or anywhere.
        glm::vec3 from(part(-4.0f, 4.0f), part(-4.0f, 4.0f), part(-4.0f, 4.0f));
        if (detail::distance_to(shape, from, 9.0f) < 0.1f)
            continue;
        const glm::vec3 out = detail::normal_at(shape, from, 1e-2f);
        from -= (detail::distance_to(shape, from, 9.0f) - std::pow(10.0f, part(-3.9f, 0.0f))) * out;
        glm::vec3 way(part(-1.0f, 1.0f), part(-1.0f, 1.0f), part(-1.0f, 1.0f));
        if (n % 8 < 4)
            way -= glm::dot(way, out) * out;
        const glm::vec3 to = from + glm::normalize(way);
        constexpr int k_samples = 2000;
        float dense = std::numeric_limits<float>::max();
        for (int i = 0; i <= k_samples; ++i)
            dense = std::min(dense, detail::distance_to(shape, glm::mix(from, to, static_cast<float>(i) / k_samples), 9.0f));
        const bool found = detail::blocks(shape, from, to);
        if (dense <= 0.5f * detail::k_touches) {
            EXPECT_TRUE(found) << n << ": it comes to " << dense;
            ++blocked;
        } else if (dense > 1.5f * detail::k_touches + (n % 8 < 4 ? 0.0f : 0.5f / k_samples)) {
            EXPECT_FALSE(found) << n << ": it stays " << dense << " away";
            beside += dense < 0.015f ? 1 : 0;
        }
    }
    EXPECT_GT(blocked, 50);
    EXPECT_GT(beside, 50);
    for (const Shape& shape : shapes) { // a line of no length, and one that is no line
        EXPECT_TRUE(detail::blocks(shape, glm::vec3(0.1f), glm::vec3(0.1f)));
        EXPECT_FALSE(detail::blocks(shape, glm::vec3(9.0f), glm::vec3(9.0f)));
        EXPECT_FALSE(detail::blocks(shape, glm::vec3(std::nanf("")), glm::vec3(9.0f)));
    }
}

// However near the centres of a row a roof or a wall is, the faces across it are closed by the part that is under it. They were
// closed whole from a sixtieth of a cell under the centres on.
TEST(ObstacleLines, ARowThatARoofCutsIsClosedByItsPart) {
    for (const float under : {0.02f, 1e-2f, 1e-3f, 3e-4f, 5e-5f, 1e-6f, 0.0f, -1e-6f, -1e-3f, -0.02f}) { // [cells] the centres
        std::vector<std::pair<const char*, PlacedObstacle>> bodies(5);
        const float roof = 10.5f - under;
        const glm::vec3 place(20.0f, roof - 4.0f, 12.0f);
        bodies[0] = {"block", {.shape = Block{{8.0f, 4.0f, 8.0f}}, .position = place}};
        bodies[1] = {"cylinder", {.shape = Cylinder{.radius = 9.0f, .half_length = 4.0f}, .position = place}};
        bodies[2] = {"ground", {.shape = Ground{heights_of({9, 9}, 8.0f, [&](double, double) { return double(roof); })}}};
        bodies[3] = {"mesh", {.shape = MeshShape{mesh_of(box_mesh({8.0f, 4.0f, 8.0f}))}, .position = place}};
        bodies[4] = {"turned block", bodies[0].second};
        std::get<Block>(bodies[4].second.shape).half_size = {8.0f, 8.0f, 4.0f};
        bodies[4].second.axes = glm::mat3({1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -1.0f}, {0.0f, 1.0f, 0.0f});
        for (const auto& [name, body] : bodies) {
            int across = 0;
            for (const auto& [x, y, z, axis, closed] : faces_of(body, [](glm::ivec3 cell) {
                     return cell.y == 10 && cell.x > 15 && cell.x < 24 && cell.z > 7 && cell.z < 16;
                 }))
                if (axis != 1) {
                    ++across;
                    EXPECT_NEAR(closed, 0.5f - under, 2e-3f) << name << " " << under << " at " << x << ", " << z;
                }
            EXPECT_EQ(across, 2 * 8 * 8) << name << " " << under;
        }
    }
}

// A plate closes the faces that it covers, in one plane, wherever it stands in a cell and however it is turned by right angles. Turned
// by 1.5707963 and in the middle of a cell it was a zigzag of faces: its force was a quarter more, with as much across the wind.
TEST(ObstacleLines, APlateClosesTheFacesThatItCovers) {
    for (int n = 0; n < 64; ++n) {
        const glm::vec3 off(0.125f * static_cast<float>(n % 8), 0.125f * static_cast<float>(n / 8 % 8),
                            0.125f * static_cast<float>(n * 5 % 8));
        for (const glm::vec3& about : {glm::vec3(0.0f, 1.0f, 0.0f), glm::vec3(0.0f, -1.0f, 0.0f), glm::vec3(1.0f, 0.0f, 0.0f)}) {
            PlacedObstacle plate;
            plate.shape = Plate{{2.0f, 3.0f}};
            plate.position = glm::vec3(20.0f, 10.0f, 12.0f) + off;
            plate.axes = glm::mat3(glm::mat3_cast(glm::angleAxis(1.5707963f, about)));
            std::set<std::pair<int, int>> planes; // axis and place along it
            const auto faces = faces_of(plate, [](glm::ivec3) { return true; });
            for (const auto& [x, y, z, axis, closed] : faces) {
                planes.insert({axis, axis == 0 ? x : axis == 1 ? y : z});
                EXPECT_EQ(closed, 1.0f);
            }
            EXPECT_EQ(planes.size(), 1u) << n;
            EXPECT_EQ(faces.size(), 24u) << n;
        }
    }
}

} // namespace
} // namespace windrow
