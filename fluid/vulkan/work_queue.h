// Changes that a host asks for between two frames, kept until the next one is recorded. A host that records nothing for long (a
// minimised window) may go on asking, so a change that a later one undoes or extends is folded into it.
#pragma once

#include "fluid/core/cell_storage.h"

#include <vector>
#include <vulkan/vulkan_core.h>

namespace windrow::vulkan {

class Air;

class WorkQueue {
  public:
    /// Room for all that one call of the host asks for: `push` allocates nothing then. `cells`: of a CellChange::set; 0: none.
    void make_room(std::size_t cells = 0);
    /// Keeps a copy of the change's cells.
    void push(CellChange change);
    /// Records all in order, and forgets it.
    void record(Air& air, VkCommandBuffer commands);
    void clear();
    void shift_origin(const OriginShift& shift);
    [[nodiscard]] bool empty() const { return changes_.empty(); }
    [[nodiscard]] std::size_t size() const { return changes_.size(); }

  private:
    [[nodiscard]] bool fold(const CellChange& change);
    void add_change(const CellChange& change);
    void append(const CellChange& change);
    void drop_overwritten(const CellChange& change);

    std::vector<CellChange> changes_, left_; ///< and scratch of `push`
    std::vector<glm::vec4> cells_;           ///< of the one `set` that may wait
};

} // namespace windrow::vulkan
