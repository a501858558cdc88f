#include "fluid/box.h"

#include "fluid/validation.h"

namespace windrow {

Result<void> validate(const Box& box) {
    return detail::validate_settings(box);
}

void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const Box& box) {
    if (detail::holds(Box::k_cells_range, box.cells) && box.cell_count() > k_max_cells)
        reasons.add(detail::FieldPath{&path, "cells"}, " is ", box.cells, ", ", box.cell_count(), " in all: a box holds at most ",
                    k_max_cells, ".");
}

} // namespace windrow
