#include "vegetation/vulkan/device.h"

#include "fluid/core/message.h"
#include "fluid/vulkan/own_device.h"
#include "vegetation/vulkan/buffer_memory.h"
#include "vegetation/vulkan/calls.h"
#include "vegetation/vulkan/objects.h"

#include <optional>

namespace windrow::vegetation::engine {
namespace {

struct Copy {
    VkBuffer from = VK_NULL_HANDLE, to = VK_NULL_HANDLE;
    VkDeviceSize bytes = 0;
};

void record(VkCommandBuffer commands, const Copy& copy) {
    const VkBufferCopy whole{0, 0, copy.bytes};
    vkCmdCopyBuffer(commands, copy.from, copy.to, 1, &whole);
}

void barrier(VkCommandBuffer commands, VkPipelineStageFlags from, VkAccessFlags written, VkPipelineStageFlags to,
             VkAccessFlags used) {
    const VkMemoryBarrier all{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, written, used};
    vkCmdPipelineBarrier(commands, from, to, 0, 1, &all, 0, nullptr, 0, nullptr);
}

Result<void> check_queue(const vulkan::Host& host, VkQueue queue) {
    if (queue == VK_NULL_HANDLE)
        return Error{"queue is null: give one of the family host.queue_family."};
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(host.physical_device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(host.physical_device, &count, families.data());
    constexpr VkQueueFlags both = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    if (host.queue_family >= count || (families[host.queue_family].queueFlags & both) != both)
        return Error{
            detail::message("queue_family ", host.queue_family,
                            " does not draw and compute: give one with VK_QUEUE_GRAPHICS_BIT and VK_QUEUE_COMPUTE_BIT.")};
    return {};
}

} // namespace

struct Device::State {
    std::unique_ptr<vulkan::OwnDevice> own{}; // ends last; null: a host's
    vulkan::Host host{};
    VkQueue queue = VK_NULL_HANDLE;
    VkPhysicalDeviceProperties properties{};
    std::string name{};
    bool counts_vertices = false;
    std::optional<BufferMemory> memory{};
    SharedObjects shared{};

