// The pinned hashes: bits.txt, a row a hash. Line ends of either kind.
#pragma once

#include "tests/bits/stories.h"

#include <istream>
#include <map>

namespace windrow::bits {

[[nodiscard]] inline std::string digits_of(std::uint64_t value) {
    std::string digits;
    for (int shift = 60; shift >= 0; shift -= 4)
        digits += "0123456789abcdef"[value >> shift & 15];
    return digits;
}
[[nodiscard]] inline std::string row_of(const Hash& hash) {
    return hash.name + ' ' + digits_of(hash.value);
}

[[nodiscard]] inline std::map<std::string, std::string> read_table(std::istream& file) {
    std::map<std::string, std::string> table;
    for (std::string name, hash; file >> name >> hash;)
        table[name] = hash;
    return table;
}

/// A line for each hash that the table lacks or has otherwise, and for each row of the found levels without a hash.
[[nodiscard]] inline std::vector<std::string> differences(const std::vector<Hash>& found,
                                                          std::map<std::string, std::string> expected) {
    std::vector<std::string> lines;
    std::map<std::string, bool> levels;
    for (const Hash& hash : found) {
        levels[hash.name.substr(0, hash.name.find('/'))] = true;
        const auto row = expected.extract(hash.name);
        if (row.empty())
            lines.push_back(row_of(hash) + " is not in the table");
        else if (row.mapped() != digits_of(hash.value))
            lines.push_back(row_of(hash) + ", the table has " + row.mapped());
    }
    for (const auto& [name, value] : expected)
        if (levels.contains(name.substr(0, name.find('/'))))
            lines.push_back(name + " is in the table alone");
    return lines;
}

} // namespace windrow::bits
