// JsonObject readers of several numbers: vectors, pairs, flags of the axes.
#include "fluid/core/validation.h"
#include "scene/json_document.h"
#include "scene/json_object.h"

#include <algorithm>
#include <cmath>

namespace windrow::scene {
namespace {

using detail::message;
using nlohmann::json;

json to_json(glm::dvec3 vector) {
    return json::array({vector.x, vector.y, vector.z});
}

} // namespace

std::optional<glm::dvec3> JsonObject::check_vector(const json& value, const std::string& path, const Range& rule, ReadLog& log) {
    if (!value.is_array() || value.size() != 3) {
        log.reject(path, message("is ", quote_json(value), ": give three numbers, [x, y, z]."));
        return std::nullopt;
    }
    Range each = rule;
    if (rule.measure == Measure::length)
        each.min = -rule.max;
    glm::dvec3 vector{0.0};
    bool good = true;
    for (int axis = 0; axis < 3; ++axis) {
        const auto number = check_number(value[static_cast<std::size_t>(axis)], message(path, "[", axis, "]"), each, log);
        good = good && number.has_value();
        vector[axis] = number.value_or(0.0);
    }
    if (good && rule.measure != Measure::component && !detail::holds(rule, vector)) {
        log.reject(path, message("is ", value.dump(), ": give ", detail::VectorBounds{rule}, "."));
        good = false;
    }
    return good ? std::optional(vector) : std::nullopt;
}

glm::dvec3 JsonObject::vector(const Key& key, glm::dvec3 fallback, const Range& rule) {
    const json* const value = note({.type = "vector", .fallback = to_json(fallback), .rule = rule}, key);
    return value == nullptr ? fallback : check_vector(*value, path_of(key), rule, *log_).value_or(fallback);
}

std::optional<glm::dvec3> JsonObject::optional_vector(const Key& key, const Range& rule) {
    const json* const value = note({.type = "vector", .rule = rule}, key);
    return value == nullptr ? std::nullopt : check_vector(*value, path_of(key), rule, *log_);
}

glm::ivec3 JsonObject::integers(const Key& key, glm::ivec3 fallback, const Range& rule) {
    const json* const value =
        note({.type = "integers", .fallback = json::array({fallback.x, fallback.y, fallback.z}), .rule = rule}, key);
    const auto numbers = value == nullptr ? std::nullopt : check_vector(*value, path_of(key), rule, *log_);
    if (!numbers)
        return fallback;
    for (int axis = 0; axis < 3; ++axis)
        if ((*numbers)[axis] != std::floor((*numbers)[axis])) {
            log_->reject(message(path_of(key), "[", axis, "]"),
                         message("is ", detail::Figure{(*numbers)[axis]}, ": give a whole number."));
            return fallback;
        }
    return glm::ivec3(*numbers);
}

std::optional<glm::dvec2> JsonObject::check_pair(const Key& key, const json* value, const Range& rule, const char* names) {
    if (value == nullptr)
        return std::nullopt;
    if (!value->is_array() || value->size() != 2) {
        reject(key, message("is ", quote_json(*value), ": give two numbers, [", names, "]."));
        return std::nullopt;
    }
    const auto first = check_number((*value)[0], path_of(key) + "[0]", rule, *log_);
    const auto second = check_number((*value)[1], path_of(key) + "[1]", rule, *log_);
    return first && second ? std::optional(glm::dvec2(*first, *second)) : std::nullopt;
}

glm::dvec2 JsonObject::pair(const Key& key, glm::dvec2 fallback, const Range& rule, const char* names) {
    const json* const value = note({.type = "pair", .fallback = json::array({fallback.x, fallback.y}), .rule = rule}, key);
    return check_pair(key, value, rule, names).value_or(fallback);
}

glm::ivec2 JsonObject::whole_pair(const Key& key, glm::ivec2 fallback, const Range& rule, const char* names) {
    const json* const value = note({.type = "whole pair", .fallback = json::array({fallback.x, fallback.y}), .rule = rule}, key);
    const auto numbers = check_pair(key, value, rule, names);
    if (!numbers)
        return fallback;
    for (int n = 0; n < 2; ++n)
        if ((*numbers)[n] != std::floor((*numbers)[n])) {
            log_->reject(message(path_of(key), "[", n, "]"),
                         message("is ", detail::Figure{(*numbers)[n]}, ": give a whole number."));
            return fallback;
        }
    return glm::ivec2(*numbers);
}

std::optional<glm::bvec3> JsonObject::optional_flags(const Key& key) {
    const json* const value = note({.type = "flags"}, key);
    if (value == nullptr)
        return std::nullopt;
    if (!value->is_array() || value->size() != 3 ||
        !std::all_of(value->begin(), value->end(), [](const json& flag) { return flag.is_boolean(); })) {
        reject(key, message("is ", quote_json(*value), ": give true or false for each axis, [x, y, z]."));
        return std::nullopt;
    }
    return glm::bvec3((*value)[0].get<bool>(), (*value)[1].get<bool>(), (*value)[2].get<bool>());
}

std::vector<float> JsonObject::numbers(const Key& key, const Range& rule) {
    constexpr std::size_t k_most = 4096;
    const std::span<const json> items = array(key, k_most, "numbers", rule);
    std::vector<float> values;
    for (std::size_t n = 0; n < items.size(); ++n)
        values.push_back(
            static_cast<float>(check_number(items[n], message(path_of(key), "[", n, "]"), rule, log()).value_or(0.0)));
    return values;
}

} // namespace windrow::scene
