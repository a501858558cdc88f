// The command as a user meets it: exit codes, sentences, files.
#include "cli/console.h"
#include "cli/frame_writer.h"
#include "cli/info_command.h"
#include "cli/output_file.h"
#include "cli/progress.h"
#include "cli/run_command.h"
#include "cli/table.h"
#include "cli/timings.h"
#include "tests/unit/command_outcome.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <sstream>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace windrow::cli {
namespace {

namespace fs = std::filesystem;

CommandOutcome run(std::vector<const char*> arguments) {
    return run_windrow(std::move(arguments));
}

void expect_rejection(std::vector<const char*> arguments, const std::string& sentence) {
    expect_rejected(run(std::move(arguments)), sentence);
}

class Command : public test::FolderTest {
  protected:
    std::string write(const std::string& name, const std::string& text) {
        std::ofstream(folder / name) << text;
        return (folder / name).string();
    }
    /// Names in a folder, sorted, with a space behind each.
    [[nodiscard]] static std::string list(const fs::path& of) {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(of))
            names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        std::string text;
        for (const std::string& name : names)
            text += name + " ";
        return text;
    }

    std::string scene =
        write("breeze.json", R"({"duration": 0.5, "frames_per_second": 10, "air": {"cells": [8, 8, 8], "ambient": [2, 0, 0]},
            "motors": [{"kind": "directional", "law": {"drive": {"speed": 5}}}]})");
};

// --- Flags -----------------------------------------------------------------------------------------------------------

TEST_F(Command, HelpVersionAndInfoAreAnswered) {
    EXPECT_EQ(run({"--version"}).code, k_exit_well);
    EXPECT_TRUE(run({"--version"}).out.starts_with("windrow 0."));
    EXPECT_NE(run({"--help"}).out.find("Exit codes"), std::string::npos);
    EXPECT_NE(run({"run", "--help"}).out.find("--threads"), std::string::npos);
    const CommandOutcome info = run({"info"});
    EXPECT_EQ(info.code, k_exit_well);
    expect_words(info.out, {"windrow 0.", "compiler", "SIMD level", "cores", "OpenVDB", "pictures", "Vulkan"});
    const CommandOutcome licences = run({"info", "--licences"});
    EXPECT_EQ(licences.code, k_exit_well);
    expect_words(licences.out, {"Apache License", "Name:    GLM", "MIT License", "Niels Lohmann", "FFTW"});
}

TEST_F(Command, WrongFlagsAreNamed) {
    expect_rejection(
        {}, "name a command, run, view, bench, verify, pareto, plants, check, device-report or info: see windrow --help.");
    expect_rejection({"runn", "x"}, "unknown command runn (did you mean run?): see windrow --help.");
    expect_rejection(
        {"draw", "x.json", "--out", "y"},
        "draw is not a command of windrow: windrow-draw draws pictures and films of scenes; see windrow-draw --help.");
    expect_rejection({"--verion"}, "unknown option --verion (did you mean --version?): see windrow --help.");
    expect_rejection({"run"}, "SCENE.json is required: see windrow run --help.");
    expect_rejection({"run", "x.json", "--frame", "3"},
                     "unknown option --frame (did you mean --frames?): see windrow run --help.");
    expect_rejection({"run", "x.json", "y.json"}, "unexpected argument y.json: see windrow run --help.");
    expect_rejection({"run", "x.json", "--frames"}, "--frames: 1 required N missing: see windrow run --help.");
    expect_rejection({"run", "x.json", "--out", "--vdb"},
                     "--out has no value: --vdb is a flag; write ./--vdb for a file of that name.");
    expect_rejection({"run", "x.json", "--frames", "0"}, "--frames is 0: give a whole number from 1 to 100000.");
    expect_rejection({"run", "x.json", "--frames", "1000000000"},
                     "--frames is 1000000000: give a whole number from 1 to 100000.");
    expect_rejection({"run", "x.json", "--frames", "ten"}, "--frames is ten: give a whole number from 1 to 100000.");
    expect_rejection({"run", "x.json", "--frames=-5"}, "--frames is -5: give a whole number from 1 to 100000.");
    expect_rejection({"run", "x.json", "--threads", "0"}, "--threads is 0: give a whole number from 1 to 256.");
    expect_rejection({"run", "x.json", "--out", ""}, "--out is empty: name a folder.");
    expect_rejection({"run", ""}, "SCENE.json is empty: name a scene file.");
}

