// A run that was killed goes on from its snapshot: its files are those of a run that was not, to the byte.
#include "cli/info_command.h"
#include "cli/run_command.h"
#include "cli/run_snapshot.h"
#include "scene/scene_reader.h"
#include "tests/unit/command_outcome.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <map>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace windrow::cli {
namespace {

namespace fs = std::filesystem;

// All that a snapshot must hold: gusts, a motor and an obstacle that move, smoke, a box that follows.
constexpr const char* k_smoky = R"({"duration": 1.5, "tick_hz": 60, "frames_per_second": 20,
    "air": {"cells": [24, 12, 16], "ambient": [4, 0, 0], "boundaries": {"y_low": "free_slip"},
            "gusts": {"intensity": 0.3, "length": 12}},
    "floor": 0, "follow": "way",
    "paths": {"way": {"points": [[0, -6, 2, -3], [0.7, -3, 2, 3], [1.5, 6, 2, -3]]}},
    "smoke": [{"position": [-4, 2, 0], "radius": 1}],
    "vdb": {"grids": {"density": true, "pressure": true, "divergence": true}},
    "obstacles": [{"name": "cart", "shape": {"block": {"half_size": [1, 1, 1]}}, "path": "way"}],
    "motors": [{"kind": "directional", "position": [-6, 2, 0], "from": 0.2, "until": 1.2,
                "law": {"drive": {"speed": 12, "rate": 8}}}]})";

class RunSnapshotOf : public test::FolderTest {
  protected:
    std::string write(const std::string& name, const std::string& text) {
        std::ofstream(folder / name) << text;
        return in(name);
    }
    std::vector<const char*> words(const std::string& out, std::vector<const char*> more = {}) {
        std::vector<const char*> all = {"run",     scene.c_str(), "--out",   out.c_str(), "--csv",           "--fields",
                                        "npz,raw", "--probe",     "a=0,2,0", "--probe",   "b=-4,1,0:4,3,2:5"};
        if (built_with_vdb())
            all.push_back("--vdb");
        if (built_with_images())
            all.push_back("--images");
        all.push_back("--forces");
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    /// The name and the bytes of each file; of timings.csv without the times.
    static std::map<std::string, std::string> files_of(const fs::path& out) {
        std::map<std::string, std::string> files;
        for (const auto& entry : fs::directory_iterator(out))
            files[entry.path().filename().string()] =
                entry.path().filename() == "timings.csv" ? without_times(entry.path()) : test::text_of(entry.path());
        return files;
    }
    static std::vector<std::string> cells_of(const std::string& line) {
        std::vector<std::string> cells;
        std::istringstream rest(line);
        for (std::string cell; std::getline(rest, cell, ',');)
            cells.push_back(cell);
        return cells;
    }
    static std::string without_times(const fs::path& file) {
        std::ifstream in(file);
        std::string line, text;
        std::getline(in, line);
        const auto header = cells_of(line);
        while (std::getline(in, line)) {
            const auto cells = cells_of(line);
            for (std::size_t n = 0; n < cells.size(); ++n)
                if (!header[n].ends_with("_ms"))
                    text += cells[n] + ",";
            text += "\n";
        }
        return text;
    }
    static void expect_equal(const std::map<std::string, std::string>& whole, const std::map<std::string, std::string>& joined) {
        for (const auto& [name, bytes] : whole)
            EXPECT_TRUE(joined.contains(name) && joined.at(name) == bytes) << name;
        for (const auto& [name, bytes] : joined)
            EXPECT_TRUE(whole.contains(name)) << name;
    }
    /// The report without what a clock says.
    static std::string report_of(const std::string& out) {
        std::istringstream in(out);
        std::string line, text;
        while (std::getline(in, line))
            if (line.starts_with("smoky") || line.starts_with("  cells") || line.starts_with("  sub-steps") ||
                line.starts_with("  limited"))
                text += line + "\n";
        return text;
    }

    /// [s]
    static std::string smoky_for(const char* duration) {
        std::string text = k_smoky;
        const std::string said = "\"duration\": 1.5";
        return text.replace(text.find(said), said.size(), std::string("\"duration\": ") + duration);
    }

    std::string scene = write("smoky.json", k_smoky);
};

TEST_F(RunSnapshotOf, AKilledRunGoesOnToTheSameBytes) {
    scene = write("smoky.json", smoky_for("0.9"));
    const std::string whole = in("whole"), killed = in("killed");
    const CommandOutcome all = run_windrow(words(whole));
    ASSERT_EQ(all.code, k_exit_well) << all.err;

    std::vector<const char*> arguments = words(killed, {"--snapshot-every", "3"});
    arguments.insert(arguments.begin(), WINDROW_COMMAND);
    arguments.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
        std::fclose(stdout);
        ::execv(WINDROW_COMMAND, const_cast<char* const*>(arguments.data()));
        ::_exit(9);
    }
    int status = 0;
    const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(120);
    while (!fs::exists(fs::path(killed) / "wind_0008.npz") && std::chrono::steady_clock::now() < patience)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ::kill(child, SIGKILL);
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "it ended before it was killed, with " << WEXITSTATUS(status);
    ASSERT_TRUE(fs::exists(fs::path(killed) / "run.snapshot"));
    ASSERT_FALSE(fs::exists(fs::path(killed) / "wind_0018.npz"));
    ASSERT_FALSE(fs::exists(fs::path(killed) / "probes.csv"));

