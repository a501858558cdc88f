// windrow_tick_bench STEPS: a wind of 32 x 16 x 32 cells with gusts and a jet, at the baseline level; prints a hash of its cells.
//
// Built for this machine and as WebAssembly; tests/web/tick_cost.py compares their CPU time by two runs each.
#include "fluid/core/bytes.h"
#include "fluid/wind.h"

#include <cstdio>
#include <cstdlib>
#include <span>

int main(int argc, char** argv) {
    const int steps = argc > 1 ? std::atoi(argv[1]) : 100;
    auto wind = windrow::Wind::create({.boundaries = windrow::Boundaries::open_over_floor(),
                                       .ambient = {3.0f, 0.0f, 1.0f},
                                       .gusts = {.intensity = 0.3f, .length = 10.0f},
                                       .simd = windrow::Simd::baseline});
    if (!wind)
        return std::puts(wind.error().c_str()), 2;
    if (!wind->motors().add(windrow::JetMotor{.position = {-6.0, 1.2, 0.0}, .law = windrow::Drive{.speed = 10.0f, .rate = 8.0f}}))
        return 2;
    for (int step = 0; step < steps; ++step)
        (void)wind->step(1.0 / 30.0);
    std::printf("%d steps %llx\n", steps,
                static_cast<unsigned long long>(windrow::detail::checksum(std::as_bytes(wind->field()))));
    return 0;
}
