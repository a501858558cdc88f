// Bodies on curved paths: several moves between two steps, what is kept of more than a tick can take, and the times of a track.

#include "fluid/track.h"
#include "tests/winds.h"

#include <numbers>

namespace {

using namespace windrow;
using namespace windrow::test;

constexpr glm::dvec3 k_middle(0.1, 0.2, -0.3); // of circles: nothing special about the cells there

using Path = std::function<glm::dvec3(double)>; ///< t from 0 to 1

Path circle(double radius) {
    return [radius](double t) {
        return radius * glm::dvec3(std::cos(2.0 * std::numbers::pi * t), 0.0, std::sin(2.0 * std::numbers::pi * t)) + k_middle;
    };
}

// The body goes along the whole path in `seconds`, so many steps of so many moves.
Wind passed(WakeMotor body, const Path& path, double seconds, int steps, int moves) {
    Wind wind = sources_only({24, 10, 24});
    body.position = path(0.0);
    const MotorId id = added(wind, body);
    for (int n = 0; n < steps; ++n) {
        for (int m = 1; m <= moves; ++m)
            EXPECT_TRUE(wind.motors().move(id, path((n + static_cast<double>(m) / moves) / steps)));
        wind.step(seconds / steps);
    }
    return wind;
}

// Largest wind_difference of a cell, of the largest speed.
double wind_difference(const Wind& a, const Wind& b) {
    return largest_apart(a.field(), b.field()) / largest_speed(b.field());
}

// --- Curves ----------------------------------------------------------------------------------------------------------

TEST(WakeCurve, EightPiecesAStepMakeTheCircleOfEightyFineSteps) {
    for (const bool drives : {false, true}) {
        const WakeMotor body{.radius = 1.5f, .law = drives ? decltype(WakeMotor::law)(WakeDrive{}) : WakeForce{}};
        const Wind pieces = passed(body, circle(6.0), 1.0, 10, 8), fine = passed(body, circle(6.0), 1.0, 80, 1);
        const Wind straight = passed(body, circle(6.0), 1.0, 10, 1), smooth = passed(body, circle(6.0), 1.0, 960, 1);
        const std::string name = drives ? "curve_drive" : "curve_force";
        // A force adds up whatever the steps; a drive's pieces act in one step at once, toward their mean, not one after the
        // other.
        WINDROW_EXPECT_FIGURE(name + "_8_pieces_against_80_steps", wind_difference(pieces, fine), drives ? 0.05 : 5e-6);
        WINDROW_EXPECT_FIGURE(name + "_80_chords_against_960", wind_difference(fine, smooth), 0.02);
        EXPECT_GT(figure(name + "_one_chord_a_step", wind_difference(straight, fine)), 0.1) << "or the pieces do nothing";
    }
}

// Tangential impulse of the sectors of 15 degrees (1.6 m) around the circle's middle.
std::vector<double> sectors_of(const Wind& wind) {
    std::vector<double> sectors(24);
    for_each_cell(wind, [&](glm::dvec3 centre, std::size_t n) {
        const glm::dvec3 p = centre - k_middle, u(wind.field()[n]);
        const double across = std::hypot(p.x, p.z), turn = std::atan2(p.z, p.x) / (2.0 * std::numbers::pi);
        const auto sector = static_cast<std::size_t>(24.0 * (turn < 0.0 ? turn + 1.0 : turn)) % 24;
        sectors[sector] += (p.x * u.z - p.z * u.x) / across;
    });
    return sectors;
}

TEST(WakeCurve, NoGapsOnATightFastCircle) {
    // 22 steps at 30 Hz around 6 m: 51 m/s, 1.7 m a step in 8 pieces. Beside it the same circle in 960 steps: what has no gap.
    for (const float radius : {0.3f, 1.5f, 2.5f}) {
        const WakeMotor body{.radius = radius, .law = WakeForce{}};
        const Wind fast = passed(body, circle(6.0), 22.0 / 30.0, 22, 8), slow = passed(body, circle(6.0), 32.0, 960, 1);
        double min_sector = 1e30, least = 1e30;
        const std::vector<double> sectors = sectors_of(fast), full = sectors_of(slow);
        for (std::size_t n = 0; n < sectors.size(); ++n)
            min_sector = std::min(min_sector, sectors[n] / full[n]);
        for (int n = 0; n < 720; ++n) { // on the way itself
            const glm::dvec3 place = circle(6.0)(n / 720.0);
            least = std::min(least, double(glm::length(fast.velocity(place)) / glm::length(slow.velocity(place))));
        }
        const std::string name = "circle_50_mps_radius_" + std::to_string(radius).substr(0, 3);
        EXPECT_GE(figure(name + "_least_sector", min_sector, 0.995), 0.995);
        EXPECT_GE(figure(name + "_least_on_the_way", least, 0.995), 0.995);
    }
}

TEST(WakeCurve, ABodyThatStandsAddsExactlyNothingHoweverOftenItIsTold) {
    const glm::vec3 ambient(1.0f, 2.0f, 3.0f);
    for (const bool frames : {false, true}) {
        Wind wind = sources_only({8, 8, 8}, 1.0f, ambient);
        const MotorId id = added(wind, WakeMotor{.position = {0.1, 0.2, 0.3}, .radius = 3.0f, .law = WakeForce{1e4f}});
        for (int n = 0; n < 30; ++n) {
            for (int m = 0; m < 20; ++m)
                ASSERT_TRUE(wind.motors().move(id, {0.1, 0.2, 0.3}));
            if (frames)
                EXPECT_EQ(wind.advance(1.0 / 144.0).last.motors_in_reach, 0);
            else
                EXPECT_EQ(wind.step(1.0 / 60.0).motors_in_reach, 0);
        }
        EXPECT_EQ(largest_off(wind.field(), ambient), 0.0);
    }
}

// --- More moves than a tick takes --------------------------------------------------------------------------------------

std::vector<Track::Segment> pieces_of(Track& track, const std::vector<glm::dvec3>& moves, double duration) {
    for (const glm::dvec3& place : moves)
        track.move_to(place);
    track.begin_frame(0.0, duration);
    const auto pieces = track.tick(duration);
    return {pieces.begin(), pieces.end()};
}

TEST(WakeCurve, ThinningKeepsTheCorner) {
    Random random(70);
    double worst = 0.0;
    int kept = 0, trials = 0;
    for (const int moves : {9, 12, 20, 40, 100})
        for (const double degrees : {30.0, 60.0, 90.0, 135.0, 180.0})
            for (int trial = 0; trial < 20; ++trial) {
                const int corner = random.integer(2, moves - 2);
                const glm::dvec3 first = random.direction(), second = glm::normalize(glm::cross(first, random.direction()));
                const double angle = degrees * std::numbers::pi / 180.0;
                const glm::dvec3 turned = std::cos(angle) * first + std::sin(angle) * second;
                std::vector<glm::dvec3> path;
                for (int n = 1; n <= moves; ++n)
                    path.push_back(n <= corner ? 0.2 * n * first : 0.2 * corner * first + 0.2 * (n - corner) * turned);
                Track track{glm::dvec3(0.0)};
                const auto pieces = pieces_of(track, path, 1.0 / 30.0);
                ASSERT_LE(pieces.size(), 8u);
                EXPECT_EQ(pieces.front().start, glm::dvec3(0.0));
                EXPECT_EQ(pieces.back().end, path.back()) << "the newest position is the target";
                double nearest = std::numeric_limits<double>::infinity(), length = 0.0;
                for (const Track::Segment& piece : pieces) {
                    nearest = std::min(nearest, glm::length(piece.end - path[static_cast<std::size_t>(corner) - 1]));
                    length += glm::length(piece.end - piece.start);
                }
                kept += nearest == 0.0;
                ++trials;
                worst = std::max(worst, std::abs(length / (0.2 * moves) - 1.0));
            }
    WINDROW_EXPECT_FIGURE("thinned_corners_lost", static_cast<double>(trials - kept) / trials, 0.0);
    WINDROW_EXPECT_FIGURE("thinned_length_lost", worst, 1e-12);
}

TEST(WakeCurve, ThinningKeepsTheVelocityOfAnEvenMotion) {
    double worst = 0.0;
    for (const int moves : {2, 8, 9, 12, 20, 40, 100}) {
        Track track{glm::dvec3(0.0)};
        std::vector<glm::dvec3> path;
        for (int n = 1; n <= moves; ++n)
            path.push_back({3.0 * n / moves, 0.0, 0.0});
        double fastest = 0.0, slowest = std::numeric_limits<double>::infinity(), seconds = 0.0;
        for (const Track::Segment& piece : pieces_of(track, path, 0.1)) {
            const double speed = glm::length(piece.end - piece.start) / piece.duration;
            fastest = std::max(fastest, speed);
            slowest = std::min(slowest, speed);
            seconds += piece.duration;
        }
        EXPECT_NEAR(seconds, 0.1, 1e-12);
        figure("even_motion_fastest_of_" + std::to_string(moves) + "_moves", fastest / 30.0);
        figure("even_motion_slowest_of_" + std::to_string(moves) + "_moves", slowest / 30.0);
        worst = std::max({worst, fastest / 30.0 - 1.0, 1.0 - slowest / 30.0});
    }
    WINDROW_EXPECT_FIGURE("even_motion_velocity_error", worst, 1e-9);
}

TEST(WakeCurve, AFastHostGetsTheWakeOfASlowOne) {
    // An even straight run, told once or forty times a step: a drive's target is the body's velocity, however often it is told.
    const Path straight = [](double t) { return glm::dvec3(-8.0 + 16.0 * t, 0.2, 0.1); };
    for (const bool drives : {false, true}) {
        const WakeMotor body{.radius = 1.5f, .law = drives ? decltype(WakeMotor::law)(WakeDrive{}) : WakeForce{}};
        const Wind once = passed(body, straight, 1.0, 10, 1), often = passed(body, straight, 1.0, 10, 40);
        WINDROW_EXPECT_FIGURE(drives ? "forty_moves_drive" : "forty_moves_force", wind_difference(often, once), 1e-5);
        WINDROW_EXPECT_FIGURE(drives ? "forty_moves_drive_impulse" : "forty_moves_force_impulse",
                              glm::length(sum_of(often.field()) - sum_of(once.field())) / glm::length(sum_of(once.field())),
                              1e-5);
    }
    // A circle of forty moves a step, thinned to eight: as good as eight chords.
    const WakeMotor body{.radius = 1.5f, .law = WakeForce{}};
    const Wind thinned = passed(body, circle(6.0), 1.0, 5, 40), chords = passed(body, circle(6.0), 1.0, 5, 8);
    const Wind smooth = passed(body, circle(6.0), 1.0, 960, 1);
    figure("circle_5_steps_of_8_chords", wind_difference(chords, smooth));
    WINDROW_EXPECT_FIGURE("circle_5_steps_of_40_moves", wind_difference(thinned, smooth), 0.05);
}

// --- The track itself --------------------------------------------------------------------------------------------------

struct TrackInFrames {
    Track track;
    double lead = 0.0, tick = 1.0 / 30.0;
    std::vector<Track::Segment> pieces{};
    double max_speed = 0.0;

