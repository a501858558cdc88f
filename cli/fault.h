// What ends a command early: a sentence, and whether the machine is to blame, which chooses the exit code.
#pragma once

#include "cli/console.h"
#include "cli/exit_code.h"

#include <string>

namespace windrow::cli {

struct Fault {
    std::string sentence; ///< empty: no fault
    bool machine = false; ///< it lacks something: a full disk, no driver; else what was asked for is wrong

    [[nodiscard]] explicit operator bool() const { return !sentence.empty(); }
};

/// Tells the fault; its exit code.
[[nodiscard]] inline int complain_of(const Fault& fault, const Console& console) {
    console.complain(fault.sentence);
    return fault.machine ? k_exit_machine : k_exit_wrong_use;
}

} // namespace windrow::cli
