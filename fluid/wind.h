// The wind around a player: the header an embedder includes.
//
//     auto wind = windrow::Wind::create({.ambient = {3.0f, 0.0f, 0.0f}});          // 32 x 16 x 32 cells of 1 m, open sides
//     auto fan  = wind->motors().add(windrow::DirectionalMotor{.position = {4.0, 1.0, 0.0}});
//     wind->follow(player_position);                                               // whole cells, nothing is lost
//     wind->step(1.0 / 60.0);
//     glm::vec3 at_leaf = wind->velocity(leaf_position);                           // [m/s]
//
// Right-handed, y up, metres and seconds. Positions are double; the solver works relative to the box, so 10^6 m away is
// as exact as the origin. One Wind is used by one thread at a time; two Winds share nothing.
#pragma once

#include "fluid/box.h"
#include "fluid/diagnostics.h"
#include "fluid/motors.h"
#include "fluid/parallel.h"
#include "fluid/pieces.h"
#include "fluid/result.h"
#include "fluid/textures.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

namespace windrow {

enum class Scheme : std::uint8_t {
    second_order,  ///< Semi-implicit semi-Lagrangian, centred forces, one direct projection: order 2 at fixed CFL. The default.
    stable_fluids, ///< The classic split (Stam 1999): forces, diffusion, advection, projection, each whole: order 1.
};

/// Stages that run. A stage whose parameter is off costs nothing anyway; these switch off what a test does not want.
/// Without advection there is no trajectory to centre forces on: the whole f dt acts in the step.
struct Stages {
    bool sources = true;
    bool settling = true;
    bool diffusion = true;
    bool advection = true;
    bool projection = true;
};

struct Config {
    /// Cells along x, y, z; 1 to 2048 each. Default 32 x 16 x 32: 32 m around a player at 1 m, half as high.
    glm::ivec3 cells{32, 16, 32};
    /// [m] Edge of a cell. Default 1: a gust that a person notices spans several.
    float cell_size = 1.0f;
    /// Default open on all sides; Sides::open_over_floor() adds ground.
    Sides sides{};
    /// [m] World position that the box is centred on at the start, to whole cells. On axes that do not follow, the centre for good.
    glm::dvec3 centre{0.0};
    /// Axes that `follow` moves. Default: every axis with two open sides. Asking it of another axis is refused.
    std::optional<glm::bvec3> follow_axes{};
    /// [m/s] Mean wind: the start, what enters through open sides, what new cells get.
    glm::vec3 ambient{0.0f};
    /// [m^2/s] Kinematic viscosity, >= 0. Default that of air, which at 1 m cells is below what the solver resolves and costs nothing.
    float viscosity = 1.5e-5f;
    /// [s] Time in which air left alone comes back to ambient; 0: never (analytic cases). Default 20: no collocated solver damps the
    /// checkerboard in still air by itself.
    float settling_time = 20.0f;
    Scheme scheme = Scheme::second_order;
    Interpolation interpolation = Interpolation::cubic;
    /// Cells that the air may cross in one sub-step, > 0. Above 2 the backtrace swallows thin motors; raise it to see the raw step.
    float max_cfl = 2.0f;
    /// Most sub-steps in a step, 1 to 64. Beyond max_cfl * max_substeps cells a step, speeds are limited (and counted).
    int max_substeps = 8;
    Stages stages{};
    /// Threads of the host; default serial. Results do not depend on it.
    ParallelFor parallel_for{};
};

/// Every reason why a config cannot be used, a line each.
[[nodiscard]] Result<void> validate(const Config& config);

class Wind {
  public:
    [[nodiscard]] static Result<Wind> create(const Config& config);

    /// Advances the air by dt [s]. 0 is a pause: nothing changes. A dt that is negative or not finite does nothing and says so
    /// (Diagnostics::stepped). Does not allocate; only a step above 1 s that asks more of the viscosity than shorter ones does so, once.
    Diagnostics step(double dt);

    // --- What acts on the air -----------------------------------------------------------------------------------------
    [[nodiscard]] Motors& motors();
    [[nodiscard]] const Motors& motors() const;
    /// Changes the mean wind [m/s]. All air of the box changes by the difference at once, as under a pressure gradient that is far wider than
    /// the box; entering through the sides alone, a new wind would never reach still air. Ramp it for a gust. Components along
    /// axes that a wall closes are dropped. Refuses what is not finite or above 1e4 m/s.
    [[nodiscard]] Result<void> set_ambient(glm::vec3 ambient);
    [[nodiscard]] glm::vec3 ambient() const;
    /// Changes kinds or wall velocities between steps. A changed kind starts the second-order history anew. Refuses what
    /// `validate` refuses and a wall across an axis that follows.
    [[nodiscard]] Result<void> set_sides(const Sides& sides);

    // --- Where the box lies -------------------------------------------------------------------------------------------
    /// Centres the box on a point, to whole cells, on the axes that follow. Air that stays inside keeps its values to the bit; new
    /// cells hold the ambient wind. A jump beyond the box starts afresh. Refuses a point that is not finite or beyond 1e12 cells.
    Result<void> follow(glm::dvec3 point);
    /// Puts the box's low y side at a height [m], to whole cells: the ground under a player. For boxes whose low y side is solid.
    Result<void> set_floor(double height);
    /// [m] World position of the box's low corner.
    [[nodiscard]] glm::dvec3 origin() const;
    [[nodiscard]] const Box& box() const;

    // --- Reading the air ----------------------------------------------------------------------------------------------
    /// [m/s] Wind at a world point: trilinear between cell centres, as a vertex stage samples the textures; beyond an open side it
    /// fades to ambient over one cell; beyond a wall it is the wind at the wall. A point that is not finite gets ambient.
    [[nodiscard]] glm::vec3 velocity(glm::dvec3 position) const;
    /// The same for many points; `velocities` holds as many.
    void velocity(std::span<const glm::dvec3> positions, std::span<glm::vec3> velocities) const;
    /// [m/s] The cells themselves, laid out as box.h says; w = 0.
    [[nodiscard]] std::span<const glm::vec4> field() const;
    /// Three textures, one an axis, as float or half; each span holds box().cell_count() texels or the call is refused.
    Result<void> write_axes(std::span<float> x, std::span<float> y, std::span<float> z) const;
    Result<void> write_axes(std::span<std::uint16_t> x, std::span<std::uint16_t> y, std::span<std::uint16_t> z) const;
    /// Where the textures lie, relative to `anchor` [m].
    [[nodiscard]] WindowBlock window_block(glm::dvec3 anchor) const;

    // --- Setting the air ----------------------------------------------------------------------------------------------
    /// Sets every cell from a function of its centre's world position; the second-order history starts anew. Values that are not
    /// finite are caught by the next step.
    void set_velocity(const std::function<glm::vec3(glm::dvec3 centre)>& velocity_at);
    /// The same from an array laid out as box.h says; refuses another size.
    Result<void> set_velocity(std::span<const glm::vec4> field);
    /// Back to ambient everywhere, history too: a fresh solver in place.
    void reset();

    [[nodiscard]] const Config& config() const;
    /// Bytes that this object has allocated.
    [[nodiscard]] std::size_t memory_bytes() const;

    Wind(Wind&&) noexcept;
    Wind& operator=(Wind&&) noexcept;
    ~Wind();

  private:
    struct State;
    explicit Wind(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace windrow
