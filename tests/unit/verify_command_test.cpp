// `windrow verify` as a user meets it: sentences, table, file, exit codes. That the errors are right is what the command itself
// asks; here a quick case stands for all, and made-up cases show that a miss is told.
#include "cases/verify_case.h"
#include "cli/console.h"
#include "cli/verify/verify_command.h"
#include "tests/unit/command_outcome.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <limits>
#include <set>

namespace windrow::cli {

using namespace cases;

namespace {

namespace fs = std::filesystem;

constexpr const char* k_quick = "couette_steady";

CommandOutcome verify(std::vector<const char*> arguments) {
    return run_windrow("verify", std::move(arguments));
}

CommandOutcome verify(const VerifyRequest& request, int signal = 0) {
    return run_request(run_verify, request, signal);
}

void expect_verify_rejection(std::vector<const char*> arguments, const std::string& sentence) {
    expect_rejected(verify(std::move(arguments)), sentence);
}

/// A case whose errors are given.
VerifyCase made_up(std::vector<double> errors, double bound, double min_order) {
    VerifyCase one{.name = "made_up", .what = "Errors as given.", .source = "none", .reason = "none", .min_order = min_order};
    for (std::size_t n = 0; n < errors.size(); ++n)
        one.sizes.push_back(1 << n);
    one.run = [=](const VerifySetting&, int size) {
        std::size_t level = 0;
        while (1 << level != size)
            ++level;
        return VerifyRow{.cells = glm::ivec3(size), .cfl = 0.5, .error = errors[level], .bound = bound};
    };
    return one;
}

using VerifyCommand = test::FolderTest;

// --- Flags -----------------------------------------------------------------------------------------------------------

TEST_F(VerifyCommand, WrongFlagsAreNamed) {
    expect_verify_rejection({"--backend", "gpu"}, "--backend is gpu: give cpu or vulkan.");
    expect_verify_rejection({"--backend", ""}, "--backend is empty: give cpu or vulkan.");
    expect_verify_rejection({"--device", "0"},
                            "--device is given, but the air runs on the CPU: add --backend vulkan, or drop it.");
    expect_verify_rejection({"--backend", "vulkan", "--device", "-1"},
                            "--device is -1: give a device's number in windrow info, from 0.");
    expect_verify_rejection({"--backend", "vulkan", "--device", ""},
                            "--device is empty: give a device's number in windrow info, from 0.");
    expect_verify_rejection({"--backend", "vulkan", "--case", "fourier_modes"},
                            "--case is fourier_modes, which runs on the CPU only: drop --backend vulkan.");
    expect_verify_rejection({"--threads", "0"}, "--threads is 0: give a whole number from 1 to 256.");
    expect_verify_rejection({"--simd", "sse"}, "--simd is sse: give best, baseline, avx2 or avx512.");
    expect_verify_rejection({"--json", ""}, "--json is empty: name a file.");
    expect_verify_rejection({"--case", ""}, "--case is empty: see windrow verify --list.");
    expect_verify_rejection({"--list", "--json", "x.json"}, "--json is given with --list, which runs nothing: drop one of them.");
    expect_verify_rejection({"--csae", "abc_flow"}, "unknown option --csae (did you mean --case?): see windrow verify --help.");
}

TEST_F(VerifyCommand, AnUnknownCaseIsRejectedWithTheNearestName) {
    expect_verify_rejection(
        {"--case", "taylor_gren_2d"},
        "--case is taylor_gren_2d, which is unknown (did you mean taylor_green_2d?): see windrow verify --list.");
    expect_verify_rejection({"--case", k_quick, "--case", "qqqqqq"},
                            "--case is qqqqqq, which is unknown: see windrow verify --list.");
}

TEST_F(VerifyCommand, AFileThatCannotBeWrittenIsRejectedBeforeAnythingRuns) {
    expect_verify_rejection({"--json", folder.c_str()},
                            folder.string() +
                                ": is a folder where a file is needed: remove it, or give another file with --json.");
}

TEST_F(VerifyCommand, TheListNamesEachCase) {
    const CommandOutcome outcome = verify({"--list"});
    EXPECT_EQ(outcome.code, k_exit_well);
    EXPECT_EQ(outcome.err, "");
    for (const VerifyCase& one : verify_cases())
        EXPECT_NE(outcome.out.find(one.name + "\n  "), std::string::npos) << one.name;
}

TEST_F(VerifyCommand, EachCaseIsWhole) {
    std::set<std::string> names;
    for (const VerifyCase& one : verify_cases()) {
        EXPECT_TRUE(names.insert(one.name).second) << one.name << " is there twice";
        EXPECT_FALSE(one.what.empty() || one.source.empty() || one.reason.empty() || !one.run) << one.name;
        EXPECT_GE(one.sizes.size(), one.min_order > 0.0 ? 3u : 1u) << one.name << ": a slope needs three resolutions";
        EXPECT_TRUE(std::is_sorted(one.sizes.begin(), one.sizes.end())) << one.name;
    }
    EXPECT_GE(names.size(), 30u);
}

// --- Results ---------------------------------------------------------------------------------------------------------

TEST_F(VerifyCommand, AQuickCasePassesAndIsKept) {
    const std::string file = in("verify.json");
    const CommandOutcome outcome =
        verify({"--case", k_quick, "--case", "fourier_transit", "--backend", "cpu", "--threads", "2", "--json", file.c_str()});
    ASSERT_EQ(outcome.code, k_exit_well) << outcome.out << outcome.err;
    expect_words(outcome.out, {k_quick, "grid", "CFL", "error", "at most", "order", "at least", "truth: ", "bound: ", "pass",
                               "2 cases: each within its bounds."});
    EXPECT_EQ(outcome.out.find("FAIL"), std::string::npos);

    const nlohmann::json json = json_in(file);
    ASSERT_EQ(json["cases"].size(), 6u);
    for (std::size_t n = 0; n < 6; ++n) {
        const nlohmann::json& entry = json["cases"][n];
        EXPECT_EQ(entry["name"], n < 3 ? k_quick : "fourier_transit");
        EXPECT_EQ(entry["backend"], "cpu");
        EXPECT_TRUE(entry["label"].is_null());
        EXPECT_TRUE(entry["grid"].is_string());
        for (const char* key : {"cfl", "error", "bound"})
            EXPECT_TRUE(entry[key].is_number()) << key;
        EXPECT_EQ(entry["order"].is_null(), n % 3 == 0) << entry.dump();
        EXPECT_EQ(entry["min_order"].is_number(), n > 3) << entry.dump();
        EXPECT_EQ(entry["pass"], true);
        EXPECT_LE(entry["error"], entry["bound"]);
    }
    EXPECT_EQ(json["cases"][4]["grid"], "80x2x4");
    EXPECT_EQ(entries(), 1) << "nothing but the file is left";
}

TEST_F(VerifyCommand, PartsJoinToTheFileOfTheWhole) {
    const std::string whole = in("whole.json"), one = in("one.json"), two = in("two.json"), joined = in("joined.json");
    const auto chosen = [](std::vector<const char*> more) {
        std::vector<const char*> all{"--case", k_quick, "--case", "fourier_transit", "--case", "poisson_mixed"};
        all.insert(all.end(), more.begin(), more.end());
        return verify(all);
    };
    ASSERT_EQ(chosen({"--json", whole.c_str()}).code, k_exit_well);
    ASSERT_EQ(chosen({"--part", "1/2", "--json", one.c_str()}).code, k_exit_well);
    ASSERT_EQ(chosen({"--part", "2/2", "--json", two.c_str()}).code, k_exit_well);
    EXPECT_NE(test::text_of(one).find("poisson_mixed"), std::string::npos) << "the third is dealt to the first part";
    const CommandOutcome outcome = chosen({"--json", joined.c_str(), "--join", two.c_str(), one.c_str()});
    EXPECT_EQ(outcome.code, k_exit_well) << outcome.err;
    expect_words(outcome.out, {"rows of 3 cases, 0 out of bounds."});
    EXPECT_EQ(test::text_of(joined), test::text_of(whole));

    expect_rejected(chosen({"--json", joined.c_str(), "--join", one.c_str()}),
                    "--join has no file with the case fourier_transit: run its part, or name the cases with --case.");
    expect_rejected(chosen({"--json", joined.c_str(), "--join", one.c_str(), whole.c_str()}),
                    whole + ": has the case " + k_quick + ", as " + one + " has: give each part once.");
    for (const char* const rows : {R"({"name": 1})", R"({"name": "a", "pass": "yes"})", "3"}) {
        std::ofstream(in("wrong.json")) << R"({"cases": [)" << rows << "]}";
        expect_rejected(chosen({"--json", joined.c_str(), "--join", in("wrong.json").c_str()}),
                        in("wrong.json") + ": is not what windrow verify --json writes: give the files of the parts.");
    }
    expect_rejected(chosen({"--join", one.c_str()}), "--join needs --json, the file to make: add it.");
    expect_rejected(chosen({"--part", "3/2"}), "--part is \"3/2\": give K/N, part K of N, such as 1/8; N is 10000 at most.");
    expect_rejected(verify({"--json", joined.c_str(), "--case", k_quick, "--join", whole.c_str()}),
                    whole + ": has the case fourier_transit, which is not asked for: drop the file, or add --case.");
    std::ofstream(one) << "{}";
    expect_rejected(chosen({"--json", joined.c_str(), "--join", one.c_str()}),
                    one + ": is not what windrow verify --json writes: give the files of the parts.");
    std::string failed = test::text_of(whole);
    for (const auto& [from, to] :
         {std::pair("\"pass\": true", "\"pass\": false"), std::pair("\"verdict\": \"pass\"", "\"verdict\": \"FAIL\"")})
        failed.replace(failed.find(from), std::string_view(from).size(), to);
    std::ofstream(one) << failed;
    EXPECT_EQ(chosen({"--json", joined.c_str(), "--join", one.c_str()}).code, k_exit_out_of_bounds);
}

TEST_F(VerifyCommand, ErrorsDoNotDependOnTheThreads) {
    const std::string one = in("one.json"), three = in("three.json");
    ASSERT_EQ(verify({"--case", "poisson_mixed", "--threads", "1", "--json", one.c_str()}).code, k_exit_well);
    ASSERT_EQ(verify({"--case", "poisson_mixed", "--threads", "3", "--json", three.c_str()}).code, k_exit_well);
    EXPECT_EQ(json_in(one), json_in(three));
}

TEST_F(VerifyCommand, AMissedBoundOrOrderIsToldAndKept) {
    struct Miss {
        std::vector<double> errors;
        double bound, min_order;
        std::vector<bool> passes;
    };
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
    const Miss misses[] = {{{0.4, 0.1, 0.025}, 0.3, 1.9, {false, true, true}},  // a bound
                           {{0.4, 0.1, 0.05}, 1.0, 1.9, {true, true, false}},   // an order
                           {{0.4, 0.5, 0.6}, 1.0, 0.5, {true, false, false}},   // an error that grows
                           {{0.4, nan, 0.025}, 1.0, 1.9, {true, false, false}}, // neither an error nor an order
                           {{infinite, 0.1, 0.025}, 1.0, 0.0, {false, true, true}},
                           {{0.0, 0.1, 0.025}, 1.0, 1.9, {true, false, true}}};
    for (const Miss& miss : misses) {
        const std::string file = in("miss.json");
        const CommandOutcome outcome =
            verify({.cases = {made_up({0.4, 0.1, 0.025}, 1.0, 1.9), made_up(miss.errors, miss.bound, miss.min_order)},
                    .threads = 1,
                    .json = file});
        EXPECT_EQ(outcome.code, k_exit_out_of_bounds);
        EXPECT_EQ(outcome.err, "windrow: 1 of 2 cases is out of bounds: made_up.\n");
        EXPECT_NE(outcome.out.find("FAIL"), std::string::npos) << outcome.out;
        const nlohmann::json json = json_in(file);
        for (std::size_t n = 0; n < 3; ++n) {
            EXPECT_EQ(json["cases"][n]["pass"], true);
            EXPECT_EQ(json["cases"][3 + n]["pass"], miss.passes[n]) << n << "\n" << outcome.out;
            EXPECT_EQ(json["cases"][3 + n]["error"].is_null(), !std::isfinite(miss.errors[n]));
        }
    }
}

/// A case whose resolutions give a row under each of two labels, of order 2 and of an order as given.
VerifyCase made_up_of_two(double second_order) {
    VerifyCase one = made_up({0.4, 0.1, 0.025}, 1.0, 1.9);
    one.run = [=](const VerifySetting&, int size) {
        const auto row = [&](const char* label, double order) {
            return VerifyRow{.cells = glm::ivec3(size), .error = 0.4 * std::pow(size, -order), .bound = 1.0, .label = label};
        };
        return std::vector{row("near", 2.0), row("far", second_order)};
    };
    return one;
}

TEST_F(VerifyCommand, RowsAreJudgedByTheirLabel) {
    const std::string file = in("labels.json");
    const CommandOutcome good = verify({.cases = {made_up_of_two(3.0)}, .threads = 1, .json = file});
    EXPECT_EQ(good.code, k_exit_well) << good.out;
    EXPECT_NE(good.out.find("pass  far\n"), std::string::npos) << good.out;
    const nlohmann::json json = json_in(file);
    ASSERT_EQ(json["cases"].size(), 6u);
    for (std::size_t n = 0; n < 6; ++n) {
        const nlohmann::json& entry = json["cases"][n];
        EXPECT_EQ(entry["label"], n % 2 == 0 ? "near" : "far");
        EXPECT_EQ(entry["order"].is_null(), n < 2);
        if (n >= 2) {
            EXPECT_NEAR(entry["order"].get<double>(), n % 2 == 0 ? 2.0 : 3.0, 1e-9);
        }
    }
    const CommandOutcome bad = verify({.cases = {made_up_of_two(1.0)}, .threads = 1});
    EXPECT_EQ(bad.code, k_exit_out_of_bounds);
    EXPECT_NE(bad.out.find("FAIL  far\n"), std::string::npos) << bad.out;
    EXPECT_EQ(bad.out.find("FAIL  near\n"), std::string::npos) << bad.out;
}

TEST_F(VerifyCommand, PlotsHoldTheCurvesOfAllResolutions) {
    VerifyCase one = made_up({0.5, 0.25}, 1.0, 0.0);
    one.run = [run = one.run](const VerifySetting& setting, int size) {
        VerifyRows found = run(setting, size);
        found.curves.push_back(
            {.plot = {}, .panel = "left", .line = std::to_string(size) + " cells", .points = {{0.0, 1.0}, {1.0, 2.0}}});
        return found;
    };
    const CommandOutcome done = verify({.cases = {one, made_up({0.5}, 1.0, 0.0)}, .threads = 1, .plots = folder / "plots"});
    EXPECT_EQ(done.code, k_exit_well);
    EXPECT_EQ(test::text_of(folder / "plots" / "made_up.csv"), "plot,panel,line,x,y\n"
                                                               "made_up,left,1 cells,0,1\nmade_up,left,1 cells,1,2\n"
                                                               "made_up,left,2 cells,0,1\nmade_up,left,2 cells,1,2\n");
    expect_verify_rejection({"--plots", ""}, "--plots is empty: name a folder.");
    expect_verify_rejection({"--list", "--plots", "somewhere"},
                            "--plots is given with --list, which runs nothing: drop one of them.");
}

// A miss that not_met() names does not pass, but is no fault; once it meets its bound, it must leave that file. A case that only
// guards against change says so.
TEST_F(VerifyCommand, KnownMissesAreToldApartFromFaults) {
    const std::array known{NotMet{"made_up", "a label"}};
    const auto with_error = [&](double error, const std::string& label) {
        VerifyCase one = made_up({error}, 1.0, 0.0);
        one.run = [=](const VerifySetting&, int size) {
            return VerifyRow{.cells = glm::ivec3(size), .error = error, .bound = 1.0, .label = label};
        };
        return verify({.cases = {one}, .known = known, .threads = 1});
    };
    const CommandOutcome misses = with_error(2.0, "a label"), meets = with_error(0.5, "a label"),
                         another = with_error(2.0, "another label");
    EXPECT_EQ(misses.code, k_exit_well);
    EXPECT_NE(misses.out.find("not met"), std::string::npos);
    EXPECT_EQ(misses.out.find("pass"), std::string::npos) << misses.out;
    EXPECT_EQ(meets.code, k_exit_out_of_bounds);
    EXPECT_NE(meets.err.find("Take it out of that file."), std::string::npos) << meets.err;
    EXPECT_EQ(another.code, k_exit_out_of_bounds);
    for (const NotMet& one : not_met())
        EXPECT_TRUE(
            std::any_of(verify_cases().begin(), verify_cases().end(), [&](const auto& real) { return real.name == one.name; }))
            << one.name << " is no case";

    VerifyCase guard = made_up({0.5}, 1.0, 0.0);
    guard.guards = true;
    EXPECT_NE(verify({.cases = {guard}, .threads = 1}).out.find("unchanged"), std::string::npos);
    VerifyCase changed = made_up({1.5}, 1.0, 0.0);
    changed.guards = true;
    const CommandOutcome fault = verify({.cases = {changed}, .threads = 1});
    EXPECT_NE(fault.out.find("CHANGED"), std::string::npos);
    EXPECT_EQ(fault.code, k_exit_out_of_bounds);
}

TEST_F(VerifyCommand, AWrongExpectationOfARealCaseFails) {
    VerifyCase wrong = verify_cases().front();
    for (const VerifyCase& one : verify_cases())
        if (one.name == "fourier_transit")
            wrong = one;
    wrong.min_order = 4.0; // it is of order 3
    EXPECT_EQ(verify({.cases = {wrong}, .threads = 1}).code, k_exit_out_of_bounds);
}

TEST_F(VerifyCommand, AStoppedRunLeavesNoFile) {
    const CommandOutcome outcome =
        verify({.cases = {made_up({0.4, 0.1, 0.025}, 1.0, 1.9)}, .threads = 1, .json = in("stopped.json")}, SIGINT);
    EXPECT_EQ(outcome.code, k_exit_signal + SIGINT);
    EXPECT_TRUE(fs::is_empty(folder));
}

TEST(VerifyJudge, AnOrderTakesTheRefinementIntoAccount) {
    VerifyCase one = made_up({0.9, 0.1}, 1.0, 1.9);
    one.sizes = {1, 3};
    VerifiedCase verified{.name = one.name};
    verified.rows.push_back(judge(one, verified, 0, {.error = 0.9, .bound = 1.0}, {}));
    EXPECT_FALSE(verified.rows[0].order);
    const VerifiedRow second = judge(one, verified, 1, {.error = 0.1, .bound = 1.0}, {});
    ASSERT_TRUE(second.order);
    EXPECT_NEAR(*second.order, 2.0, 1e-12);
    EXPECT_TRUE(second.pass);
    const VerifiedRow exact = judge(one, verified, 1, {.error = 0.0, .bound = 1.0}, {});
    EXPECT_FALSE(exact.order);
    EXPECT_TRUE(exact.pass);
}

} // namespace
} // namespace windrow::cli
