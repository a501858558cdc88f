#include "tests/fuzz/json_mutator.h"

#include <algorithm>
#include <cmath>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace windrow::fuzz {
namespace {

using nlohmann::json;

constexpr std::size_t k_max_values = 64;
constexpr std::size_t k_longest_value = 1024;

/// libFuzzer's own changes of bytes, with its dictionary.
void change_bytes(std::string& bytes, std::size_t most) {
    const std::size_t size = bytes.size();
    bytes.resize(std::max(most, size));
    bytes.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(bytes.data()), size, bytes.size()));
}

/// The last two names of `$.motors[](wake).law.drive.per_metre`: an object's key and a member's.
std::pair<std::string, std::string> last_names(const std::string& pattern) {
    std::vector<std::string> names{""};
    bool kind = false;
    for (const char letter : pattern) {
        kind = letter == '(' || (kind && letter != ')');
        if (letter == '.' && !kind)
            names.emplace_back();
        else if (!kind && letter != ')' && letter != '[' && letter != ']')
            names.back() += letter;
    }
    const std::size_t count = names.size();
    return {count > 1 && names[count - 2] != "$" ? names[count - 2] : "", names.back()};
}

} // namespace

json parse_shallow(std::string_view text) {
    bool deep = false;
    const auto shallow = [&](int depth, json::parse_event_t, json&) {
        deep = deep || depth > 40;
        return depth <= 40;
    };
    json document = json::parse(text, shallow, false);
    return deep ? json(json::value_t::discarded) : document;
}

void JsonMutator::collect(json& value, json* parent, const std::string& key, const std::string& parent_key,
                          std::vector<Node>& nodes) {
    nodes.push_back({&value, parent, key, parent_key});
    if (value.is_object())
        for (auto& [name, member] : value.items())
            collect(member, &value, name, key, nodes);
    if (value.is_array())
        for (json& item : value)
            collect(item, &value, key, parent_key, nodes);
}

void JsonMutator::learn_member(const std::string& parent_key, const std::string& key, const json& value) {
    auto& keys = keys_[parent_key];
    if (keys.size() < k_max_values && std::find(keys.begin(), keys.end(), key) == keys.end())
        keys.push_back(key);
    auto& values = values_[key];
    if (value.dump(-1, ' ', false, json::error_handler_t::replace).size() > k_longest_value)
        return;
    if (values.size() < k_max_values)
        values.push_back(value);
    else
        values[below(k_max_values)] = value;
}

void JsonMutator::learn(const json& document) {
    std::vector<Node> nodes;
    json copy = document;
    collect(copy, nullptr, "", "", nodes);
    for (const Node& node : nodes)
        if (node.parent != nullptr && node.parent->is_object())
            learn_member(node.parent_key, node.key, *node.value);
}

void JsonMutator::learn(const std::vector<scene::KnownKey>& keys) {
    for (const scene::KnownKey& known : keys) {
        if (!known.is_value())
            continue;
        const auto [parent, key] = last_names(known.pattern);
        if (known.fallback)
            learn_member(parent, key, *known.fallback);
        for (const std::string& word : known.words)
            learn_member(parent, key, word);
        if (known.type == "number" || known.type == "integer")
            for (const double bound : {known.rule.min, known.rule.max})
                if (std::isfinite(bound))
                    learn_member(parent, key, known.type == "integer" ? json(static_cast<std::int64_t>(bound)) : json(bound));
    }
}

const json* JsonMutator::known_value(const std::string& key) {
    const auto known = values_.find(key);
    return known == values_.end() || known->second.empty() ? nullptr : &known->second[below(known->second.size())];
}

double JsonMutator::number_near(double value) {
    switch (below(5)) {
    case 0:
        return value + 1.0;
    case 1:
        return value - 1.0;
    case 2:
        return value * 0.5;
    case 3:
        return value * (1.0 + 0.01 * below(100));
    default:
        return -value;
    }
}

