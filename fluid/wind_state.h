// A Wind whose cells are on the CPU, for the files that implement it.
#pragma once

#include "fluid/core/wind_core.h"
#include "fluid/cpu/cells.h"

namespace windrow {

struct WINDROW_HIDDEN Wind::State {
    State(const Config& config, Workspace workspace, const AmbientWind& ambient, std::shared_ptr<const Wind> outer);

    WindCore core;
    cpu::Cells cells;
};

} // namespace windrow
