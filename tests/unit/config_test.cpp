// What a Config is rejected for: each reason by itself, with the field, its value and the fix, and all of them at once.

#include "fluid/wind.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace windrow;

constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
constexpr float k_infinity = std::numeric_limits<float>::infinity();

struct ConfigMistake {
    const char* field; ///< how the sentence begins
    const char* value; ///< what it says of the value
    const char* fix;   ///< what it asks for
    std::function<void(Config&)> make;
};

void PrintTo(const ConfigMistake& fault, std::ostream* stream) {
    *stream << fault.field << fault.value;
}

std::vector<ConfigMistake> every_fault() {
    std::vector<ConfigMistake> faults;
    const auto add = [&](const char* field, const char* value, const char* fix, std::function<void(Config&)> make) {
        faults.push_back({field, value, fix, std::move(make)});
    };
    add("cells", " is (0, 16, 32)", "1 to 2048", [](Config& c) { c.cells.x = 0; });
    add("cells", " is (32, -4, 32)", "1 to 2048", [](Config& c) { c.cells.y = -4; });
    add("cells", " is (32, 16, 2049)", "1 to 2048", [](Config& c) { c.cells.z = 2049; });
    add("cells", " is (-2147483648, 16, 32)", "1 to 2048", [](Config& c) { c.cells.x = std::numeric_limits<int>::min(); });
    add("cells", " is (32, 16, 2147483647)", "1 to 2048", [](Config& c) { c.cells.z = std::numeric_limits<int>::max(); });
    add("cells", " is (2048, 2048, 17), 71303168 in all", "at most 67108864", [](Config& c) { c.cells = {2048, 2048, 17}; });
    add("cell_size", " is 0 m", "1e-6 to 1e6", [](Config& c) { c.cell_size = 0.0f; });
    add("cell_size", " is -1 m", "1e-6 to 1e6", [](Config& c) { c.cell_size = -1.0f; });
    add("cell_size", " is 2e+06 m", "1e-6 to 1e6", [](Config& c) { c.cell_size = 2e6f; });
    add("cell_size", " is 1e-07 m", "1e-6 to 1e6", [](Config& c) { c.cell_size = 1e-7f; });
    add("cell_size", " is nan m", "1e-6 to 1e6", [](Config& c) { c.cell_size = k_nan; });
    add("cell_size", " is inf m", "1e-6 to 1e6", [](Config& c) { c.cell_size = k_infinity; });
    add("boundaries.x_high", " is not periodic", "both boundaries",
        [](Config& c) { c.boundaries.x_low.kind = BoundaryKind::periodic; });
    add("boundaries.z_low", " is not periodic", "both boundaries",
        [](Config& c) { c.boundaries.z_high.kind = BoundaryKind::periodic; });
    add("boundaries.y_low.wall_velocity", " is (nan, 0, 0) m/s", "-10000 to 10000 m/s", [](Config& c) {
        c.boundaries.y_low = {BoundaryKind::no_slip, {k_nan, 0.0f, 0.0f}};
    });
    add("boundaries.y_low.wall_velocity", " is (3e+38, 0, 0) m/s", "-10000 to 10000 m/s", [](Config& c) {
        c.boundaries.y_low = {BoundaryKind::no_slip, {3e38f, 0.0f, 0.0f}};
    });
    add("boundaries.z_low.kind", " is 77", "periodic",
        [](Config& c) { c.boundaries.z_low.kind = static_cast<BoundaryKind>(77); });
    add("scheme", " is 9", "second_order", [](Config& c) { c.scheme = static_cast<Scheme>(9); });
    add("interpolation", " is 9", "cubic", [](Config& c) { c.interpolation = static_cast<Interpolation>(9); });
    add("simd", " is 9", "baseline", [](Config& c) { c.simd = static_cast<Simd>(9); });
    add("boundaries.y_low.wall_velocity", " is (0, 2, 0) m/s", "normal to the wall: set that component to 0", [](Config& c) {
        c.boundaries.y_low = {BoundaryKind::no_slip, {0.0f, 2.0f, 0.0f}};
    });
    add("boundaries.y_low.wall_velocity", " is (1, 0, 0) m/s", "no_slip", [](Config& c) {
        c.boundaries.y_low = {BoundaryKind::free_slip, {1.0f, 0.0f, 0.0f}};
    });
    add("centre", " is (nan, 0, 0) m", "1e12", [](Config& c) { c.centre.x = std::numeric_limits<double>::quiet_NaN(); });
    add("centre", " is (0, -inf, 0) m", "1e12", [](Config& c) { c.centre.y = -std::numeric_limits<double>::infinity(); });
    add("centre", " is (0, 0, 1e+13) m", "1e12", [](Config& c) { c.centre.z = 1e13; });
    add("follow_axes", " has x, where a boundary is solid", "open both boundaries", [](Config& c) {
        c.boundaries.x_high.kind = BoundaryKind::free_slip;
        c.follow_axes = glm::bvec3(true, false, false);
    });
    add("follow_axes", " has y, where a boundary is solid", "set_floor", [](Config& c) {
        c.boundaries = Boundaries::open_over_floor();
        c.follow_axes = glm::bvec3(true);
    });
    add("follow_axes", " has z, where a boundary is periodic", "open both boundaries", [](Config& c) {
        c.boundaries.z_low.kind = c.boundaries.z_high.kind = BoundaryKind::periodic;
        c.follow_axes = glm::bvec3(true);
    });
    add("ambient", " is (0, nan, 0) m/s", "10000 m/s", [](Config& c) { c.ambient.y = k_nan; });
    add("ambient", " is (0, 0, -inf) m/s", "10000 m/s", [](Config& c) { c.ambient.z = -k_infinity; });
    add("ambient", " is (20000, 0, 0) m/s", "10000 m/s", [](Config& c) { c.ambient.x = 2e4f; });
    add("viscosity", " is -0.1 m^2/s", "0 to 1e9", [](Config& c) { c.viscosity = -0.1f; });
    add("viscosity", " is nan m^2/s", "0 to 1e9", [](Config& c) { c.viscosity = k_nan; });
    add("viscosity", " is 2e+09 m^2/s", "0 to 1e9", [](Config& c) { c.viscosity = 2e9f; });
    add("relaxation_time", " is -1 s", "0 (never) to 1e9", [](Config& c) { c.relaxation_time = -1.0f; });
    add("relaxation_time", " is nan s", "0 (never) to 1e9", [](Config& c) { c.relaxation_time = k_nan; });
    add("relaxation_time", " is inf s", "0 (never) to 1e9", [](Config& c) { c.relaxation_time = k_infinity; });
    add("max_cfl", " is 0", "above 0", [](Config& c) { c.max_cfl = 0.0f; });
    add("max_cfl", " is -2", "above 0", [](Config& c) { c.max_cfl = -2.0f; });
    add("max_cfl", " is nan", "above 0", [](Config& c) { c.max_cfl = k_nan; });
    add("max_cfl", " is inf", "at most 1e6", [](Config& c) { c.max_cfl = k_infinity; });
    add("max_substeps", " is 0", "1 to 64", [](Config& c) { c.max_substeps = 0; });
    add("max_substeps", " is 65", "1 to 64", [](Config& c) { c.max_substeps = 65; });
    add("blend_width", " is -1", "0 (none) to 64", [](Config& c) { c.blend_width = -1.0f; });
    add("blend_width", " is 65", "0 (none) to 64", [](Config& c) { c.blend_width = 65.0f; });
    add("blend_width", " is nan", "0 (none) to 64", [](Config& c) { c.blend_width = k_nan; });
    add("canopy.height", " is -1 m", "0 (none) to 1000 m", [](Config& c) { c.canopy = Canopy{.height = -1.0f}; });
    add("canopy.height", " is nan m", "0 (none) to 1000 m", [](Config& c) { c.canopy = Canopy{.height = k_nan}; });
    add("roughness.length", " is 0 m", "1e-6 to 100 m", [](Config& c) { c.roughness = Roughness{.length = 0.0f}; });
    add("roughness.longest_mixing", " is -1 m", "0 (no limit) to 100000 m",
        [](Config& c) { c.roughness = Roughness{.longest_mixing = -1.0f}; });
    add("roughness.map", " has no lengths", "HeightMap::create",
        [](Config& c) { c.roughness = Roughness{.map = RoughnessMap{}}; });
    add("rows.first", " is 0 m", "above 0", [](Config& c) { c.rows.emplace(Rows{.first = 0.0f}); });
    add("rows.uniform", " is 0", "1 to 2048", [](Config& c) { c.rows.emplace(Rows{.uniform = 0}); });
    add("rows.ratio", " is 2", "1 to 1.5", [](Config& c) { c.rows.emplace(Rows{.ratio = 2.0f}); });
    add("rows.top", " is -1 m", "0 (by the ratio) to", [](Config& c) { c.rows.emplace(Rows{.top = -1.0f}); });
    add("rows.heights[1]", " is nan m", "above 0", [](Config& c) { c.rows.emplace(Rows{.heights = {1.0f, k_nan}}); });
    add("canopy.drag", " is 10000 1/m", "0 (none) to 1000 1/m", [](Config& c) { c.canopy = Canopy{.drag = 1e4f}; });
    add("ticks.hz", " is 0", "1 to 10000", [](Config& c) { c.ticks.hz = 0.0; });
    add("ticks.hz", " is -1", "1 to 10000", [](Config& c) { c.ticks.hz = -1.0; });
    add("ticks.hz", " is nan", "1 to 10000", [](Config& c) { c.ticks.hz = std::numeric_limits<double>::quiet_NaN(); });
    add("ticks.hz", " is 1e+05", "1 to 10000", [](Config& c) { c.ticks.hz = 1e5; });
    add("ticks.max_per_call", " is 0", "give", [](Config& c) { c.ticks.max_per_call = 0; });
    return faults;
}

