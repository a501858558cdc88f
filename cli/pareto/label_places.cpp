#include "cli/pareto/label_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace windrow::cli {
namespace {

/// Offset of a label's near end from its point.
struct Offset {
    double x, y;
    Align align;
};
// A front falls to the right and has nothing beneath it: first below and to the left, nearer places before farther ones.
constexpr std::array k_offsets = {
    Offset{-12, 17, Align::right}, Offset{-14, 5, Align::right},   Offset{0, 26, Align::centre},  Offset{-20, 32, Align::right},
    Offset{12, -10, Align::left},  Offset{14, 5, Align::left},     Offset{12, 19, Align::left},   Offset{-30, 48, Align::right},
    Offset{-48, 26, Align::right}, Offset{-10, 52, Align::right},  Offset{0, 64, Align::centre},  Offset{-60, 62, Align::right},
    Offset{30, -26, Align::left},  Offset{-80, 44, Align::right},  Offset{-30, 84, Align::right}, Offset{40, 40, Align::left},
    Offset{-90, 90, Align::right}, Offset{-120, 70, Align::right}, Offset{50, -46, Align::left},
};
constexpr double k_far = 30.0;
constexpr double k_outside = 1e6;

// Here, since the canvas is built only where windrow draws pictures.
double overlap(const Rect& a, const Rect& b) {
    const double width = std::min(a.right(), b.right()) - std::max(a.x, b.x);
    const double height = std::min(a.bottom(), b.bottom()) - std::max(a.y, b.y);
    return std::max(width, 0.0) * std::max(height, 0.0);
}

} // namespace

LabelPlaces::Place LabelPlaces::find(std::string_view text, double size, glm::dvec2 point) {
    const double width = width_about(text, size);
    double least = std::numeric_limits<double>::infinity();
    Place best;
    Rect taken;
    for (std::size_t n = 0; n < k_offsets.size(); ++n) {
        const Offset& offset = k_offsets[n];
        const glm::dvec2 at = point + glm::dvec2(offset.x, offset.y);
        const double left = offset.align == Align::left     ? at.x
                            : offset.align == Align::centre ? at.x - 0.5 * width
                                                            : at.x - width;
        const Rect rect{left, at.y - 0.8 * size, width, 1.05 * size};
        double cost = 0.002 * static_cast<double>(n); // of places that are alike the nearer one
        for (const Thing& thing : things_)
            if (const double shared = overlap(rect, thing.rect); shared > 0.0)
                cost += thing.weight * std::min(1.0, shared / (0.25 * thing.rect.width * thing.rect.height + 1e-9));
        if (rect.x < room_.x || rect.right() > room_.right() || rect.y < room_.y || rect.bottom() > room_.bottom())
            cost += k_outside;
        if (cost >= least)
            continue;
        least = cost;
        taken = rect;
        const double near_x = offset.align == Align::left    ? rect.x - 2.0
                              : offset.align == Align::right ? rect.right() + 2.0
                                                             : at.x;
        best = {.at = at,
                .align = offset.align,
                .far = std::abs(offset.x) + std::abs(offset.y) > k_far,
                .near = {near_x, offset.align == Align::centre ? rect.y : at.y - 0.3 * size}};
    }
    avoid(taken.grown(2.0), 50.0);
    return best;
}

} // namespace windrow::cli
