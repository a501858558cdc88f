#include "fluid/slot_list.h"

#include "fluid/core/message.h"

#include <atomic>

namespace windrow::detail {

std::uint32_t next_owner() {
    static std::atomic<std::uint32_t> last{0};
    return 1 + last.fetch_add(1, std::memory_order_relaxed) % (~std::uint32_t{0} - 1);
}

Error list_is_full(const SlotWords& words, int count, std::uint32_t most) {
    return Error{message("there are already ", count, " ", words.entry, "s: remove some; a wind has at most ", most, ".")};
}

Error no_entry(const SlotWords& words, std::uint32_t slot, std::uint32_t generation, bool another) {
    if (another)
        return Error{message(words.entry, " ", slot, " of generation ", generation,
                             " belongs to another wind: use the handle that add() of this one returned.")};
    return Error{message(words.entry, " ", slot, " of generation ", generation, " does not exist (", words.gone,
                         "): use the handle that add() returned.")};
}

} // namespace windrow::detail
