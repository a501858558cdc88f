// On posed meshes the push of the shells is applied after skinning: no vertex enters the surface, and no outer shell is below an
// inner one.
#include "coupling/shell.h"
#include "tests/figure.h"
#include "vegetation/files/mesh_file.h"
#include "vegetation/fur/beast.h"
#include "vegetation/tests/fur/folder.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <random>

namespace windrow::vegetation::fur {
namespace {

constexpr int k_pushes = 10'000;
constexpr float k_length = 0.06f; // [m] L

struct Posed {
    std::vector<glm::vec3> positions, normals;
};

Posed still(const Mesh& mesh) {
    Posed posed;
    for (const MeshVertex& vertex : mesh.vertices) {
        posed.positions.push_back(vertex.position);
        posed.normals.push_back(vertex.normal);
    }
    return posed;
}

// Random vertices, each with a push in a random direction, from nothing to a storm: translated by memory or velocity, and bent by
// wind. The least height over the surface, and the least step outwards from shell to shell, over L; both 0 or more in exact
// numbers.
void expect_outside(const Posed& posed, const std::string& name) {
    const auto shells = windrow::Shells::create({.shells = 8, .length = k_length, .push = 0.05f, .droop = 0.02f});
    ASSERT_TRUE(shells) << shells.error();
    std::mt19937 chance(19);
    std::normal_distribution<float> gauss;
    double lowest = 1.0, min_step = 1.0;
    for (int i = 0; i < k_pushes; ++i) {
        const std::size_t v = chance() % posed.positions.size();
        const glm::vec3 p = posed.positions[v], n = posed.normals[v];
        const glm::vec3 way = glm::normalize(glm::vec3(gauss(chance), gauss(chance), gauss(chance)));
        const float strength = static_cast<float>(i % 100) / 25.0f; // up to four times the push
        const glm::vec3 load = shells->load(n, 1.0f, way * 10.0f * strength);
        for (const bool bends : {false, true}) {
            double below = 0.0;
            for (int shell = 0; shell < 8; ++shell) {
                const float h = shells->height(shell);
                const glm::vec3 moved =
                    bends ? shells->bent(p, n, h, 1.0f, load) : shells->translated(p, n, h, 1.0f, way * strength);
                const double over = glm::dot(glm::dvec3(moved - p), glm::dvec3(n)) / static_cast<double>(k_length);
                lowest = std::min(lowest, over);
                if (shell > 0)
                    min_step = std::min(min_step, over - below);
                below = over;
            }
        }
    }
    // Rounding of positions of some metres, over L.
    WINDROW_EXPECT_FIGURE("shells/push/" + name + "/into_surface_L", -lowest, 1e-5);
    WINDROW_EXPECT_FIGURE("shells/push/" + name + "/passes_inner_L", -min_step, 1e-5);
}

TEST(PosedPush, TheBeastInThreePoses) {
    auto beast = beast_mesh();
    const auto bones = beast_skeleton();
    ASSERT_TRUE(beast) << beast.error();
    ASSERT_TRUE(bind(*beast, *bones));
    const Posed rest = still(*beast);
    for (const double seconds : {0.0, 0.4, 0.9}) {
        Posed posed = rest;
        ASSERT_TRUE(skin(*beast, pose(*bones, seconds), posed.positions, posed.normals));
        float moved = 0.0f, length = 0.0f;
        for (std::size_t i = 0; i < posed.positions.size(); ++i) {
            moved = std::max(moved, glm::length(posed.positions[i] - rest.positions[i]));
            length = std::max(length, std::abs(glm::length(posed.normals[i]) - 1.0f));
        }
        const std::string name = "beast_at_" + std::to_string(static_cast<int>(seconds * 10.0)) + "_tenths";
        EXPECT_GT(moved, 0.2f) << "a pose that moves nothing shows nothing"; // [m] of a beast of 2 m: its feet
        WINDROW_EXPECT_FIGURE("shells/push/" + name + "/normal_length_error", static_cast<double>(length), 1e-6);
        expect_outside(posed, name);
    }
}

TEST(PosedPush, TheBunnyAtRest) {
    WINDROW_NEEDS_GLMARK2("bunny.obj");
    const auto bunny = read_mesh(test::glmark2("bunny.obj"), {.max_triangles = 8'000});
    ASSERT_TRUE(bunny) << bunny.error();
    expect_outside(still(*bunny), "bunny");
}

// The normals that skinning gives stay those of the posed triangles: else "outwards" would mean little.
TEST(PosedPush, PosedNormalsFaceOutwards) {
    auto beast = beast_mesh();
    const auto bones = beast_skeleton();
    ASSERT_TRUE(bind(*beast, *bones));
    for (const double seconds : {0.0, 0.4, 0.9}) {
        Posed posed = still(*beast);
        ASSERT_TRUE(skin(*beast, pose(*bones, seconds), posed.positions, posed.normals));
        std::size_t against = 0;
        for (std::size_t i = 0; i < beast->indices.size(); i += 3) {
            const auto at = [&](std::size_t k) { return beast->indices[i + k]; };
            const glm::vec3 facing =
                glm::cross(posed.positions[at(1)] - posed.positions[at(0)], posed.positions[at(2)] - posed.positions[at(0)]);
            against += glm::dot(facing, posed.normals[at(0)] + posed.normals[at(1)] + posed.normals[at(2)]) < 0.0f;
        }
        // Where a leg folds, the skin of its inner side does: linear blending's known fault.
        WINDROW_EXPECT_FIGURE("shells/push/beast_at_" + std::to_string(static_cast<int>(seconds * 10.0)) + "_tenths/share_folded",
                              static_cast<double>(against) / static_cast<double>(beast->triangles()), 0.01);
    }
}

} // namespace
} // namespace windrow::vegetation::fur
