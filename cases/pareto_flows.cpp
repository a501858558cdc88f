// The flows.
//
//   taylor_green_2d   u = U + sin(x - U t) cos(z - W t), w = W - cos(x - U t) sin(z - W t): exact
//   vortex_pair       stream function of two Gaussian whirls that turn against each other, blown through a box with open boundaries
//   abc_flow          curl u = u, so that u . grad u is a gradient: steady without viscosity, and carried by a mean wind: exact
//   jet               a motor blows into a wind over a floor
//   gusty_fan         a fan that circles, in gusts over a logarithmic profile
//   house             a wind begins at once around a house and a ball, which no cells fit
//
// Air at the scale of a game has no viscosity to speak of, and none is taken. The first two fill the level plane, one cell
// high; the others fill the shape of a game's window.
#include "cases/cell_values.h"
#include "cases/flows.h"
#include "cases/pareto_flow.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace windrow::cases {
namespace {

std::vector<glm::ivec3> flat_grids(int count) {
    std::vector<glm::ivec3> grids;
    for (int n = 0; n < count; ++n)
        grids.emplace_back(32 << n, 1, 32 << n);
    return grids;
}

std::vector<glm::ivec3> window_grids(int count) {
    std::vector<glm::ivec3> grids;
    for (int n = 0; n < count; ++n)
        grids.emplace_back(32 << n, 16 << n, 32 << n);
    return grids;
}

// One cell high: the height follows from the finest grid and matters to nothing.
ParetoFlow flat(double width) {
    ParetoFlow flow;
    flow.size = {width, 0.0, width};
    flow.boundaries = Boundaries::all(BoundaryKind::periodic);
    return flow;
}

ParetoFlow taylor_green_2d(bool quick) {
    const TaylorGreen2D vortices{.mean = {1.0, 0.0, 0.5}, .a = 0, .b = 2};
    ParetoFlow flow = flat(2.0 * k_pi);
    flow.name = "taylor_green_2d";
    flow.what = "Taylor and Green's vortices, carried across the cells by a mean wind; exact.";
    flow.mean = vortices.mean;
    flow.end = k_pi;
    flow.top_speed = 2.0;
    flow.grids = flat_grids(quick ? 3 : 4);
    flow.start = [=](glm::dvec3 x) { return vortices(x, 0.0); };
    flow.exact = [=](glm::dvec3 x) { return vortices(x, k_pi); };
    return flow;
}

ParetoFlow vortex_pair() {
    constexpr double k_width = 1.2, k_apart = 2.6, k_speed = 3.0; // [m, m, m/s] a whirl's fastest ring is k_width wide
    constexpr glm::dvec3 k_mean(1.5, 0.0, 0.8);
    ParetoFlow flow = flat(16.0);
    flow.name = "vortex_pair";
    flow.what = "Two whirls that push each other along through a mean wind and open boundaries; truth: 768 cells a side.";
    flow.boundaries.x_low.kind = flow.boundaries.x_high.kind = flow.boundaries.z_low.kind = flow.boundaries.z_high.kind =
        BoundaryKind::open;
    flow.mean = k_mean;
    flow.end = 3.0;
    flow.top_speed = 8.0; // at the start, in the shear between the two
    flow.grids = flat_grids(4);
    flow.reference = {768, 1, 768};
    flow.start = [=](glm::dvec3 x) {
        glm::dvec3 u = k_mean;
        for (const double turn : {1.0, -1.0}) {
            const glm::dvec3 from = x - glm::dvec3(5.0, 0.0, 6.0 + 0.5 * turn * k_apart);
            const double squared = (from.x * from.x + from.z * from.z) / (k_width * k_width);
            const double rate = turn * k_speed / k_width * std::exp(0.5 * (1.0 - squared));
            u += rate * glm::dvec3(-from.z, 0.0, from.x);
        }
        return u;
    };
    return flow;
}

ParetoFlow abc_flow(bool quick) {
    constexpr double k_end = 2.0;
    const ArnoldBeltramiChildress vortices{.mean = {0.5, -0.3, 0.4}};
    ParetoFlow flow;
    flow.name = "abc_flow";
    flow.what = "Arnold, Beltrami and Childress' flow without viscosity, carried across the cells by a mean wind; exact.";
    flow.size = {4.0 * k_pi, 2.0 * k_pi, 4.0 * k_pi};
    flow.boundaries = Boundaries::all(BoundaryKind::periodic);
    flow.mean = vortices.mean;
    flow.end = k_end;
    flow.top_speed = 2.1;
    flow.grids = window_grids(quick ? 2 : 3);
    flow.start = [=](glm::dvec3 x) { return vortices(x, 0.0); };
    flow.exact = [=](glm::dvec3 x) { return vortices(x, k_end); };
    return flow;
}

std::string against_finer(const char* flow, bool quick) {
    return std::string(flow) + (quick ? "; truth: 128 x 64 x 128 cells." : "; truth: 256 x 128 x 256 cells.");
}

ParetoFlow jet(bool quick) {
    ParetoFlow flow;
    flow.name = "jet";
    flow.what = against_finer("A jet motor blows into a mean wind over a floor", quick);
    flow.size = {32.0, 16.0, 32.0};
    flow.boundaries = Boundaries::open_over_floor();
    flow.mean = {3.0, 0.0, 1.0};
    flow.end = 1.5;
    flow.top_speed = 9.0; // reached in the nozzle
    // Wide enough for cells of 1 m, and rising smoothly: what a grid cannot hold is no error of a method.
    flow.motors = {JetMotor{.position = {8.0, 5.0, 13.0},
                            .direction = {1.0f, 0.0f, 0.3f},
                            .length = 12.0f,
                            .start_radius = 3.0f,
                            .end_radius = 4.5f,
                            .law = Drive{.speed = 12.0f, .rate = 6.0f},
                            .envelope = {.attack = 0.5f},
                            .turbulence = {.intensity = 0.0f}}};
    flow.grids = window_grids(quick ? 2 : 3);
    flow.reference = quick ? glm::ivec3(128, 64, 128) : glm::ivec3(256, 128, 256);
    flow.start = [mean = flow.mean](glm::dvec3) { return mean; };
    return flow;
}

ParetoFlow gusty_fan(bool quick) {
    ParetoFlow flow = jet(quick);
    flow.name = "gusty_fan";
    flow.what = against_finer("A fan on a circle blows across gusts over a floor", quick);
    flow.mean = {5.0, 0.0, 2.0};
    flow.profile = LogProfile{};
    flow.gusts = {.intensity = 0.2f};
    flow.top_speed = 8.1; // along x, ahead of the fan
    // It begins at full speed along its circle, but with no strength yet.
    flow.motion = [](double t) {
        const double angle = 2.2 * t;
        return glm::dvec3(14.0 + 4.0 * std::cos(angle), 6.0 + std::sin(angle), 14.0 + 4.0 * std::sin(angle));
    };
    flow.motors = {DirectionalMotor{.position = flow.motion(0.0),
                                    .direction = {0.6f, 0.5f, -0.6f},
                                    .region = Sphere{4.0f},
                                    .law = Drive{.speed = 9.0f, .rate = 6.0f},
                                    .envelope = {.attack = 0.5f},
                                    .turbulence = {.intensity = 0.0f}}};
    flow.start = {};
    return flow;
}

ParetoFlow house(bool quick) {
    ParetoFlow flow = jet(quick);
    flow.name = "house";
    flow.what = against_finer("A wind begins around a house and a ball", quick);
    flow.mean = {6.0, 0.0, 2.0};
    flow.end = 1.0;
    flow.top_speed = 9.0; // around the corners
    flow.motors.clear();
    flow.obstacles = {{.position = {13.3, 2.6, 14.2},
                       .orientation = glm::angleAxis(0.4f, glm::vec3(0.0f, 1.0f, 0.0f)),
                       .shape = Block{{3.1f, 2.6f, 4.2f}}},
                      {.position = {20.7, 5.4, 19.6}, .shape = Sphere{2.3f}}};
    flow.start = [mean = flow.mean](glm::dvec3) { return mean; };
    return flow;
}

double distance_to_obstacles(const ParetoFlow& flow, glm::dvec3 x) {
    double least = std::numeric_limits<double>::infinity();
    for (const Obstacle& body : flow.obstacles) {
        const glm::vec3 own = glm::conjugate(body.orientation) * glm::vec3(x - body.position);
        least = std::min(least, static_cast<double>(detail::distance_to(body.shape, own)));
    }
    return least;
}

} // namespace

bool is_solid(const ParetoFlow& flow, glm::dvec3 x) {
    return distance_to_obstacles(flow, x) <= 0.0;
}

bool counts(const ParetoFlow& flow, glm::dvec3 x) {
    return flow.obstacles.empty() || distance_to_obstacles(flow, x) >= 0.5 * flow.size.x / flow.grids.front().x;
}

Box box_of(const ParetoFlow& flow, glm::ivec3 cells) {
    return {.cells = cells, .cell_size = static_cast<float>(flow.size.x / cells.x), .boundaries = flow.boundaries};
}

int steps_of(const ParetoFlow& flow, glm::ivec3 cells, double cfl) {
    const double cells_crossed = flow.top_speed * flow.end * cells.x / flow.size.x;
    return 2 * std::max(1, static_cast<int>(std::ceil(0.5 * cells_crossed / cfl - 1e-9)));
}

std::vector<ParetoFlow> pareto_flows(bool quick) {
    if (quick)
        return {taylor_green_2d(quick), abc_flow(quick), jet(quick), house(quick)};
    return {taylor_green_2d(quick), vortex_pair(), abc_flow(quick), jet(quick), gusty_fan(quick), house(quick)};
}

} // namespace windrow::cases
