// One motor as the sources stage evaluates it: plain data, relative to the box, with the cells that it can touch.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>

namespace windrow::detail {

struct MotorReach {
    enum class Shape : std::uint8_t { sphere, capsule, box, path };

    Shape shape = Shape::sphere;
    bool drives = false;
    glm::vec3 centre{0.0f}; ///< [m] from the box's low corner; start of a path
    glm::vec3 extent{0.0f}; ///< [m] half axis of a capsule, half size of a box, end of a path
    float radius = 0.0f;    ///< [m] widened to what the cells can hold
    /// Force: added to f per unit of weight. Drive: the velocity U drawn toward. [m/s^2 or m/s]
    glm::vec3 push{0.0f};
    /// Drive: exponent per unit of weight.
    float exponent = 0.0f;
    glm::ivec3 low{0}, high{0}; ///< cells low <= index < high
};

} // namespace windrow::detail
