#include "gpu/loader.h"

#include "fluid/core/message.h"

#include <string>

#if defined(_WIN32)
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
#else
#include <dlfcn.h>
#endif

namespace windrow::vulkan {
namespace {

#if defined(_WIN32)
constexpr const char* k_names[] = {"vulkan-1.dll"};

void* open_library(const char* name) {
    return reinterpret_cast<void*>(LoadLibraryA(name));
}
void close_library(void* library) {
    FreeLibrary(static_cast<HMODULE>(library));
}
void* find_call(void* library, const char* name) {
    return reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(library), name));
}
#else
#if defined(__APPLE__)
constexpr const char* k_names[] = {"libvulkan.1.dylib", "libvulkan.dylib", "libMoltenVK.dylib"};
#else
// By the system's own search, then where a program that was linked elsewhere, or a container, does not search.
constexpr const char* k_names[] = {"libvulkan.so.1",
                                   "libvulkan.so",
                                   "/usr/lib/x86_64-linux-gnu/libvulkan.so.1",
                                   "/usr/lib64/libvulkan.so.1",
                                   "/usr/lib/libvulkan.so.1",
                                   "/usr/local/lib/libvulkan.so.1",
                                   "/run/opengl-driver/lib/libvulkan.so.1",
                                   "/usr/local/nvidia/lib64/libvulkan.so.1"};
#endif

void* open_library(const char* name) {
    return dlopen(name, RTLD_NOW | RTLD_LOCAL);
}
void close_library(void* library) {
    dlclose(library);
}
void* find_call(void* library, const char* name) {
    return dlsym(library, name);
}
#endif

} // namespace

std::span<const char* const> Loader::names() {
    return k_names;
}

Result<Loader> Loader::open() {
    std::string tried;
    for (const char* const name : k_names) {
        tried += (tried.empty() ? "" : ", ") + std::string(name);
        Loader loader;
        loader.library_ = open_library(name);
        if (loader.library_ == nullptr)
            continue;
        loader.get_instance_proc_addr_ =
            reinterpret_cast<PFN_vkGetInstanceProcAddr>(find_call(loader.library_, "vkGetInstanceProcAddr"));
        if (loader.get_instance_proc_addr_ != nullptr)
            return loader;
    }
    return Error{detail::message("no Vulkan loader (", tried, "): install it (Debian: libvulkan1), or a driver that brings it.")};
}

Loader::~Loader() {
    if (library_ != nullptr)
        close_library(library_);
}

} // namespace windrow::vulkan
