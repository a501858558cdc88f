// A logarithmic axis: where a value lies on the page, and which values are written beside it.
#pragma once

#include <cmath>
#include <vector>

namespace windrow::cli {

struct LogAxis {
    double low = 1.0, high = 10.0; ///< values at its ends, above 0
    double from = 0.0, to = 1.0;   ///< page coordinates of the ends

    [[nodiscard]] double at(double value) const { return from + (to - from) * std::log(value / low) / std::log(high / low); }

    /// Values 1, 2, 5 (or 1 alone where there are many decades) times a power of ten, within the ends.
    [[nodiscard]] std::vector<double> ticks() const {
        const bool many = high / low > 2000.0;
        std::vector<double> values;
        for (int decade = static_cast<int>(std::floor(std::log10(low))); std::pow(10.0, decade) <= high; ++decade)
            for (const double step : {1.0, 2.0, 5.0})
                if (const double value = step * std::pow(10.0, decade);
                    value >= low * 0.9999 && value <= high * 1.0001 && (!many || step == 1.0))
                    values.push_back(value);
        return values;
    }
};

} // namespace windrow::cli