TEST_F(Command, BadScenesEndWithTheirSentence) {
    const std::string none = in("none.json");
    expect_rejection({"run", none.c_str()}, none + ": no such file: check the name and the current folder.");
    const std::string bad = write("bad.json", R"({"duration": -1, "tick_hz": "x"})");
    expect_rejection({"run", bad.c_str()}, bad + ": $.duration is -1 s: give a number above 0, at most 1e6 s.\nwindrow: " + bad +
                                               ": $.tick_hz is \"x\": give a number.");
    const std::string table = write("lines.csv", "0,0,0,0\n1,0,0\n");
    const std::string walk = write("walk.json", R"({"paths": {"p": {"file": "lines.csv"}}})");
    expect_rejection({"run", walk.c_str()}, table + ":2: has 3 fields: give four, t,x,y,z, with commas between them.");
    const std::string pipe = in("pipe.json"); // a reader that waits for its other end would wait for ever
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    expect_rejection({"run", pipe.c_str()}, pipe + ": is a pipe or a device: name a regular file.");
}

// --- Runs ------------------------------------------------------------------------------------------------------------

TEST_F(Command, RunKeepsWhatWasAskedFor) {
    const std::string out = in("kept");
    const CommandOutcome outcome = run({"run", scene.c_str(), "--out", out.c_str(), "--csv"});
    EXPECT_EQ(outcome.code, k_exit_well) << outcome.err;
    EXPECT_EQ(list(out), "timings.csv ");
    EXPECT_NE(outcome.out.find("In " + out + ": timings.csv."), std::string::npos) << outcome.out;
    expect_words(outcome.out, {"breeze: 6 frames, 30 steps of 1/60 s", "median", "99 %", "advection", "whole step",
                               "8 x 8 x 8 of 1 m (512)", "largest CFL", "limited cells  0, repaired cells 0", "times real time"});

    std::ifstream table(fs::path(out) / "timings.csv");
    std::string line;
    std::getline(table, line);
    EXPECT_EQ(line + "\n", timings_header());
    const auto columns = std::count(line.begin(), line.end(), ',');
    int rows = 0;
    for (; std::getline(table, line); ++rows)
        EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns) << line;
    EXPECT_EQ(rows, 30) << "a row a step";
}

// Names of obstacles are any text, and a flag that takes many values takes one each time.
TEST_F(Command, TablesQuoteNamesAndAProbeTakesNoScene) {
    EXPECT_EQ(csv_field("wall"), "wall");
    EXPECT_EQ(csv_field("a, \"b\""), "\"a, \"\"b\"\"\"");
    const std::string out = in("probed");
    const CommandOutcome outcome = run({"run", "--frames", "1", "--out", out.c_str(), "--probe", "mast=0,1,0", scene.c_str()});
    EXPECT_EQ(outcome.code, k_exit_well) << outcome.err;
    EXPECT_TRUE(fs::exists(fs::path(out) / "probes.csv"));
}

TEST_F(Command, RunWithoutOutputsMakesNoFolder) {
    const std::string out = in("nothing");
    const CommandOutcome outcome = run({"run", scene.c_str(), "--out", out.c_str()});
    EXPECT_EQ(outcome.code, k_exit_well);
    EXPECT_FALSE(fs::exists(out));
    EXPECT_NE(outcome.out.find("Nothing was kept: add --images, --vdb, --fields, --csv, --probe or --forces."),
              std::string::npos);
}

TEST_F(Command, FramesMayBeFewerOrMoreThanTheScenes) {
    EXPECT_NE(run({"run", scene.c_str(), "--frames", "2"}).out.find("breeze: 2 frames, 6 steps"), std::string::npos);
    EXPECT_NE(run({"run", scene.c_str(), "--frames", "1"}).out.find("breeze: 1 frame, 0 steps"), std::string::npos);
    EXPECT_NE(run({"run", scene.c_str(), "--frames", "11"}).out.find("breeze: 11 frames, 60 steps"), std::string::npos);
}

