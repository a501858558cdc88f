// A film of a scene: frames at their times, and what its VDB files hold.
#include "cli/info_command.h"
#include "cli/playback.h"
#include "scene/scene_reader.h"
#include "tests/figure.h"
#include "tests/unit/command_outcome.h"

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

namespace windrow::cli {
namespace {

namespace fs = std::filesystem;

// A fan that sways beside a house in gusts: air that changes within a tick.
constexpr const char* k_sway = R"({"duration": 2, "tick_hz": 60, "frames_per_second": 24,
    "air": {"cells": [24, 12, 16], "ambient": [4, 0, 0], "boundaries": {"y_low": "free_slip"},
            "gusts": {"intensity": 0.3, "length": 12}},
    "floor": 0,
    "paths": {"way": {"points": [[0, -6, 2, -3], [0.5, -6, 2, 3], [1, -6, 2, -3], [1.5, -6, 2, 3], [2, -6, 2, -3]]}},
    "motors": [{"kind": "directional", "path": "way", "law": {"drive": {"speed": 12, "rate": 8}}}]})";

using Frame = std::vector<glm::vec4>;

Frame cells_of(const Playback& playback) {
    const auto cells = playback.wind().field();
    return {cells.begin(), cells.end()};
}

double distance(const Frame& a, const Frame& b) {
    double sum = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n)
        sum += static_cast<double>(glm::dot(a[n] - b[n], a[n] - b[n]));
    return std::sqrt(sum / static_cast<double>(a.size()));
}

// The 48 frames of two seconds at `fps`, in steps of `tick_hz` at least; every `stride`-th.
std::vector<Frame> film(double fps, double tick_hz, int stride) {
    auto scene = *scene::read_scene_text(k_sway, "sway.json");
    const scene::FrameTimes times(0.0, fps, tick_hz);
    auto playback = Playback::create(scene, {});
    std::vector<Frame> frames;
    for (int n = 0; n < 48; ++n) {
        while (playback->steps() < times.step_of_frame(n * stride))
            EXPECT_TRUE(playback->step(times));
        frames.push_back(cells_of(*playback));
    }
    return frames;
}

double worst(const std::vector<Frame>& frames, const std::vector<Frame>& truth) {
    double most = 0.0;
    for (std::size_t n = 0; n < frames.size(); ++n)
        most = std::max(most, distance(frames[n], truth[n]));
    return most;
}

// Against steps of 1/480 s. Frames of the nearest tick are 8 ms off every second time; a blend of two ticks has no lag and still
// flattens what turns within a tick.
TEST(Film, FramesAreTheAirOfTheirOwnTime) {
    const std::vector<Frame> truth = film(24.0, 480.0, 1);
    const double equal_steps = test::figure("film/24_fps/equal_steps", worst(film(24.0, 60.0, 1), truth));
    const double at_48 = test::figure("film/48_fps/equal_steps", worst(film(48.0, 60.0, 2), truth));

    const auto scene = *scene::read_scene_text(k_sway, "sway.json");
    auto playback = Playback::create(scene, {});
    std::vector<Frame> nearest, blended;
    Frame before = cells_of(*playback), now = before;
    for (int n = 0; n < 48; ++n) {
        const double due = n * 60.0 / 24.0;
        while (static_cast<double>(playback->steps()) < due) {
            before = now;
            ASSERT_TRUE(playback->tick());
            now = cells_of(*playback);
        }
        const auto part = static_cast<float>(due - (static_cast<double>(playback->steps()) - 1.0));
        Frame blend = now;
        for (std::size_t i = 0; n > 0 && i < blend.size(); ++i)
            blend[i] = before[i] + part * (now[i] - before[i]);
        blended.push_back(blend);
        nearest.push_back(now); // 2.5 ticks are rounded up
    }
    const double of_nearest = test::figure("film/24_fps/nearest_tick", worst(nearest, truth));
    const double of_blend = test::figure("film/24_fps/blend_of_ticks", worst(blended, truth));
    EXPECT_LT(equal_steps, of_blend);
    EXPECT_LT(equal_steps, 0.5 * of_nearest);
    EXPECT_LE(worst(film(48.0, 60.0, 2), film(24.0, 60.0, 1)), equal_steps + at_48) << "both are near the same air";
    EXPECT_LT(at_48, equal_steps) << "shorter steps, of order 2";
}

