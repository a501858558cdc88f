// Meshes and voxel grids that a scene names: what is read, how faces are cut into triangles, and what is rejected.
#include "fluid/core/bytes.h"
#include "scene/obj_file.h"
#include "scene/scene_reader.h"
#include "tests/own_folder.h"
#include "tests/unit/vox_parts.h"
#include "tests/winds.h"

#include <numbers>

namespace windrow::scene {
namespace {

using test::vox;

constexpr const char* k_box = "# a box\no box\nv -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 2 -1\nv 1 2 -1\nv 1 2 1\nv -1 2 1\n"
                              "f 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n";

class SceneShapes : public test::FolderTest {
  protected:
    void write(const char* name, const std::string& bytes) const { std::ofstream(folder / name, std::ios::binary) << bytes; }
    [[nodiscard]] Result<Scene> read(const std::string& shapes) const {
        return read_scene_text(R"({"obstacles": [)" + shapes + "]}", folder / "scene.json");
    }
    [[nodiscard]] std::string reason(const std::string& shapes) const {
        const auto scene = read(shapes);
        return scene ? std::string() : scene.error();
    }
};

TEST_F(SceneShapes, AMeshIsReadOnceAndShared) {
    write("house.obj", k_box);
    const auto scene =
        read(R"({"shape": {"mesh": {"file": "house.obj"}}}, {"shape": {"mesh": {"file": "./house.obj", "scale": 2.5}}})");
    ASSERT_TRUE(scene) << scene.error();
    const auto &first = std::get<MeshShape>(scene->obstacles[0].obstacle.shape),
               &second = std::get<MeshShape>(scene->obstacles[1].obstacle.shape);
    EXPECT_EQ(first.mesh, second.mesh);
    EXPECT_EQ(first.scale, 1.0f);
    EXPECT_EQ(second.scale, 2.5f);
    EXPECT_EQ(first.mesh->data().triangles.size(), 12u);
    EXPECT_EQ(first.mesh->low(), glm::vec3(-1.0f, 0.0f, -1.0f));
    EXPECT_EQ(first.mesh->high(), glm::vec3(1.0f, 2.0f, 1.0f));
    EXPECT_NEAR(first.mesh->distance_to({0.0f, 3.0f, 0.0f}), 1.0f, 1e-6f);
    EXPECT_NEAR(first.mesh->distance_to({0.0f, 0.5f, 0.0f}), -0.5f, 1e-6f);
}

TEST_F(SceneShapes, AModelOfVoxelsIsTurnedWithItsTopUp) {
    write("tower.vox", vox({3, 2, 4}, {{0, 0, 0}, {1, 0, 0}, {2, 1, 3}}));
    const auto scene = read(R"({"shape": {"voxels": {"file": "tower.vox", "cell_size": 0.5}}})");
    ASSERT_TRUE(scene) << scene.error();
    const auto& tower = std::get<VoxelShape>(scene->obstacles[0].obstacle.shape);
    EXPECT_EQ(tower.cell_size, 0.5f);
    ASSERT_EQ(tower.grid->data().cells, glm::ivec3(3, 4, 2));
    int closed = 0;
    for (const std::uint8_t value : tower.grid->data().closed)
        closed += value;
    EXPECT_EQ(closed, 3);
    for (const glm::ivec3 cell : {glm::ivec3(0, 0, 1), glm::ivec3(1, 0, 1), glm::ivec3(2, 3, 0)})
        EXPECT_TRUE(tower.grid->closed(cell)) << cell.x << cell.y << cell.z;
}

TEST_F(SceneShapes, APictureOfHeightsIsGround) {
    write("hill.pgm", "P5\n# two bytes a pixel\n3 2\n1000\n" + std::string("\0\0\x01\xf4\x03\xe8\0\0\0\0\x03\xe8", 12));
    const auto scene = read(R"({"shape": {"ground": {"file": "hill.pgm", "scale": [10, 50, 20]}}, "position": [4, 1, 2]})");
    ASSERT_TRUE(scene) << scene.error();
    const auto& hill = std::get<Ground>(scene->obstacles[0].obstacle.shape);
    EXPECT_EQ(hill.scale, glm::vec3(10.0f, 50.0f, 20.0f));
    EXPECT_EQ(hill.heights->data(), (HeightData{{3, 2}, 1.0f, {0.0f, 0.5f, 1.0f, 0.0f, 0.0f, 1.0f}}));
    EXPECT_GT(detail::distance_to(hill, {10.0f, 25.1f, 0.0f}), 0.0f);
    EXPECT_LT(detail::distance_to(hill, {10.0f, 24.9f, 0.0f}), 0.0f);
    EXPECT_LT(detail::distance_to(hill, {1e5f, 49.9f, -1e5f}), 0.0f) << "beyond the edge";
}

// Files of heights as surveys and terrain tools write them.
TEST_F(SceneShapes, HeightsAreReadOfEachKindOfFile) {
    const auto heights = [&](const std::string& keys) -> Result<std::vector<float>> {
        const auto scene = read(R"({"shape": {"ground": {)" + keys + "}}}");
        if (!scene)
            return Error{scene.error()};
        return std::get<Ground>(scene->obstacles[0].obstacle.shape).heights->data().heights;
    };
    write("words.pgm", "P2\n# as text\n3 2\n100\n0 50 100\n25 0 75\n");
    EXPECT_EQ(*heights(R"("file": "words.pgm")"), (std::vector<float>{0.0f, 0.5f, 1.0f, 0.25f, 0.0f, 0.75f}));
    const std::string head = "ncols 3\nnrows 2\nxllcorner 4\nyllcorner 5\ncellsize 10\n";
    write("grid.asc", head + "1.5 2 -3\n40 5e1 6\n");
    EXPECT_EQ(*heights(R"("file": "grid.asc")"), (std::vector<float>{1.5f, 2.0f, -3.0f, 40.0f, 50.0f, 6.0f}));
    const auto reported = read(R"({"shape": {"ground": {"file": "grid.asc"}}})");
    ASSERT_EQ(reported->warnings.size(), 1u);
    EXPECT_NE(
        reported->warnings[0].find("grid.asc says that its pixels are 10 x 10, and a pixel counts as a metre: give \"scale\""),
        std::string::npos)
        << reported->warnings[0];
    EXPECT_TRUE(read(R"({"shape": {"ground": {"file": "grid.asc", "scale": [10, 1, 10]}}})")->warnings.empty());

    // Raw numbers, the high byte first.
    std::string high, low;
    for (int n = 0; n < 16 * 16; ++n) {
        const int level = 1000 + 40 * (n % 16) + 30 * (n / 16);
        high += {static_cast<char>(level >> 8), static_cast<char>(level)};
        low += {static_cast<char>(level), static_cast<char>(level >> 8)};
    }
    write("high.raw", high);
    write("low.raw", low);
    EXPECT_EQ(*heights(R"("file": "high.raw", "byte_order": "high_first")"), *heights(R"("file": "low.raw")"));
    EXPECT_NE(heights(R"("file": "high.raw")")
                  .error()
                  .find("is much smoother with the high byte first: give \"byte_order\": "
                        "\"high_first\"."),
              std::string::npos);
    EXPECT_NE(heights(R"("file": "low.raw", "byte_order": "high_first")").error().find("\"low_first\""), std::string::npos);

    for (const auto& [text, sentence] :
         {std::pair{head + "1 2 3 4 5", "has 5 heights of 6: the next one at row 2, column 3 is missing or no number."},
          {head + "1 2 x 4 5 6", "the next one at row 1, column 3 is missing"},
          {std::string("ncols 3\n1 2 3"), "is no ESRI ASCII grid"},
          {std::string("ncols 1e9 nrows 1e9 cellsize 1 1"), "is no ESRI ASCII grid"},
          {std::string("word"), "is no ESRI ASCII grid"}}) {
        write("bad.asc", text);
        EXPECT_NE(heights(R"("file": "bad.asc")").error().find(sentence), std::string::npos)
            << heights(R"("file": "bad.asc")").error();
    }
    write("short.pgm", "P2 3 2 100 0 50 100 25 7 x");
    EXPECT_NE(heights(R"("file": "short.pgm")").error().find("has 5 levels of 6"), std::string::npos);
}

// Where a picture beside the heights is white there is no ground, whatever its size.
TEST_F(SceneShapes, HolesAreReadOfAPicture) {
    write("level.pgm", "P2\n5 3\n100\n" + std::string("50 50 50 50 50 50 50 50 50 50 50 50 50 50 50\n"));
    write("mask.pgm", "P2\n8 2\n255\n0 0 255 0 0 0 0 0 100 0 200 0 0 0 0 0\n");
    const auto scene = read(R"({"shape": {"ground": {"file": "level.pgm", "scale": [2, 8, 3], "holes": "mask.pgm"}}})");
    ASSERT_TRUE(scene) << scene.error();
    const auto& ground = std::get<Ground>(scene->obstacles[0].obstacle.shape);
    EXPECT_EQ(ground.heights->data().holes.cells, glm::ivec2(8, 2));
    const auto is_inside = [&](float x, float z) { return detail::distance_to(ground, {x, 3.5f, z}) < 0.0f; };
    EXPECT_FALSE(is_inside(2.5f, 1.0f));
    EXPECT_FALSE(is_inside(2.5f, 5.0f));
    EXPECT_FALSE(is_inside(2.5f, -90.0f)) << "a hole at the edge goes on beyond it as the ground does";
    EXPECT_TRUE(is_inside(1.5f, 1.0f) && is_inside(3.5f, 1.0f) && is_inside(0.5f, 5.0f) && is_inside(-90.0f, 3.0f));
    // One file of heights with and without its holes, and read in two ways.
    const auto two = read(R"({"shape": {"ground": {"file": "level.pgm", "scale": [2, 8, 3], "holes": "mask.pgm"}}},
                             {"shape": {"ground": {"file": "level.pgm", "scale": [2, 8, 3], "nodata": 50}}},
                             {"shape": {"ground": {"file": "level.pgm", "scale": [2, 8, 3]}}})");
    EXPECT_NE(reason(R"({"shape": {"ground": {"file": "level.pgm", "nodata": 50}}})")
                  .find("level.pgm has 15 of 15 heights without data, the first at row 1, column 1"),
              std::string::npos);
    ASSERT_FALSE(two);
    const auto both = read(R"({"name": "a", "shape": {"ground": {"file": "level.pgm", "holes": "mask.pgm"}}},
                              {"name": "b", "shape": {"ground": {"file": "level.pgm"}}})");
    ASSERT_TRUE(both) << both.error();
    EXPECT_EQ(std::get<Ground>(both->obstacles[0].obstacle.shape).heights->holes().size(), 1u);
    EXPECT_EQ(std::get<Ground>(both->obstacles[1].obstacle.shape).heights->holes().size(), 0u);
    write("white.pgm", "P2\n2 2\n255\n255 255 255 255\n");
    for (const auto& [holes, sentence] : {std::pair{"missing.pgm", "missing.pgm"},
                                          {"white.pgm", "is a hole everywhere: leave the ground out"},
                                          {"../mask.pgm", "name a file"}})
        EXPECT_NE(
            reason(R"({"shape": {"ground": {"file": "level.pgm", "holes": ")" + std::string(holes) + R"("}}})").find(sentence),
            std::string::npos)
            << holes;
}

// Places without data, by the file's word or as surveys mark them.
TEST_F(SceneShapes, MissingHeightsAreFilledAndReported) {
    std::string head = "ncols 6\nnrows 4\ncellsize 1\nNODATA_value -1\n", rows;
    for (int n = 0; n < 24; ++n)
        rows += n == 9 ? "-1 " : n == 10 ? "-32768 " : n == 16 ? "-9999 " : "7.5 ";
    write("holes.asc", head + rows);
    const auto scene = read(R"({"shape": {"ground": {"file": "holes.asc"}}})");
    ASSERT_TRUE(scene) << scene.error();
    EXPECT_EQ(std::get<Ground>(scene->obstacles[0].obstacle.shape).heights->data().heights, std::vector<float>(24, 7.5f));
    ASSERT_EQ(scene->warnings.size(), 1u);
    EXPECT_NE(scene->warnings[0].find("has 3 of 24 heights without data, the first at row 2, column 4: they are filled"),
              std::string::npos)
        << scene->warnings[0];
    std::string most;
    for (int n = 0; n < 24; ++n)
        most += n % 4 == 0 ? "-1 " : "7.5 ";
    write("mostly.asc", head + most);
    EXPECT_NE(reason(R"({"shape": {"ground": {"file": "mostly.asc"}}})")
                  .find("has 6 of 24 heights without data, the first at row 1, column 1: fill them"),
              std::string::npos);
}

TEST_F(SceneShapes, APictureOfLengthsIsTheGroundsRoughness) {
    write("lengths.pgm", std::string("P5 2 2 255\n\x00\xff\x00\xff", 15));
    const auto air = [&](const std::string& keys) {
        return read_scene_text(R"({"air": {"roughness": {)" + keys + "}}}", folder / "scene.json");
    };
    const auto scene = air(R"("map": {"file": "lengths.pgm", "scale": [10, 0.3, 10], "position": [4, 0, 2]})");
    ASSERT_TRUE(scene) << scene.error();
    ASSERT_TRUE(scene->air.roughness && scene->air.roughness->map);
    EXPECT_EQ(scene->air.roughness->map->scale, glm::vec3(10.0f, 0.3f, 10.0f));
    EXPECT_EQ(scene->air.roughness->map->lengths->data().heights, (std::vector<float>{0.0f, 1.0f, 0.0f, 1.0f}));
    EXPECT_FALSE(air("")->air.roughness->map);
    EXPECT_FALSE(read_scene_text("{}", folder / "scene.json")->air.roughness);
    for (const auto& [keys, sentence] :
         {std::pair{R"("map": {})", "$.air.roughness.map.file is missing: name a picture of heights, PGM,"},
          {R"("map": {"file": "none.pgm"})", "none.pgm"},
          {R"("length": 0)", "$.air.roughness.length is 0 m: give 1e-6 to 100 m."}})
        EXPECT_NE(air(keys).error().find(sentence), std::string::npos) << air(keys).error();
}

TEST_F(SceneShapes, WhatCannotBeUsedIsNamed) {
    std::string open = k_box;
    open.resize(open.rfind("f "));
    write("house.obj", k_box);
    write("open.obj", open);
    write("words.obj", "v 1 2\n");
    write("empty.obj", "v 0 0 0\n");
    write("tower.vox", vox({3, 2, 4}, {{0, 0, 0}}));
    write("cut.vox", vox({3, 2, 4}, {{0, 0, 0}}).substr(0, 60));
    write("two.vox", vox({3, 2, 4}, {{0, 0, 0}}, 2));
    write("beyond.vox", vox({3, 2, 4}, {{0, 2, 0}}));
    write("large.vox", vox({300, 2, 4}, {{0, 0, 0}}));
    write("dot.pgm", "P5 1 1 255\n7");
    write("air.vox", vox({3, 2, 4}, {}));
    const auto mesh = [](const std::string& keys) { return R"({"shape": {"mesh": {)" + keys + "}}}"; };
    const auto voxels = [](const std::string& keys) { return R"({"shape": {"voxels": {)" + keys + "}}}"; };
    const std::pair<std::string, std::string> bad[] = {
        {mesh(""), "$.obstacles[0].shape.mesh.file is missing: name a mesh, OBJ, in the scene's folder."},
        {mesh(R"("file": 3)"), "$.obstacles[0].shape.mesh.file is 3"},
        {mesh(R"("file": "../house.obj")"), "is \"../house.obj\": name a file in the scene's folder"},
        {mesh(R"("file": "none.obj")"), "none.obj: no such file: check the name, which is sought beside the file that gives it."},
        {mesh(R"("file": "open.obj")"),
         "open.obj: the mesh is open at 4 edges, the first from (-1, 0, -1) to (-1, 0, 1): close it"},
        {mesh(R"("file": "words.obj")"), "words.obj:1: v has '': give 3 finite numbers."},
        {mesh(R"("file": "empty.obj")"), "empty.obj has no faces: give a mesh of triangles."},
        {mesh(R"("file": "house.obj", "scale": 0)"), "$.obstacles[0].shape.mesh.scale is 0: give 1e-6 to 1e6."},
        {mesh(R"("file": "house.obj", "size": 1)"), "$.obstacles[0].shape.mesh.size is not a known key"},
        {mesh(R"("file": "house.obj", "scale": 900000)"), "reaches 1800000 m from its origin: give at most 1e6 m."},
        {R"({"shape": {"ground": {"file": "house.obj"}}})",
         "house.obj is not a PGM of up to 65535 levels: save the image as PGM (P5)."},
        {R"({"shape": {"ground": {"file": "dot.pgm"}}})",
         "dot.pgm: heightmap.corners is (1, 1): give each component 2 to 16384."},
        {R"({"shape": {"plate": {"half_size": [1]}}})", "$.obstacles[0].shape.plate.half_size is [1]: give two numbers, [x, y]."},
        {voxels(""), "$.obstacles[0].shape.voxels.file is missing: name a MagicaVoxel file in the scene's folder."},
        {voxels(R"("file": "house.obj")"), "house.obj: is no MagicaVoxel file: it does not begin with \"VOX \""},
        {voxels(R"("file": "cut.vox")"), "cut.vox: byte 44: a chunk ends beyond the file: the file is truncated; copy it again."},
        {voxels(R"("file": "two.vox")"), "two.vox: has 2 models and no scene that places them: save each in a file of its own."},
        {voxels(R"("file": "beyond.vox")"), "beyond.vox: byte 60: the cell (0, 2, 0) is outside of the model of (3, 2, 4)"},
        {voxels(R"("file": "large.vox")"), "large.vox: byte 32: a model has 300 cells along an axis: give 1 to 256."},
        {voxels(R"("file": "air.vox")"), "air.vox: its model has no voxel: fill one at least."},
        {voxels(R"("file": "tower.vox", "cell_size": -1)"), "$.obstacles[0].shape.voxels.cell_size is -1 m"},
        {mesh(R"("file": "open.obj")") + "," + mesh(R"("file": "open.obj")"),
         "$.obstacles[1].shape.mesh.file names a file that cannot be used: see above."},
    };
    for (const auto& [text, sentence] : bad) {
        EXPECT_NE(reason(text).find(sentence), std::string::npos) << reason(text) << " is not " << sentence;
        if (text.find("},{") == std::string::npos) {
            EXPECT_EQ(reason(text).find('\n'), std::string::npos) << "one sentence: " << reason(text);
        }
    }
}

double area(const MeshData& mesh) {
    double sum = 0.0;
    for (const glm::uvec3& t : mesh.triangles)
        sum += 0.5 * glm::length(glm::cross(glm::dvec3(mesh.vertices[t.y] - mesh.vertices[t.x]),
                                            glm::dvec3(mesh.vertices[t.z] - mesh.vertices[t.x])));
    return sum;
}

MeshData face(const std::vector<glm::vec3>& corners) {
    std::string text, face = "f";
    for (std::size_t n = 0; n < corners.size(); ++n) {
        text += detail::message("v ", corners[n].x, " ", corners[n].y, " ", corners[n].z, "\n");
        face += detail::message(" ", n + 1);
    }
    const auto obj = read_obj(text + face + "\n", "face.obj", {.vertices = 100, .triangles = 100});
    EXPECT_TRUE(obj) << obj.error();
    return obj ? mesh_of_obj(*obj) : MeshData{};
}

// Triangles that reach out of the outline would have more area in all.
TEST(ObjMesh, FacesAreCutWithinTheirOutline) {
    const std::vector<glm::vec3> gate{{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {6, 2, 0}, {6, 0, 0}, {9, 0, 0}, {9, 4, 0}, {0, 4, 0}};
    std::vector<glm::vec3> star, comb;
    for (int n = 0; n < 40; ++n) {
        const float angle = static_cast<float>(n) * 0.05f * std::numbers::pi_v<float>, r = n % 2 == 0 ? 3.0f : 1.0f;
        star.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.5f);
    }
    for (int n = 0; n < 30; ++n)
        comb.emplace_back(0.0f, n % 2 == 0 ? 0.0f : 2.0f, static_cast<float>(n));
    comb.emplace_back(0.0f, 3.0f, 29.0f);
    comb.emplace_back(0.0f, 3.0f, 0.0f);
    const std::pair<std::vector<glm::vec3>, double> outlines[] = {
        {gate, 30.0}, {star, 40.0 * 0.5 * 3.0 * std::sin(0.05 * std::numbers::pi)}, {comb, 29.0 * 2.0}};
    for (const auto& [outline, expected] : outlines)
        for (const bool back : {false, true})
            for (int turn = 0; turn < 3; ++turn) {
                std::vector<glm::vec3> corners = outline;
                if (back)
                    std::reverse(corners.begin(), corners.end());
                for (glm::vec3& corner : corners)
                    for (int n = 0; n < turn; ++n)
                        corner = {corner.y, corner.z, corner.x};
                const MeshData mesh = face(corners);
                EXPECT_EQ(mesh.triangles.size(), corners.size() - 2);
                EXPECT_NEAR(area(mesh), expected, 1e-4) << corners.size() << ' ' << turn;
            }
    EXPECT_EQ(face({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).triangles.size(), 2u) << "without area";
}

} // namespace
TEST(SceneRows, AreALawOrAList) {
    const auto air = [](const std::string& keys) {
        return read_scene_text(R"({"air": {"cells": [4, 3, 4], "rows": {)" + keys + "}}}", "scene.json");
    };
    ASSERT_TRUE(air("")) << air("").error();
    EXPECT_FALSE(read_scene_text("{}", "scene.json")->air.rows);
    const auto law = air(R"("first": 0.3, "uniform": 2, "ratio": 1.2)");
    ASSERT_TRUE(law) << law.error();
    EXPECT_EQ(law->air.rows->first, 0.3f);
    EXPECT_EQ(law->air.rows->uniform, 2);
    const auto list = air(R"("heights": [0.25, 0.8, 1.6], "top": 2)");
    ASSERT_TRUE(list) << list.error();
    EXPECT_EQ(list->air.rows->heights, (std::vector<float>{0.25f, 0.8f, 1.6f}));
    for (const auto& [keys, said] : {std::pair{R"("heights": 3)", "$.air.rows.heights is 3: give a list, [...]."},
                                     {R"("heights": [1, "2"])", "$.air.rows.heights[1] is \"2\""},
                                     {R"("heights": [1, -2, 3])", "$.air.rows.heights[1] is -2 m: give a number above 0"},
                                     {R"("heights": [1, 2])", "rows.heights has 2 heights for 3 rows: give one a row."},
                                     {R"("ratio": 3)", "$.air.rows.ratio is 3: give 1 to 1.5."}}) {
        const auto rejected = air(keys);
        ASSERT_FALSE(rejected) << keys;
        EXPECT_NE(rejected.error().find(said), std::string::npos) << rejected.error();
    }
}

} // namespace windrow::scene
