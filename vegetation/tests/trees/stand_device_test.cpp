// A stand on the device: its vertices against windrow::Tree on the CPU, its base, its motion vectors, its memory of swings.
#include "coupling/plant_numerics.h"
#include "tests/figure.h"
#include "vegetation/render/light_numerics.h"
#include "vegetation/tests/trees/stage.h"
#include "vegetation/trees/tree_wind.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

namespace windrow::vegetation::trees::test {
namespace {

constexpr std::uint32_t k_none = windrow::Tree::PartIndices::k_none;

TreeStandSettings one(const char* kind, bool springs) {
    return {.kind = *preset(kind),
            .variants = 1,
            .places = {{.base = k_anchor + glm::dvec3(0.5, 0.0, -20.0), .size = 0.9f, .yaw_deg = 35.0f}},
            .springs = springs};
}

glm::vec3 placed(const PlaceBlock& place, glm::vec3 v) {
    return {place.turn.x * v.x + place.turn.y * v.z, v.y, place.turn.x * v.z - place.turn.y * v.x};
}

glm::dvec2 seen(const render::Camera& camera, glm::dvec3 p) {
    const glm::dvec4 clip =
        glm::dmat4(view_projection(camera, static_cast<float>(k_width) / k_height, k_anchor)) * glm::dvec4(p, 1.0);
    return 0.5 * glm::dvec2(clip) / clip.w + 0.5;
}

// The one bend of all plants, and the flutter of leaves: the library's functions on the device and on the CPU, in a wind that is the
// same everywhere.
TEST(TreeStand, VerticesAreThoseOfTheLibrarysTree) {
    const glm::vec3 wind(8.0f, 0.5f, -3.0f);
    for (const char* const kind : {"oak", "spruce"}) {
        Stage stage(wind, 0.0f);
        TreeStandSettings settings = one(kind, false);
        settings.kind.levels.min_angle = 1e-5f; // twigs have all of their thickness
        stage.plant(settings);
        stage.draw(camera_at(0.0, 0.0));
        const TreeModel& model = stage.stand->model(0);
        const PlaceBlock& place = stage.stand->place(0);
        std::vector<windrow::TreePart> parts;
        for (std::uint32_t n = 0; n < model.parts.size(); ++n) {
            windrow::TreePart part = model.part(n);
            part.root = place.base.w * placed(place, part.root);
            part.axis = placed(place, part.axis);
            part.length *= place.base.w;
            parts.push_back(part);
        }
        const auto flutter =
            std::bit_cast<windrow::numerics::WindrowFlutter>(*windrow::flutter_step(settings.flutter, k_frame, k_frame));
        std::vector<glm::vec4> positions, normals;
        std::vector<windrow::Tree::PartIndices> bearers;
        for (const ModelVertex& v : model.vertices) {
            glm::vec3 at = place.base.w * placed(place, glm::vec3(v.position)), normal = placed(place, glm::vec3(v.normal));
            if (v.parts.w != 0u && kind == std::string("oak")) { // a card, by the mean of its leaves; needles do not flutter
                const windrow::TreePart& twig = parts[v.parts.y];
                const glm::uvec2 hash =
                    windrow::numerics::windrow_plant_hash({v.parts.z, std::bit_cast<std::uint32_t>(place.turn.z)});
                const float angle =
                    0.32f * windrow::numerics::windrow_flutter_angle(flutter, flutter.now, hash, glm::length(wind));
                const auto turned = windrow::numerics::windrow_leaf_turned({twig.root, twig.axis, twig.length, twig.stiffness},
                                                                           angle, {at, normal});
                at = turned.position;
                normal = turned.normal;
            }
            positions.emplace_back(at, 1.0f);
            normals.emplace_back(normal, 0.0f);
            bearers.push_back({0u, v.parts.x, v.parts.y});
        }
        const std::vector<glm::vec4> winds(parts.size(), glm::vec4(wind, 0.0f));
        std::vector<glm::vec4> bent(positions.size()), turned(positions.size());
        const auto tree = windrow::Tree::create(wind_classes(preset(kind)->tree));
        const auto done = tree->vertices(parts, winds, {positions, normals, bearers}, bent, turned);
        ASSERT_TRUE(done) << done.error();
        double apart = 0.0, normals_apart = 0.0, most = 0.0;
        for (std::size_t n = 0; n < bent.size(); ++n) {
            ASSERT_EQ(stage.probe->now(n).w, 1.0f); // near: all of it is there
            apart = std::max(apart, static_cast<double>(glm::length(glm::vec3(stage.probe->now(n)) - glm::vec3(bent[n]))));
            normals_apart = std::max(normals_apart,
                                     static_cast<double>(glm::length(glm::vec3(stage.probe->normal(n)) - glm::vec3(turned[n]))));
            most = std::max(most, static_cast<double>(glm::length(glm::vec3(bent[n]) - glm::vec3(positions[n]))));
        }
        const std::string figure = std::string("trees/device/") + kind;
        // Places of 15 m in float have steps of 1e-6 m, and go through three bends of some ten roundings each.
        WINDROW_EXPECT_FIGURE(figure + "/positions", apart, 5e-5);
        WINDROW_EXPECT_FIGURE(figure + "/normals", normals_apart, 1e-4);
        EXPECT_GT(windrow::test::figure(figure + "/moved", most), 0.2);
    }
}

TEST(TreeStand, ItsBaseStaysOnTheDeviceToo) {
    Stage stage({25.0f, 0.0f, 12.0f}, 0.5f);
    stage.plant(one("birch", true));
    const TreeModel& model = stage.stand->model(0);
    const PlaceBlock& place = stage.stand->place(0);
    int held = 0;
    for (int frame = 0; frame < 5; ++frame) {
        stage.draw(camera_at(0.0, 0.0));
        for (std::size_t n = 0; n < model.vertices.size(); ++n) {
            const ModelVertex& v = model.vertices[n];
            ASSERT_TRUE(std::isfinite(stage.probe->now(n).x + stage.probe->now(n).y + stage.probe->now(n).z));
            ASSERT_NEAR(glm::length(glm::vec3(stage.probe->normal(n))), 1.0f, 2e-4f);
            if (v.parts.x != k_none || v.position.y > 0.0f)
                continue;
            // Rest as shaders have it; bends add exactly nothing there, whatever the frame.
            const glm::vec3 now(stage.probe->now(n)), before(stage.probe->before(n));
            ASSERT_EQ(now, before);
            ASSERT_LE(glm::length(now - place.base.w * placed(place, glm::vec3(v.position))), 1e-6f);
            ++held;
        }
    }
    EXPECT_GE(held, 50);
}

// What a frame took for the last one's vertices is what the last one had, while wind, springs and the camera move them; beyond
// `near`, so that leaves shrink and turn with the eye too.
TEST(TreeStand, TheFrameBeforeIsTheFrameThatWas) {
    for (const bool springs : {false, true}) {
        Stage stage({6.0f, 0.0f, 2.0f}, 0.6f);
        TreeStandSettings settings = one("oak", springs);
        settings.kind.levels.near = 12.0f;
        stage.plant(settings);
        for (int n = 0; n < 15; ++n)
            stage.draw(camera_at(0.0, 0.0));
        std::vector<glm::vec4> last(stage.probe->count());
        for (std::size_t n = 0; n < last.size(); ++n)
            last[n] = stage.probe->now(n);
        stage.draw(camera_at(0.15, 0.004));
        const std::uint32_t parts = stage.stand->model(0).drawn(stage.stand->levels(), 15.0f).parts;
        double apart = 0.0, moved = 0.0;
        for (std::size_t n = 0; n < last.size(); ++n) {
            const glm::uvec4 bearers = stage.stand->model(0).vertices[n].parts;
            if (last[n].w == 0.0f || (bearers.y != k_none && bearers.y >= parts))
                continue; // is not drawn
            apart = std::max(apart, static_cast<double>(glm::length(stage.probe->before(n) - last[n])));
            moved = std::max(moved, static_cast<double>(glm::length(glm::vec3(stage.probe->now(n)) - glm::vec3(last[n]))));
        }
        const std::string figure = springs ? "trees/before/springs" : "trees/before/still";
        WINDROW_EXPECT_FIGURE(figure, apart, 2e-5); // [m] the same text on the same numbers, but where the wind is sampled again
        EXPECT_GT(windrow::test::figure(figure + "/moved", moved), 1e-3);
    }
}

// The picture's motion vectors against the difference of projected places over two frames: a soft mast, seen from the side.
TEST(TreeStand, MotionIsTheDifferenceOfProjectedPlaces) {
    Stage stage({5.0f, 0.0f, 1.0f}, 0.6f);
    TreeStandSettings settings = one("oak", true);
    settings.kind.tree.limbs = 1;
    settings.kind.tree.branches = 0;
    settings.kind.tree.clusters = 1;
    settings.kind.tree.leaves = 1;
    settings.kind.tree.height = 30.0f;
    settings.kind.tree.limb_length = 25.0f;
    settings.kind.tree.trunk_radius = 0.5f;
    settings.kind.tree.wood = 4e8f;
    stage.plant(settings);
    for (int n = 0; n < 30; ++n)
        stage.draw(camera_at(0.0, 0.0));
    const render::Camera before = camera_at(0.0, 0.0), now = camera_at(0.03, -0.003);
    stage.draw(before);
    stage.draw(now);
    const render::PictureF motion = stage.renderer->images().motion_picture();
    const glm::dvec3 base(glm::vec3(stage.stand->place(0).base));
    double worst = 0.0, most = 0.0, of_wind = 0.0;
    int compared = 0;
    for (std::size_t n = 0; n < stage.stand->model(0).vertices.size(); ++n) {
        const ModelVertex& v = stage.stand->model(0).vertices[n];
        const glm::dvec3 here = base + glm::dvec3(glm::vec3(stage.probe->now(n))),
                         there = base + glm::dvec3(glm::vec3(stage.probe->before(n)));
        const glm::dvec3 to_eye = glm::normalize(now.position - k_anchor - here);
        const double width = glm::length(glm::vec3(v.position) - glm::vec3(v.centre));
        if (v.parts.x != k_none || here.y < 0.3 || width < 0.1 ||
            glm::dot(glm::dvec3(glm::vec3(stage.probe->normal(n))), to_eye) < 0.75)
            continue; // not of the trunk's face
        const glm::dvec2 place = seen(now, here), expected = place - seen(before, there);
        const int column = static_cast<int>(place.x * k_width), row = static_cast<int>(place.y * k_height);
        if (column < 1 || row < 1 || column >= k_width - 1 || row >= k_height - 1)
            continue;
        const glm::dvec2 got(static_cast<double>(motion.at(column, row, 0)), static_cast<double>(motion.at(column, row, 1)));
        worst = std::max(worst, glm::length(got - expected));
        most = std::max(most, glm::length(expected));
        of_wind = std::max(of_wind, glm::length(seen(now, here) - seen(now, there)));
        ++compared;
    }
    windrow::test::figure("trees/motion/compared", compared);
    EXPECT_GE(compared, 12);
    EXPECT_GT(windrow::test::figure("trees/motion/of_wind_px", of_wind * k_width), 0.02);
    // A pixel's middle lies up to 0.7 px from the vertex, on a trunk of some 100 px along which motion grows from the ground's: a
    // fiftieth of the largest; half floats keep a 1024th.
    WINDROW_EXPECT_FIGURE("trees/motion/apart", worst, most / 50.0);
}

// In an even wind leaves move above the onset; wood and needles do not move.
TEST(TreeStand, LeavesFlutterBeyondTheOnset) {
    for (const auto& [kind, wind, flutters] :
         {std::tuple{"birch", 1.2f, false}, {"birch", 6.0f, true}, {"spruce", 6.0f, false}}) {
        Stage stage({wind, 0.0f, 0.0f}, 0.0f);
        const TreeStandSettings settings = one(kind, true);
        stage.plant(settings);
        stage.draw(camera_at(0.0, 0.0));
        std::vector<glm::vec4> first(stage.probe->count());
        for (std::size_t n = 0; n < first.size(); ++n)
            first[n] = stage.probe->now(n);
        for (int n = 0; n < 3; ++n)
            stage.draw(camera_at(0.0, 0.0));
        double wood = 0.0, leaves = 0.0, most = 0.0;
        int moved = 0, cards = 0;
        const TreeModel& model = stage.stand->model(0);
        for (std::size_t n = 0; n < first.size(); ++n) {
            const ModelVertex& vertex = model.vertices[n];
            const double by = static_cast<double>(glm::length(glm::vec3(stage.probe->now(n)) - glm::vec3(first[n])));
            if (vertex.parts.w == 0u) {
                wood = std::max(wood, by);
                continue;
            }
            const windrow::TreePart twig = model.part(vertex.parts.y);
            const glm::vec3 off = glm::vec3(vertex.position) - twig.root;
            const double radius = static_cast<double>(glm::length(off - glm::dot(off, twig.axis) * twig.axis));
            leaves = std::max(leaves, by);
            if (radius > 0.05) { // [m]
                most = std::max(most, by / radius);
                moved += by > 0.005 * radius ? 1 : 0;
                ++cards;
            }
        }
        EXPECT_LE(wood, 1e-5) << kind << ' ' << wind; // [m] rounding at 8 m
        ASSERT_GT(cards, 100);
        if (!flutters) {
            EXPECT_LE(leaves, 1e-5) << kind << ' ' << wind;
            continue;
        }
        // 2 times 0.32 of the class's 0.6 rad from side to side; a tenth of a second is half a turn.
        windrow::test::figure("trees/flutter/cards_that_move", static_cast<double>(moved) / cards);
        EXPECT_GT(moved, 0.9 * cards);
        WINDROW_EXPECT_FIGURE("trees/flutter/largest_turn_rad", most / 0.9, 2.0 * 0.32 * 0.6); // its size is 0.9
    }
}

// A crown that began upright would ring for seconds.
TEST(TreeStand, BeginsAtWhatTheWindHolds) {
    Stage stage({9.0f, 0.0f, 2.0f}, 0.2f);
    stage.plant(one("oak", true));
    stage.draw(camera_at(0.0, 0.0));
    double off = 0.0, held = 0.0;
    for (const PartState& state : engine::must(stage.stand->states(0))) {
        off = std::max(off, static_cast<double>(glm::distance(glm::vec3(state.now), glm::vec3(state.target))));
        off = std::max(off, static_cast<double>(glm::length(glm::vec3(state.velocity))));
        held = std::max(held, static_cast<double>(glm::length(glm::vec3(state.now))));
    }
    WINDROW_EXPECT_FIGURE("trees/device/begins_off", off, 0.0);
    EXPECT_GT(held, 0.01);
}

// Trees behind the eye and beyond all shadows cost no vertex; a far stand stays within its bound.
TEST(TreeStand, DrawsWhatIsSeenAndLittleAfar) {
    Stage stage({3.0f, 0.0f, 0.0f}, 0.2f);
    TreeStandSettings settings = one("oak", false);
    settings.places.clear();
    for (int n = 0; n < 40; ++n) {
        settings.places.push_back({.base = k_anchor + glm::dvec3(4.0 * n - 80.0, 0.0, -260.0), .size = 1.0f});
        settings.places.push_back({.base = k_anchor + glm::dvec3(4.0 * n - 80.0, 0.0, 400.0), .size = 1.0f});
    }
    stage.plant(settings);
    stage.draw(camera_at(0.0, 0.0));
    EXPECT_GT(stage.stand->drawn_vertices(), 0u);
    WINDROW_EXPECT_FIGURE("trees/device/far_vertices", static_cast<double>(stage.stand->drawn_vertices()),
                          40.0 * k_max_far_vertices);

    const auto none = TreeStand::create(*stage.device, stage.renderer->draw_targets(), settings, {}, k_anchor);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().find("stand.places is empty"), std::string::npos);
    const std::vector<TreePlace> crowd(5000, settings.places.front());
    const auto many = TreeStand::create(*stage.device, stage.renderer->draw_targets(), settings, crowd, k_anchor);
    ASSERT_FALSE(many);
    EXPECT_NE(many.error().find("give at most"), std::string::npos);
}

} // namespace
} // namespace windrow::vegetation::trees::test
