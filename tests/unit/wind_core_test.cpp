// The core of a wind over a storage without cells: which changes, steps and frames it asks for, and in which order.
// Caught: a tick that is run twice or not at all, a shift that is recorded for air that is ambient anyway, air that sleeps on
// while something acts, a call that changes the wind before it has memory for it.

#include "fluid/core/wind_core.h"

#include <gtest/gtest.h>
#include <new>
#include <string>
#include <vector>

namespace {

using namespace windrow;
using Kind = CellChange::Kind;

/// Notes what it is asked for, a letter a call.
class FakeCells final : public CellStorage {
  public:
    void make_room(const CellNeeds&) override {
        if (!has_memory)
            throw std::bad_alloc();
    }
    Result<void> set_boundaries(const Boundaries&, bool kinds) override {
        if (!has_memory)
            return Error{"out of memory"};
        calls += kinds ? 'K' : 'W';
        return {};
    }
    void apply(const CellChange& change) override {
        constexpr std::string_view letters = "fbscaxkBE";
        calls += letters[static_cast<std::size_t>(change.kind)];
        changes.push_back(change);
    }
    bool step(const CellStep& step, Diagnostics& report) override {
        calls += 'S';
        last = step;
        window = *step.window;
        step.ambient->advance(step.duration);
        report.max_speed = 3.0f;
        was_still = at_ambient && step.may_rest;
        return step.rests;
    }
    void show(const FrameBlend& blend) override {
        calls += 'v';
        shown = blend;
    }
    void show_air() override { calls += 'r'; }
    void shift_origin(const OriginShift&) override { calls += 'o'; }
    MeasuredSpeeds measured() const override { return {{{.tick = last.tick, .largest = 3.0f, .still = was_still}}}; }
    std::string take() { return std::exchange(calls, {}); }

