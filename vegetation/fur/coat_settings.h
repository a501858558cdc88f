// Settings of a coat: layers over a mesh whose patterns make fur, feathers, grass, spikes, paper or clouds. One structure with
// ranges and defaults, that a scene file holds as it is:
//
//     const fur::CoatSettings settings{.layers = {.shells = 40, .length = 0.04f}, .look = {.gloss = 0.1f}};
//
// Its structures from other headers: windrow::ShellSettings (where the layers lie, how the wind bends them),
// StrandFieldSettings (what each layer leaves open), windrow::CascadeConfig (how tips lag behind the body).
#pragma once

#include "../../coupling/cascade.h"
#include "../../coupling/shell.h"
#include "cloud_shell.h"
#include "strand_field.h"

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace windrow::vegetation::fur {

/// Lie of strands at rest: along a direction of the mesh's own space, within the skin.
struct Comb {
    glm::vec3 along{0.0f, -1.0f, 0.0f};
    float bend = 0.0f;
    float tousle = 0.0f;
    float tousle_size = 0.05f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("along", &Comb::along, Range::length(1e-12, 1e12, ""),
                    "Direction of the tips in the mesh's space, of any length above 0."),
            Setting("bend", &Comb::bend, {0.0, 1.5, "rad", "strands stand"}, "Of the tip."),
            Setting("tousle", &Comb::tousle, {0.0, 3.0, "rad"}, "By which the comb turns at random within the skin."),
            Setting("tousle_size", &Comb::tousle_size, Range::above(0.0, 100.0, "m"), "Over which that turn changes."),
        };
    }
};

/// A round brush in the mesh's own space: inside, strands are shorter and coloured. Between `from` and `to` it is a capsule.
/// Evaluated in fragments, not at vertices: its border is as sharp on a coarse mesh as on a fine one.
struct Spot {
    glm::vec3 from{0.0f};
    glm::vec3 to{0.0f};
    float radius = 0.05f;
    float soft = 0.02f;
    float length = 1.0f;
    glm::vec3 colour{0.0f};
    float tint = 0.0f;
    float glow = 0.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("from", &Spot::from, {-1e4, 1e4, "m"}, "One end of its middle line."),
            Setting("to", &Spot::to, {-1e4, 1e4, "m"}, "The other."),
            Setting("radius", &Spot::radius, Range::above(0.0, 1000.0, "m"), "About that line."),
            Setting("soft", &Spot::soft, {0.0, 1000.0, "m"}, "Over which it fades outward."),
            Setting("length", &Spot::length, k_fraction_range, "Factor on the strands' length; 0 is bald."),
            Setting("colour", &Spot::colour, k_fraction_range, "Linear."),
            Setting("tint", &Spot::tint, k_fraction_range, "Fraction of the colour in the strands'."),
            Setting("glow", &Spot::glow, {0.0, 100.0}, "Light of its own where bald, times the colour: eyes."),
        };
    }
};
inline constexpr std::size_t k_max_spots = 24;

/// Projection of a picture onto a mesh.
enum class Projection {
    uv,   ///< by the mesh's texture coordinates
    side, ///< along x: u to -z .. z, v downward, over the mesh's box
    top,  ///< along y: u to -x .. x, v to -z .. z
    front ///< along z: u to -x .. x, v downward
};

/// Pictures of the strands' length and colour: PNG, PGM, EXR ..., beside the scene.
struct CoatMaps {
    std::string length{};
    std::string colour{};
    std::string noise_a{};
    std::string noise_b{};
    float influence_a = 1.0f;
    float influence_b = 1.0f;
    float noise_tiles = 1.0f;
    Projection projection = Projection::uv;
    float bald_below = 0.02f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("length", &CoatMaps::length, "Grey picture beside the scene: 0 bald to 1 whole."),
            Setting("colour", &CoatMaps::colour,
                    "Picture beside the scene that multiplies root and tip, sRGB or linear by its file."),
            Setting("noise_a", &CoatMaps::noise_a,
                    "One of two grey pictures in place of the strands' random lengths: open where (1 - (1 - a) influence_a) (1 - "
                    "(1 - b) influence_b) < h."),
            Setting("noise_b", &CoatMaps::noise_b, "The other."),
            Setting("influence_a", &CoatMaps::influence_a, k_fraction_range, "Of noise_a."),
            Setting("influence_b", &CoatMaps::influence_b, k_fraction_range, "Of noise_b."),
            Setting("noise_tiles", &CoatMaps::noise_tiles, Range::above(0.0, 1000.0), "Times that both repeat over uv."),
            Setting("projection", &CoatMaps::projection,
                    "Projection of length and colour onto the mesh: by uv, or seen from the side (along x), the top or the front "
                    "(along z)."),
            Setting("bald_below", &CoatMaps::bald_below, k_fraction_range,
                    "Fraction of the length below which nothing grows and the skin is drawn."),
        };
    }
};

