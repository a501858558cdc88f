// Stories for two winds told alike, one on the CPU and one on a device: what the parity of the backends is measured on.
#pragma once

#include "fluid/wind.h"

#include <glm/vec3.hpp>
#include <string>
#include <variant>
#include <vector>

namespace windrow::cases {

/// A motor that is there from the start.
struct StoryMotor {
    Motor motor;
    /// [m/s] Its velocity; a wake acts only while it moves.
    glm::dvec3 velocity{0.0};
};

/// An obstacle that is added before the step of that number.
struct StoryObstacle {
    Obstacle obstacle;
    glm::dvec3 velocity{0.0}; ///< [m/s] from then on
    int step = 0;
};

/// What a host asks for in the midst of a story, before the step of that number (0 is the first).
struct StoryChange {
    struct Ambient {
        glm::vec3 mean; ///< [m/s]
    };
    struct FollowJump {
        glm::dvec3 by; ///< [m] of the point that the box follows
    };
    struct Floor {
        double height; ///< [m]
    };
    int step = 0;
    std::variant<Ambient, FollowJump, Boundaries, Gusts, Floor> what{};
};

struct ParityStory {
    std::string name{}; ///< of small letters, digits and underscores
    std::string text{}; ///< what it holds, one line
    Config config{};
    /// [s] Of a step.
    double dt = 1.0 / 30.0;
    int steps = 100;
    /// Frames of dt by Wind::advance and Wind::record, blended between ticks; else steps of dt.
    bool frames = false;
    /// A smooth field at the start, of speeds of about 1 m/s beside the mean wind; else the mean wind alone.
    bool stirred = true;
    std::vector<StoryMotor> motors{};
    std::vector<StoryObstacle> obstacles{};
    /// [m/s] Velocity of the point that the box follows, from Config::centre on; 0: it is not asked to follow.
    glm::dvec3 walk{0.0};
    std::vector<StoryChange> changes{};
    /// Largest difference after the first step and after any step, over the largest component of the CPU's velocity at that
    /// moment. A step's rounding is some 1e-7 of it, which a hundred steps of chaotic flow stretch.
    double first_bound = 1e-5;
    double bound = 1e-4;
};

/// The story of parity_stories() that runs each kind of pass but those around obstacles: what is enough where a run is slow, as under GPU-assisted
/// validation on a software device, which compiles a pass for seconds.
inline constexpr const char* k_every_pass_story = "every_pass";
/// The story that runs those around obstacles.
inline constexpr const char* k_obstacles_story = "obstacles";
/// The story of a box with rows of its own, whose floor rises.
inline constexpr const char* k_rows_story = "rows";

/// The five grids 16^3, 32x16x32, 64x32x64, 17x9x23 and 128x64x128, smallest first, each with two stories: a walk over a floor
/// (profile, gusts, a fan, a whirl, a jet, shifts, a turning wind) and a box of mixed sides (walls that slip and drag, a periodic
/// pair, a blast, a wake, sides that change). Then, on small grids: viscosity, the classic scheme, a storm in sub-steps, frames
/// blended between ticks, planes of long lines that fit in shared memory or do not, obstacles, each kind of pass.
[[nodiscard]] std::vector<ParityStory> parity_stories();

/// The story with so few steps, two at least, and its changes at their share of the way, that it takes no more than `cell_steps`
/// updates of a cell: for a software device.
[[nodiscard]] ParityStory shortened(ParityStory story, double cell_steps);

} // namespace windrow::cases