TEST_F(Command, FramesAreWrittenWhereBuiltInAndExplainedWhereNot) {
    const std::string out = in("frames");
    const CommandOutcome vdb = run({"run", scene.c_str(), "--out", out.c_str(), "--vdb", "--frames", "2"});
    if (built_with_vdb()) {
        EXPECT_EQ(vdb.code, k_exit_well) << vdb.err;
        EXPECT_EQ(list(out), "vel_0000.vdb vel_0001.vdb ");
    } else {
        EXPECT_EQ(vdb.code, k_exit_wrong_use);
        EXPECT_EQ(vdb.err, "windrow: --vdb: this windrow was built without OpenVDB: install libopenvdb-dev and configure with "
                           "-DWINDROW_VDB=ON.\n");
    }
    fs::remove_all(out);
    const CommandOutcome images = run({"run", scene.c_str(), "--out", out.c_str(), "--images", "--frames", "2"});
    if (built_with_images()) {
        EXPECT_EQ(images.code, k_exit_well) << images.err;
        EXPECT_EQ(list(out), "contact_sheet.png frame_0000.png frame_0001.png ");
    } else {
        EXPECT_EQ(images.code, k_exit_wrong_use);
        EXPECT_EQ(images.err,
                  "windrow: --images: this windrow was built without pictures: install libopenimageio-dev and libcairo2-dev and "
                  "configure with -DWINDROW_IMAGES=ON.\n");
    }
}

TEST_F(Command, FramesOfALongerRunAreMentioned) {
    if (!built_with_vdb())
        GTEST_SKIP() << "needs --vdb";
    const std::string out = in("old");
    ASSERT_EQ(run({"run", scene.c_str(), "--out", out.c_str(), "--vdb"}).code, k_exit_well);
    const CommandOutcome again = run({"run", scene.c_str(), "--out", out.c_str(), "--vdb", "--frames", "4"});
    EXPECT_EQ(again.code, k_exit_well);
    EXPECT_EQ(again.err, "windrow: warning: " + out +
                             " holds 2 frames of another run, which this run does not replace: remove those that you do not "
                             "want.\n");
}

TEST_F(Command, AWholeFilmTakesThePlaceOfALongerOne) {
    if (!built_with_vdb())
        GTEST_SKIP() << "needs --vdb";
    const std::string out = in("old");
    ASSERT_EQ(run({"run", scene.c_str(), "--out", out.c_str(), "--vdb", "--fps", "20"}).code, k_exit_well);
    for (const char* name : {"vel_12.vdb", "vel_0099.nvdb", "vel_00x7.vdb", "frame_0099.png", "notes_0099.vdb"})
        std::ofstream(fs::path(out) / name) << "not ours";
    const CommandOutcome again = run({"run", scene.c_str(), "--out", out.c_str(), "--vdb"});
    EXPECT_EQ(again.code, k_exit_well);
    EXPECT_EQ(again.err, "windrow: warning: removed 5 frames of a longer run, from " + out + "/vel_0006.vdb on.\n");
    EXPECT_EQ(list(out), "frame_0099.png notes_0099.vdb vel_0000.vdb vel_0001.vdb vel_0002.vdb vel_0003.vdb vel_0004.vdb "
                         "vel_0005.vdb vel_0099.nvdb vel_00x7.vdb vel_12.vdb ");
}

TEST_F(Command, LimitedCellsAreSaid) {
    const std::string fast = write("fast.json", R"({"duration": 0.1, "tick_hz": 10, "frames_per_second": 10,
        "air": {"cells": [8, 8, 8], "cell_size": 0.1, "ambient": [100, 0, 0], "max_substeps": 2}})");
    const CommandOutcome outcome = run({"run", fast.c_str()});
    EXPECT_EQ(outcome.code, k_exit_well);
    EXPECT_EQ(
        outcome.err,
        "windrow: warning: in 1 of 1 step the air was too fast for 2 sub-steps (largest CFL 100.0): speeds were limited in 1024 "
        "cells, counted in each step; raise tick_hz or air.max_substeps.\n");
}

