// What shells in the wind cost a frame: the scenes of the shell fur thesis, layers, orders, shadows, lamps, clouds, wind.
//
//     windrow_fur_bench [--quick] [--frames N] [--pictures FOLDER]
//                          [--only scenes|layers|order|shadow|lamps|body|clouds|wind_at|plane|wind]
//
// On a GPU 1920 x 1080 and 1000 frames a row after 100 to warm up; on a software device, or with --quick, 128 x 128 and 3 frames
// after 1. Rows of one table take turns, frame by frame: what else the machine does slows them alike, and ratios hold. Times are
// of the device's clock (Vulkan timestamps). Counters are of a frame of its own after the timed ones, around the coats' draws
// alone.
// --pictures writes a PNG of each row's counted frame into a folder that is there. Results: docs/fur_cost.md.
#include "fluid/vulkan/own_device.h"
#include "vegetation/bench/fur_tables.h"

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string_view>

namespace {

using windrow::vegetation::bench::FurRun;

constexpr struct {
    std::string_view name;
    void (*measure)(const FurRun&);
} k_tables[] = {{"scenes", windrow::vegetation::bench::scenes_table}, {"layers", windrow::vegetation::bench::layers_table},
                {"order", windrow::vegetation::bench::order_table},   {"shadow", windrow::vegetation::bench::shadow_table},
                {"lamps", windrow::vegetation::bench::lamps_table},   {"body", windrow::vegetation::bench::body_table},
                {"clouds", windrow::vegetation::bench::clouds_table}, {"wind_at", windrow::vegetation::bench::wind_at_table},
                {"plane", windrow::vegetation::bench::plane_table},   {"wind", windrow::vegetation::bench::wind_table}};

[[noreturn]] void reject(const std::string& why) {
    std::fprintf(stderr,
                 "windrow_fur_bench: %s\nwindrow_fur_bench [--quick] [--frames N] [--pictures FOLDER] [--only TABLE], where "
                 "TABLE is one of",
                 why.c_str());
    for (const auto& table : k_tables)
        std::fprintf(stderr, " %.*s", static_cast<int>(table.name.size()), table.name.data());
    std::fprintf(stderr, "\n");
    std::exit(2);
}

struct BenchRequest {
    bool quick = false;
    int frames = 0; ///< 0: the device's own
    std::string only{}, pictures{};
};

BenchRequest wanted_of(std::span<char*> arguments) {
    BenchRequest made;
    for (std::size_t n = 1; n < arguments.size(); ++n) {
        const std::string flag = arguments[n];
        if (flag == "--quick") {
            made.quick = true;
            continue;
        }
        if (flag != "--frames" && flag != "--only" && flag != "--pictures")
            reject("there is no flag " + flag + ".");
        if (++n == arguments.size())
            reject(flag + " wants a value.");
        const std::string value = arguments[n];
        if (flag == "--frames") {
            const auto read = std::from_chars(value.data(), value.data() + value.size(), made.frames);
            if (read.ec != std::errc() || read.ptr != value.data() + value.size() || made.frames < 1 || made.frames > 100000)
                reject("--frames is " + value + "; give 1 to 100000.");
        } else if (flag == "--only") {
            made.only = value;
            bool known = false;
            for (const auto& table : k_tables)
                known = known || table.name == value;
            if (!known)
                reject("--only is " + value + ", which is no table.");
        } else {
            made.pictures = value;
            if (std::error_code none; !std::filesystem::is_directory(value, none))
                reject("--pictures is " + value + "; give a folder that is there.");
        }
    }
    return made;
}

FurRun run_of(const BenchRequest& wanted) {
    const auto devices = windrow::vulkan::list_devices();
    if (!devices) {
        std::fprintf(stderr, "windrow_fur_bench: %s\n", devices.error().c_str());
        std::exit(3);
    }
    // As the engine chooses: a GPU before software.
    const windrow::vulkan::DeviceFacts* chosen = &devices->front();
    for (const auto& device : *devices)
        if (chosen->software && !device.software)
            chosen = &device;
    FurRun run;
    run.device = chosen->name + ", " + chosen->driver;
    run.pictures = wanted.pictures;
    if (wanted.quick || chosen->software) {
        run.size = {128, 128};
        run.warm = 1;
        run.frames = 3;
    }
    if (wanted.frames > 0)
        run.frames = wanted.frames;
    return run;
}

} // namespace

int main(int count, char** arguments) {
    std::setvbuf(stdout, nullptr, _IOLBF, 1 << 12); // rows as they come, into a file too
    const BenchRequest wanted = wanted_of({arguments, static_cast<std::size_t>(count)});
    const FurRun run = run_of(wanted);
    for (const auto& table : k_tables)
        if (wanted.only.empty() || wanted.only == table.name)
            table.measure(run);
}