void JsonMutator::change_number(json& value) {
    constexpr double k_odd[] = {0.0,   -0.0, 1.0,  -1.0,  0.5,    1e-9,   1e-30,        1e9,
                                -1e12, 1e38, 4e38, 1e300, 5e-324, 65535., 4294967296.0, 9007199254740993.0};
    const bool whole = value.is_number_integer();
    const double changed = below(6) == 0 ? k_odd[below(std::size(k_odd))] : number_near(value.get<double>());
    if (whole && std::abs(changed) < 1e15 && below(16) != 0) {
        const auto rounded = static_cast<std::int64_t>(changed);
        // Unsigned where it can be: glTF asks for it.
        value = rounded < 0 ? json(rounded) : json(static_cast<std::uint64_t>(rounded));
    } else if (std::isfinite(changed)) {
        value = changed;
    }
}

void JsonMutator::change_text(Node& node) {
    auto text = node.value->get<std::string>();
    constexpr std::string_view k_mark = ";base64,";
    if (const std::size_t mark = text.find(k_mark); mark != std::string::npos && below(16) != 0) {
        // Data keep their length: buffers are held to theirs.
        constexpr std::string_view k_signs = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        const std::size_t begin = mark + k_mark.size();
        for (std::uint32_t n = 1 + below(3); n > 0 && text.size() > begin; --n)
            text[begin + below(text.size() - begin)] = k_signs[below(k_signs.size())];
    } else if (const json* const known = known_value(node.key); known != nullptr && below(3) != 0) {
        *node.value = *known;
        return;
    } else {
        change_bytes(text, text.size() + 16);
    }
    *node.value = text;
}

void JsonMutator::change_array(json& value) {
    if (value.empty()) {
        value.push_back(odd_value());
        return;
    }
    const auto at = [&] { return value.begin() + below(value.size()); };
    switch (below(4)) {
    case 0:
        value.erase(at());
        return;
    case 1:
        std::iter_swap(at(), at());
        return;
    default: {
        const json item = *at();
        if (value.size() < 64)
            value.insert(at(), item);
    }
    }
}

void JsonMutator::change_object(json& value, const std::string& key) {
    const auto known = keys_.find(key);
    if (known != keys_.end() && below(4) != 0) {
        const std::string& member = known->second[below(known->second.size())];
        if (const json* const known_member = known_value(member))
            value[member] = *known_member;
        return;
    }
    if (value.empty())
        return;
    const auto member = std::next(value.begin(), below(value.size()));
    if (below(3) != 0) {
        value.erase(member);
        return;
    }
    std::string name = member.key();
    const json moved = *member;
    value.erase(member);
    change_bytes(name, name.size() + 4);
    value[name] = moved;
}

json JsonMutator::odd_value() {
    switch (below(8)) {
    case 0:
        return nullptr;
    case 1:
        return json::array();
    case 2:
        return json::object();
    case 3:
        return "";
    case 4:
        return below(2) == 0;
    case 5:
        return json::array({0, 1, 2});
    case 6:
        return std::string(300, 'x');
    default:
        return below(100);
    }
}

void JsonMutator::mutate(json& document, std::uint32_t seed) {
    random_.seed(seed);
    std::vector<Node> nodes;
    collect(document, nullptr, "", "", nodes);
    Node& node = nodes[below(nodes.size())];
    json& value = *node.value;
    if (below(40) == 0) {
        value = odd_value();
    } else if (const json* const known = known_value(node.key);
               known != nullptr && below(8) == 0 && node.parent != nullptr && node.parent->is_object()) {
        value = *known;
    } else if (value.is_number()) {
        change_number(value);
    } else if (value.is_string()) {
        change_text(node);
    } else if (value.is_boolean()) {
        value = !value.get<bool>();
    } else if (value.is_array()) {
        change_array(value);
    } else if (value.is_object()) {
        change_object(value, node.key);
    } else {
        value = odd_value();
    }
}

void JsonMutator::cross(json& document, const json& other, std::uint32_t seed) {
    random_.seed(seed);
    json source = other;
    std::vector<Node> nodes, sources;
    collect(document, nullptr, "", "", nodes);
    collect(source, nullptr, "", "", sources);
    const Node& from = sources[below(sources.size())];
    std::erase_if(nodes, [&](const Node& node) { return node.key != from.key; });
    if (!nodes.empty())
        *nodes[below(nodes.size())].value = *from.value;
}

} // namespace windrow::fuzz
