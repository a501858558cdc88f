#include "cli/film_request.h"

#include "cli/info_command.h"
#include "scene/number_text.h"

#include <algorithm>
#include <string_view>

namespace windrow::cli {
namespace {

using detail::message;
using scene::figure;

constexpr std::int64_t k_largest_number = 1'000'000'000;
constexpr double k_longest_film = 1e6; // [s] of a scene

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
        if (!number || !(*number >= 0.0 && *number <= k_longest_film))
            reject(flag, " is ", shown(text), ": give a time from 0 to ", figure(k_longest_film), " s.");
        time = *number;
    };
}

Flags::Read read_length(const char* flag, std::optional<double>& length, const Range& range) {
    return [flag, &length, range](const std::string& text) {
        const auto number = scene::parse_number(text);
        if (!number || !range.holds(*number))
            reject(flag, " is ", shown(text), ": give a number ", range.above_min ? "above " : "from ", figure(range.min), " to ",
                   figure(range.max), " m.");
        length = *number;
    };
}

/// use(word) for each word of a list with commas: speed,vorticity
template <class Use>
void for_each_word(const std::string& text, const Use& use) {
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        use(text.substr(begin, end - begin));
        begin = end + 1;
    }
}

void read_grids(const std::string& text, scene::VdbGrids& grids) {
    for_each_word(text, [&](const std::string& word) {
        bool known = false;
        for_each_setting(grids, [&](const auto& row, bool& wanted) {
            known = known || word == row.name;
            wanted = wanted || word == row.name;
        });
        if (!known)
            reject("--grids has ", shown(word), ": give some of speed, vorticity, divergence, pressure, density, with commas.");
    });
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

void add_vdb(Flags& flags, CLI::App& command, FilmRequest& request) {
    flags.value("--grids", "LIST", "Grids beside the velocity: speed, vorticity, divergence, pressure, density (of $.smoke)",
                [&request](const std::string& text) { read_grids(text, request.grids); });
    flags.value("--margin", "M", "Reach of VDB files beyond the box, in metres, filled with the ambient wind",
                read_length("--margin", request.margin, {0.0, 1e5}));
    flags.value("--voxel", "M", "Edge of a voxel in metres; default that of the cells",
                read_length("--voxel", request.voxel_size, Range::above(0.0, 1e6)));
    command.add_flag("--nanovdb", request.nanovdb, "Write .nvdb in place of .vdb");
}

std::vector<FieldFormat> read_formats(const std::string& text) {
    std::vector<FieldFormat> formats;
    for_each_word(text, [&](const std::string& word) {
        const auto& words = k_words<FieldFormat>;
        const auto found = std::find(words.begin(), words.end(), word);
        if (found == words.end())
            reject("--fields has ", shown(word), ": give some of fga, vf, raw, npz, vti, with commas.");
        const auto format = static_cast<FieldFormat>(found - words.begin());
        if (std::find(formats.begin(), formats.end(), format) == formats.end())
            formats.push_back(format);
    });
    return formats;
}

void check_film(const FilmRequest& request, bool vdb) {
    if (request.frames && request.to)
        reject("--frames and --to both say where the film ends: give one of them.");
    if (request.from && request.to && *request.to < *request.from)
        reject("--to is ", figure(*request.to), " s, before --from, ", figure(*request.from), " s: give a later time.");
    if (!vdb && (request.grids.any() || request.nanovdb || request.margin || request.voxel_size))
        reject(request.grids.any() ? "--grids"
               : request.nanovdb   ? "--nanovdb"
               : request.margin    ? "--margin"
                                   : "--voxel",
               " is given, and no VDB files are kept: add --vdb.");
}

std::uint64_t film_bytes(const scene::Scene& scene) {
    constexpr double k_bytes_a_voxel = 80.0; // velocity, vorticity and scalars, twice while they are written
    const scene::VdbSetting& vdb = scene.vdb;
    if (!vdb.holds_more())
        return 0;
    const double cell = static_cast<double>(scene.air.cell_size);
    const double voxel = vdb.voxel_size > 0.0f ? static_cast<double>(vdb.voxel_size) : cell;
    const glm::dvec3 size = vdb.box ? glm::dvec3(vdb.box->size) : glm::dvec3(scene.air.cells) * cell + 2.0 * vdb.margin;
    const glm::dvec3 voxels = size / voxel + 1.0;
    return static_cast<std::uint64_t>(std::min(1e18, k_bytes_a_voxel * voxels.x * voxels.y * voxels.z));
}

Result<void> apply(const FilmRequest& request, const BackendRequest& backend, scene::Scene& scene) {
    scene.frames_per_second = request.frames_per_second.value_or(scene.frames_per_second);
    scene::VdbSetting& vdb = scene.vdb;
    for_each_setting(vdb.grids, [&](const auto& row, bool& wanted) { wanted = wanted || request.grids.*row.member; });
    if (request.nanovdb)
        vdb.format = scene::VdbFormat::nanovdb;
    if (request.margin && vdb.box)
        return Error{message("--margin is given, and ", scene.file.string(), " has $.vdb.box: drop one of them.")};
    vdb.margin = request.margin.value_or(vdb.margin);
    vdb.voxel_size = static_cast<float>(request.voxel_size.value_or(static_cast<double>(vdb.voxel_size)));
    if (vdb.grids.density && scene.smoke.empty())
        return Error{message("--grids asks for density, and ", scene.file.string(), " has no $.smoke: add a source of it.")};
    if (vdb.grids.pressure && backend.kind != cases::BackendKind::cpu)
        return Error{"the pressure grid needs the CPU: drop --backend, or the grid."};
    if (vdb.format == scene::VdbFormat::nanovdb && !built_with_nanovdb())
        return Error{"--nanovdb: this windrow was built without NanoVDB: install libnanovdb-dev and build again."};
    return {};
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
