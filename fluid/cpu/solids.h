// Obstacles in the cells of a box.
//
// A face between two cells is closed by a fraction c of its area, 1 - c is open. Face fluxes of the projection are
// (1 - c) (u_low + u_high) / 2 + c U, with the body's own velocity U across the face. The pressure's operator is
//
//   A = L - B,   (B phi)(cell) = sum over its faces of c (phi(neighbour) - phi(cell))
//
// L the 7-point Laplacian of the empty box. The gradient is the adjoint of the divergence: half of each open face's slope. A cell
// whose faces are all closed is shut. Faces between two shut cells count as open: they couple cells without any flow.
//
// Surface cells are those with a closed face. All work of a step runs over sorted lists of faces and cells: it is the same for
// any number of threads.
//
// A body is drawn once: its closed faces and inside cells, in cells of the world's lattice. A drawing is kept while the body rests
// there, so a box that moves reads lists and computes no distance, except those of bodies that come into reach.
#pragma once

#include "fluid/box.h"
#include "fluid/obstacle.h"
#include "fluid/parallel.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace windrow::cpu {

using detail::PlacedObstacle;

/// A closed face, between a cell and its high neighbour along an axis.
struct ClosedFace {
    std::uint32_t cell[2] = {};      ///< low and high, indices in fields
    std::uint32_t potential[2] = {}; ///< the same in the direct solve's rows
    std::uint32_t surface[2] = {};   ///< the same among the surface cells
    float closed = 0.0f;             ///< fraction
    float wall = 0.0f;               ///< [m/s] closed times the body's own velocity along the axis
    std::uint16_t body = 0;
    std::uint8_t axis = 0;
    bool shut[2] = {}; ///< of the cells
};

class Solids {
  public:
    /// A cell with a closed face.
    struct SurfaceCell {
        std::uint32_t cell = 0, potential = 0;
        bool shut = false; ///< no open face
        bool edge = false; ///< at a boundary of the box
    };
    /// A cell whose centre is inside a body.
    struct InsideCell {
        std::uint32_t cell = 0, potential = 0;
        glm::ivec3 place{0};
        std::uint16_t body = 0;
        bool shut = false;
    };
    /// A cell inside a body that a cubic read from outside reaches: its value is the mean of what `count` cells nearer to the air
    /// give.
    struct Ghost {
        std::uint32_t cell = 0, first = 0, count = 0;
    };
    /// A cell beside a ghost. Across a closed face the component along the face's axis is mirrored about the body's velocity, as
    /// at the walls of a box: u + closed (2 U - 2 u). The others are the same. Without the mirror, air that leaves a wall reads
    /// its own value there and grows without bound.
    struct GhostSource {
        std::uint32_t cell = 0;
        std::uint8_t axis = 0;
        float closed = 0.0f;
        float wall = 0.0f; ///< [m/s] U
    };

    Solids(const Box& box, int pitch);

    /// Replaces all obstacles. `shift`: cells by which the box has moved since the last call.
    void place(std::span<const PlacedObstacle> obstacles, glm::ivec3 shift = glm::ivec3(0));
    [[nodiscard]] bool any() const { return !faces_.empty() || !inside_.empty(); }

    [[nodiscard]] std::span<const ClosedFace> faces() const { return faces_; }
    [[nodiscard]] std::span<const SurfaceCell> surface() const { return surface_; }
    [[nodiscard]] std::span<const InsideCell> inside() const { return inside_; }
    /// Ghosts by layers: those of a layer read the air and the layers before it.
    [[nodiscard]] std::span<const Ghost> ghosts() const { return ghosts_; }
    [[nodiscard]] std::span<const GhostSource> ghost_sources() const { return ghost_sources_; }
    [[nodiscard]] std::span<const std::uint32_t> layer_ends() const { return layer_ends_; }
    [[nodiscard]] std::span<const PlacedObstacle> bodies() const { return bodies_; }

    /// Air cells from which a read or a trajectory may pass through a thin body.
    [[nodiscard]] std::span<const std::uint32_t> thin() const { return thin_; }
    [[nodiscard]] bool any_thin() const { return thinnest_ < k_farthest_thin; }
    /// Makes the list of them hold for trajectories of so many cells and a cubic read.
    void reach_past_thin(float cells);

