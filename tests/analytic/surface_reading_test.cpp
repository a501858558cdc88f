// What is sampled beside surfaces: where the wind itself is the same, it does not depend on where the surface cuts the cells.
#include "tests/scenarios.h"
#include "tests/tier.h"
#include "tests/winds.h"

#include <glm/gtc/matrix_transform.hpp>

namespace windrow {
namespace {

using namespace test;

constexpr float k_wind = 6.0f; // [m/s]

// Ground whose height is a function of the place [m] from its middle, in the world's middle.
Obstacle ground(const std::function<float(glm::vec2)>& height, float half = 64.0f, float spacing = 0.5f) {
    const int corners = static_cast<int>(2.0f * half / spacing) + 1;
    auto map = HeightMap::create({corners, corners}, spacing, [&](glm::vec2 place) { return height(place - half); });
    EXPECT_TRUE(map) << map.error();
    return {.position = glm::dvec3(-half, 0.0, -half), .shape = Ground{std::make_shared<const HeightMap>(*std::move(map))}};
}

Config open_air(glm::vec3 ambient) {
    return {.cells = {24, 20, 24}, .boundaries = Boundaries::open_over_floor(), .ambient = ambient};
}

Wind over(const Config& config, const Obstacle& obstacle, int steps = 3) {
    Wind wind = made(config);
    EXPECT_TRUE(wind.obstacles().add(obstacle));
    for (int n = 0; n < steps; ++n)
        (void)wind.step(1.0 / 60.0);
    return wind;
}

std::vector<Config> equal_and_thin_rows(const Config& config) {
    Config rows = config;
    rows.rows = Rows{.first = 0.5f, .uniform = 16, .ratio = 1.1f};
    return {config, rows};
}

// A steady wind along a ground, a roof or a wall that goes through the box is a solution, and stays itself to rounding: everywhere in a
// box of all defaults, wherever the surface cuts the cells. What came in through the whole of a cell at the box's edge and went on
// through a part made up to 18 % of the wind.
TEST(SurfaceReading, AWindAlongWhatGoesThroughTheBoxStaysItself) {
    std::vector<std::pair<std::string, Obstacle>> bodies;
    for (int n = 0; n < 10; ++n) {
        const float level = -4.0f + 0.1f * static_cast<float>(n);
        bodies.push_back({"plain at " + std::to_string(n) + " tenths", ground([=](glm::vec2) { return level; })});
    }
    const float along = 200.0f; // [m]
    const Shape bars[] = {Block{{along, 2.3f, 1.7f}}, Block{{along, 3.0f, 0.2f}},
                          MeshShape{mesh_of(box_mesh({along, 2.3f, 1.7f}))},
                          Capsule{.half_axis = {along, 0.0f, 0.0f}, .radius = 2.1f}};
    for (int n = 0; n < 8; ++n)
        for (const Shape& bar : bars)
            bodies.push_back(
                {"bar " + std::to_string(bodies.size()),
                 {.position = {0.0, 0.37 * n, 0.21 * n},
                  .orientation = glm::angleAxis(n < 4 ? 0.0f : 0.4f * static_cast<float>(n), glm::vec3(1.0f, 0.0f, 0.0f)),
                  .shape = bar}});
    double worst = 0.0;
    for (const auto& [name, body] : bodies) {
        const bool level = std::holds_alternative<Ground>(body.shape);
        const glm::vec3 ambient(k_wind, 0.0f, level ? 0.5f * k_wind : 0.0f);
        for (const float viscosity : {0.0f, 0.5f}) { // it slips
            Wind wind = made({.ambient = ambient, .viscosity = viscosity});
            ASSERT_TRUE(wind.obstacles().add(body)) << name;
            for (int n = 0; n < sampled(600, 60); ++n)
                (void)wind.advance(1.0 / 60.0);
            double here = 0.0;
            const glm::quat turn = glm::inverse(body.orientation);
            for (double z = -15.7; z < 16.0; z += 1.3)
                for (double y = -7.9; y < 8.0; y += 0.35)
                    for (double x = -15.9; x < 16.0; x += 1.7) {
                        const glm::vec3 own = turn * glm::vec3(glm::dvec3(x, y, z) - body.position);
                        if (detail::distance_to(body.shape, own, 1.0f) > 0.01f)
                            here = std::max(here, static_cast<double>(glm::distance(wind.velocity({x, y, z}), ambient) / k_wind));
                    }
            EXPECT_LE(here, 1e-4) << name << ", viscosity " << viscosity;
            worst = std::max(worst, here);
        }
    }
    WINDROW_EXPECT_FIGURE("surface_reading/steady_wind_along", worst, 1e-4);
}

TEST(SurfaceReading, LevelGroundReadsAlikeAtAnyHeightInACell) {
    double worst = 0.0;
    for (const Config& config : equal_and_thin_rows(open_air({k_wind, 0.0f, 0.0f})))
        for (int n = 0; n < 10; ++n) {
            const float level = 2.0f + 0.1f * static_cast<float>(n);
            const Wind wind = over(config, ground([&](glm::vec2) { return level; }));
            for (const float place : {0.3f, 0.5f, 1.7f}) {
                const auto at = [&](float d) { return wind.velocity({place, level + d, 0.4f}).x; };
                for (const float d : {0.02f, 0.1f, 0.3f, 0.5f, 0.75f})
                    worst = std::max(worst, static_cast<double>(std::abs(at(d) / at(1.0f) - 1.0f)));
            }
        }
    WINDROW_EXPECT_FIGURE("surface_reading/level", worst, 0.01);
}

TEST(SurfaceReading, SlopesReadAlikeAlongTheirContours) {
    double along_axis = 0.0, spread = 0.0, turned = 0.0;
    for (const float steepness : {0.1f, 0.25f, 0.5f, 1.0f})
        for (const float angle : {0.0f, 90.0f, 20.0f, 45.0f, 70.0f}) {
            const glm::vec2 up(std::cos(glm::radians(angle)), std::sin(glm::radians(angle)));
            const glm::vec3 wind_along = k_wind * glm::vec3(-up.y, 0.0f, up.x);
            const auto height = [&](glm::vec2 at) { return 9.0f + steepness * glm::dot(at, up); };
            const Wind wind = over(open_air(wind_along), ground(height));
            const bool axis = angle == 0.0f || angle == 90.0f;
            double least = 1e9, most = 0.0;
            for (const float d : {0.05f, 0.15f, 0.3f, 0.5f})
                for (int n = 0; n < 40; ++n) {
                    const glm::vec2 at = (static_cast<float>(n) - 20.0f) * 0.17f * up;
                    const float y = height(at);
                    const auto read = [&](float over) {
                        return static_cast<double>(glm::dot(wind.velocity({at.x, y + over, at.y}), wind_along)) /
                               (k_wind * k_wind);
                    };
                    const double off = std::abs(read(d) / read(d + 1.0f) - 1.0);
                    (axis ? along_axis : turned) = std::max(axis ? along_axis : turned, off);
                    least = std::min(least, read(d));
                    most = std::max(most, read(d));
                }
            if (axis)
                spread = std::max(spread, most - least);
        }
    WINDROW_EXPECT_FIGURE("surface_reading/slope", along_axis, 0.01);
    WINDROW_EXPECT_FIGURE("surface_reading/slope_spread", spread, 0.01);
    WINDROW_EXPECT_FIGURE("surface_reading/turned_slope", turned, 0.02);
}

TEST(SurfaceReading, TheLogLawIsItselfOverFloorPlainsAndSlopes) {
    double worst = 0.0;
    for (const float length : {0.003f, 0.03f, 0.1f})
        for (const float steepness : {-1.0f, 0.0f, 0.1f, 0.5f, 1.0f})
            for (int part = 0; part < (steepness == 0.0f ? 10 : 1); ++part) {
                Config config = open_air({k_wind, 0.0f, 0.0f});
                config.roughness = Roughness{.length = length};
                const auto height = [&](glm::vec2 at) {
                    return steepness < 0.0f ? 0.0f : 6.0f + 0.1f * static_cast<float>(part) + steepness * at.y;
                };
                Wind wind = made(config);
                if (steepness >= 0.0f) {
                    ASSERT_TRUE(wind.obstacles().add(ground(height)));
                }
                (void)wind.step(1e-3);
                const auto law = [&](float d) {
                    return k_wind * std::log(1.0f + std::max(d, 0.0f) / length) / std::log(1.0f + 10.0f / length);
                };
                wind.set_velocity([&](glm::dvec3 at) {
                    return glm::vec3(law(static_cast<float>(at.y) - height({at.x, at.z})), 0.0f, 0.0f);
                });
                for (const float d : {0.05f, 0.1f, 0.2f, 0.35f, 0.5f, 0.8f, 1.0f})
                    for (int n = 0; n < 20; ++n) {
                        const glm::vec2 at(0.31f * static_cast<float>(n) - 3.0f, 0.17f * static_cast<float>(n) - 2.0f);
                        const float u = wind.velocity({at.x, height(at) + d, at.y}).x;
                        worst = std::max(worst, static_cast<double>(std::abs(u / law(d) - 1.0f)));
                    }
            }
    WINDROW_EXPECT_FIGURE("surface_reading/log_law", worst, 0.005);
}

TEST(SurfaceReading, ALinearShearGoesThroughTheGroundThatItSticksTo) {
    double worst = 0.0;
    for (int part = 0; part < 10; ++part) {
        const float level = 2.0f + 0.1f * static_cast<float>(part);
        Obstacle plain = ground([&](glm::vec2) { return level; });
        plain.surface = Surface::no_slip;
        Wind wind = over(open_air({k_wind, 0.0f, 0.0f}), plain, 1);
        wind.set_velocity([&](glm::dvec3 at) { return glm::vec3(at.y - level, 0.0f, 0.0f); });
        for (const float d : {0.05f, 0.1f, 0.3f, 0.5f, 0.9f})
            worst = std::max(worst, static_cast<double>(std::abs(wind.velocity({0.3, level + d, 0.2}).x / d - 1.0f)));
    }
    WINDROW_EXPECT_FIGURE("surface_reading/shear", worst, 0.005);
}

// Mean and rms deviation over places of the body in a cell, of winds [over k_wind] at places beside it.
struct Spread {
    std::vector<glm::dvec3> sums;
    std::vector<double> squares;
    int count = 0;

