#include "vegetation/render/renderer.h"

#include "fluid/core/message.h"
#include "fluid/core/validation.h"
#include "shader_words/cloud_noise.h"
#include "shader_words/full_screen_vert.h"
#include "shader_words/sky_frag.h"
#include "shader_words/sky_map_frag.h"
#include "shader_words/tone_frag.h"
#include "vegetation/vulkan/calls.h"
#include "vegetation/vulkan/descriptors.h"

#include <cmath>
#include <cstring>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace windrow::vegetation::render {
namespace {

namespace words = windrow::vulkan::shader_words;
using windrow::detail::FieldPath;

constexpr VkFormat k_sky_format = VK_FORMAT_R16G16B16A16_SFLOAT; // every device draws to it and filters it
constexpr VkFormat k_shadow_format = VK_FORMAT_D16_UNORM;        // every device draws to it and samples it
// [px] Thinner parts are drawn as dots: four samples show a slanted line of 1 px as beads.
constexpr float k_min_width = 1.5f;
constexpr glm::vec3 k_meadow_albedo{0.10f, 0.14f, 0.05f}; // of what lies around: light from below is green

constexpr std::array k_frame_bindings{
    engine::Binding{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, engine::k_stages},
    engine::Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_SHADER_STAGE_ALL_GRAPHICS},
    engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_COMPUTE_BIT},
    engine::Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_SHADER_STAGE_ALL_GRAPHICS}};
// Of passes over the whole picture: toning reads the first.
constexpr std::array k_light_bindings{engine::Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_SHADER_STAGE_FRAGMENT_BIT},
                                      engine::Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_SHADER_STAGE_FRAGMENT_BIT}};

VkExtent2D extent_of(const RenderSettings& settings) {
    return {static_cast<std::uint32_t>(settings.width), static_cast<std::uint32_t>(settings.height)};
}

// Of the map of the sky; a texel that nothing reads where there is none. A small picture's has as many texels as pixels: its light
// changes within some degrees over the horizon.
VkExtent2D sky_extent(const RenderSettings& settings) {
    if (settings.quality.sky_pixels == 0)
        return {1, 1};
    constexpr std::uint32_t k_fewest = 256; // across
    const VkExtent2D whole = extent_of(settings);
    const auto pixels = std::min(static_cast<std::uint32_t>(settings.quality.sky_pixels), std::max(whole.width / k_fewest, 1u));
    return {(whole.width + pixels - 1) / pixels, (whole.height + pixels - 1) / pixels};
}

VkSampleCountFlagBits samples_of(const engine::Device& device, const RenderSettings& settings) {
    const auto samples = static_cast<VkSampleCountFlagBits>(settings.samples); // a bit of its own value
    if (!draws_with(device, samples))
        throw engine::Failure(windrow::detail::message("settings.samples (--samples of windrow-draw) is ", settings.samples,
                                                       ", which ", device.name(), " cannot draw with: give 1 or 4."));
    return samples;
}

float aspect_of(const RenderSettings& settings) {
    return static_cast<float>(settings.width) / static_cast<float>(settings.height);
}

} // namespace

windrow::Result<void> validate(const RenderSettings& settings) {
    return windrow::detail::validate_settings(settings, "settings");
}

void check_rules(windrow::detail::Reasons& reasons, const FieldPath& path, const Quality& quality) {
    if (quality.light_bytes != 4 && quality.light_bytes != 8)
        reasons.add(FieldPath{&path, "light_bytes"}, " is ", quality.light_bytes, ": give 4 or 8.");
}

void check_rules(windrow::detail::Reasons& reasons, const FieldPath& path, const RenderSettings& settings) {
    if (settings.samples == 3)
        reasons.add(FieldPath{&path, "samples"}, " is 3: give 1 or 4, which every device has, or 2.");
    if (settings.far_shadow < 1.01f * settings.near_shadow)
        reasons.add(FieldPath{&path, "far_shadow"}, " is ", settings.far_shadow, " m: give 1.01 times ",
                    FieldPath{&path, "near_shadow"}, " or more, which is ", settings.near_shadow, " m.");
}

