// libFuzzer's mutator for snapshots and event logs: the content is changed, then length and checksum are made again, since the
// parser behind them would not be reached otherwise.
#include "fluid/core/bytes.h"
#include "tests/fuzz/fuzz_target.h"

#include <cstring>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    using namespace windrow;
    constexpr std::size_t k_envelope = detail::k_header_bytes + detail::k_checksum_bytes;
    if (size <= k_envelope || size > most || seed % 64 == 0) // the envelope itself
        return LLVMFuzzerMutate(data, size, most);
    if (const auto accepted = fuzz::accepted_input(seed / 256);
        seed / 64 % 4 == 0 && !accepted.empty() && accepted.size() <= most) {
        std::memcpy(data, accepted.data(), accepted.size());
        size = accepted.size();
    }
    std::size_t content = size - k_envelope;
    // Half of the changes keep the length, as most fields do.
    const std::size_t room = seed / 4096 % 2 == 0 ? content : most - k_envelope;
    content = LLVMFuzzerMutate(data + detail::k_header_bytes, content, room);
    auto* const bytes = reinterpret_cast<std::byte*>(data);
    detail::store_number(bytes + detail::k_letters + 4, static_cast<std::uint64_t>(content));
    const std::size_t sealed = detail::k_header_bytes + content;
    detail::store_number(bytes + sealed, detail::checksum({bytes, sealed}));
    return sealed + detail::k_checksum_bytes;
}
