#include "vegetation/render/vertex_counter.h"

#include "vegetation/vulkan/calls.h"

namespace windrow::vegetation::render {

VertexCounter::VertexCounter(engine::Objects& objects) : device_(objects.device().handle()) {
    if (!objects.device().counts_vertices())
        return;
    pool_ = objects.queries(VK_QUERY_TYPE_PIPELINE_STATISTICS, engine::k_frames_in_flight,
                            VK_QUERY_PIPELINE_STATISTIC_INPUT_ASSEMBLY_VERTICES_BIT |
                                VK_QUERY_PIPELINE_STATISTIC_VERTEX_SHADER_INVOCATIONS_BIT |
                                VK_QUERY_PIPELINE_STATISTIC_FRAGMENT_SHADER_INVOCATIONS_BIT);
}

void VertexCounter::begin(VkCommandBuffer commands, int slot) {
    query_ = static_cast<std::uint32_t>(slot);
    if (counts())
        vkCmdResetQueryPool(commands, pool_, query_, 1);
}

void VertexCounter::enter(VkCommandBuffer commands) {
    if (counts())
        vkCmdBeginQuery(commands, pool_, query_, 0);
}

void VertexCounter::leave(VkCommandBuffer commands) {
    if (counts())
        vkCmdEndQuery(commands, pool_, query_);
}

VertexCounts VertexCounter::collect(int slot) const {
    VertexCounts counted; // in the order of their bits, as the device writes them
    static_assert(sizeof counted == 3 * sizeof(std::uint64_t));
    if (!counts() || vkGetQueryPoolResults(device_, pool_, static_cast<std::uint32_t>(slot), 1, sizeof counted, &counted,
                                           sizeof counted, VK_QUERY_RESULT_64_BIT) != VK_SUCCESS)
        return {};
    return counted;
}

} // namespace windrow::vegetation::render
