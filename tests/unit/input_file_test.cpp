// Files that are no files, and what all files of a scene may cost together.
#include "fluid/files/input_file.h"
#include "tests/cost.h"
#include "tests/own_folder.h"

#include <sys/stat.h>

namespace windrow::detail {
namespace {

namespace fs = std::filesystem;

class InputFile : public testing::Test {
  protected:
    InputFile() {
        fs::create_directories(folder);
        std::ofstream(folder / "plain") << "0123456789";
        std::ofstream(own / "outside") << "secret";
    }

    /// The bytes, or the sentence without the folder.
    [[nodiscard]] std::string read(const std::string& name, std::size_t most = 100) const {
        return test::sentence_of_cheap([&] {
            InputBudget budget;
            const auto bytes = read_input(folder / name, {.folder = folder, .max_bytes = most}, budget);
            return bytes ? *bytes : bytes.error().substr(folder.string().size() + 1);
        });
    }

    const test::OwnFolder own;
    const fs::path folder = own / "inner";
};

TEST_F(InputFile, ARegularFileIsReadToItsBound) {
    EXPECT_EQ(read("plain"), "0123456789");
    EXPECT_EQ(read("plain", 10), "0123456789");
    EXPECT_EQ(read("plain", 9), "plain: is larger than 0 MiB, the most that is read: give a smaller file.");
    fs::create_symlink("plain", folder / "inside");
    EXPECT_EQ(read("inside"), "0123456789");
    EXPECT_EQ(read("none"), "none: no such file: check the name, which is sought beside the file that gives it.");
}

TEST_F(InputFile, ASparseFileCountsWithItsSize) {
    std::ofstream(folder / "sparse") << "P5\n";
    fs::resize_file(folder / "sparse", std::uintmax_t{5} << 30);
    EXPECT_EQ(read("sparse", std::size_t{64} << 20),
              "sparse: is larger than 64 MiB, the most that is read: give a smaller file.");
}

TEST_F(InputFile, WhatIsNoRegularFileIsRejectedAtOnce) {
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(read("pipe"), "pipe: is a pipe or a device: name a regular file.");
    fs::create_directory(folder / "sub");
    EXPECT_EQ(read("sub"), "sub: is a folder: name a file in it.");
    InputBudget budget;
    const auto endless = read_input("/dev/zero", {.max_bytes = 100}, budget);
    ASSERT_FALSE(endless);
    EXPECT_EQ(endless.error(), "/dev/zero: is a pipe or a device: name a regular file.");
}

TEST_F(InputFile, LinksOutOfTheFolderAreRejected) {
    fs::create_symlink("../outside", folder / "link");
    fs::create_symlink("/dev/zero", folder / "zero");
    fs::create_directory_symlink("..", folder / "up");
    for (const char* name : {"link", "zero", "up/outside"})
        EXPECT_EQ(read(name), std::string(name) + ": is a link out of its folder: put the file itself there.");
    // Without a folder to stay in, the user has named the file.
    InputBudget budget;
    EXPECT_TRUE(read_input(folder / "link", {.max_bytes = 100}, budget));
}

// The system gives a size of 0 for them, and more bytes than that.
TEST_F(InputFile, AFileWithoutASizeIsReadToItsEnd) {
    InputBudget budget;
    const auto bytes = read_input("/proc/self/status", {.max_bytes = 1 << 20}, budget);
    ASSERT_TRUE(bytes) << bytes.error();
    EXPECT_NE(bytes->find("Pid:"), std::string::npos);
    EXPECT_FALSE(read_input("/proc/self/status", {.max_bytes = 16}, budget));
}

TEST_F(InputFile, TheBudgetIsOfAllFilesTogether) {
    InputBudget budget;
    EXPECT_TRUE(budget.take_bytes("a", InputBudget::k_max_bytes));
    const auto spent = read_input(folder / "plain", {.max_bytes = 100}, budget);
    ASSERT_FALSE(spent);
    EXPECT_EQ(spent.error(),
              (folder / "plain").string() + ": a scene takes at most 768 MiB of files: give fewer or smaller files.");
    // From then on no file is opened.
    EXPECT_FALSE(read_input(folder / "none", {.max_bytes = 100}, budget));
    InputBudget points;
    EXPECT_FALSE(points.take_points("a", InputBudget::k_max_points + 1));
    EXPECT_FALSE(points.take_file("b"));
}

} // namespace
} // namespace windrow::detail
