// Strands on skins without uv: how many there are on planes of any tilt, whether any is cut, what the search costs.
#include "tests/fields.h"
#include "tests/figure.h"
#include "vegetation/fur/strand_field.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <utility>
#include <vector>

// The same text once more, with a hash that counts its calls.
#undef WINDROW_SPACE_HASH_GLSL
#undef WINDROW_STRAND_CELLS_GLSL
#undef WINDROW_STRAND_FIELD_GLSL
#define WINDROW_FN [[maybe_unused]] inline
namespace windrow::vegetation::fur::counted {
inline int hashes = 0;
inline glm::uvec2 windrow_plant_hash(glm::uvec2 key) {
    ++hashes;
    return numerics::windrow_plant_hash(key);
}
using namespace glm;
using numerics::windrow_fraction;
using numerics::windrow_mask_power;
using numerics::windrow_turn_cosine;
using numerics::windrow_turn_sine;
#include "vegetation/shaders/numerics/strand_field.glsl"
} // namespace windrow::vegetation::fur::counted
#undef WINDROW_FN

namespace windrow::vegetation::fur {
namespace {

using windrow::test::Random;

struct SurfaceFrame {
    glm::dvec3 across, along, normal;
};
SurfaceFrame frame_of(glm::dvec3 normal) {
    const glm::dvec3 other = std::abs(normal.x) < 0.7 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 across = glm::normalize(glm::cross(normal, other));
    return {across, glm::cross(normal, across), normal};
}

const StrandFieldSettings k_fur{.density = 1.0f, .low = 0.7f, .high = 1.0f, .thickness = 0.8f};

TEST(StrandSurface, NoStrandIsCutByTheSearch) {
    StrandFieldSettings thick = k_fur, bowed = k_fur, blunt = k_fur;
    thick.thickness = 1.7f;
    bowed.bow = 0.4f;
    blunt.profile = StrandProfile::centre;
    blunt.cut_min = 0.25f;
    blunt.cut_max = 0.1f;
    for (const auto& [kind, settings] : {std::pair{"fur", k_fur}, {"thick", thick}, {"bowed", bowed}, {"blunt", blunt}}) {
        const StrandFieldBlock field = block(settings);
        Random random(1);
        double apart = 0.0;
        int drawn = 0;
        for (int n = 0; n < 20'000; ++n) {
            const glm::vec3 normal = n % 5 == 0 ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(random.direction());
            const glm::vec3 q = random.vector(20.0f);
            const float h = random.uniform(0.0f, 0.95f);
            // All of 7^3 cells around.
            float best = -1.0f;
            for (int k = 0; k < 343; ++k) {
                const glm::ivec3 cell = glm::ivec3(glm::floor(q)) + glm::ivec3(k % 7, k / 7 % 7, k / 49) - 3;
                const glm::uvec2 key = numerics::windrow_space_hash(0u, cell);
                const glm::vec3 jitter = glm::vec3(numerics::windrow_fraction(key.x), numerics::windrow_fraction(key.y),
                                                   numerics::windrow_strand_other_chance(key)) -
                                         0.5f;
                glm::vec3 d = q - glm::vec3(cell) - 0.5f - jitter;
                const float off = glm::dot(d, normal);
                const float reach = numerics::windrow_strand_reach(field, key) * numerics::windrow_strand_slab(std::abs(off));
                const float radius = numerics::windrow_strand_radius(field, h, reach);
                if (radius < 0.0f || reach <= 0.0f)
                    continue;
                d -= off * normal;
                glm::vec3 lean = jitter - glm::dot(jitter, normal) * normal;
                lean /= std::max(glm::length(lean), 0.05f);
                const double turn = 2.0 * 3.14159265358979 * static_cast<double>(field.bow.y * h);
                d -= field.bow.x * h *
                     (static_cast<float>(std::cos(turn)) * lean + static_cast<float>(std::sin(turn)) * glm::cross(normal, lean));
                best = std::max(best, std::min(radius, 0.9f - field.bow.x * h) - glm::length(d));
            }
            drawn += best > 0.0f;
            if (best > -0.04f)
                apart = std::max(apart, static_cast<double>(std::abs(strand_on(field, q, normal, h).inside - best)));
        }
        const std::string name = std::string("shells/surface/cut/") + kind;
        EXPECT_GT(windrow::test::figure(name + "/drawn", drawn), 500);
        WINDROW_EXPECT_FIGURE(name + "/largest_cells", apart, 5e-6);
    }
}

// Strands an area of one cell, told apart by their keys, whose root lies in a square of a plane.
double strands_on_plane(const StrandFieldBlock& field, const SurfaceFrame& frame, double depth, float h) {
    constexpr double k_half = 14.0, k_step = 0.125;
    std::set<std::pair<std::uint32_t, std::uint32_t>> keys;
    for (double v = -k_half - 0.5; v < k_half + 0.5; v += k_step)
        for (double u = -k_half - 0.5; u < k_half + 0.5; u += k_step) {
            const glm::dvec3 x = u * frame.across + v * frame.along + depth * frame.normal;
            const StrandHit hit = strand_on(field, glm::vec3(x), glm::vec3(frame.normal), h);
            const double root_u = glm::dot(glm::dvec3(hit.root), frame.across),
                         root_v = glm::dot(glm::dvec3(hit.root), frame.along);
            if (hit.inside > 0.0f && std::abs(root_u) < k_half && std::abs(root_v) < k_half)
                keys.insert({hit.key.x, hit.key.y});
        }
    return static_cast<double>(keys.size()) / (4.0 * k_half * k_half);
}

TEST(StrandSurface, DensityIsTheSameOnPlanesOfAnyTiltAndDepth) {
    // Cylinders as thin as the sampling finds, of one length: each strand that stands is seen.
    const StrandFieldBlock field =
        block({.density = 1.0f, .low = 1.0f, .profile = StrandProfile::centre, .cut_min = 0.012f, .cut_max = 0.012f});
    const glm::dvec3 tilts[] = {{0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}, {0.02, 1.0, 0.0},
                                {1.0, 1.0, 0.0}, {1.0, 1.0, 1.0}, {0.3, 0.8, -0.5}};
    double least = 1e9, most = 0.0, sum = 0.0;
    int planes = 0;
    for (const glm::dvec3 tilt : tilts) {
        double min_here = 1e9, max_here = 0.0;
        for (int k = 0; k < 8; ++k) {
            const double density = strands_on_plane(field, frame_of(glm::normalize(tilt)), 3.0 + 0.125 * k, 0.5f);
            min_here = std::min(min_here, density);
            max_here = std::max(max_here, density);
            sum += density;
            ++planes;
        }
        windrow::test::figure("shells/surface/density/spread_" + std::to_string(planes / 8), max_here / min_here - 1.0);
        least = std::min(least, min_here);
        most = std::max(most, max_here);
    }
    const double mean = sum / planes;
    EXPECT_NEAR(windrow::test::figure("shells/surface/density/mean_at_half_length", mean), 1.0, 0.08);
    // 784 strands by chance alone spread by 3.6 %; 48 such planes by about five times that from end to end.
    WINDROW_EXPECT_FIGURE("shells/surface/density/largest_over_mean", most / mean - 1.0, 0.12);
    WINDROW_EXPECT_FIGURE("shells/surface/density/min_under_mean", 1.0 - least / mean, 0.12);
}

TEST(StrandSurface, ASphereIsCoveredEvenly) {
    const StrandFieldBlock field = block(k_fur);
    for (const double radius : {4.0, 20.0}) {
        // Share of the skin that is drawn on rings of the sphere, by the angle to the lattice's axis.
        double least = 1.0, most = 0.0;
        Random random(2);
        for (int ring = 0; ring < 10; ++ring) {
            int drawn = 0;
            constexpr int k_count = 6000;
            for (int n = 0; n < k_count; ++n) {
                const double y = 0.1 * (ring + random.real(0.0, 1.0)), turn = random.real(0.0, 6.283185307);
                const double flat = std::sqrt(1.0 - y * y);
                const glm::vec3 normal(glm::dvec3(flat * std::cos(turn), y, flat * std::sin(turn)));
                drawn += strand_on(field, static_cast<float>(radius) * normal, normal, 0.3f).inside > 0.0f;
            }
            least = std::min(least, static_cast<double>(drawn) / k_count);
            most = std::max(most, static_cast<double>(drawn) / k_count);
        }
        const std::string name = "shells/surface/sphere_" + std::to_string(static_cast<int>(radius));
        windrow::test::figure(name + "/min_fraction", least);
        windrow::test::figure(name + "/largest_fraction", most);
        if (radius > 10.0) { // on the small one a ring has some ten strands
            WINDROW_EXPECT_FIGURE(name + "/ratio", most / least, 1.25);
        }
    }
}

// Along the skin of a small sphere strands come and go without a step: what is drawn changes with the way, at any scale of it.
TEST(StrandSurface, NothingPopsOrIsCutOnACurvedSkin) {
    const StrandFieldBlock field = block(k_fur);
    const auto largest_jump = [&](double step) {
        double jump = 0.0;
        Random random(3);
        for (int line = 0; line < 400; ++line) {
            const glm::dvec3 from = random.direction(), toward = frame_of(from).across;
            float last = 0.0f;
            for (int n = 0; n < 200; ++n) {
                const double turn = n * step / 5.0;
                const glm::vec3 normal(std::cos(turn) * from + std::sin(turn) * toward);
                const float inside = std::max(strand_on(field, 5.0f * normal, normal, 0.3f).inside, 0.0f);
                if (n > 0)
                    jump = std::max(jump, static_cast<double>(std::abs(inside - last)));
                last = inside;
            }
        }
        return jump;
    };
    const double coarse = windrow::test::figure("shells/surface/jump_in_0.04_cells", largest_jump(0.04));
    WINDROW_EXPECT_FIGURE("shells/surface/jump_in_0.005_cells", largest_jump(0.005), coarse / 4.0);
    // Radii grow with the length that the slab leaves: T/2 * 7.5 * 0.2 (the normal's turn by a cell) beside the way itself.
    EXPECT_LE(coarse, 0.04 * (1.0 + 0.4 * 7.5 * 0.2));
}

TEST(StrandSurface, CostsAboutEightHashes) {
    struct Kind {
        const char* name;
        glm::vec3 normal;
        float h;
    };
    const StrandFieldBlock field = block(k_fur);
    for (const Kind kind :
         {Kind{"level_root", {0.0f, 1.0f, 0.0f}, 0.0f}, Kind{"level_half", {0.0f, 1.0f, 0.0f}, 0.5f},
          Kind{"level_tip", {0.0f, 1.0f, 0.0f}, 0.95f}, Kind{"tilted_root", glm::normalize(glm::vec3(1.0f)), 0.0f},
          Kind{"tilted_half", glm::normalize(glm::vec3(1.0f)), 0.5f}}) {
        Random random(4);
        counted::hashes = 0;
        int most = 0;
        constexpr int k_count = 20'000;
        counted::WindrowStrandField same{field.cells, field.points, field.reach, field.cut, field.bow, field.shaft};
        for (int n = 0; n < k_count; ++n) {
            const int before = counted::hashes;
            (void)counted::windrow_strand_surface(same, random.vector(20.0f), kind.normal, kind.h);
            most = std::max(most, counted::hashes - before);
        }
        const std::string name = std::string("shells/surface/hashes/") + kind.name;
        WINDROW_EXPECT_FIGURE(name, static_cast<double>(counted::hashes) / k_count, 12.0);
        WINDROW_EXPECT_FIGURE(name + "/most", most, 24.0);
    }
}

// On uv: at most nine, few at the tips, one on the grid.
TEST(StrandSurface, CostsOfUv) {
    struct Kind {
        const char* name;
        float jitter, h, most;
    };
    for (const Kind kind : {Kind{"grid", 0.0f, 0.0f, 1.0f}, Kind{"jittered_root", 1.0f, 0.0f, 4.0f},
                            Kind{"jittered_half", 1.0f, 0.5f, 3.0f}, Kind{"jittered_tip", 1.0f, 0.95f, 2.0f}}) {
        StrandFieldSettings settings = k_fur;
        settings.jitter = kind.jitter;
        const StrandFieldBlock field = block(settings);
        const counted::WindrowStrandField same{field.cells, field.points, field.reach, field.cut, field.bow, field.shaft};
        Random random(5);
        counted::hashes = 0;
        constexpr int k_count = 20'000;
        for (int n = 0; n < k_count; ++n)
            (void)counted::windrow_strand_uv(same, {random.uniform(-20.0f, 20.0f), random.uniform(-20.0f, 20.0f)}, kind.h);
        const double most = static_cast<double>(kind.most);
        WINDROW_EXPECT_FIGURE(std::string("shells/uv/hashes/") + kind.name, static_cast<double>(counted::hashes) / k_count, most);
    }
}

} // namespace
} // namespace windrow::vegetation::fur
