#include "cli/info_command.h"

#include "cli/exit_code.h"
#include "cli/frame_writer.h"
#include "cli/machine.h"
#include "fluid/message.h"
#include "fluid/simd.h"

namespace windrow::cli {
namespace {

std::string compiler() {
#if defined(__clang__)
    return detail::message("clang ", __clang_major__, ".", __clang_minor__, ".", __clang_patchlevel__);
#elif defined(__GNUC__)
    return detail::message("g++ ", __GNUC__, ".", __GNUC_MINOR__, ".", __GNUC_PATCHLEVEL__);
#else
    return "unknown";
#endif
}

const char* yes(bool has) {
    return has ? "yes" : "no";
}

} // namespace

std::string version_line() {
    return "windrow " WINDROW_VERSION;
}

int tell_info(const Console& console) {
    console.out << version_line() << "\n"
                << "  compiler    " << compiler() << ", " << WINDROW_BUILD_TYPE << "\n"
                << "  SIMD level  " << name_of(Simd::best) << "\n"
                << "  cores       " << usable_cores() << "\n"
                << "  OpenVDB     " << yes(built_with_vdb()) << "\n"
                << "  pictures    " << yes(built_with_images()) << "\n";
    return k_exit_well;
}

} // namespace windrow::cli