    void add(const std::vector<glm::dvec3>& winds) {
        sums.resize(winds.size(), glm::dvec3(0.0));
        squares.resize(winds.size(), 0.0);
        ++count;
        for (std::size_t n = 0; n < winds.size(); ++n) {
            sums[n] += winds[n];
            squares[n] += glm::dot(winds[n], winds[n]);
        }
    }
    [[nodiscard]] double rms() const {
        double sum = 0.0;
        for (std::size_t n = 0; n < sums.size(); ++n)
            sum += squares[n] / count - glm::dot(sums[n], sums[n]) / (count * count);
        return std::sqrt(std::max(sum, 0.0) / static_cast<double>(sums.size()));
    }
    [[nodiscard]] glm::dvec3 mean() const {
        glm::dvec3 sum(0.0);
        for (const glm::dvec3& one : sums)
            sum += one;
        return sum / (static_cast<double>(count) * static_cast<double>(sums.size()));
    }
};

// Never along the cells' faces: such a surface cuts no cell.
constexpr int k_shifts = 8;
glm::dvec3 shift_of(int n) {
    return glm::dvec3((3 * n) % 8, (5 * n + 2) % 8, (7 * n + 1) % 8) / 8.0 + 0.0625;
}

std::vector<glm::dvec3> winds_at(const Wind& wind, const std::vector<glm::dvec3>& places) {
    std::vector<glm::dvec3> winds;
    for (const glm::dvec3& place : places)
        winds.emplace_back(glm::dvec3(wind.velocity(place)) / static_cast<double>(k_wind));
    return winds;
}

// Winds a tenth of a cell and one cell above the windward half of a hill or a ridge, in sixteenths of a cell along all axes.
struct HillWinds {
    double rms = 0.0, worst = 0.0, one_cell_above = 0.0;
};
HillWinds over_hill(bool is_ridge) {
    const auto shape = [&](glm::vec2 at) {
        const float r2 = is_ridge ? at.x * at.x : glm::dot(at, at);
        return 4.0f * std::exp(-r2 / 50.0f);
    };
    Spread near, off;
    std::vector<std::vector<glm::dvec3>> all;
    for (int n = 0; n < k_shifts; ++n) {
        Obstacle hill = ground(shape);
        hill.position += shift_of(n) + glm::dvec3(0.0, 3.0, 0.0);
        Config config = open_air({k_wind, 0.0f, 0.0f});
        config.cells = {40, 20, 32};
        const Wind wind = over(config, hill, 40);
        std::vector<glm::dvec3> low, high;
        for (int i = -24; i <= 0; ++i)
            for (int k = -6; k <= 6; k += 2) {
                const glm::vec2 at(0.4f * static_cast<float>(i), 0.5f * static_cast<float>(k));
                const glm::dvec3 place = glm::dvec3(at.x, 3.0f + shape(at), at.y) + shift_of(n);
                low.push_back(place + glm::dvec3(0.0, 0.1, 0.0));
                high.push_back(place + glm::dvec3(0.0, 1.0, 0.0));
            }
        all.push_back(winds_at(wind, low));
        near.add(all.back());
        off.add(winds_at(wind, high));
    }
    HillWinds found{.rms = near.rms(), .one_cell_above = off.rms()};
    for (const auto& winds : all)
        for (std::size_t n = 0; n < winds.size(); ++n)
            found.worst = std::max(found.worst, glm::length(winds[n] - near.sums[n] / static_cast<double>(near.count)));
    return found;
}

TEST(SurfaceReading, HillsReadAlikeWhereverTheyStandInTheCells) {
    const HillWinds hill = over_hill(false), ridge = over_hill(true);
    WINDROW_EXPECT_FIGURE("surface_reading/hill", hill.rms, std::max(0.06, 2.0 * hill.one_cell_above));
    WINDROW_EXPECT_FIGURE("surface_reading/hill_worst", hill.worst, 0.35);
    WINDROW_EXPECT_FIGURE("surface_reading/ridge", ridge.rms, std::max(0.06, 2.0 * ridge.one_cell_above));
    WINDROW_EXPECT_FIGURE("surface_reading/ridge_worst", ridge.worst, 0.35);
}

// The air leaves at the front edges, so that on a grid three times finer, whose sides are between cells, the two places are .5 apart.
TEST(SurfaceReading, RoofsAndSideWallsReadAsTheAirBesideThem) {
    Spread roof, over_roof, side, beside;
    for (int n = 0; n < k_shifts; ++n) {
        const glm::dvec3 shift = shift_of(n);
        Config config = open_air({k_wind, 0.0f, 0.0f});
        config.cells = {40, 20, 32};
        const Wind wind = over(config, {.position = glm::dvec3(0.0, 2.0, 0.0) + shift, .shape = Block{{4.0f, 5.0f, 4.0f}}}, 40);
        const auto read = [&](glm::dvec3 first, glm::dvec3 step, glm::dvec3 off) {
            std::vector<glm::dvec3> places;
            for (int m = 0; m < 13; ++m)
                places.push_back(first + static_cast<double>(m) * step + off + shift);
            return winds_at(wind, places);
        };
        const glm::dvec3 up(0.0, 1.0, 0.0), out(0.0, 0.0, 1.0), along(0.25, 0.0, 0.0);
        roof.add(read({-1.5, 7.0, 0.0}, along, 0.1 * up));
        over_roof.add(read({-1.5, 7.0, 0.0}, along, up));
        side.add(read({-1.5, 3.0, 4.0}, along, 0.1 * out));
        beside.add(read({-1.5, 3.0, 4.0}, along, out));
    }
    WINDROW_EXPECT_FIGURE("surface_reading/roof", glm::length(roof.mean() - over_roof.mean()), 0.15);
    WINDROW_EXPECT_FIGURE("surface_reading/roof_rms", roof.rms(), 1.4 * over_roof.rms());
    WINDROW_EXPECT_FIGURE("surface_reading/side", glm::length(side.mean() - beside.mean()), 0.15);
    WINDROW_EXPECT_FIGURE("surface_reading/side_rms", side.rms(), 1.4 * beside.rms());
}

// The wind around a ball in a wind U, and that of a ball that moves with -U less U.
glm::dvec3 around_ball(glm::dvec3 place, double radius, glm::dvec3 wind) {
    const double r = glm::length(place);
    const glm::dvec3 n = place / r;
    return wind + 0.5 * std::pow(radius / r, 3.0) * (wind - 3.0 * glm::dot(wind, n) * n);
}

// rms error a tenth of a cell off the ball's front, over its speed; `raw`: of the air's own cells.
struct BallError {
    double shown = 0.0, raw = 0.0;
};
BallError ball_error(float diameter, bool moves) {
    const int cells = static_cast<int>(6.0f * diameter), shifts = 4;
    const glm::vec3 speed{k_wind, 0.0f, 0.0f};
    double shown = 0.0, raw = 0.0;
    int count = 0;
    for (int n = 0; n < shifts; ++n) {
        const glm::dvec3 shift = glm::dvec3(0.3, 0.45, 0.2) + 0.25 * static_cast<double>(n);
        Config config{.cells = glm::ivec3(cells), .ambient = moves ? glm::vec3(0.0f) : speed, .pressure_solves = 8};
        Wind wind = made(config);
        const auto ball = wind.obstacles().add({.position = shift, .shape = Sphere{0.5f * diameter}});
        EXPECT_TRUE(ball);
        const double dt = 1e-2;
        glm::dvec3 centre = shift;
        for (int step = 0; step < 3; ++step) {
            if (moves) {
                centre -= dt * glm::dvec3(speed);
                EXPECT_TRUE(wind.obstacles().move(*ball, centre));
            }
            (void)wind.step(dt);
        }
        const WindView view = wind.view();
        const WindView own(view.box(), view.window(), view.blend_zone(), view.ambient(), view.field());
        for (int a = 0; a < 12; ++a)
            for (int b = 1; b < 6; ++b) { // the front
                const double angle = 2.0 * pi * a / 12, polar = 0.5 * pi * b / 6;
                const glm::dvec3 out(-std::cos(polar), std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle));
                const double radius = 0.5 * static_cast<double>(diameter);
                const glm::dvec3 place = (radius + 0.1) * out;
                const glm::dvec3 truth = around_ball(place, radius, speed) - (moves ? glm::dvec3(speed) : glm::dvec3(0.0));
                const auto off = [&](const WindView& from) {
                    const glm::dvec3 error = glm::dvec3(from.velocity(centre + place)) - truth;
                    return glm::dot(error, error);
                };
                shown += off(view);
                raw += off(own);
                ++count;
            }
    }
    return {std::sqrt(shown / count) / static_cast<double>(k_wind), std::sqrt(raw / count) / static_cast<double>(k_wind)};
}

TEST(SurfaceReading, ABallReadsAsPotentialFlowHasIt) {
    const BallError coarse = ball_error(4.0f, false), fine = ball_error(8.0f, false);
    WINDROW_EXPECT_FIGURE("surface_reading/ball_4", coarse.shown, 0.32);
    WINDROW_EXPECT_FIGURE("surface_reading/ball_8", fine.shown, 0.22);
    EXPECT_LT(fine.shown, coarse.shown);
    const BallError moving = ball_error(8.0f, true);
    WINDROW_EXPECT_FIGURE("surface_reading/moving_ball", moving.shown, 2.0 / 3.0 * moving.raw);
    figure("surface_reading/ball_8_own_cells", fine.raw);
}

TEST(SurfaceReading, TheLogLawStaysInAPeriodicBox) {
    constexpr float k_length = 0.03f;
    double worst = 0.0;
    for (const bool floor : {true, false}) {
        Config config{.cells = {8, 20, 8}, .ambient = {k_wind, 0.0f, 0.0f}, .profile = LogProfile{.roughness_length = k_length}};
        config.boundaries = Boundaries::all(BoundaryKind::periodic);
        config.boundaries.y_low = {BoundaryKind::free_slip};
        config.boundaries.y_high = {BoundaryKind::open};
        config.roughness = Roughness{.length = k_length};
        config.follow_axes = glm::bvec3(false);
        Wind wind = made(config);
        for (int n = 0; n < sampled(1200, 400); ++n)
            (void)wind.step(1.0 / 60.0);
        const float up = wind.velocity({0.0, 1.0, 0.0}).x;
        for (const float d : {0.05f, 0.1f, 0.2f, 0.5f, 1.5f}) {
            const double law =
                std::log(1.0 + static_cast<double>(d / k_length)) / std::log(1.0 + 1.0 / static_cast<double>(k_length));
            worst = std::max(worst, std::abs(static_cast<double>(wind.velocity({0.3, d, 0.2}).x / up) / law - 1.0));
        }
        if (!floor)
            break;
    }
    WINDROW_EXPECT_FIGURE("surface_reading/log_law_stepped", worst, 0.03);
}

// The cells themselves, snapshots and the steps after them do not know that anybody reads.
TEST(SurfaceReading, ChangesNoBitOfTheAir) {
    for (const bool frames : {false, true}) {
        Config config = open_air({k_wind, 0.0f, 1.0f});
        config.roughness = Roughness{};
        config.gusts.intensity = 0.1f;
        std::vector<Wind> winds;
        for (int n = 0; n < 2; ++n) {
            winds.push_back(made(config));
            ASSERT_TRUE(winds.back().obstacles().add(test::scenario_parts::hills({-40.0, 1.0, -40.0})));
            ASSERT_TRUE(winds.back().obstacles().add({.position = {0.0, 8.0, 0.0}, .shape = Sphere{2.0f}}));
        }
        for (int n = 0; n < 12; ++n)
            for (std::size_t one = 0; one < 2; ++one) {
                Wind& wind = winds[one];
                ASSERT_TRUE(wind.follow({0.3 * n, 0.0, 0.1 * n}));
                ASSERT_TRUE(wind.obstacles().move({.slot = 1, .generation = 1}, {0.05 * n, 8.0, 0.0}));
                if (frames)
                    (void)wind.advance(1.0 / 50.0);
                else
                    (void)wind.step(1.0 / 50.0);
                if (one == 1) {
                    EXPECT_GE(glm::length(wind.velocity({0.2, 2.0, 0.1})), 0.0f);
                    EXPECT_GE(glm::length(wind.previous_view().velocity({0.2, 2.0, 0.1})), 0.0f);
                }
            }
        EXPECT_EQ(*winds[0].save(), *winds[1].save());
    }
}

// Half textures and whole ones hold what a query finds: at a cell's centre x, y, z times the law's share at w.
TEST(SurfaceReading, TexturesHoldWhatAQueryFinds) {
    Config config = open_air({k_wind, 0.0f, 1.0f});
    config.roughness = Roughness{};
    config.blend_width = 0.0f; // the ambient wind is in no texture
    Wind wind = made(config);
    ASSERT_TRUE(wind.obstacles().add(test::scenario_parts::hills({-40.0, 1.0, -40.0})));
    for (int n = 0; n < 10; ++n)
        (void)wind.step(1.0 / 30.0);
    const WindView view = wind.view();
    const WindowBlock block = view.block({});
    const WallLaw law{.per_length = block.wall_per_length, .per_log = block.wall_per_log};
    ASSERT_TRUE(law.acts());
    const std::size_t count = view.box().cell_count();
    std::vector<float> whole(4 * count);
    std::vector<std::uint16_t> half(4 * count);
    ASSERT_TRUE(view.write_vectors(whole));
    ASSERT_TRUE(view.write_vectors(half));
    double worst = 0.0, worst_half = 0.0;
    for_each_cell(view.box().cells, [&](int i, int j, int k) {
        const glm::vec3 u = view.velocity(view.window().centre(i, j, k));
        const std::size_t at = 4 * view.box().index(i, j, k);
        const auto off = [&](const auto& texel) {
            const glm::vec3 found = law.fraction(texel(at + 3)) * glm::vec3(texel(at), texel(at + 1), texel(at + 2));
            return static_cast<double>(glm::length(found - u) / k_wind);
        };
        worst = std::max(worst, off([&](std::size_t n) { return whole[n]; }));
        worst_half = std::max(worst_half, off([&](std::size_t n) { return from_half(half[n]); }));
    });
    WINDROW_EXPECT_FIGURE("surface_reading/texture", worst, 1e-5);
    WINDROW_EXPECT_FIGURE("surface_reading/half_texture", worst_half, 2e-3);
}

} // namespace
} // namespace windrow
