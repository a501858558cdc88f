#include "cli/flags.h"

#include "scene/number_text.h"

#include <string_view>
#include <utility>
#include <vector>

namespace windrow::cli {
namespace {

void read_value(const std::string& name, const std::string& text, const Flags::Read& read) {
    if (text.starts_with("--"))
        reject(name, " has no value: ", text, " is a flag; write ./", text, " for a file of that name.");
    read(text);
}

void read_simd(const std::string& text, Simd& simd) {
    constexpr std::pair<const char*, Simd> k_levels[] = {
        {"best", Simd::best}, {"baseline", Simd::baseline}, {"avx2", Simd::avx2}, {"avx512", Simd::avx512}};
    for (const auto& [name, level] : k_levels) {
        if (text != name)
            continue;
        if (!runs(level))
            reject("--simd is ", name, ", which this machine does not run: give best or baseline.");
        simd = level;
        return;
    }
    reject("--simd is ", shown(text), ": give best, baseline, avx2 or avx512.");
}

} // namespace

std::int64_t read_count(const std::string& text, const std::string& flag, std::int64_t most) {
    const auto number = scene::parse_whole_number(text);
    if (!number || *number < 1 || *number > most)
        reject(flag, " is ", shown(text), ": give a whole number from 1 to ", most, ".");
    return *number;
}

CLI::Option* Flags::value(const std::string& name, const char* type, const std::string& help, Read read) {
    return command_
        .add_option_function<std::string>(
            name, [name, read = std::move(read)](const std::string& text) { read_value(name, text, read); }, help)
        ->type_name(type);
}

void Flags::values(const std::string& name, const char* type, const std::string& help, Read read) {
    command_
        .add_option_function<std::vector<std::string>>(
            name,
            [name, read = std::move(read)](const std::vector<std::string>& texts) {
                for (const std::string& text : texts)
                    read_value(name, text, read);
            },
            help)
        ->expected(1) // each time; what follows is not its
        ->take_all()
        ->type_name(type);
}

void Flags::threads(int& threads, const std::string& help) {
    value("--threads", "N", help,
          [&threads](const std::string& text) { threads = static_cast<int>(read_count(text, "--threads", k_max_threads)); });
}

void Flags::simd(Simd& simd, const std::string& help) {
    value("--simd", "LEVEL", "Instructions: best, baseline, avx2 or avx512; " + help,
          [&simd](const std::string& text) { read_simd(text, simd); });
}

void Flags::seconds(double& seconds, const std::string& help) {
    value("--seconds", "S", help, [&seconds](const std::string& text) {
        const auto number = scene::parse_number(text);
        if (!number || !(*number > 0.0 && *number <= k_max_seconds))
            reject("--seconds is ", shown(text), ": give a number above 0, at most ", scene::figure(k_max_seconds), " s.");
        seconds = *number;
    });
}

void Flags::file(const std::string& name, std::optional<std::filesystem::path>& file, const std::string& help) {
    value(name, "FILE", help, [name, &file](const std::string& text) {
        if (text.empty())
            reject(name, " is empty: name a file.");
        file = text;
    });
}

void Flags::folder(const std::string& name, std::optional<std::filesystem::path>& folder, const std::string& help) {
    value(name, "DIR", help, [name, &folder](const std::string& text) {
        if (text.empty())
            reject(name, " is empty: name a folder.");
        folder = text;
    });
}

void Flags::scene(std::filesystem::path& file) {
    value("SCENE.json", "", "Scene file; its keys are in docs/scenes.md", [&file](const std::string& text) {
        if (text.empty())
            reject("SCENE.json is empty: name a scene file.");
        file = text;
    })->required();
}

void Flags::backend(BackendRequest& backend) {
    using cases::BackendKind;
    value("--backend", "B", "What runs the air: cpu, the default, or vulkan", [&backend](const std::string& text) {
        if (text != name_of(BackendKind::cpu) && text != name_of(BackendKind::vulkan))
            reject("--backend is ", shown(text), ": give cpu or vulkan.");
        backend.kind = text == name_of(BackendKind::cpu) ? BackendKind::cpu : BackendKind::vulkan;
    });
    device(backend.device);
}

void Flags::part(scene::Part& part, const std::string& what) {
    value("--part", "K/N", "Part K of N of the " + what + ", for several processes or machines; --join puts the parts together",
          [&part](const std::string& text) {
              const auto read = scene::parse_part(text);
              if (!read)
                  reject(read.error());
              part = *read;
          });
}

void Flags::device(int& device) {
    value("--device", "N", "Vulkan device by its number in windrow info; default the first GPU",
          [&device](const std::string& text) {
              constexpr std::int64_t k_max_devices = 64;
              const auto place = scene::parse_whole_number(text);
              if (!place || *place < 0 || *place >= k_max_devices)
                  reject("--device is ", shown(text), ": give a device's number in windrow info, from 0.");
              device = static_cast<int>(*place);
          });
}

void check_backend(const CLI::App& command, const BackendRequest& backend) {
    if (backend.kind == cases::BackendKind::vulkan && WINDROW_WITH_VULKAN == 0)
        reject("--backend is vulkan, which is not built in: build with WINDROW_VULKAN=ON, or give cpu.");
    if (backend.kind == cases::BackendKind::cpu && command.count("--device") > 0)
        reject("--device is given, but the air runs on the CPU: add --backend vulkan, or drop it.");
}

} // namespace windrow::cli
