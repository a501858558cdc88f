#include "cases/parity_story.h"

#include "fluid/core/message.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/quaternion.hpp>
#include <memory>

namespace windrow::cases {
namespace {

using detail::message;

constexpr glm::ivec3 k_grids[] = {{16, 16, 16}, {17, 9, 23}, {32, 16, 32}, {64, 32, 64}, {128, 64, 128}};

std::string named(const char* kind, glm::ivec3 cells) {
    return message(kind, "_", cells.x, "x", cells.y, "x", cells.z);
}

/// A place in the box, as a share of it from its low corner; cells of 1 m, the box centred on `centre`.
glm::dvec3 place(glm::ivec3 cells, glm::dvec3 centre, glm::dvec3 share) {
    return centre + glm::dvec3(cells) * (share - 0.5);
}

ParityStory walk(glm::ivec3 cells) {
    const glm::dvec3 centre(0.0, 0.5 * cells.y, 0.0);
    const auto at = [&](double x, double y, double z) { return place(cells, centre, {x, y, z}); };
    return {.name = named("walk", cells),
            .text =
                "open boundaries over a floor with plants, profile, gusts, a fan, a whirl and a jet; the box follows a runner, "
                "the wind turns",
            .config = {.cells = cells,
                       .boundaries = Boundaries::open_over_floor(),
                       .centre = centre,
                       .ambient = {4.0f, 0.0f, 1.5f},
                       .profile = LogProfile{},
                       .gusts = {.intensity = 0.25f},
                       .canopy = Canopy{.height = 1.4f}},
            .motors = {{.motor = DirectionalMotor{.position = at(0.6, 0.3, 0.5), .direction = {-1.0f, 0.2f, 0.0f}}},
                       {.motor = VortexMotor{.position = at(0.35, 0.4, 0.3), .radius = 3.0f}},
                       {.motor = JetMotor{.position = at(0.2, 0.3, 0.7), .direction = {1.0f, 0.3f, 0.0f}}}},
            .walk = {3.0, 0.0, -4.0},
            .changes = {{.step = 45, .what = StoryChange::Ambient{{2.0f, 0.0f, 3.0f}}}}};
}

Boundaries mixed_sides() {
    Boundaries boundaries;
    boundaries.x_low.kind = BoundaryKind::free_slip;
    boundaries.y_low.kind = boundaries.y_high.kind = BoundaryKind::periodic;
    boundaries.z_high = {BoundaryKind::no_slip, {1.0f, 0.0f, 0.0f}};
    return boundaries;
}

ParityStory mixed(glm::ivec3 cells) {
    const auto at = [&](double x, double y, double z) { return place(cells, glm::dvec3(0.0), {x, y, z}); };
    Boundaries later = mixed_sides();
    later.y_low.kind = BoundaryKind::no_slip;
    later.y_high.kind = BoundaryKind::open;
    return {.name = named("mixed", cells),
            .text = "a wall that slips, one that drags, a periodic pair that becomes a floor; a vent, a blast, a wake",
            .config = {.cells = cells, .boundaries = mixed_sides(), .ambient = {0.0f, 1.0f, 0.0f}, .viscosity = 1e-3f},
            .motors = {{.motor = OmniMotor{.position = at(0.6, 0.5, 0.4), .speed = 3.0f}},
                       {.motor = PressureMotor{.position = at(0.3, 0.4, 0.6), .speed = 6.0f}},
                       {.motor = WakeMotor{.position = at(0.2, 0.5, 0.3), .radius = 1.0f}, .velocity = {3.0, 0.0, 1.0}}},
            .changes = {{.step = 60, .what = later}}};
}

ParityStory small(const char* name, const char* text) {
    ParityStory story{.name = name, .text = text};
    story.config.cells = {16, 12, 16};
    return story;
}

ParityStory viscous_walls() {
    ParityStory story = small("viscous_walls", "walls all round, one that moves, a viscosity that needs the direct solve");
    story.config.boundaries = Boundaries::all(BoundaryKind::no_slip);
    story.config.boundaries.y_high.wall_velocity = {3.0f, 0.0f, 0.0f};
    story.config.viscosity = 20.0f;
    story.motors = {{.motor = DirectionalMotor{.direction = {0.0f, 0.0f, 1.0f}}}};
    return story;
}

ParityStory stable_fluids() {
    ParityStory story = small("stable_fluids", "the classic scheme, open boundaries, a dust devil");
    story.config.ambient = {2.0f, 0.0f, 1.0f};
    story.config.scheme = Scheme::stable_fluids;
    story.motors = {{.motor = VortexMotor{.radius = 4.0f, .lift = 0.5f}}};
    return story;
}

ParityStory storm() {
    ParityStory story = small("storm", "winds so strong that the device must cut the step into sub-steps");
    story.config.ambient = {4.0f, 0.0f, 0.0f};
    story.steps = 24;
    story.motors = {{.motor = DirectionalMotor{.direction = {0.0f, 0.0f, 1.0f}, .law = Drive{.speed = 400.0f, .rate = 30.0f}}}};
    return story;
}

ParityStory frames_and_a_jump() {
    ParityStory story = small("frames_and_a_jump", "frames blended between ticks, gusts that change, a jump far beyond the box");
    story.config.cells = {24, 12, 20};
    story.config.ambient = {3.0f, 0.0f, 1.0f};
    story.config.gusts.intensity = 0.2f;
    story.dt = 1.0 / 72.0;
    story.frames = true;
    story.stirred = false;
    story.motors = {{.motor = JetMotor{.position = {-3.0, 0.0, 2.0}}}};
    story.walk = {5.0, 1.0, 0.0};
    story.changes = {{.step = 30, .what = Gusts{.intensity = 0.3f, .seed = 5}},
                     {.step = 70, .what = StoryChange::FollowJump{{1e6, 0.0, 5.0}}}};
    return story;
}

// Lines longer than a work group of 256, so that an invocation transforms several columns of a tile, and a count of z that no tile
// divides. First with unlike ends, whose transforms have no even and odd part.
ParityStory long_planes(const char* name, const char* text, int z) {
    ParityStory story = small(name, text);
    story.config.cells = {270, 2, z};
    story.config.boundaries = mixed_sides();
    story.config.ambient = {0.0f, 1.0f, 0.0f};
    story.steps = 24;
    story.motors = {{.motor = JetMotor{.position = {-100.0, 0.0, 0.0}}}, {.motor = VortexMotor{.position = {90.0, 0.0, 0.0}}}};
    story.changes = {{.step = 12, .what = Boundaries{}}};
    return story;
}

// 1890 cells: both axes in one pass on every device, of 128 invocations too.
ParityStory whole_long_planes() {
    return long_planes("whole_long_planes", "planes that fit in shared memory, of lines longer than a work group", 7);
}

// 9990 cells, which no tile holds.
ParityStory split_long_planes() {
    return long_planes("split_long_planes", "planes in tiles that do not divide them, of lines longer than a work group", 37);
}

// Planes of 9216 cells fit in no tile, so that the transforms of x and z go apart.
ParityStory every_pass() {
    ParityStory story =
        small(k_every_pass_story, "each kind of pass: planes too large for shared memory, an implicit viscosity, a "
                                  "blast, cut speeds, shifts, a wind that changes");
    story.config.cells = {96, 4, 96};
    story.config.ambient = {2.0f, 0.0f, 1.0f};
    story.config.viscosity = 20.0f;
    story.config.max_substeps = 2;
    story.steps = 6;
    story.motors = {{.motor = OmniMotor{.position = {2.0, 0.0, 3.0}, .speed = 3.0f}},
                    {.motor = DirectionalMotor{.direction = {0.0f, 0.0f, 1.0f}, .law = Force{.acceleration = 20000.0f}}}};
    story.walk = {30.0, 0.0, -10.0};
    story.changes = {{.step = 3, .what = StoryChange::Ambient{{1.0f, 0.0f, 2.0f}}}};
    return story;
}

// A house, a fence across the wind, a room of plates and a ball that flies over them.
ParityStory obstacles() {
    ParityStory story =
        small(k_obstacles_story, "a house, a fence and a closed room on rough ground in gusts and a profile, and a ball that "
                                 "flies; the box follows, a wall comes");
    story.config.cells = {20, 12, 18};
    story.config.centre = {0.0, 6.0, 0.0};
    story.config.boundaries = Boundaries::open_over_floor();
    story.config.ambient = {4.0f, 0.0f, 1.0f};
    story.config.profile = LogProfile{};
    story.config.gusts = {.intensity = 0.2f};
    story.config.roughness.emplace(Roughness{.length = 0.1f});
    story.config.pressure_solves = 2;
    story.steps = 40;
    story.walk = {1.5, 0.0, 0.5};
    const auto turned = [](glm::vec3 axis, float angle) { return glm::angleAxis(angle, axis); };
    constexpr float k_quarter = 1.57079633f;
    const glm::vec3 x(1.0f, 0.0f, 0.0f), y(0.0f, 1.0f, 0.0f);
    story.obstacles = {
        {.obstacle = {.position = {-4.0, 2.0, 3.0}, .orientation = turned(y, 0.3f), .shape = Block{{1.6f, 2.0f, 1.8f}}}},
        {.obstacle = {.position = {4.0, 1.5, -5.0}, .orientation = turned(y, 1.1f), .shape = Plate{{2.5f, 1.5f}}}},
        {.obstacle = {.position = {-6.0, 7.0, -2.0}, .shape = Sphere{1.7f}}, .velocity = {6.0, 0.0, 1.0}},
        {.obstacle = {.position = {-1.0, 4.0, -6.0}, .shape = Block{{0.6f, 4.0f, 2.0f}}}, .step = 12}};
    for (const double side : {-1.0, 1.0}) {
        story.obstacles.push_back({.obstacle = {.position = {3.0 + 2.0 * side, 2.0, 4.0},
                                                .orientation = turned(y, k_quarter),
                                                .shape = Plate{{2.1f, 2.1f}}}});
        story.obstacles.push_back({.obstacle = {.position = {3.0, 2.0, 4.0 + 2.0 * side}, .shape = Plate{{2.1f, 2.1f}}}});
    }
    story.obstacles.push_back(
        {.obstacle = {.position = {3.0, 4.0, 4.0}, .orientation = turned(x, k_quarter), .shape = Plate{{2.1f, 2.1f}}}});
    return story;
}

// Hills of two lengths of roughness under a sheared wind, a fan, a viscosity of one pass; the box follows.
ParityStory rough_hills() {
    ParityStory story = small("rough_hills", "rough hills, the roughness by a map, a profile, a fan, viscosity; the box follows");
    const auto map = [](const std::function<float(glm::vec2)>& value) {
        return std::make_shared<const HeightMap>(*HeightMap::create({41, 41}, 1.0f, value));
    };
    story.config.boundaries = Boundaries::open_over_floor();
    story.config.centre = {0.0, 6.0, 0.0};
    story.config.ambient = {5.0f, 0.0f, 2.0f};
    story.config.profile = LogProfile{};
    story.config.viscosity = 0.5f;
    story.config.pressure_solves = 2;
    story.config.roughness =
        Roughness{.longest_mixing = 2.0f,
                  .map = RoughnessMap{.lengths = map([](glm::vec2 place) { return place.x < 20.0f ? 0.01f : 0.3f; }),
                                      .position = {-20.0, 0.0, -20.0}}};
    story.steps = 40;
    story.walk = {3.0, 0.0, 1.0};
    story.motors = {{.motor = DirectionalMotor{.position = {1.0, 5.0, 0.0}, .direction = {0.0f, -0.5f, 1.0f}}}};
    const auto hills = map([](glm::vec2 place) { return 2.0f + 1.3f * std::sin(0.5f * place.x) * std::cos(0.4f * place.y); });
    story.obstacles = {{.obstacle = {.position = {-20.0, 0.0, -20.0}, .shape = Ground{hills}}}};
    return story;
}

// Rows of a third of a metre that grow to three, over a rough hill with a house, a fence across the wind and a ball that flies.
ParityStory rows() {
    ParityStory story =
        small(k_rows_story, "rows thin at the floor and thick aloft: gusts, a profile, plants, a rough hill, a house, a "
                            "fence, a ball that flies, a fan, a blast; the box follows, its floor rises");
    story.config.cells = {18, 16, 20};
    story.config.boundaries = Boundaries::open_over_floor();
    story.config.rows = Rows{.first = 0.35f, .uniform = 4, .ratio = 1.2f};
    story.config.max_cfl = 8.0f; // one sub-step: around bodies that move all recorded ones run, which depends on what has come in
    story.config.centre = {0.0, 9.0, 0.0};
    story.config.ambient = {4.0f, 0.0f, 1.5f};
    story.config.profile = LogProfile{};
    story.config.gusts = {.intensity = 0.2f};
    story.config.canopy = Canopy{.height = 0.9f};
    story.config.roughness.emplace(Roughness{.length = 0.1f});
    story.config.viscosity = 0.02f;
    story.config.pressure_solves = 2;
    story.steps = 40;
    story.walk = {2.0, 0.0, -1.0};
    story.motors = {{.motor = DirectionalMotor{.position = {1.0, 2.0, 0.0}, .direction = {-0.5f, 0.5f, 1.0f}}},
                    {.motor = OmniMotor{.position = {-3.0, 6.0, 3.0}, .speed = 2.0f}}};
    const auto hill = std::make_shared<const HeightMap>(*HeightMap::create(
        {41, 41}, 1.0f, [](glm::vec2 place) { return 1.0f + 0.8f * std::sin(0.4f * place.x) * std::cos(0.3f * place.y); }));
    story.obstacles = {{.obstacle = {.position = {-20.0, 0.0, -20.0}, .shape = Ground{hill}}},
                       {.obstacle = {.position = {-4.0, 2.0, 3.0},
                                     .orientation = glm::angleAxis(0.3f, glm::vec3(0.0f, 1.0f, 0.0f)),
                                     .shape = Block{{1.6f, 2.0f, 1.8f}}}},
                       {.obstacle = {.position = {4.0, 1.5, -5.0},
                                     .orientation = glm::angleAxis(1.1f, glm::vec3(0.0f, 1.0f, 0.0f)),
                                     .shape = Plate{{2.5f, 2.5f}}}},
                       {.obstacle = {.position = {-6.0, 7.0, -2.0}, .shape = Sphere{1.7f}}, .velocity = {6.0, 0.0, 1.0}}};
    story.changes = {{.step = 25, .what = StoryChange::Floor{1.6}}};
    return story;
}

// A closed box of rows, in which a thick viscosity is solved for; its walls drag.
ParityStory viscous_rows() {
    ParityStory story =
        small("viscous_rows", "rows of unequal thickness between walls that drag, an implicit viscosity, no open boundary");
    story.config.cells = {14, 20, 12};
    story.config.boundaries = Boundaries::all(BoundaryKind::no_slip);
    story.config.boundaries.y_high.wall_velocity = {3.0f, 0.0f, 1.0f};
    story.config.rows = Rows{.first = 0.3f, .uniform = 2, .ratio = 1.15f};
    story.config.ambient = glm::vec3(0.0f);
    story.config.viscosity = 2.0f;
    story.config.pressure_solves = 2;
    story.steps = 30;
    story.obstacles = {{.obstacle = {.position = {1.0, 1.0, 0.0}, .shape = Sphere{2.0f}, .surface = Surface::no_slip}}};
    return story;
}

} // namespace

std::vector<ParityStory> parity_stories() {
    std::vector<ParityStory> stories;
    for (const glm::ivec3 cells : k_grids)
        for (const auto story : {walk, mixed})
            stories.push_back(story(cells));
    for (const auto story : {viscous_walls, stable_fluids, storm, frames_and_a_jump, whole_long_planes, split_long_planes,
                             obstacles, rough_hills, rows, viscous_rows, every_pass})
        stories.push_back(story());
    return stories;
}

ParityStory shortened(ParityStory story, double cell_steps) {
    constexpr int k_fewest = 2; // the second has a history
    const auto cells = static_cast<double>(Box{.cells = story.config.cells}.cell_count());
    const int whole = story.steps;
    story.steps = std::clamp(static_cast<int>(cell_steps / cells), std::min(k_fewest, story.steps), story.steps);
    for (StoryChange& change : story.changes) // at their share of the way
        change.step = change.step * story.steps / whole;
    for (StoryObstacle& one : story.obstacles)
        one.step = one.step * story.steps / whole;
    return story;
}

} // namespace windrow::cases
