// Log of the calls that change a wind, and its replay, to reproduce a bug or a match.
//
//     windrow::EventLog log;
//     const auto start = wind->save();             // bytes of the whole state
//     wind->record_to(&log);                       // every accepted call that changes the wind is noted from here on
//     ...
//     auto again = windrow::Wind::load(start);     // elsewhere, later
//     auto done = windrow::replay(log, *again);    // the same bits, for any number of threads on the same SIMD level
#pragma once

#include "api.h"
#include "boundaries.h"
#include "drag_field.h"
#include "motors.h"
#include "obstacles.h"
#include "result.h"

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace windrow {

class Wind;

// One struct per call, named by its effect.
struct MotorAdded {
    MotorId id; ///< what add() returned; a replay must get the same
    Motor motor;
};
struct MotorSet {
    MotorId id;
    Motor motor;
};
struct MotorMoved {
    MotorId id;
    glm::dvec3 position;
};
struct MotorRemoved {
    MotorId id;
};
struct ObstacleAdded {
    ObstacleId id; ///< what add() returned; a replay must get the same
    Obstacle obstacle;
};
struct ObstacleSet {
    ObstacleId id;
    Obstacle obstacle;
};
struct ObstacleMoved {
    ObstacleId id;
    glm::dvec3 position;
    std::optional<glm::quat> orientation; ///< where it was given
    std::optional<glm::vec3> spin{};      ///< the same
};
struct ObstacleRemoved {
    ObstacleId id;
};
struct DragAdded {
    DragId id; ///< what add() returned; a replay must get the same
    DragDeposit deposit;
};
struct DragSet {
    DragId id;
    DragDeposit deposit;
};
struct DragRemoved {
    DragId id;
};
struct Followed {
    glm::dvec3 point;
};
struct FloorSet {
    double height;
};
struct OriginShifted {
    glm::dvec3 offset; ///< [m] whole cells
};
struct AmbientSet {
    glm::vec3 ambient;
};
struct GustsSet {
    float intensity;
    float length;
    std::uint32_t seed;
    bool tile; ///< the host gave a tile, which stays without gusts too
};
struct BoundariesSet {
    Boundaries boundaries;
};
struct VelocitySet {
    std::vector<glm::vec4> field;
};
struct WindReset {};
struct Stepped {
    double dt;
};
struct Advanced {
    double dt;
};
/// A tick of the next Stepped or Advanced, on a device: what its host decided by what was read back.
struct TickRecorded {
    std::uint8_t substeps; ///< recorded
    bool limits;           ///< with the pass that cuts speeds
    bool rests;            ///< the air became ambient and sleeps
};

using Event = std::variant<MotorAdded, MotorSet, MotorMoved, MotorRemoved, ObstacleAdded, ObstacleSet, ObstacleMoved,
                           ObstacleRemoved, DragAdded, DragSet, DragRemoved, Followed, FloorSet, OriginShifted, AmbientSet,
                           GustsSet, BoundariesSet, VelocitySet, WindReset, Stepped, Advanced, TickRecorded>;

class WINDROW_API EventLog {
  public:
    /// Adds an event. Without memory the wind goes on and the log ends before this event: `complete` is false from then on, and
    /// no further event is added.
    void note(Event event) noexcept;
    void note_velocity(std::span<const glm::vec4> field) noexcept;
    [[nodiscard]] std::span<const Event> events() const { return events_; }
    /// True if the log has all events. An incomplete log is neither written nor replayed.
    [[nodiscard]] bool complete() const { return complete_; }
    void clear();

    /// The log as bytes, little-endian, with a version and a checksum. Fails for an incomplete log, and without memory.
    [[nodiscard]] Result<std::vector<std::byte>> to_bytes() const;
    /// Rejects bytes that are truncated, changed, or of another version.
    [[nodiscard]] static Result<EventLog> from_bytes(std::span<const std::byte> bytes);

  private:
    [[nodiscard]] static Result<EventLog> read(std::span<const std::byte> bytes);
    template <class Make>
    void note_made(const Make& make) noexcept;

    std::vector<Event> events_;
    bool complete_ = true;
};

/// Repeats all calls in order. `wind` must be in the state in which the log began (Wind::save, Wind::load). Stops at the first
/// call that is rejected or returns another handle; the error names it.
[[nodiscard]] WINDROW_API Result<void> replay(const EventLog& log, Wind& wind);

} // namespace windrow
