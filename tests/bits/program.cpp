// windrow_bits [--threads N] [--level baseline|avx2|avx512] [--against FILE]: plays the stories and prints their hashes.
//
// A row a hash, `level/story/what hash`, as tests/bits/bits.txt has them. With --against it prints one line instead, and those that
// differ; the exit code is then 1. The levels of other machines are left out.
#include "fluid/thread_pool.h"
#include "tests/bits/table.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string_view>

namespace {

using namespace windrow;
using namespace windrow::bits;

int compare(const std::vector<Hash>& found, const std::string& name) {
    std::ifstream file(name);
    const std::map<std::string, std::string> expected = read_table(file);
    const std::vector<std::string> differing = differences(found, expected);
    for (const std::string& line : differing)
        std::printf("%s\n", line.c_str());
    std::printf("%s: %zu hashes, %zu differ\n", differing.empty() ? "same" : "DIFFERENT", found.size(), differing.size());
    return differing.empty() ? 0 : 1;
}

} // namespace

int main(int count, char** arguments) {
    int threads = 1;
    std::string_view level;
    std::string against;
    for (int n = 1; n + 1 < count; n += 2) {
        const std::string_view option = arguments[n];
        if (option == "--threads")
            threads = std::atoi(arguments[n + 1]);
        else if (option == "--level")
            level = arguments[n + 1];
        else if (option == "--against")
            against = arguments[n + 1];
        else
            give_up("unknown option " + std::string(option) + ": give --threads, --level or --against");
    }
    ThreadPool pool(threads);
    std::vector<Hash> found;
    for (const Simd simd : {Simd::baseline, Simd::avx2, Simd::avx512})
        if (runs(simd) && (level.empty() || level == name_of(simd)))
            for (const Hash& hash : all_stories(simd, pool.parallel_for()))
                found.push_back(hash);
    if (!against.empty())
        return compare(found, against);
    for (const Hash& hash : found)
        std::printf("%s\n", row_of(hash).c_str());
    return 0;
}
