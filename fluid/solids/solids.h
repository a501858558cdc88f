// Obstacles in the cells of a box.
//
// A face between two cells is closed by a fraction c of its area, 1 - c is open. Face fluxes of the projection are
// (1 - c) (u_low + u_high) / 2 + c U, with the body's own velocity U across the face. The pressure's operator is
//
//   A = L - B,   (B phi)(cell) = sum over its faces of c (phi(neighbour) - phi(cell))
//
// L the 7-point Laplacian of the empty box. In rows of unequal thickness what passes a face across y is over the thickness of the
// cell's row, and a slope of the operator there over the distance between the rows. The gradient is the adjoint of the divergence: half of each open face's slope. A cell
// whose faces are all closed is shut. Faces between two shut cells count as open: they couple cells without any flow.
//
// Surface cells are those with a closed face. All work of a step runs over sorted lists of faces and cells: it is the same for
// any number of threads.
//
// Air that no open face joins to the rest is a closed room: no wind blows there. A body between a room and the other air closes
// whole faces on the room's side, since a wall cell that is open in part on both sides would join them.
//
// A body is drawn once: its closed faces and inside cells, in cells of the world's lattice. A drawing is kept while the body rests
// there, so a box that moves reads lists and computes no distance, except those of bodies that come into reach.
//
// Based on: Batty, Bertails & Bridson 2007, ACM Transactions on Graphics 26; Ng, Min & Gibou 2009, Journal of Computational Physics
// 228 (fractions of faces); Buzbee, Dorr, George & Golub 1971, SIAM Journal on Numerical Analysis 8 (a direct solver's box around an
// irregular domain).
#pragma once

#include "fluid/allocator.h"
#include "fluid/api.h"
#include "fluid/box.h"
#include "fluid/obstacle.h"
#include "fluid/parallel.h"
#include "fluid/solids/ground_tile.h"
#include "fluid/solids/tiled_ground.h"
#include "fluid/solids/together.h"
#include "fluid/solids/wholes.h"

#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <span>
#include <vector>

