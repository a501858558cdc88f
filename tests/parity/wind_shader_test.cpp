// What a shader that includes shaders/coupling/windrow_wind.glsl finds in the textures of a recording.
#include "shader_words/sample_wind.h"
#include "tests/parity/wind_parity.h"

#include <array>
#include <cstring>
#include <random>

namespace windrow::vulkan {
namespace {

class WindInShaders : public WindParity {
  protected:
    // Three winds a place (now, before, felt) by sample_wind.comp.
    std::vector<glm::vec4> sampled(Wind& wind, std::span<const glm::vec4> places, glm::dvec3 anchor, const Sampling& sampling) {
        constexpr VkDescriptorType storage = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                   texture = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
        const std::vector<VkDescriptorType> kinds = {
            storage, storage, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, texture, texture, texture, texture, texture, texture, storage};
        Pipeline pipeline = *Pipeline::create(
            *device, {.code = shader_words::sample_wind, .bindings = kinds, .constants = {}, .name = "sample_wind"});
        Buffer in = *Buffer::create(*device, places.size_bytes(), MemoryUse::upload);
        Buffer out = *Buffer::create(*device, 3 * places.size_bytes(), MemoryUse::readback);
        Buffer block = *Buffer::create(*device, sizeof(FrameBlock), MemoryUse::upload, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
        std::memcpy(in.mapped(), places.data(), places.size_bytes());
        const FrameBlock told = wind.frame_block(anchor, sampling);
        std::memcpy(block.mapped(), &told, sizeof(told));
        EXPECT_TRUE(in.flush() == VK_SUCCESS && block.flush() == VK_SUCCESS);
        VkSamplerCreateInfo nearest{};
        nearest.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
        VkSampler sampler = VK_NULL_HANDLE;
        EXPECT_EQ(device->functions().vkCreateSampler(device->host().device, &nearest, nullptr, &sampler), VK_SUCCESS);
        std::vector<Binding> bindings = {{.type = storage, .buffer = in.handle()},
                                         {.type = storage, .buffer = out.handle()},
                                         {.type = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, .buffer = block.handle()}};
        for (const Textures& frame : {wind.textures(), wind.previous_textures()})
            for (const VkImageView view : frame.views)
                bindings.push_back({.type = texture, .view = view, .sampler = sampler});
        bindings.push_back({.type = storage, .buffer = wind.gust_buffer()});
        const Sets::Content content{&pipeline, bindings};
        Sets sets = *Sets::create(*device, {&content, 1});
        run([&](VkCommandBuffer commands) {
            const VkDescriptorSet set = sets.at(0);
            const Functions& call = device->functions();
            call.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.handle());
            call.vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.layout(), 0, 1, &set, 0, nullptr);
            call.vkCmdDispatch(commands, static_cast<std::uint32_t>(places.size() + 63) / 64, 1, 1);
            barrier(commands);
        });
        device->functions().vkDestroySampler(device->host().device, sampler, nullptr);
        return read<glm::vec4>(out, 3 * places.size());
    }
};

// A shader that includes windrow_wind.glsl samples the wind that the CPU's query returns from the same cells.
TEST_F(WindInShaders, AnOutsideShaderSamplesWhatAQueryFinds) {
    const std::array<Config, 3> configs = {{
        {.cells = {20, 12, 16},
         .boundaries = Boundaries::open_over_floor(),
         .centre = {1e6, 6.0, -1e6},
         .ambient = {3.0f, 0.0f, 1.0f},
         .profile = LogProfile{},
         .gusts = {.intensity = 0.25f}},
        {.cells = {9, 7, 11},
         .cell_size = 0.5f,
         .boundaries = Boundaries::all(BoundaryKind::periodic),
         .ambient = {1.0f, 0.5f, -2.0f}},
        {.cells = {12, 12, 12},
         .ambient = {0.0f, 0.0f, 2.0f},
         .gusts = {.tile = GustTile::bake(3)},
         .blend_width = 0.0f}, // for detail alone
    }};
    for (const Config& config : configs) {
        TwoWinds pair = make(config);
        pair.add(VortexMotor{.position = config.centre, .radius = 3.0f});
        for (int n = 0; n < 20; ++n) {
            const glm::dvec3 player = config.centre + glm::dvec3(0.3 * n, 0.0, 0.1 * n);
            pair.follow(player);
            frame(pair, 1.0 / 50.0);
        }
        const std::uint32_t count = 10000;
        const glm::dvec3 anchor = config.centre + glm::dvec3(12.3, -4.5, 6.7);
        std::vector<glm::vec4> places(count);
        std::mt19937 random(7);
        std::uniform_real_distribution<float> along(-1.0f, 1.0f);
        const glm::vec3 reach = 0.9f * config.cell_size * glm::vec3(config.cells);
        for (glm::vec4& place : places)
            place = glm::vec4(glm::vec3(config.centre - anchor) + reach * glm::vec3(along(random), along(random), along(random)),
                              0.0f);
        const Sampling sampling{.strength = 1.3f, .limit = 20.0f, .detail = 0.2f};
        const std::vector<glm::vec4> winds = sampled(pair.device, places, anchor, sampling);
        // The cells of the last frame are read by an empty one.
        run([&](VkCommandBuffer commands) { held(pair.device.record(commands, {.dt = 0.0})); });
        const auto view = *pair.device.queried();
        const auto before = pair.cpu.previous_view();
        double worst = 0.0, worst_before = 0.0, worst_felt = 0.0;
        const auto apart = [](glm::vec4 a, glm::vec3 b) {
            return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
        };
        for (std::uint32_t n = 0; n < count; ++n) {
            const glm::dvec3 world = anchor + glm::dvec3(places[n]);
            worst = std::max(worst, static_cast<double>(apart(winds[3 * n], view.velocity(world))));
            worst_before = std::max(worst_before, static_cast<double>(apart(winds[3 * n + 1], before.velocity(world))));
            worst_felt = std::max(worst_felt, static_cast<double>(apart(winds[3 * n + 2], view.felt(world, sampling))));
        }
        WINDROW_EXPECT_FIGURE("shader_query.now", worst, 1e-5);
        WINDROW_EXPECT_FIGURE("shader_query.before", worst_before, 3e-5); // of the CPU's own cells
        WINDROW_EXPECT_FIGURE("shader_query.felt", worst_felt, 2e-5);
    }
}

// Half textures round to 11 bits: to half a unit in the last of them.
TEST_F(WindInShaders, HalfTexturesHoldElevenBits) {
    TwoWinds pair = make({.cells = {12, 10, 11}, .ambient = {2.0f, 0.0f, 1.0f}, .blend_width = 0.0f}, 0, {.texel = Texel::half});
    pair.add(VortexMotor{});
    for (int n = 0; n < 20; ++n)
        frame(pair, 1.0 / 50.0);
    std::vector<glm::vec4> places(1000);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> along(-4.0f, 4.0f);
    for (glm::vec4& place : places)
        place = {along(random), along(random), along(random), 0.0f};
    const std::vector<glm::vec4> winds = sampled(pair.device, places, {}, {});
    run([&](VkCommandBuffer commands) { held(pair.device.record(commands, {.dt = 0.0})); });
    const auto view = *pair.device.queried();
    double worst = 0.0, fastest = 0.0;
    for (const glm::vec4& u : view.field())
        fastest = std::max({fastest, std::abs(static_cast<double>(u.x)), std::abs(static_cast<double>(u.y)),
                            std::abs(static_cast<double>(u.z))});
    for (std::size_t n = 0; n < places.size(); ++n) {
        const glm::dvec3 apart = glm::dvec3(winds[3 * n]) - glm::dvec3(view.velocity(glm::dvec3(places[n])));
        worst = std::max({worst, std::abs(apart.x), std::abs(apart.y), std::abs(apart.z)});
    }
    // The place itself is rounded too: 1e-5 m/s, as with whole textures.
    WINDROW_EXPECT_FIGURE("shader_query.half", worst, fastest / 2048.0 + 1e-5);
    EXPECT_GT(worst, 2e-5) << "these are not half";
}

} // namespace
} // namespace windrow::vulkan
