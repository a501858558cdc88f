#include "vegetation/program/film.h"

#include "fluid/core/message.h"
#include "fluid/files/new_file.h"
#include "pictures/picture_files.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <spawn.h>
#include <string_view>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace windrow::vegetation::program {
namespace {

namespace fs = std::filesystem;
using detail::message;

constexpr int k_webp_quality = 90;

// --- WebP: https://developers.google.com/speed/webp/docs/riff_container --------------------------------------------------------

void append_number(std::string& bytes, std::uint64_t value, int size) {
    for (int n = 0; n < size; ++n)
        bytes += static_cast<char>(value >> (8 * n) & 0xff);
}

std::string chunk(std::string_view name, std::string_view body) {
    std::string bytes(name);
    append_number(bytes, body.size(), 4);
    bytes += body;
    if (body.size() % 2 != 0)
        bytes += '\0';
    return bytes;
}

/// [ms] Rounded for each frame by itself, so that a long film keeps its time.
std::int64_t begin_ms(std::int64_t frame, double frames_per_second) {
    return std::llround(1000.0 * static_cast<double>(frame) / frames_per_second);
}

Result<void> write_webp(const Film& film, const scene::FrameFiles& pictures) {
    constexpr std::uint64_t k_most_bytes = 0xffff'fffe; // a size in the file has four bytes
    constexpr std::size_t k_head = 12;                  // RIFF, its size, WEBP
    constexpr unsigned char k_animated = 0x02, k_whole_frame = 0x02;
    std::string size;
    append_number(size, static_cast<std::uint64_t>(film.size.x - 1), 3);
    append_number(size, static_cast<std::uint64_t>(film.size.y - 1), 3);
    std::string body = "WEBP";
    body += chunk("VP8X", std::string{static_cast<char>(k_animated), 0, 0, 0} + size);
    body += chunk("ANIM", std::string(6, '\0')); // on black, again and again
    std::int64_t shown = 0;
    for (const Shot& shot : film.shots)
        for (std::int64_t n = 0; n < shot.count; ++n, ++shown) {
            const fs::path name = shot.folder / pictures.name(shot.first + n);
            const auto picture = pictures::read_png(name);
            if (!picture)
                return picture.failure();
            if (picture->width != film.size.x || picture->height != film.size.y)
                return Error{message(name.string(), " has ", picture->width, " x ", picture->height, " px, the film ",
                                     film.size.x, " x ", film.size.y, ": draw it again, without --resume.")};
            const auto encoded = pictures::encode_webp(*picture, k_webp_quality, name);
            if (!encoded)
                return encoded.failure();
            std::string frame(6, '\0'); // at the corner
            frame += size;
            append_number(
                frame,
                static_cast<std::uint64_t>(begin_ms(shown + 1, film.frames_per_second) - begin_ms(shown, film.frames_per_second)),
                3);
            frame += static_cast<char>(k_whole_frame);
            frame.append(reinterpret_cast<const char*>(encoded->data()) + k_head, encoded->size() - k_head);
            body += chunk("ANMF", frame);
            if (body.size() > k_most_bytes)
                return Error{message(film.file.string(), " would be above 4 GB: draw fewer or smaller pictures.")};
        }
    return detail::write_file("film", film.file, chunk("RIFF", body));
}

// --- MP4 -------------------------------------------------------------------------------------------------------------------

bool finds(const char* program) {
    const char* const path = std::getenv("PATH");
    std::string_view rest = path != nullptr ? path : "";
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(':'), rest.size());
        const fs::path file = fs::path(rest.substr(0, end)) / program;
        if (end > 0 && ::access(file.c_str(), X_OK) == 0)
            return true;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return false;
}

/// The exit code; -1 where it did not run.
int run(std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_t child = 0;
    int status = 0;
    if (::posix_spawnp(&child, arguments.front(), nullptr, nullptr, arguments.data(), environ) != 0 ||
        ::waitpid(child, &status, 0) != child || !WIFEXITED(status))
        return -1;
    return WEXITSTATUS(status);
}

/// ffmpeg's pattern for numbered files.
std::string pattern_of(const fs::path& folder, const scene::FrameFiles& pictures) {
    std::string pattern;
    for (const char letter : folder.string())
        pattern += letter == '%' ? "%%" : std::string(1, letter);
    return message(pattern, "/", pictures.prefix, "%0", pictures.digits, "d", pictures.suffix);
}

Result<void> write_mp4(const Film& film, const scene::FrameFiles& pictures) {
    const fs::path part = film.file.parent_path() / ("part_" + film.file.filename().string());
    std::vector<std::string> words{"ffmpeg", "-nostdin", "-v", "error", "-y"};
    std::string chain, joined, cuts;
    std::int64_t shown = 0;
    for (std::size_t n = 0; n < film.shots.size(); ++n) {
        const Shot& shot = film.shots[n];
        for (std::string word : {std::string("-framerate"), message(film.frames_per_second), std::string("-start_number"),
                                 message(shot.first), std::string("-i"), pattern_of(shot.folder, pictures)})
            words.push_back(std::move(word));
        chain += message("[", n, ":v]trim=end_frame=", shot.count, ",setpts=PTS-STARTPTS[s", n, "];");
        joined += message("[s", n, "]");
        if (n > 0) // a quarter of a frame early, so that rounding makes it no frame late
            cuts += message(n > 1 ? "," : "", (static_cast<double>(shown) - 0.25) / film.frames_per_second);
        shown += shot.count;
    }
    // H.264 of most players has even sides.
    chain += message(joined, "concat=n=", film.shots.size(), ",pad=ceil(iw/2)*2:ceil(ih/2)*2,format=yuv420p[film]");
    for (const char* const word : {"-filter_complex", chain.c_str(), "-map", "[film]", "-c:v", "libx264", "-crf", "18"})
        words.emplace_back(word);
    if (!cuts.empty()) {
        words.emplace_back("-force_key_frames");
        words.push_back(cuts);
    }
    for (const std::string& word : {std::string("-movflags"), std::string("+faststart"), part.string()})
        words.push_back(word);
    std::error_code error;
    if (run(std::move(words)) != 0) {
        fs::remove(part, error);
        return Error{message(film.file.string(), " was not made by ffmpeg, which gives its reason above; the pictures are in ",
                             film.shots.front().folder.string(), ".")};
    }
    fs::rename(part, film.file, error);
    if (!error)
        return {};
    fs::remove(part, error);
    return Error{message(film.file.string(), " cannot be written: remove what has that name, or give another.")};
}

} // namespace

FilmFault fault_of_film(const fs::path& file) {
    if (file.extension() != ".webp" && file.extension() != ".mp4")
        return {message("--film is ", file.string(), ": give a name that ends in .webp or .mp4.")};
    std::error_code error;
    if (!fs::is_directory(file.has_parent_path() ? file.parent_path() : ".", error))
        return {message("--film ", file.string(), " is in a folder that does not exist: create it first, or name another.")};
    if (fs::is_directory(file, error))
        return {message("--film ", file.string(), " is a folder: give the name of a file.")};
    if (file.extension() == ".mp4" && !finds("ffmpeg"))
        return {message("--film ", file.string(),
                        " is made by ffmpeg, which is not in the PATH: install it, or give a name that "
                        "ends in .webp."),
                true};
    return {};
}

Result<void> write_film(const Film& film, const scene::FrameFiles& pictures) {
    return film.file.extension() == ".webp" ? write_webp(film, pictures) : write_mp4(film, pictures);
}

} // namespace windrow::vegetation::program
