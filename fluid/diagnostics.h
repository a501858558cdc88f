// Report of a step: figures of the air, and each correction beyond the equations (limits, repairs, sleep).
//
// Each struct has a table of its figures: name, unit, meaning. CSV files, the command's tables and docs/report.md are made from
// these rows, and the C struct has a field for each. A new figure is its declaration and its row.
#pragma once

#include "operators.h"
#include "setting.h"

#include <array>
#include <cstdint>
#include <tuple>
#include <type_traits>

namespace windrow {

/// A figure of a report.
template <class Struct, class Value>
struct ReportRow {
    const char* name;
    Value Struct::*member;
    const char* unit; ///< "m/s"; empty: a count, a ratio, a choice or a flag
    const char* meaning;
};
template <class Struct, class Value>
ReportRow(const char*, Value Struct::*, const char*, const char*) -> ReportRow<Struct, Value>;

/// Wall-clock time of one step by stage.
struct StageTimes {
    /// [ms] Motors, NaN guard, speed limit.
    double sources = 0.0;
    /// [ms] The ambient wind cell by cell; 0 without gusts.
    double ambient = 0.0;
    /// [ms] Viscosity, and the mixing over rough ground.
    double diffusion = 0.0;
    /// [ms] Transport of the velocity, gathering the carried field included.
    double advection = 0.0;
    /// [ms] Direct solves of the pressure, further ones around obstacles too.
    double projection = 0.0;
    /// [ms] Rasterisation, and all passes over faces and cells at obstacles.
    double obstacles = 0.0;
    /// [ms] Energy, largest speed, divergence.
    double report = 0.0;
    /// [ms] The whole step, with what belongs to no stage: a moved box, for one.
    double total = 0.0;

