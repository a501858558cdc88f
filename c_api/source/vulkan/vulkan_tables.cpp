#include "c_api/source/vulkan/vulkan_tables.h"

namespace windrow::c_api {

void read_rest(Reasons&, const Path&, const windrow_vulkan_pipeline_store* from, std::shared_ptr<vulkan::PipelineStore>& to) {
    to = from != nullptr ? from->store : nullptr;
}
void read_rest(Reasons&, const Path&, windrow_vulkan_get_instance_proc_addr from, PFN_vkGetInstanceProcAddr& to) {
    to = reinterpret_cast<PFN_vkGetInstanceProcAddr>(from);
}

void read_rest(Reasons& reasons, const Path& path, const windrow_vulkan_host& from, vulkan::Host& to) {
    to.instance = static_cast<VkInstance>(from.instance);
    to.physical_device = static_cast<VkPhysicalDevice>(from.physical_device);
    to.device = static_cast<VkDevice>(from.device);
    to.allocation_callbacks = static_cast<const VkAllocationCallbacks*>(from.allocation_callbacks);
    to.pipeline_cache = handle_of<VkPipelineCache>(from.pipeline_cache);
    if (from.reader_queue_family_count > 0 && from.reader_queue_families == nullptr)
        reasons.add(path, ".reader_queue_families is null: give ", from.reader_queue_family_count, " families.");
    else
        to.reader_queue_families.assign(from.reader_queue_families, from.reader_queue_families + from.reader_queue_family_count);
    if (from.allocate != nullptr)
        to.memory.allocate = [allocate = from.allocate, user = from.memory_user](const VkMemoryRequirements& wanted,
                                                                                 std::uint32_t type, vulkan::MemoryPiece& block) {
            windrow_vulkan_memory given{};
            const auto result =
                static_cast<VkResult>(allocate(wanted.size, wanted.alignment, wanted.memoryTypeBits, type, &given, user));
            block = {handle_of<VkDeviceMemory>(given.memory), given.offset, given.mapped, given.user};
            return result;
        };
    if (from.release != nullptr)
        to.memory.release = [release = from.release, user = from.memory_user](const vulkan::MemoryPiece& block) {
            const windrow_vulkan_memory given{number_of(block.memory), block.offset, block.mapped, block.user};
            release(&given, user);
        };
    to.pipelines.flags = from.pipeline_flags;
    if (from.pipeline_created != nullptr)
        to.pipelines.created = [created = from.pipeline_created, user = from.pipeline_user](
                                   const char* name, VkPipeline pipeline) { created(name, number_of(pipeline), user); };
}

void write_rest(Writing, const vulkan::Host& from, windrow_vulkan_host& to) {
    to.get_instance_proc_addr = reinterpret_cast<windrow_vulkan_get_instance_proc_addr>(from.get_instance_proc_addr);
    to.instance = from.instance;
    to.physical_device = from.physical_device;
    to.device = from.device;
    to.allocation_callbacks = from.allocation_callbacks;
    to.pipeline_cache = number_of(from.pipeline_cache);
    to.pipeline_flags = from.pipelines.flags;
}

void read_rest(Reasons&, const Path&, const windrow_vulkan_settings& from, vulkan::Settings& to) {
    to.export_textures = static_cast<VkExternalMemoryHandleTypeFlagBits>(from.export_textures);
}
void write_rest(Writing, const vulkan::Settings& from, windrow_vulkan_settings& to) {
    to.export_textures = static_cast<std::uint32_t>(from.export_textures);
}

void read_rest(Reasons& reasons, const Path& path, const windrow_vulkan_frame& from, vulkan::Frame& to) {
    if (from.around != nullptr)
        to.around = to_cpp(*from.around);
    if (from.points == nullptr && from.point_count > 0)
        reasons.add(path, ".points is null: give ", from.point_count, " points.");
    else
        to.points = {same_layout<const glm::dvec3>(from.points), static_cast<std::size_t>(from.point_count)};
}

} // namespace windrow::c_api
