// Numbers as bytes: little-endian, fixed width on every machine. And the file envelope with a checksum:
//
//     0   8 letters    what it is
//     8   u32          layout of the content
//     12  u64          n, bytes of content
//     20  n bytes      content
//     20+n  u64        checksum of all before it
#pragma once

#include "fluid/core/message.h"
#include "fluid/result.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

namespace windrow::detail {

/// One kind of file.
struct Format {
    std::string_view letters; ///< 8 of them
    std::uint32_t version;    ///< names the layout of its content
    std::string_view name;    ///< for sentences
    std::string_view writer;  ///< which call makes one
};

/// A number as eight hexadecimal digits, for sentences.
struct Hex {
    std::uint32_t value;
};
inline void append(std::string& text, const Hex& hex) {
    for (int shift = 28; shift >= 0; shift -= 4)
        text += "0123456789abcdef"[hex.value >> shift & 15];
}

inline constexpr std::size_t k_letters = 8, k_header_bytes = 20, k_checksum_bytes = 8;

template <class Number>
using BitsOf =
    std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint8_t>>;

template <class Number>
requires std::is_arithmetic_v<Number>
void store_number(std::byte* bytes, Number value) {
    static_assert(sizeof value == 1 || sizeof value == 4 || sizeof value == 8, "other widths are not written");
    const auto bits = std::bit_cast<BitsOf<Number>>(value);
    for (std::size_t n = 0; n < sizeof bits; ++n)
        bytes[n] = static_cast<std::byte>(bits >> (8 * n));
}

template <class Number>
requires std::is_arithmetic_v<Number>
[[nodiscard]] Number load_number(const std::byte* bytes) {
    BitsOf<Number> bits = 0;
    for (std::size_t n = 0; n < sizeof bits; ++n)
        bits = static_cast<BitsOf<Number>>(bits | static_cast<BitsOf<Number>>(bytes[n]) << (8 * n));
    return std::bit_cast<Number>(bits);
}

/// FNV-1a, eight bytes at a time; the high half is folded down after each, so that changes of two sign bits cannot cancel. Each
/// round is one-to-one: a change within one word never goes unseen.
[[nodiscard]] inline std::uint64_t checksum(std::span<const std::byte> bytes) {
    constexpr std::uint64_t k_prime = 0x100000001b3;
    std::uint64_t sum = 0xcbf29ce484222325;
    const auto mix = [&](std::uint64_t word) {
        sum = (sum ^ word) * k_prime;
        sum ^= sum >> 32;
    };
    std::size_t n = 0;
    for (; n + 8 <= bytes.size(); n += 8)
        mix(load_number<std::uint64_t>(&bytes[n]));
    for (; n < bytes.size(); ++n)
        mix(static_cast<std::uint64_t>(bytes[n]));
    return sum;
}

/// Room for the header, to which content is appended before `seal`.
[[nodiscard]] inline std::vector<std::byte> begin_bytes(std::size_t expected_content) {
    std::vector<std::byte> bytes;
    bytes.reserve(k_header_bytes + expected_content + k_checksum_bytes);
    bytes.resize(k_header_bytes);
    return bytes;
}

/// Fills in the header and appends the checksum.
inline void seal(std::vector<std::byte>& bytes, const Format& format) {
    std::transform(format.letters.begin(), format.letters.end(), bytes.begin(),
                   [](char letter) { return static_cast<std::byte>(letter); });
    store_number(&bytes[k_letters], format.version);
    store_number(&bytes[k_letters + 4], static_cast<std::uint64_t>(bytes.size() - k_header_bytes));
    const std::uint64_t sum = checksum(bytes);
    bytes.resize(bytes.size() + k_checksum_bytes);
    store_number(&bytes[bytes.size() - k_checksum_bytes], sum);
}

/// The content, or why these bytes are not one whole and unchanged file of the format.
[[nodiscard]] inline Result<std::span<const std::byte>> unseal(std::span<const std::byte> bytes, const Format& format) {
    const std::size_t known = std::min(bytes.size(), k_letters);
    const auto same = [](std::byte byte, char letter) { return byte == static_cast<std::byte>(letter); };
    if (known == 0 ||
        !std::equal(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(known), format.letters.begin(), same))
        return Error{message("these bytes are not a Windrow ", format.name, ": give what ", format.writer, " returned.")};
    if (bytes.size() < k_header_bytes + k_checksum_bytes)
        return Error{message(format.name, " is truncated: it has ", bytes.size(), " bytes, fewer than any; give all that ",
                             format.writer, " returned.")};
    if (const auto version = load_number<std::uint32_t>(&bytes[k_letters]); version != format.version)
        return Error{message(format.name, " has the layout ", Hex{version}, ", this library reads ", Hex{format.version},
                             ": use the release that wrote it.")};
    const auto wanted = load_number<std::uint64_t>(&bytes[k_letters + 4]);
    const std::uint64_t there = bytes.size() - k_header_bytes - k_checksum_bytes;
    if (wanted > there)
        return Error{message(format.name, " is truncated: it holds ", there, " of ", wanted, " bytes; give all that ",
                             format.writer, " returned.")};
    const std::span<const std::byte> sealed = bytes.first(bytes.size() - k_checksum_bytes);
    if (wanted < there || checksum(sealed) != load_number<std::uint64_t>(&bytes[sealed.size()]))
        return Error{message(format.name, " has changed since it was written: its ", wanted < there ? "length" : "checksum",
                             " does not match; take another copy.")};
    return sealed.subspan(k_header_bytes);
}

} // namespace windrow::detail
