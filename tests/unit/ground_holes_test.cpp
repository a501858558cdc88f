// Holes in a ground (HoleMask): the parts of a map, what is drawn of them, and a wind through one.
#include "tests/tier.h"
#include "tests/unit/drawn_ground.h"

#include <functional>
#include <random>
#include <set>

namespace windrow {
namespace {

using namespace test;

HoleMask mask_of(glm::ivec2 cells, const std::function<bool(int x, int z)>& open) {
    HoleMask mask{.cells = cells};
    for (int z = 0; z < cells.y; ++z)
        for (int x = 0; x < cells.x; ++x)
            mask.open.push_back(open(x, z) ? 1 : 0);
    return mask;
}

bool says(const auto& result, const char* sentence) {
    return !result && result.error().find(sentence) != std::string::npos;
}

std::shared_ptr<const HeightMap> with_holes(const HeightMap& map, HoleMask holes) {
    HeightData data = map.data();
    data.holes = std::move(holes);
    return heights_of(std::move(data));
}

// The parts of a map are its cells, each once: those of the ground and those of the holes.
TEST(GroundHoles, PartsAreEachCellOnce) {
    std::mt19937 chance(5);
    const HeightMap level = HeightMap::level(); // 100 m a side
    for (int n = 0; n < sampled(400, 100); ++n) {
        const auto whole_number = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(chance); };
        const glm::ivec2 cells(whole_number(1, 9), whole_number(1, 9));
        const int of_ten = whole_number(0, 9);
        HeightData data = level.data();
        data.holes = mask_of(cells, [&](int, int) { return whole_number(0, 9) < of_ten; });
        const auto made = HeightMap::create(data);
        if (std::count(data.holes.open.begin(), data.holes.open.end(), 0) == 0) {
            EXPECT_TRUE(says(made, "is a hole everywhere"));
            continue;
        }
        ASSERT_TRUE(made) << made.error();
        std::vector<int> times(data.holes.open.size(), 0);
        for (const bool hole : {false, true})
            for (const HeightMap::Part& part : hole ? (*made)->holes() : (*made)->parts()) {
                const glm::ivec2 low = glm::round(part.low / 100.0f * glm::vec2(cells)),
                                 high = glm::round(part.high / 100.0f * glm::vec2(cells));
                for (int z = low.y; z < high.y; ++z)
                    for (int x = low.x; x < high.x; ++x) {
                        EXPECT_EQ(data.holes.open[static_cast<std::size_t>(z * cells.x + x)], hole ? 1 : 0);
                        ++times[static_cast<std::size_t>(z * cells.x + x)];
                    }
            }
        EXPECT_EQ(times, std::vector<int>(times.size(), 1));
    }
    const std::tuple<HoleMask, const char*> faults[] = {
        {{.cells = {3, 3}, .open = std::vector<std::uint8_t>(8)}, "holes.open has 8 values: give 9"},
        {{.cells = {0, 3}}, "heightmap.holes.cells is (0, 3)"},
        {{.cells = {20000, 1}, .open = std::vector<std::uint8_t>(20000)}, "heightmap.holes.cells is (20000, 1)"},
        {mask_of({99, 99}, [](int x, int z) { return (x + z) % 2 == 0; }), "cuts the ground into more than 256 rectangles"}};
    for (const auto& [mask, sentence] : faults) {
        HeightData data = level.data();
        data.holes = mask;
        EXPECT_TRUE(says(HeightMap::create(data), sentence));
    }
    const auto one = with_holes(level, mask_of({4, 4}, [](int x, int z) { return x == z; }));
    EXPECT_EQ(*one, *with_holes(level, mask_of({4, 4}, [](int x, int z) { return x == z; })));
    EXPECT_NE(*one, level);
    EXPECT_NE(*one, *with_holes(level, mask_of({4, 4}, [](int x, int z) { return x == z && x > 0; })));
    EXPECT_NE(*one, *with_holes(level, mask_of({8, 8}, [](int x, int z) { return x / 2 == z / 2; })));
}

// Level faces below the ground are closed by what the hole leaves of them, wherever its edges cut the cells; over and in it none is.
TEST(GroundHoles, CloseWhatTheyLeaveOfEachFace) {
    std::mt19937 chance(7);
    double worst = 0.0, at_corners = 0.0;
    for (int n = 0; n < sampled(60, 20); ++n) {
        const auto part = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(chance); };
        // Cells of 3.2 m by 2.6 m of a map of 16 x 13 m that goes on, or of 64 m by 52 m that ends outside of the box.
        const bool ends = n % 2 == 0;
        PlacedObstacle body;
        const auto map = with_holes(*heights_of({3, 3}, ends ? 32.0f : 8.0f, [](double, double) { return 6.5; }),
                                    mask_of({ends ? 20 : 5, ends ? 20 : 5}, [&](int x, int z) {
                                        return ends ? x == 9 && z == 10 : (x == 1 || x == 2) && z == 2;
                                    }));
        const float scale = ends ? 1.0f : 13.0f / 16.0f;
        body.shape = Ground{map, {1.0f, 1.0f, scale}, ends ? Beyond::nothing : Beyond::edge};
        body.position = ends ? glm::vec3(part(-16.0f, -14.0f), 0.0f, part(-19.0f, -17.0f))
                             : glm::vec3(part(6.0f, 9.0f), 0.0f, part(5.0f, 9.0f));
        const glm::vec2 cell = ends ? glm::vec2(3.2f, 3.2f) : glm::vec2(3.2f, 3.2f * scale);
        const glm::vec2 low = glm::vec2(body.position.x, body.position.z) + cell * (ends ? glm::vec2(9, 10) : glm::vec2(1, 2)),
                        high = low + cell * (ends ? glm::vec2(1.0f) : glm::vec2(2, 1));
        if (n % 3 == 0) // no tile of a surface
            body.axes = glm::mat3(glm::mat3_cast(glm::angleAxis(1e-6f, glm::vec3(1.0f, 0.0f, 0.0f))));
        const Drawn drawn = drawn_from(std::vector{body});
        for (int y = 0; y < 3; ++y)
            for (int z = 0; z < 28; ++z)
                for (int x = 0; x < 32; ++x) {
                    const glm::vec2 from(x, z), to = from + 1.0f;
                    const glm::vec2 within = glm::max(glm::min(to, high) - glm::max(from, low), 0.0f);
                    const double closed = 1.0 - static_cast<double>(within.x) * static_cast<double>(within.y);
                    if (within.x * within.y == 0.0f) {
                        EXPECT_TRUE(drawn.inside.contains(static_cast<std::uint32_t>(box_of().index(x, y, z))));
                        continue;
                    }
                    const double off = std::abs(closed - static_cast<double>(drawn.closed({x, y, z, 1})));
                    const auto is_near = [](float at, float edge) { return at >= edge - 2.0f && at <= edge + 1.0f; };
                    const bool corner = (is_near(from.x, low.x) || is_near(from.x, high.x)) &&
                                        (is_near(from.y, low.y) || is_near(from.y, high.y));
                    (corner ? at_corners : worst) = std::max(corner ? at_corners : worst, off);
                }
    }
    figure("ground_holes/level_faces", worst);
    figure("ground_holes/level_faces_at_corners", at_corners);
    EXPECT_LE(worst, 2e-3);
    EXPECT_LE(at_corners, 0.3); // distances are round beside an edge, of a block's too
}

