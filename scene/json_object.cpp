#include "scene/json_object.h"

#include "fluid/core/validation.h"
#include "scene/json_document.h"
#include "scene/nearest_word.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace windrow::scene {
namespace {

using detail::Figure, detail::message;
using nlohmann::json;

/// A default that JSON can represent.
std::optional<json> finite(float value) {
    return std::isfinite(value) ? std::optional<json>(value) : std::nullopt;
}

/// Reason for the rejection of an unknown key.
std::string unknown_key(std::string_view key, std::span<const std::string> known) {
    constexpr std::pair<const char*, const char*> k_renamed[] = {
#include "scene/renamed_keys.inl"
    };
    for (const auto& [before, now] : k_renamed)
        if (key == before && std::find(known.begin(), known.end(), now) != known.end())
            return message("is now called \"", now, "\": rename it, or run ./dev rename-scene on the file.");
    return message("is not a known key", suggestion(key, known), ": rename or remove it.");
}

} // namespace

JsonObject::JsonObject(const json& value, std::string path, std::string pattern, ReadLog& log)
    : value_(&value), path_(std::move(path)), pattern_(std::move(pattern)), log_(&log) {
    if (!value.is_object()) {
        static const json k_empty = json::object();
        log.reject(path_, message("is ", quote_json(value), ": give an object, {...}."));
        value_ = &k_empty;
        broken_ = true;
    }
}

// --- Values ----------------------------------------------------------------------------------------------------------

std::optional<double> JsonObject::check_number(const json& value, const std::string& path, const Range& rule, ReadLog& log) {
    if (!value.is_number()) {
        log.reject(path, message("is ", quote_json(value), ": give a number."));
        return std::nullopt;
    }
    const auto number = value.get<double>();
    if (!rule.holds(number) || !std::isfinite(number)) {
        log.reject(path, message("is ", Figure{number}, detail::Unit{rule.unit}, ": give ", detail::Bounds{rule}, "."));
        return std::nullopt;
    }
    return number;
}

double JsonObject::number(const Key& key, double fallback, const Range& rule) {
    const json* const value = note({.type = "number", .fallback = fallback, .rule = rule}, key);
    return value == nullptr ? fallback : check_number(*value, path_of(key), rule, *log_).value_or(fallback);
}

std::optional<double> JsonObject::optional_number(const Key& key, const Range& rule) {
    const json* const value = note({.type = "number", .rule = rule}, key);
    return value == nullptr ? std::nullopt : check_number(*value, path_of(key), rule, *log_);
}

double JsonObject::required_number(const Key& key, const Range& rule) {
    const json* const value = note({.type = "number", .required = true, .rule = rule}, key);
    return value == nullptr ? rule.min : check_number(*value, path_of(key), rule, *log_).value_or(rule.min);
}

float JsonObject::real(const Key& key, float fallback, const Range& rule) {
    const json* const value = note({.type = "number", .fallback = finite(fallback), .rule = rule}, key);
    if (value == nullptr)
        return fallback;
    const auto number = check_number(*value, path_of(key), rule, *log_);
    // A float's range is smaller than a double's; where no rule bounds the value, it is clamped to the largest float.
    constexpr double k_most = std::numeric_limits<float>::max();
    return number ? static_cast<float>(std::clamp(*number, -k_most, k_most)) : fallback;
}

std::int64_t JsonObject::whole(const Key& key, std::int64_t fallback, const Range& rule) {
    const json* const value = note({.type = "integer", .fallback = fallback, .rule = rule}, key);
    if (value == nullptr)
        return fallback;
    const auto number = check_number(*value, path_of(key), rule, *log_);
    if (number && *number != std::floor(*number)) {
        reject(key, message("is ", Figure{*number}, ": give a whole number."));
        return fallback;
    }
    return number ? static_cast<std::int64_t>(*number) : fallback;
}

int JsonObject::integer(const Key& key, int fallback, const Range& rule) {
    return static_cast<int>(whole(key, fallback, rule));
}

bool JsonObject::boolean(const Key& key, bool fallback) {
    const json* const value = note({.type = "boolean", .fallback = fallback}, key);
    if (value == nullptr || value->is_boolean())
        return value == nullptr ? fallback : value->get<bool>();
    reject(key, message("is ", quote_json(*value), ": give true or false."));
    return fallback;
}

std::string JsonObject::text(const Key& key, const std::string& fallback, const char* type) {
    const json* const value = note({.type = type, .fallback = fallback}, key);
    if (value == nullptr || value->is_string())
        return value == nullptr ? fallback : value->get<std::string>();
    reject(key, message("is ", quote_json(*value), ": give a string in double quotes."));
    return fallback;
}

std::size_t JsonObject::word_index(const Key& key, const std::string& fallback, std::vector<std::string> words) {
    KnownKey known{.type = "string", .required = fallback.empty(), .words = words};
    if (!fallback.empty())
        known.fallback = fallback;
    const json* const value = note(std::move(known), key);
    if (value == nullptr)
        return static_cast<std::size_t>(std::find(words.begin(), words.end(), fallback) - words.begin());
    if (value->is_string())
        if (const auto found = std::find(words.begin(), words.end(), value->get_ref<const std::string&>()); found != words.end())
            return static_cast<std::size_t>(found - words.begin());
    std::string choice;
    for (const std::string& word : words)
        choice += (choice.empty() ? "\"" : ", \"") + word + "\"";
    reject(key, message("is ", quote_json(*value), ": give ", words.size() > 1 ? "one of " : "", choice, "."));
    return words.size();
}

