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
// Surface cells are those with a closed face. All work of a step runs over lists of them, sorted by cell: it is the same for
// any number of threads.
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

/// A cell beside a closed face. Slots of its faces: x low, x high, y low, y high, z low, z high.
struct SurfaceCell {
    std::uint32_t cell = 0;      ///< index in fields
    std::uint32_t potential = 0; ///< index in the direct solve's rows
    float closed[6] = {};        ///< fraction of each face
    float wall = 0.0f;           ///< [m/s] outward flux of the bodies' own motion: sum of c U
    std::uint16_t body[6] = {};  ///< of each closed face
    bool shut = false;           ///< no open face
    bool at_edge = false;        ///< at a boundary of the box
};

class Solids {
  public:
    /// A cell whose centre is inside a body.
    struct InsideCell {
        std::uint32_t cell = 0, potential = 0;
        std::uint16_t body = 0;
        bool deep = false; ///< shut, without a closed face
    };
    /// A cell inside a body that a cubic read from outside reaches: its value is the mean of what `count` cells nearer to the air
    /// give.
    struct Ghost {
        std::uint32_t cell = 0, first = 0;
        std::uint32_t count = 0;
    };
    /// A cell beside a ghost. Across a closed face the component along the face's axis is mirrored about the body's velocity, as
    /// at the walls of a box: u + closed (2 U - 2 u). The others are the same. Without the mirror, air that leaves a wall reads
    /// its own value there and grows without bound.
    struct GhostSource {
        std::uint32_t cell = 0;
        std::uint16_t body = 0;
        std::uint8_t axis = 0;
        bool high = false; ///< the source is the high neighbour
        float closed = 0.0f;
    };

    Solids(const Box& box, int pitch);

    /// Replaces all obstacles.
    void rasterise(std::span<const PlacedObstacle> obstacles);
    [[nodiscard]] bool any() const { return !surface_.empty(); }

    [[nodiscard]] std::span<const SurfaceCell> surface() const { return surface_; }
    [[nodiscard]] std::span<const InsideCell> inside() const { return inside_; }
    /// Ghosts by layers: those of a layer read the air and the layers before it.
    [[nodiscard]] std::span<const Ghost> ghosts() const { return ghosts_; }
    [[nodiscard]] std::span<const GhostSource> ghost_sources() const { return ghost_sources_; }
    [[nodiscard]] std::span<const std::uint32_t> layer_ends() const { return layer_ends_; }
    /// Air cells from which a read or a trajectory may pass through a thin body.
    [[nodiscard]] std::span<const std::uint32_t> thin() const { return thin_; }
    [[nodiscard]] bool any_thin() const { return thinnest_ < k_farthest_thin; }
    /// Makes the list of them hold for trajectories of so many cells and a cubic read. Allocates nothing.
    void reach_past_thin(float cells);
    [[nodiscard]] std::span<const PlacedObstacle> bodies() const { return bodies_; }

    /// Whether the face from a cell to its high neighbour along an axis is more closed than open, and whether a cell is inside.
    [[nodiscard]] bool blocked(std::uint32_t cell, int axis) const { return (flags_[cell] >> axis & 1) != 0; }
    /// [m/s] Velocity across that face of its bodies; 0 where it is open.
    [[nodiscard]] float wall_speed(std::uint32_t low_cell, int axis) const;
    [[nodiscard]] bool inside(std::uint32_t cell) const { return (flags_[cell] & k_inside) != 0; }

    /// Index offsets of a cell's neighbours, slot by slot; across a periodic boundary from `strides` of the same layout.
    struct Strides {
        std::ptrdiff_t row, plane;
    };
    [[nodiscard]] std::ptrdiff_t to_neighbour(const SurfaceCell& cell, int slot, const Strides& strides) const;
    [[nodiscard]] Strides cell_strides() const { return {box_.cells.x, std::ptrdiff_t(box_.cells.x) * box_.cells.y}; }
    [[nodiscard]] Strides potential_strides() const { return {pitch_, std::ptrdiff_t(pitch_) * box_.cells.y}; }
    [[nodiscard]] glm::ivec3 place_of(std::uint32_t cell) const;
    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    static constexpr std::uint8_t k_inside = 8, k_shut = 16, k_thin = 32;
    static constexpr int k_ghost_layers = 3;
    static constexpr float k_farthest_thin = 64.0f; ///< [cells] thickness beyond which no trajectory passes a body
    static constexpr int k_least_reach = 4;         ///< [cells] with the default largest CFL number

    struct Face {
        std::uint32_t key; ///< 4 times the low cell's index, plus the axis
        float closed, wall;
        std::uint16_t body;
    };

    void draw(const PlacedObstacle& obstacle, std::uint16_t body, glm::vec3 offset);
    void merge_faces();
    void find_shut_cells();
    void collect_surface();
    void collect_ghosts();
    void find_thin_bodies();
    void collect_thin();
    [[nodiscard]] const Face* face_between(std::uint32_t cell, std::uint32_t next, int slot) const;
    [[nodiscard]] bool neighbour(glm::ivec3 cell, int axis, int side, glm::ivec3& result) const;
    [[nodiscard]] std::uint32_t potential_of(glm::ivec3 cell) const;

    Box box_;
    int pitch_;
    float thinnest_ = 0.0f;     ///< [cells] thickness of the thinnest body
    int reach_ = k_least_reach; ///< [cells] around thin bodies
    std::vector<PlacedObstacle> bodies_;
    std::vector<std::uint8_t> thin_bodies_; ///< whether each body is thin
    std::vector<Face> faces_;
    std::vector<InsideCell> inside_;
    std::vector<SurfaceCell> surface_;
    std::vector<Ghost> ghosts_;
    std::vector<GhostSource> ghost_sources_;
    std::vector<std::uint32_t> layer_ends_, thin_;
    std::vector<std::uint8_t> flags_; ///< one a cell: closed faces to the high neighbours, inside, shut
    std::vector<float> distances_;    ///< scratch: at the corners of an obstacle's cells
};

} // namespace windrow::cpu
