// A device with the validation layer's core and synchronisation checks on, which must stay silent to the end of each test.
// WINDROW_GPU_VALIDATION=1 in the environment adds its GPU-assisted checks, which watch every access of a shader. A software
// device compiles what they make of the passes of one wind for minutes, so `./dev validate` asks for them, of some
// tests, and `./dev test` does not.
#pragma once

#include "fluid/vulkan/own_device.h"
#include "fluid/vulkan/pipeline_store.h"
#include "gpu/device.h"
#include "gpu/memory.h"

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <gtest/gtest.h>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace windrow::vulkan {

template <class Value>
void expect_error(const Result<Value>& result, const std::string& words) {
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().find(words), std::string::npos) << result.error();
}

/// A device, and the pipelines that winds on it share: a software device compiles those of one wind for a second.
struct TestDevice {
    std::shared_ptr<OwnDevice> own;
    std::shared_ptr<PipelineStore> pipelines; ///< null until a wind asks for it
};

/// Devices that the tests of a program share, with and without the layer, until the last test has run. The layer then reports
/// what a test left undestroyed; that test run by itself shows which one it is.
class SharedDevices : public testing::Environment {
  public:
    TestDevice& of(bool validation) { return devices_[validation ? 1 : 0]; }
    void TearDown() override {
        for (TestDevice& device : devices_) {
            device.pipelines.reset();
            device.own.reset();
        }
        fail_of_messages();
    }
    /// All messages of the layer become failures.
    void fail_of_messages() {
        for (const std::string& message : std::exchange(messages, {}))
            ADD_FAILURE() << "the validation layer says: " << message;
    }
    std::vector<std::string> messages; ///< since the test began, of all devices

  private:
    TestDevice devices_[2];
};

inline SharedDevices& shared_devices() {
    static auto* const devices = static_cast<SharedDevices*>(testing::AddGlobalTestEnvironment(new SharedDevices));
    return *devices;
}
inline const bool k_devices_are_known = (shared_devices(), true); // before the first test, as GoogleTest asks

class Gpu : public testing::Test {
  protected:
    void SetUp() override { share_device(true); }

    /// A device of this test alone. A test without a device fails: a machine that cannot run these must not pass for one that has.
    void make_own(OwnDevice::Settings settings) {
        const char* const gpu_validation = std::getenv("WINDROW_GPU_VALIDATION");
        if (settings.validation && gpu_validation != nullptr && std::string(gpu_validation) == "1")
            settings.gpu_validation = true;
        settings.on_message = [](const std::string& text) { shared_devices().messages.push_back(text); };
        auto made = OwnDevice::create(settings);
        ASSERT_TRUE(made) << made.error()
                          << "\nThe tests of the Vulkan backend need a driver and the validation layer; a software "
                             "one will do (Debian: mesa-vulkan-drivers, vulkan-validationlayers).";
        own = *std::move(made);
        lend();
    }
    /// The program's device.
    void share_device(bool validation) {
        shared_ = &shared_devices().of(validation);
        if (!shared_->own) {
            make_own({.validation = validation});
            shared_->own = own;
        } else {
            own = shared_->own;
            lend();
        }
    }

    void TearDown() override {
        device.reset();
        pipelines_.reset();
        own.reset(); // of a device of its own the layer reports what was never destroyed
        shared_devices().fail_of_messages();
    }

    /// For winds that share pipelines, with those of earlier tests where the device is shared.
    Host sharing_host() {
        std::shared_ptr<PipelineStore>& store = shared_ != nullptr ? shared_->pipelines : pipelines_;
        Host lent = own->host();
        if (!store)
            store = held(PipelineStore::create(lent));
        lent.pipeline_store = store;
        return lent;
    }