windrow::Result<std::unique_ptr<Renderer>> Renderer::create(engine::Device& device, const Scene& scene,
                                                            const RenderSettings& settings) {
    windrow::detail::Reasons reasons;
    reasons.add_all_of(validate(scene));
    reasons.add_all_of(validate(settings));
    if (!reasons.empty())
        return windrow::Error{reasons.take()};
    return engine::guarded([&] { return std::unique_ptr<Renderer>(new Renderer(device, scene, settings)); });
}

Renderer::Renderer(engine::Device& device, const Scene& scene, const RenderSettings& settings)
    : device_(device), objects_(device), settings_(settings), clouds_(scene.clouds), sampling_(scene.wind.sampling),
      images_(objects_, {.extent = extent_of(settings),
                         .samples = samples_of(device, settings),
                         .light_bytes = settings.quality.light_bytes,
                         .blurred = settings.shutter_deg > 0.0f}),
      clock_(objects_), wind_(objects_), cloud_map_(objects_, scene.clouds.cover > 0.0f ? settings.quality.cloud_texels : 0),
      sky_map_(objects_, k_sky_format, sky_extent(settings)),
      cloud_noise_(objects_, {.texels = scene.clouds.cover > 0.0f ? settings.quality.cloud_noise_texels : 0,
                              .texel = 1.0f / 64.0f,                   // k_cloud_noise_texel of noise_map.glsl
                              .format = VK_FORMAT_R16G16B16A16_SFLOAT, // every device stores to it and filters it
                              .fill = words::cloud_noise}) {
    if (settings.counts)
        counter_.emplace(objects_);
    const auto side = static_cast<std::uint32_t>(settings.shadow_texels);
    const VkExtent2D both{2 * side, side};
    shadow_map_ = objects_.image({.format = k_shadow_format,
                                  .extent = both,
                                  .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
                                  .aspect = VK_IMAGE_ASPECT_DEPTH_BIT});
    const engine::Attachment map{.role = engine::Attachment::Role::depth,
                                 .format = k_shadow_format,
                                 .view = shadow_map_.view,
                                 .cleared = true,
                                 .end = VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL};
    shadow_pass_.emplace(objects_, both, std::span(&map, 1));
    compare_ = objects_.sampler(engine::Sampler::depth);
    fetch_ = objects_.sampler(engine::Sampler::texels);
    make_sets(scene);

    const std::array layouts{frame_layout_, wind_.layout(), light_layout_};
    full_screen_ = make_pipeline_layout(objects_, layouts);
    cloud_map_.make(objects_, full_screen_);
    sky_map_.make(objects_, full_screen_, words::sky_map_frag);
    const std::uint32_t mapped = settings.quality.sky_pixels > 0 ? 1 : 0;
    sky_ = make_pipeline(objects_, {.vertex = words::full_screen_vert,
                                    .fragment = words::sky_frag,
                                    .constants = std::span(&mapped, 1),
                                    .layout = full_screen_,
                                    .target = images_.scene_target(),
                                    .writes_depth = false});
    tone_ = make_pipeline(objects_, {.vertex = words::full_screen_vert,
                                     .fragment = words::tone_frag,
                                     .layout = full_screen_,
                                     .target = images_.toned_target()});
    if (settings.shutter_deg > 0.0f)
        blur_.emplace(objects_, images_, frame_layout_, settings.shutter_deg);
    terrain_.emplace(objects_, draw_targets(), scene, settings.quality.ground_texels, settings.draft);
    add(*terrain_, "ground");

    const glm::vec3 corner(scene.ground.corner - settings.anchor);
    const auto& grid = scene.ground.heights.grid();
    block_.terrain = {corner.x, corner.z, grid.spacing.x, corner.y};
    block_.terrain_size = {grid.corners, 0, 0};
    block_.pixel = {2.0f / glm::vec2(settings.width, settings.height), settings.draft ? 1.0f : 0.0f, 0.0f};
    block_.sunlight.w = scene.fog.density;
    block_.skylight.w = scene.fog.fall;
    block_.groundlight.w = static_cast<float>(scene.fog.base - settings.anchor.y);
    set_time(0.0);
    (void)set_sun(scene.sun); // was validated
}

