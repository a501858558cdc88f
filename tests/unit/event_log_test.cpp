// EventLog and replay: the same calls on the same state give the same state to the bit, through bytes and with any number of
// threads.

#include "fluid/core/bytes.h"
#include "fluid/event_log.h"
#include "fluid/thread_pool.h"
#include "tests/shapes.h"
#include "tests/tier.h"
#include "tests/unit/snapshot_session.h"

#include <array>

namespace {

using namespace windrow;
using namespace windrow::test;

Config windy() {
    Config config{.cells = {13, 8, 10}, .ambient = {3.0f, 0.0f, -1.0f}};
    config.boundaries.y_low.kind = BoundaryKind::no_slip;
    config.profile = LogProfile{};
    config.gusts = {.intensity = 0.2f, .length = 8.0f};
    return config;
}

Motor random_motor(Random& random) {
    const glm::dvec3 at = random.point(6.0);
    const Envelope envelope{.attack = random.uniform(0.0f, 0.2f), .hold = random.uniform(0.0f, 1.5f), .decay = 0.1f};
    switch (random.integer(0, 6)) {
    case 0:
        return DirectionalMotor{.position = at, .direction = random.vector(3.0f), .envelope = envelope};
    case 1:
        return DirectionalMotor{
            .position = at, .region = Cone{.axis = random.vector(4.0f)}, .law = Force{random.uniform(-20.0f, 20.0f)}};
    case 2:
        return JetMotor{.position = at, .direction = random.vector(3.0f), .envelope = envelope};
    case 3:
        return VortexMotor{.position = at, .axis = random.vector(3.0f), .lift = random.uniform(-1.0f, 1.0f)};
    case 4:
        return OmniMotor{.position = at, .speed = random.uniform(-4.0f, 4.0f), .envelope = envelope};
    case 5:
        return PressureMotor{.position = at, .speed = random.uniform(-9.0f, 9.0f)};
    default:
        return WakeMotor{.position = at, .radius = random.uniform(0.3f, 1.5f)};
    }
}

glm::quat random_turn(Random& random) {
    return {1.0f, random.uniform(-1.0f, 1.0f), random.uniform(-1.0f, 1.0f), random.uniform(-1.0f, 1.0f)};
}

Obstacle random_obstacle(Random& random) {
    static const MeshShape ball{mesh_of(ball_mesh(1.0f, 1))}, room{mesh_of(room_mesh({2.0f, 1.0f, 1.5f}, 0.2f)), 1.5f};
    static const VoxelShape step{grid_of({.cells = {2, 2, 1}, .closed = {1, 0, 1, 1}}), 0.75f};
    static const Ground slope{heights_of({{2, 2}, 1.0f, {0.0f, 1.0f, -1.0f, 0.5f}}), {2.0f, 1.0f, 3.0f}};
    const Shape shapes[] = {Sphere{random.uniform(0.2f, 2.0f)}, Capsule{}, Block{}, Cylinder{}, Plate{}, ball, room, step, slope};
    return {.position = random.point(6.0),
            .orientation = random_turn(random),
            .shape = shapes[random.integer(0, 8)],
            .surface = static_cast<Surface>(random.integer(0, 1))};
}

DragDeposit random_deposit(Random& random) {
    if (random.integer(0, 1) == 0)
        return PlantDrag{.position = random.point(6.0), .radius = random.uniform(0.1f, 3.0f), .area = random.uniform(0.0f, 5.0f)};
    return BeltDrag{.start = random.point(6.0), .end = random.point(6.0), .width = random.uniform(0.1f, 3.0f)};
}

/// Any call that a host can make, with handles that may be stale: what is rejected leaves no trace in the log.
class AnyHost {
  public:
    AnyHost(Wind& wind, std::uint32_t seed) : wind_(wind), random_(seed) {}

