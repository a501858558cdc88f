// Content of a file (core/bytes.h): u32 number of parts; of each u32 letters of its name, u64 bytes, the name, the bytes.
#include "fluid/saved_parts.h"

#include "fluid/core/bytes.h"

#include <algorithm>

namespace windrow {
namespace {

using detail::message;

constexpr detail::Format k_parts_format{"WINDPART", 1, "file of saved parts", "join_parts"};
constexpr std::size_t k_parts_count_bytes = 4, k_part_head_bytes = 12;

Result<void> check(std::span<const SavedPart> parts) {
    if (parts.size() > k_max_parts)
        return Error{message("there are ", parts.size(), " parts: give at most ", k_max_parts, ".")};
    std::vector<std::string_view> names;
    names.reserve(parts.size());
    for (const SavedPart& part : parts) {
        if (part.name.empty() || part.name.size() > k_max_part_name)
            return Error{message("a part's name has ", part.name.size(), " letters: give 1 to ", k_max_part_name, ".")};
        names.push_back(part.name);
    }
    std::sort(names.begin(), names.end());
    if (const auto twice = std::adjacent_find(names.begin(), names.end()); twice != names.end())
        return Error{message("two parts have the name \"", *twice, "\": give each its own.")};
    return {};
}

} // namespace

Result<std::vector<std::byte>> join_parts(std::span<const SavedPart> parts) {
    return detail::where_memory_lasts([&]() -> Result<std::vector<std::byte>> {
        if (auto valid = check(parts); !valid)
            return valid.failure();
        std::size_t size = k_parts_count_bytes;
        for (const SavedPart& part : parts)
            size += k_part_head_bytes + part.name.size() + part.bytes.size();
        std::vector<std::byte> file = detail::begin_bytes(size);
        const auto number = [&](auto value) {
            file.resize(file.size() + sizeof value);
            detail::store_number(&file[file.size() - sizeof value], value);
        };
        number(static_cast<std::uint32_t>(parts.size()));
        for (const SavedPart& part : parts) {
            number(static_cast<std::uint32_t>(part.name.size()));
            number(static_cast<std::uint64_t>(part.bytes.size()));
            const auto name = std::as_bytes(std::span(part.name));
            file.insert(file.end(), name.begin(), name.end());
            file.insert(file.end(), part.bytes.begin(), part.bytes.end());
        }
        detail::seal(file, k_parts_format);
        return file;
    });
}

Result<std::vector<SavedPart>> split_parts(std::span<const std::byte> file) {
    return detail::where_memory_lasts([&]() -> Result<std::vector<SavedPart>> {
        const auto content = detail::unseal(file, k_parts_format);
        if (!content)
            return content.failure();
        const Error damaged{message(k_parts_format.name, " cannot be used: its parts do not fill it; give what ",
                                    k_parts_format.writer, " returned.")};
        std::span<const std::byte> rest = *content;
        if (rest.size() < k_parts_count_bytes)
            return damaged;
        const auto count = detail::load_number<std::uint32_t>(rest.data());
        rest = rest.subspan(k_parts_count_bytes);
        if (count > rest.size() / k_part_head_bytes)
            return damaged;
        std::vector<SavedPart> parts;
        parts.reserve(count);
        for (std::uint32_t n = 0; n < count; ++n) {
            if (rest.size() < k_part_head_bytes)
                return damaged;
            const auto letters = detail::load_number<std::uint32_t>(rest.data());
            const auto bytes = detail::load_number<std::uint64_t>(rest.data() + 4);
            rest = rest.subspan(k_part_head_bytes);
            if (letters > rest.size() || bytes > rest.size() - letters)
                return damaged;
            parts.push_back({{reinterpret_cast<const char*>(rest.data()), letters}, rest.subspan(letters, bytes)});
            rest = rest.subspan(letters + bytes);
        }
        if (!rest.empty())
            return damaged;
        if (auto valid = check(parts); !valid)
            return valid.failure().after(message(k_parts_format.name, " cannot be used: "));
        return parts;
    });
}

Result<std::span<const std::byte>> find_part(std::span<const SavedPart> parts, std::string_view name) {
    const auto found = std::find_if(parts.begin(), parts.end(), [&](const SavedPart& part) { return part.name == name; });
    if (found == parts.end())
        return Error{message("the file has no part \"", name, "\": save it with the others.")};
    return found->bytes;
}

} // namespace windrow