void Renderer::make_sets(const Scene& scene) {
    frame_layout_ = make_layout(objects_, k_frame_bindings);
    light_layout_ = make_layout(objects_, k_light_bindings);
    engine::make_sets(objects_, frame_layout_, k_frame_bindings, sets_);
    engine::make_sets(objects_, light_layout_, k_light_bindings, std::span(&light_set_, 1));
    engine::make_sets(objects_, light_layout_, k_light_bindings, std::span(&sky_set_, 1));
    const engine::Buffer heights = Terrain::heights(objects_, scene.ground);
    blocks_ = objects_.frame_buffers(sizeof(ViewBlock), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    for (std::size_t slot = 0; slot < sets_.size(); ++slot) {
        point(device_, sets_[slot], 0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, blocks_[slot].buffer);
        point(device_, sets_[slot], 1, shadow_map_.view, compare_, VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL);
        point(device_, sets_[slot], 3, cloud_map_.map().view(), cloud_map_.map().sampler(),
              VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        point(device_, sets_[slot], 2, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, heights.buffer);
    }
    for (std::uint32_t binding = 0; binding < 2; ++binding) // Mesa 22.3's llvmpipe ends with a fault where one is left out
        point(device_, light_set_, binding, images_.light(), fetch_, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    point(device_, sky_set_, 0, sky_map_.view(), sky_map_.sampler(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    point(device_, sky_set_, 1, cloud_noise_.view(), cloud_noise_.sampler(), VK_IMAGE_LAYOUT_GENERAL);
}

DrawTargets Renderer::draw_targets() const {
    return {.colour = images_.scene_target(),
            .shadow = {shadow_pass_->handle(), VK_SAMPLE_COUNT_1_BIT, 0, true},
            .frame = frame_layout_,
            .wind = wind_.layout()};
}

void Renderer::set_time(double seconds) {
    block_.clouds = cloud_block(clouds_, settings_.anchor, seconds);
}

windrow::Result<void> Renderer::set_sun(const Sun& sun) {
    if (auto judged = validate(sun); !judged)
        return judged;
    block_.sky = sky_block(sun);
    const glm::vec3 beam = sun_irradiance(block_.sky), sky = sky_irradiance(block_.sky);
    block_.sunlight = glm::vec4(beam, block_.sunlight.w);
    block_.skylight = glm::vec4(sky, block_.skylight.w);
    block_.groundlight = glm::vec4(k_meadow_albedo * (sky + beam * block_.sky.sun.y), block_.groundlight.w);
    return {};
}

void Renderer::fill(const Camera& camera) {
    const float aspect = aspect_of(settings_);
    block_.view_projection_before = block_.view_projection;
    block_.eye_before = block_.eye;
    block_.view_projection = view_projection(camera, aspect, settings_.anchor);
    block_.from_clip = glm::inverse(block_.view_projection);
    block_.eye = glm::vec4(glm::vec3(camera.position - settings_.anchor), camera.exposure);
    if (first_) { // nothing was before
        block_.view_projection_before = block_.view_projection;
        block_.eye_before = block_.eye;
        first_ = false;
    }
    const float pixel = 2.0f * std::tan(0.5f * glm::radians(camera.view_deg)) / static_cast<float>(settings_.height);
    block_.eye_before.w = 0.5f * k_min_width * pixel;
    block_.cloud_map = cloud_map_.block(block_.clouds, block_.sky, glm::vec3(block_.eye));
    const float reach[3] = {camera.near, settings_.near_shadow, settings_.far_shadow};
    for (int cascade = 0; cascade < 2; ++cascade) {
        const ShadowView view = shadow_view(camera, aspect, settings_.anchor, block_.sky, reach[cascade], reach[cascade + 1],
                                            settings_.shadow_texels);
        block_.shadow[cascade] = view.matrix;
        block_.shadow_texel[cascade] = view.texel;
    }
    block_.shadow_texel.z = 1.0f / static_cast<float>(settings_.shadow_texels);
    block_.shadow_texel.w = settings_.near_shadow;
}

void Renderer::begin(const engine::Frame& frame) {
    clock_.begin(frame.commands, frame.slot);
    if (counter_)
        counter_->begin(frame.commands, frame.slot);
}

void Renderer::draw_shadows(PassContext context) {
    context.pass = Pass::shadow;
    shadow_pass_->begin(context.commands);
    const auto side = static_cast<std::uint32_t>(settings_.shadow_texels);
    for (context.cascade = 0; context.cascade < 2; ++context.cascade) {
        engine::set_area(context.commands, {{context.cascade * settings_.shadow_texels, 0}, {side, side}});
        for (const NamedDrawable& each : drawables_)
            each.drawable->draw(context);
    }
    vkCmdEndRenderPass(context.commands);
}

void Renderer::draw_colour(const PassContext& context) {
    const VkCommandBuffer commands = context.commands;
    images_.scene().begin(commands);
    const auto figured = [&](const char* name, const auto& draw) {
        if (counter_)
            counter_->enter(commands, name);
        draw();
        if (counter_)
            counter_->leave(commands);
        if (settings_.apart)
            clock_.mark(commands, name);
    };
    for (std::size_t n = 1; n < drawables_.size(); ++n)
        figured(drawables_[n].name, [&] { drawables_[n].drawable->draw(context); });
    // The ground after what stands on it: little of it is seen where grass stands. The sky last: only where nothing stands before it.
    figured(drawables_.front().name, [&] { drawables_.front().drawable->draw(context); });
    figured("sky", [&] {
        const std::array sets{context.frame, context.wind, sky_set_};
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, full_screen_, 0, 3, sets.data(), 0, nullptr);
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, sky_);
        vkCmdDraw(commands, 3, 1, 0, 0);
    });
    vkCmdEndRenderPass(commands);
}

PassContext Renderer::context_of(const engine::Frame& frame, const Camera& camera, const engine::SampledWind& wind) {
    fill(camera);
    std::memcpy(blocks_[frame.slot].mapped, &block_, sizeof block_);
    return {.commands = frame.commands,
            .frame = sets_[frame.slot],
            .wind = wind_.of(frame.slot, wind, settings_.anchor, sampling_),
            .block = &block_,
            .anchor = settings_.anchor,
            .slot = frame.slot};
}

windrow::Result<void> Renderer::keep_up(const engine::Frame& frame, const Camera& camera, const engine::SampledWind& wind,
                                        std::span<Drawable* const> drawables) {
    if (auto judged = validate(camera); !judged)
        return judged;
    const PassContext context = context_of(frame, camera, wind);
    for (Drawable* const drawable : drawables)
        if (auto prepared = drawable->prepare(context); !prepared)
            return prepared;
    return {};
}

windrow::Result<void> Renderer::record(const engine::Frame& frame, const Camera& camera, const engine::SampledWind& wind) {
    if (auto judged = validate(camera); !judged)
        return judged;
    const PassContext context = context_of(frame, camera, wind);
    const VkCommandBuffer commands = frame.commands;
    clock_.mark(commands, "wind");
    for (const NamedDrawable& each : drawables_)
        if (auto prepared = each.drawable->prepare(context); !prepared)
            return prepared;
    clock_.mark(commands, "prepare");
    const std::array sets{context.frame, context.wind, light_set_};
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, full_screen_, 0, 3, sets.data(), 0, nullptr);
    cloud_map_.map().record(commands);
    sky_map_.record(commands);
    cloud_noise_.record(commands, glm::vec2(block_.clouds.place) + block_.clouds.place.w * glm::vec2(block_.eye.x, block_.eye.z));
    draw_shadows(context);
    clock_.mark(commands, "shadow");

    draw_colour(context);
    clock_.mark(commands, "colour");

    if (blur_) {
        blur_->record(commands, context.frame);
        clock_.mark(commands, "blur");
    }
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, full_screen_, 0, 3, sets.data(), 0, nullptr);
    images_.toned().begin(commands);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, tone_);
    vkCmdDraw(commands, 3, 1, 0, 0);
    vkCmdEndRenderPass(commands);
    clock_.mark(commands, "tone");
    return {};
}

void Renderer::copy(const engine::Frame& frame) {
    images_.copy(frame.commands);
    clock_.mark(frame.commands, "copy");
}

} // namespace windrow::vegetation::render