namespace windrow {

namespace detail {
/// Room for `count`, or for twice as many where a list has less. Lists of bodies that move vary in length: they grow once.
template <class List>
void make_room(List& list, std::size_t count) {
    if (list.capacity() < count)
        list.reserve(2 * count);
}
} // namespace detail

using detail::PlacedObstacle;

/// A closed face, between a cell and its high neighbour along an axis.
struct ClosedFace {
    std::uint32_t cell[2] = {};      ///< low and high, indices in fields
    std::uint32_t potential[2] = {}; ///< the same in the direct solve's rows
    std::uint32_t surface[2] = {};   ///< the same among the surface cells
    float closed = 0.0f;             ///< fraction
    float wall = 0.0f;               ///< [m/s] closed times the body's own velocity along the axis
    float facing[2] = {};            ///< of `closed`, what is a wall across the axis in each cell, and not a cut along it
    std::uint16_t body = 0;
    std::uint16_t place[3] = {}; ///< of the low cell, in the box
    std::uint8_t axis = 0;
    bool shut[2] = {}; ///< of the cells
    /// At an open boundary of the box: both ends are the one cell, and that beyond the boundary is shut. The velocity beyond is the
    /// cell's own, and no slope is taken off: the pressure acts through all of the face.
    [[nodiscard]] bool ends_box() const { return cell[0] == cell[1]; }
};

class Solids {
  public:
    /// A cell with a closed face.
    struct SurfaceCell {
        std::uint32_t cell = 0, potential = 0;
        float volume = 1.0f; ///< of the cell, in cubes of its size
        bool shut = false;   ///< no open face
        bool edge = false;   ///< at a boundary of the box
    };
    /// A cell whose centre is inside a body.
    struct InsideCell {
        std::uint32_t cell = 0, potential = 0;
        glm::ivec3 place{0};
        std::uint16_t body = 0;
        bool shut = false;
        std::uint32_t drawn = 0; ///< number in the body's drawing
    };
    /// A face, open in part, of a cell inside a body that is not shut. The projection pushes such a cell as if it were air, and the step
    /// then gives it the body's velocity: what it took is no force.
    struct OpenSide {
        std::uint32_t cell[2] = {};      ///< low and high
        std::uint32_t potential[2] = {}; ///< the same in the direct solve's rows
        std::uint32_t inside = 0;        ///< the one inside
        float weight = 0.0f;             ///< half of the open fraction, over the area of a cube's face
        std::uint16_t body = 0;
        std::uint8_t axis = 0;
    };
    /// Air that no opening joins to the boundary of the box: rooms, with the cells inside bodies that are open to them. Where walls
    /// change its volume no flow without divergence exists: it takes the change evenly, in all of its cells.
    struct SealedPart {
        std::uint32_t end = 0;         ///< of its cells in sealed_cells()
        std::uint32_t surface_end = 0; ///< of those with a closed face, in sealed_surface()
        float change = 0.0f;           ///< [m/s] what its walls give to the divergence of a cell, times its size: the mean
    };
    /// A cell inside a body that a cubic read from outside reaches: its value is the mean of what `count` cells nearer to the air
    /// give.
    struct Ghost {
        std::uint32_t cell = 0, first = 0, count = 0;
    };
    /// A cell beside a ghost. From the air into a body the velocity along the surface stays, and that along its normal is the
    /// body's own (shaders/numerics/slip.glsl). With the air's own velocity there, air that leaves a wall reads itself and grows without
    /// bound. With the normals of the cells' faces, air that flows along a slope loses speed at each stair. A mirror,
    /// U + (U - u) beyond the surface, takes a part of the pressure's work on a body that starts: 10 % of its added mass.
    struct GhostSource {
        std::uint32_t cell = 0;
        glm::vec3 normal{0.0f}; ///< out of the surface; 0 beyond the first layer
        float wall = 0.0f;      ///< [m/s] U n
    };

    WINDROW_INTERNAL Solids(const Box& box, int pitch);
    [[nodiscard]] const Boundaries& boundaries() const { return box_.boundaries; }

    /// Replaces all obstacles. `shift`: cells by which the box has moved since the last call.
    WINDROW_INTERNAL void place(std::span<const PlacedObstacle> obstacles, glm::ivec3 shift = glm::ivec3(0));
    [[nodiscard]] bool any() const { return !faces_.empty() || !inside_.empty(); }

    /// Sorted by low cell and axis; behind them those that end the box.
    [[nodiscard]] std::span<const ClosedFace> faces() const { return faces_; }
    [[nodiscard]] std::span<const ClosedFace> end_faces() const { return faces().subspan(first_end_); }
    [[nodiscard]] std::span<const SurfaceCell> surface() const { return surface_; }
    [[nodiscard]] std::span<const InsideCell> inside() const { return inside_; }
    [[nodiscard]] std::span<const OpenSide> open_sides() const { return open_sides_; }
    /// Ghosts by layers: those of a layer read the air and the layers before it. Three layers from the air outside of closed rooms,
    /// then three from that of the rooms, if there are any.
    [[nodiscard]] std::span<const Ghost> ghosts() const { return ghosts_; }
    [[nodiscard]] std::span<const GhostSource> ghost_sources() const { return ghost_sources_; }
    [[nodiscard]] std::span<const std::uint32_t> layer_ends() const { return layer_ends_; }
    [[nodiscard]] std::span<const PlacedObstacle> bodies() const { return bodies_; }
    /// visit(cell, place, away, body) for each cell beside or under the surface of a body, `away` [cells] from it as height_over is:
    /// those nearer than half a cell, down to k_under below it, and their neighbours.
    template <class Visit>
    void for_each_near(const Visit& visit) const;
    static constexpr float k_under = 3.5f; ///< [cells]

