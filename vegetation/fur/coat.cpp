#include "vegetation/fur/coat.h"

#include "fluid/core/message.h"
#include "shader_words/coat_skin.h"
#include "vegetation/vulkan/calls.h"
#include "vegetation/vulkan/descriptors.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <utility>

namespace windrow::vegetation::fur {
namespace {

constexpr std::uint32_t k_group = 64;
constexpr std::size_t k_max_drawn = 1'000'000'000; // triangles a frame: beyond it a device looks hung

glm::vec3 turned(const windrow::Pose& pose, glm::vec3 v) {
    const glm::dquat turn = glm::normalize(glm::dquat(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z));
    return glm::vec3(turn * glm::dvec3(v));
}

} // namespace

Result<std::unique_ptr<Coat>> Coat::create(engine::Device& device, const render::DrawTargets& targets, const Mesh& mesh,
                                           std::span<const MeshPart> parts, const CoatSettings& settings,
                                           const CoatPictures& pictures, const windrow::Pose& body, glm::dvec3 anchor) {
    for (const Result<void>& judged : {validate(settings), validate(mesh), validate(pictures), windrow::validate(body)})
        if (!judged)
            return judged.failure();
    for (const MeshPart& part : parts)
        if (part.count == 0 || part.count % 3 != 0 || part.first > mesh.indices.size() ||
            part.count > mesh.indices.size() - part.first)
            return Error{detail::message("coat.parts names indices ", part.first, " to ", std::uint64_t{part.first} + part.count,
                                         "; give whole triangles of the mesh's ", mesh.indices.size(), ".")};
    const std::size_t triangles = mesh.indices.size() / 3;
    const auto layers =
        static_cast<std::size_t>(settings.bare ? 1 : std::max(settings.layers.shells, settings.levels.shadow_shells));
    if (triangles * layers > k_max_drawn)
        return Error{detail::message("coat.layers.shells is ", settings.layers.shells, " over ", triangles, " triangles, ",
                                     triangles * layers, " to draw; give fewer layers or a mesh of fewer: at most ", k_max_drawn,
                                     ".")};
    const std::uint64_t reach = device.limits().maxStorageBufferRange;
    if (2 * sizeof(CoatSkinBlock) * mesh.vertices.size() > reach)
        return Error{detail::message("coat.mesh has ", mesh.vertices.size(), " vertices; this device takes ",
                                     reach / (2 * sizeof(CoatSkinBlock)), " in one mesh: give a coarser one.")};
    if (const std::uint64_t bytes = packed_bytes(pictures); bytes > reach)
        return Error{detail::message("coat.maps are ", bytes, " bytes with their smaller copies; this device takes ", reach,
                                     ": give smaller pictures.")};
    if (!glm::all(glm::lessThan(glm::abs(anchor), glm::dvec3(1e10))))
        return Error{"coat.anchor is not finite or too far; give the renderer's own."};
    std::optional<windrow::Cascade> cascade;
    if (settings.inertia) {
        auto made = windrow::Cascade::create(*settings.inertia, body);
        if (!made)
            return made.failure();
        cascade.emplace(*std::move(made));
    }
    return engine::guarded([&] {
        return std::unique_ptr<Coat>(new Coat(device, targets, mesh, part_mesh(mesh, parts, settings), settings, pictures, body,
                                              std::move(cascade), anchor));
    });
}

Coat::PartMesh Coat::part_mesh(const Mesh& mesh, std::span<const MeshPart> parts, const CoatSettings& settings) {
    PartMesh made;
    constexpr std::uint32_t none = ~0u;
    std::vector<std::uint32_t> number(mesh.vertices.size(), none);
    glm::vec3 low(1e30f), high(-1e30f);
    const auto take = [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t n = first; n < first + count; ++n) {
            std::uint32_t& at = number[mesh.indices[n]];
            if (at == none) {
                at = static_cast<std::uint32_t>(made.vertices.size());
                const MeshVertex& v = mesh.vertices[mesh.indices[n]];
                made.vertices.push_back({glm::vec4(v.position, v.uv.x), glm::vec4(v.normal, v.uv.y), v.bones, v.weights});
                low = glm::min(low, v.position);
                high = glm::max(high, v.position);
                for (int bone = 0; bone < 4; ++bone)
                    if (v.weights[bone] > 0.0f)
                        made.bones = std::max(made.bones, v.bones[bone] + 1u);
            }
            made.indices.push_back(at);
        }
    };
    if (parts.empty())
        take(0, static_cast<std::uint32_t>(mesh.indices.size()));
    for (const MeshPart& part : parts)
        take(part.first, part.count);
    made.middle = 0.5f * (low + high);
    for (const CoatVertexBlock& v : made.vertices)
        made.radius = std::max(made.radius, glm::distance(glm::vec3(v.position), made.middle));
    made.drawn = static_cast<std::uint32_t>(made.vertices.size());
    if (!keeps_outside(settings))
        return made;
    // The body's other parts are skin too, which this coat's strands must not enter.
    const PartMesh own = made;
    made.indices.clear();
    take(0, static_cast<std::uint32_t>(mesh.indices.size()));
    made.patches = skin_patches(made.vertices, made.indices, settings.layers.length);
    made.narrow = narrow_vertices(made.vertices, made.drawn, made.patches, settings.layers.length);
    if (made.narrow.empty())
        return own;
    made.indices = own.indices;
    return made;
}

