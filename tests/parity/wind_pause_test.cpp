// A dt of 0: what was asked for shows, the air stays where it is, and both sets of textures lie where they are said to.
#include "tests/parity/wind_parity.h"

namespace windrow::vulkan {
namespace {

class WindPauses : public WindParity {
  protected:
    static glm::vec3 place(const Wind& wind) { return wind.window_block({}).origin; }
    static glm::vec3 place_before(const Wind& wind) { return glm::vec3(wind.window_block({}).previous_origin); }
    static glm::vec3 blend_centre(const Wind& wind) { return wind.window_block({}).blend_centre; }
    static glm::vec3 rim_point_before(const Wind& wind) { return wind.window_block({}).previous_blend_centre; }
};

// Between ticks too: a pause by record_step ends no tick and shows none early.
TEST_F(WindPauses, OfAHostWithTicksKeepTheirMomentBetweenThem) {
    TwoWinds pair = make({.cells = {12, 10, 11}, .ambient = {2.0f, 0.0f, 1.0f}});
    pair.add(VortexMotor{.radius = 3.0f});
    for (int n = 0; n < 20; ++n) {
        frame(pair, 1.0 / 47.0);
        pair.set_ambient({2.0f + 0.1f * static_cast<float>(n), 0.0f, 1.0f});
        frame_of(
            pair, [&](VkCommandBuffer commands, int slot) { held(pair.device.record_step(commands, {.dt = 0.0, .slot = slot})); },
            [&] { (void)pair.cpu.advance(0.0); });
        EXPECT_EQ(pair.device.window_block({}).factor, pair.cpu.window_block({}).factor);
    }
    EXPECT_EQ(pair.compared, 39);
    report("paused", pair, 1e-5);
}

TEST_F(WindPauses, LieWhereTheirTexturesWereWritten) {
    for (const bool ticks : {false, true}) {
        auto wind = Wind::create(sharing_host(), {.cells = {10, 10, 10}, .ambient = {2.0f, 0.0f, 1.0f}});
        ASSERT_TRUE(wind) << wind.error();
        ASSERT_TRUE(wind->motors().add(VortexMotor{}));
        const auto record = [&](double dt) {
            run([&](VkCommandBuffer commands) {
                if (ticks)
                    held(wind->record(commands, {.dt = dt}));
                else
                    held(wind->record_step(commands, {.dt = dt}));
            });
        };
        for (int n = 0; n < 12; ++n) {
            ASSERT_TRUE(wind->follow({1.5 * n, 0.0, -2.5 * n}));
            const bool again = n == 5 || n == 9; // both sets are written where the box is then
            if (n == 5)
                wind->reset();
            if (n == 9)
                wind->forget();
            const glm::vec3 was = place(*wind), rim_was = blend_centre(*wind);
            record(n == 3 || n == 4 || n == 7 ? 0.0 : 1.0 / 30.0);
            if (n == 0)
                continue;
            EXPECT_EQ(place_before(*wind), again ? place(*wind) : was) << n;
            EXPECT_EQ(rim_point_before(*wind), again ? blend_centre(*wind) : rim_was) << n;
        }
    }
}

} // namespace
} // namespace windrow::vulkan
