// Bodies that touch or overlap are one solid. Which faces one of them closes follows from the distance to all of them: drawn one by one,
// two that overlap would close a face twice, and beside a seam, or on the floor, the distance would be that from an end which is no
// surface.
//
// Outside, the distance to all is the least of theirs. Inside it is more than that where what is nearest is a seam: the point is then
// as deep as a ball within the bodies on both sides of the seam. That is exact where they go on from the seam as they are at it, as
// the halves of a wall, a house on its ground, or the arms of an L, but for a corner of the air between two arms.
#pragma once

#include "fluid/obstacle.h"

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace windrow {

class Together {
  public:
    /// Of an image of a body. Places are [m] from its middle along the world's axes. `cell` [m]; beyond `far` [m] from a surface
    /// distances need not be right. The bodies must stay. Seams with other bodies are not looked for where that takes too long, in a
    /// mesh that moves: beside them it is as deep as it is by itself.
    void begin(const PlacedObstacle& body, float cell, float far);
    /// The wall at the low or high end of the box along an axis, `away` [m] along it: no air is beyond it.
    void add_wall(int axis, bool high, float away);
    /// A body that touches it, `from` [m] it. What is drawn without regard to it, and before it, closes its part of a face by itself.
    void add(const PlacedObstacle& other, glm::vec3 from, bool drawn_before);
    /// After the last.
    void end();

    [[nodiscard]] bool any_drawn_before() const { return any_before_; }
    /// [m] From the surface of all, negative inside.
    [[nodiscard]] float away(glm::vec3 place) const { return away(place, Of::all, 0); }
    /// Of those that are not drawn before it, and of all others.
    struct Apart {
        float own, before; ///< [m] as `away`; within the others, `own` is as it is at their surface
    };
    [[nodiscard]] Apart apart(glm::vec3 place) const;
    /// [m] From what is not drawn before it.
    [[nodiscard]] float own_away(glm::vec3 place) const { return nearest(place, Of::own, far_).away; }
    /// Whether those that are not drawn before it hold a place.
    [[nodiscard]] bool holds_own(glm::vec3 place, float touch) const {
        return nearest(place, Of::own, 2.0f * touch).away <= touch;
    }
    /// Whether a place is another's that is not drawn before it: of the one with the least distance.
    [[nodiscard]] bool is_anothers(glm::vec3 place) const;
    /// Unit vector out of the surface of all at a place near it, from distances at `step` [m] on either side; 0 where they are equal.
    [[nodiscard]] glm::vec3 normal(glm::vec3 place, float step) const;
    /// Whether a body that is not drawn before it passes between two places outside of them.
    [[nodiscard]] bool blocks(glm::vec3 from, glm::vec3 to) const;
    /// Whether one that is not drawn before it has sharp edges.
    [[nodiscard]] bool any_edges() const { return any_edges_; }
    /// How much a sharp edge of those along an axis is one of all, and as near to a place as a cell of some size [m] that it passes
    /// through: 0 to 1 for each axis.
    [[nodiscard]] glm::vec3 edges_at(glm::vec3 place, glm::vec3 cell_size) const;
    /// [m] How far all go on, along a way of its own, from a place inside.
    [[nodiscard]] float run_from(glm::vec3 place, glm::vec3 way, float most) const;

    /// Whether two bodies touch or overlap, the other one `from` [m] the first. `cell` [m].
    [[nodiscard]] static bool touch(const PlacedObstacle& one, const PlacedObstacle& other, glm::vec3 from, float cell);

  private:
    struct Body {
        const PlacedObstacle* body;
        glm::mat3 to_own;
        glm::vec3 from; ///< [m] its middle
        detail::Extent extent;
        bool drawn_before, precedes; ///< `precedes`: what is as near to both is its own
        bool is_bridge = false;      ///< no body, but a block within two of them
        [[nodiscard]] float distance(glm::vec3 place, float most) const {
            return detail::distance_to(body->shape, to_own * (place - from), most);
        }
    };
    enum class Of : std::uint8_t { all, own, before };
    struct Nearest {
        float away;
        const Body* body;
    };
    /// `most` [m]: as in detail::distance_to.
    [[nodiscard]] Nearest nearest(glm::vec3 place, Of of, float most) const;
    [[nodiscard]] float away(glm::vec3 place, Of of, int seams) const;
    [[nodiscard]] float depth(glm::vec3 place, const Nearest& surface, Of of, int seams) const;
    [[nodiscard]] glm::vec3 wall_at(glm::vec3 place, const Nearest& surface) const;
    [[nodiscard]] bool is_beyond_wall(glm::vec3 place) const;
    [[nodiscard]] float sharpness(glm::vec3 edge, glm::vec3 beside) const;
    [[nodiscard]] bool others_reach(glm::vec3 place, const Nearest& surface) const;
    [[nodiscard]] glm::vec3 seam_at(glm::vec3 place, const Nearest& surface) const;
    [[nodiscard]] bool is_in_air(glm::vec3 place) const;
    [[nodiscard]] glm::vec3 out_of(const Body& body, glm::vec3 place, float step, float most) const;

    void add_bridges(const Body& other, std::size_t& count);

    std::vector<Body> bodies_; ///< the first is the one drawn
    std::vector<PlacedObstacle> bridges_;
    std::array<float, 6> walls_{};
    std::array<bool, 6> has_wall_{};
    bool any_wall_ = false, any_before_ = false, any_edges_ = false, has_seams_ = true;
    float cell_ = 1.0f, far_ = 3.0f;
};

} // namespace windrow
