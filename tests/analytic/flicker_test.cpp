// No two-step flicker: the history q carries half of the pressure and of the force from one step to the next. If it carried too
// much or too little, the next step would answer with the opposite sign, and the air would flicker at half the rate of the steps,
// undamped.
//
// Measured by the fourth difference over five steps, which leaves 16 times an alternating part and almost nothing of a smooth
// one:
//     alternating = |u(n+2) - 4 u(n+1) + 6 u(n) - 4 u(n-1) + u(n-2)| / 16
// Bound: 1e-3 of the blast ten steps after it.
#include "figures.h"
#include "flows.h"

#include <numbers>

namespace windrow {
namespace {

using namespace flows;
using figures::expect_at_least;
using figures::expect_at_most;

// Largest alternating part of any component about the `step`-th step from now.
double alternating_part(Wind& wind, double dt, int step) {
    std::vector<Field> fields;
    for (int n = 1; n <= step + 2; ++n) {
        wind.step(dt);
        if (n >= step - 2)
            fields.push_back(test::copy(wind.field()));
    }
    double largest = 0.0;
    for (std::size_t n = 0; n < fields[0].size(); ++n)
        for (int c = 0; c < 3; ++c) {
            const double weights[5] = {1.0, -4.0, 6.0, -4.0, 1.0};
            double sum = 0.0;
            for (int m = 0; m < 5; ++m)
                sum += weights[m] * static_cast<double>(fields[m][n][c]);
            largest = std::max(largest, std::abs(sum) / 16.0);
        }
    return largest;
}

double largest_off_ambient(const Wind& wind) {
    double largest = 0.0;
    for (const glm::vec4& u : wind.field())
        for (int c = 0; c < 3; ++c)
            largest = std::max(largest, std::abs(static_cast<double>(u[c]) - wind.ambient()[c]));
    return largest;
}

// A strong motor for five steps; `calm_steps` before it, so that it meets a wind with or without a history.
double blast_flicker(const Boundaries& boundaries, glm::vec3 ambient, int calm_steps, float acceleration) {
    Config config{.boundaries = boundaries, .floor = -8.0, .ambient = ambient, .relaxation_time = 0.0f, .max_cfl = 1e5f};
    Wind wind = *Wind::create(config);
    const double dt = 1.0 / 60.0;
    if (calm_steps == 0)
        wind.set_velocity([&](glm::dvec3) { return wind.ambient(); });
    take_steps(wind, calm_steps, dt);
    const MotorId motor = *wind.motors().add(DirectionalMotor{.position = {0.5, 0.25, -0.5},
                                                              .direction = {1.0f, 0.5f, 0.2f},
                                                              .region = Sphere{4.0f},
                                                              .law = Force{acceleration},
                                                              .turbulence = test::k_steady});
    take_steps(wind, 5, dt);
    EXPECT_TRUE(wind.motors().remove(motor));
    const double blast = largest_off_ambient(wind);
    EXPECT_GT(blast, 0.02 * static_cast<double>(acceleration) * 5.0 * dt);
    return alternating_part(wind, dt, 10) / blast;
}

TEST(Flicker, NoneTenStepsAfterABlast) {
    const std::pair<const char*, Boundaries> boxes[] = {{"periodic", Boundaries::all(BoundaryKind::periodic)},
                                                        {"open", {}},
                                                        {"over_floor", Boundaries::open_over_floor()},
                                                        {"closed", Boundaries::all(BoundaryKind::free_slip)}};
    for (const auto& [name, boundaries] : boxes)
        for (const float acceleration : {60.0f, 600.0f})
            for (const int calm_steps : {0, 20}) {
                const std::string label = std::string("flicker.blast.") + name + "." + figures::number_text(acceleration) +
                                          (calm_steps == 0 ? ".from_start" : ".into_history");
                expect_at_most(label + ".still", blast_flicker(boundaries, glm::vec3(0.0f), calm_steps, acceleration), 1e-3);
                expect_at_most(label + ".wind", blast_flicker(boundaries, {3.0f, 0.0f, 1.0f}, calm_steps, acceleration), 1e-3);
            }
}

// The first step of a flow has no history. If it handed on all of its pressure instead of half, what follows would alternate about
// the flow. The flow's largest speed is 1 m/s.
TEST(Flicker, NoneAfterAStartInTheMiddleOfAFlow) {
    for (const int cells : {32, 64, 128}) {
        const Box box = periodic_box({cells, cells, 1}, 2.0 * std::numbers::pi / cells);
        Wind wind = raw_wind(box, 0.0, Scheme::second_order, Interpolation::cubic);
        const TaylorGreen2D flow;
        EXPECT_TRUE(wind.set_velocity(velocities_of(box, [&](glm::dvec3 x) { return flow(x, 0.0); })));
        expect_at_most("flicker.start.cfl_1." + std::to_string(cells),
                       alternating_part(wind, static_cast<double>(box.cell_size), 10), 1e-3);
    }
}

} // namespace
} // namespace windrow
