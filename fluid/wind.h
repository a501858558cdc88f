// The wind in a box that follows a player, on the CPU: the main header of the library.
//
//     auto wind = windrow::Wind::create({.ambient = {3.0f, 0.0f, 0.0f}});          // 32 x 16 x 32 cells of 1 m, open boundaries
//     auto fan  = wind->motors().add(windrow::DirectionalMotor{.position = {4.0, 1.0, 0.0}});
//     wind->follow(player_position);                                               // moves by whole cells, without loss
//     wind->advance(frame_seconds);                                                // fixed ticks, blended for this frame
//     glm::vec3 at_leaf = wind->velocity(leaf_position);                           // [m/s]
//
// Right-handed, y up, metres and seconds. Positions are double; the solver works relative to the box, so 10^6 m away is
// as exact as the origin. One thread at a time may use a Wind; two Winds have no common state.
#pragma once

#include "api.h"
#include "config.h"
#include "diagnostics.h"
#include "owned.h"
#include "parallel.h"
#include "result.h"
#include "view.h"
#include "wind_control.h"
#include "wind_reader.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

namespace windrow {

/// Result of `advance`.
struct Advance {
    int ticks = 0;        ///< ticks that ran
    double dropped = 0.0; ///< [s] time beyond Ticks::max_per_call that was not simulated
    float factor = 0.0f;  ///< position of this frame between the last two ticks, 0 to 1
    Diagnostics last{};   ///< of the last tick that ran; stepped = false if none did
};

/// Motors, obstacles, what blows around the box and where it is: wind_control.h. What it blows: wind_reader.h; of the calls there,
/// those below always have cells and return them without a Result.
class WINDROW_API Wind : public WindControl, public WindReader {
  public:
    [[nodiscard]] static Result<Wind> create(const Config& config);
    /// A wind inside another one, one way: where there was the ambient wind (beyond open boundaries and in the blend zone, in new
    /// cells, as what the air relaxes to) is `outer`, which this wind keeps alive and never changes. The host advances `outer` first,
    /// then this one, by the same frames. Mean wind, profile and gusts are those of `outer`: rejects a config that gives them, a
    /// box that is not inside that of `outer` where a boundary is open, and Scheme::stable_fluids. `outer` keeps its pressure from
    /// now on: eight bytes a cell.
    [[nodiscard]] static Result<Wind> create(const Config& config, std::shared_ptr<const Wind> outer);

    /// Advances the air by dt [s]. Steps may have any length and may differ: no sequence creates energy, and the order stays 2 where
    /// a step is at most twice as long as its neighbours (1 beyond).
    /// 0 is a pause: nothing changes. A dt that is negative or not finite does nothing and returns Diagnostics::stepped = false.
    /// Does not allocate; only the first step with a volume source among the motors, and a step above 1 s that asks more of the
    /// viscosity than shorter ones, do so, once. Where that memory is missing the wind stays as it was and the step returns
    /// Diagnostics::out_of_memory.
    Diagnostics step(double dt);
    /// Advances by a frame of dt [s] in fixed ticks (Config::ticks), so that the air does not depend on the frame rate: `follow`
    /// and `Motors::move` give where things are at the end of this frame, and each tick sees them at its own time on the way.
    /// Sampling then returns the wind blended between the last two ticks, up to a tick old. The first call allocates
    /// three fields; later ones nothing beyond what `step` may. Where memory is missing nothing is done and
    /// `last.out_of_memory` is true. A dt that is negative or not finite does nothing. Mixing with `step` ends the blending.
    Advance advance(double dt);

