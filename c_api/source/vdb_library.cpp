#include "c_api/source/vdb_library.h"

#include "c_api/base.h"
#include "fluid/core/message.h"

#include <mutex>
#include <string>
#ifdef WINDROW_C_OPENVDB
#include <dlfcn.h>
#endif

namespace windrow::c_api {

#ifdef WINDROW_C_OPENVDB
namespace {

using Entry = const VdbCalls* (*)();

std::string trouble() {
    const char* const sentence = dlerror();
    return sentence != nullptr ? sentence : "no reason is given";
}

/// Beside libwindrow itself: a host may have copied both to where the system does not search.
std::filesystem::path beside_this_library() {
    Dl_info place{};
    if (dladdr(reinterpret_cast<const void*>(&windrow_version), &place) == 0 || place.dli_fname == nullptr)
        return WINDROW_C_OPENVDB;
    return std::filesystem::path(place.dli_fname).parent_path() / WINDROW_C_OPENVDB;
}

Result<const VdbCalls*> open_library() {
    const std::filesystem::path file = beside_this_library();
    // It is never closed: OpenVDB's libraries leave threads and tables behind.
    void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr)
        return Error{detail::message("VDB files need a library of their own: ", trouble(),
                                     ": put it beside libwindrow, and install OpenVDB (Debian: libopenvdb10.0).")};
    const auto entry = reinterpret_cast<Entry>(dlsym(library, "windrow_openvdb"));
    const VdbCalls* const calls = entry != nullptr ? entry() : nullptr;
    if (calls == nullptr || calls->layout != k_vdb_layout)
        return Error{detail::message(file.string(),
                                     " is of another build than libwindrow: put the one beside it that was built with it.")};
    return calls;
}

} // namespace

Result<const VdbCalls*> vdb_calls() {
    static std::mutex mutex;
    static const VdbCalls* opened = nullptr;
    const std::scoped_lock lock(mutex);
    if (opened == nullptr) {
        auto calls = open_library();
        if (!calls)
            return calls; // a later call looks again
        opened = *calls;
    }
    return opened;
}
#else
extern "C" const VdbCalls* windrow_openvdb(void);

Result<const VdbCalls*> vdb_calls() {
    return windrow_openvdb();
}
#endif

} // namespace windrow::c_api
