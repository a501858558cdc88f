// Every public call of fluid and coupling with each of its allocations failed in turn, once alone and once with all that follow:
// no exception leaves the call, an error is returned, the object is what it was, the same call then succeeds, and nothing leaks.
// Caught: a call that throws, one that changes its object before it has made room, a log that misses an event.

#include "coupling/blade.h"
#include "coupling/cascade.h"
#include "coupling/cascade_step.h"
#include "coupling/ground_memory.h"
#include "coupling/shell.h"
#include "coupling/spring.h"
#include "coupling/tree.h"
#include "fluid/event_log.h"
#include "fluid/thread_pool.h"
#include "fluid/tracer.h"
#include "fluid/wind.h"
#include "tests/fields.h"
#include "tests/figure.h"
#include "tests/tier.h"
#include "tests/unit/counted_new.h"

#include <gtest/gtest.h>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace windrow;
using namespace windrow::test;

using Bytes = std::vector<std::byte>;

constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();

int failed_allocations = 0; ///< of this test

template <class Object>
Bytes state_of(const Object&) {
    return {};
}

/// A wind, what its host records, and what its host needs for the calls.
struct HostedWind {
    Wind wind;
    EventLog log;
    Field cells;
    Bytes saved;
    MotorId fan, vent;
    ObstacleId house;

    HostedWind(Wind made) : wind(std::move(made)), cells(wind.box().cell_count(), glm::vec4(1.0f, 2.0f, 0.5f, 0.0f)) {}
};

Bytes state_of(const HostedWind& scene) {
    const auto bytes = scene.wind.save();
    return bytes ? *bytes : Bytes{};
}

template <class Object>
void expect_sound(const Object&) {}
void expect_sound(const HostedWind& scene) {
    EXPECT_TRUE(Wind::load(state_of(scene))) << "its own snapshot is rejected";
    EXPECT_TRUE(all_finite(scene.wind.field()));
}

bool succeeded(bool done) {
    return done;
}
template <class Value>
bool succeeded(const Result<Value>& result) {
    return result.has_value();
}
bool succeeded(const Diagnostics& report) {
    return !report.out_of_memory;
}
bool succeeded(const Advance& done) {
    return !done.last.out_of_memory;
}

/// `call` on what `make` returns, with each of its allocations failed. `accepts`: what it returns where memory lasts.
template <class Make, class Call>
void fail_each(const std::string& name, const Make& make, const Call& call, bool accepts = true) {
    SCOPED_TRACE(name);
    Bytes whole;
    {
        auto object = make();
        ASSERT_EQ(succeeded(call(object)), accepts);
        whole = state_of(object);
        expect_sound(object); // the others' states equal this one or the one before
    }
    for (const Failing failing : {Failing::once, Failing::from_then_on})
        for (int after = 0, failed = 1; failed != 0; ++after) {
            ASSERT_LT(after, 5000) << "no end of allocations";
            const std::int64_t live = live_bytes;
            {
                auto object = make();
                const Bytes before = state_of(object);
                bool threw = false, done = false;
                {
                    const FailingMemory memory(after, failing);
                    try {
                        done = succeeded(call(object));
                    } catch (...) {
                        threw = true;
                    }
                    failed = memory.failed() ? 1 : 0;
                }
                failed_allocations += failed;
                EXPECT_FALSE(threw) << "an exception left it after " << after << " allocations";
                EXPECT_TRUE(failed != 0 || done == accepts);
                EXPECT_TRUE(state_of(object) == (done ? whole : before)) << "after " << after << " allocations it is neither";
                if (!done && !threw) {
                    EXPECT_EQ(succeeded(call(object)), accepts) << "again, after " << after;
                    EXPECT_TRUE(state_of(object) == whole) << "again, after " << after;
                }
            }
            EXPECT_EQ(live_bytes, live) << "leaked after " << after << " allocations";
        }
}

Config small() {
    return {.cells = {8, 6, 7}, .ambient = {3.0f, 0.0f, 1.0f}, .ticks = {.hz = 20.0}};
}

Config gusty() {
    Config config = small();
    config.boundaries = Boundaries::open_over_floor();
    config.profile = LogProfile{};
    config.gusts = {.intensity = 0.3f, .tile = GustTile::standard()};
    config.canopy = Canopy{};
    config.roughness.emplace();
    return config;
}

