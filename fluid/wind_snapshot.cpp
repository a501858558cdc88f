// Snapshot: the whole state of a wind as bytes, and back. One text serves winds on the CPU and on a device, whose cells are filled
// in later.
//
// It holds all state that affects the future. It omits scratch (workspace, gathered sources, diffused and own velocity, segments
// of a path) and derived data (tables, axes that follow, the ambient wind cell by cell, gust tiles from their seeds). Equal
// states give equal bytes: unused fields are omitted (the second-order history of fresh air, the report of a sleeping wind
// while it is awake).
#include "fluid/core/ambient_record.h"
#include "fluid/core/archive.h"
#include "fluid/core/message.h"
#include "fluid/core/obstacle_record.h"
#include "fluid/core/snapshot.h"
#include "fluid/cpu/workspace.h"
#include "fluid/wind_state.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace windrow {
namespace {

constexpr detail::Format k_format{
    "WINDSNAP", detail::Layout("state 12").with<Config>().with<Motor>().with<Obstacle>().with<DragDeposit>().version(),
    "snapshot", "Wind::save"};
// The direction as normalised by Motors::add.
bool has_unit_direction(const Motor& motor) {
    const auto unit = [](const glm::vec3& direction) { return std::abs(glm::length(glm::dvec3(direction)) - 1.0) < 1e-3; };
    return std::visit(
        [&](const auto& kind) {
            if constexpr (requires { kind.direction; })
                return unit(kind.direction);
            else if constexpr (requires { kind.axis; })
                return unit(kind.axis);
            else
                return true;
        },
        motor);
}

} // namespace

// --- Fields -----------------------------------------------------------------------------------------------------------------

namespace detail {

void fields(auto& archive, Like<Diagnostics> auto& report) { // of a sleeping wind; its times are 0
    auto& [stepped, out_of_memory, regridded, max_speed, cfl, substeps, substeps_capped, carried_time, limited_cells,
           repaired_cells, motors_in_reach, motors_lost, jumps, fast_turns, filling_obstacles, diffusion, pressure_residual,
           pressure_solves, sealed_sources, sealed_rooms, divergence_rms, energy, asleep, times_ms] = report;
    archive(stepped, max_speed, cfl, substeps, substeps_capped, limited_cells, repaired_cells, motors_in_reach, diffusion,
            pressure_residual, pressure_solves, sealed_sources, divergence_rms, energy, asleep);
}

} // namespace detail

using detail::AmbientRecord, detail::Like, detail::Reading, detail::Tiles;
using detail::in_range, detail::k_farthest_cells;

namespace {

/// Handle of a body whose load a device holds.
struct DeviceLoad {
    std::uint32_t slot = 0, generation = 0;
};

/// Writer that leaves gaps for what a device holds.
class DraftWriter {
  public:
    DraftWriter(std::size_t expected, std::size_t cells) : writer_(expected), cells_(cells) {}

    template <class... Values>
    void operator()(const Values&... values) {
        (put(values), ...);
    }
    void cells(DeviceState state) { leave(state, cells_ * sizeof(glm::vec4)); }
    [[nodiscard]] SnapshotDraft finish() && { return {std::move(writer_).take(), std::move(gaps_)}; }

  private:
    void put(const auto& value) { writer_(value); }
    void put(DeviceState state) { leave(state, sizeof(float)); }
    void put(const DeviceLoad& load) {
        (*this)(load.slot, load.generation);
        leave(DeviceState::body_load, ObstacleFields::k_load_bytes - sizeof(load));
    }
    void leave(DeviceState state, std::size_t bytes) { gaps_.push_back({state, writer_.leave(bytes), bytes}); }

    detail::Writer writer_;
    std::size_t cells_;
    std::vector<SnapshotDraft::Gap> gaps_;
};

/// Names of what a device holds in place of cpu::Cells, in the order of its members.
struct DeviceNames {
    struct Air {
        DeviceState velocity = DeviceState::velocity, velocity_old = DeviceState::velocity_old, history = DeviceState::history;
        bool fresh = true;
        DeviceState dt_old = DeviceState::dt_old, undiffused_time = DeviceState::undiffused_time;
    };
    struct Frames {
        struct Field {
            DeviceState cells;
        };
        DeviceState before = DeviceState::before;
        Field shown{DeviceState::shown}, shown_before{DeviceState::shown_before};
    };
    Air air;
    Frames frames{};
    DeviceState source_flow = DeviceState::source_flow;
    struct Surface {
        std::vector<PlacedObstacle> placed;
        bool inside_is_air;
        std::vector<std::uint32_t> keys;
        std::vector<DeviceState> terms;
        glm::ivec3 shift;
        std::vector<DeviceLoad> loads;
        float duration;
    };
    Surface surface;
    [[nodiscard]] Surface surface_history() const { return surface; }
    [[nodiscard]] cpu::Cells::KeptPotential kept_potential() const { return {}; }
    LevelState level{};
    [[nodiscard]] const LevelState& level_state() const { return level; }
};

} // namespace

