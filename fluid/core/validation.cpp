#include "fluid/core/validation.h"

#include "fluid/box.h"
#include "fluid/canopy.h"
#include "fluid/roughness.h"

namespace windrow::detail {

void append(std::string& text, const FieldPath& path) {
    if (path.owner != nullptr) {
        append(text, *path.owner);
        if (path.owner->owner != nullptr || !path.owner->name.empty())
            text += path.name.empty() || path.name.front() == '[' ? "" : ".";
    }
    text += path.name;
}

void append(std::string& text, const Unit& unit) {
    if (!unit.name.empty())
        text += ' ';
    text += unit.name;
}

void append(std::string& text, const Figure& figure) {
    const double value = figure.value;
    if (value == std::trunc(value) && std::abs(value) < 1e6)
        return append(text, static_cast<long>(value));
    std::size_t digit = text.size();
    append(text, value);
    // The standard's exponent has a sign and two digits at least.
    digit = text.find('e', digit);
    if (digit == text.npos)
        return;
    ++digit;
    if (text[digit] == '+')
        text.erase(digit, 1);
    else if (text[digit] == '-')
        ++digit;
    if (text[digit] == '0' && digit + 1 < text.size())
        text.erase(digit, 1);
}

void append(std::string& text, const Bounds& bounds) {
    const Range& range = bounds.range;
    const bool low = std::isfinite(range.min), high = std::isfinite(range.max), open = low && range.above_min;
    if (open)
        text += "a number above ";
    else if (low && !high)
        text += "at least ";
    else if (!low)
        text += high ? "at most " : "a number";
    if (low)
        append(text, Figure{range.min});
    if (range.min == 0.0 && *range.zero != '\0')
        append_each(text, " (", range.zero, ")");
    if (low && high)
        text += open ? ", at most " : " to ";
    if (high)
        append(text, Figure{range.max});
    append(text, Unit{range.unit});
}

void append(std::string& text, const VectorBounds& bounds) {
    if (bounds.range.measure == Measure::direction)
        text += "a finite vector that is not 0";
    else
        append_each(text, bounds.range.measure == Measure::length ? "a length of " : "each component ", Bounds{bounds.range});
}

void append(std::string& text, const Choice& choice) {
    for (std::size_t n = 0; n < choice.words.size(); ++n)
        append_each(text, n == 0 ? "" : n + 1 < choice.words.size() ? ", " : " or ", choice.words[n]);
}

} // namespace windrow::detail

namespace windrow {

Result<void> validate(const Box& box) {
    return detail::validate_settings(box);
}

void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const Box& box) {
    if (detail::holds(Box::k_cells_range, box.cells) && box.cell_count() > k_max_cells)
        reasons.add(detail::FieldPath{&path, "cells"}, " is ", box.cells, ", ", box.cell_count(), " in all: give at most ",
                    k_max_cells, ".");
    if (!box.rows)
        return;
    if (box.rows->count() != box.cells.y)
        reasons.add(detail::FieldPath{&path, "rows"}, " are ", box.rows->count(), " for ", box.cells.y,
                    " cells along y: give RowTable::create the number of cells.");
    if (box.boundaries.periodic(1))
        reasons.add(detail::FieldPath{&path, "rows"},
                    " cannot repeat: give boundaries along y that are not periodic, or no rows.");
}

Result<void> validate(const Canopy& canopy) {
    return detail::validate_settings(canopy, "canopy");
}

Result<void> validate(const Roughness& roughness) {
    return detail::validate_settings(roughness, "roughness");
}

void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const RoughnessMap& map) {
    if (map.lengths == nullptr)
        reasons.add(path, " has no lengths: give some that HeightMap::create made.");
    else if (!map.lengths->data().holes.open.empty())
        reasons.add(path, ".lengths has holes, which lengths have not: give a map without.");
}

} // namespace windrow