    /// Callbacks of a host that takes its memory from `blocks`, with a number in it that is neither 0 nor plausible, as a device's
    /// memory has what was there before. Where the host sees it: all memory of a software device.
    MemoryCallbacks memory_of(Memory& blocks) const {
        VkPhysicalDeviceMemoryProperties kinds{};
        device->functions().vkGetPhysicalDeviceMemoryProperties(own->host().physical_device, &kinds);
        return {.allocate =
                    [&blocks, kinds](const VkMemoryRequirements& needs, std::uint32_t type, MemoryPiece& piece) {
                        VkMemoryRequirements of_type = needs;
                        of_type.memoryTypeBits = 1u << type;
                        const auto given = blocks.allocate(
                            of_type, kinds.memoryTypes[type].propertyFlags & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT, 0, true);
                        if (!given)
                            return VK_ERROR_OUT_OF_DEVICE_MEMORY;
                        piece = *given;
                        if (piece.mapped != nullptr)
                            std::memset(piece.mapped, 0x3f, needs.size);
                        return VK_SUCCESS;
                    },
                .release = [&blocks](const MemoryPiece& piece) { blocks.release(piece); }};
    }

    /// The value of a call that must succeed, as a recording.
    template <class Value>
    static Value held(Result<Value> result) {
        EXPECT_TRUE(result) << result.error();
        return result ? *std::move(result) : Value{};
    }

    void run(const std::function<void(VkCommandBuffer)>& record) {
        const auto done = own->run(record);
        ASSERT_TRUE(done) << done.error();
    }

    /// What was written so far is seen by what follows.
    void barrier(VkCommandBuffer commands) const {
        const VkMemoryBarrier all{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                  .pNext = nullptr,
                                  .srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT,
                                  .dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT |
                                                   VK_ACCESS_TRANSFER_READ_BIT | VK_ACCESS_TRANSFER_WRITE_BIT |
                                                   VK_ACCESS_HOST_READ_BIT};
        constexpr VkPipelineStageFlags work = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT;
        device->functions().vkCmdPipelineBarrier(commands, work, work | VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &all, 0, nullptr, 0,
                                                 nullptr);
    }

    [[nodiscard]] Buffer buffer(VkDeviceSize bytes, MemoryUse use) {
        auto made = Buffer::create(*device, bytes, use);
        if (!made) {
            ADD_FAILURE() << made.error();
            return {};
        }
        return *std::move(made);
    }

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
        EXPECT_EQ(vulkan::make(device->functions(), device->host(), device->functions().vkCreateSampler, info, made), VK_SUCCESS);
        return made;
    }
    /// The texel itself.
    [[nodiscard]] Sampler nearest_sampler() {
        VkSamplerCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
        return sampler_of(info);
    }

    /// Runs a compute shader for `count` invocations, in groups of 64, and waits.
    void dispatch(std::span<const std::uint32_t> code, const std::vector<Binding>& bindings, std::size_t count,
                  std::span<const std::byte> push = {}) {
        std::vector<VkDescriptorType> kinds;
        for (const Binding& binding : bindings)
            kinds.push_back(binding.type);
        const auto push_bytes = static_cast<std::uint32_t>(push.size());
        const auto pipeline = Pipeline::create(
            *device, {.code = code, .bindings = kinds, .constants = {}, .push_bytes = push_bytes, .name = "of a test"});
        ASSERT_TRUE(pipeline) << pipeline.error();
        const Sets::Content content{&*pipeline, bindings};
        const auto sets = Sets::create(*device, {&content, 1});
        ASSERT_TRUE(sets) << sets.error();
        run([&](VkCommandBuffer commands) {
            const Functions& call = device->functions();
            pipeline->bind(call, commands, sets->at(0));
            if (!push.empty())
                call.vkCmdPushConstants(commands, pipeline->layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0, push_bytes, push.data());
            call.vkCmdDispatch(commands, static_cast<std::uint32_t>(count + 63) / 64, 1, 1);
            barrier(commands);
        });
    }

    /// The first `count` values of a readback buffer.
    template <class Value>
    [[nodiscard]] std::vector<Value> read(const Buffer& from, std::size_t count) const {
        EXPECT_EQ(from.invalidate(), VK_SUCCESS);
        const auto* values = reinterpret_cast<const Value*>(from.mapped());
        return {values, values + count};
    }

    std::vector<std::string>& messages = shared_devices().messages;
    std::shared_ptr<OwnDevice> own;
    std::unique_ptr<Device> device;

  private:
    void lend() {
        auto lent = Device::create(own->host());
        ASSERT_TRUE(lent) << lent.error();
        device = *std::move(lent);
    }

    TestDevice* shared_ = nullptr;
    std::shared_ptr<PipelineStore> pipelines_;
};

} // namespace windrow::vulkan
