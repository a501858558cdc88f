#include "fluid/setting.h"
#include "tests/stability/story.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cxxabi.h>
#include <memory>
#include <ostream>
#include <typeinfo>

namespace windrow::test {
namespace {

// Digits enough that a compiler reads the same bits.
std::string literal(double value, int digits, const char* suffix, const char* type) {
    if (std::isnan(value))
        return std::string("std::numeric_limits<") + type + ">::quiet_NaN()";
    if (std::isinf(value))
        return std::string(value < 0.0 ? "-" : "") + "std::numeric_limits<" + type + ">::infinity()";
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    std::string number = text;
    if (number.find_first_of(".e") == std::string::npos)
        number += ".0";
    return number + suffix;
}

template <class Type>
std::string name_of() {
    int status = 0;
    const std::unique_ptr<char, void (*)(void*)> name(abi::__cxa_demangle(typeid(Type).name(), nullptr, nullptr, &status),
                                                      std::free);
    const std::string whole = name.get();
    return whole.substr(whole.rfind(':') + 1);
}

std::string text(float value) {
    return literal(static_cast<double>(value), 9, "f", "float");
}
std::string text(double value) {
    return literal(value, 17, "", "double");
}
std::string text(int value) {
    return std::to_string(value);
}
std::string text(std::uint32_t value) {
    return std::to_string(value) + 'u';
}
std::string text(bool value) {
    return value ? "true" : "false";
}
std::string text(const std::shared_ptr<const HeightMap>&) {
    return "{}"; // stories have no maps
}
template <class Number>
std::string text(const glm::vec<3, Number>& v) {
    return '{' + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + '}';
}
template <class... Kinds>
std::string text(const std::variant<Kinds...>& value);
template <class Value>
std::string text(const std::optional<Value>& value);
template <class Value>
requires std::is_enum_v<Value> std::string text(Value value) {
    return name_of<Value>() + "::" + k_words<Value>.at(static_cast<std::size_t>(value));
}
std::string text(const std::vector<float>& values) {
    std::string list;
    for (const float value : values)
        list += (list.empty() ? "" : ", ") + text(value);
    return '{' + list + '}';
}
std::string text(const story::StartAir& start) {
    constexpr const char* k_names[] = {"ambient", "white", "smooth", "shear"};
    return std::string("{story::StartAir::Pattern::") + k_names[static_cast<int>(start.kind)] + ", " + text(start.speed) + ", " +
           text(start.seed) + ", " + text(start.projected) + '}';
}
/// {.first = 1.0f, .second = {...}} of the settings that are not the default.
template <HasSettings Struct>
std::string text(const Struct& value) {
    std::string list;
    const Struct standard{};
    for_each_setting(value, [&]<class Row>(const Row& row, const auto& member) {
        if constexpr (Row::k_stored == Stored::everywhere)
            if (const std::string here = text(member); here != text(standard.*row.member))
                list += (list.empty() ? "." : ", .") + std::string(row.name) + " = " + here;
    });
    return '{' + list + '}';
}
template <class... Kinds>
std::string text(const std::variant<Kinds...>& value) {
    return std::visit([](const auto& kind) { return name_of<std::remove_cvref_t<decltype(kind)>>() + text(kind); }, value);
}
template <class Value>
std::string text(const std::optional<Value>& value) {
    return value ? (HasSettings<Value> ? name_of<Value>() : "glm::bvec3") + text(*value) : "{}";
}

struct EventText {
    std::string operator()(const story::Steps& e) const { return "Steps{" + text(e.count) + ", " + text(e.dt) + '}'; }
    std::string operator()(const story::Advances& e) const { return "Advances{" + text(e.count) + ", " + text(e.dt) + '}'; }
    std::string operator()(const story::Add& e) const { return "Add{" + text(e.motor) + '}'; }
    std::string operator()(const story::Replace& e) const { return "Replace{" + text(e.which) + ", " + text(e.motor) + '}'; }
    std::string operator()(const story::Move& e) const { return "Move{" + text(e.which) + ", " + text(e.position) + '}'; }
    std::string operator()(const story::Remove& e) const { return "Remove{" + text(e.which) + '}'; }
    std::string operator()(const story::Follow& e) const { return "Follow{" + text(e.point) + '}'; }
    std::string operator()(const story::Floor& e) const { return "Floor{" + text(e.height) + '}'; }
    std::string operator()(const story::ChangeSides& e) const { return "ChangeSides{Boundaries" + text(e.boundaries) + '}'; }
    std::string operator()(const story::ChangeAmbient& e) const { return "ChangeAmbient{" + text(e.ambient) + '}'; }
    std::string operator()(const story::ChangeGusts& e) const { return "ChangeGusts{Gusts" + text(e.gusts) + '}'; }
    std::string operator()(const story::Break& e) const { return "Break{" + text(e.cell) + ", " + text(e.value) + '}'; }
    std::string operator()(const story::SaveAndLoad&) const { return "SaveAndLoad{}"; }
    std::string operator()(const story::Reset&) const { return "Reset{}"; }
};

} // namespace

std::string text_of(const Story& story) {
    std::string whole = "story_of(" + text(story.config) + ",\n         " + text(story.start) + ",\n         {";
    for (std::size_t n = 0; n < story.events.size(); ++n)
        whole += (n > 0 ? ",\n          story::" : "story::") + std::visit(EventText{}, story.events[n]);
    return whole + "})";
}

void showValue(const Story& story, std::ostream& stream) {
    stream << '\n' << text_of(story);
}

} // namespace windrow::test
