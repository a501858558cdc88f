// The vertex stage against the CPU: which blade an instance is, and where its vertices go.
#include "shader_words/vertices.h"
#include "tests/figure.h"
#include "vegetation/tests/grass/device.h"
#include "vegetation/vulkan/descriptors.h"
#include "vegetation/vulkan/pipeline.h"

#include <algorithm>
#include <array>
#include <vulkan/vulkan.h>

namespace windrow::vegetation::grass {
namespace {

using namespace windrow::numerics;

class GrassVertices : public test::GrassOnTheDevice {
  protected:
    struct DrawnList {
        std::uint32_t slot, level, instances;
    };
    // Position and normal of 15 vertices an instance.
    std::vector<glm::vec4> vertices_of(const DrawnList& list) {
        const std::size_t count = std::size_t{30} * list.instances;
        engine::Objects objects(*renders);
        constexpr std::array bindings{engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_COMPUTE_BIT}};
        const VkBuffer out = objects
                                 .buffer(engine::Use::work, count * sizeof(glm::vec4),
                                         VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT)
                                 .buffer;
        const std::array layouts{field->layout(), make_layout(objects, bindings)};
        std::array sets{field->set(), VkDescriptorSet{}};
        make_sets(objects, layouts[1], bindings, std::span(sets).last(1));
        point(*renders, sets[1], 0, bindings[0].type, out);
        const VkPipelineLayout layout = make_pipeline_layout(objects, layouts);
        const VkPipeline pipeline = make_compute_pipeline(objects, layout, windrow::vulkan::shader_words::vertices);
        run([&](VkCommandBuffer commands) {
            vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
            vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 2, sets.data(), 0, nullptr);
            vkCmdPushConstants(commands, layout, VK_SHADER_STAGE_ALL, 0, sizeof list, &list);
            vkCmdDispatch(commands, (list.instances + 63) / 64, 1, 1);
            barrier(commands);
        });
        return values_of<glm::vec4>(out, count);
    }
};

TEST_F(GrassVertices, AreThoseOfTheCpu) {
    make_field();
    const glm::dvec3 corner(4.0e5, 12.0, -2.5e5), anchor = corner + glm::dvec3(20.0, 0.0, 10.0);
    ASSERT_TRUE(field->place(corner));
    Block block = block_of(field->settings(), heights, mask);
    const test::Eye eye = test::eye_at(glm::vec3(2.0f, 2.5f, 5.0f) - glm::vec3(20.0f, 0.0f, 10.0f), {0.1f, -0.1f, 1.0f}, 1.2f);
    (void)cull({.anchor = anchor, .view_projection = eye.view_projection, .eye = eye.at});
    const glm::vec3 eye_here = glm::vec3(anchor + glm::dvec3(eye.at) - corner), up(0.0f, 1.0f, 0.0f);
    const auto blades = values_of<BladeRecord>(field->blade_buffer(), slots() * places());
    const auto lists = values_of<std::uint32_t>(field->list_buffer(), 2 * slots() * places());
    const auto commands = draws();
    double position = 0.0, normal = 0.0;
    std::array<std::size_t, 2> compared{};
    std::size_t morphing = 0;
    const int far_rows = static_cast<int>(block.ground.w);
    const int side = field->settings().chunk_cells;
    for (int chunk = 0; chunk < field->tree().chunks().x * field->tree().chunks().y; ++chunk) {
        const glm::ivec2 at(chunk % field->tree().chunks().x, chunk / field->tree().chunks().x);
        const int slot = field->slot_of({at});
        for (std::uint32_t level = 0; slot >= 0 && level < 2; ++level) {
            const std::uint32_t instances = commands[4 * static_cast<std::size_t>(slot) + level].instanceCount;
            if (instances == 0)
                continue;
            const auto got = vertices_of({static_cast<std::uint32_t>(slot), level, instances});
            for (std::uint32_t n = 0; n < instances; ++n) {
                const std::size_t list = 2 * static_cast<std::size_t>(slot);
                const std::uint32_t place = lists[level == 0 ? list * places() + n : (list + 1) * places() - 1 - n];
                const BladeRecord record = blades[static_cast<std::size_t>(slot) * places() + place];
                const glm::ivec2 cell = at * side + glm::ivec2(static_cast<int>(place) % side, static_cast<int>(place) / side);
                const glm::vec3 root(record);
                const float distance = glm::length(root - eye_here);
                const WindrowBlade kind = windrow_grass_class(block, record.w, distance);
                const glm::uvec2 hash = windrow_plant_hash(windrow_grass_key(cell, 0u, 0u));
                const WindrowBladePlant plant = windrow_blade_plant(
                    kind, up, hash, windrow_blade_load(kind, up, hash, {6.0f, 0.0f, 0.0f}), (root - eye_here) / distance);
                const float morph = windrow_grass_ramp(distance, block.reach.x, block.reach.y);
                morphing += level == 0 && morph > 0.0f;
                for (int vertex = 0; vertex < (level == 0 ? 15 : 2 * far_rows + 1); ++vertex) {
                    const glm::vec2 row = windrow_grass_row(vertex, static_cast<int>(level), far_rows, morph);
                    const WindrowVertex cpu = windrow_blade_vertex(kind, plant, row.x, row.y);
                    const std::size_t mine = 2 * (std::size_t{15} * n + static_cast<std::size_t>(vertex));
                    const glm::vec3 from_anchor = root + cpu.position + glm::vec3(corner - anchor);
                    position = std::max(position, static_cast<double>(glm::length(glm::vec3(got[mine]) - from_anchor)));
                    normal = std::max(normal, static_cast<double>(glm::length(glm::vec3(got[mine + 1]) - cpu.normal)));
                    ++compared[level];
                }
            }
        }
    }
    EXPECT_GT(compared[0], 1000u);
    EXPECT_GT(compared[1], 1000u);
    EXPECT_GT(morphing, 100u);
    // A blade has 0.3 m, its root lies up to 110 m from the corner: sums of floats, 400 km from the world's origin.
    WINDROW_EXPECT_FIGURE("grass/gpu/vertex_position_error_m", position, 5e-5);
    WINDROW_EXPECT_FIGURE("grass/gpu/vertex_normal_error", normal, 1e-4);
}

} // namespace
} // namespace windrow::vegetation::grass