/// Access to the private members of the list of deposits.
struct DragFields {
    static void deposits(auto& archive, Like<DragField> auto& drag) {
        const auto slot = [&](auto& one) {
            auto& [deposit, generation, used, named_here] = one; // read: named by the wind that was saved
            archive(used, generation);
            if (used)
                archive(deposit);
        };
        if (!SlotFields::require_slots(archive, drag.list_, "it has more deposits of drag than fit.", slot) ||
            !SlotFields::require_free(archive, drag.list_, "its list of free deposits does not match its deposits."))
            return;
        if constexpr (Reading<decltype(archive)>)
            restore(archive, drag);
    }

  private:
    static void restore(detail::Reader& reader, DragField& drag) {
        for (std::size_t n = 0; n < drag.slots().size() && !reader.rejected(); ++n) {
            const DragField::Slot& slot = drag.slots()[n];
            reader.require(slot.generation > 0, "a deposit has no generation.");
            if (!slot.used)
                continue;
            if (auto valid = validate(slot.deposit); !valid)
                reader.reject("deposit ", n, " cannot be used: ", valid.error());
        }
        if (reader.rejected() || drag.slots().empty())
            return;
        drag.make_room(0);
        drag.link_all();
    }
};

/// Access to the private members of the state.
struct StateFields {
    static void slot(auto& archive, Like<Motors::Slot> auto& slot) {
        auto& [motor, track, age, generation, used, named_here, reaches] = slot; // read: named by the wind that was saved
        archive(used, generation);
        if (!used)
            return;
        archive(motor, age);
        PathFields::track(archive, track);
    }

    static void motors(auto& archive, Like<Motors> auto& motors) {
        auto& [list, jumps, reach, tile, log] = motors;
        if (!SlotFields::require_slots(archive, list, "it has more motors than fit.",
                                       [&](auto& slot) { StateFields::slot(archive, slot); }) ||
            !SlotFields::require_free(archive, list, "its list of free motors does not match its motors."))
            return;
        if constexpr (Reading<decltype(archive)>) {
            motors.reserve_reach(nullptr);
            check(archive, motors.slots());
        }
    }

    static void check(detail::Reader& reader, std::span<const Motors::Slot> motors) {
        for (std::size_t n = 0; n < motors.size() && !reader.rejected(); ++n) {
            const Motors::Slot& slot = motors[n];
            reader.require(slot.generation > 0, "a motor has no generation.");
            if (!slot.used)
                continue;
            if (auto valid = validate(slot.motor); !valid)
                reader.reject("motor ", n, " cannot be used: ", valid.error());
            reader.require(has_unit_direction(slot.motor), "a motor's direction is not of length 1.");
            reader.require(slot.age >= 0.0 && PathFields::lies_within(slot.track, k_farthest_cells),
                           "a motor's age or path is out of range.");
        }
    }

    static void ambient(auto& archive, Like<AmbientWind> auto& wind, const Config& config, Tiles& tiles) {
        if constexpr (Reading<decltype(archive)>) {
            AmbientRecord record;
            archive(record);
            detail::restore(wind, record, config.profile, tiles, archive);
        } else {
            archive(detail::record_of(wind));
        }
    }

    static void air(auto& archive, auto& air) {
        auto& [velocity, velocity_old, history, fresh, dt_old, undiffused_time] = air;
        archive(fresh, undiffused_time);
        if constexpr (Reading<decltype(archive)>)
            archive.require(undiffused_time >= 0.0f && undiffused_time < 1e30f,
                            "the time in which viscosity has not acted is out of range.");
        archive.cells(velocity);
        if (fresh)
            return;
        archive(dt_old);
        archive.cells(velocity_old);
        archive.cells(history);
        if constexpr (Reading<decltype(archive)>)
            archive.require(dt_old > 0.0f, "its last step took no time.");
    }

