// `windrow plants` as a user meets it: a table, curves of five plots, sentences.
#include "cli/console.h"
#include "tests/unit/command_outcome.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <unistd.h>
#include <vector>

namespace windrow::cli {
namespace {

namespace fs = std::filesystem;

Outcome plants(std::vector<const char*> arguments) {
    return run_windrow("plants", std::move(arguments));
}

TEST(PlantsCommand, WritesItsCurvesAndPrintsItsTable) {
    const fs::path folder = fs::temp_directory_path() / ("windrow_plants_" + std::to_string(getpid()));
    const Outcome outcome = plants({"--out", folder.c_str()});
    EXPECT_EQ(outcome.code, k_exit_well);
    EXPECT_EQ(outcome.err, "");
    for (const char* name : {"grass", "wheat", "reed", "leaf", "twig", "branch", "small trunk", "large trunk"})
        EXPECT_NE(outcome.out.find(name), std::string::npos) << name;
    std::ifstream file(folder / "plants.csv");
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    EXPECT_TRUE(text.starts_with("plot,panel,line,x,y\n"));
    for (const char* curve : {"\nbend,,grass,", "\nblades,bent,16,", "\nblades,translated,16,", "\nshells,stems,shell 8,",
                              "\nshells,translated,strand 16,", "\nspring,,15 Hz,", "\ncascade,,200 shells,"})
        EXPECT_NE(text.find(curve), std::string::npos) << curve;
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(text.find("inf"), std::string::npos);
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
