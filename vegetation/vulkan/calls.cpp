#include "vegetation/vulkan/calls.h"

#include "fluid/core/message.h"

#include <string>

namespace windrow::vegetation {

#define WINDROW_DEFINE(name) PFN_##name name = nullptr;
WINDROW_RENDERER_CALLS(WINDROW_DEFINE)
#undef WINDROW_DEFINE

windrow::Result<void> engine::load_calls(const vulkan::Host& host) {
    std::string missing;
    const auto fetch = [&]<class Call>(const char* name, Call& call) {
        const auto found = reinterpret_cast<Call>(host.get_instance_proc_addr(host.instance, name));
        if (found == nullptr)
            missing += (missing.empty() ? "" : ", ") + std::string(name);
        else if (call != found) // those that another thread uses stay untouched
            call = found;
    };
#define WINDROW_FETCH(name) fetch(#name, name);
    WINDROW_RENDERER_CALLS(WINDROW_FETCH)
#undef WINDROW_FETCH
    if (!missing.empty())
        return windrow::Error{windrow::detail::message("the loader of Vulkan lacks ", missing, ": update it.")};
    return {};
}

} // namespace windrow::vegetation
