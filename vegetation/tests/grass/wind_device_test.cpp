// The field's own vertex stage in Windrow's wind, as a host binds it: even air gives the picture of that even wind, and a fan
// another.
#include "fluid/vulkan/wind.h"
#include "shader_words/grass_wind_vert.h"
#include "shader_words/windy_frag.h"
#include "tests/figure.h"
#include "vegetation/tests/grass/device.h"
#include "vegetation/tests/grass/picture.h"
#include "vegetation/vulkan/wind_set.h"

namespace windrow::vegetation::grass {
namespace {

using GrassInTheWind = test::GrassOnTheDevice;

TEST_F(GrassInTheWind, LeansAsTheAirBlows) {
    GrassSettings settings = test::small_field();
    settings.min_width = 0.005f;
    make_field(settings);
    const glm::dvec3 corner(3.0e4, 0.0, -2.0e4), middle = corner + glm::dvec3(16.0, 2.0, 25.0);
    ASSERT_TRUE(field->place(corner));
    const test::Eye eye = test::eye_at({16.0f, 3.5f, 8.0f}, {0.0f, -0.2f, 1.0f});
    const GrassCamera camera{.anchor = corner, .view_projection = eye.view_projection, .eye = eye.at};
    auto wind = windrow::vulkan::Wind::create(
        own->host(), {.cells = {24, 8, 24}, .centre = middle, .ambient = {1.5f, 0.0f, 0.0f}}, {.frames_in_flight = 1});
    ASSERT_TRUE(wind) << wind.error();
    {
        engine::Objects objects(*renders);
        engine::WindSet wind_set(objects);
        const test::Picture still(*renders, test::Picture::still(*field));
        const test::Picture windy(*renders, {{wind_set.layout(), field->layout()},
                                             windrow::vulkan::shader_words::grass_wind_vert,
                                             windrow::vulkan::shader_words::windy_frag});
        const auto draw = [&](const test::Picture& picture) {
            run([&](VkCommandBuffer commands) {
                renders->begin_frame(commands, 0);
                held(wind->record(commands, {.dt = 1.0 / 30.0}));
                const VkDescriptorSet set = wind_set.of(0, *wind, corner, {});
                EXPECT_TRUE(field->record_cull(commands, camera));
                picture.record(commands, *field, eye.view_projection, View::colour, &picture == &windy ? set : VK_NULL_HANDLE);
            });
            return picture.pixels();
        };
        const auto changed = [](const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
            std::size_t count = 0;
            for (std::size_t n = 0; n < a.size(); ++n)
                count += a[n] != b[n];
            return static_cast<double>(count);
        };
        const auto wanted = draw(still), even = draw(windy);
        double covered = 0.0;
        for (const std::uint32_t pixel : wanted)
            covered += pixel != 0;
        EXPECT_GT(covered, 10'000.0);
        // Sampled air is 1.5 m/s to rounding, so that an edge may pass a pixel's centre: in less than a thousandth.
        WINDROW_EXPECT_FIGURE("grass/wind/share_of_pixels_of_even_air_unlike_an_even_wind", changed(wanted, even) / covered,
                              1e-3);
        ASSERT_TRUE(wind->motors().add(
            windrow::JetMotor{.position = middle + glm::dvec3(-4.0, -1.0, -6.0), .direction = {0.0f, 0.0f, 1.0f}}));
        for (int n = 0; n < 20; ++n)
            run([&](VkCommandBuffer commands) { held(wind->record(commands, {.dt = 1.0 / 30.0})); });
        const double moved = changed(even, draw(windy));
        windrow::test::figure("grass/wind/share_of_grass_pixels_changed_by_a_jet", moved / covered);
        EXPECT_GT(moved, 0.02 * covered);
    }
}

} // namespace
} // namespace windrow::vegetation::grass
