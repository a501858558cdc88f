#include "fluid/vulkan/own_device.h"

#include "fluid/core/message.h"
#include "gpu/functions.h"
#include "gpu/instance.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>
#include <vector>

namespace windrow::vulkan {
namespace {

struct FoundDevice {
    VkPhysicalDevice physical_device = VK_NULL_HANDLE;
    DeviceFacts facts{};
};

DeviceFacts facts_of(const Instance& instance, VkPhysicalDevice physical_device) {
    VkPhysicalDeviceProperties properties{};
    instance.load<PFN_vkGetPhysicalDeviceProperties>("vkGetPhysicalDeviceProperties")(physical_device, &properties);
    const std::uint32_t version = properties.apiVersion;
    DeviceFacts facts;
    facts.name = properties.deviceName;
    facts.api_version =
        detail::message(VK_API_VERSION_MAJOR(version), ".", VK_API_VERSION_MINOR(version), ".", VK_API_VERSION_PATCH(version));
    facts.software = properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
    facts.driver = "unknown";
    if (version >= VK_API_VERSION_1_2) {
        VkPhysicalDeviceDriverProperties driver{};
        driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
        VkPhysicalDeviceProperties2 more{};
        more.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
        more.pNext = &driver;
        instance.load<PFN_vkGetPhysicalDeviceProperties2>("vkGetPhysicalDeviceProperties2")(physical_device, &more);
        facts.driver = detail::message(driver.driverName, " ", driver.driverInfo);
    }
    if (const auto fit = check(instance.handle(), physical_device, instance.get_instance_proc_addr()); !fit)
        facts.trouble = fit.error();
    return facts;
}

// The devices of an instance, in the driver's order; an error where there is none.
Result<std::vector<FoundDevice>> find_devices(const Instance& instance) {
    const auto enumerate = instance.load<PFN_vkEnumeratePhysicalDevices>("vkEnumeratePhysicalDevices");
    std::uint32_t count = 0;
    VkResult result = enumerate(instance.handle(), &count, nullptr);
    std::vector<VkPhysicalDevice> devices(count);
    if (result == VK_SUCCESS && count > 0)
        result = enumerate(instance.handle(), &count, devices.data());
    if (result != VK_SUCCESS && result != VK_INCOMPLETE)
        return call_error("vkEnumeratePhysicalDevices", "the machine", result);
    if (count == 0)
        return Error{"no Vulkan device was found: install your GPU's driver, or a software one (Debian: mesa-vulkan-drivers)."};
    devices.resize(count);
    std::vector<FoundDevice> found;
    for (const VkPhysicalDevice device : devices)
        found.push_back({device, facts_of(instance, device)});
    return found;
}

// Functions for our own host, in addition to functions.h, which holds only those that Windrow calls on the device of any host.
// clang-format off
#define WINDROW_OWN_FUNCTIONS(each) \
    each(vkDestroyDevice) \
    each(vkDeviceWaitIdle) \
    each(vkGetDeviceQueue) \
    each(vkCreateCommandPool) \
    each(vkDestroyCommandPool) \
    each(vkResetCommandPool) \
    each(vkAllocateCommandBuffers) \
    each(vkBeginCommandBuffer) \
    each(vkEndCommandBuffer) \
    each(vkCreateFence) \
    each(vkDestroyFence) \
    each(vkResetFences) \
    each(vkWaitForFences) \
    each(vkQueueSubmit)
// clang-format on

struct OwnFunctions {
#define WINDROW_DECLARE(name) PFN_##name name = nullptr;
    WINDROW_OWN_FUNCTIONS(WINDROW_DECLARE)
#undef WINDROW_DECLARE
};

/// First hardware device that can run the wind, else the first device that can; the requested place where one is set.
Result<FoundDevice> choose(const std::vector<FoundDevice>& found, int place) {
    if (place >= 0) {
        if (static_cast<std::size_t>(place) >= found.size())
            return Error{detail::message("device is ", place, " and there are ", found.size(), ": give one from 0 to ",
                                         found.size() - 1, ".")};
        const FoundDevice& asked = found[static_cast<std::size_t>(place)];
        if (!asked.facts.trouble.empty())
            return Error{detail::message("device ", place, " (", asked.facts.name, "): ", asked.facts.trouble)};
        return asked;
    }
    if (place != -1)
        return Error{detail::message("device is ", place, ": give an index of the list from 0, or -1 for the best.")};
    for (const bool software : {false, true})
        for (const FoundDevice& device : found)
            if (device.facts.software == software && device.facts.trouble.empty())
                return device;
    return Error{detail::message(found.front().facts.name, ": ", found.front().facts.trouble)};
}

std::vector<VkQueueFamilyProperties> families_of(const Instance& instance, const FoundDevice& chosen) {
    const auto query = instance.load<PFN_vkGetPhysicalDeviceQueueFamilyProperties>("vkGetPhysicalDeviceQueueFamilyProperties");
    std::uint32_t count = 0;
    query(chosen.physical_device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    query(chosen.physical_device, &count, families.data());
    families.resize(count);
    return families;
}

/// A queue of the device.
struct QueuePlace {
    std::uint32_t family = 0, index = 0;
};

/// See Settings::compute_queue.
QueuePlace compute_place(const Instance& instance, const FoundDevice& chosen, std::uint32_t first) {
    const std::vector<VkQueueFamilyProperties> families = families_of(instance, chosen);
    for (std::uint32_t family = 0; family < families.size(); ++family)
        if ((families[family].queueFlags & (VK_QUEUE_COMPUTE_BIT | VK_QUEUE_GRAPHICS_BIT)) == VK_QUEUE_COMPUTE_BIT)
            return {.family = family, .index = family == first ? std::min(1u, families[first].queueCount - 1) : 0};
    return {.family = first, .index = std::min(1u, families[first].queueCount - 1)};
}

/// The first queue family with the required capabilities and none of the unwanted ones.
Result<std::uint32_t> choose_family(const Instance& instance, const FoundDevice& chosen, VkQueueFlags wanted,
                                    VkQueueFlags unwanted) {
    const std::vector<VkQueueFamilyProperties> families = families_of(instance, chosen);
    for (std::uint32_t family = 0; family < families.size(); ++family)
        if ((families[family].queueFlags & wanted) == wanted && (families[family].queueFlags & unwanted) == 0)
            return family;
    return Error{chosen.facts.name + " has no queue that " +
                 ((wanted & VK_QUEUE_GRAPHICS_BIT) != 0 ? "draws and computes" : "computes") +
                 ((unwanted & VK_QUEUE_GRAPHICS_BIT) != 0 ? " alone" : "") + ": use another device."};
}

// A device that lists it must be made with it; it is of beta headers.
constexpr const char* k_portability_subset = "VK_KHR_portability_subset";

bool needs_portability_subset(const Instance& instance, VkPhysicalDevice physical_device) {
    const auto enumerate = instance.load<PFN_vkEnumerateDeviceExtensionProperties>("vkEnumerateDeviceExtensionProperties");
    const auto extensions = [&](std::uint32_t* count, VkExtensionProperties* properties) {
        return enumerate(physical_device, nullptr, count, properties);
    };
    return lists(extensions, &VkExtensionProperties::extensionName, k_portability_subset);
}

VkPhysicalDeviceFeatures features_for(const Instance& instance, VkPhysicalDevice physical_device,
                                      const OwnDevice::Settings& settings) {
    // The struct is an array of flags.
    constexpr std::size_t count = sizeof(VkPhysicalDeviceFeatures) / sizeof(VkBool32);
    VkPhysicalDeviceFeatures has{}, enabled = requirements().features, wished = settings.wished;
    instance.load<PFN_vkGetPhysicalDeviceFeatures>("vkGetPhysicalDeviceFeatures")(physical_device, &has);
    if (settings.gpu_validation) {
        // The layer's own shader code writes from the stages of graphics too.
        wished.fragmentStoresAndAtomics = VK_TRUE;
        wished.vertexPipelineStoresAndAtomics = VK_TRUE;
    }
    std::array<VkBool32, count> of_device{}, of_wish{}, made{};
    std::memcpy(of_device.data(), &has, sizeof has);
    std::memcpy(of_wish.data(), &wished, sizeof wished);
    std::memcpy(made.data(), &enabled, sizeof enabled);
    for (std::size_t n = 0; n < count; ++n)
        made[n] |= of_device[n] & of_wish[n];
    std::memcpy(&enabled, made.data(), sizeof enabled);
    return enabled;
}

} // namespace

struct WINDROW_HIDDEN OwnDevice::State {
    std::unique_ptr<Instance> instance{}; // destroyed last
    FoundDevice chosen{};
    std::uint32_t family = 0;
    QueuePlace compute{};
    VkPhysicalDeviceFeatures features{};
    VkDevice device = VK_NULL_HANDLE;
    OwnFunctions functions{};
    VkQueue queue = VK_NULL_HANDLE, compute_queue = VK_NULL_HANDLE;
    struct Slot {
        VkCommandPool pool = VK_NULL_HANDLE;
        VkCommandBuffer commands = VK_NULL_HANDLE;
        VkFence fence = VK_NULL_HANDLE;
        bool pending = false; ///< submitted, and not waited for yet
    };
    std::vector<Slot> slots{};

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (device == VK_NULL_HANDLE || functions.vkDestroyDevice == nullptr)
            return;
        if (!slots.empty())
            (void)functions.vkDeviceWaitIdle(device);
        for (const Slot& slot : slots)
            destroy(slot);
        functions.vkDestroyDevice(device, nullptr);
    }

