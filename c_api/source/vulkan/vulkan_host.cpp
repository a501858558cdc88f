// Calls of vulkan_host.h.
#include "c_api/vulkan_host.h"

#include "c_api/source/vulkan/vulkan_tables.h"
#include "fluid/core/message.h"

#include <algorithm>
#include <string>
#include <vector>

using namespace windrow;
using namespace windrow::c_api;

struct windrow_vulkan_device_list {
    std::vector<vulkan::DeviceFacts> devices;
};
struct windrow_vulkan_device {
    std::unique_ptr<vulkan::OwnDevice> device;
};

namespace windrow::c_api {

struct NoFacts {};
template <>
struct Fields<windrow_vulkan_device_facts> {
    using Cpp = NoFacts;
    static constexpr const char* k_name = "windrow_vulkan_device_facts";
    static constexpr auto list() { return std::tuple{}; }
};
WINDROW_C_STRUCT_BUT(5, windrow_vulkan_device_settings, vulkan::OwnDevice::Settings, device, validation, gpu_validation, queue,
                     queue_without, compute_queue, get_instance_proc_addr);

void read_rest(Reasons& reasons, const Path& path, const windrow_vulkan_device_settings& from, vulkan::OwnDevice::Settings& to) {
    const auto read_names = [&](const char* field, const char* const* names, std::uint32_t count,
                                std::vector<const char*>& list) {
        if (count > 0 && (names == nullptr || std::find(names, names + count, nullptr) != names + count))
            reasons.add(path, field, " is null, or one of them is: give ", count, " names.");
        else
            list.assign(names, names + count);
    };
    read_names(".extensions", from.extensions, from.extension_count, to.extensions);
    read_names(".instance_extensions", from.instance_extensions, from.instance_extension_count, to.instance_extensions);
    if (from.wished != nullptr)
        to.wished = *static_cast<const VkPhysicalDeviceFeatures*>(from.wished);
    to.next = from.next;
    to.on_message = [on_message = from.on_message, user = from.message_user](const std::string& text) {
        if (on_message != nullptr)
            on_message(text.c_str(), user);
        else
            warn(text.c_str());
    };
}

} // namespace windrow::c_api

namespace {

windrow_result give_facts(const vulkan::DeviceFacts& from, windrow_vulkan_device_facts* to) {
    if (const windrow_result outcome = check_output(to); outcome != WINDROW_OK)
        return outcome;
    windrow_vulkan_device_facts all{};
    all.software = from.software;
    all.name = from.name.c_str();
    all.driver = from.driver.c_str();
    all.api_version = from.api_version.c_str();
    all.trouble = from.trouble.c_str();
    give(all, to);
    return WINDROW_OK;
}

} // namespace

WINDROW_C_INIT(windrow_vulkan_host)
WINDROW_C_INIT(windrow_vulkan_requirements)
WINDROW_C_INIT(windrow_vulkan_device_facts)
WINDROW_C_INIT(windrow_vulkan_device_settings)

WINDROW_EXPORT windrow_result windrow_vulkan_require_features(void* features) {
    return call({{features, "features"}}, [&]() -> windrow_result {
        const VkPhysicalDeviceFeatures required = vulkan::requirements().features;
        static_assert(sizeof required % sizeof(VkBool32) == 0);
        const auto* const from = reinterpret_cast<const VkBool32*>(&required);
        auto* const to = static_cast<VkBool32*>(features);
        for (std::size_t n = 0; n < sizeof required / sizeof(VkBool32); ++n)
            if (from[n] != VK_FALSE)
                to[n] = VK_TRUE;
        return WINDROW_OK;
    });
}
WINDROW_EXPORT windrow_result windrow_vulkan_check(void* instance, void* physical_device,
                                                   windrow_vulkan_get_instance_proc_addr get_instance_proc_addr) {
    return call({{instance, "instance"},
                 {physical_device, "physical_device"},
                 {reinterpret_cast<const void*>(get_instance_proc_addr), "get_instance_proc_addr"}},
                [&] {
                    return vulkan::check(static_cast<VkInstance>(instance), static_cast<VkPhysicalDevice>(physical_device),
                                         reinterpret_cast<PFN_vkGetInstanceProcAddr>(get_instance_proc_addr));
                });
}
WINDROW_EXPORT const char* windrow_vulkan_result_name(int32_t result) {
    return vulkan::name_of(static_cast<VkResult>(result));
}

