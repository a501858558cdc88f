// Upper bounds of the air's largest velocity component, by what is known before a step: from speeds that were measured some ticks
// ago, and from what acts since.
//
//   drives, walls, inflow    u is drawn toward a target         at most max(u, target)
//   forces                   u += dt f                          at most u + dt sum f
//   volume sources           u += u_S, a potential flow         at most u + u_S
//   a change of A            the whole air changes with it      u + |change|; u - A stays
//
// Three decisions look back:
//
//   Sub-steps while obstacles move (`substeps`). Each sub-step has its own place of them, so that their number must be known before
//   the step. Every backend takes ceil(CFL / max_cfl) of the bound from the speed that was measured k_delay ticks ago. With at most
//   four ticks in the frames in flight a device has read it back by then, and so both take the same number; else it goes on from
//   an older speed and may take more. A report holds the speeds of the four ticks before its last one too. While none moves, a
//   backend counts the speed that it finds.
//
//   Sleep (`was_still`). Air in which nothing has acted sleeps if it was still k_delay ticks ago, on every backend with the same
//   tick.
//
//   Recording (`after`). A device chooses the number itself where none moves, but its host must record enough of them. The device
//   reports two speeds, frames late: the largest component of u, and of its difference from the ambient wind A; the smaller of
//   both bounds holds. The cubic interpolation and the projection may add a little to each, which `k_margin` allows for. It is a
//   bound in practice, not a proof: where it fails, the device carries time over to the next tick.
#pragma once

#include "fluid/api.h"
#include "fluid/config.h"
#include "fluid/core/cell_storage.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace windrow {

class WINDROW_INTERNAL SpeedBound {
  public:
    /// Ticks after which a device has read back what it measured: two or three frames in flight, or a frame of four ticks.
    static constexpr std::uint64_t k_delay = 4;

    /// A change of the cells since the last tick.
    void note(const CellChange& change);
    /// Nothing is known of the air on a device until the next report.
    void note_unknown() { waiting_.air.least = waiting_.apart.least = k_unknown; }
    /// A device takes over this air, of which it has measured nothing.
    void note_read(std::span<const glm::vec4> air, const AmbientWind& ambient, const Window& window);
    /// Begins a tick with what acts in it.
    void note(const CellStep& step, const Box& box);
    /// [m/s] The largest component after a tick. What is known of the ticks before it stays.
    void note(const MeasuredSpeeds& speeds);

    /// Number of the tick that was noted last; the first is 1.
    [[nodiscard]] std::uint64_t tick() const { return last_; }
    /// Of the tick noted last, while obstacles move: 1 to Config::max_substeps.
    [[nodiscard]] int substeps(const Config& config, double duration) const;
    /// Whether the air was still k_delay ticks before the tick noted last, or by the newest measure before; `undisturbed` ticks in
    /// a row nothing has acted, that one included.
    [[nodiscard]] bool was_still(std::uint64_t undisturbed) const;
    /// [m/s] In the tick noted last, by the report of an earlier one: its largest component and largest difference from ambient.
    [[nodiscard]] float after(std::uint64_t read_tick, float largest, float apart) const;

  private:
    friend struct StateFields; // wind_snapshot.cpp

    static constexpr float k_margin = 1.25f;
    static constexpr float k_unknown = 1e30f; ///< [m/s]
    static constexpr std::size_t k_ticks = 256;

    /// Of a speed: s becomes max(s + added, least).
    struct Rise {
        float added = 0.0f, least = 0.0f;
        void toward(float target) { least = std::max(least, target); }
        void by(float more) { *this = {added + more, least + more}; }
        void reset(float to) { *this = {-2.0f * k_unknown, to}; }
        [[nodiscard]] Rise then(const Rise& next) const {
            return {std::max(added + next.added, -2.0f * k_unknown), std::max(least + next.added, next.least)};
        }
        [[nodiscard]] float of(float speed) const { return std::max(speed + added, least); }
    };
    struct Rises {
        Rise air, apart; ///< of `after`: what may be at most
        Rise expected;   ///< of `substeps`: without margins
    };
    struct Tick {
        Rises rises;
        float measured = -1.0f; ///< [m/s] after it; below 0: not yet
        bool still = false;     ///< MeasuredSpeed::still
    };
    [[nodiscard]] const Tick& at(std::uint64_t tick) const { return ticks_[tick % k_ticks]; }
    /// [m/s] After a tick: as measured, or from the newest before it that was; k_unknown where that is too long ago.
    [[nodiscard]] float expected_after(std::uint64_t tick) const;

    Rises waiting_; ///< since the last tick
    std::array<Tick, k_ticks> ticks_{};
    std::uint64_t last_ = 0;
    float ambient_ = 0.0f;     ///< [m/s] largest component of A
    float gusts_ = 0.0f;       ///< [m/s] and of what varies of it
    float source_flow_ = 0.0f; ///< [m/s] and of u_S
    glm::vec3 taken_{0.0f};    ///< [m/s] mean wind of an A that is taken out, until another one is put in
};

/// [m/s] Largest component that the ambient wind has anywhere in a box, and in `gusts` what varies of it.
[[nodiscard]] WINDROW_INTERNAL float largest_ambient(const AmbientWind& ambient, const Window& window, float* gusts = nullptr);

} // namespace windrow
