// Rough ground: which faces its stress acts at, the step of one column, and what a wind on it keeps, saves and rejects.
#include "fluid/solids/surface_layer.h"
#include "tests/shapes.h"
#include "tests/unit/snapshot_session.h"
#include "tests/winds.h"

#include <array>
#include <cmath>
#include <optional>

namespace windrow {
namespace {

using namespace test;

float drag(float height, float roughness) {
    const float stress = 0.4f / std::log1p(height / roughness);
    return stress * stress;
}
// Square of the mixing length over that of a cell, from `height` to a cell's size higher.
float mixing(float height, float size, float roughness) {
    // In double: logf of a ratio near 1 is four units in the last place off in the square.
    const double z = double{height} + double{roughness}, length = 0.4 / std::log1p(double{size} / z);
    return static_cast<float>(length * length);
}

// --- Faces -----------------------------------------------------------------------------------------------------------------------

class SurfaceLayerFaces : public testing::Test {
  protected:
    void renew(const Roughness& roughness, std::vector<PlacedObstacle> bodies = {}) {
        const Box box{.cells = k_cells, .cell_size = k_size, .boundaries = boundaries};
        Solids solids(box, k_cells.x);
        solids.place(bodies);
        layer.emplace(box, roughness);
        layer->renew(*AmbientWind::create(wind), {.cells = k_cells, .cell_size = k_size, .origin_cells = {7, 0, -3}}, boundaries,
                     solids.any() ? &solids : nullptr, true, ParallelFor{});
    }
    [[nodiscard]] float at(int i, int j, int k) const {
        return layer->faces()[static_cast<std::size_t>((k * (k_cells.y + 1) + j) * k_cells.x + i)];
    }
    static PlacedObstacle block(glm::vec3 low, glm::vec3 high) {
        return {.shape = Block{0.5f * (high - low)}, .position = 0.5f * (low + high)};
    }

