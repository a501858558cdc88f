// What acts on the air, through the public API, second order: half of it acts where the air departs, half where it arrives.
//
// Vortices in a mean wind cross a motor that moves, turns on and off (cases/flows.h), dt = h / 2. A step acts with the force of its
// middle: the motor is set to it first. Reference: spectral_flow.h with the same force, 128^2.
//
// Every kind of drive, and plants: a motor that moves and speeds up, moved as a host moves it, to where it is at the end of each
// step, against the same on four times as many cells.
#include "case_check.h"
#include "cases/spectral_solutions.h"
#include "flows.h"
#include "tests/tier.h"

#include <numbers>
#include <optional>
#include <span>

namespace windrow {
namespace {

using namespace flows;
using figures::expect_at_most;

using cases::solved;

constexpr double k_end = cases::ForcedVortices::k_end, k_viscosity = cases::ForcedVortices::k_viscosity;

double forced_error(int cells, const cases::ForcedVortices& gust, Scheme scheme, const std::vector<glm::dvec3>& exact) {
    const Box box = periodic_box({cells, cells, 1}, 2.0 * std::numbers::pi / cells);
    const double h = box.cell_size;
    Wind wind = raw_wind(box, k_viscosity, scheme, Interpolation::cubic);
    EXPECT_TRUE(wind.set_velocity(velocities_of(box, gust.start)));
    const auto motor_at = [&](double t) { return gust.motor(t, 0.5 * h); };
    const MotorId motor = *wind.motors().add(motor_at(0.0));
    for (int step = 0; step < cells; ++step) {
        EXPECT_TRUE(wind.motors().set(motor, motor_at(k_end * (step + 0.5) / cells)));
        EXPECT_EQ(wind.step(k_end / cells).substeps, 1);
    }
    return relative_error(wind.field(), exact, gust.k_mean);
}

TEST(ForcedFlow, AMovingMotorIsSecondOrderAtFixedCfl) {
    const cases::ForcedVortices gust;
    const auto& truth = cases::forced_vortices_end();
    expect_at_most("forced.reference_change_from_96_to_128",
                   relative_error(solved(gust, 96, 150)->at_cell_centres({64, 64, 1}), truth.at_cell_centres({64, 64, 1})), 2e-4);
    figures::expect_orders("forced.stable_fluids", {64, 128}, 0.9, [&](int cells) {
        return forced_error(cells, gust, Scheme::stable_fluids, truth.at_cell_centres({cells, cells, 1}));
    });
    figures::expect_case("forced_flow", {32, 64, 128});
}

TEST(ForcedFlow, AMotorAtFullStrengthFromTheStartIsToo) {
    const cases::ForcedVortices gust{.at_once = true};
    const auto exact = solved(gust, 96, 150);
    figures::expect_orders("forced.at_once", {32, 64, 128}, 1.9, [&](int cells) {
        return forced_error(cells, gust, Scheme::second_order, exact->at_cell_centres({cells, cells, 1}));
    });
}

// --- Every kind of drive, and plants -----------------------------------------------------------------------------------

glm::dvec3 path(double t) {
    return {2.0 + 0.5 * t + 0.25 * t * t, 3.0 + 0.3 * std::sin(t), 0.0};
}

// Of the one plane of cells. Beside it a jet's rays would point out of the plane, by half a cell of each grid.
glm::dvec3 plane(const Wind& wind) {
    return {0.0, 0.0, wind.origin().z + 0.5 * static_cast<double>(wind.box().cell_size)};
}

constexpr float k_rate = 4.0f; // [1/s] times a step of 0.1 s on the coarsest grid: below 1

struct Driven {
    const char* name;
    std::optional<Motor> motor;
    double fine_error = 1.0; ///< most on 128 cells
};

std::vector<glm::dvec3> driven_end(const Driven& driven, int cells, double step_cells, double end) {
    const double length = 2.0 * std::numbers::pi, h = length / cells;
    Config config{.cells = {cells, cells, 1},
                  .cell_size = static_cast<float>(h),
                  .boundaries = Boundaries::all(BoundaryKind::periodic),
                  .centre = {0.5 * length, 0.5 * length, 0.0},
                  .viscosity = 0.0f,
                  .relaxation_time = 0.0f,
                  .max_cfl = 1e6f,
                  .max_substeps = 1};
    if (!driven.motor) { // plants as high as the box: what their sharp top does is no matter of time
        config.boundaries.y_low.kind = config.boundaries.y_high.kind = BoundaryKind::free_slip;
        config.ambient = {1.0f, 0.0f, 0.0f};
        config.canopy = Canopy{.height = 10.0f, .drag = 1.0f};
    }
    Wind wind = *Wind::create(config);
    if (!driven.motor)
        wind.set_velocity([](glm::dvec3 x) {
            return glm::vec3(
                glm::dvec3(1.0 + 0.25 * std::sin(x.x) * std::cos(0.5 * x.y), -0.5 * std::cos(x.x) * std::sin(0.5 * x.y), 0.0));
        });
    std::optional<Motor> in_plane = driven.motor;
    if (in_plane)
        std::visit([&](auto& motor) { motor.position = path(0.0) + plane(wind); }, *in_plane);
    const MotorId motor = in_plane ? *wind.motors().add(*in_plane) : MotorId{};
    const int steps = 2 * static_cast<int>(std::lround(0.5 * end / (step_cells * h)));
    for (int step = 1; step <= steps; ++step) {
        if (driven.motor) {
            EXPECT_TRUE(wind.motors().move(motor, path(end * step / steps) + plane(wind)));
        }
        wind.step(end / steps);
    }
    std::vector<glm::dvec3> field;
    for (const glm::vec4& u : wind.field())
        field.emplace_back(u);
    return field;
}

// Means over the cells of a grid `factor` times as coarse.
std::vector<glm::dvec3> coarsened(const std::vector<glm::dvec3>& fine, int cells, int factor) {
    std::vector<glm::dvec3> coarse(static_cast<std::size_t>(cells) * cells);
    for (std::size_t n = 0; n < fine.size(); ++n) {
        const std::size_t i = n % (cells * factor) / factor, j = n / (cells * factor) / factor;
        coarse[j * cells + i] += fine[n] / static_cast<double>(factor * factor);
    }
    return coarse;
}

const Driven k_driven[] = {
    {"ball",
     DirectionalMotor{
         .direction = {1.0f, 0.3f, 0.0f}, .region = Sphere{1.2f}, .law = Drive{1.0f, k_rate}, .turbulence = test::k_steady},
     6e-3},
    {"pushing_ball",
     DirectionalMotor{.direction = {1.0f, 0.3f, 0.0f}, .region = Sphere{1.2f}, .law = Force{1.0f}, .turbulence = test::k_steady},
     6e-3},
    {"jet",
     JetMotor{.direction = {0.8f, 0.6f, 0.0f},
              .length = 2.0f,
              .start_radius = 0.8f,
              .end_radius = 1.2f,
              .law = Drive{1.0f, k_rate},
              .turbulence = test::k_steady},
     5e-3},
    {"vortex", VortexMotor{.axis = {0.0f, 0.0f, 1.0f}, .radius = 1.5f, .half_length = 2.0f, .law = Drive{1.0f, k_rate}}, 6e-3},
    {"wake", WakeMotor{.radius = 1.2f, .law = WakeDrive{.per_metre = k_rate, .entrainment = 0.8f}}, 6e-3},
    {"plants", std::nullopt, 6e-3},
};

TEST(ForcedFlow, EveryDriveIsSecondOrder) {
    const auto driven_flows =
        std::span(k_driven).first(test::whole_sweeps() ? std::size(k_driven) : 3); // of both laws, and a jet
    for (const Driven& driven : driven_flows) {
        constexpr int k_finest = 512;
        const auto truth = driven_end(driven, k_finest, 1.0, 2.0);
        const std::string name = std::string("driven.") + driven.name;
        const double finest = figures::expect_orders(name, {64, 128}, 1.9, [&](int cells) {
            return relative_error(driven_end(driven, cells, 1.0, 2.0), coarsened(truth, cells, k_finest / cells));
        });
        expect_at_most(name + ".error_128_bound", finest, driven.fine_error);
    }
}

// However hard: the air is held at the drive's speed, and what the pressure makes of it stays of that size.
TEST(ForcedFlow, DrivesOfAnyRateStayBounded) {
    for (const float rate : {10.0f, 100.0f, 1e3f, 1e4f, 1e6f}) {
        Driven ball = k_driven[0];
        std::get<DirectionalMotor>(*ball.motor).law = Drive{1.0f, rate};
        double fastest = 0.0;
        for (const glm::dvec3& u : driven_end(ball, 64, 1.0, 8.0))
            fastest = std::max(fastest, glm::length(u));
        expect_at_most("driven.ball.rate_" + figures::number_text(static_cast<double>(rate)) + ".fastest", fastest, 2.5);
    }
}

} // namespace
} // namespace windrow
