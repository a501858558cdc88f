// Bit-exact regression: the hash of every cell after 240 steps, for each scheme, interpolation, boundary kind and SIMD level.
//
// A refactoring changes no bit, so the table bits.txt stays as it is. A change of the method writes it again
// (WINDROW_ACCEPT_BITS=1, on a machine with AVX-512) and says in its commit why.
//
// The story has every kind of motor, gusts, a canopy, viscosity, uneven steps and a box that moves, as far as its boundaries
// admit them, on a grid of whole registers and on an odd one.

#include "fluid/core/bytes.h"
#include "tests/stability/watch.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <span>

namespace {

using namespace windrow;
using namespace windrow::test;

constexpr const char* k_table = WINDROW_SOURCE_DIR "/tests/stability/bits.txt";
constexpr int k_steps = 240;

struct Walls {
    const char* name;
    Boundaries boundaries;
};

Boundaries moving_lid() {
    Boundaries boundaries = Boundaries::all(BoundaryKind::no_slip);
    boundaries.y_high.wall_velocity = {2.0f, 0.0f, -1.0f};
    return boundaries;
}

Boundaries duct() {
    Boundaries boundaries = Boundaries::all(BoundaryKind::free_slip);
    boundaries.x_low.kind = boundaries.x_high.kind = BoundaryKind::periodic;
    boundaries.z_high.kind = BoundaryKind::open;
    boundaries.y_low.kind = BoundaryKind::no_slip;
    return boundaries;
}

const Walls k_walls[] = {{"open", Boundaries{}},
                         {"open_over_floor", Boundaries::open_over_floor()},
                         {"free_slip", Boundaries::all(BoundaryKind::free_slip)},
                         {"no_slip_moving_lid", moving_lid()},
                         {"periodic", Boundaries::all(BoundaryKind::periodic)},
                         {"duct_of_four_kinds", duct()}};

std::uint64_t hash_after(const Walls& walls, glm::ivec3 cells, Scheme scheme, Interpolation interpolation, Simd level) {
    Config config{.cells = cells,
                  .boundaries = walls.boundaries,
                  .ambient = admissible_ambient(walls.boundaries, {4.0f, 0.0f, 1.5f}),
                  .viscosity = 0.05f,
                  .scheme = scheme,
                  .interpolation = interpolation,
                  .simd = level};
    const bool floor = walls.boundaries.y_low.solid();
    const bool free_x = walls.boundaries.x_low.kind == BoundaryKind::open,
               free_z = walls.boundaries.z_low.kind == BoundaryKind::open;
    if (free_x)
        config.gusts = {.intensity = 0.2f, .length = 12.0f};
    if (floor && free_x) {
        config.profile = LogProfile{};
        config.canopy = Canopy{.height = 1.5f};
    }
    Wind wind = made(config);
    EXPECT_TRUE(wind.set_velocity(projected(smooth_noise(cells, 3.0f, 11), wind.box())));

    const glm::dvec3 start = wind.origin() + 0.5 * glm::dvec3(cells);
    drive(wind, start, {1.0f, 0.2f, 0.0f}, 12.0f);
    const MotorId walker = added(wind, WakeMotor{.position = start, .radius = 1.5f});
    added(wind, JetMotor{.position = start + glm::dvec3(-3.0, 0.0, 2.0), .direction = {0.0f, 0.3f, 1.0f}});
    added(wind, VortexMotor{.position = start + glm::dvec3(2.0, 1.0, -3.0), .radius = 3.0f, .lift = 0.4f});
    added(wind, DirectionalMotor{.position = start + glm::dvec3(0.0, 2.0, 0.0),
                                 .direction = {0.0f, 0.0f, 1.0f},
                                 .region = AlignedBox{},
                                 .law = Force{3.0f},
                                 .envelope = {.attack = 0.3f, .hold = 1.0f, .decay = 0.5f}});
    if (walls.boundaries.z_high.kind == BoundaryKind::open) { // air that comes in must get out
        added(wind, OmniMotor{.position = start + glm::dvec3(-2.0, 0.0, -2.0), .speed = 4.0f});
        added(wind, PressureMotor{.position = start + glm::dvec3(3.0, 0.0, 3.0)});
    }
    for (int n = 0; n < k_steps; ++n) {
        const glm::dvec3 way = glm::dvec3(free_x ? 0.06 : 0.01, 0.0, free_z ? -0.04 : 0.01) * static_cast<double>(n);
        EXPECT_TRUE(wind.motors().move(walker, start + way));
        if (free_x && free_z) {
            EXPECT_TRUE(wind.follow(start + way));
        }
        wind.step(n % 7 == 6 ? 1.0 / 30.0 : 1.0 / 60.0);
    }
    EXPECT_TRUE(all_finite(wind.field()));
    return windrow::detail::checksum(std::as_bytes(wind.field()));
}

using Table = std::map<std::string, std::string>;

Table read_table() {
    Table table;
    std::ifstream file(k_table);
    for (std::string name, hash; file >> name >> hash;)
        table[name] = hash;
    return table;
}

constexpr std::size_t k_rows = 180; // of the table, with all SIMD levels

// A read does not ask which scheme it is for: that of 32 cells is pinned in one.
std::vector<Interpolation> interpolations_of(Scheme scheme) {
    if (scheme == Scheme::stable_fluids)
        return {Interpolation::linear, Interpolation::cubic};
    return {Interpolation::linear, Interpolation::cubic, Interpolation::cubic_32};
}

TEST(Bits, OfEverySchemeInterpolationBoundaryAndSimdLevelStay) {
    Table found;
    for (const Simd level : {Simd::baseline, Simd::avx2, Simd::avx512}) {
        if (!runs(level))
            continue;
        for (const Scheme scheme : {Scheme::second_order, Scheme::stable_fluids})
            for (const Interpolation interpolation : interpolations_of(scheme))
                for (const Walls& walls : k_walls)
                    for (const glm::ivec3 cells : {glm::ivec3(24, 12, 20), glm::ivec3(19, 9, 13)}) {
                        const std::string name = std::string(name_of(level)) + '/' +
                                                 (scheme == Scheme::second_order ? "second_order" : "stable_fluids") + '/' +
                                                 k_words<Interpolation>[static_cast<std::size_t>(interpolation)] + '/' +
                                                 walls.name + '/' + std::to_string(cells.x) + 'x' + std::to_string(cells.y) +
                                                 'x' + std::to_string(cells.z);
                        char hash[17];
                        std::snprintf(hash, sizeof hash, "%016llx",
                                      static_cast<unsigned long long>(hash_after(walls, cells, scheme, interpolation, level)));
                        found[name] = hash;
                    }
    }
    if (std::getenv("WINDROW_ACCEPT_BITS") != nullptr) {
        ASSERT_EQ(found.size(), k_rows) << "the table holds all SIMD levels";
        std::ofstream file(k_table);
        for (const auto& [name, hash] : found)
            file << name << ' ' << hash << '\n';
        return;
    }
    Table expected = read_table();
    ASSERT_EQ(expected.size(), k_rows) << k_table;
    for (const auto& [name, hash] : found)
        EXPECT_EQ(hash, expected[name]) << name;
}

} // namespace
