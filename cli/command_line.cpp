#include "cli/command_line.h"

#include "cli/backend/backend_flags.h"
#include "cli/bench/bench_command.h"
#include "cli/bench/bench_flags.h"
#if WINDROW_WITH_VULKAN
#include "cli/check/check_command.h"
#endif
#include "cli/check/check_flags.h"
#include "cli/exit_code.h"
#include "cli/flags.h"
#include "cli/info_command.h"
#include "cli/interrupt.h"
#include "cli/pareto/pareto_command.h"
#include "cli/pareto/pareto_flags.h"
#include "cli/plants/plants_command.h"
#include "cli/run_command.h"
#include "cli/verify/verify_command.h"
#include "cli/verify/verify_flags.h"
#include "fluid/message.h"
#include "scene/nearest_word.h"
#include "scene/scene.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

namespace windrow::cli {
namespace {

using detail::message;

std::vector<std::string> words_of(const CLI::App& app) {
    std::vector<std::string> words;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames())
            words.push_back("--" + name);
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        words.push_back(command->get_name());
    return words;
}

/// The first word that stands where a command should and is none; empty where there is no such word.
std::string unknown_command(int count, const char* const* arguments) {
    for (int i = 1; i < count; ++i)
        if (arguments[i][0] != '-')
            return arguments[i];
    return {};
}

/// CLI11's fault as one sentence of ours.
std::string sentence_of(const CLI::ParseError& fault, const CLI::App& app, int count, const char* const* arguments) {
    const auto chosen = app.get_subcommands();
    const CLI::App& asked = chosen.empty() ? app : *chosen.front();
    const std::string help = message("see windrow ", chosen.empty() ? "" : asked.get_name() + " ", "--help.");
    const auto unknown = [&](const std::string& word, const char* what) {
        const std::string near = scene::nearest_word(word, words_of(asked));
        return message(word, what, near.empty() ? "" : " (did you mean " + near + "?)", ": ", help);
    };
    const auto extras = app.remaining(true);
    if (dynamic_cast<const CLI::ExtrasError*>(&fault) != nullptr && !extras.empty()) {
        // A flag that is not known leaves its value over too: the flag is the one to name.
        const auto flag =
            std::find_if(extras.begin(), extras.end(), [](const std::string& word) { return word.starts_with('-'); });
        return unknown(flag != extras.end() ? *flag : extras.front(),
                       flag != extras.end() ? " is no flag" : " is one word too many");
    }
    if (chosen.empty()) {
        const std::string word = unknown_command(count, arguments);
        if (!word.empty())
            return unknown(word, " is no command");
        if (count > 1)
            return unknown(arguments[1], " is no flag");
        return message("name a command, run, bench, verify, pareto, plants, check or info: ", help);
    }
    std::string words = fault.what();
    for (char& letter : words)
        if (letter == '\n')
            letter = ' ';
    return message(words, ": ", help);
}

struct RunFlags {
    std::string scene, frames, out, threads, simd;
    BackendFlags backend;
    bool vdb = false, images = false, csv = false;
};

void add_run(CLI::App& app, RunFlags& flags) {
    CLI::App* const run = app.add_subcommand("run", "Play a scene; keep pictures, VDB files and timings of it");
    run->add_option("SCENE.json", flags.scene, "Scene file; docs/scenes.md tells its keys")->required()->type_name("");
    run->add_option("--frames", flags.frames, "Frames to make, from time 0, whatever the scene's duration")->type_name("N");
    run->add_option("--out", flags.out, "Folder for what is kept; default out/<scene name>")->type_name("DIR");
    run->add_option("--threads", flags.threads, "Threads; default one a core; results do not depend on it")->type_name("N");
    run->add_option("--simd", flags.simd, "Instructions: best, baseline, avx2 or avx512; levels differ by rounding")
        ->type_name("LEVEL");
    add_backend(*run, flags.backend);
    run->add_flag("--images", flags.images, "Keep frame_0000.png ... and contact_sheet.png");
    run->add_flag("--vdb", flags.vdb, "Keep vel_0000.vdb ... for Blender and Houdini");
    run->add_flag("--csv", flags.csv, "Keep timings.csv: a row a step with every figure it reports");
}

ReadCommand read_run(const RunFlags& flags, const CLI::App& run, const Console& console) {
    RunRequest request{.scene = flags.scene, .frames = {}, .out = {}, .vdb = flags.vdb, .images = flags.images, .csv = flags.csv};
    const auto backend = read_backend(flags.backend, run, console);
    if (!backend)
        return k_exit_wrong_use;
    request.backend = *backend;
    if (run.count("--frames") > 0) {
        request.frames = read_count(flags.frames, "--frames", scene::k_most_frames, console);
        if (!request.frames)
            return k_exit_wrong_use;
    }
    if (run.count("--threads") > 0) {
        const auto threads = read_count(flags.threads, "--threads", k_most_threads, console);
        if (!threads)
            return k_exit_wrong_use;
        request.threads = static_cast<int>(*threads);
    }
    if (run.count("--simd") > 0) {
        const auto level = read_simd(flags.simd, console);
        if (!level)
            return k_exit_wrong_use;
        request.simd = *level;
    }
    if (run.count("--out") > 0) {
        if (flags.out.empty()) {
            console.complain("--out is empty: name a folder.");
            return k_exit_wrong_use;
        }
        request.out = flags.out;
    }
    if (flags.scene.empty()) {
        console.complain("SCENE.json is empty: name a scene file.");
        return k_exit_wrong_use;
    }
    return [request, &console] {
        const InterruptGuard guard;
        return run_scene(request, console, &InterruptGuard::signal);
    };
}

ReadCommand read_check_command(const CheckFlags& flags, const CLI::App& check, const Console& console) {
    const auto request = read_check(flags, check, console);
    if (!request)
        return k_exit_wrong_use;
#if WINDROW_WITH_VULKAN
    return [request, &console] {
        const InterruptGuard guard;
        return run_check(*request, console, &InterruptGuard::signal);
    };
#else
    return k_exit_wrong_use; // read_check has said so
#endif
}

// "--out --vdb" would name a folder "--vdb" and keep nothing.
std::string flag_as_value(const CLI::App& app) {
    for (const CLI::App* command : app.get_subcommands())
        for (const CLI::Option* option : command->get_options())
            for (const std::string& value : option->results())
                if (value.starts_with("--") && option->get_expected_min() > 0)
                    return message(option->get_name(), " has no value: ", value, " is a flag; write ./", value,
                                   " for a file of that name.");
    return {};
}

} // namespace

