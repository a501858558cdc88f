// Strands of the pictured bunny and beast against their whole posed skin: what fraction lies inside of the body, by ray parity.
//
// Strands are those of the device: its own vertices of the skin, with bones, wind, weight, comb and lag; between vertices a strand
// is where a layer's triangle is.
#include "tests/figure.h"
#include "tests/tier.h"
#include "vegetation/files/mesh_file.h"
#include "vegetation/program/dressed_body.h"
#include "vegetation/program/picture_reader.h"
#include "vegetation/tests/fur/coat_numerics.h"
#include "vegetation/tests/fur/folder.h"
#include "vegetation/tests/fur/inside_body.h"
#include "vegetation/tests/fur/stage.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <random>

namespace windrow::vegetation::fur::test {
namespace {

using namespace numerics;

/// A body of a scene of examples/scenes/fur, at a time and turned about the vertical: the wind comes from another side.
struct Subject {
    program::PictureScene scene;
    const program::Body* body = nullptr;
    program::BodyModel model{};
    CoatSettings coat{};
    glm::vec3 wind{0.0f}; ///< unit
};

Subject subject(const char* name, Mesh mesh) {
    auto scene =
        program::read_picture_scene(std::filesystem::path(WINDROW_SOURCE_DIR) / "examples/scenes/fur" / (std::string(name) + ".json"));
    EXPECT_TRUE(scene) << scene.error();
    Subject made{.scene = *std::move(scene)};
    made.model.mesh = std::move(mesh);
    made.wind = glm::normalize(made.scene.air.air.ambient);
    return made;
}

windrow::Pose posed(const Subject& of, double time, double turn) {
    windrow::Pose pose = program::pose_of(of.scene, *of.body, time);
    const glm::dquat own(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
    const glm::dquat all = glm::angleAxis(turn, glm::dvec3(0.0, 1.0, 0.0)) * own;
    pose.rotation = {all.x, all.y, all.z, all.w};
    pose.position = k_anchor + glm::angleAxis(turn, glm::dvec3(0.0, 1.0, 0.0)) * pose.position;
    return pose;
}

// [m] Of a vertex's layer at height h, from the anchor.
glm::dvec3 layer_place(const Coat& coat, const CoatSkinBlock& skin, float h) {
    const auto shells = windrow::detail::shared(coat.block().shells);
    const WindrowCoatStrand strand =
        windrow_coat_strand(shells, glm::vec3(skin.normal), skin.position.w, glm::vec3(skin.load), glm::vec3(skin.own),
                            glm::vec3(skin.lag), glm::vec3(skin.lag_more));
    return glm::dvec3(glm::vec3(skin.position)) +
           (1.0 - static_cast<double>(skin.load.w)) *
               glm::dvec3((strand.stem.reach * h + shells.form.x * shells.form.z) * glm::vec3(skin.normal) +
                      windrow_coat_shift(strand, h));
}

struct Inside {
    double tips = 0.0, middles = 0.0, roots = 0.0; ///< of all strands
    int strands = 0;
};

/// Strands over the whole coat, as many a square metre everywhere.
Inside inside_of(const Coat& coat, const Mesh& mesh, int strands) {
    const std::vector<CoatSkinBlock> skins = engine::must(coat.skin());
    // The coat has its vertices in the order of first use.
    std::vector<std::uint32_t> number(mesh.vertices.size(), ~0u), indices;
    std::uint32_t next = 0;
    for (const std::uint32_t index : mesh.indices) {
        if (number[index] == ~0u)
            number[index] = next++;
        indices.push_back(number[index]);
    }
    std::vector<glm::dvec3> positions;
    for (const CoatSkinBlock& skin : skins)
        positions.emplace_back(glm::vec3(skin.position));
    const InsideBody inside(positions, indices);

    std::vector<double> area{0.0};
    for (std::size_t n = 0; n < indices.size(); n += 3)
        area.push_back(area.back() + 0.5 * glm::length(glm::cross(positions[indices[n + 1]] - positions[indices[n]],
                                                                  positions[indices[n + 2]] - positions[indices[n]])));
    std::mt19937 chance(7);
    std::uniform_real_distribution<double> even(0.0, 1.0);
    const StrandFieldSettings& field = coat.settings().strands;
    Inside made;
    while (made.strands < strands) {
        const auto found = std::upper_bound(area.begin(), area.end(), even(chance) * area.back());
        const std::size_t triangle = std::min<std::size_t>(static_cast<std::size_t>(found - area.begin()), area.size() - 1) - 1;
        const double root = std::sqrt(even(chance)), along = even(chance);
        const glm::dvec3 weight{1.0 - root, root * (1.0 - along), root * along};
        const double reach = field.low + (field.high - field.low) * even(chance);
        double map = 0.0;
        for (std::size_t k = 0; k < 3; ++k)
            map += weight[static_cast<int>(k)] * skins[indices[3 * triangle + k]].position.w;
        if (map < std::max(0.02, double{coat.settings().maps.bald_below}))
            continue;
        const auto at = [&](double h) {
            glm::dvec3 place(0.0);
            for (std::size_t k = 0; k < 3; ++k)
                place += weight[static_cast<int>(k)] * layer_place(coat, skins[indices[3 * triangle + k]], static_cast<float>(h));
            return place;
        };
        made.tips += inside(at(map * reach));
        made.middles += inside(at(0.5 * map * reach));
        made.roots += inside(at(0.02 * map * reach));
        ++made.strands;
    }
    made.tips /= strands;
    made.middles /= strands;
    made.roots /= strands;
    return made;
}

void expect_outside(const Subject& of, const std::string& name, double bound) {
    const double second = 1.0 / 60.0;
    for (const float speed : {0.0f, 5.0f, 10.0f, 20.0f}) {
        Stage stage({.ambient = speed * of.wind, .width = 16, .height = 16});
        Coat& coat = stage.dress(of.model.mesh, of.coat, at({}));
        int pose = 0;
        for (const double time : {0.0, 0.4, 0.9}) {
            const double turn = 2.1 * pose;
            ASSERT_TRUE(coat.move(0.0, posed(of, time - 0.5, turn)));
            for (int step = 30; step >= 0; --step) {
                const double now = time - second * step;
                std::vector<glm::mat4> bones;
                if (of.model.skeleton)
                    bones = fur::pose(*of.model.skeleton, now);
                ASSERT_TRUE(coat.move(second, posed(of, now, turn), bones));
                if (step < 2)
                    stage.draw(camera_at({0.0, 900.0, 0.0}, {1.0, 1000.0, 0.0}), second);
            }
            const Inside found = inside_of(coat, of.model.mesh, windrow::test::sampled(20'000, 5'000));
            const std::string row =
                "shells/outside/" + name + "/" + std::to_string(static_cast<int>(speed)) + "_m_s/pose_" + std::to_string(pose++);
            WINDROW_EXPECT_FIGURE(row + "/tips", found.tips, bound);
            windrow::test::figure(row + "/middles", found.middles);
            windrow::test::figure(row + "/roots", found.roots);
        }
    }
}

TEST(StrandsOutside, OfTheBunny) {
    WINDROW_NEEDS_GLMARK2("bunny.obj");
    Subject bunny = subject("bunny", {});
    bunny.body = &bunny.scene.picture.bodies.at(1);
    bunny.coat = bunny.body->coats.front().coat;
    bunny.coat.maps.length.clear();
    bunny.coat.maps.colour.clear();
    bunny.coat.levels.shadow_shells = 0;
    auto mesh = read_mesh(glmark2("bunny.obj"), std::get<program::MeshSource>(bunny.body->mesh).load);
    ASSERT_TRUE(mesh) << mesh.error();
    bunny.model.mesh = *std::move(mesh);
    expect_outside(bunny, "bunny", 1e-3);
}

TEST(StrandsOutside, OfTheBeastThatWalks) {
    Subject beast = subject("beast", {});
    beast.body = &beast.scene.picture.bodies.at(1);
    beast.coat = beast.body->coats.front().coat;
    beast.coat.levels.shadow_shells = 0;
    windrow::detail::InputBudget budget;
    auto model = program::model_of(beast.scene, *beast.body, budget);
    ASSERT_TRUE(model) << model.error();
    beast.model = *std::move(model);
    expect_outside(beast, "beast", 1e-3);
}

} // namespace
} // namespace windrow::vegetation::fur::test
