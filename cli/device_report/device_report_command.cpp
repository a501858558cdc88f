#include "cli/device_report/device_report_command.h"

#include "cli/backend.h"
#include "cli/device_report/report_section.h"
#include "cli/flags.h"
#include "cli/info_command.h"
#include "cli/output_file.h"
#include "fluid/thread_pool.h"

#include <algorithm>
#include <utility>

namespace windrow::cli {
namespace {

using detail::message;

constexpr int k_report_version = 1; // of report.json

std::string section_names() {
    std::string names;
    for (const ReportSection& section : report_sections())
        names += (names.empty() ? "" : ", ") + std::string(section.name);
    return names;
}

// The folder of a report while it is written.
class Report {
  public:
    Report(std::filesystem::path folder, const DeviceReportRequest& request) : folder_(std::move(folder)) {
        json_ = {{"version", k_report_version},     {"program", version_line()}, {"compiler", compiler_name()},
                 {"commit", commit_name()},         {"quick", request.quick},    {"complete", false},
                 {"sections", ReportJson::object()}};
    }
    [[nodiscard]] ReportJson& json() { return json_; }
    [[nodiscard]] ReportJson& section(const char* name) { return json_["sections"][name]; }

    /// report.json as far as it is.
    [[nodiscard]] Fault save() const {
        // A device's name may hold any byte.
        return save("report.json", json_.dump(2, ' ', false, ReportJson::error_handler_t::replace) + "\n");
    }
    [[nodiscard]] Fault finish() {
        json_["complete"] = true;
        if (Fault fault = save())
            return fault;
        return save("report.md", report_page(json_));
    }

  private:
    [[nodiscard]] Fault save(const char* name, const std::string& text) const {
        OutputFile file(folder_ / name);
        file.write(text);
        return file.publish();
    }

    std::filesystem::path folder_;
    ReportJson json_;
};

/// The device with a queue that draws, where it has one.
Fault open_for_report(int place, std::unique_ptr<vulkan::OwnDevice>& device, bool& draws) {
    device.reset();
    draws = !open_device({.device = place, .queue = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT}, device);
    return draws ? Fault() : open_device({.device = place}, device);
}

} // namespace

const std::vector<ReportSection>& report_sections() {
    static const std::vector<ReportSection> sections = {
        {"facts", "the device, its driver and its limits", 0.0, &report_facts},
        {"costs", "launch, barrier, indirect dispatch, copy; bandwidth of caches and memory", 0.08, &report_costs},
        {"times", "a step, a walk, their passes, beside the copy floor", 0.25, &report_times},
        {"parity", "the stories of windrow check on each path, against the CPU", 0.37, &report_parity},
        {"queries", "wind and ground memory in a shader, against the CPU", 0.03, &report_queries},
        {"pipelines", "what the driver's compiler makes of each pipeline", 0.02, &report_pipelines},
        {"meadow", "frames with 0.25, 1 and 4 million blades in a field, and their stages", 0.2, &report_meadow},
        {"pictures", "a meadow from two viewpoints, and its wind as colours", 0.05, &report_pictures},
    };
    return sections;
}

void add_device_report(CLI::App& app, std::function<int()>& chosen, const Console& console) {
    CLI::App* const command = app.add_subcommand(
        "device-report", "Measure a Vulkan device: facts, costs, times, parity, a meadow; all figures into a folder");
    const auto request = std::make_shared<DeviceReportRequest>();
    Flags flags(*command);
    flags.folder("--out", request->out, "Folder for report.json, report.md and the pictures");
    flags.device(request->device);
    command->add_flag("--quick", request->quick, "The smallest set that uses each path once");
    flags.seconds(request->seconds, "Time for all sections together, default 600, quick 90");
    flags.values("--only", "SECTION", "Sections to run beside the facts: " + section_names(), [request](const std::string& text) {
        const auto& sections = report_sections();
        if (std::none_of(sections.begin(), sections.end(), [&](const auto& one) { return one.name == text; }))
            reject("--only is ", text.empty() ? "empty" : text, ": give ", section_names(), ".");
        request->only.push_back(text);
    });
    command->callback([=, &chosen, &console] {
        if (!request->out)
            reject("--out is missing: name a folder for the report.");
        chosen = interruptible<DeviceReportRequest>(run_device_report, request, console);
    });
}

int run_device_report(const DeviceReportRequest& request, const Console& console, const std::function<int()>& stop_signal) {
    const std::filesystem::path folder = request.out.value_or(".");
    OutputFolder output;
    if (const Fault fault = output.open(folder))
        return complain_of(fault, console);
    Report report(folder, request);
    std::unique_ptr<vulkan::OwnDevice> device;
    bool draws = false;
    add_drivers();
    Fault closed = open_for_report(request.device, device, draws);
    if (closed && closed.machine && name_drivers_only())
        closed = open_for_report(request.device, device, draws);
    if (closed) {
        report.json()["error"] = closed.sentence;
        report.json()["places_tried"] = places_tried();
        console.out << section_text(report.json());
        if (const Fault unsaved = report.save())
            return complain_of(unsaved, console);
        return complain_of(closed, console);
    }
    console.out << version_line() << " device-report; " << compiler_name() << "; commit " << commit_name() << "\n"
                << words_of(device->facts()) << "\n";
    const auto pool = make_pool(0, console);
    const double seconds = request.seconds > 0.0 ? request.seconds : request.quick ? k_quick_report_seconds : k_report_seconds;
    bool broken = false, pass = true;
    for (const ReportSection& section : report_sections()) {
        const bool facts = section.run == &report_facts;
        if (!facts && !request.only.empty() &&
            std::find(request.only.begin(), request.only.end(), section.name) == request.only.end())
            continue;
        if (device == nullptr) // lost in the section before
            if (const Fault fault = open_for_report(request.device, device, draws))
                return complain_of(fault, console);
        console.out << "\n" << section.name << ": " << section.text << "\n";
        console.out.flush();
        const ReportJson before = report.json()["sections"];
        ReportJson& json = report.section(section.name);
        json = ReportJson::object();
        SectionRun run{.own = *device,
                       .own_draws = draws,
                       .device = request.device,
                       .clock = SectionClock(section.share * seconds, [&] { return stop_signal() != 0; }),
                       .quick = request.quick,
                       .folder = folder,
                       .parallel_for = pool->parallel_for(),
                       .sections = before,
                       .json = json};
        if (const auto ran = section.run(run); !ran) {
            json["error"] = ran.error();
            console.complain(ran.error());
            broken = true;
            device.reset();
        }
        pass = pass && json.value("pass", true);
        json["seconds"] = four_digits(run.clock.past());
        console.out << section_text(json);
        if (const Fault fault = report.save())
            return complain_of(fault, console);
        if (const int signal = stop_signal(); signal != 0) {
            console.warn(message("stopped in the section ", section.name, ": ", (folder / "report.json").string(),
                                 " holds the figures so far."));
            return k_exit_signal + signal;
        }
    }
    if (const Fault fault = report.finish())
        return complain_of(fault, console);
    console.out << "\n" << report_page(report.json()) << "\nIn " << folder.string() << ": report.json, report.md.\n";
    if (!pass)
        return k_exit_out_of_bounds;
    return broken ? k_exit_machine : k_exit_well;
}

} // namespace windrow::cli