ReadCommand read_command_line(int count, const char* const* arguments, const Console& console) {
    CLI::App app("Windrow: the wind around a player, as a voxel fluid.", "windrow");
    app.set_version_flag("--version", version_line());
    app.require_subcommand(1);
    app.footer("Exit codes: 0 well, 1 a result out of bounds, 2 wrong use or bad input, 3 the machine lacks something.");
    RunFlags flags;
    add_run(app, flags);
    BenchFlags bench_flags;
    add_bench(app, bench_flags);
    VerifyFlags verify_flags;
    add_verify(app, verify_flags);
    ParetoFlags pareto_flags;
    add_pareto(app, pareto_flags);
    CheckFlags check_flags;
    add_check(app, check_flags);
    std::string plants_out;
    CLI::App* const plants =
        app.add_subcommand("plants", "Tell how far plants bend in which wind, and how they move; table and curves");
    plants->add_option("--out", plants_out, "Folder for plants.csv, which ./dev plots draws; default out/plants")
        ->type_name("DIR");
    app.add_subcommand("info", "Tell version, compiler, SIMD level, cores, Vulkan devices and what is built in");
    try {
        app.parse(count, arguments);
    } catch (const CLI::Success& wish) {
        app.exit(wish, console.out, console.err); // --help and --version
        return k_exit_well;
    } catch (const CLI::ParseError& fault) {
        console.complain(sentence_of(fault, app, count, arguments));
        return k_exit_wrong_use;
    }
    if (const std::string swallowed = flag_as_value(app); !swallowed.empty()) {
        console.complain(swallowed);
        return k_exit_wrong_use;
    }
    if (const CLI::App* run = app.get_subcommand("run"); run->parsed())
        return read_run(flags, *run, console);
    if (const CLI::App* bench = app.get_subcommand("bench"); bench->parsed()) {
        const auto request = read_bench(bench_flags, *bench, console);
        if (!request)
            return k_exit_wrong_use;
        return [request, &console] {
            const InterruptGuard guard;
            return run_bench(*request, console, &InterruptGuard::signal);
        };
    }
    if (const CLI::App* verify = app.get_subcommand("verify"); verify->parsed()) {
        const auto request = read_verify(verify_flags, *verify, verify_cases(), console);
        if (!request)
            return k_exit_wrong_use;
        return [request, &console] {
            const InterruptGuard guard;
            return run_verify(*request, console, &InterruptGuard::signal);
        };
    }
    if (const CLI::App* pareto = app.get_subcommand("pareto"); pareto->parsed()) {
        const auto request = read_pareto(pareto_flags, *pareto, console);
        if (!request)
            return k_exit_wrong_use;
        return [request, &console] {
            const InterruptGuard guard;
            return run_pareto(*request, console, &InterruptGuard::signal);
        };
    }
    if (const CLI::App* check = app.get_subcommand("check"); check->parsed())
        return read_check_command(check_flags, *check, console);
    if (plants->parsed()) {
        if (plants->count("--out") > 0 && plants_out.empty()) {
            console.complain("--out is empty: name a folder.");
            return k_exit_wrong_use;
        }
        const auto folder = plants_out.empty() ? std::filesystem::path("out") / "plants" : std::filesystem::path(plants_out);
        return [folder, &console] { return run_plants(folder, console); };
    }
    return [&console] { return tell_info(console); };
}

int run_command_line(int count, const char* const* arguments, const Console& console) {
    const ReadCommand read = read_command_line(count, arguments, console);
    const int* const code = std::get_if<int>(&read);
    return code != nullptr ? *code : std::get<std::function<int()>>(read)();
}

} // namespace windrow::cli
