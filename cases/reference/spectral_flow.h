// A pseudo-spectral solver of Navier and Stokes' equations in a periodic box of 2 pi, in double: what the step is compared with.
//
//     du/dt = P(u x curl u + f) - nu k^2 u          (rotational form; P removes the gradient, pressure and |u|^2 / 2 in it)
//
// Fourier modes of a real field on nx x ny x nz points (FFTW's half space along x, the fastest axis), products in real space with
// modes beyond 2/3 of each axis removed, classic fourth-order Runge-Kutta with the viscous term in an integrating factor:
// spectral in space, order 4 in time. The solver's own points lie at (i, j, k) * 2 pi / n; cell centres are had by shifting
// phases. Based on: Canuto, Hussaini, Quarteroni & Zang 1988, "Spectral methods in fluid dynamics", chapter 7; Orszag 1971 for
// the 2/3 rule.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <fftw3.h>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <vector>

namespace windrow::reference {

class SpectralFlow {
  public:
    using Modes = std::array<std::vector<std::complex<double>>, 3>;
    /// Acceleration at a point and time.
    using Force = std::function<glm::dvec3(glm::dvec3 x, double t)>;

    SpectralFlow(glm::ivec3 points, double viscosity)
        : points_(points), viscosity_(viscosity), half_(points.x / 2 + 1), real_(count()), spectrum_(mode_count()) {
        const auto plan_size = std::array{points.z, points.y, points.x};
        forward_ = fftw_plan_dft_r2c(3, plan_size.data(), real_.data(), as_fftw(spectrum_), FFTW_ESTIMATE);
        backward_ = fftw_plan_dft_c2r(3, plan_size.data(), as_fftw(spectrum_), real_.data(), FFTW_ESTIMATE);
        for (auto& component : modes_)
            component.resize(mode_count());
    }
    ~SpectralFlow() {
        fftw_destroy_plan(forward_);
        fftw_destroy_plan(backward_);
    }
    SpectralFlow(const SpectralFlow&) = delete;
    SpectralFlow& operator=(const SpectralFlow&) = delete;

    void start(const std::function<glm::dvec3(glm::dvec3)>& velocity) {
        for (int c = 0; c < 3; ++c)
            transform([&](glm::dvec3 x) { return velocity(x)[c]; }, modes_[c]);
        project(modes_);
        time_ = 0.0;
    }
    void set_force(Force force) { force_ = std::move(force); }

    void step(double dt) {
        const auto advanced = [&](const Modes& from, double share) { // exp(-nu k^2 share dt) from
            Modes result = from;
            for_each_mode([&](std::size_t n, glm::dvec3 k, bool) {
                const double fade = std::exp(-viscosity_ * glm::dot(k, k) * share * dt);
                for (auto& component : result)
                    component[n] *= fade;
            });
            return result;
        };
        const auto sum = [](const Modes& a, double factor, const Modes& b) {
            Modes result = a;
            for (int c = 0; c < 3; ++c)
                for (std::size_t n = 0; n < a[c].size(); ++n)
                    result[c][n] += factor * b[c][n];
            return result;
        };
        const Modes k1 = rate(modes_, time_);
        const Modes k2 = rate(advanced(sum(modes_, 0.5 * dt, k1), 0.5), time_ + 0.5 * dt);
        const Modes half = advanced(modes_, 0.5);
        const Modes k3 = rate(sum(half, 0.5 * dt, k2), time_ + 0.5 * dt);
        const Modes k4 = rate(sum(advanced(half, 0.5), dt, advanced(k3, 0.5)), time_ + dt);
        Modes next = advanced(sum(modes_, dt / 6.0, k1), 1.0);
        next = sum(next, dt / 3.0, advanced(sum(k2, 1.0, k3), 0.5));
        modes_ = sum(next, dt / 6.0, k4);
        time_ += dt;
    }
    void run(double end, int steps) {
        for (int n = 0; n < steps; ++n)
            step((end - time_) / (steps - n));
    }

    /// Velocity at the points (i + 1/2, j + 1/2, k + 1/2) * 2 pi / cells, x fastest; any number of cells. The series is evaluated
    /// there exactly: a wave that the cells are too coarse for looks like a longer one on their centres, and is added to that
    /// one.
    [[nodiscard]] std::vector<glm::dvec3> at_cell_centres(glm::ivec3 cells) const {
        const std::size_t total = static_cast<std::size_t>(cells.x) * cells.y * cells.z;
        std::vector<std::complex<double>> folded(total);
        const fftw_plan plan =
            fftw_plan_dft_3d(cells.z, cells.y, cells.x, as_fftw(folded), as_fftw(folded), FFTW_BACKWARD, FFTW_ESTIMATE);
        const glm::dvec3 shift = glm::dvec3(std::numbers::pi) / glm::dvec3(cells);
        const auto place = [&](glm::ivec3 k) {
            k = (k % cells + cells) % cells;
            return (static_cast<std::size_t>(k.z) * cells.y + k.y) * cells.x + k.x;
        };
        std::vector<glm::dvec3> result(total);
        for (int c = 0; c < 3; ++c) {
            std::fill(folded.begin(), folded.end(), 0.0);
            for_each_mode([&](std::size_t n, glm::dvec3 k, bool kept) {
                if (!kept)
                    return;
                const std::complex<double> value = modes_[c][n] * std::polar(1.0, glm::dot(k, shift));
                folded[place(glm::ivec3(k))] += value;
                if (k.x > 0.0)
                    folded[place(-glm::ivec3(k))] += std::conj(value);
            });
            fftw_execute(plan);
            for (std::size_t n = 0; n < total; ++n)
                result[n][c] = folded[n].real();
        }
        fftw_destroy_plan(plan);
        return result;
    }

