#include "cli/run_command.h"

#include "cli/flags.h"
#include "cli/frame_writer.h"
#include "cli/info_command.h"
#include "cli/output_file.h"
#include "cli/playback.h"
#include "cli/progress.h"
#include "cli/run_report.h"
#include "cli/run_snapshot.h"
#include "cli/timings.h"
#include "fluid/core/message.h"
#include "scene/scene.h"
#include "scene/scene_reader.h"
#if WINDROW_WITH_IMAGES
#include "pictures/picture_files.h"
#endif

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <memory>

namespace windrow::cli {
namespace {

using detail::message;

#if WINDROW_WITH_IMAGES
constexpr scene::FileReaders k_readers{.heights = pictures::read_heights};
#else
constexpr scene::FileReaders k_readers{};
#endif

/// Rejects a flag whose part was not built in, before anything else is done.
bool check_parts(const RunRequest& request, const Console& console) {
    bool good = true;
    const auto lacks = [&](bool wanted, bool built, const char* flag, const char* what, const char* option,
                           const char* packages) {
        if (!wanted || built)
            return;
        good = false;
        console.complain(message(flag, ": this windrow was built without ", what, ": install ", packages,
                                 " and configure with -D", option, "=ON."));
    };
    lacks(request.vdb, built_with_vdb(), "--vdb", "OpenVDB", "WINDROW_VDB", "libopenvdb-dev");
    if (request.snapshot_every > 0 || request.resume)
        if (request.backend.kind != cases::BackendKind::cpu) {
            good = false;
            console.complain("--snapshot-every and --resume need the CPU: drop --backend.");
        }
    lacks(request.images, built_with_images(), "--images", "pictures", "WINDROW_IMAGES", "libopenimageio-dev and libcairo2-dev");
    return good;
}

/// A box that does not fit would otherwise end with the system killing some process, maybe not this one.
bool check_memory(const scene::Scene& scene, bool vdb, const Console& console) {
    constexpr std::uint64_t k_bytes_a_cell = 192; // state, scratch, gusts, sources, one frame of the cells on its way out
    const glm::ivec3 cells = scene.air.cells;
    const auto bytes_of = [](glm::ivec3 box) {
        return k_bytes_a_cell * static_cast<std::uint64_t>(box.x) * static_cast<std::uint64_t>(box.y) *
               static_cast<std::uint64_t>(box.z);
    };
    std::uint64_t needed = bytes_of(cells);
    for (const scene::SceneLevel& level : scene.outer)
        needed += bytes_of(cells) / 2 + bytes_of(level.cells); // what is around each box, and the box
    const auto available = available_memory();
    if (!available)
        return true;
    const std::uint64_t film = vdb ? film_bytes(scene) : 0;
    if (needed + film <= *available)
        return true;
    if (needed <= *available)
        console.complain(message(scene.file.string(), ": $.vdb asks for voxels that take about ", film >> 20, " MiB, and ",
                                 (*available - needed) >> 20, " MiB are free: give a smaller margin or larger voxels."));
    else
        console.complain(message(scene.file.string(), ": $.air.cells is ", cells, ", which takes about ", needed >> 20,
                                 " MiB, and ", *available >> 20, " MiB are free: give fewer cells."));
    return false;
}

/// The flags that a run that goes on must have too: not those of its folder, its threads and its snapshots.
std::string words_of(const CLI::App& run) {
    std::string words;
    for (const CLI::Option* const option : run.get_options()) {
        const auto& names = option->get_lnames();
        if (option->count() == 0 || names.empty() || names.front() == "out" || names.front() == "threads" ||
            names.front() == "resume" || names.front() == "snapshot-every")
            continue;
        for (const std::string& value : option->results())
            words += message(words.empty() ? "--" : " --", names.front(), " ", value);
    }
    return words;
}

/// What lasts through a run.
struct SceneRun {
    const scene::Scene& scene;
    const RunRequest& request;
    const Console& console;
    std::filesystem::path folder;
    const Frames& frames;
    FrameWriter writer;
    std::unique_ptr<OutputFile> csv;
    Probes probes;
    Timings timings;

