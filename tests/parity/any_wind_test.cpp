// Random winds (tests/any_wind.h) on a device against the CPU: after each step cells, queries, forces on bodies and loads on
// plants; by steps or by frames of any length; and both saved and loaded in the middle.
//
// Bounds, over the fastest air (at least .3 m/s): 1e-4 of cells and queries, since sums of a solve are rounded otherwise; where two
// winds on the CPU that start one rounding apart differ by more than 1e-6, ten times their difference.
#include "fluid/wind_state.h"
#include "tests/any_wind.h"
#include "tests/parity/wind_parity.h"
#include "tests/tier.h"

#include <cmath>
#include <numeric>
#include <optional>

namespace windrow::vulkan {
namespace {

using test::Scenario;

class AnyWinds : public WindParity {
  protected:
    void SetUp() override { share_device(false); }

    static constexpr Settings k_settings{.texel = Texel::single, .gusts = true, .queries = ReadBack::cells, .forces = 8};
    static constexpr int k_steps = 16, k_saved_at = 8;
    static constexpr double k_least = 0.3; // [m/s]

    /// How a seed's wind goes on: by steps, or by frames, of equal or unequal length.
    struct Pace {
        bool frames = false, loads = false;
        int kind = 0;
        [[nodiscard]] double duration(int n) const {
            const double unequal = n % 3 == 0 ? 0.03 : 0.02;
            return kind == 0 ? test::k_scenario_step : kind == 1 ? 1.0 / 144.0 : unequal;
        }
    };
    /// Largest differences of a seed, over its fastest air and what that makes of forces.
    struct Off {
        double cells = 0.0, queries = 0.0, forces = 0.0, loads = 0.0;
        void note(double& largest, double off) const { largest = std::isnan(off) ? off : std::max(largest, off); }
    };

    void step(Wind& wind, double dt, bool frames) {
        run([&](VkCommandBuffer commands) {
            if (frames)
                (void)held(wind.record(commands, {.dt = dt, .slot = 0}));
            else
                (void)held(wind.record_step(commands, {.dt = dt, .slot = 0}));
        });
        (void)wind.collect(0);
    }

    static double fastest(std::span<const glm::vec4> field) {
        double most = k_least;
        for (const glm::vec4& u : field)
            most = std::max(most, static_cast<double>(glm::length(glm::vec3(u))));
        return most;
    }

    // Anywhere in the box and a little around it, more often low.
    static void compare_queries(const windrow::Wind& cpu, const Wind& device, double most, test::Chance& chance, Off& off) {
        const auto view = cpu.view();
        const auto on_device = device.queried();
        ASSERT_TRUE(on_device);
        const glm::dvec3 size(cpu.box().size()), low = cpu.window_block({0.0, 0.0, 0.0}).origin;
        for (int n = 0; n < 60; ++n) {
            const double x = chance.share(), y = chance.share(), z = chance.share();
            const glm::dvec3 at = low + size * (1.1 * glm::dvec3(x, y * y, z) - 0.05);
            off.note(off.queries, static_cast<double>(glm::length(view.velocity(at) - on_device->velocity(at))) / most);
        }
    }

    // `least`: the force of the fastest air on a cell; smaller forces are compared with that, since they are rounding.
    template <class Id>
    static void compare_forces(const windrow::Wind& cpu, const Wind& device, const Id& id, double least, double& largest) {
        const auto on_cpu = cpu.force_on(id), on_device = device.force_on(id);
        ASSERT_EQ(static_cast<bool>(on_cpu), static_cast<bool>(on_device)) << "one knows no force";
        if (!on_cpu)
            return;
        const double scale = std::max(static_cast<double>(glm::length(on_cpu->force)), least);
        const double off = static_cast<double>(glm::length(on_cpu->force - on_device->force)) / scale;
        largest = std::isnan(off) ? off : std::max(largest, off);
    }