    /// Cells of air in closed rooms: room n ends before room_ends()[n], with its cells in order.
    [[nodiscard]] std::span<const std::uint32_t> rooms() const { return rooms_; }
    [[nodiscard]] std::span<const std::uint32_t> room_ends() const { return room_ends_; }
    [[nodiscard]] bool in_room(std::uint32_t cell) const { return layers_[cell] == k_room; }
    /// The same cells, and those inside of bodies that only the air of rooms reaches: no prescribed wind is part of their velocity.
    [[nodiscard]] std::span<const std::uint32_t> sheltered() const { return sheltered_; }
    [[nodiscard]] bool is_sheltered(std::uint32_t cell) const { return layers_[cell] > k_ghost_layers; }

    /// Part n ends before sealed_parts()[n].end, with its cells in order of its rooms. All other air of a box without an open side
    /// is sealed too, and has no list.
    [[nodiscard]] std::span<const SealedPart> sealed_parts() const { return sealed_; }
    [[nodiscard]] std::span<const std::uint32_t> sealed_cells() const { return sealed_cells_; }
    /// Numbers of surface cells.
    [[nodiscard]] std::span<const std::uint32_t> sealed_surface() const { return sealed_surface_; }
    [[nodiscard]] float other_change() const { return other_change_; }
    /// How many of them change their volume, the other air with them.
    [[nodiscard]] int squeezed() const { return squeezed_; }
    /// Bodies, grounds aside, of which each fills more than half of the box.
    [[nodiscard]] int filling() const { return filling_; }
    /// [m/s] In a cell.
    [[nodiscard]] float change_in(std::uint32_t cell) const {
        const std::uint32_t part = part_of_.empty() ? 0 : part_of_[cell];
        return (flags_[cell] & k_shut) != 0 ? 0.0f : part == 0 ? other_change_ : sealed_[part - 1].change;
    }

    /// Air cells outside of closed rooms from which a read or a trajectory may pass through a sub-grid body.
    [[nodiscard]] std::span<const std::uint32_t> thin() const { return thin_; }
    [[nodiscard]] bool any_thin() const { return thinnest_ < k_farthest_thin; }
    /// [cells] Thickness of the thinnest body.
    [[nodiscard]] float thinnest() const { return thinnest_; }
    /// [cells] By body, in the coarsest row that it is in: a read from its one side that reaches as far is on its other.
    [[nodiscard]] std::span<const float> thicknesses() const { return thicknesses_; }
    /// Makes the list of them hold for trajectories of so many cells and a cubic read.
    void reach_past_thin(float cells);

    /// Whether the face from a cell to its high neighbour along an axis is more closed than open, and whether a cell is inside.
    [[nodiscard]] bool blocked(std::uint32_t cell, int axis) const { return (flags_[cell] >> axis & 1) != 0; }
    /// Whether one of `count` cells along x has a blocked face.
    [[nodiscard]] bool any_blocked(std::uint32_t cell, int count) const {
        constexpr std::uint8_t k_blocked = 7;
        std::uint8_t any = 0;
        for (int i = 0; i < count; ++i)
            any |= flags_[cell + static_cast<std::uint32_t>(i)];
        return (any & k_blocked) != 0;
    }
    [[nodiscard]] bool inside(std::uint32_t cell) const { return (flags_[cell] & k_inside) != 0; }
    /// No obstacle is in a cell or closes a face of it.
    [[nodiscard]] bool untouched(std::uint32_t cell) const { return flags_[cell] == 0; }
    /// The body that an inside cell is in.
    [[nodiscard]] std::size_t body_in(std::uint32_t cell) const { return body_of_[cell]; }
    /// [cells] Of a cell's centre over the surface of a body: the distance, above a ground the height.
    [[nodiscard]] float height_over(std::size_t body, glm::ivec3 cell) const;
    /// The face from a cell to its high neighbour; null: open.
    [[nodiscard]] const ClosedFace* face(std::uint32_t low_cell, int axis) const {
        const std::uint32_t n = face_of_[3 * static_cast<std::size_t>(low_cell) + static_cast<std::size_t>(axis)];
        return n == k_none ? nullptr : &faces_[n];
    }

