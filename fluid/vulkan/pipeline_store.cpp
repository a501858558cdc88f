#include "fluid/vulkan/pipeline_store.h"

#include "fluid/core/message.h"
#include "gpu/device.h"

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

namespace windrow::vulkan {
namespace {

struct StoredPipeline {
    std::span<const std::uint32_t> code; // embedded in the program
    std::vector<std::uint32_t> constants;
    std::uint32_t push_bytes;
    std::shared_ptr<const Pipeline> pipeline;

    [[nodiscard]] bool fits(const Pipeline::Description& wanted) const {
        return push_bytes == wanted.push_bytes && std::ranges::equal(constants, wanted.constants) &&
               std::ranges::equal(pipeline->bindings(), wanted.bindings, {}, &VkDescriptorSetLayoutBinding::descriptorType) &&
               std::ranges::equal(code, wanted.code);
    }
};

} // namespace

struct WINDROW_HIDDEN PipelineStore::State {
    explicit State(std::unique_ptr<Device> lent) : device(std::move(lent)) {}

    std::unique_ptr<Device> device; // before the pipelines, which call its functions
    std::mutex mutex;               // of what follows
    std::vector<StoredPipeline> stored;
};

PipelineStore::PipelineStore(std::unique_ptr<State> state) : state_(std::move(state)) {}
PipelineStore::~PipelineStore() = default;

Result<std::shared_ptr<PipelineStore>> PipelineStore::create(const Host& host) {
    return windrow::detail::where_memory_lasts([&]() -> Result<std::shared_ptr<PipelineStore>> {
        Host own = host;
        own.pipeline_store.reset();
        auto device = Device::create(own);
        if (!device)
            return device.failure();
        return std::shared_ptr<PipelineStore>(new PipelineStore(std::make_unique<State>(*std::move(device))));
    });
}

VkDevice PipelineStore::device() const {
    return state_->device->host().device;
}

std::size_t PipelineStore::count() const {
    const std::lock_guard lock(state_->mutex);
    return state_->stored.size();
}

// Held while a pipeline is compiled: a thread that needs the same one waits for it.
Result<std::shared_ptr<const Pipeline>> Device::pipeline(const Pipeline::Description& description) {
    if (!host_.pipeline_store) {
        auto made = Pipeline::create(*this, description);
        if (!made)
            return made.failure();
        return std::make_shared<const Pipeline>(*std::move(made));
    }
    PipelineStore::State& store = *host_.pipeline_store->state_;
    const std::lock_guard lock(store.mutex);
    const auto found = std::ranges::find_if(store.stored, [&](const StoredPipeline& stored) { return stored.fits(description); });
    if (found != store.stored.end())
        return found->pipeline;
    auto made = Pipeline::create(*store.device, description);
    if (!made)
        return made.failure();
    store.stored.push_back({.code = description.code,
                            .constants = {description.constants.begin(), description.constants.end()},
                            .push_bytes = description.push_bytes,
                            .pipeline = std::make_shared<const Pipeline>(*std::move(made))});
    return store.stored.back().pipeline;
}

} // namespace windrow::vulkan
