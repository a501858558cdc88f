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

/// Where no wind comes to be inside it, an outer wind keeps no pressure, as before.
struct OuterUndo {
    explicit OuterUndo(const Wind* outer)
        : cells(outer != nullptr && !outer->state().cells.keeps_pressure() ? &outer->state().cells : nullptr) {}
    OuterUndo(const OuterUndo&) = delete;
    OuterUndo& operator=(const OuterUndo&) = delete;
    ~OuterUndo() {
        if (cells != nullptr)
            cells->drop_pressure();
    }

    cpu::Cells* cells;
};

} // namespace windrow
