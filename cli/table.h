// Numbers and columns of the tables that commands print, and the curves of a plot as CSV, which tools/plots.py draws.
#pragma once

#include "cases/verify_case.h"

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace windrow::cli {

/// A number with `digits` behind the point, whatever the locale: "0.05".
[[nodiscard]] std::string to_fixed(double value, int digits);
/// With `digits` behind the point and an exponent: "4.5e-02".
[[nodiscard]] std::string to_scientific(double value, int digits);
/// With `digits` in all, as short as it can be: "0.045".
[[nodiscard]] std::string to_digits(double value, int digits);
/// "64x32x64"
[[nodiscard]] std::string grid_name(glm::ivec3 cells);

/// At the right end of a column; behind one space where it is wider than that.
[[nodiscard]] std::string right(std::string_view text, std::size_t width);
/// A field of a CSV file, in quotes where its text would end it.
[[nodiscard]] std::string csv_field(std::string_view text);

/// A line of a table: a name two spaces from the edge, then columns of one width.
struct TableFormat {
    std::size_t name_width = 20, width = 11;
    [[nodiscard]] std::string line(std::string_view name, std::span<const std::string> columns) const;
    [[nodiscard]] std::string line(std::string_view name, std::initializer_list<std::string> columns) const {
        return line(name, std::span(columns.begin(), columns.size()));
    }
};

using cases::PlotCurve;

/// A row a point: plot, panel, line, x, y. Values of six digits.
[[nodiscard]] std::string plot_csv(std::span<const PlotCurve> curves);

} // namespace windrow::cli