    /// The stages in order; the last row is the whole step.
    static constexpr auto rows() {
        return std::array{
            ReportRow{"sources", &StageTimes::sources, "ms", "Motors, NaN guard, speed limit."},
            ReportRow{"ambient", &StageTimes::ambient, "ms", "The ambient wind cell by cell; 0 without gusts."},
            ReportRow{"diffusion", &StageTimes::diffusion, "ms", "Viscosity, and the mixing over rough ground."},
            ReportRow{"advection", &StageTimes::advection, "ms",
                      "Transport of the velocity, gathering the carried field included."},
            ReportRow{"projection", &StageTimes::projection, "ms",
                      "Direct solves of the pressure, further ones around obstacles too."},
            ReportRow{"obstacles", &StageTimes::obstacles, "ms",
                      "Rasterisation, and all passes over faces and cells at obstacles."},
            ReportRow{"report", &StageTimes::report, "ms", "Energy, largest speed, divergence."},
            ReportRow{"total", &StageTimes::total, "ms", "The whole step, with what belongs to no stage: a moved box, for one."},
        };
    }
};

/// What a step reports.
struct Diagnostics {
    /// The step ran. False: dt was 0, negative or not finite, or out_of_memory; nothing was done.
    bool stepped = false;
    /// The system has no memory that the step needs: the wind is unchanged. Free some and call again. On a device only its
    /// obstacles find none: the step ran without them.
    bool out_of_memory = false;
    /// The box, with rows of its own, was at another height in the last step: air that stayed in it was interpolated. After
    /// `advance`, in any of its ticks.
    bool regridded = false;
    /// [m/s] Largest component of the velocity after the step.
    float max_speed = 0.0f;
    /// Largest component * dt / h after the sources, before sub-steps and limit: how many cells the air would cross at once.
    float cfl = 0.0f;
    /// Number of sub-steps: ceil(cfl / max_cfl), at most max_substeps; while obstacles move, of a bound of the speed that is
    /// known before the step.
    int substeps = 0;
    /// More sub-steps were needed than allowed: speeds were limited.
    bool substeps_capped = false;
    /// [s] Time that the next steps make up for, on a device whose speeds rose further than its host could foresee; 0 on the CPU.
    float carried_time = 0.0f;
    /// Cells whose speed was scaled down to max_cfl * max_substeps cells a step, before the air moved or, where forces and
    /// pressure had made them faster, after it.
    std::int64_t limited_cells = 0;
    /// Cells that held NaN or infinity and were set to ambient.
    std::int64_t repaired_cells = 0;
    /// Motors that acted in the box; a wake counts once per segment of its path. In free air also a volume source outside of the
    /// box that makes 1 cm/s in it.
    int motors_in_reach = 0;
    /// Motors that act on no air where they are: under the ground, or farther outside of the box than its size, on an axis along
    /// which it does not follow. A mistake in most scenes.
    int motors_lost = 0;
    /// Obstacles and wakes that were moved faster than jump_speed: they were there at once, without a push.
    int jumps = 0;
    /// Obstacles that turned by more than a sixth of a turn in the step, or whose outermost place went farther than a cell by it:
    /// their blades meet the air at few places. The moment on a blade of 4 cells and more is some 10 % off then, on a thinner one
    /// up to a half. A vortex motor is the wind of a fast rotor.
    int fast_turns = 0;
    /// Obstacles, grounds aside, of which each fills more than half of the box, so that little wind is left: a mistake of units
    /// in most scenes. Lengths are metres.
    int filling_obstacles = 0;
    /// How viscosity acted: not at all, in one explicit pass, or by a direct solve.
    DiffusionMethod diffusion = DiffusionMethod::none;
    /// What the pressure's solution leaves of the divergence at the surfaces of obstacles, relative to that before it. 0 without
    /// obstacles in the box.
    float pressure_residual = 0.0f;
    /// Direct solves of the pressure in the last sub-step. 0 without obstacles in the box.
    int pressure_solves = 0;
    /// Volume sources in air that no opening joins to the boundary of the box. What comes out of one there is taken out again,
    /// evenly, from all air of that room: incompressible air cannot leave it.
    int sealed_sources = 0;
    /// Parts of the air without an opening whose volume moving walls change: a closed room, or all air of a box without an open
    /// boundary. Incompressible air cannot leave: it takes the change evenly, as if it were pressed together, and its pressure is
    /// relative to none.
    int sealed_rooms = 0;
    /// [1/s] Root mean square of the central divergence that the collocated projection leaves.
    double divergence_rms = 0.0;
    /// [m^5/s^2] Kinetic energy of the box per unit of density: sum of u^2 / 2 h^3.
    double energy = 0.0;
    /// The air had relaxed to the ambient wind and no motor acted: the step did nothing. The other figures, those of gusts too,
    /// stay as in the step that fell asleep. Gusts go on.
    bool asleep = false;
    /// [ms] Wall-clock time by stage.
    StageTimes times_ms;

