// How far a run is: a bar that is redrawn in place on a terminal, an occasional line anywhere else.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>

namespace windrow::cli {

/// "3 s", "2 min 05 s", "1 h 12 min".
[[nodiscard]] std::string describe_duration(double seconds);

/// The bar as one line of at most `width` columns: "frame 12 of 201 [####------] 6 %, 14 s to go". Without a known rest, no time.
[[nodiscard]] std::string progress_line(std::int64_t done, std::int64_t total, double seconds_left, int width);

class Progress {
  public:
    /// `stream` is the person's, usually stderr; null: nothing is told.
    Progress(std::FILE* stream, std::int64_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void update(std::int64_t done);
    /// Clears the bar, so that what is printed next begins on a clean line.
    void clear();

  private:
    using Clock = std::chrono::steady_clock;

    std::FILE* stream_;
    std::int64_t total_;
    bool terminal_;
    bool drawn_ = false;
    int told_tenth_ = 0;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point told_{};
};

} // namespace windrow::cli
