// The wind of the box fades to the ambient wind by the distance from the point that it follows, so that a shift of the box
// moves nothing that is seen.

#include "fluid/core/numerics.h"
#include "fluid/core/view_place.h"
#include "tests/figure.h"
#include "tests/winds.h"

namespace {

using namespace windrow;
using namespace windrow::test;

/// Air in strong motion to the very edge, so that anything that jumps there shows.
Wind stormy(Config config) {
    config.ambient = {2.0f, 0.0f, -1.0f};
    Wind wind = made(config);
    EXPECT_TRUE(wind.set_velocity(smooth_noise(wind.box().cells, 8.0f, 42)));
    take_steps(wind, 3, 1.0 / 60.0);
    return wind;
}

TEST(BlendZone, AShiftMovesNothing) {
    Wind wind = stormy({});
    Random random(43);
    std::vector<glm::dvec3> points;
    for (int n = 0; n < 4000; ++n)
        points.push_back(random.point(20.0) * glm::dvec3(1.0, 0.6, 1.0));
    const double speed = largest_speed(wind.field());
    std::vector<glm::vec3> before(points.size()), after(points.size());
    double worst = 0.0;
    int shifts = 0;
    constexpr double k_rounding = 0.5 / 65536.0; // places are rounded to 1/65536 of a cell
    glm::dvec3 at(0.0);
    for (int n = 0; n < 40; ++n) {
        // To just this side of where the box jumps, and just beyond it.
        const glm::dvec3 toward = glm::dvec3(n % 4 == 0, n % 4 == 1, n % 4 == 2 || n % 4 == 3) * (n % 8 < 4 ? 1.0 : -1.0);
        const glm::dvec3 edge = glm::floor(at + 1e-4) + 0.5 - k_rounding;
        glm::dvec3 near = at;
        for (int axis = 0; axis < 3; ++axis)
            if (toward[axis] != 0.0)
                near[axis] = edge[axis];
        ASSERT_TRUE(wind.follow(near - 1e-7 * toward));
        wind.velocity(points, before);
        const glm::dvec3 origin = wind.origin();
        ASSERT_TRUE(wind.follow(near + 1e-7 * toward));
        shifts += wind.origin() != origin;
        wind.velocity(points, after);
        for (std::size_t i = 0; i < points.size(); ++i)
            worst = std::max(worst, double(glm::length(after[i] - before[i])) / speed);
        at = near + 1e-7 * toward;
    }
    EXPECT_GE(shifts, 30);
    WINDROW_EXPECT_FIGURE("window/shift_changes_sampled_wind_over_max_speed", worst, 1e-6);
}

TEST(BlendZone, WithoutItAShiftShows) {
    Wind wind = stormy({.blend_width = 0.0f});
    ASSERT_TRUE(wind.follow({0.4999, 0.0, 0.0}));
    const glm::vec3 before = wind.velocity({15.8, 0.0, 0.0});
    ASSERT_TRUE(wind.follow({0.5001, 0.0, 0.0}));
    figure("window/shift_without_blend_zone_m_per_s", double(glm::length(wind.velocity({15.8, 0.0, 0.0}) - before)));
    EXPECT_GT(glm::length(wind.velocity({15.8, 0.0, 0.0}) - before), 0.01f) << "this test would not see a jump";
}

// One over the width was infinite, and nothing times that no cell: a query at the place itself read outside of the cells.
TEST(BlendZone, OfNearlyNoWidthIsAStep) {
    for (const float width : {1e-45f, 1e-39f, 1e-20f, 1e-3f}) {
        Wind wind = made({.ambient = {1.0f, 0.0f, 0.0f}, .blend_width = width});
        wind.set_velocity([](glm::dvec3) { return glm::vec3(5.0f, 0.0f, 0.0f); });
        for (const double end : {-15.0, 15.0}) {
            EXPECT_EQ(wind.velocity({end, 0.0, 0.0}).x, 1.0f) << width;
            EXPECT_EQ(wind.velocity({0.0, 0.0, end}).x, 1.0f) << width;
            EXPECT_EQ(wind.velocity({0.99 * end, 0.0, 0.0}).x, 5.0f) << width;
        }
        const PlaceBlock place = wind.frame_block({}).place;
        for (const AxisBlock& axis : {place.x, place.z})
            EXPECT_TRUE(std::isfinite(axis.edge_scale) && std::isfinite(axis.low_edge)) << width;
    }
}

TEST(BlendZone, FadesFromTheBoxToAmbient) {
    Wind wind = made({.ambient = {1.0f, 0.0f, 0.0f}, .blend_width = 4.0f});
    wind.set_velocity([](glm::dvec3) { return glm::vec3(5.0f, 0.0f, 0.0f); });
    // Half of 32 cells less one is where it has faded, four cells before that it begins.
    for (const auto& [x, expected] :
         {std::pair{0.0, 5.0f}, {10.9, 5.0f}, {13.0, 3.0f}, {15.0, 1.0f}, {15.9, 1.0f}, {40.0, 1.0f}}) {
        EXPECT_NEAR(wind.velocity({x, 0.0, 0.0}).x, expected, 1e-5) << x;
        EXPECT_NEAR(wind.velocity({-x, 0.0, 0.0}).x, expected, 1e-5) << -x;
        EXPECT_NEAR(wind.velocity({0.0, 0.0, x}).x, expected, 1e-5) << x;
    }
    float last = 5.0f;
    for (double x = 10.0; x < 17.0; x += 0.01) {
        const float u = wind.velocity({x, 0.0, 0.0}).x;
        EXPECT_LE(u, last + 1e-6f);
        EXPECT_GE(u, last - 4.0f * 0.01f * 1.5f / 4.0f - 1e-4f) << "steeper than a smooth step over four cells";
        last = u;
    }
}

TEST(BlendZone, SmallBoxesAndAxesThatStayHaveNone) {
    for (const auto& [config, axis] : {std::pair{Config{.cells = {6, 6, 6}}, 0},
                                       {Config{.cells = {32, 16, 1}}, 2},
                                       {Config{.boundaries = Boundaries::open_over_floor()}, 1}}) {
        Wind wind = made(config);
        wind.set_velocity([](glm::dvec3) { return glm::vec3(5.0f, 0.0f, 0.0f); });
        glm::dvec3 edge = wind.origin() + 0.5 * glm::dvec3(wind.box().cells) * double(wind.box().cell_size);
        edge[axis] = wind.origin()[axis] + double(wind.box().cells[axis]) - 1e-3;
        EXPECT_NEAR(wind.velocity(edge).x, 5.0f, 1e-5);
        EXPECT_EQ(wind.window_block({}).blend_reach[axis], 0.0f);
    }
}

TEST(BlendZone, TheBlockSaysWhatTheQueryDoes) {
    Wind wind = stormy({.cells = {32, 16, 24}, .cell_size = 0.5f});
    ASSERT_TRUE(wind.follow({1e6 + 0.3, -0.2, 7.1}));
    const glm::dvec3 anchor(1e6, 0.0, 5.0);
    const WindowBlock block = wind.window_block(anchor);
    EXPECT_NEAR(block.blend_centre.x, 0.3f, 1e-6);
    EXPECT_NEAR(block.blend_centre.z, 2.1f, 1e-6);
    EXPECT_FLOAT_EQ(block.blend_width, 1.0f);
    EXPECT_FLOAT_EQ(block.blend_reach.x, 7.5f);
    EXPECT_FLOAT_EQ(block.blend_reach.y, 3.5f);
    EXPECT_FLOAT_EQ(block.blend_reach.z, 5.5f);
    const glm::dvec3 beyond = anchor + glm::dvec3(block.blend_centre) + glm::dvec3(block.blend_reach.x + 1e-3, 0.0, 0.0);
    EXPECT_EQ(wind.velocity(beyond), wind.ambient());
}

// The factors of a shader give the place and the weight of a query, for each boundary kind, in this frame and in the one before.
TEST(BlendZone, TheFactorsOfTheBlockPlaceAsTheQueryDoes) {
    Boundaries lane = Boundaries::open_over_floor();
    lane.x_low.kind = lane.x_high.kind = BoundaryKind::periodic;
    const glm::dvec3 far(1e6, 40.0, -1e6);
    for (const Config& config :
         {Config{.cells = {20, 12, 16}, .centre = far},
          {.cells = {20, 12, 16}, .boundaries = Boundaries::open_over_floor(), .centre = far},
          {.cells = {20, 9, 11}, .cell_size = 0.3f, .boundaries = lane, .blend_width = 0.0f},
          {.cells = {6, 6, 6}, .boundaries = Boundaries::all(BoundaryKind::no_slip)},
          {.cells = {1, 5, 1}},
          {.cells = {12, 10, 14},
          .boundaries = Boundaries::open_over_floor(),
          .rows = Rows{.first = 0.4f, .uniform = 2, .ratio = 1.3f}},
          // The blend zone takes the whole way from the point to the faces: nothing is inner but the point.
          {.cells = {16, 16, 16}, .blend_width = 6.0f}}) {
        Wind wind = made(config);
        wind.step(0.01);
        ASSERT_TRUE(wind.follow(config.centre + glm::dvec3(1.3, 0.0, -2.4)));
        wind.step(0.01);
        const glm::dvec3 anchor = config.centre + glm::dvec3(12.3, -4.5, 6.7);
        const FrameBlock block = wind.frame_block(anchor);
        Random random(7);
        double worst_place = 0.0, worst_share = 0.0;
        int inner = 0, whole = 0;
        for (int n = 0; n < 4000; ++n) {
            const glm::dvec3 at = config.centre + random.point(0.7 * double(config.cell_size)) * glm::dvec3(config.cells);
            const glm::vec3 p(at - anchor);
            const WindView view = wind.view();
            const double share = detail::place_in(view.box(), view.window(), view.blend_zone(), view.ambient(), at).fraction;
            double by_block = 1.0, furthest = 0.0;
            bool within = true;
            const std::array axes{block.place.x, block.place.y, block.place.z};
            for (int axis = 0; axis < 3; ++axis) {
                const AxisBlock& of = axes[axis];
                // A shader finds the row from the height.
                const bool by_height = axis == 1 && config.rows;
                const double cells = by_height ? view.window().size().y : config.cells[axis];
                const double local = by_height ? at.y - view.origin().y : view.window().local(at)[axis];
                within = within && local >= 0.0 && local <= cells;
                worst_place =
                    std::max(worst_place, std::abs(double(of.texture_scale * p[axis] + of.texture_offset) * cells - local));
                furthest = std::max(furthest, double(std::abs(of.inner_scale * p[axis] + of.inner_offset)));
                by_block *= double(numerics::windrow_edge_share(of.low_edge + of.edge_scale * p[axis],
                                                                of.high_edge - of.edge_scale * p[axis], of.smoothness));
            }
            worst_share = std::max(worst_share, std::abs(by_block - share));
            if (furthest <= 1.0) {
                ++inner;
                EXPECT_GT(share, 1.0 - 1e-5);
            }
            whole += within && share == 1.0;
        }
        EXPECT_GE(inner, whole - 5) << "all that is the box's alone is inner";
        WINDROW_EXPECT_FIGURE("factors.place", worst_place, 2e-5);
        WINDROW_EXPECT_FIGURE("factors.share", worst_share, 2e-5);
        const AxisBlock& now = block.place.x;
        const AxisBlock& before = block.previous_place.x;
        EXPECT_NEAR(now.texture_offset - before.texture_offset,
                    (block.window.previous_origin.x - block.window.origin.x) * now.texture_scale, 1e-6);
        EXPECT_EQ(now.texture_scale, before.texture_scale);
    }
}

// A point that is far off the box, as after a jump between two ticks: no place is within both, so none is inner.
TEST(BlendZone, ABoxThatItsPointHasLeftHasNoWeight) {
    const FrameBlock block = frame_block({.origin = {-19.0f, -8.0f, -8.0f},
                                          .cell_size = 1.0f,
                                          .cells = {16.0f, 16.0f, 16.0f},
                                          .blend_centre = {9.0f, 0.0f, 0.0f},
                                          .blend_width = 2.0f,
                                          .blend_reach = {7.0f, 7.0f, 7.0f}},
                                         {}, {});
    const AxisBlock& x = block.place.x;
    for (float p = -40.0f; p < 40.0f; p += 0.5f) {
        EXPECT_GT(std::abs(x.inner_scale * p + x.inner_offset), 1.0f) << p;
        EXPECT_EQ(numerics::windrow_edge_share(x.low_edge + x.edge_scale * p, x.high_edge - x.edge_scale * p, x.smoothness), 0.0f)
            << p;
    }
}

/// Second differences in time of the wind at fixed points along the way of someone who walks at an even speed, frame by frame:
/// the root mean square over the points, apart for frames near a shift of the box.
struct Jolts {
    std::vector<double> calm, at_shift;
    double max_speed = 0.0;
};

double median(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double largest(const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
}

Jolts walk(Wind& wind) {
    constexpr double k_dt = 1.0 / 60.0, k_speed = 1.4;
    for (int n = 0; n < 300; ++n) // what blows stands
        wind.step(k_dt);
    std::vector<glm::dvec3> points;
    Random random(44);
    for (int n = 0; n < 200; ++n)
        points.push_back(random.point(14.0) * glm::dvec3(1.0, 0.4, 1.0));
    std::vector<std::vector<glm::vec3>> seen;
    std::vector<bool> shifted;
    Jolts jolts;
    for (int n = 1; n <= 300; ++n) {
        const glm::dvec3 origin = wind.origin();
        EXPECT_TRUE(wind.follow({k_speed * k_dt * n, 0.0, 0.0}));
        jolts.max_speed = double(wind.step(k_dt).max_speed);
        shifted.push_back(wind.origin() != origin);
        seen.emplace_back(points.size());
        wind.velocity(points, seen.back());
    }
    for (std::size_t n = 2; n < seen.size(); ++n) {
        double squares = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::vec3 second = seen[n][i] - 2.0f * seen[n - 1][i] + seen[n - 2][i];
            squares += double(glm::dot(second, second));
        }
        (shifted[n] || shifted[n - 1] ? jolts.at_shift : jolts.calm).push_back(std::sqrt(squares / double(points.size())));
    }
    EXPECT_GE(jolts.at_shift.size(), 10u);
    return jolts;
}

TEST(BlendZone, AWalkThroughGustsFeelsNoShift) {
    Wind wind = made({.ambient = {2.0f, 0.0f, 0.5f}, .gusts = {.intensity = 0.3f}});
    const Jolts jolts = walk(wind);
    figure("window/walk_in_gusts/second_difference_median_m_per_s", median(jolts.calm));
    WINDROW_EXPECT_FIGURE("window/walk_in_gusts/at_shifts_over_median", median(jolts.at_shift) / median(jolts.calm), 1.5);
    WINDROW_EXPECT_FIGURE("window/walk_in_gusts/worst_at_shifts_over_worst", largest(jolts.at_shift) / largest(jolts.calm), 1.5);
}

// The air of a motor reaches the open boundaries. Where these move, the pressure of the whole box changes a little.
TEST(BlendZone, AWalkPastAFanFeelsAThousandthAtMost) {
    Wind wind = made({.ambient = {2.0f, 0.0f, 0.5f}});
    ASSERT_TRUE(wind.motors().add(DirectionalMotor{.position = {4.0, 0.0, 1.0}, .direction = {-1.0f, 0.0f, 1.0f}}));
    const Jolts jolts = walk(wind);
    figure("window/walk_past_a_fan/at_shifts_over_median", largest(jolts.at_shift) / median(jolts.calm));
    WINDROW_EXPECT_FIGURE("window/walk_past_a_fan/at_shifts_over_max_speed", largest(jolts.at_shift) / jolts.max_speed, 1e-3);
}

} // namespace