WINDROW_EXPORT windrow_result windrow_vulkan_pipeline_store_create(const windrow_vulkan_host* host,
                                                                   windrow_vulkan_pipeline_store** store) {
    return create_from(host, store, [](const vulkan::Host& wanted) { return vulkan::PipelineStore::create(wanted); });
}
WINDROW_EXPORT void windrow_vulkan_pipeline_store_destroy(windrow_vulkan_pipeline_store* store) {
    delete store;
}
WINDROW_EXPORT uint64_t windrow_vulkan_pipeline_store_count(const windrow_vulkan_pipeline_store* store) {
    return value_of(store, "store", [&] { return static_cast<uint64_t>(store->store->count()); });
}

// --- A device of the library's own -----------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_result windrow_vulkan_device_list_create(windrow_vulkan_device_list** list) {
    return create(list, [] { return vulkan::list_devices(); });
}
WINDROW_EXPORT void windrow_vulkan_device_list_destroy(windrow_vulkan_device_list* list) {
    delete list;
}
WINDROW_EXPORT int32_t windrow_vulkan_device_list_count(const windrow_vulkan_device_list* list) {
    return value_of(list, "list", [&] { return static_cast<int32_t>(list->devices.size()); });
}
WINDROW_EXPORT windrow_result windrow_vulkan_device_list_get(const windrow_vulkan_device_list* list, int32_t index,
                                                             windrow_vulkan_device_facts* facts) {
    return call({{list, "list"}, {facts, "facts"}}, [&]() -> windrow_result {
        if (index < 0 || index >= static_cast<int32_t>(list->devices.size()))
            return fail(WINDROW_REJECTED, detail::message("index is ", index, ": there are ", list->devices.size(), " devices."));
        return give_facts(list->devices[static_cast<std::size_t>(index)], facts);
    });
}
WINDROW_EXPORT int32_t windrow_vulkan_has_validation_layer(void) {
    int32_t has = 0;
    (void)guarded([&]() -> windrow_result {
        has = vulkan::has_validation_layer();
        return WINDROW_OK;
    });
    return has;
}

WINDROW_EXPORT windrow_result windrow_vulkan_device_create(const windrow_vulkan_device_settings* settings,
                                                           windrow_vulkan_device** device) {
    return create_from(settings, device,
                       [](const vulkan::OwnDevice::Settings& wanted) { return vulkan::OwnDevice::create(wanted); });
}
WINDROW_EXPORT void windrow_vulkan_device_destroy(windrow_vulkan_device* device) {
    delete device;
}
WINDROW_EXPORT windrow_result windrow_vulkan_device_host(const windrow_vulkan_device* device, int32_t compute,
                                                         windrow_vulkan_host* host) {
    return call({{device, "device"}, {host, "host"}}, [&]() -> windrow_result {
        if (const windrow_result outcome = check_output(host); outcome != WINDROW_OK)
            return outcome;
        give_cpp(compute != 0 ? device->device->compute_host() : device->device->host(), host);
        return WINDROW_OK;
    });
}
WINDROW_EXPORT void* windrow_vulkan_device_queue(const windrow_vulkan_device* device, int32_t compute) {
    return value_of(device, "device",
                    [&]() -> void* { return compute != 0 ? device->device->compute_queue() : device->device->queue(); });
}
WINDROW_EXPORT windrow_result windrow_vulkan_device_get_facts(const windrow_vulkan_device* device,
                                                              windrow_vulkan_device_facts* facts) {
    return call({{device, "device"}, {facts, "facts"}}, [&] { return give_facts(device->device->facts(), facts); });
}
WINDROW_EXPORT const void* windrow_vulkan_device_features(const windrow_vulkan_device* device) {
    return value_of(device, "device", [&]() -> const void* { return &device->device->features(); });
}
WINDROW_EXPORT int32_t windrow_vulkan_device_messages(const windrow_vulkan_device* device) {
    return value_of(device, "device", [&] { return device->device->messages(); });
}
WINDROW_EXPORT windrow_result windrow_vulkan_device_run(windrow_vulkan_device* device, windrow_vulkan_record record, void* user) {
    return call({{device, "device"}, {reinterpret_cast<const void*>(record), "record"}},
                [&] { return device->device->run([&](VkCommandBuffer commands) { record(commands, user); }); });
}
WINDROW_EXPORT windrow_result windrow_vulkan_device_submit(windrow_vulkan_device* device, int32_t slot,
                                                           windrow_vulkan_record record, void* user) {
    return call({{device, "device"}, {reinterpret_cast<const void*>(record), "record"}}, [&]() -> Result<void> {
        if (slot < 0 || slot > 64)
            return Error{detail::message("slot is ", slot, ": give 0 to 64.")};
        return device->device->submit(slot, [&](VkCommandBuffer commands) { record(commands, user); });
    });
}
WINDROW_EXPORT windrow_result windrow_vulkan_device_wait(windrow_vulkan_device* device) {
    return call({{device, "device"}}, [&] { return device->device->wait(); });
}
