// The operators of a step (advection, diffusion, projection) on the caller's own fields.
//
// `Wind::step` advects and diffuses by these functions, and projects by the solver of `project`, beginning from the pressure of
// its last step. Motors, the speed limit, plants, rough ground and relaxation are its own. Others reuse them: a scalar for smoke
// or seeds carried by the same wind, a projection of their own field. Fields are laid out as in box.h. A velocity is a glm::vec4
// per cell, xyz in m/s and w = 0 (one aligned load reads a whole cell).
//
//     auto work = windrow::Workspace::create({.box = {.cells = {64, 64, 1}, .cell_size = 0.1f}});
//     windrow::project(*work, velocity);
#pragma once

#include "api.h"
#include "box.h"
#include "obstacle.h"
#include "owned.h"
#include "parallel.h"
#include "result.h"
#include "simd.h"

#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>

namespace windrow {

class Solids;

/// Tables and scratch for one box. Move-only; holds no field. Calls with the same workspace must not overlap in time.
class WINDROW_API Workspace {
  public:
    struct Settings {
        Box box{};
        /// [m/s] The wind beyond open boundaries. Components along axes that a wall closes are dropped.
        glm::vec3 ambient{0.0f};
        /// Instructions of the hot loops. Default the best that this machine runs.
        Simd simd = Simd::best;
        /// Threads of the host; default serial.
        ParallelFor parallel_for{};
    };

    [[nodiscard]] static Result<Workspace> create(const Settings& settings);

    /// Changes kinds or wall velocities; rebuilds the tables (and allocates) only when a kind changed. Without memory it fails
    /// and the workspace stays as it was.
    [[nodiscard]] Result<void> set_boundaries(const Boundaries& boundaries);
    void set_ambient(glm::vec3 ambient);
    /// Replaces the obstacles that every operator sees; at most 65,535. Without memory it fails and the workspace stays as it was.
    [[nodiscard]] Result<void> set_obstacles(std::span<const PlacedObstacle> obstacles);
    /// [m^4/s] Pressure force on an obstacle (its number in `set_obstacles`) times the length of the step, over the air's density:
    /// the momentum that the last projection took from the air and gave to it.
    [[nodiscard]] glm::vec3 impulse_on(std::size_t obstacle) const;

    [[nodiscard]] const Box& box() const;
    [[nodiscard]] glm::vec3 ambient() const;
    /// The obstacles as cells and faces (fluid/solids/solids.h); null: none.
    [[nodiscard]] const Solids* solids() const;
    /// Bytes that this workspace has allocated.
    [[nodiscard]] std::size_t memory_bytes() const;

    Workspace(Workspace&&) noexcept;
    Workspace& operator=(Workspace&&) noexcept;
    ~Workspace();

    struct State; // fluid/cpu/workspace.h
    [[nodiscard]] State& state() { return *state_; }
    [[nodiscard]] const State& state() const { return *state_; }

  private:
    explicit Workspace(std::unique_ptr<State> state);
    detail::Owned<State> state_;
};

enum class Interpolation : std::uint8_t {
    linear, ///< Trilinear, 2x2x2: never overshoots, damps short waves by sqrt(1 - 4 a (1 - a) sin^2(kh/2)) a step and axis.
    cubic,  ///< Lagrange, 4x4x4: third order, overshoots by at most 1.25 an axis. The default.
    /// Of those 64 cells 32: LLL + BLL + LBL + LLB, where L is linear along an axis and B is what the cubic adds to it. Third order along
    /// each axis, prefers none, and no wave grows. Errors of flows are 1.00 to 1.05 of the cubic's. Takes less time where a processor has
    /// no AVX-512; on a device it reads half as much, which is not measured on a GPU.
    cubic_32,
};

template <>
inline constexpr std::array<const char*, 3> k_words<Interpolation>{"linear", "cubic", "cubic_32"};

/// Fields of `advect`: the one to move and the wind that moves it. All spans have one value per cell.
struct Transport {
    /// [m/s] The velocity to move; beyond open boundaries it is the ambient wind.
    std::span<const glm::vec4> carried{};
    /// [m/s] Wind at the start of the step.
    std::span<const glm::vec4> velocity{};
    /// [m/s] Wind one step earlier; empty: the wind is taken as steady over the step (second order in a steady wind).
    std::span<const glm::vec4> velocity_old{};
    /// dt / previous dt, 2 at most: how far `velocity_old` is extrapolated. 0 where velocity_old is empty.
    float extrapolation = 1.0f;
    /// [s] Step, >= 0.
    float dt = 0.0f;
    Interpolation interpolation = Interpolation::cubic;

