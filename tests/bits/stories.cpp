#include "tests/bits/stories.h"

#include <cstdio>
#include <cstdlib>

namespace windrow::bits {

// FNV-1a of 64 bits, Fowler, Noll and Vo, public domain. Not the library's own checksum: of a sealed file that is 0.
void Hashes::add(const std::string& what, std::span<const std::byte> bytes) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const std::byte byte : bytes)
        hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3u;
    list_.push_back({story_ + '/' + what, hash});
}

float Numbers::between(float low, float high) {
    state_ = state_ * 1664525u + 1013904223u; // Knuth's and Lewis's
    return low + (high - low) * (static_cast<float>(state_ >> 16) / 65536.0f);
}

double swing(int frame, int period) {
    const int place = frame % period;
    return 4.0 * (2 * place < period ? place : period - place) / period - 1.0;
}

void give_up(const std::string& reason) {
    std::fprintf(stderr, "windrow_bits: %s\n", reason.c_str());
    std::exit(1);
}

std::vector<Hash> all_stories(Simd level, ParallelFor parallel_for) {
    std::vector<Hash> all;
    for (const std::vector<Hash>& story : {meadow(level, parallel_for), town(level, parallel_for), duct(level, parallel_for),
                                           night(level, parallel_for), plants(parallel_for), functions()})
        for (const Hash& hash : story)
            all.push_back({std::string(name_of(level)) + '/' + hash.name, hash.value});
    return all;
}

} // namespace windrow::bits
