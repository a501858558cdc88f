// Ground memory around a player: plants that swing in the wind, are trodden down and rise again.
//
//     auto ground = windrow::GroundMemory::create({});
//     (void)ground->follow(player);
//     if (auto done = ground->advance({.duration = dt, .walkers = walkers, .wind_lean = lean}); !done)
//         log(done.error());
//     windrow::GroundSample here = ground->at(blade_root);
//
// A square window of texels over the plane xz that follows a point by whole texels. A move copies nothing, and texels that stay
// in the window keep their bits. The same on a device: coupling/vulkan/ground_memory.h. The formulas:
// shaders/numerics/ground.glsl.
#pragma once

#include "../fluid/api.h"
#include "../fluid/owned.h"
#include "../fluid/parallel.h"
#include "ground_config.h"
#include "motion_blocks.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace windrow {

namespace detail {
struct GroundState;
}

/// The ground at a point.
struct GroundSample {
    glm::vec2 lean{0.0f}; ///< [rad] bend of the plants (x and z), wind and walkers together
    float trample = 0.0f; ///< 0 to 1: how hard they are pressed now
    float trail = 0.0f;   ///< [rad] length of the lean that stays behind walkers
};

class WINDROW_API GroundMemory {
  public:
    /// No trail, no trample, plants at rest. Rejects as `validate`. Threads through `parallel_for`; any number gives the same
    /// bits.
    [[nodiscard]] static Result<GroundMemory> create(const GroundConfig& config, ParallelFor parallel_for = {});

    /// The window's middle, from the next `advance` on, to the nearest texel [m]. A point beyond the window begins again there.
    Result<void> follow(glm::dvec3 point);
    /// The origin of the host's world has moved, as Wind::shift_origin: every place that the memory holds moves by `offset` [m] of
    /// any length, of which x and z count. Texels keep their bits and stay under the plants. Call it between steps. Rejects what is
    /// not finite, and shifts that add up to more than 1e12 m.
    Result<void> shift_origin(glm::dvec3 offset);
    /// One step: the window moves, plants swing and rise, walkers push. Does not allocate. Rejects what is not finite or out of
    /// range, with nothing changed. Of more walkers than GroundConfig::max_walkers that touch the window the first ones count.
    Result<void> advance(const GroundStep& step);
    /// The same with a wind lean for each texel, in slots: texels x texels, x fastest; slot (i, j) will lie at next_centre({i,
    /// j}). Outside of the window step.wind_lean holds. Rejects another number of them; a lean that is no number, or beyond 1e3,
    /// counts as 0.
    Result<void> advance(const GroundStep& step, std::span<const glm::vec2> wind_leans);
    /// Walkers who touched the window in the last `advance` and did not count, for lack of room.
    [[nodiscard]] int walkers_left_out() const;
    /// [m] Place (x, z) of what a slot, 0 to texels - 1 along each edge, will hold after the next `advance`.
    [[nodiscard]] glm::dvec2 next_centre(glm::ivec2 slot) const;

    /// At a world point, of which x and z count, and the same before the last `advance`: the difference is this frame's motion
    /// vector.
    [[nodiscard]] GroundSample at(glm::dvec3 position) const;
    [[nodiscard]] GroundSample previous_at(glm::dvec3 position) const;

    /// For shaders (shaders/coupling/windrow_ground.glsl): texels in slots, x fastest: lean x, lean z, trample, length of the
    /// trail.
    [[nodiscard]] std::span<const glm::vec4> texels() const;
    [[nodiscard]] std::span<const glm::vec4> previous_texels() const;
    /// And where they lie, relative to `anchor` [m].
    [[nodiscard]] GroundBlock block(glm::dvec3 anchor) const;
    [[nodiscard]] const GroundConfig& config() const;

    /// All of it as bytes: trails, plants on the move, and the window.
    [[nodiscard]] Result<std::vector<std::byte>> save() const;
    /// Goes on to the bit as the one that was saved. Rejects bytes that `save` did not return.
    [[nodiscard]] static Result<GroundMemory> load(std::span<const std::byte> bytes, ParallelFor parallel_for = {});

    /// One that was moved from may be assigned to, copied or destroyed, no more.
    GroundMemory(GroundMemory&&) noexcept;
    GroundMemory& operator=(GroundMemory&&) noexcept;
    GroundMemory(const GroundMemory& other);
    GroundMemory& operator=(const GroundMemory& other);
    ~GroundMemory();

  private:
    friend struct detail::GroundState;
    struct State;
    explicit GroundMemory(std::unique_ptr<State> state);
    detail::Owned<State> state_;
};

} // namespace windrow
