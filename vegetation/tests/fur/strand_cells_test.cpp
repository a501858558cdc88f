// Voronoi cells of strands: the nearest point equals that of brute force in double.
#include "tests/fields.h"
#include "tests/figure.h"
#include "vegetation/fur/strand_field.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace windrow::vegetation::fur {
namespace {

using windrow::test::Random;

struct Truth {
    glm::uvec2 key{0u};
    double nearest = 1e9, second = 1e9, edge = 1e9;
};

// All points of the 9 x 9 cells around.
Truth brute(const numerics::WindrowStrandLattice& lattice, glm::dvec2 q) {
    struct CellPoint {
        glm::dvec2 at;
        glm::uvec2 key;
    };
    std::vector<CellPoint> points;
    for (int row = -4; row <= 4; ++row)
        for (int across = -4; across <= 4; ++across) {
            const glm::ivec2 cell{static_cast<int>(std::floor(q.x)) + across, static_cast<int>(std::floor(q.y)) + row};
            const glm::uvec2 key = numerics::windrow_strand_key(lattice.seed, cell);
            points.push_back({glm::dvec2(numerics::windrow_strand_centre(lattice, cell)) +
                                  glm::dvec2(numerics::windrow_strand_jitter(lattice, key)),
                              key});
        }
    Truth truth;
    glm::dvec2 nearest(0.0);
    for (const CellPoint& point : points) {
        const double distance = glm::length(q - point.at);
        if (distance < truth.nearest) {
            truth.second = truth.nearest;
            truth.nearest = distance;
            truth.key = point.key;
            nearest = point.at;
        } else
            truth.second = std::min(truth.second, distance);
    }
    for (const CellPoint& point : points)
        if (point.key != truth.key)
            truth.edge = std::min(truth.edge, glm::dot(0.5 * (nearest + point.at) - q, glm::normalize(point.at - nearest)));
    return truth;
}

TEST(StrandCells, AreThoseOfBruteForce) {
    struct CellPattern {
        const char* name;
        float jitter, wriggle, shift;
        double missed; // fraction of places whose nearest edge belongs to a point out of the nine cells
    };
    // At rest none of 1e5; all that wriggles stands at its diamond's rim more often. Shifted rows have 0.9 of the jitter
    // (fur::block), since the whole of it misses one.
    for (const CellPattern kind :
         {CellPattern{"full", 1.0f, 0.0f, 0.0f, 0.0}, CellPattern{"half", 0.5f, 0.0f, 0.0f, 0.0},
          CellPattern{"shifted", 0.9f, 0.0f, 0.5f, 0.0}, CellPattern{"shifted_grid", 0.0f, 0.0f, 0.5f, 0.0},
          CellPattern{"wriggling", 1.0f, 1.0f, 0.0f, 1e-4}, CellPattern{"wriggling_shifted", 0.9f, 1.0f, 0.5f, 1e-4}}) {
        const numerics::WindrowStrandLattice lattice{kind.jitter, kind.wriggle, 0.37f, kind.shift, 11u};
        Random random(1);
        constexpr int k_places = 100'000;
        double nearest_apart = 0.0, edge_apart = 0.0, min_edge = 1e9, widest = 0.0;
        int other_cell = 0, missed = 0;
        for (int n = 0; n < k_places; ++n) {
            const glm::vec2 q(random.uniform(-30.0f, 30.0f), random.uniform(-30.0f, 30.0f));
            const auto cell = numerics::windrow_strand_nearest(lattice, q, true);
            const Truth truth = brute(lattice, glm::dvec2(q));
            const double distance = static_cast<double>(glm::length(cell.offset));
            nearest_apart = std::max(nearest_apart, std::abs(distance - truth.nearest));
            other_cell += cell.key != truth.key && truth.second - truth.nearest > 1e-5;
            const double edge = static_cast<double>(cell.edge);
            min_edge = std::min(min_edge, edge);
            widest = std::max(widest, truth.edge);
            if (cell.key != truth.key)
                continue; // on the edge itself, to the last digit
            if (edge - truth.edge > 1e-4)
                ++missed;
            else
                edge_apart = std::max(edge_apart, std::abs(edge - truth.edge));
        }
        const std::string name = std::string("shells/cells/") + kind.name;
        EXPECT_EQ(other_cell, 0) << name;
        WINDROW_EXPECT_FIGURE(name + "/nearest_cells", nearest_apart, 1e-5);
        WINDROW_EXPECT_FIGURE(name + "/edge_cells", edge_apart, 2e-5);
        WINDROW_EXPECT_FIGURE(name + "/edges_missed", static_cast<double>(missed) / k_places, kind.missed);
        EXPECT_GE(windrow::test::figure(name + "/min_edge", min_edge), 0.0);
        // What windrow_strand_top takes for the widest: layers above are skipped.
        WINDROW_EXPECT_FIGURE(name + "/widest_cell", widest, 0.55 + 0.25 * static_cast<double>(kind.jitter));
    }
}

TEST(StrandCells, WithoutJitterAreTheGrid) {
    const numerics::WindrowStrandLattice lattice{0.0f, 1.0f, 0.4f, 0.0f, 5u};
    Random random(2);
    double apart = 0.0;
    for (int n = 0; n < 10'000; ++n) {
        const glm::vec2 q(random.uniform(-30.0f, 30.0f), random.uniform(-30.0f, 30.0f));
        const auto cell = numerics::windrow_strand_nearest(lattice, q, true);
        const glm::dvec2 d = glm::dvec2(q) - glm::floor(glm::dvec2(q)) - 0.5;
        apart = std::max({apart, glm::length(glm::dvec2(cell.offset) - d),
                          std::abs(static_cast<double>(cell.edge) - (0.5 - std::max(std::abs(d.x), std::abs(d.y))))});
        EXPECT_EQ(cell.key, numerics::windrow_strand_key(5u, glm::ivec2(glm::floor(q))));
    }
    WINDROW_EXPECT_FIGURE("shells/cells/grid_cells", apart, 1e-5);
}

// Points wander without jumps and come back after a turn.
TEST(StrandCells, WriggleIsSmoothAndComesBack) {
    double step = 0.0, apart = 0.0, moved = 0.0;
    for (int n = 0; n < 1000; ++n) {
        const glm::uvec2 key = numerics::windrow_strand_key(1u, {n, -n});
        const auto at = [&](float phase) { return numerics::windrow_strand_jitter({1.0f, 1.0f, phase, 0.0f, 1u}, key); };
        for (int k = 0; k < 64; ++k) {
            step = std::max(
                step, static_cast<double>(glm::length(at(static_cast<float>(k + 1) / 64) - at(static_cast<float>(k) / 64))));
            moved = std::max(moved, static_cast<double>(glm::length(at(static_cast<float>(k) / 64) - at(0.0f))));
        }
        apart = std::max(apart, static_cast<double>(glm::length(at(1.25f) - at(0.25f))));
    }
    // Two sines of amplitude 1/4 a component: at most 2 pi / 64 * sqrt(2) / 2 a step.
    WINDROW_EXPECT_FIGURE("shells/cells/wriggle_step_cells", step, 0.0695);
    WINDROW_EXPECT_FIGURE("shells/cells/wriggle_after_a_turn_cells", apart, 1e-5);
    EXPECT_GT(windrow::test::figure("shells/cells/wriggle_moved_cells", moved), 0.5);
}

TEST(StrandCells, SineOfTurns) {
    double apart = 0.0;
    for (int n = -20000; n <= 20000; ++n) {
        const float turns = static_cast<float>(n) / 4096.0f;
        apart = std::max(apart, std::abs(static_cast<double>(numerics::windrow_turn_sine(turns)) -
                                         std::sin(2.0 * 3.14159265358979323846 * static_cast<double>(turns))));
    }
    WINDROW_EXPECT_FIGURE("shells/cells/sine_of_turns", apart, 5e-7);
}

// The nearest middle of tufts in space against all of 7^3 cells around.
TEST(StrandCells, TuftsInSpaceAreThoseOfBruteForce) {
    Random random(3);
    double apart = 0.0;
    for (int n = 0; n < 20'000; ++n) {
        const glm::vec3 q = random.vector(20.0f);
        double least = 1e9;
        for (int cell = 0; cell < 343; ++cell) {
            const glm::ivec3 at = glm::ivec3(glm::floor(q)) + glm::ivec3(cell % 7, cell / 7 % 7, cell / 49) - 3;
            const glm::uvec2 key = numerics::windrow_space_hash(9u, at);
            const glm::dvec3 chance(numerics::windrow_fraction(key.x), numerics::windrow_fraction(key.y),
                                    numerics::windrow_strand_chance(key));
            least = std::min(least, glm::length(glm::dvec3(q) - (glm::dvec3(at) + 0.5 + 0.4 * (chance - 0.5))));
        }
        const auto tuft = numerics::windrow_space_tuft(9u, q);
        apart = std::max(apart, std::abs(static_cast<double>(glm::length(tuft.offset)) - least));
    }
    WINDROW_EXPECT_FIGURE("shells/cells/tufts_in_space_cells", apart, 1e-5);
}

} // namespace
} // namespace windrow::vegetation::fur