    // A frame as Wind::advance makes it.
    void frame(double dt) {
        track.begin_frame(lead, dt);
        for (lead += dt; lead >= tick * (1.0 - 1e-9); lead -= tick)
            for (const Track::Segment& piece : track.tick(tick))
                pieces.push_back(piece);
    }
    [[nodiscard]] glm::dvec3 way() const {
        glm::dvec3 sum(0.0);
        for (const Track::Segment& piece : pieces)
            sum += piece.end - piece.start;
        return sum;
    }
    [[nodiscard]] double moving() const {
        double sum = 0.0;
        for (const Track::Segment& piece : pieces)
            sum += piece.duration;
        return sum;
    }
};

// Errors of an even motion, seen in frames of any length: way, time, and the velocity of each piece.
void expect_even(const std::string& name, const std::function<double(int)>& frame_of) {
    const glm::dvec3 start(1e3, 2.0, -3.0), velocity(3.0, -4.0, 12.0);
    TrackInFrames frames{.track = Track(start)};
    double now = 0.0, worst = 0.0;
    for (int n = 0; now < 4.0; ++n) {
        const double dt = frame_of(n);
        now += dt;
        frames.track.move_to(start + velocity * now);
        frames.frame(dt);
    }
    glm::dvec3 place = start;
    for (const Track::Segment& piece : frames.pieces) {
        EXPECT_EQ(piece.start, place) << "no gap between pieces";
        EXPECT_GT(piece.duration, 0.0);
        place = piece.end;
        if (piece.duration > 1e-6)
            worst = std::max(worst, glm::length((piece.end - piece.start) / piece.duration - velocity));
    }
    const double ticked = now - frames.lead;
    WINDROW_EXPECT_FIGURE(name + "_way", glm::length(frames.way() - velocity * ticked), 1e-12);
    WINDROW_EXPECT_FIGURE(name + "_time", std::abs(frames.moving() - ticked), 1e-12);
    WINDROW_EXPECT_FIGURE(name + "_velocity", worst, 1e-6); // pieces of a microsecond at 1000 m
}

TEST(Track, EvenMotionMakesTheSamePathAtAnyFrameRate) {
    Random random(71);
    expect_even("track_30_hz", [](int) { return 1.0 / 30.0; });
    expect_even("track_60_hz", [](int) { return 1.0 / 60.0; });
    expect_even("track_144_hz", [](int) { return 1.0 / 144.0; });
    expect_even("track_240_hz", [](int) { return 1.0 / 240.0; });
    expect_even("track_24_hz", [](int) { return 1.0 / 24.0; });
    expect_even("track_irregular", [&](int) { return random.spread(0.005, 0.08); });
}

TEST(Track, RestThenMoveStartsWhereTheFrameBegins) {
    for (const double hz : {30.0, 60.0, 144.0}) {
        TrackInFrames frames{.track = Track(glm::dvec3(5.0, 0.0, 0.0))};
        int rested = 0;
        for (double now = 0.0; now < 0.51; now += 1.0 / hz, ++rested)
            frames.frame(1.0 / hz); // nothing is told
        EXPECT_TRUE(frames.pieces.empty());
        frames.track.move_to({6.0, 0.0, 0.0});
        frames.frame(1.0 / hz);
        for (int n = 0; n < 20; ++n)
            frames.frame(1.0 / hz);
        EXPECT_NEAR(frames.way().x, 1.0, 1e-12);
        EXPECT_NEAR(frames.moving(), 1.0 / hz, 1e-9) << "it moved for that one frame";
        for (const Track::Segment& piece : frames.pieces)
            EXPECT_NEAR(glm::length(piece.end - piece.start) / piece.duration, hz, 1e-5 * hz);
        EXPECT_EQ(frames.track.here(), glm::dvec3(6.0, 0.0, 0.0));
    }
}

TEST(Track, ManyMovesInFramesThatSpanATickLoseNothing) {
    Random random(72);
    for (int trial = 0; trial < 200; ++trial) {
        TrackInFrames frames{.track = Track(glm::dvec3(0.0))};
        glm::dvec3 place(0.0);
        double now = 0.0;
        while (now < 1.0) {
            const double dt = random.spread(1e-3, 0.1);
            const int moves = random.integer(0, 12);
            for (int m = 0; m < moves; ++m)
                frames.track.move_to(place += random.point(0.3));
            frames.frame(dt);
            now += dt;
        }
        frames.frame(0.1); // rests until all is ticked
        frames.frame(0.1);
        EXPECT_EQ(frames.track.here(), place);
        EXPECT_EQ(frames.track.target(), place);
        glm::dvec3 at(0.0);
        for (const Track::Segment& piece : frames.pieces) {
            ASSERT_LE(glm::length(piece.start - at), 0.0) << "pieces join";
            at = piece.end;
        }
        EXPECT_EQ(at, place);
        EXPECT_LE(frames.moving(), now + 1e-9);
    }
}

} // namespace
