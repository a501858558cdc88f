// A compute shader that samples the wind at the places of a buffer, bound as a host of its own does: layout, set and writes by
// fluid/vulkan/textures.h or by hand.
#pragma once

#include "fluid/vulkan/buffer.h"
#include "fluid/vulkan/handle.h"
#include "fluid/vulkan/textures.h"
#include "tests/parity/wind_parity.h"

#include <cstring>
#include <random>
#include <vector>

namespace windrow::vulkan {

/// Largest difference of a component.
[[nodiscard]] inline double difference(glm::vec4 a, glm::vec3 b) {
    return static_cast<double>(std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)}));
}

class WindShader : public WindParity {
  protected:
    /// A buffer with this content.
    template <class Values>
    [[nodiscard]] Buffer uploaded(const Values& values, VkBufferUsageFlags usage = 0) {
        const auto bytes = std::as_bytes(std::span(values));
        Buffer made = *Buffer::create(*device, bytes.size(), MemoryUse::upload, usage);
        std::memcpy(made.mapped(), bytes.data(), bytes.size());
        EXPECT_EQ(made.flush(), VK_SUCCESS);
        return made;
    }

    using Sampler = Handle<VkSampler, &Functions::vkDestroySampler>;
    [[nodiscard]] Sampler sampler_of(const VkSamplerCreateInfo& info) {
        Sampler made;
        EXPECT_EQ(make_handle(device->functions().vkCreateSampler, info, made), VK_SUCCESS);
        return made;
    }

    /// Runs `code` once a case: binding 0 holds the cases, 1 gets `each` answers of each, and `others` are the shader's own, which
    /// `write(set)` points.
    template <class Answer, class Case, class Write>
    std::vector<Answer> dispatched(std::span<const std::uint32_t> code, const std::vector<Case>& cases, std::size_t each,
                                   std::span<const VkDescriptorSetLayoutBinding> others, const Write& write) {
        const Functions& call = device->functions();
        std::vector<VkDescriptorSetLayoutBinding> bindings = {storage(0), storage(1)};
        bindings.insert(bindings.end(), others.begin(), others.end());
        std::vector<VkDescriptorPoolSize> sizes;
        for (const VkDescriptorSetLayoutBinding& binding : bindings)
            sizes.push_back({binding.descriptorType, binding.descriptorCount});

        VkDescriptorSetLayoutCreateInfo layout_info{};
        layout_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
        layout_info.bindingCount = static_cast<std::uint32_t>(bindings.size());
        layout_info.pBindings = bindings.data();
        Handle<VkDescriptorSetLayout, &Functions::vkDestroyDescriptorSetLayout> set_layout;
        EXPECT_EQ(make_handle(call.vkCreateDescriptorSetLayout, layout_info, set_layout), VK_SUCCESS);
        VkDescriptorPoolCreateInfo pool_info{};
        pool_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
        pool_info.maxSets = 1;
        pool_info.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
        pool_info.pPoolSizes = sizes.data();
        Handle<VkDescriptorPool, &Functions::vkDestroyDescriptorPool> pool;
        EXPECT_EQ(make_handle(call.vkCreateDescriptorPool, pool_info, pool), VK_SUCCESS);
        VkDescriptorSetAllocateInfo set_info{};
        set_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
        set_info.descriptorPool = pool.get();
        set_info.descriptorSetCount = 1;
        set_info.pSetLayouts = &set_layout.get();
        VkDescriptorSet set = VK_NULL_HANDLE;
        EXPECT_EQ(call.vkAllocateDescriptorSets(device->host().device, &set_info, &set), VK_SUCCESS);

        VkPipelineLayoutCreateInfo pipeline_layout_info{};
        pipeline_layout_info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
        pipeline_layout_info.setLayoutCount = 1;
        pipeline_layout_info.pSetLayouts = &set_layout.get();
        Handle<VkPipelineLayout, &Functions::vkDestroyPipelineLayout> layout;
        EXPECT_EQ(make_handle(call.vkCreatePipelineLayout, pipeline_layout_info, layout), VK_SUCCESS);
        VkShaderModuleCreateInfo module_info{};
        module_info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
        module_info.codeSize = code.size_bytes();
        module_info.pCode = code.data();
        Handle<VkShaderModule, &Functions::vkDestroyShaderModule> module;
        EXPECT_EQ(make_handle(call.vkCreateShaderModule, module_info, module), VK_SUCCESS);
        VkComputePipelineCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
        info.layout = layout.get();
        info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
        info.stage.module = module.get();
        info.stage.pName = "main";
        VkPipeline made = VK_NULL_HANDLE;
        EXPECT_EQ(call.vkCreateComputePipelines(device->host().device, VK_NULL_HANDLE, 1, &info, nullptr, &made), VK_SUCCESS);
        const Handle<VkPipeline, &Functions::vkDestroyPipeline> pipeline(call, device->host(), made);

        const std::size_t count = each * cases.size();
        const Buffer in = uploaded(cases), out = buffer(count * sizeof(Answer), MemoryUse::readback);
        point(set, 0, in);
        point(set, 1, out);
        write(set);
        run([&](VkCommandBuffer commands) {
            call.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.get());
            call.vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout.get(), 0, 1, &set, 0, nullptr);
            call.vkCmdDispatch(commands, static_cast<std::uint32_t>(cases.size() + 63) / 64, 1, 1);
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

  private:
    template <class Create, class Info, class Made>
    VkResult make_handle(Create create, const Info& info, Made& made) {
        return vulkan::make(device->functions(), device->host(), create, info, made);
    }
};

} // namespace windrow::vulkan
