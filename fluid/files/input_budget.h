// Cost limit for all files of one scene together: a small scene may name many large files, or one file many times.
#pragma once

#include "fluid/core/message.h"
#include "fluid/result.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace windrow::detail {

class InputBudget {
  public:
    /// A table for each of 4096 paths, and as many meshes and maps.
    static constexpr std::size_t k_max_files = 8192;
    /// [byte] Read from files. The largest mesh has 512 MiB.
    static constexpr std::size_t k_max_bytes = std::size_t{768} << 20;
    /// Of paths from tables: 8 of the longest. A million takes up to half a second to read.
    static constexpr std::size_t k_max_points = 8'000'000;
    /// [byte] Of memory for masks, heights, meshes and maps. One file more is in memory while it is read.
    static constexpr std::size_t k_max_memory = std::size_t{768} << 20;

    /// Each takes its part, or returns a sentence that begins with the file's `name`. After the first that is too much, all is.
    Result<void> take_file(std::string_view name) { return take(files_, 1, name, k_max_files, " files"); }
    Result<void> take_bytes(std::string_view name, std::size_t bytes) {
        return take(bytes_, bytes, name, k_max_bytes >> 20, " MiB of files");
    }
    Result<void> take_points(std::string_view name, std::size_t points) {
        return take(points_, points, name, k_max_points, " points in tables");
    }
    Result<void> take_memory(std::string_view name, std::size_t bytes) {
        return take(memory_, bytes, name, k_max_memory >> 20, " MiB of masks, heights, meshes and maps");
    }
    [[nodiscard]] std::size_t memory_left() const { return memory_; }

  private:
    Result<void> take(std::size_t& left, std::size_t wanted, std::string_view name, std::size_t most, const char* what) {
        if (spent_.empty() && wanted > left)
            spent_ = message(": a scene takes at most ", most, what, ": give fewer or smaller files.");
        if (!spent_.empty())
            return Error{message(name, spent_)};
        left -= wanted;
        return {};
    }

    std::size_t files_ = k_max_files, bytes_ = k_max_bytes, points_ = k_max_points, memory_ = k_max_memory;
    std::string spent_; ///< the sentence's end, once one of them was too little
};

} // namespace windrow::detail
