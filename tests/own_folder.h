// A folder that a test writes into, gone with the test, and a disk that takes no more.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <system_error>

#if !defined(_WIN32)
#include <csignal>
#include <sys/resource.h>
#endif

namespace windrow::test {

class OwnFolder {
  public:
    OwnFolder() {
        static std::atomic<unsigned> count{0};
        std::error_code fault;
        do { // another process may have taken a name
            const auto now = std::chrono::system_clock::now().time_since_epoch().count();
            path_ =
                std::filesystem::path(testing::TempDir()) / ("windrow_" + std::to_string(now) + '_' + std::to_string(++count));
        } while (!std::filesystem::create_directory(path_, fault) && !fault);
        EXPECT_FALSE(fault) << path_ << ": " << fault.message();
    }
    ~OwnFolder() {
        std::error_code ignored;
        std::filesystem::permissions(path_, std::filesystem::perms::owner_all, ignored);
        std::filesystem::remove_all(path_, ignored);
    }
    OwnFolder(const OwnFolder&) = delete;
    OwnFolder& operator=(const OwnFolder&) = delete;

    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::ptrdiff_t entries() const {
        return std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator());
    }

  private:
    std::filesystem::path path_;
};

/// A test with a folder of its own.
class FolderTest : public testing::Test {
  protected:
    [[nodiscard]] std::string in(const std::string& name) const { return (folder / name).string(); }
    [[nodiscard]] std::ptrdiff_t entries() const { return own_.entries(); }

  private:
    OwnFolder own_;

  protected:
    const std::filesystem::path folder = own_.path();
};

[[nodiscard]] inline std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

#if !defined(_WIN32)
/// While it lives, no file of this process may grow beyond so many bytes: a full disk without a disk.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

  private:
    rlimit before_{};
    void (*handler_)(int) = nullptr;
};
#endif

} // namespace windrow::test
