// Compute pipelines for all winds of a device: the second wind of the same shaders and sizes compiles nothing.
//
//     host.pipeline_store = *windrow::vulkan::PipelineStore::create(host);         // once, before the first wind
//
// A pipeline is found by its shader, its specialisation constants (box, work groups) and its layout. It stays until the store
// and all winds that were made with it are gone; they go before the device.
#pragma once

#include "../api.h"
#include "../result.h"
#include "host.h"

#include <cstddef>
#include <memory>

namespace windrow::vulkan {

class WINDROW_API PipelineStore {
  public:
    /// Empty. Its pipelines have the host's allocation_callbacks and pipeline_cache. Rejects a host that a wind would reject.
    [[nodiscard]] static Result<std::shared_ptr<PipelineStore>> create(const Host& host);
    [[nodiscard]] VkDevice device() const;
    /// Pipelines that it holds.
    [[nodiscard]] std::size_t count() const;

    PipelineStore(const PipelineStore&) = delete;
    PipelineStore& operator=(const PipelineStore&) = delete;
    ~PipelineStore();

  private:
    friend class Device; // finds and makes, from any thread
    struct State;
    explicit PipelineStore(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace windrow::vulkan
