#include "cli/progress.h"

#include "fluid/core/message.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <sys/ioctl.h>
#include <unistd.h>

namespace windrow::cli {
namespace {

using detail::message;

/// A terminal that cannot move its cursor gets lines.
bool can_redraw(std::FILE* stream) {
    const char* const terminal = std::getenv("TERM");
    return stream != nullptr && ::isatty(::fileno(stream)) != 0 && (terminal == nullptr || std::string_view(terminal) != "dumb");
}

int terminal_width(std::FILE* stream) {
    winsize size{};
    if (::ioctl(::fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
        return size.ws_col;
    return 80;
}

std::string two_digits(long value) {
    return message(value < 10 ? "0" : "", value);
}

} // namespace

std::string describe_duration(double seconds) {
    const long whole = std::lround(std::clamp(seconds, 0.0, 1e9));
    if (whole < 60)
        return message(whole, " s");
    if (whole < 3600)
        return message(whole / 60, " min ", two_digits(whole % 60), " s");
    return message(whole / 3600, " h ", two_digits(whole / 60 % 60), " min");
}

std::string progress_line(std::int64_t done, std::int64_t total, double seconds_left, int width) {
    const std::int64_t percent = total > 0 ? 100 * done / total : 100;
    const std::string head = message("frame ", done, " of ", total, " ");
    std::string tail = message(" ", percent, " %");
    if (done > 0 && done < total)
        tail += message(", ", describe_duration(seconds_left), " to go");
    // The last column stays empty: many terminals wrap when it is written.
    const int room = width - 1 - static_cast<int>(head.size() + tail.size()) - 2;
    std::string line = head;
    if (room >= 4) {
        const int cells = std::min(room, 40);
        const int full = total > 0 ? static_cast<int>(cells * done / total) : cells;
        line += message("[", std::string(static_cast<std::size_t>(full), '#'),
                        std::string(static_cast<std::size_t>(cells - full), '-'), "]");
    }
    line += tail;
    if (width > 1 && line.size() > static_cast<std::size_t>(width - 1))
        line.resize(static_cast<std::size_t>(width - 1));
    return line;
}

Progress::Progress(std::FILE* stream, std::int64_t total) : stream_(stream), total_(total), terminal_(can_redraw(stream)) {}

Progress::~Progress() {
    clear();
}

void Progress::update(std::int64_t done) {
    if (stream_ == nullptr)
        return;
    const Clock::time_point now = Clock::now();
    const double passed = std::chrono::duration<double>(now - begin_).count();
    const double left = done > 0 ? passed / static_cast<double>(done) * static_cast<double>(total_ - done) : 0.0;
    if (terminal_) {
        // Ten times a second is as much as an eye takes, and writing to a slow terminal must not slow the run.
        if (drawn_ && done < total_ && now - told_ < std::chrono::milliseconds(100))
            return;
        std::fprintf(stream_, "\r\x1b[K%s", progress_line(done, total_, left, terminal_width(stream_)).c_str());
        std::fflush(stream_);
        drawn_ = true;
        told_ = now;
        return;
    }
    // In a log: a line each tenth, but none for a run that is over before anybody looks.
    const int tenth = total_ > 0 ? static_cast<int>(10 * done / total_) : 10;
    if (tenth > told_tenth_ && done < total_ && passed > 2.0 && now - told_ > std::chrono::seconds(1)) {
        told_tenth_ = tenth;
        told_ = now;
        std::fprintf(stream_, "windrow: frame %lld of %lld, %d %%, %s to go\n", static_cast<long long>(done),
                     static_cast<long long>(total_), static_cast<int>(100 * done / total_), describe_duration(left).c_str());
        std::fflush(stream_);
    }
}

void Progress::clear() {
    if (!drawn_)
        return;
    std::fputs("\r\x1b[K", stream_);
    std::fflush(stream_);
    drawn_ = false;
}

} // namespace windrow::cli
