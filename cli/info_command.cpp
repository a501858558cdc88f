#include "cli/info_command.h"

#include "cli/backend.h"
#include "fluid/core/message.h"
#include "fluid/simd.h"
#include "windrow_commit.h"   // made by commit.cmake
#include "windrow_licences.h" // made by CMakeLists.txt
#if WINDROW_WITH_VDB
#include "fluid/vdb/vdb_export.h"
#endif

#include <algorithm>
#include <fstream>
#include <string>
#include <thread>

namespace windrow::cli {

std::string version_line() {
    return WINDROW_VERSION_LINE;
}

std::string compiler_name() {
#if defined(__clang__)
    return detail::message("clang ", __clang_major__, ".", __clang_minor__, ".", __clang_patchlevel__);
#elif defined(__GNUC__)
    return detail::message("g++ ", __GNUC__, ".", __GNUC_MINOR__, ".", __GNUC_PATCHLEVEL__);
#else
    return "unknown";
#endif
}

std::string commit_name() {
    return WINDROW_COMMIT;
}

bool built_with_vdb() {
    return WINDROW_WITH_VDB != 0;
}
bool built_with_nanovdb() {
#if WINDROW_WITH_VDB
    return vdb::has_nanovdb();
#else
    return false;
#endif
}
bool built_with_images() {
    return WINDROW_WITH_IMAGES != 0;
}

int run_info(const Console& console) {
    const auto yes = [](bool has) { return has ? "yes" : "no"; };
    console.out << version_line() << "\n"
                << "  compiler    " << compiler_name() << ", " << WINDROW_BUILD_TYPE << "\n"
                << "  SIMD level  " << name_of(Simd::best) << "\n"
                << "  cores       " << usable_cores() << "\n"
                << "  OpenVDB     " << yes(built_with_vdb()) << "\n"
                << "  NanoVDB     " << yes(built_with_nanovdb()) << "\n"
                << "  pictures    " << yes(built_with_images()) << "\n";
    const char* head = "  Vulkan      ";
    for (const std::string& line : vulkan_lines()) {
        console.out << head << line << "\n";
        head = "              ";
    }
    console.out << "  licences    windrow info --licences\n";
    return k_exit_well;
}

int print_licences(const Console& console) {
    console.out << k_windrow_licences;
    return k_exit_well;
}

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
