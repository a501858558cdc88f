// What a picture's file says, read: defaults, values, heights, masks, where the eye is, who jumps.
#include "coupling/plant_classes.h"
#include "vegetation/tests/program/specimen.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace windrow::vegetation::program {
namespace {

using test::Folder;

windrow::Result<PictureScene> read_picture(const std::string& picture) {
    return read_picture_scene_text(
        R"({"paths": {"walk": {"points": [[0, 0, 0.5, 0], [2, 4, 0.5, 0]]}}, "picture": )" + picture + "}", "a.json");
}

TEST(PictureReader, SceneWithoutAPictureHasTheStructuresDefaults) {
    const auto scene = read_picture_scene_text("{}", "a.json");
    ASSERT_TRUE(scene) << scene.error();
    const Picture& picture = scene->picture;
    EXPECT_EQ(picture.size, glm::ivec2(640, 360));
    EXPECT_EQ(scene->frames_per_second(), scene->air.frames_per_second);
    EXPECT_EQ(scene->frame_count(), scene->air.frame_count());
    EXPECT_EQ(picture.camera.lens.position, render::Camera{}.position);
    EXPECT_EQ(picture.sun.haze, render::Sun{}.haze);
    EXPECT_EQ(picture.fog.density, render::Fog{}.density);
    EXPECT_EQ(picture.ground.heights->extent(), glm::vec2(100.0f));
    EXPECT_EQ(picture.ground.height(3.0, -7.0), 0.0);
    EXPECT_TRUE(picture.grass.empty());
    EXPECT_FALSE(picture.ground_memory);
    EXPECT_EQ(picture.sampling.limit, windrow::Sampling{}.limit);
}

TEST(PictureReader, LayerWithoutKeysIsMeadowGrassEverywhere) {
    const auto scene = read_picture(R"({"grass": [{}]})");
    ASSERT_TRUE(scene) << scene.error();
    const GrassSource& layer = scene->picture.grass.at(0);
    EXPECT_EQ(layer.drawn.field.density, grass::GrassSettings{}.density);
    EXPECT_EQ(layer.drawn.field.blade.view_bend, grass::GrassSettings{}.blade.view_bend);
    EXPECT_EQ(layer.drawn.field.blade.stalk.rigidity, windrow::grass().rigidity);
    EXPECT_EQ(layer.drawn.look.tip, render::PlantLook{}.tip);
    ASSERT_TRUE(layer.mask.mask);
    EXPECT_EQ(layer.mask.mask->alpha({50.0f, 50.0f}), 1.0f);
}

TEST(PictureReader, ClassGivesTheStalkThatKeysThenChange) {
    const auto scene =
        read_picture(R"({"grass": [{"class": "reed"}, {"class": "reed", "length": 1.5, "stalk": {"rigidity": 2}}]})");
    ASSERT_TRUE(scene) << scene.error();
    const windrow::Drag& plain = scene->picture.grass[0].drawn.field.blade.stalk;
    const windrow::Drag& changed = scene->picture.grass[1].drawn.field.blade.stalk;
    EXPECT_EQ(plain.length, windrow::reed().length);
    EXPECT_EQ(plain.rigidity, windrow::reed().rigidity);
    EXPECT_EQ(changed.length, 1.5f);
    EXPECT_EQ(changed.rigidity, 2.0f);
    EXPECT_EQ(changed.drag_coefficient, windrow::reed().drag_coefficient);
}

TEST(PictureReader, HeightsAreTheFilesLevelsFromLowToHighAndItsHills) {
    const Folder folder;
    test::write_sample_files(folder);
    const auto scene = read_picture_scene_text(test::k_sample_values, folder / "a.json");
    ASSERT_TRUE(scene) << scene.error();
    const GroundSource& ground = scene->picture.ground;
    EXPECT_EQ(ground.heights->extent(), glm::vec2(80.0f, 40.0f));
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 9; ++column) {
            const glm::vec2 place = 10.0f * glm::vec2(column, row);
            const float height = 10.0f + 20.0f * static_cast<float>(column) / 8.0f + ground.hills.at(place);
            EXPECT_NEAR(ground.heights->heights()[static_cast<std::size_t>(9 * row + column)], height, 2e-3f)
                << column << ", " << row;
        }
    const double rim = static_cast<double>(ground.heights->heights()[0]);
    EXPECT_EQ(ground.height(100.0 - 20.0, -200.0), 1.0 + rim); // beyond the rim that of the rim, on the corner's height
}

