#include "vegetation/bench/fur_counter.h"

#include <vulkan/vulkan.h>

namespace windrow::vegetation::bench {

CountedCoats::CountedCoats(engine::Device& device)
    : device_(device.device), counters_{render::VertexCounter(device), render::VertexCounter(device),
                                        render::VertexCounter(device)} {
    VkQueryPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
    info.queryType = VK_QUERY_TYPE_OCCLUSION;
    info.queryCount = engine::k_frames_in_flight;
    engine::must(vkCreateQueryPool(device_, &info, nullptr, &written_), "vkCreateQueryPool");
    device.at_end([vulkan = device_, pool = written_] { vkDestroyQueryPool(vulkan, pool, nullptr); });
}

void CountedCoats::prepare(const render::PassContext& context) {
    if (counting) {
        for (render::VertexCounter& counter : counters_)
            counter.begin(context.commands, context.slot);
        vkCmdResetQueryPool(context.commands, written_, static_cast<std::uint32_t>(context.slot), 1);
    }
    for (const auto& coat : coats)
        coat->prepare(context);
}

void CountedCoats::draw(const render::PassContext& context) {
    const bool colour = context.pass == render::Pass::colour;
    render::VertexCounter& counter = counters_[colour ? 0u : 1u + static_cast<std::size_t>(context.cascade)];
    const auto slot = static_cast<std::uint32_t>(context.slot);
    if (counting) {
        counter.enter(context.commands);
        if (colour) // without the precise bit, which the engine does not ask its device for: llvmpipe and GPUs count all the same
            vkCmdBeginQuery(context.commands, written_, slot, 0);
    }
    if (!hidden)
        for (const auto& coat : coats)
            coat->draw(context);
    if (counting) {
        if (colour)
            vkCmdEndQuery(context.commands, written_, slot);
        counter.leave(context.commands);
    }
}

CoatCosts CountedCoats::collect(int slot) const {
    CoatCosts costs{.colour = counters_[0].collect(slot), .shadow = {counters_[1].collect(slot), counters_[2].collect(slot)}};
    engine::must(vkGetQueryPoolResults(device_, written_, static_cast<std::uint32_t>(slot), 1, sizeof costs.written,
                                       &costs.written, sizeof costs.written, VK_QUERY_RESULT_64_BIT),
                 "vkGetQueryPoolResults");
    return costs;
}

} // namespace windrow::vegetation::bench
