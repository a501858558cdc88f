#include "fluid/cpu/column_factors.h"

namespace windrow::cpu {

void factor_column(double base, const std::array<EndRule, 2>& ends, std::span<double> pivot, std::span<double> vector,
                   std::array<double, 2>& factors) {
    const int rows = static_cast<int>(pivot.size());
    const bool cyclic = is_cyclic(ends, rows);
    const auto diagonal = [&](int j) {
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

} // namespace windrow::cpu