    /// Of the cells from `first` to before `end`: whether faces that are more open than closed join them, within these, to the air
    /// at a place [cells], 1 or 0. All are where the place is inside an obstacle. `joined`: one a cell of the box.
    WINDROW_INTERNAL void find_joined(glm::dvec3 place, glm::ivec3 first, glm::ivec3 end, std::span<std::uint8_t> joined) const;

    /// Whether a wall beside a cell moves across its face, and whether one moves beside the air of a room, or beside the cells inside
    /// bodies that are open to it.
    [[nodiscard]] bool beside_moving(std::uint32_t cell) const;
    [[nodiscard]] bool walls_move(std::span<const std::uint32_t> room) const;

    /// Names of the closed faces: 4 times the low cell, plus the axis; sorted, as the faces are.
    WINDROW_INTERNAL void name_faces(std::vector<std::uint32_t>& names) const;
    /// Which of the faces with the names `before`, of another placement, each face was; -1: none. `shift`: cells by which the box has
    /// moved since. Of a moving body that closes a new face none was there: the step gives the air that it meets an impulse, to which
    /// the pressure of the last step is no guide.
    WINDROW_INTERNAL void find_origins(std::span<const std::uint32_t> before, glm::ivec3 shift,
                                       std::vector<std::int32_t>& origins);

    [[nodiscard]] WINDROW_INTERNAL glm::ivec3 place_of(std::uint32_t cell) const;
    /// In the direct solve's rows.
    [[nodiscard]] WINDROW_INTERNAL std::uint32_t potential_of(glm::ivec3 cell) const;
    /// The neighbour toward the low end of an axis; false where there is none.
    [[nodiscard]] WINDROW_INTERNAL bool low_neighbour(std::uint32_t cell, int axis, std::uint32_t& low) const;
    /// Whether the box has taken in a cell, or what is beside it, as it moved by `shift`.
    [[nodiscard]] WINDROW_INTERNAL bool came_in(std::uint32_t cell, glm::ivec3 shift) const;
    /// Bodies that the last call drew whole; of others it kept all, or the columns that still held.
    [[nodiscard]] int drawn() const { return drawn_; }
    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    /// Flags of a cell beside its three blocked faces; k_low: it is the low cell of a closed face.
    static constexpr std::uint8_t k_inside = 8, k_shut = 16, k_thin = 32, k_low = 64, k_surface = 128;
    static constexpr std::uint32_t k_none = ~std::uint32_t{0};
    /// Distances below this fraction of a cell count as 0: a body along the cells' faces has these faces closed, whatever rounding
    /// does.
    static constexpr float k_touch = 1e-4f;
    /// Whether a body holds a centre, `away` [cells] from its surface: from one that only touched it, each line would be blocked.
    static constexpr bool holds(float away) { return away <= k_touch; }
    /// Closed fraction of a face that a body only touches; it stays open. A block along the cells has three such faces for each that
    /// it closes, and each costs as much.
    static constexpr float k_least_closed = 2.0f * k_touch;
    static constexpr float k_tight = 0.999f; ///< closed fraction of a face that joins nothing
    /// [cells] Thickness below which a body is tight by whole faces. Of 1.2 cells, fractions still let 7 % of a wind through.
    static constexpr float k_thin_wall = 1.5f;
    static constexpr int k_ghost_layers = 3;
    static constexpr float k_beside = 2.0f;         ///< [cells] from a surface: a cell within may have a closed face
    static constexpr std::uint8_t k_room = 255;     ///< in `layers_`: air of a closed room
    static constexpr float k_farthest_thin = 64.0f; ///< [cells] thickness beyond which no trajectory passes a body

    /// Air cells in a row of x, from `first` to before `end`, that open faces join.
    struct Run {
        std::uint32_t first, end;
        std::uint32_t root; ///< a run that it is joined to
    };

