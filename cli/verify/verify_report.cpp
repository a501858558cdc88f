#include "cli/output_file.h"
#include "cli/table.h"
#include "cli/verify/verify_command.h"
#include "fluid/core/message.h"
#include "fluid/files/input_file.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

namespace windrow::cli {

using namespace cases;

namespace {

using detail::message;

constexpr std::size_t k_grid_width = 13, k_width = 10;

std::string line(std::string_view grid, std::string_view cfl, std::string_view error, std::string_view bound,
                 std::string_view order, std::string_view least, std::string_view verdict, std::string_view label) {
    return right(grid, k_grid_width) + right(cfl, k_width - 2) + right(error, k_width) + right(bound, k_width) +
           right(order, k_width) + right(least, k_width) + (verdict.empty() ? "" : "   ") + std::string(verdict) +
           (label.empty() ? "" : "  ") + std::string(label) + "\n";
}

// Words behind a label, wrapped; further lines stand under the first word.
std::string wrapped(std::string_view label, std::string_view words) {
    constexpr std::size_t k_line = 100;
    std::string text = "  " + std::string(label);
    const std::string indent(text.size(), ' ');
    std::size_t column = text.size();
    while (!words.empty()) {
        const std::size_t end = std::min(words.find(' '), words.size());
        if (column + 1 + end > k_line && column > indent.size()) {
            text += "\n" + indent;
            column = indent.size();
        } else if (column > indent.size()) {
            text += ' ';
            ++column;
        }
        text += words.substr(0, end);
        column += end;
        words.remove_prefix(std::min(end + 1, words.size()));
    }
    return text + "\n";
}

} // namespace

void report_list(std::span<const VerifyCase> cases, const Console& console) {
    for (const VerifyCase& one : cases)
        console.out << one.name << "\n" << wrapped("", one.what);
    console.out.flush();
}

void report_setting(int threads, Simd simd, const std::string& device, const Console& console) {
    const std::string cpu = message(threads, threads == 1 ? " thread" : " threads", " (", name_of(simd), ")");
    console.out << message("Errors against known solutions, ", device.empty() ? cpu : device,
                           ". An order is that of the error between a line and the coarser one above.\n");
    console.out.flush();
}

void report_case(const VerifyCase& one, const Console& console) {
    console.out << "\n"
                << one.name << "\n"
                << wrapped("", one.what) << wrapped("truth: ", one.source) << wrapped("bound: ", one.reason)
                << line("grid", "CFL", "error", "at most", "order", "at least", "", "");
    console.out.flush();
}

void report_row(const VerifyCase& one, const VerifiedRow& verified, const Console& console) {
    const VerifyRow& row = verified.row;
    const bool ordered = one.min_order > 0.0 && verified.order; // rounding has no order
    console.out << line(grid_name(row.cells), row.cfl > 0.0 ? to_fixed(row.cfl, 2) : "-", to_scientific(row.error, 2),
                        to_scientific(row.bound, 2), ordered ? to_fixed(*verified.order, 2) : "-",
                        ordered ? to_fixed(one.min_order, 2) : "-", verified.verdict(), row.label);
    console.out.flush();
}

void report_end(std::span<const VerifiedCase> cases, std::span<const std::string> left_out, const Console& console) {
    std::string failed, missed, met;
    std::size_t count = 0;
    for (const VerifiedCase& one : cases) {
        if (!one.well()) {
            failed += (count == 0 ? "" : ", ") + one.name;
            ++count;
        }
        for (const std::string& label : one.met_unexpectedly())
            met += (met.empty() ? "" : ", ") + one.name + (label.empty() ? "" : " (" + label + ")");
        if (std::any_of(one.rows.begin(), one.rows.end(), [](const VerifiedRow& row) { return !row.pass && row.expected; }))
            missed += (missed.empty() ? "" : ", ") + one.name;
    }
    if (!missed.empty())
        console.out << "\n" << wrapped("not met, as known: ", missed + ".");
    if (!met.empty())
        console.complain(message("met, though cases/verify_case.cpp expects a miss: ", met, ". Take it out of that file."));
    if (!left_out.empty()) {
        std::string names;
        for (const std::string& name : left_out)
            names += (names.empty() ? "" : ", ") + name;
        console.out << "\n" << wrapped("left out: ", message(names, ", which run on the CPU only."));
    }
    const std::string all = message(cases.size(), cases.size() == 1 ? " case" : " cases");
    if (count == 0)
        console.out << "\n"
                    << all
                    << (missed.empty() ? ": each within its bounds.\n" : ": each within its bounds, or known not to be.\n");
    else
        console.complain(message(count, " of ", all, count == 1 ? " is" : " are", " out of bounds: ", failed, "."));
    console.out.flush();
}

int join_verify(const VerifyRequest& request, const Console& console) {
    using Json = nlohmann::ordered_json;
    std::map<std::string, std::pair<std::size_t, Json>> found; // the part and the rows of a case
    for (std::size_t at = 0; at < request.join.size(); ++at) {
        const std::filesystem::path& file = request.join[at];
        const auto text = detail::read_input(file, {.max_bytes = std::size_t{64} << 20});
        if (!text) {
            console.complain(text.error());
            return k_exit_wrong_use;
        }
        const Json part = Json::parse(*text, nullptr, false);
        if (!part.is_object() || !part.contains("cases") || !part["cases"].is_array()) {
            console.complain(message(file.string(), ": is not what windrow verify --json writes: give the files of the parts."));
            return k_exit_wrong_use;
        }
        for (const Json& row : part["cases"]) {
            if (!row.is_object() || !row.contains("name") || !row["name"].is_string() ||
                (row.contains("pass") && !row["pass"].is_boolean())) {
                console.complain(
                    message(file.string(), ": is not what windrow verify --json writes: give the files of the parts."));
                return k_exit_wrong_use;
            }
            const auto name = row["name"].get<std::string>();
            auto& [from, rows] = found.try_emplace(name, at, Json::array()).first->second;
            if (from != at) {
                console.complain(message(file.string(), ": has the case ", name, ", as ", request.join[from].string(),
                                         " has: give each part once."));
                return k_exit_wrong_use;
            }
            rows.push_back(row);
        }
    }
    Json entries = Json::array();
    for (const VerifyCase& one : request.cases) {
        const auto rows = found.find(one.name);
        if (rows == found.end()) {
            console.complain(
                message("--join has no file with the case ", one.name, ": run its part, or name the cases with --case."));
            return k_exit_wrong_use;
        }
        for (Json& row : rows->second.second)
            entries.push_back(std::move(row));
        found.erase(rows);
    }
    if (!found.empty()) {
        console.complain(message(request.join[found.begin()->second.first].string(), ": has the case ", found.begin()->first,
                                 ", which is not asked for: drop the file, or add --case."));
        return k_exit_wrong_use;
    }
    OutputFile file(*request.json, "--json");
    file.write(Json{{"cases", entries}}.dump(2) + "\n");
    if (const Fault fault = file.publish())
        return complain_of(fault, console);
    const auto bad = [](const Json& row) { return !row.value("pass", false) && row.value("verdict", "") != "not met"; };
    const auto out = std::count_if(entries.begin(), entries.end(), bad);
    console.out << message("In ", request.json->string(), ": ", entries.size(), " rows of ", request.cases.size(), " cases, ",
                           out, " out of bounds.\n");
    return out == 0 ? k_exit_well : k_exit_out_of_bounds;
}

std::string verify_json(const VerifyRequest& request, const std::string& device, std::span<const VerifiedCase> verified) {
    using Json = nlohmann::ordered_json;
    Json entries = Json::array();
    for (std::size_t n = 0; n < verified.size(); ++n)
        for (const VerifiedRow& one : verified[n].rows) {
            const double min_order = request.cases[n].min_order;
            entries.push_back({{"name", verified[n].name},
                               {"label", one.row.label.empty() ? Json() : Json(one.row.label)},
                               {"backend", request.backend.kind == BackendKind::cpu ? "cpu" : "vulkan"},
                               {"device", device.empty() ? Json() : Json(device)},
                               {"grid", grid_name(one.row.cells)},
                               {"cfl", one.row.cfl},
                               {"error", one.row.error}, // what is not finite becomes null
                               {"order", one.order ? Json(*one.order) : Json()},
                               {"bound", one.row.bound},
                               {"min_order", one.order && min_order > 0.0 ? Json(min_order) : Json()},
                               {"pass", one.pass},
                               {"verdict", one.verdict()}});
        }
    return Json{{"cases", entries}}.dump(2) + "\n";
}

} // namespace windrow::cli
