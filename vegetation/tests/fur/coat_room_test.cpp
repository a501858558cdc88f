// The formula that takes back a strand's lean before the body's skin, on the CPU: the text that the device's pass includes.
#include "tests/figure.h"
#include "vegetation/fur/coat_room.h"
#include "vegetation/fur/shapes.h"
#include "vegetation/tests/fur/coat_numerics.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace windrow::vegetation::fur::test {
namespace {

using namespace numerics;

constexpr float k_length = 0.1f; // [m]

// A wall at x = `far` that faces the root at the origin.
WindrowSkinPatch wall(float far, float height) {
    return {glm::vec3(far, height, 0.0f), 0.05f, glm::vec3(-1.0f, 0.0f, 0.0f)};
}

// Of a place before it all is kept, of one behind it less, the farther the less; never less than nothing.
TEST(CoatRoom, LessIsKeptTheFartherAStrandIsBehindTheSkin) {
    const WindrowSkinPatch patch = wall(0.05f, 0.05f);
    const glm::vec3 root(0.0f), upright(0.0f, k_length, 0.0f);
    float last = 1.0f;
    for (int n = 0; n <= 100; ++n) {
        const glm::vec3 x(0.001f * static_cast<float>(n), 0.06f, 0.0f);
        const float kept = windrow_room_kept(patch, root, upright, x, 0.002f, k_length);
        if (x.x < 0.048f) {
            EXPECT_EQ(kept, 1.0f) << x.x;
        }
        EXPECT_GE(kept, 0.0f);
        EXPECT_LE(kept, last + 1e-6f) << x.x;
        EXPECT_LE(last - kept, 0.03f) << "1 mm of 10 cm takes it at once, at " << x.x;
        last = kept;
    }
    EXPECT_LT(last, 0.7f);
}

// Whatever else changes by little changes what is kept by little: where x lies beside the patch, how far behind it the root lies.
TEST(CoatRoom, WhatIsKeptIsContinuous) {
    struct Strand {
        glm::vec3 x, root, free;
    };
    const glm::vec3 none(0.0f), upright(0.0f, k_length, 0.0f);
    const auto steps = [&](const char* name, auto&& at) {
        double largest = 0.0;
        float last = -1.0f, low = 1.0f;
        for (int n = 0; n <= 2000; ++n) {
            const Strand strand = at(static_cast<float>(n) / 2000.0f);
            const float kept = windrow_room_kept(wall(0.05f, 0.05f), strand.root, strand.free, strand.x, 0.002f, k_length);
            if (n > 0)
                largest = std::max(largest, static_cast<double>(std::abs(kept - last)));
            last = kept;
            low = std::min(low, kept);
        }
        EXPECT_LT(low, 0.9f) << "the wall is never met";
        WINDROW_EXPECT_FIGURE(std::string("shells/room/") + name + "/largest_step", largest,
                              0.01); // of 2000: a jump would be 0.1 and more
    };
    steps("aside", [&](float t) { return Strand{glm::vec3(0.08f, 0.06f, 0.2f * t), none, upright}; });
    steps("behind", [&](float t) { return Strand{glm::vec3(0.08f, 0.06f, 0.0f), glm::vec3(0.1f * t, 0.0f, 0.0f), upright}; });
    steps("deep", [&](float t) { return Strand{glm::vec3(0.15f * t, 0.06f, 0.0f), none, upright}; });
    // The root on the wall itself: there is no length that is free.
    steps("rooted", [&](float t) {
        const glm::vec3 root(0.05f, 0.0f, 0.0f);
        return Strand{glm::vec3(0.045f + 0.03f * t, 0.06f, 0.0f), root, root};
    });
}

// All that bends a strand, weight too, goes with the lean: with all of it the strand is as it was, with none it stands.
TEST(CoatRoom, ALeanOfNothingStandsAndAWholeOneChangesNothing) {
    const auto shells = windrow::detail::shared(windrow::Shells::create({.shells = 8, .length = k_length, .sag = 0.9f})->block());
    const glm::vec3 n = glm::normalize(glm::vec3(1.0f, 0.4f, 0.2f));
    const glm::vec3 across = glm::normalize(glm::cross(n, glm::vec3(0.0f, 0.0f, 1.0f)));
    const glm::vec3 load = 0.8f * across, own = -0.4f * across, lag = 0.03f * across, more = 0.02f * across;
    const auto strand = windrow_coat_strand(shells, n, 0.9f, load, own, lag, more);
    const auto whole = windrow_coat_strand_leaning(shells, n, 0.9f, load, own, lag, more, 1.0f);
    const auto none = windrow_coat_strand_leaning(shells, n, 0.9f, load, own, lag, more, 0.0f);
    for (const float h : {0.25f, 0.5f, 1.0f}) {
        EXPECT_EQ(windrow_coat_shift(whole, h), windrow_coat_shift(strand, h));
        EXPECT_LT(glm::length(windrow_coat_shift(none, h)), 1e-8f);
    }
}

std::vector<CoatVertexBlock> blocks_of(const Mesh& mesh) {
    std::vector<CoatVertexBlock> made;
    for (const MeshVertex& v : mesh.vertices)
        made.push_back({glm::vec4(v.position, v.uv.x), glm::vec4(v.normal, v.uv.y), v.bones, v.weights});
    return made;
}

// Each place of the skin lies within a patch, on meshes coarser and finer than the patches.
TEST(CoatRoom, PatchesCoverTheSkin) {
    const auto expect_covered = [](const std::string& name, const Mesh& mesh, float length) {
        const std::vector<CoatVertexBlock> vertices = blocks_of(mesh);
        const std::vector<CoatPatchBlock> patches = skin_patches(vertices, mesh.indices, length);
        windrow::test::figure("shells/room/" + name + "/patches_a_triangle",
                              static_cast<double>(patches.size()) / static_cast<double>(mesh.triangles()));
        std::mt19937 chance(11);
        std::uniform_real_distribution<float> even(0.0f, 1.0f);
        double worst = 0.0;
        for (int n = 0; n < 500; ++n) {
            const std::size_t at = 3 * (chance() % mesh.triangles());
            const float root = std::sqrt(even(chance)), along = even(chance);
            const auto corner = [&](std::size_t k) { return mesh.vertices[mesh.indices[at + k]].position; };
            const glm::vec3 x = (1.0f - root) * corner(0) + root * (1.0f - along) * corner(1) + root * along * corner(2);
            double nearest = 1e9;
            for (const CoatPatchBlock& patch : patches) {
                const auto of = [&](std::uint32_t k) { return glm::vec3(vertices[k].position); };
                const glm::vec3 place = (1.0f - patch.weights.x - patch.weights.y) * of(patch.corners.x) +
                                        patch.weights.x * of(patch.corners.y) + patch.weights.y * of(patch.corners.z);
                nearest = std::min(nearest, static_cast<double>(glm::distance(x, place) / patch.radius));
            }
            worst = std::max(worst, nearest);
        }
        WINDROW_EXPECT_FIGURE("shells/room/" + name + "/off_a_patch", worst, 1.0);
    };
    expect_covered("coarse", *cube_sphere({.cells = 3}), 0.06f);
    expect_covered("fine", *cube_sphere({.cells = 40}), 0.3f);
    expect_covered("plane", *sheet({.size = {4.0f, 1.0f}}), 0.2f);
}

// Which vertices are looked at in each frame: none of a ball or a plane, those beside the edge of a bent sheet, all where bones move.
TEST(CoatRoom, OnlyHollowsAreNarrow) {
    const auto narrow_of = [](const Mesh& mesh, float length) {
        const std::vector<CoatVertexBlock> vertices = blocks_of(mesh);
        return narrow_vertices(vertices, vertices.size(), skin_patches(vertices, mesh.indices, length), length);
    };
    for (const float length : {0.02f, 0.2f, 0.5f})
        EXPECT_TRUE(narrow_of(*globe_sphere({}), length).empty()) << length;
    Mesh bent = *sheet({.size = {2.0f, 2.0f}, .columns = 20, .rows = 20});
    EXPECT_TRUE(narrow_of(bent, 0.2f).empty());
    for (MeshVertex& vertex : bent.vertices) { // folded up along x = 0
        const bool stands = vertex.position.x > 0.0f;
        vertex.normal = stands ? glm::vec3(-1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
        if (stands)
            vertex.position = {0.0f, vertex.position.x, vertex.position.z};
    }
    measure(bent);
    const std::vector<std::uint32_t> narrow = narrow_of(bent, 0.2f);
    EXPECT_GT(narrow.size(), 21u);
    for (const std::uint32_t n : narrow)
        EXPECT_LT(std::max(-bent.vertices[n].position.x, bent.vertices[n].position.y), 0.3f);
    for (MeshVertex& vertex : bent.vertices)
        vertex.weights = {1.0f, 0.0f, 0.0f, 0.0f};
    EXPECT_EQ(narrow_of(bent, 0.2f).size(), bent.vertices.size());
}

} // namespace
} // namespace windrow::vegetation::fur::test
