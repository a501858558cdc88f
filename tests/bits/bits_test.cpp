// The stories have the pinned bits on this machine, at each level that it runs, for any number of threads.
//
// bits.txt is pinned for all platforms: `./dev bits` compares it on those that this machine can play. After a change of the method
// WINDROW_ACCEPT_BITS=1 writes it again, on a machine with AVX-512; say in the commit why.
#include "fluid/thread_pool.h"
#include "tests/bits/table.h"

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>

namespace {

using namespace windrow;
using namespace windrow::bits;

constexpr const char* k_table = WINDROW_SOURCE_DIR "/tests/bits/bits.txt";
constexpr Simd k_levels[] = {Simd::baseline, Simd::avx2, Simd::avx512};

void expect_pinned(int threads) {
    ThreadPool pool(threads);
    std::ifstream file(k_table);
    const std::map<std::string, std::string> table = read_table(file);
    ASSERT_FALSE(table.empty()) << k_table;
    for (const Simd level : k_levels)
        if (runs(level))
            for (const std::string& line : differences(all_stories(level, pool.parallel_for()), table))
                ADD_FAILURE() << line << " (" << threads << " threads)";
}

TEST(StoryBits, ArePinned) {
    if (std::getenv("WINDROW_ACCEPT_BITS") != nullptr) {
        ASSERT_TRUE(runs(Simd::avx512)) << "the table holds all levels";
        std::ofstream file(k_table);
        for (const Simd level : k_levels)
            for (const Hash& hash : all_stories(level, {}))
                file << row_of(hash) << '\n';
    }
    expect_pinned(1);
}

TEST(StoryBits, ArePinnedForThreeThreads) {
    expect_pinned(3);
}

// What a table cannot show by passing.
TEST(StoryBits, DifferencesAreReported) {
    const std::vector<Hash> found{{"baseline/a", 1}, {"baseline/b", 2}, {"avx2/a", 3}};
    std::map<std::string, std::string> table;
    for (const Hash& hash : found)
        table[hash.name] = digits_of(hash.value);
    table["avx512/a"] = digits_of(4); // a level that this machine lacks
    EXPECT_TRUE(differences(found, table).empty());
    table["baseline/b"] = digits_of(5);
    table["avx2/c"] = digits_of(6);
    table.erase("baseline/a");
    EXPECT_EQ(differences(found, table), (std::vector<std::string>{"baseline/a 0000000000000001 is not in the table",
                                                                   "baseline/b 0000000000000002, the table has 0000000000000005",
                                                                   "avx2/c is in the table alone"}));
}

} // namespace