class FilmCommand : public test::FolderTest {
  protected:
    std::string scene = [this] {
        std::ofstream(folder / "sway.json") << k_sway;
        return (folder / "sway.json").string();
    }();
    CommandOutcome run(std::vector<const char*> arguments) {
        arguments.insert(arguments.begin(), {"run", scene.c_str()});
        return run_windrow(std::move(arguments));
    }
};

// OpenVDB stores a grid's metadata as they are: the key and its type with their lengths, the value's length, the value.
double time_in(const fs::path& file) {
    const std::string bytes = test::text_of(file);
    const std::size_t place = bytes.find("windrow_time");
    double time = NAN;
    constexpr std::size_t k_to_value = 12 + 4 + 6 + 4; // the key, "double" and both lengths
    if (place != bytes.npos && place + k_to_value + sizeof time <= bytes.size())
        std::memcpy(&time, bytes.data() + place + k_to_value, sizeof time);
    return time;
}

TEST_F(FilmCommand, FilesHaveExactTimes) {
    if (!built_with_vdb())
        GTEST_SKIP() << "needs --vdb";
    const std::string out = in("film"), part = in("part"), ntsc = in("ntsc");
    CommandOutcome outcome = run({"--vdb", "--fps", "24", "--frames", "48", "--out", out.c_str()});
    ASSERT_EQ(outcome.code, k_exit_well) << outcome.err;
    expect_words(outcome.out, {"48 frames, 141 steps of 1/72 s"});
    char name[32];
    for (int n = 0; n < 48; ++n) {
        std::snprintf(name, sizeof name, "vel_%04d.vdb", n);
        EXPECT_EQ(time_in(fs::path(out) / name), n / 24.0) << name;
    }
    EXPECT_FALSE(fs::exists(fs::path(out) / "vel_0048.vdb"));

    // A part of it, numbered as a film's shots are: the same air.
    outcome = run({"--vdb", "--fps", "24", "--from", "1", "--to", "1.25", "--first-frame", "1001", "--out", part.c_str()});
    ASSERT_EQ(outcome.code, k_exit_well) << outcome.err;
    const std::string shot = test::text_of(fs::path(part) / "vel_1007.vdb"),
                      whole = test::text_of(fs::path(out) / "vel_0030.vdb");
    EXPECT_FALSE(fs::exists(fs::path(part) / "vel_1000.vdb"));
    EXPECT_FALSE(fs::exists(fs::path(part) / "vel_1008.vdb"));
    EXPECT_EQ(time_in(fs::path(part) / "vel_1007.vdb"), 1.25);
    ASSERT_EQ(shot.size(), whole.size());
    int differing = 0;
    for (std::size_t n = 57; n < shot.size(); ++n)
        differing += shot[n] != whole[n];
    EXPECT_LE(differing, 4) << "the unique name before byte 57, and the number of the frame";

    ASSERT_EQ(run({"--vdb", "--fps", "24000/1001", "--frames", "3", "--out", ntsc.c_str()}).code, k_exit_well);
    EXPECT_NEAR(time_in(fs::path(ntsc) / "vel_0002.vdb"), 2002.0 / 24000.0, 1e-16);
}