    /// Steps until a frame is due. Returns an exit code, k_exit_well to go on.
    int advance_to_frame(Playback& playback, const cases::Backend& backend, std::int64_t frame) {
        const std::int64_t due = frames.times.step_of_frame(frame);
        while (playback.steps() < due) {
            const auto diagnostics = playback.step(frames.times);
            if (!diagnostics) {
                console.complain(diagnostics.error());
                return k_exit_wrong_use;
            }
            if (!backend.fault().empty())
                return complain_of(Fault{.sentence = backend.fault(), .machine = true}, console);
            timings.add(playback.time(), *diagnostics);
            if (csv)
                csv->write(timings_row(playback.steps(), playback.time(), *diagnostics));
            if (!std::isfinite(diagnostics->energy) || !std::isfinite(diagnostics->max_speed) ||
                !std::isfinite(diagnostics->divergence_rms)) {
                console.complain(message(scene.file.string(), ": at ", playback.time(), " s (step ", playback.steps(),
                                         ") the air is no longer finite (largest speed ", diagnostics->max_speed,
                                         " m/s): this is a fault of windrow, report it with the scene."));
                return k_exit_out_of_bounds;
            }
            if (const auto fault = writer.follow(playback, frames.times.length_of_step(playback.steps())))
                return complain_of(fault, console);
            if (const auto fault = probes.follow(playback))
                return complain_of(fault, console);
        }
        return k_exit_well;
    }
};

} // namespace

void add_run(CLI::App& app, std::function<int()>& chosen, const Console& console) {
    CLI::App* const run = app.add_subcommand("run", "Play a scene; keep pictures, VDB files and timings of it");
    const auto request = std::make_shared<RunRequest>();
    Flags flags(*run);
    flags.scene(request->scene);
    add_film(flags, request->film);
    flags.folder("--out", request->out, "Folder for what is kept; default out/<scene name>");
    flags.threads(request->threads, "Threads; default one a core; results do not depend on it");
    flags.simd(request->simd, "levels differ by rounding");
    flags.backend(request->backend);
    run->add_flag("--images", request->images, "Keep frame_0000.png ... and contact_sheet.png");
    run->add_flag("--vdb", request->vdb, "Keep vel_0000.vdb ... for Blender and Houdini");
    add_vdb(flags, *run, request->film);
    flags.value("--fields", "LIST", "Keep wind_0000.fga ... for engines and analysts: fga, vf, raw, npz, vti, with commas",
                [request](const std::string& text) { request->fields = read_formats(text); });
    add_probes(flags, *run, request->probes);
    run->add_flag("--csv", request->csv, "Keep timings.csv: a row a step with every figure it reports");
    flags.value("--snapshot-every", "N", "Keep run.snapshot after every N frames, for --resume",
                [request](const std::string& text) {
                    request->snapshot_every = read_count(text, "--snapshot-every", scene::k_max_frames);
                });
    run->add_flag("--resume", request->resume, "Go on from run.snapshot in the folder; from the start where there is none");
    run->callback([run, request, &chosen, &console] {
        check_backend(*run, request->backend);
        check_film(request->film, request->vdb);
        request->words = words_of(*run);
        chosen = interruptible<RunRequest>(run_scene, request, console);
    });
}

int run_scene(const RunRequest& request, const Console& console, const std::function<int()>& stop_signal) {
    if (!check_parts(request, console))
        return k_exit_wrong_use;
    auto scene = scene::read_scene(request.scene, k_readers);
    if (!scene) {
        console.complain(scene.error());
        return k_exit_wrong_use;
    }
    for (const std::string& sentence : scene->warnings)
        console.warn(sentence);
    scene->air.simd = request.simd;
    if (const auto applied = apply(request.film, request.backend, *scene); !applied) {
        console.complain(applied.error());
        return k_exit_wrong_use;
    }
    if (!check_memory(*scene, request.vdb, console))
        return k_exit_machine;
    const auto frames = frames_of(request.film, *scene);
    if (!frames) {
        console.complain(frames.error());
        return k_exit_wrong_use;
    }
    cases::Backend backend;
    if (const auto fault = open_backend(request.backend, backend))
        return complain_of(fault, console);
    if (request.probes.forces)
        backend.forces = static_cast<int>(std::max<std::size_t>(scene->obstacles.size(), 1));
    const bool keeps = request.vdb || request.images || request.csv || !request.fields.empty() || request.probes.any();
    const bool snapshots = request.snapshot_every > 0 || request.resume;
    const std::filesystem::path folder = request.out.value_or(std::filesystem::path("out") / scene->name);
    OutputFolder output;
    if (keeps || snapshots)
        if (const auto fault = output.open(folder))
            return complain_of(fault, console);
    RunSnapshot snapshot(folder);
    RunIdentity identity;
    if (snapshots) {
        auto found = identity_of(*scene, request.words);
        const auto begun = found && request.resume ? snapshot.read(*found) : Result<bool>(false);
        if (!found || !begun) {
            console.complain(found ? begun.error() : found.error());
            return k_exit_wrong_use;
        }
        identity = *std::move(found);
    }
    if (keeps && !request.resume)
        snapshot.remove(); // its frames are about to be replaced

    const auto begin = std::chrono::steady_clock::now();
    const auto pool = make_pool(request.threads, console);
    auto playback = snapshot.frames() > 0 ? snapshot.playback(*scene, pool->parallel_for())
                                          : Playback::create(*scene, pool->parallel_for(), backend);
    if (!playback) {
        console.complain(playback.error());
        // A device that has no room, unless the scene's winds do not fit into each other on the CPU either.
        const bool fits = !backend.is_cpu() && (scene->outer.empty() || Playback::create(*scene, {}));
        return fits ? k_exit_machine : k_exit_wrong_use;
    }

    const KeepText keep = snapshots ? KeepText::yes : KeepText::no;
    SceneRun run{.scene = *scene,
                 .request = request,
                 .console = console,
                 .folder = folder,
                 .frames = *frames,
                 .writer =
                     FrameWriter(*scene, folder, request.images, request.vdb, request.fields, *frames, pool->parallel_for()),
                 .csv = nullptr,
                 .probes = Probes(request.probes, folder, keep, snapshot.tables()),
                 .timings = {}};
    std::int64_t done = snapshot.frames();
    if (request.csv)
        run.csv =
            std::make_unique<OutputFile>(folder / "timings.csv", keep, done > 0 ? snapshot.timings_csv() : timings_header());
    int code = k_exit_well;
    if (done > 0) {
        if (const auto restored = snapshot.restore(run.writer, run.timings, *playback); !restored) {
            console.complain(restored.error());
            return k_exit_wrong_use;
        }
        snapshot.clear();
    } else if (const auto fault = run.probes.follow(*playback)) {
        code = complain_of(fault, console);
    }
    const auto keep_snapshot = [&] {
        if (const auto fault = snapshot.write(identity, done, *playback, run.writer, run.probes, run.timings, run.csv.get()))
            code = complain_of(fault, console);
    };
    {
        Progress progress(console.progress, frames->count);
        while (done < frames->count && code == k_exit_well && stop_signal() == 0) {
            progress.update(done);
            code = run.advance_to_frame(*playback, backend, done);
            if (code != k_exit_well)
                break;
            auto fault = run.writer.write(*playback, done);
            if (!backend.fault().empty()) // a frame asks the device too
                fault = {.sentence = backend.fault(), .machine = true};
            if (fault) {
                progress.clear();
                code = complain_of(fault, console);
                break;
            }
            ++done;
            if (request.snapshot_every > 0 && done % request.snapshot_every == 0 && done < frames->count)
                keep_snapshot();
        }
        progress.update(done);
    }
    const int signal = stop_signal();
    if (signal != 0 && code == k_exit_well && request.snapshot_every > 0 && done > 0 && done < frames->count)
        keep_snapshot();
    // A sheet takes seconds: who pressed Ctrl-C does not want to wait for it.
    if (signal == 0 && code == k_exit_well)
        if (const auto fault = run.writer.write_contact_sheet())
            code = complain_of(fault, console);
    // The steps so far, whatever ended the run.
    if (const auto fault = run.probes.publish(); fault && code == k_exit_well)
        code = complain_of(fault, console);
    if (run.csv)
        if (const auto fault = run.csv->publish(); fault && code == k_exit_well)
            code = complain_of(fault, console);
    if (code == k_exit_machine || code == k_exit_wrong_use)
        return code;

    const FilmRequest& film = request.film;
    const bool part = film.frames || film.from || film.to || film.first_frame != 0;
    if (keeps && done == frames->count)
        if (const std::string others = run.writer.clear_other_frames(part ? scene::Extent::part : scene::Extent::whole);
            !others.empty())
            console.warn(others);

    if (snapshots && code == k_exit_well && done == frames->count)
        snapshot.remove(); // there is nothing to go on with

    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    report_run({.scene = *scene,
                .playback = *playback,
                .folder = folder,
                .writer = run.writer,
                .timings = run.timings,
                .air_seconds = playback->time(),
                .wall_seconds = wall,
                .threads = pool->size(),
                .device = backend.device_words(),
                .frames_done = done,
                .step_hz = frames->times.step_hz(),
                .csv = request.csv,
                .probes = !request.probes.lines.empty(),
                .forces = request.probes.forces},
               console);
    if (signal != 0 && done < frames->count) {
        console.complain(message("stopped by ", signal == SIGINT ? "Ctrl-C" : "a signal", " after ", done, " of ", frames->count,
                                 " frames: all files written so far are complete."));
        return k_exit_signal + signal;
    }
    return code;
}

} // namespace windrow::cli
