// Grass, wind and renderer on a device, for tests of what is drawn and for the pictures of the looks.
#pragma once

#include "vegetation/render/grass_layer.h"
#include "vegetation/render/renderer.h"

#include <gtest/gtest.h>
#include <optional>
#include <vulkan/vulkan.h>

namespace windrow::vegetation::render::test {

inline windrow::vulkan::Host host_of(const engine::Device& device) {
    return {.instance = device.instance,
            .physical_device = device.physical,
            .device = device.device,
            .queue_family = device.family,
            .get_instance_proc_addr = vkGetInstanceProcAddr};
}

struct GrassStage {
    GrassStage(const Scene& wanted, const RenderSettings& settings)
        : scene(wanted), device(windrow::vulkan::requirements().api_version, windrow::vulkan::requirements().features,
                                [](VkInstance instance, VkPhysicalDevice candidate) {
                                    const auto fit = windrow::vulkan::check(instance, candidate, vkGetInstanceProcAddr);
                                    return fit ? std::string() : fit.error();
                                }) {
        auto blows =
            windrow::vulkan::Wind::create(host_of(device), scene.wind.wind, {.frames_in_flight = engine::k_frames_in_flight});
        EXPECT_TRUE(blows) << blows.error();
        wind.emplace(*std::move(blows));
        for (const windrow::Motor& motor : scene.wind.motors)
            EXPECT_TRUE(wind->motors().add(motor));
        auto draws = Renderer::create(device, scene, settings);
        EXPECT_TRUE(draws) << draws.error();
        renderer = *std::move(draws);
        frames.emplace(device);
    }
    GrassLayer& grow(const grass::PlacementMask& mask, const GrassLayerSettings& settings) {
        auto made = GrassLayer::create(device, renderer->draw_targets(), scene.ground, mask, settings);
        EXPECT_TRUE(made) << made.error();
        layers.push_back(*std::move(made));
        renderer->add(*layers.back());
        return *layers.back();
    }
    /// The wind alone, for so long.
    void blow(double seconds, double frame_time) {
        for (double time = 0.0; time < seconds; time += frame_time) {
            const engine::Frame frame = frames->begin();
            (void)wind->record(frame.commands, {.dt = frame_time, .slot = frame.slot});
            frames->submit(frame);
        }
        frames->wait();
    }
    /// One frame, done when this returns.
    void draw(const Camera& camera, double frame_time) {
        const engine::Frame frame = frames->begin();
        renderer->begin(frame);
        (void)wind->record(frame.commands, {.dt = frame_time, .slot = frame.slot});
        if (ground) {
            const auto stepped = ground->record(frame.commands, {.duration = frame_time, .walkers = walkers});
            EXPECT_TRUE(stepped) << stepped.error();
        }
        const auto recorded = renderer->record(frame, camera, *wind);
        EXPECT_TRUE(recorded) << recorded.error();
        renderer->copy(frame);
        frames->submit(frame);
        frames->wait();
        renderer->clock().collect(frame.slot);
    }
    /// A buffer of the device's own, as values.
    template <class Value>
    std::vector<Value> values_of(VkBuffer from, std::size_t count) {
        const engine::Buffer here = device.make_buffer(count * sizeof(Value), VK_BUFFER_USAGE_TRANSFER_DST_BIT);
        const engine::Frame frame = frames->begin();
        const VkBufferCopy all{0, 0, count * sizeof(Value)};
        vkCmdCopyBuffer(frame.commands, from, here.buffer, 1, &all);
        const VkMemoryBarrier done{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, VK_ACCESS_TRANSFER_WRITE_BIT,
                                   VK_ACCESS_HOST_READ_BIT};
        vkCmdPipelineBarrier(frame.commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &done, 0, nullptr,
                             0, nullptr);
        frames->submit(frame);
        frames->wait();
        const auto* const values = static_cast<const Value*>(here.mapped);
        return {values, values + count};
    }
    /// Blades that the last frame drew of a layer; the first so many entries of `visible_blades` where there are no shadows.
    std::size_t drawn(GrassLayer& layer) {
        std::size_t count = 0;
        const auto draws = values_of<VkDrawIndirectCommand>(layer.field().draw_buffer(),
                                                            4 * static_cast<std::size_t>(layer.field().settings().most_chunks));
        for (int z = 0; z < layer.field().tree().chunks().y; ++z)
            for (int x = 0; x < layer.field().tree().chunks().x; ++x)
                if (const int slot = layer.field().slot_of({{x, z}}); slot >= 0)
                    count += draws[4 * static_cast<std::size_t>(slot)].instanceCount +
                             draws[4 * static_cast<std::size_t>(slot) + 1].instanceCount;
        return count;
    }
    /// Ground that remembers walkers, about a point.
    void remember(const windrow::GroundConfig& config, glm::dvec3 about) {
        auto made = windrow::vulkan::GroundMemory::create(host_of(device), config);
        EXPECT_TRUE(made) << made.error();
        ground.emplace(*std::move(made));
        EXPECT_TRUE(ground->follow(about));
        for (const auto& layer : layers)
            layer->set_ground(&*ground);
    }

    Scene scene;
    engine::Device device;
    std::optional<windrow::vulkan::Wind> wind{};
    std::optional<windrow::vulkan::GroundMemory> ground{};
    std::vector<windrow::GroundWalker> walkers{};
    std::unique_ptr<Renderer> renderer{};
    std::vector<std::unique_ptr<GrassLayer>> layers{};
    std::optional<engine::Frames> frames{}; // waits before all else ends
};

} // namespace windrow::vegetation::render::test
