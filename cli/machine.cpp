#include "cli/machine.h"

#include "fluid/message.h"

#include <algorithm>
#include <fstream>
#include <string>
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

std::string device_name() {
    std::ifstream table("/proc/cpuinfo");
    std::string model = "unknown CPU";
    for (std::string line; std::getline(table, line);) {
        const std::size_t colon = line.find(": ");
        if (!line.starts_with("model name") || colon == std::string::npos || colon + 2 >= line.size())
            continue;
        model = line.substr(colon + 2);
        break;
    }
    const int cores = usable_cores();
    return detail::message(model, ", ", cores, cores == 1 ? " core" : " cores");
}

std::unique_ptr<ThreadPool> make_pool(int threads, const Console& console) {
    const int wanted = threads > 0 ? threads : usable_cores();
    auto pool = std::make_unique<ThreadPool>(wanted);
    if (pool->size() < wanted)
        console.warn(detail::message("the system gives ", pool->size(), " of ", wanted,
                                     " threads: raise its limit on processes (ulimit -u), or give --threads ", pool->size(),
                                     "."));
    return pool;
}

} // namespace windrow::cli
