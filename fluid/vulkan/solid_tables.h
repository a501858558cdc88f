// Obstacles as the device takes them: rasterised on the host (fluid/solids/solids.h), then written as one table of words
// (shaders/fluid/solids.glsl). They are made again only when an obstacle in reach of the box or the box itself has moved.
#pragma once

#include "fluid/solids/solids.h"
#include "fluid/vulkan/blocks.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace windrow::vulkan {

class SolidTables {
  public:
    /// `max_cfl`: of a sub-step; reads of faster air are one-sided in all cells where a body is sub-grid. `loads`: forces are asked for.
    SolidTables(const Box& box, float max_cfl, bool loads);

    /// Replaces all obstacles. `shift`: cells by which the box has moved since the last call. Throws std::bad_alloc.
    void place(std::span<const detail::PlacedObstacle> obstacles, glm::ivec3 shift);

    [[nodiscard]] bool any() const { return solids_.any(); }
    /// Of k_flags.
    [[nodiscard]] int flags() const;
    static constexpr int k_flags = WINDROW_OBSTACLES | WINDROW_ROOMS | WINDROW_THIN | WINDROW_BODIES_MOVE;
    /// Whether reads may have to be one-sided.
    [[nodiscard]] bool one_sided() const { return (flags() & (WINDROW_THIN | WINDROW_ROOMS)) != 0; }
    [[nodiscard]] const Solids& solids() const { return solids_; }

    /// What the device reads: WindrowSolids, then words. The history's places are the caller's to set.
    [[nodiscard]] WindrowSolids& head() { return head_; }
    [[nodiscard]] std::span<const std::byte> bytes();

    /// Closed faces, as SurfaceHistory names them: 4 times the low cell, plus the axis; sorted.
    [[nodiscard]] std::span<const std::uint32_t> keys() const { return keys_; }
    /// Drops all lists, for other boundaries or rows at another height. Bodies keep their names until the next placement, and closed faces
    /// theirs where `keeps_faces`. Throws std::bad_alloc.
    void begin_anew(const Box& box, bool keeps_faces);
    /// The faces of a wind that was loaded, before the first placement.
    void set_keys(std::vector<std::uint32_t> keys) { keys_ = std::move(keys); }

  private:
    /// A ghost's value: the air's of these cells.
    struct Term {
        std::uint32_t cell;
        float weight;
        glm::vec3 normal;
        float wall;
    };

    [[nodiscard]] int here() const { return static_cast<int>(words_.size() - sizeof(WindrowSolids) / sizeof(std::int32_t)); }
    void add_records();
    void add_faces();
    void add_bodies();
    void add_surface();
    void add_rooms(glm::ivec3 shift);
    void add_sealed();
    void add_bytes();
    void add_origins(glm::ivec3 shift);
    void add_loads();
    void flatten_ghosts();
    void find_reaches();

    Box box_;
    bool loads_;
    int farthest_; ///< [cells] reach of a one-sided read that the bytes know
    Solids solids_;
    WindrowSolids head_{};
    std::vector<std::int32_t> words_; ///< room for the head, then the tables
    std::vector<std::uint32_t> keys_, keys_before_;
    std::vector<std::int32_t> origins_;                                         ///< as Solids::find_origins
    std::vector<std::int32_t> body_starts_;                                     ///< scratch
    std::vector<std::pair<std::uint32_t, std::uint32_t>> names_, names_before_; ///< of bodies: slots and generations
    std::vector<std::int32_t> by_slot_;                                         ///< scratch: a body before of each slot
    std::vector<std::uint32_t> cells_;                                          ///< of the records, in order
    std::vector<Term> terms_;                                                   ///< of all ghosts
    std::vector<std::uint32_t> first_terms_;                                    ///< of each ghost, and the end
    std::vector<std::uint32_t> ghost_of_;                                       ///< one a cell: number of a ghost
    std::vector<std::uint8_t> reaches_, smeared_;                               ///< one a cell
};

} // namespace windrow::vulkan
