// One scene has one air: what the command reads of a file blows the same wind, to the bit, as what the renderer reads of it.
#include "fluid/wind.h"
#include "scene/scene_air.h"
#include "scene/scene_reader.h"
#include "tests/figure.h"
#include "vegetation/files/mesh_file.h"
#include "vegetation/tests/program/specimen.h"

#include <algorithm>
#include <filesystem>
#include <glm/common.hpp>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace windrow::vegetation::program {
namespace {

using scene::BodyBox;

/// The air of a scene after `seconds` in the steps of `windrow run`.
std::vector<glm::vec4> air_of(const scene::Scene& scene, double seconds, int& awake) {
    auto wind = Wind::create(scene.air);
    EXPECT_TRUE(wind) << wind.error();
    scene::SceneAir air(scene);
    EXPECT_TRUE(air.begin(*wind));
    const scene::FrameTimes times = scene.frame_times();
    for (std::int64_t step = 1; times.time_of_step(step) <= seconds; ++step) {
        EXPECT_TRUE(air.advance_to(*wind, times.time_of_step(step)));
        awake += wind->step(times.length_of_step(step)).asleep ? 0 : 1;
    }
    return {wind->field().begin(), wind->field().end()};
}

class OneAir : public testing::TestWithParam<const char*> {};

TEST_P(OneAir, OfTheCommandAndTheRenderer) {
    const auto file = std::filesystem::path(WINDROW_SOURCE_DIR) / "examples/scenes" / (std::string(GetParam()) + ".json");
    const auto run = scene::read_scene(file);
    const auto drawn = read_picture_scene(file);
    ASSERT_TRUE(run) << run.error();
    ASSERT_TRUE(drawn) << drawn.error();
    EXPECT_TRUE(run->warnings.empty());
    ASSERT_EQ(run->carried.size(), 1u);
    ASSERT_EQ(drawn->air.carried.size(), 1u);
    EXPECT_EQ(run->carried[0].key, drawn->air.carried[0].key);
    EXPECT_EQ(run->carried[0].front, drawn->air.carried[0].front);
    int awake = 0, as_awake = 0;
    EXPECT_TRUE(air_of(*run, 1.0, awake) == air_of(drawn->air, 1.0, as_awake));
    EXPECT_EQ(awake, as_awake);
    EXPECT_GT(awake, 20);
}

INSTANTIATE_TEST_SUITE_P(Scenes, OneAir, testing::Values("looks/tall", "looks/composition", "wolf", "fur/carpet"),
                         [](const auto& name) {
                             std::string text = name.param;
                             std::ranges::replace(text, '/', '_');
                             return text;
                         });

/// The box of a mesh by its keys alone, as a wake has it.
BodyBox box_of(const std::string& mesh, const std::filesystem::path& folder = {}) {
    const nlohmann::json keys = nlohmann::json::parse(mesh);
    windrow::detail::InputBudget budget;
    scene::ReadLog log("a.json", budget);
    const auto box = scene::read_body_box(scene::JsonObject(keys, "$", "$", log), folder, nullptr);
    EXPECT_TRUE(box) << box.error();
    EXPECT_EQ(log.faults(), 0u) << log.error().message;
    return box ? *box : BodyBox{};
}

/// The largest distance of a face of the box from the mesh's, in edges of the mesh.
double apart(const BodyBox& box, const windrow::Result<fur::Mesh>& mesh) {
    EXPECT_TRUE(mesh) << mesh.error();
    const glm::vec3 edges = glm::max(mesh->high - mesh->low, glm::vec3(1e-6f));
    const glm::vec3 off = glm::max(glm::abs(box.low - mesh->low), glm::abs(box.high - mesh->high)) / edges;
    return static_cast<double>(std::max({off.x, off.y, off.z}));
}

TEST(BodyBoxes, AreThoseOfTheMeshes) {
    using windrow::test::figure;
    EXPECT_LE(figure("body_box/sheet", apart(box_of(R"({"sheet": {"size": [2, 3], "wave": 0.1}})"),
                                             fur::sheet({.size = {2.0f, 3.0f}, .columns = 24, .rows = 24, .wave = 0.1f}))),
              0.02);
    EXPECT_LE(figure("body_box/globe_sphere", apart(box_of(R"({"globe_sphere": {}})"), fur::globe_sphere({}))), 0.01);
    EXPECT_LE(figure("body_box/cube_sphere",
                     apart(box_of(R"({"cube_sphere": {"radius": 0.17}})"), fur::cube_sphere({.radius = 0.17f}))),
              1e-6);
    EXPECT_LE(
        figure("body_box/beast", apart(box_of(R"({"beast": {"height": 3}})"), fur::beast_mesh({.height = 3.0f, .detail = 23}))),
        0.02);
    EXPECT_LE(figure("body_box/wing", apart(box_of(R"({"wing": {}})"), fur::wing({}))), 0.25);
    EXPECT_LE(figure("body_box/left_wing", apart(box_of(R"({"wing": {"left": true}})"), fur::wing({.left = true}))), 0.25);
    EXPECT_EQ(apart(box_of("{}"), fur::cube_sphere({})), 0.0) << "a body without a mesh is a ball";
}

TEST(BodyBoxes, OfAnObjAreThoseOfTheBody) {
    const test::Folder folder;
    folder.write("wedge.obj", "v 4 0 0\nv 0 1.25 0\nv 0 0 1\nv 0 0 -2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    for (const auto up : {fur::UpAxis::x, fur::UpAxis::y, fur::UpAxis::z}) {
        const std::string word = windrow::k_words<fur::UpAxis>.at(static_cast<std::size_t>(up));
        const BodyBox box =
            box_of(R"({"file": {"name": "wedge.obj", "size": 1.5, "yaw_deg": 30, "up": ")" + word + "\"}}", folder / "");
        EXPECT_LE(apart(box, fur::read_mesh(folder / "wedge.obj", {.up = up, .size = 1.5f, .yaw_deg = 30.0f})), 1e-6) << word;
    }
}

} // namespace
} // namespace windrow::vegetation::program
