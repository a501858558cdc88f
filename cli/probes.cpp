#include "cli/probes.h"

#include "cli/table.h"
#include "fluid/core/message.h"
#include "scene/number_text.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace windrow::cli {
namespace {

using detail::message;

constexpr int k_max_points = 100'000;

/// Parts of a text between a letter.
std::vector<std::string_view> split(std::string_view text, char between) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(between, begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

glm::dvec3 read_place(const std::string& text, std::string_view place) {
    const auto numbers = split(place, ',');
    glm::dvec3 found(0.0);
    for (std::size_t n = 0; n < 3; ++n) {
        const auto number = numbers.size() == 3 ? scene::parse_number(numbers[n]) : std::nullopt;
        if (!number || !(std::abs(*number) <= 1e12))
            reject("--probe is ", shown(text), ": give NAME=X,Y,Z in metres, or NAME=X,Y,Z:X,Y,Z:COUNT for points along a line.");
        found[static_cast<int>(n)] = *number;
    }
    return found;
}

ProbeRequest::Line read_line(const std::string& text) {
    const std::size_t equals = text.find('=');
    ProbeRequest::Line line{.name = text.substr(0, equals)};
    if (equals == std::string::npos || line.name.empty() || line.name.find_first_of(",\"\n") != std::string::npos)
        reject("--probe is ", shown(text), ": begin with a name without commas and quotes, such as mast=0,10,0.");
    const auto ends = split(std::string_view(text).substr(equals + 1), ':');
    line.from = line.to = read_place(text, ends[0]);
    if (ends.size() == 1)
        return line;
    if (ends.size() != 3)
        reject("--probe is ", shown(text), ": give both ends and a count, NAME=X,Y,Z:X,Y,Z:COUNT.");
    line.to = read_place(text, ends[1]);
    line.count = static_cast<int>(read_count(std::string(ends[2]), "--probe's count", k_max_points));
    return line;
}

} // namespace

void add_probes(Flags& flags, CLI::App& command, ProbeRequest& request) {
    flags.values("--probe", "NAME=X,Y,Z[:X,Y,Z:COUNT]",
                 "Keep probes.csv: the wind at a point, or at points along a line, after each step",
                 [&request](const std::string& text) { request.lines.push_back(read_line(text)); });
    command.add_flag("--forces", request.forces, "Keep forces.csv: force, moment and pressure on each obstacle after each step");
}

Probes::Probes(const ProbeRequest& request, const std::filesystem::path& folder, KeepText keep, const Tables& begun)
    : request_(&request) {
    const auto open = [&](const char* name, std::string_view header, std::string_view rows) {
        return std::make_unique<OutputFile>(folder / name, keep, rows.empty() ? header : rows);
    };
    if (!request.lines.empty())
        probes_ = open("probes.csv", "time_s,probe,point,x_m,y_m,z_m,u_m_s,v_m_s,w_m_s\n", begun.probes);
    for (const ProbeRequest::Line& line : request.lines)
        for (int n = 0; n < line.count; ++n)
            points_.push_back(line.from + (line.to - line.from) * (line.count > 1 ? n / (line.count - 1.0) : 0.0));
    found_.resize(points_.size());
    if (request.forces)
        forces_ =
            open("forces.csv", "time_s,obstacle,name,in_box,fx_n,fy_n,fz_n,mx_n_m,my_n_m,mz_n_m,pressure_pa\n", begun.forces);
}

Probes::Tables Probes::tables() const {
    return {.probes = probes_ ? std::string_view(probes_->text()) : std::string_view(),
            .forces = forces_ ? std::string_view(forces_->text()) : std::string_view()};
}

Fault Probes::follow(const Playback& playback) {
    if (probes_) {
        playback.wind().velocity(points_, found_);
        std::size_t at = 0;
        std::string rows;
        for (const ProbeRequest::Line& line : request_->lines)
            for (int n = 0; n < line.count; ++n, ++at)
                rows += message(playback.time(), ",", line.name, ",", n, ",", points_[at].x, ",", points_[at].y, ",",
                                points_[at].z, ",", found_[at].x, ",", found_[at].y, ",", found_[at].z, "\n");
        probes_->write(rows);
    }
    if (forces_ && playback.steps() > 0) {
        const auto& obstacles = playback.scene().obstacles;
        for (std::size_t n = 0; n < obstacles.size(); ++n) {
            const ObstacleId id = playback.air().obstacle(n);
            if (playback.wind().obstacles().find(id) == nullptr)
                continue;
            const auto acting = playback.wind().reader().force_on(id);
            if (!acting)
                return {.sentence = acting.error(), .machine = acting.failure().fault != windrow::Fault::rejected};
            forces_->write(message(playback.time(), ",", n, ",", csv_field(obstacles[n].name), ",", acting->in_box ? 1 : 0, ",",
                                   acting->force.x, ",", acting->force.y, ",", acting->force.z, ",", acting->moment.x, ",",
                                   acting->moment.y, ",", acting->moment.z, ",", acting->pressure, "\n"));
        }
    }
    return {};
}

Fault Probes::publish() {
    for (const auto& file : {probes_.get(), forces_.get()})
        if (file != nullptr)
            if (auto fault = file->publish())
                return fault;
    return {};
}

} // namespace windrow::cli
