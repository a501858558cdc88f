#include "vegetation/trees/tree_stand.h"

#include "coupling/plant_vertex.h"
#include "coupling/spring.h"
#include "fluid/core/message.h"
#include "shader_words/tree_bark_frag.h"
#include "shader_words/tree_bark_vert.h"
#include "shader_words/tree_leaf_frag.h"
#include "shader_words/tree_leaf_vert.h"
#include "shader_words/tree_loads.h"
#include "shader_words/tree_shadow_vert.h"
#include "vegetation/trees/tree_numerics.h"
#include "vegetation/trees/tree_wind.h"
#include "vegetation/vulkan/calls.h"
#include "vegetation/vulkan/descriptors.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace windrow::vegetation::trees {
namespace {

namespace words = windrow::vulkan::shader_words;

constexpr std::uint32_t k_group = 64;
constexpr std::size_t k_max_groups = 65535; // of a dispatch on any device; states of 256 MiB
constexpr float k_reach = 0.3f;             // of its height that a tree may lean beyond its ball at rest, culling allows

constexpr VkShaderStageFlags k_all = VK_SHADER_STAGE_ALL_GRAPHICS | VK_SHADER_STAGE_COMPUTE_BIT;
constexpr VkShaderStageFlags k_vertices = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_COMPUTE_BIT;
constexpr std::array k_bindings{engine::Binding{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, k_all},
                                engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, k_vertices},
                                engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, k_vertices},
                                engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, k_vertices},
                                engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, k_vertices},
                                engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_COMPUTE_BIT}};

PlaceBlock block_of(const TreePlace& place, glm::dvec3 anchor) {
    const float yaw = glm::radians(place.yaw_deg);
    const windrow::PlantKey key = windrow::place_key(static_cast<float>(place.base.x), static_cast<float>(place.base.z));
    const float chance = numerics::windrow_plant_chance(numerics::windrow_plant_hash({key.x, key.y}));
    return {.base = glm::vec4(glm::vec3(place.base - anchor), place.size), .turn = {std::cos(yaw), std::sin(yaw), chance, 0.0f}};
}

} // namespace

windrow::Result<std::unique_ptr<TreeStand>> TreeStand::create(engine::Device& device, const render::DrawTargets& targets,
                                                              const TreeStandSettings& settings,
                                                              std::span<const TreePlace> places, glm::dvec3 anchor) {
    TreeStandSettings judged = settings;
    judged.places.assign(places.begin(), places.end());
    if (auto valid = validate(judged); !valid)
        return valid.failure();
    if (places.empty())
        return windrow::Error{"stand.places is empty; give at least one place, or leave the stand out."};
    std::vector<TreeModel> models;
    for (int variant = 0; variant < settings.variants; ++variant) {
        TreeSettings tree = settings.kind.tree;
        tree.seed += 1000u * static_cast<std::uint32_t>(variant);
        models.push_back(*build(tree)); // was validated
    }
    std::size_t groups = 1;
    for (const TreeModel& model : models)
        groups = std::max(groups, (model.parts.size() + k_group - 1) / k_group);
    if (groups * places.size() > k_max_groups)
        return windrow::Error{detail::message("stand.places has ", places.size(), " trees; give at most ", k_max_groups / groups,
                                              " of this kind, or several stands.")};
    return engine::guarded(
        [&] { return std::unique_ptr<TreeStand>(new TreeStand(device, targets, settings, std::move(models), places, anchor)); });
}

TreeStand::TreeStand(engine::Device& device, const render::DrawTargets& targets, const TreeStandSettings& settings,
                     std::vector<TreeModel> models, std::span<const TreePlace> places, glm::dvec3 anchor)
    : objects_(device), models_(std::move(models)), springs_(settings.springs), flutter_(settings.flutter) {
    const TreeSettings& tree = settings.kind.tree;
    const TreeLook& look = settings.kind.look;
    block_.wind = windrow::Tree::create(wind_classes(tree))->block(); // valid classes of valid settings: vegetation/tests/trees
    block_.levels = level_block(settings.kind.levels, static_cast<int>(models_.front().leaf_parts.size()));
    block_.clock = {1u, 0u, static_cast<std::uint32_t>(targets.colour.samples), tree.leaf_form == LeafForm::needles ? 1u : 0u};
    block_.bark = glm::vec4(look.bark, look.bark_lines);
    block_.furrow = glm::vec4(look.furrow, 0.5f * tree.height);
    block_.leaf = glm::vec4(look.leaf, look.variation);
    block_.young = glm::vec4(look.young, look.gloss);
    block_.through = glm::vec4(look.through, look.against_light);
    if (tree.leaf_form == LeafForm::needles)
        flutter_.most = 0.0f;
    std::uint32_t part = 0, state = 0;
    for (const TreeModel& model : models_) {
        first_part_.push_back(part);
        part += static_cast<std::uint32_t>(model.parts.size());
    }
    for (std::size_t n = 0; n < places.size(); ++n) {
        PlaceBlock made = block_of(places[n], anchor);
        made.first = {first_part_[n % models_.size()], state, static_cast<std::uint32_t>(tree.limbs) + 1u, 0u};
        state += static_cast<std::uint32_t>(model(n).parts.size());
        places_.push_back(made);
    }
    make_pipelines(targets);
    fill_buffers();
}

