// The page: nothing covers anything else, whatever the box; ticks, words and paths are what they say.
#include "cli/drawing/canvas.h"
#include "cli/drawing/layout.h"
#include "cli/drawing/outline.h"
#include "cli/drawing/overlay.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace windrow::cli {
namespace {

SlicedAir box_of(glm::ivec3 cells, float cell_size, glm::dvec3 origin = {}) {
    return {.box = {.cells = cells, .cell_size = cell_size, .boundaries = {}}, .origin = origin, .ambient = {}, .velocity = {}};
}

void expect_within(const Rect& inner, const Rect& outer) {
    EXPECT_GE(inner.x, outer.x);
    EXPECT_GE(inner.y, outer.y);
    EXPECT_LE(inner.right(), outer.right() + 0.5);
    EXPECT_LE(inner.bottom(), outer.bottom() + 0.5);
}

TEST(Layout, PartsLieOnThePageAndApart) {
    for (const glm::ivec3 cells : {glm::ivec3(32, 16, 32),
                                   {32, 32, 32},
                                   {17, 9, 23},
                                   {64, 64, 1},
                                   {1, 1, 1},
                                   {256, 16, 16},
                                   {16, 16, 256},
                                   {16, 256, 16},
                                   {2048, 1, 1},
                                   {1, 2048, 1},
                                   {1, 1, 2048},
                                   {64, 32, 64}}) {
        for (const int width : {640, 800, 1001, 1600, 3840, 8000}) {
            SCOPED_TRACE(testing::Message() << cells.x << " x " << cells.y << " x " << cells.z << " at " << width);
            const FrameLayout layout = lay_out(box_of(cells, 0.5f), {0.0, 0.0, 0.0}, width);
            EXPECT_EQ(layout.width_px, width - width % 2);
            EXPECT_EQ(layout.height_px % 2, 0);
            EXPECT_LT(layout.height_px, 2 * width);
            // A panel with its ticks, titles and caption.
            const auto around = [](const Panel& panel) {
                return Rect{panel.rect.x - 58.0, panel.rect.y - 26.0, panel.rect.width + 58.0, panel.rect.height + 26.0 + 52.0};
            };
            const Rect level = around(layout.level), upright = around(layout.upright);
            for (const Rect& part : {level, upright, layout.legend})
                expect_within(part, layout.page);
            EXPECT_EQ(shared_area(level, upright), 0.0);
            EXPECT_EQ(shared_area(level, layout.legend), 0.0);
            EXPECT_EQ(shared_area(upright, layout.legend), 0.0);
            EXPECT_EQ(shared_area(level, Rect{0.0, 0.0, layout.page.width, 60.0}), 0.0);
            EXPECT_GE(layout.legend.width, 300.0);
            EXPECT_NEAR(layout.level.rect.width, layout.upright.rect.width, 1e-9);
        }
    }
}

TEST(Layout, HoldsStillAsTheBoxMoves) {
    const FrameLayout here = lay_out(box_of({32, 16, 32}, 1.0f), {0.0, 0.0, 0.0}, 1600);
    const FrameLayout there = lay_out(box_of({32, 16, 32}, 1.0f, {1e6, -3.0, 77.0}), {1e6, 0.0, 80.0}, 1600);
    EXPECT_EQ(here.height_px, there.height_px);
    EXPECT_EQ(here.level.rect.x, there.level.rect.x);
    EXPECT_EQ(here.upright.rect.y, there.upright.rect.y);
    EXPECT_EQ(here.legend.y, there.legend.y);
}

TEST(Layout, SlicesHaveOneScaleAndPassThroughThePoint) {
    const FrameLayout layout = lay_out(box_of({32, 16, 32}, 1.0f, {-4.0, 0.0, 2.0}), {3.0, 2.5, 100.0}, 1600);
    EXPECT_NEAR(layout.level.scale.x, layout.upright.scale.y, 0.01 * layout.level.scale.x);
    EXPECT_EQ(layout.level.plane.position, 2.5);
    EXPECT_EQ(layout.upright.plane.position, 34.0); // held inside the box
    const glm::dvec2 north_west = layout.level.to_page(glm::dvec3(-4.0, 0.0, 2.0));
    EXPECT_DOUBLE_EQ(north_west.x, layout.level.rect.x);
    EXPECT_DOUBLE_EQ(north_west.y, layout.level.rect.y); // z grows downward
    EXPECT_DOUBLE_EQ(layout.upright.to_page(glm::dvec3(-4.0, 0.0, 2.0)).y, layout.upright.rect.bottom());
}

TEST(AxisTicks, AreRoundNumbersWithinTheBox) {
    const AxisTicks ticks = make_ticks(-16.0, 32.0, 3.1);
    EXPECT_EQ(ticks.step, 5.0);
    EXPECT_EQ(ticks.places, (std::vector<double>{-15.0, -10.0, -5.0, 0.0, 5.0, 10.0, 15.0}));
    EXPECT_EQ(ticks.decimals, 0);
    EXPECT_EQ(make_ticks(0.0, 1.0, 0.15).decimals, 1);
    EXPECT_EQ(make_ticks(0.3, 1.0, 50.0).places.size(), 1u); // a strip has one
    const AxisTicks far = make_ticks(1e6 + 3.0, 32.0, 4.0);
    EXPECT_EQ(far.offset, 1e6);
    for (const double place : far.places)
        EXPECT_EQ(std::fmod(place, 5.0), 0.0);
    EXPECT_FALSE(make_ticks(1e12, 0.001, 0.0001).places.empty());
}

TEST(Text, FiguresReadTheSameEverywhere) {
    EXPECT_EQ(fixed(3.4, 2), "3.40");
    EXPECT_EQ(fixed(-3.4, 1), "\xe2\x88\x92"
                              "3.4");
    EXPECT_EQ(fixed(-0.001, 2), "0.00");
    EXPECT_EQ(fixed(std::numeric_limits<double>::quiet_NaN(), 2), "?");
    EXPECT_EQ(fixed(std::numeric_limits<double>::max(), 0).size(), 309u);
    EXPECT_EQ(brief(9.5), "9.5");
    EXPECT_EQ(brief(3.13159), "3.13");
}

TEST(Text, NamesFromFilesAreMadePrintable) {
    EXPECT_EQ(printable("m\xc3\xbchle\n"), "m\xc3\xbchle ");
    EXPECT_EQ(printable("\xff"), "\xef\xbf\xbd");
    EXPECT_EQ(printable("\xc3"), "\xef\xbf\xbd");                                 // cut short
    EXPECT_EQ(printable("\xc0\xaf").find('/'), std::string::npos);                // overlong
    EXPECT_EQ(printable("\xed\xa0\x80"), "\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd"); // half a surrogate pair
    EXPECT_EQ(printable("\xf0\x9f\x8c\xb2"), "\xf0\x9f\x8c\xb2");
    EXPECT_EQ(without_last("m\xc3\xbc"), "m");
    EXPECT_EQ(without_last(""), "");
}

TEST(Outline, LinesAreCutAtThePanel) {
    const Rect room{0.0, 0.0, 10.0, 10.0};
    const std::vector<glm::dvec2> across{{-1e12, 5.0}, {1e12, 5.0}};
    const Runs one = cut(across, room);
    ASSERT_EQ(one.size(), 1u);
    EXPECT_NEAR(one[0].front().x, 0.0, 1e-3);
    EXPECT_NEAR(one[0].back().x, 10.0, 1e-3);
    const std::vector<glm::dvec2> out_and_in{{1.0, 1.0}, {5.0, 1.0}, {20.0, 1.0}, {20.0, 9.0}, {5.0, 9.0}};
    EXPECT_EQ(cut(out_and_in, room).size(), 2u);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<glm::dvec2> gap{{1.0, 1.0}, {2.0, 1.0}, {nan, 1.0}, {4.0, 1.0}, {5.0, 1.0}};
    EXPECT_EQ(cut(gap, room).size(), 2u);
    EXPECT_TRUE(cut(std::vector<glm::dvec2>{{20.0, 0.0}, {30.0, 0.0}}, room).empty());
}

TEST(Outline, RegionsLookAsTheyAre) {
    const FrameLayout layout = lay_out(box_of({32, 16, 32}, 1.0f), {16.0, 4.0, 16.0}, 1600);
    const double scale = layout.level.scale.x;
    const glm::dvec3 centre(16.0, 8.0, 16.0);
    const Rect everything{-1e6, -1e6, 2e6, 2e6};
    const auto size = [&](const Region& region) {
        const Rect bounds = bounds_of({outline_of(region, centre, layout.level)}, everything);
        return glm::dvec2(bounds.width, bounds.height) / scale;
    };
    EXPECT_NEAR(size(Sphere{3.0f}).x, 6.0, 0.02);
    EXPECT_NEAR(size(Capsule{{2.0f, 9.0f, 0.0f}, 1.0f}).x, 6.0, 0.02);
    EXPECT_NEAR(size(Capsule{{2.0f, 9.0f, 0.0f}, 1.0f}).y, 2.0, 0.02);
    EXPECT_NEAR(size(AlignedBox{{1.0f, 2.0f, 3.0f}}).y, 6.0, 0.02);
    // From the middle 6 m along x, 1 m to 3 m in radius; seen along its axis a ring.
    EXPECT_NEAR(size(Cone{{6.0f, 0.0f, 0.0f}, 1.0f, 3.0f}).x, 6.0, 0.02);
    EXPECT_NEAR(size(Cone{{6.0f, 0.0f, 0.0f}, 1.0f, 3.0f}).y, 6.0, 0.02);
    EXPECT_NEAR(size(Cone{{0.0f, 6.0f, 0.0f}, 2.0f, 2.0f}).x, 4.0, 0.02);
    EXPECT_NEAR(size(Cone{{0.0f, 6.0f, 0.0f}, 2.0f, 2.0f}).y, 4.0, 0.02);
    EXPECT_TRUE(cuts(layout.level, Cone{{0.0f, -4.5f, 0.0f}, 1.0f, 1.0f}, centre)) << "from above into the slice";
    EXPECT_FALSE(cuts(layout.level, Cone{{0.0f, 4.5f, 0.0f}, 9.0f, 9.0f}, centre)) << "upward, away from it";
    EXPECT_TRUE(cuts(layout.level, Cone{{5.0f, 0.0f, 0.0f}, 1.0f, 4.1f}, centre));
    EXPECT_FALSE(cuts(layout.level, Cone{{5.0f, 0.0f, 0.0f}, 1.0f, 3.9f}, centre));
    EXPECT_TRUE(cuts(layout.level, Sphere{4.1f}, centre)); // the slice lies 4 m below the centre
    EXPECT_FALSE(cuts(layout.level, Sphere{3.9f}, centre));
    EXPECT_TRUE(cuts(layout.level, Capsule{{0.0f, -3.5f, 0.0f}, 1.0f}, centre));
}

TEST(Outline, PathIsSplitWhereItsBodyIs) {
    const FrameLayout layout = lay_out(box_of({32, 16, 32}, 1.0f), {0.0, 0.0, 0.0}, 1600);
    const std::vector<glm::dvec3> path{{0.0, 0.0, 4.0}, {10.0, 0.0, 4.0}, {20.0, 0.0, 4.0}};
    const PathParts parts = split_path(path, {12.5, 0.3, 4.0}, layout.level);
    const double split = layout.level.to_page(glm::dvec3(12.5, 0.0, 4.0)).x;
    EXPECT_NEAR(parts.past.back().x, split, 1e-6);
    EXPECT_NEAR(parts.future.front().x, split, 1e-6);
    EXPECT_NEAR(parts.past.front().x, layout.level.rect.x, 1e-6);
    EXPECT_NEAR(parts.future.back().x, layout.level.to_page(path.back()).x, 1e-6);
    EXPECT_TRUE(split_path({}, {}, layout.level).future.empty());
}

} // namespace
} // namespace windrow::cli
