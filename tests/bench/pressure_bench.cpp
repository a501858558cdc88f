// The direct solve on six Gaussian jets: relative residual in double, time, and time against 40 Jacobi sweeps of the same run.
//
//     windrow_pressure_bench [threads]
//
// Problem: six jets of Gaussian cross-section blow into the box, sides and top open (p = 0 at the face), floor solid; b = div u.
// Runs of the two solvers alternate; a time is the least of the runs, a ratio the median of the pairs. The error of an iteration
// is not its residual: beside it stands the error of grad p against the direct solve.
#include "fluid/pieces.h"
#include "fluid/thread_pool.h"
#include "tests/bench/reference/jacobi.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <vector>

namespace {

using windrow::Box;

struct Jet {
    glm::vec3 centre, direction; ///< centre as a share of the box
};

constexpr Jet k_jets[6] = {
    {{0.25f, 0.30f, 0.30f}, {1.0f, 0.0f, 0.0f}},   {{0.70f, 0.55f, 0.25f}, {0.0f, 0.3f, 1.0f}},
    {{0.45f, 0.75f, 0.70f}, {-0.7f, -0.5f, 0.3f}}, {{0.80f, 0.20f, 0.75f}, {-0.2f, 1.0f, 0.0f}},
    {{0.15f, 0.65f, 0.85f}, {0.5f, -0.2f, -1.0f}}, {{0.55f, 0.40f, 0.50f}, {0.6f, 0.6f, -0.4f}},
};

std::vector<glm::vec4> jets(const Box& box) {
    std::vector<glm::vec4> velocity(box.cell_count());
    const float width = 0.08f * static_cast<float>(box.cells.x);
    for (int k = 0; k < box.cells.z; ++k)
        for (int j = 0; j < box.cells.y; ++j)
            for (int i = 0; i < box.cells.x; ++i) {
                glm::vec3 sum(0.0f);
                for (const Jet& jet : k_jets) {
                    const glm::vec3 away = glm::vec3(i, j, k) + 0.5f - jet.centre * glm::vec3(box.cells);
                    sum += 10.0f * std::exp(-0.5f * glm::dot(away, away) / (width * width)) * jet.direction;
                }
                velocity[box.index(i, j, k)] = glm::vec4(sum, 0.0f);
            }
    return velocity;
}

// Value beyond a side of this problem: open sides turn the sign, the floor (y low) mirrors.
template <class At>
double laplacian(const Box& box, const At& phi, int i, int j, int k) {
    const double here = phi(i, j, k);
    const auto beyond = [&](int a, int b, int c, bool floor) {
        const bool inside = a >= 0 && a < box.cells.x && b >= 0 && b < box.cells.y && c >= 0 && c < box.cells.z;
        return inside ? static_cast<double>(phi(a, b, c)) : floor ? here : -here;
    };
    return beyond(i - 1, j, k, false) + beyond(i + 1, j, k, false) + beyond(i, j - 1, k, true) + beyond(i, j + 1, k, false) +
           beyond(i, j, k - 1, false) + beyond(i, j, k + 1, false) - 6.0 * here;
}

template <class Body>
double milliseconds(const Body& body) {
    const auto start = std::chrono::steady_clock::now();
    body();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void measure(glm::ivec3 cells, const windrow::ParallelFor& parallel_for) {
    const Box box{.cells = cells, .sides = windrow::Sides::open_over_floor()};
    auto work = windrow::Workspace::create({.box = box, .parallel_for = parallel_for});
    if (!work)
        std::exit(2);
    std::vector<float> rhs(box.cell_count());
    windrow::divergence(*work, jets(box), rhs);
    std::vector<float> phi = rhs;
    windrow::bench::Jacobi jacobi(cells);

    const int runs = std::max(12, static_cast<int>(2e8 / static_cast<double>(box.cell_count() * 60)));
    double direct = 1e30, sweeps = 1e30;
    std::vector<double> ratios;
    for (int run = 0; run < runs; ++run) {
        phi = rhs;
        const double a = milliseconds([&] { windrow::solve_poisson(*work, phi); });
        const double b = milliseconds([&] { jacobi.solve(rhs, 40, parallel_for); });
        direct = std::min(direct, a);
        sweeps = std::min(sweeps, b);
        ratios.push_back(a / b);
    }
    std::nth_element(ratios.begin(), ratios.begin() + runs / 2, ratios.end());

    double left = 0.0, whole = 0.0, jacobi_left = 0.0, gradient_error = 0.0, gradient = 0.0;
    const auto exact = [&](int i, int j, int k) { return phi[box.index(i, j, k)]; };
    const auto iterated = [&](int i, int j, int k) { return jacobi.row(j, k)[i]; };
    for (int k = 0; k < cells.z; ++k)
        for (int j = 0; j < cells.y; ++j)
            for (int i = 0; i < cells.x; ++i) {
                const double b = rhs[box.index(i, j, k)];
                left += std::pow(b - laplacian(box, exact, i, j, k), 2);
                jacobi_left += std::pow(b - laplacian(box, iterated, i, j, k), 2);
                whole += b * b;
                if (i + 1 < cells.x) {
                    const double slope = exact(i + 1, j, k) - exact(i, j, k);
                    gradient_error += std::pow(iterated(i + 1, j, k) - iterated(i, j, k) - slope, 2);
                    gradient += slope * slope;
                }
            }
    std::printf("%3dx%3dx%3d  direct: %8.3f ms  residual %.1e   40 Jacobi: %8.3f ms  residual %.2f  error of dp/dx %.2f   direct "
                "/ Jacobi: %.3f "
                "(median of %d pairs), %.3f (of least times)\n",
                cells.x, cells.y, cells.z, direct, std::sqrt(left / whole), sweeps, std::sqrt(jacobi_left / whole),
                std::sqrt(gradient_error / gradient), ratios[runs / 2], runs, direct / sweeps);
}

} // namespace

int main(int argc, char** argv) {
    const int threads = argc > 1 ? std::atoi(argv[1]) : 0;
    windrow::ThreadPool pool(threads);
    std::printf("six jets, open sides and top, solid floor; %d threads\n", pool.size());
    for (const glm::ivec3 cells : {glm::ivec3(32, 16, 32), glm::ivec3(64, 32, 64), glm::ivec3(128, 64, 128)})
        measure(cells, pool.parallel_for());
}