class ConfigFault : public testing::TestWithParam<ConfigMistake> {};

TEST_P(ConfigFault, IsNamedAloneWithValueAndFix) {
    const ConfigMistake& fault = GetParam();
    Config config;
    fault.make(config);
    const Result<void> valid = validate(config);
    ASSERT_FALSE(valid);
    const std::string& sentence = valid.error();
    EXPECT_EQ(sentence.find(std::string(fault.field) + fault.value), 0u) << sentence;
    EXPECT_NE(sentence.find(fault.fix), std::string::npos) << sentence;
    EXPECT_EQ(std::count(sentence.begin(), sentence.end(), '\n'), 0) << "one fault, one sentence, but: " << sentence;
    EXPECT_EQ(sentence.back(), '.') << sentence;
    const auto wind = Wind::create(config);
    ASSERT_FALSE(wind);
    EXPECT_EQ(wind.error(), sentence);
}

INSTANTIATE_TEST_SUITE_P(Every, ConfigFault, testing::ValuesIn(every_fault()));

TEST(Config, AllReasonsComeAtOnce) {
    Config config;
    config.cells = {0, 16, 32};
    config.cell_size = -1.0f;
    config.boundaries.x_low.kind = BoundaryKind::periodic;
    config.boundaries.y_low = {BoundaryKind::no_slip, {0.0f, 1.0f, 0.0f}};
    config.centre.x = std::numeric_limits<double>::quiet_NaN();
    config.follow_axes = glm::bvec3(true);
    config.ambient.x = k_nan;
    config.viscosity = -1.0f;
    config.relaxation_time = -1.0f;
    config.max_cfl = 0.0f;
    config.max_substeps = 0;
    const std::string sentences = validate(config).error();
    for (const char* field : {"cells is", "cell_size is", "boundaries.x_high is", "boundaries.y_low.wall_velocity is",
                              "centre is", "follow_axes has x", "follow_axes has y", "ambient is", "viscosity is",
                              "relaxation_time is", "max_cfl is", "max_substeps is"})
        EXPECT_NE(sentences.find(field), std::string::npos) << field << " is missing from:\n" << sentences;
    EXPECT_EQ(std::count(sentences.begin(), sentences.end(), '\n'), 11) << sentences;
}

