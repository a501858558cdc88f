#include "vegetation/render/cloak.h"

#include "coupling/spring.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

namespace windrow::vegetation::render {
namespace {

constexpr glm::vec3 k_cloth{0.125f, 0.022f, 0.018f}, k_lining{0.060f, 0.040f, 0.028f};
constexpr float k_weight = 5.5f; // [N/m2] of heavy wool
constexpr float k_drag = 0.6f;   // of a sheet in the lee of its wearer
constexpr float k_most = 2.2f;   // of the lean's tangent: drag along the cloth lets it fly no higher
constexpr std::size_t k_columns = Cloak::k_columns, k_rows = Cloak::k_rows;
constexpr float k_open = 2.15f; // [rad] from the middle of the back to either edge

std::size_t index(std::size_t column, std::size_t row) {
    return column * k_rows + row;
}

/// [rad] From the back, -z, toward the left.
float angle_of(std::size_t column) {
    return k_open * (2.0f * static_cast<float>(column) / static_cast<float>(k_columns - 1) - 1.0f);
}
/// Outward on the level, in the wearer's space.
glm::vec3 outward_of(std::size_t column) {
    const float angle = angle_of(column);
    return {std::sin(angle), 0.0f, -std::cos(angle)};
}
glm::vec2 on_level(const glm::vec3& v) {
    return {v.x, v.z};
}
/// From the wearer's space to the world.
glm::vec3 turned(const glm::vec3& v, float yaw) {
    const float c = std::cos(yaw), s = std::sin(yaw);
    return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}
/// Share of the lean that a row takes: the yoke holds the first ones.
float freedom_of(std::size_t row) {
    return glm::smoothstep(1.0f, 4.5f, static_cast<float>(row));
}
/// Frequency of a row: the hem swings as a pendulum of the cloak's length, the yoke twice as fast.
SpringClass spring_of(std::size_t row) {
    return {.frequency_hz = 1.5 - 0.07 * static_cast<double>(row), .damping = 0.35};
}

} // namespace

Cloak::Cloak()
    : place_(2 * k_columns * k_rows, 0.0), velocity_(place_), target_(place_), before_(place_),
      points_(k_columns * k_rows, glm::vec3(0.0f)) {}

Solid Cloak::solid(std::size_t first_part) {
    Solid solid;
    const auto corner = [&](std::size_t column, std::size_t row, float side) {
        const float part = static_cast<float>(first_part + index(column, row));
        return SolidVertex{.position = {0.0f, 0.0f, 0.004f * side, part},
                           .normal = {0.0f, 0.0f, side, 0.0f},
                           .colour = glm::vec4(side > 0.0f ? k_cloth : k_lining, 0.0f)};
    };
    for (const float side : {1.0f, -1.0f})
        for (std::size_t column = 0; column + 1 < k_columns; ++column)
            for (std::size_t row = 0; row + 1 < k_rows; ++row) {
                const SolidVertex a = corner(column, row, side), b = corner(column + 1, row, side),
                                  c = corner(column + 1, row + 1, side), d = corner(column, row + 1, side);
                solid.insert(solid.end(), {a, b, c, a, c, d});
            }
    return solid;
}

void Cloak::advance(double seconds, const Wearer& wearer) {
    lean(seconds, wearer);
    hang(wearer);
}

void Cloak::lean(double seconds, const Wearer& wearer) {
    speed_ = glm::length(on_level(wearer.high));
    if (seconds > 0.0)
        ripple_ = std::fmod(ripple_ + seconds * static_cast<double>(std::clamp(0.5f + 0.32f * speed_, 0.6f, 2.6f)), 1.0);
    before_ = target_;
    for (std::size_t row = 0; row < k_rows; ++row) {
        const float down = static_cast<float>(row) / static_cast<float>(k_rows - 1);
        const glm::vec2 wind = glm::mix(on_level(wearer.high), on_level(wearer.low), down);
        const float speed = glm::length(wind);
        glm::vec2 pull = 0.6f * k_drag / k_weight * speed * wind; // a
        pull *= k_most / (k_most + glm::length(pull)) * freedom_of(row);
        for (std::size_t column = 0; column < k_columns; ++column) {
            const glm::vec2 out = on_level(turned(outward_of(column), wearer.yaw));
            const glm::vec2 kept = pull - std::min(glm::dot(pull, out), 0.0f) * out;
            const std::size_t at = 2 * (row * k_columns + column);
            target_[at] = static_cast<double>(kept.x);
            target_[at + 1] = static_cast<double>(kept.y);
        }
    }
    if (!begun_) {
        before_ = target_;
        place_ = target_;
        begun_ = true;
    }
    for (std::size_t row = 0; row < k_rows && seconds > 0.0; ++row) {
        const auto step = spring_step(spring_of(row), seconds);
        const std::size_t at = 2 * k_columns * row;
        const auto of = [&](std::vector<double>& all) { return std::span(all).subspan(at, 2 * k_columns); };
        if (step)
            (void)advance_springs<double>(
                *step, {.place = of(place_), .velocity = of(velocity_), .target_before = of(before_), .target_now = of(target_)});
    }
}

void Cloak::hang(const Wearer& wearer) {
    const auto flesh = person_flesh(wearer.parts);
    const glm::mat4& torso = wearer.parts[person::torso];
    const auto out_of_flesh = [&](glm::vec3 p) {
        for (int pass = 0; pass < 6; ++pass) {
            float deepest = 0.0f;
            for (const PersonCapsule& capsule : flesh) {
                glm::vec3 outward;
                const float inside = k_margin - distance(capsule, p, outward);
                if (inside <= 0.0f)
                    continue;
                p += 1.02f * inside * outward;
                deepest = std::max(deepest, inside);
            }
            if (deepest < 1e-4f)
                break;
        }
        return p;
    };
    const float flutter = 0.30f * std::min(speed_ / 6.0f, 1.0f);
    for (std::size_t column = 0; column < k_columns; ++column) {
        const glm::vec3 out = outward_of(column);
        const float around = std::abs(angle_of(column)) / k_open;
        // Collar, and the shoulders' edge: an ellipse, drawn in at the breast where the cloak is clasped.
        const glm::vec3 collar(0.088f * out.x, 0.565f - 0.045f * around * around, 0.085f * out.z);
        const glm::vec3 shoulder(0.262f * out.x * (1.0f - 0.18f * around * around), 0.500f - 0.03f * around, 0.150f * out.z);
        points_[index(column, 0)] = glm::vec3(torso * glm::vec4(collar, 1.0f));
        glm::vec3 last = out_of_flesh(glm::vec3(torso * glm::vec4(shoulder, 1.0f)));
        points_[index(column, 1)] = last;
        for (std::size_t row = 2; row < k_rows; ++row) {
            const std::size_t at = 2 * (row * k_columns + column);
            const glm::vec3 leant =
                turned({static_cast<float>(place_[at]), 0.0f, static_cast<float>(place_[at + 1])}, -wearer.yaw);
            const float down = static_cast<float>(row) / static_cast<float>(k_rows - 1);
            const double turns = ripple_ - 1.1 * static_cast<double>(down) + 0.17 * static_cast<double>(column);
            const float folds = 0.05f * std::cos(2.4f * static_cast<float>(column)) * down; // it hangs in folds
            const float ripple = flutter * down * static_cast<float>(std::sin(glm::two_pi<double>() * turns));
            const glm::vec3 way = glm::vec3(0.0f, -1.0f, 0.0f) + (0.10f + folds + ripple) * out + leant;
            last = out_of_flesh(last + k_link * glm::normalize(way));
            last.y = std::max(last.y, 0.04f);
            points_[index(column, row)] = last;
        }
    }
}

std::vector<glm::mat4> Cloak::placements() const {
    std::vector<glm::mat4> placed;
    placed.reserve(points_.size());
    for (std::size_t column = 0; column < k_columns; ++column)
        for (std::size_t row = 0; row < k_rows; ++row) {
            const auto point = [&](std::size_t c, std::size_t r) { return points_[index(c, r)]; };
            const glm::vec3 across = point(std::min(column + 1, k_columns - 1), row) - point(column > 0 ? column - 1 : 0, row);
            const glm::vec3 downward = point(column, std::min(row + 1, k_rows - 1)) - point(column, row > 0 ? row - 1 : 0);
            glm::vec3 normal = glm::cross(across, downward); // outward: columns run from the right to the left
            const float size = glm::length(normal);
            normal = size > 1e-9f ? normal / size : outward_of(column);
            const glm::vec3 y = -glm::normalize(downward - glm::dot(downward, normal) * normal + glm::vec3(0.0f, -1e-6f, 0.0f));
            const glm::vec3 x = glm::cross(y, normal);
            placed.push_back(
                {glm::vec4(x, 0.0f), glm::vec4(y, 0.0f), glm::vec4(normal, 0.0f), glm::vec4(point(column, row), 1.0f)});
        }
    return placed;
}

} // namespace windrow::vegetation::render
