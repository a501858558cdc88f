#include "vegetation/bench/fur_counter.h"

#include <vulkan/vulkan.h>

namespace windrow::vegetation::bench {

CountedCoats::CountedCoats(engine::Device& device)
    : objects_(device), counters_{render::VertexCounter(objects_), render::VertexCounter(objects_),
                                  render::VertexCounter(objects_)},
      written_(objects_.queries(VK_QUERY_TYPE_OCCLUSION, engine::k_frames_in_flight)) {}

Result<void> CountedCoats::prepare(const render::PassContext& context) {
    if (counting) {
        for (render::VertexCounter& counter : counters_)
            counter.begin(context.commands, context.slot);
        vkCmdResetQueryPool(context.commands, written_, static_cast<std::uint32_t>(context.slot), 1);
    }
    for (const auto& coat : coats)
        if (auto prepared = coat->prepare(context); !prepared)
            return prepared;
    return {};
}

void CountedCoats::draw(const render::PassContext& context) {
    const bool colour = context.pass == render::Pass::colour;
    render::VertexCounter& counter = counters_[colour ? 0u : 1u + static_cast<std::size_t>(context.cascade)];
    const auto slot = static_cast<std::uint32_t>(context.slot);
    if (counting) {
        counter.enter(context.commands, "coats");
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
    const auto count = [&](std::size_t pass) { return render::sum_of(counters_[pass].collect(slot)); };
    CoatCosts costs{.colour = count(0), .shadow = {count(1), count(2)}};
    engine::must(vkGetQueryPoolResults(objects_.device().handle(), written_, static_cast<std::uint32_t>(slot), 1,
                                       sizeof costs.written, &costs.written, sizeof costs.written, VK_QUERY_RESULT_64_BIT),
                 "vkGetQueryPoolResults");
    return costs;
}

} // namespace windrow::vegetation::bench
