// The word that somebody probably meant.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace windrow::scene {

/// Fewest insertions, deletions, changes and swaps of neighbours that turn one word into the other.
/// Based on: Damerau 1964, Communications of the ACM 7 (restricted form: no letter is edited twice).
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

/// The known word nearest to `word`, or an empty one where none is near enough to be a slip of the pen.
[[nodiscard]] std::string nearest_word(std::string_view word, std::span<const std::string> known);

/// " (did you mean x?)", or nothing where none is near.
[[nodiscard]] std::string did_you_mean(std::string_view word, std::span<const std::string> known);

/// " (did you mean `x`?)", or the words to choose from where none is near.
[[nodiscard]] std::string suggestion(std::string_view word, std::span<const std::string> known);

} // namespace windrow::scene