    static void frame(auto& archive, Like<ShownFrame> auto& frame, auto& field, const Config& config, Tiles& tiles) {
        auto& [window, blend_centre, ambient, still] = frame;
        archive(window.origin_cells, blend_centre, still); // with the box's cells
        StateFields::ambient(archive, ambient, config, tiles);
        archive.cells(field.cells);
        if constexpr (Reading<decltype(archive)>)
            archive.require(in_range(window.origin_cells), "a frame is out of range.");
    }

    static void frames(auto& archive, Like<FrameHistory> auto& frames, auto& cells, const Config& config, Tiles& tiles) {
        auto& [before_still, point_before, gust_phase_before, clock, shown, shown_before, follow] = frames;
        auto& [before_cells, shown_cells, shown_before_cells] = cells;
        archive(before_still, point_before, gust_phase_before, clock.lead);
        archive.cells(before_cells);
        frame(archive, shown, shown_cells, config, tiles);
        frame(archive, shown_before, shown_before_cells, config, tiles);
        PathFields::track(archive, follow);
        if constexpr (Reading<decltype(archive)>)
            archive.require(clock.lead >= 0.0 &&
                                PathFields::lies_within(follow, k_farthest_cells * static_cast<double>(config.cell_size)),
                            "its frame, or the point that it follows, is out of range.");
    }

    static void sleep(auto& archive, Like<Sleep> auto& sleep) {
        auto& [depth, at_rest, drift, undisturbed] = sleep;
        bool calm = sleep.calm(), asleep = sleep.asleep();
        auto alone = std::min(undisturbed, SpeedBound::k_delay); // the ticks that are saved
        archive(calm, asleep, alone);
        if constexpr (Reading<decltype(archive)>) {
            archive.require(calm || !asleep, "its air sleeps but is not calm.");
            archive.require(alone <= SpeedBound::k_delay, "it has more ticks at rest than fit.");
            depth = asleep ? Sleep::Depth::asleep : calm ? Sleep::Depth::calm : Sleep::Depth::awake;
            undisturbed = alone;
        }
    }

    /// The last ticks, from which the sub-steps of the next ones follow; they are the first ticks of the wind that is loaded.
    static void speed(auto& archive, Like<SpeedBound> auto& bound) {
        auto& [waiting, ticks, last, ambient, gusts, source_flow, taken] = bound;
        auto count = std::min(last, SpeedBound::k_delay);
        const bool known = last <= SpeedBound::k_delay;
        archive(count, ambient, source_flow, waiting.expected.added, waiting.expected.least);
        if constexpr (Reading<decltype(archive)>) {
            archive.require(count <= SpeedBound::k_delay, "it has more speeds than fit.");
            last = std::min(count, SpeedBound::k_delay);
            for (std::uint64_t tick = 1; tick <= last; ++tick)
                archive(ticks[tick].rises.expected.added, ticks[tick].rises.expected.least, ticks[tick].measured,
                        ticks[tick].still);
        } else {
            for (std::uint64_t tick = last - count + 1; tick <= last; ++tick) {
                // The first of them stands for all before it.
                const float measured = tick == last - count + 1 && !known ? bound.expected_after(tick) : bound.at(tick).measured;
                archive(bound.at(tick).rises.expected.added, bound.at(tick).rises.expected.least, measured, bound.at(tick).still);
            }
        }
    }

    static constexpr std::uint8_t k_levels_mark = 0x4c;
    /// Of winds with others around or inside, after all else: those without have nothing there.
    static void levels(auto& archive, auto& cells, bool has_outer) {
        LevelState level;
        if constexpr (Reading<decltype(archive)>) {
            std::uint8_t mark = 0;
            if (!archive.at_end()) {
                archive(mark);
                archive.require(mark == k_levels_mark, "bytes follow its last field.");
            }
            if (mark == k_levels_mark)
                archive(level.pressure, level.pressure_before, level.shown_factor, level.filled, level.outer, level.outer_origin);
            archive.require(has_outer || level.outer.empty(),
                            "it was saved with an outer wind: load that first, and give it to Wind::load.");
            archive.require(!has_outer || !level.outer.empty(), "it was saved without an outer wind: load it without one.");
            if (!archive.rejected())
                archive.require(in_range(level.outer_origin) && cells.set_level_state(level),
                                "what it has of other winds is out of range.");
        } else {
            level = cells.level_state();
            if (!level.pressure.empty() || !level.outer.empty())
                archive(k_levels_mark, level.pressure, level.pressure_before, level.shown_factor, level.filled, level.outer,
                        level.outer_origin);
        }
    }