// Random masks over hills, that go on or end, turned about the upright axis: as tiles or as a body by itself they are the same, and a box
// that moves has what a drawing from the start has.
TEST(GroundHoles, AreTheSameHoweverTheyAreDrawn) {
    double worst = 0.0;
    for (int story = 0; story < sampled(60, k_sanitized ? 2 : 8); ++story) {
        std::mt19937 chance(static_cast<unsigned>(story));
        const auto whole_number = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(chance); };
        PlacedObstacle body = whole();
        const Ground& hills = std::get<Ground>(body.shape);
        const auto level = heights_of({2, 2}, 128.0f, [](double, double) { return 5.3; });
        body.shape = Ground{with_holes(story % 2 == 0 ? *hills.heights : *level,
                                       mask_of({32, 30}, [&](int, int) { return whole_number(0, 9) == 0; })),
                            glm::vec3(1.0f), story % 4 < 2 ? Beyond::edge : Beyond::nothing};
        std::vector<PlacedObstacle> bodies{body};
        turn(bodies, story % 3 == 0 ? 0.1f * static_cast<float>(story) : 0.0f, {16.0f, 0.0f, 14.0f});
        bodies[0].position += glm::vec3(0.37f, 0.11f, 0.21f);
        if (story % 2 == 1) {
            std::vector<PlacedObstacle> other = bodies;
            other[0].axes = glm::mat3(glm::mat3_cast(glm::angleAxis(1e-7f, glm::vec3(1.0f, 0.0f, 0.0f)))) * bodies[0].axes;
            ASSERT_FALSE(TiledGround::is_upright_ground(other[0]));
            const Drawn a = drawn_from(bodies), b = drawn_from(other);
            worst = std::max(worst, apart(a, b));
            std::vector<std::uint32_t> differ;
            std::set_symmetric_difference(a.inside.begin(), a.inside.end(), b.inside.begin(), b.inside.end(),
                                          std::back_inserter(differ));
            const auto row = static_cast<std::uint32_t>(box_of().cells.x),
                       plane = row * static_cast<std::uint32_t>(box_of().cells.y);
            std::set<std::uint32_t> columns; // one whose centres are on an edge is inside by rounding
            for (const std::uint32_t cell : differ)
                columns.insert(cell / plane * row + cell % row);
            EXPECT_LE(columns.size(), 1u) << story;
        }
        Solids solids(box_of(), box_of().cells.x);
        solids.place(bodies);
        for (int n = 0; n < 4; ++n) {
            const glm::ivec3 shift(whole_number(-3, 3), 0, whole_number(-2, 2));
            bodies[0].position -= glm::vec3(shift);
            solids.place(bodies, shift);
            EXPECT_LE(apart(drawn_by(solids), drawn_from(bodies)), 2e-3) << story << ", " << n;
        }
    }
    figure("ground_holes/drawn_otherwise", worst);
    EXPECT_LE(worst, 3e-3); // a face is closed whole or in part by whether the line between two centres touches
}