    // --- Reading the air --------------------------------------------------------------------------------------------------
    /// All that is read of this moment, and of the frame before, for motion vectors. Without `advance` both are the last step: a
    /// host that steps by itself keeps the textures of its last frame.
    [[nodiscard]] WindView view() const;
    [[nodiscard]] WindView previous_view() const;
    [[nodiscard]] glm::vec3 velocity(glm::dvec3 position) const override { return view().velocity(position); }
    void velocity(std::span<const glm::dvec3> positions, std::span<glm::vec3> velocities) const {
        view().velocity(positions, velocities);
    }
    /// The same as four floats each, w = 0: as plants take winds (Blades::loads, Shells::loads).
    void velocity(std::span<const glm::dvec3> positions, std::span<glm::vec4> velocities) const {
        view().velocity(positions, velocities);
    }
    /// [m/s] Wind that acts on a plant there: scaled, limited, with small-scale detail.
    [[nodiscard]] glm::vec3 felt(glm::dvec3 position, const Sampling& sampling) const { return view().felt(position, sampling); }
    /// The same for many points, as `velocity` takes them.
    void felt(std::span<const glm::dvec3> positions, const Sampling& sampling, std::span<glm::vec3> velocities) const {
        view().felt(positions, sampling, velocities);
    }
    void felt(std::span<const glm::dvec3> positions, const Sampling& sampling, std::span<glm::vec4> velocities) const {
        view().felt(positions, sampling, velocities);
    }
    /// One texture of four components, as float or half, as WindView::write_vectors has it. The span holds four numbers for each of
    /// box().cell_count() texels, or the call is rejected.
    Result<void> write_vectors(std::span<float> texels) const { return view().write_vectors(texels); }
    Result<void> write_vectors(std::span<std::uint16_t> texels) const { return view().write_vectors(texels); }
    /// Three textures, one an axis, as float or half; each span holds box().cell_count() texels or the call is rejected.
    Result<void> write_axes(std::span<float> x, std::span<float> y, std::span<float> z) const {
        return view().write_axes(x, y, z);
    }
    Result<void> write_axes(std::span<std::uint16_t> x, std::span<std::uint16_t> y, std::span<std::uint16_t> z) const {
        return view().write_axes(x, y, z);
    }
    /// [m/s] The cells after the last step or tick, laid out as box.h says; w as WindView::field has it.
    [[nodiscard]] std::span<const glm::vec4> field() const;
    [[nodiscard]] const AmbientWind& ambient_wind() const override { return view().ambient(); }
    [[nodiscard]] WindowBlock window_block(glm::dvec3 anchor) const override;
    [[nodiscard]] FrameBlock frame_block(glm::dvec3 anchor, const Sampling& sampling = {}) const override;
    Result<void> write_obstacles(std::span<float> cells) const override;
    Result<void> write_pressure(std::span<float> cells) override;
    [[nodiscard]] Result<ObstacleForce> force_on(ObstacleId id) const override;
    [[nodiscard]] Result<DragForce> force_on(DragId id) const override;
    [[nodiscard]] Diagnostics diagnostics() const override;
    [[nodiscard]] std::uint64_t memory_bytes() const override;

    // --- Setting the air: needs no memory, and so returns nothing -----------------------------------------------------------
    using WindControl::set_velocity;
    void set_velocity(const std::function<glm::vec3(glm::dvec3 centre)>& velocity_at);

    // --- Snapshots --------------------------------------------------------------------------------------------------------
    /// The whole state as bytes: config, air, motors, obstacles, gusts, ticks. Little-endian, with a version and a checksum. Fails
    /// without memory for them. Levels are saved one by one.
    [[nodiscard]] Result<std::vector<std::byte>> save() const;
    /// A wind that continues from there with the same bits (on the same SIMD level). Rejects bytes that are truncated, changed,
    /// or of another version. `outer`: the loaded outer wind of a wind that has one, which is loaded before it.
    [[nodiscard]] static Result<Wind> load(std::span<const std::byte> bytes, ParallelFor parallel_for = {},
                                           std::shared_ptr<const Wind> outer = {});

    Wind(Wind&&) noexcept;
    Wind& operator=(Wind&&) noexcept;
    ~Wind() override;

    struct State; // wind_state.h
    [[nodiscard]] State& state() const { return *state_; }

  private:
    explicit Wind(std::unique_ptr<State> state);
    /// Of a valid config.
    [[nodiscard]] static Result<Wind> make(const Config& config, std::shared_ptr<const Wind> outer, bool loads);
    [[nodiscard]] Result<WindView> read_view() const override { return view(); }
    [[nodiscard]] Result<WindView> read_previous_view() const override { return previous_view(); }
    detail::Owned<State> state_;
};

} // namespace windrow
