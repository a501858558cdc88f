#include "fluid/event_log.h"

#include "fluid/archive.h"
#include "fluid/wind.h"

#include <cmath>

namespace windrow {
namespace detail {

void fields(auto& archive, Like<MotorId> auto& id) {
    auto& [slot, generation, owner] = id; // a log is for any wind that starts from the same snapshot
    archive(slot, generation);
}

void fields(auto& archive, Like<MotorAdded> auto& event) {
    auto& [id, motor] = event;
    archive(id, motor);
}

void fields(auto& archive, Like<MotorSet> auto& event) {
    auto& [id, motor] = event;
    archive(id, motor);
}

void fields(auto& archive, Like<MotorMoved> auto& event) {
    auto& [id, position] = event;
    archive(id, position);
}

void fields(auto& archive, Like<MotorRemoved> auto& event) {
    auto& [id] = event;
    archive(id);
}

void fields(auto& archive, Like<Followed> auto& event) {
    auto& [point] = event;
    archive(point);
}

void fields(auto& archive, Like<FloorSet> auto& event) {
    auto& [height] = event;
    archive(height);
}

void fields(auto& archive, Like<AmbientSet> auto& event) {
    auto& [ambient] = event;
    archive(ambient);
}

void fields(auto& archive, Like<GustsSet> auto& event) {
    auto& [intensity, length, seed, tile] = event;
    archive(intensity, length, seed, tile);
}

void fields(auto& archive, Like<SidesSet> auto& event) {
    auto& [boundaries] = event;
    archive(boundaries);
}

void fields(auto& archive, Like<VelocitySet> auto& event) {
    auto& [field] = event;
    auto count = static_cast<std::uint64_t>(field.size());
    archive(count);
    if constexpr (Reading<decltype(archive)>) {
        if (!archive.can_hold(count, sizeof(glm::vec4)))
            return;
        field.resize(count);
    }
    archive.cells(field);
}

void fields(auto&, Like<WindReset> auto&) {}

void fields(auto& archive, Like<Stepped> auto& event) {
    auto& [dt] = event;
    archive(dt);
}

void fields(auto& archive, Like<Advanced> auto& event) {
    auto& [dt] = event;
    archive(dt);
}

} // namespace detail

namespace {

constexpr detail::Format k_format{"WINDLOGS", detail::Layout("events 2").with<Motor>().with<Boundaries>().version(), "event log",
                                  "EventLog::to_bytes"};

const char* name_of(const Event& event) {
    constexpr const char* k_names[] = {"add",       "set",         "move",      "remove",         "follow",
                                       "set_floor", "set_ambient", "set_gusts", "set_boundaries", "set_velocity",
                                       "reset",     "step",        "advance"};
    static_assert(std::size(k_names) == std::variant_size_v<Event>);
    return k_names[event.index()];
}

/// Makes one call again.
struct Repeat {
    Wind& wind;

