// `windrow bench --backend vulkan` and `windrow check`: flags, figures, exit codes.
#include "cli/bench/vulkan/device_contest.h"
#include "cli/check/check_command.h"
#include "cli/console.h"
#include "tests/parity/gpu.h"
#include "tests/unit/command_outcome.h"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace windrow::cli {

using namespace cases;

namespace {

CommandOutcome command(std::vector<const char*> arguments) {
    return run_windrow(std::move(arguments));
}

void expect_rejection(const std::vector<const char*>& arguments, const std::string& sentence) {
    expect_rejected(command(arguments), sentence);
}

TEST(DeviceCommands, WrongFlagsAreNamed) {
    const std::string device = ": give a device's number in windrow info, from 0.";
    expect_rejection({"bench", "--backend", "gpu"}, "--backend is gpu: give cpu or vulkan.");
    expect_rejection({"bench", "--backend", ""}, "--backend is empty: give cpu or vulkan.");
    expect_rejection({"bench", "--device", "0"},
                     "--device is given, but the air runs on the CPU: add --backend vulkan, or drop it.");
    expect_rejection({"bench", "--backend", "vulkan", "--device", "one"}, "--device is one" + device);
    expect_rejection({"bench", "--backend", "vulkan", "--device", "-1"}, "--device is -1" + device);
    expect_rejection({"bench", "--backend", "vulkan", "--volumes", "4"},
                     "--volumes is given with --backend vulkan, which measures grids: drop one of them.");
    expect_rejection({"check", "--device", ""}, "--device is empty" + device);
    expect_rejection({"check", "--seconds", "-1"}, "--seconds is -1: give a number above 0, at most 3600 s.");
    expect_rejection({"check", "--json", ""}, "--json is empty: name a file.");
}

TEST(DeviceCommands, APlaceWithoutADeviceIsWrongUse) {
    const CommandOutcome outcome = command({"bench", "--backend", "vulkan", "--device", "63"});
    EXPECT_EQ(outcome.code, k_exit_wrong_use);
    EXPECT_TRUE(outcome.err.starts_with("windrow: --device is 63, and this machine has ")) << outcome.err;
}

TEST(DeviceCommands, NoDriverIsTheMachines) {
    ASSERT_EQ(setenv("VK_ICD_FILENAMES", "/none.json", 1), 0); // of older loaders
    ASSERT_EQ(setenv("VK_DRIVER_FILES", "/none.json", 1), 0);
    for (const auto& arguments : {std::vector<const char*>{"bench", "--backend", "vulkan"}, {"check"}}) {
        const CommandOutcome outcome = command(arguments);
        EXPECT_EQ(outcome.code, k_exit_machine);
        EXPECT_NE(outcome.err.find("driver"), std::string::npos) << outcome.err;
    }
    unsetenv("VK_ICD_FILENAMES");
    unsetenv("VK_DRIVER_FILES");
}

TEST(DeviceCommands, FiguresAreToldAndKept) {
    const auto file = std::filesystem::temp_directory_path() / ("windrow_device_" + std::to_string(::getpid()) + ".json");
    const CommandOutcome outcome =
        command({"bench", "--backend", "vulkan", "--grid", "8x6x10", "--seconds", "0.05", "--json", file.c_str()});
    ASSERT_EQ(outcome.code, k_exit_well) << outcome.err;
    for (const char* word : {"8 x 6 x 10", "second_order", "one_substep", "plain stencil", "plain copy", "modes_forward",
                             "between them", "moved by a step", "against the CPU"})
        EXPECT_NE(outcome.out.find(word), std::string::npos) << word << "\n" << outcome.out;
    const nlohmann::json json = nlohmann::json::parse(std::ifstream(file));
    std::filesystem::remove(file);
    ASSERT_EQ(json["entries"].size(), 2);
    for (const nlohmann::json& entry : json["entries"]) {
        EXPECT_EQ(entry["grid"], "8x6x10");
        EXPECT_EQ(entry["backend"], "vulkan");
        for (const char* key : {"dispatches", "barriers", "vs_stencil", "vs_copy16", "cells_per_s", "samples"})
            EXPECT_GT(entry[key], 0) << key;
        EXPECT_GE(entry["step_us"]["median"], entry["step_us"]["min"]);
        EXPECT_GE(entry["step_us"]["p99"], entry["step_us"]["median"]);
        EXPECT_GE(entry["read_back_us"]["median"], 0.0) << "of cells; the report is in the step";
    }
    EXPECT_EQ(json["entries"][0]["dispatches"], 8) << "the default records one sub-step too; its cells are read";
    EXPECT_EQ(json["entries"][1]["dispatches"], 7) << "a step of one sub-step, which reports";
    EXPECT_EQ(json["entries"][1]["barriers"], 7);
    EXPECT_GT(json["entries"][0]["bytes_moved"], 8 * 6 * 10 * 100);
    EXPECT_GT(json["entries"][0]["parity_steps"], 0);
    EXPECT_GT(json["entries"][0]["parity"], 0.0);
    EXPECT_LT(json["entries"][0]["parity"], 1e-4);
    EXPECT_GE(json["passes"].size(), 7u);
    for (const nlohmann::json& pass : json["passes"])
        EXPECT_LE(pass.value("dispatches", 0), 1) << pass << ": of one sub-step, without the empty ones";
    EXPECT_GT(json["references"][0]["stencil_us"]["mean"], 0.0);
}

TEST(DeviceSpread, IsMeanAndNearestRanks) {
    std::vector<float> values;
    for (int n = 1; n <= 200; ++n)
        values.push_back(static_cast<float>(n));
    const DeviceSpread spread = device_spread(values);
    EXPECT_DOUBLE_EQ(spread.mean, 100.5);
    EXPECT_EQ(spread.min, 1.0);
    EXPECT_EQ(spread.median, 100.0);
    EXPECT_EQ(spread.p99, 198.0);
    EXPECT_EQ(spread.samples, 200u);
}

TEST(CheckedStories, OneThatFailsOrOneMessageFailsTheCheck) {
    CheckedStories run;
    EXPECT_FALSE(run.pass()) << "nothing ran";
    run.stories.push_back({.steps = 2, .first = 1e-7, .last = 1e-7, .largest = 1e-7, .first_bound = 1e-5, .bound = 1e-4});
    EXPECT_TRUE(run.pass());
    CheckResult result;
    EXPECT_FALSE(result.pass()) << "nothing ran";
    result.runs = {run};
    EXPECT_TRUE(result.pass());
    result.runs.push_back(run);
    result.runs.back().message_count = 1;
    EXPECT_FALSE(result.pass());
    run.broken.push_back("The story storm: no.");
    EXPECT_FALSE(run.pass());
    run.broken.clear();
    run.stories.back().largest = 1e-3;
    EXPECT_FALSE(run.pass());
}

} // namespace
} // namespace windrow::cli
