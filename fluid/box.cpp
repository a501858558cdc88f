#include "fluid/box.h"

#include "fluid/message.h"

namespace windrow {

Result<void> validate(const Box& box) {
    detail::Reasons reasons;
    bool axes_valid = true;
    for (int axis = 0; axis < 3; ++axis)
        if (box.cells[axis] < 1 || box.cells[axis] > k_max_axis_cells) {
            reasons.add("cells is ", box.cells, ": each axis takes 1 to ", k_max_axis_cells, " cells.");
            axes_valid = false;
            break;
        }
    if (axes_valid && box.cell_count() > k_max_cells)
        reasons.add("cells is ", box.cells, ", ", box.cell_count(), " in all: a box holds at most ", k_max_cells, ".");
    if (!(box.cell_size >= 1e-6f && box.cell_size <= 1e6f))
        reasons.add("cell_size is ", box.cell_size, " m: give 1e-6 to 1e6 m.");
    if (auto sides = validate(box.sides); !sides)
        reasons.add(sides.error());
    if (!reasons.empty())
        return Error{reasons.take()};
    return {};
}

} // namespace windrow