    /// [m/s], volumes in cubes of a cell's size.
    struct Change {
        double volume, through, gross;
    };

    /// The cells of one body; positions are cells of the box, of now.
    struct Drawing {
        struct Face {
            glm::ivec3 cell;
            int axis;
            float closed, wall;
        };
        /// Toward a neighbour outside of the body: 2 axis, plus 1 for the high one.
        struct Side {
            std::uint32_t direction;
            glm::vec3 normal; ///< as a GhostSource's
            float wall;
        };
        struct Inside {
            glm::ivec3 cell;
            std::uint32_t first_side, sides; ///< of the drawing's
        };
        struct Near {
            glm::ivec3 cell;
            float away; ///< [cells]
        };
        PlacedObstacle body;
        std::vector<PlacedObstacle> beside; ///< at rest: the bodies that it was drawn with, placed from its own place
        float thickness = 0.0f;             ///< [m] as thickness_of_
        Wholes::Part part;                  ///< of what it was drawn as
        bool draws = true;                  ///< false: a tile that others draw
        glm::ivec3 low{0}, high{0};         ///< cells drawn: all that the body reaches within the box and some beyond
        detail::HostVector<Face> faces;
        detail::HostVector<Inside> inside;
        detail::HostVector<Side> sides;
        detail::HostVector<Near> near;
    };