    Off play(const Scenario& row, const Config& config, const Pace& pace, std::uint32_t seed) {
        Off off;
        auto cpu = windrow::Wind::create(config);
        auto device = Wind::create(own->host(), config, k_settings);
        EXPECT_TRUE(cpu && device);
        if (!cpu || !device)
            return off;
        row.begin(*cpu);
        row.begin(*device);
        test::Chance chance(seed);
        for (int n = 0; n < k_steps; ++n) {
            if (n == k_saved_at && pace.loads) {
                const auto bytes = cpu->save();
                auto same = windrow::Wind::load(*bytes);
                auto loaded = Wind::load(own->host(), *bytes, k_settings);
                EXPECT_TRUE(same && loaded);
                cpu = *std::move(same);
                device = *std::move(loaded);
            }
            row.step(*cpu, n);
            row.step(*device, n);
            const double dt = pace.duration(n);
            pace.frames ? (void)cpu->advance(dt) : (void)cpu->step(dt);
            step(*device, dt, pace.frames);
            const auto cells = device->cells();
            const auto field = pace.frames ? cpu->view().field() : cpu->field();
            EXPECT_TRUE(cells);
            if (!cells)
                return off;
            off.note(off.cells, apart(*cells, field, k_least));
            const double most = fastest(field), h = static_cast<double>(config.cell_size), pressure = most * most * h * h;
            compare_queries(*cpu, *device, most, chance, off);
            if (pace.frames) // of the last tick, which a frame without one does not read again
                continue;
            for (std::uint32_t slot = 0; slot < 4; ++slot)
                compare_forces(*cpu, *device, test::obstacle_id(slot), 0.6 * pressure, off.forces);
            for (std::uint32_t slot = 0; slot < 3; ++slot)
                compare_forces(*cpu, *device, DragId{.slot = slot, .generation = 1}, 0.1 * pressure, off.loads);
        }
        return off;
    }

    // How far two winds part whose air starts one rounding apart.
    static double by_chance(const Scenario& row, const Config& config, const Pace& pace) {
        auto one = windrow::Wind::create(config), other = windrow::Wind::create(config);
        row.begin(*one);
        row.begin(*other);
        double worst = 0.0;
        for (int n = 0; n < k_steps; ++n) {
            for (windrow::Wind* const wind : {&*one, &*other}) {
                row.step(*wind, n);
                pace.frames ? (void)wind->advance(pace.duration(n)) : (void)wind->step(pace.duration(n));
            }
            if (n == 0)
                for (glm::vec4& u : std::span<glm::vec4>(other->state().cells.air.velocity))
                    u.x = std::nextafter(u.x, 1e3f);
            worst = std::max(worst, apart(other->field(), one->field(), k_least));
        }
        return worst;
    }
};

TEST_F(AnyWinds, AreThoseOfTheCpu) {
    Off worst;
    int played = 0;
    std::vector<std::uint32_t> seeds{11, 12}; // boundaries that change beside bodies: forces, and a frame without a tick
    if (!test::k_sanitized)
        seeds.insert(seeds.end(), {3, 15});
    if (test::whole_sweeps() && !test::k_sanitized) {
        seeds.resize(200);
        std::iota(seeds.begin(), seeds.end(), 1u);
    }
    for (const std::uint32_t seed : seeds) {
        const Scenario row = test::AnyWind::scenario(seed);
        Config config;
        row.config(config);
        if (!validate(config))
            continue;
        const Pace pace{.frames = seed % 2 == 0, .loads = seed % 3 == 0, .kind = static_cast<int>(seed / 2 % 3)};
        const Off off = play(row, config, pace, seed);
        ++played;
        constexpr double k_bound = 1e-4;
        double bound = k_bound;
        if (!(off.cells <= bound) || !(off.queries <= bound)) {
            const double chance = by_chance(row, config, pace);
            bound = chance > 1e-6 ? 10.0 * chance : bound;
        }
        EXPECT_LE(off.cells, bound) << row.name;
        EXPECT_LE(off.queries, bound) << row.name;
        EXPECT_LE(off.forces, 20.0 * bound) << row.name;
        EXPECT_LE(off.loads, 10.0 * bound) << row.name;
        if (bound > k_bound)
            continue;
        worst.cells = std::max(worst.cells, off.cells);
        worst.queries = std::max(worst.queries, off.queries);
        worst.forces = std::max(worst.forces, off.forces);
        worst.loads = std::max(worst.loads, off.loads);
    }
    EXPECT_GT(4 * played, 3 * static_cast<int>(seeds.size())) << "winds that no config allows";
    WINDROW_EXPECT_FIGURE("any_winds.cells", worst.cells, 1e-4);
    WINDROW_EXPECT_FIGURE("any_winds.queries", worst.queries, 1e-4);
    WINDROW_EXPECT_FIGURE("any_winds.forces", worst.forces, 2e-3);
    WINDROW_EXPECT_FIGURE("any_winds.loads", worst.loads, 1e-3);
}

} // namespace
} // namespace windrow::vulkan
