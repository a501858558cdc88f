// Advection by a uniform wind, du/dt + U . grad u = 0, where one step has a closed form.
//
// A Fourier mode of angle theta = k h per cell comes out of a shift by a cells times  sum_j w_j(a) exp(-i j theta):
//   linear   w_0 = 1 - a, w_1 = a:      size sqrt(1 - 4 a (1 - a) sin^2(theta / 2)), variance + a (1 - a) cells^2 a step
//   cubic    Lagrange's weights on -1..2: moments up to the third exact, so variance + 0; sum |w| <= 1.25 an axis
// The velocity's advect() carries a field that is not its own wind here; the scalar's advect() must agree with the same forms.
#include "cases/cubic_factor.h"
#include "figures.h"
#include "flows.h"

#include <array>
#include <complex>
#include <numbers>

namespace windrow {
namespace {

using namespace flows;
using figures::expect_at_least;
using figures::expect_at_most;

enum class CarriedForm { vector_x, vector_y, vector_z, scalar };
constexpr CarriedForm k_forms[] = {CarriedForm::vector_x, CarriedForm::vector_y, CarriedForm::vector_z, CarriedForm::scalar};

// One step of `values`, as a component of a velocity that is not the wind, or as a scalar.
std::vector<float> carry(Workspace& work, CarriedForm form, std::span<const float> values, std::span<const glm::vec4> wind,
                         float dt, Interpolation interpolation) {
    std::vector<float> result(values.size());
    if (form == CarriedForm::scalar) {
        EXPECT_TRUE(
            advect(work, ScalarTransport{.carried = values, .velocity = wind, .dt = dt, .interpolation = interpolation}, result));
        return result;
    }
    const int axis = static_cast<int>(form);
    Field carried(values.size(), glm::vec4(0.0f)), moved(values.size());
    for (std::size_t n = 0; n < values.size(); ++n)
        carried[n][axis] = values[n];
    advect(work, Transport{.carried = carried, .velocity = wind, .dt = dt, .interpolation = interpolation}, moved);
    for (std::size_t n = 0; n < values.size(); ++n)
        result[n] = moved[n][axis];
    return result;
}

Field uniform_wind(const Box& box, glm::vec3 wind) {
    return Field(box.cell_count(), glm::vec4(wind, 0.0f));
}

// sum_j w_j(a) exp(-i j theta) after whole cells; `cells` is how far the air moved.
std::complex<double> mode_factor(Interpolation interpolation, double cells, double theta) {
    if (interpolation != Interpolation::linear) // along an axis
        return cases::cubic_factor(cells, theta);
    // The departure point lies between the cells -whole - 1 and -whole; t is its distance from the first.
    const double low = std::floor(-cells), t = -cells - low;
    return (1.0 - t) * std::polar(1.0, low * theta) + t * std::polar(1.0, (low + 1.0) * theta);
}

// What became of mode k along `axis`: its complex factor.
std::complex<double> measured_factor(Workspace& work, CarriedForm form, Interpolation interpolation, int axis, int k,
                                     glm::vec3 wind) {
    const Box& box = work.box();
    const double theta = 2.0 * std::numbers::pi * k / box.cells[axis];
    const auto cosine = scalars_of(box, [&](glm::dvec3 x) { return std::cos(theta * (x[axis] - 0.5)); });
    const auto sine = scalars_of(box, [&](glm::dvec3 x) { return std::sin(theta * (x[axis] - 0.5)); });
    const Field air = uniform_wind(box, wind);
    const auto moved_cosine = carry(work, form, cosine, air, 1.0f, interpolation);
    const auto moved_sine = carry(work, form, sine, air, 1.0f, interpolation);
    std::complex<double> factor = 0.0;
    visit_cells(box, [&](std::size_t n, glm::dvec3 x) {
        factor += std::complex<double>(moved_cosine[n], moved_sine[n]) * std::polar(1.0, -theta * (x[axis] - 0.5));
    });
    return factor / static_cast<double>(box.cell_count());
}

const char* name_of(Interpolation interpolation) {
    return interpolation == Interpolation::linear ? "linear" : "cubic";
}

class UniformWind : public ::testing::TestWithParam<Interpolation> {};

TEST_P(UniformWind, EachModeOfEachAxisHasItsFactor) {
    constexpr int k_cells = 32;
    double worst = 0.0, worst_size = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        glm::ivec3 cells(3, 2, 4);
        cells[axis] = k_cells;
        Workspace work = workspace(periodic_box(cells));
        for (const CarriedForm form : k_forms)
            for (const float shift : {0.0f, 0.125f, 0.3f, 0.5f, 0.77f, -0.4f, 2.6f, -7.25f})
                for (const int k : {0, 1, 2, 5, 8, 13, 15, 16}) {
                    glm::vec3 wind(0.6f, -0.3f, 1.7f);
                    wind[axis] = shift;
                    const auto factor = measured_factor(work, form, GetParam(), axis, k, wind);
                    worst =
                        std::max(worst, std::abs(factor - mode_factor(GetParam(), shift, 2.0 * std::numbers::pi * k / k_cells)));
                    if (GetParam() == Interpolation::linear) {
                        const double a = shift - std::floor(shift), s = std::sin(std::numbers::pi * k / k_cells);
                        worst_size = std::max(
                            worst_size, std::abs(std::abs(factor) - std::sqrt(std::max(0.0, 1.0 - 4.0 * a * (1.0 - a) * s * s))));
                    }
                }
    }
    expect_at_most(std::string("advection.mode_factor.") + name_of(GetParam()), worst, 1e-5);
    if (GetParam() == Interpolation::linear)
        expect_at_most("advection.mode_damping.linear", worst_size, 1e-5);
}

// Oblique modes, pointwise: the factors of the axes multiply.
TEST_P(UniformWind, AnObliqueModeHasTheProductOfItsFactors) {
    Workspace work = workspace(periodic_box({32, 16, 20}));
    const Box& box = work.box();
    Random random(5);
    double worst = 0.0;
    for (int trial = 0; trial < 24; ++trial) {
        const glm::ivec3 k(random.integer(0, 15), random.integer(0, 7), random.integer(0, 9));
        const glm::vec3 wind(random.point(3.0));
        const glm::dvec3 theta = 2.0 * std::numbers::pi * glm::dvec3(k) / glm::dvec3(box.cells);
        std::complex<double> factor = 1.0;
        for (int axis = 0; axis < 3; ++axis)
            factor *= mode_factor(GetParam(), wind[axis], theta[axis]);
        const auto start = scalars_of(box, [&](glm::dvec3 x) { return std::cos(glm::dot(theta, x)); });
        const auto moved = carry(work, k_forms[trial % 4], start, uniform_wind(box, wind), 1.0f, GetParam());
        visit_cells(box, [&](std::size_t n, glm::dvec3 x) {
            worst = std::max(worst, std::abs(moved[n] - (factor * std::polar(1.0, glm::dot(theta, x))).real()));
        });
    }
    expect_at_most(std::string("advection.oblique_mode.") + name_of(GetParam()), worst, 1e-5);
}

// A Gaussian a line: 40 steps of half a cell, where linear weights spread the most.
TEST_P(UniformWind, AGaussianSpreadsByTheVarianceOfItsWeights) {
    constexpr int k_cells = 64, k_steps = 40;
    constexpr double k_start = 16.0, k_from = 20.0;
    const bool linear = GetParam() == Interpolation::linear;
    double worst = 0.0, worst_mean = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        for (const float shift : {0.5f, -0.5f, 0.25f}) {
            glm::ivec3 cells(2, 1, 3);
            cells[axis] = k_cells;
            Workspace work = workspace(periodic_box(cells));
            const Box& box = work.box();
            glm::vec3 wind(0.0f);
            wind[axis] = shift;
            const double middle = shift > 0.0f ? k_from : k_cells - k_from;
            const auto gaussian = [&](glm::dvec3 x) {
                const double off = std::remainder(x[axis] - middle, k_cells);
                return std::exp(-0.5 * off * off / k_start);
            };
            for (const CarriedForm form : {CarriedForm::vector_x, CarriedForm::scalar}) {
                auto values = scalars_of(box, gaussian);
                for (int step = 0; step < k_steps; ++step)
                    values = carry(work, form, values, uniform_wind(box, wind), 1.0f, GetParam());
                double sum = 0.0, first = 0.0, second = 0.0;
                visit_cells(box, [&](std::size_t n, glm::dvec3 x) {
                    const double off = std::remainder(x[axis] - middle - static_cast<double>(shift) * k_steps, k_cells);
                    sum += values[n];
                    first += values[n] * off;
                    second += values[n] * off * off;
                });
                const double mean = first / sum, growth = second / sum - mean * mean - k_start;
                const double a = std::abs(shift);
                worst = std::max(worst, std::abs(growth - (linear ? k_steps * a * (1.0 - a) : 0.0)));
                worst_mean = std::max(worst_mean, std::abs(mean));
                if (axis == 0 && shift == 0.5f)
                    figures::report(std::string("advection.variance_growth_40_half_cells.") + name_of(GetParam()) +
                                        (form == CarriedForm::scalar ? ".scalar" : ".vector"),
                                    growth);
            }
        }
    expect_at_most(std::string("advection.variance_growth_error.") + name_of(GetParam()), worst, 1e-3);
    expect_at_most(std::string("advection.gaussian_mean_error_cells.") + name_of(GetParam()), worst_mean, 1e-4);
}

TEST_P(UniformWind, AWholeCellShiftIsACopyToTheBit) {
    const Box box = periodic_box({13, 6, 9});
    Workspace work = workspace(box);
    Random random(3);
    int differing = 0;
    for (const glm::ivec3 shift : {glm::ivec3(0), glm::ivec3(1, 0, 0), glm::ivec3(-2, 3, 1), glm::ivec3(14, -7, 40)}) {
        std::vector<float> values(box.cell_count());
        for (float& v : values)
            v = static_cast<float>(random.real(-5, 5));
        for (const CarriedForm form : k_forms) {
            const auto moved = carry(work, form, values, uniform_wind(box, glm::vec3(shift)), 1.0f, GetParam());
            visit_cells(box, [&](std::size_t n, glm::dvec3 x) {
                const glm::ivec3 from = ((glm::ivec3(x) - shift) % box.cells + box.cells) % box.cells;
                differing += moved[n] != values[box.index(from.x, from.y, from.z)];
            });
        }
    }
    expect_at_most(std::string("advection.whole_cell_shift_differing_cells.") + name_of(GetParam()), differing, 0);
}

INSTANTIATE_TEST_SUITE_P(Interpolations, UniformWind, ::testing::Values(Interpolation::linear, Interpolation::cubic),
                         [](const auto& suite) { return name_of(suite.param); });

// Any wind, not only a uniform one: a value between its neighbours can be no larger than the largest.
TEST(Advection, LinearNeverGrowsAtAnyCfl) {
    Random random(11);
    double worst = 0.0;
    const BoundaryKind periodic = BoundaryKind::periodic, open = BoundaryKind::open, wall = BoundaryKind::free_slip,
                       rough = BoundaryKind::no_slip;
    for (const Boundaries& boundaries : {Boundaries::all(periodic), Boundaries::all(open), Boundaries::all(wall),
                                         sides_of({open, wall}, {rough, open}, {periodic, periodic})})
        for (const float cfl : {0.1f, 0.5f, 1.0f, 3.0f, 10.0f, 100.0f}) {
            const Box box{.cells = {19, 8, 12}, .boundaries = boundaries};
            Workspace work = workspace(box);
            for (const CarriedForm form : k_forms) {
                std::vector<float> values(box.cell_count());
                for (float& v : values)
                    v = random.integer(0, 1) == 0 ? -1.0f : 1.0f;
                for (int step = 0; step < 5; ++step) {
                    values = carry(work, form, values, random_field(random, box), cfl, Interpolation::linear);
                    for (const float v : values)
                        worst = std::max(worst, std::abs(static_cast<double>(v)));
                }
            }
        }
    // Room for the rounding of a + t (b - a), nothing else.
    expect_at_most("advection.linear_largest_value", worst, 1.0 + 1e-6);
}

// Worst case of the cubic weights: signs -, +, +, - and a shift of half a cell give 1.25 on each axis that moves.
TEST(Advection, CubicOvershootsByAQuarterAnAxisAtMost) {
    Random random(12);
    const Box box = periodic_box({16, 8, 12});
    Workspace work = workspace(box);
    const auto pattern = [](double x) { return (static_cast<int>(x) + 1) / 2 % 2 == 0 ? 1.0 : -1.0; };
    for (int axes = 1; axes <= 3; ++axes) {
        const auto start = scalars_of(box, [&](glm::dvec3 x) {
            double value = 1.0;
            for (int axis = 0; axis < axes; ++axis)
                value *= pattern(x[axis]);
            return value;
        });
        glm::vec3 wind(0.0f);
        for (int axis = 0; axis < axes; ++axis)
            wind[axis] = 0.5f;
        for (const CarriedForm form : {CarriedForm::vector_y, CarriedForm::scalar}) {
            const auto moved = carry(work, form, start, uniform_wind(box, wind), 1.0f, Interpolation::cubic);
            const double largest = *std::max_element(moved.begin(), moved.end());
            expect_at_most("advection.cubic_worst_overshoot_error." + std::to_string(axes) +
                               (form == CarriedForm::scalar ? ".scalar" : ".vector"),
                           std::abs(largest - std::pow(1.25, axes)), 1e-5);
        }
    }
    double worst = 0.0;
    for (int trial = 0; trial < 50; ++trial) {
        std::vector<float> values(box.cell_count());
        for (float& v : values)
            v = random.integer(0, 1) == 0 ? -1.0f : 1.0f;
        for (const float v : carry(work, k_forms[trial % 4], values, random_field(random, box, 3.0f), 1.0f, Interpolation::cubic))
            worst = std::max(worst, std::abs(static_cast<double>(v)));
    }
    expect_at_most("advection.cubic_random_overshoot", worst, std::pow(1.25, 3) + 1e-5);
    // The trial means nothing unless it comes near the bound.
    expect_at_least("advection.cubic_random_overshoot_reached", worst, 1.25);
}

// The step reads one padded field where a wind carries itself; two where they differ. Both must be the same advection.
TEST(Advection, AWindThatCarriesItselfEqualsACopyThatItCarries) {
    Random random(21);
    const Box box{.cells = {17, 9, 23}, .boundaries = Boundaries::open_over_floor()};
    Workspace work = workspace(box, {0.3f, 0.0f, -0.2f});
    const Field wind = random_field(random, box, 2.0f), copy = wind;
    for (const Interpolation interpolation : {Interpolation::linear, Interpolation::cubic}) {
        Field own(wind.size()), other(wind.size());
        advect(work, Transport{.carried = wind, .velocity = wind, .dt = 0.7f, .interpolation = interpolation}, own);
        advect(work, Transport{.carried = copy, .velocity = wind, .dt = 0.7f, .interpolation = interpolation}, other);
        EXPECT_EQ(own, other);
    }
}

// --- Every wave of space, at every shift -------------------------------------------------------------------------------------------

// The largest factor that any wave takes from a read: |sum_x w(x) exp(-i theta x)| over all directions and lengths. w from -3 to 3.
struct ReadWeights {
    static constexpr int k_reach = 3, k_side = 2 * k_reach + 1;
    std::array<float, k_side * k_side * k_side> values{};

