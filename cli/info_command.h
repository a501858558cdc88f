// What this build and this machine can do; `windrow info` prints it for a bug report.
#pragma once

#include "cli/console.h"
#include "fluid/thread_pool.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace windrow::cli {

/// "windrow 0.1.0"
[[nodiscard]] std::string version_line();
/// "g++ 12.2.0"
[[nodiscard]] std::string compiler_name();
/// The commit that was built, "-dirty" behind it where the files differed from it; "unknown" outside git.
[[nodiscard]] std::string commit_name();
/// Whether the command was built with these parts (CMake options WINDROW_VDB and WINDROW_IMAGES).
[[nodiscard]] bool built_with_vdb();
[[nodiscard]] bool built_with_nanovdb();
[[nodiscard]] bool built_with_images();

/// Prints all of it and the machine's devices. Returns the exit code.
int run_info(const Console& console);
/// Prints LICENSE and NOTICE.
int print_licences(const Console& console);

/// Cores that this process may use, at least 1.
[[nodiscard]] int usable_cores();
/// Memory that can be had without swapping; nothing where the system does not tell. [bytes]
[[nodiscard]] std::optional<std::uint64_t> available_memory();

/// A pool of `threads`, 0 for one a core. Warns where the system gives fewer.
[[nodiscard]] std::unique_ptr<ThreadPool> make_pool(int threads, const Console& console);

/// The processor's model and the cores that this process may use: "AMD EPYC, 2 cores". Some systems tell no model: "unknown CPU".
[[nodiscard]] std::string device_name();

} // namespace windrow::cli
