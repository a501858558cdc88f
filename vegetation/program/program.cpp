// windrow-draw SCENE.json ...: draws the pictures of scene files, on the GPU or, where there is none, on a software one.
//
//     windrow-draw examples/scenes/meadow.json --out out/meadow      every frame as PNG, a contact sheet, a table of times
//     windrow-draw SCENE.json --frames 1 --from 3.5 --size 1920x1080 one picture, of the moment 3.5 s
//     windrow-draw SCENE.json --fps 24 --shutter 180 --resume        frames of a film; a run that was stopped goes on
//     windrow-draw SCENE.json --part 2/8                             a part of the frames: one process or machine of eight
//     windrow-draw SCENE.json --join --film film.mp4                 once all parts are drawn: what is made of all of them
//     windrow-draw SCENE.json --show slice                           the wind itself: streaks, arrows, slice; or what plants do:
//                                                                    lean, levels, chunks
//     windrow-draw SCENE.json --size 640x360 --film film.webp        a film too; of several scenes behind one another; .mp4 by ffmpeg
//     windrow-draw examples/scenes/looks/*.json --frames 1 --sheet looks.png       the first picture of each, side by side
//     windrow-draw examples/scenes/fur/*.json --frames 1 --jpeg docs/gallery    the first picture of each, small, for a page
//
// Exit codes as the windrow command's: 0 well, 2 wrong use or a bad scene, 3 the machine lacks something.
#include "fluid/core/message.h"
#include "pictures/picture_files.h"
#include "pictures/sheet.h"
#include "scene/frame_files.h"
#include "scene/nearest_word.h"
#include "scene/number_text.h"
#include "scene/part.h"
#include "vegetation/program/film.h"
#include "vegetation/program/picture_reader.h"
#include "vegetation/program/scene_renderer.h"
#include "vegetation/program/stage_table.h"
#include "vegetation/vulkan/device.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <unistd.h>

using namespace windrow::vegetation;

