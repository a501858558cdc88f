// Snapshots: the whole state of a wind. What is accepted must step, and come back from its own bytes.
#include "fluid/gust_tile.h"
#include "fluid/wind.h"
#include "tests/fuzz/fuzz_target.h"

#include <span>

namespace windrow::fuzz {

ReadOutcome read_input(std::string_view bytes) {
    // Shared by all motors with eddies as long as someone holds it; baked again it takes 5 ms.
    static const auto tile = GustTile::standard();
    auto wind = Wind::load(std::as_bytes(std::span(bytes)));
    if (!wind)
        return ReadOutcome::rejected;
    (void)wind->step(1.0 / 60.0);
    const auto saved = wind->save();
    require(static_cast<bool>(saved), "a wind that was loaded can be saved");
    const auto again = Wind::load(*saved);
    require(static_cast<bool>(again), "a wind that was loaded and stepped comes back from its bytes");
    const auto once_more = again->save();
    require(once_more && *once_more == *saved, "a snapshot comes back to the bit");
    return ReadOutcome::accepted;
}

} // namespace windrow::fuzz