TEST(PictureReader, HillsRiseUponLowToTheirHeightAndOtherSeedsGiveOthers) {
    const auto hills = [](int seed) {
        const auto scene =
            read_picture(R"({"ground": {"low": -3, "extent": [400, 400], "hills": {"height": 8, "length": 20, "seed": )" +
                         std::to_string(seed) + "}}}");
        EXPECT_TRUE(scene) << scene.error();
        return std::vector<float>(scene->picture.ground.heights->heights().begin(),
                                  scene->picture.ground.heights->heights().end());
    };
    const std::vector<float> some = hills(1);
    const auto [lowest, highest] = std::minmax_element(some.begin(), some.end());
    EXPECT_GE(*lowest, -3.0f);
    EXPECT_LE(*highest, 5.0f);
    EXPECT_GT(*highest - *lowest, 4.0f); // of 400 cells some are nearly as low and as high as can be
    EXPECT_EQ(some, hills(1));
    EXPECT_NE(some, hills(2));
}

TEST(PictureReader, HeightsOfEightBitsToo) {
    const Folder folder;
    folder.write("small.pgm", std::string("P5\n# a remark\n2 2\n255\n") + '\0' + '\xff' + '\0' + '\xff');
    const auto scene = read_picture_scene_text(
        R"({"picture": {"ground": {"heights": "small.pgm", "low": -2, "high": 2, "extent": [10, 10]}}})", folder / "a.json");
    ASSERT_TRUE(scene) << scene.error();
    EXPECT_EQ(scene->picture.ground.heights->heights()[0], -2.0f);
    EXPECT_EQ(scene->picture.ground.heights->heights()[1], 2.0f);
}

TEST(PictureReader, LevelGroundHasSquareTexelsThatFitItsSides) {
    for (const glm::dvec2 extent :
         {glm::dvec2(100.0, 33.3), glm::dvec2(500.0, 500.0), glm::dvec2(0.5, 2.0), glm::dvec2(7.0, 3.0)}) {
        const auto scene = read_picture(R"({"ground": {"low": 4, "extent": [)" + std::to_string(extent.x) + ", " +
                                        std::to_string(extent.y) + "]}}");
        ASSERT_TRUE(scene) << scene.error();
        const HeightMap& heights = *scene->picture.ground.heights;
        EXPECT_NEAR(heights.extent().x, extent.x, 1e-3 * heights.grid().spacing.x);
        EXPECT_NEAR(heights.extent().y, extent.y, 1e-3 * heights.grid().spacing.x);
        EXPECT_LE(heights.grid().spacing.x, std::max(1.0, extent.x / 250.0));
        EXPECT_EQ(scene->picture.ground.height(0.0, 0.0), 4.0);
    }
}

