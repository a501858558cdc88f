// Storms: motors of 50 m/s in small cells, where speeds pass what all allowed sub-steps can carry.
//
// Such air is chaotic: whatever rounds otherwise parts ways. So a tick is held to its bound from a common start, and many ticks
// to what the CPU's own instruction sets come to between them; where it has one, to what a wind that is a rounding off comes to.
#include "tests/parity/wind_parity.h"

#include <random>

namespace windrow::vulkan {
namespace {

// 2 cells of 0.25 m in each of 2 parts of 1/30 s: 30 m/s at most.
Config storm_box(Simd simd) {
    return {.cells = {20, 14, 18},
            .cell_size = 0.25f,
            .boundaries = Boundaries::open_over_floor(),
            .ambient = {6.0f, 0.0f, -3.0f},
            .max_substeps = 2,
            .simd = simd};
}

std::vector<Motor> storm_motors() {
    return {DirectionalMotor{.position = {0.4, 0.2, 0.3},
                             .direction = {0.2f, 0.3f, 1.0f},
                             .region = Sphere{.radius = 1.0f},
                             .law = Drive{.speed = 50.0f, .rate = 30.0f}},
            DirectionalMotor{.position = {-1.2, -0.4, 0.1},
                             .direction = {1.0f, 0.1f, 0.0f},
                             .region = Sphere{.radius = 0.8f},
                             .law = Force{.acceleration = 900.0f}},
            VortexMotor{
                .position = {0.0, 0.0, -0.8}, .radius = 1.6f, .half_length = 1.0f, .law = Drive{.speed = 50.0f, .rate = 20.0f}},
            OmniMotor{.position = {1.0, 0.1, 1.2}, .radius = 0.5f, .speed = 50.0f}};
}

class WindStorms : public WindParity {
  protected:
    static std::vector<glm::vec4> start(std::size_t cells) {
        std::mt19937 random(11);
        std::uniform_real_distribution<float> speed(-45.0f, 45.0f);
        std::vector<glm::vec4> field(cells);
        for (glm::vec4& u : field)
            u = {speed(random), speed(random), speed(random), 0.0f};
        return field;
    }
};

// Both begin every second tick with the CPU's cells: the first tick without a past, the second with one.
TEST_F(WindStorms, AgreeTickByTick) {
    TwoWinds pair = make(storm_box(Simd::best));
    for (const Motor& motor : storm_motors())
        pair.add(motor);
    auto field = start(pair.cpu.box().cell_count());
    int capped = 0;
    for (int n = 0; n < 60; ++n) {
        if (n % 2 == 0)
            pair.set_velocity(field);
        Diagnostics cpu;
        frame_of(
            pair,
            [&](VkCommandBuffer commands, int slot) {
                held(pair.device.record_step(commands, {.dt = 1.0 / 30.0, .slot = slot}));
            },
            [&] { cpu = pair.cpu.step(1.0 / 30.0); });
        ASSERT_TRUE(std::isfinite(cpu.max_speed) && cpu.max_speed > 0.0f) << n;
        capped += cpu.substeps_capped ? 1 : 0;
        field.assign(pair.cpu.field().begin(), pair.cpu.field().end());
    }
    EXPECT_GT(capped, 30) << "no storm";
    report("storm_ticks", pair, 1e-4);
}

TEST_F(WindStorms, PartNoFasterThanTheCpusInstructionSetsDo) {
    std::vector<Simd> levels;
    for (const Simd level : {Simd::baseline, Simd::avx2, Simd::avx512})
        if (runs(level))
            levels.push_back(level);
    std::vector<Config> boxes;
    for (const Simd level : levels)
        boxes.push_back(storm_box(level));
    if (boxes.size() < 2) { // one level: a wind that is a unit in the last place off in every cell
        boxes.push_back(boxes.front());
        for (int axis = 0; axis < 3; ++axis)
            boxes.back().ambient[axis] = std::nextafter(boxes.back().ambient[axis], 100.0f);
    }
    std::vector<windrow::Wind> winds;
    for (const Config& box : boxes) {
        winds.push_back(*windrow::Wind::create(box));
        for (const Motor& motor : storm_motors())
            ASSERT_TRUE(winds.back().motors().add(motor));
    }
    TwoWinds pair = make(storm_box(levels.front()));
    for (const Motor& motor : storm_motors())
        pair.add(motor);
    double spread = 0.0, worst = 0.0, expected = 0.0; // the last: the spread a frame ago, when what is read back now was made
    for (int n = 0; n <= 200; ++n) {
        step(pair, 1.0 / 30.0);
        ASSERT_TRUE(std::isfinite(pair.last) && (n < 2 || pair.last > 0.0)) << n; // the first frame may agree to the bit
        if (n > 0 && expected > 0.0)
            worst = std::max(worst, pair.last / expected);
        for (windrow::Wind& wind : winds) {
            const Diagnostics diagnostics = wind.step(1.0 / 30.0);
            ASSERT_TRUE(std::isfinite(diagnostics.max_speed) && diagnostics.max_speed > 0.0f) << n;
        }
        for (std::size_t a = 0; a < winds.size(); ++a)
            for (std::size_t b = 0; b < a; ++b) {
                const double between = apart(winds[a].field(), winds[b].field());
                ASSERT_TRUE(std::isfinite(between)) << n;
                spread = std::max(spread, between);
            }
        expected = spread;
        if (n == 20 || n == 100 || n == 200)
            test::figure("wind_parity.storm_spread." + std::to_string(n), spread);
    }
    test::figure("wind_parity.storm_largest", pair.largest);
    // The CPU's instruction sets differ in the rounding of transport and pressure; the device also in that of drives and forces.
    WINDROW_EXPECT_FIGURE("wind_parity.storm_over_spread", worst, 30.0);
    EXPECT_GT(spread, 0.0);
    EXPECT_GT(worst, 0.0);
}

} // namespace
} // namespace windrow::vulkan
