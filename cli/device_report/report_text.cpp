#include "cli/device_report/report_section.h"
#include "cli/table.h"
#include "fluid/core/message.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace windrow::cli {
namespace {

using detail::message;
using Cells = std::vector<std::pair<std::string, std::string>>; ///< column and value

std::string value_text(const ReportJson& value) {
    if (value.is_string())
        return value.get<std::string>();
    if (value.is_boolean())
        return value.get<bool>() ? "yes" : "no";
    if (value.is_null())
        return "-";
    if (value.is_number_float()) {
        const double number = value.get<double>();
        return number >= 1e3 && number < 1e9 ? to_fixed(number, 0) : to_digits(number, 4);
    }
    return value.dump(-1, ' ', false, ReportJson::error_handler_t::replace);
}

// The members of an object in a row; those of an object within it by both names: "us median".
void add_cells(Cells& cells, const std::string& prefix, const ReportJson& object) {
    for (const auto& [key, value] : object.items())
        if (value.is_object())
            add_cells(cells, prefix + key + " ", value);
        else
            cells.emplace_back(prefix + key, value_text(value));
}

bool is_table(const ReportJson& value) {
    return value.is_array() && !value.empty() && value.front().is_object();
}

std::vector<Cells> rows_of(const ReportJson& table) {
    std::vector<Cells> rows;
    for (const ReportJson& row : table)
        add_cells(rows.emplace_back(), "", row);
    return rows;
}

// Columns as wide as their widest value; the first at the left, the others at the right. Columns are the first row's.
std::string table_text(const ReportJson& table) {
    const std::vector<Cells> rows = rows_of(table);
    std::string text;
    for (std::size_t line = 0; line <= rows.size(); ++line) {
        for (std::size_t column = 0; column < rows[0].size(); ++column) {
            std::size_t width = rows[0][column].first.size();
            for (const Cells& row : rows)
                width = std::max(width, column < row.size() ? row[column].second.size() : 0);
            const Cells& row = rows[line == 0 ? 0 : line - 1];
            const std::string cell = column >= row.size() ? "" : line == 0 ? row[column].first : row[column].second;
            text += column == 0 ? "  " + cell + std::string(width - cell.size(), ' ') : right(cell, width + 2);
        }
        text += "\n";
    }
    return text;
}

std::string markdown(const ReportJson& table) {
    const std::vector<Cells> rows = rows_of(table);
    std::string text = "|", rule = "|";
    for (const auto& [column, value] : rows[0]) {
        text += " " + column + " |";
        rule += "---|";
    }
    text += "\n" + rule + "\n";
    for (const Cells& row : rows) {
        text += "|";
        for (const auto& [column, value] : row)
            text += " " + value + " |";
        text += "\n";
    }
    return text;
}

const ReportJson* find(const ReportJson& json, std::initializer_list<const char*> path) {
    const ReportJson* at = &json;
    for (const char* const key : path) {
        const auto found = at->is_object() ? at->find(key) : at->end();
        if (!at->is_object() || found == at->end())
            return nullptr;
        at = &*found;
    }
    return at;
}

} // namespace

double four_digits(double value) {
    if (!(std::abs(value) > 0.0) || !std::isfinite(value))
        return value;
    const double scale = std::pow(10.0, 3.0 - std::floor(std::log10(std::abs(value))));
    return std::round(value * scale) / scale;
}

ReportJson spread_json(const DeviceSpread& us, double factor) {
    return {{"median", four_digits(us.median * factor)}, {"p99", four_digits(us.p99 * factor)}, {"samples", us.samples}};
}

std::string section_text(const ReportJson& section) {
    constexpr std::size_t k_longest = 100; // lists of extensions are in the file
    std::string text;
    for (const auto& [key, value] : section.items()) {
        if (is_table(value)) {
            text += table_text(value);
        } else if (value.is_array()) {
            for (const ReportJson& item : value)
                text += "  " + key + ": " + value_text(item) + "\n";
        } else if (value.is_object()) {
            for (const auto& [inner, of_inner] : value.items())
                text += "  " + inner + ": " + value_text(of_inner) + "\n";
        } else if (const std::string words = value_text(value); words.size() <= k_longest) {
            text += "  " + key + ": " + words + "\n";
        }
    }
    return text;
}

std::string readme_table(const ReportJson& report) {
    const ReportJson* const steps = find(report, {"sections", "times", "steps"});
    const ReportJson* const facts = find(report, {"sections", "facts"});
    if (steps == nullptr || facts == nullptr || !is_table(*steps))
        return "";
    const bool software = facts->value("software", false);
    std::string text = message("| ", value_text((*facts)["device"]), software ? " (software)" : "",
                               " | step, us, median | 99 % | read-back, us | copy floor, us |\n|---|---|---|---|---|\n");
    for (const ReportJson& row : *steps)
        if (row.contains("left_out"))
            text += message("| ", value_text(row["grid"]), " | ", value_text(row["left_out"]), " | - | - | - |\n");
        else if (row.value("recording", "") == "step, one sub-step")
            text += message("| ", value_text(row["grid"]), " | ", value_text(row["us"]["median"]), " | ",
                            value_text(row["us"]["p99"]), " | ", value_text(row["read_back_us"]["median"]), " | ",
                            value_text(row["copy_floor_us"]), " |\n");
    return text;
}

std::string report_page(const ReportJson& report) {
    const ReportJson* const facts = find(report, {"sections", "facts"});
    std::string text = "# A device\n\n";
    if (facts != nullptr)
        text += message(value_text((*facts)["device"]), "; ", value_text((*facts)["driver"]), "; Vulkan ",
                        value_text((*facts)["vulkan"]), ". Host: ", value_text((*facts)["host"]), ". ",
                        value_text(report["program"]), ", commit ", value_text(report["commit"]), ".\n");
    if (facts != nullptr && facts->value("software", false))
        text += "A software device: its times are none of a GPU.\n";
    if (const std::string table = readme_table(report); !table.empty())
        text += "\n## For a README\n" + table;
    for (const auto& [name, section] : report["sections"].items()) {
        if (name == "facts")
            continue;
        text += "\n## " + name + "\n";
        for (const auto& [key, value] : section.items()) {
            if (is_table(value))
                text += (text.ends_with("|\n") ? "\n" : "") + markdown(value);
            else if (key == "error")
                text += "Failed: " + value_text(value) + "\n";
            else if (key == "left_out")
                for (const ReportJson& item : value)
                    text += "- left out: " + value_text(item) + "\n";
        }
    }
    return text;
}

} // namespace windrow::cli