    const CommandOutcome resumed = run_windrow(words(killed, {"--resume", "--snapshot-every", "7", "--threads", "3"}));
    ASSERT_EQ(resumed.code, k_exit_well) << resumed.err;
    expect_equal(files_of(whole), files_of(killed));
    EXPECT_NE(report_of(all.out), "");
    std::string report = report_of(resumed.out), expected = report_of(all.out);
    report = report.substr(0, report.find(" s, ")) + report.substr(report.find('\n')); // without the threads
    expected = expected.substr(0, expected.find(" s, ")) + expected.substr(expected.find('\n'));
    EXPECT_EQ(report, expected);
}

TEST_F(RunSnapshotOf, EveryFrameIsAPlaceToGoOnFrom) {
    scene = write("smoky.json", smoky_for("0.3"));
    const std::string whole = in("whole"), parts = in("parts");
    ASSERT_EQ(run_windrow(words(whole)).code, k_exit_well);
    RunRequest request{.scene = scene, .film = {}, .out = parts, .csv = true};
    request.fields = {FieldFormat::npz, FieldFormat::raw};
    request.vdb = built_with_vdb();
    request.images = built_with_images();
    request.probes.lines = {{.name = "a", .from = {0, 2, 0}, .to = {0, 2, 0}, .count = 1},
                            {.name = "b", .from = {-4, 1, 0}, .to = {4, 3, 2}, .count = 5}};
    request.probes.forces = true;
    request.snapshot_every = 100; // the signal alone keeps one
    request.resume = true;        // the first of them begins
    int runs = 0;
    for (int code = -1; code != k_exit_well; ++runs) {
        std::ostringstream out, err;
        int asked = 0;
        code = run_scene(request, {.out = out, .err = err, .progress = nullptr}, [&] { return ++asked > 1 ? SIGTERM : 0; });
        ASSERT_TRUE(code == k_exit_well || code == 128 + SIGTERM) << err.str();
        ASSERT_LT(runs, 20);
    }
    EXPECT_EQ(runs, 7);
    auto kept = files_of(parts), all = files_of(whole);
    kept.erase("contact_sheet.png"); // a stopped run draws none
    all.erase("contact_sheet.png");
    expect_equal(all, kept);
}

TEST_F(RunSnapshotOf, OtherRunsAreRejected) {
    const std::string out = in("out"), file = out + "/run.snapshot";
    RunRequest request{.scene = scene, .film = {}, .out = out, .csv = true};
    request.fields = {FieldFormat::npz};
    request.snapshot_every = 1;
    request.words = "--csv true";
    const auto stopped_after = [&](int frames) {
        std::ostringstream text, err;
        int asked = 0;
        return run_scene(request, {.out = text, .err = err, .progress = nullptr}, [&] { return ++asked > frames ? SIGINT : 0; });
    };
    const auto expect_sentence = [&](const std::string& sentence) {
        expect_rejected(run_request(run_scene, request, 0), sentence);
    };
    ASSERT_EQ(stopped_after(2), 128 + SIGINT);
    ASSERT_TRUE(fs::exists(file));
    const std::string good = test::text_of(file);
    request.resume = true;

    request.words = "--csv true --fps 30";
    const CommandOutcome other = run_request(run_scene, request, 0);
    EXPECT_EQ(other.code, k_exit_wrong_use);
    expect_words(other.err, {"run.snapshot: is of a run with \"--csv true --simd ",
                             "\", this one has \"--csv true --fps 30 --simd ", "\": give the same flags, or drop --resume."});
    request.words = "--csv true";

    std::string changed = good;
    changed[changed.size() / 2] = static_cast<char>(changed[changed.size() / 2] ^ 1);
    std::ofstream(file) << changed;
    expect_sentence(file +
                    ": file of saved parts has changed since it was written: its checksum does not match; take another copy.");
    std::ofstream(file) << good;

    fs::rename(out + "/wind_0001.npz", out + "/away");
    expect_sentence(out + "/wind_0001.npz: is missing, though the run is past this frame: drop --resume.");
    fs::rename(out + "/away", out + "/wind_0001.npz");

    write("smoky.json", std::string(k_smoky) + " ");
    expect_sentence(file + ": the scene or a file that it names has changed since: drop --resume.");
    write("smoky.json", k_smoky);

    request.backend.kind = cases::BackendKind::vulkan;
    expect_sentence("--snapshot-every and --resume need the CPU: drop --backend.");
    request.backend.kind = cases::BackendKind::cpu;

    request.film.frames = 4;
    EXPECT_EQ(run_request(run_scene, request, 0).code, k_exit_well);
    EXPECT_FALSE(fs::exists(file)) << "a run that has ended leaves none";
    ASSERT_EQ(stopped_after(2), 128 + SIGINT);
    request.resume = false;
    request.snapshot_every = 0;
    EXPECT_EQ(stopped_after(1), 128 + SIGINT);
    EXPECT_FALSE(fs::exists(file)) << "its frames are replaced";
}

TEST_F(RunSnapshotOf, FilesOfThePictureAreOfTheRun) {
    const auto identity = [&](int height) {
        write("hill.pgm", "P2 2 2 255 0 0 0 " + std::to_string(height) + "\n");
        const auto read = scene::read_scene(write("walked.json", R"({"air": {"cells": [8, 8, 8]},
            "paths": {"way": {"points": [[0, 0, 0, 0], [1, 9, 0, 9]]}},
            "picture": {"ground": {"heights": "hill.pgm", "high": 5, "extent": [10, 10]}, "walkers": [{"path": "way"}]}})"));
        EXPECT_TRUE(read) << (read ? "" : read.error());
        return read ? identity_of(*read, "")->scene : 0;
    };
    EXPECT_NE(identity(255), identity(100));
    EXPECT_EQ(identity(255), identity(255));
}

} // namespace
} // namespace windrow::cli
