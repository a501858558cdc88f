// What a coat has on the device: pipelines, sets, buffers.
#include "shader_words/coat_skin.h"
#include "shader_words/shell_depth_frag.h"
#include "shader_words/shell_frag.h"
#include "shader_words/shell_pixel_depth_frag.h"
#include "shader_words/shell_pixel_frag.h"
#include "shader_words/shell_shadow_frag.h"
#include "shader_words/shell_shadow_vert.h"
#include "shader_words/shell_vert.h"
#include "vegetation/fur/coat.h"
#include "vegetation/vulkan/descriptors.h"

#include <algorithm>
#include <cstring>
#include <vulkan/vulkan.h>

namespace windrow::vegetation::fur {
namespace {

namespace words = windrow::vulkan::shader_words;

constexpr VkDescriptorType k_storage = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
constexpr VkShaderStageFlags k_vertices = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_COMPUTE_BIT;
constexpr std::array k_bindings{engine::Binding{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, engine::k_stages},
                                engine::Binding{k_storage, k_vertices},
                                engine::Binding{k_storage, k_vertices},
                                engine::Binding{k_storage, VK_SHADER_STAGE_COMPUTE_BIT},
                                engine::Binding{k_storage, VK_SHADER_STAGE_COMPUTE_BIT},
                                engine::Binding{k_storage, engine::k_stages}};

// The constants of vegetation/shaders/fur/shell_strand.glsl, in their order.
std::array<std::uint32_t, 7> constants_of(const CoatSettings& settings, bool noise) {
    const StrandFieldSettings& strands = settings.strands;
    const std::uint32_t pattern = settings.cloud ? 3u : noise ? 2u : settings.strands_on == StrandsOn::surface ? 1u : 0u;
    return {pattern,
            static_cast<std::uint32_t>(strands.profile),
            static_cast<std::uint32_t>(strands.shape),
            strands.bow > 0.0f ? 1u : 0u,
            strands.tuft > 0.0f ? 1u : 0u,
            strands.jitter > 0.0f ? 1u : 0u,
            settings.levels.march > 0 ? 1u : 0u};
}

} // namespace

void Coat::make_pipelines(const render::DrawTargets& targets) {
    own_ = engine::make_layout(objects_, k_bindings);
    const std::array sets{targets.frame, targets.wind, own_};
    layout_ = engine::make_pipeline_layout(objects_, sets);
    skin_ = engine::make_compute_pipeline(objects_, layout_, words::coat_skin);
    using Words = std::span<const std::uint32_t>;
    const auto constants = constants_of(settings_, block_.pictures[2].w > 0);
    const bool pixel = settings_.wind_at == WindAt::pixel;
    colour_ = engine::make_pipeline(objects_, {.vertex = words::shell_vert,
                                               .fragment = pixel ? Words(words::shell_pixel_frag) : Words(words::shell_frag),
                                               .constants = constants,
                                               .layout = layout_,
                                               .target = targets.colour});
    if (settings_.levels.depth_first)
        depth_ = engine::make_pipeline(objects_,
                                       {.vertex = words::shell_vert,
                                        .fragment = pixel ? Words(words::shell_pixel_depth_frag) : Words(words::shell_depth_frag),
                                        .constants = constants,
                                        .layout = layout_,
                                        .target = targets.colour,
                                        .writes_colour = false});
    shadow_ = engine::make_pipeline(objects_, {.vertex = words::shell_shadow_vert,
                                               .fragment = words::shell_shadow_frag,
                                               .constants = constants,
                                               .layout = layout_,
                                               .target = targets.shadow,
                                               .bias = true});
}

void Coat::fill_buffers(const render::DrawTargets& targets, const PackedPictures& pictures, const PartMesh& part) {
    constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    const engine::Buffer vertices = engine::filled(objects_, part.vertices, storage);
    const engine::Buffer texels = engine::filled(objects_, pictures.texels, storage);
    indices_ = engine::filled(objects_, part.indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
    skins_ =
        objects_.buffer(engine::Use::work, 2 * sizeof(CoatSkinBlock) * skin_count_, storage | VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
    const std::size_t poses = 2 + (cascade_ ? static_cast<std::size_t>(cascade_->config().stages) : 0);
    engine::make_sets(objects_, own_, k_bindings, sets_);
    blocks_ = objects_.frame_buffers(sizeof(CoatBlock), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    poses_ = objects_.frame_buffers(sizeof(windrow::PoseBlock) * poses, storage);
    bone_buffers_ = objects_.frame_buffers(sizeof(glm::mat4) * std::max<std::size_t>(2 * bones_.size(), 1), storage);
    const engine::Device& device = objects_.device();
    for (std::size_t slot = 0; slot < sets_.size(); ++slot) {
        engine::point(device, sets_[slot], 0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, blocks_[slot].buffer);
        std::uint32_t binding = 1;
        for (const engine::Buffer& each : {vertices, skins_, poses_[slot], bone_buffers_[slot], texels})
            engine::point(device, sets_[slot], binding++, k_storage, each.buffer);
    }
    if (!part.narrow.empty()) {
        const std::array before{targets.frame, targets.wind, own_};
        room_.emplace(objects_, before, part.patches, part.narrow);
    }
}

} // namespace windrow::vegetation::fur