namespace {

using windrow::Error;
using windrow::Fault;
using windrow::Result;

constexpr std::size_t k_max_on_sheet = 24;
constexpr int k_wrong_use = 2, k_machine = 3; ///< exit codes

const windrow::scene::FrameFiles k_pictures{"frame_", ".png"}, k_exrs{"frame_", ".exr"};

struct Options {
    std::vector<std::filesystem::path> scenes{};
    std::filesystem::path folder{}, sheet{}; ///< of one scene's pictures; of the sheet of all scenes, if it was asked for
    std::filesystem::path jpeg{};            ///< folder of small pictures, if they were asked for
    std::filesystem::path film{};            ///< of all scenes, if it was asked for
    std::int64_t frames = 0;                 ///< 0: all from `from`
    double from = 0.0;                       ///< [s]
    bool resume = false;                     ///< pictures at the begin that are there are kept
    bool exr = false;
    windrow::scene::Part part{}; ///< of the frames
    bool join = false;           ///< nothing is drawn: the pictures of all parts are there
    program::SceneRendererSettings scene_renderer{};
};

int code_of(const Error& error) {
    return error.fault == Fault::rejected ? k_wrong_use : k_machine;
}

/// What a run leaves behind for its last words.
struct Kept {
    std::vector<render::Picture8> sheet{};
    program::StageTable stages{};
    std::int64_t first = 0, last = 0;      ///< numbers of the first and the last frame that are asked for
    std::int64_t pictures = 0, before = 0; ///< drawn by this run; kept from one before
    double seconds = 0.0;                  ///< of the clock on the wall, pictures and files included
};

/// The picture last: where it is, all of the frame is (--resume).
Result<void> keep(const Options& options, const program::SceneRenderer& scene_renderer, std::int64_t frame) {
    if (options.exr)
        if (auto written =
                windrow::pictures::write_exr(scene_renderer.images().light_picture(), scene_renderer.images().motion_picture(),
                                             options.folder / k_exrs.name(frame));
            !written)
            return written;
    return windrow::pictures::write_png(scene_renderer.images().picture(), options.folder / k_pictures.name(frame));
}

/// A file that a frame lacks, of those that were asked for; empty: it has all. A file is written whole or not at all.
std::filesystem::path missing_of(const Options& options, std::int64_t frame) {
    std::error_code error;
    for (const auto& [asked, files] : {std::pair(true, k_pictures), std::pair(options.exr, k_exrs)})
        if (const auto file = options.folder / files.name(frame); asked && !std::filesystem::is_regular_file(file, error))
            return file;
    return {};
}

/// The first frame from `first` on, before `end`, that lacks a file.
std::int64_t first_not_drawn(const Options& options, std::int64_t first, std::int64_t end) {
    while (first < end && missing_of(options, first).empty())
        ++first;
    return first;
}

/// Pictures for the contact sheet: every so many of `count`.
std::int64_t stride_on_sheet(std::int64_t count) {
    constexpr auto k_most = static_cast<std::int64_t>(k_max_on_sheet);
    return std::max<std::int64_t>(1, (count + k_most - 1) / k_most);
}

/// Adds to the sheet what is there of a run from `begun` to `end`: its pictures before `first`. Rejects others than of `size` [px].
Result<void> read_sheet(const Options& options, std::int64_t begun, std::int64_t first, std::int64_t end,
                        std::optional<glm::ivec2> size, Kept& kept) {
    for (std::int64_t frame = begun; frame < first; frame += stride_on_sheet(end - begun)) {
        const std::filesystem::path file = options.folder / k_pictures.name(frame);
        auto picture = windrow::pictures::read_png(file);
        if (!picture)
            return picture.failure();
        if (size && glm::ivec2(picture->width, picture->height) != *size)
            return Error{windrow::detail::message("picture ", file.string(), " is ", picture->width, " x ", picture->height,
                                                  " px, and this run draws ", size->x, " x ", size->y,
                                                  " px; give that --size, or another --out.")};
        kept.sheet.push_back(*std::move(picture));
    }
    return {};
}

/// What a run that draws all frames from `first` on, before `end`, would leave behind, from the pictures of its parts.
Result<Kept> join(const Options& options, std::int64_t first, std::int64_t end) {
    if (const std::int64_t missing = first_not_drawn(options, first, end); missing < end)
        return Error{windrow::detail::message(missing_of(options, missing).string(),
                                              " is missing: draw the part that has this frame, with --part, before --join.")};
    Kept kept{.first = first, .last = end - 1, .before = end - first};
    if (auto read = read_sheet(options, first, end, end, {}, kept); !read)
        return read.failure();
    if (auto joined = program::StageTable::join(options.folder); !joined)
        return joined.failure();
    return kept;
}

/// `code`: the exit code of an error.
Result<Kept> draw(const Options& options, const program::PictureScene& scene, program::SceneRenderer& scene_renderer, int& code) {
    code = k_wrong_use;
    // Motion vectors are of two frames, and what is drawn keeps its last place: so many are drawn, and not written, before a film
    // goes on.
    constexpr std::int64_t k_lead = 2;
    const auto begin = std::chrono::steady_clock::now();
    const auto total = static_cast<std::int64_t>(std::floor(scene.air.duration * scene_renderer.frames_per_second() + 1e-9)) + 1;
    const auto asked = static_cast<std::int64_t>(std::llround(options.from * scene_renderer.frames_per_second()));
    if (asked >= total)
        return Error{windrow::detail::message("--from is ", options.from, " s, after the scene's end at ", scene.air.duration,
                                              " s; give an earlier moment.")};
    const std::int64_t all = (options.frames > 0 ? std::min(total, asked + options.frames) : total) - asked;
    if (options.join)
        return join(options, asked, asked + all);
    const std::int64_t begun = asked + options.part.first(all), end = asked + options.part.end(all);
    const std::int64_t first = options.resume ? first_not_drawn(options, begun, end) : begun;
    const bool moves = scene_renderer.shutter_deg() > 0.0f || options.exr; // motion vectors are seen or written
    const std::int64_t lead = moves || first > asked ? first - k_lead : first;
    Kept kept{.first = asked, .last = asked + all - 1, .before = first - begun};
    if (options.part.is_whole()) // a part makes no sheet
        if (auto read = read_sheet(options, begun, first, end, scene_renderer.size(), kept); !read)
            return read.failure();
    if (first == end)
        return kept;
    kept.stages = program::StageTable(scene_renderer);
    if (first > begun)
        if (auto read = kept.stages.keep(options.folder / program::StageTable::name(options.part), begun, first); !read)
            return read.failure();
    code = k_machine;
    if (auto settled = scene_renderer.warm_up(); !settled)
        return settled.failure();
    const std::int64_t every = stride_on_sheet(end - begun);
    const bool shows_progress = ::isatty(STDERR_FILENO) != 0;
    for (std::int64_t frame = 0; frame < end; ++frame) {
        if (auto done = frame < lead ? scene_renderer.skip() : scene_renderer.draw(frame >= first); !done)
            return done.failure();
        if (frame < first)
            continue;
        if (auto written = keep(options, scene_renderer, frame); !written) {
            code = code_of(written.failure());
            return written.failure();
        }
        kept.stages.add(frame, scene_renderer.times());
        if ((frame - begun) % every == 0)
            kept.sheet.push_back(scene_renderer.images().picture());
        // So that a run that is killed leaves what --resume goes on from.
        if (auto noted = kept.stages.write(options.folder / program::StageTable::name(options.part)); !noted) {
            code = code_of(noted.failure());
            return noted.failure();
        }
        ++kept.pictures;
        if (shows_progress)
            std::fprintf(stderr, "\rframe %d of %d ", static_cast<int>(frame - first + 1), static_cast<int>(end - first));
    }
    if (shows_progress)
        std::fputs("\r\033[K", stderr);
    kept.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return kept;
}

int complain(const std::string& sentence, int code) {
    std::fprintf(stderr, "windrow-draw: %s\n", sentence.c_str());
    return code;
}

/// One sheet of pictures, `width` px each.
Result<void> write_sheet(const std::vector<render::Picture8>& pictures, int width, const std::filesystem::path& file) {
    const auto sheet = windrow::pictures::contact_sheet(pictures, 4, width);
    return sheet ? windrow::pictures::write_png(*sheet, file) : Result<void>(sheet.failure());
}

/// A picture of 640 px in at most 60 kB: what a page of many pictures can bear.
Result<void> write_small(const render::Picture8& picture, const std::filesystem::path& file) {
    constexpr std::uintmax_t k_max_bytes = 60'000;
    for (int quality = 85;; quality -= 5) {
        if (auto written = windrow::pictures::write_jpeg(windrow::pictures::shrunk(picture, 640), quality, file); !written)
            return written;
        std::error_code error;
        if (quality <= 50 || std::filesystem::file_size(file, error) <= k_max_bytes)
            return {};
    }
}

/// The shots of a film are of one size and rate.
std::string fault_of_shot(const std::filesystem::path& file, const program::SceneRenderer& scene_renderer, program::Film& film) {
    if (film.shots.empty()) {
        film.size = scene_renderer.size();
        film.frames_per_second = scene_renderer.frames_per_second();
    }
    if (film.size == scene_renderer.size() && film.frames_per_second == scene_renderer.frames_per_second())
        return {};
    return windrow::detail::message("--film: ", file.string(), " has ", scene_renderer.size().x, " x ", scene_renderer.size().y,
                                    " px and ", scene_renderer.frames_per_second(), " frames a second, the film ", film.size.x,
                                    " x ", film.size.y, " and ", film.frames_per_second, "; give --size and --fps for all.");
}

int run(const std::filesystem::path& file, const Options& options, std::vector<render::Picture8>& firsts, program::Film& film) {
    const auto scene = program::read_picture_scene(file);
    if (!scene)
        return complain(scene.error(), 2);
    for (const std::string& sentence : scene->air.warnings)
        (void)complain(sentence, 0);
    std::error_code error;
    std::filesystem::create_directories(options.folder, error);
    if (error)
        return complain("--out " + options.folder.string() + " cannot be made (" + error.message() +
                            "); name a folder that you may write to.",
                        2);
    auto scene_renderer = program::SceneRenderer::create(*scene, options.scene_renderer);
    if (!scene_renderer) // a scene that is at fault, or no device for any
        return complain(scene_renderer.error(), engine::Device::create() ? k_wrong_use : k_machine);
    if (const std::string fault = options.film.empty() ? "" : fault_of_shot(file, **scene_renderer, film); !fault.empty())
        return complain(fault, k_wrong_use);
    int code = 0;
    auto kept = draw(options, *scene, **scene_renderer, code);
    if (!kept)
        return complain(kept.error(), code);
    if (const int left_out = (*scene_renderer)->walkers_left_out(); left_out > 0)
        (void)complain(windrow::detail::message(file.string(), ": the ground's memory left out ", left_out,
                                                " walkers of a frame; raise $.picture.ground_memory.max_walkers."),
                       0);
    const bool whole = options.frames == 0 && options.from == 0.0;
    const auto files = std::array{k_pictures, k_exrs};
    if (const std::string others =
            !options.part.is_whole()
                ? ""
                : windrow::scene::clear_other_frames(options.folder, std::span(files).first(options.exr ? 2 : 1), kept->last,
                                                     whole ? windrow::scene::Extent::whole : windrow::scene::Extent::part);
        !others.empty())
        (void)complain(others, 0);
    film.shots.push_back({.folder = options.folder, .first = kept->first, .count = kept->last + 1 - kept->first});
    if (kept->sheet.size() > 1 && options.part.is_whole())
        if (const auto written = write_sheet(kept->sheet, 480, options.folder / "contact_sheet.png"); !written)
            return complain(written.error(), code_of(written.failure()));
    if (!kept->sheet.empty() && !options.jpeg.empty())
        if (const auto written = write_small(kept->sheet.front(), options.jpeg / (file.stem().string() + ".jpg")); !written)
            return complain(written.error(), code_of(written.failure()));
    if (!kept->sheet.empty())
        firsts.push_back(kept->sheet.front());
    if (kept->before > 0)
        std::printf("%d pictures were there\n", static_cast<int>(kept->before));
    if (kept->pictures == 0)
        return 0;
    std::printf("%s: %d pictures of %d x %d px in %.1f s, in %s\n", (*scene_renderer)->device().c_str(),
                static_cast<int>(kept->pictures), (*scene_renderer)->size().x, (*scene_renderer)->size().y, kept->seconds,
                options.folder.string().c_str());
    std::fputs(kept->stages.text().c_str(), stdout);
    return 0;
}

/// What would be found out only once all is drawn.
std::string fault_of(const Options& options) {
    if (!options.sheet.empty()) {
        std::error_code error;
        const std::filesystem::path folder = options.sheet.has_parent_path() ? options.sheet.parent_path() : ".";
        if (!std::filesystem::is_directory(folder, error))
            return "--sheet " + options.sheet.string() + " is in a folder that does not exist; create it first, or name another.";
        if (options.sheet.extension() != ".png")
            return "--sheet " + options.sheet.string() + " is not a PNG; give a name that ends in .png.";
    }
    if (!options.part.is_whole())
        for (const auto& [flag, given] :
             {std::pair("--join", options.join), std::pair("--film", !options.film.empty()),
              std::pair("--sheet", !options.sheet.empty()), std::pair("--jpeg", !options.jpeg.empty())})
            if (given)
                return windrow::detail::message(flag, " is made of all parts: give it without --part, once they are drawn.");
    if (options.join && options.resume)
        return "--join draws nothing that --resume could go on with: drop one of them.";
    std::error_code absent;
    if (!options.jpeg.empty() && !std::filesystem::is_directory(options.jpeg, absent))
        return "--jpeg " + options.jpeg.string() + " is not a folder; create it first, or name another.";
    std::set<std::filesystem::path> stems;
    for (const std::filesystem::path& scene : options.scenes)
        if (!stems.insert(scene.stem()).second)
            return scene.string() + " would be drawn into the folder of another scene of that name; draw it by a run of its own.";
    return {};
}

int run_all(const Options& options) {
    std::vector<render::Picture8> firsts;
    program::Film film{.file = options.film};
    if (const std::string fault = fault_of(options); !fault.empty())
        return complain(fault, 2);
    if (!options.film.empty())
        if (const program::FilmFault fault = program::fault_of_film(options.film); !fault.sentence.empty())
            return complain(fault.sentence, fault.machine ? k_machine : k_wrong_use);
    for (const std::filesystem::path& scene : options.scenes) {
        Options own = options;
        if (options.folder.empty())
            own.folder = std::filesystem::path("out") / scene.stem();
        else if (options.scenes.size() > 1)
            own.folder = options.folder / scene.stem();
        if (const int code = run(scene, own, firsts, film); code != 0)
            return code;
    }
    if (!options.film.empty()) {
        if (const auto written = program::write_film(film, k_pictures); !written)
            return complain(written.error(), code_of(written.failure()));
        std::int64_t frames = 0;
        for (const program::Shot& shot : film.shots)
            frames += shot.count;
        std::error_code error;
        std::printf("%s: %.1f s, %.2f MB\n", options.film.string().c_str(), static_cast<double>(frames) / film.frames_per_second,
                    static_cast<double>(std::filesystem::file_size(options.film, error)) / 1e6);
    }
    if (options.sheet.empty())
        return 0;
    // Four of them are as wide as a page shows.
    const auto written = write_sheet(firsts, 343, options.sheet);
    return written ? 0 : complain(written.error(), code_of(written.failure()));
}

/// As CLI::Range, which takes NaN for a number of any range.
CLI::Validator within(double least, double most) {
    return CLI::Validator(
        [=](const std::string& text) {
            double value = 0.0;
            if (CLI::detail::lexical_cast(text, value) && value >= least && value <= most)
                return std::string();
            char sentence[96];
            std::snprintf(sentence, sizeof sentence, "\" is not a number from %g to %g; give one.", least, most);
            return '"' + text + sentence;
        },
        "NUMBER");
}

/// CLI11's fault as one sentence; of a flag that is unknown, the one that was probably meant.
std::string sentence_of(const CLI::ParseError& fault, const CLI::App& app) {
    const auto extras = app.remaining();
    if (dynamic_cast<const CLI::ExtrasError*>(&fault) == nullptr || extras.empty())
        return fault.what();
    std::vector<std::string> flags;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames())
            flags.push_back("--" + name);
    const auto flag = std::find_if(extras.begin(), extras.end(), [](const std::string& word) { return word.starts_with('-'); });
    const std::string& word = flag != extras.end() ? *flag : extras.front();
    return windrow::detail::message("unknown option ", word, windrow::scene::did_you_mean(word, flags),
                                    ": see windrow-draw --help.");
}

