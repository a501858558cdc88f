// What the sanitizers need to live with Mesa's software driver and Vulkan's validation layer. Part of each program that may
// load them, so that it holds however the program is run, by CTest or by hand. Empty in a build without one.
// The runtime of a sanitizer looks these up in the program.
#pragma GCC visibility push(default)

#if defined(__SANITIZE_ADDRESS__) // GCC
#define WINDROW_ASAN 1
#elif defined(__SANITIZE_THREAD__)
#define WINDROW_TSAN 1
#elif defined(__has_feature) // Clang
#if __has_feature(thread_sanitizer)
#define WINDROW_TSAN 1
#endif
#if __has_feature(address_sanitizer)
#define WINDROW_ASAN 1
#endif
#endif

#ifdef WINDROW_ASAN
#include <dlfcn.h>
#include <initializer_list>

// The driver allocates and frees a block for each group that it runs; the default quarantine keeps them all, up to 24 GB.
extern "C" const char* __asan_default_options() {
    return "quarantine_size_mb=4:thread_local_quarantine_size_kb=16";
}

// The validation layer (1.3.239) leaks its own notes of a device, a few thousand bytes, and the driver (Mesa 22.3.6) what it
// compiled for a compute shader that samples images. What of ours is not destroyed, the layer tells, and the counts of
// faults_test.cpp.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libVkLayer_khronos_validation.so\nleak:libvulkan_lvp.so\nleak:libLLVM-15.so\n";
}

// Quiet: a child process's output is compared with what it should print.
extern "C" const char* __lsan_default_options() {
    return "print_suppressions=0";
}

namespace {

// The driver holds some bytes for good in its own globals. They count as leaked once the loader has unloaded it, and no
// suppression can name a module that is gone, the layer neither: so both stay, where they are installed.
[[maybe_unused]] const bool modules_stay = [] {
    for (const char* module : {"libvulkan_lvp.so", "libVkLayer_khronos_validation.so"})
        (void)dlopen(module, RTLD_LAZY | RTLD_NODELETE);
    return true;
}();

} // namespace
#endif

#ifdef WINDROW_TSAN
// The driver (Mesa 22.3.6) and the validation layer (1.3.239) have threads of their own, were not built with the sanitizer, and
// end what these share without telling it. A report is left out where a stack of it goes through one of them: of ours that is
// what the layer's messages call, and no more.
extern "C" const char* __tsan_default_suppressions() {
    return "race:libvulkan_lvp.so\nmutex:libvulkan_lvp.so\nrace:libVkLayer_khronos_validation.so\n"
           "mutex:libVkLayer_khronos_validation.so\n";
}
#endif
