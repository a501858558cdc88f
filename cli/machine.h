// What the machine has.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace windrow::cli {

/// Cores that this process may use, at least 1.
[[nodiscard]] int usable_cores();
/// Memory that can be had without swapping; nothing where the system does not tell. [bytes]
[[nodiscard]] std::optional<std::uint64_t> available_memory();

/// The processor's model and the cores that this process may use: "AMD EPYC, 2 cores". Some systems tell no model: "unknown CPU".
[[nodiscard]] std::string device_name();

} // namespace windrow::cli
