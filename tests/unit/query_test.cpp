// Reading the air: velocity() is what a vertex stage gets from the three textures and the window block; written here a second
// time, in double, from textures.h and wind.h.

#include "tests/winds.h"

#include <array>
#include <cstddef>
#include <cstring>

namespace {

using namespace windrow;
using namespace windrow::test;

Wind noisy(const Config& config) {
    Wind wind = made(config);
    EXPECT_TRUE(wind.set_velocity(white_noise(config.cells, 5.0f, 81)));
    return wind;
}

std::vector<NamedConfig> queried_scenes() {
    const Config base{.cells = {13, 9, 17},
                      .cell_size = 0.75f,
                      .centre = {3.0, -2.0, 1.0},
                      .ambient = {4.0f, -1.0f, 2.0f},
                      .blend_width = 0.0f};
    const auto boundaries = [&](BoundaryKind kind) {
        return with(base, [&](Config& c) { c.boundaries = Boundaries::all(kind); });
    };
    return {{"open", boundaries(BoundaryKind::open)},
            {"free_slip", boundaries(BoundaryKind::free_slip)},
            {"no_slip", boundaries(BoundaryKind::no_slip)},
            {"periodic", boundaries(BoundaryKind::periodic)},
            {"mixed", with(base,
                           [](Config& c) {
                               c.boundaries = {.x_low = {BoundaryKind::no_slip}, .y_low = {BoundaryKind::free_slip}};
                               c.boundaries.z_low.kind = c.boundaries.z_high.kind = BoundaryKind::periodic;
                           })},
            {"rows", with(base,
                          [](Config& c) {
                              c.boundaries.y_low = {BoundaryKind::free_slip};
                              c.rows.emplace(Rows{.first = 0.25f, .uniform = 2, .ratio = 1.3f});
                          })},
            {"one_cell", with(base, [](Config& c) { c.cells = glm::ivec3(1, 6, 1); })},
            {"million_metres_away", with(base, [](Config& c) { c.centre = glm::dvec3(1e6, 3.0, -1e6); })}};
}

/// The textures, as a shader would hold them.
struct AxisTextures {
    std::vector<float> axis[3];
    WindowBlock block;
    glm::dvec3 anchor;
    std::array<float, k_max_rows> heights;

    AxisTextures(const Wind& wind, glm::dvec3 at)
        : block(wind.window_block(at)), anchor(at), heights(wind.frame_block(at).heights) {
        for (auto& texels : axis)
            texels.resize(wind.field().size());
        EXPECT_TRUE(wind.write_axes(std::span(axis[0]), std::span(axis[1]), std::span(axis[2])));
    }

    [[nodiscard]] double texel(int component, const int (&cell)[3]) const {
        const int nx = int(block.cells.x), ny = int(block.cells.y);
        return axis[component][(std::size_t(cell[2]) * ny + cell[1]) * nx + cell[0]];
    }

