// A file has its name only when it is complete, whoever else writes it and whoever dies meanwhile.
#include "fluid/files/new_file.h"
#include "tests/own_folder.h"

#include <cerrno>
#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

namespace windrow {
namespace {

namespace fs = std::filesystem;
using detail::NewFile;

using NewFiles = test::FolderTest;

using test::text_of;

// Runs `work` in a process of its own.
template <class Work>
pid_t in_a_process(const Work& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        work();
        ::_exit(0);
    }
    return child;
}

int status_of(pid_t child) {
    int status = -1;
    ::waitpid(child, &status, 0);
    return status;
}

// With one part file for both, most readings are mixed or short.
TEST_F(NewFiles, ThatTwoProcessesWriteAreAlwaysComplete) {
    const fs::path file = folder / "shared";
    constexpr int k_writes = 500; // of each
    constexpr std::size_t k_bytes = 200'000;
    ASSERT_TRUE(detail::write_file("file", file, std::string(k_bytes, 'a')));
    for (const char letter : {'a', 'b'})
        in_a_process([&] {
            const std::string bytes(k_bytes, letter);
            for (int n = 0; n < k_writes; ++n)
                if (!detail::write_file("file", file, bytes))
                    ::_exit(1);
        });
    int readings = 0, broken = 0, running = 2;
    while (running > 0) {
        const std::string text = text_of(file);
        ++readings;
        if (text.size() != k_bytes || text.find_first_not_of(text.front()) != std::string::npos)
            ++broken;
        int status = 0;
        while (running > 0 && ::waitpid(-1, &status, WNOHANG) > 0) {
            EXPECT_EQ(status, 0);
            --running;
        }
    }
    EXPECT_EQ(broken, 0) << "of " << readings;
    EXPECT_GT(readings, 20);
    EXPECT_EQ(entries(), 1);
}

TEST_F(NewFiles, PartsOfTheDeadAreClearedAndThoseOfTheLivingStay) {
    const pid_t dead = in_a_process([&] {
        NewFile file(folder / "left");
        (void)file.write("half");
        ::raise(SIGKILL);
    });
    EXPECT_EQ(WTERMSIG(status_of(dead)), SIGKILL);
    std::ofstream(folder / "a user's.part") << "mine";
    EXPECT_EQ(entries(), 2);
    NewFile living(folder / "living");
    EXPECT_EQ(entries(), 3);
    detail::clear_dead_parts(folder);
    EXPECT_EQ(entries(), 2);
    EXPECT_EQ(status_of(in_a_process([&] { detail::clear_dead_parts(folder); })), 0);
    EXPECT_EQ(entries(), 2);
    EXPECT_TRUE(living.write("whole") && living.publish());
    EXPECT_EQ(text_of(folder / "living"), "whole");
    detail::clear_dead_parts(folder / "missing"); // nothing to do
}

TEST_F(NewFiles, ADroppedOneLeavesNothing) {
    std::ofstream(folder / "name") << "old";
    {
        NewFile file(folder / "name");
        EXPECT_TRUE(file.write("new"));
        EXPECT_EQ(entries(), 2);
    }
    EXPECT_EQ(entries(), 1);
    EXPECT_EQ(text_of(folder / "name"), "old");
}

TEST_F(NewFiles, ALinkStaysAndWhatItLeadsToIsWritten) {
    std::ofstream(folder / "target") << "old";
    fs::create_symlink("target", folder / "link");
    ASSERT_TRUE(detail::write_file("file", folder / "link", "new"));
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(text_of(folder / "target"), "new");
}

TEST_F(NewFiles, NamesMayBeAsLongAsTheSystemAllows) {
    std::string name(255, 'n');
    EXPECT_TRUE(detail::write_file("file", folder / name, "x"));
    name += 'n';
    EXPECT_EQ(NewFile(folder / name).error(), ENAMETOOLONG);
    EXPECT_EQ(entries(), 1);
}

TEST_F(NewFiles, WhatIsNoRegularFileIsRejected) {
    EXPECT_EQ(NewFile("/dev/null").error(), ENXIO);
    EXPECT_EQ(NewFile(folder).error(), EISDIR);
    EXPECT_EQ(NewFile(folder / "missing" / "name").error(), ENOENT);
    const auto written = detail::write_file("table", "/dev/null", "x");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error(),
              "table /dev/null cannot be written (not a regular file); name a file in a folder that you may write "
              "to, on a disk with room.");
}

} // namespace
} // namespace windrow
