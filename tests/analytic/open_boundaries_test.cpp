// Open sides: what blows out is gone, what blows in is the ambient wind, and still air gains nothing.
//
// A puff in a wind U crosses a box of length L in L / U; after three crossings less than 2 % of its peak may remain. In still air
// the energy about the ambient wind may never exceed 1.001 of the start, without force and whatever the flow through the sides.
#include "figures.h"
#include "flows.h"

namespace windrow {
namespace {

using namespace flows;
using figures::expect_at_least;
using figures::expect_at_most;

TEST(OpenSides, AScalarPuffLeaves) {
    const Box box{.cells = {32, 16, 32}, .boundaries = Boundaries::open_over_floor()};
    const glm::vec3 ambient(4.0f, 0.0f, 1.5f);
    Workspace work = workspace(box, ambient);
    const Field wind(box.cell_count(), glm::vec4(ambient, 0.0f));
    for (const Interpolation interpolation : {Interpolation::linear, Interpolation::cubic}) {
        auto smoke = scalars_of(
                 box,
                 [](glm::dvec3 x) { return std::exp(-glm::dot(x - glm::dvec3(16, 5, 16), x - glm::dvec3(16, 5, 16)) / 18.0); }),
             next = smoke;
        double at_one = 0.0;
        for (int step = 1; step <= 240; ++step) {
            EXPECT_TRUE(advect(
                work, ScalarTransport{.carried = smoke, .velocity = wind, .dt = 0.1f, .interpolation = interpolation}, next));
            std::swap(smoke, next);
            if (step == 20) // half a crossing: the middle of the puff is at the side
                at_one = *std::max_element(smoke.begin(), smoke.end());
        }
        const std::string name = std::string("open_sides.smoke_") + (interpolation == Interpolation::linear ? "linear" : "cubic");
        expect_at_least(name + ".at_half_a_crossing", at_one, 0.2);
        expect_at_most(name + ".after_three_crossings", *std::max_element(smoke.begin(), smoke.end()), 0.02);
    }
}

// Two puffs of wind: a ring that turns on itself, and a gust along the mean wind with a pressure of its own.
TEST(OpenSides, APuffOfWindLeaves) {
    for (const Boundaries& boundaries : {Boundaries::all(BoundaryKind::open), Boundaries::open_over_floor()})
        for (const Scheme scheme : {Scheme::second_order, Scheme::stable_fluids})
            for (const int kind : {0, 1}) {
                Config config{.boundaries = boundaries, .ambient = {4.0f, 0.0f, 1.0f}, .relaxation_time = 0.0f, .scheme = scheme};
                Wind wind = *Wind::create(config);
                wind.set_velocity([&](glm::dvec3 x) {
                    const double bump = std::exp(-glm::dot(x, x) / 18.0);
                    return config.ambient + glm::vec3(bump * (kind == 0 ? glm::dvec3(-x.z, 0.5 * x.z, x.x - 0.5 * x.y)
                                                                        : glm::dvec3(2.0, 0.3, -1.0)));
                });
                const double peak = largest_off(wind.field(), config.ambient);
                take_steps(wind, 240, 0.1);
                expect_at_most(
                    std::string("open_sides.puff_after_three_crossings.") + (boundaries.y_low.solid() ? "floor." : "open.") +
                        (scheme == Scheme::second_order ? "second_order." : "stable_fluids.") + (kind == 0 ? "ring" : "gust"),
                    largest_off(wind.field(), config.ambient) / peak, 0.02);
            }
}

// Sum of |u - ambient|^2.
double energy_about_ambient(const Wind& wind) {
    double sum = 0.0;
    for (const glm::vec4& u : wind.field()) {
        const glm::dvec3 off = glm::dvec3(u) - glm::dvec3(wind.ambient());
        sum += glm::dot(off, off);
    }
    return sum;
}

// Largest energy of a run over that of its start.
double largest_energy(Wind& wind, int steps, double dt) {
    const double first = energy_about_ambient(wind);
    double largest = 0.0;
    for (int step = 0; step < steps; ++step) {
        wind.step(dt);
        if (step < 100 || step % 10 == 0)
            largest = std::max(largest, energy_about_ambient(wind));
    }
    return largest / first;
}

TEST(OpenSides, AirWithoutForceGainsNoEnergy) {
    const std::pair<const char*, Boundaries> boxes[] = {{"open", Boundaries::all(BoundaryKind::open)},
                                                        {"over_floor", Boundaries::open_over_floor()}};
    for (const auto& [name, boundaries] : boxes)
        for (const glm::vec3 ambient : {glm::vec3(0.0f), glm::vec3(2.0f, 0.0f, 1.0f)})
            for (const bool noise : {false, true}) {
                Config config{.boundaries = boundaries, .ambient = ambient, .relaxation_time = 0.0f};
                Wind wind = *Wind::create(config);
                Random random(3);
                wind.set_velocity([&](glm::dvec3 x) {
                    return ambient + glm::vec3(noise
                                                   ? random.point(1.0)
                                                   : glm::dvec3(std::sin(0.4 * x.y + 0.3 * x.z), std::sin(0.5 * x.x + 0.2 * x.z),
                                                                std::cos(0.3 * x.x + 0.6 * x.y)));
                });
                expect_at_most(std::string("open_sides.largest_energy.") + name + (ambient.x > 0.0f ? ".wind" : ".still") +
                                   (noise ? ".noise" : ".smooth"),
                               largest_energy(wind, 900, 1.0 / 60.0), 1.001);
            }
}

// The air of the box is slower or faster than the wind around it: the new wind must blow in, not drive the air ever faster.
TEST(OpenSides, ANewAmbientWindBlowsIn) {
    for (const Scheme scheme : {Scheme::second_order, Scheme::stable_fluids})
        for (const float share : {0.5f, 1.5f}) {
            Config config{.relaxation_time = 0.0f, .scheme = scheme};
            Wind wind = *Wind::create(config);
            const glm::vec3 ambient(3.0f, 0.0f, 1.0f);
            EXPECT_TRUE(wind.set_ambient(ambient));
            wind.set_velocity([&](glm::dvec3) { return share * ambient; });
            const std::string name =
                std::string(scheme == Scheme::second_order ? ".second_order." : ".stable_fluids.") + figures::number_text(share);
            expect_at_most("open_sides.new_ambient.largest_energy" + name, largest_energy(wind, 1200, 1.0 / 30.0), 1.001);
            expect_at_most("open_sides.new_ambient.off_after_40_s" + name,
                           largest_off(wind.field(), ambient) / static_cast<double>(glm::length(ambient)), 0.02);
        }
}

} // namespace
} // namespace windrow
