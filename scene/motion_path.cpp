#include "scene/motion_path.h"

#include "fluid/core/message.h"
#include "scene/number_text.h"
#include "scene/text_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace windrow::scene {
namespace {

using detail::message;

constexpr std::size_t k_max_bytes = std::size_t{64} << 20;

std::string_view trim(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == text.npos)
        return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The first four fields of a line, and their total number: a line may be only commas.
struct CsvFields {
    std::array<std::string_view, 4> text{};
    std::size_t count = 0;
};

CsvFields split(std::string_view line) {
    CsvFields fields;
    for (;;) {
        const std::size_t comma = line.find(',');
        if (fields.count < fields.text.size())
            fields.text[fields.count] = trim(line.substr(0, comma));
        ++fields.count;
        if (comma == line.npos)
            return fields;
        line.remove_prefix(comma + 1);
    }
}

/// A text of the file, cut to fit a sentence.
std::string quote(std::string_view text) {
    constexpr std::size_t k_longest = 40;
    return message("\"", text.substr(0, k_longest), text.size() > k_longest ? "..." : "", "\"");
}

bool is_header(const CsvFields& fields) {
    return fields.count == 4 && fields.text == std::array<std::string_view, 4>{"t", "x", "y", "z"};
}

/// One line's point, or the reason why it is invalid.
Result<PathPoint> read_point(const CsvFields& fields) {
    if (fields.count != 4)
        return Error{message("has ", fields.count, fields.count == 1 ? " field" : " fields",
                             ": give four, t,x,y,z, with commas between them.")};
    constexpr const char* k_names[] = {"t", "x", "y", "z"};
    double values[4] = {};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto value = parse_number(fields.text[i]);
        if (!value)
            return Error{message(k_names[i], " is ", quote(fields.text[i]), ": give a finite number.")};
        if (std::abs(*value) > MotionPath::k_farthest)
            return Error{message(k_names[i], " is ", figure(*value), ": give ", figure(-MotionPath::k_farthest), " to ",
                                 figure(MotionPath::k_farthest), ".")};
        values[i] = *value;
    }
    return PathPoint{.time = values[0], .position = {values[1], values[2], values[3]}};
}

} // namespace

glm::dvec3 MotionPath::at(double time) const {
    if (points_.empty())
        return glm::dvec3(0.0);
    const auto next =
        std::upper_bound(points_.begin(), points_.end(), time, [](double t, const PathPoint& point) { return t < point.time; });
    if (next == points_.begin())
        return points_.front().position;
    if (next == points_.end())
        return points_.back().position;
    const PathPoint& before = *(next - 1);
    const double share = (time - before.time) / (next->time - before.time);
    // Written so that equal points give that point to the bit, and a fraction of 0 the point before.
    return before.position + share * (next->position - before.position);
}

Result<MotionPath> parse_path_csv(std::string_view text, const std::string& name) {
    std::vector<PathPoint> points;
    std::size_t line_number = 0;
    bool header_allowed = true;
    while (!text.empty()) {
        const std::size_t line_break = text.find('\n');
        const std::string_view line = trim(text.substr(0, line_break));
        text.remove_prefix(line_break == text.npos ? text.size() : line_break + 1);
        ++line_number;
        if (line.empty() || line.starts_with('#'))
            continue;
        const CsvFields fields = split(line);
        if (std::exchange(header_allowed, false)) {
            if (is_header(fields))
                continue;
            if (fields.count == 4 && !parse_number(fields.text[0]) && !parse_number(fields.text[1]))
                return Error{message(name, ":", line_number, ": the names of the columns are ", quote(line),
                                     ": put the columns in the order t,x,y,z and name them so, or leave the names out.")};
        }
        const auto point = read_point(fields);
        if (!point)
            return point.failure().after(message(name, ":", line_number, ": "));
        if (!points.empty() && !(point->time > points.back().time))
            return Error{message(name, ":", line_number, ": t is ", point->time, " s after ", points.back().time,
                                 " s: times must increase from line to line.")};
        if (points.size() == MotionPath::k_max_points)
            return Error{
                message(name, ":", line_number, ": a path holds at most ", MotionPath::k_max_points, " points: leave some out.")};
        points.push_back(*point);
    }
    if (points.empty())
        return Error{message(name, ": holds no point: give at least one line t,x,y,z.")};
    return MotionPath(std::move(points));
}

Result<MotionPath> read_path_csv(const std::filesystem::path& file, const std::filesystem::path& folder,
                                 detail::InputBudget& budget) {
    const auto text = read_text_file(file, {.folder = folder, .max_bytes = k_max_bytes}, budget);
    if (!text)
        return text.failure();
    auto path = parse_path_csv(*text, file.string());
    if (path)
        if (auto taken = budget.take_points(file.string(), path->points().size()); !taken)
            return taken.failure();
    return path;
}

} // namespace windrow::scene
