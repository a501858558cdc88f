// Still air: a puff, sleep, a snapshot of the sleeping air, a walk while it sleeps, a jet that wakes it, sleep again.
#include "fluid/wind.h"
#include "tests/bits/stories.h"

namespace windrow::bits {

std::vector<Hash> night(Simd level, ParallelFor parallel_for) {
    Hashes hashes("night");
    Wind wind = must(Wind::create({.cells = {21, 11, 18},
                                   .cell_size = 0.8f,
                                   .boundaries = Boundaries::open_over_floor(),
                                   .relaxation_time = 0.25f,
                                   .sleep_speed = 0.01f,
                                   .simd = level,
                                   .parallel_for = parallel_for}));
    std::vector<std::uint8_t> asleep;
    for (int frame = 0; frame < 240; ++frame) {
        if (frame == 2)
            (void)must(wind.motors().add(PressureMotor{.position = {1.0, 1.0, 1.0}, .speed = 6.0f, .duration = 0.05f}));
        if (frame == 120)
            (void)must(wind.motors().add(
                JetMotor{.position = {2.0, 1.0, 0.0}, .envelope = {.attack = 0.1f, .hold = 0.2f, .decay = 0.1f}}));
        if (frame >= 100 && frame < 140)
            must(wind.follow({0.1 * (frame - 100), 0.0, 0.0}));
        if (frame == 110) {
            must(wind.set_floor(0.8));
            const std::vector<std::byte> saved = must(wind.save());
            hashes.add("snapshot/asleep", saved);
            wind = must(Wind::load(saved, parallel_for));
        }
        asleep.push_back(wind.advance(1.0 / 40.0).last.asleep ? 1 : 0);
        if (frame == 10 || frame == 130)
            hashes.add("cells/" + std::to_string(frame), std::as_bytes(wind.field()));
    }
    if (asleep[99] == 0 || asleep[130] != 0 || asleep.back() == 0)
        give_up("the air of the night does not sleep when it should");
    hashes.add("asleep", asleep);
    return hashes.list();
}

} // namespace windrow::bits
