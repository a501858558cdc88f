#include "vegetation/render/vertex_counter.h"

#include "vegetation/vulkan/calls.h"

namespace windrow::vegetation::render {

VertexCounter::VertexCounter(engine::Objects& objects) : device_(objects.device().handle()) {
    if (!objects.device().counts_vertices())
        return;
    pool_ = objects.queries(VK_QUERY_TYPE_PIPELINE_STATISTICS, k_most * engine::k_frames_in_flight,
                            VK_QUERY_PIPELINE_STATISTIC_INPUT_ASSEMBLY_VERTICES_BIT |
                                VK_QUERY_PIPELINE_STATISTIC_VERTEX_SHADER_INVOCATIONS_BIT |
                                VK_QUERY_PIPELINE_STATISTIC_FRAGMENT_SHADER_INVOCATIONS_BIT);
}

void VertexCounter::begin(VkCommandBuffer commands, int slot) {
    slot_ = slot;
    names_[static_cast<std::size_t>(slot)].clear();
    if (counts())
        vkCmdResetQueryPool(commands, pool_, k_most * static_cast<std::uint32_t>(slot), k_most);
}

void VertexCounter::enter(VkCommandBuffer commands, const char* name) {
    auto& names = names_[static_cast<std::size_t>(slot_)];
    open_ = counts() && names.size() < k_most;
    if (!open_)
        return;
    vkCmdBeginQuery(commands, pool_, k_most * static_cast<std::uint32_t>(slot_) + static_cast<std::uint32_t>(names.size()), 0);
    names.push_back(name);
}

void VertexCounter::leave(VkCommandBuffer commands) {
    const auto& names = names_[static_cast<std::size_t>(slot_)];
    if (open_)
        vkCmdEndQuery(commands, pool_, k_most * static_cast<std::uint32_t>(slot_) + static_cast<std::uint32_t>(names.size()) - 1);
    open_ = false;
}

std::vector<DrawnCounts> VertexCounter::collect(int slot) const {
    std::vector<DrawnCounts> drawn;
    for (const char* const name : names_[static_cast<std::size_t>(slot)]) {
        VertexCounts counted; // in the order of their bits, as the device writes them
        static_assert(sizeof counted == 3 * sizeof(std::uint64_t));
        const std::uint32_t query = k_most * static_cast<std::uint32_t>(slot) + static_cast<std::uint32_t>(drawn.size());
        if (vkGetQueryPoolResults(device_, pool_, query, 1, sizeof counted, &counted, sizeof counted, VK_QUERY_RESULT_64_BIT) !=
            VK_SUCCESS)
            return {};
        drawn.push_back({name, counted});
    }
    return drawn;
}

VertexCounts sum_of(const std::vector<DrawnCounts>& drawn) {
    VertexCounts sum;
    for (const DrawnCounts& each : drawn) {
        sum.vertices += each.counts.vertices;
        sum.invocations += each.counts.invocations;
        sum.fragments += each.counts.fragments;
    }
    return sum;
}

} // namespace windrow::vegetation::render
