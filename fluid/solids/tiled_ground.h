// The surface of upright grounds: one that goes on beyond its edge, or the tiles at rest that end (Beyond::nothing), as one surface.
// The height of a place is the greatest among the tiles that hold it, so no wall is between tiles that meet; the surface ends where no
// tile goes on. Each face and each cell is drawn by one tile, its owner, from the whole surface: where tiles are drawn one by one and
// their closed parts are added, a face across a seam is wrong by some per cent.
//
// Places are [m] along the world's axes from the middle of the ground that is drawn. The surface itself is around a middle of its own:
// so many small tiles have one surface, which each of them draws from.
#pragma once

#include "fluid/obstacle.h"
#include "fluid/solids/plane_buckets.h"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace windrow {

class TiledGround {
  public:
    enum class Owner : std::uint8_t { drawn, other, none };
    static constexpr float k_slack = 1e-3f;       ///< of a cell: places of bodies are rounded to a fourth of it
    static constexpr float k_into_column = 0.75f; ///< [cells] from a column's centre to its corners, and some

    [[nodiscard]] static bool is_upright_ground(const PlacedObstacle& body) {
        return std::holds_alternative<Ground>(body.shape) && body.axes[1] == glm::vec3(0.0f, 1.0f, 0.0f);
    }
    [[nodiscard]] static bool is_tile(const PlacedObstacle& body) {
        return is_upright_ground(body) && std::get<Ground>(body.shape).beyond == Beyond::nothing && !body.moves();
    }

    /// The ground at a place.
    struct Level {
        float height = 0.0f, between = 0.0f; ///< [m] in the own heights of its tile; from these to those of the drawn one
        float end = 0.0f;                    ///< [m] to where the surface ends; `far` and more: farther
        bool ground = false;                 ///< false: there is none
        [[nodiscard]] float level() const { return height - between; }           ///< [m] from the drawn one's middle
        [[nodiscard]] float rise(float y) const { return y + between - height; } ///< [m] of a place over it
    };

    /// `cell` [m]: places nearer than a thousandth of it to a tile are held by it. `far` [m]: beyond it distances from the end need not
    /// be right.
    void begin(float cell, float far);
    /// `between`: [m] from its middle to that of the surface. `kind`: its number in an order of what tiles are, equal where they are the
    /// same.
    void add(const PlacedObstacle& body, glm::vec3 between, std::uint32_t kind = 0);
    /// After the last. Where several could own a place, it is the first by what they are, whatever order they were added in.
    void end();
    /// The ground that is drawn, of those that were added, and [m] its middle from that of the surface.
    void draw(const PlacedObstacle& body, glm::vec3 from = glm::vec3(0.0f)) {
        drawn_ = &body;
        from_ = from;
    }
    void clear() { tiles_.clear(); }
    [[nodiscard]] bool empty() const { return tiles_.empty(); }
    [[nodiscard]] float far() const { return far_; }

    [[nodiscard]] Level at(glm::vec2 from_drawn) const;
    /// [m] From the surface, negative below it: over it the height, outside of its ends the distance.
    [[nodiscard]] float away(const Level& level, glm::vec3 place) const;
    [[nodiscard]] float away(glm::vec3 place) const { return away(at({place.x, place.z}), place); }
    /// Unit vector out of the surface, from distances at `step` [m] on either side; zero where they are equal.
    [[nodiscard]] glm::vec3 normal(glm::vec3 place, float step) const;
    /// [m] The highest level that the surface has along a level line; minus infinity where none is.
    [[nodiscard]] float crest(glm::vec2 from_drawn, glm::vec2 to_drawn) const;
    /// Whose a column of cells is, by the place of its centre: that of the tile that holds it, or else of one that may reach into it.
    [[nodiscard]] Owner owner(glm::vec2 from_drawn) const;

  private:
    struct Tile {
        const PlacedObstacle* body;
        const Ground* ground;
        glm::mat3 to_own;
        glm::vec3 between;
        detail::GroundPart whole;
        std::span<const detail::GroundPart> parts, holes; ///< of the lists of all
        glm::vec2 low, high;                              ///< holds it
        float top;                                        ///< [m] nothing of it is higher
        std::uint32_t kind;
        bool repeats = false; ///< another one before it has the same sides
        [[nodiscard]] glm::vec3 own_place(glm::vec2 place) const {
            return to_own * (glm::vec3(place.x, 0.0f, place.y) + between);
        }
        [[nodiscard]] glm::vec2 world_place(glm::vec2 own) const {
            const glm::vec3 world = body->axes * glm::vec3(own.x, 0.0f, own.y) - between;
            return {world.x, world.z};
        }
        [[nodiscard]] bool is_near(glm::vec2 place, float distance) const {
            return place.x >= low.x - distance && place.x <= high.x + distance && place.y >= low.y - distance &&
                   place.y <= high.y + distance;
        }
        /// Beyond its edge.
        [[nodiscard]] bool goes_on() const { return ground->beyond == Beyond::edge; }
        /// [m] Outside of it; 0: it holds the place.
        [[nodiscard]] float outside(glm::vec2 place) const;
    };
    /// Where the ground ends: a part of a tile's side, or of a hole's, beyond which no tile goes on.
    struct End {
        glm::vec2 from, to;
    };
    void find_repeated();
    void find_ends();
    void cover(glm::vec2 begin, glm::vec2 end);
    void add_ends(const Tile& tile, glm::vec2 from, glm::vec2 to, glm::vec2 outwards);
    // Places from here on are from the middle of the surface.
    [[nodiscard]] glm::vec2 here(glm::vec2 place) const { return place + glm::vec2(from_.x, from_.z); }
    /// visit(tile) for each tile whose corners are within `distance` [m] of a place along each axis; false from it ends the search.
    template <class Visit>
    void each_near(glm::vec2 place, float distance, const Visit& visit) const;
    template <class Look>
    void each_ring(std::size_t count, const float& nearest, const Look& look) const;
    [[nodiscard]] float to_end(glm::vec2 place) const;
    [[nodiscard]] float beside(glm::vec3 place) const;

    std::vector<Tile> tiles_;
    std::vector<detail::GroundPart> parts_, holes_;
    std::vector<End> ends_;
    PlaneBuckets tiles_at_, ends_at_;  ///< by place
    std::vector<glm::vec2> covered_;   ///< scratch: parts of a line
    std::vector<std::uint32_t> order_; ///< scratch
    const PlacedObstacle* drawn_ = nullptr;
    glm::vec3 from_{0.0f};
    float cell_ = 1.0f, far_ = 3.0f, slack_ = 1e-3f;
};

} // namespace windrow