TEST_F(FilmCommand, GridsRegionAndFormat) {
    if (!built_with_vdb())
        GTEST_SKIP() << "needs --vdb";
    std::ofstream(folder / "sway.json") << std::string(k_sway).replace(0, 1, R"({"smoke": [{"path": "way", "radius": 1.5}],)");
    const std::string plain = in("plain"), film = in("film"), nano = in("nano");
    ASSERT_EQ(run({"--vdb", "--frames", "2", "--out", plain.c_str()}).code, k_exit_well);
    CommandOutcome outcome = run({"--vdb", "--frames", "2", "--margin", "4", "--grids",
                                  "speed,vorticity,divergence,pressure,density", "--out", film.c_str()});
    ASSERT_EQ(outcome.code, k_exit_well) << outcome.err;
    const std::string bytes = test::text_of(fs::path(film) / "vel_0001.vdb");
    expect_words(bytes, {"speed m/s", "vorticity 1/s", "divergence 1/s", "pressure m^2/s^2", "density 1", "velocity m/s"});
    EXPECT_EQ(test::text_of(fs::path(plain) / "vel_0001.vdb").find("speed m/s"), std::string::npos);
    EXPECT_GT(bytes.size(), 2 * fs::file_size(fs::path(plain) / "vel_0001.vdb"));
    if (built_with_nanovdb()) {
        outcome = run({"--vdb", "--frames", "2", "--nanovdb", "--out", nano.c_str()});
        ASSERT_EQ(outcome.code, k_exit_well) << outcome.err;
        EXPECT_TRUE(fs::exists(fs::path(nano) / "vel_0001.nvdb"));
        EXPECT_FALSE(fs::exists(fs::path(nano) / "vel_0001.vdb"));
    }
}

TEST_F(FilmCommand, WrongUseIsASentence) {
    const auto rejected = [&](std::vector<const char*> arguments, const std::string& sentence) {
        expect_rejected(run(std::move(arguments)), sentence);
    };
    for (const char* const rate : {"0", "-24", "24/0", "x", "1e9", "24/", "/1001", "nan"})
        rejected({"--fps", rate},
                 std::string("--fps is ") + rate + ": give frames a second from 0.001 to 10000, such as 24 or 24000/1001.");
    rejected({"--from", "-1"}, "--from is -1: give a time from 0 to 1e6 s.");
    rejected({"--from", "3"}, "--from is 3 s, after the scene's end at 2 s: give an earlier time, --to or --frames.");
    rejected({"--from", "1", "--to", "0.5"}, "--to is 0.5 s, before --from, 1 s: give a later time.");
    rejected({"--frames", "3", "--to", "1"}, "--frames and --to both say where the film ends: give one of them.");
    rejected({"--first-frame", "-1"}, "--first-frame is -1: give a whole number from 0 to 1000000000.");
    rejected({"--fps", "10000", "--to", "1000"},
             "--fps makes 10000001 frames: give at most 100000 frames, by a lower rate, or by --from and --to.");
    rejected(
        {"--fps", "0.001", "--frames", "1000"},
        "the last frame is at 999000 s, 59940000 steps of the scene: give at most 10000000 steps, by fewer frames or a lower "
        "tick_hz.");
    rejected({"--grids", "speed,spin"},
             "--grids has spin: give some of speed, vorticity, divergence, pressure, density, with commas.");
    rejected({"--vdb", "--grids", "density"}, "--grids asks for density, and " + scene + " has no $.smoke: add a source of it.");
    rejected({"--grids", "speed"}, "--grids is given, and no VDB files are kept: add --vdb.");
    rejected({"--voxel", "2"}, "--voxel is given, and no VDB files are kept: add --vdb.");
    if (built_with_vdb()) {
        const CommandOutcome large = run({"--vdb", "--margin", "100000", "--out", in("large").c_str()});
        EXPECT_EQ(large.code, k_exit_machine);
        expect_words(large.err, {"$.vdb asks for voxels that take about"});
        EXPECT_FALSE(fs::exists(in("large")));
    }
    rejected({"--margin", "-1"}, "--margin is -1: give a number from 0 to 100000 m.");
    rejected({"--voxel", "0"}, "--voxel is 0: give a number above 0 to 1e6 m.");
}

} // namespace
} // namespace windrow::cli
