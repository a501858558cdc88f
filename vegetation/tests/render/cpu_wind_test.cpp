// A wind on the CPU beside its textures: gusts that begin later, what a recording rejects, steps in place of ticks.
#include "vegetation/vulkan/cpu_wind.h"
#include "vegetation/vulkan/frames.h"
#include "vegetation/vulkan/wind_set.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace windrow::vegetation::engine {
namespace {

class CpuWinds : public testing::Test {
  protected:
    void SetUp() override {
        device = must(Device::create());
        frames = must(Frames::create(*device));
    }
    /// A frame of the wind alone.
    void record(CpuWind& wind) {
        const Frame frame = must(frames->begin());
        must(wind.record(frame.commands, frame.slot));
        must(frames->finish(frame));
    }

    std::unique_ptr<Device> device;
    std::unique_ptr<Frames> frames;
    const Config config{.cells = {8, 6, 8}, .cell_size = 0.5f, .ambient = {3.0f, 0.0f, 1.0f}};
};

TEST_F(CpuWinds, ShowGustsThatBeginLater) {
    const auto wind = must(CpuWind::create(*device, config));
    record(*wind);
    const VkBuffer before = wind->gust_buffer();
    for (const unsigned seed : {3u, 4u}) {
        must(wind->air().set_gusts({.intensity = 0.3f, .length = 4.0f, .seed = seed}));
        (void)wind->air().advance(1.0 / 30.0);
        record(*wind);
        EXPECT_NE(wind->gust_buffer(), before);
        const auto& tile = wind->air().view().ambient().tile();
        ASSERT_TRUE(tile);
        const auto shown = must(device->read<glm::vec4>(wind->gust_buffer(), 0, tile->texels().size()));
        EXPECT_TRUE(std::equal(shown.begin(), shown.end(), tile->texels().begin())) << "seed " << seed;
    }
}

TEST_F(CpuWinds, RejectWhatTheyHaveNoRoomFor) {
    const auto wind = must(CpuWind::create(*device, config));
    const Frame frame = must(frames->begin());
    for (const int slot : {-1, k_frames_in_flight})
        EXPECT_EQ(wind->record(frame.commands, slot).error(), "slot is " + std::to_string(slot) + "; give 0 to 1.");
    wind->air() = must(Wind::create({.cells = {16, 6, 8}}));
    EXPECT_FALSE(wind->record(frame.commands, frame.slot));
    must(frames->finish(frame));
    EXPECT_FALSE(CpuWind::create(*device, {.cells = {0, 6, 8}}));
    const auto limit = static_cast<int>(device->limits().maxImageDimension3D);
    if (limit < 2048) {
        const auto large = CpuWind::create(*device, {.cells = {limit + 1, 2, 2}});
        ASSERT_FALSE(large);
        EXPECT_NE(large.error().find(std::to_string(limit)), std::string::npos);
    }
}

// By steps as by ticks, textures take turns: those of the frame before stay where it recorded them.
TEST_F(CpuWinds, KeepTheTexturesOfTheFrameBefore) {
    auto air = must(Wind::create(config));
    const auto wind = must(CpuWind::create(*device, std::move(air)));
    record(*wind);
    for (int n = 0; n < 3; ++n) {
        const VkImage was = wind->textures().vectors.image;
        (void)wind->air().step(1.0 / 30.0);
        record(*wind);
        EXPECT_EQ(wind->previous_textures().vectors.image, was);
        EXPECT_NE(wind->textures().vectors.image, was);
    }
}

} // namespace
} // namespace windrow::vegetation::engine
