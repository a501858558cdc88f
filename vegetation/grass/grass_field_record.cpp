// What a field records in a frame.
#include "vegetation/grass/grass_field_state.h"
#include "vegetation/vulkan/calls.h"

#include <algorithm>
#include <cmath>

namespace windrow::vegetation::grass {
namespace {

constexpr std::uint32_t k_group = 128; // generate.comp, cull.comp
constexpr VkPipelineStageFlags k_transfer = VK_PIPELINE_STAGE_TRANSFER_BIT, k_compute = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
constexpr VkPipelineStageFlags k_draws = VK_PIPELINE_STAGE_DRAW_INDIRECT_BIT | VK_PIPELINE_STAGE_VERTEX_SHADER_BIT;

void barrier(VkCommandBuffer commands, VkPipelineStageFlags from, VkAccessFlags written, VkPipelineStageFlags to,
             VkAccessFlags used) {
    const VkMemoryBarrier all{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, written, used};
    vkCmdPipelineBarrier(commands, from, to, 0, 1, &all, 0, nullptr, 0, nullptr);
}

// vkCmdUpdateBuffer takes 65536 bytes at once, and copies them while it records: no staging memory that a frame in flight might
// read.
void update(VkCommandBuffer commands, VkBuffer to, std::size_t offset, const void* from, std::size_t bytes) {
    constexpr std::size_t most = 65536;
    const auto* const data = static_cast<const char*>(from);
    for (std::size_t done = 0; done < bytes; done += most)
        vkCmdUpdateBuffer(commands, to, offset + done, std::min(most, bytes - done), data + done);
}

// Planes that nothing lies beyond, for what is not to be culled.
Planes planes_for(bool culled, const glm::mat4& view_projection, const glm::dvec3& corner) {
    return culled ? frustum_planes(view_projection, corner) : Planes{};
}

bool is_finite(const glm::mat4& m) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(m[column][row]))
                return false;
    return true;
}

bool is_finite(const GrassCamera& camera) {
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(camera.anchor[axis]) || !std::isfinite(camera.eye[axis]))
            return false;
    return is_finite(camera.view_projection) && (!camera.shadow_view_projection || is_finite(*camera.shadow_view_projection));
}

} // namespace

void GrassField::State::set_frame(const GrassCamera& camera) {
    const glm::dvec3 from_anchor = corner - camera.anchor;
    const glm::dvec3 eye = camera.anchor + glm::dvec3(camera.eye);
    block.corner = glm::vec4(glm::vec3(from_anchor), block.corner.w);
    block.eye = glm::vec4(glm::vec3(eye - corner), block.eye.w);
    block.eye_before = glm::vec4(glm::vec3(eye_before.value_or(eye) - corner), 0.0f);
    eye_before = eye;
    const bool culled = settings.culling == Culling::blades;
    const Planes colour = planes_for(culled, camera.view_projection, from_anchor);
    const Planes shadow =
        camera.shadow_view_projection ? planes_for(culled, *camera.shadow_view_projection, from_anchor) : Planes{};
    std::copy(colour.begin(), colour.end(), block.planes);
    std::copy(shadow.begin(), shadow.end(), block.planes + colour.size());
}

GrassReport GrassField::State::choose(const GrassCamera& camera) {
    GrassReport report;
    const bool culled = settings.culling != Culling::none;
    const Planes colour = planes_for(culled, camera.view_projection, corner - camera.anchor);
    tree.visible(colour, glm::vec3(block.eye), block.reach.w, seen);
    shaded.clear();
    if (camera.shadow_view_projection && block.ground.z > 0.0f)
        tree.visible(planes_for(culled, *camera.shadow_view_projection, corner - camera.anchor), glm::vec3(block.eye),
                     block.ground.z, shaded);
    cache.begin_frame();
    made_orders.clear();
    cull_orders.clear();
    // Those that have a slot keep it, unless there are too few: then the nearest come first.
    if (seen.size() + shaded.size() <= static_cast<std::size_t>(settings.max_chunks))
        for (const auto* chunks : {&seen, &shaded})
            for (const Chunk chunk : *chunks)
                if (cache.slot_of(chunk) >= 0)
                    (void)cache.ask(chunk);
    const auto ask = [&](const std::vector<Chunk>& chunks, int view) {
        drawn[view].clear();
        for (const Chunk chunk : chunks) {
            const ChunkCache::Given given = cache.ask(chunk);
            if (given.slot < 0) {
                ++report.left_out;
                continue;
            }
            if (given.made)
                made_orders.emplace_back(given.slot, chunk.at.x, chunk.at.y, 0);
            drawn[view].push_back(given.slot);
        }
    };
    ask(seen, 0);
    ask(shaded, 1);
    for (const int slot : drawn[0])
        cull_orders.emplace_back(slot, 1, 0, 0);
    for (const int slot : drawn[1]) {
        // A chunk that both views ask for is culled by one order. A few dozen of each.
        const auto same = std::find_if(cull_orders.begin(), cull_orders.begin() + static_cast<std::ptrdiff_t>(drawn[0].size()),
                                       [slot](const glm::ivec4& order) { return order.x == slot; });
        if (same != cull_orders.begin() + static_cast<std::ptrdiff_t>(drawn[0].size()))
            same->y |= 2;
        else
            cull_orders.emplace_back(slot, 2, 0, 0);
    }
    report.colour_chunks = static_cast<int>(drawn[0].size());
    report.shadow_chunks = static_cast<int>(drawn[1].size());
    report.made_chunks = static_cast<int>(made_orders.size());
    report.first_order = report.made_chunks;
    report.orders = static_cast<int>(cull_orders.size());
    return report;
}

