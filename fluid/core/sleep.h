// Sleep state of the air: awake, calm or asleep.
#pragma once

#include "fluid/diagnostics.h"

#include <cstdint>

namespace windrow {

struct Sleep {
    enum class Depth : std::uint8_t {
        awake,
        calm,  ///< every cell is ambient to the bit, history included: filled so, and not stepped since
        asleep ///< calm, and nothing acts: a step carries the gusts on and does nothing else
    };
    Depth depth = Depth::awake;
    Diagnostics at_rest;     ///< what a step reports while asleep
    std::uint64_t drift = 0; ///< how often gusts moved over sleeping air: cells that held them before do not hold those of now
    std::uint64_t undisturbed = 0; ///< ticks in a row in which nothing acted on the air, the newest one included

    [[nodiscard]] bool calm() const { return depth != Depth::awake; }
    [[nodiscard]] bool asleep() const { return depth == Depth::asleep; }

    /// Something acts on the air, or its cells were set.
    void wake() {
        depth = Depth::awake;
        undisturbed = 0;
    }
    /// The ambient wind has changed: the next step runs.
    void stir() {
        depth = calm() ? Depth::calm : Depth::awake;
        undisturbed = 0;
    }
    /// The box moved where the ambient wind depends on its place: the next step runs. What was still there is taken for still here.
    void turn_over() { depth = calm() ? Depth::calm : Depth::awake; }
    /// A tick is stepped.
    void begin_tick(bool acted_on) {
        depth = Depth::awake;
        undisturbed = acted_on ? 0 : undisturbed + 1;
    }
    /// The cells became ambient, with no past.
    void fill() { depth = asleep() ? Depth::asleep : Depth::calm; }
    /// A step came to rest with this report, which becomes that of a sleeper.
    void fall_asleep(Diagnostics& report) {
        depth = Depth::asleep;
        report.asleep = true;
        at_rest = {.stepped = true,
                   .max_speed = report.max_speed,
                   .filling_obstacles = report.filling_obstacles,
                   .divergence_rms = report.divergence_rms,
                   .energy = report.energy,
                   .asleep = true,
                   .times_ms = {}};
    }

    /// Conditions that keep air awake.
    struct Conditions {
        float relaxation_time = 0.0f;   ///< [s] to the ambient wind; 0: never
        float sleep_speed = 0.0f;       ///< [m/s] 0: never
        int motors = 0;                 ///< in reach
        bool source_flow = false;       ///< of volume sources
        bool viscous = false;           ///< viscosity acts, or rough ground on the ambient wind
        bool wind_among_plants = false; ///< which does not come to rest
        bool bodies_act = false;        ///< obstacles in the box that move, or that wind flows around
    };
    [[nodiscard]] static bool may_begin(const Conditions& now) {
        return now.relaxation_time > 0.0f && now.sleep_speed > 0.0f && now.motors == 0 && !now.source_flow && !now.viscous &&
               !now.wind_among_plants && !now.bodies_act;
    }
};

} // namespace windrow
