// Pictures show the data: a slice's colours are those of the cells, arrows point where the air goes, files are whole or not
// there.
#include "cli/drawing/canvas.h"
#include "cli/drawing/frame.h"
#include "cli/drawing/layout.h"
#include "cli/drawing/motor_marks.h"
#include "cli/drawing/slice.h"
#include "cli/pictures.h"
#include "tests/own_folder.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

namespace windrow::cli {
namespace {

constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();

using PicturesTest = test::FolderTest;

SlicedAir air_of(const Wind& wind) {
    return {.box = wind.box(), .origin = wind.origin(), .ambient = wind.ambient(), .velocity = [&](auto at, auto to) {
                wind.velocity(at, to);
            }};
}

SlicedAir air_of(glm::ivec3 cells, float cell_size, glm::dvec3 origin, std::function<glm::vec3(glm::dvec3)> velocity_at) {
    SlicedAir air{.box = {.cells = cells, .cell_size = cell_size, .boundaries = {}},
                  .origin = origin,
                  .ambient = {3.0f, 0.0f, 1.0f},
                  .velocity = {}};
    air.velocity = [velocity_at](std::span<const glm::dvec3> positions, std::span<glm::vec3> velocities) {
        for (std::size_t index = 0; index < positions.size(); ++index)
            velocities[index] = velocity_at(positions[index]);
    };
    return air;
}

/// The default box, still.
SlicedAir still_air() {
    return air_of({32, 16, 32}, 1.0f, {}, [](glm::dvec3) { return glm::vec3(0.0f); });
}

/// A field in which every component differs from cell to cell.
glm::vec3 known_wind(glm::dvec3 p) {
    return {static_cast<float>(3.0 * std::sin(0.7 * p.x + 0.3 * p.z)), static_cast<float>(2.0 * std::cos(0.5 * p.y + 0.2 * p.x)),
            static_cast<float>(4.0 * std::sin(0.4 * p.z - 0.6 * p.y))};
}

void expect_colour(Rgb8 seen, Rgb8 wanted, int tolerance) {
    for (std::size_t channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(seen[channel], wanted[channel], tolerance);
}

Rgb8 colour_of(glm::vec3 velocity, float scale) {
    return speed_colour(glm::length(velocity) / scale);
}

// --- The PNG slice of each axis equals the data ----------------------------------------------------------------------

TEST_F(PicturesTest, SliceOfEachAxisEqualsTheCells) {
    // Without a rim: over it the cells fade to the ambient wind.
    auto wind = Wind::create({.cells = {13, 7, 10}, .cell_size = 0.5f, .centre = {40.0, 3.0, -9.0}, .blend_width = 0.0f});
    ASSERT_TRUE(wind);
    wind->set_velocity(known_wind);
    const SlicedAir air = air_of(*wind);
    constexpr int k_per_cell = 5; // odd, so that the middle pixel of a cell lies on its centre
    constexpr float k_scale = 5.0f;
    const glm::ivec3 cells = wind->box().cells;
    for (const Normal normal : {Normal::x, Normal::y, Normal::z}) {
        const int across = static_cast<int>(normal), layer = 3;
        const Plane plane{normal, wind->origin()[across] + (layer + 0.5) * 0.5};
        const int columns = cells[plane.right()], rows = cells[plane.along_height()];
        const SlicePicture slice = render_slice(air, plane, k_scale, columns * k_per_cell, rows * k_per_cell);
        EXPECT_EQ(slice.broken_pixels, 0);
        ASSERT_TRUE(write_png(slice.image, {}, folder / "slice.png"));
        const auto png = read_png(folder / "slice.png");
        ASSERT_TRUE(png);
        for (int row = 0; row < rows; ++row) {
            for (int column = 0; column < columns; ++column) {
                glm::ivec3 cell(layer);
                cell[plane.right()] = column;
                cell[plane.along_height()] = plane.grows_upward() ? rows - 1 - row : row;
                const glm::vec3 held(wind->field()[wind->box().index(cell.x, cell.y, cell.z)]);
                expect_colour(png->at(column * k_per_cell + 2, row * k_per_cell + 2), colour_of(held, k_scale), 2);
            }
        }
    }
}

TEST_F(PicturesTest, SliceBetweenCellsIsWhatAPlantReads) {
    auto wind = Wind::create({.cells = {8, 6, 9}, .ambient = {2.0f, 0.0f, 0.0f}});
    ASSERT_TRUE(wind);
    wind->set_velocity(known_wind);
    const SlicedAir air = air_of(*wind);
    const Plane plane{Normal::y, wind->origin().y + 2.2};
    const SlicePicture slice = render_slice(air, plane, 5.0f, 37, 29);
    for (int row = 0; row < 29; ++row) {
        for (int column = 0; column < 37; ++column) {
            const glm::dvec2 share((column + 0.5) / 37.0, (row + 0.5) / 29.0);
            const glm::dvec3 at = plane.to_world(plane.in_plane(wind->origin()) + share * plane.in_plane(air.extent()));
            expect_colour(slice.image.at(column, row), colour_of(wind->velocity(at), 5.0f), 2);
        }
    }
}

TEST_F(PicturesTest, AirThatIsNoNumberIsFlagged) {
    const SlicedAir air =
        air_of({4, 4, 4}, 1.0f, {}, [](glm::dvec3 p) { return p.x < 2.0 ? glm::vec3(k_nan) : glm::vec3(1.0f); });
    const SlicePicture slice = render_slice(air, {Normal::y, 2.0}, 10.0f, 8, 8);
    EXPECT_EQ(slice.broken_pixels, 32);
    EXPECT_EQ(slice.image.at(0, 0), k_broken_colour);
    EXPECT_NE(slice.image.at(7, 7), k_broken_colour);
    EXPECT_NEAR(slice.largest, std::sqrt(3.0f), 1e-5f);
}

// --- Colours ---------------------------------------------------------------------------------------------------------

TEST(ColourMap, EqualStepsOfSpeedAreEqualStepsOfLightness) {
    constexpr int k_steps = 20;
    const double first = to_oklab(speed_colour(0.0f)).x, last = to_oklab(speed_colour(1.0f)).x;
    EXPECT_LT(first, 0.2);
    EXPECT_GT(last, 0.93);
    for (int step = 0; step < k_steps; ++step) {
        const double rise = to_oklab(speed_colour(static_cast<float>(step + 1) / k_steps)).x -
                            to_oklab(speed_colour(static_cast<float>(step) / k_steps)).x;
        EXPECT_NEAR(rise, (last - first) / k_steps, 0.25 * (last - first) / k_steps) << step;
    }
}

TEST(ColourMap, IsHeldBeyondItsEnds) {
    EXPECT_EQ(speed_colour(-1.0f), speed_colour(0.0f));
    EXPECT_EQ(speed_colour(7.0f), speed_colour(1.0f));
}

// --- Arrows ----------------------------------------------------------------------------------------------------------

TEST(Arrows, FollowAKnownVortex) {
    // Solid rotation about a vertical line: the flow is across the radius and as fast as it is long.
    const glm::dvec2 centre(5.3, -3.2);
    const SlicedAir air = air_of({16, 8, 16}, 1.0f, {-4.0, 0.0, -12.0},
                                 [&](glm::dvec3 p) { return glm::vec3(-(p.z - centre.y), 0.0, p.x - centre.x); });
    const float scale = 6.0f;
    const auto arrows = slice_arrows(air, {Normal::y, 4.0}, 2.0, scale);
    EXPECT_EQ(arrows.size(), 64u);
    for (const WindArrow& arrow : arrows) {
        const glm::dvec2 radius = arrow.middle - centre;
        EXPECT_NEAR(glm::dot(arrow.direction, radius), 0.0, 1e-5 * glm::length(radius));
        EXPECT_GT(radius.x * arrow.direction.y - radius.y * arrow.direction.x, 0.0); // from x to z
        EXPECT_NEAR(arrow.share, std::min(1.0, glm::length(radius) / scale), 1e-5);
    }
}

TEST(Arrows, UprightOnesPointUpThePage) {
    const SlicedAir air = air_of({8, 8, 8}, 1.0f, {}, [](glm::dvec3) { return glm::vec3(0.0f, 2.0f, 9.0f); });
    const FrameLayout layout = lay_out(air, {4.0, 4.0, 4.0}, 1600);
    for (const WindArrow& arrow : slice_arrows(air, layout.upright.plane, 1.0, 10.0f)) {
        EXPECT_NEAR(layout.upright.turned(arrow.direction).y, -1.0, 1e-6); // the page's y runs down
        EXPECT_NEAR(arrow.share, 0.2, 1e-6);                               // the part out of the plane does not count
    }
}

TEST(Arrows, StandStillInTheWorldAsTheBoxMoves) {
    const auto still = [](glm::dvec3) { return glm::vec3(1.0f, 0.0f, 0.0f); };
    for (const double corner : {0.0, -8.5, 1e6 + 0.25}) {
        for (const double spacing : {0.5, 1.0, 4.0}) {
            const auto before =
                slice_arrows(air_of({17, 4, 17}, 1.0f, glm::dvec3(corner), still), {Normal::y, corner}, spacing, 5.0f);
            const auto after =
                slice_arrows(air_of({17, 4, 17}, 1.0f, glm::dvec3(corner + 3.0), still), {Normal::y, corner}, spacing, 5.0f);
            for (const WindArrow& arrow : after) {
                const double steps = (arrow.middle.x - before.front().middle.x) / spacing;
                EXPECT_NEAR(steps, std::round(steps), 1e-6) << corner << " " << spacing;
            }
        }
    }
}

TEST(Arrows, LeaveOutWhatIsNoNumberAndKeepAThinBoxesMiddle) {
    const SlicedAir broken =
        air_of({4, 4, 4}, 1.0f, {}, [](glm::dvec3 p) { return p.x < 2.0 ? glm::vec3(k_nan) : glm::vec3(1.0f); });
    EXPECT_EQ(slice_arrows(broken, {Normal::y, 2.0}, 1.0, 10.0f).size(), 8u);
    const SlicedAir thin = air_of({64, 1, 64}, 1.0f, {}, [](glm::dvec3) { return glm::vec3(1.0f); });
    for (const WindArrow& arrow : slice_arrows(thin, {Normal::z, 2.0}, 4.0, 10.0f))
        EXPECT_DOUBLE_EQ(arrow.middle.y, 0.5);
    const SlicedAir still = air_of({4, 4, 4}, 1.0f, {}, [](glm::dvec3) { return glm::vec3(0.0f); });
    EXPECT_EQ(slice_arrows(still, {Normal::y, 2.0}, 1.0, 10.0f).front().direction, glm::dvec2(0.0));
}

// --- Frames ----------------------------------------------------------------------------------------------------------

TEST(Frame, ShowsUniformWindInItsColourOnBothSlices) {
    const SlicedAir air = air_of({32, 16, 32}, 1.0f, {-7.0, 0.0, 3.0}, [](glm::dvec3) { return glm::vec3(4.0f, 0.0f, 0.0f); });
    const PictureSettings settings{.title = "uniform", .speed_scale = 8.0f, .slice_point = {0.0, 2.0, 9.0}};
    const auto image = compose_frame(air, 1.5, {}, {}, settings);
    ASSERT_TRUE(image);
    const FrameLayout layout = lay_out(air, settings.slice_point, settings.width);
    EXPECT_EQ(image->width, 1600);
    for (const Panel* panel : {&layout.level, &layout.upright}) {
        // Arrows stand at odd metres here, and the other slice cuts elsewhere.
        const glm::dvec2 at = panel->to_page(glm::dvec3(0.0, 12.0, 16.0)) * layout.unit;
        expect_colour(image->at(static_cast<int>(at.x), static_cast<int>(at.y)), speed_colour(0.5f), 2);
    }
}

TEST(Frame, DrawsWhateverItIsGiven) {
    const double inf = std::numeric_limits<double>::infinity();
    const std::vector<Trail> trails{
        {.name = "", .points = {}, .now = {}, .followed = true},
        {.name = "bad \xff\xfe name", .points = {{k_nan, 0.0, 0.0}, {1.0, 2.0, 3.0}}, .now = {inf, 0.0, 0.0}},
        {.name = "far", .points = {{-1e15, 0.0, 0.0}, {1e15, 1.0, 1.0}}, .now = {0.0, 0.0, 0.0}}};
    const std::vector<NamedMotor> motors{
        {"far away", DirectionalMotor{.position = {1e9, 0.0, 0.0}}},
        {std::string(5000, 'n'), DirectionalMotor{.direction = {0.0f, 1.0f, 0.0f}, .region = Sphere{1e7f}}},
        {"box", DirectionalMotor{.direction = {0.0f, 0.0f, 0.0f}, .region = AlignedBox{{1e-6f, 5.0f, 5.0f}}, .law = Force{}}},
        {"capsule", DirectionalMotor{.region = Capsule{{k_nan, 0.0f, 0.0f}, 1.0f}}},
        {"cone", DirectionalMotor{.region = Cone{{k_nan, 0.0f, 0.0f}, 1.0f, 2.0f}}},
        {"jet", JetMotor{.position = {1e9, 0.0, 0.0}}},
        {"jet", JetMotor{.direction = {0.0f, 0.0f, 0.0f}, .length = 1e6f, .end_radius = 1e6f}},
        {"vortex", VortexMotor{.axis = {0.0f, 0.0f, 0.0f}}},
        {"vortex", VortexMotor{.axis = {k_nan, 0.0f, 0.0f}, .radius = 1e6f}},
        {"vortex", VortexMotor{.radius = 1e-6f, .half_length = 1e6f, .law = Force{-1.0f}}},
        {"omni", OmniMotor{.radius = 1e6f, .speed = -1.0f}},
        {"omni", OmniMotor{.radius = 1e-6f}, k_nan},
        {"pressure", PressureMotor{.radius = 1e6f}, -0.1},
        {"pressure", PressureMotor{.position = {k_nan, 0.0, 0.0}}},
        {"wake", WakeMotor{.radius = 1e6f}},
        {"wake", WakeMotor{.position = {k_nan, 0.0, 0.0}}}};
    const auto wind = [](glm::dvec3 p) { return p.x > 3.0 ? glm::vec3(k_nan) : glm::vec3(1e38f, 1e38f, -1.0f); };
    for (const glm::ivec3 cells :
         {glm::ivec3(32, 16, 32), {17, 9, 23}, {64, 64, 1}, {1, 1, 1}, {2048, 1, 1}, {1, 1, 2048}, {2, 900, 2}}) {
        for (const float scale : {0.0f, k_nan, -1.0f, 1e-30f, 1e30f}) {
            const SlicedAir air = air_of(cells, 1.0f, {-1.0, 0.0, -1.0}, wind);
            const PictureSettings settings{
                .title = "\xc3\x28", .width = 640, .speed_scale = scale, .slice_point = {k_nan, 1e30, -inf}};
            const auto image = compose_frame(air, inf, trails, motors, settings);
            ASSERT_TRUE(image) << image.error();
            EXPECT_EQ(image->width, 640);
            EXPECT_EQ(image->height % 2, 0);
        }
    }
}

/// Pixels that differ on a panel.
int changed(const Image& a, const Image& b, const Rect& rect, double unit) {
    int count = 0;
    for (int row = static_cast<int>(rect.y * unit); row < static_cast<int>(rect.bottom() * unit); ++row)
        for (int column = static_cast<int>(rect.x * unit); column < static_cast<int>(rect.right() * unit); ++column)
            count += a.at(column, row) != b.at(column, row) ? 1 : 0;
    return count;
}

TEST(Frame, ShowsEachKindOfMotorInItsColour) {
    const SlicedAir air = still_air();
    const PictureSettings settings{.title = "", .slice_point = {16.0, 8.0, 16.0}};
    const glm::dvec3 middle(16.0, 8.0, 16.0);
    const FrameLayout layout = lay_out(air, settings.slice_point, settings.width);
    for (const Motor& kind : {Motor(DirectionalMotor{}), Motor(WakeMotor{.radius = 2.0f}), Motor(JetMotor{}),
                              Motor(VortexMotor{}), Motor(OmniMotor{}), Motor(PressureMotor{})}) {
        Motor motor = kind;
        std::visit([&](auto& any) { any.position = middle; }, motor);
        const auto with = compose_frame(air, 0.0, {}, std::vector<NamedMotor>{{"it", motor}}, settings);
        ASSERT_TRUE(with);
        const Colour colour = style_of(motor).colour;
        for (const Panel* panel : {&layout.level, &layout.upright}) {
            int hits = 0;
            for (int row = 0; row < panel->height_px; ++row)
                for (int column = 0; column < panel->width_px; ++column) {
                    const Rgb8 seen = with->at(static_cast<int>(panel->rect.x * layout.unit) + column,
                                               static_cast<int>(panel->rect.y * layout.unit) + row);
                    hits += std::abs(seen[0] - 255 * colour.red) < 3 && std::abs(seen[1] - 255 * colour.green) < 3 &&
                                    std::abs(seen[2] - 255 * colour.blue) < 3
                                ? 1
                                : 0;
                }
            EXPECT_GT(hits, 100) << style_of(motor).name;
        }
    }
}

TEST(Frame, LeavesOutMotorsThatDoNothingNow) {
    const SlicedAir air = still_air();
    const PictureSettings settings{.title = "", .slice_point = {16.0, 8.0, 16.0}};
    const FrameLayout layout = lay_out(air, settings.slice_point, settings.width);
    const auto draw = [&](double strength) {
        return *compose_frame(
            air, 0.0, {}, std::vector<NamedMotor>{{"burst", PressureMotor{.position = {16.0, 8.0, 16.0}}, strength}}, settings);
    };
    const Image none = *compose_frame(air, 0.0, {}, {}, settings);
    EXPECT_EQ(changed(none, draw(0.001), layout.level.rect, layout.unit), 0);
    EXPECT_GT(changed(none, draw(-0.1), layout.level.rect, layout.unit), 500);
    EXPECT_GT(changed(draw(-1.0), draw(1.0), layout.level.rect, layout.unit), 100) << "its arrows point the other way";
}

TEST(Frame, ManyMotorsLeaveTheAirInSight) {
    const SlicedAir air = still_air();
    const PictureSettings settings{.title = "", .slice_point = {16.0, 2.0, 16.0}};
    const FrameLayout layout = lay_out(air, settings.slice_point, settings.width);
    std::vector<NamedMotor> motors;
    for (int i = 0; i < 300; ++i) {
        Motor motor = i % 3 == 0 ? Motor(JetMotor{}) : i % 3 == 1 ? Motor(VortexMotor{.radius = 2.0f}) : Motor(OmniMotor{});
        const glm::dvec3 at(1.0 + 3.1 * (i % 10), 0.5 + 0.5 * static_cast<double>(i % 31), 1.0 + static_cast<double>(i / 10));
        std::visit([&](auto& any) { any.position = at; }, motor);
        motors.push_back({"motor " + std::to_string(i), motor});
    }
    const Image none = *compose_frame(air, 0.0, {}, {}, settings);
    const Image many = *compose_frame(air, 0.0, {}, motors, settings);
    const int pixels = layout.level.width_px * layout.level.height_px;
    EXPECT_LT(changed(none, many, layout.level.rect, layout.unit), pixels / 2);
    // Plates of names would be dark boxes by the hundred; the legend names each kind once, with its count.
    EXPECT_EQ(none.height, many.height);
}

TEST(Frame, IsTheSameEveryTime) {
    const SlicedAir air = air_of({8, 4, 8}, 1.0f, {}, known_wind);
    const auto first = compose_frame(air, 0.0, {}, {}, {.title = "", .width = 641});
    const auto second = compose_frame(air, 0.0, {}, {}, {.title = "", .width = 641});
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->width, 640); // even
    EXPECT_EQ(first->values, second->values);
}

TEST_F(PicturesTest, WidthOutsideTheBoundsIsRejectedByName) {
    auto wind = cases::BackendWind::create({.cells = {4, 4, 4}});
    ASSERT_TRUE(wind);
    for (const int width : {1, 639, 8001, 10000, -5}) {
        const auto drawn = draw_frame(**wind, 0.0, {}, {}, {}, {.title = "", .width = width}, folder / "frame.png");
        ASSERT_FALSE(drawn);
        EXPECT_NE(drawn.error().find("width " + std::to_string(width)), std::string::npos) << drawn.error();
        EXPECT_NE(drawn.error().find("frame.png"), std::string::npos) << drawn.error();
    }
    EXPECT_EQ(entries(), 0);
}

TEST_F(PicturesTest, FrameOfAWindIsOneFileThatKnowsItsTime) {
    auto wind = cases::BackendWind::create(
        {.cells = {8, 4, 8}, .boundaries = Boundaries::open_over_floor(), .ambient = {3.0f, 0.0f, 0.0f}});
    ASSERT_TRUE(wind);
    ASSERT_TRUE(draw_frame(**wind, 3.4, {}, {}, {}, {.title = "meadow", .width = 800}, folder / "frame.png"));
    EXPECT_EQ(entries(), 1);
    PngWords words;
    const auto png = read_png(folder / "frame.png", &words);
    ASSERT_TRUE(png);
    EXPECT_EQ(png->width, 800);
    EXPECT_EQ(words.title, "meadow");
    EXPECT_EQ(words.description, "t = 3.40 s");
}

// --- Files -----------------------------------------------------------------------------------------------------------

TEST_F(PicturesTest, FailedWriteNamesTheFileAndLeavesNothing) {
    const Image image(16, 16);
    const auto missing = write_png(image, {}, folder / "none" / "a.png");
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().find("a.png"), std::string::npos) << missing.error();
    EXPECT_FALSE(missing.error().starts_with(k_disk_fault));
    std::filesystem::create_directory(folder / "b.png");
    EXPECT_FALSE(write_png(image, {}, folder / "b.png"));
    EXPECT_EQ(entries(), 1);
}

TEST_F(PicturesTest, DiskThatTakesNoMoreKeepsTheOldFileAndSaysSo) {
    const std::filesystem::path file = folder / "frame.png";
    ASSERT_TRUE(write_png(Image(4, 4), {}, file));
    const auto old_size = std::filesystem::file_size(file);
    Image large(600, 600);
    std::mt19937 noise; // does not compress
    for (std::uint8_t& value : large.values)
        value = static_cast<std::uint8_t>(noise());

    // A size limit stops the write midway, as a full disk does.
    const auto written = [&] {
        const test::FileSizeLimit limit(20000);
        return write_png(large, {}, file);
    }();
    ASSERT_FALSE(written);
    EXPECT_TRUE(written.error().starts_with(k_disk_fault)) << written.error();
    EXPECT_NE(written.error().find("frame.png"), std::string::npos) << written.error();
    EXPECT_EQ(entries(), 1);
    EXPECT_EQ(std::filesystem::file_size(file), old_size);
    EXPECT_TRUE(read_png(file));
}

// --- Contact sheets --------------------------------------------------------------------------------------------------

TEST_F(PicturesTest, ContactSheetHasTheFramesInOrder) {
    std::vector<std::filesystem::path> frames;
    for (int frame = 0; frame < 6; ++frame) {
        Image image(820, 451); // shrinks to 800 x 440
        for (std::size_t index = 0; index < image.values.size(); ++index)
            image.values[index] = static_cast<std::uint8_t>(40 * frame);
        frames.push_back(folder / (std::to_string(frame) + ".png"));
        ASSERT_TRUE(write_png(image, {"run", "t"}, frames.back()));
    }
    ASSERT_TRUE(draw_contact_sheet(frames, folder / "sheet.png"));
    const auto sheet = read_png(folder / "sheet.png");
    ASSERT_TRUE(sheet);
    // Three columns of 800 px with gaps of 28 and margins of 48; two rows of 440 px, each under a caption of 44; a title of 64.
    EXPECT_EQ(sheet->width, 2 * 48 + 3 * 800 + 2 * 28);
    EXPECT_EQ(sheet->height, 2 * 48 + 64 + 2 * (44 + 440) + 28);
    for (int frame = 0; frame < 6; ++frame) {
        const int column = 48 + (frame % 3) * 828 + 400, row = 48 + 64 + (frame / 3) * (44 + 440 + 28) + 44 + 220;
        const auto shade = static_cast<std::uint8_t>(40 * frame);
        expect_colour(sheet->at(column, row), {shade, shade, shade}, 1);
    }
    ASSERT_TRUE(draw_contact_sheet(std::span(frames).first(1), folder / "one.png"));
    EXPECT_EQ(read_png(folder / "one.png")->width, 2 * 48 + 800);
    ASSERT_TRUE(draw_contact_sheet(std::span(frames).first(4), folder / "four.png"));
    EXPECT_EQ(read_png(folder / "four.png")->width, 2 * 48 + 2 * 800 + 28);
}

TEST_F(PicturesTest, ContactSheetOfARunHasTheLegendOnce) {
    auto wind = cases::BackendWind::create({.ambient = {3.0f, 0.0f, 0.0f}});
    ASSERT_TRUE(wind);
    const PictureSettings settings{.title = "run"};
    std::vector<std::filesystem::path> frames;
    for (int frame = 0; frame < 4; ++frame) {
        frames.push_back(folder / (std::to_string(frame) + ".png"));
        ASSERT_TRUE(draw_frame(**wind, frame, {}, {}, {}, settings, frames.back()));
    }
    const FrameParts parts = frame_parts(**wind, settings);
    const auto page = read_png(frames.front());
    ASSERT_TRUE(page);
    for (const PixelRect& part : {parts.level, parts.upright, parts.legend}) {
        EXPECT_GE(part.x, 0);
        EXPECT_GE(part.y, 0);
        EXPECT_LE(part.x + part.width, page->width);
        EXPECT_LE(part.y + part.height, page->height);
    }
    ASSERT_TRUE(draw_contact_sheet(frames, folder / "sheet.png", parts));
    const auto sheet = read_png(folder / "sheet.png");
    ASSERT_TRUE(sheet);
    // Two by two tiles of both slices, 800 px at most, with one legend at the foot.
    const double tall = parts.level.height + parts.upright.height;
    const int tile_width = static_cast<int>(std::lround(std::max(parts.level.width, parts.upright.width) * 800.0 / tall));
    EXPECT_EQ(sheet->width, 2 * 48 + std::max(2 * tile_width + 28, parts.legend.width));
    EXPECT_EQ(sheet->height, 2 * 48 + 64 + 2 * (44 + 800) + 28 + 28 + 44 + parts.legend.height);
    // Parts that do not fit the pictures at hand are held inside them.
    ASSERT_TRUE(write_png(Image(30, 20), {}, folder / "small.png"));
    EXPECT_TRUE(draw_contact_sheet(std::vector{folder / "small.png"}, folder / "sheet.png", parts));
}

TEST_F(PicturesTest, ContactSheetRejectsWhatItCannotRead) {
    const std::filesystem::path sheet = folder / "sheet.png", damaged = folder / "damaged.png";
    EXPECT_FALSE(draw_contact_sheet({}, sheet));
    EXPECT_FALSE(draw_contact_sheet(std::vector<std::filesystem::path>(65, damaged), sheet));
    const std::vector missing{folder / "missing.png"};
    const auto none = draw_contact_sheet(missing, sheet);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().find("missing.png"), std::string::npos) << none.error();
    ASSERT_TRUE(write_png(Image(200, 200), {}, damaged));
    std::filesystem::resize_file(damaged, std::filesystem::file_size(damaged) / 2);
    const auto half = draw_contact_sheet(std::vector{damaged}, sheet);
    ASSERT_FALSE(half);
    EXPECT_NE(half.error().find("damaged.png"), std::string::npos) << half.error();
    EXPECT_FALSE(std::filesystem::exists(sheet));
}

} // namespace
} // namespace windrow::cli