Config in_rows() {
    Config config = gusty();
    config.rows.emplace(Rows{.first = 0.4f, .uniform = 2, .heights = {0.2f, 0.6f, 1.0f, 1.5f, 2.2f, 3.0f}});
    return config;
}

enum class Past { fresh, stepped, ticking };

HostedWind scene_of(const Config& config, Past past) {
    auto wind = Wind::create(config);
    EXPECT_TRUE(wind) << wind.error();
    HostedWind scene(*std::move(wind));
    scene.fan = *scene.wind.motors().add(DirectionalMotor{.law = Drive{.speed = 6.0f}});
    for (int n = 0; n < 3 && past != Past::fresh; ++n)
        if (past == Past::stepped)
            scene.wind.step(0.04);
        else
            scene.wind.advance(0.033);
    scene.saved = *scene.wind.save();
    return scene;
}

class Allocations : public ::testing::Test {
  protected:
    void SetUp() override { failed_allocations = 0; }
    void TearDown() override { figure("failed_allocations", failed_allocations); }

  private:
    std::shared_ptr<const GustTile> tile_ = GustTile::standard(); // shared, so that no scene bakes its own
};

TEST_F(Allocations, OfAWindsCalls) {
    Boundaries walls = Boundaries::all(BoundaryKind::no_slip), blowing = walls;
    blowing.z_high.wall_velocity = {1.0f, 0.0f, 0.0f};
    for (const auto& [name, config] : {std::pair{"plain", small()}, {"gusty", gusty()}, {"rows", in_rows()}})
        for (const Past past : {Past::fresh, Past::stepped, Past::ticking}) {
            if ((config.rows || (config.gusts.intensity > 0.0f && !test::whole_sweeps())) && past != Past::stepped)
                continue;
            SCOPED_TRACE(std::string(name) + ", past " + std::to_string(static_cast<int>(past)));
            const auto make = [past, of = config] { return scene_of(of, past); };
            const auto with_vent = [&] {
                HostedWind scene = make();
                scene.vent = *scene.wind.motors().add(OmniMotor{.radius = 2.0f});
                return scene;
            };
            fail_each("step", make, [](HostedWind& s) { return s.wind.step(0.05); });
            fail_each("step with a vent", with_vent, [](HostedWind& s) { return s.wind.step(0.05); });
            fail_each("advance", make, [](HostedWind& s) { return s.wind.advance(0.12); });
            fail_each("advance with a vent", with_vent, [](HostedWind& s) { return s.wind.advance(0.12); });
            fail_each("advance beyond all ticks", make, [](HostedWind& s) { return s.wind.advance(3.0); });
            fail_each("add a deposit", make, [](HostedWind& s) { return s.wind.drag().add(PlantDrag{}); });
            fail_each("add deposits", make, [](HostedWind& s) {
                const DragDeposit deposits[] = {PlantDrag{}, BeltDrag{}, PlantDrag{.radius = 3.0f}};
                return s.wind.drag().add(deposits);
            });
            fail_each("set_ambient", make, [](HostedWind& s) { return s.wind.set_ambient({-2.0f, 0.0f, 4.0f}); });
            fail_each("set_gusts", make, [](HostedWind& s) { return s.wind.set_gusts({.intensity = 0.2f}); });
            fail_each("set_gusts of a seed", make,
                      [](HostedWind& s) { return s.wind.set_gusts({.intensity = 0.2f, .seed = 9}); });
            fail_each("set_gusts off", make, [](HostedWind& s) { return s.wind.set_gusts({}); });
            fail_each("set_boundaries", make, [&](HostedWind& s) { return s.wind.set_boundaries(walls); });
            fail_each("set_boundaries with a vent", with_vent, [&](HostedWind& s) { return s.wind.set_boundaries(walls); });
            fail_each("follow", make, [](HostedWind& s) { return s.wind.follow({2.3, 0.0, -1.2}); });
            fail_each("follow beyond", make, [](HostedWind& s) { return s.wind.follow({200.0, 3.0, -1.0}); });
            fail_each("set_velocity", make, [](HostedWind& s) { return s.wind.set_velocity(s.cells); });
            fail_each("set_velocity of a function", make, [](HostedWind& s) {
                s.wind.set_velocity([](glm::dvec3 x) { return glm::vec3(x); });
                return true;
            });
            fail_each("reset", make, [](HostedWind& s) {
                s.wind.reset();
                return true;
            });
            fail_each("save", make, [](HostedWind& s) { return s.wind.save(); });
            fail_each("load", make, [](HostedWind& s) { return Wind::load(s.saved); });
            fail_each("write_pressure", make,
                      [](HostedWind& s) { return s.wind.write_pressure(std::span<float>(&s.cells.data()->x, s.cells.size())); });
            fail_each("reading", make, [](HostedWind& s) {
                (void)s.wind.felt({0.3, 1.0, 0.2}, {.detail = 0.4f});
                (void)s.wind.frame_block({1.0, 0.0, 0.0}, {});
                (void)s.wind.window_block({1.0, 0.0, 0.0});
                (void)s.wind.previous_view().velocity({0.0, 1.0, 0.0});
                return true;
            });
        }
    for (const Config& floor : {gusty(), in_rows()})
        fail_each(
            "set_floor", [&] { return scene_of(floor, Past::stepped); }, [](HostedWind& s) { return s.wind.set_floor(3.0); });
    // What a step of a minute asks of this viscosity, no step of a second does.
    Config syrup = small();
    syrup.viscosity = 0.05f;
    fail_each(
        "step of a minute", [&] { return scene_of(syrup, Past::stepped); }, [](HostedWind& s) { return s.wind.step(60.0); });
    syrup.viscosity = 50.0f;
    fail_each(
        "set_boundaries of a viscous wind", [&] { return scene_of(syrup, Past::stepped); },
        [&](HostedWind& s) { return s.wind.set_boundaries(walls); });
    fail_each(
        "set_boundaries that moves a wall",
        [&] {
            Config closed = small();
            closed.boundaries = walls;
            return scene_of(closed, Past::stepped);
        },
        [&](HostedWind& s) { return s.wind.set_boundaries(blowing); });
}

