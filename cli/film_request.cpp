#include "cli/film_request.h"

#include "scene/number_text.h"

#include <string_view>

namespace windrow::cli {
namespace {

using detail::message;
using scene::figure;

constexpr std::int64_t k_largest_number = 1'000'000'000;
constexpr double k_longest = 1e6; // [s] of a scene

// 24, 23.976, 24000/1001
double read_frame_rate(const std::string& text) {
    constexpr double k_least = 0.001, k_most = 10'000.0;
    const std::size_t slash = text.find('/');
    const auto over = scene::parse_number(std::string_view(text).substr(0, slash));
    const auto under = slash == text.npos ? std::optional(1.0) : scene::parse_number(std::string_view(text).substr(slash + 1));
    if (!over || !under || !(*under > 0.0) || !(*over / *under >= k_least && *over / *under <= k_most))
        reject("--fps is ", shown(text), ": give frames a second from ", figure(k_least), " to ", figure(k_most),
               ", such as 24 or 24000/1001.");
    return *over / *under;
}

Flags::Read read_time(const char* flag, std::optional<double>& time) {
    return [flag, &time](const std::string& text) {
        const auto number = scene::parse_number(text);
        if (!number || !(*number >= 0.0 && *number <= k_longest))
            reject(flag, " is ", shown(text), ": give a time from 0 to ", figure(k_longest), " s.");
        time = *number;
    };
}

} // namespace

void add_film(Flags& flags, FilmRequest& request) {
    flags.value("--frames", "N", "Frames to keep, whatever the scene's duration",
                [&request](const std::string& text) { request.frames = read_count(text, "--frames", scene::k_max_frames); });
    flags.value("--fps", "RATE", "Frames a second, each the air of its own time: 24, 24000/1001; default the scene's",
                [&request](const std::string& text) { request.frames_per_second = read_frame_rate(text); });
    flags.value("--from", "S", "Time of the first frame; the air before it is simulated and not kept; default 0",
                read_time("--from", request.from));
    flags.value("--to", "S", "Time that no frame is later than; default the scene's duration", read_time("--to", request.to));
    flags.value("--first-frame", "N", "Number of the first frame, in names and in VDB files; default 0",
                [&request](const std::string& text) {
                    const auto number = scene::parse_whole_number(text);
                    if (!number || *number < 0 || *number > k_largest_number)
                        reject("--first-frame is ", shown(text), ": give a whole number from 0 to ", k_largest_number, ".");
                    request.first_frame = *number;
                });
}

void check_film(const FilmRequest& request) {
    if (request.frames && request.to)
        reject("--frames and --to both say where the film ends: give one of them.");
    if (request.from && request.to && *request.to < *request.from)
        reject("--to is ", figure(*request.to), " s, before --from, ", figure(*request.from), " s: give a later time.");
}

void apply(const FilmRequest& request, scene::Scene& scene) {
    scene.frames_per_second = request.frames_per_second.value_or(scene.frames_per_second);
}

Result<Frames> frames_of(const FilmRequest& request, const scene::Scene& scene) {
    const double from = request.from.value_or(0.0);
    Frames frames{.times = {from, scene.frames_per_second, scene.tick_hz}, .count = 0, .first = request.first_frame};
    frames.count = request.frames.value_or(frames.times.frames_until(request.to.value_or(scene.duration)));
    if (frames.count == 0)
        return Error{message("--from is ", figure(from), " s, after the scene's end at ", figure(scene.duration),
                             " s: give an earlier time, --to or --frames.")};
    if (frames.count > scene::k_max_frames)
        return Error{message("--fps makes ", frames.count, " frames: give at most ", scene::k_max_frames,
                             " frames, by a lower rate, or by --from and --to.")};
    if (const std::int64_t steps = frames.times.step_of_frame(frames.count - 1); steps > scene::k_max_ticks)
        return Error{message("the last frame is at ", figure(frames.times.time_of_frame(frames.count - 1)), " s, ", steps,
                             " steps of the scene: give at most ", scene::k_max_ticks,
                             " steps, by fewer frames or a lower tick_hz.")};
    return frames;
}

} // namespace windrow::cli
