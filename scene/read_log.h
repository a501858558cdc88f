// What reading a scene leaves behind: every fault, not only the first, and, for who asks, every key that the reader knows.
#pragma once

#include "fluid/files/input_budget.h"
#include "fluid/files/pgm.h"
#include "fluid/result.h"
#include "fluid/setting.h"
#include "fluid/shapes/height_map.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace windrow::scene {

/// A key that the reader asked for. `pattern` is its path with [] for an index, * for a free name and (kind) behind an object
/// that comes in kinds: `$.motors[](wake).law.drive.per_metre`.
struct KnownKey {
    std::string pattern = {};
    /// number, integer, boolean, string, name, file, vector, integers, pair, whole pair, flags, points, object, array, or two with "or";
    /// of the object itself: "one of", where it holds one key at most; "not both", of the two keys in `words`; "needs", of the first
    /// key where it holds the second; "kind", what it is
    std::string type = {};
    bool required = false;
    std::optional<nlohmann::json> fallback = {};
    Range rule = {};
    std::vector<std::string> words = {}; ///< what a string may be
    std::string meaning = {};            ///< for people who write scenes
    std::size_t max_items = 0;           ///< of an array

    /// A value that a file may hold, not a rule of its object.
    [[nodiscard]] bool is_value() const { return type != "one of" && type != "not both" && type != "needs" && type != "kind"; }
};

/// Heights of a picture that is no PGM, from its bytes; `name` begins the sentence that says why there are none. `max_pixels`: those
/// that the scene has room for.
using HeightPictureReader = Result<HeightPicture> (*)(std::string_view bytes, const std::string& name, std::size_t max_pixels);

class ReadLog {
  public:
    /// `file` begins each sentence. `budget` is what the files of the scene may cost; it outlives the log. `known` receives the
    /// keys; null where nobody asks.
    ReadLog(std::string file, detail::InputBudget& budget, std::vector<KnownKey>* known = nullptr)
        : file_(std::move(file)), budget_(&budget), known_(known) {}

    /// Notes a fault: "file: path rest".
    void reject(std::string_view path, std::string_view rest);
    /// Notes a fault that names its own place.
    void reject_as_is(std::string sentence);
    /// Notes the faults of a validation, a line each.
    void reject_lines(std::string_view lines);
    void know(KnownKey key);
    /// Notes what is no fault, but may not be what its writer wants.
    void warn(std::string sentence) { warnings_.push_back(std::move(sentence)); }
    [[nodiscard]] std::vector<std::string> take_warnings() { return std::exchange(warnings_, {}); }

    [[nodiscard]] const std::string& file() const { return file_; }
    [[nodiscard]] std::size_t faults() const { return count_; }
    /// Whether further faults are only counted: their sentences need not be made.
    [[nodiscard]] bool is_full() const { return count_ >= k_max_sentences; }
    void count_fault() { ++count_; }
    [[nodiscard]] detail::InputBudget& budget() { return *budget_; }
    /// For height maps that are no PGM; null: there are none.
    HeightPictureReader heights = nullptr;
    /// All sentences, one a line; the first 20 where there are more.
    [[nodiscard]] Error error() const;

  private:
    static constexpr std::size_t k_max_sentences = 20;

    std::string file_;
    detail::InputBudget* budget_;
    std::vector<KnownKey>* known_;
    std::string text_;
    std::vector<std::string> warnings_;
    std::size_t count_ = 0;
};

} // namespace windrow::scene
