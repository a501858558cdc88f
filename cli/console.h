// Where the command speaks: results to `out`, faults and progress to `err`.
#pragma once

#include <cstdio>
#include <ostream>
#include <string_view>

namespace windrow::cli {

struct Console {
    std::ostream& out;
    std::ostream& err;
    std::FILE* progress; ///< null: no progress

    /// One fault a line of `sentences`, each begun with the command's name, so that a log of many commands tells whose it is.
    void complain(std::string_view sentences) const;
    void warn(std::string_view sentence) const;
};

} // namespace windrow::cli
