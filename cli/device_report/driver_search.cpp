#include "cli/device_report/report_section.h"
#include "gpu/loader.h"

#include <algorithm>
#include <cstdlib>

namespace windrow::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* k_variables[] = {"VK_DRIVER_FILES", "VK_ICD_FILENAMES", "VK_ADD_DRIVER_FILES"};
// Of the loader, on Linux; those of the user's home and of XDG_DATA_DIRS are its own too.
constexpr const char* k_folders[] = {"/etc/vulkan/icd.d", "/usr/share/vulkan/icd.d", "/usr/local/share/vulkan/icd.d"};
// Of containers with NVIDIA's tools, of NixOS, of Flatpak and of BSD's ports.
constexpr const char* k_more_folders[] = {"/usr/local/nvidia/share/vulkan/icd.d", "/run/opengl-driver/share/vulkan/icd.d",
                                          "/usr/lib/x86_64-linux-gnu/GL/vulkan/icd.d", "/usr/local/etc/vulkan/icd.d"};

std::vector<std::string> files_in(const char* folder) {
    std::vector<std::string> files;
    std::error_code fault;
    for (const fs::directory_entry& file : fs::directory_iterator(folder, fault))
        if (file.path().extension() == ".json")
            files.push_back(file.path().string());
    std::sort(files.begin(), files.end());
    return files;
}

std::string joined(const std::vector<std::string>& words, char separator) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? std::string() : std::string(1, separator)) + word;
    return text;
}

std::string more_drivers() {
    std::vector<std::string> all;
    for (const char* const folder : k_more_folders)
        for (std::string& file : files_in(folder))
            all.push_back(std::move(file));
    return joined(all, ':');
}

bool names_drivers() {
    return std::any_of(std::begin(k_variables), std::end(k_variables),
                       [](const char* name) { return std::getenv(name) != nullptr; });
}

} // namespace

void add_drivers() {
    if (const std::string files = more_drivers(); !names_drivers() && !files.empty())
        ::setenv("VK_ADD_DRIVER_FILES", files.c_str(), 1);
}

bool name_drivers_only() {
    const std::string files = more_drivers();
    if (files.empty() || std::getenv("VK_DRIVER_FILES") != nullptr || std::getenv("VK_ICD_FILENAMES") != nullptr)
        return false;
    ::setenv("VK_ICD_FILENAMES", files.c_str(), 1); // the name that loaders of any age read
    return true;
}

ReportJson places_tried() {
    ReportJson places = ReportJson::array();
    for (const char* const name : vulkan::Loader::names())
        places.push_back({{"place", name}, {"is", "a name of the loader"}, {"holds", ""}});
    for (const char* const name : k_variables) {
        const char* const value = std::getenv(name);
        places.push_back({{"place", name}, {"is", "a variable that names drivers"}, {"holds", value == nullptr ? "" : value}});
    }
    const auto add = [&](const char* folder, const char* what) {
        places.push_back({{"place", folder}, {"is", what}, {"holds", joined(files_in(folder), ' ')}});
    };
    for (const char* const folder : k_folders)
        add(folder, "a folder of drivers");
    for (const char* const folder : k_more_folders)
        add(folder, "a folder of drivers that loaders do not search");
    return places;
}

} // namespace windrow::cli
