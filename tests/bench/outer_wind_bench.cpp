// Cost of a wind around the default window on the CPU: of three ticks of the window at 30 Hz and one of an outer wind at 10 Hz, over
// three of the window alone. A bush before the window keeps both awake.
//
// Minima of turns in which all take part: other programs disturb each alike.
#include "fluid/wind.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>

namespace {

using namespace windrow;

double milliseconds_of(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

int main() {
    constexpr int k_turns = 300;
    const Boundaries floor = Boundaries::open_over_floor();
    const PlantDrag bush{.position = {-24.0, 0.0, 0.0}, .radius = 5.0f, .height = 8.0f, .area = 40.0f};
    const auto outer = std::make_shared<Wind>(*Wind::create({.cells = {48, 12, 48},
                                                             .cell_size = 2.0f,
                                                             .boundaries = floor,
                                                             .ambient = {5.0f, 0.0f, 1.0f},
                                                             .sleep_speed = 0.0f,
                                                             .ticks = {.hz = 10.0}}));
    (void)outer->drag().add(bush);
    Wind inner = *Wind::create({.boundaries = floor, .sleep_speed = 0.0f}, outer);
    Wind alone = *Wind::create({.boundaries = floor, .ambient = {5.0f, 0.0f, 1.0f}, .sleep_speed = 0.0f});
    double of_outer = std::numeric_limits<double>::infinity(), of_inner = of_outer, of_alone = of_outer;
    for (int turn = 0; turn < k_turns; ++turn) {
        of_outer = std::min(of_outer, milliseconds_of([&] { (void)outer->advance(0.1); }));
        for (int tick = 0; tick < 3; ++tick) {
            of_inner = std::min(of_inner, milliseconds_of([&] { (void)inner.advance(1.0 / 30.0); }));
            of_alone = std::min(of_alone, milliseconds_of([&] { (void)alone.advance(1.0 / 30.0); }));
        }
    }
    std::printf("tick of the window alone    %.3f ms\n", of_alone);
    std::printf("in an outer wind            %.3f ms, %.2f of it\n", of_inner, of_inner / of_alone);
    std::printf("tick of the outer wind      %.3f ms, %.2f of it\n", of_outer, of_outer / of_alone);
    std::printf("both, at 30 and 10 Hz       %.2f windows\n", (of_inner + of_outer / 3.0) / of_alone);
    return 0;
}
