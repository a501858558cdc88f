// Coats as drawn, against their formulas on the CPU: maps, colours, light, lamps.
#include "tests/figure.h"
#include "vegetation/fur/strand_numerics.h"
#include "vegetation/tests/fur/coat_numerics.h"
#include "vegetation/tests/fur/stage.h"

#include <algorithm>
#include <cmath>

namespace windrow::vegetation::fur::test {
namespace {

using namespace numerics;

constexpr double k_byte = 1.0 / 255.0; // of full scale, radiance 1
constexpr float k_pi_fraction = 0.318309886f;

render::Camera from_above(double height, float view_deg) {
    return camera_at({0.0, height, 0.01 * height}, {0.0, 0.0, 0.0}, view_deg);
}

CoatSettings still(const StrandFieldSettings& strands) {
    CoatSettings coat;
    coat.layers.shells = 9;
    coat.layers.length = 0.01f;
    coat.layers.sag = 0.0f;
    coat.wind_fraction = 0.0f;
    coat.strands_on = StrandsOn::uv;
    coat.strands = strands;
    coat.look.variation = 0.0f;
    coat.look.second = coat.look.tip;
    coat.levels.shadow_shells = 0;
    coat.levels.full_until = 1e4f;
    return coat;
}

// A map with two discs of 0, one of which holds a corner of the square, which is a vertex.
CoatPicture bald_map(int side) {
    CoatPicture map{side, side, {}};
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const glm::vec2 at = (glm::vec2(column, row) + 0.5f) / static_cast<float>(side);
            const bool bald =
                glm::distance(at, glm::vec2(0.6f, 0.45f)) < 0.18f || glm::distance(at, glm::vec2(0.0f, 1.0f)) < 0.3f;
            map.texels.emplace_back(glm::vec3(bald ? 0.0f : 1.0f), 1.0f);
        }
    return map;
}

// The map at a place of 0 to 1, blended between its four texels there.
float blended(const CoatPicture& map, glm::vec2 at) {
    const glm::vec2 cell = glm::clamp(at, 0.0f, 1.0f) * glm::vec2(map.columns, map.rows) - 0.5f, low = glm::floor(cell),
                    share = cell - low;
    float sum = 0.0f;
    for (int corner = 0; corner < 4; ++corner) {
        const int right = corner % 2, down = corner / 2;
        const int x = std::clamp(static_cast<int>(low.x) + right, 0, map.columns - 1),
                  y = std::clamp(static_cast<int>(low.y) + down, 0, map.rows - 1);
        sum += (right == 1 ? share.x : 1.0f - share.x) * (down == 1 ? share.y : 1.0f - share.y) *
               map.texels[static_cast<std::size_t>(y * map.columns + x)].x;
    }
    return sum;
}

// [texels] From a place to the nearest on the other side of `level`, in steps of a fiftieth.
double border_distance(const CoatPicture& map, glm::vec2 at, float level) {
    const bool side = blended(map, at) < level;
    for (int n = 1; n < 500; ++n)
        for (int turn = 0; turn < 32; ++turn) {
            const float angle = 0.19634954f * static_cast<float>(turn),
                        far = 0.02f * static_cast<float>(n) / static_cast<float>(map.columns);
            if ((blended(map, at + far * glm::vec2(std::cos(angle), std::sin(angle))) < level) != side)
                return 0.02 * n;
        }
    return 10.0;
}

TEST(CoatLook, NothingGrowsWhereTheMapIsBaldWhateverTheVertices) {
    Stage stage({.width = 256, .height = 256});
    CoatSettings settings = still(closed());
    settings.look.skin = {0.8f, 0.0f, 0.0f};
    settings.look.root = settings.look.tip = settings.look.second = {0.0f, 0.8f, 0.0f};
    settings.look.gloss = settings.look.sheen = settings.look.through = 0.0f;
    settings.layers.length = 1e-3f;
    const int side = 32;
    CoatPictures pictures;
    pictures.length = bald_map(side);
    const CoatPicture& map = pictures.length;
    stage.dress(square(), settings, at({}), pictures);
    const render::Camera camera = from_above(8.0, 15.5f);
    stage.draw(camera);
    const render::PictureF light = stage.light();
    double farthest = 0.0; // of a pixel on the wrong side of a disc's border [texels]
    int bald = 0, grown = 0, seen_pixels = 0;
    for (int row = 0; row < 256; ++row)
        for (int column = 0; column < 256; ++column) {
            const glm::dvec3 place = on_level(camera, column, row, 256, 256, 0.0);
            if (std::max(std::abs(place.x), std::abs(place.z)) > 0.98)
                continue;
            ++seen_pixels;
            const glm::vec2 uv(0.5 + 0.5 * place.x, 0.5 + 0.5 * place.z);
            const glm::vec2 on(uv.x, 1.0f - uv.y);
            const bool wanted = blended(map, on) < settings.maps.bald_below;
            const glm::vec3 got = radiance(light, column, row);
            const bool is_bald = got.r > got.g;
            (is_bald ? bald : grown) += 1;
            if (is_bald != wanted)
                farthest = std::max(farthest, border_distance(map, on, settings.maps.bald_below));
        }
    EXPECT_GT(bald, seen_pixels / 10);
    EXPECT_GT(grown, seen_pixels / 2);
    WINDROW_EXPECT_FIGURE("shells/bald/border_texels", farthest, 1.0);
}

// The light of vegetation/shaders/fur/shell_light.glsl for one light, and of the sky, by the same formulas.
struct LitPoint {
    glm::vec3 albedo, normal, tangent;
    float t, open, hair;
};
glm::vec3 lit(const CoatLook& look, const LitPoint& p, glm::vec3 beam, glm::vec3 to_light, glm::vec3 to_eye) {
    const float facing = windrow_wrapped(glm::dot(p.normal, to_light), look.wrap);
    const glm::vec3 half_way = windrow_half_way(to_light, to_eye, p.normal);
    const float gloss = look.gloss * windrow_plain_gloss(p.normal, half_way, look.gloss_power);
    const float sheen = look.sheen * windrow_hair_sheen(p.tangent, half_way, look.sheen_power);
    const float through = look.through * windrow_tips_through(p.t, -glm::dot(to_eye, to_light));
    const glm::vec3 along = facing * (gloss + sheen * glm::mix(glm::vec3(0.04f), p.albedo, 0.5f)) + through * p.albedo;
    return k_pi_fraction * beam * (p.open * facing * p.albedo + p.hair * p.t * along);
}
glm::vec3 expected(const CoatLook& look, const render::ViewBlock& frame, const LitPoint& p, glm::vec3 to_eye) {
    return lit(look, p, glm::vec3(frame.sunlight), glm::vec3(frame.sky.sun), to_eye) +
           p.open * p.albedo *
               render::numerics::windrow_around(p.normal, glm::vec3(frame.skylight), glm::vec3(frame.groundlight));
}

TEST(CoatLook, ColourAtAKnownHeightIsTheFormula) {
    for (const float height : {0.25f, 0.5f, 0.75f, 1.0f}) {
        Stage stage({.width = 64, .height = 64});
        CoatSettings settings = still(closed(std::min(height + 0.01f, 1.0f)));
        settings.look.root = {0.10f, 0.04f, 0.02f};
        settings.look.tip = settings.look.second = {0.42f, 0.36f, 0.25f};
        settings.look.tip_power = 3.0f;
        settings.look.strand_normals = 0.0f;
        stage.dress(square(), settings, at({}));
        const render::Camera camera = from_above(8.0, 5.0f);
        stage.draw(camera);
        const render::PictureF light = stage.light();
        double worst = 0.0;
        for (int row = 4; row < 60; row += 7)
            for (int column = 4; column < 60; column += 7) {
                const glm::dvec3 place = on_level(camera, column, row, 64, 64, settings.layers.length * height);
                const glm::vec3 to_eye(glm::normalize(camera.position - k_anchor - place));
                const CoatLook& look = settings.look;
                const LitPoint p{windrow_strand_colour(look.root, look.tip, look.second, 0.0f, height, look.tip_power, 1.0f),
                                 {0.0f, 1.0f, 0.0f},
                                 {0.0f, 1.0f, 0.0f},
                                 height,
                                 windrow_strand_occlusion(height, look.occlusion, look.occlusion_bias),
                                 1.0f};
                const glm::vec3 apart =
                    glm::abs(radiance(light, column, row) - expected(look, stage.renderer->frame_block(), p, to_eye));
                worst = std::max({worst, double(apart.x), double(apart.y), double(apart.z)});
            }
        WINDROW_EXPECT_FIGURE("shells/colour/" + std::to_string(height).substr(0, 4), worst, k_byte);
    }
}

TEST(CoatLook, ALitSphereIsTheFormulaAndItsBackFallsSmoothly) {
    Stage stage({.width = 128, .height = 128, .sun = {.elevation_deg = 20.0f, .azimuth_deg = 0.0f}});
    CoatSettings settings = still(closed());
    settings.bare = true;
    settings.look.skin = {0.4f, 0.3f, 0.2f};
    const double radius = 0.5;
    stage.dress(*globe_sphere({.radius = static_cast<float>(radius), .sectors = 128, .stacks = 96}), settings, at({}));
    const render::Camera camera = camera_at({0.0, 0.0, 4.0}, {0.0, 0.0, 0.0}, 16.0f); // the sun from the right
    stage.draw(camera);
    const render::PictureF light = stage.light();
    double worst = 0.0;
    int compared = 0, behind = 0;
    const glm::vec3 sun(stage.renderer->frame_block().sky.sun);
    for (int row = 0; row < 128; ++row)
        for (int column = 0; column < 128; ++column) {
            // The ray through the pixel, and the sphere.
            const glm::dvec3 eye = camera.position - k_anchor;
            const glm::dvec3 way = glm::normalize(on_level(camera, column, row, 128, 128, row < 64 ? 1.0 : -1.0) - eye);
            const double along = -glm::dot(eye, way), off = glm::dot(eye, eye) - along * along;
            if (off > 0.9 * 0.9 * radius * radius)
                continue;
            const glm::dvec3 place = eye + way * (along - std::sqrt(radius * radius - off));
            const LitPoint p{settings.look.skin, glm::vec3(place / radius), glm::vec3(place / radius), 0.0f, 1.0f, 0.0f};
            const glm::vec3 wanted = expected(settings.look, stage.renderer->frame_block(), p, -glm::vec3(way));
            const glm::vec3 apart = glm::abs(radiance(light, column, row) - wanted);
            worst = std::max({worst, double(apart.x), double(apart.y), double(apart.z)});
            ++compared;
            behind += glm::dot(p.normal, sun) < -0.3f ? 1 : 0;
        }
    EXPECT_GT(compared, 3000);
    EXPECT_GT(behind, 200); // a clamped half-Lambert would leave them 0.25 of the sun
    WINDROW_EXPECT_FIGURE("shells/lit_sphere", worst, k_byte);
}

TEST(CoatLook, TwoLampsAreTheSumOfBoth) {
    Stage stage({.width = 96, .height = 96});
    CoatSettings settings = still({.density = 60.0f, .thickness = 1.5f});
    settings.strands_on = StrandsOn::surface;
    settings.layers.length = 0.08f;
    Coat& coat = stage.dress(*globe_sphere({}), settings, at({}));
    const std::vector<Lamp> both{{.position = k_anchor + glm::dvec3(1.5, 0.6, 1.0), .colour = {1.5f, 0.2f, 0.1f}},
                                 {.position = k_anchor + glm::dvec3(-1.2, 0.1, 1.4), .colour = {0.1f, 0.4f, 2.0f}}};
    const auto drawn = [&](std::span<const Lamp> lamps) {
        EXPECT_TRUE(coat.set_lamps(lamps));
        stage.draw(camera_at({0.0, 0.3, 3.0}));
        return stage.light();
    };
    const std::span<const Lamp> all(both);
    const render::PictureF none = drawn({}), first = drawn(all.first(1)), second = drawn(all.last(1)), sum = drawn(all);
    double worst = 0.0, most = 0.0;
    for (std::size_t n = 0; n < sum.values.size(); ++n) {
        const double alone = double(first.values[n]) - none.values[n] + (double(second.values[n]) - none.values[n]);
        worst = std::max(worst, std::abs(double(sum.values[n]) - none.values[n] - alone));
        most = std::max(most, alone);
    }
    EXPECT_GT(most, 0.05);
    WINDROW_EXPECT_FIGURE("shells/two_lamps", worst, k_byte);
}

TEST(CoatLook, TheSameFrameHasTheSameBytes) {
    std::vector<std::vector<float>> pictures;
    for (int n = 0; n < 2; ++n) {
        Stage stage({.ambient = {4.0f, 0.0f, 1.0f}, .gusts = 0.5f, .width = 64, .height = 64, .samples = 4});
        CoatSettings settings;
        settings.layers.shells = 8;
        settings.strands.density = 60.0f;
        settings.inertia.emplace();
        Coat& coat = stage.dress(*globe_sphere({}), settings, at({}));
        for (int frame = 0; frame < 3; ++frame) {
            ASSERT_TRUE(coat.move(k_frame, at({0.02 * frame, 0.0, 0.0})));
            stage.draw(camera_at({0.0, 0.3, 3.0}));
        }
        pictures.push_back(stage.light().values);
    }
    EXPECT_EQ(pictures[0], pictures[1]);
}

} // namespace
} // namespace windrow::vegetation::fur::test
