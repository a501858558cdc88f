// A story: a wind and all that happens to it. Random ones look for faults, shrunk ones are told again.
//
// Motors are named by their turn: `which` counts the motors that were added and are not removed, the first 0, modulo their
// number; where there is none, nothing happens. So a story from which an event was taken is still a story.
#pragma once

#include "fluid/wind.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace windrow::test {

namespace story {

/// The air at the beginning.
struct StartAir {
    enum class Pattern : std::uint8_t { ambient, white, smooth, shear };
    Pattern kind = Pattern::ambient;
    float speed = 1.0f; ///< [m/s]
    std::uint32_t seed = 1;
    /// Without its divergence, as a step leaves it: an energy to compare with.
    bool projected = false;
};

struct Steps {
    int count = 1;
    double dt = 0.1; ///< [s]
};
/// Calls of `advance`.
struct Advances {
    int count = 1;
    double dt = 0.1; ///< [s]
};
struct Add {
    Motor motor;
};
/// `Motors::set`.
struct Replace {
    int which = 0;
    Motor motor;
};
struct Move {
    int which = 0;
    glm::dvec3 position{0.0}; ///< [m]
};
struct Remove {
    int which = 0;
};
struct Follow {
    glm::dvec3 point{0.0}; ///< [m]
};
/// Where the low y side is solid; else nothing happens.
struct Floor {
    double height = 0.0; ///< [m]
};
struct ChangeSides {
    Boundaries boundaries;
};
struct ChangeAmbient {
    glm::vec3 ambient{0.0f}; ///< [m/s]
};
struct ChangeGusts {
    Gusts gusts;
};
/// One component of a cell becomes no number; `cell` counts modulo the cells.
struct Break {
    int cell = 0;
    float value = 0.0f;
};
/// The wind goes on from its own snapshot.
struct SaveAndLoad {};
struct Reset {};

using Event = std::variant<Steps, Advances, Add, Replace, Move, Remove, Follow, Floor, ChangeSides, ChangeAmbient, ChangeGusts,
                           Break, SaveAndLoad, Reset>;

} // namespace story

struct Story {
    Config config;
    story::StartAir start;
    std::vector<story::Event> events;
};

[[nodiscard]] inline Story story_of(Config config, story::StartAir start, std::vector<story::Event> events) {
    return {std::move(config), start, std::move(events)};
}

/// As C++ that can be pasted into told_stories_test.cpp: a call of story_of.
[[nodiscard]] std::string text_of(const Story& story);
/// What rapidcheck calls.
void showValue(const Story& story, std::ostream& stream);

/// What must hold of a story beside what must hold of all.
struct Claims {
    /// Nothing acts, the wind outside is still: the energy never passes this share of the start's.
    std::optional<double> energy_of_start{};
};

/// What came out. Ratios as in watch.h.
struct StoryOutcome {
    std::string fault; ///< the first thing that does not hold; empty where all does
    int steps = 0;
    double energy = 0.0; ///< largest energy over that of all the box's air at the input speed (input.h), or over the start's
    double max = 0.0;    ///< largest |u| over the input speed, or over the start's
};

/// Tells a story to two winds at once, one on one thread that is saved and loaded where the story says so, one on three threads
/// that is not, and asks of every step:
///   every cell holds a number; energy and largest speed are within their bounds; the report says what was done; both winds hold
///   the same bits.
[[nodiscard]] StoryOutcome tell(const Story& story, const Claims& claims = {});

} // namespace windrow::test
