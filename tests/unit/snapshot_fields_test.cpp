// A snapshot holds every field, and little else.

#include "fluid/wind_state.h"
#include "tests/shapes.h"
#include "tests/unit/snapshot_session.h"

namespace {

using namespace windrow;
using namespace windrow::test;

// A field that is left out leaves the bytes as they are; one that is read wrongly comes out otherwise when saved again.
template <class T>
void each_counts(const T& start, const std::vector<std::function<void(T&)>>& changes,
                 const std::function<Bytes(const T&)>& bytes_of) {
    std::vector<Bytes> seen{bytes_of(start)};
    for (std::size_t n = 0; n < changes.size(); ++n) {
        T value = start;
        changes[n](value);
        const Bytes bytes = bytes_of(value);
        for (const Bytes& other : seen)
            EXPECT_NE(bytes, other) << "change " << n;
        EXPECT_EQ(*loaded(bytes).save(), bytes) << "change " << n;
        seen.push_back(bytes);
    }
}

Roughness rough_by_map(double length, double x, float scale) {
    return {.map = RoughnessMap{.lengths = heights_of({2, 2}, 1.0f, [=](double, double) { return length; }),
                                .position = {x, 0.0, 0.0},
                                .scale = glm::vec3(scale)}};
}

TEST(SnapshotFields, EachOfTheConfigCounts) {
    Config start{.cells = {3, 4, 5}};
    start.boundaries.x_low.kind = start.boundaries.x_high.kind = start.boundaries.y_low.kind = BoundaryKind::no_slip;
    start.boundaries.y_high.kind = BoundaryKind::no_slip;
    start.profile = LogProfile{};
    start.gusts.intensity = 0.25f;
    using Change = std::function<void(Config&)>;
    const std::vector<Change> changes{
        [](Config& c) { c.cells.x = 6; },
        [](Config& c) { c.cells.y = 6; },
        [](Config& c) { c.cells.z = 6; },
        [](Config& c) { c.cell_size = 0.5f; },
        [](Config& c) { c.boundaries.x_low.kind = BoundaryKind::free_slip; },
        [](Config& c) { c.boundaries.x_high.wall_velocity.y = 1.0f; },
        [](Config& c) { c.boundaries.x_high.wall_velocity.z = 1.0f; },
        [](Config& c) { c.boundaries.y_low.kind = BoundaryKind::free_slip; },
        [](Config& c) { c.boundaries.y_high.wall_velocity.x = 2.0f; },
        [](Config& c) { c.boundaries.z_low.kind = BoundaryKind::free_slip; },
        [](Config& c) { c.boundaries.z_high.kind = BoundaryKind::free_slip; },
        [](Config& c) { c.boundaries.z_low.kind = c.boundaries.z_high.kind = BoundaryKind::periodic; },
        [](Config& c) { c.centre.x = 0.25; },
        [](Config& c) { c.centre.y = 0.25; },
        [](Config& c) { c.centre.z = 0.25; },
        [](Config& c) { c.follow_axes = glm::bvec3(false); },
        [](Config& c) { c.follow_axes = glm::bvec3(false, false, true); },
        [](Config& c) { c.ambient.x = 2.0f; },
        [](Config& c) { c.ambient.y = 2.0f; },
        [](Config& c) { c.ambient.z = 2.0f; },
        [](Config& c) { c.profile.reset(); },
        [](Config& c) { c.profile->roughness_length = 0.1f; },
        [](Config& c) { c.profile->reference_height = 3.0f; },
        [](Config& c) { c.gusts.intensity = 0.5f; },
        [](Config& c) { c.gusts.length = 6.0f; },
        [](Config& c) { c.gusts.seed = 77; },
        [](Config& c) { c.canopy = Canopy{}; },
        [](Config& c) { c.canopy = Canopy{.height = 2.0f}; },
        [](Config& c) { c.canopy = Canopy{.drag = 2.0f}; },
        [](Config& c) { c.roughness = Roughness{}; },
        [](Config& c) { c.roughness = Roughness{.length = 0.2f}; },
        [](Config& c) { c.roughness = Roughness{.longest_mixing = 2.0f}; },
        [](Config& c) { c.roughness = rough_by_map(0.1, 0.0, 1.0f); },
        [](Config& c) { c.roughness = rough_by_map(0.2, 0.0, 1.0f); },
        [](Config& c) { c.roughness = rough_by_map(0.1, 5.0, 1.0f); },
        [](Config& c) { c.roughness = rough_by_map(0.1, 0.0, 2.0f); },
        [](Config& c) { c.blend_width = 1.0f; },
        [](Config& c) { c.viscosity = 0.5f; },
        [](Config& c) { c.relaxation_time = 3.0f; },
        [](Config& c) { c.sleep_speed = 0.5f; },
        [](Config& c) { c.scheme = Scheme::stable_fluids; },
        [](Config& c) { c.interpolation = Interpolation::linear; },
        [](Config& c) { c.interpolation = Interpolation::cubic_32; },
        [](Config& c) { c.max_cfl = 1.0f; },
        [](Config& c) { c.max_substeps = 2; },
        [](Config& c) { c.stages.sources = false; },
        [](Config& c) { c.stages.relaxation = false; },
        [](Config& c) { c.stages.diffusion = false; },
        [](Config& c) { c.stages.advection = false; },
        [](Config& c) { c.stages.projection = false; },
        [](Config& c) { c.ticks.hz = 50.0; },
        [](Config& c) { c.ticks.max_per_call = 7; },
    };
    each_counts<Config>(start, changes, [](const Config& config) { return *made(config).save(); });
}

template <class Kind>
void each_of_a_motor_counts(const std::vector<std::function<void(Kind&)>>& changes) {
    each_counts<Kind>({}, changes, [](const Kind& motor) {
        Wind wind = made({.cells = {2, 2, 2}});
        added(wind, motor);
        return *wind.save();
    });
}

template <class Kind>
void add_numbers(std::vector<std::function<void(Kind&)>>& list, std::initializer_list<float Kind::*> numbers) {
    for (float Kind::*const number : numbers)
        list.push_back([=](Kind& m) { m.*number = 0.25f; });
}

template <class Kind>
std::vector<std::function<void(Kind&)>> changes_of_place() {
    return {[](Kind& m) { m.position.x = 1.5; }, [](Kind& m) { m.position.y = 1.5; }, [](Kind& m) { m.position.z = 1.5; }};
}

template <class Kind>
std::vector<std::function<void(Kind&)>> changes_of_envelope() {
    auto list = changes_of_place<Kind>();
    list.insert(list.end(), {[](Kind& m) { m.envelope.attack = 0.5f; }, [](Kind& m) { m.envelope.hold = 0.5f; },
                             [](Kind& m) { m.envelope.decay = 0.5f; }});
    return list;
}

template <class Kind>
void add_changes_of_turbulence(std::vector<std::function<void(Kind&)>>& list) {
    list.insert(list.end(), {[](Kind& m) { m.turbulence.intensity = 0.25f; }, [](Kind& m) { m.turbulence.length = 0.5f; },
                             [](Kind& m) { m.turbulence.seed = 7; }});
}

template <class Kind>
std::vector<std::function<void(Kind&)>> changes_of_law() {
    auto list = changes_of_envelope<Kind>();
    list.insert(list.end(), {[](Kind& m) { m.law = Force{}; }, [](Kind& m) { m.law = Force{0.5f}; },
                             [](Kind& m) { m.law = Drive{.speed = 0.5f}; }, [](Kind& m) { m.law = Drive{.rate = 0.5f}; }});
    return list;
}

TEST(SnapshotFields, EachOfAMotorCounts) {
    auto directional = changes_of_law<DirectionalMotor>();
    for (const glm::vec3 direction : {glm::vec3(0.0f, 1.0f, 0.0f), glm::vec3(0.0f, 0.0f, 1.0f)})
        directional.push_back([=](DirectionalMotor& m) { m.direction = direction; });
    const glm::vec3 up(0.0f, 1.0f, 0.0f);
    for (const Region& region :
         std::vector<Region>{Sphere{0.5f}, Capsule{}, Capsule{.half_axis = up}, Capsule{.radius = 0.5f}, AlignedBox{},
                             AlignedBox{{1.0f, 2.0f, 2.0f}}, AlignedBox{{2.0f, 1.0f, 2.0f}}, AlignedBox{{2.0f, 2.0f, 1.0f}},
                             Cone{}, Cone{.axis = up}, Cone{.start_radius = 0.25f}, Cone{.end_radius = 0.25f}})
        directional.push_back([=](DirectionalMotor& m) { m.region = region; });
    add_changes_of_turbulence(directional);
    each_of_a_motor_counts<DirectionalMotor>(directional);

    auto wake = changes_of_envelope<WakeMotor>();
    add_numbers(wake, {&WakeMotor::radius});
    for (const decltype(WakeMotor::law)& law : std::vector<decltype(WakeMotor::law)>{
             WakeForce{}, WakeForce{0.25f}, WakeDrive{.per_metre = 0.25f}, WakeDrive{.entrainment = 0.25f}})
        wake.push_back([=](WakeMotor& m) { m.law = law; });
    add_changes_of_turbulence(wake);
    each_of_a_motor_counts<WakeMotor>(wake);

    auto jet = changes_of_law<JetMotor>();
    jet.push_back([=](JetMotor& m) { m.direction = up; });
    add_numbers(jet, {&JetMotor::length, &JetMotor::start_radius, &JetMotor::end_radius});
    add_changes_of_turbulence(jet);
    each_of_a_motor_counts<JetMotor>(jet);

    auto vortex = changes_of_law<VortexMotor>();
    vortex.push_back([](VortexMotor& m) { m.axis = glm::vec3(1.0f, 0.0f, 0.0f); });
    add_numbers(vortex, {&VortexMotor::radius, &VortexMotor::half_length, &VortexMotor::lift});
    each_of_a_motor_counts<VortexMotor>(vortex);

    auto omni = changes_of_envelope<OmniMotor>();
    add_numbers(omni, {&OmniMotor::radius, &OmniMotor::speed});
    each_of_a_motor_counts<OmniMotor>(omni);

    auto pressure = changes_of_place<PressureMotor>();
    add_numbers(pressure, {&PressureMotor::radius, &PressureMotor::speed, &PressureMotor::duration});
    each_of_a_motor_counts<PressureMotor>(pressure);
}

// A report while asleep is the one thing that no later step makes again.
TEST(SnapshotFields, ASleeperReportsTheSame) {
    Wind wind = made({.cells = {4, 4, 4}, .ambient = {3.0f, 1.0f, 0.0f}});
    (void)wind.step(0.1);
    Wind again = loaded(*wind.save());
    const Diagnostics a = wind.step(0.1), b = again.step(0.1);
    EXPECT_TRUE(b.asleep && b.stepped);
    EXPECT_EQ(a.max_speed, b.max_speed);
    EXPECT_EQ(a.energy, b.energy);
    EXPECT_EQ(a.divergence_rms, b.divergence_rms);
}

TEST(SnapshotFields, HandlesGoOnWithTheirGenerations) {
    Session session{made({.cells = {4, 4, 4}}), {}};
    session.add_all_kinds();
    Wind again = loaded(*session.wind.save());
    EXPECT_EQ(again.motors().find(session.motors[0]), nullptr);
    EXPECT_NE(again.motors().find(session.motors[1]), nullptr);
    for (int n = 0; n < 4; ++n) {
        const auto here = session.wind.motors().add(OmniMotor{}), there = again.motors().add(OmniMotor{});
        ASSERT_TRUE(here && there);
        EXPECT_EQ(*here, *there);
    }
}

TEST(SnapshotFields, ATileThatWasHandedInGoesByItsSeed) {
    Wind wind = made(
        {.cells = {4, 4, 4}, .ambient = {5.0f, 0.0f, 0.0f}, .gusts = {.intensity = 0.3f, .seed = 3, .tile = GustTile::bake(9)}});
    EXPECT_EQ(loaded(*wind.save()).config().gusts.seed, 9u);
}

TEST(SnapshotFields, TakesSoManyBytesACell) {
    const auto per_cell = [](const Wind& wind) {
        return static_cast<double>(wind.save()->size()) / static_cast<double>(wind.box().cell_count());
    };
    Wind wind = made({});
    WINDROW_EXPECT_FIGURE("snapshot_bytes_per_cell_fresh", per_cell(wind), 16.1);
    ASSERT_TRUE(wind.motors().add(DirectionalMotor{}));
    (void)wind.step(0.02);
    WINDROW_EXPECT_FIGURE("snapshot_bytes_per_cell_stepped", per_cell(wind), 52.1);
    ASSERT_TRUE(wind.motors().add(OmniMotor{}));
    (void)wind.step(0.02);
    WINDROW_EXPECT_FIGURE("snapshot_bytes_per_cell_with_sources_of_air", per_cell(wind), 68.1);
    (void)wind.advance(0.05);
    WINDROW_EXPECT_FIGURE("snapshot_bytes_per_cell_with_all", per_cell(wind), 116.1);
}

} // namespace
