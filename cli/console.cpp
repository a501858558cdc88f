#include "cli/console.h"

namespace windrow::cli {

void Console::complain(std::string_view sentences) const {
    out.flush();
    while (!sentences.empty()) {
        const std::size_t end = sentences.find('\n');
        err << "windrow: " << sentences.substr(0, end) << '\n';
        sentences.remove_prefix(end == sentences.npos ? sentences.size() : end + 1);
    }
    err.flush();
}

void Console::warn(std::string_view sentence) const {
    out.flush();
    err << "windrow: warning: " << sentence << '\n';
    err.flush();
}

} // namespace windrow::cli