TEST_F(Allocations, OfCreation) {
    const auto nothing = [] { return 0; };
    Config own_tile = gusty();
    own_tile.gusts = {.intensity = 0.2f, .seed = 7};
    Config viscous = small();
    viscous.viscosity = 50.0f;
    Config periodic = small();
    periodic.boundaries = Boundaries::all(BoundaryKind::periodic);
    for (const Config& config : {small(), gusty(), own_tile, viscous, periodic, in_rows()})
        fail_each("Wind::create", nothing, [&](int) { return Wind::create(config); });
    fail_each("AmbientWind::create", nothing, [](int) {
        return AmbientWind::create({.mean = {1.0f, 0.0f, 0.0f}, .gusts = {.intensity = 0.2f, .seed = 3}});
    });
    fail_each("GustTile::bake", nothing, [](int) { return GustTile::bake(5) != nullptr; });
    fail_each("Workspace::create", nothing, [](int) { return Workspace::create({.box = {.cells = {6, 5, 4}}}); });
    const Wind air = *Wind::create(small());
    fail_each("Tracer::create", nothing, [&](int) { return Tracer::create(air.view()); });
    fail_each(
        "Tracer::step", [&] { return *Tracer::create(air.view()); },
        [&](Tracer& smoke) { return smoke.step(air.view(), {}, 0.1); });
    fail_each("ThreadPool", nothing, [](int) { return ThreadPool(2).size() > 0; });
    fail_each("GroundMemory::create", nothing, [](int) { return GroundMemory::create({.texels = 32}); });
    fail_each("Cascade::create", nothing, [](int) { return Cascade::create({}, {}); });
    fail_each("CascadeStep::create", nothing, [](int) { return CascadeStep::create(12); });
    fail_each("Blades::create", nothing, [](int) { return Blades::create({}); });
    fail_each("Shells::create", nothing, [](int) { return Shells::create({}); });
    fail_each("Tree::create", nothing, [](int) { return Tree::create({}); });
    fail_each("spring_step", nothing, [](int) { return spring_step({}, 0.1); });
}

