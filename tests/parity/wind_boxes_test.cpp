// A hundred steps of every motor in boxes of mixed sides that shift, at the sizes that the solver is held to.
#include "tests/parity/wind_parity.h"
#include "tests/tier.h"

namespace windrow::vulkan {
namespace {

struct BoxStory {
    const char* name;
    glm::ivec3 cells;
    int steps;
    double bound = 1e-5;
};

const int k_steps = test::whole_sweeps() ? 100 : 30; // a hundred on every run in scenarios_test.cpp

// Boundaries of every kind in two mixes, each with an axis that follows.
Config mixed_box(glm::ivec3 cells, bool floor) {
    Config config{.cells = cells, .ambient = {2.0f, 0.0f, 1.0f}};
    if (floor) { // x open and following, y ground and sky, z periodic
        config.boundaries = Boundaries::open_over_floor();
        config.boundaries.z_low.kind = config.boundaries.z_high.kind = BoundaryKind::periodic;
    } else { // x a moving wall and a slipping one, y a slipping ceiling, z open and following
        config.boundaries.x_low = {BoundaryKind::no_slip, {0.0f, 0.5f, 1.0f}};
        config.boundaries.x_high.kind = BoundaryKind::free_slip;
        config.boundaries.y_high.kind = BoundaryKind::free_slip;
    }
    return config;
}

class WindBoxes : public WindParity {
  protected:
    void live(const BoxStory& story, bool floor, bool ticks) {
        const Config config = mixed_box(story.cells, floor);
        TwoWinds pair = make(config);
        const glm::dvec3 reach = 0.25 * glm::dvec3(story.cells);
        pair.add(DirectionalMotor{.position = {0.5 * reach.x, 0.3, -0.5 * reach.z}, .direction = {-0.3f, 0.1f, 1.0f}});
        pair.add(DirectionalMotor{
            .position = {-reach.x, -0.5, reach.z}, .direction = {1.0f, 0.4f, 0.0f}, .law = Force{.acceleration = 15.0f}});
        pair.add(VortexMotor{.position = {-0.5 * reach.x, 0.0, 0.0}, .lift = 0.5f});
        pair.add(JetMotor{.position = {reach.x, 0.0, reach.z}, .direction = {-1.0f, 0.3f, -0.2f}});
        pair.add(OmniMotor{.position = {0.2, 0.4, 0.6 * reach.z}});
        pair.add(PressureMotor{.position = {-0.4 * reach.x, 0.7, -0.7 * reach.z}});
        const WakeMotor body{.position = {-reach.x, 0.0, -reach.z}, .radius = 1.0f};
        const auto ids = pair.add(body);
        for (int n = 0; n <= story.steps; ++n) { // one more, by which the last is read back
            const double t = static_cast<double>(n) / story.steps;
            pair.move(ids, body.position + t * glm::dvec3(2.0 * reach.x, 2.0, 2.0 * reach.z));
            pair.follow({5.3 * t, 0.0, -4.2 * t});
            if (ticks)
                frame(pair, 1.0 / 30.0);
            else
                step(pair, 1.0 / 30.0);
        }
        EXPECT_EQ(pair.compared, story.steps);
        EXPECT_NE(pair.cpu.origin(), windrow::Wind::create(config)->origin()) << "the box never moved";
        const std::string name = std::string(floor ? ".floor" : ".walls") + (ticks ? ".ticks." : ".steps.");
        report("box" + name + story.name, pair, story.bound);
    }
};

TEST_F(WindBoxes, OfSixteenCubed) {
    for (const bool floor : {true, false})
        for (const bool ticks : {true, false})
            live({"16x16x16", {16, 16, 16}, k_steps}, floor, ticks);
}

TEST_F(WindBoxes, OfTheDefault) {
    live({"32x16x32", {32, 16, 32}, k_steps}, true, true);
    live({"32x16x32", {32, 16, 32}, k_steps}, false, false);
}

TEST_F(WindBoxes, OfOddSizes) {
    for (const bool floor : {true, false})
        live({"17x9x23", {17, 9, 23}, k_steps}, floor, floor);
}

// The jet's way is long enough here to roll up: on the CPU alone a nozzle faster by 5e-6 ends 1.8e-5 apart.
TEST_F(WindBoxes, LongOfTwiceTheDefault) {
    live({"64x32x64", {64, 32, 64}, 100, 1e-4}, true, true);
}

// Planes that do not fit in 32 KiB of shared memory: x and z go apart.
TEST_F(WindBoxes, LongOfFourTimesTheDefault) {
    live({"128x64x128", {128, 64, 128}, test::k_sanitized ? 1 : 10}, false, false); // 5 s a step on a software driver
}

} // namespace
} // namespace windrow::vulkan