TEST_F(Command, AMotorThatReachesNoAirIsNamed) {
    const auto motor = [](const char* name, const char* place) {
        return std::string(R"({"name": ")") + name + R"(", "kind": "directional", "position": )" + place +
               R"(, "direction": [1, 0, 0], "region": {"sphere": {"radius": 1}}, "law": {"drive": {"speed": 5}}})";
    };
    const auto warned = [&](const std::string& motors) {
        const std::string scene = write("lost.json", R"({"duration": 0.1, "tick_hz": 10, "air": {"cells": [8, 8, 8],
            "follow_axes": [false, false, false]}, "motors": [)" +
                                                         motors + "]}");
        const CommandOutcome outcome = run({"run", scene.c_str()});
        EXPECT_EQ(outcome.code, k_exit_well);
        return outcome.err;
    };
    const std::string here = motor("fan", "[0, 0, 0]"), far = motor("car", "[90, 0, 0]");
    EXPECT_EQ(warned(here + ", " + far),
              "windrow: warning: $.motors[1] (car) reached no air in any step: it is under the ground or far outside of the box; "
              "compare $.motors with $.floor and $.air.\n");
    EXPECT_TRUE(warned(far + ", " + far + ", " + here).starts_with("windrow: warning: $.motors[0] (car) and 1 other reached"));
}

TEST_F(Command, AnObstacleThatFillsTheBoxIsNamedWithItsSize) {
    const std::string large = write("large.json", R"({"duration": 0.1, "tick_hz": 10, "air": {"cells": [8, 8, 8], "cell_size": 1},
        "obstacles": [{"name": "post", "position": [0, 0, 0], "shape": {"block": {"half_size": [0.2, 2, 0.2]}}},
            {"name": "house", "position": [0, 0, 0], "shape": {"block": {"half_size": [400, 300, 350]}}}]})");
    const CommandOutcome outcome = run({"run", large.c_str()});
    EXPECT_EQ(outcome.code, k_exit_well);
    EXPECT_EQ(outcome.err,
              "windrow: warning: an obstacle filled more than half of the box in 1 step; $.obstacles[1] (house) is 800 x "
              "600 x 700 m large. Lengths are metres: was it made in centimetres?\n");
}

TEST_F(Command, AirThatIsPressedTogetherIsSaid) {
    const std::string pressed = write("pressed.json", R"({"duration": 0.3, "tick_hz": 10, "frames_per_second": 10,
        "air": {"cells": [12, 6, 6], "cell_size": 1, "boundaries": {
            "x_low": {"kind": "free_slip"}, "x_high": {"kind": "free_slip"}, "y_low": {"kind": "free_slip"},
            "y_high": {"kind": "free_slip"}, "z_low": {"kind": "free_slip"}, "z_high": {"kind": "free_slip"}}},
        "paths": {"push": {"points": [[0, -3, 3, 0], [1, 0, 3, 0]]}},
        "obstacles": [{"name": "piston", "path": "push", "shape": {"block": {"half_size": [1, 3, 3]}}}]})");
    const CommandOutcome outcome = run({"run", pressed.c_str()});
    EXPECT_EQ(outcome.code, k_exit_well);
    EXPECT_EQ(outcome.err,
              "windrow: warning: walls changed the volume of air that has no opening in 3 steps: it was pressed together, "
              "which air at these speeds is not; leave a gap.\n");
}

TEST_F(Command, SleepIsReported) {
    const std::string calm = write("calm.json", R"({"duration": 1, "air": {"cells": [8, 8, 8]},
        "motors": [{"kind": "jet", "from": 0.5, "envelope": {"hold": 0.1}}]})");
    const std::string out = in("calm");
    const CommandOutcome outcome = run({"run", calm.c_str(), "--csv", "--out", out.c_str()});
    EXPECT_EQ(outcome.code, k_exit_well) << outcome.err;
    EXPECT_NE(outcome.out.find(" of 60 steps; a step took "), std::string::npos) << outcome.out;
    expect_words(test::text_of(fs::path(out) / "timings.csv"), {",asleep,", ",ambient_ms,"});
}

TEST_F(Command, StopsAfterTheFrameWithWholeFiles) {
    const std::string out = in("stopped");
    std::ostringstream text;
    std::ostringstream err;
    int asked = 0;
    const RunRequest request{.scene = scene, .film = {}, .out = out, .csv = true};
    const int code = run_scene(request, {.out = text, .err = err, .progress = nullptr}, [&] { return ++asked > 3 ? SIGINT : 0; });
    EXPECT_EQ(code, 128 + SIGINT);
    EXPECT_EQ(err.str(), "windrow: stopped by Ctrl-C after 3 of 6 frames: all files written so far are complete.\n");
    EXPECT_EQ(list(out), "timings.csv ");
    EXPECT_NE(text.str().find("breeze: 3 frames, 12 steps"), std::string::npos) << text.str();
}