    std::string calls;
    std::vector<CellChange> changes;
    CellStep last;
    Window window;
    FrameBlend shown;
    bool has_memory = true, at_ambient = false, was_still = false;
};

struct Fixture {
    explicit Fixture(const Config& config) : core(config, made(config), cells) {
        core.start();
        EXPECT_EQ(cells.take(), "f");
    }
    static AmbientWind made(const Config& config) {
        return *AmbientWind::create({.mean = config.ambient, .profile = config.profile, .gusts = config.gusts});
    }
    FakeCells cells;
    WindCore core;
};

const Config k_windy{.cells = {8, 8, 8}, .ambient = {2.0f, 0.0f, 0.0f}, .ticks = {.hz = 10.0, .max_per_call = 4}};

Config sleepless() {
    Config config = k_windy;
    config.sleep_speed = 0.0f;
    return config;
}

Config gusty() {
    Config config = k_windy;
    config.gusts = {.intensity = 0.2f, .tile = GustTile::standard()};
    return config;
}

TEST(WindCore, RunsTheTicksOfUnevenFrames) {
    Fixture wind(sleepless());
    const auto frame = [&](double dt) { return wind.core.advance(dt); };
    EXPECT_EQ(frame(0.03).ticks, 0);
    EXPECT_EQ(wind.cells.take(), "Bv") << "frames begin, and this one is shown";
    EXPECT_NEAR(wind.cells.shown.factor, 0.3f, 1e-6f);
    EXPECT_EQ(frame(0.0).ticks, 0);
    EXPECT_EQ(wind.cells.take(), "v") << "a pause";
    EXPECT_EQ(frame(0.09).ticks, 1);
    EXPECT_EQ(wind.cells.take(), "kSv") << "the air is kept, then stepped";
    EXPECT_NEAR(wind.cells.last.duration, 0.1, 1e-12);
    EXPECT_NEAR(wind.cells.shown.factor, 0.2f, 1e-6f);
    const Advance two = frame(0.22);
    EXPECT_EQ(two.ticks, 2);
    EXPECT_EQ(two.dropped, 0.0);
    EXPECT_NEAR(two.factor, 0.4f, 1e-6f);
    EXPECT_EQ(wind.cells.take(), "kSkSv");
    EXPECT_TRUE(wind.core.step(0.05).stepped);
    EXPECT_EQ(wind.cells.take(), "ES") << "a step ends the frames";
    EXPECT_FALSE(wind.core.frames);
    EXPECT_FALSE(wind.cells.last.kept);
}

TEST(WindCore, DropsTimeBeyondTheMostTicks) {
    for (const bool gusts : {false, true}) {
        Fixture wind(gusts ? gusty() : k_windy);
        ASSERT_TRUE(wind.core.motors.add(DirectionalMotor{.envelope = {.hold = 0.4f}}));
        (void)wind.core.advance(0.1);
        (void)wind.cells.take();
        const glm::dvec3 phase = wind.core.ambient.phase();
        const Advance done = wind.core.advance(1.0);
        EXPECT_EQ(done.ticks, 4);
        EXPECT_NEAR(done.dropped, 0.6, 1e-9);
        EXPECT_EQ(wind.cells.take(), gusts ? "aakSkSkSkSv" : "kSkSkSkSv") << "gusts go out of the air and come in where they are";
        EXPECT_EQ(wind.core.motors.count(), 0) << "its time passed with what was dropped";
        if (gusts) {
            const auto n = wind.cells.changes.size() - 6; // before the four that were kept
            EXPECT_EQ(wind.cells.changes[n].factor, -1.0f);
            EXPECT_EQ(wind.cells.changes[n + 1].factor, 1.0f);
            EXPECT_NEAR(wind.core.ambient.phase().x, phase.x + 2.0, 1e-9) << "a second, dropped or not";
        }
    }
}

TEST(WindCore, SleepsUntilSomethingActs) {
    Fixture wind(k_windy);
    const std::vector<glm::vec4> still(wind.core.box().cell_count());
    ASSERT_TRUE(wind.core.set_velocity(still));
    EXPECT_FALSE(wind.core.step(0.1).asleep);
    EXPECT_TRUE(wind.cells.last.may_rest);
    EXPECT_FALSE(wind.core.sleep.calm());
    // As late as a device knows it, and not of air that something has acted on since.
    const auto falls_asleep = [&] {
        for (int n = 0; n < 20; ++n)
            if (wind.core.step(0.1).asleep)
                return n;
        return -1;
    };
    constexpr int k_later = SpeedBound::k_delay;
    wind.cells.at_ambient = true;
    EXPECT_EQ(falls_asleep(), k_later);
    (void)wind.cells.take();
    const Diagnostics asleep = wind.core.step(0.1);
    EXPECT_TRUE(asleep.asleep && asleep.stepped);
    EXPECT_EQ(asleep.max_speed, 3.0f) << "of the step that fell asleep";
    EXPECT_EQ(wind.cells.take(), "") << "a step of sleeping air touches no cell";
    ASSERT_TRUE(wind.core.set_ambient({1.0f, 0.0f, 0.0f}));
    EXPECT_EQ(wind.cells.take(), "cf") << "it stays ambient";
    EXPECT_FALSE(wind.core.sleep.asleep());
    EXPECT_TRUE(wind.core.step(0.1).asleep);
    EXPECT_EQ(wind.cells.take(), "S");
    const auto motor = wind.core.motors.add(DirectionalMotor{});
    ASSERT_TRUE(motor);
    EXPECT_FALSE(wind.core.step(0.1).asleep);
    EXPECT_FALSE(wind.cells.last.may_rest);
    ASSERT_TRUE(wind.core.motors.remove(*motor));
    EXPECT_EQ(falls_asleep(), k_later);
    ASSERT_TRUE(wind.core.set_velocity(still));
    EXPECT_FALSE(wind.core.sleep.calm()) << "cells that were set are not known to be ambient";
    EXPECT_EQ(falls_asleep(), k_later);
    ASSERT_TRUE(wind.core.set_boundaries(Boundaries::open_over_floor()));
    EXPECT_FALSE(wind.core.sleep.calm());
}

TEST(WindCore, CarriesTheGustsOverSleepingAir) {
    for (const bool gusts : {false, true}) {
        Fixture wind(gusts ? gusty() : k_windy);
        wind.cells.at_ambient = true;
        for (int n = 0; n < 5 && !wind.core.sleep.asleep(); ++n)
            (void)wind.core.advance(0.1);
        (void)wind.cells.take();
        EXPECT_EQ(wind.core.sleep.drift, 0u);
        (void)wind.core.advance(1.0); // six ticks of it are dropped
        EXPECT_EQ(wind.cells.take(), "kv") << "the air before the last tick sleeps too from the second tick on";
        EXPECT_TRUE(wind.cells.shown.still);
        EXPECT_EQ(wind.core.sleep.drift, gusts ? 5u : 0u);
        (void)wind.core.advance(0.05);
        (void)wind.core.advance(0.05);
        EXPECT_EQ(wind.cells.shown.unchanged, !gusts) << "a frame of the same steady wind is there already";
    }
}

TEST(WindCore, ShiftsTheAirWithTheWindow) {
    Fixture wind(sleepless());
    ASSERT_TRUE(wind.core.follow({3.2, 0.0, -1.0}));
    EXPECT_EQ(wind.cells.take(), "") << "air that is the same everywhere needs no shift";
    EXPECT_EQ(wind.core.window().origin_cells, CellIndex(-1, -4, -5));
    wind.core.step(0.1);
    (void)wind.cells.take();
    ASSERT_TRUE(wind.core.follow({5.2, 0.0, -1.0}));
    EXPECT_EQ(wind.cells.take(), "s");
    EXPECT_EQ(wind.cells.changes.back().by, CellIndex(2, 0, 0));
    EXPECT_EQ(wind.cells.changes.back().window.origin_cells.x, 1);
    wind.core.step(0.1);
    EXPECT_EQ(wind.core.place.stepped.origin_cells.x, 1);
    EXPECT_EQ(wind.core.place.previous.origin_cells.x, -1);
    (void)wind.cells.take();
    ASSERT_TRUE(wind.core.follow({50.0, 0.0, 0.0}));
    EXPECT_EQ(wind.cells.take(), "f") << "nothing of the old air is in the box";
    (void)wind.core.advance(0.05);
    ASSERT_TRUE(wind.core.follow({51.0, 0.0, 0.0}));
    EXPECT_EQ(wind.core.window().origin_cells.x, 46) << "with ticks the box moves in them";
    (void)wind.core.advance(0.05);
    EXPECT_EQ(wind.core.window().origin_cells.x, 47);
    EXPECT_EQ(wind.cells.window.origin_cells.x, 47);
}

TEST(WindCore, GustsGoWithAGroundThatMoves) {
    Config config = gusty();
    config.boundaries = Boundaries::open_over_floor();
    Fixture wind(config);
    wind.core.step(0.1);
    (void)wind.cells.take();
    ASSERT_TRUE(wind.core.set_floor(2.0));
    EXPECT_EQ(wind.cells.take(), "asa");
    const auto& changes = wind.cells.changes;
    EXPECT_EQ(changes[changes.size() - 3].factor, -1.0f);
    EXPECT_FALSE(changes[changes.size() - 2].exposed_hold_ambient);
    EXPECT_EQ(changes.back().factor, 1.0f);
}

// Sources of air are named by what they are and where the box is.
TEST(WindCore, RenewsTheFlowOfVolumeSources) {
    Fixture wind(k_windy);
    const auto renewed = [&] {
        wind.core.step(0.1);
        return wind.cells.last.renews_sources;
    };
    EXPECT_FALSE(renewed());
    const auto vent = wind.core.motors.add(OmniMotor{.position = {0.5, 0.5, 0.5}});
    ASSERT_TRUE(vent);
    EXPECT_TRUE(renewed());
    EXPECT_FALSE(renewed());
    EXPECT_TRUE(wind.cells.last.has_source_flow);
    ASSERT_TRUE(wind.core.follow({1.0, 0.0, 0.0}));
    EXPECT_TRUE(wind.cells.changes.back().has_source_flow);
    EXPECT_TRUE(renewed()) << "the same vent elsewhere in the box";
    ASSERT_TRUE(wind.core.motors.remove(*vent));
    EXPECT_TRUE(renewed());
    EXPECT_FALSE(wind.cells.last.has_source_flow);
}

// Every call does all, or leaves the wind as it was.
TEST(WindCore, WithoutMemoryEveryCallLeavesTheWindAsItWas) {
    for (const bool frames : {false, true}) {
        Config config = gusty();
        config.boundaries = Boundaries::open_over_floor();
        Fixture wind(config);
        WindCore& core = wind.core;
        frames ? (void)core.advance(0.13) : (void)core.step(0.1);
        (void)wind.cells.take();
        const glm::dvec3 phase = core.ambient.phase(), point = core.place.point;
        const CellIndex origin = core.window().origin_cells;
        const double lead = frames ? core.frames->clock.lead : 0.0;
        const std::vector<glm::vec4> field(core.box().cell_count());
        wind.cells.has_memory = false;
        EXPECT_TRUE(core.step(0.1).out_of_memory);
        EXPECT_TRUE(core.advance(0.3).last.out_of_memory);
        EXPECT_FALSE(core.set_ambient({5.0f, 0.0f, 0.0f}));
        EXPECT_FALSE(core.set_gusts({}));
        EXPECT_FALSE(core.set_boundaries(Boundaries{}));
        EXPECT_FALSE(core.follow({30.0, 0.0, 0.0}));
        EXPECT_FALSE(core.set_floor(3.0));
        EXPECT_FALSE(core.set_velocity(field));
        EXPECT_EQ(wind.cells.take(), "");
        EXPECT_EQ(core.ambient.phase(), phase);
        EXPECT_EQ(core.place.point, point);
        EXPECT_EQ(core.window().origin_cells, origin);
        EXPECT_EQ(core.config.ambient, config.ambient);
        EXPECT_EQ(core.config.gusts.intensity, config.gusts.intensity);
        EXPECT_TRUE(core.config.boundaries.y_low.solid());
        ASSERT_EQ(core.frames.has_value(), frames);
        if (frames) {
            EXPECT_EQ(core.frames->clock.lead, lead);
            EXPECT_EQ(core.frames->follow.target(), point);
        }
        wind.cells.has_memory = true;
        EXPECT_EQ(core.advance(0.1).ticks, 1);
    }
}

} // namespace
