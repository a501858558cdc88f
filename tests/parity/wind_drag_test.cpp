// Deposits of drag on a device beside the scenario table: no dispatch more, what is uploaded, the load on a deposit, and a wind that
// forgets.
#include "tests/parity/wind_parity.h"

#include <vector>

namespace windrow::vulkan {
namespace {

class WindDrag : public WindParity {
  protected:
    static constexpr Settings k_settings{.texel = Texel::single, .queries = ReadBack::cells};
    static Config config() { return {.cells = {16, 10, 14}, .ambient = {6.0f, 0.0f, 1.0f}, .gusts = {.intensity = 0.2f}}; }
    static constexpr PlantDrag k_bush{.position = {0.3, -2.0, 0.6}, .radius = 1.7f, .height = 3.0f, .area = 6.0f};

    void step(Wind& wind) {
        run([&](VkCommandBuffer commands) { (void)held(wind.record_step(commands, {.dt = 1.0 / 30.0, .slot = 0})); });
        (void)wind.collect(0);
    }
};

TEST_F(WindDrag, TakesNoDispatchMore) {
    const auto dispatches = [&](bool plants) {
        std::vector<int> counts;
        auto made = Wind::create(sharing_host(), config(), k_settings);
        EXPECT_TRUE(made && made->motors().add(DirectionalMotor{})); // else the air sleeps without plants
        for (int n = 0; made && n < 8; ++n) {
            if (plants && n % 3 == 1) {
                EXPECT_TRUE(made->drag().add(k_bush));
            }
            if (n > 4) {
                EXPECT_TRUE(made->follow({1.0 * n, 0.0, -0.3 * n}));
            }
            step(*made);
            counts.push_back(made->dispatches());
        }
        return counts;
    };
    EXPECT_EQ(dispatches(true), dispatches(false));
}

TEST_F(WindDrag, HasTheForceOfTheCpu) {
    auto made = Wind::create(sharing_host(), config(), k_settings);
    ASSERT_TRUE(made) << made.error();
    Wind& gpu = *made;
    windrow::Wind cpu = *windrow::Wind::create(config());
    const auto id = gpu.drag().add(k_bush);
    ASSERT_TRUE(id && cpu.drag().add(k_bush));
    EXPECT_NE(gpu.force_on(*id).error().find("no cells have come back yet"), std::string::npos);
    for (int n = 0; n < 12; ++n) {
        ASSERT_TRUE(gpu.follow({0.3 * n, 0.0, 0.0}) && cpu.follow({0.3 * n, 0.0, 0.0}));
        step(gpu);
        (void)cpu.step(1.0 / 30.0);
    }
    const auto found = gpu.force_on(*id), expected = cpu.force_on(id->unowned());
    ASSERT_TRUE(found && expected);
    EXPECT_GT(glm::length(expected->force), 10.0f);
    WINDROW_EXPECT_FIGURE("wind_drag.force", glm::length(found->force - expected->force) / glm::length(expected->force), 2e-5);
    EXPECT_EQ(found->in_box, expected->in_box);
    Wind blind = *Wind::create(sharing_host(), config(), {});
    const auto unseen = blind.drag().add(k_bush);
    ASSERT_TRUE(unseen);
    EXPECT_NE(blind.force_on(*unseen).error().find("Settings::queries of cells"), std::string::npos);
    EXPECT_FALSE(blind.force_on(DragId{}));
}

// Over rough ground plants shorten the mixing length behind them: a belt and a bush before and on a hill, in gusts, in a box that
// follows, then without them.
TEST_F(WindDrag, HasTheLeeOfTheCpu) {
    for (const bool gusts : {false, true}) {
        Config rough{.cells = {24, 12, 14},
                     .boundaries = Boundaries::open_over_floor(),
                     .centre = {0.0, 6.0, 0.0},
                     .ambient = {6.0f, 0.0f, 1.0f},
                     .profile = LogProfile{},
                     .gusts = {.intensity = gusts ? 0.2f : 0.0f},
                     .roughness = Roughness{}};
        auto made = Wind::create(sharing_host(), rough, k_settings);
        ASSERT_TRUE(made) << made.error();
        Wind& gpu = *made;
        windrow::Wind cpu = *windrow::Wind::create(rough);
        const BeltDrag belt{.start = {-4.0, 0.0, -5.0}, .end = {-4.0, 0.0, 5.0}, .width = 2.0f, .height = 4.0f};
        const Obstacle block{.position = {5.0, 0.5, 1.0}, .shape = Block{}};
        const auto planted = gpu.drag().add(belt);
        const auto also = cpu.drag().add(belt);
        ASSERT_TRUE(planted && also);
        ASSERT_TRUE(gpu.drag().add(k_bush) && cpu.drag().add(k_bush));
        ASSERT_TRUE(gpu.obstacles().add(block) && cpu.obstacles().add(block));
        double worst = 0.0, deepest = 0.0, lee = 0.0;
        for (int n = 0; n < 16; ++n) {
            ASSERT_TRUE(gpu.follow({0.2 * n, 6.0, 0.0}) && cpu.follow({0.2 * n, 6.0, 0.0}));
            if (n == 13) {
                ASSERT_TRUE(gpu.drag().remove(*planted) && cpu.drag().remove(*also));
            }
            step(gpu);
            (void)cpu.step(1.0 / 30.0);
            const auto cells = *gpu.cells();
            worst = std::max(worst, apart(cells, cpu.field()));
            for (std::size_t at = 0; at < cells.size(); ++at) {
                deepest = std::max(deepest, static_cast<double>(cpu.field()[at].w));
                lee = std::max(lee, static_cast<double>(std::abs(cells[at].w - cpu.field()[at].w)));
            }
        }
        EXPECT_GT(deepest, 0.2);
        WINDROW_EXPECT_FIGURE(gusts ? "wind_drag.lee_in_gusts" : "wind_drag.lee", worst, 1e-5);
        WINDROW_EXPECT_FIGURE(gusts ? "wind_drag.lee_itself_in_gusts" : "wind_drag.lee_itself", lee, 1e-5);
    }
}

// What a recording uploads that is never submitted is uploaded again.
TEST_F(WindDrag, IsUploadedAgainAfterForget) {
    auto made = Wind::create(sharing_host(), config(), k_settings);
    ASSERT_TRUE(made) << made.error();
    Wind& gpu = *made;
    windrow::Wind cpu = *windrow::Wind::create(config());
    const auto together = [&] {
        step(gpu);
        (void)cpu.step(1.0 / 30.0);
        return apart(*gpu.cells(), cpu.field());
    };
    ASSERT_TRUE(gpu.drag().add(k_bush) && cpu.drag().add(k_bush));
    for (int n = 0; n < 4; ++n)
        (void)together();
    const PlantDrag another{.position = {2.3, -2.0, -2.4}, .radius = 2.0f, .height = 4.0f, .area = 9.0f};
    ASSERT_TRUE(gpu.drag().add(another) && cpu.drag().add(another));
    Submitter(own->host(), 1).discard([&](VkCommandBuffer commands, int) {
        (void)held(gpu.record_step(commands, {.dt = 1.0 / 30.0, .slot = 0}));
    });
    (void)cpu.step(1.0 / 30.0); // the gusts of both have passed
    gpu.forget();
    cpu.reset();
    double worst = 0.0;
    for (int n = 0; n < 8; ++n)
        worst = std::max(worst, together());
    WINDROW_EXPECT_FIGURE("wind_drag.after_forget", worst, 1e-5);
}

} // namespace
} // namespace windrow::vulkan