    /// [m/s] Second-order history (see numerics in step.cpp): `history_scale * history` is subtracted from `carried` as it is
    /// read. Empty: none.
    std::span<const glm::vec4> history{};
    float history_scale = 0.0f;
    /// Factor on carried - ambient as it is read, 1 / (1 + dt / relaxation time); 1: none.
    float relaxation = 1.0f;
};

/// result(x) = carried(xd), xd = x - dt/2 (u(x) + (1 + a) u(x0) - a u_old(x0)), x0 = x - dt u(x)   (SETTLS).
/// Second order in the trajectory, third in space with cubic weights. `result` may be any span but `velocity`; it may be
/// `velocity_old`. Based on: Hortal 2002, ECMWF Technical Memorandum 292; Staniforth & Cote 1991, Monthly Weather Review 119.
WINDROW_API void advect(Workspace& work, const Transport& transport, std::span<glm::vec4> result);

/// A scalar on the same wind: smoke, seeds, a tracer.
struct ScalarTransport {
    std::span<const float> carried{};
    std::span<const glm::vec4> velocity{}; ///< [m/s]
    float dt = 0.0f;                       ///< [s]
    Interpolation interpolation = Interpolation::cubic;
    /// Value beyond open boundaries; walls mirror the scalar.
    float outside = 0.0f;
    /// Keeps each result within the eight values around its departure point: no overshoot, order 2.6 instead of 3.
    bool clamped = false;
};
/// Allocates once, at the first call; an error, with `result` untouched, where memory is missing.
WINDROW_API Result<void> advect(Workspace& work, const ScalarTransport& transport, std::span<float> result);

/// Method of diffusion for a viscosity, by r = viscosity * dt / h^2.
enum class DiffusionMethod : std::uint8_t {
    none,     ///< r < 1e-4: less than round-off of the advection; nothing is done.
    one_pass, ///< r <= 1/12: u + r L u, factor 1 - 4 r sum sin^2(kh/2) a mode.
    implicit, ///< above: backward Euler solved directly, factor 1 / (1 + 4 r sum sin^2(kh/2)); stable for any r.
};
template <>
inline constexpr std::array<const char*, 3> k_words<DiffusionMethod>{"none", "one_pass", "implicit"};
[[nodiscard]] WINDROW_API DiffusionMethod diffusion_method(float viscosity, float dt, float cell_size);

/// result = field after dt of diffusion with `viscosity` [m^2/s], boundaries as in boundaries.h. First order in time, second in
/// space. `result` must not overlap `field`; with DiffusionMethod::none it is a copy. Allocates once at the first
/// implicit call (see reserve_diffusion); an error, with `result` untouched, where memory is missing.
WINDROW_API Result<DiffusionMethod> diffuse(Workspace& work, std::span<const glm::vec4> field, float viscosity, float dt,
                                            std::span<glm::vec4> result);
/// Allocates the memory of implicit diffusion, so that no later call allocates.
[[nodiscard]] WINDROW_API Result<void> reserve_diffusion(Workspace& work);

/// [1/s] Central divergence at cell centres, as the projection sees it. Beyond a wall the normal velocity turns its sign; beyond an
/// open boundary it is that of the cell inside. A face that an obstacle closes passes what the obstacle's own motion does; cells
/// inside have 0.
WINDROW_API void divergence(Workspace& work, std::span<const glm::vec4> velocity, std::span<float> result);

/// Solves L phi = rhs in place, L the 7-point Laplacian [1/m^2] with phi = 0 at the ghosts' centres beyond open boundaries and
/// d phi/dn = 0 on walls: direct, by fast diagonalisation. In a box without an open boundary the mean of rhs is dropped and phi
/// has mean 0. Based on: Lynch, Rice & Thomas 1964, Numerische Mathematik 6.
WINDROW_API void solve_poisson(Workspace& work, std::span<float> rhs_then_phi);

/// velocity -= grad phi with L phi = div velocity - expansion. Collocated, so approximate: the remaining divergence falls as h^2.
/// The kinetic energy does not grow, except at open boundaries, where waves of a few cells along an edge may gain: 1.065 times at
/// most, 4.4 times however often repeated (norms of the matrix and of its powers for 8 x 8 x 8 cells). `gradient`, where not
/// empty, receives grad phi [m/s]. `expansion`, where not empty, is the target divergence [1/s] of volume sources (> 0) and
/// sinks; in a box without an open boundary its mean is dropped. Around obstacles phi is found by conjugate gradients, to a residual
/// of 1e-4 at their surfaces; cells inside take the obstacles' own velocity.
WINDROW_API void project(Workspace& work, std::span<glm::vec4> velocity, std::span<glm::vec4> gradient = {},
                         std::span<const float> expansion = {});

} // namespace windrow
