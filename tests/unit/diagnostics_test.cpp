// What a step reports, against the same asked of the cells by hand; and that a dt that is none does nothing.

#include "tests/winds.h"

namespace {

using namespace windrow;
using namespace windrow::test;

TEST(Diagnostics, SubstepsAreTheCflOverWhatOneMayCross) {
    Random random(121);
    for (int trial = 0; trial < 300; ++trial) {
        const float h = static_cast<float>(random.spread(0.05, 20.0)), speed = static_cast<float>(random.spread(0.01, 100.0));
        const float max_cfl = trial % 3 == 0 ? static_cast<float>(random.spread(0.5, 8.0)) : 2.0f;
        const int max_substeps = trial % 4 == 0 ? random.integer(1, 64) : 8;
        const double dt = random.spread(1e-4, 30.0) * h / speed;
        glm::vec3 wind_speed(0.3f * speed);
        wind_speed[trial % 3] = trial % 2 == 0 ? speed : -speed;
        Wind wind =
            made({.cells = {4, 3, 5}, .cell_size = h, .ambient = wind_speed, .max_cfl = max_cfl, .max_substeps = max_substeps});
        const Diagnostics report = wind.step(dt);
        const double cfl = double(speed) * double(float(dt)) / double(h);
        ASSERT_NEAR(report.cfl, cfl, 1e-6 * cfl);
        const int wanted = std::max(1, static_cast<int>(std::ceil(report.cfl / max_cfl)));
        EXPECT_EQ(report.substeps, std::min(wanted, max_substeps));
        EXPECT_EQ(report.substeps_capped, wanted > max_substeps);
        // Before the air moves and, since it comes in as fast through the sides, after it.
        EXPECT_EQ(report.limited_cells, wanted > max_substeps ? 2 * 60 : 0);
        EXPECT_TRUE(report.stepped);
    }
}

TEST(Diagnostics, ForcesCountIntoTheCfl) {
    Wind wind = made({.cells = {8, 8, 8}, .ambient = {1.0f, 0.0f, 0.0f}});
    ASSERT_TRUE(
        wind.motors().add(DirectionalMotor{.region = AlignedBox{glm::vec3(1e6f)}, .law = Force{30.0f}, .turbulence = k_steady}));
    const Diagnostics report = wind.step(0.5);
    EXPECT_NEAR(report.cfl, (1.0 + 0.5 * 30.0) * 0.5, 1e-4);
    EXPECT_EQ(report.substeps, 4);
    EXPECT_EQ(report.motors_in_reach, 1);
}

TEST(Diagnostics, CappedSpeedsAreCountedAndLimited) {
    // All stages that could change a speed after the limit are off, and the limited air is uniform along its own way.
    Wind wind = made({.cells = {8, 8, 8},
                      .boundaries = Boundaries::all(BoundaryKind::periodic),
                      .viscosity = 0.0f,
                      .relaxation_time = 0.0f,
                      .stages = {.relaxation = false, .diffusion = false, .projection = false}});
    Field field(512, glm::vec4(0.0f));
    for (int i = 0; i < 8; ++i) // rows of their own speed, along x
        for (int row = 0; row < 64; ++row)
            field[static_cast<std::size_t>(row * 8 + i)].x = row < 10 ? 40.0f : row < 20 ? -40.0f : 1.0f;
    ASSERT_TRUE(wind.set_velocity(field));
    const Diagnostics report = wind.step(1.0);
    EXPECT_TRUE(report.substeps_capped);
    EXPECT_EQ(report.substeps, 8);
    EXPECT_EQ(report.limited_cells, 160);
    EXPECT_NEAR(report.cfl, 40.0, 1e-4);
    for (int row = 0; row < 64; ++row)
        ASSERT_NEAR(wind.field()[static_cast<std::size_t>(row * 8 + 3)].x,
                    row < 10   ? 16.0
                    : row < 20 ? -16.0
                               : 1.0,
                    1e-5)
            << "2 cells * 8 parts / 1 s";
}

TEST(Diagnostics, BrokenCellsAreCountedAndMended) {
    const glm::vec3 ambient(1.0f, -2.0f, 0.5f);
    Random random(122);
    for (int trial = 0; trial < 20; ++trial) {
        Wind wind = made({.cells = {13, 7, 9}, .ambient = ambient, .stages = k_no_stages});
        Field field = white_noise({13, 7, 9}, 2.0f, random.bits());
        std::vector<bool> broken(field.size(), false);
        const int count = random.integer(0, 60);
        for (int n = 0; n < count; ++n) {
            const auto cell = static_cast<std::size_t>(random.integer(0, int(field.size()) - 1));
            field[cell][random.integer(0, 2)] = n % 3 == 0 ? k_nan : n % 3 == 1 ? k_infinity : -k_infinity;
            broken[cell] = true;
        }
        ASSERT_TRUE(wind.set_velocity(field));
        const Diagnostics report = wind.step(0.1);
        EXPECT_EQ(report.repaired_cells, std::count(broken.begin(), broken.end(), true));
        for (std::size_t n = 0; n < field.size(); ++n)
            ASSERT_EQ(wind.field()[n], broken[n] ? glm::vec4(ambient, 0.0f) : field[n]);
        EXPECT_EQ(wind.step(0.1).repaired_cells, 0);
    }
}

// Central divergence from boundaries.h, in double.
double divergence_rms(const Wind& wind) {
    const Box& box = wind.box();
    double squares = 0.0;
    for_each_cell(box.cells, [&](int i, int j, int k) {
        double sum = 0.0;
        for (int axis = 0; axis < 3; ++axis)
            for (int end = 0; end < 2; ++end) {
                glm::ivec3 cell(i, j, k);
                const int n = box.cells[axis], next = cell[axis] + (end == 0 ? -1 : 1);
                const bool outside = next < 0 || next >= n;
                const BoundaryKind kind = box.boundaries.at(axis, end).kind;
                double sign = end == 0 ? -1.0 : 1.0;
                if (!outside) {
                    cell[axis] = next;
                } else if (kind == BoundaryKind::periodic) {
                    cell[axis] = end == 0 ? n - 1 : 0;
                } else if (kind != BoundaryKind::open) { // beyond an open boundary lies the cell itself
                    sign = -sign;                        // mirrored with its sign turned
                }
                sum += sign * double(wind.field()[box.index(cell.x, cell.y, cell.z)][axis]);
            }
        squares += sum * sum * 0.25 / (double(box.cell_size) * box.cell_size);
    });
    return std::sqrt(squares / double(box.cell_count()));
}

TEST(Diagnostics, EnergySpeedAndDivergenceAreThoseOfTheCells) {
    double energy = 0.0, speed = 0.0, divergence = 0.0;
    for (const glm::ivec3 cells : {glm::ivec3(16, 16, 16), glm::ivec3(17, 9, 23), glm::ivec3(1, 5, 8), glm::ivec3(6, 1, 1)})
        for (int kind = 0; kind < 5; ++kind) {
            Config config{.cells = cells, .cell_size = 0.4f, .ambient = {2.0f, 1.0f, -1.0f}};
            config.boundaries = kind < 4 ? Boundaries::all(static_cast<BoundaryKind>(kind)) : Boundaries::open_over_floor();
            Wind wind = made(config);
            ASSERT_TRUE(wind.set_velocity(white_noise(cells, 5.0f, 123)));
            for (int n = 0; n < 5; ++n) {
                const Diagnostics report = wind.step(0.02);
                float largest = 0.0f;
                for (const glm::vec4& u : wind.field())
                    largest = std::max({largest, std::abs(u.x), std::abs(u.y), std::abs(u.z)});
                const double by_hand = energy_of(wind.field()) * std::pow(double(config.cell_size), 3);
                energy = std::max(energy, std::abs(report.energy - by_hand) / by_hand);
                speed = std::max(speed, double(std::abs(report.max_speed - largest)));
                divergence = std::max(divergence, std::abs(report.divergence_rms - divergence_rms(wind)) *
                                                      double(config.cell_size) / largest);
            }
        }
    WINDROW_EXPECT_FIGURE("report_energy_error", energy, 1e-6);
    WINDROW_EXPECT_FIGURE("report_speed_error", speed, 0.0);
    WINDROW_EXPECT_FIGURE("report_divergence_error", divergence, 1e-6); // of the largest speed a cell
}

TEST(Diagnostics, ADtThatIsNoneDoesNothing) {
    const auto with_a_wake_on_its_way = [] {
        Wind wind = made({.cells = {8, 8, 8}, .viscosity = 1.0f});
        EXPECT_TRUE(wind.set_velocity(white_noise({8, 8, 8}, 5.0f, 124)));
        const MotorId body = added(wind, WakeMotor{.position = {-2.0, 0.0, 0.0}, .radius = 1.5f, .law = WakeForce{}});
        added(wind, DirectionalMotor{.turbulence = k_steady});
        wind.step(0.1);
        EXPECT_TRUE(wind.motors().move(body, {2.0, 0.0, 0.0}));
        return wind;
    };
    Wind wind = with_a_wake_on_its_way();
    const Field before = copy(wind.field());
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    for (const double dt :
         {0.0, -0.0, -1.0, nan, -nan, infinity, -infinity, 1e300, 1e-300, 5e-324}) { // what a float cannot hold is none either
        const Diagnostics report = wind.step(dt);
        EXPECT_FALSE(report.stepped) << dt;
        EXPECT_EQ(report.substeps, 0) << dt;
        ASSERT_EQ(cells_that_differ(before, wind.field()), 0u) << dt;
    }
    // The pause did not eat the wake's path, nor the history: the next step is that of a wind that never paused.
    Wind steady = with_a_wake_on_its_way();
    EXPECT_EQ(steady.step(0.1).motors_in_reach, 2);
    wind.step(0.1);
    EXPECT_EQ(cells_that_differ(steady.field(), wind.field()), 0u);
}

TEST(Diagnostics, EveryFieldIsFilled) {
    Wind wind = made({.viscosity = 10.0f});
    ASSERT_TRUE(wind.motors().add(DirectionalMotor{.position = {500.0, 0.0, 0.0}, .turbulence = k_steady}));
    ASSERT_TRUE(wind.motors().add(DirectionalMotor{.position = {5.0, 0.0, 0.0}, .turbulence = k_steady}));
    const Diagnostics report = wind.step(1.0 / 60.0);
    EXPECT_EQ(report.motors_in_reach, 1) << "the other is too far";
    EXPECT_EQ(report.diffusion, DiffusionMethod::implicit);
    EXPECT_GT(report.max_speed, 0.1f);
    EXPECT_GT(report.energy, 0.0);
    EXPECT_FALSE(report.substeps_capped);
    for_each_row(report.times_ms, [](const auto& row, double time) { EXPECT_GE(time, 0.0) << row.name; });
    EXPECT_LE(sum_of_stages(report.times_ms), report.times_ms.total * 1.0001);
    for (const auto& [viscosity, method] : {std::pair{0.0f, DiffusionMethod::none},
                                            {5e-3f, DiffusionMethod::none},
                                            {0.02f, DiffusionMethod::one_pass},
                                            {4.9f, DiffusionMethod::one_pass},
                                            {5.1f, DiffusionMethod::implicit}})
        EXPECT_EQ(made({.cells = {4, 4, 4}, .viscosity = viscosity}).step(1.0 / 60.0).diffusion, method) << viscosity;
}

} // namespace
