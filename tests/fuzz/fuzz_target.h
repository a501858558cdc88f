// A fuzz target: one parser, read from bytes that come from anywhere.
//
// A target defines read_input; fuzz_target.cpp hands libFuzzer's inputs to it and counts them, replay.cpp hands that of each parser the
// files of seeds/<parser> and findings/<parser>.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace windrow::fuzz {

enum class ReadOutcome {
    skipped,  ///< the target's own bound: the parser was not called, and the input is not counted
    rejected, ///< the parser returned an error
    accepted
};

/// Defined by each target. Must come back for any bytes, without a leak.
[[nodiscard]] ReadOutcome read_input(std::string_view bytes);

[[nodiscard]] inline ReadOutcome outcome_of(bool accepted) {
    return accepted ? ReadOutcome::accepted : ReadOutcome::rejected;
}

/// One of the inputs that were accepted lately; empty while there are none. A mutator that begins with it stays near what the
/// parser accepts: libFuzzer's corpus also collects every way to be rejected.
[[nodiscard]] std::string_view accepted_input(std::uint32_t random);

/// Stops the process with a sentence: an accepted input broke a promise of the library.
inline void require(bool kept, const char* promise) {
    if (kept)
        return;
    std::fprintf(stderr, "broken promise: %s\n", promise);
    std::abort();
}

} // namespace windrow::fuzz
