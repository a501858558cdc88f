#include "vegetation/program/stage_table.h"

#include "fluid/core/message.h"
#include "fluid/files/input_file.h"
#include "fluid/files/new_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>

namespace windrow::vegetation::program {
namespace {

double mib(std::uint64_t bytes) {
    return static_cast<double>(bytes) / 1048576.0;
}

StageFigures figures_of(std::string name, std::vector<double> times) {
    std::sort(times.begin(), times.end());
    const auto at = [&](double share) {
        return times[static_cast<std::size_t>(std::ceil(share * static_cast<double>(times.size()))) - 1];
    };
    const std::size_t middle = times.size() / 2;
    return {.name = std::move(name),
            .mean = std::accumulate(times.begin(), times.end(), 0.0) / static_cast<double>(times.size()),
            .median = times.size() % 2 == 1 ? times[middle] : 0.5 * (times[middle - 1] + times[middle]),
            .max = at(0.99)};
}

} // namespace

StageTable::StageTable(const SceneRenderer& scene_renderer) {
    const SceneRendererMemory memory = scene_renderer.memory();
    char text[256];
    std::snprintf(text, sizeof text,
                  "memory: %.1f MiB pictures, shadows, ground and trees, %.1f wind, %.1f grass, %.1f ground's memory\n",
                  mib(memory.targets), mib(memory.wind), mib(memory.grass), mib(memory.ground_memory));
    what_ = text;
}

void StageTable::add(std::int64_t frame, const std::vector<render::StageTime>& times) {
    if (times.empty())
        return;
    if (names_.empty())
        for (const render::StageTime& stage : times)
            names_.emplace_back(stage.name);
    std::vector<double> row;
    for (const render::StageTime& stage : times)
        row.push_back(1e-3 * stage.us);
    if (row.size() != names_.size())
        return; // another kind of frame: not of this table
    frames_.push_back(frame);
    rows_.push_back(std::move(row));
}

std::vector<StageFigures> StageTable::figures() const {
    std::vector<StageFigures> made;
    if (rows_.empty())
        return made;
    std::vector<double> sums(rows_.size(), 0.0);
    for (std::size_t stage = 0; stage < names_.size(); ++stage) {
        std::vector<double> times;
        for (std::size_t row = 0; row < rows_.size(); ++row) {
            times.push_back(rows_[row][stage]);
            sums[row] += rows_[row][stage];
        }
        made.push_back(figures_of(names_[stage], std::move(times)));
    }
    made.push_back(figures_of("frame", std::move(sums)));
    return made;
}

std::string StageTable::text() const {
    std::string text = what_;
    char line[128];
    const std::vector<StageFigures> all = figures();
    if (all.empty())
        return text + "this device has no timestamps: no stage is timed\n";
    std::snprintf(line, sizeof line, "%-10s %10s %10s %10s  over %zu frames\n", "ms", "mean", "median", "99 %", rows_.size());
    text += line;
    for (const StageFigures& stage : all) {
        std::snprintf(line, sizeof line, "%-10s %10.2f %10.2f %10.2f\n", stage.name.c_str(), stage.mean, stage.median, stage.max);
        text += line;
    }
    return text;
}

windrow::Result<void> StageTable::write(const std::filesystem::path& file) const {
    std::string text = "frame";
    for (const std::string& name : names_)
        text += "," + name + "_ms";
    text += '\n';
    for (std::size_t row = 0; row < rows_.size(); ++row) {
        text += std::to_string(frames_[row]);
        for (const double time : rows_[row]) {
            char figure[32];
            std::snprintf(figure, sizeof figure, ",%.4f", time);
            text += figure;
        }
        text += '\n';
    }
    return windrow::detail::write_file("table", file, text);
}

std::string StageTable::name(const windrow::scene::Part& part) {
    return part.is_whole() ? "times.csv" : windrow::detail::message("times.", part.number, "-of-", part.count, ".csv");
}

windrow::Result<void> StageTable::join(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> parts;
    std::error_code unreadable;
    for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable))
        if (const std::string file = entry.path().filename().string();
            file.starts_with("times.") && file.find("-of-") != file.npos && file.ends_with(".csv"))
            parts.push_back(entry.path());
    if (parts.empty())
        return {};
    std::string text;
    std::map<long long, std::string> rows;
    for (const std::filesystem::path& part : parts) {
        const auto table = windrow::detail::read_input(part, {.max_bytes = std::size_t{1} << 30});
        if (!table)
            return table.failure();
        const std::size_t body = std::min(table->find('\n'), table->size() - 1) + 1;
        text = table->substr(0, body);
        for (std::size_t begin = body; begin < table->size();) {
            const std::size_t end = std::min(table->find('\n', begin), table->size() - 1) + 1;
            const std::string row = table->substr(begin, end - begin);
            const auto frame = windrow::scene::parse_whole_number(row.substr(0, row.find(',')));
            if (!frame)
                return windrow::Error{windrow::detail::message(part.string(), ": is not a table of a part: remove it.")};
            rows[*frame] = row;
            begin = end;
        }
    }
    for (const auto& [frame, row] : rows)
        text += row;
    if (auto written = windrow::detail::write_file("table", folder / "times.csv", text); !written)
        return written;
    for (const std::filesystem::path& part : parts)
        std::filesystem::remove(part, unreadable);
    return {};
}

} // namespace windrow::vegetation::program
