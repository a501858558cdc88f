// Two and three frames in flight that nobody waits for, compared frame by frame as their read-backs come in.
#include "tests/parity/wind_parity.h"

namespace windrow::vulkan {
namespace {

class WindInFlight : public WindParity {
  protected:
    // The layer's experimental check of hazards between command buffers, which no call of Vulkan asks for.
    void SetUp() override {
        setenv("VK_LAYER_ENABLES", "VALIDATION_CHECK_ENABLE_SYNCHRONIZATION_VALIDATION_QUEUE_SUBMIT", 1);
        WindParity::SetUp();
        unsetenv("VK_LAYER_ENABLES");
    }
};

TEST_F(WindInFlight, EveryFrameIsTheCpus) {
    for (const int in_flight : {2, 3}) {
        TwoWinds pair = make({.cells = {24, 14, 20},
                              .boundaries = Boundaries::open_over_floor(),
                              .centre = {0.0, 7.0, 0.0},
                              .ambient = {3.0f, 0.0f, 1.0f},
                              .profile = LogProfile{},
                              .gusts = {.intensity = 0.25f}},
                             in_flight);
        pair.add(DirectionalMotor{.position = {4.0, 2.0, 1.0}, .direction = {-1.0f, 0.2f, 0.0f}});
        pair.add(PressureMotor{.position = {-3.0, 3.0, 2.0}});
        std::vector<glm::vec4> field(pair.cpu.box().cell_count(), glm::vec4(1.0f, 0.2f, -1.0f, 0.0f));
        for (int n = 0; n < 100; ++n) {
            pair.follow({0.06 * n, 0.0, -0.08 * n});
            if (n % 7 == 3)
                pair.set_ambient({2.0f + 0.01f * static_cast<float>(n), 0.0f, 1.5f});
            if (n == 30 || n == 31 || n == 32) { // each by its own cells
                field[static_cast<std::size_t>(n)].x = 4.0f;
                pair.set_velocity(field);
            }
            if (n >= 50 && n < 54) { // each by its own tables
                Boundaries boundaries = Boundaries::open_over_floor();
                if (n % 2 == 0)
                    boundaries.z_low.kind = boundaries.z_high.kind = BoundaryKind::periodic;
                pair.set_boundaries(boundaries);
            }
            if (n == 70)
                pair.set_gusts({.intensity = 0.3f, .seed = 4});
            frame(pair, 1.0 / 60.0);
        }
        test::figure("wind_parity.overlapped_" + std::to_string(in_flight), pair.submitter->overlapped());
        // A GPU may be done before the host has recorded the next.
        EXPECT_TRUE(pair.submitter->overlapped() > 0 || !own->facts().software) << "nothing was in flight";
        EXPECT_EQ(pair.compared, 100 - in_flight);
        report("in_flight_" + std::to_string(in_flight), pair, 1e-5);
        pair.submitter->wait();
    }
}

TEST_F(WindInFlight, EveryStepIsTheCpus) {
    TwoWinds pair = make({.cells = {16, 12, 18}, .ambient = {2.0f, 0.0f, 1.0f}, .viscosity = 1.0f}, 2);
    pair.add(VortexMotor{});
    for (int n = 0; n < 60; ++n) {
        pair.follow({0.1 * n, 0.05 * n, 0.0});
        step(pair, 1.0 / 40.0);
    }
    EXPECT_EQ(pair.compared, 58);
    report("steps_in_flight", pair, 1e-5);
    pair.submitter->wait();
}

// A query is as old as the frames in flight.
TEST_F(WindInFlight, TheAgeOfAQueryIsTold) {
    for (const int in_flight : {1, 2, 3}) {
        TwoWinds pair = make({.cells = {8, 8, 8}, .ambient = {2.0f, 0.0f, 1.0f}}, in_flight);
        pair.add(VortexMotor{});
        for (int n = 0; n < 12; ++n) {
            frame(pair, 1.0 / 50.0);
            EXPECT_NEAR(pair.device.query_age(), n < in_flight ? 0.0 : in_flight / 50.0, 1e-12) << n;
        }
        pair.submitter->wait();
    }
}

} // namespace
} // namespace windrow::vulkan
