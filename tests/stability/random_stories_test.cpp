// Any sequence of calls: always finite, never faster nor with more energy than what was put in allows (input.h),
// reported as it was, the same bits on one and on three threads, saved and loaded or not; and without forces never more energy
// than at the start. What fails is shrunk and printed as C++, to be kept in told_stories_test.cpp.
//
// The seed is fixed so that a run can be repeated; RC_PARAMS="seed=0 max_success=10000" asks for more.

#include "fluid/operators.h"
#include "tests/stability/random_story.h"
#include "tests/stability/story.h"
#include "tests/stability/watch.h"

#include <cstdlib>
#include <rapidcheck.h>

namespace {

using namespace windrow;
using namespace windrow::test;

template <class Property>
bool check(const std::string& claim, Property property) {
    const std::string params = "seed=20240229 max_success=" + std::to_string(sampled(500, 60));
    ::setenv("RC_PARAMS", params.c_str(), 0); // read at the first
    return rc::check(claim, property);
}

/// The worst of all stories of a property.
struct Tally {
    int steps = 0;
    double energy = 0.0, max = 0.0;

    void tell(const Story& story, const Claims& claims = {}) {
        const StoryOutcome outcome = windrow::test::tell(story, claims);
        if (!outcome.fault.empty())
            RC_FAIL(outcome.fault);
        steps += outcome.steps;
        energy = std::max(energy, outcome.energy);
        max = std::max(max, outcome.max);
    }
    /// A bound of 0: the speed has none.
    void print(const std::string& name, GrowthBounds bounds) const {
        const std::string full = "stability/" + name + '/' + std::to_string(steps) + "_steps/";
        EXPECT_GT(steps, 0);
        figure(full + "energy", energy, bounds.energy);
        bounds.max > 0.0 ? figure(full + "max", max, bounds.max) : figure(full + "max", max);
    }
};

TEST(RandomStories, StayWithinWhatWasPutIn) {
    Tally tally;
    EXPECT_TRUE(check("whatever happens, the air stays within what was put in", [&] { tally.tell(*any_story()); }));
    tally.print("random_stories", {k_input_energy, k_speed_factor});
}

// --- Without forces ------------------------------------------------------------------------------------------------------

// Most energy over the start's with open boundaries, ProjectingAddsNoEnergy: of one projection, and of any number of them.
constexpr double k_open_projection = 1.032 * 1.032, k_open_projections = 2.2 * 2.2;

void gains_no_energy(Tally& tally, Config (*config)(), double max_cells) {
    const Story story = *calm_story(config, max_cells);
    auto wind = Wind::create(story.config);
    RC_ASSERT(wind.has_value());
    // Else there is nothing but rounding to compare with: a box one cell across may hold no wind at all.
    const Field start = white_noise(story.config.cells, 1.0f, story.start.seed);
    RC_PRE(energy_of(projected(start, wind->box())) > 1e-6 * energy_of(start));
    // Two cases show what a projection with open boundaries adds (below): a wall a few cells off, 1 to 12 % in columns of 5 cells,
    // and boundaries that change, 0.7 %.
    const glm::ivec3 cells = story.config.cells;
    const bool shown = std::min({cells.x, cells.y, cells.z}) < 12 ||
                       std::any_of(story.events.begin(), story.events.end(),
                                   [](const story::Event& event) { return std::holds_alternative<story::ChangeSides>(event); });
    tally.tell(story, {.energy_of_start = shown ? k_open_projections : 1.001});
}

// Linear weights average: no box is too small and no step too long.
TEST(RandomStories, LinearOnesGainNoEnergyByThemselves) {
    const auto config = [] {
        Config linear = any_config();
        linear.interpolation = Interpolation::linear;
        return linear;
    };
    Tally tally;
    EXPECT_TRUE(check("linear: energy never above 1.001 of the start, 4.84 where projections show",
                      [&] { gains_no_energy(tally, config, 10.0); }));
    tally.print("random_calm_linear", {k_open_projections, 0.0});
}

// Cubic weights overshoot: the bound is asked where waves of several cells fit and the air crosses two cells a part at most, as
// by default.
TEST(RandomStories, CubicOnesGainNoEnergyByThemselves) {
    const auto config = [] {
        Config cubic = any_config();
        if (cubic.interpolation == Interpolation::linear)
            cubic.interpolation = Interpolation::cubic;
        cubic.cells = {pick(12, 20), pick(12, 20), pick(12, 20)};
        return cubic;
    };
    Tally tally;
    EXPECT_TRUE(check("cubic: energy never above 1.001 of the start, 4.84 where projections show",
                      [&] { gains_no_energy(tally, config, 2.0); }));
    tally.print("random_calm_cubic", {k_open_projections, 0.0});
}

// --- The projection by itself --------------------------------------------------------------------------------------------

// A projection adds nothing to the square norm, once or repeated. Beyond an open boundary p is 0 at the ghost's centre and the
// divergence sees the cell itself there, no adjoint pair: the norm of the matrix is 1.032 at most (boxes of 4 to 20 cells an axis,
// of one to three axes), that of its powers 2.2.
TEST(RandomStories, ProjectingAddsNoEnergy) {
    double worst = 0.0;
    EXPECT_TRUE(check("a projection never adds more than its norm to the square norm", [&] {
        const Box box{.cells = {pick(1, 16), pick(1, 16), pick(1, 16)}, .cell_size = 1.0f, .boundaries = some_sides(0.0)};
        auto work = Workspace::create({.box = box});
        RC_ASSERT(work.has_value());
        const auto seed = static_cast<std::uint32_t>(pick(1, 1000));
        Field field = pick(0, 1) == 0 ? white_noise(box.cells, 1.0f, seed) : shear_layer(box.cells, 1.0f, seed);
        const double start = energy_of(field);
        double last = start;
        for (int n = 0; n < 40 && last > 1e-6 * start; ++n) {
            project(*work, field);
            const double energy = energy_of(field);
            worst = std::max(worst, energy / last);
            const bool open = box.boundaries.has_open(0) || box.boundaries.has_open(1) || box.boundaries.has_open(2);
            RC_ASSERT(energy <= last * (open ? k_open_projection : 1.0 + 1e-5));
            RC_ASSERT(energy <= start * (open ? k_open_projections : 1.0 + 1e-5));
            last = energy;
        }
    }));
    figure("stability/projecting/energy_after_over_before", worst, k_open_projection);
}

} // namespace
