#include "cli/verify/verify_command.h"

#include "cli/exit_code.h"
#include "cli/machine.h"
#include "cli/output_file.h"
#include "cli/plot_csv.h"
#include "cli/verify/verify_json.h"
#include "cli/verify/verify_report.h"
#include "fluid/thread_pool.h"

#include <algorithm>
#include <memory>

namespace windrow::cli {

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
    if (const auto fault = backend.open(request.backend))
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
            for (const VerifyCurve& curve : found.curves)
                curves.push_back({one.name, curve.panel, curve.name, curve.points});
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
