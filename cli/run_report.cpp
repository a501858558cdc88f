#include "cli/run_report.h"

#include "cli/info_command.h"
#include "cli/table.h"
#include "fluid/core/message.h"

#include <string>

namespace windrow::cli {
namespace {

using detail::message;

std::string plural(std::int64_t count, const char* noun) {
    return message(count, " ", noun, count == 1 ? "" : "s");
}

/// "20.0 s of air in 0.31 s: 65 times real time"
std::string real_time(const RunReport& report) {
    const double solver = report.timings.solver_seconds();
    std::string text = message(to_fixed(report.air_seconds, 2), " s of air solved in ", to_fixed(solver, 2), " s");
    if (solver > 0.0)
        text +=
            message(", ", to_fixed(report.air_seconds / solver, report.air_seconds < 100.0 * solver ? 1 : 0), " times real time");
    return text;
}

/// "412 of 600 steps; a step took 0.4 us asleep, 0.51 ms awake (medians)"
std::string slept(const Timings& timings) {
    std::string text = message(timings.steps_asleep(), " of ", plural(timings.steps(), "step"), "; a step took ",
                               to_fixed(1000.0 * timings.asleep_ms(), 2), " us asleep");
    if (timings.steps_asleep() < timings.steps())
        text += message(", ", to_fixed(timings.awake_ms(), 3), " ms awake");
    return text + " (medians)";
}

/// "$.obstacles[2] (house) is 200 x 80 x 120 m large."
std::string largest_text(const scene::Scene& scene) {
    std::string text;
    float largest = 0.0f;
    for (std::size_t n = 0; n < scene.obstacles.size(); ++n) {
        const scene::SceneObstacle& body = scene.obstacles[n];
        const glm::vec3 size = 2.0f * windrow::detail::half_extent(body.obstacle.shape);
        const float volume = size.x * size.y * size.z;
        if (std::holds_alternative<Ground>(body.obstacle.shape) || volume <= largest)
            continue;
        largest = volume;
        text = message("$.obstacles[", n, "] (", body.name, ") is ", size.x, " x ", size.y, " x ", size.z, " m large.");
    }
    return text;
}

/// "$.motors[1] (car) and 2 others"; "3 motors" where it is not known which.
std::string lost_text(const RunReport& report) {
    const int lost = report.timings.motors_lost();
    const auto slots = report.playback.wind().motors().slots();
    std::string first;
    int found = 0;
    for (std::size_t n = 0; n < report.scene.motors.size(); ++n) {
        const MotorId id = report.playback.air().motor(n);
        if (id.slot >= slots.size() || !slots[id.slot].used || slots[id.slot].generation != id.generation ||
            slots[id.slot].reaches)
            continue;
        if (found++ == 0)
            first = message("$.motors[", n, "] (", report.scene.motors[n].name, ")");
    }
    if (found != lost) // some ended, or will come into the box that follows
        return plural(lost, "motor");
    return lost == 1 ? first : message(first, " and ", plural(lost - 1, "other"));
}

void warn(const RunReport& report, const Console& console) {
    const Timings& timings = report.timings;
    if (timings.limited_cells() > 0)
        console.warn(message("in ", timings.limited_steps(), " of ", plural(timings.steps(), "step"),
                             " the air was too fast for ", plural(report.scene.air.max_substeps, "sub-step"), " (largest CFL ",
                             to_fixed(timings.largest_cfl(), 1), "): speeds were limited in ",
                             plural(timings.limited_cells(), "cell"),
                             ", counted in each step; raise tick_hz or air.max_substeps."));
    if (timings.repaired_cells() > 0)
        console.warn(message(plural(timings.repaired_cells(), "cell"), " held NaN or infinity and ",
                             timings.repaired_cells() == 1 ? "was" : "were", " set to ambient, first at ",
                             timings.first_repair_time(), " s."));
    if (timings.jumps() > 0)
        console.warn(message(plural(timings.jumps(), "move"), " of obstacles or walkers ", timings.jumps() == 1 ? "was" : "were",
                             " faster than ", report.scene.air.jump_speed,
                             " m/s and pushed no air; give the path more time, or raise air.jump_speed."));
    if (timings.fast_turns() > 0)
        console.warn(
            message("an obstacle turned by more than a sixth of a turn, or by more than a cell at its tips, in ",
                    plural(timings.fast_turns(), "step"),
                    ", so that its blades met the air at few places; raise tick_hz, or take a vortex motor for a rotor."));
    if (timings.sealed() > 0)
        console.warn(message("walls changed the volume of air that has no opening in ", plural(timings.sealed(), "step"),
                             ": it was pressed together, which air at these speeds is not; leave a gap."));
    if (timings.filled() > 0)
        console.warn(message("an obstacle filled more than half of the box in ", plural(timings.filled(), "step"), "; ",
                             largest_text(report.scene), " Lengths are metres: was it made in centimetres?"));
    if (timings.motors_lost() > 0)
        console.warn(message(lost_text(report),
                             " reached no air in any step: ", timings.motors_lost() == 1 ? "it is" : "they are",
                             " under the ground or far outside of the box; compare $.motors with $.floor and $.air."));
}

// Of a box with rows of its own.
std::string rows_text(const Config& air) {
    if (!air.rows)
        return {};
    const auto rows = RowTable::create(*air.rows, air.cells.y, air.cell_size);
    return rows ? message(", rows of ", static_cast<float>((*rows)->thickness(0)), " to ",
                          static_cast<float>((*rows)->thickness(air.cells.y - 1)), " m, ", static_cast<float>((*rows)->top()),
                          " m in all")
                : std::string();
}

std::string list_files(const RunReport& report) {
    std::string text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
    if (report.writer.pictures() > 0)
        add(plural(static_cast<std::int64_t>(report.writer.pictures()), "picture") +
            (report.writer.has_contact_sheet() ? " (frame_*.png, contact_sheet.png)" : " (frame_*.png)"));
    if (report.writer.vdbs() > 0)
        add(plural(static_cast<std::int64_t>(report.writer.vdbs()), "VDB file") + " (vel_*.vdb)");
    if (report.writer.fields() > 0) {
        std::string names;
        for (const FieldFormat format : report.writer.field_formats())
            names += std::string(names.empty() ? "" : ", ") + "wind_*." + name_of(format);
        add(plural(static_cast<std::int64_t>(report.writer.fields()), "file") + " of fields (" + names + ")");
    }
    if (report.csv)
        add("timings.csv");
    if (report.probes)
        add("probes.csv");
    if (report.forces)
        add("forces.csv");
    return text;
}

} // namespace

void report_run(const RunReport& report, const Console& console) {
    const Timings& timings = report.timings;
    const Config& air = report.scene.air;
    const std::int64_t cells =
        static_cast<std::int64_t>(air.cells.x) * static_cast<std::int64_t>(air.cells.y) * static_cast<std::int64_t>(air.cells.z);
    console.out << report.scene.name << ": " << plural(report.frames_done, "frame") << ", " << plural(timings.steps(), "step")
                << " of 1/" << message(report.step_hz) << " s, "
                << (report.device.empty() ? message(plural(report.threads, "thread"), " (", name_of(air.simd), ")")
                                          : report.device)
                << "\n"
                << timings.table();
    console.out << "  cells          "
                << message(air.cells.x, " x ", air.cells.y, " x ", air.cells.z, " of ", air.cell_size, " m", rows_text(air), " (",
                           cells, ")\n");
    console.out << "  sub-steps      " << timings.substeps() << " in all, largest CFL " << to_fixed(timings.largest_cfl(), 2)
                << ", largest speed " << to_fixed(timings.largest_speed(), 2) << " m/s\n";
    console.out << "  limited cells  " << timings.limited_cells() << ", repaired cells " << timings.repaired_cells();
    if (timings.steps_asleep() > 0)
        console.out << "\n  asleep         " << slept(timings);
    console.out << "\n  time           " << real_time(report) << "; " << to_fixed(report.wall_seconds, 2) << " s in all";
    if (report.writer.pictures() > 0)
        console.out << ", pictures " << to_fixed(report.writer.picture_seconds(), 2) << " s";
    if (report.writer.vdbs() > 0)
        console.out << ", VDB " << to_fixed(report.writer.vdb_seconds(), 2) << " s";
    console.out << "\n";
    warn(report, console);
    if (const std::string files = list_files(report); !files.empty())
        console.out << "In " << report.folder.string() << ": " << files << ".\n";
    else
        console.out << "Nothing was kept: add --images, --vdb, --fields, --csv, --probe or --forces.\n";
    console.out.flush();
}

} // namespace windrow::cli
