// The six sides: what is rejected, what ambient wind they admit, and what lies beyond each kind.

#include "fluid/boundaries.h"
#include "fluid/operators.h"
#include "tests/fields.h"
#include "tests/figure.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <string>

namespace {

using namespace windrow;
using namespace windrow::test;

constexpr const char* k_names[6] = {"boundaries.x_low",  "boundaries.x_high", "boundaries.y_low",
                                    "boundaries.y_high", "boundaries.z_low",  "boundaries.z_high"};

Boundary& side_of(Boundaries& boundaries, int axis, int end) {
    Boundary* const ordered[6] = {&boundaries.x_low,  &boundaries.x_high, &boundaries.y_low,
                                  &boundaries.y_high, &boundaries.z_low,  &boundaries.z_high};
    return *ordered[2 * axis + end];
}

TEST(Boundaries, EachFaceIsNamedInItsRejection) {
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end) {
            const std::string name = k_names[2 * axis + end], partner = k_names[2 * axis + 1 - end];
            const auto rejection = [&](Boundary side) {
                Boundaries boundaries;
                side_of(boundaries, axis, end) = side;
                const auto valid = validate(boundaries);
                EXPECT_FALSE(valid) << name;
                EXPECT_EQ(std::count(valid.error().begin(), valid.error().end(), '\n'), 0) << valid.error();
                return valid.error();
            };
            glm::vec3 across(0.0f), along(0.0f), broken(0.0f);
            across[axis] = along[(axis + 1) % 3] = 1.0f;
            broken[(axis + 2) % 3] = std::numeric_limits<float>::quiet_NaN();
            EXPECT_EQ(rejection({BoundaryKind::periodic}).find(partner + " is not periodic, but the opposite boundary is"), 0u);
            EXPECT_EQ(rejection({BoundaryKind::no_slip, across}).find(name + ".wall_velocity is "), 0u);
            EXPECT_EQ(rejection({BoundaryKind::no_slip, broken}).find(name + ".wall_velocity is "), 0u);
            for (const BoundaryKind kind : {BoundaryKind::open, BoundaryKind::free_slip})
                EXPECT_NE(rejection({kind, along}).find("no_slip"), std::string::npos);

            Boundaries sound;
            side_of(sound, axis, end) = {BoundaryKind::no_slip, along};
            EXPECT_TRUE(validate(sound));
        }
}

TEST(Boundaries, AllReasonsComeAtOnce) {
    Boundaries boundaries = Boundaries::all(BoundaryKind::free_slip);
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            side_of(boundaries, axis, end).wall_velocity = glm::vec3(1.0f);
    boundaries.z_high.kind = BoundaryKind::periodic;
    const std::string sentences = validate(boundaries).error();
    EXPECT_EQ(std::count(sentences.begin(), sentences.end(), '\n'), 6) << sentences;
    for (const char* name : k_names)
        EXPECT_NE(sentences.find(name), std::string::npos) << name;
}

TEST(Boundaries, PresetsAndQuestions) {
    const Boundaries floor = Boundaries::open_over_floor();
    EXPECT_TRUE(validate(floor));
    EXPECT_TRUE(floor.has_solid(1) && floor.has_open(1) && !floor.has_solid(0) && !floor.periodic(2));
    EXPECT_EQ(floor.at(1, 0).kind, BoundaryKind::free_slip);
    EXPECT_EQ(floor.at(1, 1).kind, BoundaryKind::open);
    for (const BoundaryKind kind : {BoundaryKind::open, BoundaryKind::free_slip, BoundaryKind::no_slip, BoundaryKind::periodic}) {
        const Boundaries boundaries = Boundaries::all(kind);
        EXPECT_TRUE(validate(boundaries));
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(boundaries.periodic(axis), kind == BoundaryKind::periodic);
            EXPECT_EQ(boundaries.has_open(axis), kind == BoundaryKind::open);
            EXPECT_EQ(boundaries.has_solid(axis), kind == BoundaryKind::free_slip || kind == BoundaryKind::no_slip);
        }
    }
    Boundaries mixed;
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end) {
            Boundaries one;
            side_of(one, axis, end).kind = BoundaryKind::no_slip;
            EXPECT_EQ(one.at(axis, end).kind, BoundaryKind::no_slip);
            EXPECT_FALSE(one == mixed);
        }
}

TEST(Boundaries, AWallTakesTheAmbientComponentAcrossIt) {
    const glm::vec3 wind(3.0f, -2.0f, 5.0f);
    EXPECT_EQ(admissible_ambient(Boundaries{}, wind), wind);
    EXPECT_EQ(admissible_ambient(Boundaries::all(BoundaryKind::periodic), wind), wind);
    EXPECT_EQ(admissible_ambient(Boundaries::open_over_floor(), wind), glm::vec3(3.0f, 0.0f, 5.0f));
    EXPECT_EQ(admissible_ambient(Boundaries::all(BoundaryKind::no_slip), wind), glm::vec3(0.0f));
    Boundaries wall;
    wall.x_high.kind = BoundaryKind::no_slip;
    EXPECT_EQ(admissible_ambient(wall, wind), glm::vec3(0.0f, -2.0f, 5.0f));
}

// --- What lies beyond ------------------------------------------------------------------------------------------------

// The velocity half a cell beyond a face, written from the list at the top of boundaries.h.
glm::dvec3 ghost(const Boundary& side, int axis, glm::dvec3 edge, glm::dvec3 far_edge, glm::dvec3 ambient) {
    glm::dvec3 mirrored = edge;
    switch (side.kind) {
    case BoundaryKind::open:
        return ambient;
    case BoundaryKind::periodic:
        return far_edge;
    case BoundaryKind::free_slip:
        mirrored[axis] = -edge[axis];
        return mirrored;
    default:
        return 2.0 * glm::dvec3(side.wall_velocity) - edge;
    }
}

// One explicit pass of diffusion is u + r (sum of six neighbours - 6 u): it shows the ghosts of every face and every kind.
TEST(Boundaries, DiffusionSeesTheGhostsOfTheList) {
    Random random(11);
    double worst = 0.0;
    for (int trial = 0; trial < 200; ++trial) {
        Box box{.cells = {random.integer(1, 5), random.integer(1, 5), random.integer(1, 5)}, .cell_size = 0.5f, .boundaries = {}};
        for (int axis = 0; axis < 3; ++axis) {
            const int choice = random.integer(0, 9);
            for (int end = 0; end < 2; ++end) {
                Boundary& side = side_of(box.boundaries, axis, end);
                side.kind = choice == 0 ? BoundaryKind::periodic : static_cast<BoundaryKind>(random.integer(0, 2));
                if (side.kind == BoundaryKind::no_slip) {
                    side.wall_velocity = random.vector(2.0f);
                    side.wall_velocity[axis] = 0.0f;
                }
            }
        }
        const glm::vec3 wind = random.vector(3.0f);
        auto work = Workspace::create({.box = box, .ambient = wind});
        ASSERT_TRUE(work) << work.error();
        const glm::dvec3 ambient(admissible_ambient(box.boundaries, wind));
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
            return ghost(box.boundaries.at(axis, end), axis, at(cell), at(far_edge), ambient);
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
