// Replay of an event log on a wind of either kind: the calls of windrow::Wind, and a Time that makes its steps.
#pragma once

#include "fluid/core/message.h"
#include "fluid/event_log.h"
#include "fluid/wind.h"

#include <cmath>
#include <iterator>

namespace windrow::detail {

inline const char* name_of(const Event& event) {
    constexpr const char* k_names[] = {"add",
                                       "set",
                                       "move",
                                       "remove",
                                       "add_obstacle",
                                       "set_obstacle",
                                       "move_obstacle",
                                       "remove_obstacle",
                                       "add_drag",
                                       "set_drag",
                                       "remove_drag",
                                       "follow",
                                       "set_floor",
                                       "shift_origin",
                                       "set_ambient",
                                       "set_gusts",
                                       "set_boundaries",
                                       "set_velocity",
                                       "reset",
                                       "step",
                                       "advance",
                                       "tick"};
    static_assert(std::size(k_names) == std::variant_size_v<Event>);
    return k_names[event.index()];
}

/// Makes one call again.
template <class Wind, class Time>
struct Repeat {
    Wind& wind;
    const Time& time;

    Result<void> operator()(const MotorAdded& event) const {
        return same_handle("motor", wind.motors().add(event.motor), event.id);
    }
    Result<void> operator()(const MotorSet& event) const { return wind.motors().set(event.id, event.motor); }
    Result<void> operator()(const MotorMoved& event) const { return wind.motors().move(event.id, event.position); }
    Result<void> operator()(const MotorRemoved& event) const { return wind.motors().remove(event.id); }
    Result<void> operator()(const ObstacleAdded& event) const {
        return same_handle("obstacle", wind.obstacles().add(event.obstacle), event.id);
    }
    Result<void> operator()(const ObstacleSet& event) const { return wind.obstacles().set(event.id, event.obstacle); }
    Result<void> operator()(const ObstacleMoved& event) const {
        Obstacles& obstacles = wind.obstacles();
        if (event.orientation && event.spin)
            return obstacles.move(event.id, event.position, *event.orientation, *event.spin);
        return event.orientation ? obstacles.move(event.id, event.position, *event.orientation)
                                 : obstacles.move(event.id, event.position);
    }
    Result<void> operator()(const ObstacleRemoved& event) const { return wind.obstacles().remove(event.id); }
    Result<void> operator()(const DragAdded& event) const {
        return same_handle("deposit", wind.drag().add(event.deposit), event.id);
    }
    Result<void> operator()(const DragSet& event) const { return wind.drag().set(event.id, event.deposit); }
    Result<void> operator()(const DragRemoved& event) const { return wind.drag().remove(event.id); }
    Result<void> operator()(const Followed& event) const { return wind.follow(event.point); }
    Result<void> operator()(const OriginShifted& event) const { return wind.shift_origin(event.offset); }
    Result<void> operator()(const FloorSet& event) const { return wind.set_floor(event.height); }
    Result<void> operator()(const AmbientSet& event) const { return wind.set_ambient(event.ambient); }
    Result<void> operator()(const GustsSet& event) const {
        const auto tile = event.tile ? GustTile::bake(event.seed) : nullptr;
        if (event.tile && !tile)
            return out_of_memory();
        return wind.set_gusts({.intensity = event.intensity, .length = event.length, .seed = event.seed, .tile = tile});
    }
    Result<void> operator()(const BoundariesSet& event) const { return wind.set_boundaries(event.boundaries); }
    Result<void> operator()(const VelocitySet& event) const { return wind.set_velocity(event.field); }
    Result<void> operator()(const WindReset&) const {
        wind.reset();
        return {};
    }
    Result<void> operator()(const Stepped& event) const {
        const auto report = time.step(event.dt);
        if (!report)
            return report.failure();
        if (report->out_of_memory)
            return out_of_memory();
        if (report->stepped)
            return {};
        return Error{message("dt is ", event.dt, " s: give a finite time above 0.")};
    }
    Result<void> operator()(const Advanced& event) const {
        if (!(event.dt >= 0.0 && std::isfinite(event.dt)))
            return Error{message("dt is ", event.dt, " s: give a finite time, 0 or more.")};
        const auto done = time.advance(event.dt);
        if (!done)
            return done.failure();
        if (done->last.out_of_memory)
            return out_of_memory();
        return {};
    }
    Result<void> operator()(const TickRecorded& event) const {
        time.record(event);
        return {};
    }

    template <class Id>
    static Result<void> same_handle(const char* what, const Result<Id>& id, Id expected) {
        if (!id)
            return id.failure();
        if (*id == expected)
            return {};
        return Error{message("the ", what, " got slot ", id->slot, " of generation ", id->generation, ", not in slot ",
                             expected.slot, " of generation ", expected.generation,
                             ", so the wind was not in the state in which the log began: load the snapshot taken there.")};
    }
    static Error out_of_memory() {
        return Error{"out of memory: free some, load the snapshot and replay again.", Fault::out_of_memory};
    }
};

inline Result<void> check_complete(const EventLog& log) {
    if (log.complete())
        return {};
    return Error{message("event log is incomplete: memory ran out after ", log.events().size(),
                         " events; clear it and record again from a new snapshot.")};
}

/// `time` has step(dt) and advance(dt), which return a Result of Diagnostics and Advance, and record(TickRecorded). Each event is
/// copied: the wind may be recording into this very log, which then grows.
template <class Wind, class Time>
Result<void> replay(const EventLog& log, Wind& wind, const Time& time) {
    if (auto complete = check_complete(log); !complete)
        return complete;
    return where_memory_lasts([&]() -> Result<void> {
        const std::size_t count = log.events().size();
        for (std::size_t n = 0; n < count; ++n) {
            const Event event = log.events()[n];
            if (auto done = std::visit(Repeat<Wind, Time>{wind, time}, event); !done)
                return done.failure().after(message("event ", n, " (", name_of(event), "): "));
        }
        return {};
    });
}

} // namespace windrow::detail