TEST(PictureReader, MaskIsItsFileOrEvenAndThenItsStrokes) {
    const Folder folder;
    test::write_sample_files(folder);
    const auto scene = read_picture_scene_text(test::k_sample_values, folder / "a.json");
    ASSERT_TRUE(scene) << scene.error();
    const grass::PlacementMask& painted = *scene->picture.grass[0].mask.mask;
    auto wanted = grass::PlacementMask::create({33, 17}, {80.0f, 40.0f}, 0.5f);
    ASSERT_TRUE(wanted) << wanted.error();
    ASSERT_TRUE(grass::thin_out(*wanted, {.share = 0.3f, .size = 6.0f, .seed = 4294967295u}));
    ASSERT_TRUE(grass::tread(*wanted, {.width = 1.5f, .at = 60.0f}));
    ASSERT_TRUE(wanted->paint({.centre = {20.0f, 10.0f}, .radius = 8.0f, .strength = 0.75f, .hardness = 0.25f}));
    ASSERT_TRUE(wanted->erase({.centre = {40.0f, 20.0f}, .radius = 4.5f, .strength = 0.9f, .hardness = 0.6f}));
    EXPECT_EQ(painted.grid().corners, wanted->grid().corners);
    EXPECT_TRUE(std::equal(painted.values().begin(), painted.values().end(), wanted->values().begin(), wanted->values().end()));
    const grass::PlacementMask& drawn = *scene->picture.grass[1].mask.mask;
    EXPECT_EQ(drawn.alpha({40.0f, 1.0f}), 1.0f);
    EXPECT_EQ(drawn.alpha({40.0f, 39.0f}), 0.0f);
}

TEST(PictureReader, CameraMovesOnItsPathAboveTheGround) {
    const Folder folder;
    test::write_sample_files(folder);
    const auto scene = read_picture_scene_text(test::k_sample_values, folder / "a.json");
    ASSERT_TRUE(scene) << scene.error();
    const render::Camera eye = camera_at(*scene, 2.0);
    EXPECT_EQ(eye.position.x, 3.0);
    EXPECT_EQ(eye.position.y, 1.5 + scene->picture.ground.height(3.0, 2.0));
    EXPECT_EQ(eye.target.y, 1.0 + scene->picture.ground.height(1.0, -20.0));
    EXPECT_EQ(eye.exposure, 0.72f);
}

TEST(PictureReader, WalkerWalksAndJumpsOnAParabola) {
    const auto scene = read_picture(
        R"({"ground_memory": {}, "walkers": [{"path": "walk", "weight": 0.5, "airborne": [{"from": 1, "until": 2, "height": 0.8}]}]})");
    ASSERT_TRUE(scene) << scene.error();
    const windrow::GroundWalker step = walker_at(*scene, scene->picture.walkers.at(0), 1.25, 1.5);
    EXPECT_EQ(step.previous.x, 2.5);
    EXPECT_EQ(step.position.x, 3.0);
    EXPECT_FLOAT_EQ(step.foot_height, 0.8f);
    EXPECT_FLOAT_EQ(step.previous_foot_height, 0.6f); // 4 (1/4) (3/4) of it
    EXPECT_EQ(scene->picture.walkers[0].foot_height(0.9), 0.0f);
    EXPECT_EQ(scene->picture.walkers[0].foot_height(2.0), 0.0f);
    EXPECT_EQ(step.weight, 0.5f);
}

TEST(PictureReader, ExampleOfTheDocumentsIsRead) {
    std::ifstream file(std::filesystem::path(WINDROW_SOURCE_DIR) / "docs" / "scenes.md");
    const std::string page((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    const std::size_t begin = page.find("```json\n", page.find("## The picture")) + 8;
    const auto scene = read_picture_scene_text(page.substr(begin, page.find("```", begin) - begin), "a.json");
    ASSERT_TRUE(scene) << scene.error();
    EXPECT_EQ(scene->picture.grass.at(1).plant, "reed");
    EXPECT_EQ(scene->frame_count(), 301);
    EXPECT_EQ(scene->picture.grass[0].mask.mask->alpha({100.0f, 140.0f}), 0.0f);
}

TEST(PictureReader, ScenesThatComeWithTheProjectAreRead) {
    const std::filesystem::path folder = std::filesystem::path(WINDROW_SOURCE_DIR) / "examples" / "scenes";
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".json" && entry.path().filename() != "scene.schema.json") {
            const auto scene = read_picture_scene(entry.path());
            EXPECT_TRUE(scene) << scene.error();
            ++count;
        }
    EXPECT_GE(count, 10);
}

} // namespace
} // namespace windrow::vegetation::program