    float& at(int x, int y, int z) {
        return values[static_cast<std::size_t>(((z + k_reach) * k_side + y + k_reach) * k_side + x + k_reach)];
    }
    [[nodiscard]] double largest_factor() {
        constexpr int k_waves = 12; // angles n pi / 12
        double largest = 0.0;
        for (int a = 0; a <= k_waves; ++a)
            for (int b = -k_waves; b <= k_waves; ++b)
                for (int c = -k_waves; c <= k_waves; ++c) {
                    std::complex<double> sum;
                    for (int z = -k_reach; z <= k_reach; ++z)
                        for (int y = -k_reach; y <= k_reach; ++y)
                            for (int x = -k_reach; x <= k_reach; ++x)
                                if (const float w = at(x, y, z); w != 0.0f)
                                    sum += static_cast<double>(w) * turn(a * x + b * y + c * z);
                    largest = std::max(largest, std::abs(sum));
                }
        return largest;
    }
    static std::complex<double> turn(int twelfths) {
        static const auto table = [] {
            std::array<std::complex<double>, 24> all;
            for (std::size_t n = 0; n < all.size(); ++n)
                all[n] = std::polar(1.0, -std::numbers::pi / 12.0 * static_cast<double>(n));
            return all;
        }();
        return table[static_cast<std::size_t>((twelfths % 24 + 24) % 24)];
    }
};

constexpr float k_shifts[] = {0.0f, 0.15f, 0.3f, 0.5f}; // a read is the same from either end
template <class Use>
void each_shift(const Use& use) {
    for (const float x : k_shifts)
        for (const float y : k_shifts)
            for (const float z : k_shifts)
                if (x >= y && y >= z)
                    use(glm::vec3(x, y, z));
}

// A read of 32 cells, cubic along the inner rows and linear along the outer ones, passes every test of one axis, and its waves grow
// by 1.0096 a step: 35-fold in 400. So waves of all directions are looked at.
TEST(Advection, NoWaveOfAnyDirectionGrows) {
    const Box box{.cells = {10, 10, 10}, .boundaries = Boundaries::all(BoundaryKind::periodic)};
    Workspace work = workspace(box);
    std::vector<float> one(box.cell_count(), 0.0f);
    one[static_cast<std::size_t>((5 * 10 + 5) * 10 + 5)] = 1.0f;
    for (const Interpolation interpolation : {Interpolation::linear, Interpolation::cubic, Interpolation::cubic_32})
        for (const CarriedForm form : {CarriedForm::vector_x, CarriedForm::scalar}) {
            double largest = 0.0;
            each_shift([&](glm::vec3 shift) {
                const auto moved = carry(work, form, one, uniform_wind(box, shift), 1.0f, interpolation);
                ReadWeights weights;
                for (int z = -3; z <= 3; ++z)
                    for (int y = -3; y <= 3; ++y)
                        for (int x = -3; x <= 3; ++x)
                            weights.at(x, y, z) = moved[static_cast<std::size_t>(((5 + z) * 10 + 5 + y) * 10 + 5 + x)];
                largest = std::max(largest, weights.largest_factor());
            });
            expect_at_most(std::string("advection.largest_factor.") +
                               k_words<Interpolation>[static_cast<std::size_t>(interpolation)] +
                               (form == CarriedForm::scalar ? "_scalar" : ""),
                           largest, 1.0 + 1e-5);
        }

    double literal = 0.0;
    each_shift([&](glm::vec3 t) {
        const auto cubic = [](float f, int node) {
            const float weights[] = {-f * (f - 1.0f) * (f - 2.0f) / 6.0f, (f + 1.0f) * (f - 1.0f) * (f - 2.0f) / 2.0f,
                                     -(f + 1.0f) * f * (f - 2.0f) / 2.0f, (f + 1.0f) * f * (f - 1.0f) / 6.0f};
            return weights[node + 1];
        };
        const auto linear = [](float f, int node) { return node == 0 ? 1.0f - f : node == 1 ? f : 0.0f; };
        const auto inner = [](int node) { return node == 0 || node == 1; };
        ReadWeights weights;
        for (int z = -1; z <= 2; ++z)
            for (int y = -1; y <= 2; ++y)
                for (int x = -1; x <= 2; ++x)
                    weights.at(x, y, z) = cubic(t.z, z) * (inner(z) ? cubic(t.y, y) : linear(t.y, y)) *
                                          (inner(z) && inner(y) ? cubic(t.x, x) : linear(t.x, x));
        literal = std::max(literal, weights.largest_factor());
    });
    expect_at_least("advection.largest_factor_of_32_cells", literal, 1.005);
}

} // namespace
} // namespace windrow
