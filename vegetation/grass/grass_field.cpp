#include "vegetation/grass/grass_field.h"

#include "fluid/core/validation.h"
#include "shader_words/cull.h"
#include "shader_words/generate.h"
#include "vegetation/grass/grass_field_state.h"
#include "vegetation/vulkan/descriptors.h"
#include "vegetation/vulkan/pipeline.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vulkan/vulkan.h>

namespace windrow::vegetation::grass {
namespace {

// A cell's number leaves 4 bits for the stream (vegetation/shaders/numerics/grass.glsl).
constexpr double k_max_cells = 268435456.0;
constexpr double k_max_chunks = 4194304.0; // 45 MB of quadtree

} // namespace

GrassField::GrassField(std::unique_ptr<State> state) : state_(std::move(state)) {}
GrassField::GrassField(GrassField&&) noexcept = default;
GrassField& GrassField::operator=(GrassField&&) noexcept = default;
GrassField::~GrassField() = default;

GrassField::State::State(engine::Device& device, HeightMap ground, PlacementMask grows, const GrassSettings& wanted)
    : settings(wanted), heights(std::move(ground)), mask(std::move(grows)), tree(heights, mask, settings, blade_reach(settings)),
      cache(tree.chunks(), settings.max_chunks), block(block_of(settings, heights, mask)), objects(device),
      mask_rows(0, mask.grid().corners.y - 1) {}

windrow::Result<GrassField> GrassField::create(engine::Device& device, const HeightMap& heights, const PlacementMask& mask,
                                               const GrassSettings& settings) {
    windrow::detail::Reasons reasons;
    reasons.add_all_of(validate(settings));
    // A thousandth of a texel comes of dividing an extent into texels.
    if (glm::length(heights.extent() - mask.extent()) > 1e-3f * heights.grid().spacing.x)
        reasons.add("The mask reaches ", mask.extent().x, " m x ", mask.extent().y, " m, the heights ", heights.extent().x,
                    " m x ", heights.extent().y, " m: give the mask heights.extent().");
    const glm::dvec2 cells = glm::dvec2(heights.extent()) * static_cast<double>(settings.density);
    const glm::dvec2 chunks = glm::ceil(cells / static_cast<double>(std::max(settings.chunk_cells, 1)));
    if (cells.x >= k_max_cells || cells.y >= k_max_cells || chunks.x * chunks.y > k_max_chunks)
        reasons.add("The field has ", cells.x, " x ", cells.y, " blade places in ", chunks.x * chunks.y,
                    " chunks: give fewer than 2^28 along an axis and at most 2^22 chunks, by a lower grass.density, a larger "
                    "grass.chunk_cells or less ground.");
    if (auto fits = reasons.outcome(); !fits)
        return fits.failure();
    return engine::guarded([&] {
        auto state = std::make_unique<State>(device, heights, mask, settings);
        state->make();
        return GrassField(std::move(state));
    });
}

void GrassField::State::make() {
    const auto slots = static_cast<VkDeviceSize>(settings.max_chunks);
    const VkDeviceSize places = slots * static_cast<VkDeviceSize>(settings.chunk_cells * settings.chunk_cells);
    constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    constexpr VkBufferUsageFlags filled = VK_BUFFER_USAGE_TRANSFER_DST_BIT, counted = VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
    const struct {
        VkBuffer* buffer;
        const char* name;
        VkDeviceSize bytes;
        VkBufferUsageFlags usage;
    } wanted[] = {{&frame, "The grass's frame block", sizeof(Block), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | filled},
                  {&blades, "The grass's blades", places * sizeof(BladeRecord), storage | counted},
                  {&lists, "The grass's index lists", places * 2 * sizeof(std::uint32_t), storage | counted},
                  {&chunk_places, "The grass's chunks' places", slots * sizeof(glm::ivec2), storage},
                  {&draws, "The grass's draw commands", slots * 4 * sizeof(VkDrawIndirectCommand),
                   storage | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT | counted},
                  {&orders, "The grass's orders", slots * 2 * sizeof(glm::ivec4), storage | filled},
                  {&height_values, "The grass's heights", heights.heights().size_bytes(), storage | filled},
                  {&mask_values, "The grass's mask", mask.values().size_bytes(), storage | filled}};
    constexpr VkShaderStageFlags computes = VK_SHADER_STAGE_COMPUTE_BIT, draws_too = computes | VK_SHADER_STAGE_VERTEX_BIT;
    std::vector<engine::Binding> of_passes, of_draws;
    for (const auto& each : wanted) {
        *each.buffer = objects.storage(each.name, "lower grass.max_chunks, or give fewer corners", each.bytes, each.usage);
        const VkDescriptorType type =
            each.buffer == &frame ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        of_passes.push_back({type, computes});
        if (of_draws.size() < 6)
            of_draws.push_back({type, draws_too});
    }
    const auto bound = [&](VkDescriptorSetLayout layout, std::span<const engine::Binding> bindings) {
        VkDescriptorSet set = VK_NULL_HANDLE;
        make_sets(objects, layout, bindings, std::span(&set, 1));
        for (std::uint32_t n = 0; n < bindings.size(); ++n)
            point(objects.device(), set, n, bindings[n].type, *wanted[n].buffer);
        return set;
    };
    const VkDescriptorSetLayout pass_sets = make_layout(objects, of_passes);
    pass_set = bound(pass_sets, of_passes);
    draw_layout = make_layout(objects, of_draws);
    draw_set = bound(draw_layout, of_draws);
    pass_layout = make_pipeline_layout(objects, std::span(&pass_sets, 1));
    generate = make_compute_pipeline(objects, pass_layout, windrow::vulkan::shader_words::generate);
    cull = make_compute_pipeline(objects, pass_layout, windrow::vulkan::shader_words::cull);
}

windrow::Result<void> GrassField::place(const glm::dvec3& corner) {
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(corner[axis]))
            return windrow::Error{
                windrow::detail::message("The grass's corner has a coordinate of ", corner[axis], " m: give finite numbers.")};
    state_->corner = corner;
    return {};
}

