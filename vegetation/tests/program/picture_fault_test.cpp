// Pictures that are rejected, and the sentence that each gets: file, place, value, fix.
#include "vegetation/tests/program/specimen.h"

namespace windrow::vegetation::program {
namespace {

using test::Folder;

std::string rejection(const std::string& picture, const std::filesystem::path& file = "a.json") {
    const auto scene = read_picture_scene_text(
        R"({"paths": {"walk": {"points": [[0, 0, 1.5, 0], [2, 4, 1.5, 0]]}}, "picture": )" + picture + "}", file);
    return scene ? std::string() : scene.error();
}

void expect_rejection(const std::string& picture, const std::string& sentence) {
    EXPECT_EQ(rejection(picture), sentence) << picture;
}

TEST(PictureFault, TextThatIsNoPicture) {
    expect_rejection("3", "a.json: $.picture is 3: give an object, {...}.");
    EXPECT_TRUE(rejection(R"({"camera": {"view_deg": NaN}})").ends_with("NaN is not a JSON number: give a finite number."));
    EXPECT_TRUE(rejection(R"({"fog": {"base": 1e999}})").ends_with("give one that fits a double (up to 1.8e308)."));
    expect_rejection(R"({"camera": []})", "a.json: $.picture.camera is []: give an object, {...}.");
    expect_rejection(R"({"grass": {}})", "a.json: $.picture.grass is {}: give a list, [...].");
    expect_rejection(R"({"grass": [1]})", "a.json: $.picture.grass[0] is 1: give an object, {...}.");
    expect_rejection(R"({"trees": {"kind": "oak"}})", "a.json: $.picture.trees is {\"kind\":\"oak\"}: give a list, [...].");
    expect_rejection(R"({"trees": [{"kind": "palm"}]})",
                     "a.json: $.picture.trees[0].kind is \"palm\": give one of \"oak\", \"birch\", \"spruce\", \"bush\".");
    expect_rejection(R"({"trees": [{"scatter": {"low": [5, 0], "high": [5, 1]}}]})",
                     "a.json: $.picture.trees[0].scatter.high.x is 5 m: give more than "
                     "$.picture.trees[0].scatter.low.x, which is 5 m.");
    expect_rejection(R"({"trees": [{}, 7]})", "a.json: $.picture.trees[1] is 7: give an object, {...}.");
    expect_rejection(R"({"size": [640]})", "a.json: $.picture.size is [640]: give two numbers, [width, height].");
    expect_rejection(R"({"size": [640, 360.5]})", "a.json: $.picture.size[1] is 360.5: give a whole number.");
    expect_rejection(R"({"camera": {"above_ground": 1}})", "a.json: $.picture.camera.above_ground is 1: give true or false.");
    expect_rejection(R"({"ground": {"extent": ["a", 1]}})", "a.json: $.picture.ground.extent[0] is \"a\": give a number.");
}

TEST(PictureFault, ValuesOutOfRange) {
    expect_rejection(R"({"size": [8, 100000]})", "a.json: $.picture.size[0] is 8 px: give 16 to 8192 px.\n"
                                                 "a.json: $.picture.size[1] is 100000 px: give 16 to 8192 px.");
    expect_rejection(R"({"warm_up": -1})", "a.json: $.picture.warm_up is -1 s: give 0 to 3600 s.");
    expect_rejection(R"({"frames_per_second": 0})", "a.json: $.picture.frames_per_second is 0 1/s: give 0.001 to 10000 1/s.");
    expect_rejection(R"({"camera": {"view_deg": 179, "exposure": 0}})",
                     "a.json: $.picture.camera.view_deg is 179 deg: give 1 to 150 deg.\n"
                     "a.json: $.picture.camera.exposure is 0: give 1e-6 to 1e6.");
    expect_rejection(R"({"quality": {"light_bytes": 6}})", "a.json: $.picture.quality.light_bytes is 6: give 4 or 8.");
    expect_rejection(R"({"grass": [{"far_vertices": 6}]})",
                     "a.json: $.picture.grass[0].far_vertices is 6: give 5 or 7, rows of two and the tip.");
    expect_rejection(R"({"sun": {"haze": -0.1}})", "a.json: $.picture.sun.haze is -0.1: give 0 to 0.5.");
    expect_rejection(R"({"grass": [{"density": 1e300}]})",
                     "a.json: $.picture.grass[0].density is 1e300 1/m: give 0.1 to 64 1/m.");
    expect_rejection(R"({"grass": [{"taper": 0}]})", "a.json: $.picture.grass[0].taper is 0: give a number above 0, at most 10.");
    expect_rejection(R"({"grass": [{"seed": 4294967296}]})", "a.json: $.picture.grass[0].seed is 4294967296: give 0 to "
                                                             "4294967295.");
    expect_rejection(R"({"grass": [{"look": {"tip": [0.2, 1.5, 0]}}]})",
                     "a.json: $.picture.grass[0].look.tip[1] is 1.5: give 0 to 1.");
    expect_rejection(R"({"grass": [{"mask": {"even": 2}}]})", "a.json: $.picture.grass[0].mask.even is 2: give 0 to 1.");
    expect_rejection(R"({"grass": [{"mask": {"corners": [1, 20000]}}]})",
                     "a.json: $.picture.grass[0].mask.corners[0] is 1: give 2 to 4097.\n"
                     "a.json: $.picture.grass[0].mask.corners[1] is 20000: give 2 to 4097.");
    expect_rejection(R"({"sampling": {"detail": 2}})", "a.json: $.picture.sampling.detail is 2: give 0 (none) to 1.");
    expect_rejection(R"({"ground_memory": {"spring": {"damping": -1}}})",
                     "a.json: $.picture.ground_memory.spring.damping is -1: give 0 to 1000.");
}

TEST(PictureFault, ValuesThatDoNotFitTogether) {
    expect_rejection(R"({"camera": {"near": 10, "far": 5}})",
                     "a.json: $.picture.camera.far is 5 m: give 1.01 to 1e6 times near, 10.1 to 1e7 m.");
    expect_rejection(
        R"({"camera": {"position": [0, 5, 0], "target": [0, 0, 0]}})",
        "a.json: $.picture.camera.target is straight above, below or at $.picture.camera.position: move it aside, so "
        "that the picture has an up direction.");
    expect_rejection(R"({"grass": [{"split_distance": 100}]})",
                     "a.json: $.picture.grass[0].split_distance is 100 m: give less than "
                     "$.picture.grass[0].cut_distance, which is 90 m.");
    expect_rejection(
        R"({"grass": [{}, {"look": {"tip": [0.9, 0.9, 0.9]}}]})",
        "a.json: $.picture.grass[1].look has a brightest colour that makes 1.191875 with (1 + against_light / 10) times "
        "what shines through it: give at most 0.6, by darker colours.");
    expect_rejection(R"({"ground_memory": {"texels": 8, "texel_size": 0.5}})",
                     "a.json: $.picture.ground_memory.blend_width is 2 m: give at most a quarter of the window, 1 m.");
    expect_rejection(
        R"({"frames_per_second": 10000, "warm_up": 0, "walkers": []})",
        "a.json: $.picture.frames_per_second is 10000 1/s, which makes 100001 pictures: give at most 100000 of them, "
        "by a smaller one or a shorter $.duration.");
    expect_rejection(R"({"walkers": [{"path": "walk"}]})",
                     "a.json: $.picture.walkers is given, but \"ground_memory\" is not: add "
                     "\"ground_memory\": {}, or remove it.");
    expect_rejection(R"({"ground_memory": {}, "walkers": [{"path": "walk", "airborne": [{"from": 2, "until": 2}]}]})",
                     "a.json: $.picture.walkers[0].airborne[0].until is 2 s, not after \"from\", 2 s: give a later time.");
    expect_rejection(R"({"grass": [{"mask": {"file": "mask.pgm", "even": 1}}]})",
                     "a.json: $.picture.grass[0].mask holds both \"file\" and \"even\": keep one of them.");
    expect_rejection(
        R"({"grass": [{"mask": {"strokes": [{}, {"paint": {}, "erase": {}}]}}]})",
        "a.json: $.picture.grass[0].mask.strokes[0] holds neither \"paint\" or \"erase\": give one of them.\n"
        "a.json: $.picture.grass[0].mask.strokes[1] holds more than one of \"paint\" or \"erase\": keep one of them.");
}

TEST(PictureFault, PathsThatThereAreNot) {
    expect_rejection(R"({"camera": {"path": "wolk"}})", "a.json: $.picture.camera.path is \"wolk\", which is not in $.paths "
                                                        "(did you mean `walk`?): add it there or name another.");
    expect_rejection(R"({"ground_memory": {}, "walkers": [{}]})", "a.json: $.picture.walkers[0] has no \"path\": add it.");
    expect_rejection(R"({"camera": {"path": "walk", "position": [0, 0, 0]}})",
                     "a.json: $.picture.camera holds both \"position\" and \"path\": keep one of them.");
    // The eye walks over what it looks at.
    expect_rejection(
        R"({"camera": {"path": "walk", "target": [2, 0, 0]}, "frames_per_second": 1})",
        "a.json: $.picture.camera.target is straight above, below or at $.picture.camera.position: move it aside, so "
        "that the picture has an up direction.\na.json: $.picture.camera has this fault at 1 s on its paths: change one of "
        "them.");
}

TEST(PictureFault, PatchesPathsAndHillsOutOfRange) {
    expect_rejection(R"({"grass": [{"mask": {"bare": 1}}]})",
                     "a.json: $.picture.grass[0].mask.bare is 1: give 0 (no patches) to 0.95.");
    expect_rejection(R"({"grass": [{"mask": {"bare_size": 0}}]})",
                     "a.json: $.picture.grass[0].mask.bare_size is 0 m: give 0.2 to 1000 m.");
    expect_rejection(R"({"grass": [{"mask": {"path": {"width": -1}}}]})",
                     "a.json: $.picture.grass[0].mask.path.width is -1 m: give 0 (no path) to 20 m.");
    expect_rejection(R"({"ground": {"hills": {"length": 0}}})",
                     "a.json: $.picture.ground.hills.length is 0 m: give 1 to 100000 m.");
    expect_rejection(R"({"grass": [{"max_blades": 3}]})", "a.json: $.picture.grass[0].max_blades is 3: give 1024 to 4194304.");
}

TEST(PictureFault, KeysThatNobodyKnows) {
    expect_rejection(R"({"camra": {}})",
                     "a.json: $.picture.camra is not a known key (did you mean `camera`?): rename or remove it.");
    expect_rejection(R"({"grass": [{"lenght": 1}]})",
                     "a.json: $.picture.grass[0].lenght is not a known key (did you mean `length`?): rename or remove it.");
    EXPECT_TRUE(rejection(R"({"grass": [{"class": "weat"}]})")
                    .starts_with("a.json: $.picture.grass[0].class is \"weat\": give one of \"grass\", \"wheat\", \"reed\""));
}

TEST(PictureFault, LooksOfObstacles) {
    expect_rejection(R"({"obstacles": [{}, {"name": "roof"}]})",
                     "a.json: $.picture.obstacles[0] is for \"obstacle\", but no obstacle of $.obstacles has that name: give one "
                     "of theirs.\n"
                     "a.json: $.picture.obstacles[1] is for \"roof\", but no obstacle of $.obstacles has that name: give one of "
                     "theirs.");
    expect_rejection(R"({"obstacles": [{"colour": [0.5, 2, 0]}]})",
                     "a.json: $.picture.obstacles[0].colour[1] is 2: give 0 to 1.");
    expect_rejection(
        R"({"obstacles": [{"windows": {"width": 0, "pane": 1}}]})",
        "a.json: $.picture.obstacles[0].windows.width is 0 m: give a number above 0, at most 1000 m.\n"
        "a.json: $.picture.obstacles[0].windows.pane is not a known key (known: width, height, spacing, storey, sill, "
        "door, glass, frame): rename or remove it.");
}

TEST(PictureFault, FaultsOfTheAirAndOfThePictureAreToldAtOnce) {
    const auto scene = read_picture_scene_text(R"({"tick_hz": 0, "picture": {"warm_up": -1}})", "a.json");
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error(),
              "a.json: $.tick_hz is 0 Hz: give 1 to 10000 Hz.\na.json: $.picture.warm_up is -1 s: give 0 to 3600 s.");
}

TEST(PictureFault, FilesThatAreMissingCutOrNone) {
    const Folder folder;
    test::write_sample_files(folder);
    folder.write_pgm("tall.pgm", 3, 2, [](int, int) { return 0; });
    folder.write("cut.pgm", "P5\n9 5\n65535\n1234");
    folder.write("huge.pgm", "P5\n2147483647 2147483647\n65535\n");
    folder.write("wide.pgm", "P5\n5000 2\n255\n" + std::string(10000, '\0'));
    folder.write("text.pgm", "not a picture");
    const auto ground = [&](const std::string& keys) { return rejection(R"({"ground": {)" + keys + "}}", folder / "a.json"); };
    const std::string start = (folder / "a.json").string() + ": $.picture.ground.", at = (folder / "").string();
    EXPECT_EQ(ground(R"("heights": "hils.pgm")"),
              start + "heights is \"hils.pgm\": " + at +
                  "hils.pgm: no such file: check the name, which is sought beside the file that gives it.");
    EXPECT_EQ(ground(R"("heights": "cut.pgm", "extent": [80, 40])"),
              start + "heights is \"cut.pgm\": " + at + "cut.pgm ends early: it has 17 bytes of 103; save it again.");
    EXPECT_EQ(ground(R"("heights": "huge.pgm")"),
              start + "heights is \"huge.pgm\": " + at +
                  "huge.pgm ends early: it has 31 bytes of 9223372028264841249; save it again.");
    EXPECT_EQ(ground(R"("heights": "text.pgm")"), start + "heights is \"text.pgm\": " + at +
                                                      "text.pgm is not a PGM of up to 65535 levels: save the image as PGM (P5).");
    EXPECT_EQ(ground(R"("heights": "wide.pgm")"),
              start + "heights is \"wide.pgm\", which has 5000 x 2 pixels: give 2 to 4097 a side.");
    EXPECT_EQ(
        ground(R"("heights": "tall.pgm")"),
        start + "extent is [100, 100] m, which makes the 3 x 2 pixels of \"heights\" not square: give [100, 50] m, whose pixels "
                "are square.");
    EXPECT_EQ(ground(R"("heights": "../hills.pgm")"),
              start + "heights is \"../hills.pgm\": name a file in the scene's folder, relative to it, so that the folder can be "
                      "copied as a whole.");
    EXPECT_EQ(ground(R"("heights": 3)"), start + "heights is 3: give a string in double quotes.");
    EXPECT_EQ(ground(R"("heights": "hills.pgm", "extent": [80, 40], "low": 5, "high": 5)"),
              start + "high is 5 m, not above \"low\", 5 m: give more.");
    EXPECT_EQ(ground(R"("extent": [1, 3.14159])"),
              start + "extent is [1, 3.14159] m, which no grid of square texels fits: give two lengths in a ratio of whole "
                      "numbers.");
    EXPECT_EQ(rejection(R"({"grass": [{"mask": {"file": "none.pgm"}}]})", folder / "a.json"),
              (folder / "a.json").string() + ": $.picture.grass[0].mask.file is \"none.pgm\": " + at +
                  "none.pgm: no such file: check the name, which is sought beside the file that gives it.");
    EXPECT_FALSE(read_picture_scene(folder / "none.json"));
}

TEST(PictureFault, EveryBeginningOfASceneIsRejected) {
    const Folder folder;
    test::write_sample_files(folder);
    const std::string whole = test::k_sample_values;
    for (std::size_t size = 0; size + 1 < whole.size(); size += 7)
        EXPECT_FALSE(read_picture_scene_text(whole.substr(0, size), folder / "a.json")) << size;
}

} // namespace
} // namespace windrow::vegetation::program