TEST_F(Command, SignalsAreNoted) {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        const InterruptGuard guard;
        EXPECT_EQ(InterruptGuard::signal(), 0);
        std::raise(number);
        EXPECT_EQ(InterruptGuard::signal(), number);
    }
    const InterruptGuard guard;
    EXPECT_EQ(InterruptGuard::signal(), 0) << "a new guard begins again";
}

// --- Folders and disks -----------------------------------------------------------------------------------------------

TEST_F(Command, AFolderBelongsToOneRun) {
    const std::string out = in("shared");
    const std::vector<const char*> again{"run", scene.c_str(), "--csv", "--out", out.c_str()};
    {
        OutputFolder other;
        ASSERT_FALSE(other.open(out));
        expect_rejection(again,
                         out + ": another windrow writes into this folder: wait for it, or give another folder with --out.");
        EXPECT_EQ(list(out), "");
    }
    EXPECT_EQ(run(again).code, k_exit_well);
    EXPECT_EQ(list(out), "timings.csv ");
}

TEST_F(Command, AFaultAtAFrameKeepsTheStepsBefore) {
    if (!built_with_vdb())
        GTEST_SKIP() << "needs --vdb";
    const std::string out = in("fault");
    fs::create_directories(fs::path(out) / "vel_0002.vdb");
    const CommandOutcome outcome = run({"run", scene.c_str(), "--csv", "--vdb", "--out", out.c_str()});
    EXPECT_EQ(outcome.code, k_exit_wrong_use);
    EXPECT_EQ(list(out), "timings.csv vel_0000.vdb vel_0001.vdb vel_0002.vdb ");
    const std::string table = test::text_of(fs::path(out) / "timings.csv");
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 12);
}

TEST_F(Command, FoldersThatCannotBeWritten) {
    const std::string below = scene + "/out"; // a file stands where a folder is needed
    expect_rejection({"run", scene.c_str(), "--csv", "--out", below.c_str()},
                     below + ": is a file where a folder is needed: remove it, or give another folder with --out.");
    expect_rejection({"run", scene.c_str(), "--csv", "--out", scene.c_str()},
                     scene + ": is a file where a folder is needed: remove it, or give another folder with --out.");
    const std::string name(300, 'n');
    const std::string lengthy = in(name);
    expect_rejection({"run", scene.c_str(), "--csv", "--out", lengthy.c_str()},
                     lengthy + ": the name is too long for the system: give a shorter one with --out.");
    if (::geteuid() == 0)
        return; // rights do not bind root
    const std::string closed = in("closed");
    fs::create_directory(closed);
    fs::permissions(closed, fs::perms::owner_read | fs::perms::owner_exec);
    expect_rejection({"run", scene.c_str(), "--csv", "--out", closed.c_str()},
                     closed + ": permission denied: allow writing, or give another folder with --out.");
}

#if !defined(__SANITIZE_ADDRESS__)
// In a container that allows one process. The libraries of pictures and volumes start threads while they are loaded.
TEST(VersionOfTheCommand, NeedsNoThread) {
    int out[2];
    ASSERT_EQ(::pipe(out), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        const rlimit limit{1, 1};
        if (::setrlimit(RLIMIT_NPROC, &limit) != 0 || (::geteuid() == 0 && ::setuid(65534) != 0))
            ::_exit(9);
        ::dup2(out[1], STDOUT_FILENO);
        ::execl(WINDROW_COMMAND, WINDROW_COMMAND, "--version", nullptr);
        ::_exit(9); // another user's folder
    }
    ::close(out[1]);
    char text[64] = {};
    const ssize_t count = ::read(out[0], text, sizeof text - 1);
    ::close(out[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status)) << "killed by signal " << WTERMSIG(status);
    if (WEXITSTATUS(status) == 9)
        GTEST_SKIP() << "this user may not set a limit, or not read the command";
    EXPECT_EQ(WEXITSTATUS(status), k_exit_well);
    EXPECT_EQ(std::string(text, static_cast<std::size_t>(std::max<ssize_t>(count, 0))), run({"--version"}).out);
}
#endif

TEST_F(Command, DiskThatTakesNothingIsFoundBeforeTheRun) {
    const std::string out = in("full");
    CommandOutcome outcome;
    {
        const test::FileSizeLimit limit(100);
        outcome = run({"run", scene.c_str(), "--csv", "--out", out.c_str()});
    }
    EXPECT_EQ(outcome.code, k_exit_machine);
    EXPECT_EQ(outcome.err, "windrow: " + out + ": is larger than the system allows a file to be: raise the limit (ulimit -f).\n");
    EXPECT_EQ(list(out), "") << "nothing half-written is left";
}

