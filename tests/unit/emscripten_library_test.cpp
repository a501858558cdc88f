// cmake/toolchains/emscripten_library.h, what Emscripten's standard library lacks, against this compiler's own.
//
// Wrong code that this catches: a number written with 16 digits, which another double has too; an exponent where none is shorter;
// "1e" read as a number; a fold over a tuple that goes on behind the first difference.
#define WINDROW_LIBRARY_NAMESPACE lacking
#include "cmake/toolchains/emscripten_library.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <random>
#include <string_view>
#include <vector>

namespace {

template <class Float>
std::string text_by_lacking(Float value) {
    char text[64];
    return {text, lacking::to_chars(text, text + sizeof text, value).ptr};
}
template <class Float>
std::string text_by_standard(Float value) {
    char text[64];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

template <class Float, class Bits>
void expect_texts_of_the_standard() {
    for (const double value :
         {0.0, -0.0, 1.0, 100.0, 1e5, 123456.0, 1e6, 0.001, 0.0001, 1e-5, 0.1, 1.0 / 3.0, 1e22, 2.5e-7, 16777216.0})
        EXPECT_EQ(text_by_lacking(static_cast<Float>(value)), text_by_standard(static_cast<Float>(value)));
    std::mt19937_64 random(1);
    for (int n = 0; n < 20000; ++n) {
        const auto value = std::bit_cast<Float>(static_cast<Bits>(random()));
        if (!std::isfinite(value))
            continue;
        const std::string text = text_by_lacking(value);
        ASSERT_EQ(text.size(), text_by_standard(value).size())
            << text_by_standard(value); // equally short: the last digit is a library's own choice
        Float back = 0;
        const auto read = lacking::from_chars(text.data(), text.data() + text.size(), back);
        ASSERT_EQ(std::bit_cast<Bits>(back), std::bit_cast<Bits>(value)) << text;
        ASSERT_EQ(read.ptr, text.data() + text.size());
    }
}

TEST(EmscriptenLibrary, WritesFloatsAsTheStandardDoes) {
    expect_texts_of_the_standard<float, std::uint32_t>();
}
TEST(EmscriptenLibrary, WritesDoublesAsTheStandardDoes) {
    expect_texts_of_the_standard<double, std::uint64_t>();
}

TEST(EmscriptenLibrary, WritesAGivenNumberOfDigits) {
    for (const float value : {0.0f, 1.0f, 123456.78f, -1e-6f, 3.0e8f}) {
        char mine[64], theirs[64];
        const auto mine_end = lacking::to_chars(mine, mine + 64, value, lacking::chars_format::general, 7).ptr;
        const auto theirs_end = std::to_chars(theirs, theirs + 64, value, std::chars_format::general, 7).ptr;
        EXPECT_EQ(std::string(mine, mine_end), std::string(theirs, theirs_end));
    }
    char small[2];
    EXPECT_EQ(lacking::to_chars(small, small + 2, 123.0).ec, std::errc::value_too_large);
}

TEST(EmscriptenLibrary, ReadsNumbersAsTheStandardDoes) {
    for (const std::string_view text :
         {"1",  "-2.5",  ".5",     "5.",  "1e3", "1e",  "1e+",  "1.5E-3x",  "",      "-",   ".",    "+1",
          " 1", "1e400", "1e-400", "0e5", "0.0", "inf", "-INF", "infinity", "infin", "nan", "0x10", "1e-320"}) {
        double mine = 7.0, theirs = 7.0;
        const auto a = lacking::from_chars(text.data(), text.data() + text.size(), mine);
        const auto b = std::from_chars(text.data(), text.data() + text.size(), theirs);
        EXPECT_EQ(a.ec, b.ec) << text;
        EXPECT_EQ(a.ptr - text.data(), b.ptr - text.data()) << text;
        EXPECT_TRUE(mine == theirs || (std::isnan(mine) && std::isnan(theirs))) << text << ' ' << mine << ' ' << theirs;
    }
}

TEST(EmscriptenLibrary, ComparesAsTheStandardDoes) {
    const std::array<std::vector<int>, 5> lists{{{}, {1}, {1, 2}, {1, 3}, {2}}};
    for (const auto& a : lists)
        for (const auto& b : lists)
            EXPECT_EQ(lacking::lexicographical_compare_three_way(a.begin(), a.end(), b.begin(), b.end()), a <=> b);
    EXPECT_EQ(lacking::compare_tuples(std::tuple(1, 2.0f, 9u), std::tuple(1, 3.0f, 1u)), std::partial_ordering::less);
    EXPECT_EQ(lacking::compare_tuples(std::tuple(1, 2), std::tuple(1, 2)), std::strong_ordering::equal);
    EXPECT_EQ(lacking::compare_tuples(std::tuple(1, NAN), std::tuple(1, NAN)), std::partial_ordering::unordered);
}

TEST(EmscriptenLibrary, HasTheAlgorithmsOnRanges) {
    const std::vector<int> numbers{1, 2, 3};
    std::vector<int> copied(3), doubled(3);
    lacking::ranges::copy(numbers, copied.begin());
    lacking::ranges::transform(numbers, doubled.begin(), [](int n) { return 2 * n; });
    EXPECT_TRUE(lacking::ranges::equal(copied, numbers));
    EXPECT_FALSE(lacking::ranges::equal(std::vector{1, 2}, numbers));
    EXPECT_EQ(doubled, (std::vector{2, 4, 6}));
    EXPECT_TRUE(lacking::ranges::any_of(numbers, [](int n) { return n == 3; }));
    EXPECT_FALSE(lacking::ranges::all_of(numbers, [](int n) { return n == 3; }));
    EXPECT_EQ(lacking::bit_cast<std::uint32_t>(1.0f), 0x3f800000u);
    bool held = false;
    const lacking::atomic_ref reference(held);
    reference = true;
    EXPECT_TRUE(held && reference);
}

} // namespace
