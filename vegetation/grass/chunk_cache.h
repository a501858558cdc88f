// Which chunks have memory: a fixed number of slots, given to the chunks that views ask for, taken from those that none asked for
// the longest. A field of any size needs no more than its slots.
#pragma once

#include "vegetation/grass/chunk_tree.h"

#include <cstdint>
#include <span>
#include <vector>

namespace windrow::vegetation::grass {

class ChunkCache {
  public:
    ChunkCache(glm::ivec2 chunks, int slots);

    /// Begins a frame: what is asked for from here on keeps its slot until the next.
    void begin_frame() { ++frame_; }
    struct Given {
        int slot = -1;     ///< -1: all slots are asked for in this frame
        bool made = false; ///< the chunk had none before: its blades must be made
    };
    [[nodiscard]] Given ask(Chunk chunk);
    /// The blades of all chunks in a box of chunks, ends included, must be made again: they lose their slots.
    void forget(glm::ivec2 first, glm::ivec2 last);
    /// The slot of a chunk, -1 where it has none.
    [[nodiscard]] int slot_of(Chunk chunk) const { return slot_of_[index(chunk)]; }
    [[nodiscard]] int resident() const;

  private:
    struct Slot {
        std::int64_t asked = -1; // the frame in which it was last asked for
        int chunk = -1;
    };
    [[nodiscard]] std::size_t index(Chunk chunk) const { return static_cast<std::size_t>(chunk.at.y) * chunks_.x + chunk.at.x; }

    glm::ivec2 chunks_{0};
    std::int64_t frame_ = 0;
    std::vector<Slot> slots_{};
    std::vector<int> slot_of_{};
};

} // namespace windrow::vegetation::grass
