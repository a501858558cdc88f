// What a host did to a wind, call by call, and how to do it again: so that a bug or a match can be reproduced.
//
//     windrow::EventLog log;
//     const auto start = wind->save();             // bytes of the whole state
//     wind->record_to(&log);                       // every accepted call that changes the wind is noted from here on
//     ...
//     auto again = windrow::Wind::load(start);     // elsewhere, later
//     auto done = windrow::replay(log, *again);    // the same bits, for any number of threads on the same SIMD level
#pragma once

#include "fluid/boundaries.h"
#include "fluid/motors.h"
#include "fluid/result.h"

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace windrow {

class Wind;

// One struct a call, named by what was done.
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
struct Followed {
    glm::dvec3 point;
};
struct FloorSet {
    double height;
};
struct AmbientSet {
    glm::vec3 ambient;
};
struct GustsSet {
    float intensity;
    float length;
    std::uint32_t seed;
    bool tile; ///< a tile was handed in, which stands without gusts too
};
struct SidesSet {
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

using Event = std::variant<MotorAdded, MotorSet, MotorMoved, MotorRemoved, Followed, FloorSet, AmbientSet, GustsSet, SidesSet,
                           VelocitySet, WindReset, Stepped, Advanced>;

class EventLog {
  public:
    /// Adds an event. Where memory is missing the wind goes on and the log ends before this event: `complete` is false from then
    /// on, and nothing more is noted.
    void note(Event event) noexcept;
    void note_velocity(std::span<const glm::vec4> field) noexcept;
    [[nodiscard]] std::span<const Event> events() const { return events_; }
    /// All that happened is noted. An incomplete log is neither written nor replayed.
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

/// Does everything again, in order. `wind` must be in the state in which the log began (Wind::save, Wind::load). Stops at the
/// first call that is rejected or whose handle comes out otherwise, and says which.
[[nodiscard]] Result<void> replay(const EventLog& log, Wind& wind);

} // namespace windrow
