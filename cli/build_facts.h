// What this build was made with and from.
#pragma once

#include <string>

namespace windrow::cli {

/// "g++ 12.2.0"
[[nodiscard]] std::string compiler_name();
/// The commit that was built, "-dirty" behind it where the files differed from it; "unknown" outside git.
[[nodiscard]] std::string commit_name();

} // namespace windrow::cli
