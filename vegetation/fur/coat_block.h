// Shader blocks of a coat, laid out as in vegetation/shaders/fur/coat.glsl, and their conversion from its settings.
#pragma once

#include "../../coupling/motion_blocks.h"
#include "../../coupling/shell.h"
#include "coat_settings.h"
#include "mesh.h"

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace windrow::vegetation::fur {

struct SpotBlock {
    glm::vec4 from{0.0f}; ///< xyz [m] in the mesh's space; w radius
    glm::vec4 to{0.0f};   ///< xyz; w soft edge
    glm::vec4 tint{0.0f}; ///< rgb; w weight
    glm::vec4 more{0.0f}; ///< x factor on the length; y glow
};
struct LampBlock {
    glm::vec4 place{0.0f};  ///< xyz [m] from the anchor; w reach
    glm::vec4 colour{0.0f}; ///< rgb irradiance at 1 m
};

struct FootBlock {
    glm::vec4 place{0.0f};  ///< xyz [m] from the anchor; w radius
    glm::vec4 weight{0.0f}; ///< x
};

/// A uniform block of std140 layout.
struct CoatBlock {
    windrow::ShellBlock shells{}; ///< lengths times the body's scale
    StrandFieldBlock field{};
    glm::vec4 levels{0.0f};    ///< x divisor of a layer's number; y [m] length over the mesh's metres; z wind fraction; w [s]
    glm::ivec4 counts{0};      ///< x vertices; y, z first entry of this and of the last frame's skin; w stages
    glm::ivec4 layers{0};      ///< x drawn; y 1: outer first; z 1: mirrored; w those of the shadow
    glm::ivec4 form{0};        ///< x 1: translated; y WindAt; z 1: strands by the surface; w 1: bare
    glm::ivec4 drawing{0};     ///< x march; y samples a pixel; z spots; w lamps
    glm::vec4 comb{0.0f};      ///< xyz direction; w [rad] bend
    glm::vec4 tousle{0.0f};    ///< x [rad]; y 1 / [m]; z 1 / [s] of the last frame; w bald_below
    glm::vec4 root{0.0f};      ///< rgb; w power
    glm::vec4 tip{0.0f};       ///< rgb; w variation
    glm::vec4 second{0.0f};    ///< rgb; w 1 / [m]
    glm::vec4 skin{0.0f};      ///< rgb; w bias of the occlusion
    glm::vec4 light{0.0f};     ///< x occlusion exponent; y wrap; z gloss; w its power
    glm::vec4 sheen{0.0f};     ///< x sheen; y its power; z through; w strand normals
    glm::vec4 cel{0.0f};       ///< x levels; y square normals; z 1: clouds; w 1: the skin hides the far half
    glm::vec4 drift{0.0f};     ///< xy [m] along x and z of the mesh where the strands' pattern has gone; z, w feet now and before
    glm::vec4 low{0.0f};       ///< xyz corner of the mesh's box; w Projection
    glm::vec4 extent{0.0f};    ///< xyz 1 / its size; w noise tiles
    glm::vec4 influence{0.0f}; ///< x, y of the noise pictures; z [rad] push of feet; w 1: exact normals
    CloudShellBlock cloud{};
    std::array<glm::ivec4, 4> pictures{}; ///< x first texel; y columns; z rows; w levels, 0: none
    std::array<SpotBlock, k_max_spots> spots{};
    std::array<LampBlock, k_max_lamps> lamps{};
    std::array<FootBlock, k_max_feet> feet{}, feet_before{};
    glm::ivec4 ahead{0};  ///< x the pose of a moment later; y its first bone; z 1: there is one
    glm::vec4 gone{0.0f}; ///< xyz [m] in the world that the pattern has gone since the last frame; w 1 / [s] of that moment
};
static_assert(sizeof(CoatBlock) == 2368 + 2 * 8 * 32 + 32);

/// A vertex of the mesh, for the skinning pass.
struct CoatVertexBlock {
    glm::vec4 position{0.0f}; ///< xyz [m]; w u
    glm::vec4 normal{0.0f};   ///< xyz; w v
    glm::uvec4 bones{0u};
    glm::vec4 weights{0.0f}; ///< all 0: no bones
};
static_assert(sizeof(CoatVertexBlock) == 64);

/// A vertex of the skin in a frame: seven vec4, CoatSkin of vegetation/shaders/fur/coat.glsl.
struct CoatSkinBlock {
    glm::vec4 position{0.0f}, normal{0.0f}, load{0.0f}, own{0.0f}, lag{0.0f}, lag_more{0.0f}, velocity{0.0f};
};
static_assert(sizeof(CoatSkinBlock) == 112);

/// All that does not change from frame to frame, of settings that `validate` passes.
[[nodiscard]] CoatBlock coat_block(const CoatSettings& settings, const Mesh& mesh, int samples);
/// A cloud whose air has gone by `drift` [m] of the mesh, and that has evolved by some heaps' sizes; nothing where there is none.
[[nodiscard]] CloudShellBlock cloud_block(const CoatSettings& settings, const Mesh& mesh, glm::dvec2 drift, double evolved);
/// The lengths of a body of this scale.
[[nodiscard]] windrow::ShellBlock scaled(const windrow::ShellBlock& block, float scale);

} // namespace windrow::vegetation::fur
