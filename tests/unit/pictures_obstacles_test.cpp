// Obstacles and streamlines on slices: a section is where the body is, a line goes along the wind, apart from others and around
// bodies.
#include "cli/drawing/sections.h"
#include "cli/drawing/streamlines.h"
#include "tests/shapes.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

namespace windrow::cli {
namespace {

constexpr Rgb8 k_grey{0xA7, 0xA3, 0x9C};

SlicedAir air_of(std::function<glm::dvec3(glm::dvec3)> velocity_at, std::vector<NamedObstacle> obstacles = {}) {
    SlicedAir air{.box = {.cells = {40, 16, 24}, .cell_size = 0.5f, .boundaries = {}},
                  .origin = {1e6, -2.0, 5.0}, // a float of the place would be half a cell off
                  .velocity = {},
                  .obstacles = std::move(obstacles)};
    air.velocity = [velocity_at](std::span<const glm::dvec3> positions, std::span<glm::vec3> velocities) {
        for (std::size_t n = 0; n < positions.size(); ++n)
            velocities[n] = glm::vec3(velocity_at(positions[n]));
    };
    return air;
}

glm::dvec3 even_wind(glm::dvec3) {
    return {3.0, 0.0, 1.0};
}

const glm::dvec3 k_middle{1e6 + 10.0, 2.0, 11.0};
const glm::quat k_turned = glm::angleAxis(0.6f, glm::normalize(glm::vec3(1.0f, 2.0f, -0.5f)));

std::vector<NamedObstacle> bodies() {
    return {{"ball", {.position = k_middle + glm::dvec3(-4.0, 0.3, 1.0), .shape = Sphere{1.5f}}},
            {"block",
             {.position = k_middle + glm::dvec3(2.0, 0.0, 0.0), .orientation = k_turned, .shape = Block{{3.0f, 1.0f, 0.6f}}}}};
}

TEST(Sections, AreWhereTheBodiesAre) {
    const SlicedAir air = air_of(even_wind, bodies());
    for (const Plane& plane : {Plane{Normal::y, k_middle.y}, Plane{Normal::z, k_middle.z}, Plane{Normal::x, k_middle.x + 2.0}}) {
        constexpr int k_width = 160, k_height = 96;
        const SlicePicture slice = render_slice(air, plane, 10.0f, k_width, k_height);
        const std::vector<CutBody> cut = bodies_at(air.obstacles, plane, air);
        int inside = 0;
        for (int row = 0; row < k_height; ++row)
            for (int column = 0; column < k_width; ++column) {
                const glm::dvec2 share((column + 0.5) / k_width,
                                       plane.grows_upward() ? 1.0 - (row + 0.5) / k_height : (row + 0.5) / k_height);
                const glm::dvec3 world = plane.to_world(plane.in_plane(air.origin) + share * plane.in_plane(air.extent()));
                float nearest = 1e9f;
                for (const NamedObstacle& body : air.obstacles) {
                    const glm::vec3 own = glm::inverse(body.obstacle.orientation) * glm::vec3(world - body.obstacle.position);
                    nearest = std::min(nearest, detail::distance_to(body.obstacle.shape, own));
                }
                const Rgb8 seen = slice.image.at(column, row);
                if (nearest < -0.4f) { // beyond the outline
                    EXPECT_EQ(seen, k_grey) << column << ' ' << row;
                    EXPECT_TRUE(inside_body(cut, world));
                    ++inside;
                } else if (nearest > 0.4f) {
                    EXPECT_EQ(seen, speed_colour(std::sqrt(10.0f) / 10.0f)) << column << ' ' << row;
                    EXPECT_FALSE(inside_body(cut, world));
                }
            }
        EXPECT_GT(inside, 20);
    }
}

// A level slice above the ground: the wind of 1 m/s a metre above it has one colour, but where a line of equal height or a house is.
TEST(Sections, ALevelSliceFollowsTheGround) {
    const auto height = [](double x, double z) { return 1.0 + 0.1 * x + 0.05 * z; };
    const Obstacle ground{
        .position = {1e6 - 4.0, -2.0, 1.0},
        .shape = Ground{test::heights_of({29, 21}, 1.0f, [&](double x, double z) { return height(x - 4.0, z - 4.0); })}};
    const glm::dvec3 foot(1e6 + 15.0, 0.0, 11.0);
    const auto over_ground = [&](glm::dvec3 p) { return p.y + 2.0 - height(p.x - 1e6, p.z - 5.0); };
    const SlicedAir air = air_of(
        [&](glm::dvec3 p) {
            return glm::dvec3{std::max(over_ground(p), 0.0), 0.0, 0.0};
        },
        {{"hills", ground},
         {"house", {.position = {foot.x, height(15.0, 6.0) - 2.0, foot.z}, .shape = Block{{1.0f, 1.5f, 1.0f}}}}});
    const SlicedAir over = above_ground(air);
    EXPECT_NEAR(over.ground({foot.x, foot.z}), height(15.0, 6.0) - 2.0, 1e-5);
    EXPECT_NEAR(contour_step(over), 0.5, 1e-9); // 2.6 m in all
    const Plane plane{Normal::y, 1.0 - 2.0};
    const SlicePicture slice = render_slice(over, plane, 4.0f, 160, 96);
    int even = 0, lines = 0, house = 0;
    for (int row = 0; row < 96; ++row)
        for (int column = 0; column < 160; ++column) {
            const Rgb8 seen = slice.image.at(column, row);
            (seen == speed_colour(0.25f) ? even : seen == k_grey ? house : lines) += 1;
        }
    EXPECT_NEAR(house, 16 * 16, 64); // 2 m of 20 m and of 12 m, less its outline
    EXPECT_NEAR(even + lines + house, 160 * 96, 0);
    EXPECT_GT(lines, 5 * 96 / 2);
    EXPECT_LT(lines, 160 * 96 / 10);
    EXPECT_EQ(render_slice(air, plane, 4.0f, 160, 96).image.at(150, 90), k_grey) << "a level one cuts the hills";
}

TEST(Sections, TheLargestSpeedIsThatOfAir) {
    std::vector<NamedObstacle> train{{"train", {.position = k_middle, .shape = Block{{2.0f, 2.0f, 2.0f}}}}};
    const auto wind = [&](glm::dvec3 place) {
        const glm::dvec3 off = glm::abs(place - k_middle);
        return glm::dvec3(std::max({off.x, off.y, off.z}) < 2.0 ? 30.0 : 4.0, 0.0, 0.0);
    };
    EXPECT_FLOAT_EQ(render_slice(air_of(wind, train), {Normal::y, 2.0}, 10.0f, 80, 48).largest, 4.0f);
}

TEST(Sections, APlateIsALine) {
    const glm::quat yawed = glm::angleAxis(0.5f, glm::vec3(0.0f, 1.0f, 0.0f));
    const SlicedAir air =
        air_of(even_wind, {{"fence", {.position = k_middle, .orientation = yawed, .shape = Plate{{3.0f, 1.0f}}}}});
    const auto cut_at = [&](const Plane& plane) {
        const auto found = bodies_at(air.obstacles, plane, air);
        return found.empty() ? std::nullopt : cut_of(found.front(), plane);
    };
    const auto ends = cut_at({Normal::y, k_middle.y + 0.5});
    ASSERT_TRUE(ends);
    EXPECT_NEAR(glm::distance(ends->first, ends->second), 6.0, 1e-5);
    const glm::dvec2 along = glm::normalize(ends->second - ends->first);
    EXPECT_NEAR(std::abs(along.x * std::cos(0.5) - along.y * std::sin(0.5)), 1.0, 1e-5) << "a yaw turns x to -z";
    EXPECT_NEAR(glm::distance(0.5 * (ends->first + ends->second), {k_middle.x, k_middle.z}), 0.0, 1e-5);
    EXPECT_FALSE(cut_at({Normal::y, k_middle.y + 1.1})) << "above it";
}

// --- Streamlines -----------------------------------------------------------------------------------------------------

/// A whirl about the middle that also flows along x.
glm::dvec3 whirl(glm::dvec3 place) {
    const glm::dvec3 off = place - k_middle;
    return {1.0 - 0.8 * off.z, 0.0, 0.8 * off.x};
}

/// Lines that come together.
glm::dvec3 funnel(glm::dvec3 place) {
    return {2.0, 0.0, -0.4 * (place.z - k_middle.z)};
}

void expect_even_lines(const std::function<glm::dvec3(glm::dvec3)>& wind) {
    const SlicedAir air = air_of(wind);
    const Plane plane{Normal::y, 2.0};
    constexpr double k_spacing = 0.8;
    const auto lines = streamlines(air, plane, {}, k_spacing, 1e-3);
    ASSERT_GT(lines.size(), 8u);
    for (std::size_t a = 0; a < lines.size(); ++a) {
        for (std::size_t n = 1; n < lines[a].size(); ++n) {
            const glm::dvec2 step = lines[a][n] - lines[a][n - 1], middle = 0.5 * (lines[a][n] + lines[a][n - 1]);
            const glm::dvec2 flow = plane.in_plane(wind(plane.to_world(middle)));
            if (glm::length(flow) > 0.5) { // beside the centre a step turns far
                EXPECT_GT(glm::dot(glm::normalize(step), glm::normalize(flow)), 0.995);
            }
        }
        for (std::size_t b = 0; b < a; ++b)
            for (const glm::dvec2 one : lines[a])
                for (const glm::dvec2 other : lines[b])
                    ASSERT_GE(glm::distance(one, other), 0.5 * k_spacing);
    }
    // No gap: each place is near some line, or near a side of the box, where short ones are left out.
    for (double x = 2.0; x < 18.0; x += 0.4)
        for (double z = 2.0; z < 10.0; z += 0.4) {
            const glm::dvec2 place(1e6 + x, 5.0 + z);
            double nearest = 1e9;
            for (const Streamline& line : lines)
                for (const glm::dvec2 point : line)
                    nearest = std::min(nearest, glm::distance(point, place));
            EXPECT_LT(nearest, 1.6 * k_spacing) << x << ' ' << z;
        }
}

TEST(Streamlines, GoAlongTheWindAndKeepTheirDistance) {
    expect_even_lines(whirl);
    expect_even_lines(funnel);
}

TEST(Streamlines, StopAtBodiesAndPlates) {
    // The wind blows through them, as a reader between cells may see it.
    std::vector<NamedObstacle> all = bodies();
    all.push_back({"fence",
                   {.position = k_middle + glm::dvec3(6.0, 0.0, 0.0),
                    .orientation = glm::angleAxis(1.5707963f, glm::vec3(0.0f, 1.0f, 0.0f)),
                    .shape = Plate{{3.0f, 1.0f}}}});
    const SlicedAir air = air_of(even_wind, all);
    const Plane plane{Normal::y, 2.0};
    const auto cut = bodies_at(air.obstacles, plane, air);
    ASSERT_EQ(cut.size(), 3u);
    const auto lines = streamlines(air, plane, cut, 0.5, 1e-3);
    ASSERT_GT(lines.size(), 20u);
    for (const Streamline& line : lines)
        for (std::size_t n = 1; n < line.size(); ++n) {
            EXPECT_FALSE(inside_body(cut, plane.to_world(line[n])));
            for (const CutBody& body : cut)
                EXPECT_FALSE(body.blocks(plane.to_world(line[n - 1]), plane.to_world(line[n]))) << body.named->name;
        }
}

TEST(Streamlines, CalmOrBrokenAirHasNone) {
    const auto none = [](glm::dvec3) { return glm::dvec3(0.0); };
    const auto broken = [](glm::dvec3) { return glm::dvec3(std::nan("")); };
    EXPECT_TRUE(streamlines(air_of(none), {Normal::y, 2.0}, {}, 0.5, 1e-3).empty());
    EXPECT_TRUE(streamlines(air_of(broken), {Normal::z, 11.0}, {}, 0.5, 1e-3).empty());
}

} // namespace
} // namespace windrow::cli
