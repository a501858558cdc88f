// Strands in cells of uv: the drawn area and profile at each height equal the formula.
#include "tests/fields.h"
#include "tests/figure.h"
#include "vegetation/fur/strand_field.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <string>

namespace windrow::vegetation::fur {
namespace {

using windrow::test::Random;

constexpr int k_texels = 1024; // across a cell

// A grid of strands of one length.
StrandFieldSettings grid() {
    return {.density = 1.0f, .jitter = 0.0f, .low = 1.0f, .high = 1.0f};
}

// [cells^2] drawn of the cell at the origin.
double area(const StrandFieldBlock& field, float h) {
    int drawn = 0;
    for (int y = 0; y < k_texels; ++y)
        for (int x = 0; x < k_texels; ++x)
            drawn += strand_at(field, (glm::vec2(x, y) + 0.5f) / static_cast<float>(k_texels), h).inside > 0.0f;
    return static_cast<double>(drawn) / (k_texels * k_texels);
}

// In the sources' units a cell is 2 wide, r from 0 to 1 along its axes: area pi T^2 (R - h)^2.
TEST(StrandField, ConesHaveTheAreaOfTheirFormula) {
    double worst = 0.0;
    for (const float thickness : {0.4f, 1.0f})
        for (const float length : {0.7f, 1.0f})
            for (const float h : {0.0f, 0.2f, 0.5f, 0.6f}) {
                StrandFieldSettings settings = grid();
                settings.thickness = thickness;
                settings.low = settings.high = length;
                const double radius = static_cast<double>(thickness) * (static_cast<double>(length) - static_cast<double>(h));
                const double expected = std::numbers::pi * radius * radius;
                worst = std::max(worst, std::abs(4.0 * area(block(settings), h) / expected - 1.0));
            }
    WINDROW_EXPECT_FIGURE("shells/field/cone_area_error", worst, 0.02);
}

// How far from the cell's middle along x its strand (or, in the edge form, the space left of it) reaches, by halving.
double radius_at(const StrandFieldBlock& field, float h) {
    double low = 0.0, high = 0.5;
    for (int n = 0; n < 30; ++n) {
        const double middle = 0.5 * (low + high);
        (strand_at(field, {static_cast<float>(0.5 + middle), 0.5f}, h).inside > 0.0f ? low : high) = middle;
    }
    return low;
}

TEST(StrandField, ProfilesFollowTheirCuts) {
    struct TaperForm {
        const char* name;
        StrandProfile profile;
        float low, high, exponent;
    };
    for (const TaperForm form : {TaperForm{"centre", StrandProfile::centre, 0.2f, 0.0f, 0.7f},
                                 TaperForm{"centre_square", StrandProfile::centre, 0.2f, 0.02f, 2.0f},
                                 TaperForm{"cylinder", StrandProfile::centre, 0.1f, 0.1f, 0.7f},
                                 TaperForm{"edge", StrandProfile::edge, 0.0f, 0.45f, 0.7f}}) {
        StrandFieldSettings settings = grid();
        settings.profile = form.profile;
        settings.cut_min = form.low;
        settings.cut_max = form.high;
        settings.cut_exponent = form.exponent;
        const StrandFieldBlock field = block(settings);
        double off = 0.0, last = 1.0, rises = 0.0;
        for (int n = 0; n <= 40; ++n) {
            const float h = static_cast<float>(n) / 40.0f;
            const double cut =
                form.low + (form.high - form.low) * std::pow(static_cast<double>(h), static_cast<double>(form.exponent));
            const double expected = form.profile == StrandProfile::edge ? 0.5 - cut : std::sqrt(std::max(cut, 0.0));
            const double radius = radius_at(field, h);
            off = std::max(off, std::abs(radius - expected));
            rises = std::max(rises, radius - last);
            last = radius;
        }
        const std::string name = std::string("shells/field/") + form.name;
        WINDROW_EXPECT_FIGURE(name + "/radius_off_cells", off, 1.0 / k_texels);
        // Equal ones stay within float's own steps of a place near 1/2.
        WINDROW_EXPECT_FIGURE(name + "/rises_to_the_tip", std::max(rises, 0.0), 1e-7);
    }
}

TEST(StrandField, EmptyLayersAreToldAndNoOthers) {
    struct GapCase {
        const char* name;
        StrandFieldSettings settings;
        int empty; // of 50 layers, i / 49
    };
    // Edge, 003's own figures: 0 to 0.6 as t^0.7 passes the half cell of the grid at t = 0.771, so that layers 38 to 49 draw
    // nothing.
    StrandFieldSettings edge = grid(), shorter = grid(), nothing = grid(), jittered;
    edge.profile = jittered.profile = StrandProfile::edge;
    edge.cut_min = jittered.cut_min = 0.0f;
    edge.cut_max = jittered.cut_max = 0.6f;
    edge.cut_exponent = jittered.cut_exponent = 0.7f;
    jittered.density = 1.0f;
    shorter.high = shorter.low = 0.5f;
    nothing.thickness = 0.0f;
    for (const GapCase& c : {GapCase{"edge", edge, 12}, GapCase{"half_length", shorter, 25}, GapCase{"no_thickness", nothing, 49},
                             GapCase{"all", grid(), 0}, GapCase{"edge_jittered", jittered, 0}}) {
        const StrandFieldBlock field = block(c.settings);
        int empty = 0, drawn_in_empty = 0, never_drawn = 0;
        for (int layer = 0; layer < 50; ++layer) {
            const float h = static_cast<float>(layer) / 49.0f;
            Random random(1);
            int drawn = 0;
            for (int n = 0; n < 4000; ++n)
                drawn += strand_at(field, {random.uniform(-20.0f, 20.0f), random.uniform(-20.0f, 20.0f)}, h).inside > 0.0f;
            empty += layer_empty(c.settings, h);
            drawn_in_empty += layer_empty(c.settings, h) ? drawn : 0;
            never_drawn += !layer_empty(c.settings, h) && drawn == 0;
        }
        const std::string name = std::string("shells/field/empty/") + c.name;
        windrow::test::figure(name, empty);
        windrow::test::figure(name + "/drawn_but_bare", never_drawn);
        EXPECT_EQ(empty, c.empty) << name;
        EXPECT_EQ(drawn_in_empty, 0) << name;
    }
}

// The strand at a point by all points of 7 x 7 cells around: none is cut by the search.
TEST(StrandField, NoStrandIsCutByTheSearch) {
    struct NamedStrands {
        const char* name;
        StrandFieldSettings settings;
    };
    for (const NamedStrands& kind :
         {NamedStrands{"thick", {.density = 1.0f, .low = 0.5f, .thickness = 1.6f}},
          NamedStrands{"bowed", {.density = 1.0f, .low = 0.5f, .thickness = 1.0f, .bow = 0.5f, .bow_turns = 1.5f}},
          NamedStrands{"feathers",
                       {.density = 1.0f,
                       .row_shift = 0.5f,
                       .jitter = 0.5f,
                       .thickness = 0.9f,
                       .shape = StrandShape::oval,
                       .half_length = 0.9f}},
          NamedStrands{"strips",
                       {.density = 1.0f, .jitter = 1.0f, .thickness = 0.6f, .shape = StrandShape::strip, .half_length = 0.6f}}}) {
        const StrandFieldBlock field = block(kind.settings);
        const auto lattice = numerics::windrow_strand_lattice(field);
        Random random(1);
        double apart = 0.0;
        int drawn = 0;
        for (int n = 0; n < 40'000; ++n) {
            const glm::vec2 q(random.uniform(-20.0f, 20.0f), random.uniform(-20.0f, 20.0f));
            const float h = random.uniform(0.0f, 0.9f);
            float best = -1.0f;
            for (int row = -3; row <= 3; ++row)
                for (int across = -3; across <= 3; ++across) {
                    const glm::ivec2 cell = numerics::windrow_strand_home(lattice, q, row) + glm::ivec2(across, 0);
                    const glm::uvec2 key = numerics::windrow_strand_key(lattice.seed, cell);
                    const float reach = numerics::windrow_strand_reach(field, key);
                    const float radius = numerics::windrow_strand_radius(field, h, reach);
                    const glm::vec2 d = q - numerics::windrow_strand_centre(lattice, cell) -
                                        numerics::windrow_strand_jitter(lattice, key) -
                                        numerics::windrow_strand_bow(field, key, h);
                    if (radius >= 0.0f)
                        best = std::max(
                            best, numerics::windrow_strand_inside(field, d, std::min(radius, 1.0f - field.bow.x * h), h, reach));
                }
            const float inside = strand_at(field, q, h).inside;
            drawn += best > 0.0f;
            if (best > -0.05f) // beyond, any number below 0 will do
                apart = std::max(apart, static_cast<double>(std::abs(inside - best)));
        }
        const std::string name = std::string("shells/field/search/") + kind.name;
        EXPECT_GT(windrow::test::figure(name + "/drawn", drawn), 1000);
        WINDROW_EXPECT_FIGURE(name + "/inside_off_cells", apart, 1e-6);
    }
}

// Where a strand of a tuft is drawn follows from its root by the tufts' formula, with the tuft's middle found by brute force.
TEST(StrandField, TipsGatherInTufts) {
    constexpr float k_amount = 0.7f, k_size = 5.0f;
    const StrandFieldBlock field = block({.density = 1.0f,
                                          .low = 1.0f,
                                          .profile = StrandProfile::centre,
                                          .cut_min = 0.05f,
                                          .cut_max = 0.02f,
                                          .tuft = k_amount,
                                          .tuft_size = k_size});
    const numerics::WindrowStrandLattice coarse{1.0f, 0.0f, 0.0f, 0.0f, 0x51ed270bu};
    Random random(1);
    double off = 0.0;
    int drawn[3] = {};
    for (int n = 0; n < 60'000; ++n) {
        const glm::vec2 q(random.uniform(-60.0f, 60.0f), random.uniform(-60.0f, 60.0f));
        for (int k = 0; k < 3; ++k) {
            const float h = 0.5f * static_cast<float>(k);
            const StrandHit hit = strand_at(field, q, h);
            if (hit.inside <= 0.0f)
                continue;
            ++drawn[k];
            const glm::dvec2 root(hit.root);
            glm::dvec2 middle(0.0);
            double least = 1e9;
            for (int cell = 0; cell < 25; ++cell) {
                const glm::ivec2 at =
                    glm::ivec2(glm::floor(root / static_cast<double>(k_size))) + glm::ivec2(cell % 5, cell / 5) - 2;
                const glm::uvec2 key = numerics::windrow_strand_key(coarse.seed, at);
                const glm::dvec2 point = static_cast<double>(k_size) * glm::dvec2(numerics::windrow_strand_centre(coarse, at) +
                                                                                  numerics::windrow_strand_jitter(coarse, key));
                if (glm::length(root - point) < least) {
                    least = glm::length(root - point);
                    middle = point;
                }
            }
            const double shrink = 1.0 - static_cast<double>(k_amount * h * h);
            const glm::dvec2 seen = middle + shrink * (root - middle) + glm::dvec2(hit.outward);
            off = std::max(off, glm::length(seen - glm::dvec2(q)));
        }
    }
    WINDROW_EXPECT_FIGURE("shells/field/tufts/place_off_cells", off, 1e-4);
    const double root = drawn[0], tip = drawn[2];
    // A tip's section is cut_max / cut_min of its root's; in tufts of 0.3 of the width some of it lies one on another.
    windrow::test::figure("shells/field/tufts/share_at_root", root / 60'000);
    windrow::test::figure("shells/field/tufts/share_at_tip", tip / 60'000);
    EXPECT_GT(tip, 0.0);
    EXPECT_LT(tip, 0.4 * root);
}

// A lying feather begins at the skin at its root and ends at its whole length.
TEST(StrandField, LyingFeathersRiseAlongV) {
    StrandFieldSettings settings = grid();
    settings.profile = StrandProfile::centre;
    settings.cut_min = settings.cut_max = 0.16f;
    settings.shape = StrandShape::strip;
    settings.half_length = 0.4f;
    settings.lift = 1.0f;
    const StrandFieldBlock field = block(settings);
    double off = 0.0;
    for (int n = 1; n < 40; ++n) {
        const float y = -0.4f + 0.02f * static_cast<float>(n);
        double low = 0.0, high = 1.0;
        for (int k = 0; k < 24; ++k) {
            const double middle = 0.5 * (low + high);
            (strand_at(field, {0.5f, 0.5f + y}, static_cast<float>(middle)).inside > 0.0f ? low : high) = middle;
        }
        off = std::max(off, std::abs(low - (static_cast<double>(y) + 0.4) / 0.8));
    }
    WINDROW_EXPECT_FIGURE("shells/field/lift_off", off, 1e-5);
}

TEST(StrandField, RejectsWhatIsOutOfRange) {
    EXPECT_TRUE(validate(StrandFieldSettings{}));
    const float bad[] = {std::nanf(""), INFINITY, -INFINITY, -1e9f, 1e9f};
    float StrandFieldSettings::*const fields[] = {
        &StrandFieldSettings::density,  &StrandFieldSettings::stretch,     &StrandFieldSettings::row_shift,
        &StrandFieldSettings::jitter,   &StrandFieldSettings::wriggle,     &StrandFieldSettings::phase,
        &StrandFieldSettings::low,      &StrandFieldSettings::high,        &StrandFieldSettings::thickness,
        &StrandFieldSettings::cut_min,  &StrandFieldSettings::cut_max,     &StrandFieldSettings::cut_exponent,
        &StrandFieldSettings::lift,     &StrandFieldSettings::half_length, &StrandFieldSettings::shaft,
        &StrandFieldSettings::bow,      &StrandFieldSettings::bow_turns,   &StrandFieldSettings::tuft,
        &StrandFieldSettings::tuft_size};
    for (const auto field : fields)
        for (const float value : bad) {
            StrandFieldSettings settings;
            settings.*field = value;
            EXPECT_FALSE(validate(settings));
        }
    const auto says = [](const StrandFieldSettings& settings, const char* words) {
        const auto valid = validate(settings);
        return !valid && valid.error().find(words) != std::string::npos;
    };
    EXPECT_TRUE(says({.low = 0.9f, .high = 0.2f}, "strands.low"));
    EXPECT_TRUE(says({.shape = StrandShape::oval, .half_length = 0.8f, .bow = 0.4f}, "strands.half_length"));
    EXPECT_TRUE(says({.profile = StrandProfile::edge, .shape = StrandShape::strip}, "strands.shape"));
    EXPECT_TRUE(says({.seed = -1}, "strands.seed"));
    EXPECT_TRUE(says({.density = 0.0f}, "strands.density is 0: give 0.01 to 100000."));
}

} // namespace
} // namespace windrow::vegetation::fur
