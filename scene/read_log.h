// What reading a scene leaves behind: every fault, not only the first, and, for who asks, every key that the reader knows.
#pragma once

#include "fluid/input_budget.h"
#include "fluid/result.h"

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace windrow::scene {

/// What a number may be.
struct NumberRule {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    bool above_least = false; ///< `least` itself is refused
    const char* unit = "";    ///< for the sentence
};

/// A key that the reader asked for. `pattern` is its path with [] for an index, * for a free name and (kind) behind an object
/// that comes in kinds: `$.motors[](wake).law.drive.per_metre`.
struct KnownKey {
    std::string pattern = {};
    /// number, integer, boolean, string, name, vector, integers, pair, whole pair, flags, object, array, or two with "or"
    std::string type = {};
    bool required = false;
    std::optional<nlohmann::json> fallback = {};
    NumberRule rule = {};
    std::vector<std::string> words = {}; ///< what a string may be
};

class ReadLog {
  public:
    /// `file` begins each sentence. `budget` is what the files of the scene may cost; it outlives the log. `known` receives the
    /// keys; null where nobody asks.
    ReadLog(std::string file, detail::InputBudget& budget, std::vector<KnownKey>* known = nullptr)
        : file_(std::move(file)), budget_(&budget), known_(known) {}

    /// Notes a fault: "file: path rest".
    void refuse(std::string_view path, std::string_view rest);
    /// Notes a fault that names its own place.
    void refuse_as_is(std::string sentence);
    void know(KnownKey key);

    [[nodiscard]] const std::string& file() const { return file_; }
    [[nodiscard]] std::size_t faults() const { return count_; }
    /// Whether further faults are only counted: their sentences need not be made.
    [[nodiscard]] bool is_full() const { return count_ >= k_most_sentences; }
    void count_fault() { ++count_; }
    [[nodiscard]] detail::InputBudget& budget() { return *budget_; }
    /// All sentences, one a line; the first 20 where there are more.
    [[nodiscard]] Error error() const;

  private:
    static constexpr std::size_t k_most_sentences = 20;

    std::string file_;
    detail::InputBudget* budget_;
    std::vector<KnownKey>* known_;
    std::string text_;
    std::size_t count_ = 0;
};

} // namespace windrow::scene