    static constexpr auto rows() {
        return std::tuple{
            ReportRow{"stepped", &Diagnostics::stepped, "",
                      "The step ran. False: dt was 0, negative or not finite, or out_of_memory; nothing was done."},
            ReportRow{
                "out_of_memory", &Diagnostics::out_of_memory, "",
                "The system has no memory that the step needs: the wind is unchanged. Free some and call again. On a device only "
                "its obstacles find none: the step ran without them."},
            ReportRow{"regridded", &Diagnostics::regridded, "",
                      "The box, with rows of its own, was at another height in the last step: air that stayed in it was "
                      "interpolated. After `advance`, in any of its ticks."},
            ReportRow{"max_speed", &Diagnostics::max_speed, "m/s", "Largest component of the velocity after the step."},
            ReportRow{"cfl", &Diagnostics::cfl, "",
                      "Largest component * dt / h after the sources, before sub-steps and limit: how many cells the air would "
                      "cross at once."},
            ReportRow{"substeps", &Diagnostics::substeps, "",
                      "Number of sub-steps: ceil(cfl / max_cfl), at most max_substeps; while obstacles move, of a bound of the "
                      "speed that is "
                      "known before the step."},
            ReportRow{"substeps_capped", &Diagnostics::substeps_capped, "",
                      "More sub-steps were needed than allowed: speeds were limited."},
            ReportRow{
                "carried_time", &Diagnostics::carried_time, "s",
                "Time that the next steps make up for, on a device whose speeds rose further than its host could foresee; 0 "
                "on the CPU."},
            ReportRow{"limited_cells", &Diagnostics::limited_cells, "",
                      "Cells whose speed was scaled down to max_cfl * max_substeps cells a step, before the air moved or, where "
                      "forces and pressure had made them faster, after it."},
            ReportRow{"repaired_cells", &Diagnostics::repaired_cells, "",
                      "Cells that held NaN or infinity and were set to ambient."},
            ReportRow{
                "motors_in_reach", &Diagnostics::motors_in_reach, "",
                "Motors that acted in the box; a wake counts once per segment of its path. In free air also a volume source "
                "outside of the box that makes 1 cm/s in it."},
            ReportRow{
                "motors_lost", &Diagnostics::motors_lost, "",
                "Motors that act on no air where they are: under the ground, or farther outside of the box than its size, on an "
                "axis along which it does not follow. A mistake in most scenes."},
            ReportRow{"jumps", &Diagnostics::jumps, "",
                      "Obstacles and wakes that were moved faster than jump_speed: they were there at once, without a push."},
            ReportRow{
                "fast_turns", &Diagnostics::fast_turns, "",
                "Obstacles that turned by more than a sixth of a turn in the step, or whose outermost place went farther than a "
                "cell by it: their blades meet the air at few places. The moment on a blade of 4 cells and more is some 10 % off "
                "then, on a thinner one up to a half. A vortex motor is the wind of a fast rotor."},
            ReportRow{"filling_obstacles", &Diagnostics::filling_obstacles, "",
                      "Obstacles, grounds aside, of which each fills more than half of the box, so that little wind is left: a "
                      "mistake of "
                      "units in most scenes. Lengths are metres."},
            ReportRow{"diffusion", &Diagnostics::diffusion, "",
                      "How viscosity acted: not at all, in one explicit pass, or by a direct solve."},
            ReportRow{
                "pressure_residual", &Diagnostics::pressure_residual, "",
                "What the pressure's solution leaves of the divergence at the surfaces of obstacles, relative to that before "
                "it. 0 without obstacles in the box."},
            ReportRow{"pressure_solves", &Diagnostics::pressure_solves, "",
                      "Direct solves of the pressure in the last sub-step. 0 without obstacles in the box."},
            ReportRow{"sealed_sources", &Diagnostics::sealed_sources, "",
                      "Volume sources in air that no opening joins to the boundary of the box. What comes out of one there is "
                      "taken out again, evenly, from all air of that room: incompressible air cannot leave it."},
            ReportRow{
                "sealed_rooms", &Diagnostics::sealed_rooms, "",
                "Parts of the air without an opening whose volume moving walls change: a closed room, or all air of a box "
                "without an open boundary. Incompressible air cannot leave: it takes the change evenly, as if it were pressed "
                "together, and its pressure is relative to none."},
            ReportRow{"divergence_rms", &Diagnostics::divergence_rms, "1/s",
                      "Root mean square of the central divergence that the collocated projection leaves."},
            ReportRow{"energy", &Diagnostics::energy, "m^5/s^2",
                      "Kinetic energy of the box per unit of density: sum of u^2 / 2 h^3."},
            ReportRow{
                "asleep", &Diagnostics::asleep, "",
                "The air had relaxed to the ambient wind and no motor acted: the step did nothing. The other figures, those "
                "of gusts too, stay as in the step that fell asleep. Gusts go on."},
            ReportRow{"times_ms", &Diagnostics::times_ms, "ms", "Wall-clock time by stage."},
        };
    }
};

/// Calls visit(row, value) for each figure in order; the report may be const.
template <class Report, class Visit>
constexpr void for_each_row(Report& report, const Visit& visit) {
    using Plain = std::remove_const_t<Report>;
    static_assert(detail::member_count<Plain>() == std::tuple_size_v<decltype(Plain::rows())>, "a member has no row");
    std::apply([&](const auto&... row) { (visit(row, report.*row.member), ...); }, Plain::rows());
}

} // namespace windrow