windrow::Result<void> GrassField::repaint(const PlacementMask& mask, const Touched& touched) {
    State& state = *state_;
    if (mask.grid().corners != state.mask.grid().corners || mask.grid().spacing != state.mask.grid().spacing)
        return windrow::Error{
            "The mask of GrassField::repaint has other corners or another extent: give the field's own, changed."};
    if (!(touched.low.x <= touched.high.x) || !(touched.low.y <= touched.high.y))
        return {};
    state.mask = mask;
    state.tree.refresh(state.heights, state.mask, touched);
    const float side = static_cast<float>(state.settings.chunk_cells) / state.settings.density;
    const glm::vec2 last(state.tree.chunks() - 1);
    state.cache.forget(glm::ivec2(glm::clamp(glm::floor(touched.low / side), glm::vec2(0.0f), last)),
                       glm::ivec2(glm::clamp(glm::floor(touched.high / side), glm::vec2(0.0f), last)));
    const float spacing = mask.grid().spacing.y;
    const float rows = static_cast<float>(mask.grid().corners.y - 1);
    const glm::ivec2 dirty(static_cast<int>(glm::clamp(std::floor(touched.low.y / spacing), 0.0f, rows)),
                           static_cast<int>(glm::clamp(std::ceil(touched.high.y / spacing), 0.0f, rows)));
    state.mask_rows = state.mask_rows.y < state.mask_rows.x
                          ? dirty
                          : glm::ivec2(std::min(state.mask_rows.x, dirty.x), std::max(state.mask_rows.y, dirty.y));
    return {};
}

VkDescriptorSetLayout GrassField::layout() const {
    return state_->draw_layout;
}
VkDescriptorSet GrassField::set() const {
    return state_->draw_set;
}
const GrassSettings& GrassField::settings() const {
    return state_->settings;
}
const ChunkTree& GrassField::tree() const {
    return state_->tree;
}
std::uint64_t GrassField::memory_bytes() const {
    return state_->objects.memory_bytes();
}
VkBuffer GrassField::draw_buffer() const {
    return state_->draws;
}
VkBuffer GrassField::blade_buffer() const {
    return state_->blades;
}
VkBuffer GrassField::list_buffer() const {
    return state_->lists;
}
int GrassField::slot_of(Chunk chunk) const {
    return state_->cache.slot_of(chunk);
}

} // namespace windrow::vegetation::grass
