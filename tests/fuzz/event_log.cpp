// Event logs: calls of a host. What is accepted comes back to the bit, and is replayed until a call is rejected.
#include "fluid/event_log.h"

#include "fluid/gust_tile.h"
#include "fluid/wind.h"
#include "tests/fuzz/fuzz_target.h"

#include <algorithm>

namespace windrow::fuzz {

ReadOutcome read_input(std::string_view bytes) {
    static const auto tile = GustTile::standard();
    const auto input = std::as_bytes(std::span(bytes));
    const auto log = EventLog::from_bytes(input);
    if (!log)
        return ReadOutcome::rejected;
    const auto bytes_again = log->to_bytes();
    require(bytes_again && std::ranges::equal(*bytes_again, input), "an event log comes back to the bit");
    // Each change of gusts bakes a tile for 5 ms; the second is the first's code.
    const auto gusts = std::ranges::count_if(log->events(), [](const Event& e) { return std::holds_alternative<GustsSet>(e); });
    if (gusts > 1)
        return ReadOutcome::accepted;
    auto wind = Wind::create({.cells = {3, 3, 3}});
    (void)replay(*log, *wind);
    return ReadOutcome::accepted;
}

} // namespace windrow::fuzz
