// A renderer with a stand of trees in a wind, whose vertices are read back.
#pragma once

#include "shader_words/tree_points.h"
#include "vegetation/render/renderer.h"
#include "vegetation/trees/tree_stand.h"
#include "vegetation/vulkan/descriptors.h"

#include <array>
#include <gtest/gtest.h>
#include <optional>
#include <span>
#include <vector>
#include <vulkan/vulkan.h>

namespace windrow::vegetation::trees::test {

inline constexpr glm::dvec3 k_anchor{4e5, 0.0, -2.5e5}; // [m]
inline constexpr int k_width = 320, k_height = 240;
inline constexpr double k_frame = 1.0 / 30.0; // [s]

/// Records, after the stand, where each vertex of its first tree is.
class Probe final : public render::Drawable {
  public:
    Probe(engine::Device& device, const render::DrawTargets& targets, const TreeStand& stand) : objects_(device), stand_(stand) {
        constexpr std::array bindings{engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_COMPUTE_BIT}};
        const VkDescriptorSetLayout own = engine::make_layout(objects_, bindings);
        const std::array sets{targets.frame, targets.wind, stand.layout(), own};
        layout_ = engine::make_pipeline_layout(objects_, sets);
        pipeline_ = engine::make_compute_pipeline(objects_, layout_, windrow::vulkan::shader_words::tree_points);
        points_ = objects_.buffer(engine::Use::work, 3 * sizeof(glm::vec4) * count(),
                                  VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
        engine::make_sets(objects_, own, bindings, std::span(&set_, 1));
        engine::point(device, set_, 0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, points_.buffer);
    }

    Result<void> prepare(const render::PassContext& context) override {
        const std::array sets{context.frame, context.wind, stand_.set(context.slot), set_};
        vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, 4, sets.data(), 0, nullptr);
        vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_);
        VkMemoryBarrier barrier{};
        barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
        barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
        barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT;
        vkCmdPipelineBarrier(context.commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, 0, 1,
                             &barrier, 0, nullptr, 0, nullptr);
        const std::array<std::uint32_t, 3> which{0u, 0u, static_cast<std::uint32_t>(count())};
        vkCmdPushConstants(context.commands, layout_, VK_SHADER_STAGE_ALL, 0, sizeof which, which.data());
        vkCmdDispatch(context.commands, (which[2] + 63u) / 64u, 1, 1);
        return {};
    }
    /// Once the frame is done.
    void read() { values_ = engine::must(objects_.device().read<glm::vec4>(points_.buffer, 0, 3 * count())); }
    void draw(const render::PassContext&) override {}

    [[nodiscard]] std::size_t count() const { return stand_.model(0).vertices.size(); }
    /// [m] from the trunk's base, in the frame that was read; w the factor on its size.
    [[nodiscard]] glm::vec4 now(std::size_t vertex) const { return at(3 * vertex); }
    [[nodiscard]] glm::vec4 normal(std::size_t vertex) const { return at(3 * vertex + 1); }
    [[nodiscard]] glm::vec4 before(std::size_t vertex) const { return at(3 * vertex + 2); }

  private:
    [[nodiscard]] glm::vec4 at(std::size_t n) const { return values_[n]; }

    engine::Objects objects_;
    const TreeStand& stand_;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
    engine::Buffer points_{};
    std::vector<glm::vec4> values_{};
};

struct Stage {
    /// `gusts` 0 to 1 their intensity.
    Stage(glm::vec3 ambient, float gusts) : device(engine::must(engine::Device::create())) {
        scene.ground.corner = k_anchor - glm::dvec3(50.0, 0.0, 50.0);
        windrow::Config& config = scene.wind.wind;
        config.cells = {16, 16, 16};
        config.centre = k_anchor + glm::dvec3(0.0, 8.0, -20.0);
        config.ambient = ambient;
        config.gusts = {.intensity = gusts, .length = 6.0f};
        auto made = windrow::vulkan::Wind::create(device->host(), config, {.frames_in_flight = engine::k_frames_in_flight});
        EXPECT_TRUE(made) << made.error();
        wind.emplace(*std::move(made));
        auto drawn = render::Renderer::create(
            *device, scene, {.width = k_width, .height = k_height, .samples = 1, .shadow_texels = 64, .anchor = k_anchor});
        EXPECT_TRUE(drawn) << drawn.error();
        renderer = *std::move(drawn);
        frames = engine::must(engine::Frames::create(*device));
    }

    void plant(const TreeStandSettings& settings) {
        auto made = TreeStand::create(*device, renderer->draw_targets(), settings, settings.places, k_anchor);
        ASSERT_TRUE(made) << made.error();
        stand = *std::move(made);
        stand->set_time_step(k_frame);
        renderer->add(*stand);
        probe.emplace(*device, renderer->draw_targets(), *stand);
        renderer->add(*probe);
    }

    /// One frame, done when this returns.
    void draw(const render::Camera& camera) {
        const engine::Frame frame = engine::must(frames->begin());
        renderer->begin(frame);
        engine::must(wind->record(frame.commands, {.dt = k_frame, .slot = frame.slot}));
        const auto recorded = renderer->record(frame, camera, *wind);
        EXPECT_TRUE(recorded) << recorded.error();
        renderer->copy(frame);
        engine::must(frames->finish(frame));
        renderer->clock().collect(frame.slot);
        if (probe)
            probe->read();
    }

    render::Scene scene;
    std::unique_ptr<engine::Device> device;
    std::optional<windrow::vulkan::Wind> wind;
    std::unique_ptr<render::Renderer> renderer;
    std::unique_ptr<TreeStand> stand;
    std::optional<Probe> probe;
    std::unique_ptr<engine::Frames> frames; // waits before all else ends
};

/// Looks at the tree that stands 20 m before the anchor.
inline render::Camera camera_at(double x, double turn) {
    render::Camera camera;
    camera.position = k_anchor + glm::dvec3(x, 4.0, 0.0);
    camera.target = camera.position + glm::dvec3(10.0 * std::sin(turn), 0.5, -10.0 * std::cos(turn));
    return camera;
}

} // namespace windrow::vegetation::trees::test
