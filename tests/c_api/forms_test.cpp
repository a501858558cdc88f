// Forms as bytes, and lines of a debug view, in C: what comes back has the bits of what went, and damage is found.
#include "tests/shapes.h"

#include <array>
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
    void operator()(windrow_mesh* mesh) const { windrow_mesh_destroy(mesh); }
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

/// Two balls that meet: a union with a surface of its own.
windrow::MeshData twins() {
    return windrow::test::both(
        windrow::test::ball_mesh(1.0f, 3),
        windrow::test::placed(windrow::test::ball_mesh(1.0f, 3), [](glm::vec3 v) { return v + glm::vec3(1.2f, 0.1f, 0.0f); }));
}

std::vector<float> distances(const windrow_mesh* mesh) {
    std::vector<float> found;
    for (int n = 0; n < 4000; ++n)
        found.push_back(windrow_mesh_distance(mesh, {-2.0f + 0.3f * static_cast<float>(n % 17),
                                                     -1.5f + 0.21f * static_cast<float>(n / 17 % 15),
                                                     -1.5f + 0.2f * static_cast<float>(n / 255)}));
    return found;
}

TEST(FormsInC, AMeshComesBackWithItsBits) {
    const windrow::MeshData data = twins();
    windrow_mesh* made = nullptr;
    ASSERT_EQ(windrow_mesh_create(reinterpret_cast<const windrow_vec3*>(data.vertices.data()), data.vertices.size(),
                                  reinterpret_cast<const std::uint32_t*>(data.triangles.data()), data.triangles.size(), &made),
              WINDROW_OK)
        << windrow_last_error();
    const Held<windrow_mesh> mesh(made);
    windrow_bytes* bytes = nullptr;
    ASSERT_EQ(windrow_mesh_save(mesh.get(), &bytes), WINDROW_OK);
    const std::string saved = taken(bytes);
    windrow_mesh* back = nullptr;
    ASSERT_EQ(windrow_mesh_load(saved.data(), saved.size(), &back), WINDROW_OK) << windrow_last_error();
    const Held<windrow_mesh> loaded(back);
    const auto before = distances(mesh.get()), after = distances(loaded.get());
    EXPECT_EQ(std::memcmp(before.data(), after.data(), before.size() * sizeof(float)), 0);
    ASSERT_EQ(windrow_mesh_save(loaded.get(), &bytes), WINDROW_OK);
    EXPECT_EQ(taken(bytes), saved);

    // Air about either has the same bits.
    std::array<std::vector<windrow_vec4>, 2> fields;
    for (std::size_t n = 0; n < 2; ++n) {
        windrow_config config;
        ASSERT_EQ(windrow_config_init(&config, sizeof config), WINDROW_OK);
        config.cells = {20, 12, 12};
        config.cell_size = 0.4f;
        config.ambient = {5.0f, 0.0f, 1.0f};
        windrow_wind* wind = nullptr;
        ASSERT_EQ(windrow_wind_create(&config, &wind), WINDROW_OK);
        const Held<windrow_wind> held(wind);
        windrow_obstacle obstacle;
        ASSERT_EQ(windrow_obstacle_init(&obstacle, sizeof obstacle), WINDROW_OK);
        obstacle.shape = windrow_shape_mesh(n == 0 ? mesh.get() : loaded.get(), 1.0f);
        windrow_obstacle_id id{};
        ASSERT_EQ(windrow_wind_add_obstacle(wind, &obstacle, &id), WINDROW_OK) << windrow_last_error();
        for (int step = 0; step < 5; ++step)
            ASSERT_EQ(windrow_wind_step(wind, 1.0 / 60.0, nullptr), WINDROW_OK);
        const windrow_vec4* cells = nullptr;
        std::uint64_t count = 0;
        ASSERT_EQ(windrow_wind_field(wind, WINDROW_FRAME_NOW, &cells, &count, nullptr), WINDROW_OK);
        fields[n].assign(cells, cells + count);
    }
    EXPECT_EQ(std::memcmp(fields[0].data(), fields[1].data(), fields[0].size() * sizeof(windrow_vec4)), 0);
}

TEST(FormsInC, DamagedMeshesAreRejected) {
    const auto made = windrow::TriangleMesh::create(windrow::test::box_mesh(glm::vec3(1.0f)));
    ASSERT_TRUE(made);
    const auto saved = (*made)->save();
    ASSERT_TRUE(saved);
    windrow_mesh* mesh = nullptr;
    const auto rejected = [&](const std::vector<std::byte>& bytes, const char* words) {
        EXPECT_EQ(windrow_mesh_load(bytes.data(), bytes.size(), &mesh), WINDROW_REJECTED);
        EXPECT_EQ(mesh, nullptr);
        EXPECT_NE(std::string_view(windrow_last_error()).find(words), std::string_view::npos) << windrow_last_error();
    };
    for (std::size_t n = 0; n < saved->size(); n += 7) { // each byte is under the checksum, or is its own reason
        auto bytes = *saved;
        bytes[n] ^= std::byte{4};
        EXPECT_EQ(windrow_mesh_load(bytes.data(), bytes.size(), &mesh), WINDROW_REJECTED) << n;
    }
    auto bytes = *saved;
    bytes.pop_back();
    rejected(bytes, "truncated");
    rejected({std::byte{1}}, "are not a Windrow made mesh");
    EXPECT_EQ(windrow_mesh_load(nullptr, 0, &mesh), WINDROW_REJECTED);
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
    EXPECT_EQ(lines[WINDROW_DEBUG_MOTOR].size(), 24u + 24u + 4u + 3u);
    ASSERT_EQ(lines[WINDROW_DEBUG_ARROW].size(), 4u * 2u * 3u);
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
    EXPECT_STREQ(windrow_last_error(), "arrows is 257: give 0 to 256 along the longer level axis.");
    EXPECT_EQ(windrow_wind_debug_lines(wind.get(), nullptr, nullptr, nullptr), WINDROW_REJECTED);
}

} // namespace