    void call() {
        switch (random_.integer(0, 28)) {
        case 26:
            (void)wind_.shift_origin(glm::round(random_.point(30.0)));
            return;
        case 0:
        case 1:
            if (const auto id = wind_.motors().add(random_motor(random_)))
                motors_.push_back(*id);
            return;
        case 2:
            (void)wind_.motors().set(some_motor(), random_motor(random_));
            return;
        case 3:
            (void)wind_.motors().remove(some_motor());
            return;
        case 4:
            (void)wind_.follow(random_.point(9.0));
            return;
        case 5:
            (void)wind_.set_floor(random_.real(-4.0, 4.0));
            return;
        case 6:
            (void)wind_.set_ambient(random_.vector(5.0f));
            return;
        case 7:
            (void)wind_.set_gusts({.intensity = random_.uniform(0.0f, 0.4f), .length = 8.0f, .seed = random_.bits() % 3});
            return;
        case 8:
            change_floor();
            return;
        case 9:
            set_velocity();
            return;
        case 10:
            wind_.reset();
            return;
        case 11:
        case 12:
            (void)wind_.step(random_.real(0.005, 0.1));
            return;
        case 13:
        case 14:
        case 15:
        case 16:
            (void)wind_.advance(random_.real(0.0, 0.07));
            return;
        case 17:
            if (const auto id = wind_.obstacles().add(random_obstacle(random_)))
                obstacles_.push_back(*id);
            return;
        case 18:
            (void)wind_.obstacles().set(some_obstacle(), random_obstacle(random_));
            return;
        case 19:
            (void)wind_.obstacles().remove(some_obstacle());
            return;
        case 20:
        case 21:
            (void)wind_.obstacles().move(some_obstacle(), random_.point(6.0));
            return;
        case 22:
            (void)wind_.obstacles().move(some_obstacle(), random_.point(6.0), random_turn(random_));
            return;
        case 23:
            if (const auto id = wind_.drag().add(random_deposit(random_)))
                deposits_.push_back(*id);
            return;
        case 24:
            if (!deposits_.empty())
                (void)wind_.drag().set(deposits_.back(), random_deposit(random_));
            return;
        case 25:
            if (!deposits_.empty() && random_.integer(0, 2) == 0) // else it stays, to be seen
                (void)wind_.drag().remove(deposits_.back());
            return;
        default:
            (void)wind_.motors().move(some_motor(), random_.point(6.0));
            return;
        }
    }

  private:
    MotorId some_motor() {
        return motors_.empty() ? MotorId{}
                               : motors_[static_cast<std::size_t>(random_.integer(0, static_cast<int>(motors_.size()) - 1))];
    }
    ObstacleId some_obstacle() {
        return obstacles_.empty()
                   ? ObstacleId{}
                   : obstacles_[static_cast<std::size_t>(random_.integer(0, static_cast<int>(obstacles_.size()) - 1))];
    }
    void change_floor() {
        Boundaries boundaries = wind_.config().boundaries;
        boundaries.y_low = random_.integer(0, 2) == 0
                               ? Boundary{BoundaryKind::free_slip}
                               : Boundary{BoundaryKind::no_slip, {random_.uniform(-2.0f, 2.0f), 0.0f, 0.0f}};
        EXPECT_TRUE(wind_.set_boundaries(boundaries));
    }
    void set_velocity() {
        if (random_.integer(0, 1) == 0)
            wind_.set_velocity([](glm::dvec3 centre) { return glm::vec3(centre.y, 1.0f, 0.1 * centre.x); });
        else
            EXPECT_TRUE(wind_.set_velocity(smooth_noise(wind_.box().cells, 3.0f, random_.bits())));
    }

    Wind& wind_;
    Random random_;
    std::vector<MotorId> motors_;
    std::vector<ObstacleId> obstacles_;
    std::vector<DragId> deposits_;
};

/// A session of calls that were accepted, from the middle of a flight on.
struct Recording {
    Bytes start, end;
    EventLog log;

