#include "vegetation/render/wind_streaks.h"

#include "fluid/core/validation.h"
#include "shader_words/solid_frag.h"
#include "shader_words/solid_vert.h"
#include "vegetation/render/solids.h"
#include "vegetation/vulkan/calls.h"
#include "vegetation/vulkan/descriptors.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <utility>

namespace windrow::vegetation::render {
namespace {

namespace words = windrow::vulkan::shader_words;

constexpr std::array k_streak_bindings{engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_VERTEX_BIT},
                                       engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_VERTEX_BIT}};
constexpr std::size_t k_vertices_of_one = 6 * (StreakWays::k_points - 1);

/// As SolidPlace of vegetation/shaders/render/solid.glsl.
struct Unmoved {
    glm::mat4 now{1.0f}, before{1.0f};
};

/// Evenly spread places of 0 to 1 (Roberts 2018, the sequence R3: powers of the root of x^4 = x + 1).
glm::dvec3 spread(std::uint32_t number) {
    constexpr double k_root = 1.2207440846057596;
    const glm::dvec3 step(1.0 / k_root, 1.0 / (k_root * k_root), 1.0 / (k_root * k_root * k_root));
    return glm::fract(0.5 + static_cast<double>(number) * step);
}

} // namespace

windrow::Result<void> validate(const WindStreakSettings& settings) {
    return windrow::detail::validate_settings(settings, "streaks");
}

void check_rules(windrow::detail::Reasons& reasons, const windrow::detail::FieldPath& path, const WindStreakSettings& settings) {
    if (settings.highest < settings.lowest)
        reasons.add(windrow::detail::FieldPath{&path, "highest"}, " is ", settings.highest, " m, below ",
                    windrow::detail::FieldPath{&path, "lowest"}, ", ", settings.lowest, " m: give at least that.");
}

StreakWays::StreakWays(const WindStreakSettings& settings, const StreakBox& box)
    : settings_(settings), box_(box), ways_(static_cast<std::size_t>(settings.count)), heads_(ways_.size()),
      velocities_(ways_.size()) {
    for (std::size_t n = 0; n < ways_.size(); ++n) // of all ages, so that they do not end at once
        begin(ways_[n], static_cast<double>(settings.life) * static_cast<double>(n) / static_cast<double>(ways_.size()));
}

void StreakWays::begin(Way& way, double age) {
    const glm::dvec3 share = spread(++begun_);
    const auto low = static_cast<double>(settings_.lowest), high = static_cast<double>(settings_.highest);
    way.points[0] =
        box_.low + glm::dvec3(share.x * box_.extent.x, low + (high - low) * share.y * share.y, share.z * box_.extent.z);
    way.used = 1;
    way.since = 0.0;
    way.age = age;
}

float StreakWays::strength(const Way& way) const {
    const float share = static_cast<float>(way.age) / settings_.life;
    return glm::smoothstep(0.0f, 0.2f, share) * glm::smoothstep(0.0f, 0.2f, 1.0f - share);
}

StreakWays::Point StreakWays::point(const Way& way, int number) const {
    const auto n = static_cast<std::size_t>(number);
    if (number == 0)
        return {way.points[0], 1.0};
    const auto seconds = static_cast<double>(settings_.seconds);
    const double before = way.since + (number - 1) * apart();
    if (before < seconds)
        return {way.points[n], 1.0 - before / seconds};
    return {glm::mix(way.points[n - 1], way.points[n], glm::clamp(1.0 - (before - seconds) / apart(), 0.0, 1.0)), 0.0};
}

void StreakWays::advance(double dt, const Velocity& velocity, const Blocked& blocked) {
    const int steps = std::max(1, static_cast<int>(std::ceil(dt / apart() - 1e-6)));
    const double length = dt / steps; // [s]
    for (int step = 0; step < steps; ++step) {
        for (std::size_t n = 0; n < ways_.size(); ++n)
            heads_[n] = ways_[n].points[0];
        velocity(heads_, velocities_);
        for (std::size_t n = 0; n < ways_.size(); ++n) {
            Way& way = ways_[n];
            way.age += length;
            const glm::dvec3 next = heads_[n] + length * glm::dvec3(velocities_[n]);
            const glm::dvec3 share = (next - box_.low) / box_.extent;
            const bool inside =
                share.x >= 0.0 && share.y >= 0.0 && share.z >= 0.0 && share.x <= 1.0 && share.y <= 1.0 && share.z <= 1.0;
            if (!inside || way.age > static_cast<double>(settings_.life) || blocked(heads_[n], next)) {
                begin(way, 0.0);
                continue;
            }
            // A point stays behind each `apart()` s, on the line of this step; in between the head alone moves.
            const double left = apart() - way.since;
            if (way.used == 1 || left < length - 1e-9) {
                const bool first = way.used == 1;
                std::copy_backward(way.points.begin() + 1, way.points.end() - 1, way.points.end());
                way.points[1] = first ? heads_[n] : heads_[n] + std::max(left, 0.0) / length * (next - heads_[n]);
                way.since = first ? 0.0 : -left;
                way.used = std::min(way.used + 1, k_points);
            }
            way.since += length;
            way.points[0] = next;
        }
    }
}