windrow::Result<GrassReport> GrassField::record_cull(VkCommandBuffer commands, const GrassCamera& camera) {
    State& state = *state_;
    if (commands == VK_NULL_HANDLE)
        return windrow::Error{"GrassField::record_cull got no command buffer: give one that is being recorded."};
    if (!is_finite(camera))
        return windrow::Error{"GrassField::record_cull got a camera with a number that is not finite: give finite ones."};
    state.set_frame(camera);
    const GrassReport report = state.choose(camera);

    // The frame before has read what is written here.
    barrier(commands, k_transfer | k_compute | k_draws, VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT,
            k_transfer | k_compute, VK_ACCESS_TRANSFER_WRITE_BIT | VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT);
    update(commands, state.frame, 0, &state.block, sizeof state.block);
    if (!state.heights_are_there)
        update(commands, state.height_values, 0, state.heights.heights().data(), state.heights.heights().size_bytes());
    state.heights_are_there = true;
    if (state.mask_rows.x <= state.mask_rows.y) {
        const std::size_t row = static_cast<std::size_t>(state.mask.grid().corners.x) * sizeof(float);
        const auto first = static_cast<std::size_t>(state.mask_rows.x), end = static_cast<std::size_t>(state.mask_rows.y) + 1;
        update(commands, state.mask_values, first * row, reinterpret_cast<const char*>(state.mask.values().data()) + first * row,
               (end - first) * row);
        state.mask_rows = {0, -1};
    }
    const std::size_t made = state.made_orders.size();
    update(commands, state.orders, 0, state.made_orders.data(), made * sizeof(glm::ivec4));
    update(commands, state.orders, made * sizeof(glm::ivec4), state.cull_orders.data(),
           state.cull_orders.size() * sizeof(glm::ivec4));
    barrier(commands, k_transfer, VK_ACCESS_TRANSFER_WRITE_BIT, k_compute | k_draws,
            VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_UNIFORM_READ_BIT);

    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, state.pass_layout, 0, 1, &state.pass_set, 0, nullptr);
    const auto dispatch = [&](VkPipeline pipeline, std::size_t first_order, std::uint32_t x, std::uint32_t y) {
        const auto first = static_cast<std::uint32_t>(first_order);
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
        vkCmdPushConstants(commands, state.pass_layout, VK_SHADER_STAGE_ALL, 0, sizeof first, &first);
        vkCmdDispatch(commands, x, y, 1);
    };
    if (made > 0) {
        const auto places = static_cast<std::uint32_t>(state.settings.chunk_cells * state.settings.chunk_cells);
        dispatch(state.generate, 0, (places + k_group - 1) / k_group, static_cast<std::uint32_t>(made));
        barrier(commands, k_compute, VK_ACCESS_SHADER_WRITE_BIT, k_compute, VK_ACCESS_SHADER_READ_BIT);
    }
    if (!state.cull_orders.empty())
        dispatch(state.cull, made, static_cast<std::uint32_t>(state.cull_orders.size()), 2);
    barrier(commands, k_compute, VK_ACCESS_SHADER_WRITE_BIT, k_draws | k_transfer | k_compute,
            VK_ACCESS_INDIRECT_COMMAND_READ_BIT | VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_TRANSFER_READ_BIT);
    return report;
}

void GrassField::draw(VkCommandBuffer commands, const GrassPass& pass) const {
    const State& state = *state_;
    const auto view = static_cast<std::uint32_t>(pass.view);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pass.layout, pass.set, 1, &state.draw_set, 0, nullptr);
    for (const int slot : state.drawn[view])
        for (std::uint32_t level = 0; level < 2; ++level) {
            const std::uint32_t push[2] = {static_cast<std::uint32_t>(slot), level + 2 * view};
            vkCmdPushConstants(commands, pass.layout, pass.push_stages, pass.push_offset, sizeof push, push);
            const VkDeviceSize at = (4 * VkDeviceSize{push[0]} + 2 * view + level) * sizeof(VkDrawIndirectCommand);
            vkCmdDrawIndirect(commands, state.draws, at, 1, sizeof(VkDrawIndirectCommand));
        }
}

} // namespace windrow::vegetation::grass
