// The commands on a Vulkan device: the wind that they see is the CPU's to rounding, and what they report is of the step just
// made.
#include "cases/backend_wind.h"
#include "cases/verify_case.h"
#include "cli/backend.h"
#include "cli/console.h"
#include "tests/figure.h"
#include "tests/tier.h"
#include "tests/unit/command_outcome.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace windrow::cli {

using namespace cases;

namespace {

double apart(std::span<const glm::vec4> a, std::span<const glm::vec4> b) {
    double worst = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n)
        for (int axis = 0; axis < 3; ++axis)
            if (const double off = std::abs(static_cast<double>(a[n][axis]) - b[n][axis]); !(off <= worst))
                worst = off; // a NaN stays
    return a.size() == b.size() ? worst : std::nan("");
}

class OnDevice : public testing::Test {
  protected:
    void SetUp() override {
        const Fault fault = open_backend({.kind = BackendKind::vulkan}, device);
        ASSERT_FALSE(fault) << fault.sentence;
    }
    [[nodiscard]] std::unique_ptr<BackendWind> wind_on(const Backend& backend, const Config& config) const {
        auto wind = BackendWind::create(config, backend, BackendClock::on);
        EXPECT_TRUE(wind) << wind.error();
        return *std::move(wind);
    }

    Backend cpu, device;
};

TEST_F(OnDevice, TheWindAndItsReportAreTheCpusAtEachStep) {
    const Config config{.cells = {16, 12, 20}, .boundaries = Boundaries::open_over_floor(), .ambient = {3.0f, 0.0f, 1.0f}};
    const auto here = wind_on(cpu, config), there = wind_on(device, config);
    ASSERT_TRUE(here && there);
    EXPECT_EQ(apart(here->field(), there->field()), 0.0); // before any step
    for (const auto& wind : {here.get(), there.get()})
        ASSERT_TRUE(wind->motors().add(DirectionalMotor{.direction = {0.0f, 0.0f, 1.0f}, .law = Force{8.0f}}));
    double worst = 0.0, speed = 0.0, energy = 0.0;
    for (int step = 1; step <= 40; ++step) {
        for (const auto& wind : {here.get(), there.get()})
            ASSERT_TRUE(wind->follow({0.1 * step, 0.0, -0.07 * step}));
        const Diagnostics a = here->step(1.0 / 30.0), b = there->step(1.0 / 30.0);
        EXPECT_TRUE(b.stepped);
        EXPECT_EQ(a.motors_in_reach, b.motors_in_reach);
        EXPECT_EQ(a.substeps, b.substeps);
        EXPECT_GT(b.times_ms.total, 0.0);
        EXPECT_GT(b.times_ms.advection, 0.0);
        EXPECT_GT(b.times_ms.projection, 0.0);
        EXPECT_LE(b.times_ms.sources + b.times_ms.diffusion + b.times_ms.advection + b.times_ms.projection + b.times_ms.report,
                  b.times_ms.total);
        EXPECT_EQ(here->origin(), there->origin());
        const double off = apart(here->field(), there->field());
        ASSERT_TRUE(std::isfinite(off));
        worst = std::max(worst, off);
        ASSERT_TRUE(std::isfinite(b.max_speed) && std::isfinite(b.energy));
        speed = std::max(speed, std::abs(static_cast<double>(a.max_speed) - b.max_speed));
        energy = std::max(energy, std::abs(b.energy / a.energy - 1.0));
        const glm::dvec3 leaf(1.3, 0.4, -0.2);
        EXPECT_LT(glm::length(here->velocity(leaf) - there->velocity(leaf)), 1e-4f);
    }
    WINDROW_EXPECT_FIGURE("command_wind.device_off_cpu", worst, 5e-5); // [m/s] of 6
    WINDROW_EXPECT_FIGURE("command_wind.device_speed", speed, 5e-5);
    WINDROW_EXPECT_FIGURE("command_wind.device_energy", energy, 1e-5);
}

