// A box that moves in every step, near and far: what it leaves behind is gone, what it meets is the wind outside.

#include "tests/stability/watch.h"

namespace {

using namespace windrow;
using namespace windrow::test;

constexpr glm::ivec3 k_moving_cells(20, 12, 16);

TEST(MovingWindow, AShiftInEveryStep) {
    Wind wind = made({.cells = k_moving_cells, .ambient = {5.0f, 1.0f, -3.0f}});
    drive(wind, {0.0, 0.0, 0.0}, {-1.0f, 0.3f, 0.0f}, 30.0f, 4.0f);
    Watch watch(wind, 30.0);
    Random random(35);
    for (int n = 0; n < shortened(10'000); ++n) {
        EXPECT_TRUE(wind.follow(random.point(n % 2 == 0 ? 4.0 : 12.0)));
        watch.step(n % 3 == 0 ? 0.1 : 1.0 / 60.0);
    }
    watch.judge("shift_every_step", {k_input_energy, k_opposed_factor});
}

// Gusts ride on the mean wind: the strongest is the mean times intensity times the longest vector of the tile.
double strongest(const Wind& wind) {
    const Gusts& gusts = wind.config().gusts;
    const glm::vec3 mean = wind.ambient();
    const double level = std::hypot(static_cast<double>(mean.x), static_cast<double>(mean.z));
    const auto tile = GustTile::bake(gusts.seed);
    return glm::length(glm::dvec3(mean)) + static_cast<double>(gusts.intensity) * level * static_cast<double>(tile->bound());
}

struct WindowJump {
    const char* name;
    double metres;
    bool always; ///< in every step, or in every tenth with small shifts between
};

// A whole gust tile is 256 m; 10^12 cells is where `follow` ends, a double there tells 0.1 mm apart.
TEST(MovingWindow, GustsAndJumpsOfAnyLength) {
    for (const WindowJump jump :
         {WindowJump{"3_m", 3.0, true}, {"30_m", 30.0, true}, {"1e6_m", 1e6, true}, {"1e11_m", 1e11, false}})
        for (const bool floor : {false, true}) {
            Wind wind = made({.cells = k_moving_cells,
                              .boundaries = floor ? Boundaries::open_over_floor() : Boundaries{},
                              .ambient = {12.0f, 0.0f, -5.0f},
                              .gusts = {.intensity = 0.5f}});
            drive(wind, {1.0, 0.0, 2.0}, {-1.0f, 0.3f, 0.0f}, 30.0f, 3.0f);
            // What is solved is the wind less its gusts, driven toward the target: the sum of both may come out.
            Watch watch(wind, 30.0 + 2.0 * strongest(wind));
            Random random(52);
            glm::dvec3 at(0.0);
            for (int n = 0; n < shortened(1'000); ++n) {
                const bool far = jump.always || n % 10 == 0;
                // A walk; the box comes home at times, where the fan is.
                at = n % 5 == 0 ? random.point(2.0) : at + random.point(far ? jump.metres : 2.0);
                ASSERT_TRUE(wind.follow(at));
                if (floor) {
                    ASSERT_TRUE(wind.set_floor(random.real(-3.0, 3.0)));
                }
                watch.step(n % 3 == 0 ? 0.1 : 1.0 / 60.0);
            }
            watch.judge(std::string("gusts_jumps_") + jump.name + (floor ? "_over_floor" : ""),
                        {k_input_energy, k_opposed_factor});
        }
}

// Nothing acts but the wind outside and the shifts: the box can hold nothing that the wind did not bring.
TEST(MovingWindow, GustsAloneStayGusts) {
    Wind wind =
        made({.cells = k_moving_cells, .ambient = {12.0f, 0.0f, -5.0f}, .gusts = {.intensity = 0.5f}, .sleep_speed = 0.0f});
    Watch watch(wind, strongest(wind));
    Random random(53);
    for (int n = 0; n < shortened(1'500); ++n) {
        ASSERT_TRUE(wind.follow(random.point(n % 50 == 0 ? 1e7 : 5.0)));
        watch.step(1.0 / 60.0);
    }
    watch.judge("gusts_alone", {k_input_energy, 1.0 + 1e-5}); // given, not solved: exact but for rounding
}

} // namespace
