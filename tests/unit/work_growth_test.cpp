// Work without a bound: what is read takes at most 6.25 times as long where it is four times as large, in the family of each kind that
// takes longest. What no algorithm makes cheap is rejected by a sentence.
#include "fluid/core/message.h"
#include "scene/height_files.h"
#include "scene/obj_file.h"
#include "scene/vox_file.h"
#include "tests/shapes.h"
#include "tests/tier.h"
#include "tests/unit/vox_parts.h"
#include "tests/winds.h"

#include <ctime>

namespace windrow::scene {
namespace {

using test::box_mesh, test::both;

// [s] Of the processor, the least of several runs.
double seconds(const std::function<void()>& work) {
    double least = 1e9, sum = 0.0;
    for (int run = 0; run < 5 && sum < 0.3; ++run) {
        const std::clock_t begin = std::clock();
        work();
        const double now = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        least = std::min(least, now);
        sum += now;
    }
    return least;
}

/// Whether 4 n takes more than 6.25 times as long as n: 2.5 for each doubling, where a square takes 16. work(n) returns what is timed.
bool grows(int n, const std::function<std::function<void()>(int)>& work) {
    constexpr double k_most = 2.5 * 2.5, k_noise = 1.2e-3; // below a millisecond a clock shows noise
    return seconds(work(4 * n)) > k_most * std::max(seconds(work(n)), k_noise);
}

/// A busy machine may break one measurement; what grows as the square breaks them all.
void expect_even_growth(const char* name, int n, const std::function<std::function<void()>(int)>& work) {
    if (test::k_sanitized)
        return (void)grows(n / 8, work);
    for (int attempt = 0; attempt < 4; ++attempt)
        if (!grows(n, work))
            return;
    ADD_FAILURE() << name << " of " << 4 * n << " takes more than 6.25 times as long as of a quarter as many";
}

// --- Meshes ------------------------------------------------------------------------------------------------------------------

/// A cylinder of so many sides: two fans, and sides as long as it is high.
MeshData cylinder(int sides, float height) {
    MeshData data;
    for (int end = 0; end < 2; ++end)
        for (int n = 0; n < sides; ++n) {
            const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(n) / static_cast<float>(sides);
            data.vertices.emplace_back(std::cos(angle), height * static_cast<float>(end), std::sin(angle));
        }
    const auto count = static_cast<glm::uint>(sides);
    for (glm::uint n = 0; n < count; ++n) {
        const glm::uint next = (n + 1) % count;
        data.triangles.insert(data.triangles.end(), {{n, count + n, count + next}, {n, count + next, next}});
        if (n > 0 && next > 0)
            data.triangles.insert(data.triangles.end(), {{0, n, next}, {count, count + next, count + n}});
    }
    return data;
}

/// A cube whose faces are strips from edge to edge.
MeshData strips(int count) {
    MeshData data;
    const auto columns = static_cast<glm::uint>(count) + 1;
    for (int row = 0; row < 4; ++row)
        for (glm::uint n = 0; n < columns; ++n)
            data.vertices.emplace_back(static_cast<float>(n) / static_cast<float>(count), row == 1 || row == 2, row >= 2);
    const auto corner = [&](glm::uint row, glm::uint n) { return row % 4 * columns + n; };
    for (glm::uint row = 0; row < 4; ++row)
        for (glm::uint n = 0; n + 1 < columns; ++n) {
            const glm::uint a = corner(row, n), b = corner(row, n + 1), c = corner(row + 1, n + 1), d = corner(row + 1, n);
            data.triangles.insert(data.triangles.end(), {{a, b, c}, {a, c, d}});
        }
    for (const glm::uint n : {0u, columns - 1}) {
        const glm::uint a = corner(0, n), b = corner(1, n), c = corner(2, n), d = corner(3, n);
        if (n == 0)
            data.triangles.insert(data.triangles.end(), {{a, b, c}, {a, c, d}});
        else
            data.triangles.insert(data.triangles.end(), {{a, c, b}, {a, d, c}});
    }
    return data;
}

/// Boxes one around another, or all the same.
MeshData nested(int boxes, float apart) {
    MeshData data;
    for (int n = 0; n < boxes; ++n)
        data = both(std::move(data), box_mesh(glm::vec3(1.0f + apart * static_cast<float>(n))));
    return data;
}

/// Needles through one place in all directions.
MeshData needles(int count) {
    test::Random random(7);
    MeshData data;
    for (int n = 0; n < count; ++n) {
        const glm::vec3 along = glm::normalize(random.vector(1.0f)), middle = random.vector(0.2f);
        const auto first = static_cast<glm::uint>(data.vertices.size());
        for (const glm::vec3 corner :
             {middle - along, middle - along + random.vector(2e-3f), middle - along + random.vector(2e-3f), middle + along})
            data.vertices.push_back(corner);
        for (const glm::uvec3 t : {glm::uvec3(0, 1, 2), glm::uvec3(0, 3, 1), glm::uvec3(1, 3, 2), glm::uvec3(2, 3, 0)})
            data.triangles.push_back(t + first);
    }
    return data;
}

TEST(WorkGrowth, OfMeshes) {
    const auto expect = [](const char* name, int n, const std::function<MeshData(int)>& of) {
        expect_even_growth(name, n, [&](int size) {
            return [data = of(size)] {
                const auto mesh = TriangleMesh::create(data);
                ASSERT_TRUE(mesh) << mesh.error();
                test::Random random(3);
                const glm::vec3 middle = 0.5f * ((*mesh)->low() + (*mesh)->high()), half = (*mesh)->high() - middle;
                float sum = 0.0f;
                for (int n = 0; n < 100; ++n)
                    sum += (*mesh)->distance_to(middle + half * random.vector(1.2f));
                ASSERT_TRUE(std::isfinite(sum));
            };
        });
    };
    expect("a cylinder", 300, [](int n) { return cylinder(n, 2.0f); });
    expect("a tall cylinder", 300, [](int n) { return cylinder(n, 200.0f); });
    expect("a cube of strips", 100, strips);
    expect("needles", 250, needles);
    // Each point's own search grows with the boxes around it, up to TriangleMesh::k_max_steps.
    expect("nested boxes", 8, [](int n) { return nested(n, 1.0f / static_cast<float>(n)); });
    expect("one box many times", 16, [](int n) { return nested(n, 0.0f); });
    expect("a bar of blocks that overlap", 24, [](int n) {
        MeshData data;
        for (int block = 0; block < n; ++block)
            data = both(std::move(data), box_mesh(glm::vec3(0.6f), glm::vec3(block, 0.1f * static_cast<float>(block % 2), 0.0f)));
        return data;
    });
    expect("a round ring", 16, [](int n) { return test::torus_mesh(2.0f, 0.5f, static_cast<glm::uint>(n), 100); });
}

TEST(WorkGrowth, OfMeshesEndsInASentence) {
    const std::string sentence =
        "a point beside the mesh takes more than 10000 steps of a search, in the mean: its triangles are long "
        "and thin, or one around another; cut them shorter, or give fewer.";
    for (const MeshData& data : {cylinder(20'000, 2.0f), cylinder(20'000, 200.0f), strips(5'000), nested(1'500, 1e-3f)}) {
        const auto mesh = TriangleMesh::create(data);
        ASSERT_FALSE(mesh) << data.triangles.size();
        EXPECT_EQ(mesh.error(), sentence);
    }
    // A crowd of small ones beside a far one: to their own size they are long.
    const auto crowd = TriangleMesh::create(both(needles(8'000), box_mesh(glm::vec3(1e-2f), glm::vec3(1e3f))));
    ASSERT_FALSE(crowd);
    EXPECT_EQ(crowd.error(), sentence);
}

// --- Files -------------------------------------------------------------------------------------------------------------------

TEST(WorkGrowth, OfVoxelFiles) {
    using test::number;
    const auto file = [](int lists, int voxels, glm::ivec3 size) {
        std::string bytes = "VOX " + number(150) + "MAIN" + number(0) + number(0);
        bytes += "SIZE" + number(12) + number(0) + number(size.x) + number(size.y) + number(size.z);
        for (int n = 0; n < lists; ++n) {
            bytes += "XYZI" + number(4 + 4 * voxels) + number(0) + number(voxels);
            for (int voxel = 0; voxel < voxels; ++voxel)
                bytes += std::string("\0\0\0\1", 4);
        }
        return bytes;
    };
    expect_even_growth("size", 40, [&](int n) {
        return [bytes = file(1, 1, {n, 96, 96})] {
            auto data = read_vox(bytes, "a.vox");
            ASSERT_TRUE(data && VoxelGrid::create(*std::move(data)));
        };
    });
    // Each list of a model took the memory of all its cells again: 128 MiB of empty lists took hours.
    const double begin = seconds([&] {
        EXPECT_EQ(read_vox(file(1'000, 0, {256, 256, 256}), "a.vox").error(),
                  "a.vox: byte 72: the model has a second chunk XYZI; export the file again.");
        EXPECT_EQ(read_vox(file(1'000, 1, {8, 8, 8}), "a.vox").error(),
                  "a.vox: byte 76: the model has a second chunk XYZI; export the file again.");
    });
    if (!test::k_sanitized) {
        EXPECT_LT(begin, 0.05);
    }
    // Nodes below nodes, each of which shows the model at its own end.
    expect_even_growth("nodes", 4'000, [&](int n) {
        std::string nodes;
        for (int node = 0; node < n; ++node)
            nodes += test::chunk("nGRP", number(2 * node) + number(0) + number(2) + number(2 * node + 1) + number(2 * node + 2)) +
                     test::vox_shape(2 * node + 1, 0);
        return [bytes = test::vox_file(test::vox_model({2, 2, 2}, {{0, 0, 0}}) + nodes)] {
            const auto read = read_vox(bytes, "a.vox");
            ASSERT_TRUE(read) << read.error();
        };
    });
}

TEST(WorkGrowth, OfHeightFiles) {
    detail::InputBudget budget;
    ReadLog log("scene.json", budget);
    const auto read = [&](const std::string& bytes, const char* name) {
        return [&log, bytes, name] {
            const auto heights = read_height_file(bytes, name, {}, true, log);
            ASSERT_TRUE(heights) << heights.error();
        };
    };
    expect_even_growth("raw", 1 << 15, [&](int n) {
        const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));
        return read(std::string(2 * side * side, '\1'), "a.raw");
    });
    expect_even_growth("words", 1 << 15, [&](int n) {
        std::string text = "P2 256 " + std::to_string(n / 256) + " 9\n";
        for (int pixel = 0; pixel < n; ++pixel)
            text += "7 ";
        return read(text, "a.pgm");
    });
    // A gap of a fifth of the heights in one piece is filled from its edge: it was looked at whole for each ring.
    expect_even_growth("gap", 1 << 14, [&](int n) {
        const int side = static_cast<int>(std::sqrt(static_cast<double>(n)));
        std::string text = "ncols " + std::to_string(side) + " nrows " + std::to_string(side) + " cellsize 1 NODATA_value -9 ";
        for (int z = 0; z < side; ++z)
            for (int x = 0; x < side; ++x)
                text += std::max(std::abs(2 * x - side), std::abs(2 * z - side)) < 44 * side / 100 ? "-9 " : "1 ";
        return read(text, "a.asc");
    });
}

// --- Bodies ------------------------------------------------------------------------------------------------------------------

TEST(WorkGrowth, OfBodiesThatMoveInOneBox) {
    const auto mesh = test::mesh_of(box_mesh(glm::vec3(0.3f)));
    for (const Shape& shape : {Shape(Sphere{.radius = 0.4f}), Shape(Plate{.half_size = glm::vec2(0.4f)}), Shape(MeshShape{mesh})})
        expect_even_growth("bodies", 100, [&](int n) {
            auto made = Wind::create({.cells = {24, 12, 24}});
            EXPECT_TRUE(made) << made.error();
            auto wind = std::make_shared<Wind>(*std::move(made));
            auto bodies = std::make_shared<std::vector<std::pair<ObstacleId, glm::dvec3>>>();
            test::Random random(5);
            for (int body = 0; body < n; ++body) {
                const glm::dvec3 place(random.vector(5.5f) * glm::vec3(2.0f, 1.0f, 2.0f));
                const auto id = wind->obstacles().add({.position = place, .shape = shape});
                EXPECT_TRUE(id) << id.error();
                bodies->emplace_back(*id, place);
            }
            return [wind, bodies] {
                for (auto& [id, place] : *bodies)
                    ASSERT_TRUE(wind->obstacles().move(id, place += glm::dvec3(1e-3)));
                ASSERT_TRUE(wind->step(0.01).stepped);
            };
        });
}

// Each tile is drawn beside those around it alone, and none looks at all others more than once.
TEST(WorkGrowth, OfTilesOfGround) {
    const auto map = HeightMap::create({.corners = {2, 2}, .spacing = 1.0f, .heights = {0.4f, 0.6f, 0.5f, 0.7f}});
    ASSERT_TRUE(map) << map.error();
    expect_even_growth("tiles", 256, [&](int n) {
        return [&map, n] {
            Wind wind = test::made({.cells = {34, 8, 34}, .boundaries = Boundaries::open_over_floor()});
            for (int tile = 0; tile < n; ++tile)
                ASSERT_TRUE(wind.obstacles().add(
                    {.position = {tile % 32 - 16, 0.0, tile / 32 - 16},
                     .shape = Ground{.heights = *map, .scale = glm::vec3(1.0f), .beyond = Beyond::nothing}}));
            ASSERT_TRUE(wind.step(0.01).stepped);
        };
    });
}

// Of tiles of a tenth of a cell a few draw, from one surface: each was drawn from all within six cells, and looked for its thickness at
// all within sixteen. Those that stand upon each other looked at each other too: 256 of them took 6 s.
TEST(WorkGrowth, OfTilesFarSmallerThanACell) {
    const auto map = HeightMap::create({.corners = {2, 2}, .spacing = 1.0f, .heights = {2.4f, 2.6f, 2.5f, 2.7f}});
    ASSERT_TRUE(map) << map.error();
    struct Family {
        const char* name;
        int from;
        float size;
        glm::dvec3 (*place)(int tile);
    };
    for (const Family& family :
         {Family{"tiles of a tenth of a cell", 256, 0.1f,
                 [](int n) { return 0.1 * glm::dvec3(n % 64, 0, n / 64) - glm::dvec3(3.2, 0, 3.2); }},
          Family{"scattered ones", 128, 0.1f, [](int n) { return 0.45 * glm::dvec3(n / 16, 0, n % 16) - glm::dvec3(14, 0, 14); }},
          Family{"tiles upon each other", 128, 4.0f, [](int n) { return glm::dvec3(0.3, 0.01 * (n % 97), 0.3); }}})
        expect_even_growth(family.name, family.from, [&](int n) {
            return [&map, &family, n] {
                Wind wind = test::made({.cells = {34, 8, 34}, .boundaries = Boundaries::open_over_floor()});
                for (int tile = 0; tile < n; ++tile)
                    ASSERT_TRUE(wind.obstacles().add(
                        {.position = family.place(tile),
                         .shape =
                             Ground{.heights = *map, .scale = {family.size, 1.0f, family.size}, .beyond = Beyond::nothing}}));
                ASSERT_TRUE(wind.step(0.01).stepped);
            };
        });
}

// Each block is drawn with those that it touches alone.
TEST(WorkGrowth, OfBlocksThatOverlap) {
    expect_even_growth("blocks", 100, [&](int n) {
        return [n] {
            Wind wind = test::made({.cells = {34, 10, 34}, .boundaries = Boundaries::open_over_floor()});
            for (int block = 0; block < n; ++block)
                ASSERT_TRUE(wind.obstacles().add({.position = {block % 20 * 1.5 - 15.0, 0.0, block / 20 * 1.5 - 15.0},
                                                  .shape = Block{.half_size = {0.8f, 0.5f, 0.8f}}}));
            ASSERT_TRUE(wind.step(0.01).stepped);
        };
    });
}

} // namespace
} // namespace windrow::scene
