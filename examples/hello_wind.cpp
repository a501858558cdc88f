// Tutorial: the wind beside a fan, in ten lines of the library.
//
//     hello_wind          prints the wind at three points, ten times over a second
//
// 1. Make a wind. Everything has a default: 32 x 16 x 32 cells of 1 m around the origin, open air on all sides. Here a light
//    breeze of 2 m/s blows along x.
// 2. Add a fan: a motor that pulls the air in a ball of 2 m toward 8 m/s along z, with 4/s: 63 % of the way in 1/4 s.
// 3. Step. A game steps at its tick rate; 1/60 s is what the library is tuned for.
// 4. Ask for the wind anywhere: at a leaf, a flag, a particle. Beyond the box it is the breeze.
//
// What to see: the fan's air settles in half a second, at less than 8 m/s because the breeze brings slow air all the time; the
// place before the fan feels the jet later; far away nothing changes.

#include <cstdio>
#include <windrow/fluid/wind.h>

int main() {
    windrow::Config config;
    config.ambient = {2.0f, 0.0f, 0.0f};
    auto wind = windrow::Wind::create(config);
    if (!wind) {
        std::fprintf(stderr, "%s\n", wind.error().c_str()); // says which field is wrong, and the fix
        return 2;
    }
    const auto fan = wind->motors().add(windrow::DirectionalMotor{.position = {0.0, 0.0, 0.0},
                                                                  .direction = {0.0f, 0.0f, 1.0f},
                                                                  .region = windrow::Sphere{2.0f},
                                                                  .law = windrow::Drive{8.0f, 4.0f}});
    if (!fan)
        return 2;

    const glm::dvec3 places[] = {{0.0, 0.0, 0.0}, {1.5, 0.0, 4.0}, {0.0, 0.0, 60.0}};
    std::printf("  time     in the fan            4 m before the fan     far away, beyond the box\n");
    for (int step = 1; step <= 60; ++step) {
        wind->step(1.0 / 60.0);
        if (step % 6 != 0)
            continue;
        std::printf("%5.2f s", step / 60.0);
        for (const glm::dvec3& place : places) {
            const glm::vec3 velocity = wind->velocity(place);
            std::printf("   (%5.2f,%5.2f,%5.2f)", static_cast<double>(velocity.x), static_cast<double>(velocity.y),
                        static_cast<double>(velocity.z));
        }
        std::printf(" m/s\n");
    }
    return 0;
}
