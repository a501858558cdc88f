// Obstacles as a plane cuts them: filled sections with one outline around bodies that overlap. A plate is a line.
#pragma once

#include "cli/drawing/slice.h"

#include <glm/mat3x3.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace windrow::cli {

/// An obstacle near a plane, ready to be asked about places of the world.
struct CutBody {
    const NamedObstacle* named;
    glm::mat3 to_own{1.0f}; ///< from the world's axes to its own
    double reach = 0.0;     ///< [m] from its position to its farthest point

    [[nodiscard]] glm::vec3 own(const glm::dvec3& world) const { return to_own * glm::vec3(world - named->obstacle.position); }
    /// [m] From a place to its surface, negative inside.
    [[nodiscard]] float distance(const glm::dvec3& world) const;
    /// Whether the line between two places meets it.
    [[nodiscard]] bool blocks(const glm::dvec3& from, const glm::dvec3& to) const;
    [[nodiscard]] bool is_plate() const { return std::holds_alternative<Plate>(named->obstacle.shape); }
};

/// Those that may meet the plane within the box. The obstacles outlive them.
[[nodiscard]] std::vector<CutBody> bodies_at(std::span<const NamedObstacle> obstacles, const Plane& plane, const SlicedAir& air);

/// Whether a place is inside a body.
[[nodiscard]] bool inside_body(std::span<const CutBody> bodies, const glm::dvec3& world);

/// The line along which a plane cuts a plate, in the plane's coordinates; nothing where it misses it or holds all of it.
[[nodiscard]] std::optional<std::pair<glm::dvec2, glm::dvec2>> cut_of(const CutBody& plate, const Plane& plane);

/// Paints the sections upon a slice of the whole box.
void paint_sections(Image& slice, std::span<const CutBody> bodies, const Plane& plane, const SlicedAir& air);

} // namespace windrow::cli