    /// All state except the config, which comes first: it creates the wind. `cells` is a cpu::Cells, or DeviceNames.
    static void state(auto& archive, Like<WindCore> auto& core, auto& cells) {
        auto& [config, rows, place, ambient, motors, obstacles, drag, source_name, sleep, speed, frames, last, log, outer, box,
               storage] = core;
        auto& [window, point, stepped, previous, follow_axes] = place;
        Tiles tiles;
        tiles.add(ambient.tile());
        archive(window.origin_cells, point, stepped.point, previous.point, stepped.origin_cells, previous.origin_cells,
                window.shifted, source_name);
        StateFields::sleep(archive, sleep);
        StateFields::speed(archive, speed);
        StateFields::ambient(archive, ambient, config, tiles);
        if constexpr (Reading<decltype(archive)>) {
            const Gusts& gusts = ambient.settings().gusts;
            archive.require(gusts.intensity == config.gusts.intensity && gusts.length == config.gusts.length,
                            "its gusts are not those of its config.");
        }
        if (sleep.asleep())
            archive(sleep.at_rest);
        StateFields::air(archive, cells.air);
        if constexpr (Reading<decltype(archive)>) {
            const std::size_t count = cells.air.velocity.size();
            cells.set_held();
            if (source_name != 0 && archive.can_hold(count, sizeof(glm::vec4)))
                for (auto* field : {&cells.source_flow, &cells.solved})
                    *field = cpu::Buffer<glm::vec4>(count);
        }
        if (source_name != 0)
            archive.cells(cells.source_flow);
        StateFields::motors(archive, motors);
        ObstacleFields::obstacles(archive, obstacles);
        DragFields::deposits(archive, drag);
        auto surface = cells.surface_history();
        ObstacleFields::surface(archive, surface, config.cells);
        if constexpr (Reading<decltype(archive)>)
            if (!archive.rejected()) {
                ObstacleFields::settle(obstacles, place.window, config.boundaries, surface.placed);
                cells.set_surface_history(std::move(surface));
            }
        auto kept = cells.kept_potential();
        archive(kept.weight, kept.cells);
        if constexpr (Reading<decltype(archive)>) {
            archive.require(kept.weight == 0.0f
                                ? kept.cells.empty()
                                : kept.weight > 0.0f && kept.weight <= 1.0f && kept.cells.size() == box.cell_count(),
                            "the potential of its last step is out of range.");
            if (!archive.rejected())
                cells.set_kept_potential(kept);
        }
        archive(last.max_speed, last.asleep); // which a wind inside this one asks for
        if constexpr (Reading<decltype(archive)>)
            archive.require(std::isfinite(last.max_speed) && last.max_speed >= 0.0f,
                            "the speed of its last step is out of range.");
        bool ticking = frames.has_value();
        archive(ticking);
        if constexpr (Reading<decltype(archive)>) {
            // The middle of a box that stands at the farthest floor is higher.
            const double farthest = k_farthest_cells * static_cast<double>(config.cell_size) + window.size().y;
            archive.require(in_range(window.origin_cells) && in_range(stepped.origin_cells) && in_range(previous.origin_cells) &&
                                in_range(point, farthest) && in_range(stepped.point, farthest) &&
                                in_range(previous.point, farthest),
                            "its box is out of range.");
            if (ticking && archive.can_hold(3 * cells.air.velocity.size(), sizeof(glm::vec4))) {
                cells.make_room({.frames = true});
                frames.emplace(AirNow{window, {}, ambient});
            }
        }
        if (!frames)
            return;
        if constexpr (std::same_as<decltype(archive), DraftWriter&>) {
            FrameHistory once = *frames;
            once.shown_before = once.shown;
            StateFields::frames(archive, std::as_const(once), cells.frames, config, tiles);
        } else {
            StateFields::frames(archive, *frames, cells.frames, config, tiles);
        }
    }
};