TEST(Config, LimitsThemselvesAreAccepted) {
    const auto accepted = [](auto change) {
        Config config;
        change(config);
        const Result<void> valid = validate(config);
        EXPECT_TRUE(valid) << valid.error();
    };
    accepted([](Config&) {});
    accepted([](Config& c) { c.cells = {1, 1, 1}; });
    accepted([](Config& c) { c.cells = {2048, 1, 1}; });
    accepted([](Config& c) { c.cells = {2048, 2048, 16}; });
    accepted([](Config& c) { c.cell_size = 1e-6f; });
    accepted([](Config& c) { c.cell_size = 1e6f; });
    accepted([](Config& c) { c.centre = {1e12, -1e12, 0.0}; });
    accepted([](Config& c) { c.ambient = {1e4f, -1e4f, 0.0f}; });
    accepted([](Config& c) { c.viscosity = 0.0f; });
    accepted([](Config& c) { c.viscosity = 1e9f; });
    accepted([](Config& c) { c.relaxation_time = 0.0f; });
    accepted([](Config& c) { c.relaxation_time = 1e9f; });
    accepted([](Config& c) { c.max_cfl = 1e-30f; });
    accepted([](Config& c) { c.max_cfl = 1e6f; });
    accepted([](Config& c) { c.max_substeps = 1; });
    accepted([](Config& c) { c.max_substeps = 64; });
    accepted([](Config& c) { c.follow_axes = glm::bvec3(false); });
    accepted([](Config& c) {
        c.boundaries = Boundaries::open_over_floor();
        c.follow_axes = glm::bvec3(true, false, true);
    });
}

