// `windrow bench` as a user meets it: sentences, table, file. Nothing here asks how fast anything is.
#include "cases/verify_case.h"
#include "cli/bench/bench_command.h"
#include "cli/bench/contest.h"
#include "cli/console.h"
#include "tests/unit/command_outcome.h"

#include <chrono>
#include <cmath>
#include <sys/stat.h>

namespace windrow::cli {
namespace {

namespace fs = std::filesystem;

CommandOutcome bench(std::vector<const char*> arguments) {
    return run_windrow("bench", std::move(arguments));
}

void expect_bench_rejection(std::vector<const char*> arguments, const std::string& sentence) {
    expect_rejected(bench(std::move(arguments)), sentence);
}

using BenchCommand = test::FolderTest;

void expect_positive(const nlohmann::json& json, const char* key) {
    ASSERT_TRUE(json.contains(key)) << key << " in " << json.dump();
    ASSERT_TRUE(json[key].is_number()) << key;
    const double value = json[key];
    EXPECT_TRUE(std::isfinite(value) && value > 0.0) << key << " is " << value;
}

void expect_spread(const nlohmann::json& json, const char* key, bool positive = true) {
    ASSERT_TRUE(json.contains(key)) << key << " in " << json.dump();
    const nlohmann::json& spread = json[key];
    for (const char* name : {"min", "median", "p99", "samples"}) {
        if (positive)
            expect_positive(spread, name);
        else
            ASSERT_TRUE(spread.contains(name) && spread[name].is_number() && spread[name] >= 0.0) << key;
    }
    EXPECT_LE(spread["min"], spread["median"]);
    EXPECT_LE(spread["median"], spread["p99"]);
}

// --- Flags -----------------------------------------------------------------------------------------------------------

TEST_F(BenchCommand, WrongFlagsAreNamed) {
    const std::string grid = ": give three whole numbers such as 64x32x64, each from 1 to 2048.";
    for (const std::string text : {"64x32", "64x32x64x2", "0x1x1", "64x32x-3", "64x32x2049", "axbxc", "64", "64xx64", "64x32x"})
        expect_bench_rejection({"--grid", text.c_str()}, "--grid is " + text + grid);
    expect_bench_rejection({"--grid", ""}, "--grid is empty" + grid);
    expect_bench_rejection({"--grid", "8x8x8", "--grid", "9"}, "--grid is 9" + grid);
    expect_bench_rejection({"--grid", "2048x2048x2048"},
                           "--grid is 2048x2048x2048, 8589934592 cells: give at most 67108864 cells.");
    expect_bench_rejection({"--threads", "0"}, "--threads is 0: give a whole number from 1 to 256.");
    expect_bench_rejection({"--simd", "sse"}, "--simd is sse: give best, baseline, avx2 or avx512.");
    expect_bench_rejection({"--volumes", "16", "none"}, "--volumes is none: give a whole number from 1 to 65536.");
    expect_bench_rejection({"--seconds", "0"}, "--seconds is 0: give a number above 0, at most 3600 s.");
    expect_bench_rejection({"--seconds", "nan"}, "--seconds is nan: give a number above 0, at most 3600 s.");
    expect_bench_rejection({"--json", ""}, "--json is empty: name a file.");
    expect_bench_rejection({"--gird", "8x8x8"}, "unknown option --gird (did you mean --grid?): see windrow bench --help.");
}

TEST_F(BenchCommand, AFileThatCannotBeWrittenIsRejectedBeforeAnythingIsMeasured) {
    expect_bench_rejection({"--json", folder.c_str()},
                           folder.string() +
                               ": is a folder where a file is needed: remove it, or give another file with --json.");
    const std::string lost = in("none/bench.json");
    const CommandOutcome outcome = bench({"--json", lost.c_str()});
    EXPECT_EQ(outcome.code, k_exit_wrong_use);
    EXPECT_NE(outcome.err.find("give another file with --json."), std::string::npos) << outcome.err;
    EXPECT_TRUE(fs::is_empty(folder));
    for (const auto& entry : fs::directory_iterator(folder.parent_path()))
        EXPECT_FALSE(entry.path().string().starts_with(folder.string() + ".")) << entry.path();
}

TEST_F(BenchCommand, WhatIsNoOrdinaryFileStaysAndALinkIsFollowed) {
    const std::string pipe = in("pipe");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    expect_bench_rejection({"--json", pipe.c_str()}, pipe + ": is not a regular file: give another file with --json.");
    EXPECT_TRUE(fs::is_fifo(pipe));

    const std::string target = in("target.json"), link = in("link.json");
    std::ofstream(target) << "old";
    fs::create_symlink(target, link);
    ASSERT_EQ(bench({"--grid", "4x4x4", "--seconds", "0.01", "--json", link.c_str()}).code, k_exit_well);
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_TRUE(json_in(target).contains("entries"));
}

// --- Results ---------------------------------------------------------------------------------------------------------

TEST_F(BenchCommand, FiguresAreToldAndKept) {
    const std::string file = in("bench.json");
    const CommandOutcome outcome = bench({"--grid", "8x6x10", "--threads", "2", "--seconds", "0.05", "--json", file.c_str()});
    ASSERT_EQ(outcome.code, k_exit_well) << outcome.err;
    expect_words(outcome.out, {"8 x 6 x 10", "2 threads", "second_order", "stable_fluids", "barriers", "Stam, 40 sweeps", "copy",
                               "advection", "projection", "direct", "40 Jacobi sweeps", "residual"});

    const nlohmann::json json = json_in(file);
    for (const char* key : {"device", "compiler", "commit", "simd"})
        EXPECT_TRUE(json.contains(key) && json[key].is_string() && !json[key].get<std::string>().empty()) << key;
    EXPECT_EQ(json["threads"], 2);
    ASSERT_EQ(json["entries"].size(), 2);
    for (const nlohmann::json& entry : json["entries"]) {
        EXPECT_EQ(entry["grid"], "8x6x10");
        EXPECT_EQ(entry["backend"], "cpu");
        expect_spread(entry, "step_ms");
        EXPECT_EQ(entry["stages_ms"].size(), k_stage_count);
        for (std::size_t n = 0; n < k_stage_count; ++n)
            expect_spread(entry["stages_ms"], StageTimes::rows()[n].name, false);
        for (const char* key :
             {"dispatches", "barriers", "vs_copy16", "vs_stam40", "cells_per_s", "bytes_per_cell", "largest_cfl", "samples"})
            expect_positive(entry, key);
    }
    EXPECT_EQ(json["entries"][0]["scheme"], "second_order");
    EXPECT_EQ(json["entries"][1]["scheme"], "stable_fluids");
    ASSERT_EQ(json["references"].size(), 1);
    const nlohmann::json& reference = json["references"][0];
    EXPECT_EQ(reference["grid"], "8x6x10");
    for (const char* key : {"copy16_ms", "stam40_ms", "jacobi40_ms", "direct_ms"})
        expect_spread(reference, key);
    for (const char* key : {"jacobi40_residual", "jacobi40_gradient_error", "direct_residual", "direct_vs_jacobi40"})
        expect_positive(reference, key);
    if (!cases::spectral_cases().empty()) { // FFTW is linked
        expect_spread(reference, "fftw_ms");
        expect_spread(reference, "direct_one_thread_ms");
        expect_positive(reference, "fftw_residual");
        expect_positive(reference, "direct_vs_fftw");
    }
    if (WINDROW_CASES_OPENVDB) {
        expect_spread(reference, "vdb_ms");
        expect_positive(reference, "vdb_residual");
    }
    EXPECT_TRUE(json["volumes"].empty());
    EXPECT_EQ(entries(), 1) << "nothing but the file is left";
}

TEST_F(BenchCommand, TheSmallestGridIsMeasuredToo) {
    EXPECT_EQ(bench({"--grid", "1x1x1", "--threads", "1", "--seconds", "0.01"}).code, k_exit_well);
}

TEST_F(BenchCommand, VolumesAloneAreMeasuredWhereNoGridIsGiven) {
    const std::string file = in("volumes.json");
    const CommandOutcome outcome =
        bench({"--volumes", "1", "3", "--threads", "2", "--simd", "baseline", "--seconds", "0.02", "--json", file.c_str()});
    ASSERT_EQ(outcome.code, k_exit_well) << outcome.err;
    const nlohmann::json json = json_in(file);
    EXPECT_EQ(json["simd"], "baseline");
    EXPECT_TRUE(json["entries"].empty());
    EXPECT_TRUE(json["references"].empty());
    ASSERT_EQ(json["volumes"].size(), 2);
    EXPECT_EQ(json["volumes"][1]["volumes"], 3);
    for (const nlohmann::json& volumes : json["volumes"]) {
        expect_spread(volumes, "round_ms");
        for (const char* key : {"volumes_per_s", "volumes_per_s_core", "bytes_per_volume"})
            expect_positive(volumes, key);
    }
}

// --- Contest ---------------------------------------------------------------------------------------------------------

TEST(Contest, EachContestantHasItsTurnAndEnoughSamples) {
    int prepared = 0, ran = 0, noted = 0;
    Contest contest;
    const std::size_t one =
        contest.add({.run = [&] { ++ran; }, .prepare = [&] { ++prepared; }, .note = [&] { ++noted; }, .repeats = false});
    const std::size_t other = contest.add({.run = [] {}});
    EXPECT_TRUE(contest.hold(0.5, [] { return false; }));
    EXPECT_EQ(prepared, ran);
    EXPECT_EQ(static_cast<std::size_t>(noted), contest.milliseconds(one).samples);
    EXPECT_GE(contest.milliseconds(one).samples, k_enough_samples);
    EXPECT_GE(contest.milliseconds(other).samples, k_enough_samples);
    EXPECT_GT(contest.rounds(), 0u);
}

TEST(Contest, ARatioIsTheFirstOverTheSecond) {
    const auto busy = [](double milliseconds) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double, std::milli>(milliseconds);
        while (std::chrono::steady_clock::now() < end) {
        }
    };
    Contest contest;
    const std::size_t quick = contest.add({.run = [&] { busy(0.2); }});
    const std::size_t slow = contest.add({.run = [&] { busy(2.0); }});
    ASSERT_TRUE(contest.hold(0.2, [] { return false; }));
    EXPECT_GT(contest.ratio(slow, quick), 2.0);
    EXPECT_LT(contest.ratio(quick, slow), 0.5);
}

TEST(Contest, StopsWhenAsked) {
    Contest contest;
    contest.add({.run = [] {}});
    EXPECT_FALSE(contest.hold(1000.0, [] { return true; }));
}

TEST(Contest, SpreadIsNearestRanks) {
    std::vector<float> values;
    for (int n = 1; n <= 200; ++n)
        values.push_back(static_cast<float>(n));
    const Spread spread = spread_of(values);
    EXPECT_EQ(spread.min, 1.0);
    EXPECT_EQ(spread.median, 100.0);
    EXPECT_EQ(spread.p99, 198.0);
    EXPECT_EQ(spread.samples, 200u);
}

} // namespace
} // namespace windrow::cli