    struct Reach {
        glm::ivec3 low, high; ///< cells low <= cell < high
        [[nodiscard]] bool holds(glm::ivec3 cell) const {
            return glm::all(glm::greaterThanEqual(cell, low)) && glm::all(glm::lessThan(cell, high));
        }
        [[nodiscard]] std::size_t count() const {
            const glm::uvec3 size = glm::max(high - low, 0);
            return static_cast<std::size_t>(size.x) * size.y * size.z;
        }
        [[nodiscard]] std::size_t index(glm::ivec3 cell) const {
            const glm::ivec3 from = cell - low, size = high - low;
            return (static_cast<std::size_t>(from.z) * size.y + from.y) * size.x + from.x;
        }
        [[nodiscard]] std::size_t column(glm::ivec3 cell) const {
            return static_cast<std::size_t>((cell.z - low.z) * (high.x - low.x) + cell.x - low.x);
        }
        template <class Visit>
        void for_each(const Visit& visit) const;
    };
    struct View;
    /// Heights [cells] of an upright ground over that at the centre of a column of cells: all that its faces and neighbours meet, and
    /// the highest along the lines from its centre to the next along x and z.
    struct Column {
        float low = 0.0f, high = 0.0f;
        float crest[3] = {};
        bool ends = false;  ///< the ground may end in it or beside it: the distance of a cell is not its height
        float level = 0.0f; ///< [m] from the body's middle: of the ground at the centre
    };
    [[nodiscard]] glm::ivec3 air_cell_at(glm::dvec3 place, glm::ivec3 first, glm::ivec3 end) const;
    /// A drawing has the faces of the box's low boundaries too, which are those of the cells below; around the box it is repeated.
    [[nodiscard]] glm::ivec3 needed_beyond() const {
        return {!box_.boundaries.periodic(0), !box_.boundaries.periodic(1), !box_.boundaries.periodic(2)};
    }
    [[nodiscard]] Reach reach_of(const PlacedObstacle& obstacle, glm::ivec3 beyond) const;
    [[nodiscard]] bool is_drawing_of(const Drawing& drawing, const PlacedObstacle& obstacle) const;
    [[nodiscard]] bool still_holds(std::size_t number, bool looked_beside) const;
    void find_tiles();
    void find_tile_places();
    void find_changed_tiles();
    [[nodiscard]] bool changed_near(const PlacedObstacle& tile, const PlacedObstacle& changed, float margin) const;
    [[nodiscard]] bool any_changed_near(std::size_t number, float margin) const;
    [[nodiscard]] bool surely_precedes(const GroundTilePlace& one, const GroundTilePlace& other) const;
    [[nodiscard]] std::uint32_t kind_of(const GroundTilePlace& tile) const;
    void find_drawers(bool as_before);
    void leave_out(std::size_t number);
    void sort_by_place();
    /// Finds what a body that is no tile is drawn with: the bodies that it touches.
    void find_beside(std::size_t number);
    [[nodiscard]] static bool is_drawn_before(const PlacedObstacle& body, const PlacedObstacle& other);
    [[nodiscard]] bool is_same(const PlacedObstacle& body, const PlacedObstacle& other) const;
    [[nodiscard]] bool are_same(std::span<const PlacedObstacle> bodies, std::span<const PlacedObstacle> others) const;
    [[nodiscard]] bool stands_in(const PlacedObstacle& body, std::span<const PlacedObstacle> list) const;
    [[nodiscard]] float beside_margin() const;
    [[nodiscard]] bool is_tight(std::size_t number, float thickness) const;
    [[nodiscard]] float find_thickness(std::size_t number);
    [[nodiscard]] float thickness_together(std::size_t number, float own, float most);
    [[nodiscard]] float row_from(glm::vec3 place, glm::vec3 way) const;
    void collect_ground(std::size_t number, const View& view);
    void collect_together(std::size_t number, const View& view, std::span<const PlacedObstacle> beside);
    /// Swaps them; `before` is free then: its position is NaN.
    static void take(Drawing& drawing, Drawing& before);
    void take_room(Drawing& drawing, const PlacedObstacle& body);
    void draw(std::size_t number);
    [[nodiscard]] bool draw_rest(std::size_t number);
    void keep_columns(Drawing& drawing, const Reach& whole);
    void clear_drawn();
    void add_drawn(Drawing& drawing);
    /// `offset`: cells from the body to its image.
    void draw_image(std::size_t number, const Reach& reach, glm::ivec3 offset);
    [[nodiscard]] bool may_touch(const View& view, const Reach& reach, glm::ivec3 cell, float away, float within) const;
    [[nodiscard]] const Column* column_of(const Reach& reach, glm::ivec3 cell) const;
    [[nodiscard]] bool line_is_blocked(const View& view, const Reach& reach, glm::ivec3 cell, int axis) const;
    [[nodiscard]] float depth_at(const View& view, const Reach& reach, glm::ivec3 cell) const;
    void draw_inside(const View& view, const Reach& reach, glm::ivec3 cell, float away, bool beside);
    [[nodiscard]] bool is_anothers(std::size_t number, const View& view, glm::vec3 place) const;
    void draw_near(std::size_t number, const View& view, const Reach& reach, const Reach& drawn);
    void measure(const View& view, const Reach& reach);
    [[nodiscard]] glm::vec3 shut_by_edges(const View& view, glm::ivec3 cell, float away) const;
    [[nodiscard]] float shut_at(const View& view, const Reach& reach, glm::ivec3 cell, int axis) const;
    void measure_ground(const View& view, Reach& reach, const Reach& drawn);
    [[nodiscard]] Column column_at(const View& view, const Reach& reach, int i, int k) const;
    [[nodiscard]] static float rise_over(const View& view, const Column& column, glm::ivec3 cell, float away);
    [[nodiscard]] float away_at(const View& view, glm::vec3 place) const;
    [[nodiscard]] TiledGround::Owner owner_of(const Reach& reach, glm::ivec3 cell) const;
    void gather_faces();
    [[nodiscard]] ClosedFace& gathered(glm::ivec3 low, glm::ivec3 high, int axis, std::uint16_t body);
    [[nodiscard]] bool at_open_end(glm::ivec3 cell) const;
    [[nodiscard]] ClosedFace end_face(glm::ivec3 cell, const Drawing::Face& drawn, int end, std::uint16_t body) const;
    void close_at_open_ends();
    void sort_faces();
    void add_end_faces();
    void find_facing();
    [[nodiscard]] float closed_beyond(const ClosedFace& face, int end) const;
    [[nodiscard]] bool is_open_end(int axis, int end) const { return box_.boundaries.at(axis, end).kind == BoundaryKind::open; }
    void layer_inside(bool of_rooms);
    void find_rooms();
    void close_rooms();
    void find_sealed();
    void join_rooms();
    void find_changes(bool closed);
    void make_room_for_motion();
    void find_shut_cells();
    void open_reached_cells();
    void collect_open_sides();
    void collect_surface();
    void collect_ghosts();
    void count_thicknesses();
    void collect_thin();
    /// Of an inside cell toward a neighbour outside of its body; null where there is none.
    [[nodiscard]] const Drawing::Side* side_of(const InsideCell& cell, int direction) const;
    [[nodiscard]] bool neighbour(glm::ivec3 cell, int axis, int side, glm::ivec3& result) const;
    [[nodiscard]] std::uint32_t index(glm::ivec3 cell) const;
    /// visit(cell, place) for each cell with one of the flags, in order.
    template <class Visit>
    void for_each_flagged(std::uint8_t flags, const Visit& visit) const;
    /// visit(neighbour, axis, low cell of the face between) for each neighbour of a cell.
    template <class Visit>
    void for_each_neighbour(const InsideCell& cell, const Visit& visit) const;

