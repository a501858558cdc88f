// A compute shader that samples the wind at the places of a buffer, bound as a host of its own does: layout, set and writes by
// fluid/vulkan/textures.h or by hand.
#pragma once

#include "fluid/vulkan/textures.h"
#include "gpu/buffer.h"
#include "tests/parity/wind_parity.h"

#include <random>
#include <vector>

namespace windrow::vulkan {

/// Largest difference of a component.
[[nodiscard]] inline double difference(glm::vec4 a, glm::vec3 b) {
    return static_cast<double>(std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)}));
}

class WindShader : public WindParity {
  protected:
    /// Runs `code` once a case: binding 0 holds the cases, 1 gets `each` answers of each, and `others` are the shader's own, which
    /// `write(set)` points.
    template <class Answer, class Case, class Write>
    std::vector<Answer> dispatched(std::span<const std::uint32_t> code, const std::vector<Case>& cases, std::size_t each,
                                   std::span<const VkDescriptorSetLayoutBinding> others, const Write& write) {
        std::vector<VkDescriptorSetLayoutBinding> bindings = {storage(0), storage(1)};
        bindings.insert(bindings.end(), others.begin(), others.end());
        const Pipeline pipeline = *Pipeline::create(*device, *PipelineLayout::create(*device, bindings, {}, "a test"),
                                                    {.code = code, .bindings = {}, .constants = {}, .name = "of a test"});
        const Sets::Content content{&pipeline};
        const Sets sets = *Sets::create(*device, {&content, 1});
        const VkDescriptorSet set = sets.at(0);
        const std::size_t count = each * cases.size();
        const Buffer in = uploaded(cases), out = buffer(count * sizeof(Answer), MemoryUse::readback);
        point(set, 0, in);
        point(set, 1, out);
        write(set);
        run([&](VkCommandBuffer commands) {
            pipeline.bind(device->functions(), commands, set);
            device->functions().vkCmdDispatch(commands, static_cast<std::uint32_t>(cases.size() + 63) / 64, 1, 1);
            barrier(commands);
        });
        return read<Answer>(out, count);
    }

    /// The same at places in the wind's box. Binding `first` and those behind it are windrow_wind.glsl's, those between are `others`.
    template <class Write>
    std::vector<glm::vec4> sampled(std::span<const std::uint32_t> code, const Wind& wind, TextureSet textures,
                                   const std::vector<glm::vec4>& places, std::size_t each, const FrameBlock& frame,
                                   std::vector<VkDescriptorSetLayoutBinding> others, const Write& write_others) {
        const Buffer block = uploaded(std::span(&frame, 1), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
        const Sampler sampler = sampler_of(sampler_info(wind.config().boundaries));
        const auto first = static_cast<std::uint32_t>(2 + others.size());
        const SetBindings of_wind = set_bindings(textures, VK_SHADER_STAGE_COMPUTE_BIT, first);
        others.insert(others.end(), of_wind.begin(), of_wind.end());
        return dispatched<glm::vec4>(code, places, each, others, [&](VkDescriptorSet set) {
            write_others(set);
            const SetWrites writes(set,
                                   {.now = wind.textures(),
                                    .before = wind.previous_textures(),
                                    .sampler = sampler.get(),
                                    .block = {block.handle(), 0, sizeof frame},
                                    .tile = wind.gust_buffer()},
                                   textures, first);
            device->functions().vkUpdateDescriptorSets(device->host().device, writes.size(), writes.data(), 0, nullptr);
        });
    }

    /// Points a storage buffer's binding.
    void point(VkDescriptorSet set, std::uint32_t binding, const Buffer& buffer) {
        const VkDescriptorBufferInfo whole{buffer.handle(), 0, VK_WHOLE_SIZE};
        VkWriteDescriptorSet write{};
        write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        write.dstSet = set;
        write.dstBinding = binding;
        write.descriptorCount = 1;
        write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        write.pBufferInfo = &whole;
        device->functions().vkUpdateDescriptorSets(device->host().device, 1, &write, 0, nullptr);
    }
    static VkDescriptorSetLayoutBinding storage(std::uint32_t binding, std::uint32_t count = 1) {
        return {binding, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, count, VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
    }

    /// Places around `centre`, up to `reach` [m] from it along each axis.
    static std::vector<glm::vec4> places_around(glm::vec3 centre, glm::vec3 reach, std::size_t count) {
        std::mt19937 random(7);
        std::uniform_real_distribution<float> along(-1.0f, 1.0f);
        std::vector<glm::vec4> places(count);
        for (glm::vec4& place : places) {
            const float x = along(random), y = along(random), z = along(random);
            place = glm::vec4(centre + reach * glm::vec3(x, y, z), 0.0f);
        }
        return places;
    }
};

} // namespace windrow::vulkan
