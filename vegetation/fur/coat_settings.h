// What describes a coat: layers over a mesh whose patterns make fur, feathers, grass, spikes, paper or clouds. One structure with
// ranges and defaults, that a scene file holds as it is:
//
//     const fur::CoatSettings settings{.layers = {.shells = 40, .length = 0.04f}, .look = {.gloss = 0.1f}};
//
// Its structures from other headers: windrow::ShellSettings (where the layers lie, how the wind bends them),
// StrandFieldSettings (what each layer leaves open), windrow::CascadeConfig (how tips lag behind the body).
#pragma once

#include "coupling/cascade.h"
#include "coupling/shell.h"
#include "vegetation/fur/cloud_shell.h"
#include "vegetation/fur/strand_field.h"

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace windrow::vegetation::fur {

/// How strands lie at rest: along a direction of the mesh's own space, within the skin.
struct Comb {
    glm::vec3 along{0.0f, -1.0f, 0.0f}; ///< where tips point to, of any length but 0. Default: down
    float bend = 0.0f;                  ///< [rad] of the tip, 0 to 1.5. Default 0: strands stand
    float tousle = 0.0f;                ///< [rad] random turn of each place's comb within the skin, 0 to 3
    float tousle_size = 0.05f;          ///< [m] over which that turn changes, above 0 to 100
};

/// A round brush in the mesh's own space: inside, strands are shorter and coloured. Between `from` and `to` it is a capsule.
/// Evaluated in fragments, not at vertices: its border is as sharp on a coarse mesh as on a fine one.
struct Spot {
    glm::vec3 from{0.0f}, to{0.0f}; ///< [m]
    float radius = 0.05f;           ///< [m] above 0, to 1000
    float soft = 0.02f;             ///< [m] over which it fades outward, 0 to 1000
    float length = 1.0f;            ///< factor on the strands' length, 0 (bald) to 1
    glm::vec3 colour{0.0f};         ///< linear
    float tint = 0.0f;              ///< fraction of `colour` in the strands', 0 to 1
    float glow = 0.0f;              ///< light of its own where bald, times `colour`, 0 to 100: eyes
};
inline constexpr std::size_t k_most_spots = 24;

/// How a picture lies on a mesh.
enum class Projection {
    uv,   ///< by the mesh's texture coordinates
    side, ///< along x: u to -z .. z, v downward, over the mesh's box
    top,  ///< along y: u to -x .. x, v to -z .. z
    front ///< along z: u to -x .. x, v downward
};

/// Pictures of the strands' length and colour: PNG, PGM, EXR ..., beside the scene.
struct CoatMaps {
    std::string length{}; ///< grey: 0 bald to 1 whole; empty: whole everywhere
    std::string colour{}; ///< sRGB or linear by its file; multiplies root and tip; empty: white
    /// Two grey pictures, repeated `noise_tiles` times over uv, in place of the strands' random lengths: open where
    /// (1 - (1 - a) ia) (1 - (1 - b) ib) < h. Empty: none.
    std::string noise_a{}, noise_b{};
    float influence_a = 1.0f, influence_b = 1.0f; ///< 0 to 1
    float noise_tiles = 1.0f;                     ///< above 0 to 1000
    Projection projection = Projection::uv;       ///< of length and colour
    float bald_below = 0.02f;                     ///< below this fraction of the length nothing grows: the skin is drawn. 0 to 1
};

/// Colours are linear albedo, 0 to 1.
struct CoatLook {
    glm::vec3 root{0.05f, 0.04f, 0.03f}; ///< at the skin
    glm::vec3 tip{0.45f, 0.38f, 0.30f};
    glm::vec3 second{0.45f, 0.38f, 0.30f}; ///< tips of other patches: of each patch somewhere between `tip` and this
    glm::vec3 skin{0.25f, 0.18f, 0.15f};   ///< where nothing grows
    float second_size = 1.0f;              ///< [m] size of the patches, above 0 to 1e4
    float tip_power = 1.0f;                ///< root to tip by h^k, above 0 to 10; 3: tips alone
    float variation = 0.15f;               ///< fraction by which single strands are lighter or darker, 0 to 0.9
    float occlusion = 0.7f;                ///< A of min(1, h^A + b): how far up the dark root reaches, 0 (none) to 5
    float occlusion_bias = 0.15f;          ///< b, 0 to 1
    float wrap = 1.0f;                     ///< 1: half-Lambert, 0: Lambert; between, between
    float gloss = 0.05f;                   ///< Blinn-Phong amount, 0 to 10
    float gloss_power = 24.0f;             ///< 1 to 1000
    float sheen = 0.15f;                   ///< hair's light along its strands (Kajiya-Kay), 0 to 10
    float sheen_power = 40.0f;             ///< 1 to 1000
    float through = 0.2f;                  ///< light that shines through tips against the sun, 0 to 1
    float strand_normals = 0.6f;           ///< how much of each strand's own roundness is seen, 0 to 1
    float square_normals = 0.0f;           ///< 0: away from the strand's middle, 1: from the cell's edge
    /// Normals of the strands' own form, in place of the sources' turn from its side at the root to the skin's at the tip.
    bool exact_normals = false;
    int cel_steps = 0; ///< levels of light, 0 (smooth) to 8
};

/// How many layers are drawn, and how.
struct CoatLevels {
    int least_shells = 8;     ///< afar, 2 to 4096; at most the coat's own are drawn
    float full_until = 4.0f;  ///< [m] distance up to which all shells are drawn, above 0 to 1e6; beyond, as 1 / distance
    int march = 4;            ///< steps a fragment may look between its layer and the next inner one, 0 (none) to 16
    bool skip_empty = true;   ///< layers above every strand's tip are not drawn
    bool outer_first = true;  ///< order of layers: the skin, then outer ones first, which hide what lies below from being shaded
    bool depth_first = false; ///< a pass that writes depth alone before the colours
    bool one_draw_each = false; ///< the naive form, one draw a layer: a baseline for measurements
    bool shadow_strands = true; ///< the shadow has the strands' form; without it the body's
    int shadow_shells = 16;     ///< layers in the shadow's map, 0 (casts none) to 4096
};

/// Where a strand feels the wind.
enum class WindAt {
    strand, ///< once a vertex, halfway up the strand
    shell,  ///< at each shell's own vertex
    pixel   ///< at each fragment's root: strands lean one by one on meshes of a few vertices (bent form, rigid meshes)
};

/// How strands are laid over the mesh.
enum class StrandsOn {
    surface, ///< evenly over any mesh, whatever its texture coordinates: round cones and centre forms
    uv       ///< by the cells of its texture coordinates: all forms, and shapes that lie along v
};

struct CoatSettings {
    windrow::ShellSettings layers{};
    bool translated = false; ///< push and droop of the shell literature in place of strands that keep their length
    WindAt wind_at = WindAt::strand;
    float wind_share = 1.0f; ///< of the wind that it feels, 0 to 100
    /// [rad] Lean of the tip away from a foot, right beside its middle, 0 (none) to pi/2. Not in the translate form.
    float foot_push = 1.2f;
    bool mirrored = false; ///< layers on both sides of the skin, half of them each, and no skin: clouds
    bool drifts = false;   ///< the pattern moves along with the air: clouds
    bool bare = false;     ///< the skin alone
    StrandsOn strands_on = StrandsOn::surface;
    StrandFieldSettings strands{};
    float wriggle_hz = 0.3f; ///< turns a second of the strands' wriggle, and by which a cloud's heaps become others, -100 to 100
    /// In place of strands: a cloud on a level mesh, with layers.length its half height and the mesh's box its size (those two of
    /// its own fields are not used). Wants `mirrored`, and `drifts` to go with the air.
    std::optional<CloudShellSettings> cloud{};
    Comb comb{};
    std::vector<Spot> spots{}; ///< at most k_most_spots
    CoatMaps maps{};
    CoatLook look{};
    CoatLevels levels{};
    std::optional<windrow::CascadeConfig> inertia{}; ///< none: tips move with the body at once
};

/// Every reason why it cannot be used, a line each. Maps are looked at when they are read.
[[nodiscard]] windrow::Result<void> validate(const CoatSettings& settings);

} // namespace windrow::vegetation::fur
