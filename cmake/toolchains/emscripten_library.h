// Parts of the standard library that Emscripten 3.1.6 (libc++ 13) lacks, in front of every file by -include: numbers as text
// (charconv of float and double), bit_cast, three-way comparison of ranges and tuples, algorithms on ranges, atomic_ref.
//
// Results equal those of a complete library: tests/unit/emscripten_library_test.cpp compares them with GCC's. For that test
// WINDROW_LIBRARY_NAMESPACE names another namespace than std, where all of this may stand beside the real one.
// atomic_ref reads and writes plainly: a build without threads has nothing else that could see a torn value.
#pragma once
#ifdef __cplusplus

#include <algorithm>
#include <bit>
#include <charconv>
#include <compare>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <limits>
#include <string>
#include <system_error>
#include <tuple>
#include <type_traits>
#include <utility>

#ifdef WINDROW_LIBRARY_NAMESPACE
namespace WINDROW_LIBRARY_NAMESPACE {
using std::strong_ordering, std::tuple;
enum class chars_format { scientific = 1, fixed = 2, hex = 4, general = 3 };
#else
namespace std {
#endif

// --- <bit> -----------------------------------------------------------------------------------------------------------
template <class To, class From>
[[nodiscard]] constexpr To bit_cast(const From& from) noexcept {
    static_assert(sizeof(To) == sizeof(From));
    return __builtin_bit_cast(To, from);
}

// --- <charconv> ------------------------------------------------------------------------------------------------------
namespace windrow_library {

inline std::to_chars_result copy_text(char* first, char* last, const char* text, std::ptrdiff_t size) {
    if (size > last - first)
        return {last, std::errc::value_too_large};
    std::memcpy(first, text, static_cast<std::size_t>(size));
    return {first + size, std::errc{}};
}

template <class Float>
Float parse(const char* text) {
    if constexpr (sizeof(Float) == sizeof(float))
        return std::strtof(text, nullptr);
    else
        return std::strtod(text, nullptr);
}

// The end of what spells a number from `first` on, `first` where nothing does: digits, a point, an exponent, or inf and nan.
inline const char* end_of_number(const char* first, const char* last) {
    const char* at = first;
    const auto digits = [&] {
        const char* begin = at;
        while (at != last && *at >= '0' && *at <= '9')
            ++at;
        return at - begin;
    };
    const auto word = [&](const char* letters) {
        const char* from = at;
        for (; *letters != 0; ++letters, ++from)
            if (from == last || (*from | 32) != *letters)
                return false;
        at = from;
        return true;
    };
    if (at != last && *at == '-')
        ++at;
    if (word("infinity") || word("inf") || word("nan"))
        return at;
    const std::ptrdiff_t whole = digits();
    std::ptrdiff_t part = 0;
    if (at != last && *at == '.') {
        ++at;
        part = digits();
    }
    if (whole + part == 0)
        return first;
    const char* mantissa = at;
    if (at != last && (*at | 32) == 'e') {
        ++at;
        if (at != last && (*at == '+' || *at == '-'))
            ++at;
        if (digits() == 0)
            at = mantissa;
    }
    return at;
}

} // namespace windrow_library

/// The shortest text that gives the value again; of two equally long ones that without an exponent.
template <class Float>
requires std::is_floating_point_v<Float> std::to_chars_result to_chars(char* first, char* last, Float value) {
    char text[64], fixed[400];
    if (value != value || value - value != value - value) // NaN and infinity
        return windrow_library::copy_text(first, last, text, std::snprintf(text, sizeof text, "%g", static_cast<double>(value)));
    int digits = 0, size = 0;
    do
        size = std::snprintf(text, sizeof text, "%.*e", digits, static_cast<double>(value));
    while (windrow_library::parse<Float>(text) != value && ++digits < std::numeric_limits<Float>::max_digits10);
    const int exponent = std::atoi(std::strchr(text, 'e') + 1);
    const int decimals = digits > exponent ? digits - exponent : 0;
    const int plain = std::snprintf(fixed, sizeof fixed, "%.*f", decimals, static_cast<double>(value));
    return plain <= size ? windrow_library::copy_text(first, last, fixed, plain)
                         : windrow_library::copy_text(first, last, text, size);
}

/// With a number of digits, as printf's %g.
template <class Float>
requires std::is_floating_point_v<Float> std::to_chars_result to_chars(char* first, char* last, Float value, chars_format format,
                                                                       int digits) {
    char text[400];
    const char* form = format == chars_format::fixed ? "%.*f" : format == chars_format::scientific ? "%.*e" : "%.*g";
    return windrow_library::copy_text(first, last, text,
                                      std::snprintf(text, sizeof text, form, digits, static_cast<double>(value)));
}

template <class Float>
requires std::is_floating_point_v<Float> std::from_chars_result from_chars(const char* first, const char* last, Float& value) {
    const char* end = windrow_library::end_of_number(first, last);
    if (end == first)
        return {first, std::errc::invalid_argument};
    const std::string text(first, end);
    const Float found = windrow_library::parse<Float>(text.c_str());
    const bool infinite = found - found != found - found && text.find_first_of("nN") == std::string::npos;
    const auto significant = text.find_first_of("123456789");
    const bool vanished = found == Float(0) && significant != std::string::npos && significant < text.find_first_of("eE");
    if (infinite || vanished)
        return {end, std::errc::result_out_of_range};
    value = found;
    return {end, std::errc{}};
}

// --- <compare>, <tuple> ----------------------------------------------------------------------------------------------
template <class Left, class Right>
[[nodiscard]] constexpr auto lexicographical_compare_three_way(Left a, Left a_end, Right b, Right b_end) -> decltype(*a <=> *b) {
    for (; a != a_end && b != b_end; ++a, ++b)
        if (const auto order = *a <=> *b; order != 0)
            return order;
    return a != a_end ? strong_ordering::greater : b != b_end ? strong_ordering::less : strong_ordering::equal;
}

/// The first unequal parts decide; as strongly ordered as the weakest of them.
template <class... Parts>
[[nodiscard]] constexpr auto compare_tuples(const tuple<Parts...>& a, const tuple<Parts...>& b) {
    using Order = std::common_comparison_category_t<decltype(std::declval<Parts>() <=> std::declval<Parts>())...>;
    return [&]<std::size_t... n>(std::index_sequence<n...>) {
        Order order = strong_ordering::equal;
        (void)(((order = std::get<n>(a) <=> std::get<n>(b)) != 0) || ...);
        return order;
    }
    (std::index_sequence_for<Parts...>{});
}
#ifndef WINDROW_LIBRARY_NAMESPACE
template <class... Parts>
[[nodiscard]] constexpr auto operator<=>(const tuple<Parts...>& a, const tuple<Parts...>& b) {
    return compare_tuples(a, b);
}
#endif

// --- <algorithm> on ranges -------------------------------------------------------------------------------------------
namespace ranges {

template <class Range, class Out>
constexpr void copy(const Range& range, Out out) {
    std::copy(std::begin(range), std::end(range), out);
}
template <class Range, class Out>
constexpr void move(Range&& range, Out out) {
    std::move(std::begin(range), std::end(range), out);
}
template <class Range, class Out, class Change>
constexpr void transform(const Range& range, Out out, Change change) {
    std::transform(std::begin(range), std::end(range), out, change);
}
template <class Range, class Claim>
[[nodiscard]] constexpr bool all_of(const Range& range, Claim claim) {
    return std::all_of(std::begin(range), std::end(range), claim);
}
template <class Range, class Claim>
[[nodiscard]] constexpr bool any_of(const Range& range, Claim claim) {
    return std::any_of(std::begin(range), std::end(range), claim);
}
template <class Left, class Right>
[[nodiscard]] constexpr bool equal(const Left& left, const Right& right) {
    return std::equal(std::begin(left), std::end(left), std::begin(right), std::end(right));
}
template <class Left, class Right, class Same>
[[nodiscard]] constexpr bool equal(const Left& left, const Right& right, Same same) {
    return std::equal(std::begin(left), std::end(left), std::begin(right), std::end(right), same);
}

} // namespace ranges

// --- <atomic> --------------------------------------------------------------------------------------------------------
template <class Value>
class atomic_ref {
  public:
    explicit atomic_ref(Value& value) : value_(&value) {}
    Value operator=(Value value) const { return *value_ = value; }
    operator Value() const { return *value_; }
    [[nodiscard]] Value load() const { return *value_; }
    void store(Value value) const { *value_ = value; }

  private:
    Value* value_;
};
}
#endif
