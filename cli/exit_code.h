// What the command says to the shell.
#pragma once

namespace windrow::cli {

enum ExitCode : int {
    k_exit_well = 0,
    k_exit_out_of_bounds = 1, ///< the run worked, its result did not: a figure that is not finite, an error above its bound
    k_exit_wrong_use = 2,     ///< wrong flags, bad input, a folder that cannot be written, a part that was not built in
    k_exit_machine = 3,       ///< the machine lacks something: disk space, memory
    k_exit_signal = 128,      ///< plus the number of the signal that stopped the run, as shells count
};

} // namespace windrow::cli
