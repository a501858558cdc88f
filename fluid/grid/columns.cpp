#include "fluid/grid/columns.h"

#include <cmath>
#include <cstddef>

namespace windrow {

ColumnRows::ColumnRows(const RowTable& rows, double cell_size) {
    for (int j = 0; j < rows.count(); ++j)
        thickness.push_back(rows.thickness(j) / cell_size);
    for (int face = 0; face <= rows.count(); ++face)
        links.push_back(cell_size / (rows.height(face) - rows.height(face - 1)));
    scales.push_back(1.0 / std::sqrt(links[1]));
    for (std::size_t j = 1; j < thickness.size(); ++j)
        scales.push_back(1.0 / (links[j] * scales[j - 1]));
}

void factor_column(double base, const std::array<EndRule, 2>& ends, const ColumnRows& law, std::span<double> pivot,
                   std::span<double> vector, std::array<double, 2>& factors) {
    const int rows = static_cast<int>(pivot.size());
    const bool cyclic = is_cyclic(ends, rows);
    const auto diagonal = [&](int j) {
        if (!law.empty()) {
            const auto row = static_cast<std::size_t>(j);
            const double low = law.links[row], high = law.links[row + 1];
            const double ends_add =
                (j == 0 ? diagonal_correction(ends[0]) * low : 0.0) + (j == rows - 1 ? diagonal_correction(ends[1]) * high : 0.0);
            return law.scales[row] * law.scales[row] * (law.thickness[row] * (base + 2.0) - low - high + ends_add);
        }
        if (rows == 1 && ends[0] == EndRule::periodic)
            return base + 2.0;
        double value = base;
        if (!cyclic) {
            value += j == 0 ? diagonal_correction(ends[0]) : 0.0;
            value += j == rows - 1 ? diagonal_correction(ends[1]) : 0.0;
        } else if (j == 0) {
            value += base; // minus gamma = -b[0]
        } else if (j == rows - 1) {
            value += 1.0 / base; // minus 1 / gamma
        }
        return value;
    };
    for (int j = 0; j < rows; ++j)
        pivot[j] = 1.0 / (diagonal(j) - (j > 0 ? pivot[j - 1] : 0.0));
    if (!cyclic)
        return;
    const double gamma = -base;
    for (int j = 0; j < rows; ++j) {
        const double d = (j == 0 ? gamma : 0.0) + (j == rows - 1 ? 1.0 : 0.0);
        vector[j] = (d - (j > 0 ? vector[j - 1] : 0.0)) * pivot[j];
    }
    for (int j = rows - 2; j >= 0; --j)
        vector[j] -= pivot[j] * vector[j + 1];
    const double scale = 1.0 / (1.0 + vector[0] + vector[rows - 1] / gamma);
    factors = {scale, scale / gamma};
}

} // namespace windrow
