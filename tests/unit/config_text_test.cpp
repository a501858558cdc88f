// Settings as C++ text: the text here is compiled, and is what the compiled settings are written as.
#include "scene/config_text.h"

#include <gtest/gtest.h>
#include <string>

namespace windrow::scene {
namespace {

struct Sample {
    Config config;
    std::string text;
};
#define WINDROW_BOTH(...)                                                                                                        \
    Sample {                                                                                                                     \
        __VA_ARGS__, #__VA_ARGS__                                                                                                \
    }

/// Each setting of a scene file differs from its default.
const Sample k_all = WINDROW_BOTH(
    windrow::Config{.cells = {48, 16, 40},
                    .cell_size = 0.75f,
                    .boundaries = {.x_low = {.kind = windrow::BoundaryKind::periodic},
                                   .x_high = {.kind = windrow::BoundaryKind::periodic},
                                   .y_low = {.kind = windrow::BoundaryKind::no_slip, .wall_velocity = {1.0f, 0.0f, -0.1f}}},
                    .centre = {1241.0, 0.1, 994.0},
                    .floor = 4.5,
                    .follow_axes = glm::bvec3{false, false, true},
                    .ambient = {3.4f, 0.0f, 1e-10f},
                    .profile = windrow::LogProfile{.roughness_length = 0.05f},
                    .gusts = {.intensity = 0.25f, .length = 14.0f, .seed = 7u},
                    .canopy = windrow::Canopy{.height = 1.2f},
                    .roughness = windrow::Roughness{},
                    .rows = windrow::Rows{.first = 0.25f, .uniform = 3, .ratio = 1.2f},
                    .blend_width = 3.0f,
                    .viscosity = 0.01f,
                    .relaxation_time = 200.0f,
                    .sleep_speed = 0.0f,
                    .jump_speed = 50.0f,
                    .scheme = windrow::Scheme::stable_fluids,
                    .interpolation = windrow::Interpolation::linear,
                    .max_cfl = 1e+06f,
                    .max_substeps = 4,
                    .pressure_solves = 3});

/// Without the spaces that a formatter chooses.
std::string packed(std::string text) {
    std::erase(text, ' ');
    std::erase(text, '\n');
    return text;
}

TEST(ConfigText, IsCppThatMakesTheSameSettings) {
    const auto written = write_cpp(k_all.config);
    ASSERT_TRUE(written) << written.error();
    EXPECT_EQ(packed(*written), packed(k_all.text));
    for_each_setting(k_all.config, [&]<class Row>(const Row& row, const auto&) {
        if constexpr (Row::k_stored == Stored::everywhere) {
            EXPECT_NE(written->find(std::string(".") + row.name + " = "), std::string::npos) << row.name;
        }
    });
}

TEST(ConfigText, LeavesDefaultsOut) {
    EXPECT_EQ(*write_cpp({}), "windrow::Config{}");
}

TEST(ConfigText, RejectsAMapOfRoughness) {
    Config config;
    config.roughness.emplace().map.emplace();
    const auto written = write_cpp(config);
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().find("$.air.roughness.map"), std::string::npos);
}

} // namespace
} // namespace windrow::scene