    /// Mean of |u|^2 / 2.
    [[nodiscard]] double energy() const {
        double sum = 0.0;
        for_each_mode([&](std::size_t n, glm::dvec3 k, bool) {
            const double twice = k.x == 0.0 ? 1.0 : 2.0; // the mirrored half; the 2/3 rule keeps nothing at k = n / 2
            for (const auto& component : modes_)
                sum += twice * std::norm(component[n]) / 2.0;
        });
        return sum;
    }

  private:
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(points_.x) * points_.y * points_.z; }
    [[nodiscard]] std::size_t mode_count() const { return static_cast<std::size_t>(half_) * points_.y * points_.z; }
    static fftw_complex* as_fftw(std::vector<std::complex<double>>& values) {
        return reinterpret_cast<fftw_complex*>(values.data());
    }

    /// visit(place, wave vector, whether the 2/3 rule keeps it)
    template <class Visit>
    void for_each_mode(Visit&& visit) const {
        std::size_t n = 0;
        const auto wave = [](int index, int size) { return index <= size / 2 ? index : index - size; };
        const auto kept = [](int wave_number, int size) { return size == 1 || 3 * std::abs(wave_number) < size; };
        for (int k = 0; k < points_.z; ++k)
            for (int j = 0; j < points_.y; ++j)
                for (int i = 0; i < half_; ++i, ++n) {
                    const int y = wave(j, points_.y), z = wave(k, points_.z);
                    visit(n, glm::dvec3(i, y, z), kept(i, points_.x) && kept(y, points_.y) && kept(z, points_.z));
                }
    }

    void forward(std::vector<std::complex<double>>& to) {
        fftw_execute(forward_);
        const double scale = 1.0 / static_cast<double>(count());
        for_each_mode([&](std::size_t n, glm::dvec3, bool kept) { to[n] = kept ? scale * spectrum_[n] : 0.0; });
    }
    template <class Value>
    void transform(Value&& value, std::vector<std::complex<double>>& to) {
        const glm::dvec3 spacing = 2.0 * std::numbers::pi / glm::dvec3(points_);
        std::size_t n = 0;
        for (int k = 0; k < points_.z; ++k)
            for (int j = 0; j < points_.y; ++j)
                for (int i = 0; i < points_.x; ++i)
                    real_[n++] = value(spacing * glm::dvec3(i, j, k));
        forward(to);
    }
    void backward(const std::vector<std::complex<double>>& from, std::vector<double>& to) {
        spectrum_ = from;
        fftw_execute(backward_); // destroys its input
        to = real_;
    }

    void project(Modes& modes) const {
        for_each_mode([&](std::size_t n, glm::dvec3 k, bool) {
            const double square = glm::dot(k, k);
            if (square == 0.0)
                return;
            const std::complex<double> along = (k.x * modes[0][n] + k.y * modes[1][n] + k.z * modes[2][n]) / square;
            for (int c = 0; c < 3; ++c)
                modes[c][n] -= k[c] * along;
        });
    }

    Modes rate(const Modes& modes, double t) {
        using namespace std::complex_literals;
        std::array<std::vector<double>, 3> u, w;
        std::vector<std::complex<double>> curl(mode_count());
        for (int c = 0; c < 3; ++c) {
            backward(modes[c], u[c]);
            const int a = (c + 1) % 3, b = (c + 2) % 3;
            for_each_mode([&](std::size_t n, glm::dvec3 k, bool) { curl[n] = 1i * (k[a] * modes[b][n] - k[b] * modes[a][n]); });
            backward(curl, w[c]);
        }
        Modes result;
        for (int c = 0; c < 3; ++c) {
            const int a = (c + 1) % 3, b = (c + 2) % 3;
            for (std::size_t n = 0; n < real_.size(); ++n)
                real_[n] = u[a][n] * w[b][n] - u[b][n] * w[a][n];
            if (force_)
                add_force(c, t);
            result[c].resize(mode_count());
            forward(result[c]);
        }
        project(result);
        return result;
    }
    void add_force(int c, double t) {
        const glm::dvec3 spacing = 2.0 * std::numbers::pi / glm::dvec3(points_);
        std::size_t n = 0;
        for (int k = 0; k < points_.z; ++k)
            for (int j = 0; j < points_.y; ++j)
                for (int i = 0; i < points_.x; ++i)
                    real_[n++] += force_(spacing * glm::dvec3(i, j, k), t)[c];
    }

    glm::ivec3 points_;
    double viscosity_;
    int half_;
    double time_ = 0.0;
    Modes modes_;
    Force force_;
    std::vector<double> real_;
    std::vector<std::complex<double>> spectrum_;
    fftw_plan forward_ = nullptr, backward_ = nullptr;
};

} // namespace windrow::reference
