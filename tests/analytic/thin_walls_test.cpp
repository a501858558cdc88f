// Walls of any thickness, at any angle and place in the cells: across a duct they stop the wind, and smoke before them stays there,
// between 0 and 1.
#include "fluid/tracer.h"
#include "tests/scenarios.h"
#include "tests/tier.h"
#include "tests/winds.h"

#include <glm/gtc/matrix_transform.hpp>

namespace windrow {
namespace {

using namespace test;

constexpr float k_speed = 8.0f, k_half = 40.0f; // [m/s], [m] of a wall: beyond the duct's sides at any angle

// A duct along x with open ends, two units of its walls thick at most of which it holds at 60 degrees.
Config duct() {
    Config config{.cells = {40, 10, 10}, .ambient = {k_speed, 0.0f, 0.0f}, .pressure_solves = 4};
    config.boundaries = Boundaries::all(BoundaryKind::free_slip);
    config.boundaries.x_low = config.boundaries.x_high = {BoundaryKind::open};
    return config;
}

enum class Made { block, mesh, voxels, cylinder };
constexpr const char* k_names[] = {"block", "mesh", "voxels", "cylinder"};

Shape wall_of(Made made, float thickness) {
    const glm::vec3 half{0.5f * thickness, k_half, k_half};
    switch (made) {
    case Made::mesh:
        return MeshShape{mesh_of(box_mesh(half))};
    case Made::voxels: { // cubes: as many as the wall is wide
        const int across = std::max(1, static_cast<int>(2.0f * k_half / thickness));
        if (across > 200)
            return Block{half};
        return VoxelShape{grid_of({.cells = {1, across, across}, .closed = std::vector<std::uint8_t>(across * across, 1)}),
                          thickness};
    }
    case Made::cylinder:
        return Cylinder{.radius = k_half, .half_length = 0.5f * thickness};
    default:
        return Block{half};
    }
}

struct Placed {
    Obstacle wall;
    glm::vec3 normal;
    float thickness;
    [[nodiscard]] float before(glm::dvec3 place) const { // [m] of the face that the wind meets
        return -glm::dot(glm::vec3(place - wall.position), normal) - 0.5f * thickness;
    }
    [[nodiscard]] float behind(glm::dvec3 place) const {
        return glm::dot(glm::vec3(place - wall.position), normal) - 0.5f * thickness;
    }
};

Placed placed(Made made, float thickness, float yaw, float pitch, glm::vec3 place) {
    glm::mat3 axes(glm::rotate(glm::rotate(glm::mat4(1.0f), glm::radians(yaw), {0.0f, 1.0f, 0.0f}), glm::radians(pitch),
                               {0.0f, 0.0f, 1.0f}));
    const glm::vec3 normal = axes[0];
    if (made == Made::cylinder) // whose axis is y
        axes = glm::mat3(axes[1], axes[0], -axes[2]);
    return {.wall = {.position = glm::dvec3(place), .orientation = glm::quat_cast(axes), .shape = wall_of(made, thickness)},
            .normal = normal,
            .thickness = thickness};
}

// Mean flow along the duct over the wind, half a duct behind the wall's middle.
double flux(const Wind& wind) {
    const glm::ivec3 cells = wind.box().cells;
    double sum = 0.0;
    for_each_cell(cells, [&](int i, int j, int k) {
        if (i == cells.x - 2)
            sum += static_cast<double>(wind.field()[wind.box().index(i, j, k)].x);
    });
    return std::abs(sum) / (cells.y * cells.z) / static_cast<double>(k_speed);
}

class ThinWalls : public testing::TestWithParam<Made> {};

// Based on: the method of shared faces between centres inside and outside. Without it 84 % of the wind pass, by angle and thickness.
TEST_P(ThinWalls, LetNoWindThrough) {
    std::mt19937 chance(7);
    const auto part = [&](float from, float to) { return std::uniform_real_distribution<float>(from, to)(chance); };
    double sum = 0.0, worst = 0.0;
    const int places = sampled(64, 12);
    for (int n = 0; n < places; ++n) {
        const float thickness = n % 4 == 0 ? part(0.05f, 0.3f) : n % 4 == 3 ? part(1.2f, 3.0f) : part(0.3f, 1.2f);
        const Placed wall = placed(GetParam(), thickness, part(-60.0f, 60.0f), n % 2 == 0 ? 0.0f : part(-30.0f, 30.0f),
                                   {part(-0.5f, 0.5f), part(-0.5f, 0.5f), part(-0.5f, 0.5f)});
        Wind wind = made(duct());
        ASSERT_TRUE(wind.obstacles().add(wall.wall));
        take_steps(wind, 60, 0.1);
        const double through = flux(wind);
        sum += through;
        worst = std::max(worst, through);
    }
    const std::string name = std::string("thin_walls/") + k_names[static_cast<int>(GetParam())];
    WINDROW_EXPECT_FIGURE(name + "/mean_flux_over_wind", sum / places, 0.01);
    WINDROW_EXPECT_FIGURE(name + "/worst_flux_over_wind", worst, 0.02);
}

TEST_P(ThinWalls, KeepSmokeBeforeThem) {
    std::mt19937 chance(11);
    const auto part = [&](float from, float to) { return std::uniform_real_distribution<float>(from, to)(chance); };
    const int places = sampled(32, 6);
    for (int n = 0; n < places; ++n) {
        const Placed wall = placed(GetParam(), part(0.05f, 1.4f), part(-60.0f, 60.0f), n % 2 == 0 ? 0.0f : part(-30.0f, 30.0f),
                                   {part(-0.5f, 0.5f), part(-0.5f, 0.5f), part(-0.5f, 0.5f)});
        Wind wind = made(duct());
        ASSERT_TRUE(wind.obstacles().add(wall.wall));
        auto smoke = Tracer::create(wind.view());
        ASSERT_TRUE(smoke) << smoke.error();
        const float cfl[] = {0.1f, 1.0f, 10.0f};
        double kept = 0.0;
        for (int step = 0; step < 12; ++step) {
            const double dt = static_cast<double>(cfl[n % 3] / k_speed);
            wind.step(dt);
            ASSERT_TRUE(smoke->step(wind.view(), wind.obstacles().in_reach(), dt));
            smoke->blow(wall.wall.position - glm::dvec3(wall.normal * (0.5f * wall.thickness + 0.7f)),
                        2.0f); // reaches beyond the wall
            double behind = 0.0;
            for_each_cell(wind, [&](glm::dvec3 centre, std::size_t cell) {
                const float density = smoke->cells()[cell];
                ASSERT_TRUE(density >= 0.0f && density <= 1.0f) << density;
                if (wall.behind(centre) > 0.0f)
                    behind = std::max(behind, static_cast<double>(density));
                if (wall.before(centre) > 0.0f)
                    kept += static_cast<double>(density);
            });
            ASSERT_EQ(behind, 0.0) << "thickness " << wall.thickness << ", step " << step << ", place " << n;
        }
        EXPECT_GT(kept, 1.0);
    }
}

std::string name_of(const testing::TestParamInfo<Made>& made) {
    return k_names[static_cast<int>(made.param)];
}

INSTANTIATE_TEST_SUITE_P(Shapes, ThinWalls, testing::Values(Made::block, Made::mesh, Made::voxels, Made::cylinder), name_of);

// A wall that moves along a duct takes the air before it along: what passes a section is what it sweeps.
TEST_P(ThinWalls, PushWhatTheySweep) {
    constexpr double k_wall_speed = 1.0, k_dt = 1.0 / 30.0;
    for (const float thickness : {0.1f, 0.45f, 0.8f, 1.3f}) {
        Config config = duct();
        config.ambient = glm::vec3(0.0f);
        Placed wall = placed(GetParam(), thickness, 17.0f, 0.0f, {-4.0f, 0.2f, 0.1f});
        Wind wind = made(config);
        const auto id = wind.obstacles().add(wall.wall);
        ASSERT_TRUE(id) << id.error();
        double sum = 0.0;
        int count = 0;
        for (int step = 1; step <= 150; ++step) {
            ASSERT_TRUE(wind.obstacles().move(*id, wall.wall.position + glm::dvec3(k_wall_speed * k_dt * step, 0.0, 0.0),
                                              wall.wall.orientation));
            wind.step(k_dt);
            if (step > 60) {
                sum += flux(wind) * static_cast<double>(k_speed);
                ++count;
            }
        }
        WINDROW_EXPECT_FIGURE("thin_walls/" + std::string(k_names[static_cast<int>(GetParam())]) + "/push_off/" +
                                  std::to_string(static_cast<int>(100.0f * thickness)),
                              std::abs(sum / count / k_wall_speed - 1.0), 0.01);
    }
}

// [m/s] Mean speed in a room with its lee side open, in cells of 1 m and a wind of 8 m/s.
double wind_in_room(float thickness) {
    Config config{.cells = {36, 16, 28}, .ambient = {k_speed, 0.0f, 0.0f}};
    config.centre = {0.0, 8.0, 0.0};
    config.boundaries = Boundaries::open_over_floor();
    Wind wind = made(config);
    const auto wall = [&](glm::vec3 low, glm::vec3 high) {
        EXPECT_TRUE(wind.obstacles().add({.position = glm::dvec3(0.5f * (low + high)), .shape = Block{0.5f * (high - low)}}));
    };
    const float t = thickness;
    wall({-4.3f - t, 0.0f, -4.2f - t}, {-4.3f, 5.1f + t, 4.2f + t}); // windward
    wall({-4.3f, 0.0f, -4.2f - t}, {4.3f, 5.1f + t, -4.2f});
    wall({-4.3f, 0.0f, 4.2f}, {4.3f, 5.1f + t, 4.2f + t});
    wall({-4.3f, 5.1f, -4.2f}, {4.3f, 5.1f + t, 4.2f}); // roof
    double sum = 0.0;
    int count = 0;
    for (int step = 0; step < 1200; ++step) {
        wind.step(1.0 / 30.0);
        if (step < 100)
            continue;
        for_each_cell(wind, [&](glm::dvec3 centre, std::size_t cell) {
            if (std::abs(centre.x) < 4.0 && centre.y < 5.0 && std::abs(centre.z) < 4.0) {
                sum += glm::length(glm::dvec3(wind.field()[cell]));
                ++count;
            }
        });
    }
    return sum / count;
}

// Around the same air: walls of 30 cm, and thick ones, whose outside differs, and with it the wake that they stand in.
TEST(ThinRooms, LongHaveTheWindOfThickOnes) {
    const double thin = wind_in_room(0.3f);
    double thick = 0.0;
    for (const float thickness : {1.6f, 1.8f, 2.0f, 2.2f}) {
        const double wind = wind_in_room(thickness);
        figure("thin_walls/room/" + std::to_string(thickness), wind);
        thick += 0.25 * wind;
    }
    figure("thin_walls/room/thin", thin);
    WINDROW_EXPECT_FIGURE("thin_walls/room/off", std::abs(thin / thick - 1.0), 0.1);
}

// Smoke in bodies of every shape and motion, in gusts, in a box that follows.
TEST(TracerBounds, HoldBesideEveryBody) {
    int bodies = 0;
    for (const Scenario& row : scenarios(whole_sweeps())) {
        if (!row.name.ends_with("s")) // rests, moves, turns, and hills
            continue;
        for (const float cfl : {0.1f, 1.0f, 10.0f}) {
            if (!whole_sweeps() && cfl != 1.0f)
                continue;
            Config config = scenario_config();
            config.gusts.intensity = 0.3f;
            if (row.config)
                row.config(config);
            Wind wind = made(config);
            if (row.begin)
                row.begin(wind);
            auto smoke = Tracer::create(wind.view());
            ASSERT_TRUE(smoke) << smoke.error();
            float least = 0.0f, most = 0.0f;
            for (int step = 0; step < sampled(24, 6); ++step) {
                const double dt = static_cast<double>(cfl / 6.0f);
                if (row.step)
                    row.step(wind, step);
                ASSERT_TRUE(wind.follow({0.4 * step, 0.0, 0.2 * step}));
                wind.step(dt);
                ASSERT_TRUE(smoke->step(wind.view(), wind.obstacles().in_reach(), dt));
                smoke->blow(wind.view().window().centre(4, 4, 6), 1.5f);
                for (const float density : smoke->cells()) {
                    least = std::min(least, density);
                    most = std::max(most, density);
                }
            }
            EXPECT_GE(least, 0.0f) << row.name << " at " << cfl;
            EXPECT_LE(most, 1.0f) << row.name << " at " << cfl;
        }
        ++bodies;
    }
    EXPECT_GE(bodies, 8);
}

} // namespace
} // namespace windrow