Coat::Coat(engine::Device& device, const render::DrawTargets& targets, const Mesh& mesh, PartMesh part,
           const CoatSettings& settings, const CoatPictures& pictures, const windrow::Pose& body,
           std::optional<windrow::Cascade> cascade, glm::dvec3 anchor)
    : objects_(device), settings_(settings), anchor_(anchor), cascade_(std::move(cascade)), body_(body),
      vertex_count_(part.drawn), skin_count_(static_cast<std::uint32_t>(part.vertices.size())),
      index_count_(static_cast<std::uint32_t>(part.indices.size())), middle_(part.middle), radius_(part.radius) {
    box_.low = mesh.low;
    box_.high = mesh.high;
    block_ = coat_block(settings, mesh, static_cast<int>(targets.colour.samples));
    shells_ = block_.shells;
    top_ = strand_top(settings.strands);
    bones_.assign(part.bones, glm::mat4(1.0f));
    bones_ahead_ = bones_;
    block_.ahead = {1 + (cascade_ ? cascade_->config().stages : 0), static_cast<int>(part.bones), 0, 0};
    posed_radius_ = radius_;
    block_.counts = {static_cast<int>(skin_count_), 0, static_cast<int>(skin_count_), cascade_ ? cascade_->config().stages : 0};
    const PackedPictures packed_pictures = packed(pictures);
    block_.pictures = packed_pictures.places;
    make_pipelines(targets);
    fill_buffers(targets, packed_pictures, part);
}

Result<void> Coat::judge_bones(std::span<const glm::mat4> bones) const {
    if (!bones.empty() && bones.size() < bones_.size())
        return Error{detail::message("coat.move has ", bones.size(), " bones; give as many as the mesh's vertices name, ",
                                     bones_.size(), ".")};
    for (const glm::mat4& bone : bones)
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                if (!(std::abs(bone[column][row]) < 1e9f))
                    return Error{"coat.move has a bone that is not finite; give rigid matrices."};
    return {};
}

Result<void> Coat::move(double seconds, const windrow::Pose& body, std::span<const glm::mat4> bones,
                        const std::optional<CoatAhead>& ahead) {
    if (auto judged = windrow::validate(body); !judged)
        return judged;
    if (auto judged = judge_bones(bones); !judged)
        return judged;
    if (ahead) {
        if (auto judged = windrow::validate(ahead->body); !judged)
            return judged;
        if (auto judged = judge_bones(ahead->bones); !judged)
            return judged;
        if (!(ahead->seconds > 0.0 && ahead->seconds <= 1.0))
            return Error{detail::message("coat.move's ahead.seconds is ", ahead->seconds, "; give a time above 0, at most 1 s.")};
    }
    if (!std::isfinite(seconds) || seconds < 0.0)
        return Error{detail::message("coat.move's seconds is ", seconds, "; give the time since the last call, 0 or more.")};
    if (cascade_) {
        const auto moved = seconds > 0.0 ? cascade_->advance(seconds, body) : cascade_->reset(body);
        if (!moved)
            return moved;
    }
    since_ = seconds > 0.0 ? since_ + seconds : 0.0;
    body_ = body;
    ahead_ = ahead ? ahead->body : body;
    const std::span<const glm::mat4> soon = ahead ? ahead->bones : bones;
    posed_radius_ = radius_;
    for (std::size_t n = 0; n < bones_.size(); ++n) {
        bones_[n] = n < bones.size() ? bones[n] : glm::mat4(1.0f);
        bones_ahead_[n] = n < soon.size() ? soon[n] : glm::mat4(1.0f);
        // A vertex lies among the places that its bones give it, each within the ball that its bone carries away.
        posed_radius_ =
            std::max(posed_radius_, radius_ + glm::distance(glm::vec3(bones_[n] * glm::vec4(middle_, 1.0f)), middle_));
    }
    block_.ahead.z = ahead ? 1 : 0;
    block_.gone.w = ahead ? static_cast<float>(1.0 / ahead->seconds) : 0.0f;
    block_.tousle.z = seconds > 1e-9 ? static_cast<float>(1.0 / seconds) : 0.0f;
    return {};
}

