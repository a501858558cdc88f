#include "vegetation/render/wind_arrows.h"

#include "fluid/core/validation.h"
#include "shader_words/wind_arrow_vert.h"
#include "shader_words/wind_lattice_frag.h"
#include "shader_words/wind_slice_vert.h"
#include "vegetation/vulkan/calls.h"
#include "vegetation/vulkan/descriptors.h"

#include <cmath>
#include <cstring>

namespace windrow::vegetation::render {
namespace {

namespace words = windrow::vulkan::shader_words;

constexpr std::uint32_t k_arrow_vertices = 9, k_tile_vertices = 6;
constexpr std::array k_bindings{engine::Binding{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_SHADER_STAGE_ALL_GRAPHICS}};

} // namespace

windrow::Result<void> validate(const WindArrowSettings& settings) {
    return windrow::detail::validate_settings(settings, "arrows");
}

void check_rules(windrow::detail::Reasons& reasons, const windrow::detail::FieldPath& path, const WindArrowSettings& settings) {
    const glm::dvec3 count(settings.count);
    if (count.x * count.y * count.z > 1e6)
        reasons.add(windrow::detail::FieldPath{&path, "count"}, " is ", settings.count, ", ", count.x * count.y * count.z,
                    " in all: give at most 1e6.");
}

Result<std::unique_ptr<WindArrows>> WindArrows::create(engine::Device& device, const DrawTargets& targets,
                                                       const WindArrowSettings& settings) {
    if (auto judged = validate(settings); !judged)
        return judged.failure();
    return engine::guarded([&] { return std::unique_ptr<WindArrows>(new WindArrows(device, targets, settings)); });
}

WindArrows::WindArrows(engine::Device& device, const DrawTargets& targets, const WindArrowSettings& settings)
    : objects_(device), settings_(settings) {
    const bool slice = settings.form == WindArrowSettings::Form::slice;
    if (slice)
        settings_.count.y = 1;
    const VkDescriptorSetLayout own = make_layout(objects_, k_bindings);
    const std::array layouts{targets.frame, targets.wind, own};
    layout_ = make_pipeline_layout(objects_, layouts);
    pipeline_ = make_pipeline(objects_, {.vertex = slice ? std::span<const std::uint32_t>(words::wind_slice_vert)
                                                         : std::span<const std::uint32_t>(words::wind_arrow_vert),
                                         .fragment = words::wind_lattice_frag,
                                         .layout = layout_,
                                         .target = targets.colour});
    make_sets(objects_, own, k_bindings, sets_);
    blocks_ = objects_.frame_buffers(sizeof(Block), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    for (std::size_t slot = 0; slot < sets_.size(); ++slot)
        point(device, sets_[slot], 0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, blocks_[slot].buffer);
    place(glm::vec3(0.0f));
}

void WindArrows::place(glm::vec3 middle) {
    const float spacing = settings_.spacing;
    const auto corner = [&](float at, int count) {
        return std::round(at / spacing - 0.5f * static_cast<float>(count - 1)) * spacing;
    };
    block_.corner = {corner(middle.x, settings_.count.x), settings_.lowest, corner(middle.z, settings_.count.z), spacing};
    block_.count = glm::ivec4(settings_.count, 0);
    block_.look = {settings_.scale, settings_.seconds, 0.0f, 0.0f};
}

void WindArrows::draw(const PassContext& context) {
    if (context.pass == Pass::shadow)
        return; // they are no things
    const auto slot = static_cast<std::size_t>(context.slot);
    std::memcpy(blocks_[slot].mapped, &block_, sizeof block_);
    const std::array sets{context.frame, context.wind, sets_[slot]};
    vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 3, sets.data(), 0, nullptr);
    vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
    const auto places = static_cast<std::uint32_t>(settings_.count.x * settings_.count.y * settings_.count.z);
    const bool slice = settings_.form == WindArrowSettings::Form::slice;
    vkCmdDraw(context.commands, slice ? k_tile_vertices : k_arrow_vertices, places, 0, 0);
}

} // namespace windrow::vegetation::render
