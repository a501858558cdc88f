// What a reader finds beside surfaces: cells as they are shown, in frames, views and textures. The air's own cells stay as they are.
//
// A cell inside a body holds the body's velocity, and one that its surface cuts holds little air: a read between such a cell and the
// next would depend on where the surface cuts the grid. So a cell nearer to a surface than half of its thickness, and those down to
// two and a half cells below it, are filled: they take the air along the normal, the upwind solution of grad u . grad d = 0,
//
//   u = sum w_a u_a / sum w_a,   w_a = (d_a - d) / (distance to a)^2      a: the neighbour along an axis that is farther out
//
// d [cells] the distance from the surface, over a ground the height. A cell outside takes nothing across a face that is more closed
// than open. Then the part along the normal n = grad d becomes the body's own, and air that sticks goes through the surface linearly
// (shaders/numerics/slip.glsl). Chains of such cells are sums of air alone, in no order: one pass for any number of threads. Between
// the links of a chain nothing is projected; measured, that changes ridges, hills and roofs by nothing and balls by 4 % for the better.
//
// Over rough surfaces cells also show the law of the wall (shaders/numerics/wall_law.glsl), by the height over what is below in the
// column: the floor, a ground, a top. Beside a wall no law acts.
//
// A column with plants has the profile that they make: no law acts there.
//
// Based on: Aslam 2004, Journal of Computational Physics 193 (extrapolation along normals); the law: wall_law.glsl.
#pragma once

#include "fluid/allocator.h"
#include "fluid/api.h"
#include "fluid/box.h"
#include "fluid/drag_field.h"
#include "fluid/parallel.h"
#include "fluid/solids/solids.h"
#include "fluid/view.h"
#include "fluid/window.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace windrow {

struct Config;

/// The law that acts over the surfaces of a wind; none where its ground is smooth, and where a canopy has a profile of its own.
[[nodiscard]] WINDROW_INTERNAL WallLaw wall_law(const Config& config, const Box& box);

class WINDROW_INTERNAL SurfaceReading {
  public:
    /// A cell that a filled one takes air from. Weights sum to 1.
    struct Term {
        std::uint32_t cell = 0;
        float weight = 0.0f;
        float raised = 0.0f; ///< the weight over the law's share at that cell
    };
    /// The surface beside a filled cell.
    struct Wall {
        glm::vec3 normal{0.0f};
        float across = 0.0f; ///< [m/s] the body's own velocity along it
        glm::vec3 own{0.0f}; ///< [m/s] that velocity, of a surface to which the air sticks; else 0
        float keep = 1.0f;   ///< shaders/numerics/slip.glsl
    };
    /// A cell that is not shown as its row is: filled where `count` is not 0.
    struct Cell {
        std::uint32_t cell = 0;
        std::uint32_t first = 0, count = 0; ///< terms
        std::uint32_t wall = 0;             ///< of a filled cell
        float height = 0.0f;                ///< wall_law.glsl
        float raise = 1.0f;                 ///< one over the law's share there
    };
    /// All other cells of a row.
    struct Row {
        float height = 0.0f, raise = 1.0f;
    };

    [[nodiscard]] const WallLaw& law() const { return law_; }
    [[nodiscard]] std::span<const Cell> cells() const { return cells_; } ///< in order
    [[nodiscard]] std::span<const Term> terms() const { return terms_; }
    [[nodiscard]] std::span<const Wall> walls() const { return walls_; }
    [[nodiscard]] std::span<const Row> rows() const { return rows_; } ///< empty without a law
    /// No cell is shown otherwise than it is.
    [[nodiscard]] bool empty() const { return cells_.empty() && rows_.empty(); }

    /// Part of the box: cell c of the part is c + `low` of the box. `rows_low`: row that the part's lowest is, of the box over its
    /// floor: another one where the box has moved since the reading was made.
    struct Part {
        glm::ivec3 cells{0}, low{0};
        int rows_low = 0;
    };
    /// Writes the cells of a part as shown. `shown` may not be `air`.
    void show(std::span<const glm::vec4> air, const Part& part, std::span<glm::vec4> shown,
              const ParallelFor& parallel_for) const;
    /// As for textures that hold no height: filled, without the law. visit(cell of the part, velocity) for each filled one.
    template <class Visit>
    void for_each_filled(std::span<const glm::vec4> air, const Part& part, const Visit& visit) const;

    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    friend class ReadingMaker;
    void clear();
    [[nodiscard]] std::optional<std::uint32_t> index_in(const Part& part, std::uint32_t cell) const;
    [[nodiscard]] bool is_whole(const Part& part) const { return part.cells == size_ && part.low == glm::ivec3(0); }
    [[nodiscard]] glm::vec3 over_wall(const Cell& cell, glm::vec3 sum, bool raised) const;
    [[nodiscard]] glm::vec3 filled(const Cell& cell, std::span<const glm::vec4> air, const Part& part, bool raised) const;
    [[nodiscard]] glm::vec3 filled(const Cell& cell, const float* air) const;

