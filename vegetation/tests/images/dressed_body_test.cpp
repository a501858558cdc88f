// What dresses a scene's bodies, without a picture: meshes and their fur lines, parts, how far the air carries a pattern.
#include "tests/figure.h"
#include "vegetation/program/furred_body.h"
#include "vegetation/program/picture_reader.h"
#include "vegetation/tests/program/specimen.h"

#include <algorithm>
#include <cmath>

namespace windrow::vegetation::program {
namespace {

using test::Folder;

constexpr const char* k_furred = R"({"picture": {"bodies": [
    {"mesh": {"file": {"name": "tent.obj", "size": 2}}, "coats": [{}, {"material": "felt"}]}, {"mesh": {"file": {"name": "none.obj"}}}]}})";

/// A pyramid, whose one side is of felt and whose others have a coat in their mtl.
void write_tent(const Folder& folder) {
    folder.write("tent.mtl", "newmtl fur\nfur 48 0.419 2.753 11\nnewmtl felt\n");
    folder.write(
        "tent.obj",
        "mtllib tent.mtl\nv 0 0 0\nv 4 0 0\nv 0 0 4\nv 0 4 0\nusemtl fur\nf 1 2 3\nf 1 4 2\nf 1 3 4\nusemtl felt\nf 2 4 3\n");
}

TEST(FurredBody, FurLineOfTheFileIsItsCoat) {
    const Folder folder;
    write_tent(folder);
    const auto scene = read_picture_scene_text(k_furred, folder / "a.json");
    ASSERT_TRUE(scene) << scene.error();
    const Body& body = scene->picture.bodies.at(0);
    windrow::detail::InputBudget budget;
    const auto model = model_of(*scene, body, budget);
    ASSERT_TRUE(model) << model.error();
    const auto whole = parts_of(model->mesh, body.coats.at(0)), felt = parts_of(model->mesh, body.coats.at(1));
    ASSERT_TRUE(whole && felt);
    EXPECT_EQ(whole->size(), 2u);
    ASSERT_EQ(felt->size(), 1u);
    EXPECT_FALSE(felt->front().fur);
    const auto fur = std::find_if(whole->begin(), whole->end(), [](const fur::MeshPart& part) { return part.fur.has_value(); });
    ASSERT_NE(fur, whole->end());
    const fur::CoatSettings settings = settings_of(body.coats.at(0), fur->fur);
    EXPECT_EQ(settings.layers.shells, 48);
    EXPECT_FLOAT_EQ(settings.layers.length, 0.2095f); // the file's 4 units are 2 m
    EXPECT_EQ(settings.strands.thickness, 2.753f);
    EXPECT_EQ(settings.strands.density, 11.0f);
    const auto absent = parts_of(model->mesh, {.material = "silk"});
    ASSERT_FALSE(absent);
    EXPECT_EQ(absent.error(), "material is \"silk\", and the mesh has \"fur\", \"felt\"; name one of these, or none for all.");
    EXPECT_FALSE(model_of(*scene, scene->picture.bodies.at(1), budget)); // no such file: reported when it is drawn
}

TEST(FurredBody, PatternDriftsAsTheWindTimesTheTime) {
    // The pattern drifts by wind times time, within a texel. Without a profile the wind is the same everywhere, with one it is
    // that of the body's own height.
    const auto scene = read_picture_scene_text(
        R"({"air": {"ambient": [9, 0, -2.5], "gusts": {"intensity": 0.5}}, "picture": {"bodies": [{"place": {"position": [0, 70, 0]}}]}})",
        "a.json");
    ASSERT_TRUE(scene) << scene.error();
    double worst = 0.0;
    for (const double time : {0.0, 1.0 / 60.0, 7.3, 3600.0, 86400.0}) {
        const glm::dvec2 off = drift_of(*scene, scene->picture.bodies.at(0), time) - time * glm::dvec2(9.0, -2.5);
        worst = std::max(worst, std::hypot(off.x, off.y));
    }
    WINDROW_EXPECT_FIGURE("images/furred_body/drift_m", worst, 1e-9);
    const auto sheared = read_picture_scene_text(
        R"({"air": {"ambient": [9, 0, 0], "profile": {}, "boundaries": {"y_low": "free_slip"}}, "picture": {"bodies": [{"place": {"position": [0, 70, 0]}}]}})",
        "a.json");
    ASSERT_TRUE(sheared) << sheared.error();
    const windrow::LogProfile profile;
    const double rough = static_cast<double>(profile.roughness_length), reference = static_cast<double>(profile.reference_height);
    const double wanted = 9.0 * std::log((70.0 + rough) / rough) / std::log((reference + rough) / rough);
    EXPECT_NEAR(drift_of(*sheared, sheared->picture.bodies.at(0), 100.0).x, 100.0 * wanted, 1e-3);
}

} // namespace
} // namespace windrow::vegetation::program