    /// A batch of uploads: its staging buffers end when the frame that copies them is done.
    struct Batch {
        std::vector<Copy> copies{};
        std::unique_ptr<Objects> staging{};
    };
    Batch pending{};
    std::array<std::unique_ptr<Objects>, k_frames_in_flight> in_flight{};
    std::array<std::vector<Copy>, k_frames_in_flight> each_frame{};
};

Device::Device(std::unique_ptr<State> state) : state_(std::move(state)) {}

Device::~Device() {
    if (state_->own)
        vkDeviceWaitIdle(handle());
    state_->pending = {};
    state_->in_flight = {};
}

Result<std::unique_ptr<Device>> Device::create(const DeviceSettings& settings) {
    VkPhysicalDeviceFeatures wished{};
    wished.pipelineStatisticsQuery = VK_TRUE;
    auto own = vulkan::OwnDevice::create({.device = settings.device,
                                          .validation = settings.validation,
                                          .on_message = settings.on_message,
                                          .queue = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT,
                                          .wished = wished,
                                          .extensions = settings.extensions,
                                          .instance_extensions = settings.instance_extensions,
                                          .get_instance_proc_addr = settings.get_instance_proc_addr});
    if (!own)
        return own.failure();
    auto made = adopt((*own)->host(), (*own)->queue(), settings);
    if (!made)
        return made.failure();
    (*made)->state_->counts_vertices = (*own)->features().pipelineStatisticsQuery == VK_TRUE;
    (*made)->state_->own = *std::move(own);
    return made;
}

Result<std::unique_ptr<Device>> Device::adopt(const vulkan::Host& host, VkQueue queue, const DeviceSettings& settings) {
    const auto functions = vulkan::load_functions(host);
    if (!functions)
        return functions.failure();
    if (auto loaded = load_calls(host); !loaded)
        return loaded.failure();
    if (auto fits = vulkan::check(host.instance, host.physical_device, host.get_instance_proc_addr); !fits)
        return fits.failure();
    if (auto fits = check_queue(host, queue); !fits)
        return fits.failure();
    auto state = std::make_unique<State>();
    state->host = host;
    state->queue = queue;
    vkGetPhysicalDeviceProperties(host.physical_device, &state->properties);
    state->name = state->properties.deviceName;
    state->memory.emplace(host, *functions, settings.staged);
    return std::unique_ptr<Device>(new Device(std::move(state)));
}

const vulkan::Host& Device::host() const {
    return state_->host;
}
VkQueue Device::queue() const {
    return state_->queue;
}
const std::string& Device::name() const {
    return state_->name;
}
const VkPhysicalDeviceLimits& Device::limits() const {
    return state_->properties.limits;
}
bool Device::software() const {
    return state_->properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
}
bool Device::counts_vertices() const {
    return state_->counts_vertices;
}
VkDeviceSize Device::memory_bytes() const {
    return state_->memory->given();
}
VkDeviceSize Device::reserved_bytes() const {
    return state_->memory->taken();
}
SharedObjects& Device::shared_objects() {
    return state_->shared;
}
BufferMemory& Device::memory() const {
    return *state_->memory;
}

void Device::upload(const Buffer& to, const void* from) {
    State::Batch& batch = state_->pending;
    if (!batch.staging)
        batch.staging = std::make_unique<Objects>(*this);
    const Buffer staged = batch.staging->buffer(Use::staging, to.bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
    std::memcpy(staged.mapped, from, to.bytes);
    batch.copies.push_back({staged.buffer, to.buffer, to.bytes});
}

void Device::copy_each_frame(int slot, const Buffer& from, const Buffer& to) {
    state_->each_frame[static_cast<std::size_t>(slot)].push_back({from.buffer, to.buffer, to.bytes});
}

void Device::forget(VkBuffer to) {
    const auto goes_there = [to](const Copy& copy) { return copy.to == to; };
    std::erase_if(state_->pending.copies, goes_there);
    for (auto& copies : state_->each_frame)
        std::erase_if(copies, goes_there);
}

void Device::begin_frame(VkCommandBuffer commands, int slot) {
    State::Batch batch = std::exchange(state_->pending, {});
    const std::vector<Copy>& each_frame = state_->each_frame[static_cast<std::size_t>(slot)];
    state_->in_flight[static_cast<std::size_t>(slot)] = std::move(batch.staging); // what was there is done
    if (batch.copies.empty() && each_frame.empty())
        return;
    for (const Copy& copy : batch.copies)
        record(commands, copy);
    for (const Copy& copy : each_frame)
        record(commands, copy);
    barrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
            VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT);
}

const void* Device::read_back(const Buffer& buffer) const {
    // Whole atoms, as the memory was cut; asked of coherent memory too, where the driver has nothing to do.
    const VkDeviceSize atom = limits().nonCoherentAtomSize;
    const VkMappedMemoryRange range{.sType = VK_STRUCTURE_TYPE_MAPPED_MEMORY_RANGE,
                                    .pNext = nullptr,
                                    .memory = buffer.memory,
                                    .offset = buffer.offset,
                                    .size = (buffer.bytes + atom - 1) / atom * atom};
    (void)vkInvalidateMappedMemoryRanges(handle(), 1, &range); // fails where the host itself has no memory left
    return buffer.mapped;
}

Result<void> Device::read_bytes(VkBuffer from, VkDeviceSize offset, VkDeviceSize bytes, void* to) {
    return guarded([&] {
        Objects objects(*this);
        const Buffer here = objects.buffer(Use::readback, bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
        VkCommandPoolCreateInfo pool_info{};
        pool_info.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
        pool_info.queueFamilyIndex = host().queue_family;
        const VkCommandPool pool = objects.make(vkCreateCommandPool, vkDestroyCommandPool, pool_info, "vkCreateCommandPool");
        VkFenceCreateInfo fence_info{};
        fence_info.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
        const VkFence fence = objects.make(vkCreateFence, vkDestroyFence, fence_info, "vkCreateFence");
        VkCommandBufferAllocateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
        info.commandPool = pool;
        info.commandBufferCount = 1;
        VkCommandBuffer commands = VK_NULL_HANDLE;
        must(vkAllocateCommandBuffers(handle(), &info, &commands), "vkAllocateCommandBuffers");
        VkCommandBufferBeginInfo begin{};
        begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
        begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
        must(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
        barrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_ACCESS_MEMORY_WRITE_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT,
                VK_ACCESS_TRANSFER_READ_BIT);
        const VkBufferCopy part{offset, 0, bytes};
        vkCmdCopyBuffer(commands, from, here.buffer, 1, &part);
        barrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_HOST_BIT,
                VK_ACCESS_HOST_READ_BIT);
        must(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
        VkSubmitInfo submit{};
        submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
        submit.commandBufferCount = 1;
        submit.pCommandBuffers = &commands;
        must(vkQueueSubmit(queue(), 1, &submit, fence), "vkQueueSubmit");
        must(vkWaitForFences(handle(), 1, &fence, VK_TRUE, UINT64_MAX), "vkWaitForFences");
        std::memcpy(to, read_back(here), bytes);
    });
}

} // namespace windrow::vegetation::engine