/// Colours are linear albedo, 0 to 1.
struct CoatLook {
    glm::vec3 root{0.05f, 0.04f, 0.03f};
    glm::vec3 tip{0.45f, 0.38f, 0.30f};
    glm::vec3 second{0.45f, 0.38f, 0.30f};
    glm::vec3 skin{0.25f, 0.18f, 0.15f};
    float second_size = 1.0f;
    float tip_power = 1.0f;
    float variation = 0.15f;
    float occlusion = 0.7f;
    float occlusion_bias = 0.15f;
    float wrap = 1.0f;
    float gloss = 0.05f;
    float gloss_power = 24.0f;
    float sheen = 0.15f;
    float sheen_power = 40.0f;
    float through = 0.2f;
    float strand_normals = 0.6f;
    float square_normals = 0.0f;
    bool exact_normals = false;
    int cel_steps = 0;

    static constexpr auto settings() {
        return std::tuple{
            Setting("root", &CoatLook::root, k_fraction_range, "At the skin."),
            Setting("tip", &CoatLook::tip, k_fraction_range, "At the tip."),
            Setting("second", &CoatLook::second, k_fraction_range,
                    "Tips of other patches: each patch is somewhere between tip and this."),
            Setting("skin", &CoatLook::skin, k_fraction_range, "Skin colour where no strands grow."),
            Setting("second_size", &CoatLook::second_size, Range::above(0.0, 1e4, "m"), "Of those patches."),
            Setting("tip_power", &CoatLook::tip_power, Range::above(0.0, 10.0), "Root to tip by height^this; 3: tips only."),
            Setting("variation", &CoatLook::variation, {0.0, 0.9}, "Fraction by which single strands are lighter or darker."),
            Setting("occlusion", &CoatLook::occlusion, {0.0, 5.0, "", "not at all"},
                    "A of min(1, h^A + bias): how far up the dark root reaches."),
            Setting("occlusion_bias", &CoatLook::occlusion_bias, k_fraction_range, "Light that reaches the root."),
            Setting("wrap", &CoatLook::wrap, k_fraction_range, "1 half-Lambert, 0 Lambert."),
            Setting("gloss", &CoatLook::gloss, {0.0, 10.0}, "Amount of Blinn-Phong."),
            Setting("gloss_power", &CoatLook::gloss_power, {1.0, 1000.0}, "Its exponent."),
            Setting("sheen", &CoatLook::sheen, {0.0, 10.0}, "Hair's light along its strands (Kajiya and Kay)."),
            Setting("sheen_power", &CoatLook::sheen_power, {1.0, 1000.0}, "Its exponent."),
            Setting("through", &CoatLook::through, k_fraction_range, "Light that shines through tips against the sun."),
            Setting("strand_normals", &CoatLook::strand_normals, k_fraction_range, "Weight of each strand's own round normals."),
            Setting("square_normals", &CoatLook::square_normals, k_fraction_range,
                    "0 away from the strand's middle, 1 away from its cell's edge."),
            Setting("exact_normals", &CoatLook::exact_normals,
                    "Normals of the strands' own form, in place of a turn from its side at the root to the skin's at the tip."),
            Setting("cel_steps", &CoatLook::cel_steps, {0.0, 8.0, "", "smooth"}, "Levels of light."),
        };
    }
};

/// Number and order of the drawn layers.
struct CoatLevels {
    int min_shells = 8;
    float full_until = 4.0f;
    int march = 4;
    bool skip_empty = true;
    bool outer_first = true;
    bool depth_first = false;
    bool one_draw_each = false;
    bool shadow_strands = true;
    int shadow_shells = 16;