/// "1920x1080".
std::string read_size(const std::string& text, std::optional<glm::ivec2>& size) {
    const std::string_view words = text;
    const std::size_t cross = std::min(words.find('x'), words.size());
    const auto width = windrow::scene::parse_whole_number(words.substr(0, cross)),
               height = windrow::scene::parse_whole_number(words.substr(std::min(cross + 1, words.size())));
    if (!width || !height || *width < 16 || *height < 16 || *width > 8192 || *height > 8192)
        return "--size is \"" + text + "\"; give it as WIDTHxHEIGHT, 16 to 8192 pixels each.";
    size = glm::ivec2(*width, *height);
    return {};
}

} // namespace

int main(int argument_count, char** arguments) {
    Options options;
    CLI::App app("Draws scene files.", "windrow-draw");
    std::string size, backend, part, show = "plants";
    double frames_per_second = 0.0;
    const std::map<std::string, program::Show> shows{{"plants", program::Show::plants}, {"streaks", program::Show::streaks},
                                                     {"arrows", program::Show::arrows}, {"slice", program::Show::slice},
                                                     {"lean", program::Show::lean},     {"levels", program::Show::levels},
                                                     {"chunks", program::Show::chunks}};
    app.add_option("scene", options.scenes, "scenes: JSON files, examples/scenes/scene.schema.json says of what")->required();
    app.add_option("--out", options.folder,
                   "where the pictures go, of several scenes in a folder each; default: out/NAME of the file");
    app.add_option("--sheet", options.sheet, "the first pictures of all scenes on one sheet: a PNG; they are of one size");
    app.add_option("--jpeg", options.jpeg, "the first picture of each scene as NAME.jpg in this folder, 640 px wide");
    app.add_option("--film", options.film,
                   "the pictures as a film too: an animated WebP, or MP4 by ffmpeg; of several scenes one behind the other");
    app.add_option("--frames", options.frames, "how many frames; default: to the scene's end")->check(within(1, 100000));
    app.add_option("--from", options.from, "[s] the moment of the first; what is before is blown, not drawn")
        ->check(within(0.0, 1e6));
    app.add_flag("--resume", options.resume, "keeps pictures that are there, from the first on, and draws those behind them");
    app.add_option("--part", part, "K/N: draws part K of N of the frames, for several processes or machines");
    app.add_flag("--join", options.join,
                 "draws nothing: makes the contact sheet, the film and times.csv of the pictures of all parts");
    app.add_option("--warm-up", options.scene_renderer.warm_up, "[s] of wind before the first picture; default: the scene's")
        ->check(within(0.0, 3600.0));
    app.add_option("--fps", frames_per_second, "frames a second; default: the scene's")->check(within(0.1, 10000.0));
    app.add_option("--size", size, "of a picture in pixels, as 1280x720; default: the scene's");
    app.add_option("--samples", options.scene_renderer.samples, "a pixel: 1, 4, or 2 where the device can; default: 4")
        ->check(CLI::IsMember({1, 2, 4}));
    app.add_option("--shutter", options.scene_renderer.shutter_deg,
                   "[deg] blurs what moves, as a camera does that is open for this angle of a "
                   "frame; 180 is a film's; default: the scene's")
        ->check(within(0.0, 360.0));
    app.add_option("--show", show, "plants, or with them streaks, arrows, slice of the wind; or lean, levels, chunks");
    app.add_flag("--exr", options.exr, "light and motion of each frame as OpenEXR too");
    app.add_option("--backend", backend, "what runs the air: cpu or vulkan; default: vulkan on a GPU, cpu on a software device");
    app.add_flag("!--no-wind", options.scene_renderer.wind, "without wind: what it costs");
    try {
        app.parse(argument_count, arguments);
    } catch (const CLI::ParseError& error) {
        return error.get_exit_code() == 0 ? app.exit(error) : complain(sentence_of(error, app), 2);
    }
    if (!size.empty())
        if (const std::string fault = read_size(size, options.scene_renderer.size); !fault.empty())
            return complain(fault, 2);
    if (!part.empty()) {
        const auto read = windrow::scene::parse_part(part);
        if (!read)
            return complain(read.error(), 2);
        options.part = *read;
    }
    const auto shown = shows.find(show);
    if (shown == shows.end()) {
        std::vector<std::string> names;
        for (const auto& [name, value] : shows)
            names.push_back(name);
        return complain("--show is \"" + show + "\"" + windrow::scene::did_you_mean(show, names) +
                            "; give one of plants, streaks, arrows, slice, lean, levels, chunks.",
                        2);
    }
    options.scene_renderer.show = shown->second;
    if (!backend.empty() && backend != "cpu" && backend != "vulkan")
        return complain("--backend is \"" + backend + "\"; give cpu or vulkan.", 2);
    if (!backend.empty())
        options.scene_renderer.backend = backend == "cpu" ? program::Backend::cpu : program::Backend::vulkan;
    if (frames_per_second > 0.0)
        options.scene_renderer.frames_per_second = frames_per_second;
    return run_all(options);
}
