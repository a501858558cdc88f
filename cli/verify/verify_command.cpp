#include "cli/verify/verify_command.h"

#include "cli/flags.h"
#include "cli/info_command.h"
#include "cli/output_file.h"
#include "cli/table.h"
#include "fluid/thread_pool.h"
#include "scene/nearest_word.h"

#include <algorithm>
#include <iterator>
#include <memory>

namespace windrow::cli {

using namespace cases;

namespace {

const VerifyCase* find_case(std::span<const VerifyCase> cases, const std::string& name) {
    const auto found = std::find_if(cases.begin(), cases.end(), [&](const VerifyCase& one) { return one.name == name; });
    return found == cases.end() ? nullptr : &*found;
}

[[noreturn]] void reject_case(const std::string& name, std::span<const VerifyCase> known) {
    if (name.empty())
        reject("--case is empty: see windrow verify --list.");
    if (std::find(std::begin(k_spectral_names), std::end(k_spectral_names), name) != std::end(k_spectral_names))
        reject("--case is ", name, ", whose truth is solved by FFTW: run ", k_where_fftw_is, ".");
    std::vector<std::string> names;
    for (const VerifyCase& one : known)
        names.push_back(one.name);
    reject("--case is ", name, ", which is unknown", scene::did_you_mean(name, names), ": see windrow verify --list.");
}

bool runs(const VerifyCase& one, BackendKind backend) {
    return one.runs_on == RunsOn::all || (one.runs_on == RunsOn::cpu) == (backend == BackendKind::cpu);
}

[[noreturn]] void reject_backend(const VerifyCase& one) {
    if (one.runs_on == RunsOn::cpu)
        reject("--case is ", one.name, ", which runs on the CPU only: drop --backend vulkan.");
    reject("--case is ", one.name, ", which compares a device with the CPU: add --backend vulkan.");
}

// The cases that are named, or all that the backend can run.
void choose_cases(const std::vector<std::string>& names, std::span<const VerifyCase> known, VerifyRequest& request) {
    const BackendKind backend = request.backend.kind;
    for (const std::string& name : names) {
        const VerifyCase* const found = find_case(known, name);
        if (found == nullptr)
            reject_case(name, known);
        if (!runs(*found, backend))
            reject_backend(*found);
        if (find_case(request.cases, name) == nullptr)
            request.cases.push_back(*found);
    }
    if (!names.empty())
        return;
    for (const VerifyCase& one : known) {
        if (request.list || runs(one, backend))
            request.cases.push_back(one);
        else if (one.runs_on == RunsOn::cpu)
            request.left_out.push_back(one.name);
    }
}

} // namespace

void add_verify(CLI::App& app, std::span<const VerifyCase> known, std::function<int()>& chosen, const Console& console) {
    CLI::App* const verify = app.add_subcommand("verify", "Hold the solver against known solutions; exit 1 where one is missed");
    const auto request = std::make_shared<VerifyRequest>();
    const auto names = std::make_shared<std::vector<std::string>>();
    Flags flags(*verify);
    flags.values("--case", "NAME", "Cases to run; default all", [names](const std::string& name) { names->push_back(name); });
    verify->add_flag("--list", request->list, "List the cases and run none");
    flags.backend(request->backend);
    flags.threads(request->threads, "Threads; default one a core; errors do not depend on it");
    flags.simd(request->simd, "levels differ by rounding");
    flags.file("--json", request->json, "File for all errors and bounds; written atomically");
    flags.folder("--plots", request->plots, "Folder for the curves of cases that have some, as CSV for ./dev plots");
    flags.part(request->part, "cases, dealt out in turn");
    flags.values("--join", "FILE", "Make the file --json of those of all parts; no case is run",
                 [request](const std::string& file) { request->join.emplace_back(file); });
    verify->callback([=, &chosen, &console] {
        check_backend(*verify, request->backend);
        choose_cases(*names, known, *request);
        if (!request->join.empty()) {
            for (const char* const other : {"--part", "--list", "--plots"})
                if (verify->count(other) > 0)
                    reject("--join is given with ", other, ": it runs nothing, drop one of them.");
            if (!request->json)
                reject("--join needs --json, the file to make: add it.");
            chosen = [request, &console] { return join_verify(*request, console); };
            return;
        }
        if (!request->part.is_whole()) {
            std::int64_t place = 0;
            std::erase_if(request->cases, [&](const VerifyCase&) { return !request->part.holds(place++); });
        }
        for (const char* const output : {"--json", "--plots"})
            if (request->list && verify->count(output) > 0)
                reject(output, " is given with --list, which runs nothing: drop one of them.");
        chosen = interruptible<VerifyRequest>(run_verify, request, console);
    });
}

int run_verify(const VerifyRequest& request, const Console& console, const std::function<int()>& stop_signal) {
    if (request.list) {
        report_list(request.cases, console);
        return k_exit_well;
    }
    const auto file = request.json ? std::make_unique<OutputFile>(*request.json, "--json") : nullptr;
    if (file)
        if (const auto fault = file->fault())
            return complain_of(fault, console);
    OutputFolder folder;
    if (request.plots)
        if (const Fault fault = folder.open(*request.plots))
            return complain_of(fault, console);

    Backend backend;
    if (const auto fault = open_backend(request.backend, backend))
        return complain_of(fault, console);
    const auto pool = make_pool(request.threads, console);
    const VerifySetting setting{.simd = request.simd, .parallel_for = pool->parallel_for(), .backend = backend, .stopped = [&] {
                                    return stop_signal() != 0;
                                }};
    report_setting(pool->size(), request.simd, backend.device_words(), console);
    std::vector<VerifiedCase> verified;
    for (const VerifyCase& one : request.cases) {
        report_case(one, console);
        verified.push_back({.name = one.name});
        std::vector<PlotCurve> curves;
        for (std::size_t level = 0; level < one.sizes.size(); ++level) {
            if (const int signal = stop_signal(); signal != 0)
                return k_exit_signal + signal;
            const VerifyRows found = one.run(setting, one.sizes[level]);
            if (const int signal = stop_signal(); signal != 0)
                return k_exit_signal + signal;
            if (!backend.fault().empty())
                return complain_of(Fault{.sentence = one.name + ": " + backend.fault(), .machine = true}, console);
            for (const VerifyRow& row : found.rows) {
                verified.back().rows.push_back(judge(one, verified.back(), level, row, request.known));
                report_row(one, verified.back().rows.back(), console);
            }
            for (const PlotCurve& curve : found.curves)
                curves.push_back({one.name, curve.panel, curve.line, curve.points});
        }
        if (!request.plots || curves.empty())
            continue;
        const std::filesystem::path place = *request.plots / (one.name + ".csv");
        OutputFile page(place);
        page.write(plot_csv(curves));
        if (const Fault fault = page.publish())
            return complain_of(fault, console);
        console.out << "In " << place.string() << ": curves; ./dev plots " << request.plots->string() << " draws them.\n";
    }
    report_end(verified, request.left_out, console);
    if (file) {
        file->write(verify_json(request, backend.device_words(), verified));
        if (const auto fault = file->publish())
            return complain_of(fault, console);
        console.out << "In " << request.json->string() << ": all errors and bounds.\n";
    }
    const bool well = std::all_of(verified.begin(), verified.end(),
                                  [](const VerifiedCase& one) { return one.well() && one.met_unexpectedly().empty(); });
    return well ? k_exit_well : k_exit_out_of_bounds;
}

} // namespace windrow::cli