namespace {

Config saved_config(const WindCore& core) {
    Config config = core.config;
    if (config.gusts.tile)
        config.gusts.seed = config.gusts.tile->seed();
    return config;
}

// Bytes beside the cells, more or less.
std::size_t bytes_beside(const WindCore& core) {
    return 2048 + core.motors.slots().size() * 256 + core.obstacles.slots().size() * 128 + core.drag.slots().size() * 64;
}

} // namespace

SnapshotDraft draft_snapshot(const WindCore& core, bool fresh, const DeviceSurface& surface, const LevelState& level) {
    const std::size_t cells = core.box().cell_count();
    DraftWriter writer(7 * cells * sizeof(glm::vec4) + bytes_beside(core), cells);
    writer(saved_config(core));
    std::vector<DeviceLoad> loads;
    if (surface.load_duration > 0.0f)
        for (const PlacedObstacle& body : surface.placed)
            loads.push_back({body.slot, body.generation});
    const DeviceNames names{.air = {.fresh = fresh},
                            .surface = {.placed = surface.placed,
                                        .inside_is_air = surface.inside_is_air,
                                        .keys = surface.keys,
                                        .terms = std::vector(surface.keys.size(), DeviceState::surface_term),
                                        .shift = surface.shift,
                                        .loads = std::move(loads),
                                        .duration = surface.load_duration},
                            .level = level};
    StateFields::state(writer, core, names);
    StateFields::levels(writer, names, core.outer != nullptr);
    return std::move(writer).finish();
}

std::vector<std::byte> finish_snapshot(SnapshotDraft&& draft) {
    detail::seal(draft.bytes, k_format);
    return std::move(draft.bytes);
}

LoadedWind loaded(Wind& wind) {
    cpu::Cells& cells = wind.state().cells;
    return {.core = wind.state().core,
            .fresh = cells.air.fresh,
            .dt_old = cells.air.dt_old,
            .undiffused_time = cells.air.undiffused_time,
            .velocity = cells.air.velocity,
            .velocity_old = cells.air.velocity_old,
            .history = cells.air.history,
            .source_flow = cells.source_flow,
            .before = cells.frames.before,
            .shown = cells.frames.shown.cells,
            .shown_before = cells.frames.shown_before.cells,
            .surface = cells.surface_history(),
            .level = cells.level_state()};
}

Result<std::vector<std::byte>> Wind::save() const {
    state_->cells.materialise_all();
    const State& state = *state_;
    const WindCore& core = state.core;
    const cpu::Cells& cells = state.cells;
    const std::size_t fields = 1 + (cells.air.fresh ? 0 : 2) + (core.source_name != 0 ? 1 : 0) + (core.frames ? 3 : 0);
    return detail::where_memory_lasts([&]() -> Result<std::vector<std::byte>> {
        detail::Writer writer(fields * cells.air.velocity.size() * sizeof(glm::vec4) + bytes_beside(core));
        writer(saved_config(core));
        StateFields::state(writer, core, cells);
        StateFields::levels(writer, cells, core.outer != nullptr);
        return std::move(writer).finish(k_format);
    });
}

Result<Wind> Wind::load(std::span<const std::byte> bytes, ParallelFor parallel_for, std::shared_ptr<const Wind> outer) {
    return detail::where_memory_lasts([&]() -> Result<Wind> {
        OuterUndo undo(outer);
        const auto content = detail::unseal(bytes, k_format);
        if (!content)
            return content.failure();
        const auto rejected = [](std::string_view reason) { return Error{detail::message("snapshot cannot be used: ", reason)}; };
        detail::Reader reader(*content);
        Config config;
        reader(config);
        if (reader.rejected())
            return rejected(reader.reason());
        if (auto valid = validate(config); !valid)
            return rejected(valid.error());
        if (!reader.can_hold(Box{.cells = config.cells}.cell_count(), sizeof(glm::vec4)))
            return rejected(reader.reason());
        config.parallel_for = parallel_for;
        auto wind = make(config, outer, true); // wherever its box was when it was created
        if (!wind)
            return rejected(wind.error());
        StateFields::state(reader, wind->state().core, wind->state().cells);
        StateFields::levels(reader, wind->state().cells, outer != nullptr);
        reader.end();
        if (reader.rejected())
            return rejected(reader.reason());
        WindCore& core = wind->state().core;
        core.renew_ambient();
        if (core.config.stages.sources)
            wind->state().cells.set_drag(core.drag.cells_in(core.window(), core.config.boundaries), core.window());
        undo.succeed();
        return wind;
    });
}

} // namespace windrow
