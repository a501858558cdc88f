// The hot loops as a table of function pointers, one table per SIMD level.
//
// The same source (level.inl and its includes) is compiled once per level and selected at run time. Everything here is plain
// data: a level's file is compiled for instructions that the machine may lack, so it must not emit inline functions of the
// standard library or GLM that the linker could also use in the rest of the program.
//
// A velocity is four floats a cell (x, y, z, 0). "Planes" are planes of constant k, the unit of work for threads.
#pragma once

#include "fluid/grid/halo.h"
#include "fluid/simd.h"

#include <cstddef>
#include <cstdint>

namespace windrow::cpu {

/// Lanes of the blocks that the direct solve works in: one AVX-512 register, two of AVX2, four of SSE.
inline constexpr int k_lanes = 16;

/// Most cells of a row, as k_max_axis_cells of fluid/box.h, which a level's file must not include.
inline constexpr int k_max_row = 2048;

/// Gathers `carried - s q` and `(1 + a) u - a u_old` into padded fields.
struct PadTask {
    int cells[3];
    const HaloRule* rules[3]; ///< rules[axis][padded index], padded index = cell + k_halo_low
    const float* carried;
    const float* history; ///< null: none
    float history_scale;
    float relaxation; ///< 1: none
    float ambient[4];
    const float* ambient_cells;       ///< four floats a padded cell, for `carried`; null: `ambient` everywhere
    const float* trace_ambient_cells; ///< the same for the trace
    const float* velocity;
    const float* velocity_old; ///< null: none
    float extrapolation;
    const float* row_scales; ///< of the trace's y, by row; null: 1
    float* padded_carried;
    float* padded_trace; ///< null: the trace reads padded_carried
};

/// Range of reads, in cells from the first centre; w unused. Periods are 0 where the axis is not periodic.
struct Legal {
    float low[4], high[4];
    float period[4], inverse_period[4];
};

/// The prescribed background wind A, for the term v . grad A of the perturbation v. Fields of four floats a padded cell.
struct PrescribedWind {
    const float* now;         ///< at the step's start; null: none
    const float* next;        ///< at its end
    const float* source_flow; ///< part of the perturbation, four floats a cell; null: none
    float gusts_squared;      ///< [m2/s2] square of the gusts' strength
    float still_squared;      ///< [m2/s2] square of a perturbation that counts as none
    Legal legal;
    const float* bends; ///< second differences of the profile, one a padded row; null: no profile
    float mean[4];      ///< [m/s] that the profile scales
};

/// Semi-Lagrangian advection of a padded field.
struct AdvectTask {
    int cells[3];
    const float* velocity; ///< at the start, one value a cell
    const float* padded_trace;
    const float* padded_carried; ///< four floats a cell, or one for scalars
    float* result;
    float cells_per_speed; ///< dt / h
    /// By row: cell size over its thickness, which makes rows of what moves along y. Null: 1. The padded trace holds it already.
    const float* row_scales;
    Legal legal;
    PrescribedWind prescribed;
    bool clamped; ///< scalars only
};

struct DivergenceTask {
    int cells[3];
    int pitch; ///< floats from row to row of `result`
    const float* velocity;
    NormalGhost ghosts[3][2];
    float scale;             ///< result = scale * (sum of central differences over two cells)
    const float* row_scales; ///< by row: factor on the difference along y; null: 1
    float* result;
};

struct GradientTask {
    int cells[3];
    int pitch;
    const float* potential;
    NormalGhost ghosts[3][2];
    float scale;
    const float* row_scales; ///< by row: factor on the difference along y; null: 1
    float* velocity;         ///< velocity -= slope, slope = scale * differences
    float* gradient;         ///< = weight * slope + kept * gradient; null: not wanted
    float weight = 1.0f, kept = 0.0f;
};

struct DiffuseTask {
    int cells[3];
    const HaloRule* rules[3];
    float ambient[4];
    const float* field;
    float ratio;             ///< r = viscosity dt / h^2
    const float* row_scales; ///< by row: cell size over its thickness; null: 1
    const float* links;      ///< by face: cell size over the distance between rows
    float* result;
};

/// Turbulent stress in columns (fluid/solids/surface_layer.h).
struct StressTask {
    int cells[3];
    const float* velocity; ///< u at the start
    const float* carried;  ///< the part of it that is solved for
    float* result;         ///< may be `carried`
    const float* faces;
    const float* wind; ///< A, four floats a padded cell; null: `ambient`
    float ambient[4];
    bool prescribed;          ///< A is not part of `carried`, which is 0 beyond the box
    const float* wind_mixing; ///< one a row of faces; null: as the air's
    const float* wind_drag;   ///< one a row of cells
    float cells_per_speed;    ///< dt / h
    const float* row_scales;  ///< by row: cell size over its thickness; null: 1
    bool lee;                 ///< the fourth components of `velocity` shorten the mixing length (shaders/numerics/lee.glsl)
};

/// Half of a step's drag on some cells of a row, where nothing else acts (fluid/cpu/acting.h).
struct DragTask {
    int count;
    const float* deposits; ///< [1/m] of each cell; null: none
    float canopy;          ///< [1/m] of all
    float half;            ///< [s] dt / 2
    const float* wind;     ///< four floats a cell: all of it at departure, the prescribed part at arrival; null: 0
    /// In place of `wind` at departure: air that relaxes to `rest`, of which `left` is left; 1: it does not.
    const float* carried = nullptr;
    float left = 1.0f;
    const float* rest = nullptr;
    float scale = 0.0f; ///< of the history, 1 / s at departure, s at arrival
    float* history = nullptr;
    float* kept = nullptr; ///< the history as it was
    float* arrived = nullptr;
};

/// The lee of plants in a row (shaders/numerics/lee.glsl).
struct LeeTask {
    int count;
    const float* velocity; ///< four floats a cell, the lee as the fourth
    const float* above;
    const float* below;    ///< null: air at rest
    float time_per_height; ///< [s/m] a step over the distance of these
    const float* deposits; ///< as of DragTask
    float canopy, dt;
    float* carried; ///< takes the lee after the step
};

/// Figures of one plane, or of a part of it.
struct PlaneSurvey {
    float largest_component;      ///< of the finite cells
    std::int64_t nonfinite_cells; ///< cells with NaN or infinity
    double squares;               ///< sum of |u|^2 of the finite cells
    double divergence_squares;    ///< 0 where not requested
};
inline void add(const PlaneSurvey& part, PlaneSurvey& whole) {
    whole.largest_component = part.largest_component > whole.largest_component ? part.largest_component : whole.largest_component;
    whole.nonfinite_cells += part.nonfinite_cells;
    whole.squares += part.squares;
    whole.divergence_squares += part.divergence_squares;
}

/// Matrix product C[rows x columns] = A[rows x depth] B[depth x columns], row-major with strides in floats; columns a multiple of
/// k_lanes.
struct Product {
    const float* a;
    std::ptrdiff_t a_stride;
    const float* b;
    std::ptrdiff_t b_stride;
    float* c;
    std::ptrdiff_t c_stride;
    int rows, columns, depth;
};

/// Even-odd split of an axis: `pairs` sums, the unpaired values, and `pairs` differences. Input and output do not overlap.
struct Fold {
    int count, pairs;
};

/// Tridiagonal systems of one block: for each mode m and lane, x[j-1] + b[j] x[j] + x[j+1] = d[j] in place, j = 0..rows-1.
struct TridiagonalTask {
    float* data; ///< [modes][rows][k_lanes], modes `stride` floats apart
    std::ptrdiff_t stride;
    const float* pivots;         ///< [modes][rows][k_lanes]: 1 / (b[j] - pivot[j-1])
    const float* cyclic;         ///< null, or the same shape: Sherman-Morrison vector of the periodic system
    const float* cyclic_factors; ///< [modes][2][k_lanes]: factors on the first and the last row
    int modes, rows;
    const float* scale_in;  ///< null, or one a row: factor on d
    const float* scale_out; ///< null, or one a row: factor on x
};

/// Length of what repeats, in two parts: `high` has its first 26 binary digits.
struct Period {
    double whole, high, low;
};

/// One axis of the gust tile in the world: from `origin` [m] on, moved by `phase` [m], texels of `texel` [m], repeated `repeats`
/// times in its own period.
struct TileAxis {
    double origin, phase, texel, repeats;
    Period period; ///< [m]
    Period texels; ///< of the tile, a power of two
};
inline constexpr int k_tile_side = 128, k_tile_height = 16; ///< as GustTile, which a level's file must not include

/// The ambient wind at points. The part of it that is off is 0.
struct AmbientTask {
    float mean[4];
    float roughness_length, reference_height; ///< [m]; roughness 0: no profile
    float gust_strength;                      ///< [m/s] 0: no gusts
    float gust_axes[4];
    const float* tile;              ///< four floats a texel
    double ground, lowest, highest; ///< [m] world; heights over the ground are kept between the last two
    TileAxis gusts[3];              ///< set where there are gusts
};

/// What a plant feels of a wind.
struct FeltTask {
    float strength, limit;
    float detail_amount; ///< 0: none
    float longest;       ///< longest vector of the tile
    const float* tile;
    TileAxis detail[3]; ///< set where there is detail
};

/// One axis of a box at points. Kinds of boundaries are numbers as in shaders/numerics/window.glsl.
struct PointAxis {
    int cells;
    float low_kind, high_kind;
    float reach;     ///< [cells] of the blend zone; 0: none
    float per_width; ///< [1/cells] one over its width
    double origin;   ///< [cells] of the low corner, in the world
    double point;    ///< [cells] of the blend zone's centre, in the world
    Period period;   ///< [cells] where the axis is periodic
};

/// The wind of a box at points.
struct PointTask {
    PointAxis axis[3];
    double per_cell;           ///< [1/m] one over the cell size
    const double* row_heights; ///< [m] over the low corner, of row -1 first; null: all rows are cell_size thick
    int rows;
    double bottom; ///< [m] of the low corner in the world; where it has rows, or a law of the wall acts
    double top;    ///< [m] of the box over that; where it has rows
    float wall_per_length, wall_per_log, wall_lowest, wall_fall; ///< shaders/numerics/wall_law.glsl; wall_per_log 0: none acts
    const float* field;                                          ///< four floats a cell
    AmbientTask ambient;
};

/// A point among the cells.
struct PointPlace {
    int low[3], high[3];
    float between[3];
    float share;      ///< of the box's wind; 0: the cells do not count
    float ambient[4]; ///< set where the share is not 1
};

struct Kernels {
    const char* name;
    void (*pad_plane)(const PadTask&, int padded_plane);
    void (*advect_plane[3])(const AdvectTask&, int plane);        ///< by Interpolation
    void (*advect_scalar_plane[3])(const AdvectTask&, int plane); ///< by Interpolation
    void (*divergence_plane)(const DivergenceTask&, int plane);
    /// Sum over some rows of (divergence - wanted)^2; `wanted` one float a cell, null for 0. task.result is not touched.
    double (*divergence_squares)(const DivergenceTask&, const float* wanted, int plane, int first_row, int last_row);
    void (*gradient_plane)(const GradientTask&, int plane);
    void (*diffuse_plane)(const DiffuseTask&, int plane);
    void (*stress_plane)(const StressTask&, int plane);
    void (*deepen_lee)(const LeeTask&);
    /// The change at departure goes into the history, and the history is kept.
    void (*drag_departs)(const DragTask&);
    /// The history is as it was again, and what arrived is slowed; fourth components stay.
    void (*drag_arrives)(const DragTask&);
    void (*multiply)(const Product&);
    void (*tridiagonal)(const TridiagonalTask&);
    void (*fold_lines)(const Fold&, const float* lines, std::ptrdiff_t stride, float* folded);
    void (*unfold_lines)(const Fold&, const float* folded, float* lines, std::ptrdiff_t stride);
    void (*fold_row)(const Fold&, const float* row, int odd_offset, float* folded);
    void (*unfold_row)(const Fold&, const float* folded, int odd_offset, float* row);
    PlaneSurvey (*survey)(const float* velocity, std::size_t cells);
    /// Points are three doubles each. Velocities are written `stride` floats apart, three or four each. All levels give the same
    /// bits here, and a point the same in any list.
    void (*sample_points)(const PointTask&, const double* points, std::size_t count, int stride, float* velocities);
    void (*sample_ambient)(const AmbientTask&, const double* points, std::size_t count, int stride, float* velocities);
    /// Of the velocities given, in place.
    void (*feel)(const FeltTask&, const double* points, std::size_t count, int stride, float* velocities);
    void (*place_point)(const PointTask&, const double* point, PointPlace&);
    /// The wind at a place whose eight cells are given, x fastest, four floats each.
    void (*blend_corners)(const float* corners, const PointPlace&, float* velocity);
    /// Halves as to_half of fluid/textures.h makes them, of four floats a cell: x, y, z, 0, or one component.
    void (*halve_vectors)(const float* cells, std::size_t count, std::uint16_t* halves);
    void (*halve_axis)(const float* cells, std::size_t count, int axis, std::uint16_t* halves);
};

/// Null where this machine does not run the level.
[[nodiscard]] const Kernels* kernels_for(Simd level);
/// Those of the best level: for what gives the same bits at all levels.
[[nodiscard]] inline const Kernels& best_kernels() {
    return *kernels_for(Simd::best);
}

namespace baseline {
extern const Kernels k_kernels;
}
#if defined(WINDROW_X86_LEVELS)
namespace avx2 {
extern const Kernels k_kernels;
}
namespace avx512 {
extern const Kernels k_kernels;
}
#endif

} // namespace windrow::cpu
