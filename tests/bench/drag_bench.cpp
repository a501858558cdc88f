// Cost of drag on the CPU: a step of the default window without any, with a canopy of three rows, and with 40,000 plants; a shift of
// the box past these plants, and adding them.
//
// Minima of turns in which all take part: other programs disturb each alike.
#include "fluid/wind.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace {

using namespace windrow;

double milliseconds_of(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// Evenly over the default window of 32 m.
std::vector<DragDeposit> plants(int count) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-16.0, 16.0), size(0.3, 0.9);
    std::vector<DragDeposit> deposits;
    for (int n = 0; n < count; ++n) {
        const double radius = size(random), x = place(random), z = place(random);
        deposits.emplace_back(PlantDrag{.position = {x, 0.0, z},
                                        .radius = static_cast<float>(radius),
                                        .height = static_cast<float>(2.5 * radius),
                                        .area = static_cast<float>(0.3 * radius * radius)});
    }
    return deposits;
}

Wind windy(bool canopy) {
    Config config{.boundaries = Boundaries::open_over_floor(), .ambient = {5.0f, 0.0f, 1.0f}, .sleep_speed = 0.0f};
    if (canopy)
        config.canopy = Canopy{.height = 3.0f};
    return *Wind::create(config);
}

} // namespace

int main() {
    constexpr int k_turns = 60, k_steps = 8;
    Wind none = windy(false), canopy = windy(true), planted = windy(false);
    const auto deposits = plants(40000);
    const double adding = milliseconds_of([&] { (void)planted.drag().add(deposits); });
    const double first = milliseconds_of([&] { (void)planted.step(1.0 / 30.0); });
    std::array<double, 3> best;
    best.fill(std::numeric_limits<double>::infinity());
    const std::array<Wind*, 3> winds{&none, &canopy, &planted};
    for (int turn = 0; turn < k_turns; ++turn)
        for (std::size_t n = 0; n < winds.size(); ++n)
            for (int step = 0; step < k_steps; ++step)
                best[n] = std::min(best[n], milliseconds_of([&] { (void)winds[n]->step(1.0 / 30.0); }));
    std::printf("step without plants        %.3f ms\n", best[0]);
    std::printf("canopy of three rows       %.3f ms, %.3f of it\n", best[1], best[1] / best[0]);
    std::printf("40,000 plants              %.3f ms, %.3f of it\n", best[2], best[2] / best[0]);
    // The same window, without air.
    DragField field(Box{{32, 16, 32}, 1.0f, {}, nullptr});
    (void)field.add(deposits);
    Window window{.cells = {32, 16, 32}, .cell_size = 1.0f, .origin_cells = {-16, 0, -16}};
    (void)field.cells_in(window, {});
    double shift = std::numeric_limits<double>::infinity();
    for (int turn = 0; turn < 200; ++turn) {
        window.origin_cells.x += turn % 20 < 10 ? 1 : -1;
        shift = std::min(shift, milliseconds_of([&] { (void)field.cells_in(window, {}); }));
    }
    std::printf("shift by a cell past them  %.3f ms\n", shift);
    std::printf("adding 40,000 plants      %.1f ms; the first step that finds them %.1f ms\n", adding, first);
    return 0;
}
