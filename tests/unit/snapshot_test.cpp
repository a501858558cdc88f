// Wind::save and Wind::load: what comes back goes on to the same bits.

#include "fluid/thread_pool.h"
#include "fluid/wind_state.h"
#include "tests/unit/snapshot_session.h"

namespace {

using namespace windrow;
using namespace windrow::test;

struct SavedFlight {
    std::string name;
    Config config{};
    std::function<void(Session&)> before{};
    bool ticks = false;
};

void PrintTo(const SavedFlight& scene, std::ostream* stream) {
    *stream << scene.name;
}

void go_on(Session& session, const SavedFlight& scene, int count) {
    session.act(count);
    if (scene.ticks)
        (void)session.wind.advance(session.random.real(0.0, 0.08));
    else
        (void)session.wind.step(count % 5 == 0 ? 0.15 : 1.0 / 60.0);
}

std::vector<SavedFlight> scenes() {
    const Config base{.cells = {17, 9, 14}, .ambient = {3.0f, 0.0f, -1.0f}};
    std::vector<SavedFlight> list;
    const auto add = [&](std::string name, const std::function<void(Config&)>& change, std::function<void(Session&)> before,
                         bool ticks) {
        list.push_back({std::move(name), base, std::move(before), ticks});
        change(list.back().config);
    };
    const auto as_it_is = [](Config&) {};
    const auto flight = [](Session& session) {
        session.add_all_kinds();
        EXPECT_TRUE(session.wind.set_velocity(white_noise(session.wind.box().cells, 3.0f, 7)));
        for (int n = 0; n < 6; ++n)
            go_on(session, {}, n);
    };
    const auto ticked_flight = [](Session& session) {
        session.add_all_kinds();
        for (int n = 0; n < 12; ++n)
            go_on(session, {.name = {}, .ticks = true}, n);
    };
    const auto gusty = [](Config& config) {
        config.boundaries = Boundaries::open_over_floor();
        config.profile = LogProfile{.roughness_length = 0.05f, .reference_height = 6.0f};
        config.gusts = {.intensity = 0.3f, .length = 9.0f, .seed = 5};
    };
    add(
        "fresh", as_it_is, [](Session&) {}, false);
    add("mid_flight", as_it_is, flight, false);
    add("ticked", as_it_is, ticked_flight, true);
    add("stepped_after_ticks", as_it_is, ticked_flight, false);
    add(
        "wake_amid_frames", as_it_is,
        [](Session& session) {
            session.add_all_kinds();
            for (int n = 0; n < 11; ++n) { // 144 Hz over 30 Hz: points wait for their tick, and the last have no time yet
                session.act(n);
                (void)session.wind.advance(1.0 / 144.0);
            }
            session.act(2);
        },
        true);
    add(
        "asleep", as_it_is,
        [](Session& session) {
            EXPECT_TRUE(session.wind.step(0.1).stepped);
            for (int n = 0; n < 5; ++n)
                (void)session.wind.step(0.1);
            EXPECT_TRUE(session.wind.step(0.1).asleep);
        },
        false);
    add(
        "asleep_with_ticks", as_it_is,
        [](Session& session) {
            for (int n = 0; n < 5; ++n)
                (void)session.wind.advance(0.05);
            EXPECT_TRUE(session.wind.state().core.sleep.asleep());
        },
        true);
    add("gusts_over_profile", gusty, flight, false);
    add("gusts_over_profile_with_ticks", gusty, ticked_flight, true);
    add(
        "gusts_changed", gusty,
        [=](Session& session) {
            ticked_flight(session);
            // Frames still show the old ones.
            EXPECT_TRUE(session.wind.set_gusts({.intensity = 0.2f, .length = 12.0f, .seed = 8}));
            EXPECT_TRUE(session.wind.set_floor(-3.0));
        },
        true);
    add(
        "rows",
        [=](Config& config) {
            gusty(config);
            config.rows.emplace(Rows{.first = 0.4f, .uniform = 3, .ratio = 1.2f});
        },
        [=](Session& session) {
            ticked_flight(session);
            EXPECT_TRUE(session.wind.set_floor(1.0));
        },
        true);
    add(
        "listed_rows",
        [](Config& config) {
            config.rows.emplace(Rows{.top = 20.0f, .heights = {0.2f, 0.6f, 1.1f, 1.8f, 3.0f, 5.0f, 8.0f, 12.0f, 17.0f}});
        },
        flight, false);
    add(
        "phase_at_the_period",
        [](Config& config) {
            config.ambient = {-1e-18f, 0.0f, 5.0f};
            config.gusts.intensity = 0.3f;
        },
        [](Session& session) {
            for (int n = 0; n < 6; ++n) // asleep: the phase alone moves on
                (void)session.wind.step(0.02);
            EXPECT_EQ(session.wind.state().core.ambient.phase().x, session.wind.state().core.ambient.period());
        },
        false);
    add(
        "own_tile_without_gusts", [](Config& config) { config.gusts = {.seed = 3, .tile = GustTile::bake(9)}; }, flight, false);
    add(
        "own_tile_of_another_seed",
        [](Config& config) { config.gusts = {.intensity = 0.4f, .seed = 3, .tile = GustTile::bake(9)}; }, flight, false);
    add(
        "far_away",
        [](Config& config) {
            config.centre = {3e6, -2e5, 7e7};
        },
        [](Session& session) {
            session.add(OmniMotor{.position = {3e6 + 1.0, -2e5, 7e7}});
            for (int n = 0; n < 8; ++n) {
                EXPECT_TRUE(session.wind.follow({3e6 + 1.7 * n, -2e5 - 0.4 * n, 7e7 + 2.1 * n}));
                (void)session.wind.step(0.03);
            }
        },
        false);
    add(
        "stable_fluids",
        [](Config& config) {
            config.scheme = Scheme::stable_fluids;
            config.boundaries = Boundaries::all(BoundaryKind::no_slip);
            config.interpolation = Interpolation::linear;
        },
        [=](Session& session) {
            session.add(OmniMotor{});
            session.add(VortexMotor{});
            for (int n = 0; n < 3; ++n)
                (void)session.wind.step(0.05);
        },
        false);
    add(
        "viscous_one_pass", [](Config& config) { config.viscosity = 1.0f; }, flight, false);
    add(
        "viscous_implicit", [](Config& config) { config.viscosity = 50.0f; }, flight, false);
    add(
        "without_advection", [](Config& config) { config.stages.advection = false; }, flight, false);
    add(
        "sides_and_wind_changed", [](Config& config) { config.boundaries.y_low.kind = BoundaryKind::free_slip; },
        [=](Session& session) {
            flight(session);
            Boundaries boundaries = session.wind.config().boundaries;
            boundaries.y_low = {BoundaryKind::no_slip, {1.0f, 0.0f, 0.5f}};
            EXPECT_TRUE(session.wind.set_boundaries(boundaries));
            EXPECT_TRUE(session.wind.set_ambient({1.0f, 2.0f, 3.0f}));
        },
        false);
    return list;
}

void expect_same_view(const WindView& a, const WindView& b) {
    EXPECT_EQ(cells_that_differ(a.field(), b.field()), 0u);
    Random random(3);
    const Sampling sampling{.detail = 0.5f};
    for (int n = 0; n < 50; ++n) {
        const glm::dvec3 at = a.origin() + random.point(20.0);
        EXPECT_EQ(a.velocity(at), b.velocity(at));
        EXPECT_EQ(a.felt(at, sampling), b.felt(at, sampling));
    }
}

void expect_same(const Wind& a, const Wind& b) {
    expect_same_view(a.view(), b.view());
    expect_same_view(a.previous_view(), b.previous_view());
    EXPECT_EQ(a.window_block(a.origin()).previous_origin, b.window_block(b.origin()).previous_origin);
    EXPECT_EQ(a.window_block(a.origin()).previous_blend_centre, b.window_block(b.origin()).previous_blend_centre);
    EXPECT_EQ(a.window_block(a.origin()).factor, b.window_block(b.origin()).factor);
    EXPECT_EQ(a.motors().count(), b.motors().count());
}

class Snapshot : public testing::TestWithParam<SavedFlight> {};

TEST_P(Snapshot, GoesOnToTheSameBits) {
    const SavedFlight& scene = GetParam();
    Session first{made(scene.config), {}};
    scene.before(first);
    const Bytes bytes = *first.wind.save();
    ThreadPool pool(4);
    Session serial{loaded(bytes), first.motors, first.random},
        threaded{loaded(bytes, pool.parallel_for()), first.motors, first.random};
    ASSERT_EQ(*serial.wind.save(), bytes);
    expect_same(first.wind, serial.wind);
    const bool boxed_in = scene.config.boundaries == Boundaries::all(BoundaryKind::no_slip);
    for (int n = 0; n < 20; ++n) {
        for (Session* const session : {&first, &serial, &threaded}) {
            if (boxed_in)
                (void)session->wind.step(0.02 + 0.01 * n);
            else
                go_on(*session, scene, n);
        }
        ASSERT_EQ(*serial.wind.save(), *first.wind.save()) << "frame " << n;
        ASSERT_EQ(*threaded.wind.save(), *first.wind.save()) << "frame " << n << ", 4 threads";
    }
    expect_same(first.wind, serial.wind);
    EXPECT_TRUE(all_finite(first.wind.field()));
}

INSTANTIATE_TEST_SUITE_P(Scenes, Snapshot, testing::ValuesIn(scenes()), [](const auto& instance) { return instance.param.name; });

TEST(SnapshotScenes, AreInTheStatesThatTheyClaim) {
    for (const SavedFlight& scene : scenes()) {
        Session session{made(scene.config), {}};
        scene.before(session);
        const Wind::State& state = session.wind.state();
        if (scene.name == "wake_amid_frames") {
            EXPECT_GT(state.core.frames->clock.lead, 0.0);
        }
        if (scene.name == "mid_flight") {
            EXPECT_NE(state.core.source_name, 0u);
            EXPECT_FALSE(state.cells.air.fresh);
            EXPECT_LT(state.core.motors.count(), static_cast<int>(state.core.motors.slots().size()) - 1);
        }
    }
}

// What these read of the gusts was blended in the step before: it must be that of now.
TEST(SnapshotOfGusts, CallsBeforeTheNextStepSeeTheSameGusts) {
    for (const bool broken : {false, true}) {
        Wind wind = made({.cells = {8, 6, 8}, .ambient = {4.0f, 0.0f, 1.0f}, .gusts = {.intensity = 0.3f}});
        take_steps(wind, 5, 0.05);
        Wind again = loaded(*wind.save());
        for (Wind* const each : {&wind, &again}) {
            if (!broken) {
                each->reset();
                continue;
            }
            Field field = copy(each->field());
            field[77].x = std::numeric_limits<float>::quiet_NaN();
            ASSERT_TRUE(each->set_velocity(field));
            EXPECT_EQ(each->step(0.05).repaired_cells, 1);
        }
        EXPECT_EQ(*again.save(), *wind.save()) << broken;
    }
}

} // namespace
