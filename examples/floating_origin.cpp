// A host with a floating origin that traps floating-point faults, as some engines and languages do.
//
//     floating_origin     rides 600 m through a gusty wind, and prints what the rider feels each second
//
// 1. The rider stays near the origin, where floats are exact: whenever he is more than 100 m away, the host moves its world so that he
//    is near 0 again.
// 2. It moves all of its own places by that way, and calls shift_origin with it: box, wake, gust pattern and ground go along. The way
//    is whole cells, and best whole periods of the gusts, whose pattern then keeps its bits.
// 3. No air changes: the rider feels the same wind as in a world that never moves, which a second wind computes here.
//
// Divide by zero, invalid operations and overflow end this program where the C library can trap them (glibc).

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <windrow/fluid/wind.h>

namespace {

glm::dvec3 rider_at(double time) {
    return {12.0 * time, 1.0, 20.0 * std::sin(0.3 * time)};
}

windrow::Config config() {
    windrow::Config config;
    config.boundaries = windrow::Boundaries::open_over_floor();
    config.ambient = {5.0f, 0.0f, 1.0f};
    config.profile = windrow::LogProfile{};
    config.gusts = {.intensity = 0.2f};
    return config;
}

} // namespace

int main() {
#ifdef __GLIBC__
    feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
#endif
    auto floating = windrow::Wind::create(config()), fixed = windrow::Wind::create(config());
    if (!floating || !fixed)
        return std::fprintf(stderr, "%s\n", (floating ? fixed : floating).error().c_str()), 2;
    const windrow::WakeMotor wake{.position = rider_at(0.0), .radius = 0.8f};
    const auto rider = floating->motors().add(wake), rider_too = fixed->motors().add(wake);
    if (!rider || !rider_too)
        return 2;

    glm::dvec3 origin(0.0); // [m] place of the floating world's origin in the fixed one
    const double period = floating->ambient_wind().period();
    double worst = 0.0;
    for (int frame = 1; frame <= 3000; ++frame) {
        const glm::dvec3 place = rider_at(frame / 60.0);
        if (glm::dvec3 here = place - origin; std::abs(here.x) > 100.0) {
            const glm::dvec3 way(-period * std::round(here.x / period), 0.0, 0.0); // the rider's, to near the origin
            if (way.x != 0.0) {
                if (const auto moved = floating->shift_origin(way); !moved)
                    return std::fprintf(stderr, "%s\n", moved.error().c_str()), 1;
                origin -= way;
            }
        }
        const glm::dvec3 here = place - origin;
        if (!floating->motors().move(*rider, here) || !floating->follow(here) || !fixed->motors().move(*rider_too, place) ||
            !fixed->follow(place))
            return 1;
        floating->advance(1.0 / 60.0);
        fixed->advance(1.0 / 60.0);
        const glm::dvec3 beside(0.0, 0.5, 2.0);
        const glm::vec3 felt = floating->felt(here + beside, {}), truth = fixed->felt(place + beside, {});
        worst = std::max(worst, static_cast<double>(glm::length(felt - truth)));
        if (frame % 60 == 0)
            std::printf("%4.0f s   at %6.1f of %6.1f m   (%5.2f,%5.2f,%5.2f) m/s\n", frame / 60.0, here.x, place.x,
                        static_cast<double>(felt.x), static_cast<double>(felt.y), static_cast<double>(felt.z));
    }
    std::printf("The two worlds differ by %.1e m/s at most.\n", worst);
    return worst < 1e-3 ? 0 : 1;
}
