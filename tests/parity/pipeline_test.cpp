// A compute pass from its SPIR-V to its numbers.
#include "shader_words/scale.h"
#include "tests/parity/gpu.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace windrow::vulkan {
namespace {

struct ScalePush {
    std::uint32_t count;
    float factor;
};

constexpr VkDescriptorType k_two_buffers[] = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};

Sets::Content set_of(const Pipeline& pipeline, const Buffer& from, const Buffer& to) {
    return {&pipeline,
            {{.type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .buffer = from.handle()},
             {.type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .buffer = to.handle()}}};
}

class Scale : public Gpu {
  protected:
    /// Numbers that the buffers hold.
    static constexpr std::uint32_t k_count = 1000;
    static constexpr std::uint32_t k_group = 64;

    void SetUp() override {
        Gpu::SetUp();
        ASSERT_TRUE(device);
        make_all();
    }
    void make_all() {
        const std::uint32_t constants[] = {k_group, std::bit_cast<std::uint32_t>(0.5f)};
        auto made = Pipeline::create(*device, {.code = shader_words::scale,
                                               .bindings = k_two_buffers,
                                               .constants = constants,
                                               .push_bytes = sizeof(ScalePush),
                                               .name = "scale"});
        ASSERT_TRUE(made) << made.error();
        pipeline = *std::move(made);
        upload = buffer(k_count * sizeof(float), MemoryUse::upload);
        middle = buffer(k_count * sizeof(float), MemoryUse::device);
        result = buffer(k_count * sizeof(float), MemoryUse::readback);
        const Sets::Content contents[] = {set_of(pipeline, upload, middle), set_of(pipeline, middle, result)};
        auto bound = Sets::create(*device, contents);
        ASSERT_TRUE(bound) << bound.error();
        sets = *std::move(bound);
        auto* values = reinterpret_cast<float*>(upload.mapped());
        for (std::uint32_t i = 0; i < k_count; ++i)
            values[i] = static_cast<float>(i);
        ASSERT_EQ(upload.flush(), VK_SUCCESS);
    }
    void TearDown() override {
        sets = {};
        result = {};
        middle = {};
        upload = {};
        pipeline = {};
        Gpu::TearDown();
    }

    void dispatch(VkCommandBuffer commands, std::size_t set, float factor, std::uint32_t count = k_count) const {
        const Functions& functions = device->functions();
        const ScalePush push{count, factor};
        pipeline.bind(functions, commands, sets.at(set));
        functions.vkCmdPushConstants(commands, pipeline.layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof push, &push);
        functions.vkCmdDispatch(commands, (count + k_group - 1) / k_group, 1, 1);
    }

    Pipeline pipeline;
    Buffer upload, middle, result;
    Sets sets;
};

TEST_F(Scale, TwoPassesGiveTheExactNumbers) {
    run([&](VkCommandBuffer commands) {
        dispatch(commands, 0, 2.0f);
        barrier(commands);
        dispatch(commands, 1, 3.0f);
        barrier(commands);
    });
    const auto values = read<float>(result, k_count);
    for (std::uint32_t i = 0; i < k_count; ++i)
        ASSERT_EQ(values[i], 3.0f * (2.0f * static_cast<float>(i) + 0.5f) + 0.5f) << i; // each exact in a float
}

TEST_F(Scale, ARemovedBarrierIsCaught) {
    const int before = own->messages();
    run([&](VkCommandBuffer commands) {
        dispatch(commands, 0, 2.0f);
        dispatch(commands, 1, 3.0f); // reads what the first has written, with nothing between
        barrier(commands);
    });
    EXPECT_FALSE(messages.empty());
    EXPECT_EQ(own->messages() - before, static_cast<int>(messages.size()));
    for (const std::string& message : messages)
        EXPECT_NE(message.find("SYNC-HAZARD-READ-AFTER-WRITE"), std::string::npos) << message;
    messages.clear(); // they were wanted
}

// The checks that run on the device: slower, and known to stumble over what is allowed (push descriptors, timeline semaphores).
class ScaleCheckedOnTheDevice : public Scale {
  protected:
    void SetUp() override {
        make_own({.gpu_validation = true});
        ASSERT_TRUE(device);
        make_all();
    }
};

TEST_F(ScaleCheckedOnTheDevice, IsFoundInOrder) {
    run([&](VkCommandBuffer commands) {
        dispatch(commands, 0, 2.0f);
        barrier(commands);
        dispatch(commands, 1, 3.0f);
        barrier(commands);
    });
}

TEST_F(ScaleCheckedOnTheDevice, AnAccessBeyondABufferIsCaught) {
    run([&](VkCommandBuffer commands) {
        dispatch(commands, 0, 2.0f, k_count + 1);
        barrier(commands);
    });
    ASSERT_FALSE(messages.empty());
    for (const std::string& message : messages)
        EXPECT_NE(message.find("highest byte accessed"), std::string::npos) << message;
    messages.clear(); // they were wanted
}

} // namespace
} // namespace windrow::vulkan