    Box box_;
    int pitch_;
    int drawn_ = 0;
    int squeezed_ = 0, filling_ = 0;
    float other_change_ = 0.0f;
    float thinnest_ = k_farthest_thin; ///< [cells] thickness of the thinnest body
    int reach_ = 3;                    ///< [cells] from a cell to the farthest that its read may take
    std::vector<PlacedObstacle> bodies_;
    std::vector<Drawing> drawings_, drawings_before_; ///< one a body, in their order; those behind keep their room
    std::vector<float> thicknesses_;                  ///< [cells] of each body
    std::vector<std::uint8_t> closes_new_;            ///< scratch of find_origins: whether each body does
    detail::HostVector<ClosedFace> faces_;
    detail::HostVector<SurfaceCell> surface_;
    detail::HostVector<InsideCell> inside_;
    detail::HostVector<OpenSide> open_sides_;
    detail::HostVector<Ghost> ghosts_;
    detail::HostVector<GhostSource> ghost_sources_;
    detail::HostVector<std::uint32_t> layer_ends_, thin_, rooms_, room_ends_, sheltered_;
    detail::HostVector<InsideCell> layered_;                  ///< the ghosts' cells
    detail::HostVector<Run> runs_;                            ///< scratch
    detail::HostVector<std::uint32_t> row_runs_, part_sizes_; ///< scratch: first run of each row; cells of each part of the air
    detail::HostVector<SealedPart> sealed_;
    detail::HostVector<std::uint32_t> sealed_cells_, sealed_surface_;
    detail::HostVector<std::uint32_t> part_of_; ///< one a cell: 0 other air, else 1 + number of a part; empty until a room is
    detail::HostVector<std::uint32_t> nodes_, node_parts_; ///< scratch of join_rooms
    detail::HostVector<std::uint32_t> unreached_;          ///< scratch of find_shut_cells
    detail::HostVector<Change> changes_;                   ///< scratch of find_changes: of the other air, then of the parts
    detail::HostVector<ClosedFace> unsorted_, ends_;       ///< gathered: faces between cells, and at open boundaries
    detail::HostVector<glm::vec2> largest_parts_; ///< scratch of gather_faces: closed by one body, and its speed times that
    std::size_t first_end_ = 0;
    detail::HostVector<glm::ivec3> at_open_ends_;      ///< scratch: inside cells
    detail::HostVector<Drawing::Face> drawn_faces_;    ///< scratch of draw
    detail::HostVector<Drawing::Inside> drawn_inside_; ///< scratch of draw
    detail::HostVector<Drawing::Side> drawn_sides_;    ///< scratch of draw
    detail::HostVector<Drawing::Near> drawn_near_;     ///< scratch of draw
    detail::HostVector<std::uint8_t> flags_;           ///< one a cell
    detail::HostVector<std::uint16_t> body_of_;        ///< one a cell: body that an inside cell is in
    detail::HostVector<std::uint32_t> drawn_of_;       ///< one a cell: number of an inside cell in that body's drawing
    detail::HostVector<std::uint32_t> surface_of_;     ///< one a cell: number of a surface cell
    detail::HostVector<std::uint8_t> layers_;          ///< one a cell: layer of a ghost, or k_room
    detail::HostVector<std::uint32_t> face_of_;        ///< three a cell: face to the high neighbour
    /// Scratch [cells]: at the corners of a body's cells, there of what it has in common with what is drawn before it, at their centres.
    detail::HostVector<float> distances_, before_, depths_;
    detail::HostVector<glm::vec3> shut_; ///< scratch: how far a cell is, for edges along each axis
    detail::HostVector<Column> columns_; ///< scratch: of an upright ground; empty for all else
    std::vector<GroundTile> tiles_;
    static constexpr int k_beyond = 8; ///< [cells] drawn beyond the box, so that not every shift draws a large body again
    static constexpr float k_unknown = -1.0f;
    static constexpr float k_farthest_row = 16.0f; ///< [cells] what is as thick counts as thicker than any read is long
    static constexpr std::size_t k_no_ground = ~std::size_t{0}, k_all_tiles = k_no_ground - 1;
    std::vector<GroundTilePlace> tile_places_;                    ///< of all images
    PlaneBuckets tiles_at_;                                       ///< the same by place
    std::vector<PlacedObstacle> changed_tiles_;                   ///< scratch of place
    bool tiles_are_drawn_ = true;                                 ///< else memory ended in the last placement
    std::vector<std::uint8_t> draws_;                             ///< whether each tile does
    std::vector<ColumnTiles> owned_;                              ///< scratch: of columns
    bool crowded_ = false;                                        ///< more tiles are beside one than are looked at for each
    Wholes wholes_;                                               ///< that the bodies are parts of
    Together together_;                                           ///< scratch: a body with those that it touches
    std::vector<detail::Extent> extents_;                         ///< scratch [m]: of each body, or of the whole that it is in
    std::vector<std::uint32_t> by_place_, wide_;                  ///< scratch: bodies along x; those too wide for that
    std::vector<float> thickness_of_;                             ///< [m] of each body; of a tile with those that it touches
    std::size_t resting_ = 0;                                     ///< bodies at rest at the last placement
    std::vector<std::pair<PlacedObstacle, std::uint32_t>> kinds_; ///< scratch: tiles, anywhere, to be sorted
    std::vector<std::uint32_t> tile_of_;                          ///< of a body; k_none: it is none
    TiledGround ground_, other_ground_;                      ///< scratch: of an upright ground; empty for all else; one to swap
    std::pair<std::size_t, glm::vec3> ground_of_, other_of_; ///< the body, and where its image is, that it was collected for
    std::vector<TiledGround::Level> levels_, corner_levels_; ///< scratch: of the columns' centres and corners
    std::vector<TiledGround::Owner> owners_;                 ///< scratch: of the columns
    std::vector<PlacedObstacle> beside_;                     ///< scratch of place
    std::vector<std::uint8_t> kept_, lacks_; ///< scratch: whether a body has its last drawing; whether a column is to be drawn
};

template <class Visit>
void Solids::for_each_near(const Visit& visit) const {
    for (std::size_t body = 0; body < bodies_.size(); ++body)
        for (const Drawing::Near& near : drawings_[body].near)
            if (glm::all(glm::greaterThanEqual(near.cell, glm::ivec3(0))) && glm::all(glm::lessThan(near.cell, box_.cells)))
                visit(static_cast<std::uint32_t>(box_.index(near.cell.x, near.cell.y, near.cell.z)), near.cell, near.away, body);
}

} // namespace windrow
