// What the export does when the disk is full, the folder is wrong or others write: nothing is lost and nothing is left behind.

#include "fluid/vdb/vdb_export.h"
#include "tests/unit/counted_new.h"
#include "tests/unit/vdb_fixture.h"

#include <array>
#include <cstdint>
#include <sched.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace windrow;
using namespace windrow::vdb_test;
using vdb::Problem;

TEST(VdbDisk, WhereverTheDiskEndsTheOldFileStays) {
    const OwnFolder folder;
    const fs::path file = folder / "wind.vdb";
    std::ofstream(file) << "precious";
    const WindBox air = random_air({32, 16, 24});
    ASSERT_TRUE(vdb::write(air.grid(), folder / "whole.vdb"));
    const std::uintmax_t whole = fs::file_size(folder / "whole.vdb");
    ASSERT_GT(whole, 100'000u); // Several flushes of the buffer.

    // Every 1009th byte, and the last one, which only the flush before the rename meets.
    int failures = 0;
    for (std::uintmax_t bytes = 0; bytes < whole; bytes = bytes + 1009 < whole || bytes == whole - 1 ? bytes + 1009 : whole - 1) {
        vdb::WriteResult written;
        {
            const test::FileSizeLimit limit(bytes);
            written = vdb::write(air.grid(), file);
        }
        ++failures;
        ASSERT_EQ(written.problem(), Problem::disk_full) << bytes << ": " << written.error();
        ASSERT_NE(written.error().find("wind.vdb: File too large"), std::string::npos) << written.error();
        ASSERT_EQ(text_of(file), "precious") << bytes;
        ASSERT_EQ(folder.entries(), 2) << bytes;
    }
    EXPECT_GT(failures, 100);

    const test::FileSizeLimit limit(whole);
    EXPECT_TRUE(vdb::write(air.grid(), file));
    EXPECT_EQ(fs::file_size(file), whole);
}

TEST(VdbDisk, AFullDiskSaysSo) {
    const WindBox air = random_air({32, 16, 32});
    bool mounted = false;
    // A thread of its own may see a small disk that nobody else sees and that ends with it.
    std::thread([&] {
        const OwnFolder folder;
        if (::unshare(CLONE_FS | CLONE_NEWNS) != 0 || ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
            ::mount("tmpfs", folder.path().c_str(), "tmpfs", 0, "size=64k") != 0)
            return;
        mounted = true;
        std::ofstream(folder / "wind.vdb") << "precious";
        const vdb::WriteResult written = vdb::write(air.grid(), folder / "wind.vdb");
        EXPECT_EQ(written.problem(), Problem::disk_full);
        EXPECT_NE(written.error().find("wind.vdb: No space left on device"), std::string::npos) << written.error();
        EXPECT_EQ(text_of(folder / "wind.vdb"), "precious");
        EXPECT_EQ(folder.entries(), 1);
        EXPECT_TRUE(vdb::write(uniform_air({4, 4, 4}, glm::vec3(1.0f)).grid(), folder / "wind.vdb"));
        ::umount(folder.path().c_str());
    }).join();
    if (!mounted)
        GTEST_SKIP() << "this user may not mount a small disk; the file size limit stands in for it above";
}

TEST(VdbDisk, AFolderThatCannotBeWrittenSaysWhy) {
    const OwnFolder folder;
    const WindBox air = uniform_air({4, 4, 4}, glm::vec3(1.0f));
    const auto expect = [&](const fs::path& file, const char* reason) {
        const vdb::WriteResult written = vdb::write(air.grid(), file);
        EXPECT_EQ(written.problem(), Problem::cannot_write);
        EXPECT_EQ(written.error().find(file.string() + ": " + reason), 0u) << written.error();
    };
    std::ofstream(folder / "plain") << "file";
    fs::create_directory(folder / "folder.vdb");
    ::mkfifo((folder / "pipe.vdb").c_str(), 0600);
    expect(folder / "missing" / "a.vdb", "No such file or directory: create that folder first");
    expect(folder / "plain" / "a.vdb", "Not a directory: create that folder first");
    expect(folder / "folder.vdb", "Is a directory: it is a folder or a device, name a file");
    expect(folder / "pipe.vdb", "not a regular file: it is a folder or a device, name a file");
    expect("/dev/full", "not a regular file: it is a folder or a device, name a file");
    expect(folder / std::string(300, 'a'), "File name too long: shorten it");
    EXPECT_EQ(folder.entries(), 3);

    // The superuser writes anywhere: become nobody for a moment.
    ::chmod(folder.path().c_str(), 0555);
    const bool super = ::geteuid() == 0;
    ASSERT_TRUE(!super || ::seteuid(65534) == 0);
    expect(folder / "a.vdb", "Permission denied: name a file in a folder that you may write to");
    ASSERT_TRUE(!super || ::seteuid(0) == 0);
    ::chmod(folder.path().c_str(), 0755);
    EXPECT_EQ(folder.entries(), 3);
}

TEST(VdbDisk, ANewFileReplacesTheOld) {
    const OwnFolder folder;
    std::ofstream(folder / "a.vdb") << "old";
    const WindBox air = random_air({8, 8, 8});
    ASSERT_TRUE(vdb::write(air.grid(), folder / "a.vdb"));
    EXPECT_EQ(folder.entries(), 1);
    ASSERT_TRUE(vdb::write(air.grid(), folder / "b.vdb"));
    EXPECT_EQ(text_of(folder / "a.vdb"), text_of(folder / "b.vdb"));
    ASSERT_TRUE(vdb::write(random_air({8, 8, 8}).grid(), folder / "b.vdb", {.frame = 1}));
    EXPECT_NE(text_of(folder / "a.vdb").substr(21, 36), text_of(folder / "b.vdb").substr(21, 36))
        << "the tag is of the frame too";
}

TEST(VdbDisk, EightThreadsWriteTheSameBytes) {
    const OwnFolder folder;
    const WindBox air = random_air({16, 9, 12});
    std::array<vdb::WriteResult, 8> written;
    std::array<std::string, 8> bytes;
    std::vector<std::thread> threads;
    for (std::size_t n = 0; n < written.size(); ++n)
        threads.emplace_back([&, n] {
            const fs::path file = folder / (std::to_string(n) + ".vdb");
            written[n] = vdb::write(air.grid(), file);
            bytes[n] = text_of(file);
        });
    for (std::thread& thread : threads)
        thread.join();
    for (std::size_t n = 0; n < written.size(); ++n) {
        ASSERT_TRUE(written[n]) << written[n].error();
        EXPECT_EQ(bytes[n], bytes[0]);
    }
}

// Each allocation of a write failed in turn: no exception, the old file stays, no part is left, and the next write succeeds.
TEST(VdbDisk, WhereverMemoryEndsTheOldFileStays) {
    const OwnFolder folder;
    const WindBox air = random_air({5, 4, 3});
    const vdb::Sequence sequence{.folder = folder.path()};
    const fs::path file = folder / "wind_0002.vdb";
    ASSERT_TRUE(sequence.write(air.grid(), 2, 0.0));
    const std::string written = text_of(file);
    int failures = 0;
    for (const auto failing : {test::Failing::once, test::Failing::from_then_on})
        for (int after = 0, failed = 1; failed != 0; after += 1 + after / 50) {
            std::ofstream(file) << "precious";
            bool threw = false, done = false;
            {
                const test::FailingMemory memory(after, failing);
                try {
                    const auto result = sequence.write(air.grid(), 2, 0.0);
                    done = result.has_value();
                } catch (...) {
                    threw = true;
                }
                failed = memory.failed() ? 1 : 0;
            }
            failures += failed;
            ASSERT_FALSE(threw) << "after " << after << " allocations";
            ASSERT_TRUE(done ? text_of(file) == written : text_of(file) == "precious") << "after " << after;
            ASSERT_EQ(folder.entries(), 1) << "after " << after;
        }
    EXPECT_GT(failures, 100);
}

} // namespace
