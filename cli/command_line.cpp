#include "cli/bench/bench_command.h"
#include "cli/console.h"
#include "cli/flags.h"
#include "cli/info_command.h"
#include "cli/pareto/pareto_command.h"
#include "cli/plants/plants_command.h"
#include "cli/run_command.h"
#include "cli/verify/verify_command.h"
#include "cli/view_command.h"
#if WINDROW_WITH_VULKAN
#include "cli/check/check_command.h"
#include "cli/device_report/device_report_command.h"
#endif
#include "fluid/core/message.h"
#include "scene/nearest_word.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
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
    const auto unknown = [&](const char* what, const std::string& word) {
        return message(what, word, scene::did_you_mean(word, words_of(asked)), ": ", help);
    };
    const auto extras = app.remaining(true);
    if (dynamic_cast<const CLI::ExtrasError*>(&fault) != nullptr && !extras.empty()) {
        // A flag that is not known leaves its value over too: the flag is the one to name.
        const auto flag =
            std::find_if(extras.begin(), extras.end(), [](const std::string& word) { return word.starts_with('-'); });
        return flag != extras.end() ? unknown("unknown option ", *flag) : unknown("unexpected argument ", extras.front());
    }
    if (chosen.empty()) {
        const std::string word = unknown_command(count, arguments);
        if (word == "draw")
            return "draw is not a command of windrow: windrow-draw draws pictures and films of scenes; see windrow-draw --help.";
        if (!word.empty())
            return unknown("unknown command ", word);
        if (count > 1)
            return unknown("unknown option ", arguments[1]);
        return message("name a command, run, view, bench, verify, pareto, plants, check, device-report or info: ", help);
    }
    std::string words = fault.what();
    for (char& letter : words)
        if (letter == '\n')
            letter = ' ';
    return message(words, ": ", help);
}

// Parses the flags into what is asked for; `chosen` runs it.
void parse(CLI::App& app, int count, const char* const* arguments, std::function<int()>& chosen, const Console& console) {
    app.set_version_flag("--version", version_line());
    app.require_subcommand(1);
    app.footer("Exit codes: 0 well, 1 a result out of bounds, 2 wrong use or bad input, 3 the machine lacks something.");
    add_run(app, chosen, console);
    add_view(app, chosen, console);
    add_bench(app, chosen, console);
    add_verify(app, cases::verify_cases(), chosen, console);
    add_pareto(app, chosen, console);
#if WINDROW_WITH_VULKAN
    add_check(app, chosen, console);
    add_device_report(app, chosen, console);
#else
    for (const char* const name : {"check", "device-report"})
        app.add_subcommand(name, "For a Vulkan device: not built in")->allow_extras()->callback([name] {
            reject(name, " runs on Vulkan, which is not built in: build with WINDROW_VULKAN=ON.");
        });
#endif
    add_plants(app, chosen, console);
    CLI::App* const info =
        app.add_subcommand("info", "Print version, compiler, SIMD level, cores, Vulkan devices and the options of this build");
    const auto licences = std::make_shared<bool>(false);
    info->add_flag("--licences", *licences, "Print the licence and those of what is linked, and nothing else");
    info->callback([&chosen, &console, licences] {
        chosen = [&console, licences] { return *licences ? print_licences(console) : run_info(console); };
    });
    app.parse(count, arguments);
}

} // namespace

ReadCommand read_command_line(int count, const char* const* arguments, const Console& console) {
    CLI::App app("Windrow: the wind around a player, as a voxel fluid.", "windrow");
    std::function<int()> chosen;
    try {
        parse(app, count, arguments, chosen, console);
    } catch (const CLI::Success& wish) {
        app.exit(wish, console.out, console.err); // --help and --version
        return k_exit_well;
    } catch (const WrongFlag& fault) {
        console.complain(fault.what());
        return k_exit_wrong_use;
    } catch (const CLI::ParseError& fault) {
        console.complain(sentence_of(fault, app, count, arguments));
        return k_exit_wrong_use;
    }
    return chosen;
}

int run_command_line(int count, const char* const* arguments, const Console& console) {
    const ReadCommand read = read_command_line(count, arguments, console);
    const int* const code = std::get_if<int>(&read);
    return code != nullptr ? *code : std::get<std::function<int()>>(read)();
}

} // namespace windrow::cli