    explicit Recording(std::uint32_t seed, std::size_t calls = 300) {
        Wind wind = made(windy());
        AnyHost host(wind, seed);
        for (int n = 0; n < 40; ++n)
            host.call();
        (void)wind.advance(0.05);
        start = *wind.save();
        wind.record_to(&log);
        (void)wind.advance(0.05);
        while (log.events().size() < calls)
            host.call();
        wind.record_to(nullptr);
        end = *wind.save();
        (void)wind.step(0.1);
        EXPECT_EQ(log.events().size(), calls) << "records after it was told to stop";
    }
};

std::string reason_of(const EventLog& log, Wind& wind) {
    const auto done = replay(log, wind);
    EXPECT_FALSE(done);
    return done ? std::string() : done.error();
}

TEST(Replay, OfARandomSessionEndsInTheSameBits) {
    std::array<int, std::variant_size_v<Event>> seen{};
    for (const std::uint32_t seed : {1u, 2u, 3u, 4u}) {
        const Recording recording(seed);
        for (const Event& event : recording.log.events())
            ++seen[event.index()];
        const auto log = EventLog::from_bytes(*recording.log.to_bytes());
        ASSERT_TRUE(log) << log.error();
        EXPECT_EQ(*log->to_bytes(), *recording.log.to_bytes());
        for (const int threads : {1, 4}) {
            ThreadPool pool(threads);
            Wind again = loaded(recording.start, pool.parallel_for());
            const auto done = replay(*log, again);
            ASSERT_TRUE(done) << done.error();
            ASSERT_EQ(*again.save(), recording.end) << "session " << seed << ", " << threads << " threads";
        }
    }
    for (std::size_t kind = 0; kind < seen.size() - 1; ++kind) // the last is of a device (TickRecorded)
        EXPECT_GT(seen[kind], 0) << "event of index " << kind;
}

TEST(Replay, RecordsTheSameLogAgain) {
    const Recording recording(5, 100);
    Wind again = loaded(recording.start);
    EventLog copy;
    again.record_to(&copy);
    ASSERT_TRUE(replay(recording.log, again));
    EXPECT_EQ(*copy.to_bytes(), *recording.log.to_bytes());
    // Into the very log that it reads: once through, and the log holds everything twice.
    EventLog log = recording.log;
    Wind once_more = loaded(recording.start);
    once_more.record_to(&log);
    ASSERT_TRUE(replay(log, once_more));
    EXPECT_EQ(log.events().size(), 200u);
    EXPECT_EQ(*once_more.save(), recording.end);
}

TEST(Replay, NamesTheEventThatIsRejected) {
    EventLog log;
    log.note(Stepped{0.1});
    log.note(MotorMoved{{3, 2}, glm::dvec3(0.0)});
    Wind wind = made(windy());
    EXPECT_EQ(reason_of(log, wind),
              "event 1 (move): motor 3 of generation 2 does not exist (removed, ended, or never added): use the handle that "
              "add() returned.");
    log.clear();
    log.note(MotorAdded{{0, 2}, OmniMotor{}});
    EXPECT_EQ(reason_of(log, wind),
              "event 0 (add): the motor got slot 0 of generation 1, not in slot 0 of generation 2, so the wind was not in "
              "the state in which the log began: load the snapshot taken there.");
}

TEST(Replay, RejectsWhatTheCallsReject) {
    const double broken = std::numeric_limits<double>::quiet_NaN();
    const std::pair<Event, std::string> rejected[] = {
        {MotorAdded{{0, 1}, OmniMotor{.radius = -1.0f}}, "(add): motor.radius is -1"},
        {MotorSet{{7, 1}, OmniMotor{}}, "(set): motor 7"},
        {MotorRemoved{{7, 1}}, "(remove): motor 7"},
        {ObstacleAdded{{0, 1}, {.shape = Sphere{-1.0f}}}, "(add_obstacle): obstacle.shape.sphere.radius is -1"},
        {ObstacleAdded{{0, 1}, {.shape = MeshShape{}}}, "(add_obstacle): obstacle.shape.mesh has no mesh: give one that"},
        {ObstacleSet{{7, 1}, {}}, "(set_obstacle): obstacle 7"},
        {ObstacleMoved{{7, 1}, {}, {}}, "(move_obstacle): obstacle 7"},
        {ObstacleRemoved{{7, 1}}, "(remove_obstacle): obstacle 7"},
        {Followed{glm::dvec3(broken)}, "(follow): follow point is"},
        {FloorSet{broken}, "(set_floor): floor height"},
        {AmbientSet{glm::vec3(1e9f)}, "(set_ambient): ambient is"},
        {GustsSet{2.0f, 8.0f, 1, false}, "(set_gusts): gusts.intensity is 2"},
        {BoundariesSet{{.x_low = {BoundaryKind::periodic}}}, "(set_boundaries): boundaries.x_high is not periodic"},
        {VelocitySet{Field(3)}, "(set_velocity): set_velocity got 3 cells"},
        {Stepped{-1.0}, "(step): dt is -1 s"},
        {Stepped{broken}, "(step): dt is nan s"},
        {Advanced{-1.0}, "(advance): dt is -1 s"},
    };
    for (const auto& [event, reason] : rejected) {
        Wind wind = made(windy());
        EventLog log;
        log.note(WindReset{});
        log.note(event);
        const std::string found = reason_of(log, wind);
        EXPECT_EQ(found.substr(0, 8 + reason.size()), "event 1 " + reason);
    }
}

TEST(EventLogBytes, AreRejectedUnlessWholeAndUnchanged) {
    const EventLog log = Recording(6, 60).log;
    const Bytes bytes = *log.to_bytes();
    ASSERT_TRUE(EventLog::from_bytes(bytes));
    EXPECT_EQ(EventLog::from_bytes({}).error(),
              "these bytes are not a Windrow event log: give what EventLog::to_bytes returned.");
    EXPECT_FALSE(EventLog::from_bytes(*made({}).save()));
    Random random(41);
    const auto somewhere = [&] { return static_cast<std::size_t>(random.integer(0, static_cast<int>(bytes.size()) - 1)); };
    for (int n = 0; n < 2000; ++n) {
        ASSERT_FALSE(EventLog::from_bytes(std::span(bytes).first(somewhere())));
        Bytes changed = bytes;
        changed[somewhere()] ^= static_cast<std::byte>(random.integer(1, 255));
        ASSERT_FALSE(EventLog::from_bytes(changed));
    }
}

// That of a log of today.
std::uint32_t layout() {
    return detail::load_number<std::uint32_t>(EventLog{}.to_bytes()->data() + detail::k_letters);
}

// With a checksum that is right; without set_velocity, so that the changes meet all the rest, and without set_gusts, which is
// slow.
TEST(EventLogBytes, ForgedOnesDoNoHarm) {
    const auto tile = GustTile::standard(); // held: else each replay of a motor with eddies makes its own
    EventLog log;
    const Recording recording(7, 120);
    for (const Event& event : recording.log.events())
        if (!std::holds_alternative<VelocitySet>(event) && !std::holds_alternative<GustsSet>(event))
            log.note(event);
    const Bytes bytes = *log.to_bytes();
    Random random(42);
    int readable = 0;
    const int forgeries = sampled(200, k_sanitized ? 10 : 30);
    for (int n = 0; n < forgeries; ++n) {
        Bytes forged(bytes.begin(), bytes.end() - static_cast<std::ptrdiff_t>(detail::k_checksum_bytes));
        forged[static_cast<std::size_t>(random.integer(detail::k_header_bytes, static_cast<int>(forged.size()) - 1))] =
            static_cast<std::byte>(random.bits());
        detail::seal(forged, {"WINDLOGS", layout(), "", ""});
        const auto read = EventLog::from_bytes(forged);
        if (!read)
            continue;
        ++readable;
        Wind wind = loaded(recording.start);
        (void)replay(*read, wind);
    }
    figure("event_log_forged_and_readable", readable);
    EXPECT_GT(readable, forgeries / 2);
}

TEST(EventLogBytes, BelieveNoPromiseOfEvents) {
    Bytes bytes = detail::begin_bytes(64);
    bytes.resize(bytes.size() + 8, std::byte{0xff}); // 2^64 - 1 events
    detail::seal(bytes, {"WINDLOGS", layout(), "", ""});
    EXPECT_EQ(EventLog::from_bytes(bytes).error(),
              "event log cannot be used: its length is 18446744073709551615 items of 1 bytes or more, but only 0 bytes follow.");
}

TEST(EventLogBytes, AreFew) {
    EventLog log;
    log.note(MotorMoved{{1, 1}, glm::dvec3(1.0)});
    const std::size_t one = log.to_bytes()->size();
    log.note(MotorMoved{{1, 1}, glm::dvec3(2.0)});
    WINDROW_EXPECT_FIGURE("event_log_bytes_per_move", static_cast<double>(log.to_bytes()->size() - one), 33.0);
    log.note(Advanced{0.02});
    WINDROW_EXPECT_FIGURE("event_log_bytes_of_frame_and_move", static_cast<double>(log.to_bytes()->size() - one), 42.0);
}

} // namespace
