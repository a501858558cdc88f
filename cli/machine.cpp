#include "cli/machine.h"

#include <algorithm>
#include <fstream>
#include <thread>

namespace windrow::cli {

int usable_cores() {
    return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

std::optional<std::uint64_t> available_memory() {
    std::ifstream table("/proc/meminfo");
    std::string name;
    std::uint64_t kilobytes = 0;
    std::string unit;
    while (table >> name >> kilobytes) {
        if (name == "MemAvailable:")
            return kilobytes * 1024;
        std::getline(table, unit);
    }
    return std::nullopt;
}

} // namespace windrow::cli
