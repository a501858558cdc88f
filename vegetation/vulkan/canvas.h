// A small picture to draw to, offscreen: colour and depth, resolved where it has several samples a pixel, and its way to the
// host.
#pragma once

#include "pipeline.h"
#include "render_pass.h"

#include <optional>

namespace windrow::vegetation::engine {

class Canvas {
  public:
    /// `format` of four bytes a pixel; `samples` 1 or 4, which every device has. Depth has 16 bits.
    Canvas(Objects& objects, VkExtent2D extent, VkFormat format, VkSampleCountFlagBits samples);

    /// Targets that a pipeline must match.
    [[nodiscard]] PassTarget target() const { return {.render_pass = pass_->handle(), .samples = samples_}; }
    /// Begins the render pass over black.
    void begin(VkCommandBuffer commands) const { pass_->begin(commands); }
    /// Ends it, and copies the picture to the host.
    void end(VkCommandBuffer commands) const;
    /// Four bytes a pixel, row by row from the top, once the frame is done. Good until the next is drawn.
    [[nodiscard]] std::span<const std::byte> pixels() const;

  private:
    const Device& device_;
    VkExtent2D extent_{};
    VkSampleCountFlagBits samples_{};
    Image picture_{};
    Buffer pixels_{};
    std::optional<RenderPass> pass_{};
};

} // namespace windrow::vegetation::engine
