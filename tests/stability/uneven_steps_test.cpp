// Steps of unequal length: the history of a short step meets a long one, and the other way round.
//
// Without motors the energy must not grow, whatever the ratio of a step to the next. What is wrong in the history turns its sign
// with each step and grows by their ratio (shaders/numerics/history.glsl); undamped, ratios of 1.35 to 2 make 2 to 800 times the
// energy within 300 steps, and no other ratio shows it.

#include "tests/stability/watch.h"

#include <sstream>

namespace {

using namespace windrow;
using namespace windrow::test;

// Two whirls that turn against each other about axes along y, and carry each other along x.
Field vortex_pair(glm::ivec3 cells, float size, std::uint32_t) {
    Field field(cell_count(cells));
    const float radius = 0.1f * static_cast<float>(cells.z);
    std::size_t n = 0;
    for_each_cell(cells, [&](int i, int, int k) {
        for (const float side : {-1.0f, 1.0f}) {
            const float x = (static_cast<float>(i) + 0.5f - 0.5f * static_cast<float>(cells.x)) / radius;
            const float z = (static_cast<float>(k) + 0.5f - 0.5f * static_cast<float>(cells.z)) / radius - 1.5f * side;
            const float turn = 1.6f * size * side * std::exp(-0.5f * (x * x + z * z));
            field[n] += turn * glm::vec4(-z, 0.0f, x, 0.0f);
        }
        ++n;
    });
    return field;
}

// The classic start that rolls up in three dimensions; scaled so that a box of any shape has no divergence to lose.
Field taylor_green(glm::ivec3 cells, float size, std::uint32_t) {
    Field field(cell_count(cells));
    const glm::vec3 step = 6.2831853f / glm::vec3(cells);
    std::size_t n = 0;
    for_each_cell(cells, [&](int i, int j, int k) {
        const glm::vec3 x = step * (glm::vec3(i, j, k) + 0.5f);
        field[n++] = size * std::cos(x.z) *
                     glm::vec4(std::sin(x.x) * std::cos(x.y), -step.x / step.y * std::cos(x.x) * std::sin(x.y), 0.0f, 0.0f);
    });
    return field;
}

struct UnevenStart {
    const char* name;
    Field (*field)(glm::ivec3, float, std::uint32_t);
};
constexpr UnevenStart k_uneven_starts[] = {{"smooth", smooth_noise},
                                           {"white", white_noise},
                                           {"shear", shear_layer},
                                           {"vortex_pair", vortex_pair},
                                           {"taylor_green", taylor_green}};

// Largest energy over the start's while steps that cross `cells_per_step` cells alternate with some shorter by `ratio`.
double largest_energy(const UnevenStart& start, BoundaryKind boundaries, Config config, double cells_per_step, double ratio,
                      int steps) {
    config.cells = {32, 16, 32};
    config.boundaries = Boundaries::all(boundaries);
    config.viscosity = 0.0f;
    config.relaxation_time = 0.0f;
    Wind wind = made(config);
    EXPECT_TRUE(wind.set_velocity(projected(start.field(config.cells, 1.0f, 7), wind.box())));
    float component = 0.0f;
    for (const glm::vec4& u : wind.field())
        component = std::max({component, std::abs(u.x), std::abs(u.y), std::abs(u.z)});
    const double before = energy_of(wind.field());
    double largest = 0.0;
    for (int n = 0; n < steps; ++n) {
        wind.step(cells_per_step / component / (n % 2 == 0 ? ratio : 1.0));
        largest = std::max(largest, energy_of(wind.field()) / before);
    }
    return largest;
}

double worst_energy(const Config& config, double cells_per_step, double ratio, int steps) {
    double worst = 0.0;
    for (const BoundaryKind boundaries : k_kinds)
        for (const UnevenStart& start : k_uneven_starts)
            worst = std::max(worst, largest_energy(start, boundaries, config, cells_per_step, ratio, steps));
    return worst;
}

std::string name_of(const char* how, double cells_per_step, double ratio) {
    std::ostringstream name;
    name << "stability/uneven_" << how << "/cfl_" << cells_per_step << "/ratio_" << ratio << "/energy";
    return name.str();
}

Config raw() {
    return {.max_cfl = 1e6f, .max_substeps = 1};
}

// Those in between, and the others of the sweep, in LongUnevenSteps.
TEST(UnevenSteps, CreateNoEnergy) {
    const int steps = k_sanitized ? 10 : 120;
    for (const double ratio : {1.35, 2.0, 1.0, 1.5}) {
        if (!whole_sweeps() && ratio != 1.35 && ratio != 2.0) // even steps are HardCases'
            continue;
        WINDROW_EXPECT_FIGURE(name_of("raw", 2.0, ratio), worst_energy(raw(), 2.0, ratio, steps), 1.001);
        WINDROW_EXPECT_FIGURE(name_of("default", 1.33, ratio), worst_energy({}, 1.33, ratio, steps), 1.001);
    }
}

TEST(LongUnevenSteps, CreateNoEnergyAtAnyRatio) {
    for (const double ratio : {1.0, 1.01, 1.05, 1.1, 1.2, 1.35, 1.5, 1.75, 2.0, 2.5, 3.0, 10.0, 100.0, 1000.0}) {
        for (const double cfl : {0.5, 1.0, 1.33, 2.0})
            WINDROW_EXPECT_FIGURE(name_of("raw", cfl, ratio), worst_energy(raw(), cfl, ratio, 300), 1.001);
        for (const double cfl : {0.5, 1.33, 3.0, 6.0, 40.0})
            WINDROW_EXPECT_FIGURE(name_of("default", cfl, ratio), worst_energy({}, cfl, ratio, 300), 1.001);
    }
}

// Beyond what sub-steps allow the raw step may gain; it must not run away. The starts that gain most.
TEST(LongUnevenSteps, TenThousandRawStepsStayBounded) {
    for (const double cfl : {5.0, 10.0, 50.0})
        for (const double ratio : {1.0, 1.5, 2.0, 3.0}) {
            double worst = 0.0;
            for (const BoundaryKind boundaries : {BoundaryKind::periodic, BoundaryKind::free_slip})
                for (const UnevenStart& start : {k_uneven_starts[2], k_uneven_starts[3]})
                    worst = std::max(worst, largest_energy(start, boundaries, raw(), cfl, ratio, 10'000));
            WINDROW_EXPECT_FIGURE(name_of("raw_long", cfl, ratio), worst, 10.0);
        }
}

void expect_bounded(const std::string& name, int steps, float max_cfl, const std::function<double(int)>& dt_of) {
    for (int kind = 0; kind < 4; ++kind)
        for (const Scheme scheme : {Scheme::second_order, Scheme::stable_fluids}) {
            Wind wind = made({.cells = {20, 12, 16},
                              .boundaries = Boundaries::all(k_kinds[kind]),
                              .viscosity = 0.1f,
                              .scheme = scheme,
                              .max_cfl = max_cfl});
            drive(wind, {0.0, 0.0, 0.0}, {1.0f, 0.3f, 0.0f}, 10.0f);
            added(wind, DirectionalMotor{.position = {4.0, 0.0, 0.0}, .direction = {0.0f, 1.0f, 0.0f}, .law = Force{1.0f}});
            Watch watch(wind, 10.0); // the force pushes a sideward metre a second into air that crosses it in one
            watch.run(steps, dt_of);
            watch.judge(name + '_' + k_kind_names[kind] + (scheme == Scheme::stable_fluids ? "_stable_fluids" : ""),
                        {k_input_energy, k_opposed_factor});
        }
}

// While motors push.
TEST(UnevenSteps, AlternatingByAThousand) {
    expect_bounded("steps_alternating", 1'500, 2.0f, [](int n) { return n % 2 == 0 ? 1e-3 : 1.0; });
}

TEST(UnevenSteps, LogUniform) {
    Random random(71);
    expect_bounded("steps_log_uniform", 1'000, 2.0f, [&](int) { return random.spread(1e-5, 10.0); });
    expect_bounded("steps_log_uniform_raw", 1'000, 1e6f, [&](int) { return random.spread(1e-5, 10.0); });
}

} // namespace
