// Obstacles in a wind: sleep, snapshots, logs.

#include "fluid/core/bytes.h"
#include "fluid/event_log.h"
#include "fluid/solids/solids.h"
#include "fluid/thread_pool.h"
#include "fluid/wind_state.h"
#include "tests/shapes.h"
#include "tests/tier.h"
#include "tests/unit/snapshot_session.h"

#include <array>

namespace {

using namespace windrow;
using namespace windrow::test;

Config breezy() {
    return {.cells = {14, 8, 12}, .ambient = {2.0f, 0.0f, 0.5f}, .ticks = {.hz = 30.0}};
}

std::vector<ObstacleId> add_bodies(Wind& wind) {
    const Obstacle bodies[] = {
        {.position = {0.2, -2.0, 1.0}, .orientation = glm::quat(2, 0, 1, 0), .shape = Block{{1.5f, 1.0f, 0.7f}}},
        {.position = {3.0, 0.0, -2.0}, .shape = Cylinder{.radius = 0.6f, .half_length = 3.0f}},
        {.position = {-3.0, 0.0, 2.0}, .shape = Plate{{1.0f, 2.0f}}, .surface = Surface::no_slip},
        {.position = {1.0, 2.0, 3.0}, .shape = Capsule{.half_axis = {0.0f, 1.0f, 0.5f}}},
        {.position = {-4.0, 1.0, -3.0}, .shape = Sphere{1.1f}},
        {.position = {90.0, 1.0, -3.0}},
        {.position = {-2.0, -1.0, -2.0},
         .orientation = glm::quat(1, 0, 2, 0),
         .shape = MeshShape{mesh_of(room_mesh({1.0f, 1.0f, 1.5f}, 0.2f))}},
        {.position = {4.0, -1.0, 3.0}, .shape = MeshShape{mesh_of(room_mesh({1.0f, 1.0f, 1.5f}, 0.2f)), 0.5f}},
        {.position = {0.0, -3.0, 0.0}, .shape = VoxelShape{grid_of({.cells = {3, 1, 3}, .closed = {1, 0, 1, 0, 1, 0, 1, 1, 1}})}},
        {.position = {-4.0, -3.6, -4.0},
         .shape = Ground{heights_of({{2, 3}, 1.0f, {0.0f, 1.0f, 0.5f, 0.0f, 0.0f, 0.8f}}), {4.0f, 1.0f, 3.0f}}},
    };
    std::vector<ObstacleId> ids;
    for (const Obstacle& body : bodies)
        ids.push_back(*wind.obstacles().add(body));
    EXPECT_TRUE(wind.obstacles().remove(ids[3]));
    return ids;
}

TEST(WindWithObstacles, SleepsWhereNothingActs) {
    Wind calm = made({.cells = {8, 8, 8}});
    const ObstacleId body = *calm.obstacles().add({.shape = Sphere{1.5f}});
    take_steps(calm, 6, 0.1);
    EXPECT_TRUE(calm.step(0.1).asleep) << "still air around a body at rest";
    EXPECT_TRUE(calm.follow({3.0, 0.0, 0.0}));
    EXPECT_TRUE(calm.step(0.1).asleep) << "the box moves among bodies at rest";
    EXPECT_TRUE(calm.obstacles().move(body, {0.5, 0.0, 0.0}));
    EXPECT_FALSE(calm.step(0.1).asleep) << "it moves";

    Wind wind = made({.cells = {8, 8, 8}, .ambient = {3.0f, 0.0f, 0.0f}});
    take_steps(wind, 3, 0.1);
    EXPECT_TRUE(wind.step(0.1).asleep);
    EXPECT_TRUE(wind.obstacles().add({.position = {500.0, 0.0, 0.0}}));
    EXPECT_TRUE(wind.step(0.1).asleep) << "a body far away";
    const ObstacleId near = *wind.obstacles().add({.position = {20.0, 0.0, 0.0}});
    EXPECT_TRUE(wind.step(0.1).asleep);
    EXPECT_TRUE(wind.follow({16.0, 0.0, 0.0}));
    for (int n = 0; n < 5; ++n)
        EXPECT_FALSE(wind.step(0.1).asleep) << "wind that meets a body";
    EXPECT_TRUE(wind.obstacles().remove(near));
    EXPECT_FALSE(wind.step(0.1).asleep) << "its wake is left";

    Wind sleepy = made({.cells = {8, 8, 8}, .ambient = {3.0f, 0.0f, 0.0f}, .sleep_speed = 100.0f});
    EXPECT_TRUE(sleepy.obstacles().add({}));
    EXPECT_FALSE(take_steps(sleepy, 3, 0.1).asleep) << "however little it differs";
}

TEST(WindWithObstacles, OneMayFillABoxThatTheAirCannotLeave) {
    for (const BoundaryKind kind : {BoundaryKind::periodic, BoundaryKind::free_slip}) {
        Wind wind = made({.cells = {6, 4, 6}, .boundaries = Boundaries::all(kind)});
        const ObstacleId body = *wind.obstacles().add({.shape = Sphere{20.0f}});
        for (int n = 0; n < 3; ++n) {
            EXPECT_TRUE(wind.obstacles().move(body, {0.1 * n, 0.0, 0.0}));
            EXPECT_EQ(wind.step(0.1).repaired_cells, 0);
        }
        EXPECT_NEAR(wind.velocity({0.0, 0.0, 0.0}).x, 1.0f, 1e-4f) << "the body's own";
        EXPECT_TRUE(wind.obstacles().remove(body));
        EXPECT_EQ(wind.step(0.1).repaired_cells, 0) << "air again";
    }
}

// A body across an end of the box, of which a periodic boundary makes a second one and an open end another wall.
TEST(WindWithObstacles, AreThereAnewWhereBoundariesChange) {
    Wind wind = made({.cells = {10, 6, 8}, .ambient = {3.0f, 0.0f, 1.0f}});
    ASSERT_TRUE(wind.obstacles().add({.position = {5.0, 0.0, 0.0}, .shape = Block{{2.0f, 2.0f, 1.5f}}}));
    take_steps(wind, 3, 0.1);
    std::vector<float> inside(wind.field().size());
    for (const BoundaryKind kind : {BoundaryKind::periodic, BoundaryKind::free_slip, BoundaryKind::open}) {
        Boundaries boundaries;
        boundaries.x_low.kind = boundaries.x_high.kind = kind;
        ASSERT_TRUE(wind.set_boundaries(boundaries));
        (void)wind.step(0.1);
        ASSERT_TRUE(wind.write_obstacles(inside));
        EXPECT_EQ(inside[wind.box().index(0, 3, 4)], kind == BoundaryKind::periodic ? 1.0f : 0.0f);
        EXPECT_EQ(inside[wind.box().index(9, 3, 4)], 1.0f);
        Wind again = *Wind::load(*wind.save());
        for (Wind* const one : {&wind, &again})
            take_steps(*one, 2, 0.1);
        EXPECT_TRUE(std::equal(wind.field().begin(), wind.field().end(), again.field().begin()));
    }
}

// Air that sleeps places no body; a query of the cells inside does, as the box moves.
TEST(WindWithObstacles, BodiesThatSleepingAirMeetsAreMarked) {
    Wind wind = made({.cells = {16, 8, 12}, .boundaries = Boundaries::open_over_floor(), .centre = {0.0, 4.0, 0.0}});
    ASSERT_TRUE(wind.obstacles().add({.position = {20.0, 2.0, 0.0}, .shape = Block{{2.0f, 3.0f, 2.5f}}}));
    std::vector<float> inside(wind.field().size()), awake(inside.size());
    const auto marked = [](const std::vector<float>& cells) { return std::count(cells.begin(), cells.end(), 1.0f); };
    for (int n = 0; n < 24; ++n) {
        ASSERT_TRUE(wind.follow({1.0 * n, 4.0, 0.0}));
        const Diagnostics report = wind.step(0.1);
        ASSERT_TRUE(wind.write_obstacles(inside));
        Wind other = made({.cells = {16, 8, 12}, .boundaries = Boundaries::open_over_floor(), .centre = {1.0 * n, 4.0, 0.0}});
        ASSERT_EQ(other.origin(), wind.origin());
        ASSERT_TRUE(other.obstacles().add({.position = {20.0, 2.0, 0.0}, .shape = Block{{2.0f, 3.0f, 2.5f}}}));
        (void)other.step(0.1);
        ASSERT_TRUE(other.write_obstacles(awake));
        EXPECT_EQ(inside, awake) << n << (report.asleep ? ", asleep" : ", awake");
    }
    EXPECT_GT(marked(inside), 0);
}

TEST(WindWithObstacles, AWindWithoutThemIsAsItWas) {
    Wind plain = made(breezy()), far = made(breezy());
    for (int n = 0; n < 500; ++n)
        ASSERT_TRUE(far.obstacles().add({.position = {100.0 + 3 * n, 0.0, 0.0}}));
    for (Wind* wind : {&plain, &far}) {
        added(*wind, JetMotor{});
        for (int n = 0; n < 20; ++n)
            (void)wind->step(0.03);
    }
    EXPECT_TRUE(std::equal(plain.field().begin(), plain.field().end(), far.field().begin()));
}

// With more surface cells than one task takes.
TEST(WindWithObstacles, SeveralWorkersGiveTheSameBits) {
    ThreadPool pool(4);
    std::vector<Bytes> ends;
    for (const bool serial : {true, false}) {
        Config config{.cells = {24, 10, 24}, .ambient = {5.0f, 0.0f, 1.0f}, .roughness = Roughness{}};
        if (!serial)
            config.parallel_for = pool.parallel_for();
        Wind wind = made(config);
        for (const double z : {-8.0, 0.0, 8.0})
            ASSERT_TRUE(wind.obstacles().add({.position = {0.0, 0.0, z}, .shape = Block{{1.0f, 4.0f, 3.0f}}}));
        take_steps(wind, 5, 0.05);
        ends.push_back(*wind.save());
    }
    EXPECT_EQ(ends[0], ends[1]);
}

void play(Wind& wind, std::span<const ObstacleId> ids, int frame) {
    const double t = 0.02 * frame;
    EXPECT_TRUE(wind.obstacles().move(ids[0], {0.2 + t, -2.0, 1.0 - 2.0 * t}));
    EXPECT_TRUE(wind.obstacles().move(ids[1], {3.0, std::sin(t), -2.0}, glm::quat(2.0f, float(t), 0.3f, 0.0f)));
    EXPECT_TRUE(wind.obstacles().move(ids[6], {-2.0, -1.0, -2.0}, glm::quat(1.0f, 0.0f, 0.0f, 0.0f), {0.0f, 2.0f, 0.0f}));
    if (frame % 7 == 3) {
        EXPECT_TRUE(wind.follow({0.4 * frame, 0.0, -0.2 * frame}));
    }
    if (frame == 11) {
        EXPECT_TRUE(wind.obstacles().add({.position = {2.0, 0.0, 3.0}}));
    }
}

TEST(SnapshotWithObstacles, GoesOnToTheSameBits) {
    for (const bool ticks : {false, true}) {
        const auto go = [&](Wind& wind) {
            if (ticks)
                (void)wind.advance(1.0 / 144.0);
            else
                (void)wind.step(0.02);
        };
        Wind first = made(breezy());
        const auto ids = add_bodies(first);
        for (int n = 0; n < 9; ++n) {
            play(first, ids, n);
            go(first);
        }
        const Bytes bytes = *first.save();
        Wind again = loaded(bytes);
        ASSERT_EQ(*again.save(), bytes);
        EXPECT_EQ(again.obstacles().count(), 9);
        for (int n = 9; n < 40; ++n) {
            for (Wind* wind : {&first, &again}) {
                if (n < 25) // then they come to rest
                    play(*wind, ids, n);
                go(*wind);
            }
            ASSERT_EQ(*again.save(), *first.save()) << "frame " << n << (ticks ? ", ticks" : "");
        }
    }
}

// A drawing that is kept while the box moves is that of a wind which begins there. Places of these balls are half parts of a cell
// (Solids::View), which floats round up in one box and down in another.
TEST(SnapshotWithObstacles, GoesOnToTheSameBitsWhereverTheBoxHasBeen) {
    Wind first = made({.cells = {14, 8, 12}, .cell_size = 0.652466f, .ambient = {4.0f, 0.0f, 1.0f}});
    const double h = static_cast<double>(0.652466f);
    for (int n = 0; n < 6; ++n)
        ASSERT_TRUE(first.obstacles().add(
            {.position = glm::dvec3(0.37 + n, 0.21 - 0.5 * (n % 3), 0.13 + 2.0 * (n % 4) - 3.0) * h, .shape = Sphere{0.45f}}));
    for (int n = 0; n < 8; ++n) {
        ASSERT_TRUE(first.follow(glm::dvec3(0.8 * n, 0.0, -0.6 * n) * h));
        (void)first.step(0.03);
        Wind again = loaded(*first.save());
        (void)first.step(0.03);
        (void)again.step(0.03);
        ASSERT_EQ(*again.save(), *first.save()) << "step " << n;
    }
}

TEST(SnapshotWithObstacles, ASleeperSleepsOn) {
    Wind first = made({.cells = {8, 8, 8}});
    ASSERT_TRUE(first.obstacles().add({.shape = Sphere{1.5f}}));
    take_steps(first, 7, 0.1);
    Wind again = loaded(*first.save());
    for (Wind* wind : {&first, &again})
        ASSERT_TRUE(wind->obstacles().add({.position = {50.0, 0.0, 0.0}}));
    EXPECT_TRUE(again.step(0.1).asleep) << "one that is added far away does not wake it";
    EXPECT_TRUE(first.step(0.1).asleep);
    EXPECT_EQ(*again.save(), *first.save());
}

TEST(SnapshotWithObstacles, EachFieldCounts) {
    using Change = std::function<void(Obstacle&)>;
    const std::vector<Change> changes{
        [](Obstacle&) {},
        [](Obstacle& o) { o.position.x = 1.5; },
        [](Obstacle& o) { o.position.y = 1.5; },
        [](Obstacle& o) { o.position.z = 1.5; },
        [](Obstacle& o) {
            o.orientation = {0, 1, 0, 0};
        },
        [](Obstacle& o) {
            o.orientation = {0, 0, 1, 0};
        },
        [](Obstacle& o) {
            o.orientation = {0, 0, 0, 1};
        },
        [](Obstacle& o) { o.surface = Surface::no_slip; },
        [](Obstacle& o) {
            o.shape = Block{{2, 1, 1}};
        },
        [](Obstacle& o) {
            o.shape = Block{{1, 2, 1}};
        },
        [](Obstacle& o) {
            o.shape = Block{{1, 1, 2}};
        },
        [](Obstacle& o) { o.shape = Sphere{}; },
        [](Obstacle& o) { o.shape = Sphere{1.5f}; },
        [](Obstacle& o) { o.shape = Capsule{}; },
        [](Obstacle& o) {
            o.shape = Capsule{.half_axis = {0, 1, 0}};
        },
        [](Obstacle& o) { o.shape = Capsule{.radius = 0.5f}; },
        [](Obstacle& o) { o.shape = Cylinder{}; },
        [](Obstacle& o) { o.shape = Cylinder{.radius = 0.5f}; },
        [](Obstacle& o) { o.shape = Cylinder{.half_length = 0.5f}; },
        [](Obstacle& o) { o.shape = Plate{}; },
        [](Obstacle& o) {
            o.shape = Plate{{2, 1}};
        },
        [](Obstacle& o) {
            o.shape = Plate{{1, 2}};
        },
        [](Obstacle& o) { o.shape = MeshShape{mesh_of(box_mesh(glm::vec3(1.0f)))}; },
        [](Obstacle& o) { o.shape = MeshShape{mesh_of(box_mesh(glm::vec3(2.0f)))}; },
        [](Obstacle& o) { o.shape = MeshShape{mesh_of(inside_out(box_mesh(glm::vec3(1.0f))))}; },
        [](Obstacle& o) {
            o.shape = MeshShape{mesh_of(box_mesh(glm::vec3(1.0f))), 2.0f};
        },
        [](Obstacle& o) {
            o.shape = VoxelShape{grid_of({.cells = {2, 1, 1}, .closed = {1, 1}})};
        },
        [](Obstacle& o) {
            o.shape = VoxelShape{grid_of({.cells = {2, 1, 1}, .closed = {0, 1}})};
        },
        [](Obstacle& o) {
            o.shape = VoxelShape{grid_of({.cells = {1, 2, 1}, .closed = {1, 1}})};
        },
        [](Obstacle& o) {
            o.shape = VoxelShape{grid_of({.cells = {2, 1, 1}, .closed = {1, 1}}), 2.0f};
        },
        [](Obstacle& o) {
            o.shape = Ground{heights_of({{2, 2}, 1.0f, {0, 0, 0, 1}})};
        },
        [](Obstacle& o) {
            o.shape = Ground{heights_of({{2, 2}, 1.0f, {0, 0, 0, 2}})};
        },
        [](Obstacle& o) {
            o.shape = Ground{heights_of({{2, 2}, 2.0f, {0, 0, 0, 1}})};
        },
        [](Obstacle& o) {
            o.shape = Ground{heights_of({{2, 3}, 1.0f, {0, 0, 0, 1, 0, 0}})};
        },
        [](Obstacle& o) {
            o.shape = Ground{heights_of({{2, 2}, 1.0f, {0, 0, 0, 1}}), {1.0f, 2.0f, 1.0f}};
        },
    };
    std::vector<Bytes> seen;
    for (const Change& change : changes) {
        Wind wind = made({.cells = {2, 2, 2}});
        Obstacle obstacle;
        change(obstacle);
        ASSERT_TRUE(wind.obstacles().add(obstacle));
        const Bytes bytes = *wind.save();
        EXPECT_EQ(std::find(seen.begin(), seen.end(), bytes), seen.end()) << "change " << seen.size() << " leaves no trace";
        EXPECT_EQ(*loaded(bytes).save(), bytes) << "change " << seen.size();
        seen.push_back(bytes);
    }
}

TEST(SnapshotWithObstacles, EqualMeshesAreSavedOnceAndShared) {
    const MeshData data = ball_mesh(1.0f, 3);
    const auto bytes_of = [&](int count) {
        Wind wind = made({.cells = {2, 2, 2}});
        for (int n = 0; n < count; ++n)
            EXPECT_TRUE(wind.obstacles().add({.position = {5.0 * n, 0.0, 0.0}, .shape = MeshShape{mesh_of(data)}}));
        return *wind.save();
    };
    const std::size_t mesh = data.vertices.size() * sizeof(glm::vec3) + data.triangles.size() * sizeof(glm::uvec3);
    const Bytes one = bytes_of(1), ten = bytes_of(10);
    EXPECT_GT(one.size(), mesh);
    EXPECT_LT(ten.size(), one.size() + mesh / 4);
    Wind again = loaded(ten);
    EXPECT_EQ(*again.save(), ten);
    const TriangleMesh* first = nullptr;
    for (const Obstacles::Slot& slot : again.obstacles().slots()) {
        const TriangleMesh* const here = std::get<MeshShape>(slot.obstacle.shape).mesh.get();
        EXPECT_TRUE(first == nullptr || here == first);
        first = here;
    }
}

TEST(SnapshotWithObstacles, ForgedMeshesAreRejected) {
    Wind wind = made({.cells = {1, 1, 1}});
    ASSERT_TRUE(wind.obstacles().add({.shape = MeshShape{mesh_of(box_mesh(glm::vec3(77.0f)))}}));
    ASSERT_TRUE(wind.obstacles().add({.shape = VoxelShape{grid_of({.cells = {3, 1, 1}, .closed = {1, 0, 1}}), 55.0f}}));
    const Bytes bytes = *wind.save();
    const auto layout = detail::load_number<std::uint32_t>(bytes.data() + detail::k_letters);
    const auto find = [&](auto number) {
        std::array<std::byte, sizeof number> wanted;
        detail::store_number(wanted.data(), number);
        return static_cast<std::size_t>(std::search(bytes.begin(), bytes.end(), wanted.begin(), wanted.end()) - bytes.begin());
    };
    const std::size_t corner = find(-77.0f); // the first vertex: before it its count and the mesh's number
    ASSERT_LT(corner, bytes.size());
    const std::size_t triangles = corner + 8 * sizeof(glm::vec3), bits = find(55.0f) - 1;
    const auto rejection = [&](std::size_t at, auto number) {
        Bytes forged(bytes.begin(), bytes.end() - static_cast<std::ptrdiff_t>(detail::k_checksum_bytes));
        detail::store_number(&forged[at], number);
        detail::seal(forged, {"WINDSNAP", layout, "", ""});
        const auto read = Wind::load(forged);
        return read ? std::string() : read.error();
    };
    const std::tuple<std::string, std::string> said[] = {
        {rejection(corner - 8, 1u), "the form of a body has the number 1, but only 0 are before it."},
        {rejection(corner - 8, ~0u), "snapshot cannot be used"},
        {rejection(corner - 4, 1u << 30), "its length is 1073741824 items of 12 bytes or more"},
        {rejection(corner, k_nan), "vertex 0 of the mesh is at (nan, -77, -77) m"},
        {rejection(corner, 1.0f), ""}, // another closed mesh
        {rejection(corner, -0.0f), "the form of a body is not as it was written."},
        {rejection(corner, 77.0f), "snapshot cannot be used"}, // two vertices at one place
        {rejection(triangles + 4, 99u), "triangle 0 of the mesh has the vertex 99 of 8"},
        {rejection(triangles + 4, 3u), "the mesh"},
        {rejection(bits, std::uint8_t{0}), "the voxel grid has no closed cell"},
        {rejection(bits, std::uint8_t{9}), "a voxel grid has cells beyond its last."},
        {rejection(bits - 4, 0u), "a voxel grid's size is out of range."},
        {rejection(bits - 4, 5000u), "a voxel grid's size is out of range."},
    };
    for (const auto& [sentence, reason] : said) {
        EXPECT_EQ(sentence.empty(), reason.empty()) << reason;
        EXPECT_NE(sentence.find(reason), std::string::npos) << sentence << " is not " << reason;
    }
}

TEST(SnapshotWithObstacles, ForgedOnesDoNoHarm) {
    Wind wind = made({.cells = {3, 2, 3}});
    const auto ids = add_bodies(wind);
    for (int n = 0; n < 5; ++n) {
        play(wind, ids, n);
        (void)wind.step(0.02);
    }
    const Bytes bytes = *wind.save();
    const auto layout = detail::load_number<std::uint32_t>(bytes.data() + detail::k_letters);
    Random random(8);
    int readable = 0;
    const int forgeries = sampled(3000, k_sanitized ? 150 : 300);
    for (int n = 0; n < forgeries; ++n) {
        Bytes forged(bytes.begin(), bytes.end() - static_cast<std::ptrdiff_t>(detail::k_checksum_bytes));
        for (int k = 0; k < 1 + n % 3; ++k)
            forged[static_cast<std::size_t>(random.integer(detail::k_header_bytes, static_cast<int>(forged.size()) - 1))] =
                static_cast<std::byte>(random.bits());
        detail::seal(forged, {"WINDSNAP", layout, "", ""});
        auto read = Wind::load(forged);
        if (!read)
            continue;
        ++readable;
        (void)read->step(0.02);
        const auto saved = read->save();
        ASSERT_TRUE(saved);
        ASSERT_TRUE(Wind::load(*saved)) << Wind::load(*saved).error();
    }
    EXPECT_GT(readable, forgeries / 10);
}

TEST(ReplayWithObstacles, EndsInTheSameBits) {
    Wind wind = made(breezy());
    const auto before = *wind.obstacles().add({.position = {0.0, 3.0, 0.0}});
    (void)wind.advance(0.1);
    const Bytes start = *wind.save();
    EventLog log;
    wind.record_to(&log);
    const auto ids = add_bodies(wind);
    for (int n = 0; n < 20; ++n) {
        play(wind, ids, n);
        (void)wind.advance(0.021);
    }
    ASSERT_TRUE(wind.obstacles().set(ids[2], {.position = {-2.0, 0.0, 2.0}}));
    ASSERT_TRUE(wind.obstacles().remove(before));
    EXPECT_FALSE(wind.obstacles().remove(before)) << "what is rejected is not in the log";
    (void)wind.advance(0.05);
    const auto read = EventLog::from_bytes(*log.to_bytes());
    ASSERT_TRUE(read) << read.error();
    Wind again = loaded(start);
    const auto done = replay(*read, again);
    ASSERT_TRUE(done) << done.error();
    EXPECT_EQ(*again.save(), *wind.save());

    Wind other = made(breezy());
    EventLog stranger;
    stranger.note(ObstacleAdded{{3, 1}, {}});
    EXPECT_EQ(
        replay(stranger, other).error(),
        "event 0 (add_obstacle): the obstacle got slot 0 of generation 1, not in slot 3 of generation 1, so the wind was not "
        "in the state in which the log began: load the snapshot taken there.");
}

// A read from the one side of a body reaches the other where it is thin in the cells that it is in, not in those aloft: reads
// beside thin bodies cost many times those of other cells.
TEST(ThinBodies, AreMeasuredInTheirOwnRows) {
    const Rows rows{.first = 0.5f, .uniform = 8, .top = 80.0f};
    Box box{.cells = {24, 32, 24}, .boundaries = Boundaries::open_over_floor()};
    box.rows = *RowTable::create(rows, box.cells.y, box.cell_size);
    ASSERT_GT(box.rows->coarsest(), 5.0f);
    const auto thin_cells = [&](float height, glm::vec3 half_size) {
        Solids solids(box, box.cells.x);
        solids.place(std::array{PlacedObstacle{.shape = Block{half_size}, .position = {12.0f, height, 12.0f}}});
        solids.reach_past_thin(0.5f);
        return solids.thin().size();
    };
    EXPECT_EQ(thin_cells(3.0f, {3.0f, 3.0f, 3.0f}), 0u) << "a house of 6 m over rows of half a metre";
    EXPECT_GT(thin_cells(3.0f, {1.0f, 3.0f, 3.0f}), 0u) << "a wall of two cells";
    EXPECT_GT(thin_cells(70.0f, {6.0f, 6.0f, 6.0f}), 0u) << "two and a half of the rows aloft";
}

// One that stops all wind is counted; a ground is not, nor is one whose larger part is outside.
TEST(ObstacleWind, OneThatFillsTheBoxIsCounted) {
    Wind wind = made({.cells = {8, 8, 8}, .ambient = {5.0f, 0.0f, 0.0f}});
    const ObstacleId house = *wind.obstacles().add({.shape = Block{{400.0f, 300.0f, 350.0f}}});
    EXPECT_EQ(wind.step(0.02).filling_obstacles, 1);
    ASSERT_TRUE(wind.obstacles().set(house, {.shape = Block{{4.0f, 3.0f, 3.5f}}}));
    EXPECT_EQ(wind.step(0.02).filling_obstacles, 1);
    ASSERT_TRUE(wind.obstacles().set(house, {.position = {4.1, 0.0, 0.0}, .shape = Block{{4.0f, 3.0f, 3.5f}}}));
    EXPECT_EQ(wind.step(0.02).filling_obstacles, 0);
    ASSERT_TRUE(wind.obstacles().remove(house));
    EXPECT_EQ(wind.step(0.02).filling_obstacles, 0);
}

// A floor of rows that rises takes the gusts out of the air and puts others in: not into a closed room.
TEST(ObstacleWind, ARoomStaysStillWhereItsFloorRises) {
    Wind wind = made({.cells = {20, 12, 20},
                      .boundaries = Boundaries::open_over_floor(),
                      .ambient = {6.0f, 0.0f, 1.0f},
                      .gusts = {.intensity = 0.2f},
                      .rows = Rows{.first = 0.5f, .uniform = 8, .ratio = 1.1f}});
    ASSERT_TRUE(
        wind.obstacles().add({.position = {0.0, 2.2, 0.0}, .shape = MeshShape{mesh_of(room_mesh({4.0f, 2.2f, 4.0f}, 1.0f))}}));
    take_steps(wind, 20, 0.05);
    ASSERT_TRUE(wind.set_floor(0.5));
    take_steps(wind, 1, 0.05);
    EXPECT_LT(glm::length(wind.velocity({0.3, 2.0, -0.4})), 0.01f);
}

} // namespace
