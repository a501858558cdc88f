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

// A table that was written: its head and its rows, by their frames.
struct WrittenTable {
    std::string head{};
    std::map<long long, std::string> rows{};
};

windrow::Result<WrittenTable> read_table(const std::filesystem::path& file) {
    const auto text = windrow::detail::read_input(file, {.max_bytes = std::size_t{1} << 30});
    if (!text)
        return text.failure();
    const std::size_t body = std::min(text->find('\n'), text->size() - 1) + 1;
    WrittenTable table{.head = text->substr(0, body)};
    for (std::size_t begin = body; begin < text->size();) {
        const std::size_t end = std::min(text->find('\n', begin), text->size() - 1) + 1;
        std::string row = text->substr(begin, end - begin);
        const auto frame = windrow::scene::parse_whole_number(row.substr(0, row.find(',')));
        if (!frame)
            return windrow::Error{windrow::detail::message(file.string(), ": is not a table of frames: remove it.")};
        table.rows[*frame] = std::move(row);
        begin = end;
    }
    return table;
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

windrow::Result<void> StageTable::keep(const std::filesystem::path& file, std::int64_t begun, std::int64_t end) {
    std::error_code unreadable;
    if (!std::filesystem::exists(file, unreadable))
        return {};
    const auto table = read_table(file);
    if (!table)
        return table.failure();
    kept_head_ = table->head;
    for (const auto& [frame, row] : table->rows)
        if (frame >= begun && frame < end)
            kept_rows_ += row;
    return {};
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
    if (kept_head_ == text)
        text += kept_rows_;
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
        auto table = read_table(part);
        if (!table)
            return table.failure();
        text = table->head;
        for (auto& [frame, row] : table->rows)
            rows[frame] = std::move(row);
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
