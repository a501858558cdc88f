#include "cli/device_report/meadow.h"

#include "coupling/blade.h"
#include "shader_words/full_screen_vert.h"
#include "shader_words/meadow_backdrop_frag.h"
#include "shader_words/meadow_blade_frag.h"
#include "shader_words/meadow_blade_vert.h"
#include "shader_words/wind_slices_frag.h"

#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

namespace windrow::cli {
namespace {

using namespace vulkan;
namespace words = shader_words;

constexpr double k_step = 1.0 / 30.0;       // [s]
constexpr glm::dvec3 k_walk{4.0, 0.0, 0.0}; // [m/s]
constexpr glm::dvec3 k_chest{0.0, 0.8, 0.0};
constexpr glm::dvec3 k_fan{6.0, 1.2, -5.0};
constexpr glm::vec3 k_fan_axis{-0.98f, -0.10f, 0.17f};

// As scene.glsl has it.
struct Scene {
    glm::mat4 view_projection{1.0f};
    glm::vec4 eye{0.0f}, walker{0.0f};
    BladeBlock grass{};
};

Config meadow_config() {
    return {.cells = {48, 12, 48},
            .cell_size = 0.5f,
            .boundaries = Boundaries::open_over_floor(),
            .centre = {0.0, 3.0, 0.0},
            .ambient = {-1.0f, 0.0f, 3.2f},
            .profile = LogProfile{},
            .gusts = {.intensity = 0.35f, .length = 10.0f}};
}

} // namespace

Result<std::unique_ptr<Meadow>> Meadow::create(OwnDevice& own, Device& device) {
    std::vector<VkDescriptorType> kinds = WindBindings::kinds();
    kinds.insert(kinds.begin(), VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER);
    auto host = DrawHost::create(own, device, kinds);
    if (!host)
        return host.failure();
    const Config config = meadow_config();
    auto bindings = WindBindings::create(device, config.boundaries);
    if (!bindings)
        return bindings.failure();
    auto scene = Buffer::create(device, sizeof(Scene), MemoryUse::upload, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    if (!scene)
        return scene.failure();
    auto wind = vulkan::Wind::create(own.host(), config, {.frames_in_flight = 1});
    if (!wind)
        return wind.failure();
    const auto fan = wind->motors().add(JetMotor{.position = k_fan,
                                                 .direction = k_fan_axis,
                                                 .length = 7.0f,
                                                 .start_radius = 0.9f,
                                                 .end_radius = 1.6f,
                                                 .law = Drive{.speed = 12.0f, .rate = 8.0f}});
    const auto walker = wind->motors().add(WakeMotor{.position = k_chest, .radius = 0.9f, .law = WakeDrive{.per_metre = 20.0f}});
    if (!fan || !walker)
        return fan ? walker.failure() : fan.failure();
    std::unique_ptr<Meadow> made(new Meadow(own, *std::move(host), *std::move(bindings), *std::move(scene), *std::move(wind)));
    made->walker_ = *walker;
    return made;
}

Result<void> Meadow::blow(int steps, const std::function<bool()>& stopped) {
    for (int n = 1; n <= steps && !stopped(); ++n) {
        feet_ = k_step * (n - steps / 2) * k_walk;
        if (auto moved = wind_.motors().move(walker_, feet_ + k_chest); !moved)
            return moved;
        Result<void> recorded;
        auto ran = own_.run([&](VkCommandBuffer commands) {
            if (const auto step = wind_.record_step(commands, {.dt = k_step}); !step)
                recorded = step.failure();
        });
        if (!ran || !recorded)
            return ran ? recorded : ran;
    }
    return {};
}

Result<void> Meadow::look(Eye eye, VkExtent2D extent, std::uint32_t blades) {
    const bool above = eye == Eye::above;
    const glm::vec3 at = above ? glm::vec3(0.0f, 11.0f, 5.5f) : glm::vec3(0.0f, 2.2f, 8.5f);
    const glm::vec3 ahead = above ? glm::vec3(0.0f, -1.0f, -0.62f) : glm::vec3(0.0f, -0.20f, -1.0f);
    glm::mat4 projection = glm::perspectiveRH_ZO(
        glm::radians(44.0f), static_cast<float>(extent.width) / static_cast<float>(extent.height), 0.4f, 160.0f);
    projection[1][1] = -projection[1][1]; // Vulkan's clip space has y down
    const auto grass = Blades::create({.stalk = {}, .width = 0.012f, .view_bend = 0.4f});
    const Scene scene{.view_projection = projection * glm::lookAtRH(at, at + ahead, {0.0f, 1.0f, 0.0f}),
                      .eye = glm::vec4(at, static_cast<float>(blades)),
                      .walker = glm::vec4(glm::vec3(feet_), above ? 13.0f : 0.0f),
                      .grass = grass ? grass->block() : BladeBlock{}};
    std::memcpy(scene_.mapped(), &scene, sizeof scene);
    (void)scene_.flush(); // memory for uploads is coherent
    std::vector<Binding> bindings = bindings_.of(wind_, {}, {.detail = 0.5f, .detail_length = 0.5f});
    bindings.insert(bindings.begin(), {.type = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, .buffer = scene_.handle()});
    return host_->bind(std::move(bindings));
}

Result<std::vector<DrawHost::Draw>> Meadow::frame(const DrawHost::Target& target, std::uint32_t blades) {
    const auto sky =
        host_->pipeline(target, {.vertex = words::full_screen_vert, .fragment = words::meadow_backdrop_frag, .depth = false});
    if (!sky)
        return sky.failure();
    const auto grass = host_->pipeline(target, {.vertex = words::meadow_blade_vert,
                                                .fragment = words::meadow_blade_frag,
                                                .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP});
    if (!grass)
        return grass.failure();
    return std::vector<DrawHost::Draw>{{*sky, 3, 1}, {*grass, k_blade_vertices, blades}};
}

Result<std::vector<DrawHost::Draw>> Meadow::vertices(const DrawHost::Target& target, std::uint32_t blades) {
    const auto grass = host_->pipeline(
        target, {.vertex = words::meadow_blade_vert, .fragment = {}, .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP});
    if (!grass)
        return grass.failure();
    return std::vector<DrawHost::Draw>{{*grass, k_blade_vertices, blades}};
}

Result<std::vector<DrawHost::Draw>> Meadow::slices(const DrawHost::Target& target) {
    const auto slice =
        host_->pipeline(target, {.vertex = words::full_screen_vert, .fragment = words::wind_slices_frag, .depth = false});
    if (!slice)
        return slice.failure();
    return std::vector<DrawHost::Draw>{{*slice, 3, 1}};
}

} // namespace windrow::cli
