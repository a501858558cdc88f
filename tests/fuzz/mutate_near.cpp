// libFuzzer's mutator for parsers of plain bytes and lines: half of the inputs begin with one that was accepted, and half of the
// changes keep the length, so that chunks, rows and pixels stay where they were.
#include "tests/fuzz/fuzz_target.h"

#include <cstddef>
#include <cstring>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    const std::string_view accepted = windrow::fuzz::accepted_input(seed / 4);
    if (seed % 2 == 0 && !accepted.empty() && accepted.size() <= most) {
        std::memcpy(data, accepted.data(), accepted.size());
        size = accepted.size();
    }
    return LLVMFuzzerMutate(data, size, seed / 2 % 2 == 0 && size > 0 ? size : most);
}
