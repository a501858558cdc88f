// `windrow device-report`: flags, files, figures, exit codes.
#include "cli/device_report/device_report_command.h"
#include "cli/device_report/report_section.h"
#include "tests/parity/gpu.h"
#include "tests/tier.h"
#include "tests/unit/command_outcome.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <set>

namespace windrow::cli {
namespace {

namespace fs = std::filesystem;

class DeviceReport : public testing::Test {
  protected:
    [[nodiscard]] CommandOutcome report(std::vector<const char*> arguments) const {
        arguments.insert(arguments.begin(), {"device-report", "--out", out.c_str()});
        return run_windrow(std::move(arguments));
    }
    [[nodiscard]] nlohmann::json json() const { return json_in(out / "report.json"); }

    const test::OwnFolder folder;
    const fs::path out = folder / "report";
};

void expect_spread(const nlohmann::json& us) {
    EXPECT_GT(us["samples"], 0) << us;
    EXPECT_GE(us["median"], 0.0) << us;
    EXPECT_GE(us["p99"], us["median"]) << us;
}

void expect_costs(const nlohmann::json& costs) {
    EXPECT_EQ(costs["commands"].size(), 9u);
    for (const nlohmann::json& row : costs["commands"])
        expect_spread(row["us"]);
    ASSERT_FALSE(costs["bandwidth"].empty());
    EXPECT_EQ(costs["bandwidth"][0]["footprint_KiB"], 64);
    EXPECT_GT(costs["bandwidth"][0]["GB_per_s"], 0.0);
}

// The read-back is apart from the step, and the passes are those of one sub-step.
void expect_times(const nlohmann::json& times) {
    const auto of_first_grid = [&](const nlohmann::json& row) { return row["grid"] == "32x16x32"; };
    ASSERT_EQ(std::ranges::count_if(times["steps"], of_first_grid), 12); // a GPU may have time for larger ones
    for (const nlohmann::json& row : times["steps"]) {
        if (row.contains("left_out"))
            continue;
        expect_spread(row["us"]);
        EXPECT_GT(row["read_back_us"]["median"], 0.0) << row;
        EXPECT_EQ(row["substeps"], row["recording"] == "step, eight of eight" ? 8 : 1) << row;
        EXPECT_GT(row["dispatches"], 0) << row;
    }
    EXPECT_EQ(times["steps"][0]["recording"], "step, one sub-step");
    EXPECT_GT(times["steps"][0]["copy_floor_us"], 0.0);
    for (const nlohmann::json& pass : times["passes"])
        EXPECT_LE(pass["dispatches"].is_number() ? pass["dispatches"].get<int>() : 0, 1) << pass;
}

// The first four stories have both texels, both divisions of planes, and one to three frames in flight.
void expect_parity(const nlohmann::json& parity) {
    EXPECT_TRUE(parity["pass"]);
    EXPECT_EQ(parity["ran"], parity["stories"].size());
    std::set<std::string> texels, planes, frames;
    for (const nlohmann::json& row : parity["stories"]) {
        EXPECT_LE(row["largest"], row["bound"]) << row;
        EXPECT_GE(row["steps"], 2) << row;
        texels.insert(row["texel"]);
        planes.insert(row["planes"]);
        frames.insert(row["frames_in_flight"].dump());
    }
    EXPECT_EQ(texels.size(), 2u);
    EXPECT_EQ(planes.size(), 2u);
    EXPECT_EQ(frames.size(), 3u);
}

TEST_F(DeviceReport, WrongFlagsAreNamed) {
    const auto rejects = [](std::vector<const char*> arguments, const std::string& sentence) {
        arguments.insert(arguments.begin(), "device-report");
        expect_rejected(run_windrow(std::move(arguments)), sentence);
    };
    rejects({}, "--out is missing: name a folder for the report.");
    rejects({"--out", ""}, "--out is empty: name a folder.");
    rejects({"--out", "x", "--seconds", "0"}, "--seconds is 0: give a number above 0, at most 3600 s.");
    rejects({"--out", "x", "--device", "first"}, "--device is first: give a device's number in windrow info, from 0.");
    const CommandOutcome unknown = report({"--only", "speed"});
    EXPECT_EQ(unknown.code, k_exit_wrong_use);
    EXPECT_TRUE(unknown.err.starts_with("windrow: --only is speed: give facts, costs, times")) << unknown.err;
    EXPECT_FALSE(fs::exists(out)) << "nothing was begun";
}

TEST_F(DeviceReport, AFileInThePlaceOfTheFolderIsNamed) {
    std::ofstream(out) << "mine";
    const CommandOutcome outcome = report({"--only", "facts"});
    EXPECT_EQ(outcome.code, k_exit_wrong_use);
    EXPECT_NE(outcome.err.find("is a file where a folder is needed"), std::string::npos) << outcome.err;
}

TEST_F(DeviceReport, NoDriverIsTheMachinesAndKeptInTheFile) {
    ASSERT_EQ(setenv("VK_ICD_FILENAMES", "/none.json", 1), 0); // of older loaders
    ASSERT_EQ(setenv("VK_DRIVER_FILES", "/none.json", 1), 0);
    const CommandOutcome outcome = report({"--quick"});
    unsetenv("VK_ICD_FILENAMES");
    unsetenv("VK_DRIVER_FILES");
    EXPECT_EQ(outcome.code, k_exit_machine);
    EXPECT_NE(outcome.err.find("driver"), std::string::npos) << outcome.err;
    const nlohmann::json found = json();
    EXPECT_FALSE(found["complete"]);
    EXPECT_NE(found["error"].get<std::string>().find("driver"), std::string::npos);
    std::map<std::string, std::string> tried;
    for (const nlohmann::json& row : found["places_tried"])
        tried[row["place"]] = row["holds"];
    EXPECT_EQ(tried["VK_DRIVER_FILES"], "/none.json");
    EXPECT_TRUE(tried.contains("libvulkan.so.1"));
    EXPECT_TRUE(tried.contains("/usr/share/vulkan/icd.d"));
    expect_words(outcome.out, {"libvulkan.so.1", "VK_DRIVER_FILES", "/none.json", "/etc/vulkan/icd.d"});
}

TEST_F(DeviceReport, ARunThatIsCutKeepsTheSectionsBeforeIt) {
    DeviceReportRequest request{.out = out, .quick = true, .seconds = 20.0};
    std::ostringstream text, errors;
    int asked = 0;
    const int code = run_device_report(request, {.out = text, .err = errors, .progress = nullptr},
                                       [&] { return ++asked > 40 ? SIGTERM : 0; }); // within the costs
    EXPECT_EQ(code, k_exit_signal + SIGTERM);
    const nlohmann::json found = json();
    EXPECT_FALSE(found["complete"]);
    EXPECT_TRUE(found["sections"]["facts"].contains("device"));
    EXPECT_TRUE(found["sections"].contains("costs"));
    EXPECT_FALSE(found["sections"].contains("times"));
    EXPECT_FALSE(fs::exists(out / "report.md"));
    for (const fs::directory_entry& file : fs::directory_iterator(out))
        EXPECT_EQ(file.path().filename(), "report.json") << "no part is left";
}

// All sections in whole sweeps, in the time of a software device.
TEST_F(DeviceReport, AQuickReportHasItsFigures) {
    // Half a minute of a software device goes to times, stories and pictures. The bench and Stories have the first two.
    const bool whole = test::whole_sweeps();
    std::vector<const char*> arguments{"--quick", "--seconds", whole ? "40" : "10"};
    if (!whole)
        arguments.insert(arguments.end(), {"--only", "costs", "queries", "meadow"});
    const CommandOutcome outcome = report(arguments);
    ASSERT_EQ(outcome.code, k_exit_well) << outcome.err << outcome.out;
    const nlohmann::json found = json();
    EXPECT_TRUE(found["complete"]);
    const nlohmann::json& sections = found["sections"];
    for (const char* key : {"device", "driver", "vulkan", "type", "limits", "queue_families", "memory_heaps", "extensions",
                            "clocks", "subgroup_size", "places_tried"})
        EXPECT_TRUE(sections["facts"].contains(key)) << key;
    expect_costs(sections["costs"]);
    if (whole) {
        expect_times(sections["times"]);
        expect_parity(sections["parity"]);
        ASSERT_EQ(sections["pictures"]["pictures"].size(), 3u);
        for (const nlohmann::json& row : sections["pictures"]["pictures"]) {
            const fs::path file = out / row["file"].get<std::string>();
            EXPECT_GT(fs::file_size(file), 100'000u) << file << ": nothing but an even ground";
        }
    }
    ASSERT_EQ(sections["queries"]["queries"].size(), 4u);
    for (const nlohmann::json& row : sections["queries"]["queries"]) {
        EXPECT_TRUE(row["pass"]) << row;
        EXPECT_GT(row["largest"], 0.1) << row;
    }
    ASSERT_TRUE(sections["meadow"].contains("frames")) << sections["meadow"];
    EXPECT_EQ(sections["meadow"]["frames"].size(), 3u);
    for (const nlohmann::json& row : sections["meadow"]["frames"]) // what the time did not allow is in the table and in words
        EXPECT_TRUE(row.contains("left_out") ? !sections["meadow"]["left_out"].empty() : row["ns_per_blade"] > 0.0) << row;
    std::set<std::string> stages;
    for (const nlohmann::json& row : sections["meadow"]["stages"]) {
        expect_spread(row["us"]);
        stages.insert(row["stage"]);
    }
    for (const char* name : {"prepare", "shadow", "colour", "tone"})
        EXPECT_TRUE(stages.contains(name)) << name;
    std::ifstream page(out / "report.md");
    const std::string text{std::istreambuf_iterator<char>(page), {}};
    expect_words(text, {"# A device", "## costs", "| launch and barrier |"});
    if (whole)
        expect_words(text, {"## For a README", "| step, one sub-step |"});
}

// Mesa's compiler for AMD runs without a device. It is in mesa-vulkan-drivers, as the software driver of the other tests.
TEST_F(DeviceReport, PipelinesAreCompiledForADeviceThatIsNotThere) {
    const char* const driver = "/usr/share/vulkan/icd.d/radeon_icd.x86_64.json";
    if (!fs::exists(driver))
        GTEST_SKIP() << driver << " is not installed";
    if (test::k_sanitized)
        GTEST_SKIP() << "the driver's threads leave 256 bytes behind, which a leak check counts";
    ASSERT_EQ(setenv("VK_DRIVER_FILES", driver, 1), 0);
    ASSERT_EQ(setenv("RADV_FORCE_FAMILY", "gfx1100", 1), 0);
    const CommandOutcome outcome = report({"--only", "pipelines"});
    unsetenv("VK_DRIVER_FILES");
    unsetenv("RADV_FORCE_FAMILY");
    ASSERT_EQ(outcome.code, k_exit_well) << outcome.err;
    const nlohmann::json rows = json()["sections"]["pipelines"]["pipelines"];
    std::map<std::string, int> grids, instructions;
    for (const nlohmann::json& row : rows) {
        ++grids[row["grid"]];
        for (const char* key : {"SGPRs", "VGPRs", "Code size", "Instructions"})
            EXPECT_GT(row[key], 0) << row;
        EXPECT_EQ(row["Spilled VGPRs"], 0) << row;
        instructions[row["pipeline"]] = row["Instructions"];
    }
    EXPECT_EQ(grids.size(), 6u) << "three grids, obstacles on rough ground, the same in rows, and the ground memory";
    EXPECT_LT(instructions["sample, equal rows"], 270 + instructions["the same shader without it"]) << "as docs/vulkan.md states";
    EXPECT_GT(instructions["sample"], instructions["sample, equal rows"]) << "it finds the row";
    EXPECT_GE(grids["128x64x128"], 10);
    EXPECT_EQ(grids["32x16x32"], grids["128x64x128"]);
}

// A grid that time or memory did not allow has its row, in the section and for a README.
TEST(ReportText, WhatIsLeftOutHasARow) {
    const char* const step = "step, one sub-step";
    ReportJson report = {{"sections", {{"facts", {{"device", "a device"}}}}}};
    ReportJson& times = report["sections"]["times"];
    times["steps"].push_back({{"recording", step},
                              {"grid", "8x8x8"},
                              {"us", {{"median", 2.0}, {"p99", 3.0}}},
                              {"read_back_us", {{"median", 1.0}}},
                              {"copy_floor_us", 0.5}});
    times["steps"].push_back({{"recording", step}, {"grid", "16x16x16"}, {"left_out", "left out: memory"}});
    expect_words(readme_table(report), {"| 8x8x8 | 2 | 3 | 1 | 0.5 |", "| 16x16x16 | left out: memory | - | - | - |"});
    expect_words(section_text(times), {"16x16x16  left out: memory"});
}

TEST(ReportText, TablesTakeTheirColumnsFromTheFirstRow) {
    const ReportJson section = {
        {"seconds", 1.5},
        {"rows", {{{"name", "a"}, {"us", {{"median", 2.0}}}}, {{"name", "long"}, {"us", {{"median", nullptr}}}}}},
        {"left_out", {"b: no time."}}};
    EXPECT_EQ(section_text(section), "  seconds: 1.5\n"
                                     "  name  us median\n"
                                     "  a             2\n"
                                     "  long          -\n"
                                     "  left_out: b: no time.\n");
    EXPECT_EQ(four_digits(123456.0), 123500.0);
    EXPECT_EQ(four_digits(0.0), 0.0);
}

} // namespace
} // namespace windrow::cli
