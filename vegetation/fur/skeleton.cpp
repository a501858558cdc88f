#include "vegetation/fur/skeleton.h"

#include "fluid/core/validation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

namespace windrow::vegetation::fur {
namespace {

using windrow::detail::message;

double wide(float value) {
    return static_cast<double>(value);
}

double distance_to(const Bone& bone, const glm::dvec3& p) {
    const glm::dvec3 head(bone.head), along = glm::dvec3(bone.tail) - head;
    const double square = glm::dot(along, along);
    const double t = square > 0.0 ? std::clamp(glm::dot(p - head, along) / square, 0.0, 1.0) : 0.0;
    return glm::length(p - head - t * along);
}

// sin of a turning angle, whose turns are counted in double so that hours of time lose nothing.
double wave(float hz, double seconds, float phase, double times) {
    const double turns = wide(hz) * seconds * times;
    return std::sin(2.0 * std::numbers::pi * (turns - std::floor(turns)) + wide(phase));
}

double angle_of(const Swing& swing, double seconds) {
    // The second harmonic runs at 2 a = 4 pi hz t + 2 phase.
    return wide(swing.rest) + wide(swing.amplitude) * wave(swing.hz, seconds, swing.phase, 1.0) +
           wide(swing.second) * wave(swing.hz, seconds, 2.0f * swing.phase + swing.second_phase, 2.0);
}

} // namespace

Result<void> validate(const Skeleton& skeleton) {
    windrow::detail::Reasons reasons;
    windrow::detail::check_items(reasons, {nullptr, "skeleton.bones"}, std::span(skeleton.bones), {1.0, k_max_bones});
    if (skeleton.bones.size() <= k_max_bones)
        for (std::size_t i = 0; i < skeleton.bones.size(); ++i)
            if (const int parent = skeleton.bones[i].parent; parent < -1 || parent >= static_cast<int>(i))
                reasons.add("skeleton.bones[", i, "].parent is ", parent, ": give a bone before it, or -1.");
    return reasons.outcome();
}

Result<void> bind(Mesh& mesh, const Skeleton& skeleton) {
    if (const auto valid = validate(skeleton); !valid)
        return valid;
    if (const auto valid = validate(mesh); !valid)
        return valid;
    for (MeshVertex& vertex : mesh.vertices) {
        std::array<std::pair<double, std::uint32_t>, 5> nearest; // by strength, the strongest first
        nearest.fill({0.0, 0});
        for (std::uint32_t i = 0; i < skeleton.bones.size(); ++i) {
            const double d = distance_to(skeleton.bones[i], vertex.position) / wide(skeleton.bones[i].radius);
            const std::pair<double, std::uint32_t> candidate{1.0 / (0.05 + d * d * d * d), i};
            if (candidate.first <= nearest.back().first)
                continue;
            nearest.back() = candidate;
            for (std::size_t k = 4; k > 0 && nearest[k].first > nearest[k - 1].first; --k)
                std::swap(nearest[k], nearest[k - 1]);
        }
        double sum = 0.0;
        for (std::size_t k = 0; k < 4; ++k)
            sum += nearest[k].first - nearest[4].first;
        for (int k = 0; k < 4; ++k) {
            // Where five bones are equally near none is chosen: the first holds all.
            const double strength = nearest[static_cast<std::size_t>(k)].first - nearest[4].first;
            vertex.bones[k] = nearest[static_cast<std::size_t>(k)].second;
            vertex.weights[k] = sum > 0.0 ? static_cast<float>(strength / sum) : k == 0 ? 1.0f : 0.0f;
        }
    }
    return {};
}

std::vector<glm::mat4> pose(const Skeleton& skeleton, double seconds) {
    struct Place {
        glm::dquat turn{1.0, 0.0, 0.0, 0.0};
        glm::dvec3 shift{0.0};
    };
    std::vector<Place> places;
    std::vector<glm::mat4> matrices;
    for (const Bone& bone : skeleton.bones) {
        const Place above = bone.parent < 0 ? Place{} : places[static_cast<std::size_t>(bone.parent)];
        glm::dquat turn(1.0, 0.0, 0.0, 0.0);
        for (const Swing& swing : bone.swings)
            turn = turn * glm::angleAxis(angle_of(swing, seconds), glm::normalize(glm::dvec3(swing.axis)));
        // p -> above(head + sway + turn (p - head)); the shift is what is left of it at p = 0.
        const glm::dvec3 head(bone.head);
        const glm::dvec3 local = head - turn * head + glm::dvec3(bone.sway) * wave(bone.sway_hz, seconds, bone.sway_phase, 1.0);
        const Place place{glm::normalize(above.turn * turn), above.shift + above.turn * local};
        places.push_back(place);
        glm::dmat4 matrix = glm::mat4_cast(place.turn);
        matrix[3] = glm::dvec4(place.shift, 1.0);
        matrices.emplace_back(matrix);
    }
    return matrices;
}

Result<void> skin(const Mesh& mesh, std::span<const glm::mat4> matrices, std::span<glm::vec3> positions,
                  std::span<glm::vec3> normals) {
    if (positions.size() != mesh.vertices.size() || normals.size() != mesh.vertices.size())
        return windrow::Error{message("skin.positions and .normals have ", positions.size(), " and ", normals.size(),
                                      " entries: give ", mesh.vertices.size(), ".")};
    for (const MeshVertex& vertex : mesh.vertices)
        for (int k = 0; k < 4; ++k)
            if (vertex.weights[k] > 0.0f && vertex.bones[k] >= matrices.size())
                return windrow::Error{
                    message("skin.matrices has ", matrices.size(), " entries: give one for bone ", vertex.bones[k], ".")};
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const MeshVertex& vertex = mesh.vertices[i];
        positions[i] = vertex.position;
        normals[i] = vertex.normal;
        if (vertex.weights == glm::vec4(0.0f))
            continue;
        glm::vec3 position(0.0f), normal(0.0f);
        for (int k = 0; k < 4; ++k)
            if (vertex.weights[k] > 0.0f) {
                const glm::mat4& matrix = matrices[vertex.bones[k]];
                position += vertex.weights[k] * glm::vec3(matrix * glm::vec4(vertex.position, 1.0f));
                normal += vertex.weights[k] * glm::vec3(matrix * glm::vec4(vertex.normal, 0.0f));
            }
        positions[i] = position;
        // Bones that face apart by half a turn leave no direction.
        if (const float length = glm::length(normal); length > 1e-6f)
            normals[i] = normal / length;
    }
    return {};
}

} // namespace windrow::vegetation::fur
