#include "cli/build_facts.h"

#include "fluid/message.h"
#include "windrow_commit.h" // made by commit.cmake

namespace windrow::cli {

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

} // namespace windrow::cli
