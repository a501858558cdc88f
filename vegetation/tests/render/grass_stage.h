// Grass, wind and renderer on a device, for tests of what is drawn and for the pictures of the looks.
#pragma once

#include "vegetation/render/grass_layer.h"
#include "vegetation/render/renderer.h"

#include <gtest/gtest.h>
#include <optional>
#include <vulkan/vulkan.h>

namespace windrow::vegetation::render::test {

struct GrassStage {
    GrassStage(const Scene& wanted, const RenderSettings& settings, const engine::DeviceSettings& own = {})
        : scene(wanted), device(engine::must(engine::Device::create(own))) {
        auto blows =
            windrow::vulkan::Wind::create(device->host(), scene.wind.wind, {.frames_in_flight = engine::k_frames_in_flight});
        EXPECT_TRUE(blows) << blows.error();
        wind.emplace(*std::move(blows));
        for (const windrow::Motor& motor : scene.wind.motors)
            EXPECT_TRUE(wind->motors().add(motor));
        auto draws = Renderer::create(*device, scene, settings);
        EXPECT_TRUE(draws) << draws.error();
        renderer = *std::move(draws);
        frames = engine::must(engine::Frames::create(*device));
    }
    GrassLayer& grow(const grass::PlacementMask& mask, const GrassLayerSettings& settings) {
        auto made = GrassLayer::create(*device, renderer->draw_targets(), scene.ground, mask, settings);
        EXPECT_TRUE(made) << made.error();
        layers.push_back(*std::move(made));
        renderer->add(*layers.back());
        return *layers.back();
    }
    /// The wind alone, for so long.
    void blow(double seconds, double frame_time) {
        for (double time = 0.0; time < seconds; time += frame_time) {
            const engine::Frame frame = engine::must(frames->begin());
            engine::must(wind->record(frame.commands, {.dt = frame_time, .slot = frame.slot}));
            engine::must(frames->submit(frame));
        }
        engine::must(frames->wait());
    }
    /// One frame, done when this returns.
    void draw(const Camera& camera, double frame_time) {
        const engine::Frame frame = engine::must(frames->begin());
        renderer->begin(frame);
        engine::must(wind->record(frame.commands, {.dt = frame_time, .slot = frame.slot}));
        if (ground) {
            const auto stepped = ground->record(frame.commands, {.duration = frame_time, .walkers = walkers});
            EXPECT_TRUE(stepped) << stepped.error();
        }
        const auto recorded = renderer->record(frame, camera, *wind);
        EXPECT_TRUE(recorded) << recorded.error();
        renderer->copy(frame);
        engine::must(frames->finish(frame));
        renderer->clock().collect(frame.slot);
    }
    /// A buffer of the device's own, as values.
    template <class Value>
    std::vector<Value> values_of(VkBuffer from, std::size_t count) {
        return engine::must(device->read<Value>(from, 0, count));
    }
    /// Blades that the last frame drew of a layer; the first so many entries of `visible_blades` where there are no shadows.
    std::size_t drawn(GrassLayer& layer) {
        std::size_t count = 0;
        const auto draws = values_of<VkDrawIndirectCommand>(layer.field().draw_buffer(),
                                                            4 * static_cast<std::size_t>(layer.field().settings().max_chunks));
        for (int z = 0; z < layer.field().tree().chunks().y; ++z)
            for (int x = 0; x < layer.field().tree().chunks().x; ++x)
                if (const int slot = layer.field().slot_of({{x, z}}); slot >= 0)
                    count += draws[4 * static_cast<std::size_t>(slot)].instanceCount +
                             draws[4 * static_cast<std::size_t>(slot) + 1].instanceCount;
        return count;
    }
    /// Ground that remembers walkers, about a point.
    void remember(const windrow::GroundConfig& config, glm::dvec3 about) {
        auto made = windrow::vulkan::GroundMemory::create(device->host(), config);
        EXPECT_TRUE(made) << made.error();
        ground.emplace(*std::move(made));
        EXPECT_TRUE(ground->follow(about));
        for (const auto& layer : layers)
            layer->set_ground(&*ground);
    }

    Scene scene;
    std::unique_ptr<engine::Device> device;
    std::optional<windrow::vulkan::Wind> wind{};
    std::optional<windrow::vulkan::GroundMemory> ground{};
    std::vector<windrow::GroundWalker> walkers{};
    std::unique_ptr<Renderer> renderer{};
    std::vector<std::unique_ptr<GrassLayer>> layers{};
    std::unique_ptr<engine::Frames> frames{}; // waits before all else ends
};

} // namespace windrow::vegetation::render::test
