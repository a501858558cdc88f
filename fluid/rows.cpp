#include "fluid/rows.h"

#include "fluid/core/message.h"
#include "fluid/core/validation.h"
#include "fluid/portable_math.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace windrow {
namespace {

constexpr double k_steepest = 2.0;   // of two distances side by side, of a list
constexpr double k_most_ratio = 1.5; // of the law
constexpr double k_most_scales = 1e9;

// Rows -1 to `count`. A distance between rows is `first` below the first row that is not uniform, then grows.
std::vector<double> heights_of(const Rows& rows, int count, double ratio) {
    const double first = static_cast<double>(rows.first);
    std::vector<double> heights{-0.5 * first, 0.5 * first};
    for (int row = 1; row <= count; ++row)
        heights.push_back(heights.back() +
                          first * numerics::power(ratio, static_cast<unsigned>(std::max(row - rows.uniform, 0))));
    return heights;
}

double top_of(const std::vector<double>& heights) {
    return 0.5 * (heights[heights.size() - 2] + heights.back());
}

// The ratio for a top, by bisection: the top grows with it.
double ratio_for(const Rows& rows, int count) {
    double low = 1.0, high = k_most_ratio;
    for (int n = 0; n < 60; ++n) {
        const double middle = 0.5 * (low + high);
        (top_of(heights_of(rows, count, middle)) < static_cast<double>(rows.top) ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace

Result<void> validate(const Rows& rows) {
    return detail::validate_settings(rows, "rows");
}

void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const Rows& rows) {
    const detail::FieldPath list{&path, "heights"};
    const std::vector<float>& heights = rows.heights;
    double before = 0.0, distance = heights.empty() ? 0.0 : 2.0 * static_cast<double>(heights[0]);
    for (std::size_t n = 0; n < heights.size(); ++n) {
        const double here = static_cast<double>(heights[n]), apart = here - before;
        if (!Range::above(0.0, 1e6).holds(heights[n])) // reported by its range
            return;
        if (!(apart > 0.0))
            return reasons.add(list, " has ", heights[n], " m at place ", n + 1, " above ", before,
                               " m: give rising heights above 0.");
        if (n > 0) {
            if (!(apart <= k_steepest * distance && distance <= k_steepest * apart))
                return reasons.add(list, " has distances of ", distance, " and ", apart, " m around place ", n,
                                   ": give distances of at most twice the one beside.");
            distance = apart;
        }
        before = here;
    }
    if (heights.empty() || rows.top == 0.0f)
        return;
    const double above = 2.0 * (static_cast<double>(rows.top) - before);
    if (!(above <= k_steepest * distance && distance <= k_steepest * above))
        reasons.add(detail::FieldPath{&path, "top"}, " is ", rows.top, " m above a last height of ", before,
                    " m: give half a distance between rows more than that.");
}

Result<std::shared_ptr<const RowTable>> RowTable::create(const Rows& rows, int count, float cell_size) {
    if (auto valid = validate(rows); !valid)
        return valid.failure();
    if (count < 2)
        return Error{detail::message("rows are given for a box of ", count, " row: give 2 rows or more, or no rows.")};
    if (count > k_max_rows)
        return Error{detail::message("rows are given for a box of ", count, " rows: give at most ", k_max_rows, ", or no rows.")};
    std::vector<double> heights;
    if (!rows.heights.empty()) {
        if (rows.heights.size() != static_cast<std::size_t>(count))
            return Error{
                detail::message("rows.heights has ", rows.heights.size(), " heights for ", count, " rows: give one a row.")};
        heights.assign(rows.heights.begin(), rows.heights.end());
        const double last = heights.back(), apart = last - heights[heights.size() - 2];
        heights.push_back(rows.top > 0.0f ? 2.0 * static_cast<double>(rows.top) - last : last + apart);
        heights.insert(heights.begin(), -heights.front());
    } else if (rows.top > 0.0f) {
        const double least = top_of(heights_of(rows, count, 1.0)), most = top_of(heights_of(rows, count, k_most_ratio));
        const double top = static_cast<double>(rows.top);
        if (!(top >= least * (1.0 - 1e-6) && top <= most * (1.0 + 1e-6)))
            return Error{detail::message("rows.top is ", rows.top, " m, but ", count, " rows reach from ", least, " to ", most,
                                         " m: give a top between these, or other rows.")};
        heights = heights_of(rows, count, ratio_for(rows, count));
    } else {
        heights = heights_of(rows, count, static_cast<double>(rows.ratio));
    }
    if (!(heights.back() < 1e9))
        return Error{detail::message("rows reach ", heights.back(), " m: give a lower ratio.")};
    // Unknowns of the column solve are scaled row by row (ColumnRows). Distances that alternate make the scales of every other row
    // grow without bound, up to what floats cannot hold.
    double least = 1.0, most = 1.0, scale = 1.0, before = 1.0;
    for (std::size_t row = 2; row + 1 < heights.size(); ++row) {
        const double next = before * (heights[row + 1] - heights[row]) / (heights[row] - heights[row - 1]);
        before = scale;
        scale = next;
        least = std::min(least, scale);
        most = std::max(most, scale);
    }
    if (!(most <= k_most_scales * least))
        return Error{detail::message("rows.heights have distances that grow and shrink by turns, up to a factor of ",
                                     most / least, " in all: give distances that grow upward.")};
    return std::shared_ptr<const RowTable>(new RowTable(std::move(heights), cell_size));
}

RowTable::RowTable(std::vector<double> heights, float cell_size) : heights_(std::move(heights)) {
    const double h = static_cast<double>(cell_size);
    double finest = thickness(0), coarsest = finest;
    for (int row = 0; row < count(); ++row) {
        scales_.push_back(static_cast<float>(h / thickness(row)));
        centres_.push_back(static_cast<float>(height(row)));
        finest = std::min(finest, thickness(row));
        coarsest = std::max(coarsest, thickness(row));
    }
    for (int face = 0; face <= count(); ++face) {
        const double apart = height(face) - height(face - 1);
        links_.push_back(static_cast<float>(h / apart));
        finest = std::min(finest, apart);
        coarsest = std::max(coarsest, apart);
    }
    finest_ = static_cast<float>(finest);
    coarsest_ = static_cast<float>(coarsest);
}

double RowTable::height(int row) const {
    const int rows = count();
    if (row < -1)
        return -height(-1 - row);
    if (row > rows)
        return heights_.back() + (row - rows) * (heights_.back() - heights_[heights_.size() - 2]);
    return heights_[static_cast<std::size_t>(row + 1)];
}

double RowTable::place(double height) const {
    const auto above = std::upper_bound(heights_.begin() + 1, heights_.end() - 1, height);
    const auto below = above - 1;
    return static_cast<double>(below - heights_.begin()) - 0.5 + (height - *below) / (*above - *below);
}

double RowTable::place_before(int row, double rise) const {
    const double then = height(row) + rise;
    return then > 0.0 && then < top() ? place(then) : std::numeric_limits<double>::quiet_NaN();
}

double RowTable::height_at(double place) const {
    const double from = std::floor(std::clamp(place - 0.5, -1.0, static_cast<double>(count() - 1)));
    const int row = static_cast<int>(from);
    return height(row) + (place - 0.5 - from) * (height(row + 1) - height(row));
}

} // namespace windrow
