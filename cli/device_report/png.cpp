// Based on: W3C, Portable Network Graphics (Second Edition), 2003: chunks (5), the filter Paeth (9.4), zlib streams (10). Deutsch, RFC
// 1951, DEFLATE 1.3, 1996: blocks with fixed codes (3.2.6). Deutsch and Gailly, RFC 1950, ZLIB 3.3, 1996: Adler-32.
#include "cli/device_report/png.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace windrow::cli {
namespace {

void append_big_endian(std::string& text, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8)
        text += static_cast<char>(value >> shift);
}

std::uint32_t crc_of(std::string_view bytes) {
    static const auto table = [] {
        std::array<std::uint32_t, 256> made{};
        for (std::uint32_t n = 0; n < 256; ++n) {
            std::uint32_t c = n;
            for (int bit = 0; bit < 8; ++bit)
                c = (c & 1u) != 0 ? 0xedb88320u ^ (c >> 1) : c >> 1;
            made[n] = c;
        }
        return made;
    }();
    std::uint32_t crc = 0xffffffffu;
    for (const char byte : bytes)
        crc = table[(crc ^ static_cast<std::uint8_t>(byte)) & 0xffu] ^ (crc >> 8);
    return ~crc;
}

std::uint32_t adler_of(std::string_view bytes) {
    std::uint32_t a = 1, b = 0;
    for (const char byte : bytes) {
        a = (a + static_cast<std::uint8_t>(byte)) % 65521u;
        b = (b + a) % 65521u;
    }
    return (b << 16) | a;
}

void append_chunk(std::string& file, std::string_view name, std::string_view content) {
    append_big_endian(file, static_cast<std::uint32_t>(content.size()));
    std::string checked(name);
    checked += content;
    file += checked;
    append_big_endian(file, crc_of(checked));
}

// Bits from the lowest of each byte on.
class BitWriter {
  public:
    explicit BitWriter(std::string& out) : out_(out) {}
    void write(std::uint32_t bits, int count) {
        held_ |= std::uint64_t{bits} << filled_;
        for (filled_ += count; filled_ >= 8; filled_ -= 8, held_ >>= 8)
            out_ += static_cast<char>(held_);
    }
    /// A Huffman code, whose highest bit comes first.
    void write_code(std::uint32_t code, int count) {
        std::uint32_t turned = 0;
        for (int bit = 0; bit < count; ++bit)
            turned |= ((code >> bit) & 1u) << (count - 1 - bit);
        write(turned, count);
    }
    void finish() { write(0, (8 - filled_) % 8); }

  private:
    std::string& out_;
    std::uint64_t held_ = 0;
    int filled_ = 0;
};

// A literal, the end of the block or a length, by the fixed code.
void write_symbol(BitWriter& bits, std::uint32_t symbol) {
    if (symbol < 144)
        bits.write_code(0x30 + symbol, 8);
    else if (symbol < 256)
        bits.write_code(0x190 + symbol - 144, 9);
    else if (symbol < 280)
        bits.write_code(symbol - 256, 7);
    else
        bits.write_code(0xc0 + symbol - 280, 8);
}

// `first` has the smallest value of each code; the number of extra bits grows by one each `step` codes from the second group on.
std::uint32_t code_of(std::uint32_t value, std::span<const std::uint16_t> first) {
    return static_cast<std::uint32_t>(std::upper_bound(first.begin(), first.end(), value) - first.begin()) - 1;
}

constexpr std::size_t k_shortest = 3, k_longest = 258, k_window = 32768;
constexpr std::uint16_t k_lengths[] = {3,  4,  5,  6,  7,  8,  9,  10, 11,  13,  15,  17,  19,  23, 27,
                                       31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258};
constexpr std::uint16_t k_distances[] = {1,   2,   3,   4,   5,   7,    9,    13,   17,   25,   33,   49,   65,    97,    129,
                                         193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};

void write_match(BitWriter& bits, std::uint32_t length, std::uint32_t distance) {
    const std::uint32_t at = code_of(length, k_lengths);
    write_symbol(bits, 257 + at);
    bits.write(length - k_lengths[at], at < 8 || at == 28 ? 0 : static_cast<int>(at / 4) - 1);
    const std::uint32_t far = code_of(distance, k_distances);
    bits.write_code(far, 5);
    bits.write(distance - k_distances[far], far < 4 ? 0 : static_cast<int>(far / 2) - 1);
}

// One block of fixed codes; matches with the last place of the same three bytes.
std::string deflate(std::string_view bytes) {
    std::string out;
    BitWriter bits(out);
    bits.write(1, 1); // the last block
    bits.write(1, 2); // of fixed codes
    std::vector<std::size_t> last(1 << 15, bytes.size());
    const auto byte = [&](std::size_t n) { return static_cast<std::uint32_t>(static_cast<std::uint8_t>(bytes[n])); };
    for (std::size_t n = 0; n < bytes.size();) {
        std::size_t length = 0, from = 0;
        if (n + k_shortest <= bytes.size()) {
            const std::uint32_t hash = ((byte(n) << 16 | byte(n + 1) << 8 | byte(n + 2)) * 2654435761u) >> 17;
            from = last[hash];
            last[hash] = n;
            const std::size_t most = std::min(k_longest, bytes.size() - n);
            if (from < n && n - from <= k_window)
                while (length < most && bytes[from + length] == bytes[n + length])
                    ++length;
        }
        if (length >= k_shortest) {
            write_match(bits, static_cast<std::uint32_t>(length), static_cast<std::uint32_t>(n - from));
            n += length;
        } else {
            write_symbol(bits, byte(n++));
        }
    }
    write_symbol(bits, 256); // the end
    bits.finish();
    return out;
}

// The neighbour nearest to left + up - corner.
int paeth(int left, int up, int corner) {
    const int guess = left + up - corner;
    const int by_left = std::abs(guess - left), by_up = std::abs(guess - up), by_corner = std::abs(guess - corner);
    return by_left <= by_up && by_left <= by_corner ? left : by_up <= by_corner ? up : corner;
}

} // namespace

std::string png_of(int width, int height, std::span<const std::byte> pixels) {
    constexpr char k_paeth = 4;
    const auto value = [&](int x, int y, int channel) {
        return x < 0 || y < 0 ? 0
                              : static_cast<int>(pixels[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                                             static_cast<std::size_t>(x)) +
                                                        static_cast<std::size_t>(channel)]);
    };
    std::string rows;
    rows.reserve((3 * static_cast<std::size_t>(width) + 1) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y) {
        rows += k_paeth;
        for (int x = 0; x < width; ++x)
            for (int channel = 0; channel < 3; ++channel)
                rows += static_cast<char>(value(x, y, channel) - paeth(value(x - 1, y, channel), value(x, y - 1, channel),
                                                                       value(x - 1, y - 1, channel)));
    }
    std::string head;
    append_big_endian(head, static_cast<std::uint32_t>(width));
    append_big_endian(head, static_cast<std::uint32_t>(height));
    head += std::string("\x08\x02\x00\x00\x00", 5); // 8 bits; red, green, blue; not interlaced
    std::string data = "\x78\x01";                  // deflate with a window of 32 KiB
    data += deflate(rows);
    append_big_endian(data, adler_of(rows));
    std::string file = "\x89PNG\r\n\x1a\n";
    append_chunk(file, "IHDR", head);
    append_chunk(file, "IDAT", data);
    append_chunk(file, "IEND", "");
    return file;
}

} // namespace windrow::cli