    [[nodiscard]] Result<void> make_device(const Settings& settings) {
        const float priorities[] = {1.0f, 1.0f};
        features = features_for(*instance, chosen.physical_device, settings);
        VkDeviceQueueCreateInfo queue_infos[2] = {};
        for (VkDeviceQueueCreateInfo& queue_info : queue_infos) {
            queue_info.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
            queue_info.queueFamilyIndex = family;
            queue_info.queueCount = 1;
            queue_info.pQueuePriorities = priorities;
        }
        queue_infos[0].queueCount = compute.family == family ? compute.index + 1 : 1;
        queue_infos[1].queueFamilyIndex = compute.family;
        VkDeviceCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
        info.queueCreateInfoCount = compute.family == family ? 1 : 2;
        info.pQueueCreateInfos = queue_infos;
        info.pEnabledFeatures = &features;
        info.pNext = settings.next;
        std::vector<const char*> extensions = settings.extensions;
        if (needs_portability_subset(*instance, chosen.physical_device))
            extensions.push_back(k_portability_subset);
        info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
        info.ppEnabledExtensionNames = extensions.data();
        const VkResult result =
            instance->load<PFN_vkCreateDevice>("vkCreateDevice")(chosen.physical_device, &info, nullptr, &device);
        if (result != VK_SUCCESS) {
            device = VK_NULL_HANDLE;
            return call_error("vkCreateDevice", chosen.facts.name, result);
        }
        const auto load = instance->load<PFN_vkGetDeviceProcAddr>("vkGetDeviceProcAddr");
        bool complete = true;
#define WINDROW_FETCH(name)                                                                                                      \
    functions.name = reinterpret_cast<PFN_##name>(load(device, #name));                                                          \
    complete = complete && functions.name != nullptr;
        WINDROW_OWN_FUNCTIONS(WINDROW_FETCH)
#undef WINDROW_FETCH
        if (!complete)
            return Error{chosen.facts.name + " lacks functions of Vulkan 1.0: update its driver."};
        return {};
    }

