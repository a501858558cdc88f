#include "cases/reference/residual.h"

#include <cmath>

namespace windrow::reference {
namespace {

template <class Visit>
void for_each_cell(const Box& box, const Visit& visit) {
    for (int k = 0; k < box.cells.z; ++k)
        for (int j = 0; j < box.cells.y; ++j)
            for (int i = 0; i < box.cells.x; ++i)
                visit(i, j, k);
}

// Beyond open sides phi is 0, the floor (y low) mirrors it.
double laplacian(const Box& box, const PressureAt& phi, int i, int j, int k) {
    const double here = phi(i, j, k);
    const auto beyond = [&](int a, int b, int c) {
        const bool inside = a >= 0 && a < box.cells.x && b >= 0 && b < box.cells.y && c >= 0 && c < box.cells.z;
        return inside ? phi(a, b, c) : b < 0 ? here : 0.0;
    };
    return beyond(i - 1, j, k) + beyond(i + 1, j, k) + beyond(i, j - 1, k) + beyond(i, j + 1, k) + beyond(i, j, k - 1) +
           beyond(i, j, k + 1) - 6.0 * here;
}

double relative(double error, double whole) {
    return whole > 0.0 ? std::sqrt(error / whole) : 0.0;
}

} // namespace

double relative_residual(const Box& box, std::span<const float> rhs, const PressureAt& phi) {
    double left = 0.0, whole = 0.0;
    for_each_cell(box, [&](int i, int j, int k) {
        const double b = rhs[box.index(i, j, k)];
        const double r = b - laplacian(box, phi, i, j, k);
        left += r * r;
        whole += b * b;
    });
    return relative(left, whole);
}

double relative_gradient_error(const Box& box, const PressureAt& phi, const PressureAt& exact) {
    double error = 0.0, whole = 0.0;
    for_each_cell(box, [&](int i, int j, int k) {
        if (i + 1 == box.cells.x)
            return;
        const double slope = exact(i + 1, j, k) - exact(i, j, k);
        const double off = phi(i + 1, j, k) - phi(i, j, k) - slope;
        error += off * off;
        whole += slope * slope;
    });
    return relative(error, whole);
}

} // namespace windrow::reference
