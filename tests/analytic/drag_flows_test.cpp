// Flows through deposits of drag: a crown's drag coefficient, the momentum that it takes, the order of the half steps, and a box
// that walks past plants.
//
// A porous body of resistance k = integral of c along the wind has the pressure loss coefficient K = 2 k. The stream that passes it is
// slowed to 1/(1 + K/4) of the wind, so that its drag coefficient is K/(1 + K/4)^2.
// Based on: Taylor 1944, Aeronautical Research Council R&M 2236 (a screen in a stream).
#include "tests/winds.h"

#include <array>

namespace windrow {
namespace {

using namespace test;

// A cube of 8 cells in a wind of 4 m/s, 16 cells behind the front of an open box.
struct Crown {
    Wind wind;
    DragId id;
};
Crown crown_of(glm::ivec3 cells, float resistance, const Boundaries& boundaries) {
    Wind wind = made({.cells = cells,
                      .boundaries = boundaries,
                      .centre = {0.5 * cells.x - 16.0, 0.0, 0.0},
                      .floor = -0.5 * cells.y,
                      .ambient = {4.0f, 0.0f, 0.0f},
                      .viscosity = 0.0f,
                      .relaxation_time = 0.0f});
    const auto id =
        wind.drag().add(PlantDrag{.position = {0.0, -4.0, 0.0}, .radius = 4.0f, .height = 8.0f, .area = 64.0f * resistance});
    EXPECT_TRUE(id);
    return {std::move(wind), *id};
}

double load_on(const Crown& crown) {
    return static_cast<double>(crown.wind.force_on(crown.id)->force.x);
}

std::string digits(double value) {
    return std::to_string(value).substr(0, 3);
}

// Once the wake has passed the box's end; later it sways where it is slowest.
TEST(DragFlows, ACrownHasTheDragOfAScreen) {
    for (const double pressure_loss : {0.2, 0.4, 0.8, 1.6, 3.2}) {
        Crown crown = crown_of({48, 40, 40}, static_cast<float>(0.5 * pressure_loss), {});
        take_steps(crown.wind, 120, 0.2);
        double load = 0.0;
        constexpr int k_steps = 40;
        for (int step = 0; step < k_steps; ++step) {
            (void)crown.wind.step(0.2);
            load += load_on(crown) / k_steps;
        }
        const double expected = pressure_loss / std::pow(1.0 + 0.25 * pressure_loss, 2) * 0.5 * 1.2 * 16.0 * 64.0;
        WINDROW_EXPECT_FIGURE("drag.screen_" + digits(pressure_loss), std::abs(load / expected - 1.0), 0.04);
    }
}

// In a duct with walls that slip: what passes a plane before the crown, pressure with it, less what passes one behind and what the
// air between them gains.
TEST(DragFlows, ACrownTakesTheMomentumOfItsLoad) {
    constexpr int k_front = 8, k_behind = 40, k_steps = 160;
    constexpr double k_dt = 0.05, k_air = 1.2;
    Boundaries duct;
    duct.y_low.kind = duct.y_high.kind = duct.z_low.kind = duct.z_high.kind = BoundaryKind::free_slip;
    for (const double pressure_loss : {0.2, 0.8, 3.2}) {
        Crown crown = crown_of({48, 24, 24}, static_cast<float>(0.5 * pressure_loss), duct);
        take_steps(crown.wind, 480, k_dt);
        const Box& box = crown.wind.box();
        const auto between = [&] {
            double sum = 0.0;
            for_each_cell(box.cells, [&](int i, int j, int k) {
                const double weight = i > k_front && i < k_behind ? 1.0 : i == k_front || i == k_behind ? 0.5 : 0.0;
                sum += weight * k_air * static_cast<double>(crown.wind.field()[box.index(i, j, k)].x);
            });
            return sum;
        };
        double lost = 0.0, load = 0.0;
        const double before = between();
        std::vector<float> pressure(box.cell_count());
        for (int step = 0; step < k_steps; ++step) {
            load += 0.5 * load_on(crown) / k_steps;
            (void)crown.wind.step(k_dt);
            load += 0.5 * load_on(crown) / k_steps;
            ASSERT_TRUE(crown.wind.write_pressure(pressure));
            for (const auto& [plane, sign] : {std::pair{k_front, 1.0}, std::pair{k_behind, -1.0}})
                for (int k = 0; k < box.cells.z; ++k)
                    for (int j = 0; j < box.cells.y; ++j) {
                        const std::size_t n = box.index(plane, j, k);
                        const auto u = static_cast<double>(crown.wind.field()[n].x);
                        lost += sign * k_air * (u * u + static_cast<double>(pressure[n])) / k_steps;
                    }
        }
        lost -= (between() - before) / (k_steps * k_dt);
        WINDROW_EXPECT_FIGURE("drag.momentum_" + digits(pressure_loss), std::abs(lost / load - 1.0), 0.05);
    }
}

// --- Order -----------------------------------------------------------------------------------------------------------------------

// c, which deposits of 2 x 2 cells make: of a corner what gives the cells between corners the values of c itself, to h^4.
double bush_at(double x, double y) {
    constexpr double k_most = 0.4, k_width = 0.6;
    const auto off = [](double a) { return std::remainder(a - pi, 2.0 * pi); };
    return k_most * std::exp(-(off(x) * off(x) + off(y) * off(y)) / (2.0 * k_width * k_width));
}
double corner_at(double x, double y, double h) {
    const double around = bush_at(x + h, y) + bush_at(x - h, y) + bush_at(x, y + h) + bush_at(x, y - h) - 4.0 * bush_at(x, y);
    return std::max(bush_at(x, y) - 0.125 * around, 0.0);
}

// Vortices carried through a bush for pi / 2 s, at a Courant number of 0.73: the cells of one plane.
std::vector<glm::dvec3> carried_through_a_bush(int cells) {
    const double h = static_cast<double>(static_cast<float>(2.0 * pi / cells)), middle = 0.5 * cells * h;
    Wind wind = made({.cells = {cells, cells, 1},
                      .cell_size = static_cast<float>(h),
                      .boundaries = Boundaries::all(BoundaryKind::periodic),
                      .centre = {middle, middle, 0.5 * h},
                      .viscosity = 0.0f,
                      .relaxation_time = 0.0f,
                      .max_cfl = 1e6f,
                      .max_substeps = 1});
    std::vector<DragDeposit> bush;
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i)
            bush.push_back(PlantDrag{.position = {i * h, (j - 1) * h, 0.5 * h},
                                     .radius = static_cast<float>(h),
                                     .height = static_cast<float>(2.0 * h),
                                     .area = static_cast<float>(corner_at(i * h, j * h, h) * h * h * h)});
    EXPECT_TRUE(wind.drag().add(bush));
    wind.set_velocity([](glm::dvec3 x) {
        return glm::vec3(glm::dvec3(1.0 + std::sin(x.x) * std::cos(x.y), 0.5 - std::cos(x.x) * std::sin(x.y), 0.0));
    });
    const int steps = 22 * cells / 32;
    take_steps(wind, steps, 0.5 * pi / steps);
    std::vector<glm::dvec3> field;
    for (const glm::vec4& u : wind.field())
        field.emplace_back(u);
    return field;
}

// At the centres of a grid half as fine, to h^4.
std::vector<glm::dvec3> halved(const std::vector<glm::dvec3>& fine, int cells) {
    constexpr std::array<double, 4> k_weights{-1.0 / 16.0, 9.0 / 16.0, 9.0 / 16.0, -1.0 / 16.0};
    std::vector<glm::dvec3> coarse(fine.size() / 4);
    for_each_cell({cells / 2, cells / 2, 1}, [&](int i, int j, int) {
        glm::dvec3 sum(0.0);
        for (int b = 0; b < 4; ++b)
            for (int a = 0; a < 4; ++a) {
                const int x = (2 * i - 1 + a + cells) % cells, y = (2 * j - 1 + b + cells) % cells;
                sum += k_weights[static_cast<std::size_t>(a)] * k_weights[static_cast<std::size_t>(b)] *
                       fine[static_cast<std::size_t>(y * cells + x)];
            }
        coarse[static_cast<std::size_t>(j * (cells / 2) + i)] = sum;
    });
    return coarse;
}

// Differences of each grid to the next finer one, over the largest speed of 2 m/s; each is a quarter of the one before, or less.
void expect_second_order(int finest) {
    double before = 0.0;
    auto coarse = carried_through_a_bush(32);
    for (int cells = 64; cells <= finest; cells *= 2) {
        auto fine = carried_through_a_bush(cells);
        const auto same = halved(fine, cells);
        double squares = 0.0;
        for (std::size_t n = 0; n < same.size(); ++n)
            squares += glm::dot(same[n] - coarse[n], same[n] - coarse[n]);
        const double apart = std::sqrt(squares / static_cast<double>(same.size())) / 2.0;
        if (before > 0.0) {
            WINDROW_EXPECT_FIGURE("drag.refined_" + std::to_string(cells / 2), apart / before, 0.25);
        }
        if (cells == 256) {
            WINDROW_EXPECT_FIGURE("drag.apart_128", apart, 6e-5);
        }
        before = apart;
        coarse = std::move(fine);
    }
}

TEST(DragFlows, ABushIsSecondOrderInAMovingFlow) {
    expect_second_order(128);
}
TEST(DragFlows, LongABushIsSecondOrderInAMovingFlow) {
    expect_second_order(256);
}

// --- A box that walks ------------------------------------------------------------------------------------------------------------

// Past two bushes, across the wind: thirteen shifts, beside a box that is wide enough to hold the way; all times, the inner half.
TEST(DragFlows, ABoxThatWalksPastPlantsFindsTheSameAir) {
    const Config narrow{.cells = {32, 16, 32}, .ambient = {2.0f, 0.0f, 4.0f}};
    Config wide = narrow;
    wide.cells.x = 48;
    wide.centre = {6.0, 0.0, 0.0};
    Wind walks = made(narrow), stays = made(wide);
    for (Wind* wind : {&walks, &stays})
        for (const glm::dvec3 at : {glm::dvec3(5.0, -2.0, 1.0), glm::dvec3(8.0, -2.0, -2.0)}) {
            EXPECT_TRUE(wind->drag().add(PlantDrag{.position = at, .radius = 1.5f, .height = 4.0f, .area = 4.0f}));
            take_steps(*wind, 100, 1.0 / 30.0);
        }
    double worst = 0.0;
    for (int step = 0; step < 13 * 6; ++step) {
        ASSERT_TRUE(walks.follow({1.0 + step / 6, 0.0, 0.0}));
        (void)walks.step(1.0 / 30.0);
        (void)stays.step(1.0 / 30.0);
        const glm::ivec3 apart(glm::round(walks.origin() - stays.origin()));
        for_each_cell(glm::ivec3(16, 8, 16), [&](int i, int j, int k) {
            const glm::ivec3 cell = glm::ivec3(i, j, k) + glm::ivec3(8, 4, 8), there = cell + apart;
            const glm::vec4 u = walks.field()[walks.box().index(cell.x, cell.y, cell.z)],
                            v = stays.field()[stays.box().index(there.x, there.y, there.z)];
            worst = std::max(worst, static_cast<double>(glm::length(u - v)) / std::sqrt(20.0));
        });
    }
    WINDROW_EXPECT_FIGURE("drag.walk", worst, 0.005);
}

} // namespace
} // namespace windrow