// A tile that covers a hole of another one closes it, as level with it or higher.
TEST(GroundHoles, ATileOverAHoleClosesIt) {
    const auto tile = [](std::shared_ptr<const HeightMap> heights, glm::vec3 at) {
        PlacedObstacle body;
        body.shape = Ground{std::move(heights), glm::vec3(1.0f), Beyond::nothing};
        body.position = at;
        return body;
    };
    const auto level = [](float size, double height) { return heights_of({2, 2}, size, [=](double, double) { return height; }); };
    const auto holed = with_holes(*level(64.0f, 5.2), mask_of({16, 16}, [](int x, int z) { return x == 8 && z == 8; }));
    for (const float shift : {0.0f, 0.3f, 0.5f})
        for (const double lift : {0.0, 1.0}) {
            const glm::vec3 low(shift - 16.0f, 0.0f, shift - 18.0f), of_hole = low + glm::vec3(32.0f, 0.0f, 32.0f);
            const PlacedObstacle plug = tile(level(4.0f, 5.2 + lift), of_hole);
            const Drawn plugged = drawn_from(std::vector{tile(holed, low), plug}),
                        wanted = drawn_from(std::vector{tile(level(64.0f, 5.2), low), plug});
            EXPECT_EQ(plugged.faces, wanted.faces) << shift << ", " << lift;
            EXPECT_EQ(plugged.inside, wanted.inside) << shift << ", " << lift;
        }
}

// A rampart with a gate: a level tile with a hole, under a lintel, is the two blocks beside it.
TEST(GroundHoles, AWindThroughAGateIsThatBetweenBlocks) {
    PlacedObstacle rampart, left, right, lintel;
    rampart.shape = Ground{with_holes(*heights_of({2, 33}, 4.0f, [](double, double) { return 8.0; }),
                                      mask_of({1, 32}, [](int, int z) { return z == 19; })),
                           glm::vec3(1.0f), Beyond::nothing};
    rampart.position = {14.0f, 0.0f, -64.0f};
    left.shape = right.shape = Block{{2.0f, 54.0f, 38.0f}};
    left.position = {16.0f, 8.0f - 54.0f, 12.0f - 38.0f};
    right.position = {16.0f, 8.0f - 54.0f, 16.0f + 38.0f};
    lintel.shape = Block{{2.0f, 2.0f, 2.0f}};
    lintel.position = {16.0f, 6.0f, 14.0f};
    Wind one = wind_over(std::vector{rampart, lintel}), two = wind_over(std::vector{left, right, lintel});
    for (int n = 0; n < 60; ++n) {
        one.step(1.0 / 30.0);
        two.step(1.0 / 30.0);
    }
    const double apart = largest_apart(one.field(), two.field()) / glm::length(glm::dvec2(6.0, 1.5));
    figure("ground_holes/gate_of_blocks", apart);
    EXPECT_LE(apart, 1e-3);
    const auto through = [](const Wind& wind) { return wind.view().velocity(wind.origin() + glm::dvec3(16.0, 1.5, 14.0)).x; };
    EXPECT_GT(through(one), 3.0f);
    EXPECT_NEAR(through(one), through(two), 1e-2);
}

} // namespace
} // namespace windrow
