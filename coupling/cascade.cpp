#include "coupling/cascade.h"

#include "fluid/core/archive.h"
#include "fluid/core/validation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

namespace windrow {
namespace {

constexpr detail::Format k_cascade_format{"WINDLAGS", detail::Layout("cascade 1").with<CascadeConfig>().version(),
                                          "saved cascade", "Cascade::save"};

bool finite(glm::dvec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// x, y, z, and a quaternion of length 1.
void write_parts(const Pose& pose, double* parts) {
    const glm::dvec4 q = pose.rotation / glm::length(pose.rotation);
    for (int n = 0; n < 3; ++n)
        parts[n] = pose.position[n];
    for (int n = 0; n < 4; ++n)
        parts[3 + n] = q[n];
}

} // namespace

Result<void> validate(const CascadeConfig& config) {
    return detail::validate_settings(config, "cascade");
}

Result<void> validate(const Pose& pose) {
    detail::Reasons reasons;
    if (!finite(pose.position))
        reasons.add("Pose::position is ", pose.position, ": give three finite numbers.");
    const double length = glm::length(pose.rotation);
    if (!(length > 1e-150) || !std::isfinite(length))
        reasons.add("Pose::rotation is a quaternion of length ", length,
                    ": give a finite one that is not 0, such as (0, 0, 0, 1).");
    if (!(pose.scale > 0.0) || !std::isfinite(pose.scale))
        reasons.add("Pose::scale is ", pose.scale, ": give a number above 0.");
    return reasons.outcome();
}

Result<Cascade> Cascade::create(const CascadeConfig& config, const Pose& body) {
    if (auto valid = validate(config); !valid)
        return valid.failure();
    auto step = CascadeStep::create(config.stages);
    if (!step)
        return step.failure();
    return detail::where_memory_lasts([&]() -> Result<Cascade> {
        Cascade cascade(config, *std::move(step));
        const auto stages = static_cast<std::size_t>(config.stages);
        for (Row* row : {&cascade.now_, &cascade.before_})
            row->stages.resize(stages * k_parts);
        cascade.poses_.resize(stages + 1);
        cascade.previous_poses_.resize(stages + 1);
        if (auto rested = cascade.reset(body); !rested)
            return rested.failure();
        return cascade;
    });
}

Result<void> Cascade::advance(double duration, const Pose& body) {
    if (auto valid = validate(body); !valid)
        return valid;
    if (auto set = step_.set(config_.stages / config_.lag, duration); !set)
        return set;
    std::copy(std::begin(now_.body), std::end(now_.body), std::begin(before_.body));
    std::copy(now_.stages.begin(), now_.stages.end(), before_.stages.begin());
    before_.scale = now_.scale;
    write_parts(body, now_.body);
    now_.scale = body.scale;
    // q and -q are the same rotation. The sign closer to the last one gives the short way between them.
    double along = 0.0;
    for (std::size_t n = 3; n < k_parts; ++n)
        along += now_.body[n] * before_.body[n];
    for (std::size_t n = 3; n < k_parts && along < 0.0; ++n)
        now_.body[n] = -now_.body[n];
    return advance_cascades<double>(step_, {now_.stages, before_.body, now_.body});
}

Result<void> Cascade::reset(const Pose& body) {
    if (auto valid = validate(body); !valid)
        return valid;
    for (Row* row : {&now_, &before_}) {
        write_parts(body, row->body);
        row->scale = body.scale;
        for (std::size_t n = 0; n < row->stages.size(); ++n)
            row->stages[n] = row->body[n % k_parts];
    }
    return {};
}

Result<void> Cascade::move(glm::dvec3 offset) {
    if (!finite(offset))
        return Error{detail::message("Cascade::move got ", offset, ": give three finite numbers.")};
    for (Row* row : {&now_, &before_})
        for (int n = 0; n < 3; ++n) {
            row->body[n] += offset[n];
            for (std::size_t at = static_cast<std::size_t>(n); at < row->stages.size(); at += k_parts)
                row->stages[at] += offset[n];
        }
    return {};
}

// Bytes of a row, whose stages have their number, and back.
void Cascade::fields(auto& archive, auto& row) {
    constexpr double k_farthest = 1e300, k_unit = 1e-6; // differences of such places are numbers
    for (auto& part : row.body)
        archive(part);
    for (auto& part : row.stages)
        archive(part);
    archive(row.scale);
    if constexpr (detail::Reading<decltype(archive)>) {
        double square = 0.0;
        for (std::size_t n = 3; n < k_parts; ++n)
            square += row.body[n] * row.body[n];
        archive.require(std::abs(square - 1.0) <= k_unit, "the rotation of its body is not of length 1.");
        archive.require(row.scale > 0.0, "its scale is not above 0.");
        const auto holds = [&](std::size_t n, double part) {
            return std::abs(part) <= (n % k_parts < 3 ? k_farthest : 1.0 + k_unit);
        };
        for (std::size_t n = 0; n < row.stages.size(); ++n)
            archive.require(holds(n, row.stages[n]) && holds(n, row.body[n % k_parts]), "a stage is out of range.");
    }
}

Result<std::vector<std::byte>> Cascade::save() const {
    return detail::where_memory_lasts([&]() -> Result<std::vector<std::byte>> {
        detail::Writer writer(256 + 2 * now_.stages.size() * sizeof(double));
        writer(config_);
        for (const Row* row : {&now_, &before_})
            fields(writer, *row);
        return std::move(writer).finish(k_cascade_format);
    });
}

Result<Cascade> Cascade::load(std::span<const std::byte> bytes) {
    return detail::where_memory_lasts([&]() -> Result<Cascade> {
        std::optional<Cascade> cascade;
        auto read = detail::read_sealed(bytes, k_cascade_format, [&](detail::Reader& reader) {
            CascadeConfig config;
            reader(config);
            if (reader.rejected())
                return;
            auto made = create(config, {});
            if (!made)
                return reader.reject(made.error());
            cascade = *std::move(made);
            for (Row* row : {&cascade->now_, &cascade->before_})
                fields(reader, *row);
        });
        if (!read)
            return read.failure();
        return *std::move(cascade);
    });
}

// As windrow_cascade_stage, windrow_cascade_fraction and windrow_pose_between, in double.
Pose Cascade::read(const Row& row, double height) const {
    const double at = std::clamp(height >= 0.0 ? height : 0.0, 0.0, 1.0) * config_.stages;
    const auto low = std::min(static_cast<std::size_t>(at), static_cast<std::size_t>(config_.stages) - 1);
    const double share = at - static_cast<double>(low);
    const double* const from = low == 0 ? row.body : &row.stages[(low - 1) * k_parts];
    const double* const to = &row.stages[low * k_parts];
    double parts[k_parts];
    for (std::size_t n = 0; n < k_parts; ++n)
        parts[n] = from[n] + share * (to[n] - from[n]);
    Pose pose{.position = {parts[0], parts[1], parts[2]}, .rotation = {0.0, 0.0, 0.0, 1.0}, .scale = row.scale};
    const glm::dvec4 q(parts[3], parts[4], parts[5], parts[6]);
    if (const double length = glm::length(q); length > 1e-10)
        pose.rotation = q / length;
    return pose;
}

Pose Cascade::at(double height) const {
    return read(now_, height);
}
Pose Cascade::previous_at(double height) const {
    return read(before_, height);
}

std::span<const PoseBlock> Cascade::poses_of(const Row& row, glm::dvec3 anchor, std::vector<PoseBlock>& poses) {
    for (std::size_t n = 0; n < poses.size(); ++n) {
        const double* const parts = n == 0 ? row.body : &row.stages[(n - 1) * k_parts];
        poses[n].place = glm::vec4(glm::dvec3(parts[0], parts[1], parts[2]) - anchor, row.scale);
        poses[n].rotation = glm::vec4(glm::dvec4(parts[3], parts[4], parts[5], parts[6]));
    }
    return poses;
}

std::span<const PoseBlock> Cascade::shader_poses(glm::dvec3 anchor) {
    return poses_of(now_, anchor, poses_);
}
std::span<const PoseBlock> Cascade::previous_shader_poses(glm::dvec3 anchor) {
    return poses_of(before_, anchor, previous_poses_);
}

} // namespace windrow