    /// Whether the face from a cell to its high neighbour along an axis is more closed than open, and whether a cell is inside.
    [[nodiscard]] bool blocked(std::uint32_t cell, int axis) const { return (flags_[cell] >> axis & 1) != 0; }
    [[nodiscard]] bool inside(std::uint32_t cell) const { return (flags_[cell] & k_inside) != 0; }
    /// The face from a cell to its high neighbour; null: open.
    [[nodiscard]] const ClosedFace* face(std::uint32_t low_cell, int axis) const {
        const std::uint32_t n = face_of_[3 * static_cast<std::size_t>(low_cell) + static_cast<std::size_t>(axis)];
        return n == k_none ? nullptr : &faces_[n];
    }

    [[nodiscard]] glm::ivec3 place_of(std::uint32_t cell) const;
    /// Bodies that were drawn, not taken from the last call, by the last call.
    [[nodiscard]] int drawn() const { return drawn_; }
    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    /// Flags of a cell beside its three blocked faces; k_low: it is the low cell of a closed face.
    static constexpr std::uint8_t k_inside = 8, k_shut = 16, k_thin = 32, k_low = 64, k_surface = 128;
    static constexpr std::uint32_t k_none = ~std::uint32_t{0};
    static constexpr int k_ghost_layers = 3;
    static constexpr float k_farthest_thin = 64.0f; ///< [cells] thickness beyond which no trajectory passes a body
    static constexpr int k_least_reach = 4;         ///< [cells] with the default largest CFL number

    /// The cells of one body; positions are cells of the box, of now.
    struct Drawing {
        struct Face {
            glm::ivec3 cell;
            int axis;
            float closed, wall;
        };
        PlacedObstacle body;
        glm::ivec3 low{0}, high{0}; ///< cells drawn: all that the body reaches within the box and some beyond
        std::vector<Face> faces;
        std::vector<glm::ivec3> inside;
    };

    struct Reach {
        glm::ivec3 low, high; ///< cells low <= cell < high
    };
    [[nodiscard]] Reach reach_of(const PlacedObstacle& obstacle, glm::ivec3 beyond) const;
    [[nodiscard]] bool still_holds(const Drawing& drawing, const PlacedObstacle& obstacle) const;
    void draw(Drawing& drawing);
    /// `offset`: cells from the body to its image.
    void draw_image(Drawing& drawing, const Reach& reach, glm::ivec3 offset);
    void collect_faces();
    void find_shut_cells();
    void collect_surface();
    void collect_ghosts();
    void find_thin_bodies();
    void collect_thin();
    [[nodiscard]] bool neighbour(glm::ivec3 cell, int axis, int side, glm::ivec3& result) const;
    [[nodiscard]] std::uint32_t index(glm::ivec3 cell) const;
    [[nodiscard]] std::uint32_t potential_of(glm::ivec3 cell) const;
    /// visit(cell, place) for each cell with one of the flags, in order.
    template <class Visit>
    void for_each_flagged(std::uint8_t flags, const Visit& visit) const;
    /// visit(neighbour, axis, face between, null: open) for each neighbour of a cell.
    template <class Visit>
    void for_each_neighbour(const InsideCell& cell, const Visit& visit) const;

    Box box_;
    int pitch_;
    int drawn_ = 0;
    float thinnest_ = k_farthest_thin; ///< [cells] thickness of the thinnest body
    int reach_ = k_least_reach;        ///< [cells] around thin bodies
    std::vector<PlacedObstacle> bodies_;
    std::vector<Drawing> drawings_, drawings_before_;
    std::vector<std::uint8_t> thin_bodies_; ///< whether each body is thin
    std::vector<ClosedFace> faces_;
    std::vector<SurfaceCell> surface_;
    std::vector<InsideCell> inside_;
    std::vector<Ghost> ghosts_;
    std::vector<GhostSource> ghost_sources_;
    std::vector<std::uint32_t> layer_ends_, thin_;
    std::vector<ClosedFace> unsorted_;
    std::vector<std::uint8_t> flags_;       ///< one a cell
    std::vector<std::uint16_t> body_of_;    ///< one a cell: body that an inside cell is in
    std::vector<std::uint32_t> surface_of_; ///< one a cell: number of a surface cell
    std::vector<std::uint8_t> layers_;      ///< one a cell: layer of a ghost
    std::vector<std::uint32_t> face_of_;    ///< three a cell: face to the high neighbour
    std::vector<float> distances_;          ///< scratch: at the corners of an obstacle's cells
};

} // namespace windrow::cpu
