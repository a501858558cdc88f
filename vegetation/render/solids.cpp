#include "vegetation/render/solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

namespace windrow::vegetation::render {
namespace {

constexpr glm::vec3 k_metal{0.230f, 0.225f, 0.215f};
constexpr glm::vec3 k_blade{0.420f, 0.400f, 0.350f};

struct SolidCorner {
    glm::vec3 position, normal;
};

void triangle(Solid& solid, const SolidCorner& a, const SolidCorner& b, const SolidCorner& c, glm::vec3 colour) {
    for (const SolidCorner& corner : {a, b, c})
        solid.push_back({glm::vec4(corner.position, 0.0f), glm::vec4(corner.normal, 0.0f), glm::vec4(colour, 0.0f)});
}

void quad(Solid& solid, const SolidCorner& a, const SolidCorner& b, const SolidCorner& c, const SolidCorner& d,
          glm::vec3 colour) {
    triangle(solid, a, b, c, colour);
    triangle(solid, a, c, d, colour);
}

float turn_of(int side, int sides) {
    return glm::two_pi<float>() * static_cast<float>(side) / static_cast<float>(sides);
}

} // namespace

Solid lathe(std::span<const glm::vec2> profile, int sides, glm::vec3 colour) {
    const auto normal_at = [&](std::size_t n) { // across the profile, by its neighbours
        const glm::vec2 along = profile[std::min(n + 1, profile.size() - 1)] - profile[n > 0 ? n - 1 : 0];
        const glm::vec2 out(along.y, -along.x);
        return out / std::max(glm::length(out), 1e-6f);
    };
    const auto corner = [&](std::size_t n, int side) {
        const float turn = turn_of(side, sides);
        const glm::vec3 around(std::cos(turn), 0.0f, std::sin(turn));
        const glm::vec2 normal = normal_at(n);
        return SolidCorner{profile[n].x * around + glm::vec3(0.0f, profile[n].y, 0.0f),
                           normal.x * around + glm::vec3(0.0f, normal.y, 0.0f)};
    };
    Solid solid;
    for (std::size_t n = 0; n + 1 < profile.size(); ++n)
        for (int side = 0; side < sides; ++side)
            quad(solid, corner(n, side), corner(n, side + 1), corner(n + 1, side + 1), corner(n + 1, side), colour);
    return solid;
}

Solid box(glm::vec3 half, glm::vec3 colour) {
    Solid solid;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 normal(0.0f), u(0.0f), v(0.0f);
            normal[axis] = side;
            u[(axis + 1) % 3] = half[(axis + 1) % 3];
            v[(axis + 2) % 3] = half[(axis + 2) % 3];
            const glm::vec3 middle = half * normal;
            quad(solid, {middle - u - v, normal}, {middle + u - v, normal}, {middle + u + v, normal}, {middle - u + v, normal},
                 colour);
        }
    return solid;
}

Solid ring(float radius, float tube, int sides, glm::vec3 colour) {
    constexpr int around_tube = 8;
    const auto corner = [&](int side, int across) {
        const float turn = turn_of(side, sides), twist = turn_of(across, around_tube);
        const glm::vec3 out(std::cos(turn), std::sin(turn), 0.0f);
        const glm::vec3 normal = std::cos(twist) * out + glm::vec3(0.0f, 0.0f, std::sin(twist));
        return SolidCorner{radius * out + tube * normal, normal};
    };
    Solid solid;
    for (int side = 0; side < sides; ++side)
        for (int across = 0; across < around_tube; ++across)
            quad(solid, corner(side, across), corner(side + 1, across), corner(side + 1, across + 1), corner(side, across + 1),
                 colour);
    return solid;
}

void add(Solid& whole, const Solid& part, const glm::mat4& placed) {
    const glm::mat3 turned = glm::transpose(glm::inverse(glm::mat3(placed)));
    for (const SolidVertex& vertex : part)
        whole.push_back({glm::vec4(glm::vec3(placed * glm::vec4(glm::vec3(vertex.position), 1.0f)), vertex.position.w),
                         glm::vec4(glm::normalize(turned * glm::vec3(vertex.normal)), 0.0f), vertex.colour});
}

std::size_t parts_of(const Solid& solid) {
    float last = 0.0f;
    for (const SolidVertex& vertex : solid)
        last = std::max(last, vertex.position.w);
    return static_cast<std::size_t>(last) + 1;
}

Solid fan_stand(float radius, float height) {
    Solid solid = ring(radius, 0.035f * radius, 40, k_metal);
    add(solid, ring(0.62f * radius, 0.012f * radius, 32, k_metal), glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, 0.1f * radius}));
    for (int spoke = 0; spoke < 6; ++spoke) {
        const glm::mat4 turned = glm::rotate(glm::mat4(1.0f), turn_of(spoke, 6), {0.0f, 0.0f, 1.0f});
        add(solid, box({0.012f * radius, 0.5f * radius, 0.012f * radius}, k_metal),
            glm::translate(turned, {0.0f, 0.5f * radius, 0.1f * radius}));
    }
    const float pole = std::max(height - radius, 0.01f);
    add(solid, box({0.05f * radius, 0.5f * pole, 0.05f * radius}, k_metal),
        glm::translate(glm::mat4(1.0f), {0.0f, -radius - 0.5f * pole, 0.0f}));
    add(solid, box({0.5f * radius, 0.03f * radius, 0.4f * radius}, k_metal),
        glm::translate(glm::mat4(1.0f), {0.0f, -height + 0.03f * radius, 0.0f}));
    return solid;
}

Solid fan_blades(float radius) {
    Solid solid = lathe(std::array{glm::vec2(0.0f, -0.12f * radius), glm::vec2(0.1f * radius, -0.1f * radius),
                                   glm::vec2(0.12f * radius, 0.05f * radius), glm::vec2(0.0f, 0.14f * radius)},
                        14, k_metal);
    for (SolidVertex& vertex : solid) { // its axis along z
        vertex.position = {vertex.position.x, vertex.position.z, vertex.position.y, 0.0f};
        vertex.normal = {vertex.normal.x, vertex.normal.z, vertex.normal.y, 0.0f};
    }
    for (int blade = 0; blade < 5; ++blade) {
        glm::mat4 placed = glm::rotate(glm::mat4(1.0f), turn_of(blade, 5), {0.0f, 0.0f, 1.0f});
        placed = glm::rotate(glm::translate(placed, {0.0f, 0.5f * radius, 0.0f}), 0.6f, {0.0f, 1.0f, 0.0f});
        add(solid, box({0.17f * radius, 0.42f * radius, 0.008f * radius}, k_blade), placed);
    }
    return solid;
}

} // namespace windrow::vegetation::render
