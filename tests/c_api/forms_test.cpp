// Gust tiles as bytes, and lines of a debug view, in C: what comes back has the bits of what went, and damage is found.
#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>
#include <windrow/windrow.h>

namespace {

struct EndForm {
    void operator()(windrow_gust_tile* tile) const { windrow_gust_tile_destroy(tile); }
    void operator()(windrow_wind* wind) const { windrow_wind_destroy(wind); }
};
template <class Kind>
using Held = std::unique_ptr<Kind, EndForm>;

std::string taken(windrow_bytes* bytes) {
    std::string copy(reinterpret_cast<const char*>(windrow_bytes_data(bytes)), windrow_bytes_size(bytes));
    windrow_bytes_destroy(bytes);
    return copy;
}

TEST(FormsInC, AGustTileComesBackWithItsBits) {
    windrow_gust_tile *made = nullptr, *back = nullptr;
    ASSERT_EQ(windrow_gust_tile_bake(7, &made), WINDROW_OK);
    const Held<windrow_gust_tile> tile(made);
    windrow_bytes* bytes = nullptr;
    ASSERT_EQ(windrow_gust_tile_save(tile.get(), &bytes), WINDROW_OK);
    std::string saved = taken(bytes);
    EXPECT_LT(saved.size(), 64u);
    ASSERT_EQ(windrow_gust_tile_load(saved.data(), saved.size(), &back), WINDROW_OK) << windrow_last_error();
    const Held<windrow_gust_tile> loaded(back);
    std::uint64_t count = 0, again = 0;
    const windrow_vec4* const before = windrow_gust_tile_texels(tile.get(), &count);
    const windrow_vec4* const after = windrow_gust_tile_texels(loaded.get(), &again);
    ASSERT_EQ(count, again);
    EXPECT_EQ(std::memcmp(before, after, count * sizeof(windrow_vec4)), 0);
    saved[24] = static_cast<char>(saved[24] ^ 1);
    EXPECT_EQ(windrow_gust_tile_load(saved.data(), saved.size(), &back), WINDROW_REJECTED);
    EXPECT_EQ(back, nullptr);
}

TEST(DebugLinesInC, DrawTheBoxMotorsObstaclesAndArrows) {
    windrow_config config;
    ASSERT_EQ(windrow_config_init(&config, sizeof config), WINDROW_OK);
    config.cells = {10, 8, 6};
    config.cell_size = 2.0f;
    config.ambient = {3.0f, 0.0f, 4.0f};
    config.boundaries = windrow_boundaries_open_over_floor();
    windrow_wind* made = nullptr;
    ASSERT_EQ(windrow_wind_create(&config, &made), WINDROW_OK);
    const Held<windrow_wind> wind(made);
    windrow_obstacle obstacle;
    ASSERT_EQ(windrow_obstacle_init(&obstacle, sizeof obstacle), WINDROW_OK);
    obstacle.position = {4.0, 1.0, 2.0};
    obstacle.orientation = {0.0f, 0.70710678f, 0.0f, 0.70710678f}; // a quarter about y
    obstacle.shape = windrow_shape_block({1.0f, 1.0f, 3.0f});
    windrow_obstacle_id body{};
    ASSERT_EQ(windrow_wind_add_obstacle(wind.get(), &obstacle, &body), WINDROW_OK);
    windrow_jet_motor jet;
    ASSERT_EQ(windrow_jet_motor_init(&jet, sizeof jet), WINDROW_OK);
    jet.position = {-3.0, 2.0, 0.0};
    windrow_motor_id motor{};
    ASSERT_EQ(windrow_wind_add_jet(wind.get(), &jet, &motor), WINDROW_OK) << windrow_last_error();

    std::map<windrow_debug_kind, std::vector<windrow_debug_line>> lines;
    const auto keep = [](void* user, const windrow_debug_line* line) {
        (*static_cast<decltype(lines)*>(user))[line->kind].push_back(*line);
    };
    windrow_debug_view view;
    ASSERT_EQ(windrow_debug_view_init(&view, sizeof view), WINDROW_OK);
    view.arrows = 4;
    view.seconds = 0.5f;
    view.height = 5.0;
    ASSERT_EQ(windrow_wind_debug_lines(wind.get(), &view, keep, &lines), WINDROW_OK) << windrow_last_error();
    ASSERT_EQ(lines[WINDROW_DEBUG_BOX].size(), 12u);
    ASSERT_EQ(lines[WINDROW_DEBUG_OBSTACLE].size(), 12u);
    EXPECT_EQ(lines[WINDROW_DEBUG_MOTOR].size(), 16u + 16u + 4u + 3u);
    ASSERT_EQ(lines[WINDROW_DEBUG_ARROW].size(), 4u * 4u * 3u);
    windrow_dvec3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
    for (const windrow_debug_line& line : lines[WINDROW_DEBUG_OBSTACLE])
        for (const windrow_dvec3& end : {line.begin, line.end}) {
            low = {std::min(low.x, end.x), std::min(low.y, end.y), std::min(low.z, end.z)};
            high = {std::max(high.x, end.x), std::max(high.y, end.y), std::max(high.z, end.z)};
        }
    EXPECT_NEAR(high.x - low.x, 6.0, 1e-5) << "its long side lies along x";
    EXPECT_NEAR(high.z - low.z, 2.0, 1e-5);
    EXPECT_NEAR(low.x + high.x, 8.0, 1e-5);
    const windrow_dvec3 origin = windrow_wind_origin(wind.get());
    for (const windrow_debug_line& line : lines[WINDROW_DEBUG_BOX])
        EXPECT_TRUE(line.begin.x == origin.x || line.begin.x == origin.x + 20.0);
    // The first line of each arrow is the way of the air, from a cell's place at the height that was asked for.
    for (std::size_t n = 0; n < lines[WINDROW_DEBUG_ARROW].size(); n += 3) {
        const windrow_debug_line& line = lines[WINDROW_DEBUG_ARROW][n];
        windrow_vec3 velocity;
        ASSERT_EQ(windrow_wind_velocity(wind.get(), line.begin, &velocity), WINDROW_OK);
        EXPECT_EQ(line.begin.y, origin.y + 5.0);
        EXPECT_NEAR(line.end.x - line.begin.x, 0.5 * static_cast<double>(velocity.x), 1e-6);
        EXPECT_NEAR(line.end.z - line.begin.z, 0.5 * static_cast<double>(velocity.z), 1e-6);
        EXPECT_NEAR(line.speed, 5.0f, 1e-4f);
    }
    lines.clear();
    view.box = view.motors = view.obstacles = 0;
    view.arrows = 0;
    ASSERT_EQ(windrow_wind_debug_lines(wind.get(), &view, keep, &lines), WINDROW_OK);
    EXPECT_TRUE(lines.empty());
    view.arrows = 257;
    EXPECT_EQ(windrow_wind_debug_lines(wind.get(), &view, keep, &lines), WINDROW_REJECTED);
    EXPECT_STREQ(windrow_last_error(), "arrows is 257: give 0 to 256 along an axis.");
    EXPECT_EQ(windrow_wind_debug_lines(wind.get(), nullptr, nullptr, nullptr), WINDROW_REJECTED);
}

} // namespace