TEST_F(Allocations, OfMotors) {
    const auto make = [] { return scene_of(small(), Past::stepped); };
    const Motor stirred = JetMotor{.turbulence = {.intensity = 0.2f}}, wake = WakeMotor{};
    fail_each("add", make, [](HostedWind& s) { return s.wind.motors().add(OmniMotor{}); });
    fail_each("add with eddies", make, [&](HostedWind& s) { return s.wind.motors().add(stirred); });
    fail_each("add a wake", make, [&](HostedWind& s) { return s.wind.motors().add(wake); });
    fail_each("set", make, [&](HostedWind& s) { return s.wind.motors().set(s.fan, wake); });
    fail_each("move", make, [](HostedWind& s) { return s.wind.motors().move(s.fan, {1.0, 2.0, 0.0}); });
    fail_each("remove", make, [](HostedWind& s) { return s.wind.motors().remove(s.fan); });
    const auto full = [&] {
        HostedWind scene = make();
        for (int n = 0; n < 3; ++n)
            EXPECT_TRUE(scene.wind.motors().add(WakeMotor{}));
        return scene;
    };
    fail_each("a motor that ends in a step", full, [](HostedWind& s) {
        const auto id = s.wind.motors().add(DirectionalMotor{.envelope = {.hold = 0.01f}});
        if (!id)
            return false;
        s.wind.step(0.05);
        return true;
    });
}

TEST_F(Allocations, OfObstacles) {
    const auto make = [] {
        HostedWind town = scene_of(small(), Past::stepped);
        town.house = *town.wind.obstacles().add({.position = {1.0, 0.0, 0.0}});
        return town;
    };
    fail_each("add", make, [](HostedWind& s) { return s.wind.obstacles().add({}); });
    fail_each("set", make, [](HostedWind& s) { return s.wind.obstacles().set(s.house, {.shape = Sphere{}}); });
    fail_each("move", make, [](HostedWind& s) { return s.wind.obstacles().move(s.house, {1.0, 2.0, 0.0}); });
    fail_each("turn", make, [](HostedWind& s) { return s.wind.obstacles().move(s.house, {}, {1.0f, 1.0f, 0.0f, 0.0f}); });
    fail_each("remove", make, [](HostedWind& s) { return s.wind.obstacles().remove(s.house); });
}

TEST_F(Allocations, OfRejections) {
    const auto make = [] { return scene_of(small(), Past::stepped); };
    const auto rejected = [&](const char* name, const auto& call) { fail_each(name, make, call, false); };
    rejected("Wind::create", [](HostedWind&) {
        return Wind::create({.cells = {0, -1, 9999}, .cell_size = k_nan, .blend_width = -1.0f});
    });
    rejected("set_ambient", [](HostedWind& s) { return s.wind.set_ambient({k_nan, 0.0f, 0.0f}); });
    rejected("set_gusts", [](HostedWind& s) { return s.wind.set_gusts({.intensity = -1.0f, .length = k_nan}); });
    rejected("set_boundaries", [](HostedWind& s) { return s.wind.set_boundaries({.x_low = {BoundaryKind::periodic}}); });
    rejected("follow", [](HostedWind& s) { return s.wind.follow({1e300, 0.0, 0.0}); });
    rejected("set_floor", [](HostedWind& s) { return s.wind.set_floor(1.0); });
    rejected("set_velocity", [](HostedWind& s) { return s.wind.set_velocity(std::span(s.cells).first(3)); });
    rejected("load", [](HostedWind& s) { return Wind::load(std::span(s.saved).first(100)); });
    rejected("add", [](HostedWind& s) { return s.wind.motors().add(OmniMotor{.radius = -1.0f, .speed = k_nan}); });
    rejected("set", [](HostedWind& s) { return s.wind.motors().set(s.fan, DirectionalMotor{.direction = glm::vec3(0.0f)}); });
    rejected("add an obstacle", [](HostedWind& s) { return s.wind.obstacles().add({.shape = Sphere{-1.0f}}); });
    rejected("move an obstacle", [](HostedWind& s) { return s.wind.obstacles().move({99, 3}, {}); });
    rejected("stale handle", [](HostedWind& s) { return s.wind.motors().move({99, 3}, {}); });
    rejected("write_axes", [](HostedWind& s) { return s.wind.write_axes(std::span<float>(), {}, {}); });
    rejected("write_vectors", [](HostedWind& s) { return s.wind.write_vectors(std::span<float>()); });
    rejected("AmbientWind::create", [](HostedWind&) { return AmbientWind::create({.mean = {k_nan, 0.0f, 0.0f}}); });
    rejected("Workspace::create", [](HostedWind&) { return Workspace::create({.box = {.cells = {0, 1, 1}}}); });
    rejected("validate a motor", [](HostedWind&) { return validate(Motor(WakeMotor{.radius = -3.0f})); });
    rejected("validate a sampling", [](HostedWind&) { return validate(Sampling{.limit = k_nan}); });
    rejected("GroundMemory::create", [](HostedWind&) { return GroundMemory::create({.texels = -4}); });
    rejected("Cascade::create", [](HostedWind&) { return Cascade::create({.stages = -1}, {.scale = -1.0}); });
    rejected("CascadeStep::create", [](HostedWind&) { return CascadeStep::create(-1); });
    rejected("Blades::create", [](HostedWind&) { return Blades::create({.width = -1.0f}); });
    rejected("Shells::create", [](HostedWind&) { return Shells::create({.shells = -1}); });
    rejected("Tree::create", [](HostedWind&) { return Tree::create({.trunk = {.length = -1.0f}}); });
    rejected("spring_step", [](HostedWind&) { return spring_step({}, -1.0); });
}

