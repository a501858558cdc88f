// The six sides: what is refused, what ambient wind they admit, and what lies beyond each kind.

#include "fluid/pieces.h"
#include "fluid/sides.h"
#include "tests/fields.h"
#include "tests/figure.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <string>

namespace {

using namespace windrow;
using namespace windrow::test;

constexpr const char* k_names[6] = {"sides.x_low", "sides.x_high", "sides.y_low", "sides.y_high", "sides.z_low", "sides.z_high"};

Side& side_of(Sides& sides, int axis, int end) {
    Side* const ordered[6] = {&sides.x_low, &sides.x_high, &sides.y_low, &sides.y_high, &sides.z_low, &sides.z_high};
    return *ordered[2 * axis + end];
}

TEST(Sides, EachFaceIsNamedInItsRefusal) {
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end) {
            const std::string name = k_names[2 * axis + end], partner = k_names[2 * axis + 1 - end];
            const auto refusal = [&](Side side) {
                Sides sides;
                side_of(sides, axis, end) = side;
                const auto valid = validate(sides);
                EXPECT_FALSE(valid) << name;
                EXPECT_EQ(std::count(valid.error().begin(), valid.error().end(), '\n'), 0) << valid.error();
                return valid.error();
            };
            glm::vec3 across(0.0f), along(0.0f), broken(0.0f);
            across[axis] = along[(axis + 1) % 3] = 1.0f;
            broken[(axis + 2) % 3] = std::numeric_limits<float>::quiet_NaN();
            EXPECT_EQ(refusal({SideKind::periodic}).find(partner + " is not periodic but its partner is"), 0u);
            EXPECT_EQ(refusal({SideKind::no_slip, across}).find(name + ".wall_velocity is "), 0u);
            EXPECT_EQ(refusal({SideKind::no_slip, broken}).find(name + ".wall_velocity is "), 0u);
            for (const SideKind kind : {SideKind::open, SideKind::free_slip})
                EXPECT_NE(refusal({kind, along}).find("no_slip"), std::string::npos);

            Sides sound;
            side_of(sound, axis, end) = {SideKind::no_slip, along};
            EXPECT_TRUE(validate(sound));
        }
}

TEST(Sides, AllReasonsComeAtOnce) {
    Sides sides = Sides::all(SideKind::free_slip);
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            side_of(sides, axis, end).wall_velocity = glm::vec3(1.0f);
    sides.z_high.kind = SideKind::periodic;
    const std::string sentences = validate(sides).error();
    EXPECT_EQ(std::count(sentences.begin(), sentences.end(), '\n'), 6) << sentences;
    for (const char* name : k_names)
        EXPECT_NE(sentences.find(name), std::string::npos) << name;
}

TEST(Sides, PresetsAndQuestions) {
    const Sides floor = Sides::open_over_floor();
    EXPECT_TRUE(validate(floor));
    EXPECT_TRUE(floor.has_solid(1) && floor.has_open(1) && !floor.has_solid(0) && !floor.periodic(2));
    EXPECT_EQ(floor.at(1, 0).kind, SideKind::free_slip);
    EXPECT_EQ(floor.at(1, 1).kind, SideKind::open);
    for (const SideKind kind : {SideKind::open, SideKind::free_slip, SideKind::no_slip, SideKind::periodic}) {
        const Sides sides = Sides::all(kind);
        EXPECT_TRUE(validate(sides));
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(sides.periodic(axis), kind == SideKind::periodic);
            EXPECT_EQ(sides.has_open(axis), kind == SideKind::open);
            EXPECT_EQ(sides.has_solid(axis), kind == SideKind::free_slip || kind == SideKind::no_slip);
        }
    }
    Sides mixed;
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end) {
            Sides one;
            side_of(one, axis, end).kind = SideKind::no_slip;
            EXPECT_EQ(one.at(axis, end).kind, SideKind::no_slip);
            EXPECT_FALSE(one == mixed);
        }
}