    [[nodiscard]] glm::dvec3 sample(glm::dvec3 position) const {
        glm::dvec3 local = (position - anchor - glm::dvec3(block.origin)) / double(block.cell_size);
        const double over_floor = local.y, under_top = double(block.height / block.cell_size) - local.y;
        if (const int rows = int(block.rows); rows > 0) { // between the two centres around it
            const double height = local.y * double(block.cell_size);
            int low = 0;
            while (low + 2 < rows && double(heights[std::size_t(low) + 1]) <= height)
                ++low;
            const double below = double(heights[std::size_t(low)]), above = double(heights[std::size_t(low) + 1]);
            local.y = low + 0.5 + (height - below) / (above - below);
        }
        double share = 1.0, t[3];
        int low[3], high[3];
        for (int a = 0; a < 3; ++a) {
            const int n = int(block.cells[a]);
            if (block.low_boundaries[a] == 0.0f) // open: fades over one cell
                share *= std::clamp(1.0 + (a == 1 ? over_floor : local[a]), 0.0, 1.0);
            if (block.high_boundaries[a] == 0.0f)
                share *= std::clamp(1.0 + (a == 1 ? under_top : n - local[a]), 0.0, 1.0);
            const double at = local[a] - 0.5;
            t[a] = at - std::floor(at);
            if (block.low_boundaries[a] == 2.0f) {
                const double wrapped = std::floor(at) - n * std::floor(std::floor(at) / n);
                low[a] = int(wrapped);
                high[a] = (low[a] + 1) % n;
            } else {
                low[a] = int(std::clamp(std::floor(at), 0.0, n - 1.0));
                high[a] = int(std::clamp(std::floor(at) + 1.0, 0.0, n - 1.0));
            }
        }
        glm::dvec3 result(0.0);
        for (int component = 0; component < 3; ++component) {
            double sum = 0.0;
            for (int corner = 0; corner < 8; ++corner) {
                const int cell[3] = {corner & 1 ? high[0] : low[0], corner & 2 ? high[1] : low[1], corner & 4 ? high[2] : low[2]};
                sum += (corner & 1 ? t[0] : 1 - t[0]) * (corner & 2 ? t[1] : 1 - t[1]) * (corner & 4 ? t[2] : 1 - t[2]) *
                       texel(component, cell);
            }
            result[component] = share * sum + (1.0 - share) * double(block.ambient[component]);
        }
        return result;
    }
};

glm::dvec3 extent_of(const Wind& wind) {
    return glm::dvec3(wind.box().size());
}

TEST(Query, EqualsATrilinearSampleOfTheTextures) {
    for (const NamedConfig& scene : queried_scenes()) {
        const Wind wind = noisy(scene.config);
        const AxisTextures textures(wind, scene.config.centre + glm::dvec3(1.0, -2.0, 0.5));
        Random random(82);
        double worst = 0.0;
        for (int n = 0; n < 10'000; ++n) {
            const double margin = n % 3 == 0 ? 3.0 : 0.1; // beyond the rim, and inside
            const glm::dvec3 extent = extent_of(wind);
            const double x = random.real(-margin, extent.x + margin), y = random.real(-margin, extent.y + margin),
                         z = random.real(-margin, extent.z + margin);
            const glm::dvec3 position = wind.origin() + glm::dvec3(x, y, z);
            worst = std::max(worst, glm::length(glm::dvec3(wind.velocity(position)) - textures.sample(position)) /
                                        largest_speed(wind.field()));
        }
        WINDROW_EXPECT_FIGURE("query_" + scene.name, worst, 1e-5);
    }
}

TEST(Query, CellCentresAreTheCells) {
    for (const NamedConfig& scene : queried_scenes()) {
        const Wind wind = noisy(scene.config);
        double worst = 0.0;
        for_each_cell(wind, [&](glm::dvec3 centre, std::size_t n) {
            worst = std::max(worst, double(glm::length(wind.velocity(centre) - glm::vec3(wind.field()[n]))));
        });
        WINDROW_EXPECT_FIGURE("query_centres_" + scene.name, worst, 1e-6 * largest_speed(wind.field()));
    }
}

TEST(Query, IsContinuousAcrossTheRim) {
    for (const NamedConfig& scene : queried_scenes()) {
        const Wind wind = noisy(scene.config);
        const double h = wind.box().cell_size, stride = 1e-3 * h;
        // Along an axis the wind changes by at most twice its size a cell, and beyond an open boundary by all that ambient differs.
        const double speed = largest_speed(wind.field()),
                     steepest = std::sqrt(3.0) * (3.0 * speed + glm::length(glm::dvec3(wind.ambient())));
        Random random(83);
        double worst = 0.0;
        for (int line = 0; line < 60; ++line) {
            const glm::dvec3 extent = extent_of(wind), through = wind.origin() + extent * (0.5 + random.point(0.45));
            const glm::dvec3 direction = line < 6 ? glm::dvec3(line % 3 == 0, line % 3 == 1, line % 3 == 2) : random.direction();
            glm::vec3 last = wind.velocity(through);
            for (double t = stride; t < glm::length(extent); t += stride) {
                const glm::vec3 now = wind.velocity(through + t * direction);
                worst = std::max(worst, double(glm::length(now - last)) / 1e-3);
                last = now;
            }
        }
        WINDROW_EXPECT_FIGURE("query_steepest_per_cell_" + scene.name, worst, steepest);
    }
}

TEST(Query, OutsideIsAmbientWallOrTheOtherSide) {
    const std::vector<NamedConfig> list = queried_scenes();
    Random random(84);
    const Wind open = noisy(list[0].config);
    Config boxed = list[1].config;
    boxed.floor = open.origin().y;
    const Wind walls = noisy(boxed);
    const Wind ring = noisy(list[3].config);
    double worst = 0.0;
    for (int n = 0; n < 1000; ++n) {
        // A point inside, sent out along one axis.
        const glm::dvec3 extent = extent_of(open), inside = open.origin() + extent * (0.5 + random.point(0.5));
        const int axis = n % 3;
        const bool low = random.integer(0, 1) == 0;
        const double edge = low ? open.origin()[axis] : open.origin()[axis] + extent[axis];
        glm::dvec3 beyond = inside, face = inside, turn = inside;
        beyond[axis] = edge + (low ? -1.0 : 1.0) * (0.7500001 + random.spread(1e-3, 1e6));
        face[axis] = edge;
        turn[axis] += extent[axis] * random.integer(-5, 5);
        ASSERT_EQ(open.velocity(beyond), open.ambient()) << "beyond one cell";
        worst = std::max({worst, double(glm::length(walls.velocity(beyond) - walls.velocity(face))),
                          double(glm::length(ring.velocity(turn) - ring.velocity(inside)))});
    }
    WINDROW_EXPECT_FIGURE("query_beyond", worst / 5.0, 1e-5);
}

TEST(Query, APointThatIsNoneGetsAmbientAndFarOnesAreFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    for (const NamedConfig& scene : queried_scenes()) {
        const Wind wind = noisy(scene.config);
        for (const double bad : {nan, infinity, -infinity})
            for (int axis = 0; axis < 3; ++axis) {
                glm::dvec3 position = scene.config.centre;
                position[axis] = bad;
                EXPECT_EQ(wind.velocity(position), wind.ambient()) << scene.name;
            }
        int broken = 0;
        for (const double far_off : {1e7, 1e12, 1e30, 1e39, 1e300, 1.7e308, -1e7, -1e39, -1.7e308})
            for (int axis = 0; axis < 3; ++axis) {
                glm::dvec3 position = scene.config.centre;
                position[axis] = far_off;
                const glm::vec3 there = wind.velocity(position);
                broken += !(glm::length(there) <= 1.001 * largest_speed(wind.field()) + glm::length(wind.ambient()));
            }
        WINDROW_EXPECT_FIGURE("query_far_points_broken_" + scene.name, broken, 0.0);
    }
}

TEST(Query, ManyPointsEqualSinglePoints) {
    const Wind wind = noisy(queried_scenes()[4].config);
    Random random(85);
    std::vector<glm::dvec3> points(1000);
    for (glm::dvec3& point : points)
        point = queried_scenes()[4].config.centre + random.point(12.0);
    std::vector<glm::vec3> many(points.size());
    wind.velocity(points, many);
    for (std::size_t n = 0; n < points.size(); ++n)
        ASSERT_EQ(many[n], wind.velocity(points[n]));
}

// --- The textures of the axes hold the bits of the cells -------------------------------------------------------------

TEST(Query, AxesEqualTheCellsToTheBit) {
    Wind wind = noisy(queried_scenes()[0].config);
    wind.step(0.1);
    const std::size_t count = wind.field().size();
    std::vector<float> whole[3];
    std::vector<std::uint16_t> half[3];
    for (int axis = 0; axis < 3; ++axis) {
        whole[axis].resize(count);
        half[axis].resize(count);
    }
    ASSERT_TRUE(wind.write_axes(std::span(whole[0]), std::span(whole[1]), std::span(whole[2])));
    ASSERT_TRUE(wind.write_axes(std::span(half[0]), std::span(half[1]), std::span(half[2])));
    for (std::size_t n = 0; n < count; ++n)
        for (int axis = 0; axis < 3; ++axis) {
            ASSERT_EQ(std::memcmp(&whole[axis][n], &wind.field()[n][axis], sizeof(float)), 0);
            ASSERT_EQ(half[axis][n], to_half(wind.field()[n][axis]));
        }
}

TEST(Query, VectorsEqualTheCellsToTheBit) {
    Wind wind = noisy(queried_scenes()[0].config);
    wind.step(0.1);
    const std::size_t count = wind.field().size();
    std::vector<float> whole(4 * count, 7.0f);
    std::vector<std::uint16_t> half(4 * count, 7);
    ASSERT_TRUE(wind.write_vectors(std::span(whole)));
    ASSERT_TRUE(wind.write_vectors(std::span(half)));
    for (std::size_t n = 0; n < 4 * count; ++n) {
        const float number = n % 4 < 3 ? wind.field()[n / 4][int(n % 4)] : 0.0f;
        ASSERT_EQ(std::memcmp(&whole[n], &number, sizeof(float)), 0) << n;
        ASSERT_EQ(half[n], to_half(number)) << n;
    }
}

TEST(Query, RoomOfAnotherSizeIsRejectedAndUntouched) {
    const Wind wind = noisy(queried_scenes()[0].config);
    const std::size_t count = wind.field().size();
    std::vector<float> right(count, 7.0f), wrong(count - 1, 7.0f);
    std::vector<std::uint16_t> half_right(count, 7), half_wrong(count + 1, 7);
    const auto rejected = wind.write_axes(std::span(right), std::span(right), std::span(wrong));
    ASSERT_FALSE(rejected);
    EXPECT_NE(rejected.error().find(std::to_string(count - 1) + " texels"), std::string::npos) << rejected.error();
    EXPECT_NE(rejected.error().find(std::to_string(count) + " cells"), std::string::npos) << rejected.error();
    EXPECT_FALSE(wind.write_axes(std::span(half_wrong), std::span(half_right), std::span(half_right)));
    const auto rejected_vectors = wind.write_vectors(std::span(right));
    ASSERT_FALSE(rejected_vectors);
    EXPECT_NE(rejected_vectors.error().find(std::to_string(count) + " numbers"), std::string::npos) << rejected_vectors.error();
    EXPECT_FALSE(wind.write_vectors(std::span(half_wrong)));
    EXPECT_TRUE(std::all_of(right.begin(), right.end(), [](float texel) { return texel == 7.0f; }));
    EXPECT_TRUE(std::all_of(half_right.begin(), half_right.end(), [](std::uint16_t texel) { return texel == 7; }));

    Wind writable = noisy(queried_scenes()[0].config);
    const Field before = copy(writable.field());
    EXPECT_FALSE(writable.set_velocity(Field(count - 1)));
    EXPECT_EQ(cells_that_differ(before, writable.field()), 0u);
}

TEST(Query, TheBlockSaysWhereTheTexturesLie) {
    Config config = queried_scenes()[4].config;
    config.follow_axes.reset();
    config.boundaries = Boundaries::open_over_floor();
    Wind wind = noisy(config);
    const glm::dvec3 anchor(2.0, 1.0, -7.0), origin = wind.origin();
    wind.step(0.1);
    ASSERT_TRUE(wind.follow(config.centre + glm::dvec3(1.5, 0.0, -0.75)));
    WindowBlock block = wind.window_block(anchor);
    EXPECT_EQ(block.origin, glm::vec3(wind.origin() - anchor));
    EXPECT_EQ(block.cell_size, 0.75f);
    EXPECT_EQ(glm::vec3(block.previous_origin), glm::vec3(origin - anchor));
    EXPECT_EQ(block.cells, glm::vec3(13.0f, 9.0f, 17.0f));
    EXPECT_EQ(block.factor, 1.0f);
    EXPECT_EQ(glm::vec3(block.ambient), glm::vec3(4.0f, 0.0f, 2.0f)) << "no wind through the floor";
    EXPECT_EQ(block.low_boundaries, glm::vec3(0.0f, 1.0f, 0.0f));
    EXPECT_EQ(glm::vec3(block.high_boundaries), glm::vec3(0.0f));
    wind.step(0.1);
    block = wind.window_block(anchor);
    EXPECT_EQ(glm::vec3(block.previous_origin), glm::vec3(origin - anchor)) << "the step before the last one lay there";
    wind.step(0.1);
    block = wind.window_block(anchor);
    EXPECT_EQ(block.previous_origin, block.origin);
    EXPECT_EQ(offsetof(WindowBlock, previous_origin), 32u);
    EXPECT_EQ(offsetof(WindowBlock, high_boundaries), 80u);
}

TEST(Query, WhatShadersReadIsFiniteWhateverIsAsked) {
    const auto bits = [](const FrameBlock& block) {
        std::array<float, sizeof(FrameBlock) / sizeof(float)> values;
        std::memcpy(values.data(), &block, sizeof block);
        return values;
    };
    Wind wind = *Wind::create({.cells = {8, 8, 8}, .ambient = {3.0f, 0.0f, 1.0f}, .gusts = {.intensity = 0.2f}});
    const auto standard = bits(wind.frame_block(glm::dvec3(0.0)));
    for (const float bad : {k_nan, -1.0f, k_infinity}) {
        const Sampling sampling{.strength = bad, .limit = bad, .detail = bad, .detail_length = bad};
        EXPECT_EQ(bits(wind.frame_block(glm::dvec3(k_nan), sampling)), standard) << bad;
        EXPECT_EQ(wind.felt({1.0, 2.0, 3.0}, sampling), wind.felt({1.0, 2.0, 3.0}, Sampling{})) << bad;
    }
    EXPECT_NE(bits(wind.frame_block({2.0, 0.0, 0.0})), standard);
}

} // namespace
