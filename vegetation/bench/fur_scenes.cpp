#include "vegetation/bench/fur_scenes.h"

#include "vegetation/fur/beast.h"
#include "vegetation/fur/shapes.h"

#include <cmath>

namespace windrow::vegetation::bench {
namespace {

// All layers at any distance; what the tables ask for is drawn.
constexpr float k_always_full = 1e5f; // [m]

template <class T>
T made(Result<T> result) {
    if (!result) {
        std::fprintf(stderr, "windrow_fur_bench: %s\n", result.error().c_str());
        std::exit(1);
    }
    return *std::move(result);
}

void set_length(fur::CoatSettings& coat, float length) {
    // A strand of the default's shape: rigidity as length^3 lets the same wind bend it by the same angle.
    coat.layers.strand.rigidity *= std::pow(length / coat.layers.length, 3.0f);
    coat.layers.length = coat.layers.strand.length = length;
}

} // namespace

fur::CoatSettings thesis_coat(int layers) {
    fur::CoatSettings coat;
    coat.layers.shells = layers;
    coat.layers.spacing = 0.805f;
    set_length(coat, 0.319f);
    coat.strands_on = fur::StrandsOn::uv;
    coat.strands = {.density = 145.0f, .jitter = 0.0f, .low = 0.0f, .high = 0.811f, .thickness = 1.01f};
    coat.look.root = {0.02f, 0.1f, 0.02f};
    coat.look.tip = coat.look.second = {0.1f, 0.5f, 0.1f};
    coat.look.occlusion = 0.27f;
    coat.look.occlusion_bias = 0.0f;
    coat.levels = {.full_until = k_always_full, .march = 0, .skip_empty = false, .outer_first = false, .shadow_shells = 0};
    return coat;
}

fur::CoatSettings fur(int layers) {
    fur::CoatSettings coat;
    coat.layers.shells = layers;
    set_length(coat, 0.06f);
    coat.strands = {.density = 40.0f, .low = 0.5f, .thickness = 1.6f};
    coat.comb = {.bend = 0.6f, .tousle = 0.5f, .tousle_size = 0.08f};
    coat.look.root = {0.09f, 0.05f, 0.025f};
    coat.look.tip = {0.62f, 0.42f, 0.24f};
    coat.look.second = {0.5f, 0.3f, 0.15f};
    coat.look.second_size = 0.2f;
    coat.levels.full_until = k_always_full;
    coat.levels.shadow_shells = 0;
    return coat;
}

fur::CoatSettings cloud(int layers) {
    fur::CoatSettings coat;
    coat.cloud.emplace().size = 50.0f;
    coat.mirrored = coat.drifts = true;
    coat.wind_fraction = 0.0f;
    coat.layers.shells = layers;
    coat.layers.sag = 0.0f;
    set_length(coat, 14.0f);
    coat.look = {.root = {0.55f, 0.6f, 0.7f}, .tip = glm::vec3(0.95f), .second = glm::vec3(0.95f)};
    coat.look.gloss = coat.look.sheen = coat.look.occlusion = 0.0f;
    coat.look.cel_steps = 4;
    coat.levels.full_until = k_always_full;
    coat.levels.shadow_shells = 0;
    return coat;
}

fur::CoatSettings bare_skin() {
    fur::CoatSettings coat;
    coat.bare = true;
    coat.look.skin = {0.3f, 0.28f, 0.25f};
    coat.levels.shadow_shells = 0;
    return coat;
}

fur::Mesh thesis_sphere() {
    return made(fur::globe_sphere({}));
}

fur::Mesh sheet_of(float metres, int cells) {
    return made(fur::sheet({.size = glm::vec2(metres), .columns = cells, .rows = cells}));
}

Worn floor(float metres, double y) {
    return {.mesh = sheet_of(metres, 10), .settings = bare_skin(), .place = {0.0, y, 0.0}};
}

FurCase thesis_scene(std::string name, int layers) {
    return {.name = std::move(name), .coats = {{.mesh = thesis_sphere(), .settings = thesis_coat(layers)}}};
}

FurCase thesis_light_scene(std::string name, int layers) {
    FurCase made = thesis_scene(std::move(name), layers);
    made.coats.front().settings.levels.shadow_shells = layers;
    made.coats.push_back(floor(6.0f, -0.85));
    made.lamps.push_back({.position = {1.5, 1.2, 1.5}, .colour = glm::vec3(6.0f, 5.0f, 3.5f)});
    return made;
}

FurCase thesis_many_scene(std::string name, int layers) {
    FurCase made = thesis_light_scene(std::move(name), layers);
    const Worn sphere = made.coats.front(), plane = floor(16.0f, -0.85);
    made.coats.clear();
    for (int n = 0; n < 18; ++n) {
        made.coats.push_back(sphere);
        made.coats.back().place = {1.8 * (n % 6 - 2.5), 0.0, -1.8 * (n / 6)};
    }
    made.coats.push_back(plane);
    made.from = {0.0, 5.5, 10.5};
    made.to = {0.0, -0.5, -1.8};
    made.view_deg = 52.0f;
    return made;
}

FurCase beast_scene(std::string name, int layers) {
    fur::CoatSettings coat = fur(layers);
    set_length(coat, 0.12f);
    coat.levels.march = 0;
    coat.levels.outer_first = coat.levels.skip_empty = false;
    return {.name = std::move(name),
            .coats = {{.mesh = made(fur::beast_mesh()), .settings = coat, .bones = made(fur::beast_skeleton())}},
            .from = {6.0, 1.9, 2.5},
            .to = {0.0, 1.1, 0.35},
            .view_deg = 37.0f};
}

FurCase fur_scene(std::string name, int layers) {
    return {.name = std::move(name), .coats = {{.mesh = thesis_sphere(), .settings = fur(layers)}}, .from = {0.0, 0.6, 2.4}};
}

} // namespace windrow::vegetation::bench