glm::vec3 upright_normal(glm::vec3 to_eye) {
    constexpr float k_facing = 0.1f; // of a unit vector: a ribbon between two normals is not quite flat
    return glm::normalize(glm::vec3(0.0f, 1.0f, 0.0f) - std::min(to_eye.y - k_facing, 0.0f) * to_eye);
}

Result<std::unique_ptr<WindStreaks>> WindStreaks::create(engine::Device& device, const DrawTargets& targets,
                                                         const WindStreakSettings& settings, const StreakBox& box) {
    if (auto judged = validate(settings); !judged)
        return judged.failure();
    return engine::guarded([&] { return std::unique_ptr<WindStreaks>(new WindStreaks(device, targets, settings, box)); });
}

WindStreaks::WindStreaks(engine::Device& device, const DrawTargets& targets, const WindStreakSettings& settings,
                         const StreakBox& box)
    : objects_(device), settings_(settings), ways_(settings, box) {
    const VkDescriptorSetLayout own = make_layout(objects_, k_streak_bindings);
    const std::array layouts{targets.frame, targets.wind, own};
    layout_ = make_pipeline_layout(objects_, layouts);
    pipeline_ = make_pipeline(
        objects_, {.vertex = words::solid_vert, .fragment = words::solid_frag, .layout = layout_, .target = targets.colour});
    make_sets(objects_, own, k_streak_bindings, sets_);
    const engine::Buffer unmoved = filled_block(objects_, Unmoved{}, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    vertices_ = objects_.frame_buffers(sizeof(SolidVertex) * k_vertices_of_one * static_cast<std::size_t>(settings.count),
                                       VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    for (std::size_t slot = 0; slot < sets_.size(); ++slot) {
        point(device, sets_[slot], 0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, vertices_[slot].buffer);
        point(device, sets_[slot], 1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, unmoved.buffer);
    }
}

Result<void> WindStreaks::prepare(const PassContext& context) {
    auto* vertex = static_cast<SolidVertex*>(vertices_[static_cast<std::size_t>(context.slot)].mapped);
    const SolidVertex* const begin = vertex;
    const glm::vec3 eye(context.block->eye);
    const float half_pixel = context.block->eye_before.w; // [m] for each metre of distance
    for (const StreakWays::Way& way : ways_.ways()) {
        // Corners of the ribbon, turned to the eye, from the head to the tail.
        std::array<glm::vec3, 2> last{};
        glm::vec4 last_normal(0.0f);
        for (int n = 0; n < way.used; ++n) {
            const StreakWays::Point drawn = ways_.point(way, n);
            const glm::vec3 here(drawn.place - context.anchor);
            const int other = n + 1 < way.used ? n + 1 : std::max(n - 1, 0);
            const glm::vec3 along =
                (n + 1 < way.used ? 1.0f : -1.0f) * (here - glm::vec3(ways_.point(way, other).place - context.anchor));
            const float distance = std::max(glm::distance(eye, here), 1e-6f);
            glm::vec3 beside = glm::cross(along, eye - here);
            const float length = glm::length(beside);
            const float half =
                std::max(0.5f * settings_.width, half_pixel * distance) * static_cast<float>(drawn.share) * ways_.strength(way);
            beside = length > 1e-9f ? beside * (half / length) : glm::vec3(0.0f);
            const std::array corners{here - beside, here + beside};
            const glm::vec4 normal(upright_normal((eye - here) / distance), 0.0f);
            if (n > 0)
                for (const auto& [corner, its] :
                     {std::pair(last[0], last_normal), std::pair(last[1], last_normal), std::pair(corners[1], normal),
                      std::pair(last[0], last_normal), std::pair(corners[1], normal), std::pair(corners[0], normal)})
                    *vertex++ = {glm::vec4(corner, 0.0f), its, glm::vec4(settings_.colour, 0.0f)};
            last = corners;
            last_normal = normal;
        }
    }
    drawn_ = static_cast<std::uint32_t>(vertex - begin);
    return {};
}

void WindStreaks::draw(const PassContext& context) {
    if (context.pass == Pass::shadow)
        return; // they are no things
    const std::array sets{context.frame, context.wind, sets_[static_cast<std::size_t>(context.slot)]};
    vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 3, sets.data(), 0, nullptr);
    vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
    vkCmdDraw(context.commands, drawn_, 1, 0, 0);
}

} // namespace windrow::vegetation::render
