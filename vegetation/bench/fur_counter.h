// What the coats of a picture cost, without the ground and the sky: their draws between counters of their own.
#pragma once

#include "vegetation/fur/coat.h"
#include "vegetation/render/vertex_counter.h"

#include <array>
#include <memory>
#include <vector>

namespace windrow::vegetation::bench {

struct CoatCosts {
    render::VertexCounts colour{};                ///< of the colour pass, one before it for depth included
    std::array<render::VertexCounts, 2> shadow{}; ///< of the near and the far map
    std::uint64_t written = 0;                    ///< samples of the colour pass that passed the discard and the depth test
    std::uint64_t pixels = 0;                     ///< that differ from a picture without coats; FurStage::count fills it in
};

/// All coats of a picture as one drawable, in the order in which they came.
class CountedCoats final : public render::Drawable {
  public:
    /// Throws engine::Failure.
    explicit CountedCoats(engine::Device& device);

    std::vector<std::unique_ptr<fur::Coat>> coats{};
    bool counting = false; ///< of the frames from now on; timed frames have no queries within
    bool hidden = false;   ///< nothing is drawn from now on

    Result<void> prepare(const render::PassContext& context) override;
    void draw(const render::PassContext& context) override;
    /// Of a slot's frame that counted, which the host has waited for.
    [[nodiscard]] CoatCosts collect(int slot) const;

  private:
    engine::Objects objects_;
    std::array<render::VertexCounter, 3> counters_; ///< colour, near shadow, far shadow: a query counts once a frame
    VkQueryPool written_ = VK_NULL_HANDLE;
};

} // namespace windrow::vegetation::bench
