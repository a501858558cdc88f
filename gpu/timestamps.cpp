#include "gpu/timestamps.h"

#include "fluid/core/message.h"
#include "gpu/device.h"
#include "gpu/functions.h"

#include <vector>

namespace windrow::vulkan {
namespace {

std::uint32_t valid_bits(const Device& device) {
    std::uint32_t count = 0;
    const Functions& call = device.functions();
    call.vkGetPhysicalDeviceQueueFamilyProperties(device.host().physical_device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    call.vkGetPhysicalDeviceQueueFamilyProperties(device.host().physical_device, &count, families.data());
    const std::uint32_t family = device.host().queue_family;
    return family < count ? families[family].timestampValidBits : 0;
}

} // namespace

Result<Timestamps> Timestamps::create(Device& device, std::uint32_t count) {
    const std::uint32_t bits = valid_bits(device);
    if (bits == 0)
        return Error{detail::message("timestamps are on, but queue family ", device.host().queue_family,
                                     " of this device has none: leave them off, or give a family whose timestampValidBits "
                                     "is above 0.")};
    VkQueryPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
    info.queryType = VK_QUERY_TYPE_TIMESTAMP;
    info.queryCount = count;
    Timestamps made;
    const VkResult result = make(device.functions(), device.host(), device.functions().vkCreateQueryPool, info, made.pool_);
    if (result != VK_SUCCESS)
        return call_error("vkCreateQueryPool", detail::message(count, " timestamps"), result);
    made.functions_ = &device.functions();
    made.device_ = device.host().device;
    made.count_ = count;
    made.valid_ = bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
    made.microsecond_ = 1e-3 * static_cast<double>(device.limits().timestampPeriod); // the period is in nanoseconds
    return made;
}

void Timestamps::reset(VkCommandBuffer commands) const {
    functions_->vkCmdResetQueryPool(commands, pool_.get(), 0, count_);
}

void Timestamps::write(VkCommandBuffer commands, std::uint32_t n) const {
    functions_->vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, pool_.get(), n);
}

bool Timestamps::read(std::span<std::uint64_t> moments) const {
    return functions_->vkGetQueryPoolResults(device_, pool_.get(), 0, static_cast<std::uint32_t>(moments.size()),
                                             moments.size_bytes(), moments.data(), sizeof(std::uint64_t),
                                             VK_QUERY_RESULT_64_BIT) == VK_SUCCESS;
}

double Timestamps::microseconds(std::uint64_t from, std::uint64_t to) const {
    return static_cast<double>((to - from) & valid_) * microsecond_;
}

} // namespace windrow::vulkan