TEST_F(OnDevice, WhatIsAskedBetweenStepsShowsAtOnce) {
    const auto wind = wind_on(device, {.cells = {8, 8, 8}, .ambient = {1.0f, 0.0f, 0.0f}});
    ASSERT_TRUE(wind);
    wind->set_velocity([](glm::dvec3 x) { return glm::vec3(x.y, 2.0, -1.0); });
    EXPECT_EQ(wind->field()[0], glm::vec4(-3.5f, 2.0f, -1.0f, 0.0f));
    ASSERT_TRUE(wind->follow({0.0, 2.0, 0.0}));
    EXPECT_EQ(wind->origin().y, -2.0);
    EXPECT_EQ(wind->view().origin().y, -2.0);
    EXPECT_EQ(wind->field()[0], glm::vec4(-1.5f, 2.0f, -1.0f, 0.0f));
    wind->reset();
    EXPECT_EQ(wind->field()[0], glm::vec4(1.0f, 0.0f, 0.0f, 0.0f));
}

TEST_F(OnDevice, SleepKeepsTheBoxWhereItIs) {
    const auto wind = wind_on(device, {.cells = {8, 8, 8}, .ambient = {1.0f, 0.0f, 0.0f}});
    ASSERT_TRUE(wind);
    for (int step = 0; step < 6; ++step)
        EXPECT_TRUE(wind->step(0.1).stepped);
    EXPECT_TRUE(wind->step(0.1).asleep);
    ASSERT_TRUE(wind->follow({40.0, 0.0, 0.0}));
    EXPECT_EQ(wind->view().origin(), wind->origin());
    EXPECT_EQ(wind->step(0.1).asleep, true);
    EXPECT_EQ(wind->view().origin(), wind->origin());
}

CommandOutcome run(std::vector<const char*> arguments) {
    return run_windrow(std::move(arguments));
}

// At the coarsest resolution of each: implicit diffusion of r = 1e4, whose systems are singular to floats, projections, motors,
// whole steps.
TEST_F(OnDevice, VerifyHoldsTheCpusBounds) {
    std::vector<std::string> names = {"diffusion_modes",   "couette_implicit", "stokes_second_one_pass", "solenoidal_stays",
                                      "gradient_vanishes", "taylor_green_2d",  "force_momentum",         "source_flux"};
    const VerifySetting setting{.backend = device};
    if (!windrow::test::whole_sweeps()) // implicit systems by the first, forces by rows of WindScenarios
        names = {"diffusion_modes", "gradient_vanishes", "taylor_green_2d", "source_flux"};
    std::size_t found = 0;
    for (const VerifyCase& one : verify_cases())
        if (std::find(names.begin(), names.end(), one.name) != names.end()) {
            ++found;
            const auto known = not_met();
            const bool misses =
                std::any_of(known.begin(), known.end(), [&](const NotMet& miss) { return miss.name == one.name; });
            const VerifyRows on_device = one.run(setting, one.sizes.front());
            const VerifyRows on_cpu = misses ? one.run({}, one.sizes.front()) : on_device;
            for (std::size_t n = 0; n < on_device.rows.size(); ++n) {
                const VerifyRow& row = on_device.rows[n];
                const double most = misses ? 1.001 * on_cpu.rows[n].error : row.bound;
                EXPECT_LE(row.error, most) << one.name << " " << row.label;
            }
        }
    EXPECT_EQ(found, names.size());
    EXPECT_EQ(device.fault(), "");
}

TEST_F(OnDevice, VerifyNamesTheDevice) {
    const CommandOutcome verified = run({"verify", "--backend", "vulkan", "--case", "gradient_vanishes"});
    EXPECT_EQ(verified.code, k_exit_well) << verified.out << verified.err;
    EXPECT_NE(verified.out.find("Vulkan 1."), std::string::npos) << verified.out;
}

TEST_F(OnDevice, ANumberThatNoDeviceHasIsWrongUse) {
    for (const char* command : {"run", "verify"}) {
        std::vector<const char*> words = {command, "--backend", "vulkan", "--device", "63"};
        const std::string scene = WINDROW_SOURCE_DIR "/examples/scenes/still.json";
        if (words[0] == std::string("run"))
            words.push_back(scene.c_str());
        const CommandOutcome rejected = run(words);
        EXPECT_EQ(rejected.code, k_exit_wrong_use);
        EXPECT_NE(rejected.err.find("--device is 63, and this machine has"), std::string::npos) << rejected.err;
    }
}

} // namespace
} // namespace windrow::cli
