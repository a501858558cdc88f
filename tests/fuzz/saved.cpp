// Trails, lag, springs and files of several parts: what is accepted goes on, and comes back from its own bytes.
#include "coupling/cascade.h"
#include "coupling/ground_memory.h"
#include "fluid/saved_parts.h"
#include "tests/fuzz/fuzz_target.h"

#include <cmath>

namespace windrow::fuzz {
namespace {

template <class Kind>
void require_round_trip(const Kind& kind) {
    const auto saved = kind.save();
    require(static_cast<bool>(saved), "what was loaded can be saved");
    const auto again = Kind::load(*saved);
    require(static_cast<bool>(again), "what was loaded and stepped comes back from its bytes");
    const auto once_more = again->save();
    require(once_more && *once_more == *saved, "it comes back to the bit");
}

} // namespace

ReadOutcome read_input(std::string_view text) {
    const auto bytes = std::as_bytes(std::span(text));
    if (auto ground = GroundMemory::load(bytes)) {
        const GroundWalker walker{.position = {0.5, 0.0, 0.0}};
        require(static_cast<bool>(ground->advance({.duration = 0.02, .walkers = {&walker, 1}})), "a loaded ground goes on");
        require(std::isfinite(ground->at({0.5, 0.0, 0.0}).lean.x), "a loaded ground has finite leans");
        require_round_trip(*ground);
        return ReadOutcome::accepted;
    }
    if (auto tail = Cascade::load(bytes)) {
        require(static_cast<bool>(tail->advance(0.02, {})), "a loaded cascade goes on");
        require(std::isfinite(tail->at(1.0).position.x), "a loaded cascade has finite places");
        require_round_trip(*tail);
        return ReadOutcome::accepted;
    }
    std::vector<float> values(10);
    const auto array = [&](std::size_t n) { return std::span(values).subspan(2 * n, 2); };
    if (load_springs<float>(bytes, {.place = array(0), .velocity = array(1), .target_before = {}, .target_now = {}}, array(2))) {
        const auto step = spring_step(springs::grass, 0.02);
        (void)advance_springs<float>(*step, {array(0), array(1), array(2), array(2)});
        require(std::isfinite(values[0]), "loaded springs have finite places");
        return ReadOutcome::accepted;
    }
    const auto parts = split_parts(bytes);
    if (!parts)
        return ReadOutcome::rejected;
    const auto joined = join_parts(*parts);
    require(joined && std::ranges::equal(*joined, bytes), "parts are joined to the same file");
    return ReadOutcome::accepted;
}

} // namespace windrow::fuzz
