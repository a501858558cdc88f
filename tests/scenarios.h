// The scenario table: each feature of a wind alone, with all else at its default, and random combinations of them. Tests play the
// rows on the CPU, on a device, and through save and load.
#pragma once

#include "tests/scenario_parts.h"

namespace windrow::test {

/// Each feature alone. Not `whole`: of the shapes in turn one that rests, one that moves and one that turns.
inline std::vector<Scenario> scenarios(bool whole) {
    using scenario_parts::must;
    std::vector<Scenario> rows;
    int number = 0;
    for (const scenario_parts::NamedShape& shape : scenario_parts::scenario_shapes()) {
        for (const Way way : {Way::rests, Way::moves, Way::turns})
            if (whole || static_cast<int>(way) == number % 3)
                rows.push_back(scenario_parts::obstacle_scenario(shape, way, {-3.0, 0.2, 1.0}));
        ++number;
    }
    for (const bool whole_turns : {false, true}) { // a propeller, which two poses do not tell; and one that respawns
        const auto shape = scenario_parts::NamedShape{whole_turns ? "propeller" : "respawn", Block{{2.4f, 0.7f, 0.9f}}};
        Scenario row = scenario_parts::obstacle_scenario(shape, Way::rests, {-3.0, 0.2, 1.0});
        row.step = [=](WindControl& wind, int n) {
            if (whole_turns)
                must(wind.obstacles().move(obstacle_id(), {-3.0, 0.2, 1.0}, glm::angleAxis(0.3f, glm::vec3(0.0f, 1.0f, 0.0f)),
                                           {0.0f, 0.0f, 3.0f}));
            else
                must(wind.obstacles().move(obstacle_id(), {n % 8 < 4 ? -3.0 : 4.0, 0.2, 1.0 - 0.02 * n}));
        };
        rows.push_back(row);
    }
    rows.push_back({.name = "hills", .begin = [](WindControl& wind) { must(wind.obstacles().add(scenario_parts::hills())); }});
    rows.push_back({.name = "hills_in_rows",
                    .config =
                        [](Config& c) {
                            c.boundaries = Boundaries::open_over_floor();
                            c.rows = Rows{.first = 0.35f, .uniform = 4, .ratio = 1.2f};
                        },
                    .begin =
                        [](WindControl& wind) {
                            must(wind.obstacles().add(scenario_parts::hills({-40.0, 0.0, -40.0})));
                        }});
    rows.push_back({.name = "tiles",
                    .begin =
                        [](WindControl& wind) {
                            must(wind.obstacles().add(scenario_parts::tile_of_hills({-40, -40}, {1, 40})));
                            must(wind.obstacles().add(scenario_parts::tile_of_hills({1, 3}, {40, 40})));
                        },
                    .step =
                        [](WindControl& wind, int n) {
                            must(wind.follow(glm::dvec3(0.15, 0.0, -0.1) * (n + 1.0)));
                            if (n == 6) // one that comes late, and one that is replaced
                                must(wind.obstacles().add(scenario_parts::tile_of_hills({1, -40}, {40, 3})));
                            if (n == 9)
                                must(wind.obstacles().set(obstacle_id(1), scenario_parts::tile_of_hills({1, 3}, {40, 40}, 0.4)));
                        }});
    rows.push_back({.name = "house_of_pieces", // one of which goes, and another moves away
                    .begin =
                        [](WindControl& wind) {
                            for (int n = 0; n < 8; ++n)
                                must(wind.obstacles().add({.position = glm::dvec3(n & 1, n >> 1 & 1, n >> 2) * 1.7 + 0.31,
                                                           .shape = Block{glm::vec3(0.85f)}}));
                        },
                    .step =
                        [](WindControl& wind, int n) {
                            must(wind.follow(glm::dvec3(0.15, 0.0, -0.1) * (n + 1.0)));
                            if (n == 6)
                                must(wind.obstacles().remove(obstacle_id(7)));
                            if (n >= 9)
                                must(wind.obstacles().move(obstacle_id(0), glm::dvec3(0.31 - 0.05 * (n - 8), 0.31, 0.31)));
                        }});
    rows.push_back(
        {.name = "house_with_a_wing", // an L whose roof overlaps it; a cart of two blocks passes its wall
         .begin =
             [](WindControl& wind) {
                 const auto add = [&](glm::dvec3 low, glm::dvec3 high) {
                     must(wind.obstacles().add({.position = 0.5 * (low + high), .shape = Block{glm::vec3(0.5 * (high - low))}}));
                 };
                 add({-2.3, 0.0, -2.1}, {1.7, 3.0, 0.4});
                 add({-2.3, 0.0, 0.4}, {-0.2, 2.6, 3.9});
                 add({-1.9, 2.5, -1.8}, {1.3, 4.2, 0.1});
                 add({1.7, 0.0, 0.6}, {3.7, 1.0, 1.9});
                 add({2.1, 1.0, 0.7}, {3.2, 2.2, 1.8});
             },
         .step =
             [](WindControl& wind, int n) {
                 must(wind.follow(glm::dvec3(0.15, 0.0, -0.1) * (n + 1.0)));
                 must(wind.obstacles().move(obstacle_id(3), glm::dvec3(2.7 - 0.04 * (n + 1), 0.5, 1.25)));
                 must(wind.obstacles().move(obstacle_id(4), glm::dvec3(2.65 - 0.04 * (n + 1), 1.6, 1.25)));
                 if (n == 9)
                     must(wind.obstacles().remove(obstacle_id(2)));
             }});
    rows.push_back({.name = "ground_with_holes", // a cellar and a trench
                    .begin =
                        [](WindControl& wind) {
                            Obstacle hills = scenario_parts::hills();
                            HeightData data = std::get<Ground>(hills.shape).heights->data();
                            data.holes = {.cells = {20, 20}, .open = std::vector<std::uint8_t>(400)};
                            for (const int cell : {10 * 20 + 9, 12 * 20 + 10, 12 * 20 + 11, 12 * 20 + 12})
                                data.holes.open[static_cast<std::size_t>(cell)] = 1;
                            std::get<Ground>(hills.shape).heights = heights_of(std::move(data));
                            must(wind.obstacles().add(hills));
                        },
                    .step = [](WindControl& wind, int n) { must(wind.follow(glm::dvec3(0.15, 0.0, -0.1) * (n + 1.0))); }});
    rows.push_back(
        {.name = "bar_through_the_box_moves", // whose cuts of the boundaries are closed too
         .config = [](Config& c) { c.viscosity = 0.5f; },
         .begin =
             [](WindControl& wind) {
                 must(wind.obstacles().add(
                     {.position = {0.0, 0.3, 0.4}, .shape = Block{{100.0f, 1.3f, 1.6f}}, .surface = Surface::no_slip}));
             },
         .step =
             [](WindControl& wind, int n) {
                 must(wind.obstacles().move(obstacle_id(), {0.0, 0.3 - 0.02 * n, 0.4}));
             }});
    rows.push_back({.name = "floor", .config = [](Config& c) { c.boundaries = Boundaries::open_over_floor(); }});
    rows.push_back({.name = "profile", .config = [](Config& c) { c.profile = LogProfile{}; }});
    rows.push_back({.name = "gusts", .config = [](Config& c) { c.gusts.intensity = 0.2f; }});
    rows.push_back({.name = "rough_ground", .config = [](Config& c) {
                        c.boundaries = Boundaries::open_over_floor();
                        c.profile = LogProfile{};
                        c.roughness = Roughness{};
                    }});
    rows.push_back({.name = "canopy", .config = [](Config& c) {
                        c.boundaries = Boundaries::open_over_floor();
                        c.canopy = Canopy{};
                    }});
    rows.push_back({.name = "rows", .config = [](Config& c) {
                        c.boundaries = Boundaries::open_over_floor();
                        c.rows = Rows{};
                    }});
    rows.push_back({.name = "stable_fluids",
                    .config = [](Config& c) { c.scheme = Scheme::stable_fluids; },
                    .begin = [](WindControl& wind) { must(wind.motors().add(DirectionalMotor{})); }});
    rows.push_back({.name = "linear",
                    .config = [](Config& c) { c.interpolation = Interpolation::linear; },
                    .begin = [](WindControl& wind) { must(wind.motors().add(DirectionalMotor{})); }});
    rows.push_back({.name = "viscous",
                    .config = [](Config& c) { c.viscosity = 0.5f; },
                    .begin = [](WindControl& wind) { must(wind.motors().add(DirectionalMotor{})); }});
    const std::pair<const char*, Motor> motors[] = {{"directional", DirectionalMotor{}},
                                                    {"omni", OmniMotor{}},
                                                    {"vortex", VortexMotor{}},
                                                    {"jet", JetMotor{.turbulence = {.intensity = 0.1f}}},
                                                    {"pressure", PressureMotor{}}};
    for (const auto& [name, motor] : motors)
        rows.push_back({.name = name, .begin = [motor = motor](WindControl& wind) { must(wind.motors().add(motor)); }});
    rows.push_back({.name = "wake",
                    .begin =
                        [](WindControl& wind) {
                            must(wind.motors().add(WakeMotor{.position = {-6.0, 0.0, 0.0}}));
                        },
                    .step =
                        [](WindControl& wind, int n) {
                            must(wind.motors().move(motor_id(), {-6.0 + 0.12 * (n + 1), 0.0, 0.02 * n}));
                        }});
    rows.push_back({.name = "shift",
                    .begin = [](WindControl& wind) { must(wind.motors().add(DirectionalMotor{})); },
                    .step =
                        [](WindControl& wind, int n) {
                            must(wind.follow({0.11 * n, 0.03 * n, -0.07 * n}));
                        }});
    for (const std::string name : {"drag", "drag_in_gusts", "drag_in_rows", "drag_of_stable_fluids", "drag_over_rough_ground",
                                   "drag_walk", "drag_walk_in_calm_air"})
        rows.push_back(scenario_parts::drag_scenario(name));
    // A host whose world floats: box, bodies, wakes, ground and gusts move with it.
    rows.push_back({.name = "shifted_origin",
                    .config =
                        [](Config& c) {
                            c.boundaries = Boundaries::open_over_floor();
                            c.profile = LogProfile{};
                            c.gusts.intensity = 0.2f;
                        },
                    .begin =
                        [](WindControl& wind) {
                            must(wind.motors().add(WakeMotor{.position = {-6.0, 3.0, 0.0}}));
                            must(wind.obstacles().add({.position = {1.0, 4.0, -0.5}, .shape = Block{{1.2f, 0.7f, 0.9f}}}));
                            must(wind.obstacles().add({.position = {-3.0, 2.0, 3.0}, .shape = Sphere{1.1f}}));
                        },
                    .step =
                        [](WindControl& wind, int n) {
                            const glm::dvec3 way(37.0, 2.0, -64.0);
                            if (n % 10 == 5)
                                must(wind.shift_origin(way));
                            const glm::dvec3 origin = static_cast<double>((n + 5) / 10) * way;
                            must(wind.motors().move(motor_id(), origin + glm::dvec3(-6.0 + 0.12 * (n + 1), 3.0, 0.02 * n)));
                            must(wind.obstacles().move(obstacle_id(), origin + glm::dvec3(1.0, 4.0, -0.5 + 0.03 * n)));
                            must(wind.follow(origin + glm::dvec3(0.11 * n, 0.0, -0.07 * n)));
                        }});
    rows.push_back({.name = "rising_floor",
                    .config = [](Config& c) { c.boundaries = Boundaries::open_over_floor(); },
                    .begin =
                        [](WindControl& wind) {
                            must(wind.motors().add(DirectionalMotor{.position = {0.0, 3.0, 0.0}}));
                        },
                    .step = [](WindControl& wind, int n) { must(wind.set_floor(0.05 * n)); }});
    rows.push_back(
        {.name = "turning_wind", .step = [](WindControl& wind, int n) {
             must(wind.set_ambient({6.0f - 0.03f * static_cast<float>(n), 0.0f, 1.0f + 0.02f * static_cast<float>(n)}));
         }});
    rows.push_back(
        {.name = "sides_that_change", // beside a house, which the flow of a source meets
         .begin =
             [](WindControl& wind) {
                 must(wind.motors().add(DirectionalMotor{}));
                 must(wind.motors().add(OmniMotor{.position = {4.0, 1.0, -2.0}}));
                 must(wind.obstacles().add({.position = {-3.0, 0.2, 1.0}, .shape = Block{{1.2f, 1.6f, 0.9f}}}));
             },
         .step =
             [](WindControl& wind, int n) {
                 if (n % 20 == 15)
                     must(wind.set_boundaries(n % 40 == 15 ? Boundaries{.z_low = {BoundaryKind::free_slip}} : Boundaries{}));
             }});
    // Sub-steps, of which each has its own place of the body and its sources.
    rows.push_back({.name = "fast_air_in_small_cells",
                    .config =
                        [](Config& c) {
                            c.cell_size = 0.25f;
                            c.ambient = {25.0f, 0.0f, 3.0f};
                            c.gusts.intensity = 0.1f;
                        },
                    .begin =
                        [](WindControl& wind) {
                            must(wind.obstacles().add({.position = {-0.8, 0.1, 0.3}, .shape = Sphere{0.45f}}));
                            must(wind.obstacles().add({.position = {0.7, -0.2, -0.4}, .shape = Plate{{0.5f, 0.6f}}}));
                            must(wind.motors().add(PressureMotor{.position = {0.2, 0.5, 0.5}, .radius = 0.6f}));
                        },
                    .step =
                        [](WindControl& wind, int n) {
                            must(wind.obstacles().move(obstacle_id(), {-0.8 + 0.012 * (n + 1), 0.1, 0.3}));
                        },
                    .steps = 40, // its sources take a software device half a second each
                    .chaotic = true});
    // A drive is what moves the air fastest: how far reads reach past a body of 3.4 cells counts it.
    Scenario driven =
        scenario_parts::obstacle_scenario({"block_beside_drives", Block{{2.0f, 2.5f, 1.7f}}}, Way::moves, {-4.0, 0.3, 2.0});
    driven.begin = [placed = driven.begin](WindControl& wind) {
        placed(wind);
        must(wind.motors().add(DirectionalMotor{}));
        must(wind.motors().add(PressureMotor{}));
    };
    driven.steps = 12;
    rows.push_back(std::move(driven));
    // What a body leaves between two sub-steps of the very first tick has a past, that of the first sub-step.
    rows.push_back({.name = "ball_moves_in_sub_steps_at_once",
                    .config = [](Config& c) { c.max_cfl = 0.2f; },
                    .begin =
                        [](WindControl& wind) {
                            must(wind.obstacles().add({.position = {-4.0, 0.1, 0.2}, .shape = Sphere{2.4f}}));
                        },
                    .step =
                        [](WindControl& wind, int n) {
                            must(wind.obstacles().move(obstacle_id(), {-4.0 + 0.4 * (n + 1), 0.1, 0.2}));
                        },
                    .steps = 8});
    // Bodies below four cells read one-sidedly, as far as the fastest air: one that moves from the first step on, which is rehearsed.
    rows.push_back(
        {.name = "small_ball_moves_from_the_start",
         .config =
             [](Config& c) {
                 c.ambient = {-16.26f, 0.0f, 11.83f};
             },
         .begin =
             [](WindControl& wind) {
                 must(wind.obstacles().add({.position = {0.02, 0.13, 0.06}, .shape = Sphere{1.94f}}));
             },
         .step = [](WindControl& wind,
                    int n) { must(wind.obstacles().move(obstacle_id(), glm::dvec3(0.02 - 0.447 * (n + 1.0), 0.13, 0.06))); },
         .steps = 8});
    // It closes faces in some sub-steps and none in others.
    rows.push_back({.name = "ball_smaller_than_a_cell_beside_a_vent",
                    .config =
                        [](Config& c) {
                            c.ambient = {0.0f, 0.0f, 0.0f};
                            for (Boundary* side : {&c.boundaries.x_low, &c.boundaries.x_high, &c.boundaries.y_low})
                                side->kind = BoundaryKind::free_slip;
                        },
                    .begin =
                        [](WindControl& wind) {
                            must(wind.obstacles().add({.position = {1.0, 0.0, 0.0}, .shape = Sphere{0.3f}}));
                            must(wind.motors().add(OmniMotor{.position = {-1.0, 0.0, 1.0}, .speed = 6.0f}));
                        },
                    .step =
                        [](WindControl& wind, int n) {
                            must(wind.obstacles().move(obstacle_id(), {0.5 - 0.5 * n, 0.0, 0.1 * (n + 1.0)}));
                        },
                    .steps = 8});
    // What a body leaves takes the lee of the air beside it.
    rows.push_back(
        {.name = "lee_behind_a_ball_that_moves",
         .config =
             [](Config& c) {
                 c.boundaries = Boundaries::open_over_floor();
                 c.profile = LogProfile{};
                 c.roughness = Roughness{};
                 c.canopy = Canopy{.height = 2.0f};
             },
         .begin =
             [](WindControl& wind) {
                 must(wind.obstacles().add({.position = {4.0, 1.2, -1.0}, .shape = Sphere{1.3f}}));
             },
         .step =
             [](WindControl& wind, int n) {
                 must(wind.obstacles().move(obstacle_id(), glm::dvec3(4.0 - 0.4 * (n + 1.0), 1.2, -1.0 + 0.1 * (n + 1.0))));
                 must(wind.follow(glm::dvec3(-0.15, 0.0, 0.05) * static_cast<double>(n)));
             },
         .steps = 24});
    // Sealed air: a piston that fills a tube, and a closed box in which bodies move.
    rows.push_back({.name = "piston",
                    .begin =
                        [](WindControl& wind) {
                            const auto add = [&](glm::dvec3 at, glm::vec3 half) {
                                must(wind.obstacles().add({.position = at, .shape = Block{half}}));
                            };
                            add({-5.0, 0.0, 0.0}, {2.3f, 2.2f, 2.2f}); // the piston
                            for (const double side : {-3.0, 3.0}) {
                                add({0.0, side, 0.0}, {9.0f, 1.0f, 4.0f});
                                add({0.0, 0.0, side}, {9.0f, 2.0f, 1.0f});
                            }
                            add({9.0, 0.0, 0.0}, {1.0f, 4.0f, 4.0f});
                        },
                    .step =
                        [](WindControl& wind, int n) {
                            must(wind.obstacles().move(obstacle_id(), {-5.0 + 0.03 * (n + 1), 0.0, 0.0}));
                        },
                    .steps = 40});
    rows.push_back({.name = "closed_box",
                    .config =
                        [](Config& c) {
                            c.boundaries = Boundaries::all(BoundaryKind::free_slip);
                            c.gusts.intensity = 0.2f;
                        },
                    .begin =
                        [](WindControl& wind) {
                            must(wind.obstacles().add({.position = {-4.0, 2.0, 0.0}, .shape = Sphere{2.3f}}));
                            must(wind.obstacles().add({.position = {-2.0, 1.0, 1.0}, .shape = Block{{3.0f, 2.0f, 2.0f}}}));
                        },
                    .step =
                        [](WindControl& wind, int n) {
                            must(wind.obstacles().move(obstacle_id(), {-4.0, 2.0 + 0.04 * (n + 1), 0.0}));
                        },
                    .steps = 40});
    rows.push_back({.name = "sleep",
                    .config =
                        [](Config& c) {
                            c.ambient = glm::vec3(0.0f);
                            c.relaxation_time = 0.3f; // else it takes 20 s
                        },
                    .begin =
                        [](WindControl& wind) {
                            must(wind.motors().add(DirectionalMotor{.envelope = {.attack = 0.0f, .hold = 0.3f, .decay = 0.1f}}));
                        },
                    .late = true});
    return rows;
}

/// A thick and a thin body that rests, moves or turns, with gusts and without, in the open, in rows, over hills and over hills in rows.
/// One in `every` of them.
inline std::vector<Scenario> matrix_of_motion(int every) {
    std::vector<Scenario> rows;
    int number = 0;
    for (const char* const kind : {"block", "thin_wall"})
        for (const Way way : {Way::rests, Way::moves, Way::turns})
            for (const bool gusts : {false, true})
                for (const bool own_rows : {false, true})
                    for (const bool hills : {false, true}) {
                        if (number++ % every != 0)
                            continue;
                        const auto shapes = scenario_parts::scenario_shapes();
                        const auto shape = *std::find_if(shapes.begin(), shapes.end(),
                                                         [&](const auto& each) { return each.name == std::string(kind); });
                        Scenario row = scenario_parts::obstacle_scenario(shape, way, {-3.0, own_rows ? 3.0 : 0.2, 1.0});
                        row.name =
                            "matrix_" + row.name + (gusts ? "_gusts" : "") + (own_rows ? "_rows" : "") + (hills ? "_hills" : "");
                        row.steps = 12;
                        row.config = [=](Config& c) {
                            c.gusts.intensity = gusts ? 0.2f : 0.0f;
                            if (!own_rows)
                                return;
                            c.boundaries = Boundaries::open_over_floor();
                            c.rows = Rows{.first = 0.35f, .uniform = 4, .ratio = 1.2f};
                        };
                        if (hills)
                            row.begin = [=, body = row.begin](WindControl& wind) {
                                body(wind);
                                scenario_parts::must(
                                    wind.obstacles().add(scenario_parts::hills({-40.0, own_rows ? -0.5 : -4.0, -40.0})));
                            };
                        rows.push_back(std::move(row));
                    }
    return rows;
}

/// Some features at once: obstacles of two kinds that rest, move or turn, and others by chance.
inline std::vector<Scenario> random_scenarios(int count) {
    std::vector<Scenario> rows;
    const auto shapes = scenario_parts::scenario_shapes();
    for (int number = 0; number < count; ++number) {
        std::mt19937 random(1000 + static_cast<unsigned>(number));
        const auto pick = [&](std::size_t most) { return random() % most; };
        std::vector<Scenario> parts;
        const auto& first = shapes[pick(shapes.size())];
        const auto& second = shapes[pick(shapes.size())];
        parts.push_back(scenario_parts::obstacle_scenario(first, static_cast<Way>(pick(3)), {-4.0, 0.3, 2.0}, 0));
        parts.push_back(scenario_parts::obstacle_scenario(second, static_cast<Way>(pick(3)), {4.0, -0.4, -2.5}, 1));
        for (Scenario& row : scenarios(false))
            for (const char* const name : {"profile", "gusts", "rough_ground", "canopy", "rows", "directional", "omni", "vortex",
                                           "jet", "pressure", "turning_wind"})
                if (row.name == name && pick(3) == 0)
                    parts.push_back(std::move(row));
        if (pick(3) == 0)
            parts.push_back(scenario_parts::drag_scenario("drag"));
        Scenario both{.name = "random_" + std::to_string(number)};
        for (const Scenario& part : parts)
            both.name += "_" + part.name;
        both.config = [parts](Config& c) {
            for (const Scenario& part : parts)
                if (part.config)
                    part.config(c);
        };
        both.begin = [parts](WindControl& wind) {
            for (const Scenario& part : parts)
                if (part.begin)
                    part.begin(wind);
        };
        both.step = [parts](WindControl& wind, int n) {
            for (const Scenario& part : parts)
                if (part.step)
                    part.step(wind, n);
        };
        rows.push_back(std::move(both));
    }
    return rows;
}

} // namespace windrow::test
