#include "vegetation/files/gltf_buffers.h"

#include "fluid/core/message.h"
#include "vegetation/files/mesh_file.h"
#include "vegetation/files/mesh_folder.h"

#include <cstring>

namespace windrow::vegetation::fur {
namespace {

using windrow::detail::message;

std::uint32_t word(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;)
        value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

// %20 and the like; a broken one stays as it is.
std::string without_percents(std::string_view uri) {
    const auto digit = [](char c) { return std::string_view("0123456789abcdef").find(static_cast<char>(c | 0x20)); };
    std::string name;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) < 16 && digit(uri[i + 2]) < 16) {
            name += static_cast<char>(16 * digit(uri[i + 1]) + digit(uri[i + 2]));
            i += 2;
        } else {
            name += uri[i];
        }
    }
    return name;
}

Result<std::string> bytes_of(const nlohmann::json& buffer, const std::string& place, std::string_view binary,
                             const std::filesystem::path& path, windrow::detail::InputBudget& budget) {
    const auto uri = buffer.find("uri");
    if (uri == buffer.end())
        return std::string(binary);
    if (!uri->is_string())
        return windrow::Error{message(place, ".uri is not a string: name a file or give data.")};
    const std::string text = uri->get<std::string>();
    if (!text.starts_with("data:"))
        return read_beside(path, without_percents(text), budget);
    constexpr std::string_view k_mark = ";base64,";
    const std::size_t mark = text.find(k_mark);
    if (mark == std::string::npos)
        return windrow::Error{message(place, ".uri has data of another kind than base64: give base64.")};
    return decode_base64(std::string_view(text).substr(mark + k_mark.size()), place + ".uri");
}

} // namespace

Result<GltfParts> split_gltf(std::string_view bytes, const std::string& name) {
    if (!bytes.starts_with("glTF"))
        return GltfParts{bytes, {}};
    constexpr std::uint32_t k_json = 0x4e4f534a, k_binary = 0x004e4942;
    constexpr std::size_t k_header = 12, k_head = 8;
    if (bytes.size() < k_header + k_head || word(bytes, 4) != 2 || word(bytes, 8) != bytes.size())
        return windrow::Error{message(name, " is not a GLB 2, or has another length than its header: give a complete GLB 2.")};
    GltfParts parts;
    for (std::size_t at = k_header; at < bytes.size();) {
        if (bytes.size() - at < k_head || word(bytes, at) > bytes.size() - at - k_head)
            return windrow::Error{
                message(name, " has a chunk at byte ", at, " that is longer than the file: give a complete GLB.")};
        const std::string_view content = bytes.substr(at + k_head, word(bytes, at));
        if (at == k_header && word(bytes, at + 4) == k_json)
            parts.json = content;
        else if (parts.binary.empty() && word(bytes, at + 4) == k_binary)
            parts.binary = content;
        at += k_head + content.size();
    }
    return parts;
}

Result<std::string> read_gltf_buffer(const nlohmann::json& buffer, std::size_t index, std::string_view binary,
                                     const std::filesystem::path& path, windrow::detail::InputBudget& budget) {
    const std::string place = message(path.string(), ": $.buffers[", index, "]");
    if (!buffer.is_object())
        return windrow::Error{message(place, " is not an object: give one.")};
    const auto length = buffer.find("byteLength");
    if (length == buffer.end() || !length->is_number_unsigned() || length->get<std::uint64_t>() > k_max_bytes)
        return windrow::Error{message(place, ".byteLength is missing or not a count: give 1 to ", k_max_bytes, ".")};
    const std::size_t size = length->get<std::size_t>();
    auto bytes = bytes_of(buffer, place, index == 0 ? binary : std::string_view(), path, budget);
    if (!bytes)
        return bytes;
    if (bytes->size() < size)
        return windrow::Error{message(place, " has ", bytes->size(), " bytes, and says ", size, ": give them all.")};
    bytes->resize(size);
    return bytes;
}

Result<std::string> decode_base64(std::string_view text, const std::string& name) {
    constexpr std::string_view k_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    while (text.ends_with('='))
        text.remove_suffix(1);
    if (text.size() % 4 == 1)
        return windrow::Error{message(name, " is truncated base64: give all of it.")};
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int held = 0;
    for (const char sign : text) {
        const std::size_t digit = k_digits.find(sign);
        if (digit == std::string_view::npos)
            return windrow::Error{message(name, " has a character that is not base64: give base64.")};
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        if ((held += 6) >= 8)
            bytes += static_cast<char>(bits >> (held -= 8) & 0xff);
    }
    return bytes;
}

} // namespace windrow::vegetation::fur
