#include "vegetation/render/stage_clock.h"

#include "vegetation/vulkan/calls.h"

namespace windrow::vegetation::render {

StageClock::StageClock(engine::Objects& objects) : device_(objects.device().handle()) {
    const windrow::vulkan::Host& host = objects.device().host();
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(host.physical_device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(host.physical_device, &count, families.data());
    const std::uint32_t bits = families[host.queue_family].timestampValidBits;
    if (bits == 0)
        return;
    mask_ = bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
    tick_us_ = 1e-3 * static_cast<double>(objects.device().limits().timestampPeriod);
    pool_ = objects.queries(VK_QUERY_TYPE_TIMESTAMP, k_marks * engine::k_frames_in_flight);
}

void StageClock::begin(VkCommandBuffer commands, int slot) {
    if (!counts())
        return;
    collect(slot);
    slot_ = slot;
    names_[slot].clear();
    const std::uint32_t first = k_marks * static_cast<std::uint32_t>(slot);
    vkCmdResetQueryPool(commands, pool_, first, k_marks);
    vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, pool_, first);
}

void StageClock::mark(VkCommandBuffer commands, const char* name) {
    if (!counts() || names_[slot_].size() + 1 >= k_marks)
        return;
    names_[slot_].push_back(name);
    const auto number = k_marks * static_cast<std::uint32_t>(slot_) + static_cast<std::uint32_t>(names_[slot_].size());
    vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, pool_, number);
}

void StageClock::collect(int slot) {
    if (!counts())
        return;
    const std::size_t stages = names_[slot].size();
    if (stages == 0)
        return;
    std::array<std::uint64_t, k_marks> ticks{};
    const auto count = static_cast<std::uint32_t>(stages + 1);
    if (vkGetQueryPoolResults(device_, pool_, k_marks * static_cast<std::uint32_t>(slot), count, sizeof ticks, ticks.data(),
                              sizeof ticks[0], VK_QUERY_RESULT_64_BIT) != VK_SUCCESS)
        return;
    times_.clear();
    for (std::size_t n = 0; n < stages; ++n)
        times_.push_back({names_[slot][n], tick_us_ * static_cast<double>((ticks[n + 1] - ticks[n]) & mask_)});
}

} // namespace windrow::vegetation::render