    static constexpr auto settings() {
        return std::tuple{
            Setting("min_shells", &CoatLevels::min_shells, {2.0, 4096.0}, "Afar; at most the coat's own are drawn."),
            Setting("full_until", &CoatLevels::full_until, Range::above(0.0, 1e6, "m"),
                    "Distance up to which all shells are drawn; beyond, as 1 / distance."),
            Setting("march", &CoatLevels::march, {0.0, 16.0},
                    "Steps a fragment may look between its layer and the next inner one."),
            Setting("skip_empty", &CoatLevels::skip_empty, "Layers above every tip are not drawn."),
            Setting("outer_first", &CoatLevels::outer_first,
                    "Outer layers are drawn first, after the skin, so that layers hidden below them are not shaded."),
            Setting("depth_first", &CoatLevels::depth_first, "A pass that writes only depth before the colours."),
            Setting("one_draw_each", &CoatLevels::one_draw_each,
                    "The naive form, one draw a layer: a baseline for measurements."),
            Setting("shadow_strands", &CoatLevels::shadow_strands, "Whether the shadow has the strands' form, or the body's."),
            Setting("shadow_shells", &CoatLevels::shadow_shells, {0.0, 4096.0, "", "casts none"}, "Layers in the shadow's map."),
        };
    }
};

/// Point at which the wind acts on a strand.
enum class WindAt {
    strand, ///< once a vertex, halfway up the strand
    shell,  ///< at each shell's own vertex
    pixel   ///< at each fragment's root: strands lean one by one on meshes of a few vertices (bent form, rigid meshes)
};

/// Mapping of strands onto the mesh.
enum class StrandsOn {
    surface, ///< evenly over any mesh, whatever its texture coordinates: round cones and centre forms
    uv       ///< by the cells of its texture coordinates: all forms, and shapes that lie along v
};

struct CoatSettings {
    windrow::ShellSettings layers{};
    bool translated = false;
    WindAt wind_at = WindAt::strand;
    float wind_fraction = 1.0f;
    float foot_push = 1.2f;
    bool avoids_body = true;
    bool mirrored = false;
    bool drifts = false;
    bool bare = false;
    StrandsOn strands_on = StrandsOn::surface;
    StrandFieldSettings strands{};
    float wriggle_hz = 0.3f;
    std::optional<CloudShellSettings> cloud{};
    Comb comb{};
    std::vector<Spot> spots{};
    CoatMaps maps{};
    CoatLook look{};
    CoatLevels levels{};
    std::optional<windrow::CascadeConfig> inertia{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("layers", &CoatSettings::layers, "Positions of the layers, and their bend in the wind."),
            Setting("translated", &CoatSettings::translated,
                    "Whether layers are pushed and droop as in the shell literature, in place of strands that bend and keep "
                    "their length."),
            Setting("wind_at", &CoatSettings::wind_at,
                    "Point at which a strand samples the wind: once a vertex, at each shell's vertex, or at each pixel's root "
                    "(meshes of a "
                    "few vertices)."),
            Setting("wind_fraction", &CoatSettings::wind_fraction, {0.0, 100.0}, "Fraction of the wind that acts on it."),
            Setting("foot_push", &CoatSettings::foot_push, {0.0, 1.5707964, "rad"},
                    "Lean of the tip away from a foot, right beside its middle. Not where translated."),
            Setting(
                "avoids_body", &CoatSettings::avoids_body,
                "Strands lean less, or are shorter, where they would enter the body's own skin. Two more passes a frame, none "
                "on a rigid mesh without hollows. Not where translated, mirrored, or with wind_at pixel."),
            Setting("mirrored", &CoatSettings::mirrored,
                    "Half of the layers above and half below the skin, which is not drawn: clouds."),
            Setting("drifts", &CoatSettings::drifts, "The pattern moves along with the air: clouds."),
            Setting("bare", &CoatSettings::bare, "Draws only the skin."),
            Setting("strands_on", &CoatSettings::strands_on,
                    "Placement of strands: evenly over any surface (round ones), or by the cells of the mesh's uv (all forms)."),
            Setting("strands", &CoatSettings::strands, "Pattern of strands in each layer."),
            Setting("wriggle_hz", &CoatSettings::wriggle_hz, {-100.0, 100.0, "Hz"},
                    "Turns a second of the strands' wriggle, and by which a cloud's heaps become others."),
            Setting("cloud", &CoatSettings::cloud,
                    "Heaps of cloud in place of strands, the layers' length high, on a level mesh; it is as large as the mesh. "
                    "Wants mirrored, and drifts to go with the air."),
            Setting("comb", &CoatSettings::comb, "Direction of strands at rest."),
            Setting("spots", &CoatSettings::spots, {0.0, k_max_spots},
                    "Round brushes in the mesh's own space: inside, strands are shorter and coloured."),
            Setting("maps", &CoatSettings::maps, "Pictures of length and colour."),
            Setting("look", &CoatSettings::look, "Colours and light. Colours are linear."),
            Setting("levels", &CoatSettings::levels, "Number and order of the drawn layers."),
            Setting("inertia", &CoatSettings::inertia, "Lag of tips behind the body. Without it they move with the body."),
        };
    }
};