TEST_F(Allocations, OfLogs) {
    const auto recording = [] {
        auto scene = std::make_unique<HostedWind>(scene_of(small(), Past::fresh));
        scene->wind.record_to(&scene->log);
        return scene;
    };
    // A log that found no memory is incomplete and rejected; the wind goes on.
    for (const Failing failing : {Failing::once, Failing::from_then_on})
        for (int after = 0; after < 8; ++after) {
            const auto scene = recording();
            {
                const FailingMemory memory(after, failing);
                scene->wind.step(0.05);
                (void)scene->wind.set_velocity(scene->cells);
                (void)scene->wind.set_ambient({1.0f, 0.0f, 0.0f});
            }
            scene->wind.step(0.05);
            auto again = Wind::load(scene->saved);
            ASSERT_TRUE(again);
            EXPECT_EQ(scene->log.complete(), scene->log.to_bytes().has_value());
            EXPECT_EQ(scene->log.complete(), replay(scene->log, *again).has_value());
            if (scene->log.complete()) {
                EXPECT_EQ(*again->save(), *scene->wind.save());
            }
            scene->log.clear();
            EXPECT_TRUE(scene->log.complete());
        }
    const auto recorded = [&] {
        auto scene = recording();
        scene->wind.step(0.05);
        EXPECT_TRUE(scene->wind.set_velocity(scene->cells));
        EXPECT_TRUE(scene->wind.set_gusts({.intensity = 0.1f, .tile = GustTile::standard()}));
        scene->wind.step(0.05);
        return scene;
    };
    const auto log = recorded()->log;
    const Bytes bytes = *log.to_bytes(), start = recorded()->saved;
    const auto nothing = [] { return 0; };
    fail_each("to_bytes", nothing, [&](int) { return log.to_bytes(); });
    fail_each("from_bytes", nothing, [&](int) { return EventLog::from_bytes(bytes); });
    fail_each(
        "from_bytes of others", nothing, [&](int) { return EventLog::from_bytes(std::span(bytes).first(40)); }, false);
    fail_each("replay", nothing, [&](int) {
        auto again = Wind::load(start);
        return again && replay(log, *again).has_value();
    });
}

struct Work {
    Workspace work;
    Field velocity, result;
    std::vector<float> smoke, moved;
};

Bytes state_of(const Work& work) {
    const auto bytes = [](const auto& values) { return std::as_bytes(std::span(values)); };
    Bytes all(bytes(work.result).begin(), bytes(work.result).end());
    all.insert(all.end(), bytes(work.moved).begin(), bytes(work.moved).end());
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            all.push_back(static_cast<std::byte>(work.work.box().boundaries.at(axis, end).kind));
    return all;
}

