// A folder of one test, with files that the test writes; gone with the test.
#pragma once

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <unistd.h>

namespace windrow::vegetation::fur::test {

class Folder {
  public:
    Folder() {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        path_ = std::filesystem::temp_directory_path() /
                (std::string("windrow_fur_") + info->name() + "_" + std::to_string(getpid()));
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_ / "inner");
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    /// In the inner folder, so that there is an outside that belongs to the test too.
    [[nodiscard]] std::filesystem::path at(const std::string& name) const { return path_ / "inner" / name; }
    std::filesystem::path write(const std::string& name, std::string_view bytes) const {
        std::ofstream(at(name), std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return at(name);
    }

  private:
    std::filesystem::path path_;
};

/// Meshes of Debian's package glmark2-data, which ./dev installs.
inline std::filesystem::path glmark2(const char* name) {
    return std::filesystem::path("/usr/share/glmark2/models") / name;
}

/// Meshes that tools/make_meshes.py makes; the test program.make_meshes runs it first.
inline std::filesystem::path made(const char* name) {
    return std::filesystem::path(WINDROW_SOURCE_DIR) / "examples/scenes/fur" / name;
}

/// A mesh of glmark2-data that is not installed fails the test: ./dev installs it.
#define WINDROW_NEEDS_GLMARK2(name)                                                                                              \
    if (!std::filesystem::exists(fur::test::glmark2(name)))                                                                      \
    FAIL() << fur::test::glmark2(name) << " is not there: install glmark2-data to test with it."

} // namespace windrow::vegetation::fur::test
