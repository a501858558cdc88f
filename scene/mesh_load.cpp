#include "scene/mesh_load.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

namespace windrow::scene {
namespace {

// Even permutations, which mirror nothing.
glm::vec3 turned(const glm::vec3& v, UpAxis up) {
    switch (up) {
    case UpAxis::x:
        return {-v.y, v.x, v.z};
    case UpAxis::z:
        return {v.x, v.z, -v.y};
    default:
        return v;
    }
}

} // namespace

MeshTurn::MeshTurn(const MeshLoad& load)
    : up_(load.up), cosine_(std::cos(glm::radians(load.yaw_deg))), sine_(std::sin(glm::radians(load.yaw_deg))) {}

glm::vec3 MeshTurn::operator()(const glm::vec3& v) const {
    const glm::vec3 w = turned(v, up_);
    return {cosine_ * w.x + sine_ * w.z, w.y, cosine_ * w.z - sine_ * w.x};
}

MeshStand::MeshStand(const MeshLoad& load, const glm::vec3& low, const glm::vec3& high)
    : foot{(low.x + high.x) / 2.0f, low.y, (low.z + high.z) / 2.0f} {
    const glm::vec3 edges = high - low;
    scale = load.size / (load.size_of == SizeOf::height ? edges.y : std::max({edges.x, edges.y, edges.z}));
}

} // namespace windrow::scene