Result<void> Coat::set_lamps(std::span<const Lamp> lamps) {
    if (auto judged = validate(lamps); !judged)
        return judged;
    block_.drawing.w = static_cast<int>(lamps.size());
    for (std::size_t n = 0; n < lamps.size(); ++n)
        block_.lamps[n] = {glm::vec4(glm::vec3(lamps[n].position - anchor_), lamps[n].reach), glm::vec4(lamps[n].colour, 0.0f)};
    return {};
}

Result<void> Coat::set_feet(std::span<const Foot> feet) {
    if (auto judged = validate(feet); !judged)
        return judged;
    block_.drift.z = static_cast<float>(feet.size());
    for (std::size_t n = 0; n < feet.size(); ++n)
        block_.feet[n] = {glm::vec4(glm::vec3(feet[n].position - anchor_), feet[n].radius),
                          glm::vec4(feet[n].weight, 0.0f, 0.0f, 0.0f)};
    return {};
}

void Coat::set_time(double seconds) {
    // Whole turns are taken off in double.
    const double turns = settings_.strands.phase + (std::isfinite(seconds) ? seconds * settings_.wriggle_hz : 0.0);
    block_.field.points.z = static_cast<float>(turns - std::floor(turns));
    evolved_ = turns - settings_.strands.phase;
}

void Coat::drift(glm::dvec2 metres) {
    if (settings_.drifts && std::isfinite(metres.x) && std::isfinite(metres.y))
        drift_ = metres;
}

void Coat::place_pattern() {
    // Into the mesh's own space, where the pattern lies.
    const glm::dquat turn = glm::normalize(glm::dquat(body_.rotation.w, body_.rotation.x, body_.rotation.y, body_.rotation.z));
    const glm::dvec3 own = glm::inverse(turn) * glm::dvec3(drift_.x, 0.0, drift_.y) / body_.scale;
    block_.drift.x = static_cast<float>(own.x);
    block_.drift.y = static_cast<float>(own.z);
    block_.cloud = cloud_block(settings_, box_, {own.x, own.z}, evolved_);
}

void Coat::find_seen(const render::ViewBlock& frame) {
    const auto scale = static_cast<float>(body_.scale);
    const glm::vec3 middle = glm::vec3(body_.position - anchor_) + turned(body_, scale * middle_);
    // Neither form takes a strand beyond its own length but the translated one's push, droop and lag.
    float reach = 1.1f * settings_.layers.length * (1.0f + settings_.layers.bias);
    if (settings_.translated)
        reach += std::abs(settings_.layers.push) * 10.0f + settings_.layers.droop + posed_radius_;
    const float radius = scale * (posed_radius_ + reach);
    seen_ = {render::sees(frame.view_projection, middle, radius), render::sees(frame.shadow[0], middle, radius),
             render::sees(frame.shadow[1], middle, radius)};
    const float distance = std::max(glm::distance(glm::vec3(frame.eye), middle) - radius, 0.0f);
    const LayerCount layers = layers_at(settings_, distance, top_);
    block_.levels.x = layers.divisor;
    block_.layers.x = layers.drawn;
    block_.layers.w = settings_.bare                    ? std::min(settings_.levels.shadow_shells, 1)
                      : settings_.levels.shadow_strands ? settings_.levels.shadow_shells
                                                        : std::min(settings_.levels.shadow_shells, 1);
    counts_ = {.layers = seen_[0] ? layers.drawn : 0, .skipped = layers.layers - layers.drawn, .divisor = layers.divisor};
    counts_.vertices = static_cast<std::uint64_t>(counts_.layers) * index_count_ * (settings_.levels.depth_first ? 2u : 1u);
    block_.shells = scaled(shells_, scale);
    block_.levels.y = scale;
}