/// Whether strands are kept outside of the body: as avoids_body has it, where strands are such as can be.
[[nodiscard]] bool keeps_outside(const CoatSettings& settings);

/// Every reason why it cannot be used, a line each. Maps are looked at when they are read.
[[nodiscard]] windrow::Result<void> validate(const CoatSettings& settings);
void check_rules(windrow::detail::Reasons& reasons, const windrow::detail::FieldPath& path, const CoatMaps& maps);

/// Lamps that shine on coats beside the sun: a few points of light, without shadows of their own.
struct Lamp {
    glm::dvec3 position{0.0, 3.0, 0.0};
    glm::vec3 colour{1.0f};
    float reach = 20.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("position", &Lamp::position, {-1e9, 1e9, "m"}, "Its position."),
            Setting("colour", &Lamp::colour, {0.0, 1e6}, "Irradiance across the beam at 1 m, in the picture's units."),
            Setting("reach", &Lamp::reach, Range::above(0.0, 1e4, "m"), "Beyond it falls smoothly to nothing."),
        };
    }
};
inline constexpr std::size_t k_max_lamps = 8;

[[nodiscard]] windrow::Result<void> validate(std::span<const Lamp> lamps);

/// Feet, hands and wheels that press strands aside, radially and at once. Unlike the ground's memory (coupling/ground_memory.h) a
/// coat keeps no trail.
struct Foot {
    glm::dvec3 position{0.0};
    float radius = 0.3f;
    float weight = 1.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("position", &Foot::position, {-1e10, 1e10, "m"}, "Of its sole in the world."),
            Setting("radius", &Foot::radius, Range::above(0.0, 1e3, "m"), "Within which strands lean away."),
            Setting("weight", &Foot::weight, k_fraction_range, "Fraction of CoatSettings::foot_push."),
        };
    }
};
inline constexpr std::size_t k_max_feet = 8;

[[nodiscard]] windrow::Result<void> validate(std::span<const Foot> feet);

/// Number of layers of a coat by distance.
struct LayerCount {
    float divisor = 1.0f; ///< of a layer's number: its place in the strand is i / divisor, held at 1
    int layers = 1;       ///< that exist at this distance
    int drawn = 1;        ///< the inner ones of them; the others lie above every strand's tip
};

/// At a distance [m] from the eye. Their number goes by a continuous one, n: layer i is at i / (n - 1), so that a layer that
/// comes with a growing n begins where the outermost already is, and nothing pops. `top` is the largest height at which any
/// strand shows, 0 to 1.
[[nodiscard]] LayerCount layers_at(const CoatSettings& settings, float distance, float top);

} // namespace windrow::vegetation::fur

template <>
inline constexpr std::array<const char*, 4> windrow::k_words<windrow::vegetation::fur::Projection>{"uv", "side", "top", "front"};
template <>
inline constexpr std::array<const char*, 3> windrow::k_words<windrow::vegetation::fur::WindAt>{"strand", "shell", "pixel"};
template <>
inline constexpr std::array<const char*, 2> windrow::k_words<windrow::vegetation::fur::StrandsOn>{"surface", "uv"};
