// The memory that a Wind reports is what it has allocated, and a step allocates nothing.

#include "fluid/thread_pool.h"
#include "tests/unit/counted_new.h"
#include "tests/winds.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <glm/gtc/quaternion.hpp>
#include <new>
#include <optional>

namespace {

using namespace windrow;
using namespace windrow::test;

std::vector<NamedConfig> measured_scenes() {
    return {{"default", {}},
            {"16x16x16", {.cells = {16, 16, 16}}},
            {"64x32x64", {.cells = {64, 32, 64}}},
            {"odd", {.cells = {17, 9, 23}}},
            {"unlike_ends",
             {.cells = {32, 16, 20},
              .boundaries = {.x_low = {BoundaryKind::no_slip},
                             .y_low = {BoundaryKind::free_slip},
                             .z_high = {BoundaryKind::no_slip}}}},
            {"periodic", {.cells = {20, 10, 12}, .boundaries = Boundaries::all(BoundaryKind::periodic)}},
            {"one_pass", {.viscosity = 0.5f}},
            {"implicit", {.viscosity = 50.0f}},
            {"gusty",
             {.boundaries = Boundaries::open_over_floor(),
              .ambient = {3.0f, 0.0f, 1.0f},
              .profile = LogProfile{},
              .gusts = {.intensity = 0.3f}}},
            {"one_cell", {.cells = {1, 1, 1}}}};
}

TEST(Memory, EveryFormOfNewIsCounted) {
    const std::int64_t bytes = live_bytes, count = allocations;
    auto* const plain = static_cast<char*>(::operator new[](100)); // a compiler may leave out a new-expression that nobody needs
    auto* const aligned = static_cast<char*>(::operator new[](1000, std::align_val_t{64}));
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(aligned) % 64, 0u);
    EXPECT_EQ(live_bytes - bytes, 1100);
    EXPECT_EQ(allocations - count, 2);
    ::operator delete[](aligned, std::align_val_t{64});
    ::operator delete[](plain);
    EXPECT_EQ(live_bytes, bytes);
}

// Bytes that `object` holds and does not report, or reports and does not hold.
template <class Object>
double unsaid(const Object& object, std::int64_t before) {
    return static_cast<double>(std::abs(live_bytes - before - static_cast<std::int64_t>(object.memory_bytes())));
}

// The reported memory equals what was allocated, without slack; the object itself (sizeof) is the caller's and is not counted.
// Figures are recorded at the end of each scene, since recording allocates.
TEST(Memory, AWindSaysWhatItHasAllocated) {
    (void)GustTile::standard(); // the last one's count of owners stays: the standard library's
    for (const NamedConfig& scene : measured_scenes()) {
        // [bytes] A tile of gusts is shared, and its count of owners is the standard library's.
        const double shared = scene.config.gusts.intensity > 0.0f ? 32.0 : 0.0;
        double created = 0.0, with_motors = 0.0, with_other_sides = 0.0, bytes_a_cell = 0.0;
        const std::int64_t before = live_bytes;
        {
            std::optional<Wind> wind;
            if (auto result = Wind::create(scene.config))
                wind.emplace(*std::move(result));
            ASSERT_TRUE(wind);
            created = unsaid(*wind, before);
            bytes_a_cell = static_cast<double>(live_bytes - before) / static_cast<double>(wind->field().size());

            bool accepted = true;
            for (int n = 0; n < 100; ++n) // Motors make room as they come.
                accepted = wind->motors().add(DirectionalMotor{.law = Force{}}).has_value() && accepted;
            wind->step(0.1);
            with_motors = unsaid(*wind, before);

            accepted = wind->set_boundaries(Boundaries::all(BoundaryKind::no_slip)).has_value() && accepted;
            wind->step(0.1);
            with_other_sides = unsaid(*wind, before);
            ASSERT_TRUE(accepted);
        }
        EXPECT_EQ(live_bytes, before) << "all of it is given back";
        figure("memory_bytes_a_cell_" + scene.name, bytes_a_cell);
        WINDROW_EXPECT_FIGURE("memory_unsaid_" + scene.name, created, shared);
        WINDROW_EXPECT_FIGURE("memory_unsaid_with_motors_" + scene.name, with_motors, shared);
        WINDROW_EXPECT_FIGURE("memory_unsaid_other_sides_" + scene.name, with_other_sides, shared);
    }
}

TEST(Memory, AWorkspaceSaysWhatItHasAllocated) {
    const std::int64_t before = live_bytes;
    auto work =
        Workspace::create({.box = {.cells = {21, 12, 34}, .cell_size = 0.5f, .boundaries = Boundaries::open_over_floor()}});
    ASSERT_TRUE(work);
    const double created = unsaid(*work, before);
    ASSERT_TRUE(reserve_diffusion(*work));
    const double with_diffusion = unsaid(*work, before);
    WINDROW_EXPECT_FIGURE("memory_unsaid_workspace", created, 0.0);
    WINDROW_EXPECT_FIGURE("memory_unsaid_workspace_diffusion", with_diffusion, 0.0);
}

