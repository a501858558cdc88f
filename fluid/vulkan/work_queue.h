// What a host asks of the cells between two frames, kept until the next one is recorded. A host that records nothing for long (a
// minimised window) may go on asking, so what a later call undoes or takes further is folded into it.
#pragma once

#include "fluid/ambient.h"
#include "fluid/vulkan/air.h"
#include "fluid/window.h"

#include <vector>

namespace windrow::vulkan {

/// One change of the cells, with what blew around the box when it was asked for.
struct Work {
    enum class Kind : std::uint8_t {
        fill,        ///< all ambient, with no past
        fill_before, ///< what is kept of the air too
        shift,       ///< by `move`
        add_change,  ///< of the mean wind, by `change`
        add_wind,    ///< `factor` times the ambient wind
        set,         ///< to `cells`
    };
    Kind kind = Kind::fill;
    AmbientWind ambient;
    Window window;
    bool kept = false;   ///< the air of the tick before is kept, and changes too
    bool to_air = true;  ///< of a change: false changes only what is kept
    float factor = 0.0f; ///< 1 or -1
    glm::vec3 change{0.0f};
    Air::Move move{};
    std::vector<glm::vec4> cells{};

    void record(Air& air, VkCommandBuffer commands) const;
};

class WorkQueue {
  public:
    /// Room for all that one call of the host asks for: `push` allocates nothing then.
    void make_room();
    void push(Work work);
    /// Records all in order, and forgets it.
    void record(Air& air, VkCommandBuffer commands);
    void clear() { works_.clear(); }
    [[nodiscard]] bool empty() const { return works_.empty(); }
    [[nodiscard]] std::size_t size() const { return works_.size(); }

  private:
    [[nodiscard]] bool fold(const Work& work);
    void add_change(Work change);
    void append(Work work);
    void drop_overwritten(const Work& work);

    std::vector<Work> works_, left_; ///< and scratch of `push`
};

} // namespace windrow::vulkan
