// Shader blocks of moving plants, laid out as the structs of shaders/numerics, for std140 and std430.
#pragma once

#include <glm/vec4.hpp>

namespace windrow {

/// A step of a class of springs: WindrowSpringStep of shaders/numerics/spring.glsl.
struct SpringBlock {
    glm::vec4 place{0.0f};
    glm::vec4 velocity{0.0f};
};
static_assert(sizeof(SpringBlock) == 32);

/// A frame of a class of plants that swing: WindrowSwingStep of shaders/numerics/swing.glsl.
struct SwingBlock {
    SpringBlock spring{};                    ///< of a part of the frame
    SpringBlock smoothing{};                 ///< of a part, for what the detail adds
    glm::vec4 parts{1.0f, 0.0f, 0.0f, 0.0f}; ///< x their number, y [s] length of one, zw 0
};
static_assert(sizeof(SwingBlock) == 80);

/// A frame of a class of leaves that flutter: WindrowFlutter of shaders/numerics/flutter.glsl.
struct FlutterBlock {
    glm::vec4 motion{0.0f}; ///< x [rad] most, y [m/s] wind from which on, zw 0
    glm::vec4 now{0.0f};    ///< turns of each band, 0 to 1
    glm::vec4 before{0.0f}; ///< a frame ago
};
static_assert(sizeof(FlutterBlock) == 48);

/// A stage of a cascade, or the body: WindrowPose of shaders/numerics/cascade.glsl.
struct PoseBlock {
    glm::vec4 place{0.0f};                      ///< xyz [m] from the anchor, w scale
    glm::vec4 rotation{0.0f, 0.0f, 0.0f, 1.0f}; ///< quaternion x, y, z, w, of any length
};
static_assert(sizeof(PoseBlock) == 32);

/// Position of a frame's ground texels: WindrowGroundPlace of shaders/numerics/ground_texels.glsl.
struct GroundPlaceBlock {
    glm::vec4 corner{0.0f};     ///< xy [m] low corner (x and z) minus the anchor, z [m] edge of a texel, w texels an axis
    glm::vec4 blend_zone{0.0f}; ///< xy [m] centre of the blend zone, minus the anchor; z [m] reach, w [m] width of the fading
    glm::vec4 slot{0.0f};       ///< xy slot of the low corner; zw lean of the wind outside
};
static_assert(sizeof(GroundPlaceBlock) == 48);

/// A frame of the ground: the uniform block of shaders/coupling/windrow_ground.glsl.
struct GroundBlock {
    GroundPlaceBlock now{};
    GroundPlaceBlock before{}; ///< of the frame before, for motion vectors
};
static_assert(sizeof(GroundBlock) == 96);

} // namespace windrow
