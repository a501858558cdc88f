#include "scene/json_document.h"

#include "fluid/core/message.h"
#include "scene/number_text.h"
#include "scene/text_file.h"

#include <algorithm>
#include <vector>

namespace windrow::scene {
namespace {

using detail::message;
using nlohmann::json;

/// Builds the document while it is parsed, since the library's own builder drops a repeated key silently.
class Builder final : public nlohmann::json_sax<json> {
  public:
    Builder(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    bool null() override { return put(nullptr); }
    bool boolean(bool value) override { return put(value); }
    bool number_integer(number_integer_t value) override { return put(value); }
    bool number_unsigned(number_unsigned_t value) override { return put(value); }
    bool number_float(number_float_t value, const string_t& raw) override {
        // The parser reads floats in the process's locale; the raw digits mean the same in each.
        return put(parse_number(raw).value_or(value));
    }
    bool string(string_t& value) override { return put(std::move(value)); }
    bool binary(binary_t&) override { return false; }

    bool start_object(std::size_t) override { return open(json::object()); }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open(json::array()); }
    bool end_array() override { return close(); }

    bool key(string_t& key) override {
        OpenValue& level = levels_.back();
        level.key = std::move(key);
        if (level.value->contains(level.key)) {
            fault_ = message(name_, ": ", join_json_path(path_of(levels_.size() - 1), level.key),
                             " is a duplicate key: remove one of the two.");
            return false;
        }
        return true;
    }

    bool parse_error(std::size_t position, const std::string& token, const nlohmann::detail::exception& thrown) override {
        // `position` counts the bytes read, the one that did not fit included.
        const std::size_t offset = std::min(position > 0 ? position - 1 : 0, text_.size());
        const TextPlace place = place_in_text(text_, offset);
        fault_ = message(name_, ":", place.line, ":", place.column, ": ", reason(offset, token, thrown));
        return false;
    }

    [[nodiscard]] std::string& fault() { return fault_; }
    [[nodiscard]] json& root() { return root_; }

  private:
    struct OpenValue {
        json* value;
        std::string key;
    };

    bool put(json&& value) { return place(std::move(value)) != nullptr; }

    json* place(json&& value) {
        if (++values_ > k_max_json_values) {
            fault_ = message(name_, ": has more than ", k_max_json_values, " values: give fewer, or put paths in tables.");
            return nullptr;
        }
        if (levels_.empty()) {
            root_ = std::move(value);
            return &root_;
        }
        OpenValue& level = levels_.back();
        if (level.value->is_array())
            return &level.value->emplace_back(std::move(value));
        return &((*level.value)[level.key] = std::move(value));
    }

    bool open(json&& value) {
        if (levels_.size() >= k_max_json_depth) {
            fault_ = message(name_, ": ", path_of(levels_.size()), " is nested deeper than ", k_max_json_depth,
                             " levels: a scene needs no more than 8.");
            return false;
        }
        json* const placed = place(std::move(value));
        if (placed != nullptr)
            levels_.push_back({placed, {}});
        return placed != nullptr;
    }

    bool close() {
        levels_.pop_back();
        return true;
    }

    /// Path of the container at the first `count` levels.
    [[nodiscard]] std::string path_of(std::size_t count) const {
        std::string path = "$";
        for (std::size_t i = 0; i < count; ++i) {
            const OpenValue& level = levels_[i];
            if (level.value->is_array()) {
                const std::size_t items = level.value->size();
                // The item that is being read is already there, unless it is the next one.
                const bool begun = i + 1 < levels_.size();
                path += message("[", begun && items > 0 ? items - 1 : items, "]");
            } else {
                path = join_json_path(path, level.key);
            }
        }
        return path;
    }

    [[nodiscard]] std::string reason(std::size_t offset, const std::string& token,
                                     const nlohmann::detail::exception& thrown) const {
        if (thrown.id == 406)
            return message("the number ", token.substr(0, 40), " is too large: give one that fits a double (up to 1.8e308).");
        // The rest of the text from the word that contains the fault.
        std::size_t start = offset;
        while (start > 0 && std::string_view("+-abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ").find(text_[start - 1]) !=
                                std::string_view::npos)
            --start;
        const std::string_view rest = text_.substr(std::min(start, text_.size()));
        for (const char* word :
             {"NaN", "nan", "NAN", "-NaN", "-nan", "Infinity", "-Infinity", "+Infinity", "inf", "-inf", "+inf", "Inf", "-Inf"})
            if (rest.starts_with(word))
                return message(word, " is not a JSON number: give a finite number.");
        if (rest.empty() || text_.find_first_not_of(" \t\r\n", offset) == std::string_view::npos)
            return "the file ends in the middle of the JSON: was it cut short, or is a closing bracket missing?";
        if (rest.starts_with("//") || rest.starts_with("/*") || rest.starts_with("#"))
            return "JSON has no comments: remove it, or write it in \"description\".";
        if (rest.starts_with("'"))
            return "JSON takes double quotes only: write \" instead of '.";
        if (const std::size_t before = text_.find_last_not_of(" \t\r\n", offset > 0 ? offset - 1 : 0);
            before != std::string_view::npos && text_[before] == ',' && (text_[offset] == '}' || text_[offset] == ']'))
            return message("trailing comma before '", text_.substr(offset, 1), "': remove it.");
        return message("is not JSON: ", words_of(thrown), ".");
    }

    /// The parser's own words without its preamble: "unexpected '}'; expected string literal".
    [[nodiscard]] static std::string words_of(const nlohmann::detail::exception& thrown) {
        std::string words = thrown.what();
        if (const std::size_t dash = words.find(" - "); dash != std::string::npos)
            words.erase(0, dash + 3);
        for (char& letter : words)
            if (letter == '\n' || letter == '\r')
                letter = ' ';
        if (words.size() > 120)
            words = words.substr(0, 120) + "...";
        return words;
    }

    std::string_view text_;
    const std::string& name_;
    json root_;
    std::vector<OpenValue> levels_;
    std::size_t values_ = 0;
    std::string fault_;
};

} // namespace

Result<json> parse_json(std::string_view text, const std::string& name) {
    Builder builder(text, name);
    if (!json::sax_parse(text.begin(), text.end(), &builder))
        return Error{builder.fault().empty() ? message(name, ": is not JSON.") : std::move(builder.fault())};
    return std::move(builder.root());
}

std::string join_json_path(std::string_view parent, std::string_view key) {
    const bool plain = !key.empty() && key.size() <= 64 && std::all_of(key.begin(), key.end(), [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9') ||
               letter == '_' || letter == '*';
    });
    if (plain)
        return message(parent, ".", key);
    return message(parent, "[", quote_json(json(key)), "]");
}

std::string quote_json(const json& value) {
    // Replace, not throw, where a cut falls into a character.
    std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
    constexpr std::size_t k_longest = 60;
    if (text.size() > k_longest) {
        std::size_t cut = k_longest;
        while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xc0u) == 0x80u)
            --cut;
        text = text.substr(0, cut) + "...";
    }
    return text;
}

} // namespace windrow::scene
