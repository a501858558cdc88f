#include "scene/nearest_word.h"

#include <algorithm>
#include <vector>

namespace windrow::scene {

int edit_distance(std::string_view a, std::string_view b) {
    const std::size_t width = b.size() + 1;
    std::vector<int> table((a.size() + 1) * width);
    const auto at = [&](std::size_t i, std::size_t j) -> int& { return table[i * width + j]; };
    for (std::size_t i = 0; i <= a.size(); ++i)
        at(i, 0) = static_cast<int>(i);
    for (std::size_t j = 0; j <= b.size(); ++j)
        at(0, j) = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i)
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const int change = a[i - 1] == b[j - 1] ? 0 : 1;
            int best = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, at(i - 1, j - 1) + change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                best = std::min(best, at(i - 2, j - 2) + 1);
            at(i, j) = best;
        }
    return at(a.size(), b.size());
}

std::string nearest_word(std::string_view word, std::span<const std::string> known) {
    // Bounds the table for long unknown keys and long candidate names.
    constexpr std::size_t k_longest = 64;
    if (word.size() > k_longest)
        return {};
    std::string nearest;
    int least = static_cast<int>(std::max<std::size_t>(word.size() / 3, 1)) + 1;
    for (const std::string& candidate : known) {
        if (candidate.size() > k_longest)
            continue;
        // A prefix of a word ("vel" for "velocity") is near at any length.
        const bool begun = word.size() >= 3 && (candidate.starts_with(word) || word.starts_with(candidate));
        const int distance = begun ? 1 : edit_distance(word, candidate);
        if (distance < least) {
            least = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

std::string did_you_mean(std::string_view word, std::span<const std::string> known) {
    const std::string near = nearest_word(word, known);
    return near.empty() ? near : " (did you mean " + near + "?)";
}

std::string suggestion(std::string_view word, std::span<const std::string> known) {
    if (const std::string nearest = nearest_word(word, known); !nearest.empty())
        return " (did you mean `" + nearest + "`?)";
    if (known.empty())
        return {};
    // A scene may have thousands of names, or one of megabytes.
    constexpr std::size_t k_max_bytes = 1000;
    std::string text = " (known:";
    for (std::size_t i = 0; i < known.size(); ++i) {
        if (text.size() + known[i].size() > k_max_bytes)
            return text + (i == 0 ? " " : ", ") + "...)";
        text += (i == 0 ? " " : ", ") + known[i];
    }
    return text + ")";
}

} // namespace windrow::scene
