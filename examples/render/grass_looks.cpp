#include "examples/render/grass_looks.h"

#include "coupling/plant_classes.h"
#include "examples/render/place_numerics.h"

#include <algorithm>
#include <cmath>

namespace render {
namespace {

// A leafy meadow; the looks say what is theirs.
LookLayer leaves(float length, float width, float density) {
    LookLayer made;
    grass::GrassSettings& field = made.settings.field;
    field.blade = {.stalk = windrow::grass(),
                   .length_spread = 0.3f,
                   .width = width,
                   .tip_width = 0.06f,
                   .taper = 2.6f,
                   .along_wind = 0.8f,
                   .own_bend = 0.75f,
                   .own_bend_spread = 0.45f,
                   .own_curve = 0.55f,
                   .view_bend = 0.35f};
    field.blade.stalk.length = length;
    field.density = density;
    field.chunk_cells = 80;
    field.split_distance = 9.0f;
    field.cut_distance = 60.0f;
    field.fade_from = 0.6f;
    field.shadow_distance = 13.0f;
    field.least_width = 0.0f; // the renderer's own holds
    field.thin_from = 2.6f;
    field.thin_power = 1.45f;
    field.thin_widen = 0.62f; // for the eye of one who stands in it
    field.clump_size = 1.2f * length;
    field.clump_height = 0.35f;
    field.clump_lean = 0.55f;
    field.clump_fan = 0.35f;
    field.patch_size = 5.0f;
    field.patch_height = 0.35f;
    field.most_chunks = 900;
    made.settings.look.even_from = 48.0f;
    made.settings.look.self_shade = 1.8f;
    made.settings.look.variation = 0.26f;
    made.settings.look.root_light = 0.26f;
    return made;
}

// Stalks with a seed head or a flower, here and there.
LookLayer stalks(const LookLayer& among, float length, float density) {
    LookLayer made = among;
    grass::GrassSettings& field = made.settings.field;
    field.seed = 77;
    field.blade.stalk.length = length;
    field.blade.stalk.rigidity *= 4.0f; // a stem of four blades
    field.blade.width = 0.004f;
    field.blade.tip_width = 0.5f;
    field.blade.own_bend = 0.3f;
    field.blade.own_bend_spread = 0.25f;
    field.blade.view_bend = 0.0f;
    field.density = density;
    field.chunk_cells = 32;
    field.cut_distance = 40.0f;
    field.thin_from = 8.0f;
    field.thin_power = 1.2f;
    field.clump_height = 0.2f;
    field.clump_lean = 0.3f;
    field.clump_fan = 0.0f;
    field.most_chunks = 400;
    made.settings.most_blades = 65536;
    made.settings.look.head_from = 0.66f;
    return made;
}

GrassLook tall() {
    GrassLook look{.name = "tall", .layers = {leaves(0.62f, 0.011f, 21.0f)}};
    PlantLook& light = look.layers[0].settings.look;
    light.root = {0.018f, 0.038f, 0.008f};
    light.tip = {0.125f, 0.185f, 0.035f};
    light.second = {0.075f, 0.150f, 0.040f};
    look.layers.push_back(stalks(look.layers[0], 0.92f, 3.5f));
    PlantLook& seeds = look.layers[1].settings.look;
    seeds.head = {0.27f, 0.21f, 0.11f};
    seeds.head_width = 0.010f;
    seeds.head_from = 0.74f;
    return look;
}

GrassLook low() {
    GrassLook look{.name = "short", .layers = {leaves(0.15f, 0.0065f, 38.0f)}, .wind = {1.8f, -0.6f}};
    grass::GrassSettings& field = look.layers[0].settings.field;
    field.cut_distance = 34.0f;
    field.thin_from = 1.8f;
    field.clump_size = 0.16f;
    field.patch_height = 0.2f;
    PlantLook& light = look.layers[0].settings.look;
    light.root = {0.022f, 0.050f, 0.010f};
    light.tip = {0.090f, 0.175f, 0.032f};
    light.second = {0.120f, 0.190f, 0.045f};
    light.dryness = 0.4f;
    light.even_from = 28.0f;
    look.layers.push_back(stalks(look.layers[0], 0.17f, 9.0f));
    LookLayer& daisies = look.layers[1];
    daisies.bare = 0.5f;
    daisies.settings.field.blade.width = 0.003f;
    daisies.settings.field.cut_distance = 25.0f;
    daisies.settings.look.head = {0.42f, 0.41f, 0.36f};
    daisies.settings.look.head_from = 0.9f;
    daisies.settings.look.head_width = 0.018f;
    return look;
}

GrassLook violet() {
    GrassLook look{.name = "violet", .layers = {leaves(0.42f, 0.010f, 24.0f)}};
    PlantLook& light = look.layers[0].settings.look;
    light.root = {0.012f, 0.016f, 0.050f};
    light.tip = {0.150f, 0.070f, 0.230f};
    light.second = {0.050f, 0.080f, 0.230f};
    light.dry = {0.250f, 0.130f, 0.260f};
    light.through = {0.130f, 0.050f, 0.190f};
    light.dryness = 0.5f;
    look.layers.push_back(stalks(look.layers[0], 0.55f, 4.0f));
    LookLayer& spikes = look.layers[1];
    spikes.bare = 0.4f;
    spikes.settings.look.head = {0.30f, 0.15f, 0.40f};
    spikes.settings.look.head_from = 0.5f;
    spikes.settings.look.head_width = 0.020f;
    return look;
}

GrassLook path() {
    GrassLook look{.name = "path", .layers = {leaves(0.40f, 0.010f, 24.0f)}, .path_width = 1.3f};
    grass::GrassSettings& field = look.layers[0].settings.field;
    field.blade.own_bend = 1.3f;
    field.blade.own_bend_spread = 0.5f;
    field.blade.own_curve = 0.35f;
    field.clump_fan = 0.6f;
    PlantLook& light = look.layers[0].settings.look;
    light.soil = {0.130f, 0.098f, 0.062f};
    light.tip = {0.110f, 0.180f, 0.030f};
    light.second = {0.150f, 0.180f, 0.040f};
    return look;
}

GrassLook yellow() {
    GrassLook look{.name = "yellow", .layers = {leaves(0.50f, 0.008f, 25.0f)}};
    grass::GrassSettings& field = look.layers[0].settings.field;
    field.blade.own_bend = 0.2f;
    field.blade.own_bend_spread = 0.15f;
    field.blade.view_bend = 0.5f;
    field.clump_fan = 0.15f;
    PlantLook& light = look.layers[0].settings.look;
    light.root = {0.060f, 0.045f, 0.015f};
    light.tip = {0.270f, 0.200f, 0.060f};
    light.second = {0.220f, 0.185f, 0.070f};
    light.dry = {0.290f, 0.230f, 0.110f};
    light.through = {0.140f, 0.100f, 0.025f};
    look.layers.push_back(stalks(look.layers[0], 0.66f, 6.0f));
    PlantLook& seeds = look.layers[1].settings.look;
    seeds.head = {0.36f, 0.26f, 0.10f};
    seeds.head_width = 0.014f;
    return look;
}

GrassLook wind() {
    GrassLook look{.name = "wind", .layers = {leaves(0.55f, 0.010f, 22.0f)}, .wind = {7.0f, -1.5f}};
    grass::GrassSettings& field = look.layers[0].settings.field;
    field.blade.along_wind = 1.0f;
    field.blade.own_bend = 0.25f;
    field.blade.own_bend_spread = 0.2f;
    field.clump_lean = 0.2f;
    field.clump_fan = 0.0f;
    PlantLook& light = look.layers[0].settings.look;
    light.tip = {0.120f, 0.185f, 0.060f};
    light.second = {0.090f, 0.160f, 0.070f};
    light.gloss = 14.0f;
    light.dryness = 0.6f;
    return look;
}

GrassLook composition() {
    GrassLook look{.name = "composition", .layers = {leaves(0.26f, 0.009f, 28.0f)}, .path_width = 0.9f};
    LookLayer& base = look.layers[0];
    base.settings.look.soil = {0.120f, 0.092f, 0.058f};
    base.settings.field.thin_from = 2.2f;
    LookLayer tufts = leaves(0.75f, 0.012f, 8.0f);
    tufts.settings.field.seed = 5;
    tufts.settings.look = base.settings.look;
    tufts.settings.look.tip = {0.150f, 0.180f, 0.045f};
    tufts.settings.look.second = {0.180f, 0.180f, 0.060f};
    tufts.bare = 0.75f;
    tufts.bare_size = 2.5f;
    LookLayer blue = stalks(base, 0.36f, 8.0f);
    blue.bare = 0.6f;
    blue.bare_size = 3.0f;
    blue.settings.look.head = {0.10f, 0.13f, 0.40f};
    blue.settings.look.head_from = 0.93f;
    blue.settings.look.head_width = 0.018f;
    LookLayer white = blue;
    white.settings.field.seed = 101;
    white.bare = 0.75f;
    white.bare_size = 5.0f;
    white.settings.look.head = {0.42f, 0.40f, 0.34f};
    look.layers.insert(look.layers.end(), {tufts, blue, white});
    return look;
}

} // namespace

std::vector<GrassLook> grass_looks() {
    return {tall(), low(), violet(), path(), yellow(), wind(), composition()};
}

windrow::Result<grass::PlacementMask> mask_of(const GrassLook& look, const LookLayer& layer, const grass::HeightMap& heights,
                                              float path_at) {
    const glm::vec2 extent = heights.extent();
    const glm::ivec2 corners = glm::clamp(glm::ivec2(extent / 0.25f) + 1, glm::ivec2(2), glm::ivec2(1024));
    auto mask = grass::PlacementMask::create(corners, extent, 1.0f);
    if (!mask)
        return mask;
    const float shift = 13.7f * static_cast<float>(layer.settings.field.seed % 64u);
    mask->apply([&](glm::vec2 place, float) {
        float alpha = 1.0f;
        if (layer.bare > 0.0f) { // two octaves: their sum lies about 1/2
            const glm::vec2 at = place / layer.bare_size + shift;
            const float noise = 0.7f * numerics::windrow_place_noise(at) + 0.3f * numerics::windrow_place_noise(2.7f * at + 5.0f);
            alpha *= glm::smoothstep(layer.bare - 0.12f, layer.bare + 0.08f, noise + 0.5f * (layer.bare - 0.5f));
        }
        if (look.path_width > 0.0f) {
            const float middle = path_at + 1.1f * std::sin(0.21f * place.y) + 0.5f * std::sin(0.47f * place.y + 1.0f);
            const float beside = std::abs(place.x - middle) / (0.5f * look.path_width);
            const float ragged = 0.25f * (numerics::windrow_place_noise(place / 0.35f) - 0.5f);
            alpha *= glm::smoothstep(0.75f, 1.9f, beside + ragged);
        }
        return alpha;
    });
    return mask;
}

} // namespace render
