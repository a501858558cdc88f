// Largest component, broken cells and sum of squares in one read. Finite is asked of the bits: an exponent of all
// ones is infinity or NaN, whatever the arithmetic around it does.

PlaneSurvey survey(const float* velocity, std::size_t cells) {
    const CellInt exponent = {0x7f800000, 0x7f800000, 0x7f800000, 0x7f800000};
    const CellInt magnitude = {0x7fffffff, 0x7fffffff, 0x7fffffff, 0x7fffffff};
    PlaneSurvey found = {0.0f, 0, 0.0};
    Cell largest = splat(0.0f);
    constexpr std::size_t k_run = 64; // squares are summed in float over a run only, then in double
    for (std::size_t start = 0; start < cells; start += k_run) {
        const std::size_t end = start + k_run < cells ? start + k_run : cells;
        Cell squares = splat(0.0f);
        CellInt broken = {0, 0, 0, 0};
        for (std::size_t n = start; n < end; ++n) {
            const Cell value = load_cell(velocity + 4 * n);
            const CellInt bits = reinterpret_cast<CellInt>(value);
            const CellInt bad = (bits & exponent) == exponent;
            const Cell sound = reinterpret_cast<Cell>(bits & ~bad);
            const Cell size = reinterpret_cast<Cell>(reinterpret_cast<CellInt>(sound) & magnitude);
            broken |= bad;
            largest = size > largest ? size : largest;
            squares += sound * sound;
        }
        if ((broken[0] | broken[1] | broken[2] | broken[3]) != 0)
            for (std::size_t n = start; n < end; ++n) {
                const CellInt bits = reinterpret_cast<CellInt>(load_cell(velocity + 4 * n));
                const CellInt bad = (bits & exponent) == exponent;
                found.broken_cells += (bad[0] | bad[1] | bad[2] | bad[3]) != 0 ? 1 : 0;
            }
        found.squares += double(squares[0]) + double(squares[1]) + double(squares[2]) + double(squares[3]);
    }
    for (int axis = 0; axis < 4; ++axis)
        found.largest_component = largest[axis] > found.largest_component ? largest[axis] : found.largest_component;
    return found;
}
