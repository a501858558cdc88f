#include "scene/json_object.h"

#include "fluid/message.h"
#include "scene/json_document.h"
#include "scene/nearest_word.h"
#include "scene/number_text.h"

#include <algorithm>
#include <cmath>

namespace windrow::scene {
namespace {

using detail::message;
using nlohmann::json;

std::string with_unit(double number, const char* unit) {
    return message(figure(number), *unit == '\0' ? "" : " ", unit);
}

/// "give a number above 0, at most 1000 m"
std::string describe(const NumberRule& rule) {
    const bool low = std::isfinite(rule.least);
    const bool high = std::isfinite(rule.most);
    if (low && rule.above_least && high)
        return message("give a number above ", figure(rule.least), ", at most ", with_unit(rule.most, rule.unit));
    if (low && rule.above_least)
        return message("give a number above ", with_unit(rule.least, rule.unit));
    if (low && high)
        return message("give ", figure(rule.least), " to ", with_unit(rule.most, rule.unit));
    if (low)
        return message("give at least ", with_unit(rule.least, rule.unit));
    return high ? message("give at most ", with_unit(rule.most, rule.unit)) : std::string("give a number");
}

} // namespace

JsonObject::JsonObject(const json& value, std::string path, std::string pattern, ReadLog& log)
    : value_(&value), path_(std::move(path)), pattern_(std::move(pattern)), log_(&log) {
    if (!value.is_object()) {
        static const json k_empty = json::object();
        log.refuse(path_, message("is ", quote_json(value), ": give an object, {...}."));
        value_ = &k_empty;
        broken_ = true;
    }
}

// --- Values ----------------------------------------------------------------------------------------------------------

std::optional<double> JsonObject::check_number(const json& value, const std::string& path, const NumberRule& rule, ReadLog& log) {
    if (!value.is_number()) {
        log.refuse(path, message("is ", quote_json(value), ": give a number."));
        return std::nullopt;
    }
    const auto number = value.get<double>();
    const bool low = rule.above_least ? number > rule.least : number >= rule.least;
    if (!low || number > rule.most || !std::isfinite(number)) {
        log.refuse(path, message("is ", with_unit(number, rule.unit), ": ", describe(rule), "."));
        return std::nullopt;
    }
    return number;
}

double JsonObject::number(const char* key, double fallback, const NumberRule& rule) {
    const json* const value = note({.type = "number", .fallback = fallback, .rule = rule}, key);
    return value == nullptr ? fallback : check_number(*value, path_of(key), rule, *log_).value_or(fallback);
}

std::optional<double> JsonObject::optional_number(const char* key, const NumberRule& rule) {
    const json* const value = note({.type = "number", .rule = rule}, key);
    return value == nullptr ? std::nullopt : check_number(*value, path_of(key), rule, *log_);
}

double JsonObject::required_number(const char* key, const NumberRule& rule) {
    const json* const value = note({.type = "number", .required = true, .rule = rule}, key);
    return value == nullptr ? rule.least : check_number(*value, path_of(key), rule, *log_).value_or(rule.least);
}

float JsonObject::real(const char* key, float fallback, const NumberRule& rule) {
    const json* const value = note({.type = "number", .fallback = fallback, .rule = rule}, key);
    if (value == nullptr)
        return fallback;
    const auto number = check_number(*value, path_of(key), rule, *log_);
    return number ? static_cast<float>(*number) : fallback;
}

std::int64_t JsonObject::whole(const char* key, std::int64_t fallback, const NumberRule& rule) {
    const json* const value = note({.type = "integer", .fallback = fallback, .rule = rule}, key);
    if (value == nullptr)
        return fallback;
    const auto number = check_number(*value, path_of(key), rule, *log_);
    if (number && *number != std::floor(*number)) {
        refuse(key, message("is ", figure(*number), ": give a whole number."));
        return fallback;
    }
    return number ? static_cast<std::int64_t>(*number) : fallback;
}

int JsonObject::integer(const char* key, int fallback, const NumberRule& rule) {
    return static_cast<int>(whole(key, fallback, rule));
}

bool JsonObject::boolean(const char* key, bool fallback) {
    const json* const value = note({.type = "boolean", .fallback = fallback}, key);
    if (value == nullptr || value->is_boolean())
        return value == nullptr ? fallback : value->get<bool>();
    refuse(key, message("is ", quote_json(*value), ": give true or false."));
    return fallback;
}

std::string JsonObject::text(const char* key, const std::string& fallback) {
    const json* const value = note({.type = "string", .fallback = fallback}, key);
    if (value == nullptr || value->is_string())
        return value == nullptr ? fallback : value->get<std::string>();
    refuse(key, message("is ", quote_json(*value), ": give a text in double quotes."));
    return fallback;
}

std::size_t JsonObject::word_index(const char* key, const std::string& fallback, std::vector<std::string> words) {
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
    refuse(key, message("is ", quote_json(*value), ": give ", words.size() > 1 ? "one of " : "", choice, "."));
    return words.size();
}

std::optional<std::size_t> JsonObject::name(const char* key, std::span<const std::string> names, const char* what,
                                            bool required) {
    const json* const value = note({.type = "name", .required = required}, key);
    if (value == nullptr)
        return std::nullopt;
    if (!value->is_string()) {
        refuse(key, message("is ", quote_json(*value), ": give a name out of $.", what, " in double quotes."));
        return std::nullopt;
    }
    const auto& word = value->get_ref<const std::string&>();
    if (const auto found = std::find(names.begin(), names.end(), word); found != names.end())
        return static_cast<std::size_t>(found - names.begin());
    if (log_->is_full())
        log_->count_fault();
    else
        refuse(key, message("is ", quote_json(*value), ", which names none of $.", what, suggestion(word, names),
                            ": add it there or name another."));
    return std::nullopt;
}

// --- What holds more -------------------------------------------------------------------------------------------------

JsonObject JsonObject::object(const char* key) {
    static const json k_empty = json::object();
    const json* const value = note({.type = "object"}, key);
    JsonObject child(value == nullptr ? k_empty : *value, path_of(key), join_json_path(pattern_, key), *log_);
    child.broken_ = child.broken_ || broken_;
    return child;
}

std::span<const json> JsonObject::array(const char* key, std::size_t most) {
    const json* const value = note({.type = "array"}, key);
    if (value == nullptr)
        return {};
    if (!value->is_array()) {
        refuse(key, message("is ", quote_json(*value), ": give a list, [...]."));
        return {};
    }
    if (value->size() > most) {
        refuse(key, message("holds ", value->size(), " items: give at most ", most, "."));
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
    if (held == 1)
        return chosen;
    if (held == 0 && fallback != nullptr && value_->empty())
        return static_cast<std::size_t>(
            std::find_if(keys.begin(), keys.end(), [&](const char* key) { return std::string_view(key) == fallback; }) -
            keys.begin());
    if (held == 0 && !broken_)
        refuse(message("holds neither ", choice, ": give one of them."));
    else if (held > 1)
        refuse(message("holds more than one of ", choice, ": keep one of them."));
    return keys.size();
}

const json* JsonObject::find(const char* key, const char* type) {
    return note({.type = type}, key);
}

const json* JsonObject::note(KnownKey key, const char* name) {
    if (std::find(asked_.begin(), asked_.end(), name) == asked_.end())
        asked_.emplace_back(name);
    const bool required = key.required;
    key.pattern = join_json_path(pattern_, name);
    log_->know(std::move(key));
    const auto found = value_->find(name);
    if (found != value_->end())
        return &*found;
    if (required && !broken_)
        refuse(message("has no \"", name, "\": add it."));
    return nullptr;
}

void JsonObject::finish() {
    for (const auto& [key, value] : value_->items()) {
        if (std::find(asked_.begin(), asked_.end(), key) != asked_.end())
            continue;
        if (log_->is_full()) // a suggestion takes longer than the rest of the reading
            log_->count_fault();
        else
            log_->refuse(join_json_path(path_, key),
                         message("is not a known key", suggestion(key, asked_), ": rename or remove it."));
    }
}

void JsonObject::refuse(std::string_view rest) {
    log_->refuse(path_, rest);
}
void JsonObject::refuse(const char* key, std::string_view rest) {
    log_->refuse(path_of(key), rest);
}
void JsonObject::set_kind(std::string_view kind) {
    pattern_ += message("(", kind, ")");
}
std::string JsonObject::path_of(const char* key) const {
    return join_json_path(path_, key);
}

} // namespace windrow::scene
