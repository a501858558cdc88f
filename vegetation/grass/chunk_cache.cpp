#include "vegetation/grass/chunk_cache.h"

#include <algorithm>

namespace windrow::vegetation::grass {

ChunkCache::ChunkCache(glm::ivec2 chunks, int slots)
    : chunks_(chunks), slots_(static_cast<std::size_t>(slots)),
      slot_of_(static_cast<std::size_t>(chunks.x) * static_cast<std::size_t>(chunks.y), -1) {}

ChunkCache::Given ChunkCache::ask(Chunk chunk) {
    int& known = slot_of_[index(chunk)];
    if (known >= 0) {
        slots_[static_cast<std::size_t>(known)].asked = frame_;
        return {known, false};
    }
    // The one asked for the longest ago, free ones before all. A few hundred slots, and only for chunks that come into view.
    const auto oldest =
        std::min_element(slots_.begin(), slots_.end(), [](const Slot& a, const Slot& b) { return a.asked < b.asked; });
    if (oldest->asked == frame_)
        return {};
    if (oldest->chunk >= 0)
        slot_of_[static_cast<std::size_t>(oldest->chunk)] = -1;
    *oldest = {frame_, static_cast<int>(index(chunk))};
    known = static_cast<int>(oldest - slots_.begin());
    return {known, true};
}

void ChunkCache::forget(glm::ivec2 first, glm::ivec2 last) {
    for (int z = std::max(first.y, 0); z <= std::min(last.y, chunks_.y - 1); ++z)
        for (int x = std::max(first.x, 0); x <= std::min(last.x, chunks_.x - 1); ++x) {
            int& slot = slot_of_[index({{x, z}})];
            if (slot >= 0)
                slots_[static_cast<std::size_t>(slot)] = {};
            slot = -1;
        }
}

int ChunkCache::resident() const {
    return static_cast<int>(std::count_if(slots_.begin(), slots_.end(), [](const Slot& slot) { return slot.chunk >= 0; }));
}

} // namespace windrow::vegetation::grass