// Motors, a wake, sub-steps, viscosity, shifts, changing ambient: none of it allocates in the frame.
TEST(Memory, AFrameAllocatesNothing) {
    ThreadPool pool(2);
    for (NamedConfig& scene : measured_scenes()) {
        if (cell_count(scene.config.cells) > 100'000)
            continue; // shows nothing more than the smaller ones
        scene.config.parallel_for = pool.parallel_for();
        Wind wind = made(scene.config);
        Random random(111);
        for (int n = 0; n < 40; ++n) {
            DirectionalMotor motor{.position = random.point(8.0), .direction = random.vector(1.0f)};
            if (n % 2 == 0)
                motor.law = Force{500.0f};
            ASSERT_TRUE(wind.motors().add(motor));
        }
        const MotorId body = added(wind, WakeMotor{});
        Field texels(wind.field().size());
        std::vector<float> x(texels.size()), y(texels.size()), z(texels.size());
        std::int64_t in_steps = 0, in_frames = 0;
        int substeps = 0;
        for (int n = 0; n < 100; ++n) {
            const std::int64_t frame = allocations;
            bool accepted = wind.motors().move(body, random.point(8.0)).has_value();
            accepted = wind.follow(random.point(10.0)).has_value() && accepted;
            accepted = wind.set_ambient(random.vector(2.0f)).has_value() && accepted;
            const std::int64_t step = allocations;
            substeps = std::max(substeps, wind.step(n % 3 == 0 ? 0.1 : 0.01).substeps);
            in_steps += allocations - step;
            const glm::vec3 u = wind.velocity(random.point(10.0));
            accepted = wind.write_axes(std::span(x), std::span(y), std::span(z)).has_value() && accepted;
            in_frames += allocations - frame;
            ASSERT_TRUE(accepted && std::isfinite(u.x));
        }
        EXPECT_TRUE(substeps > 1 || scene.name == "one_cell");
        WINDROW_EXPECT_FIGURE("allocations_in_100_steps_" + scene.name, double(in_steps), 0.0);
        WINDROW_EXPECT_FIGURE("allocations_in_100_frames_" + scene.name, double(in_frames), 0.0);
    }
}

// The first frame makes what blending needs, the first source of air what its flow needs; after that nothing is made.
TEST(Memory, AFrameInTicksAllocatesNothing) {
    (void)GustTile::standard();
    const std::int64_t before = live_bytes;
    std::optional<Wind> wind;
    if (auto result = Wind::create({.ambient = {2.0f, 0.0f, 0.0f}, .gusts = {.intensity = 0.2f}}))
        wind.emplace(*std::move(result));
    ASSERT_TRUE(wind);
    Random random(113);
    bool accepted = true;
    for (int n = 0; n < 10; ++n) {
        const Envelope brief{.attack = 0.1f, .hold = 0.05f * static_cast<float>(n), .decay = 0.2f};
        for (const Motor& motor : {Motor(JetMotor{.position = random.point(8.0), .envelope = brief}), Motor(VortexMotor{}),
                                   Motor(OmniMotor{.position = random.point(8.0), .envelope = brief}), Motor(PressureMotor{})})
            accepted = wind->motors().add(motor).has_value() && accepted;
    }
    const auto body = wind->motors().add(WakeMotor{});
    ASSERT_TRUE(accepted && body);
    wind->advance(0.1);
    const std::int64_t made = allocations;
    for (int n = 0; n < 300; ++n) {
        for (int move = 0; move < 20; ++move)
            accepted = wind->motors().move(*body, random.point(8.0)).has_value() && accepted;
        accepted = wind->follow(random.point(10.0)).has_value() && accepted;
        wind->advance(0.007);
        accepted = std::isfinite(wind->felt(random.point(10.0), {.detail = 0.3f}).x) && accepted;
        accepted = std::isfinite(wind->previous_view().velocity(random.point(10.0)).x) && accepted;
    }
    const std::int64_t in_frames = allocations - made;
    const double unsaid_bytes = unsaid(*wind, before);
    EXPECT_TRUE(accepted);
    EXPECT_LT(wind->motors().count(), 41) << "motors ended on the way";
    WINDROW_EXPECT_FIGURE("allocations_in_300_frames_in_ticks", double(in_frames), 0.0);
    WINDROW_EXPECT_FIGURE("memory_unsaid_with_ticks", unsaid_bytes, 32.0);
}

// The list alone: bodies that move, come to rest and begin again, a box that moves among them.
TEST(Memory, ATickOfObstaclesAllocatesNothing) {
    const std::int64_t live = live_bytes;
    Obstacles list;
    Random random(112);
    std::vector<ObstacleId> ids;
    for (int n = 0; n < 3000; ++n)
        ids.push_back(*list.add({.position = random.point(60.0), .shape = Sphere{random.uniform(0.1f, 9.0f)}}));
    for (int n = 0; n < 300; ++n)
        ASSERT_TRUE(list.move(ids[static_cast<std::size_t>(n)], random.point(60.0)));
    EXPECT_EQ(static_cast<std::int64_t>(list.memory_bytes()),
              live_bytes - live - static_cast<std::int64_t>(ids.capacity() * sizeof(ObstacleId)));
    const std::int64_t made = allocations;
    bool accepted = true;
    std::size_t placed = 0;
    for (int n = 0; n < 100; ++n) {
        for (int k = 0; k < 300 && n % 4 == 0; ++k)
            accepted = list.move(ids[static_cast<std::size_t>((7 * n + k) % 3000)], random.point(60.0)).has_value() && accepted;
        list.begin_frame(0.0, 0.02);
        const Window window{.cells = {64, 32, 64}, .cell_size = 1.0f, .origin_cells = {n / 3 - 32, -16, -32}};
        placed = std::max(placed, list.tick(0.02, window, {}).size());
    }
    const std::int64_t in_ticks = allocations - made;
    EXPECT_TRUE(accepted);
    EXPECT_GT(placed, 300u);
    WINDROW_EXPECT_FIGURE("allocations_in_100_ticks_of_obstacles", double(in_ticks), 0.0);
}

// Bodies that move, turn and pass through the box, a thin plate, a walk of the box along a
// street. The first steps make the room for bodies as they come into the box; what moves on finds it made.
TEST(Memory, AStepOfMovingBodiesAllocatesNothing) {
    for (const bool gusty : {false, true}) {
        Config config{.cells = {32, 12, 24}, .boundaries = Boundaries::open_over_floor(), .centre = {0.0, 6.0, 0.0}};
        config.ambient = {6.0f, 0.0f, 1.0f};
        config.viscosity = 0.5f;
        if (gusty)
            config.gusts = {.intensity = 0.2f};
        Wind wind = made(config);
        const auto turned = [](double angle) { return glm::quat(glm::angleAxis(angle, glm::dvec3(0.0, 1.0, 0.0))); };
        const auto placed = [&](const Obstacle& obstacle) { return *wind.obstacles().add(obstacle); };
        for (int n = -3; n < 12; ++n) // a street
            placed({.position = {9.0 * n, 3.0, n % 2 == 0 ? 9.0 : -9.0},
                    .orientation = turned(n % 2 == 0 ? 0.3 : -0.2),
                    .shape = Block{{2.5f, 3.0f, 2.0f}}});
        const ObstacleId fence = placed({.position = {2.0, 2.0, 4.0}, .shape = Plate{{3.0f, 2.0f}}}),
                         train = placed({.position = {0.0, 2.0, -4.0}, .shape = Block{{4.0f, 2.0f, 1.3f}}}),
                         ball = placed({.position = {0.0, 6.0, 0.0}, .shape = Sphere{2.2f}});
        std::int64_t in_steps = 0;
        bool accepted = true;
        for (int n = 0; n < 180; ++n) {
            const double at = 0.2 * n; // [m] of the box
            const std::int64_t before = allocations;
            accepted = accepted && wind.follow({at, 6.0, 0.0});
            accepted = accepted && wind.obstacles().move(fence, {at + 2.0, 2.0, 4.0}, turned(0.05 * n));
            accepted = accepted && wind.obstacles().move(train, {at + 6.0 * std::sin(0.07 * n), 2.0, -4.0}, turned(0.02 * n));
            accepted = accepted && wind.obstacles().move(ball, {at + std::sin(0.2 * n), 6.0 + std::cos(0.2 * n), 0.0});
            (void)wind.step(n % 5 == 0 ? 0.1 : 1.0 / 30.0);
            if (n >= 100)
                in_steps += allocations - before;
        }
        EXPECT_TRUE(accepted);
        WINDROW_EXPECT_FIGURE(std::string("allocations_in_80_steps_of_bodies") + (gusty ? "_in_gusts" : ""), double(in_steps),
                              0.0);
    }
}

TEST(Memory, AStepOfUpToASecondAllocatesNothing) {
    // A viscosity that asks for nothing at 60 Hz and for a pass in longer steps, and one that comes to ask for a solve.
    for (const float viscosity : {1e-4f, 5e-3f, 0.5f}) {
        Wind wind = made({.cells = {16, 8, 16}, .viscosity = viscosity});
        const std::int64_t before = allocations;
        for (const double dt : {1.0 / 60.0, 0.1, 1.0})
            wind.step(dt);
        const std::int64_t made = allocations - before;
        WINDROW_EXPECT_FIGURE("allocations_in_long_steps_viscosity_" + std::to_string(viscosity), double(made), 0.0);
    }
}

} // namespace
