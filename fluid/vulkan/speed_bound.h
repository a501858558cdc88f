// Upper bound of the air's largest velocity component, from which the host knows how many sub-steps a tick can need.
//
// The device reports two speeds, frames late: the largest component of u, and of its difference from the ambient wind A. Both
// rise only by what acts since, which the host knows:
//
//   drives, walls, inflow    u is drawn toward a target         at most max(u, target)
//   forces                   u += dt f                          at most u + dt sum f
//   volume sources           u += u_S, a potential flow         at most u + u_S
//   a change of A            the whole air changes with it      u + |change|; u - A stays
//
// The cubic interpolation and the projection may add a little to each, which `k_margin` allows for. The smaller of the two bounds
// holds. It is a bound in practice, not a proof: where it fails, the device carries time over to the next tick.
#pragma once

#include "fluid/cell_storage.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace windrow::vulkan {

class SpeedBound {
  public:
    /// A change of the cells since the last tick.
    void note(const CellChange& change);
    /// Nothing is known until the next report.
    void note_unknown() { waiting_.air.least = waiting_.apart.least = k_unknown; }
    /// Ends a tick, the ones after another, with what acts in it.
    void note(std::uint64_t tick, const CellStep& step, const Box& box);

    /// [m/s] In the last noted tick, by the report of an earlier one: its largest component and largest difference from ambient.
    [[nodiscard]] float after(std::uint64_t read_tick, float largest, float apart) const;

  private:
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
        Rise air, apart;
    };
    Rises waiting_; ///< since the last tick
    std::array<Rises, k_ticks> ticks_{};
    std::uint64_t last_ = 0;
    float ambient_ = 0.0f;     ///< [m/s] largest component of A
    float gusts_ = 0.0f;       ///< [m/s] and of what varies of it
    float source_flow_ = 0.0f; ///< [m/s] and of u_S
};

/// [m/s] Largest component that the ambient wind has anywhere in a box, and in `gusts` what varies of it.
[[nodiscard]] float largest_ambient(const AmbientWind& ambient, const Window& window, float* gusts = nullptr);

} // namespace windrow::vulkan
