// libFuzzer's mutator for parsers of JSON, and for GLB, whose first chunk is JSON.
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/json_mutator.h"

#include <algorithm>
#include <cstring>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace windrow::fuzz {
namespace {

using nlohmann::json;

/// JSON and what follows it: nothing, or the chunks behind a GLB's first.
struct Document {
    json value{json::value_t::discarded};
    std::string rest;
    bool binary = false;
};

constexpr std::size_t k_glb_head = 20; ///< "glTF", version, length; length and kind of the first chunk

Document document_of(std::string_view bytes) {
    if (!bytes.starts_with("glTF"))
        return {parse_shallow(bytes), {}, false};
    std::uint32_t length = 0;
    if (bytes.size() < k_glb_head)
        return {};
    std::memcpy(&length, bytes.data() + 12, sizeof length); // little-endian, as the machine
    if (length > bytes.size() - k_glb_head)
        return {};
    return {parse_shallow(bytes.substr(k_glb_head, length)), std::string(bytes.substr(k_glb_head + length)), true};
}

/// The bytes again, a GLB with the lengths that it has now.
std::string bytes_of(const Document& document) {
    std::string text = document.value.dump(-1, ' ', false, json::error_handler_t::replace);
    if (!document.binary)
        return text;
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const auto word = [](std::size_t value) {
        char bytes[4];
        const auto small = static_cast<std::uint32_t>(value);
        std::memcpy(bytes, &small, sizeof small);
        return std::string(bytes, sizeof bytes);
    };
    return "glTF" + word(2) + word(k_glb_head + text.size() + document.rest.size()) + word(text.size()) + "JSON" + text +
           document.rest;
}

/// Writes the document over the input; 0 where it does not fit.
std::size_t put(const Document& document, std::uint8_t* data, std::size_t most) {
    const std::string bytes = bytes_of(document);
    if (bytes.size() > most)
        return 0;
    std::memcpy(data, bytes.data(), bytes.size());
    return bytes.size();
}

std::string_view view(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

JsonMutator& mutator() {
    static JsonMutator made;
    return made;
}

} // namespace
} // namespace windrow::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    using namespace windrow::fuzz;
    if (seed % 32 == 0) // the syntax itself
        return LLVMFuzzerMutate(data, size, most);
    const std::string_view accepted = accepted_input(seed / 64);
    const std::string_view base = seed / 32 % 2 == 0 && !accepted.empty() ? accepted : view(data, size);
    Document document = document_of(base);
    if (document.value.is_discarded())
        return LLVMFuzzerMutate(data, size, most);
    if (seed % 8 == 1)
        mutator().learn(document.value);
    if (seed % 256 == 3)
        mutator().learn(known_keys(base));
    if (document.binary && !document.rest.empty() && seed % 8 == 2) {
        // Bytes of the binary chunk, which keeps its length.
        auto* const rest = reinterpret_cast<std::uint8_t*>(document.rest.data());
        const std::size_t begin = std::min<std::size_t>(8, document.rest.size() - 1);
        (void)LLVMFuzzerMutate(rest + begin, document.rest.size() - begin, document.rest.size() - begin);
    } else {
        mutator().mutate(document.value, seed);
    }
    const std::size_t written = put(document, data, most);
    return written > 0 ? written : LLVMFuzzerMutate(data, size, most);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* one, std::size_t one_size, const std::uint8_t* two,
                                                 std::size_t two_size, std::uint8_t* out, std::size_t most, unsigned seed) {
    using namespace windrow::fuzz;
    Document document = document_of(view(one, one_size));
    const Document other = document_of(view(two, two_size));
    if (document.value.is_discarded() || other.value.is_discarded())
        return 0;
    mutator().cross(document.value, other.value, seed);
    return put(document, out, most);
}
