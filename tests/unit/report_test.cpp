// Each figure of a step's report is its row (fluid/diagnostics.h), and the row reaches all readers: timings.csv, the console's table
// of stages, docs/report.md. The C struct is made from the rows too (tools/make_bindings.py).
#include "cli/timings.h"
#include "fluid/core/message.h"
#include "tests/scene_schema.h"

#include <algorithm>
#include <concepts>
#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace windrow::cli {
namespace {

const std::filesystem::path k_source = WINDROW_SOURCE_DIR;

std::vector<std::string> fields_of(const std::string& line) {
    std::istringstream stream(line.substr(0, line.find('\n')));
    std::vector<std::string> fields;
    for (std::string field; std::getline(stream, field, ',');)
        fields.push_back(field);
    return fields;
}

/// Sets the figures to 1, 2, 3 and so on; `cells`: each by name as it is in a CSV file.
void number(auto& report, std::vector<std::pair<std::string, std::string>>& cells) {
    for_each_row(report, [&](const auto& row, auto& value) {
        using Value = std::remove_reference_t<decltype(value)>;
        if constexpr (std::is_class_v<Value>) {
            number(value, cells);
        } else if constexpr (std::is_enum_v<Value>) {
            value = static_cast<Value>(2);
            cells.emplace_back(row.name, k_words<Value>[2]);
        } else {
            value = static_cast<Value>(cells.size() + 1);
            cells.emplace_back(row.name, std::same_as<Value, bool> ? "1" : detail::message(cells.size() + 1));
        }
    });
}

template <class Report>
void expect_rows_of_its_members() {
    Report report;
    std::set<std::string> names;
    std::set<const void*> members;
    for_each_row(report, [&](const auto& row, const auto& value) { // which compiles where there are as many rows as members
        names.insert(row.name);
        members.insert(&value);
        EXPECT_GT(std::string(row.meaning).size(), 10u) << row.name;
    });
    EXPECT_EQ(names.size(), std::tuple_size_v<decltype(Report::rows())>);
    EXPECT_EQ(members.size(), names.size()) << "two rows of one member";
}

TEST(Report, EachMemberHasItsRow) {
    expect_rows_of_its_members<Diagnostics>();
    expect_rows_of_its_members<StageTimes>();
    EXPECT_STREQ(StageTimes::rows().back().name, "total") << "the last row is the whole";
}

TEST(Report, EachRowIsAColumnOfTheCsv) {
    Diagnostics report;
    std::vector<std::pair<std::string, std::string>> cells;
    number(report, cells);
    const std::vector<std::string> header = fields_of(timings_header()), row = fields_of(timings_row(7, 0.5, report));
    ASSERT_EQ(header.size(), 2 + cells.size());
    ASSERT_EQ(row.size(), header.size());
    EXPECT_EQ(row[0] + " " + row[1], "7 0.5");
    for (std::size_t n = 0; n < cells.size(); ++n) {
        EXPECT_TRUE(header[n + 2].starts_with(cells[n].first)) << header[n + 2] << " is not of " << cells[n].first;
        EXPECT_EQ(row[n + 2], cells[n].second) << header[n + 2];
    }
    // Columns that scripts of users may read by name.
    for (const char* name : {"step", "time_s", "max_speed_m_s", "cfl", "carried_time_s", "diffusion", "divergence_rms_1_s",
                             "energy_m5_s2", "sources_ms", "total_ms"})
        EXPECT_EQ(std::count(header.begin(), header.end(), name), 1) << name;
}

TEST(Report, StagesWithTheRestAreTheWhole) {
    Timings timings;
    Diagnostics report;
    double stages = 0.0;
    for (std::size_t n = 0; n < k_stage_count; ++n)
        stages += report.times_ms.*StageTimes::rows()[n].member = 0.5 * static_cast<double>(n + 1);
    report.times_ms.total = stages + 0.75;
    timings.add(0.0, report);
    const std::string table = timings.table();
    std::istringstream lines(table);
    std::string line, name;
    std::getline(lines, line);
    std::map<std::string, double> median;
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        std::getline(words >> std::ws, name, ' ');
        if (name == "whole")
            words >> line; // step
        double least = 0.0;
        words >> least >> median[name];
    }
    double sum = median["rest"];
    for (std::size_t n = 0; n < k_stage_count; ++n) {
        EXPECT_EQ(median[StageTimes::rows()[n].name], 0.5 * static_cast<double>(n + 1)) << table;
        sum += median[StageTimes::rows()[n].name];
    }
    EXPECT_EQ(median["rest"], 0.75) << table;
    EXPECT_EQ(median["whole"], sum) << table;
    EXPECT_EQ(median.size(), k_stage_count + 2) << table;
}

void write_table(std::string& text, const auto& report) {
    text += "\n| name | unit | meaning |\n|---|---|---|\n";
    for_each_row(report, [&]<class Value>(const auto& row, const Value&) {
        std::string unit = row.unit;
        for (const char* word : k_words<Value>)
            unit += detail::message(unit.empty() ? "`" : ", `", word, "`");
        text += detail::message("| `", row.name, "` | ", unit, " | ", row.meaning, " |\n");
    });
}

TEST(Report, IsMadeOfItsRows) {
    std::string page = "# Report of a step\n\n"
                       "To keep the figures of each step, run `windrow run SCENE --csv`: `timings.csv` has a row a step.\n"
                       "A figure's column is named with its unit, `max_speed_m_s` for one. A flag is 0 or 1 there.\n"
                       "`Wind::step` returns the same figures as `Diagnostics`, `windrow_wind_step` as `windrow_diagnostics`.\n\n"
                       "This page is made by `./dev schema` from the tables in `fluid/diagnostics.h`.\n\n## Diagnostics\n";
    write_table(page, Diagnostics{});
    page += "\n## Stages\n\n"
            "`Diagnostics::times_ms` has the time of each stage. The table that a run prints shows what belongs to no stage\n"
            "as `rest`.\n";
    write_table(page, StageTimes{});
    test::expect_file(k_source / "docs/report.md", page);
}

} // namespace
} // namespace windrow::cli
