// A wind on a compute queue beside graphics: what a family that only computes may run and who may read the textures, on a device
// that pretends to have such a family; then two queues, or the two of its kind that the device has, ordered by semaphores.
#include "examples/queue_lane.h"
#include "fluid/vulkan/wind.h"
#include "shader_words/texels.h"
#include "tests/parity/gpu.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <set>

namespace windrow::vulkan {
namespace {

constexpr std::uint32_t k_fake_family = 1;
constexpr std::uint32_t k_cells = 8; // along each axis

const Config k_gusting{
    .cells = {k_cells, k_cells, k_cells}, .ambient = {2.0f, 0.0f, 1.0f}, .gusts = {.intensity = 0.3f}, .relaxation_time = 2.0f};

// --- A family that only computes ---------------------------------------------------------------------------------------------

// What the calls below know; Vulkan's calls carry no pointer of ours.
struct FakeFamily {
    PFN_vkGetInstanceProcAddr instance_call = nullptr;
    Functions real;
    int exclusive_images = 0;
    std::set<VkImage> concurrent_images{};
    std::set<VkBuffer> concurrent_buffers{};
    std::set<std::uint32_t> families{}; ///< that share
    int barriers = 0;
    VkPipelineStageFlags stages = 0; ///< of all barriers
    bool transfers = false;          ///< of ownership, in any of them
};
FakeFamily g_fake;

// The real first family, and one that cannot draw.
void VKAPI_CALL fake_families(VkPhysicalDevice device, std::uint32_t* count, VkQueueFamilyProperties* families) {
    if (families == nullptr) {
        *count = 2;
        return;
    }
    std::uint32_t real = 1;
    g_fake.real.vkGetPhysicalDeviceQueueFamilyProperties(device, &real, families);
    families[k_fake_family] = families[0];
    families[k_fake_family].queueFlags = VK_QUEUE_COMPUTE_BIT | VK_QUEUE_TRANSFER_BIT;
}

// True where the object is shared; made exclusive then, since the family is not real.
template <class CreateInfo>
bool take_sharing(CreateInfo& info) {
    if (info.sharingMode != VK_SHARING_MODE_CONCURRENT)
        return false;
    g_fake.families.insert(info.pQueueFamilyIndices, info.pQueueFamilyIndices + info.queueFamilyIndexCount);
    info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
    info.queueFamilyIndexCount = 0;
    return true;
}

VkResult VKAPI_CALL fake_image(VkDevice device, const VkImageCreateInfo* info, const VkAllocationCallbacks* callbacks,
                               VkImage* made) {
    VkImageCreateInfo own = *info;
    const bool shared = take_sharing(own);
    const VkResult result = g_fake.real.vkCreateImage(device, &own, callbacks, made);
    if (shared)
        g_fake.concurrent_images.insert(*made);
    else
        ++g_fake.exclusive_images;
    return result;
}

VkResult VKAPI_CALL fake_buffer(VkDevice device, const VkBufferCreateInfo* info, const VkAllocationCallbacks* callbacks,
                                VkBuffer* made) {
    VkBufferCreateInfo own = *info;
    const bool shared = take_sharing(own);
    const VkResult result = g_fake.real.vkCreateBuffer(device, &own, callbacks, made);
    if (shared)
        g_fake.concurrent_buffers.insert(*made);
    return result;
}

void VKAPI_CALL fake_barrier(VkCommandBuffer commands, VkPipelineStageFlags from, VkPipelineStageFlags to,
                             VkDependencyFlags dependencies, std::uint32_t memory_count, const VkMemoryBarrier* memory,
                             std::uint32_t buffer_count, const VkBufferMemoryBarrier* buffers, std::uint32_t image_count,
                             const VkImageMemoryBarrier* images) {
    ++g_fake.barriers;
    g_fake.stages |= from | to;
    for (std::uint32_t n = 0; n < image_count; ++n)
        g_fake.transfers = g_fake.transfers || images[n].srcQueueFamilyIndex != images[n].dstQueueFamilyIndex;
    g_fake.real.vkCmdPipelineBarrier(commands, from, to, dependencies, memory_count, memory, buffer_count, buffers, image_count,
                                     images);
}

PFN_vkVoidFunction VKAPI_CALL fake_device_call(VkDevice device, const char* name) {
    if (std::strcmp(name, "vkCreateImage") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(&fake_image);
    if (std::strcmp(name, "vkCreateBuffer") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(&fake_buffer);
    if (std::strcmp(name, "vkCmdPipelineBarrier") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(&fake_barrier);
    return g_fake.real.vkGetDeviceProcAddr(device, name);
}

PFN_vkVoidFunction VKAPI_CALL fake_instance_call(VkInstance instance, const char* name) {
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(&fake_device_call);
    if (std::strcmp(name, "vkGetPhysicalDeviceQueueFamilyProperties") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(&fake_families);
    return g_fake.instance_call(instance, name);
}

class ComputeFamily : public Gpu {
  protected:
    void SetUp() override {
        Gpu::SetUp();
        ASSERT_TRUE(own);
        host = own->host();
        g_fake = {};
        g_fake.instance_call = host.get_instance_proc_addr;
        g_fake.real = device->functions();
        host.get_instance_proc_addr = &fake_instance_call;
        host.queue_family = k_fake_family;
        host.reader_queue_families = {0, 0};
    }

    // Moved, gusting and blown: every kind of barrier that a frame has.
    void live(Wind& wind) {
        ASSERT_TRUE(wind.motors().add(OmniMotor{.position = {1.0, 0.0, 1.0}}));
        for (int n = 0; n < 6; ++n) {
            ASSERT_TRUE(wind.follow({0.9 * n, 0.0, 0.0}));
            ASSERT_TRUE(wind.set_gusts({.intensity = n < 3 ? 0.3f : 0.2f, .seed = n < 3 ? 1u : 5u})); // a new tile
            run([&](VkCommandBuffer commands) { held(wind.record(commands, {.dt = 1.0 / 30.0})); });
        }
    }

    Host host;
};

// Textures and gusts are shared with the readers' family, nothing else is, and no barrier names what the family lacks.
TEST_F(ComputeFamily, RunsAWindWhoseReadersAreElsewhere) {
    auto wind = Wind::create(host, k_gusting, {.queries = ReadBack::cells});
    ASSERT_TRUE(wind) << wind.error();
    live(*wind);
    EXPECT_EQ(g_fake.exclusive_images, 0);
    for (const Textures& frame : {wind->textures(), wind->previous_textures()})
        EXPECT_TRUE(g_fake.concurrent_images.contains(frame.vectors.image));
    EXPECT_TRUE(g_fake.concurrent_buffers.contains(wind->gust_buffer()));
    EXPECT_EQ(g_fake.concurrent_buffers.size(), 2u); // it, and the one that was measured before
    EXPECT_EQ(g_fake.families, (std::set<std::uint32_t>{0, k_fake_family}));
    constexpr VkPipelineStageFlags legal = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT |
                                           VK_PIPELINE_STAGE_DRAW_INDIRECT_BIT | VK_PIPELINE_STAGE_HOST_BIT;
    EXPECT_GT(g_fake.barriers, 50);
    EXPECT_EQ(g_fake.stages & ~legal, 0u);
    EXPECT_FALSE(g_fake.transfers);

    auto plain = Wind::create(own->host(), k_gusting, {.queries = ReadBack::cells});
    ASSERT_TRUE(plain) << plain.error();
    live(*plain);
    const auto here = wind->queried(), there = plain->queried();
    ASSERT_TRUE(here && there);
    EXPECT_EQ(std::memcmp(here->field().data(), there->field().data(), here->field().size_bytes()), 0);
}

TEST_F(ComputeFamily, SharesNothingWithoutReadersElsewhere) {
    host.reader_queue_families = {k_fake_family};
    auto wind = Wind::create(host, k_gusting);
    ASSERT_TRUE(wind) << wind.error();
    EXPECT_TRUE(g_fake.concurrent_images.empty());
    EXPECT_TRUE(g_fake.concurrent_buffers.empty());
}

TEST_F(ComputeFamily, RejectsWhatItCannotDo) {
    host.reader_stages = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT;
    expect_error(Wind::create(host, {}), "reader_stages holds VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, which queue family 1 lacks");
    host.reader_stages = VK_PIPELINE_STAGE_TRANSFER_BIT;
    expect_error(Wind::create(host, {}), "reader_stages holds bits of no shader stage (4096)");
    host.reader_stages = 0;
    host.reader_queue_families = {0, 7};
    expect_error(Wind::create(host, {}), "reader_queue_families holds 7 and the device has 2");
    host.queue_family = 2;
    expect_error(Wind::create(host, {}), "queue_family is 2 and the device has 2");
}

// --- Two queues --------------------------------------------------------------------------------------------------------------

class TwoQueues : public Gpu {
  protected:
    void SetUp() override {
        setenv("VK_LAYER_ENABLES", "VALIDATION_CHECK_ENABLE_SYNCHRONIZATION_VALIDATION_QUEUE_SUBMIT", 1);
        make_own({.validation = true, .queue = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT, .compute_queue = true});
        unsetenv("VK_LAYER_ENABLES");
    }
};

/// Reads a row of texels of both frames; a set for each turn of the textures.
struct RowReader {
    Pipeline pipeline;
    std::array<Buffer, 2> rows;
    Sets sets;

    RowReader(Device& device, const Wind& wind, VkSampler sampler) {
        constexpr VkDescriptorType texture = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
        std::vector<VkDescriptorType> kinds(3, texture);
        kinds[0] = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        pipeline = *Pipeline::create(
            device, {.code = shader_words::texels, .bindings = kinds, .constants = {}, .push_bytes = 0, .name = "texels"});
        std::vector<Sets::Content> contents;
        for (std::size_t turn = 0; turn < 2; ++turn) {
            rows[turn] = *Buffer::create(device, 2 * k_cells * sizeof(glm::vec4), MemoryUse::readback);
            contents.push_back({&pipeline, {{.type = kinds[0], .buffer = rows[turn].handle()}}});
            for (const bool now : {true, false}) {
                const Textures textures = now == (turn == 0) ? wind.textures() : wind.previous_textures();
                contents.back().bindings.push_back({.type = texture, .view = textures.vectors.view, .sampler = sampler});
            }
        }
        sets = *Sets::create(device, contents);
    }

    void record(const Functions& call, VkCommandBuffer commands, std::size_t turn) const {
        pipeline.bind(call, commands, sets.at(turn));
        call.vkCmdDispatch(commands, 1, 1, 1);
    }
};

// The wind of each frame on its queue, what samples it on the other, two frames in flight: the texels are those of a wind that
// shares the queue with its reader.
TEST_F(TwoQueues, ReadTheTexelsThatOneQueueReads) {
    const Settings settings{.texel = Texel::single, .frames_in_flight = 2};
    auto beside = Wind::create(own->compute_host(), k_gusting, settings), inside = Wind::create(own->host(), k_gusting, settings);
    ASSERT_TRUE(beside) << beside.error();
    ASSERT_TRUE(inside) << inside.error();
    const Sampler sampler = nearest_sampler();
    constexpr VkPipelineStageFlags at = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT;
    {
        const QueueLane compute(own->compute_host(), own->compute_queue()), graphics(own->host(), own->queue());
        std::optional<RowReader> reader, plain;
        int compared = 0;
        double largest = 0.0;
        std::array<std::vector<glm::vec4>, 2> expected;
        const auto compare = [&](std::size_t slot) {
            graphics.wait(slot);
            if (expected[slot].empty())
                return;
            const auto texels = read<glm::vec4>(reader->rows[slot], 2 * k_cells);
            EXPECT_EQ(std::memcmp(texels.data(), expected[slot].data(), texels.size() * sizeof(glm::vec4)), 0);
            for (const glm::vec4 texel : texels)
                largest = std::max(largest, static_cast<double>(std::abs(texel.x)));
            ++compared;
        };
        for (auto* wind : {&*beside, &*inside})
            ASSERT_TRUE(wind->motors().add(VortexMotor{}));
        for (std::size_t n = 0; n < 12; ++n) {
            const std::size_t slot = n % 2;
            compute.wait(slot);
            compare(slot);
            ASSERT_TRUE(beside->follow({0.4 * static_cast<double>(n), 0.0, 0.0}));
            ASSERT_TRUE(inside->follow({0.4 * static_cast<double>(n), 0.0, 0.0}));
            compute.submit(slot, n == 0 ? VK_NULL_HANDLE : graphics.signal(), at, [&](VkCommandBuffer commands) {
                held(beside->record(commands, {.dt = 1.0 / 30.0, .slot = static_cast<int>(slot)}));
            });
            if (!reader)
                reader.emplace(*device, *beside, sampler.get());
            graphics.submit(slot, compute.signal(), at, [&](VkCommandBuffer commands) {
                reader->record(device->functions(), commands, slot);
                barrier(commands);
            });
            run([&](VkCommandBuffer commands) {
                held(inside->record(commands, {.dt = 1.0 / 30.0}));
                if (!plain)
                    plain.emplace(*device, *inside, sampler.get());
                plain->record(device->functions(), commands, slot);
                barrier(commands);
            });
            expected[slot] = read<glm::vec4>(plain->rows[slot], 2 * k_cells);
        }
        compare(0);
        compare(1);
        EXPECT_EQ(compared, 12);
        EXPECT_GT(largest, 0.1);
    }
}

} // namespace
} // namespace windrow::vulkan
