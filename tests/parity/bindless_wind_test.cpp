// A host that declares all bindings itself: two winds in arrays of textures and in one buffer of blocks.
#include "shader_words/bindless_wind.h"
#include "shader_words/bindless_wind_nonuniform.h"
#include "shader_words/sample_wind_exact.h"
#include "tests/parity/wind_shader.h"

#include <array>
#include <set>

namespace windrow::vulkan {
namespace {

class BindlessWinds : public WindShader {
  protected:
    void SetUp() override {
        OwnDevice::Settings settings{.validation = true};
        settings.wished.shaderStorageBufferArrayDynamicIndexing = VK_TRUE;
        make_own(settings);
        ASSERT_TRUE(own->features().shaderStorageBufferArrayDynamicIndexing);
    }
};

// Each of two winds, at its index, is what its own set of windrow_wind.glsl gives, and what the CPU's query returns.
TEST_F(BindlessWinds, EachWindIsSampledAtItsIndex) {
    constexpr std::size_t k_winds = 2, k_places = 2000;
    const std::array<Config, k_winds> configs = {{
        {.cells = {12, 8, 10},
         .boundaries = Boundaries::open_over_floor(),
         .ambient = {3.0f, 0.0f, 1.0f},
         .gusts = {.intensity = 0.3f},
         .rows = Rows{.first = 0.4f, .uniform = 2, .ratio = 1.3f}},
        {.cells = {9, 7, 11},
         .cell_size = 0.5f,
         .boundaries = Boundaries::all(BoundaryKind::periodic),
         .ambient = {-1.0f, 0.5f, 2.0f}},
    }};
    std::vector<Wind> winds;
    std::vector<FrameBlock> frames;
    for (const Config& config : configs) {
        winds.push_back(
            *Wind::create(own->host(), config, {.texel = Texel::single, .frames_in_flight = 1, .queries = ReadBack::cells}));
        ASSERT_TRUE(winds.back().motors().add(VortexMotor{.radius = 3.0f}));
        for (int n = 0; n < 5; ++n)
            run([&](VkCommandBuffer commands) { held(winds.back().record(commands, {.dt = 1.0 / 30.0})); });
        frames.push_back(winds.back().frame_block({}));
    }
    const std::vector<glm::vec4> places = places_around({}, {8.0f, 6.0f, 8.0f}, k_places);
    const Buffer blocks = uploaded(frames);
    std::vector<Sampler> samplers;
    std::vector<VkDescriptorImageInfo> now, before;
    std::vector<VkDescriptorBufferInfo> tiles;
    for (const Wind& wind : winds) {
        samplers.push_back(sampler_of(sampler_info(wind.config().boundaries)));
        const auto of = [&](const Textures& textures) {
            return VkDescriptorImageInfo{samplers.back().get(), textures.vectors.view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
        };
        now.push_back(of(wind.textures()));
        before.push_back(of(wind.previous_textures()));
        tiles.push_back({wind.gust_buffer(), 0, VK_WHOLE_SIZE});
    }
    const auto volumes = [](std::uint32_t binding) {
        return VkDescriptorSetLayoutBinding{binding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, k_winds,
                                            VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
    };
    const std::array others{volumes(2), volumes(3), storage(4, k_winds), storage(5)};
    const std::vector<glm::vec4> sampled_by_index =
        dispatched<glm::vec4>(shader_words::bindless_wind, places, 2 * k_winds, others, [&](VkDescriptorSet set) {
            std::array<VkWriteDescriptorSet, 3> writes{};
            for (std::uint32_t n = 0; n < 3; ++n) {
                writes[n].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
                writes[n].dstSet = set;
                writes[n].dstBinding = 2 + n;
                writes[n].descriptorCount = k_winds;
                writes[n].descriptorType = others[n].descriptorType;
            }
            writes[0].pImageInfo = now.data();
            writes[1].pImageInfo = before.data();
            writes[2].pBufferInfo = tiles.data();
            device->functions().vkUpdateDescriptorSets(device->host().device, 3, writes.data(), 0, nullptr);
            point(set, 5, blocks);
        });
    for (std::size_t w = 0; w < k_winds; ++w) {
        const std::vector<glm::vec4> own_set = sampled(shader_words::sample_wind_exact, winds[w], TextureSet::vectors, places, 3,
                                                       frames[w], {}, [](VkDescriptorSet) {});
        run([&](VkCommandBuffer commands) { held(winds[w].record(commands, {.dt = 0.0})); }); // reads the one before
        const WindView view = *winds[w].queried();
        double worst = 0.0, from_set = 0.0, moved = 0.0;
        for (std::size_t n = 0; n < k_places; ++n) {
            const glm::vec4* const both = &sampled_by_index[2 * (k_winds * n + w)];
            worst = std::max(worst, difference(both[0], view.velocity(glm::dvec3(places[n]))));
            moved = std::max(moved, difference(both[0], glm::vec3(both[1])));
            for (std::size_t frame = 0; frame < 2; ++frame)
                from_set = std::max(from_set, difference(both[frame], glm::vec3(own_set[3 * n + frame])));
        }
        WINDROW_EXPECT_FIGURE("bindless.query", worst, 1e-5);
        WINDROW_EXPECT_FIGURE("bindless.own_set", from_set, 1e-6);
        EXPECT_GT(moved, 1e-3) << "neither frame passes for the other";
    }
}

// Runtime arrays with an index that differs within a subgroup, compiled and not run, since llvmpipe has none: the decoration
// NonUniform must be on the image that is sampled, not only on the index.
TEST(BindlessWindText, IndicesMayDifferWithinASubgroup) {
    constexpr std::uint32_t k_decorate = 71, k_nonuniform = 5300, k_sample_explicit_lod = 88;
    const std::span<const std::uint32_t> words = shader_words::bindless_wind_nonuniform;
    std::set<std::uint32_t> nonuniform;
    int samples = 0;
    for (std::size_t at = 5; at < words.size(); at += words[at] >> 16) { // decorations come before functions
        const std::uint32_t operation = words[at] & 0xffff;
        if (operation == k_decorate && words[at + 2] == k_nonuniform)
            nonuniform.insert(words[at + 1]);
        if (operation == k_sample_explicit_lod) {
            ++samples;
            EXPECT_TRUE(nonuniform.contains(words[at + 3]));
        }
    }
    EXPECT_EQ(samples, 2);
}

} // namespace
} // namespace windrow::vulkan
