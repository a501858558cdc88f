// `windrow pareto` as a user meets it: sentences, table, CSV. Small flows stand for the large ones; nothing here asks how
// fast anything is.
#include "cases/flow_truth.h"
#include "cases/flow_wind.h"
#include "cases/pareto_method.h"
#include "cli/console.h"
#include "cli/pareto/pareto_command.h"
#include "tests/unit/command_outcome.h"

#include <cmath>
#include <csignal>
#include <limits>
#include <map>
#include <set>
#include <sstream>

namespace windrow::cli {

using namespace cases;

namespace {

namespace fs = std::filesystem;

constexpr const char* k_header = "backend,scheme,advection,pressure,grid,cfl,case,error,order,step_ms,cost_vs_stam40,"
                                 "threads,ms_per_second,machine";

CommandOutcome pareto(std::vector<const char*> arguments) {
    return run_windrow("pareto", std::move(arguments));
}

CommandOutcome pareto(const ParetoRequest& request, int signal = 0) {
    return run_request(run_pareto, request, signal);
}

void expect_pareto_rejection(std::vector<const char*> arguments, const std::string& sentence) {
    expect_rejected(pareto(std::move(arguments)), sentence);
}

using test::text_of;

std::vector<std::vector<std::string>> rows_of(const fs::path& file) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream text(text_of(file));
    for (std::string line; std::getline(text, line);) {
        rows.emplace_back();
        std::istringstream cells(line + ",");
        for (std::string cell; std::getline(cells, cell, ',');)
            rows.back().push_back(cell);
    }
    return rows;
}

/// Two flows of the command, the exact one and the motor's, on grids that take no time.
std::vector<ParetoFlow> small_flows() {
    std::vector<ParetoFlow> flows;
    for (ParetoFlow& flow : pareto_flows(false)) {
        if (flow.name == "taylor_green_2d")
            flow.grids = {{8, 1, 8}, {16, 1, 16}};
        else if (flow.name == "jet") {
            flow.grids = {{6, 3, 6}, {12, 6, 12}};
            flow.reference = {16, 8, 16};
        } else
            continue;
        flows.push_back(std::move(flow));
    }
    return flows;
}

class ParetoCommand : public test::FolderTest {
  protected:
    [[nodiscard]] ParetoRequest small(const char* out, int threads = 2) const {
        return {.flows = small_flows(), .cfls = {1.0, 2.0}, .seconds = 0.001, .threads = threads, .out = folder / out};
    }
};

// --- Flags -----------------------------------------------------------------------------------------------------------

TEST_F(ParetoCommand, WrongFlagsAreNamed) {
    expect_pareto_rejection({"--threads", "0"}, "--threads is 0: give a whole number from 1 to 256.");
    expect_pareto_rejection({"--simd", "sse"}, "--simd is sse: give best, baseline, avx2 or avx512.");
    expect_pareto_rejection({"--flow", "jets"}, "--flow is jets, which is none (did you mean jet?): see windrow pareto --help.");
    expect_pareto_rejection({"--out", ""}, "--out is empty: name a folder.");
    expect_pareto_rejection({"--qick"}, "unknown option --qick (did you mean --quick?): see windrow pareto --help.");
}

TEST_F(ParetoCommand, AFolderThatCannotBeWrittenIsRejectedBeforeAnythingRuns) {
    const std::string file = (folder / "file").string();
    std::ofstream(file) << "x";
    expect_pareto_rejection({"--out", file.c_str()},
                            file + ": is a file where a folder is needed: remove it, or give another folder with --out.");
}

TEST_F(ParetoCommand, PartsJoinToOneTableInTheOrderOfTheFlows) {
    ParetoRequest one = small("one"), two = small("two"), whole = small("whole");
    one.flows.erase(one.flows.begin());
    two.flows.erase(two.flows.begin() + 1);
    ASSERT_EQ(pareto(one).code, k_exit_well);
    ASSERT_EQ(pareto(two).code, k_exit_well);
    whole.join = {one.out, two.out};
    const auto join = [](const ParetoRequest& request) {
        std::ostringstream out, err;
        const int code = join_pareto(request, {.out = out, .err = err, .progress = nullptr});
        return CommandOutcome{code, out.str(), err.str()};
    };
    EXPECT_EQ(join(whole).code, k_exit_well);
    const std::string first = text_of(two.out / "pareto.csv"), second = text_of(one.out / "pareto.csv");
    EXPECT_EQ(text_of(whole.out / "pareto.csv"), first + second.substr(second.find('\n') + 1));
    whole.join = {one.out, one.out};
    const std::string file = (one.out / "pareto.csv").string();
    expect_rejected(join(whole), file + ": has the flow jet, as " + file + " has: give each part once.");
    whole.join = {one.out};
    expect_rejected(join(whole),
                    "--join has no folder with the flow taylor_green_2d: run its part, or name the flows with --flow.");
    std::ofstream(one.out / "pareto.csv") << "x\n";
    expect_rejected(join(whole), file + ": is not what windrow pareto writes: give the folders of the parts.");
    expect_pareto_rejection({"--join", "a", "--part", "1/2"}, "--join is given with --part: it runs nothing, drop one of them.");
}

// --- What is compared ------------------------------------------------------------------------------------------------

TEST(ParetoMethods, AreAllOfThemAndTheDefaultIsWhatAWindDoes) {
    std::set<std::string> names;
    for (const Method& method : pareto_methods(Solves::all))
        names.insert(name_of(method));
    EXPECT_EQ(names.size(), 20u);
    EXPECT_EQ(k_default_method.scheme, Config{}.scheme);
    EXPECT_EQ(k_default_method.interpolation, Config{}.interpolation);
    EXPECT_TRUE(names.contains(name_of(k_default_method)));
}

TEST(ParetoFlows, AreWhole) {
    const std::string script = text_of(fs::path(WINDROW_SOURCE_DIR) / "tools" / "plots.py");
    for (const bool quick : {false, true}) {
        int in_three_dimensions = 0;
        std::set<std::string> names;
        for (const ParetoFlow& flow : pareto_flows(quick)) {
            names.insert(flow.name);
            in_three_dimensions += flow.grids.front().y > 1 ? 1 : 0;
            EXPECT_GE(flow.grids.size(), 2u) << flow.name;
            EXPECT_FALSE(flow.what.empty()) << flow.name;
            EXPECT_NE(script.find("\"" + flow.name + "\": "), std::string::npos) << flow.name << " has no title over its panel";
            for (const glm::ivec3 cells : flow.grids) {
                EXPECT_TRUE(validate(box_of(flow, cells))) << flow.name;
                for (const double cfl : {0.5, 1.0, 4.0}) {
                    const int steps = steps_of(flow, cells, cfl);
                    const double crossed = flow.top_speed * flow.end / steps / box_of(flow, cells).cell_size;
                    EXPECT_EQ(steps % 2, 0);
                    EXPECT_LE(crossed, 1.0001 * cfl) << flow.name;
                }
            }
            if (flow.exact)
                continue;
            // Finer by as much along each axis.
            EXPECT_EQ(flow.reference.x % flow.grids.back().x, 0) << flow.name;
            EXPECT_GE(flow.reference.x, 2 * flow.grids.back().x) << flow.name;
            if (flow.grids.back().y > 1) {
                EXPECT_EQ(flow.reference.y * flow.grids.back().x, flow.reference.x * flow.grids.back().y) << flow.name;
            }
        }
        EXPECT_EQ(names.size(), quick ? 4u : 6u);
        EXPECT_GE(in_three_dimensions, 2);
    }
}

TEST(ParetoFlows, AnExactFlowBeginsWhereItShould) {
    for (ParetoFlow flow : pareto_flows(false)) {
        if (!flow.exact)
            continue;
        // At a time of 0 the start is the end; nothing of that is built into the flow, so the error of a short run tells.
        const glm::ivec3 cells = flow.grids.front();
        auto wind = FlowWind::create(flow, cells, {});
        ASSERT_TRUE(wind);
        const auto truth = FlowTruth::find(flow, Simd::best, {}, [] { return false; });
        ASSERT_TRUE(truth && *truth);
        const auto end = (*truth)->at_centres(cells);
        EXPECT_GT(flow_error(wind->field(), end), 0.3) << flow.name << " moves";
        const int steps = steps_of(flow, cells, 1.0);
        for (int n = 0; n < steps; ++n)
            wind->step(flow.end / steps);
        EXPECT_LT(flow_error(wind->field(), end), 0.03) << flow.name;
    }
}

TEST(ParetoFlows, AReferenceIsReadWhereItLies) {
    ParetoFlow flow = small_flows().back();
    const auto never = [] { return false; };
    const auto truth = FlowTruth::find(flow, Simd::best, {}, never);
    ASSERT_TRUE(truth && *truth);
    auto wind = FlowWind::create(flow, flow.reference, {});
    ASSERT_TRUE(wind);
    const int steps = steps_of(flow, flow.reference, 1.0);
    for (int n = 0; n < steps; ++n)
        wind->step(flow.end / steps);
    EXPECT_LT(flow_error(wind->field(), (*truth)->at_centres(flow.reference)), 1e-6);
    EXPECT_FALSE(*FlowTruth::find(flow, Simd::best, {}, [] { return true; }));
}

// `windrow pareto` measures all methods with one wind: what it ran before leaves no trace.
TEST(ParetoFlows, AMethodAfterOthersIsThatOfAFreshWind) {
    const ParetoFlow flow = small_flows().front();
    ASSERT_TRUE(flow.start && flow.motors.empty());
    const auto end_of = [&](FlowWind& wind) {
        for (int n = 0; n < 3; ++n)
            wind.step(flow.end / steps_of(flow, {16, 1, 16}, 1.0));
        return std::vector(wind.field().begin(), wind.field().end());
    };
    const std::vector<Method> methods = pareto_methods(Solves::all);
    auto used = FlowWind::create(flow, {16, 1, 16}, {.method = methods.back()});
    ASSERT_TRUE(used);
    std::vector<glm::vec4> last = end_of(*used);
    for (const Method& method : methods) {
        used->set_method(method);
        used->begin();
        auto fresh = FlowWind::create(flow, {16, 1, 16}, {.method = method});
        ASSERT_TRUE(fresh);
        const std::vector<glm::vec4> expected = end_of(*fresh);
        EXPECT_NE(std::exchange(last, expected), expected) << "no method before had this air";
        EXPECT_EQ(end_of(*used), expected) << name_of(method);
    }
}

// --- Results ---------------------------------------------------------------------------------------------------------

TEST_F(ParetoCommand, FiguresAreToldAndKept) {
    const CommandOutcome outcome = pareto(small("run"));
    ASSERT_EQ(outcome.code, k_exit_well) << outcome.out << outcome.err;
    expect_words(outcome.out,
                 {"taylor_green_2d", "jet", "ms/s of flow", "front of 80 runs", "the default, second_order cubic direct",
                  "on the front on 8x1x8: ", "on the front on 12x6x12: ", "pareto.csv"});

    const fs::path out = folder / "run";
    const auto rows = rows_of(out / "pareto.csv");
    ASSERT_EQ(rows.size(), 1u + 2u * 2u * 20u * 2u * 2u); // flows, grids, methods, CFLs, threads
    EXPECT_EQ(text_of(out / "pareto.csv").substr(0, std::string(k_header).size() + 1), std::string(k_header) + "\n");
    std::set<std::string> keys;
    std::map<std::string, std::string> errors; // by all but the threads
    for (std::size_t n = 1; n < rows.size(); ++n) {
        const auto& row = rows[n];
        ASSERT_GE(row.size(), 14u); // the machine is quoted and may hold commas
        EXPECT_EQ(row[0], "cpu");
        std::string key;
        for (int column = 1; column < 7; ++column)
            key += row[column] + " ";
        EXPECT_TRUE(keys.insert(key + row[11]).second) << key;
        EXPECT_EQ(errors.emplace(key, row[7]).first->second, row[7]) << "errors do not depend on the threads";
        EXPECT_GT(std::stod(row[7]), 0.0) << key;
        const bool coarsest = row[4] == "8x1x8" || row[4] == "6x3x6";
        EXPECT_EQ(row[8].empty(), coarsest) << key;
        EXPECT_GT(std::stod(row[9]), 0.0) << key;
        EXPECT_GT(std::stod(row[10]), 0.0) << key;
        EXPECT_TRUE(row[11] == "1" || row[11] == "2");
        EXPECT_GT(std::stod(row[12]), 0.0) << key;
    }
    // An order is that of the errors beside it.
    const auto error_at = [&](const std::string& grid) {
        return std::stod(errors.at("second_order cubic direct " + grid + " 1 taylor_green_2d "));
    };
    std::size_t orders = 0;
    for (const auto& row : rows) {
        if (row[1] != "second_order" || row[2] != "cubic" || row[3] != "direct" || row[4] != "16x1x16" || row[5] != "1")
            continue;
        EXPECT_NEAR(std::stod(row[8]), std::log2(error_at("8x1x8") / error_at("16x1x16")), 1e-4);
        ++orders;
    }
    EXPECT_EQ(orders, 2u);

    std::set<std::string> files;
    for (const auto& entry : fs::directory_iterator(out))
        files.insert(entry.path().filename().string());
    EXPECT_EQ(files, std::set<std::string>({"pareto.csv"}));
}

TEST_F(ParetoCommand, OneThreadIsMeasuredOnce) {
    ParetoRequest request = small("one", 1);
    request.flows.pop_back();
    ASSERT_EQ(pareto(request).code, k_exit_well);
    EXPECT_EQ(rows_of(folder / "one" / "pareto.csv").size(), 1u + 2u * 20u * 2u);
}

TEST_F(ParetoCommand, ABrokenFlowIsTold) {
    ParetoRequest request = small("broken", 1);
    request.flows.pop_back();
    request.flows.front().exact = [](glm::dvec3) { return glm::dvec3(std::numeric_limits<double>::quiet_NaN()); };
    const CommandOutcome outcome = pareto(request);
    EXPECT_EQ(outcome.code, k_exit_out_of_bounds);
    EXPECT_EQ(outcome.err, "windrow: the default method broke on taylor_green_2d: its error is not finite.\n");
    const auto rows = rows_of(folder / "broken" / "pareto.csv");
    ASSERT_GT(rows.size(), 1u);
    EXPECT_FALSE(std::isfinite(std::stod(rows[1][7])));
    EXPECT_EQ(rows.back()[8], "") << "no order between what is not finite";
}

// Around obstacles the classic step has whole cells, and is far from the truth where ours is near.
TEST_F(ParetoCommand, AroundObstaclesTheClassicStepHasWholeCells) {
    ParetoRequest request = small("house", 1);
    request.flows = {pareto_flows(false).back()};
    ParetoFlow& flow = request.flows.front();
    ASSERT_FALSE(flow.obstacles.empty());
    flow.grids = {{16, 8, 16}, {32, 16, 32}};
    flow.reference = {64, 32, 64};
    flow.end = 0.5;
    const CommandOutcome outcome = pareto(request);
    ASSERT_EQ(outcome.code, k_exit_well) << outcome.err;
    std::map<std::string, double> errors;
    for (const auto& row : rows_of(folder / "house" / "pareto.csv"))
        if (row[4] == "32x16x32" && row[5] == "1")
            errors[row[1] + " " + row[2] + " " + row[3]] = std::stod(row[7]);
    EXPECT_EQ(errors.size(), 7u);
    EXPECT_LT(2.0 * errors.at("second_order cubic direct"), errors.at("stable_fluids linear jacobi40"));
    EXPECT_LT(errors.at("second_order cubic direct"), 0.3);
    EXPECT_LT(errors.at("stable_fluids linear jacobi80"), errors.at("stable_fluids linear jacobi20"));
}

// Gusts, a profile and a motor that moves: by the direct solve alone.
TEST_F(ParetoCommand, AGustyFlowIsRunByWinds) {
    ParetoRequest request = small("gusty");
    const std::vector<ParetoFlow> flows = pareto_flows(false);
    const auto gusty = std::find_if(flows.begin(), flows.end(), [](const ParetoFlow& each) { return each.needs_wind(); });
    ASSERT_NE(gusty, flows.end());
    request.flows = {*gusty};
    ParetoFlow& flow = request.flows.front();
    flow.grids = {{12, 6, 12}, {24, 12, 24}};
    flow.reference = {48, 24, 48};
    const CommandOutcome outcome = pareto(request);
    ASSERT_EQ(outcome.code, k_exit_well) << outcome.out << outcome.err;
    const auto rows = rows_of(folder / "gusty" / "pareto.csv");
    ASSERT_EQ(rows.size(), 1u + 2u * 4u * 2u * 2u); // grids, methods, CFLs, threads
    for (std::size_t n = 1; n < rows.size(); ++n) {
        EXPECT_EQ(rows[n][3], "direct");
        const double error = std::stod(rows[n][7]);
        EXPECT_TRUE(error > 0.01 && error < 0.9) << error; // of 1: the fan was left out
        if (!rows[n][8].empty()) {
            EXPECT_GT(std::stod(rows[n][8]), 0.3) << n;
        }
    }
}

TEST_F(ParetoCommand, AStoppedRunLeavesNoFile) {
    EXPECT_EQ(pareto(small("stopped"), SIGINT).code, k_exit_signal + SIGINT);
    EXPECT_TRUE(fs::is_empty(folder / "stopped"));
}

} // namespace
} // namespace windrow::cli
