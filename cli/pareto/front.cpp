#include "cli/pareto/front.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace windrow::cli {
namespace {

bool finite(const CostError& point) {
    return std::isfinite(point.cost) && std::isfinite(point.error);
}

} // namespace

bool beats(const CostError& a, const CostError& b) {
    if (!finite(a) || !finite(b))
        return finite(a);
    return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
}

std::vector<std::size_t> front_of(std::span<const CostError> points) {
    std::vector<std::size_t> order;
    for (std::size_t n = 0; n < points.size(); ++n)
        if (finite(points[n]))
            order.push_back(n);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(points[a].cost, points[a].error) < std::pair(points[b].cost, points[b].error);
    });
    std::vector<std::size_t> front;
    double least = std::numeric_limits<double>::infinity(); // error of all that is cheaper
    for (std::size_t n = 0; n < order.size();) {
        // Of one cost, the best and its equals.
        const double best = points[order[n]].error, cost = points[order[n]].cost;
        for (; n < order.size() && points[order[n]].cost == cost; ++n)
            if (best < least && points[order[n]].error == best)
                front.push_back(order[n]);
        least = std::min(least, best);
    }
    return front;
}

std::optional<std::size_t> beaten_by(std::span<const CostError> points, std::size_t point) {
    std::optional<std::size_t> found;
    for (std::size_t n = 0; n < points.size(); ++n) {
        if (!beats(points[n], points[point]))
            continue;
        if (!found || std::pair(points[n].error, points[n].cost) < std::pair(points[*found].error, points[*found].cost))
            found = n;
    }
    return found;
}

} // namespace windrow::cli
