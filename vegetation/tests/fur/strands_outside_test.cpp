// Strands of the pictured bunny and beast against their whole posed skin: what fraction lies inside of the body, by ray parity.
//
// Strands are the device's: its own vertices of the skin, with bones, wind, weight, comb and lag; between vertices a strand is where
// a layer's triangle is.
#include "tests/figure.h"
#include "tests/tier.h"
#include "vegetation/tests/fur/clothed_subject.h"
#include "vegetation/tests/fur/inside_body.h"

#include <cmath>
#include <cstring>
#include <random>

namespace windrow::vegetation::fur::test {
namespace {

constexpr double k_step = 1.0 / 60.0; // [s]

/// Of all strands: fractions whose places lie in the body, and what of their lean and length is taken, in the mean.
struct Inside {
    double tips = 0.0, middles = 0.0, lean = 0.0, length = 0.0;
};

/// Strands over the whole coat, as many a square metre everywhere.
Inside inside_of(const Coat& coat, const Mesh& mesh, int strands) {
    const std::vector<CoatSkinBlock> skins = engine::must(coat.skin());
    std::vector<std::uint32_t> number(mesh.vertices.size(), ~0u), indices; // of the coat: in the order of first use
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
        area.push_back(area.back() + glm::length(glm::cross(positions[indices[n + 1]] - positions[indices[n]],
                                                            positions[indices[n + 2]] - positions[indices[n]])));
    std::mt19937 chance(7);
    std::uniform_real_distribution<double> even(0.0, 1.0);
    const StrandFieldSettings& field = coat.settings().strands;
    Inside made;
    for (int grown = 0; grown < strands;) {
        const auto found = std::upper_bound(area.begin(), area.end(), even(chance) * area.back());
        const std::size_t triangle = std::min(static_cast<std::size_t>(found - area.begin()), area.size() - 1) - 1;
        const double root = std::sqrt(even(chance)), along = even(chance);
        const std::array weight{1.0 - root, root * (1.0 - along), root * along};
        const double reach = field.low + (field.high - field.low) * even(chance);
        double map = 0.0;
        for (std::size_t k = 0; k < 3; ++k)
            map += weight[k] * skins[indices[3 * triangle + k]].position.w;
        if (map < std::max(0.02, double{coat.settings().maps.bald_below}))
            continue;
        const auto at = [&](double h) {
            glm::dvec3 place(0.0);
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t n = indices[3 * triangle + k];
                place += weight[k] * (positions[n] + layer_offset(coat, skins[n], static_cast<float>(h)));
            }
            return place;
        };
        made.tips += inside(at(map * reach)) / static_cast<double>(strands);
        made.middles += inside(at(0.5 * map * reach)) / static_cast<double>(strands);
        for (std::size_t k = 0; k < 3; ++k) {
            const CoatSkinBlock& skin = skins[indices[3 * triangle + k]];
            made.lean += weight[k] * static_cast<double>(skin.own.w) / strands;
            made.length += weight[k] * static_cast<double>(skin.load.w) / strands;
        }
        ++grown;
    }
    return made;
}

/// The worst of three poses, after half a second in which tips have come to lag.
double worst_tips(const Subject& of, const std::string& name, float speed, bool avoids) {
    Stage stage({.ambient = speed * of.wind(), .width = 16, .height = 16});
    CoatSettings settings = of.coat;
    settings.avoids_body = avoids;
    Coat& coat = stage.dress(of.model.mesh, settings, at({}));
    double worst = 0.0;
    int pose = 0;
    for (const double time : {0.0, 0.4, 0.9}) {
        const double turn = 2.1 * pose;
        EXPECT_TRUE(coat.move(0.0, of.pose(time - 0.5, turn), of.bones(time - 0.5)));
        for (int step = 29; step >= 0; --step) {
            const double now = time - k_step * step;
            EXPECT_TRUE(coat.move(k_step, of.pose(now, turn), of.bones(now)));
            if (step < 5)
                skin_only(stage, k_step);
        }
        const Inside found = inside_of(coat, of.model.mesh, windrow::test::sampled(20'000, 5'000));
        const std::string row = "shells/outside/" + name + "/" + std::to_string(static_cast<int>(speed)) + "_m_s/pose_" +
                                std::to_string(pose++) + (avoids ? "" : "/not_asked");
        windrow::test::figure(row + "/middles", found.middles);
        // A coat that stood everywhere, or had no strands, would be outside too.
        WINDROW_EXPECT_FIGURE(row + "/lean_taken", found.lean, 0.4);
        WINDROW_EXPECT_FIGURE(row + "/length_taken", found.length, 0.03);
        worst = std::max(worst, windrow::test::figure(row + "/tips", found.tips));
    }
    return worst;
}

void expect_outside(const Subject& of, const std::string& name) {
    for (const float speed : {0.0f, 5.0f, 10.0f, 20.0f}) {
        if (speed != 20.0f && !windrow::test::whole_sweeps())
            continue;
        WINDROW_EXPECT_FIGURE("shells/outside/" + name + "/" + std::to_string(static_cast<int>(speed)) + "_m_s/tips",
                              worst_tips(of, name, speed, true), 1e-3);
    }
    // The measure sees strands in the body where a coat may have them.
    EXPECT_GT(worst_tips(of, name, 10.0f, false), 0.01);
}

TEST(StrandsOutside, OfTheBunny) {
    WINDROW_NEEDS_GLMARK2("bunny.obj");
    expect_outside(pictured_bunny(), "bunny");
}

TEST(StrandsOutside, LongOfTheBeastThatWalks) {
    expect_outside(walking_beast(), "beast");
}

// What the measure itself measures with: a ball's points, by their distance from its middle.
TEST(StrandsOutside, RayParityTellsABallsInsideFromItsOutside) {
    const Mesh ball = *globe_sphere({.radius = 1.0f, .sectors = 60, .stacks = 40});
    std::vector<glm::dvec3> positions;
    for (const MeshVertex& vertex : ball.vertices)
        positions.emplace_back(vertex.position);
    const InsideBody inside(positions, ball.indices);
    std::mt19937 chance(3);
    std::normal_distribution<double> gauss;
    for (int n = 0; n < 2'000; ++n) {
        const glm::dvec3 way = glm::normalize(glm::dvec3(gauss(chance), gauss(chance), gauss(chance)));
        ASSERT_TRUE(inside(0.99 * way) && inside(0.2 * way));
        ASSERT_FALSE(inside(1.001 * way) || inside(3.0 * way));
    }
}

struct Walk {
    double largest_step = 0.0; ///< [L] that a tip goes in a frame beside its root
    double passes = 0.0;       ///< [L] the most by which an outer layer lies below an inner one
    double shortened = 0.0;    ///< the part of all strands' length that is taken
};

Walk walk(const Subject& of, bool avoids) {
    constexpr double second = k_step / 4.0;
    Stage stage({.ambient = 8.0f * of.wind(), .gusts = 0.5f, .width = 16, .height = 16});
    CoatSettings settings = of.coat;
    settings.avoids_body = avoids;
    Coat& coat = stage.dress(of.model.mesh, settings, at({}));
    constexpr double begin = 0.15, end = 0.25;
    const int frames = static_cast<int>(std::lround((end - begin) / second));
    const double length = static_cast<double>(of.coat.layers.length);
    Walk made;
    std::vector<glm::dvec3> before;
    for (int frame = -4; frame <= frames; ++frame) {
        const double now = begin + frame * second;
        EXPECT_TRUE(coat.move(frame == -4 ? 0.0 : second, of.pose(now, 0.7), of.bones(now)));
        skin_only(stage, second);
        std::vector<glm::dvec3> tips;
        for (const CoatSkinBlock& skin : engine::must(coat.skin())) {
            double below = 0.0;
            for (int layer = 1; layer <= 4; ++layer) {
                const glm::dvec3 place = layer_offset(coat, skin, 0.25f * static_cast<float>(layer));
                const double over = glm::dot(place, glm::dvec3(glm::vec3(skin.normal))) / length;
                made.passes = std::max(made.passes, below - over);
                below = over;
            }
            tips.push_back(layer_offset(coat, skin, skin.position.w) / length);
            made.shortened += static_cast<double>(skin.load.w);
        }
        for (std::size_t n = 0; n < tips.size() && frame > 0; ++n)
            made.largest_step = std::max(made.largest_step, glm::distance(tips[n], before[n]));
        before = std::move(tips);
    }
    made.shortened /= static_cast<double>(before.size()) * (frames + 5);
    return made;
}

// Lean relaxes over 0.025 s, and its whole range takes a tip pi/2 L along an arc, that of the length L: so much may a frame add to
// how tips go by themselves. A tuft that jumped went 1.1 L.
TEST(StrandsOutside, NoTuftJumpsAndLayersKeepTheirOrder) {
    const Subject beast = walking_beast();
    const Walk free = walk(beast, false), kept = walk(beast, true);
    const double added = (1.571 + 1.0) * (1.0 - std::exp(-k_step / 4.0 / 0.025));
    windrow::test::figure("shells/outside/walk/step_not_asked_L", free.largest_step);
    WINDROW_EXPECT_FIGURE("shells/outside/walk/step_L", kept.largest_step, free.largest_step + added);
    WINDROW_EXPECT_FIGURE("shells/outside/walk/passes_inner_L", kept.passes, 1e-5); // rounding of positions of some metres
    WINDROW_EXPECT_FIGURE("shells/outside/walk/shortened", kept.shortened, 0.03);
}

// A ball has no hollow: no passes, and the same bits as without the setting.
TEST(StrandsOutside, ABallIsAsWithoutIt) {
    const auto skin_of = [](bool avoids) {
        Stage stage({.ambient = {9.0f, 0.0f, 2.0f}, .gusts = 0.5f, .width = 16, .height = 16});
        CoatSettings settings = bare_bones();
        settings.layers.sag = 0.6f;
        settings.comb.bend = 0.8f;
        settings.avoids_body = avoids;
        settings.inertia.emplace();
        Coat& coat = stage.dress(*globe_sphere({}), settings, at({}));
        for (int frame = 0; frame < 3; ++frame) {
            EXPECT_TRUE(coat.move(k_step, at({0.1 * frame, 0.0, 0.0})));
            skin_only(stage, k_step);
        }
        return engine::must(coat.skin());
    };
    const std::vector<CoatSkinBlock> with = skin_of(true), without = skin_of(false);
    ASSERT_EQ(with.size(), without.size());
    EXPECT_EQ(std::memcmp(with.data(), without.data(), sizeof(CoatSkinBlock) * with.size()), 0);
}

} // namespace
} // namespace windrow::vegetation::fur::test
