// `windrow plants` as a user meets it: a table, curves of five plots, sentences.
#include "cli/console.h"
#include "tests/unit/command_outcome.h"

namespace windrow::cli {
namespace {

using PlantsCommand = test::FolderTest;

CommandOutcome plants(std::vector<const char*> arguments) {
    return run_windrow("plants", std::move(arguments));
}

TEST_F(PlantsCommand, WritesItsCurvesAndPrintsItsTable) {
    const CommandOutcome outcome = plants({"--out", folder.c_str()});
    EXPECT_EQ(outcome.code, k_exit_well);
    EXPECT_EQ(outcome.err, "");
    expect_words(outcome.out, {"grass", "wheat", "reed", "leaf", "twig", "branch", "small trunk", "large trunk"});
    const std::string text = test::text_of(folder / "plants.csv");
    EXPECT_TRUE(text.starts_with("plot,panel,line,x,y\n"));
    expect_words(text, {"\nbend,,grass,", "\nblades,bent,16,", "\nblades,translated,16,", "\nshells,stems,shell 8,",
                        "\nshells,translated,strand 16,", "\nspring,,15 Hz,", "\ncascade,,200 shells,"});
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(text.find("inf"), std::string::npos);
}

TEST_F(PlantsCommand, RejectsAFolderThatTakesNothing) {
    EXPECT_EQ(plants({"--out", ""}).code, k_exit_wrong_use);
    const CommandOutcome outcome = plants({"--out", "/dev/null/plants"});
    EXPECT_EQ(outcome.code, k_exit_wrong_use);
    EXPECT_TRUE(outcome.err.starts_with("windrow: ")) << outcome.err;
}

} // namespace
} // namespace windrow::cli
