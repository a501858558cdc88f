// What the machine has.
#pragma once

#include "cli/console.h"
#include "fluid/thread_pool.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace windrow::cli {

/// Cores that this process may use, at least 1.
[[nodiscard]] int usable_cores();
/// Memory that can be had without swapping; nothing where the system does not tell. [bytes]
[[nodiscard]] std::optional<std::uint64_t> available_memory();

/// A pool of `threads`, 0 for one a core. Warns where the system gives fewer.
[[nodiscard]] std::unique_ptr<ThreadPool> make_pool(int threads, const Console& console);

/// The processor's model and the cores that this process may use: "AMD EPYC, 2 cores". Some systems tell no model: "unknown CPU".
[[nodiscard]] std::string device_name();

} // namespace windrow::cli