void Coat::write_motion(std::size_t slot) {
    auto* const poses = static_cast<windrow::PoseBlock*>(poses_[slot].mapped);
    if (cascade_) {
        const auto now = cascade_->shader_poses(anchor_);
        std::copy(now.begin(), now.end(), poses);
    } else {
        poses[0] = {glm::vec4(glm::vec3(body_.position - anchor_), static_cast<float>(body_.scale)),
                    glm::vec4(glm::normalize(body_.rotation))};
    }
    poses[block_.ahead.x] = {glm::vec4(glm::vec3(ahead_.position - anchor_), static_cast<float>(ahead_.scale)),
                             glm::vec4(glm::normalize(ahead_.rotation))};
    if (!bones_.empty()) {
        auto* const bones = static_cast<glm::mat4*>(bone_buffers_[slot].mapped);
        std::copy(bones_.begin(), bones_.end(), bones);
        std::copy(bones_ahead_.begin(), bones_ahead_.end(), bones + bones_.size());
    }
}

Result<void> Coat::prepare(const render::PassContext& context) {
    const auto slot = static_cast<std::size_t>(context.slot);
    find_seen(*context.block);
    place_pattern();
    write_motion(slot);
    std::swap(block_.counts.y, block_.counts.z);
    // How far the pattern has gone in the world since the last frame, for motion vectors.
    block_.gone = glm::vec4(first_ ? 0.0f : static_cast<float>(drift_.x - drift_before_.x), 0.0f,
                            first_ ? 0.0f : static_cast<float>(drift_.y - drift_before_.y), block_.gone.w);
    drift_before_ = drift_;
    if (first_) {
        block_.feet_before = block_.feet;
        block_.drift.w = block_.drift.z;
    }
    std::memcpy(blocks_[slot].mapped, &block_, sizeof block_);
    block_.feet_before = block_.feet;
    block_.drift.w = block_.drift.z;
    const std::array sets{context.frame, context.wind, sets_[slot]};
    vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, 3, sets.data(), 0, nullptr);
    vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_COMPUTE, skin_);
    // Two frames ago's entries are written over; the last frame's are read.
    VkMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
    barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT;
    vkCmdPipelineBarrier(context.commands, VK_PIPELINE_STAGE_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                         VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, 0, 1, &barrier, 0, nullptr, 0, nullptr);
    const std::int32_t first = first_ ? 1 : 0;
    first_ = false;
    vkCmdPushConstants(context.commands, layout_, VK_SHADER_STAGE_ALL, 0, sizeof first, &first);
    vkCmdDispatch(context.commands, (skin_count_ + k_group - 1) / k_group, 1, 1);
    if (room_) {
        vkCmdPipelineBarrier(context.commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, 0, 1,
                             &barrier, 0, nullptr, 0, nullptr);
        room_->record(context.commands, sets, std::exchange(since_, 0.0), first == 1);
    }
    barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT;
    vkCmdPipelineBarrier(context.commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_VERTEX_SHADER_BIT, 0, 1,
                         &barrier, 0, nullptr, 0, nullptr);
    return {};
}

void Coat::draw(const render::PassContext& context) {
    const bool shadow = context.pass == render::Pass::shadow;
    if (!seen_[shadow ? 1u + static_cast<std::size_t>(context.cascade) : 0u])
        return;
    const int layers = shadow ? block_.layers.w : block_.layers.x;
    if (layers < 1)
        return;
    const VkCommandBuffer commands = context.commands;
    const std::array sets{context.frame, context.wind, sets_[static_cast<std::size_t>(context.slot)]};
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 3, sets.data(), 0, nullptr);
    vkCmdBindIndexBuffer(commands, indices_.buffer, 0, VK_INDEX_TYPE_UINT32);
    if (shadow)
        vkCmdPushConstants(commands, layout_, VK_SHADER_STAGE_ALL, 0, sizeof context.cascade, &context.cascade);
    const auto each = [&](VkPipeline pipeline) {
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
        const auto count = static_cast<std::uint32_t>(layers);
        if (!settings_.levels.one_draw_each)
            return vkCmdDrawIndexed(commands, index_count_, count, 0, 0, 0);
        for (std::uint32_t layer = 0; layer < count; ++layer)
            vkCmdDrawIndexed(commands, index_count_, 1, 0, 0, layer);
    };
    if (!shadow && settings_.levels.depth_first)
        each(depth_);
    each(shadow ? shadow_ : colour_);
}

Result<std::vector<CoatSkinBlock>> Coat::skin() const {
    return objects_.device().read<CoatSkinBlock>(skins_.buffer, static_cast<std::size_t>(block_.counts.y), vertex_count_);
}

} // namespace windrow::vegetation::fur
