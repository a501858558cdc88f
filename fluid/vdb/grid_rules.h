// Rejections of the export: all reasons, a line each.
#pragma once

#include "fluid/vdb/vdb_export.h"

#include <filesystem>
#include <string>

namespace windrow::vdb {

/// Without '/' and control characters.
[[nodiscard]] bool is_plain_name(const std::string& name);
[[nodiscard]] Result<void> check(const VelocityGrid& grid, const std::filesystem::path& file, const Options& options);

} // namespace windrow::vdb