std::optional<std::size_t> JsonObject::name(const Key& key, std::span<const std::string> names, const char* what, bool required) {
    const json* const value = note({.type = "name", .required = required}, key);
    if (value == nullptr)
        return std::nullopt;
    if (!value->is_string()) {
        reject(key, message("is ", quote_json(*value), ": give a name of $.", what, " in double quotes."));
        return std::nullopt;
    }
    const auto& word = value->get_ref<const std::string&>();
    if (const auto found = std::find(names.begin(), names.end(), word); found != names.end())
        return static_cast<std::size_t>(found - names.begin());
    if (log_->is_full())
        log_->count_fault();
    else
        reject(key, message("is ", quote_json(*value), ", which is not in $.", what, suggestion(word, names),
                            ": add it there or name another."));
    return std::nullopt;
}

// --- Containers ------------------------------------------------------------------------------------------------------

JsonObject JsonObject::object(const Key& key) {
    static const json k_empty = json::object();
    const json* const value = note({.type = "object"}, key);
    JsonObject child(value == nullptr ? k_empty : *value, path_of(key), join_json_path(pattern_, key.name), *log_);
    child.broken_ = child.broken_ || broken_;
    return child;
}

std::span<const json> JsonObject::array(const Key& key, std::size_t most, const char* type, const Range& rule) {
    const json* const value = note({.type = type, .rule = rule, .max_items = most}, key);
    if (value == nullptr)
        return {};
    if (!value->is_array()) {
        reject(key, message("is ", quote_json(*value), ": give a list, [...]."));
        return {};
    }
    if (value->size() > most) {
        reject(key, message("holds ", value->size(), " items: give at most ", most, "."));
        return {};
    }
    return value->get_ref<const json::array_t&>();
}

std::size_t JsonObject::one_of(std::initializer_list<const char*> keys, const char* fallback) {
    std::size_t chosen = keys.size();
    std::size_t held = 0;
    std::string choice;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const char* const key = keys.begin()[i];
        choice += (choice.empty() ? "\"" : i + 1 < keys.size() ? ", \"" : " or \"") + std::string(key) + "\"";
        if (value_->contains(key)) {
            chosen = i;
            ++held;
        }
        asked_.emplace_back(key);
    }
    log_->know({.pattern = pattern_, .type = "one of", .required = fallback == nullptr});
    if (held == 1)
        return chosen;
    if (held == 0 && fallback != nullptr && value_->empty())
        return static_cast<std::size_t>(
            std::find_if(keys.begin(), keys.end(), [&](const char* key) { return std::string_view(key) == fallback; }) -
            keys.begin());
    if (held == 0 && !broken_)
        reject(message("holds neither ", choice, ": give one of them."));
    else if (held > 1)
        reject(message("holds more than one of ", choice, ": keep one of them."));
    return keys.size();
}

void JsonObject::not_both(const char* one, const char* other) {
    log_->know({.pattern = pattern_, .type = "not both", .words = {one, other}});
    if (value_->contains(one) && value_->contains(other))
        reject(message("holds both \"", one, "\" and \"", other, "\": keep one of them."));
}

void JsonObject::needs(const char* key, const char* wanted, std::string_view why) {
    log_->know({.pattern = pattern_, .type = "needs", .words = {wanted, key}});
    if (value_->contains(key) && !value_->contains(wanted))
        reject(key, why);
}

const json* JsonObject::find(const Key& key, const char* type, const Range& rule) {
    return note({.type = type, .rule = rule}, key);
}

const json* JsonObject::note(KnownKey key, const Key& asked) {
    const char* const name = asked.name;
    if (std::find(asked_.begin(), asked_.end(), name) == asked_.end())
        asked_.emplace_back(name);
    const bool required = key.required;
    key.pattern = join_json_path(pattern_, name);
    key.meaning = asked.meaning;
    log_->know(std::move(key));
    const auto found = value_->find(name);
    if (found != value_->end())
        return &*found;
    if (required && !broken_)
        reject(message("has no \"", name, "\": add it."));
    return nullptr;
}

void JsonObject::finish() {
    for (const auto& [key, value] : value_->items()) {
        if (std::find(asked_.begin(), asked_.end(), key) != asked_.end())
            continue;
        if (log_->is_full()) // a suggestion takes longer than the rest of the reading
            log_->count_fault();
        else
            log_->reject(join_json_path(path_, key), unknown_key(key, asked_));
    }
}

void JsonObject::reject(std::string_view rest) {
    log_->reject(path_, rest);
}
void JsonObject::reject(const Key& key, std::string_view rest) {
    log_->reject(path_of(key), rest);
}
void JsonObject::set_kind(std::string_view kind, const char* meaning) {
    pattern_ += message("(", kind, ")");
    log_->know({.pattern = pattern_, .type = "kind", .meaning = meaning});
}
std::string JsonObject::path_of(const Key& key) const {
    return join_json_path(path_, key.name);
}

} // namespace windrow::scene
