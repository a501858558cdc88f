// Several saved states in one file, each under a name.
//
//     const auto air = wind->save(), trails = ground->save(), smoke = tracer->save();
//     const auto file = windrow::join_parts({{{"wind", *air}, {"ground", *trails}, {"smoke", *smoke}}});
//
//     const auto parts = windrow::split_parts(*file);
//     const auto found = windrow::find_part(*parts, "ground");
//     auto ground = windrow::GroundMemory::load(*found);
//
// What a part holds is not looked at here: each `load` checks its own. A program may add parts of its own.
#pragma once

#include "api.h"
#include "result.h"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace windrow {

/// It refers to a name and to bytes that are elsewhere.
struct SavedPart {
    std::string_view name{};
    std::span<const std::byte> bytes{};
};

inline constexpr std::size_t k_max_parts = 4096;   ///< in a file
inline constexpr std::size_t k_max_part_name = 64; ///< letters

/// One file of all. Rejects more than k_max_parts, a name that is empty, longer than k_max_part_name or there twice, and memory that
/// is short.
[[nodiscard]] WINDROW_API Result<std::vector<std::byte>> join_parts(std::span<const SavedPart> parts);
/// The parts of a file, in their order; they refer to `file`. Rejects what join_parts did not return.
[[nodiscard]] WINDROW_API Result<std::vector<SavedPart>> split_parts(std::span<const std::byte> file);
/// The bytes of the part with this name; an error where there is none.
[[nodiscard]] WINDROW_API Result<std::span<const std::byte>> find_part(std::span<const SavedPart> parts, std::string_view name);

} // namespace windrow