TEST_F(Command, DiskThatFillsUpLeavesWholeFilesOnly) {
    const std::string out = in("filling");
    CommandOutcome outcome;
    {
        const test::FileSizeLimit limit(6000);
        outcome = run({"run", scene.c_str(), "--csv", "--frames", "100", "--out", out.c_str()});
    }
    EXPECT_EQ(outcome.code, k_exit_machine);
    EXPECT_EQ(outcome.err,
              "windrow: " + out + "/timings.csv: is larger than the system allows a file to be: raise the limit (ulimit -f).\n");
    EXPECT_EQ(list(out), "");
}

TEST_F(Command, ExistingFileStaysWhenTheNewOneDoesNotFit) {
    const std::string name = write("kept.txt", "old");
    {
        const test::FileSizeLimit limit(100);
        OutputFile file(name);
        file.write(std::string(10'000, 'x'));
        EXPECT_TRUE(file.publish().machine);
    }
    EXPECT_EQ(test::text_of(name), "old");
    EXPECT_EQ(list(folder), "breeze.json kept.txt ");
    EXPECT_EQ(write_fault("x", ENOSPC).machine, true);
    EXPECT_EQ(write_fault("x", EACCES).machine, false);
}

// --- What is told ----------------------------------------------------------------------------------------------------

TEST(Progress, LineFitsTheWidth) {
    for (int width = 2; width < 200; ++width)
        EXPECT_LT(progress_line(57, 201, 14.0, width).size(), static_cast<std::size_t>(width));
    EXPECT_EQ(progress_line(50, 100, 75.0, 60), "frame 50 of 100 [#########---------] 50 %, 1 min 15 s to go");
    EXPECT_EQ(progress_line(100, 100, 0.0, 40), "frame 100 of 100 [##############] 100 %");
}

TEST(Progress, DurationsForPeople) {
    EXPECT_EQ(describe_duration(0.4), "0 s");
    EXPECT_EQ(describe_duration(59.0), "59 s");
    EXPECT_EQ(describe_duration(125.0), "2 min 05 s");
    EXPECT_EQ(describe_duration(4321.0), "1 h 12 min");
}

TEST(Timings, QuantilesAreNearestRanks) {
    std::vector<float> values;
    for (int i = 100; i >= 1; --i)
        values.push_back(static_cast<float>(i));
    EXPECT_EQ(quantile(values, 0.0), 1.0f);
    EXPECT_EQ(quantile(values, 0.5), 50.0f);
    EXPECT_EQ(quantile(values, 0.99), 99.0f);
    EXPECT_EQ(quantile({}, 0.5), 0.0f);
}

TEST(Timings, StepsAsleepStandApart) {
    Timings timings;
    Diagnostics step;
    step.times_ms.total = 1.0;
    timings.add(0.0, step);
    step.asleep = true;
    step.times_ms.total = 0.0005;
    for (int i = 0; i < 3; ++i)
        timings.add(0.0, step);
    EXPECT_EQ(timings.steps(), 4);
    EXPECT_EQ(timings.steps_asleep(), 3);
    EXPECT_EQ(timings.awake_ms(), 1.0f) << "steps asleep do not make a step look cheap";
    EXPECT_EQ(timings.asleep_ms(), 0.0005f);
    EXPECT_NE(timings.table().find("  step asleep "), std::string::npos) << timings.table();
    EXPECT_NEAR(timings.solver_seconds(), 0.0010015, 1e-9);
}

TEST(Timings, TimeThatNoStageClaimsIsShown) {
    Timings timings;
    Diagnostics step;
    step.times_ms = {.sources = 0.1, .diffusion = 0.0, .advection = 0.5, .projection = 0.2, .report = 0.0, .total = 1.0};
    timings.add(0.0, step);
    EXPECT_NE(timings.table().find("  rest               0.200     0.200     0.200     20 %"), std::string::npos)
        << timings.table();
    EXPECT_NE(timings.table().find("  whole step         1.000     1.000     1.000    100 %"), std::string::npos)
        << timings.table();
}

} // namespace
} // namespace windrow::cli