    Result<void> operator()(const MotorAdded& event) const {
        const auto id = wind.motors().add(event.motor);
        if (!id)
            return Error{id.error()};
        if (*id != event.id)
            return Error{
                detail::message("the motor got slot ", id->slot, " of generation ", id->generation, ", not in slot ",
                                event.id.slot, " of generation ", event.id.generation,
                                ", so the wind was not in the state in which the log began: load the snapshot taken there.")};
        return {};
    }
    Result<void> operator()(const MotorSet& event) const { return wind.motors().set(event.id, event.motor); }
    Result<void> operator()(const MotorMoved& event) const { return wind.motors().move(event.id, event.position); }
    Result<void> operator()(const MotorRemoved& event) const { return wind.motors().remove(event.id); }
    Result<void> operator()(const Followed& event) const { return wind.follow(event.point); }
    Result<void> operator()(const FloorSet& event) const { return wind.set_floor(event.height); }
    Result<void> operator()(const AmbientSet& event) const { return wind.set_ambient(event.ambient); }
    Result<void> operator()(const GustsSet& event) const {
        const auto tile = event.tile ? GustTile::bake(event.seed) : nullptr;
        if (event.tile && !tile)
            return out_of_memory();
        return wind.set_gusts({.intensity = event.intensity, .length = event.length, .seed = event.seed, .tile = tile});
    }
    Result<void> operator()(const SidesSet& event) const { return wind.set_boundaries(event.boundaries); }
    Result<void> operator()(const VelocitySet& event) const { return wind.set_velocity(event.field); }
    Result<void> operator()(const WindReset&) const {
        wind.reset();
        return {};
    }
    Result<void> operator()(const Stepped& event) const {
        const Diagnostics report = wind.step(event.dt);
        if (report.out_of_memory)
            return out_of_memory();
        if (report.stepped)
            return {};
        return Error{detail::message("dt is ", event.dt, " s: give a finite time above 0.")};
    }
    Result<void> operator()(const Advanced& event) const {
        if (!(event.dt >= 0.0 && std::isfinite(event.dt)))
            return Error{detail::message("dt is ", event.dt, " s: give a finite time, 0 or more.")};
        if (wind.advance(event.dt).last.out_of_memory)
            return out_of_memory();
        return {};
    }

    static Error out_of_memory() { return Error{"out of memory: free some, load the snapshot and replay again."}; }
};

} // namespace

template <class Make>
void EventLog::note_made(const Make& make) noexcept {
    if (!complete_)
        return;
    try {
        events_.push_back(make());
    } catch (...) {
        complete_ = false;
    }
}

void EventLog::note(Event event) noexcept {
    note_made([&] { return std::move(event); });
}

void EventLog::note_velocity(std::span<const glm::vec4> field) noexcept {
    note_made([&] { return VelocitySet{{field.begin(), field.end()}}; });
}

void EventLog::clear() {
    events_.clear();
    complete_ = true;
}

namespace {

Result<void> check_complete(const EventLog& log) {
    if (log.complete())
        return {};
    return Error{detail::message("event log is incomplete: memory ran out after ", log.events().size(),
                                 " events; clear it and record again from a new snapshot.")};
}

} // namespace

Result<std::vector<std::byte>> EventLog::to_bytes() const {
    if (auto complete = check_complete(*this); !complete)
        return Error{complete.error()};
    return detail::where_memory_lasts([&]() -> Result<std::vector<std::byte>> {
        detail::Writer writer(64 * events_.size());
        writer(static_cast<std::uint64_t>(events_.size()));
        for (const Event& event : events_)
            writer(event);
        return std::move(writer).finish(k_format);
    });
}

Result<EventLog> EventLog::from_bytes(std::span<const std::byte> bytes) {
    return detail::where_memory_lasts([&] { return read(bytes); });
}

Result<EventLog> EventLog::read(std::span<const std::byte> bytes) {
    const auto content = detail::unseal(bytes, k_format);
    if (!content)
        return Error{content.error()};
    detail::Reader reader(*content);
    std::uint64_t count = 0;
    reader(count);
    EventLog log;
    if (reader.can_hold(count, 1)) // memory grows with what has been read
        for (std::uint64_t n = 0; n < count && !reader.rejected(); ++n)
            reader(log.events_.emplace_back());
    reader.end();
    if (reader.rejected())
        return Error{detail::message("event log cannot be used: ", reader.reason())};
    return log;
}

// Each event is copied: the wind may be recording into this very log, which then grows.
Result<void> replay(const EventLog& log, Wind& wind) {
    if (auto complete = check_complete(log); !complete)
        return complete;
    return detail::where_memory_lasts([&]() -> Result<void> {
        const std::size_t count = log.events().size();
        for (std::size_t n = 0; n < count; ++n) {
            const Event event = log.events()[n];
            if (auto done = std::visit(Repeat{wind}, event); !done)
                return Error{detail::message("event ", n, " (", name_of(event), "): ", done.error())};
        }
        return {};
    });
}

} // namespace windrow