TEST_F(Allocations, OfOperators) {
    const auto make = [] {
        auto work = Workspace::create({.box = {.cells = {8, 6, 7}}});
        EXPECT_TRUE(work);
        const std::size_t cells = work->box().cell_count();
        return Work{*std::move(work), white_noise({8, 6, 7}, 2.0f, 5), Field(cells), std::vector<float>(cells, 1.0f),
                    std::vector<float>(cells)};
    };
    const Boundaries walls = Boundaries::all(BoundaryKind::no_slip);
    fail_each("set_boundaries", make, [&](Work& w) { return w.work.set_boundaries(walls); });
    fail_each("reserve_diffusion", make, [](Work& w) { return reserve_diffusion(w.work); });
    fail_each("diffuse", make, [](Work& w) { return diffuse(w.work, w.velocity, 5.0f, 1.0f, w.result); });
    fail_each("advect a scalar", make, [](Work& w) {
        return advect(w.work, ScalarTransport{.carried = w.smoke, .velocity = w.velocity, .dt = 0.3f}, w.moved);
    });
    const auto viscous = [&] {
        Work work = make();
        EXPECT_TRUE(reserve_diffusion(work.work));
        return work;
    };
    fail_each("set_boundaries with diffusion", viscous, [&](Work& w) { return w.work.set_boundaries(walls); });
    fail_each("advect, project", make, [](Work& w) {
        advect(w.work, Transport{.carried = w.velocity, .velocity = w.velocity, .dt = 0.2f}, w.result);
        project(w.work, w.result);
        return true;
    });
}

TEST_F(Allocations, OfPlants) {
    const auto ground = [] {
        auto memory = GroundMemory::create({.texels = 32});
        EXPECT_TRUE(memory);
        return *std::move(memory);
    };
    const GroundWalker walker{};
    fail_each("GroundMemory::advance", ground,
              [&](GroundMemory& memory) { return memory.advance({.duration = 0.1, .walkers = std::span(&walker, 1)}); });
    fail_each("GroundMemory::follow", ground, [](GroundMemory& memory) { return memory.follow({3.0, 0.0, 1.0}); });
    fail_each(
        "GroundMemory::advance of nothing", ground, [](GroundMemory& memory) { return memory.advance({.duration = -1.0}); },
        false);
    const auto cascade = [] {
        auto made = Cascade::create({}, {});
        EXPECT_TRUE(made);
        return *std::move(made);
    };
    fail_each("Cascade::advance", cascade, [](Cascade& c) { return c.advance(0.1, {.position = {1.0, 0.0, 0.0}}); });
    fail_each("Cascade::reset", cascade, [](Cascade& c) { return c.reset({.scale = 2.0}); });
    fail_each("Cascade::move", cascade, [](Cascade& c) { return c.move({1.0, 0.0, 0.0}); });
    fail_each("Cascade's poses", cascade, [](Cascade& c) { return c.shader_poses({}).size() > 0; });
    fail_each(
        "Cascade::advance of nothing", cascade, [](Cascade& c) { return c.advance(-1.0, {.scale = -1.0}); }, false);
}

/// A wind inside another one.
struct NestedWind {
    std::shared_ptr<Wind> outer;
    std::optional<Wind> inner{};
};

NestedWind nested(bool both) {
    const Boundaries floor = Boundaries::open_over_floor();
    NestedWind winds{std::make_shared<Wind>(*Wind::create(
        {.cells = {16, 8, 16}, .cell_size = 2.0f, .boundaries = floor, .ambient = {4.0f, 0.0f, 1.0f}, .profile = LogProfile{}}))};
    (void)winds.outer->obstacles().add({.position = {-6.0, 2.0, 0.0}, .shape = Block{glm::vec3(3.0f)}});
    (void)winds.outer->advance(0.1);
    if (both) {
        winds.inner.emplace(*Wind::create({.cells = {12, 8, 12}, .boundaries = floor}, winds.outer));
        (void)winds.inner->advance(0.1);
    }
    return winds;
}

TEST_F(Allocations, OfNestedWinds) {
    fail_each(
        "create", [] { return nested(false); },
        [](NestedWind& winds) {
            return Wind::create({.cells = {12, 8, 12}, .boundaries = Boundaries::open_over_floor()}, winds.outer);
        });
    const auto both = [] { return nested(true); };
    fail_each("follow", both, [](NestedWind& winds) { return winds.inner->follow({3.2, 0.0, 1.0}); });
    fail_each("advance", both, [](NestedWind& winds) { return winds.inner->advance(0.1); });
    fail_each("step", both, [](NestedWind& winds) { return winds.inner->step(0.05); });
    fail_each("reading beyond the box", both, [](NestedWind& winds) {
        (void)winds.inner->velocity({10.0, 1.0, 2.0});
        return true;
    });
}

} // namespace
