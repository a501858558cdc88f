// `windrow plants` as a user meets it: a table, five plots, sentences.
#include "cli/command_line.h"
#include "cli/exit_code.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace windrow::cli {
namespace {

namespace fs = std::filesystem;

struct Outcome {
    int code;
    std::string out, err;
};

Outcome plants(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), {"windrow", "plants"});
    std::ostringstream out, err;
    const int code =
        run_command_line(static_cast<int>(arguments.size()), arguments.data(), {.out = out, .err = err, .progress = nullptr});
    return {code, out.str(), err.str()};
}

TEST(PlantsCommand, WritesItsPlotsAndTellsItsTable) {
    const fs::path folder = fs::temp_directory_path() / ("windrow_plants_" + std::to_string(getpid()));
    const Outcome outcome = plants({"--out", folder.c_str()});
    EXPECT_EQ(outcome.code, k_exit_well);
    EXPECT_EQ(outcome.err, "");
    for (const char* name : {"grass", "wheat", "reed", "leaf", "twig", "branch", "small trunk", "large trunk"})
        EXPECT_NE(outcome.out.find(name), std::string::npos) << name;
    for (const char* name : {"bend.svg", "blades.svg", "shells.svg", "spring.svg", "cascade.svg"}) {
        std::ifstream file(folder / name);
        const std::string text((std::istreambuf_iterator<char>(file)), {});
        EXPECT_TRUE(text.starts_with("<")) << name;
        EXPECT_NE(text.find("</svg>"), std::string::npos) << name;
        EXPECT_EQ(text.find("nan"), std::string::npos) << name;
        EXPECT_EQ(text.find("inf"), std::string::npos) << name;
    }
    fs::remove_all(folder);
}

TEST(PlantsCommand, RefusesAFolderThatTakesNothing) {
    EXPECT_EQ(plants({"--out", ""}).code, k_exit_wrong_use);
    const Outcome outcome = plants({"--out", "/dev/null/plants"});
    EXPECT_EQ(outcome.code, k_exit_wrong_use);
    EXPECT_TRUE(outcome.err.starts_with("windrow: ")) << outcome.err;
}

} // namespace
} // namespace windrow::cli