TEST(Sides, AWallTakesTheAmbientComponentAcrossIt) {
    const glm::vec3 wind(3.0f, -2.0f, 5.0f);
    EXPECT_EQ(admissible_ambient(Sides{}, wind), wind);
    EXPECT_EQ(admissible_ambient(Sides::all(SideKind::periodic), wind), wind);
    EXPECT_EQ(admissible_ambient(Sides::open_over_floor(), wind), glm::vec3(3.0f, 0.0f, 5.0f));
    EXPECT_EQ(admissible_ambient(Sides::all(SideKind::no_slip), wind), glm::vec3(0.0f));
    Sides wall;
    wall.x_high.kind = SideKind::no_slip;
    EXPECT_EQ(admissible_ambient(wall, wind), glm::vec3(0.0f, -2.0f, 5.0f));
}

// --- What lies beyond ------------------------------------------------------------------------------------------------

// The velocity half a cell beyond a face, written from the list at the top of sides.h.
glm::dvec3 ghost(const Side& side, int axis, glm::dvec3 edge, glm::dvec3 far_edge, glm::dvec3 ambient) {
    glm::dvec3 mirrored = edge;
    switch (side.kind) {
    case SideKind::open:
        return ambient;
    case SideKind::periodic:
        return far_edge;
    case SideKind::free_slip:
        mirrored[axis] = -edge[axis];
        return mirrored;
    default:
        return 2.0 * glm::dvec3(side.wall_velocity) - edge;
    }
}

// One explicit pass of diffusion is u + r (sum of six neighbours - 6 u): it shows the ghosts of every face and every kind.
TEST(Sides, DiffusionSeesTheGhostsOfTheList) {
    Random random(11);
    double worst = 0.0;
    for (int trial = 0; trial < 200; ++trial) {
        Box box{.cells = {random.integer(1, 5), random.integer(1, 5), random.integer(1, 5)}, .cell_size = 0.5f, .sides = {}};
        for (int axis = 0; axis < 3; ++axis) {
            const int choice = random.integer(0, 9);
            for (int end = 0; end < 2; ++end) {
                Side& side = side_of(box.sides, axis, end);
                side.kind = choice == 0 ? SideKind::periodic : static_cast<SideKind>(random.integer(0, 2));
                if (side.kind == SideKind::no_slip) {
                    side.wall_velocity = random.vector(2.0f);
                    side.wall_velocity[axis] = 0.0f;
                }
            }
        }
        const glm::vec3 wind = random.vector(3.0f);
        auto work = Workspace::create({.box = box, .ambient = wind});
        ASSERT_TRUE(work) << work.error();
        const glm::dvec3 ambient(admissible_ambient(box.sides, wind));
        const Field field = white_noise(box.cells, 1.0f, random.bits());
        Field result(field.size());
        const double ratio = 0.0625; // r = nu dt / h^2
        ASSERT_EQ(*diffuse(*work, field, static_cast<float>(ratio * 0.25), 1.0f, result), DiffusionMethod::one_pass);

        const auto at = [&](glm::ivec3 cell) { return glm::dvec3(field[box.index(cell.x, cell.y, cell.z)]); };
        const auto neighbour = [&](glm::ivec3 cell, int axis, int end) {
            glm::ivec3 next = cell;
            next[axis] += end == 0 ? -1 : 1;
            if (next[axis] >= 0 && next[axis] < box.cells[axis])
                return at(next);
            glm::ivec3 far_edge = cell;
            far_edge[axis] = end == 0 ? box.cells[axis] - 1 : 0;
            return ghost(box.sides.at(axis, end), axis, at(cell), at(far_edge), ambient);
        };
        for (int k = 0; k < box.cells.z; ++k)
            for (int j = 0; j < box.cells.y; ++j)
                for (int i = 0; i < box.cells.x; ++i) {
                    glm::dvec3 sum = -6.0 * at({i, j, k});
                    for (int axis = 0; axis < 3; ++axis)
                        for (int end = 0; end < 2; ++end)
                            sum += neighbour({i, j, k}, axis, end);
                    const glm::dvec3 expected = at({i, j, k}) + ratio * sum;
                    const glm::dvec3 error = glm::abs(glm::dvec3(result[box.index(i, j, k)]) - expected);
                    worst = std::max({worst, error.x, error.y, error.z});
                }
    }
    WINDROW_EXPECT_FIGURE("ghost_error", worst, 5e-7);
}

} // namespace