TEST(Config, IsCopiedOnCreation) {
    const Config config{
        .cells = {5, 6, 7}, .cell_size = 0.25f, .ambient = {1.0f, 2.0f, 3.0f}, .viscosity = 0.5f, .max_substeps = 3};
    auto wind = Wind::create(config);
    ASSERT_TRUE(wind);
    EXPECT_EQ(wind->config().cells, config.cells);
    EXPECT_EQ(wind->config().cell_size, config.cell_size);
    EXPECT_EQ(wind->config().ambient, config.ambient);
    EXPECT_EQ(wind->config().viscosity, config.viscosity);
    EXPECT_EQ(wind->config().max_substeps, config.max_substeps);
    EXPECT_EQ(wind->box().cells, config.cells);
    EXPECT_EQ(wind->field().size(), 5u * 6u * 7u);
}

TEST(Config, RejectedChangesLeaveEverythingAsItWas) {
    auto wind = Wind::create({.follow_axes = glm::bvec3(true, false, true), .ambient = {1.0f, 0.0f, 2.0f}});
    ASSERT_TRUE(wind);
    Boundaries broken;
    broken.x_low.kind = BoundaryKind::periodic;
    Boundaries wall_across;
    wall_across.z_low.kind = BoundaryKind::no_slip;
    wall_across.y_low.kind = BoundaryKind::periodic;
    EXPECT_FALSE(wind->set_ambient({k_nan, 0.0f, 0.0f}));
    EXPECT_FALSE(wind->set_ambient({0.0f, 2e4f, 0.0f}));
    EXPECT_FALSE(wind->set_boundaries(broken));
    const auto rejected = wind->set_boundaries(wall_across);
    ASSERT_FALSE(rejected);
    EXPECT_NE(rejected.error().find("boundaries.y_high is not periodic"), std::string::npos) << rejected.error();
    EXPECT_NE(rejected.error().find("follow_axes has z"), std::string::npos) << rejected.error();
    EXPECT_EQ(wind->ambient(), glm::vec3(1.0f, 0.0f, 2.0f));
    EXPECT_EQ(wind->config().boundaries, Boundaries{});
    EXPECT_EQ(wind->box().boundaries, Boundaries{});

    EXPECT_TRUE(wind->set_boundaries(Boundaries::open_over_floor()));
    EXPECT_EQ(wind->box().boundaries, Boundaries::open_over_floor());
    EXPECT_EQ(wind->config().boundaries, Boundaries::open_over_floor());
}

TEST(Rows, OfAnImpossibleShapeAreRejectedInASentence) {
    Rows alternate{.heights = {0.5f}};
    for (int row = 1; row < k_max_rows; ++row)
        alternate.heights.push_back(alternate.heights.back() + (row % 2 == 0 ? 1.0f : 1.999f));
    const auto turns = RowTable::create(alternate, k_max_rows, 1.0f);
    ASSERT_FALSE(turns);
    EXPECT_NE(turns.error().find("rows.heights have distances that grow and shrink by turns"), std::string::npos)
        << turns.error();
    EXPECT_FALSE(RowTable::create({}, k_max_rows + 1, 1.0f));
    const auto even = RowTable::create({.first = 0.7f, .uniform = 20, .top = 7.0f}, 10, 1.0f);
    EXPECT_TRUE(even) << "the top differs from the height of equal rows by rounding alone: " << even.error();
}

} // namespace
