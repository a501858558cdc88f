#include "cli/verify/verify_flags.h"

#include "cli/flags.h"
#include "cli/run_command.h"
#include "fluid/message.h"
#include "scene/nearest_word.h"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace windrow::cli {
namespace {

using detail::message;

const VerifyCase* find_case(std::span<const VerifyCase> cases, const std::string& name) {
    const auto found = std::find_if(cases.begin(), cases.end(), [&](const VerifyCase& one) { return one.name == name; });
    return found == cases.end() ? nullptr : &*found;
}

void complain_of_case(const std::string& name, std::span<const VerifyCase> known, const Console& console) {
    if (name.empty()) {
        console.complain("--case is empty: see windrow verify --list.");
        return;
    }
    std::vector<std::string> names;
    for (const VerifyCase& one : known)
        names.push_back(one.name);
    const std::string near = scene::nearest_word(name, names);
    console.complain(message("--case is ", name, ", which is no case", near.empty() ? "" : " (did you mean " + near + "?)",
                             ": see windrow verify --list."));
}

bool runs(const VerifyCase& one, BackendKind backend) {
    return one.runs_on == RunsOn::all || (one.runs_on == RunsOn::cpu) == (backend == BackendKind::cpu);
}

void complain_of_backend(const VerifyCase& one, const Console& console) {
    if (one.runs_on == RunsOn::cpu)
        console.complain(message("--case is ", one.name,
                                 ", which asks for pieces that a device runs only inside a step: drop --backend vulkan."));
    else
        console.complain(message("--case is ", one.name, ", which compares a device with the CPU: add --backend vulkan."));
}

} // namespace

void add_verify(CLI::App& app, VerifyFlags& flags) {
    CLI::App* const verify = app.add_subcommand("verify", "Hold the solver against known solutions; exit 1 where one is missed");
    verify->add_option("--case", flags.cases, "Cases to run; default all")->type_name("NAME");
    verify->add_flag("--list", flags.list, "Tell the cases and run none");
    add_backend(*verify, flags.backend);
    verify->add_option("--threads", flags.threads, "Threads; default one a core; errors do not depend on it")->type_name("N");
    verify->add_option("--simd", flags.simd, "Instructions: best, baseline, avx2 or avx512; levels differ by rounding")
        ->type_name("LEVEL");
    verify->add_option("--json", flags.json, "File for all errors and bounds; written whole or not at all")->type_name("FILE");
    verify->add_option("--plots", flags.plots, "Folder for the curves of cases that have some, as CSV for ./dev plots")
        ->type_name("DIR");
}

std::optional<VerifyRequest> read_verify(const VerifyFlags& flags, const CLI::App& verify, std::span<const VerifyCase> known,
                                         const Console& console) {
    VerifyRequest request{.list = flags.list};
    const auto backend = read_backend(flags.backend, verify, console);
    if (!backend)
        return std::nullopt;
    request.backend = *backend;
    for (const std::string& name : flags.cases) {
        const VerifyCase* const found = find_case(known, name);
        if (found == nullptr) {
            complain_of_case(name, known, console);
            return std::nullopt;
        }
        if (!runs(*found, backend->kind)) {
            complain_of_backend(*found, console);
            return std::nullopt;
        }
        if (find_case(request.cases, name) == nullptr)
            request.cases.push_back(*found);
    }
    if (request.cases.empty())
        for (const VerifyCase& one : known) {
            if (flags.list || runs(one, backend->kind))
                request.cases.push_back(one);
            else if (one.runs_on == RunsOn::cpu)
                request.left_out.push_back(one.name);
        }
    if (verify.count("--threads") > 0) {
        const auto threads = read_count(flags.threads, "--threads", k_most_threads, console);
        if (!threads)
            return std::nullopt;
        request.threads = static_cast<int>(*threads);
    }
    if (verify.count("--simd") > 0) {
        const auto level = read_simd(flags.simd, console);
        if (!level)
            return std::nullopt;
        request.simd = *level;
    }
    const auto read_output = [&](const std::string& flag, const std::string& given, const char* kind,
                                 std::optional<std::filesystem::path>& path) {
        if (verify.count(flag) == 0)
            return true;
        path = given;
        if (given.empty())
            console.complain(message(flag, " is empty: name a ", kind, "."));
        else if (flags.list)
            console.complain(message(flag, " is given with --list, which runs nothing: drop one of them."));
        return !given.empty() && !flags.list;
    };
    if (!read_output("--json", flags.json, "file", request.json) || !read_output("--plots", flags.plots, "folder", request.plots))
        return std::nullopt;
    return request;
}

} // namespace windrow::cli
