// A folder of the process for readers that take files; gone with the process. `tools/fuzz.py` sets TMPDIR to a folder in memory.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <unistd.h>

namespace windrow::fuzz {

class ScratchFolder {
  public:
    ScratchFolder() : path_(std::filesystem::temp_directory_path() / ("windrow_fuzz_" + std::to_string(getpid()))) {
        std::filesystem::create_directories(path_);
    }
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    std::filesystem::path write(const char* name, std::string_view bytes) const {
        const std::filesystem::path file = path_ / name;
        if (std::FILE* const stream = std::fopen(file.c_str(), "wb")) {
            if (!bytes.empty())
                std::fwrite(bytes.data(), 1, bytes.size(), stream);
            std::fclose(stream);
        }
        return file;
    }

  private:
    std::filesystem::path path_;
};

} // namespace windrow::fuzz
