// A renderer with coats in a wind, small and without fog: its linear light, motion and counters are read back.
#pragma once

#include "fluid/vulkan/wind.h"
#include "vegetation/fur/coat.h"
#include "vegetation/fur/shapes.h"
#include "vegetation/render/renderer.h"
#include "vegetation/vulkan/frames.h"

#include <glm/matrix.hpp>
#include <gtest/gtest.h>
#include <memory>
#include <optional>
#include <vector>
#include <vulkan/vulkan.h>

namespace windrow::vegetation::fur::test {

inline constexpr glm::dvec3 k_anchor{4e5, 0.0, -2.5e5}; // [m]
inline constexpr double k_frame = 1.0 / 30.0;           // [s]

struct StageSettings {
    glm::vec3 ambient{0.0f}; ///< [m/s]
    float gusts = 0.0f;      ///< 0 to 1
    int width = 256, height = 256, samples = 1, shadow_texels = 64;
    float near_shadow = 12.0f; ///< [m]
    bool ground = false;       ///< seen: else it lies far below
    render::Sun sun{};
};

struct Stage {
    explicit Stage(const StageSettings& settings = {})
        : device(engine::must(engine::Device::create())), frames(engine::must(engine::Frames::create(*device))) {
        scene.sun = settings.sun;
        scene.fog.density = 0.0f;
        scene.ground.corner = k_anchor - glm::dvec3(50.0, settings.ground ? 0.0 : 400.0, 50.0);
        windrow::Config& config = scene.wind.wind;
        config.cells = {16, 16, 16};
        config.centre = k_anchor + glm::dvec3(0.0, 2.0, 0.0);
        config.ambient = settings.ambient;
        config.gusts = {.intensity = settings.gusts, .length = 6.0f};
        auto made = windrow::vulkan::Wind::create(device->host(), config, {.frames_in_flight = engine::k_frames_in_flight});
        EXPECT_TRUE(made) << made.error();
        wind.emplace(*std::move(made));
        auto drawn = render::Renderer::create(*device, scene,
                                              {.width = settings.width,
                                               .height = settings.height,
                                               .samples = settings.samples,
                                               .shadow_texels = settings.shadow_texels,
                                               .near_shadow = settings.near_shadow,
                                               .anchor = k_anchor,
                                               .counts = true});
        EXPECT_TRUE(drawn) << drawn.error();
        renderer = *std::move(drawn);
    }

    /// Another coat that is drawn.
    Coat& dress(const Mesh& mesh, const CoatSettings& settings, const windrow::Pose& body, const CoatPictures& pictures = {}) {
        auto made = Coat::create(*device, renderer->draw_targets(), mesh, {}, settings, pictures, body, k_anchor);
        if (!made)
            ADD_FAILURE() << made.error();
        coats.push_back(*std::move(made));
        renderer->add(*coats.back());
        return *coats.back();
    }

    /// One frame, done when this returns.
    void draw(const render::Camera& camera, double seconds = k_frame) {
        const engine::Frame frame = engine::must(frames->begin());
        renderer->begin(frame);
        engine::must(wind->record(frame.commands, {.dt = static_cast<float>(seconds), .slot = frame.slot}));
        const auto recorded = renderer->record(frame, camera, *wind);
        EXPECT_TRUE(recorded) << recorded.error();
        renderer->copy(frame);
        engine::must(frames->finish(frame));
        renderer->clock().collect(frame.slot);
        if (renderer->counter())
            counted = sum_of(renderer->counter()->collect(frame.slot));
    }

    /// Radiance of a pixel of the last frame, before exposure. Read `light` again after each frame.
    [[nodiscard]] render::PictureF light() const { return renderer->images().light_picture(); }

    render::Scene scene;
    std::unique_ptr<engine::Device> device;
    std::unique_ptr<engine::Frames> frames;
    std::optional<windrow::vulkan::Wind> wind;
    std::unique_ptr<render::Renderer> renderer;
    std::vector<std::unique_ptr<Coat>> coats;
    render::VertexCounts counted{};
};

/// Where `from` [m] from the anchor looks at `to`.
inline render::Camera camera_at(glm::dvec3 from, glm::dvec3 to = glm::dvec3(0.0), float view_deg = 30.0f) {
    render::Camera camera;
    camera.position = k_anchor + from;
    camera.target = k_anchor + to;
    camera.view_deg = view_deg;
    camera.near = 0.01f;
    return camera;
}

inline glm::vec3 radiance(const render::PictureF& picture, int column, int row) {
    return {picture.at(column, row, 0), picture.at(column, row, 1), picture.at(column, row, 2)};
}

/// [pixels] Where a place [m from the anchor] is seen, x right, y down, 0 at the corner.
inline glm::dvec2 seen(const render::Camera& camera, glm::dvec3 place, int width, int height) {
    const glm::dmat4 view(render::view_projection(camera, static_cast<float>(width) / static_cast<float>(height), k_anchor));
    const glm::dvec4 clip = view * glm::dvec4(place, 1.0);
    return (0.5 + 0.5 * glm::dvec2(clip) / clip.w) * glm::dvec2(width, height);
}

/// [m from the anchor] Where the ray through the middle of a pixel meets the level y.
inline glm::dvec3 on_level(const render::Camera& camera, int column, int row, int width, int height, double y) {
    const glm::dmat4 back = glm::inverse(
        glm::dmat4(render::view_projection(camera, static_cast<float>(width) / static_cast<float>(height), k_anchor)));
    const glm::dvec2 clip = 2.0 * (glm::dvec2(column, row) + 0.5) / glm::dvec2(width, height) - 1.0;
    const glm::dvec4 far = back * glm::dvec4(clip, 0.9, 1.0);
    const glm::dvec3 eye = camera.position - k_anchor, way = glm::dvec3(far) / far.w - eye;
    return eye + way * ((y - eye.y) / way.y);
}

/// Strands that leave nothing open: cylinders wider than their cells, as tall as `height` of the coat.
inline StrandFieldSettings closed(float height = 1.0f) {
    return {.density = 20.0f,
            .jitter = 0.0f,
            .low = height,
            .high = height,
            .profile = StrandProfile::centre,
            .cut_min = 1.0f,
            .cut_max = 1.0f};
}

/// A coat that is lit by its colours alone and casts nothing; it does not sag.
inline CoatSettings bare_bones() {
    CoatSettings coat;
    coat.layers.sag = 0.0f;
    coat.look.variation = coat.look.occlusion = coat.look.gloss = coat.look.sheen = 0.0f;
    coat.levels.shadow_shells = 0;
    coat.levels.full_until = 1e4f;
    return coat;
}

/// A level 2 m square of few vertices.
inline Mesh square(float size = 2.0f, int cells = 1) {
    return *sheet({.size = {size, size}, .columns = cells, .rows = cells});
}

inline windrow::Pose at(glm::dvec3 offset, double scale = 1.0) {
    return {.position = k_anchor + offset, .scale = scale};
}

} // namespace windrow::vegetation::fur::test
