// Command lines: an argument a line. Flags are read and checked; nothing is run.
#include "cli/console.h"
#include "tests/fuzz/fuzz_target.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace windrow::fuzz {

ReadOutcome read_input(std::string_view bytes) {
    // As from a shell: an argument holds no zero byte.
    std::string text(bytes.substr(0, bytes.find('\0')));
    std::vector<const char*> arguments{"windrow"};
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        arguments.push_back(text.c_str() + at);
        text[end] = '\0';
        at = end + 1;
    }
    std::ostringstream out, err;
    const auto read = cli::read_command_line(static_cast<int>(arguments.size()), arguments.data(),
                                             {.out = out, .err = err, .progress = nullptr});
    return outcome_of(!std::holds_alternative<int>(read));
}

} // namespace windrow::fuzz
