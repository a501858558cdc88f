// Deposits of drag: where they are spread, the exact law, that they stay in their place, handles, snapshots and replays.
#include "fluid/event_log.h"
#include "fluid/wind_state.h"
#include "fluid/window.h"
#include "tests/winds.h"

#include <random>

namespace windrow {
namespace {

using namespace test;

constexpr Boundaries k_open{};

Box box_of_rows(bool own_rows) {
    Box box{{24, 12, 20}, 0.5f, Boundaries::open_over_floor(), nullptr};
    if (own_rows)
        box.rows = *RowTable::create({.first = 0.35f, .uniform = 4, .ratio = 1.2f}, box.cells.y, box.cell_size);
    return box;
}

Window window_of(const Box& box, CellIndex origin = {-12, 0, -10}) {
    return {.cells = box.cells, .cell_size = box.cell_size, .origin_cells = origin, .rows = box.rows.get()};
}

std::vector<float> drag_of(DragField& field, const Window& window, const Boundaries& boundaries = k_open) {
    const DragCells cells = field.cells_in(window, boundaries);
    return {cells.drag.begin(), cells.drag.end()};
}

// [m^2] Of all cells.
double area_in(const Box& box, std::span<const float> drag) {
    double area = 0.0;
    const auto h = static_cast<double>(box.cell_size);
    for_each_cell(box.cells, [&](int i, int j, int k) {
        area += static_cast<double>(drag[box.index(i, j, k)]) * static_cast<double>(box.volume(j)) * h * h * h;
    });
    return area;
}

std::vector<DragDeposit> random_deposits(int count, unsigned seed) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    const auto place = [&] { return glm::dvec3(between(-4.0, 4.0), between(0.0, 1.0), between(-3.0, 3.0)); };
    std::vector<DragDeposit> deposits;
    for (int n = 0; n < count; ++n) {
        const double base = between(0.0, 1.0);
        if (n % 2 == 0)
            deposits.push_back(PlantDrag{.position = place(),
                                         .radius = static_cast<float>(between(0.01, 1.0)),
                                         .base = static_cast<float>(base),
                                         .height = static_cast<float>(base + between(0.1, 2.0)),
                                         .area = static_cast<float>(between(0.1, 3.0))});
        else
            deposits.push_back(BeltDrag{.start = place(),
                                        .end = place() + glm::dvec3(0.01, 0.0, 0.0),
                                        .width = static_cast<float>(between(0.1, 1.5)),
                                        .height = static_cast<float>(between(0.1, 3.0)),
                                        .resistance = static_cast<float>(between(0.1, 3.0))});
    }
    return deposits;
}

double area_of(const DragDeposit& deposit) {
    if (const auto* plant = std::get_if<PlantDrag>(&deposit))
        return static_cast<double>(plant->area);
    const auto& belt = std::get<BeltDrag>(deposit);
    const glm::dvec3 way = belt.end - belt.start;
    return static_cast<double>(belt.resistance) * static_cast<double>(belt.height) * std::hypot(way.x, way.z);
}

TEST(Drag, AddsUpToTheAreaOfEachDeposit) {
    double worst = 0.0;
    for (const bool own_rows : {false, true}) {
        const Box box = box_of_rows(own_rows);
        for (const DragDeposit& deposit : random_deposits(200, 7)) {
            DragField field(box);
            ASSERT_TRUE(field.add(deposit));
            worst = std::max(worst, std::abs(area_in(box, drag_of(field, window_of(box))) / area_of(deposit) - 1.0));
        }
    }
    WINDROW_EXPECT_FIGURE("drag.area", worst, 1e-6);
}

TEST(Drag, IsSpreadOverNoLessThanTwoCells) {
    const Box box = box_of_rows(false);
    double plant_most = 0.0, belt_most = 0.0;
    for (int n = 0; n < 20; ++n) {
        const glm::dvec3 at(0.31 * n - 3.0, 0.0, 0.17 * n - 1.0);
        const auto most_of = [&](const DragDeposit& deposit) {
            DragField field(box);
            EXPECT_TRUE(field.add(deposit));
            const auto drag = drag_of(field, window_of(box));
            return static_cast<double>(*std::max_element(drag.begin(), drag.end()));
        };
        // All of it in a row of 2 x 2 cells of 0.125 m^3; a fence of 0.5 m rows over 1 m of thickness.
        plant_most = std::max(plant_most, most_of(PlantDrag{.position = at, .radius = 0.01f, .height = 0.5f, .area = 1.0f}));
        belt_most = std::max(
            belt_most, most_of(BeltDrag{.start = at, .end = at + glm::dvec3(3.0, 0.0, 0.5), .width = 0.02f, .height = 1.0f}));
    }
    EXPECT_LE(plant_most, 2.0 * (1.0 + 1e-6));
    EXPECT_LE(belt_most, 2.0 * (1.0 + 1e-6));
}

TEST(Drag, OfABeltIsItsResistanceAcrossIt) {
    const Box box = box_of_rows(false);
    for (const double turn : {0.0, 0.25 * pi, 0.5 * pi}) {
        const glm::dvec3 along(std::cos(turn), 0.0, std::sin(turn));
        DragField field(box);
        ASSERT_TRUE(
            field.add(BeltDrag{.start = -20.0 * along, .end = 20.0 * along, .width = 1.5f, .height = 2.0f, .resistance = 1.7f}));
        const auto drag = drag_of(field, window_of(box));
        double across = 0.0; // of a layer: over its length
        for (int k = 0; k < box.cells.z; ++k)
            for (int i = 0; i < box.cells.x; ++i)
                across += static_cast<double>(drag[box.index(i, 1, k)]) * 0.25;
        const double length = turn == 0.0 ? 12.0 : turn < 1.0 ? 10.0 * std::numbers::sqrt2 : 10.0;
        EXPECT_NEAR(across / length, 1.7, turn > 0.0 && turn < 1.0 ? 0.02 : 1e-5) << turn; // cut aslant at two sides of the box
    }
}

// The same bits as found afresh, wherever the box has been.
TEST(Drag, StaysInItsPlaceAsTheBoxMoves) {
    for (const bool own_rows : {false, true}) {
        const Box box = box_of_rows(own_rows);
        const auto deposits = random_deposits(300, 3);
        DragField field(box);
        ASSERT_TRUE(field.add(deposits));
        std::mt19937 random(5);
        CellIndex at(-12, 0, -10);
        for (int step = 0; step < 40; ++step) {
            for (int axis = 0; axis < 3; ++axis)
                at[axis] += static_cast<std::int64_t>(random() % 7) - 3;
            DragField fresh(box);
            ASSERT_TRUE(fresh.add(deposits));
            ASSERT_EQ(drag_of(field, window_of(box, at)), drag_of(fresh, window_of(box, at))) << step;
        }
    }
}

TEST(Drag, DoesNotDependOnTheOrderOfItsDeposits) {
    const Box box = box_of_rows(true);
    auto deposits = random_deposits(60, 11);
    DragField ordered(box);
    ASSERT_TRUE(ordered.add(deposits));
    const auto expected = drag_of(ordered, window_of(box));
    std::shuffle(deposits.begin(), deposits.end(), std::mt19937(2));
    DragField field(box);
    std::vector<DragId> passing(30), ids(deposits.size());
    ASSERT_TRUE(field.add(random_deposits(30, 12), passing));
    (void)drag_of(field, window_of(box));
    ASSERT_TRUE(field.add(random_deposits(60, 13), ids));
    for (std::size_t n = 0; n < ids.size(); ++n) {
        ASSERT_TRUE(field.set(ids[n], deposits[n]));
        if (n % 7 == 0)
            (void)drag_of(field, window_of(box));
    }
    for (const DragId id : passing)
        ASSERT_TRUE(field.remove(id));
    EXPECT_EQ(drag_of(field, window_of(box)), expected);
    EXPECT_EQ(field.count(), 60);
}

TEST(Drag, ReportsWhatHasChanged) {
    const Box box = box_of_rows(false);
    DragField field(box);
    const PlantDrag bush{.position = {0.0, 0.0, 0.0}, .radius = 0.5f, .height = 1.0f};
    const auto id = field.add(bush);
    ASSERT_TRUE(id);
    (void)drag_of(field, window_of(box));
    EXPECT_TRUE(field.take_change().whole);
    (void)drag_of(field, window_of(box));
    EXPECT_FALSE(field.take_change().any());
    ASSERT_TRUE(field.remove(*id));
    (void)drag_of(field, window_of(box));
    const DragChange removed = field.take_change();
    ASSERT_EQ(removed.count, 1);
    EXPECT_EQ(removed.ranges[0].low, glm::ivec3(11, 0, 9));
    EXPECT_EQ(removed.ranges[0].high, glm::ivec3(13, 2, 11));
    ASSERT_TRUE(field.add(bush));
    (void)drag_of(field, window_of(box));
    (void)field.take_change();
    (void)drag_of(field, window_of(box, {-11, 0, -10}));
    const DragChange moved = field.take_change();
    ASSERT_EQ(moved.count, 1);
    EXPECT_EQ(moved.ranges[0].low, glm::ivec3(23, 0, 0));
    EXPECT_EQ(moved.ranges[0].high, glm::ivec3(24, 12, 20));
}

TEST(Drag, StandsInEachPeriodOfAPeriodicBox) {
    const Box box{{8, 6, 8}, 1.0f, Boundaries::all(BoundaryKind::periodic), nullptr};
    const Window window = window_of(box, {0, 0, 0});
    const auto found = [&](glm::dvec3 by) {
        DragField field(box);
        EXPECT_TRUE(field.add(PlantDrag{.position = glm::dvec3(7.5, 1.0, 0.25) + by, .radius = 1.5f, .height = 2.0f}));
        EXPECT_TRUE(field.add(BeltDrag{.start = glm::dvec3(6.0, 0.0, 7.0) + by, .end = glm::dvec3(9.0, 0.0, 9.0) + by}));
        return drag_of(field, window, box.boundaries);
    };
    const auto here = found({});
    EXPECT_NEAR(area_in(box, here), 2.0 + 2.0 * 2.0 * std::hypot(3.0, 2.0), 1e-5);
    EXPECT_EQ(found({8.0, 0.0, -16.0}), here);
}

// --- The air -------------------------------------------------------------------------------------------------------------------

// c = 0.5 / m in all of the box: a belt of 64 m, wider than it.
const BeltDrag k_everywhere{
    .start = {-32.0, -32.0, 0.0}, .end = {32.0, -32.0, 0.0}, .width = 64.0f, .height = 64.0f, .resistance = 32.0f};

TEST(Drag, SlowsByTheExactLawWhateverTheStep) {
    const glm::dvec3 start(6.0, -2.0, 3.0);
    double worst = 0.0;
    for (const double dt : {0.1, 1.0, 10.0}) {
        Wind wind = sources_only({6, 5, 7});
        ASSERT_TRUE(wind.drag().add(k_everywhere));
        wind.set_velocity([&](glm::dvec3) { return glm::vec3(start); });
        take_steps(wind, 10, dt);
        const glm::dvec3 truth = start / (1.0 + 0.5 * 10.0 * dt * glm::length(start));
        for (const glm::vec4& u : wind.field())
            worst = std::max(worst, glm::length(glm::dvec3(u) - truth) / glm::length(start));
    }
    WINDROW_EXPECT_FIGURE("drag.law", worst, 1e-5);
    // Both halves of whole steps, in a box that is as long as the belt.
    worst = 0.0;
    for (const double dt : {0.1, 1.0, 10.0}) {
        Wind wind = made({.cells = {8, 8, 8},
                          .boundaries = Boundaries::all(BoundaryKind::periodic),
                          .relaxation_time = 0.0f,
                          .max_cfl = 1e6f});
        ASSERT_TRUE(wind.drag().add(
            BeltDrag{.start = {-4.0, -4.0, 0.0}, .end = {4.0, -4.0, 0.0}, .width = 8.0f, .height = 8.0f, .resistance = 4.0f}));
        wind.set_velocity([&](glm::dvec3) { return glm::vec3(start); });
        take_steps(wind, 10, dt);
        const glm::dvec3 truth = start / (1.0 + 0.5 * 10.0 * dt * glm::length(start));
        for (const glm::vec4& u : wind.field())
            worst = std::max(worst, glm::length(glm::dvec3(u) - truth) / glm::length(start));
    }
    WINDROW_EXPECT_FIGURE("drag.law_of_whole_steps", worst, 1e-5);
}

Config meadow(float gusts) {
    return {.cells = {16, 10, 14},
            .boundaries = Boundaries::open_over_floor(),
            .ambient = {6.0f, 0.0f, 1.0f},
            .gusts = {.intensity = gusts}};
}

TEST(Drag, OfACanopyIsThatOfOneBeltToTheBit) {
    for (const Scheme scheme : {Scheme::second_order, Scheme::stable_fluids})
        for (const float gusts : {0.0f, 0.2f}) {
            Config config = meadow(gusts);
            config.scheme = scheme;
            Wind belt = made(config);
            config.canopy = Canopy{.height = 2.5f, .drag = 0.5f};
            Wind canopy = made(config);
            const auto floor = static_cast<double>(belt.config().floor);
            ASSERT_TRUE(belt.drag().add(BeltDrag{
                .start = {-32.0, floor, 0.0}, .end = {32.0, floor, 0.0}, .width = 64.0f, .height = 2.5f, .resistance = 32.0f}));
            for (Wind* wind : {&belt, &canopy}) {
                added(*wind, DirectionalMotor{.position = {0.0, 2.0, 0.0}});
                added(*wind, DirectionalMotor{.position = {2.0, 1.0, 2.0}, .law = Force{}});
            }
            for (int step = 0; step < 12; ++step) {
                belt.step(1.0 / 30.0);
                canopy.step(1.0 / 30.0);
            }
            EXPECT_TRUE(std::ranges::equal(belt.field(), canopy.field())) << gusts;
        }
}

TEST(Drag, ThatIsElsewhereChangesNoBit) {
    const auto field_with = [](const std::function<void(Wind&)>& prepare) {
        Wind wind = made(meadow(0.2f));
        prepare(wind);
        take_steps(wind, 10, 1.0 / 30.0);
        return std::vector<glm::vec4>(wind.field().begin(), wind.field().end());
    };
    const auto without = field_with([](Wind&) {});
    EXPECT_EQ(field_with([](Wind& wind) { EXPECT_TRUE(wind.drag().add(PlantDrag{.position = {100.0, 0.0, 0.0}})); }), without);
    EXPECT_EQ(field_with([](Wind& wind) { EXPECT_TRUE(wind.drag().add(PlantDrag{.area = 0.0f})); }), without);
    EXPECT_EQ(field_with([](Wind& wind) {
                  const auto id = wind.drag().add(PlantDrag{});
                  EXPECT_TRUE(id && wind.drag().remove(*id));
              }),
              without);
    EXPECT_NE(field_with([](Wind& wind) { EXPECT_TRUE(wind.drag().add(PlantDrag{.radius = 3.0f, .height = 4.0f})); }), without);
}

// What a step takes from uniform air, by the law, over the time of the step.
TEST(Drag, GivesTheForceThatTheAirLoses) {
    Wind wind = sources_only({12, 8, 12});
    const auto id = wind.drag().add(PlantDrag{.position = {0.3, -2.0, 0.1}, .radius = 2.0f, .height = 3.3f, .area = 4.0f});
    const auto half_out = wind.drag().add(BeltDrag{.start = {0.0, -2.0, -1.0}, .end = {12.0, -2.0, -1.0}, .width = 2.0f});
    ASSERT_TRUE(id && half_out);
    wind.set_velocity([](glm::dvec3) { return glm::vec3(3.0f, 0.0f, 4.0f); });
    const auto load = wind.force_on(*id);
    ASSERT_TRUE(load);
    EXPECT_NEAR(load->force.x, 1.2 * 4.0 * 5.0 * 3.0, 1e-4);
    EXPECT_NEAR(load->force.z, 1.2 * 4.0 * 5.0 * 4.0, 1e-4);
    EXPECT_NEAR(load->in_box, 1.0, 1e-6);
    const auto part = wind.force_on(*half_out);
    ASSERT_TRUE(part);
    EXPECT_NEAR(part->in_box, 0.5, 1e-6);
    ASSERT_TRUE(wind.drag().remove(*half_out));
    EXPECT_FALSE(wind.force_on(*half_out));
    const glm::dvec3 before = sum_of(wind.field());
    wind.step(1e-4);
    const double lost = 1.2 * (before.x - sum_of(wind.field()).x) / 1e-4;
    WINDROW_EXPECT_FIGURE("drag.force", std::abs(lost / static_cast<double>(load->force.x) - 1.0), 1e-2);
}

TEST(Drag, WakesAirThatSleepsInAWind) {
    Config config = meadow(0.0f);
    config.relaxation_time = 1.0f;
    Wind wind = made(config);
    take_steps(wind, 20, 0.1);
    ASSERT_TRUE(wind.diagnostics().asleep);
    const auto id = wind.drag().add(PlantDrag{.radius = 2.0f});
    ASSERT_TRUE(id);
    EXPECT_FALSE(wind.step(0.1).asleep);
    take_steps(wind, 20, 0.1);
    EXPECT_FALSE(wind.diagnostics().asleep);
    ASSERT_TRUE(wind.drag().remove(*id));
    take_steps(wind, 400, 0.1);
    EXPECT_TRUE(wind.diagnostics().asleep);
    config.ambient = glm::vec3(0.0f);
    Wind still = made(config);
    ASSERT_TRUE(still.drag().add(PlantDrag{.radius = 2.0f}));
    take_steps(still, 20, 0.1);
    EXPECT_TRUE(still.diagnostics().asleep);
}

// --- Saved winds and logs ----------------------------------------------------------------------------------------------------

void walk(Wind& wind, int first, int steps) {
    for (int step = first; step < first + steps; ++step) {
        EXPECT_TRUE(wind.follow({0.4 * step, 0.0, -0.2 * step}));
        if (step % 4 == 0) {
            EXPECT_TRUE(wind.drag().add(PlantDrag{.position = {0.4 * step + 2.0, 0.0, 1.0}, .radius = 1.3f}));
        }
        if (step % 5 == 4) {
            EXPECT_TRUE(wind.shift_origin({step % 2 == 0 ? 7.0 : -7.0, 0.0, 0.0}));
        }
        wind.step(1.0 / 30.0);
    }
}

TEST(Drag, IsSavedAndReplayedToTheBit) {
    for (const bool own_rows : {false, true}) {
        Config config = meadow(0.2f);
        if (own_rows)
            config.rows = Rows{.first = 0.35f, .uniform = 4, .ratio = 1.2f};
        Wind wind = made(config);
        std::vector<DragId> ids(40);
        ASSERT_TRUE(wind.drag().add(random_deposits(40, 21), ids));
        ASSERT_TRUE(wind.drag().remove(ids[3]));
        walk(wind, 0, 10);
        const auto saved = wind.save();
        ASSERT_TRUE(saved);
        auto again = Wind::load(*saved), replayed = Wind::load(*saved);
        ASSERT_TRUE(again && replayed) << again.error();
        EXPECT_EQ(again->drag().count(), wind.drag().count());
        EXPECT_TRUE(again->drag().find(ids[5]) != nullptr && again->drag().find(ids[3]) == nullptr);
        EventLog log;
        wind.record_to(&log);
        for (Wind* one : {&wind, &*again}) {
            ASSERT_TRUE(one->drag().set(ids[6], PlantDrag{.position = {1.0, 0.0, 0.0}, .radius = 2.0f}));
            ASSERT_TRUE(one->drag().remove(ids[7]));
            walk(*one, 10, 10);
        }
        EXPECT_TRUE(std::ranges::equal(wind.field(), again->field()));
        const auto bytes = log.to_bytes();
        ASSERT_TRUE(bytes);
        const auto read = EventLog::from_bytes(*bytes);
        ASSERT_TRUE(read) << read.error();
        const auto done = replay(*read, *replayed);
        ASSERT_TRUE(done) << done.error();
        EXPECT_TRUE(std::ranges::equal(wind.field(), replayed->field()));
        EXPECT_EQ(*wind.save(), *replayed->save());
    }
}

// Readers among plants take no law of the wall, before the first step too.
TEST(Drag, IsReadAtOnceAfterALoad) {
    Wind wind = made({.cells = {16, 8, 12},
                      .boundaries = Boundaries::open_over_floor(),
                      .ambient = {5.0f, 0.0f, 0.0f},
                      .profile = LogProfile{},
                      .roughness = Roughness{}});
    ASSERT_TRUE(wind.drag().add(PlantDrag{.position = {0.3, 0.0, 0.2}, .radius = 1.2f, .height = 1.5f}));
    for (int n = 0; n < 20; ++n)
        (void)wind.step(1.0 / 20.0);
    const Wind again = *Wind::load(*wind.save());
    for (const double height : {0.02, 0.05, 0.2, 0.8, 2.0})
        EXPECT_EQ(wind.velocity({0.4, height, 0.1}), again.velocity({0.4, height, 0.1})) << height;
}

TEST(Drag, RejectsWhatItCannotUse) {
    const auto reason = [](const DragDeposit& deposit) {
        const auto valid = validate(deposit);
        return valid ? std::string() : valid.error();
    };
    EXPECT_EQ(reason(PlantDrag{}), "");
    EXPECT_EQ(reason(BeltDrag{}), "");
    EXPECT_NE(reason(PlantDrag{.radius = 0.0f}).find("plant.radius is 0 m"), std::string::npos)
        << reason(PlantDrag{.radius = 0.0f});
    EXPECT_NE(reason(PlantDrag{.base = 2.0f}).find("plant.base is 2 m and height 2 m: give a base below the height."),
              std::string::npos)
        << reason(PlantDrag{.base = 2.0f});
    EXPECT_NE(reason(PlantDrag{.area = k_nan}).find("plant.area is nan"), std::string::npos);
    EXPECT_NE(reason(BeltDrag{.start = {5.0, 3.0, 0.0}}).find("belt.end is 0 m from `start`"), std::string::npos)
        << reason(BeltDrag{.start = {5.0, 3.0, 0.0}});
    EXPECT_NE(reason(BeltDrag{.resistance = -1.0f}).find("belt.resistance is -1"), std::string::npos);

    Wind wind = made({.cells = {8, 8, 8}});
    const std::vector<DragDeposit> two{PlantDrag{}, PlantDrag{.height = -1.0f}};
    std::vector<DragId> ids(2);
    const auto bad = wind.drag().add(two, ids);
    ASSERT_FALSE(bad);
    EXPECT_NE(bad.error().find("deposit 1: plant.height is -1 m"), std::string::npos) << bad.error();
    EXPECT_EQ(wind.drag().count(), 0);
    EXPECT_FALSE(wind.drag().add(std::span(two).first(1), std::span(ids).first(2)));
    const auto id = wind.drag().add(PlantDrag{});
    ASSERT_TRUE(id);
    EXPECT_FALSE(wind.drag().set(*id, PlantDrag{.height = 0.0f}));
    EXPECT_EQ(std::get<PlantDrag>(*wind.drag().find(*id)).height, 2.0f);
    ASSERT_TRUE(wind.drag().remove(*id));
    EXPECT_FALSE(wind.drag().remove(*id));
    EXPECT_FALSE(wind.drag().set(*id, PlantDrag{}));
    EXPECT_FALSE(wind.force_on(*id));
    EXPECT_EQ(wind.drag().find(*id), nullptr);
}

} // namespace
} // namespace windrow
