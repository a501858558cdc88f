#include "cli/info_command.h"

#include "cli/build_facts.h"
#include "cli/exit_code.h"
#include "cli/frame_writer.h"
#include "cli/machine.h"
#include "cli/vulkan_facts.h"
#include "fluid/simd.h"

namespace windrow::cli {
namespace {

const char* yes(bool has) {
    return has ? "yes" : "no";
}

} // namespace

std::string version_line() {
    return WINDROW_VERSION_LINE;
}

int tell_info(const Console& console) {
    console.out << version_line() << "\n"
                << "  compiler    " << compiler_name() << ", " << WINDROW_BUILD_TYPE << "\n"
                << "  SIMD level  " << name_of(Simd::best) << "\n"
                << "  cores       " << usable_cores() << "\n"
                << "  OpenVDB     " << yes(built_with_vdb()) << "\n"
                << "  pictures    " << yes(built_with_images()) << "\n";
    const char* head = "  Vulkan      ";
    for (const std::string& line : vulkan_lines()) {
        console.out << head << line << "\n";
        head = "              ";
    }
    return k_exit_well;
}

} // namespace windrow::cli