void TreeStand::make_pipelines(const render::DrawTargets& targets) {
    own_ = engine::make_layout(objects_, k_bindings);
    const std::array sets{targets.frame, targets.wind, own_};
    layout_ = engine::make_pipeline_layout(objects_, sets);
    loads_ = engine::make_compute_pipeline(objects_, layout_, words::tree_loads);
    bark_ = engine::make_pipeline(
        objects_,
        {.vertex = words::tree_bark_vert, .fragment = words::tree_bark_frag, .layout = layout_, .target = targets.colour});
    leaf_ = engine::make_pipeline(
        objects_,
        {.vertex = words::tree_leaf_vert, .fragment = words::tree_leaf_frag, .layout = layout_, .target = targets.colour});
    shadow_ = engine::make_pipeline(
        objects_, {.vertex = words::tree_shadow_vert, .layout = layout_, .target = targets.shadow, .bias = true});
}

void TreeStand::fill_buffers() {
    std::vector<ModelVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<ModelPart> parts;
    for (const TreeModel& model : models_) {
        first_vertex_.push_back(static_cast<std::uint32_t>(vertices.size()));
        first_index_.push_back(static_cast<std::uint32_t>(indices.size()));
        vertices.insert(vertices.end(), model.vertices.begin(), model.vertices.end());
        indices.insert(indices.end(), model.indices.begin(), model.indices.end());
        parts.insert(parts.end(), model.parts.begin(), model.parts.end());
    }
    constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    const engine::Buffer vertex_buffer = engine::filled(objects_, vertices, storage),
                         part_buffer = engine::filled(objects_, parts, storage);
    const engine::Buffer place_buffer = engine::filled(objects_, places_, storage);
    indices_ = engine::filled(objects_, indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
    const std::size_t states = places_.back().first.y + model(places_.size() - 1).parts.size();
    states_ = engine::filled(objects_, std::vector<PartState>(states), storage | VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
    std::size_t max_groups = 0;
    for (std::size_t n = 0; n < places_.size(); ++n)
        max_groups += (model(n).parts.size() + k_group - 1) / k_group;
    engine::make_sets(objects_, own_, k_bindings, sets_);
    blocks_ = objects_.frame_buffers(sizeof(StandBlock), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    jobs_ = objects_.frame_buffers(sizeof(glm::uvec4) * max_groups, storage);
    const engine::Device& device = objects_.device();
    for (std::size_t slot = 0; slot < sets_.size(); ++slot) {
        engine::point(device, sets_[slot], 0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, blocks_[slot].buffer);
        std::uint32_t binding = 1;
        for (const engine::Buffer& each : {vertex_buffer, part_buffer, place_buffer, states_, jobs_[slot]})
            engine::point(device, sets_[slot], binding++, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, each.buffer);
    }
}

void TreeStand::set_time_step(double seconds) {
    time_step_ = std::isfinite(seconds) && seconds > 0.0 ? seconds : 0.0;
}

void TreeStand::find_seen(const render::ViewBlock& frame) {
    seen_.clear();
    drawn_vertices_ = 0;
    const glm::vec3 eye(frame.eye);
    for (std::uint32_t n = 0; n < places_.size(); ++n) {
        const PlaceBlock& place = places_[n];
        const TreeModel& model = this->model(n);
        const glm::vec3 foot(place.base), middle = foot + glm::vec3(0.0f, place.base.w * model.middle.y, 0.0f);
        const float aside = glm::length(glm::vec2(model.middle.x, model.middle.z));
        const float radius = place.base.w * (model.radius + aside + k_reach * model.wind_reach);
        Seen seen{.tree = n,
                  .by = {render::sees(frame.view_projection, middle, radius), render::sees(frame.shadow[0], middle, radius),
                         render::sees(frame.shadow[1], middle, radius)}};
        if (!seen.by[0] && !seen.by[1] && !seen.by[2])
            continue;
        const glm::vec3 height(0.0f, place.base.w * block_.furrow.w, 0.0f);
        seen.drawn = model.drawn(block_.levels, glm::length(eye - foot - height) / place.base.w);
        drawn_vertices_ += seen.by[0] ? seen.drawn.vertices : 0u;
        seen_.push_back(seen);
    }
}

Result<void> TreeStand::prepare(const render::PassContext& context) {
    find_seen(*context.block);
    ++block_.clock.x;
    block_.clock.y = springs_ ? 1u : 0u;
    block_.trunk_spring = windrow::spring_step(windrow::springs::trunk, time_step_)->block();
    const auto limbs = *windrow::spring_bands(windrow::springs::branch), twigs = *windrow::spring_bands(windrow::springs::twig);
    for (std::size_t band = 0; band < limbs.size(); ++band) {
        block_.limb_springs[band] = windrow::spring_step(limbs[band], time_step_)->block();
        block_.twig_springs[band] = windrow::spring_step(twigs[band], time_step_)->block();
    }
    time_ += time_step_;
    block_.flutter = *windrow::flutter_step(flutter_, time_, time_step_);
    const auto slot = static_cast<std::size_t>(context.slot);
    std::memcpy(blocks_[slot].mapped, &block_, sizeof block_);
    if (seen_.empty())
        return {};
    // One job a group: a software device runs all of a group's lanes, whether they have a part or not.
    auto* const jobs = static_cast<glm::uvec4*>(jobs_[slot].mapped);
    std::uint32_t groups = 0;
    for (const Seen& seen : seen_)
        for (std::uint32_t first = 0; first < seen.drawn.parts; first += k_group)
            jobs[groups++] = {seen.tree, first, seen.drawn.parts, 0u};
    const std::array sets{context.frame, context.wind, sets_[slot]};
    vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, 3, sets.data(), 0, nullptr);
    vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_COMPUTE, loads_);
    // The frame before has read its bends, and written those that springs go on from.
    VkMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
    barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT;
    vkCmdPipelineBarrier(context.commands, VK_PIPELINE_STAGE_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                         VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, 0, 1, &barrier, 0, nullptr, 0, nullptr);
    vkCmdDispatch(context.commands, groups, 1, 1);
    barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT;
    vkCmdPipelineBarrier(context.commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_VERTEX_SHADER_BIT, 0, 1,
                         &barrier, 0, nullptr, 0, nullptr);
    return {};
}

void TreeStand::draw(const render::PassContext& context) {
    const VkCommandBuffer commands = context.commands;
    const std::array sets{context.frame, context.wind, sets_[static_cast<std::size_t>(context.slot)]};
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 3, sets.data(), 0, nullptr);
    vkCmdBindIndexBuffer(commands, indices_.buffer, 0, VK_INDEX_TYPE_UINT32);
    const bool shadow = context.pass == render::Pass::shadow;
    const std::size_t view = shadow ? 1u + static_cast<std::size_t>(context.cascade) : 0u;
    if (shadow)
        vkCmdPushConstants(commands, layout_, VK_SHADER_STAGE_ALL, 0, sizeof context.cascade, &context.cascade);
    const auto draw = [&](const Seen& seen, IndexRange range) {
        const std::size_t variant = seen.tree % models_.size();
        if (range.count > 0)
            vkCmdDrawIndexed(commands, range.count, 1, first_index_[variant] + range.first,
                             static_cast<std::int32_t>(first_vertex_[variant]), seen.tree);
    };
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, shadow ? shadow_ : bark_);
    for (const Seen& seen : seen_)
        if (seen.by[view]) {
            draw(seen, seen.drawn.wood);
            draw(seen, seen.drawn.more_wood);
        }
    if (!shadow)
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, leaf_);
    for (const Seen& seen : seen_)
        if (seen.by[view])
            draw(seen, seen.drawn.leaves);
}

Result<std::vector<PartState>> TreeStand::states(std::size_t tree) const {
    return objects_.device().read<PartState>(states_.buffer, places_[tree].first.y, model(tree).parts.size());
}

} // namespace windrow::vegetation::trees
