#include "cli/pareto/pareto_command.h"

#include "cli/flags.h"
#include "cli/info_command.h"
#include "cli/output_file.h"
#include "fluid/core/message.h"
#include "fluid/thread_pool.h"
#include "scene/nearest_word.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace windrow::cli {

using namespace cases;

namespace {

using detail::message;

bool check_memory(const ParetoRequest& request, const Console& console) {
    const auto available = available_memory();
    for (const ParetoFlow& flow : request.flows) {
        const std::uint64_t needed = flow_run_bytes(flow);
        if (available && needed > *available) {
            console.complain(message(flow.name, " takes about ", needed >> 20, " MiB, and ", *available >> 20,
                                     " MiB are free: give --quick, or free some memory."));
            return false;
        }
    }
    return true;
}

/// Flows on which the default method broke.
std::string broken(const ParetoResult& result) {
    std::string names;
    for (const FlowResult& flow : result.flows)
        for (const ParetoRow& row : flow.rows)
            if (row.method == k_default_method && !std::isfinite(row.error)) {
                names += (names.empty() ? "" : ", ") + flow.name;
                break;
            }
    return names;
}

std::vector<std::string> names_of(const std::vector<ParetoFlow>& flows) {
    std::vector<std::string> names;
    for (const ParetoFlow& flow : flows)
        names.push_back(flow.name);
    return names;
}

// The flows that are named, or all.
std::vector<ParetoFlow> chosen_flows(bool quick, const std::vector<std::string>& names) {
    std::vector<ParetoFlow> flows = pareto_flows(quick);
    const std::vector<std::string> known = names_of(flows);
    for (const std::string& name : names)
        if (std::find(known.begin(), known.end(), name) == known.end())
            reject("--flow is ", shown(name), ", which is none", scene::did_you_mean(name, known),
                   ": see windrow pareto --help.");
    if (!names.empty())
        std::erase_if(flows,
                      [&](const ParetoFlow& flow) { return std::find(names.begin(), names.end(), flow.name) == names.end(); });
    return flows;
}

} // namespace

void add_pareto(CLI::App& app, std::function<int()>& chosen, const Console& console) {
    CLI::App* const pareto = app.add_subcommand("pareto", "Find the least error for the time: methods, grids, steps; table, CSV");
    const auto request = std::make_shared<ParetoRequest>();
    const auto quick = std::make_shared<bool>(false);
    const auto out = std::make_shared<std::optional<std::filesystem::path>>();
    const auto names = std::make_shared<std::vector<std::string>>();
    Flags flags(*pareto);
    std::string flows;
    for (const std::string& name : names_of(pareto_flows(false)))
        flows += (flows.empty() ? "" : ", ") + name;
    flags.values("--flow", "NAME", "Flows to run, of " + flows + "; default all",
                 [names](const std::string& name) { names->push_back(name); });
    pareto->add_flag("--quick", *quick, "Fewer flows, grids and steps: two minutes on two cores instead of 15");
    flags.folder("--out", *out, "Folder for pareto.csv, which ./dev plots draws; default out/pareto");
    flags.backend(request->backend);
    flags.threads(request->threads, "Most threads; default one a core; errors do not depend on it");
    flags.simd(request->simd, "all methods run on them");
    flags.part(request->part, "flows, dealt out in turn; give each part an --out of its own");
    flags.values("--join", "DIR", "Make pareto.csv in --out of those in the folders of all parts; no flow is run",
                 [request](const std::string& folder) { request->join.emplace_back(folder); });
    pareto->callback([=, &chosen, &console] {
        check_backend(*pareto, request->backend);
        request->flows = chosen_flows(*quick, *names);
        request->cfls = *quick ? std::vector{1.0, 2.0} : std::vector{0.5, 1.0, 2.0, 4.0};
        request->one_thread_too = !*quick;
        request->seconds = *quick ? 0.4 : 1.5;
        request->out = out->value_or(std::filesystem::path("out") / "pareto");
        if (!request->join.empty()) {
            if (pareto->count("--part") > 0)
                reject("--join is given with --part: it runs nothing, drop one of them.");
            chosen = [request, &console] { return join_pareto(*request, console); };
            return;
        }
        if (!request->part.is_whole()) {
            std::int64_t place = 0;
            std::erase_if(request->flows, [&](const ParetoFlow&) { return !request->part.holds(place++); });
        }
        chosen = interruptible<ParetoRequest>(run_pareto, request, console);
    });
}

int run_pareto(const ParetoRequest& request, const Console& console, const std::function<int()>& stop_signal) {
    if (!check_memory(request, console))
        return k_exit_machine;
    OutputFolder output;
    if (const Fault fault = output.open(request.out))
        return complain_of(fault, console);
    Backend backend;
    if (const Fault fault = open_backend(request.backend, backend))
        return complain_of(fault, console);
    if (request.threads > usable_cores())
        console.complain(message("--threads is ", request.threads, ", more than the ", usable_cores(),
                                 " cores: the threads wait for each other, which makes the times longer."));
    const auto pool = make_pool(request.threads, console);
    const int threads = pool->size();
    const std::function<bool()> stopped = [&] { return stop_signal() != 0; };
    ParetoResult result{.device = backend.is_cpu() ? device_name() : backend.device_words(),
                        .simd = name_of(request.simd),
                        .backend = backend.kind(),
                        .threads = threads,
                        .flows = {}};
    report_pareto_start(result, console);
    for (const ParetoFlow& flow : request.flows) {
        console.out << "\n" << flow.name << ": " << flow.what << "\n";
        console.out.flush();
        auto found = run_flow(flow, request, threads, pool->parallel_for(), backend, console, stopped);
        if (!found && backend.fault().empty()) {
            console.complain(found.error());
            return backend.is_cpu() ? k_exit_wrong_use : k_exit_machine; // a device that has no room
        }
        if (!backend.fault().empty())
            return complain_of(Fault{.sentence = flow.name + ": " + backend.fault(), .machine = true}, console);
        if (!*found)
            return k_exit_signal + stop_signal();
        report_front(**found, threads, console);
        result.flows.push_back(std::move(**found));
    }
    OutputFile csv(request.out / "pareto.csv");
    csv.write(pareto_csv(result));
    if (const Fault fault = csv.publish())
        return complain_of(fault, console);
    console.out << "\nIn " << request.out.string() << ": pareto.csv with all figures; ./dev plots " << request.out.string()
                << " draws the fronts.\n";
    if (const std::string names = broken(result); !names.empty()) {
        console.complain(message("the default method broke on ", names, ": its error is not finite."));
        return k_exit_out_of_bounds;
    }
    return k_exit_well;
}

} // namespace windrow::cli
