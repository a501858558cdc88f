// Grounds that end, and tiles of one surface (fluid/solids/tiled_ground.h).
#include "fluid/solids/together.h"
#include "tests/tier.h"
#include "tests/unit/drawn_ground.h"

#include <random>

namespace windrow {
namespace {

using namespace test;

// Drawn one by one, with their closed parts added, faces across a seam are wrong by up to the whole of a face.
TEST(TiledGround, FourTilesAreOneMapToTheBit) {
    const Drawn one = drawn_from(std::vector{whole()});
    ASSERT_GT(one.faces.size(), 1500u);
    for (const glm::vec2 seam :
         {glm::vec2(16.0f, 14.0f), glm::vec2(16.5f, 14.0f), glm::vec2(9.0f, 13.5f), glm::vec2(12.5f, 7.5f)}) {
        std::vector<PlacedObstacle> tiles = quarters(seam);
        for (int order = 0; order < 4; ++order) {
            const Drawn four = drawn_from(tiles);
            EXPECT_EQ(four.faces, one.faces) << "seam at " << seam.x << ", " << seam.y;
            EXPECT_EQ(four.inside, one.inside);
            std::rotate(tiles.begin(), tiles.begin() + 1, tiles.end());
        }
        EXPECT_EQ(drawn_from(tiles).normals.size(), one.normals.size());
    }
}

// Seams that are at no whole part of a cell, and tiles turned about the upright axis. The place of each body is rounded to 1/4096 of a
// cell, and a face between air and air is closed or not by whether the crest of the ground touches the line between their centres; so
// the tiles may have a face as the one map has it where it is moved by twice that.
TEST(TiledGround, FourTilesAreOneMapWhereverTheSeamIs) {
    std::mt19937 chance(3);
    double worst = 0.0;
    int thresholds = 0;
    std::size_t drawn = 0;
    for (int n = 0; n < sampled(200, 40); ++n) {
        const auto part = [&](float most) { return std::uniform_real_distribution<float>(0.0f, most)(chance); };
        const float parts[] = {part(1.0f), part(1.0f), part(1.0f), part(8.0f), part(12.0f), part(6.3f)}; // in this order
        std::vector<PlacedObstacle> one{whole()},
            four = quarters({12.0f + 0.5f * std::floor(parts[3]), 10.0f + 0.5f * std::floor(parts[4])});
        for (auto* bodies : {&one, &four}) {
            turn(*bodies, n % 2 == 0 ? 0.0f : parts[5], {16.0f, 0.0f, 14.0f});
            for (PlacedObstacle& body : *bodies)
                body.position += glm::vec3(parts[0], parts[1], parts[2]);
        }
        const Drawn tiles = drawn_from(four);
        std::vector<Drawn> maps{drawn_from(one)};
        drawn += maps[0].faces.size();
        if (apart(maps[0], tiles) > 3e-3)
            for (int move = 0; move < 6; ++move) {
                std::vector<PlacedObstacle> moved = one;
                moved[0].position[move / 2] += (move % 2 == 0 ? 1.0f : -1.0f) / 2048.0f;
                maps.push_back(drawn_from(moved));
            }
        std::set<FaceName> names;
        for (const Drawn* const which : std::array<const Drawn*, 2>{&tiles, &maps[0]})
            for (const auto& face : which->faces)
                names.insert(face.first);
        for (const FaceName& name : names) {
            float low = 1.0f, high = 0.0f;
            for (const Drawn& map : maps) {
                low = std::min(low, map.closed(name));
                high = std::max(high, map.closed(name));
            }
            thresholds += high - low > 0.02f ? 1 : 0;
            worst = std::max({worst, double(low - tiles.closed(name)), double(tiles.closed(name) - high)});
        }
    }
    figure("tiled_ground/off_one_map", worst);
    EXPECT_LE(worst, 2e-3); // 6 / 4096: the slope of the cliff times what places are rounded to
    EXPECT_LE(thresholds, drawn / 10'000);
}

// A level tile and a block of the same size, whose distances are the same. A block has sharp edges (fluid/solids/edges.h), ground has
// none: faces beside them are left out.
TEST(TiledGround, ATileEndsAsABlock) {
    for (const float shift : {0.0f, 0.3f, 0.5f, 0.8f}) {
        PlacedObstacle tile, block;
        tile.shape = Ground{heights_of({9, 13}, 1.0f, [](double, double) { return 4.3; }), glm::vec3(1.0f), Beyond::nothing};
        tile.position = {9.0f + shift, 0.0f, 7.0f + 0.5f * shift};
        block.shape = Block{{4.0f, 50.0f, 6.0f}};
        block.position = tile.position + glm::vec3(4.0f, 4.3f - 50.0f, 6.0f);
        const auto drawn = [&](const PlacedObstacle& body) {
            Together edges;
            edges.begin(block, 1.0f, 3.0f);
            edges.end();
            const auto is_at_edge = [&](glm::vec3 cell) {
                return edges.edges_at(cell + 0.5f - block.position, glm::vec3(1.0f)) != glm::vec3(0.0f);
            };
            Drawn result = drawn_from(std::vector{body});
            std::erase_if(result.faces, [&](const auto& face) {
                const auto [x, y, z, axis] = face.first;
                glm::vec3 cell(x, y, z), next = cell;
                next[axis] += 1.0f;
                return is_at_edge(cell) || is_at_edge(next);
            });
            EXPECT_GT(result.faces.size(), 100u);
            return result;
        };
        const Drawn a = drawn(tile), b = drawn(block);
        EXPECT_LE(apart(a, b), 2e-4) << shift; // the height over it is not the distance beside its edge
        EXPECT_EQ(a.inside, b.inside);
        // Turned about a level axis by nothing to speak of it is no tile, and ends as well.
        tile.axes = glm::mat3(glm::mat3_cast(glm::angleAxis(1e-6f, glm::vec3(1.0f, 0.0f, 0.0f))));
        EXPECT_LE(apart(drawn(tile), b), 2e-4) << shift;
    }
}

TEST(TiledGround, WhereTilesOverlapTheHigherCounts) {
    // A finer tile, half a metre higher, over a coarse one: as one map that has the step.
    const auto step = [](double x, double z) { return x >= 10.0 && x <= 18.0 && z >= 8.0 && z <= 16.0 ? 5.5 : 5.0; };
    PlacedObstacle fine, coarse, one;
    fine.shape = Ground{heights_of({17, 17}, 0.5f, [](double, double) { return 5.5; }), glm::vec3(1.0f), Beyond::nothing};
    fine.position = {10.0f, 0.0f, 8.0f};
    coarse.shape = Ground{heights_of({3, 3}, 64.0f, [](double, double) { return 5.0; }), glm::vec3(1.0f), Beyond::nothing};
    coarse.position = {-48.0f, 0.0f, -50.0f};
    one.shape = Ground{heights_of({1025, 1025}, 0.125f, [&](double x, double z) { return step(x - 48.0, z - 50.0); })};
    one.position = coarse.position;
    const Drawn both = drawn_from(std::vector{fine, coarse}), mapped = drawn_from(std::vector{one});
    EXPECT_LE(apart(both, mapped), 0.15); // the map's step is a slope of an eighth of a metre
    EXPECT_EQ(both.inside, mapped.inside);
    EXPECT_EQ(drawn_from(std::vector{coarse, fine}).faces, both.faces);
    // The height over the ground, which rough ground asks for, is that over both.
    const Box box = box_of();
    Solids solids(box, box.cells.x);
    solids.place(std::vector{fine, coarse});
    for (const std::size_t body : {0u, 1u}) {
        EXPECT_FLOAT_EQ(solids.height_over(body, {13, 7, 11}), 7.5f - 5.5f);
        EXPECT_FLOAT_EQ(solids.height_over(1, {5, 7, 11}), 7.5f - 5.0f);
    }
}

// A map whose edges lie in the box goes on as on them.
TEST(TiledGround, BeyondAnEdgeThatGoesOnIsTheEdge) {
    const auto clamped = [](double x, double z) { return height(std::clamp(x, 6.0, 22.0), std::clamp(z, 5.0, 19.0)); };
    PlacedObstacle part, all;
    part.shape = Ground{heights_of({33, 29}, 0.5f, [&](double x, double z) { return clamped(x + 6.0, z + 5.0); })};
    part.position = {6.0f, 0.0f, 5.0f};
    all.shape = Ground{heights_of({129, 129}, 0.5f, [&](double x, double z) { return clamped(x - 16.0, z - 16.0); })};
    all.position = {-16.0f, 0.0f, -16.0f};
    const Drawn a = drawn_from(std::vector{part}), b = drawn_from(std::vector{all});
    EXPECT_EQ(a.faces, b.faces);
    EXPECT_EQ(a.inside, b.inside);
}

// Gaps: two tiles with a missing one between them are two blocks, and the air between them reaches the floor of the box.
TEST(TiledGround, AMissingTileIsAGapWithWalls) {
    std::vector<PlacedObstacle> tiles = quarters({16.0f, 14.0f});
    tiles.erase(tiles.begin() + 3);
    const Drawn drawn = drawn_from(tiles);
    for (int y = 0; y < 3; ++y) {
        EXPECT_EQ(drawn.faces.at({15, y, 20, 0}), 1.0f);
        EXPECT_EQ(drawn.faces.at({20, y, 13, 2}), 1.0f);
        EXPECT_FALSE(drawn.faces.contains({20, y, 20, 0}));
        EXPECT_FALSE(drawn.inside.contains(static_cast<std::uint32_t>(box_of().index(20, y, 20))));
    }
}

// A tile as wide as a periodic box is ground everywhere: it ends nowhere.
TEST(TiledGround, GoesOnAcrossPeriodicEnds) {
    Boundaries boundaries = Boundaries::open_over_floor();
    boundaries.x_low = boundaries.x_high = boundaries.z_low = boundaries.z_high = Boundary{BoundaryKind::periodic};
    const auto level = [](double, double) { return 5.25; };
    PlacedObstacle tile, whole;
    tile.shape = Ground{heights_of({33, 29}, 1.0f, level), glm::vec3(1.0f), Beyond::nothing};
    whole.shape = Ground{heights_of({3, 3}, 1.0f, level)};
    for (const float shift : {0.0f, 0.5f, 7.25f}) {
        tile.position = {shift, 0.0f, 0.5f * shift};
        const Drawn a = drawn_from(std::vector{tile}, box_of(boundaries)), b = drawn_from(std::vector{whole}, box_of(boundaries));
        EXPECT_EQ(a.faces, b.faces) << shift;
        EXPECT_EQ(a.inside, b.inside) << shift;
    }
}

// Drawings are kept: those of a surface that changes while it stands equal those that are made at once.
TEST(TiledGround, ComingAndGoingLeavesWhatADrawingFromTheStartHas) {
    const std::vector<PlacedObstacle> tiles = quarters({16.5f, 13.5f});
    Solids solids(box_of(), box_of().cells.x);
    const auto place = [&](std::vector<PlacedObstacle> bodies) {
        solids.place(bodies);
        const Drawn now = drawn_by(solids), fresh = drawn_from(bodies);
        EXPECT_EQ(now.faces, fresh.faces);
        EXPECT_EQ(now.inside, fresh.inside);
        EXPECT_EQ(now.normals, fresh.normals);
        EXPECT_EQ(now.near, fresh.near);
        return solids.drawn();
    };
    EXPECT_EQ(place({tiles[0], tiles[1], tiles[2]}), 3);
    EXPECT_EQ(place(tiles), 1); // of the others the columns beside it are drawn
    EXPECT_EQ(place(tiles), 0);
    EXPECT_EQ(place({tiles[1], tiles[2], tiles[3]}), 0);
    auto raised = tiles;
    raised[1] = part_of_hills({16.5f, -64.0f}, {64.0f, 13.5f}, Beyond::nothing, 0.75);
    place(raised);
    auto moving = tiles;
    moving[2].velocity = {0.0f, 0.0f, 1.0f}; // no tile of the surface while it moves
    place(moving);
    place(tiles);
    std::vector<PlacedObstacle> row;
    for (const float x : {-8.0f, 0.0f, 8.0f, 16.0f, 24.0f})
        row.push_back(part_of_hills({x, 4.0f}, {x + 8.0f, 20.0f}));
    place({row[0], row[1], row[2], row[3]});
    EXPECT_EQ(place(row), 1);
    // A finer one over them, and gone again.
    row.push_back(part_of_hills({10.5f, 6.0f}, {18.0f, 13.0f}, Beyond::nothing, 0.5));
    EXPECT_EQ(place(row), 1);
    row.pop_back();
    EXPECT_EQ(place(row), 0);
}

// A box that moves draws the columns that come into reach, and has what a drawing from the start has.
TEST(TiledGround, ABoxThatMovesDrawsWhatComesIntoReach) {
    std::mt19937 chance(11);
    for (const bool tiled : {false, true}) {
        Solids solids(box_of(), box_of().cells.x);
        std::vector<PlacedObstacle> bodies = tiled ? quarters({16.5f, 13.5f}) : std::vector{whole()};
        solids.place(bodies);
        int drawn = 0;
        for (int n = 0; n < sampled(60, 16); ++n) {
            const auto cells = [&](int most) { return std::uniform_int_distribution<int>(-most, most)(chance); };
            const glm::ivec3 shift = n % 8 == 7 ? glm::ivec3(0, cells(1), 0) : glm::ivec3(cells(3), 0, cells(2));
            for (PlacedObstacle& body : bodies)
                body.position -= glm::vec3(shift);
            solids.place(bodies, shift);
            drawn += solids.drawn();
            const Drawn fresh = drawn_from(bodies), now = drawn_by(solids);
            EXPECT_EQ(now.faces, fresh.faces) << n;
            EXPECT_EQ(now.inside, fresh.inside) << n;
            EXPECT_EQ(now.normals, fresh.normals) << n;
            EXPECT_EQ(now.near, fresh.near) << n;
        }
        EXPECT_EQ(drawn, 0);
    }
}

// Tiles of any size and turn, down to a third of a cell, with gaps and overlaps, in boxes that move or are periodic: what is kept and
// drawn in part equals what is drawn at once.
TEST(TiledGround, AnyTilesThatComeAndGoLeaveWhatADrawingFromTheStartHas) {
    for (int story = 0; story < sampled(300, k_sanitized ? 5 : 40); ++story) {
        std::mt19937 chance(static_cast<unsigned>(story));
        const auto part = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(chance); };
        const auto whole_number = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(chance); };
        const bool periodic = story % 5 == 4;
        Boundaries boundaries;
        if (periodic) {
            boundaries = Boundaries::open_over_floor();
            boundaries.x_low = boundaries.x_high = Boundary{BoundaryKind::periodic};
        }
        const Box box = box_of(boundaries);
        const float yaw = story % 3 == 0 ? part(0.0f, 6.3f) : 0.0f;
        const glm::mat3 turned(glm::mat3_cast(glm::angleAxis(yaw, glm::vec3(0.0f, 1.0f, 0.0f))));
        std::vector<PlacedObstacle> all;
        for (int n = whole_number(1, 6); n > 0; --n) {
            PlacedObstacle tile;
            const float width = part(0.3f, 18.0f), height = part(3.0f, 9.0f), slope = part(-0.3f, 0.3f);
            const glm::ivec2 corners(std::max(2, static_cast<int>(width) + 1), whole_number(2, 18));
            const auto heights = heights_of(corners, 1.0f, [=](double x, double z) {
                return static_cast<double>(height) + static_cast<double>(slope) * x + 0.4 * std::sin(x + z);
            });
            tile.shape = Ground{heights, {width / static_cast<float>(corners.x - 1), 1.0f, part(0.5f, 1.5f)}, Beyond::nothing};
            tile.position = {part(-8.0f, 32.0f), part(-1.0f, 1.0f), part(-8.0f, 28.0f)};
            tile.axes = whole_number(0, 3) == 0 ? glm::mat3(1.0f) : turned;
            tile.slot = static_cast<std::uint32_t>(n);
            all.push_back(tile);
        }
        Solids solids(box, box.cells.x);
        solids.place(all);
        for (int n = 0; n < 8; ++n) {
            const glm::ivec3 shift =
                periodic ? glm::ivec3(0) : glm::ivec3(whole_number(-3, 3), whole_number(-4, 1) / 4, whole_number(-2, 2));
            for (PlacedObstacle& tile : all)
                tile.position -= glm::vec3(shift);
            std::vector<PlacedObstacle> now;
            std::copy_if(all.begin(), all.end(), std::back_inserter(now), [&](const auto&) { return whole_number(0, 4) > 0; });
            std::shuffle(now.begin(), now.end(), chance);
            solids.place(now, shift);
            const Drawn kept = drawn_by(solids), fresh = drawn_from(now, box);
            EXPECT_LE(apart(kept, fresh), 2e-3) << story << ", " << n; // places are rounded anew
            EXPECT_EQ(kept.inside, fresh.inside) << story << ", " << n;
            EXPECT_EQ(kept.near.size(), fresh.near.size()) << story << ", " << n;
        }
    }
}

// A tile thinner than a cell is a wall: tight by itself, whatever stands near it.
TEST(TiledGround, AThinTileIsTight) {
    for (const bool with_another : {false, true}) {
        std::vector<PlacedObstacle> tiles(1);
        tiles[0].shape =
            Ground{heights_of({2, 40}, 1.0f, [](double, double) { return 30.0; }), {0.4f, 1.0f, 1.0f}, Beyond::nothing};
        tiles[0].position = {15.3f, 0.0f, -5.0f};
        if (with_another)
            tiles.push_back(part_of_hills({19.0f, 4.0f}, {25.0f, 20.0f}));
        const Drawn drawn = drawn_from(tiles);
        for (int y = 0; y < 20; ++y)
            for (int z = 0; z < 28; ++z)
                EXPECT_EQ(std::max(drawn.faces.at({14, y, z, 0}), drawn.faces.at({15, y, z, 0})), 1.0f) << with_another;
    }
}

// --- Winds -------------------------------------------------------------------------------------------------------------------

// The faces have the same bits; a normal has the rounding of its place from its own tile's middle.
TEST(TiledGround, AWindOverTilesIsThatOverTheMap) {
    Wind one = wind_over(std::vector{whole()}), four = wind_over(quarters({16.0f, 14.0f}));
    for (int n = 0; n < sampled(60, 12); ++n) {
        for (Wind* wind : {&one, &four})
            if (n == 6) {
                ASSERT_TRUE(wind->follow(wind->origin() + glm::dvec3(wind->box().size()) * 0.5 + glm::dvec3(3.0, 0.0, 2.0)));
            }
        one.step(1.0 / 30.0);
        four.step(1.0 / 30.0);
    }
    // Heights of 10 m are rounded to 1e-6 m, so normals over .2 m to 5e-6; the lee lets that grow fivefold in two seconds.
    const double apart = largest_apart(one.field(), four.field()) / glm::length(glm::dvec2(6.0, 1.5));
    figure("tiled_ground/wind_off_one_map", apart);
    EXPECT_LE(apart, test::whole_sweeps() ? 1e-4 : 1.6e-5);
    // Where plants stand: beside the surface, across the seams.
    for (double x = 12.0; x < 20.0; x += 0.37) {
        const glm::dvec3 place(x, height(x, x - 2.0) + 0.1, x - 2.0);
        const auto sampled = [&](const Wind& wind) {
            const glm::dvec3 at = place + glm::dvec3(-16.0, 0.0, -14.0);
            return wind.view().velocity(at);
        };
        EXPECT_LE(glm::distance(sampled(one), sampled(four)), 1e-3f) << x;
        EXPECT_GT(glm::length(sampled(four)), 2.0f) << x;
    }
    EXPECT_GT(largest_off(four.field(), {6.0f, 0.0f, 1.5f}), 1.0);
}

// A surface is as thick as it is, however small its tiles are: reads beside it pass or stop as those beside the one map do, and a wall of
// tiles is tight. Where each tile is as thin as itself, the wind is .2 of itself off beside a plateau in tiles of 2 m, .74 beside a wall
// of .6 m in tiles of .3 m.
TEST(TiledGround, SmallTilesAreOneSurface) {
    const auto surface = [](glm::vec2 size, glm::ivec2 tiles, float shift) {
        std::vector<PlacedObstacle> all;
        const glm::vec2 tile = size / glm::vec2(tiles);
        const auto heights = heights_of({2, 2}, 1.0f, [](double, double) { return 4.3; });
        for (int z = 0; z < tiles.y; ++z)
            for (int x = 0; x < tiles.x; ++x) {
                PlacedObstacle one;
                one.shape = Ground{heights, {tile.x, 1.0f, tile.y}, Beyond::nothing};
                one.position = {14.0f + shift + static_cast<float>(x) * tile.x, 0.0f,
                                9.0f + 0.5f * shift + static_cast<float>(z) * tile.y};
                one.slot = static_cast<std::uint32_t>(all.size());
                all.push_back(one);
            }
        return all;
    };
    struct Case {
        glm::vec2 size;
        glm::ivec2 tiles;
    };
    double worst_face = 0.0, worst_wind = 0.0;
    for (const auto& [size, tiles] :
         {Case{{4.0f, 4.0f}, {2, 2}}, Case{{7.5f, 7.5f}, {12, 12}}, Case{{1.0f, 12.0f}, {1, 12}}, Case{{0.6f, 12.0f}, {2, 20}}})
        for (const float shift : {0.0f, 0.31f, 0.77f}) {
            const auto one = surface(size, {1, 1}, shift), many = surface(size, tiles, shift);
            const Drawn a = drawn_from(one), b = drawn_from(many);
            worst_face = std::max(worst_face, apart(a, b));
            EXPECT_EQ(a.inside, b.inside) << size.x << ", " << tiles.x << ", " << shift;
            Wind of_one = wind_over(one), of_many = wind_over(many);
            for (int n = 0; n < 12; ++n) {
                of_one.step(1.0 / 60.0);
                of_many.step(1.0 / 60.0);
            }
            worst_wind = std::max(worst_wind, largest_apart(of_one.field(), of_many.field()) / 6.0);
        }
    figure("tiled_ground/small_tiles_off_one_map", worst_face);
    figure("tiled_ground/wind_over_small_tiles", worst_wind);
    EXPECT_LE(worst_face, 3e-3); // places of bodies are rounded to a fourth of 1e-3
    EXPECT_LE(worst_wind, 3e-3);
}

} // namespace
} // namespace windrow