    [[nodiscard]] VkResult wait(Slot& slot) const {
        if (!std::exchange(slot.pending, false))
            return VK_SUCCESS;
        return functions.vkWaitForFences(device, 1, &slot.fence, VK_TRUE, UINT64_MAX);
    }
    /// Makes the slots up to this one; with the first submission, since a driver without a device, which compiles alone, has no
    /// fences.
    [[nodiscard]] Result<void> make_slots(int last) {
        while (static_cast<int>(slots.size()) <= last) {
            Slot slot;
            if (auto made = make_slot(slot); !made) {
                destroy(slot);
                return made;
            }
            slots.push_back(slot);
        }
        return {};
    }

  private:
    void destroy(const Slot& slot) const {
        if (slot.fence != VK_NULL_HANDLE)
            functions.vkDestroyFence(device, slot.fence, nullptr);
        if (slot.pool != VK_NULL_HANDLE)
            functions.vkDestroyCommandPool(device, slot.pool, nullptr);
    }
    [[nodiscard]] Result<void> make_slot(Slot& slot) {
        VkCommandPoolCreateInfo pool_info{};
        pool_info.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
        pool_info.queueFamilyIndex = family;
        VkResult result = functions.vkCreateCommandPool(device, &pool_info, nullptr, &slot.pool);
        if (result != VK_SUCCESS) {
            slot.pool = VK_NULL_HANDLE;
            return call_error("vkCreateCommandPool", chosen.facts.name, result);
        }
        VkCommandBufferAllocateInfo commands_info{};
        commands_info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
        commands_info.commandPool = slot.pool;
        commands_info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
        commands_info.commandBufferCount = 1;
        result = functions.vkAllocateCommandBuffers(device, &commands_info, &slot.commands);
        if (result != VK_SUCCESS)
            return call_error("vkAllocateCommandBuffers", chosen.facts.name, result);
        VkFenceCreateInfo fence_info{};
        fence_info.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
        result = functions.vkCreateFence(device, &fence_info, nullptr, &slot.fence);
        if (result != VK_SUCCESS) {
            slot.fence = VK_NULL_HANDLE;
            return call_error("vkCreateFence", chosen.facts.name, result);
        }
        return {};
    }
};

bool has_validation_layer() {
    return Instance::has_validation();
}

OwnDevice::OwnDevice(std::unique_ptr<State> state) : state_(std::move(state)) {}
OwnDevice::~OwnDevice() = default;

Result<std::unique_ptr<OwnDevice>> OwnDevice::create(const Settings& settings) {
    auto state = std::make_unique<State>();
    const bool validation = settings.validation || settings.gpu_validation;
    auto instance = Instance::create(
        {.validation = validation, .gpu_validation = settings.gpu_validation, .extensions = settings.instance_extensions},
        settings.on_message, settings.get_instance_proc_addr);
    if (!instance)
        return instance.failure();
    state->instance = *std::move(instance);
    auto found = find_devices(*state->instance);
    if (!found)
        return found.failure();
    auto chosen = choose(*found, settings.device);
    if (!chosen)
        return chosen.failure();
    state->chosen = *std::move(chosen);
    auto family = choose_family(*state->instance, state->chosen, settings.queue, settings.queue_without);
    if (!family)
        return family.failure();
    state->family = *family;
    state->compute = {.family = *family};
    if (settings.compute_queue)
        state->compute = compute_place(*state->instance, state->chosen, *family);
    if (auto made = state->make_device(settings); !made)
        return made.failure();
    state->functions.vkGetDeviceQueue(state->device, state->family, 0, &state->queue);
    state->functions.vkGetDeviceQueue(state->device, state->compute.family, state->compute.index, &state->compute_queue);
    return std::unique_ptr<OwnDevice>(new OwnDevice(std::move(state)));
}

Host OwnDevice::host() const {
    Host host;
    host.instance = state_->instance->handle();
    host.physical_device = state_->chosen.physical_device;
    host.device = state_->device;
    host.queue_family = state_->family;
    host.get_instance_proc_addr = state_->instance->get_instance_proc_addr();
    return host;
}

VkQueue OwnDevice::queue() const {
    return state_->queue;
}

Host OwnDevice::compute_host() const {
    Host beside = host();
    beside.queue_family = state_->compute.family;
    if (beside.queue_family != state_->family)
        beside.reader_queue_families = {state_->family};
    return beside;
}

VkQueue OwnDevice::compute_queue() const {
    return state_->compute_queue;
}

const VkPhysicalDeviceFeatures& OwnDevice::features() const {
    return state_->features;
}

const DeviceFacts& OwnDevice::facts() const {
    return state_->chosen.facts;
}

int OwnDevice::messages() const {
    return state_->instance->messages();
}

Result<void> OwnDevice::run(const std::function<void(VkCommandBuffer)>& record) {
    if (auto submitted = submit(0, record); !submitted)
        return submitted;
    return wait();
}

Result<void> OwnDevice::submit(int slot_number, const std::function<void(VkCommandBuffer)>& record) {
    const OwnFunctions& functions = state_->functions;
    const VkDevice device = state_->device;
    const auto failed = [this](const char* function, VkResult result) {
        // Submitted work must be complete when the caller frees its resources.
        (void)state_->functions.vkDeviceWaitIdle(state_->device);
        return call_error(function, state_->chosen.facts.name, result);
    };

    if (auto made = state_->make_slots(slot_number); !made)
        return made;
    State::Slot& slot = state_->slots[static_cast<std::size_t>(slot_number)];
    if (const VkResult result = state_->wait(slot); result != VK_SUCCESS)
        return failed("vkWaitForFences", result);
    if (const VkResult result = functions.vkResetCommandPool(device, slot.pool, 0); result != VK_SUCCESS)
        return failed("vkResetCommandPool", result);
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    if (const VkResult result = functions.vkBeginCommandBuffer(slot.commands, &begin); result != VK_SUCCESS)
        return failed("vkBeginCommandBuffer", result);
    record(slot.commands);
    if (const VkResult result = functions.vkEndCommandBuffer(slot.commands); result != VK_SUCCESS)
        return failed("vkEndCommandBuffer", result);
    if (const VkResult result = functions.vkResetFences(device, 1, &slot.fence); result != VK_SUCCESS)
        return failed("vkResetFences", result);
    // A fence: with timeline semaphores each wait takes 10 s under GPU-assisted validation (layer 1.3.239).
    VkSubmitInfo submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &slot.commands;
    if (const VkResult result = functions.vkQueueSubmit(state_->queue, 1, &submit, slot.fence); result != VK_SUCCESS)
        return failed("vkQueueSubmit", result);
    slot.pending = true;
    return {};
}

Result<void> OwnDevice::wait() {
    for (State::Slot& slot : state_->slots)
        if (const VkResult result = state_->wait(slot); result != VK_SUCCESS) {
            (void)state_->functions.vkDeviceWaitIdle(state_->device);
            return call_error("vkWaitForFences", state_->chosen.facts.name, result);
        }
    return {};
}

Result<std::vector<DeviceFacts>> list_devices() {
    auto instance = Instance::create({}, {});
    if (!instance)
        return instance.failure();
    auto found = find_devices(**instance);
    if (!found)
        return found.failure();
    std::vector<DeviceFacts> facts;
    for (const FoundDevice& device : *found)
        facts.push_back(device.facts);
    return facts;
}

} // namespace windrow::vulkan
