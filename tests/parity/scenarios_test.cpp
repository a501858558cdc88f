// The scenario table on a device against the CPU, with all defaults: a hundred steps on end, and twelve from a common start.
//
// Bounds, over the largest component of the CPU's velocity: 1e-4 after 100 steps; 1e-5 after 12 steps from a common start, which
// the CPU saved and both loaded. Where two runs on the CPU that start one rounding apart differ by more than 1e-6 (a chaotic row),
// ten times their difference; at most a twentieth of the rows may be so.
#include "fluid/wind_state.h"
#include "tests/parity/wind_parity.h"
#include "tests/scenarios.h"
#include "tests/tier.h"

#include <array>
#include <cmath>

namespace windrow::vulkan {
namespace {

using test::Scenario;

std::vector<Scenario> table() {
    std::vector<Scenario> rows = test::scenarios(test::whole_sweeps());
    for (Scenario& row : test::matrix_of_motion(test::whole_sweeps() ? 1 : 7))
        rows.push_back(std::move(row));
    for (Scenario& row : test::random_scenarios(test::whole_sweeps() ? 40 : 4))
        rows.push_back(std::move(row));
    return rows;
}

Config config_of(const Scenario& row) {
    Config config = test::scenario_config();
    if (row.config)
        row.config(config);
    return config;
}

class WindScenarios : public WindParity, public testing::WithParamInterface<Scenario> {
  protected:
    // Other tests run each kind of pass under the validation layer, which takes half of the time.
    void SetUp() override { share_device(false); }

    static constexpr Settings k_settings{.texel = Texel::single, .queries = ReadBack::cells};

    static void act(const Scenario& row, WindControl& wind, int n) {
        if (row.step)
            row.step(wind, n);
    }

    void step(Wind& wind) {
        run([&](VkCommandBuffer commands) { (void)held(wind.record_step(commands, {.dt = test::k_scenario_step, .slot = 0})); });
        (void)wind.collect(0);
    }

    // Steps of both, and how far apart they are then.
    double together(const Scenario& row, windrow::Wind& cpu, Wind& on_device, int first, int count) {
        for (int n = first; n < first + count; ++n) {
            act(row, cpu, n);
            act(row, on_device, n);
            (void)cpu.step(test::k_scenario_step);
            step(on_device);
        }
        const auto cells = on_device.cells();
        EXPECT_TRUE(cells) << cells.error();
        return cells ? apart(*cells, cpu.field()) : std::nan("");
    }

    // How far two winds part that start one rounding apart.
    static double by_chance(const Scenario& row, std::span<const std::byte> bytes, int first, int count) {
        auto one = windrow::Wind::load(bytes), other = windrow::Wind::load(bytes);
        EXPECT_TRUE(one && other);
        for (glm::vec4& u : std::span<glm::vec4>(other->state().cells.air.velocity))
            u.x = std::nextafter(u.x, 1e3f);
        for (int n = first; n < first + count; ++n)
            for (windrow::Wind* const wind : std::array{&*one, &*other}) {
                act(row, *wind, n);
                (void)wind->step(test::k_scenario_step);
            }
        return apart(other->field(), one->field());
    }
};

TEST_P(WindScenarios, AreThoseOfTheCpu) {
    const Scenario& row = GetParam();
    const Config config = config_of(row);
    auto cpu = windrow::Wind::create(config);
    auto gpu = Wind::create(sharing_host(), config, k_settings);
    ASSERT_TRUE(cpu) << cpu.error();
    ASSERT_TRUE(gpu) << gpu.error();
    if (row.begin) {
        row.begin(*cpu);
        row.begin(*gpu);
    }
    constexpr int k_apart = 12;
    double from_common_start = 0.0;
    // Other tiers take the first of its steps, and start both from what there is after twelve, and of late rows each forty on.
    const int steps = test::k_sanitized ? 8 : test::whole_sweeps() || row.late ? row.steps : std::min(row.steps, 24);
    const int first = test::whole_sweeps() || steps <= k_apart ? 0 : k_apart, every = test::whole_sweeps() ? k_apart : 40;
    for (int n = 0; n < steps;) {
        if (n % every == first) {
            const auto bytes = cpu->save();
            ASSERT_TRUE(bytes);
            auto same = windrow::Wind::load(*bytes);
            auto loaded = Wind::load(sharing_host(), *bytes, k_settings);
            ASSERT_TRUE(same && loaded) << loaded.error();
            const double off = together(row, *same, *loaded, n, k_apart);
            from_common_start = std::max(from_common_start, off);
            const double chance = row.chaotic ? by_chance(row, *bytes, n, k_apart) : 0.0;
            EXPECT_LE(off, chance > 1e-6 ? 10.0 * chance : 1e-5) << "after step " << n;
        }
        const double off = together(row, *cpu, *gpu, n, 4);
        n += 4;
        if (n == steps) {
            WINDROW_EXPECT_FIGURE("wind_scenarios." + std::to_string(steps) + "_steps." + row.name, off, 1e-4);
        }
    }
    WINDROW_EXPECT_FIGURE("wind_scenarios.from_a_common_start." + row.name, from_common_start, row.chaotic ? 1.0 : 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Table, WindScenarios, testing::ValuesIn(table()),
                         [](const testing::TestParamInfo<Scenario>& row) { return row.param.name; });

TEST(WindScenarioTable, HasFewChaoticRows) {
    const auto rows = table();
    const auto chaotic = std::count_if(rows.begin(), rows.end(), [](const Scenario& row) { return row.chaotic; });
    EXPECT_LE(20 * chaotic, static_cast<std::ptrdiff_t>(rows.size()));
}

} // namespace
} // namespace windrow::vulkan
