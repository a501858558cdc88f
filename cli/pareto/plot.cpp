#include "cli/pareto/plot.h"

namespace windrow::cli {

double width_about(std::string_view text, double size, bool bold) {
    constexpr std::string_view k_narrow = " .,:;'|!ijlIt()/", k_wide = "mwMW%@";
    double ems = 0.0;
    for (const char letter : text) {
        if ((static_cast<unsigned char>(letter) & 0xC0) == 0x80) // within a character
            continue;
        ems += k_narrow.find(letter) != k_narrow.npos ? 0.34 : k_wide.find(letter) != k_wide.npos ? 0.93 : 0.62;
    }
    return size * ems * (bold ? 1.12 : 1.0);
}

} // namespace windrow::cli
