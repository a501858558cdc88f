// MagicaVoxel files (scene/vox_file.h).
#include "scene/vox_file.h"
#include "tests/unit/vox_parts.h"

#include <gtest/gtest.h>
#include <random>
#include <set>
#include <tuple>

namespace windrow::scene {
namespace {

using namespace test;

// A quarter turn about its z axis, x to y and y to -x, is row 0 from y with a minus and row 1 from x: 1 + (0 << 2) + 16. After a mirror of
// x (20: x, y, z with the first sign) the cell at x = 2 is turned as one at x = 0.
TEST(VoxFiles, AModelIsTurnedAsInItsEditor) {
    const auto only_cell = [&](const std::vector<std::string>& turns) {
        const auto data = read_vox(vox({3, 2, 4}, {{2, 1, 3}}, 1, turns), "tower.vox");
        EXPECT_TRUE(data) << data.error();
        glm::ivec3 found(-1);
        for (int k = 0, n = 0; k < data->cells.z; ++k)
            for (int j = 0; j < data->cells.y; ++j)
                for (int i = 0; i < data->cells.x; ++i, ++n)
                    if (data->closed[static_cast<std::size_t>(n)] != 0)
                        found = {i, j, k};
        return std::pair(data->cells, found);
    };
    const std::string quarter = "17", mirror = "20", none = "4";
    EXPECT_EQ(only_cell({none}), only_cell({}));
    EXPECT_EQ(only_cell({}), std::pair(glm::ivec3(3, 4, 2), glm::ivec3(2, 3, 0)));
    // The editor's (2, 1, 3) of 3 x 2 x 4 becomes (0, 2, 3) of 2 x 3 x 4.
    EXPECT_EQ(only_cell({quarter}), std::pair(glm::ivec3(2, 4, 3), glm::ivec3(0, 3, 0)));
    EXPECT_EQ(only_cell({quarter, mirror}), std::pair(glm::ivec3(2, 4, 3), glm::ivec3(0, 3, 2)));
    EXPECT_EQ(only_cell({mirror, quarter}), std::pair(glm::ivec3(2, 4, 3), glm::ivec3(1, 3, 0)));
    const auto fault = [&](const std::string& bytes) { return read_vox(bytes, "tower.vox").error(); };
    const std::string two = vox({3, 2, 4}, {{2, 1, 3}}, 1, {none}, 2), odd = vox({3, 2, 4}, {{2, 1, 3}}, 1, {"0"}),
                      words = vox({3, 2, 4}, {{2, 1, 3}}, 1, {"east"});
    EXPECT_EQ(read_vox(two, "tower.vox")->closed, read_vox(vox({3, 2, 4}, {{2, 1, 3}}), "tower.vox")->closed)
        << "at one place twice";
    for (const std::string& bad : {odd, words})
        EXPECT_NE(fault(bad).find("_r is no turn along the axes"), std::string::npos) << fault(bad);
    std::string cut = vox({3, 2, 4}, {{2, 1, 3}}, 1, {none});
    cut[cut.find("_t") - 4] = 'z';
    EXPECT_NE(fault(cut).find("a node's text ends beyond its chunk"), std::string::npos) << fault(cut);
}

// Several models, turned and placed by nodes within nodes: each voxel is where the editor has it. A model turns about its middle, rounded
// down, and the place of a voxel is that of its centre (the format's own words).
TEST(VoxFiles, AllModelsStandAsInTheEditor) {
    std::mt19937 chance(4);
    const auto whole_number = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(chance); };
    // Rows of a turn: from which axis, and its sign. Bits 0-1 and 2-3: the axis of rows 0 and 1; bits 4-6: signs.
    const auto turned = [](int bits, glm::dvec3 at) {
        const int first = bits & 3, second = bits >> 2 & 3, axes[3] = {first, second, 3 - first - second};
        glm::dvec3 to;
        for (int n = 0; n < 3; ++n)
            to[n] = ((bits >> (4 + n) & 1) != 0 ? -1.0 : 1.0) * at[axes[n]];
        return to;
    };
    const auto any_turn = [&] {
        const int orders[] = {4, 8, 1, 9, 2, 6}; // of 0 1 2, 0 2 1, 1 0 2, 1 2 0, 2 0 1, 2 1 0
        return orders[whole_number(0, 5)] + 16 * whole_number(0, 7);
    };
    for (int file = 0; file < 60; ++file) {
        std::string models, nodes;
        std::vector<glm::ivec3> sizes;
        std::vector<std::vector<glm::ivec3>> cells;
        for (int n = whole_number(1, 3); n > 0; --n) {
            sizes.emplace_back(whole_number(1, 4), whole_number(1, 4), whole_number(1, 5));
            cells.push_back({sizes.back() - 1});
            for (int more = whole_number(0, 3); more > 0; --more)
                cells.back().emplace_back(whole_number(0, sizes.back().x - 1), whole_number(0, sizes.back().y - 1), 0);
            models += vox_model(sizes.back(), cells.back());
        }
        std::set<std::tuple<int, int, int>> wanted;
        glm::ivec3 low(1 << 20), high(-(1 << 20));
        const int root_turn = any_turn(), places = whole_number(1, 4);
        const glm::ivec3 root_way(whole_number(-5, 5), 2, -1);
        const auto words = [](glm::ivec3 way) {
            return std::to_string(way.x) + " " + std::to_string(way.y) + " " + std::to_string(way.z);
        };
        std::string group = number(1) + number(0) + number(places);
        for (int n = 0; n < places; ++n) {
            const int model = whole_number(0, static_cast<int>(sizes.size()) - 1), turn = any_turn();
            const glm::ivec3 way(whole_number(-6, 6), whole_number(-6, 6), whole_number(-6, 6));
            const bool hidden = n > 0 && whole_number(0, 4) == 0;
            group += number(10 + 2 * n);
            nodes += vox_place(10 + 2 * n, 11 + 2 * n, std::to_string(turn), words(way), hidden) + vox_shape(11 + 2 * n, model);
            if (hidden)
                continue;
            const auto in_scene = [&](glm::dvec3 centre) {
                const glm::dvec3 at =
                    turned(turn, centre - glm::dvec3(sizes[static_cast<std::size_t>(model)] / 2)) + glm::dvec3(way);
                return glm::ivec3(glm::floor(turned(root_turn, at) + glm::dvec3(root_way)));
            };
            for (const glm::ivec3 cell : cells[static_cast<std::size_t>(model)]) {
                const glm::ivec3 at = in_scene(glm::dvec3(cell) + 0.5);
                wanted.insert({at.x, at.y, at.z});
            }
            for (const glm::dvec3 corner : {glm::dvec3(0.5), glm::dvec3(sizes[static_cast<std::size_t>(model)]) - 0.5}) {
                low = glm::min(low, in_scene(corner));
                high = glm::max(high, in_scene(corner));
            }
        }
        nodes = vox_place(0, 1, std::to_string(root_turn), words(root_way)) + chunk("nGRP", group) + nodes;
        const auto read = read_vox(vox_file(models + nodes), "village.vox");
        ASSERT_TRUE(read) << read.error();
        ASSERT_EQ(read->cells, glm::ivec3(high.x - low.x, high.z - low.z, high.y - low.y) + 1);
        std::set<std::tuple<int, int, int>> found;
        for (int z = 0, n = 0; z < read->cells.z; ++z)
            for (int y = 0; y < read->cells.y; ++y)
                for (int x = 0; x < read->cells.x; ++x, ++n)
                    if (read->closed[static_cast<std::size_t>(n)] != 0)
                        found.insert({low.x + x, high.y - z, low.z + y});
        EXPECT_EQ(found, wanted) << file;
    }
    const auto fault = [&](const std::string& nodes) {
        return read_vox(vox_file(vox_model({2, 2, 2}, {{0, 0, 0}}) + nodes), "a.vox").error();
    };
    EXPECT_EQ(fault(vox_shape(1, 7)), "a.vox: a shape names model 7 of 1; export the file again.");
    EXPECT_EQ(fault(vox_place(0, 1, "4", "0 0 0", true) + vox_shape(1, 0)), "a.vox: all of its models are hidden: show one.");
    EXPECT_EQ(fault(vox_place(0, 1, "4", "0 0 0") + chunk("nGRP", number(1) + number(0) + number(2) + number(0) + number(2)) +
                    vox_shape(2, 0)),
              "a.vox: its nodes go in a circle; export the file again.");
    EXPECT_NE(fault(vox_place(0, 1, "4", "0 0 0") + vox_place(2, 1, "4", "0 0 0") + vox_shape(1, 0)).find("is in two groups"),
              std::string::npos);
    EXPECT_NE(fault(vox_place(0, 1, "4", "0 zero 0") + vox_shape(1, 0)).find("_t is not three whole numbers"), std::string::npos);
    EXPECT_NE(fault(vox_place(0, 1, "4", "9000 0 0") + vox_shape(1, 0) + vox_shape(2, 0))
                  .find("its models reach over more than 4096 cells"),
              std::string::npos);
}

} // namespace
} // namespace windrow::scene
