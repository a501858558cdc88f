// The clamped scalar: cubic where the field is smooth, never outside the eight cells around the departure point.
//
// Order: a Gaussian of sigma 0.1 carried through a periodic unit square by (1, 0.5), back at its start at T = 2, CFL 0.7; an
// order of 1.8 or more is asked over N = 32, 64, 128. Bound: the departure point is found once more in double; where
// it lies on a cell's face to rounding, the cells on either side count.
#include "cases/reference/trajectory.h"
#include "figures.h"
#include "flows.h"

#include <numbers>

namespace windrow {
namespace {

using namespace flows;
using figures::expect_at_least;
using figures::expect_at_most;

double round_trip_error(int cells, Interpolation interpolation, bool clamped, double width) {
    const Box box = periodic_box({cells, cells, 1}, 1.0 / cells);
    Workspace work = workspace(box);
    const Field wind(box.cell_count(), glm::vec4(1.0f, 0.5f, 0.0f, 0.0f));
    const auto start = scalars_of(box, [&](glm::dvec3 x) {
        return std::exp(-0.5 * ((x.x - 0.5) * (x.x - 0.5) + (x.y - 0.5) * (x.y - 0.5)) / (width * width));
    });
    const int steps = static_cast<int>(std::lround(2.0 * cells / 0.7));
    auto values = start;
    std::vector<float> next(values.size());
    for (int step = 0; step < steps; ++step) {
        EXPECT_TRUE(advect(work,
                           ScalarTransport{.carried = values,
                                           .velocity = wind,
                                           .dt = static_cast<float>(2.0 / steps),
                                           .interpolation = interpolation,
                                           .clamped = clamped},
                           next));
        std::swap(values, next);
    }
    std::vector<float> off(values.size());
    for (std::size_t n = 0; n < values.size(); ++n)
        off[n] = values[n] - start[n];
    return rms(std::span<const float>(off)) / rms(std::span<const float>(start));
}

TEST(AdvectionClamp, KeepsItsOrderOnASmoothField) {
    const auto error = [](int cells) { return round_trip_error(cells, Interpolation::cubic, true, 0.1); };
    expect_at_most("advection_clamp.finest", figures::expect_orders("advection_clamp", {32, 64, 128}, 1.8, error), 0.0025);
}

TEST(AdvectionClamp, UnclampedCubicAndLinearForComparison) {
    const auto cubic = [](int cells) { return round_trip_error(cells, Interpolation::cubic, false, 0.1); };
    expect_at_most("advection_clamp.unclamped.finest", figures::expect_orders("advection_clamp.unclamped", {64, 128}, 2.6, cubic),
                   0.0015);
    const double l64 = round_trip_error(64, Interpolation::linear, false, 0.1),
                 l128 = round_trip_error(128, Interpolation::linear, false, 0.1);
    figures::report("advection_clamp.linear_error_128", l128);
    figures::report("advection_clamp.linear_order_64_128", figures::order(l64, l128));
}

// A block with edges, turned round and round by a wind that is not uniform: the cubic overshoots, the clamped one may not.
TEST(AdvectionClamp, NeverLeavesTheRangeOfTheField) {
    const Box box = periodic_box({40, 24, 12});
    Workspace work = workspace(box);
    const glm::dvec3 size(box.cells);
    const Field wind = velocities_of(box, [&](glm::dvec3 x) {
        const glm::dvec3 phase = 2.0 * std::numbers::pi * x / size;
        return 1.5 * glm::dvec3(std::sin(phase.y) + std::cos(phase.z), std::sin(phase.z) + std::cos(phase.x),
                                std::sin(phase.x) + std::cos(phase.y));
    });
    const auto block = scalars_of(
        box, [&](glm::dvec3 x) { return std::abs(x.x - 20) < 7 && std::abs(x.y - 12) < 5 && std::abs(x.z - 6) < 3 ? 3.0 : 1.0; });
    float low = 1.0f, high = 3.0f, loose_high = 3.0f;
    auto values = block, loose = block, next = block;
    for (int step = 0; step < 60; ++step) {
        EXPECT_TRUE(advect(work, ScalarTransport{.carried = values, .velocity = wind, .dt = 0.6f, .clamped = true}, next));
        std::swap(values, next);
        low = std::min(low, *std::min_element(values.begin(), values.end()));
        high = std::max(high, *std::max_element(values.begin(), values.end()));
        EXPECT_TRUE(advect(work, ScalarTransport{.carried = loose, .velocity = wind, .dt = 0.6f}, next));
        std::swap(loose, next);
        loose_high = std::max(loose_high, *std::max_element(loose.begin(), loose.end()));
    }
    expect_at_least("advection_clamp.min_value_of_a_block_1_to_3", low, 1.0);
    expect_at_most("advection_clamp.largest_value_of_a_block_1_to_3", high, 3.0);
    // Without the clamp the same block does overshoot: the bound above is not empty.
    expect_at_least("advection_clamp.largest_value_without_clamp", loose_high, 3.05);
}

TEST(AdvectionClamp, EachValueLiesWithinItsEightNeighbours) {
    Random random(31);
    const BoundaryKind periodic = BoundaryKind::periodic, open = BoundaryKind::open, slip = BoundaryKind::free_slip,
                       rough = BoundaryKind::no_slip;
    int outside = 0, checked = 0, at_bound = 0;
    for (const Boundaries& boundaries : {Boundaries::all(periodic), Boundaries::all(open), Boundaries::all(slip),
                                         sides_of({open, slip}, {rough, rough}, {periodic, periodic})})
        for (const glm::ivec3 cells : {glm::ivec3(17, 9, 11), glm::ivec3(5, 1, 8), glm::ivec3(2, 70, 3)}) {
            const Box box{.cells = cells, .boundaries = boundaries};
            Workspace work = workspace(box, {0.4f, 0.2f, 0.1f});
            const Field wind = random_field(random, box, 2.0f);
            const auto values = scalars_of(box, [&](glm::dvec3) { return random.real(-1.0, 1.0); });
            const float dt = 0.9f, beyond_value = 0.25f;
            std::vector<float> moved(values.size());
            EXPECT_TRUE(advect(
                work, ScalarTransport{.carried = values, .velocity = wind, .dt = dt, .outside = beyond_value, .clamped = true},
                moved));
            const Transport trace{.carried = wind, .velocity = wind, .dt = dt};
            for_each_cell(cells, [&](int i, int j, int k) {
                ++checked;
                const glm::dvec3 from = reference::departure(box, glm::dvec3(work.ambient()), trace, {i, j, k});
                double least = std::numeric_limits<double>::infinity(), most = -least;
                const glm::ivec3 first(glm::floor(from - 1e-4)), last(glm::floor(from + 1e-4) + 1.0);
                for (int c = first.z; c <= last.z; ++c)
                    for (int b = first.y; b <= last.y; ++b)
                        for (int a = first.x; a <= last.x; ++a) {
                            const double value = reference::scalar_at(box, values, beyond_value, {a, b, c});
                            least = std::min(least, value);
                            most = std::max(most, value);
                        }
                const double value = moved[box.index(i, j, k)];
                outside += value < least || value > most;
                at_bound += value == least || value == most;
            });
        }
    expect_at_most("advection_clamp.cells_outside_their_neighbours", outside, 0);
    // Random cells are rough: the clamp must have had work to do.
    expect_at_least("advection_clamp.share_of_cells_at_their_bound", static_cast<double>(at_bound) / checked, 0.01);
}

} // namespace
} // namespace windrow
