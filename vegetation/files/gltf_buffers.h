// The buffers of a glTF file: the binary chunk of a GLB, data in the text itself, files beside it.
#pragma once

#include "fluid/files/input_budget.h"
#include "vegetation/fur/mesh.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace windrow::vegetation::fur {

struct GltfParts {
    std::string_view json;   ///< views of the file's bytes
    std::string_view binary; ///< of a GLB, or empty
};

/// A GLB's two chunks, or all of the bytes as JSON.
[[nodiscard]] Result<GltfParts> split_gltf(std::string_view bytes, const std::string& name);

/// The bytes of the glTF's buffer `index`, as many as its byteLength says.
[[nodiscard]] Result<std::string> read_gltf_buffer(const nlohmann::json& buffer, std::size_t index, std::string_view binary,
                                                   const std::filesystem::path& path, windrow::detail::InputBudget& budget);

/// RFC 4648, section 4. Rejects other signs and lengths.
[[nodiscard]] Result<std::string> decode_base64(std::string_view text, const std::string& name);

} // namespace windrow::vegetation::fur
