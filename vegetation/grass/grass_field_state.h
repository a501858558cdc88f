// What a field keeps; private to it.
#pragma once

#include "vegetation/grass/chunk_cache.h"
#include "vegetation/grass/grass_field.h"

#include <glm/vec4.hpp>
#include <optional>
#include <vector>

namespace windrow::vegetation::grass {

struct GrassField::State {
    State(engine::Device& device, HeightMap ground, PlacementMask grows, const GrassSettings& wanted);

    void make();
    /// The slots of this frame's chunks, as orders for the passes.
    [[nodiscard]] GrassReport choose(const GrassCamera& camera);
    void set_frame(const GrassCamera& camera);

    GrassSettings settings;
    HeightMap heights;
    PlacementMask mask;
    ChunkTree tree;
    ChunkCache cache;
    Block block;
    glm::dvec3 corner{0.0};
    std::optional<glm::dvec3> eye_before{}; // [m] in the world

    engine::Objects objects;
    VkBuffer frame = VK_NULL_HANDLE, blades = VK_NULL_HANDLE, lists = VK_NULL_HANDLE, chunk_places = VK_NULL_HANDLE,
             draws = VK_NULL_HANDLE, orders = VK_NULL_HANDLE, height_values = VK_NULL_HANDLE, mask_values = VK_NULL_HANDLE;
    VkDescriptorSetLayout draw_layout = VK_NULL_HANDLE;
    VkDescriptorSet pass_set = VK_NULL_HANDLE, draw_set = VK_NULL_HANDLE;
    VkPipelineLayout pass_layout = VK_NULL_HANDLE;
    VkPipeline generate = VK_NULL_HANDLE, cull = VK_NULL_HANDLE;

    bool heights_are_there = false;
    glm::ivec2 mask_rows{0, -1}; // that the device does not have yet, ends included
    // Of the frame that was recorded last.
    std::vector<Chunk> seen{}, shaded{};
    std::vector<glm::ivec4> made_orders{}, cull_orders{};
    std::vector<int> drawn[2]; // slots of a view, the nearest first
};

} // namespace windrow::vegetation::grass