    glm::ivec3 size_{0}; ///< of the box
    WallLaw law_;
    detail::HostVector<Cell> cells_;
    detail::HostVector<Term> terms_;
    detail::HostVector<Wall> walls_;
    detail::HostVector<Row> rows_;
};

template <class Visit>
void SurfaceReading::for_each_filled(std::span<const glm::vec4> air, const Part& part, const Visit& visit) const {
    for (const Cell& cell : cells_)
        if (cell.count > 0)
            if (const auto at = index_in(part, cell.cell))
                visit(*at, filled(cell, air, part, false));
}

/// Makes readings of one box, with scratch that it keeps.
class WINDROW_INTERNAL ReadingMaker {
  public:
    ReadingMaker(const Box& box, const Config& config);
    ~ReadingMaker();
    /// `solids` may be null: none. `drag`: in the same window. Null where every cell is shown as it is. A reading that nobody holds any more gives its room to a
    /// new one. Throws std::bad_alloc.
    [[nodiscard]] std::shared_ptr<const SurfaceReading> make(const Solids* solids, const Boundaries& boundaries,
                                                             const Window& window, const DragCells& drag);
    [[nodiscard]] const WallLaw& law() const { return law_; }
    /// Of the box's place: lengths of the ground differ by it.
    [[nodiscard]] bool depends_on_place() const;
    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    static constexpr std::uint32_t k_none = ~std::uint32_t{0};
    /// A cell beside or below a surface.
    struct Near {
        std::uint32_t cell;
        glm::ivec3 place;
        float away; ///< [cells] least of all bodies
        std::size_t body;
        glm::vec3 normal{0.0f};
        std::uint32_t first = 0, count = 0, wall = 0; ///< as SurfaceReading::Cell
        bool done = false;                            ///< visited
    };
    /// Air farther out beside a near cell.
    struct Source {
        std::uint32_t cell;
        float weight, away;
        float rise; ///< [m] over the near cell
    };

    void collect(const Solids& solids);
    [[nodiscard]] std::uint32_t neighbour(const Near& near, int axis, int side) const;
    [[nodiscard]] float apart(int row, int axis, int side) const;
    void find_normal(Near& near) const;
    [[nodiscard]] int find_sources(const Solids& solids, const Near& near, Source (&sources)[6]) const;
    void visit(const Solids& solids, std::uint32_t number, SurfaceReading& reading);
    void fill(const Solids& solids, Near& near, std::span<const Source> sources, SurfaceReading& reading);
    void find_heights(const Solids* solids, const Window& window, const DragCells& drag, const SurfaceReading& reading);
    void lift_plants(const DragCells& drag);
    void find_column(const Solids& solids, int i, int k, float per_height);
    void extend_height(const Solids& solids, const Near& near, std::span<const Source> sources);
    [[nodiscard]] float per_height_at(int i, int k) const;
    void write_cells(SurfaceReading& reading);
    [[nodiscard]] float raise_of(float height) const;
    [[nodiscard]] float kept(float height, float per_height) const;
    [[nodiscard]] float height_of(const SurfaceReading& reading, std::uint32_t cell) const;
    [[nodiscard]] glm::vec3 velocity_of(const PlacedObstacle& body, glm::vec3 place) const;

    Box box_;
    const Config& config_;
    WallLaw law_;
    std::vector<std::shared_ptr<SurfaceReading>> made_;
    std::vector<Near> near_;
    std::vector<std::uint32_t> near_of_; ///< one a cell: in near_, or k_none
    std::vector<float> heights_;         ///< one a cell, of wall_law.glsl; with a law, and with obstacles or lengths by place
    std::vector<float> per_heights_;     ///< one a column: of wall_law.glsl over heights; empty: 1
};

} // namespace windrow
