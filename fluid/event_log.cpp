#include "fluid/event_log.h"

#include "fluid/core/archive.h"
#include "fluid/core/replay.h"
#include "fluid/core/shape_record.h"
#include "fluid/wind.h"

namespace windrow {
namespace detail {

template <class T, class... Kinds>
concept LikeOneOf = (Like<T, Kinds> || ...);

// Without the owner: a log is for any wind that starts from the same snapshot.
void fields(auto& archive, LikeOneOf<MotorId, ObstacleId, DragId> auto& id) {
    auto& [slot, generation, owner] = id;
    archive(slot, generation);
}

void fields(auto& archive, LikeOneOf<MotorRemoved, ObstacleRemoved, DragRemoved, Followed, FloorSet, OriginShifted, AmbientSet,
                                     BoundariesSet, Stepped, Advanced> auto& event) {
    auto& [field] = event;
    archive(field);
}

void fields(auto& archive,
            LikeOneOf<MotorAdded, MotorSet, MotorMoved, ObstacleAdded, ObstacleSet, DragAdded, DragSet> auto& event) {
    auto& [id, field] = event;
    archive(id, field);
}

void fields(auto& archive, Like<ObstacleMoved> auto& event) {
    auto& [id, position, orientation, spin] = event;
    archive(id, position, orientation, spin);
}

void fields(auto& archive, Like<GustsSet> auto& event) {
    auto& [intensity, length, seed, tile] = event;
    archive(intensity, length, seed, tile);
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

void fields(auto& archive, Like<TickRecorded> auto& event) {
    auto& [substeps, limits, rests] = event;
    archive(substeps, limits, rests);
}

} // namespace detail

namespace {

constexpr detail::Format k_format{
    "WINDLOGS", detail::Layout("events 8").with<Motor>().with<Obstacle>().with<DragDeposit>().with<Boundaries>().version(),
    "event log", "EventLog::to_bytes"};

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

Result<std::vector<std::byte>> EventLog::to_bytes() const {
    if (auto complete = detail::check_complete(*this); !complete)
        return complete.failure();
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
        return content.failure();
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

namespace {

// Time of a wind on the CPU; what a device recorded is nothing to it.
struct OwnTime {
    Wind& wind;
    [[nodiscard]] Result<Diagnostics> step(double dt) const { return wind.step(dt); }
    [[nodiscard]] Result<Advance> advance(double dt) const { return wind.advance(dt); }
    void record(const TickRecorded&) const {}
};

} // namespace

Result<void> replay(const EventLog& log, Wind& wind) {
    return detail::replay(log, wind, OwnTime{wind});
}

} // namespace windrow