    static constexpr glm::ivec3 k_cells{8, 12, 6};
    static constexpr float k_size = 0.5f, k_roughness = 0.03f;
    Boundaries boundaries = Boundaries::open_over_floor();
    AmbientWind::Settings wind{.mean = {4.0f, 0.0f, 0.0f}};
    std::optional<SurfaceLayer> layer;
};

TEST_F(SurfaceLayerFaces, OverAFloorGoByTheHeight) {
    renew({.length = k_roughness});
    for (const int i : {0, 3, 7}) {
        EXPECT_FLOAT_EQ(at(i, 0, 2), -drag(0.25f, k_roughness));
        for (int j = 1; j <= k_cells.y; ++j)
            EXPECT_NEAR(at(i, j, 5) / mixing(k_size * (static_cast<float>(j) - 0.5f), k_size, k_roughness), 1.0f, 2e-6f) << j;
    }
    boundaries.y_high.kind = BoundaryKind::free_slip;
    renew({.length = k_roughness});
    EXPECT_EQ(at(1, k_cells.y, 1), 0.0f) << "nothing passes a lid";
    boundaries.y_low.kind = BoundaryKind::no_slip;
    renew({.length = k_roughness});
    EXPECT_EQ(at(1, 0, 1), 0.0f) << "viscosity holds the air there";
}

TEST_F(SurfaceLayerFaces, HaveALongestMixingLength) {
    renew({.length = k_roughness, .longest_mixing = 0.6f});
    EXPECT_NEAR(at(0, 2, 0), mixing(0.75f, k_size, k_roughness), 1e-5f);
    EXPECT_FLOAT_EQ(at(0, 9, 0), 0.6f * 0.6f / (k_size * k_size));
}

TEST_F(SurfaceLayerFaces, WithoutAFloorAreOverHeightZero) {
    boundaries.y_low.kind = BoundaryKind::open;
    renew({.length = k_roughness});
    EXPECT_EQ(at(0, 0, 0), 0.0f) << "half a cell below";
    EXPECT_FLOAT_EQ(at(0, 1, 0), mixing(0.25f, k_size, k_roughness));
}

TEST_F(SurfaceLayerFaces, TakeTheirLengthFromAMap) {
    const auto lengths = heights_of({11, 11}, 1.0f, [](double x, double z) { return 0.01 * x + 0.1 * z - 0.2; });
    renew({.map = RoughnessMap{.lengths = lengths, .position = {0.0, 50.0, -4.0}, .scale = {1.0f, 2.0f, 1.0f}}});
    // The centre of cell (3, 0, 5) is at (5.25, .25, 1.25).
    EXPECT_NEAR(at(3, 0, 5), -drag(0.25f, 2.0f * (0.01f * 5.25f + 0.1f * 5.25f - 0.2f)), 1e-5f);
    EXPECT_NEAR(at(0, 0, 0), -drag(0.25f, 2.0f * (0.01f * 3.75f + 0.1f * 2.75f - 0.2f)), 1e-5f);
    renew({.map = RoughnessMap{.lengths = heights_of({2, 2}, 1.0f, [](double, double) { return -1.0; })}});
    EXPECT_FLOAT_EQ(at(0, 0, 0), -drag(0.25f, 1e-6f)) << "no length: the smoothest";
}

TEST_F(SurfaceLayerFaces, StandOnRoofsAndEndAtCeilings) {
    renew({.length = k_roughness}, {block({1.0f, 2.0f, 1.0f}, {2.0f, 3.1f, 2.0f})}); // a beam over a passage
    EXPECT_FLOAT_EQ(at(2, 0, 2), -drag(0.25f, k_roughness)) << "the floor below it";
    EXPECT_GT(at(2, 3, 2), 0.0f);
    EXPECT_EQ(at(2, 4, 2), 0.0f) << "its ceiling";
    EXPECT_EQ(at(2, 5, 2), 0.0f) << "inside";
    EXPECT_NEAR(at(2, 6, 2), -drag(0.15f, k_roughness), 1e-3f) << "its roof, .15 m below the centre of a cell";
    EXPECT_NEAR(at(2, 7, 2), mixing(0.15f, k_size, k_roughness), 1e-4f);
    EXPECT_FLOAT_EQ(at(5, 7, 2), mixing(3.25f, k_size, k_roughness)) << "beside it";

    PlacedObstacle beam = block({1.0f, 2.0f, 1.0f}, {2.0f, 3.1f, 2.0f});
    beam.velocity = {1.0f, 0.0f, 0.0f};
    renew({.length = k_roughness}, {beam});
    EXPECT_EQ(at(2, 6, 2), 0.0f) << "what moves is smooth";
    beam = block({1.0f, 2.0f, 1.0f}, {2.0f, 3.1f, 2.0f});
    beam.surface = Surface::no_slip;
    renew({.length = k_roughness}, {beam});
    EXPECT_EQ(at(2, 6, 2), 0.0f) << "viscosity holds the air there";
}

TEST_F(SurfaceLayerFaces, StandOnRoofsAcrossPeriodicBoundaries) {
    boundaries = Boundaries::all(BoundaryKind::periodic);
    renew({.length = k_roughness}, {block({1.0f, 4.9f, 1.0f}, {2.0f, 6.6f, 2.0f})}); // up to .6 m over the seam at 6 m
    EXPECT_NEAR(at(2, 1, 2), -drag(0.15f, k_roughness), 1e-3f);
    EXPECT_NEAR(at(2, 2, 2), mixing(0.15f, k_size, k_roughness), 1e-4f);
}

TEST_F(SurfaceLayerFaces, StandOnPlatesAndOnGrounds) {
    PlacedObstacle plate{.shape = Plate{{1.0f, 1.0f}}, .position = {2.0f, 1.5f, 1.5f}};
    plate.axes = {glm::vec3(1, 0, 0), glm::vec3(0, 0, 1), glm::vec3(0, -1, 0)}; // level
    renew({.length = k_roughness}, {plate});
    EXPECT_NEAR(at(3, 3, 2), -drag(0.25f, k_roughness), 1e-5f);
    EXPECT_NEAR(at(3, 4, 2), mixing(0.25f, k_size, k_roughness), 1e-5f);
    EXPECT_NEAR(at(7, 4, 2), mixing(1.75f, k_size, k_roughness), 1e-5f) << "beside it";

    const auto slope = heights_of({21, 21}, 1.0f, [](double x, double) { return 0.4 * x; });
    renew({.length = k_roughness}, {PlacedObstacle{.shape = Ground{slope}}});
    EXPECT_NEAR(at(3, 1, 2), -drag(0.75f - 0.4f * 1.75f, k_roughness), 1e-4f) << "the height over it, not the distance";
    EXPECT_EQ(at(3, 0, 2), 0.0f) << "below it";
    EXPECT_NEAR(at(0, 0, 2), -drag(0.25f - 0.4f * 0.25f, k_roughness), 1e-4f) << "in the lower half of the lowest cell";
}

TEST_F(SurfaceLayerFaces, OfTheWindGoByItsOwnProfile) {
    renew({.length = 0.1f});
    EXPECT_TRUE(layer->wind_mixing().empty());
    for (const float one : layer->wind_drag())
        EXPECT_EQ(one, 0.0f);
    wind.profile = LogProfile{.roughness_length = 0.01f};
    wind.ground = 1.0;
    renew({.length = 0.1f});
    EXPECT_EQ(layer->wind_drag()[1], 0.0f) << "below its ground";
    EXPECT_FLOAT_EQ(layer->wind_drag()[3], drag(0.75f, 0.01f));
    EXPECT_EQ(layer->wind_mixing()[2], 0.0f);
    EXPECT_FLOAT_EQ(layer->wind_mixing()[4], mixing(0.75f, k_size, 0.01f));
}

// --- A column --------------------------------------------------------------------------------------------------------------------

Config closed_column(int rows) {
    return {.cells = {5, rows, 3},
            .cell_size = 0.5f,
            .boundaries = with(Config{},
                               [](Config& c) {
                                   c.boundaries = Boundaries::all(BoundaryKind::periodic);
                                   c.boundaries.y_low.kind = c.boundaries.y_high.kind = BoundaryKind::free_slip;
                               })
                              .boundaries,
            .roughness = Roughness{.length = 0.1f},
            .viscosity = 0.0f,
            .relaxation_time = 0.0f,
            .stages = {.sources = false, .relaxation = false, .diffusion = true, .advection = false, .projection = false}};
}

TEST(RoughColumn, OfOneCellSlowsByTheLaw) {
    for (const double dt : {0.001, 0.1, 50.0}) {
        Wind wind = made(closed_column(1));
        wind.set_velocity([](glm::dvec3) { return glm::vec3(3.0f, 0.0f, -4.0f); });
        (void)wind.step(dt);
        const double k = dt / 0.5 * static_cast<double>(drag(0.25f, 0.1f)) * 5.0, factor = (1.0 + k) / (1.0 + 2.0 * k);
        for (const glm::vec4& u : wind.field())
            ASSERT_NEAR(static_cast<double>(glm::length(u - glm::vec4(3.0f * factor, 0.0f, -4.0f * factor, 0.0f))), 0.0, 2e-6)
                << dt;
    }
}

// All momentum that the air loses passes the floor. Rows that are no multiple of a register's lanes, and steps of any length.
TEST(RoughColumn, LosesMomentumAtTheFloorAlone) {
    for (const int rows : {2, 9, 31})
        for (const double dt : {0.01, 3.0}) {
            Wind wind = made(closed_column(rows));
            Random random(5);
            wind.set_velocity(
                [&](glm::dvec3) { return glm::vec3(random.uniform(-5, 5), random.uniform(-1, 1), random.uniform(-5, 5)); });
            const std::vector<glm::vec4> before(wind.field().begin(), wind.field().end());
            (void)wind.step(dt);
            for (int i = 0; i < 5; ++i) {
                glm::dvec3 lost(0.0);
                for (int j = 0; j < rows; ++j) {
                    const std::size_t n = wind.box().index(i, j, 1);
                    lost += glm::dvec3(before[n]) - glm::dvec3(wind.field()[n]);
                    EXPECT_EQ(before[n].y, wind.field()[n].y);
                    EXPECT_EQ(wind.field()[n].w, 0.0f);
                }
                const glm::dvec3 was(before[wind.box().index(i, 0, 1)]), is(wind.field()[wind.box().index(i, 0, 1)]);
                const double speed = glm::length(glm::dvec2(was.x, was.z));
                const glm::dvec3 drawn = dt / 0.5 * static_cast<double>(drag(0.25f, 0.1f)) * speed * (2.0 * is - was);
                EXPECT_NEAR(lost.x, drawn.x, 5e-4 * rows) << rows << " rows, " << dt << " s";
                EXPECT_NEAR(lost.z, drawn.z, 5e-4 * rows);
            }
        }
}

// --- A wind ----------------------------------------------------------------------------------------------------------------------

TEST(WindOnRoughGround, SleepsWhereTheGroundIsThatOfItsProfile) {
    Config config{.cells = {8, 6, 8},
                  .boundaries = Boundaries::open_over_floor(),
                  .ambient = {3.0f, 0.0f, 0.0f},
                  .profile = LogProfile{.roughness_length = 0.05f},
                  .roughness = Roughness{.length = 0.05f}};
    Wind like = made(config);
    take_steps(like, 5, 0.1);
    EXPECT_TRUE(like.step(0.1).asleep);
    for (const BoundaryKind kind : {BoundaryKind::open, BoundaryKind::no_slip}) {
        Wind over_nothing = made(with(config, [&](Config& c) {
            c.boundaries.y_low.kind = kind;
            c.profile.reset();
        }));
        take_steps(over_nothing, 3, 0.1);
        EXPECT_TRUE(over_nothing.step(0.1).asleep) << "no surface is rough";
    }
    config.roughness->length = 0.06f;
    Wind rougher = made(config);
    take_steps(rougher, 3, 1e-4);
    EXPECT_FALSE(rougher.step(1e-4).asleep) << "little as a short step changes";
    EXPECT_LT(rougher.field()[0].x, like.field()[0].x);
}

TEST(WindOnRoughGround, IsSavedWithItsMap) {
    Config config{.cells = {8, 6, 8}, .boundaries = Boundaries::open_over_floor(), .ambient = {3.0f, 0.0f, 1.0f}};
    config.roughness.emplace(Roughness{.length = 0.2f, .longest_mixing = 3.0f});
    config.roughness->map =
        RoughnessMap{.lengths = heights_of({3, 3}, 2.0f, [](double x, double z) { return 0.01 + 0.1 * x * z; }),
                     .position = {-2.0, 0.0, -2.0}};
    Wind wind = made(config);
    take_steps(wind, 3, 0.1);
    const auto bytes = wind.save();
    ASSERT_TRUE(bytes) << bytes.error();
    auto read = Wind::load(*bytes);
    ASSERT_TRUE(read) << read.error();
    ASSERT_TRUE(read->config().roughness && read->config().roughness->map);
    EXPECT_EQ(*read->config().roughness->map->lengths, *config.roughness->map->lengths);
    EXPECT_EQ(read->config().roughness->longest_mixing, 3.0f);
    (void)wind.step(0.1);
    (void)read->step(0.1);
    EXPECT_TRUE(std::equal(wind.field().begin(), wind.field().end(), read->field().begin()));
}

} // namespace
} // namespace windrow
