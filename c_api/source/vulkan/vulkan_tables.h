// Handles of Vulkan as C has them, and the tables of vulkan_host.h and vulkan_wind.h.
#pragma once

#include "c_api/source/tables.h"
#include "c_api/vulkan_wind.h"
#include "fluid/vulkan/own_device.h"
#include "fluid/vulkan/pipeline_store.h"
#include "fluid/vulkan/wind.h"

struct windrow_vulkan_pipeline_store {
    std::shared_ptr<windrow::vulkan::PipelineStore> store;
};

namespace windrow::c_api {

/// Of a handle that is no pointer on each system: VkImage, VkBuffer.
template <class Handle>
[[nodiscard]] Handle handle_of(std::uint64_t number) {
    if constexpr (std::is_pointer_v<Handle>)
        return reinterpret_cast<Handle>(static_cast<std::uintptr_t>(number));
    else
        return number;
}
template <class Handle>
[[nodiscard]] std::uint64_t number_of(Handle handle) {
    if constexpr (std::is_pointer_v<Handle>)
        return reinterpret_cast<std::uintptr_t>(handle);
    else
        return handle;
}

template <>
inline constexpr int k_values<vulkan::Texel> = 2;
template <>
inline constexpr int k_values<vulkan::TextureSet> = 3;
template <>
inline constexpr int k_values<vulkan::ReadBack> = 5;

WINDROW_C_STRUCT_BUT(1, windrow_vulkan_requirements, vulkan::Requirements, api_version, shared_bytes, invocations,
                     storage_buffers, storage_images);
WINDROW_C_STRUCT_BUT(8, windrow_vulkan_host, vulkan::Host, queue_family, reader_stages, shared_bytes, pipeline_store,
                     get_instance_proc_addr);
WINDROW_C_STRUCT_BUT(1, windrow_vulkan_settings, vulkan::Settings, texel, textures, frames_in_flight, gusts, timestamps, queries,
                     read_cells, read_points, forces, obstacles);
WINDROW_C_STRUCT_BUT(2, windrow_vulkan_frame, vulkan::Frame, slot, dt, save);

void read_rest(Reasons& reasons, const Path& path, const windrow_vulkan_pipeline_store* from,
               std::shared_ptr<vulkan::PipelineStore>& to);
void read_rest(Reasons& reasons, const Path& path, windrow_vulkan_get_instance_proc_addr from, PFN_vkGetInstanceProcAddr& to);
void read_rest(Reasons& reasons, const Path& path, const windrow_vulkan_host& from, vulkan::Host& to);
void write_rest(Writing, const vulkan::Host& from, windrow_vulkan_host& to);
void read_rest(Reasons& reasons, const Path& path, const windrow_vulkan_settings& from, vulkan::Settings& to);
void write_rest(Writing, const vulkan::Settings& from, windrow_vulkan_settings& to);
void read_rest(Reasons& reasons, const Path& path, const windrow_vulkan_frame& from, vulkan::Frame& to);

/// Runs use(host) on the host of a struct.
template <class Use>
[[nodiscard]] windrow_result with_host(const windrow_vulkan_host* host, const Use& use) {
    return call({{host, "host"}}, [&] { return with(host, use); });
}
[[nodiscard]] inline VkCommandBuffer commands_of(void* commands) {
    return static_cast<VkCommandBuffer>(commands);
}

} // namespace windrow::c_api
