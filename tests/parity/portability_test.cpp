// Drivers over another API, as MoltenVK over Metal: what instance and device are made with, where a loader and a device pretend to
// list the extensions of such drivers.
#include "gpu/loader.h"
#include "tests/parity/gpu.h"

#include <algorithm>
#include <cstring>
#include <set>

namespace windrow::vulkan {
namespace {

constexpr const char* k_enumeration = "VK_KHR_portability_enumeration";
constexpr const char* k_subset = "VK_KHR_portability_subset";
constexpr VkInstanceCreateFlags k_enumerate = 1; // VK_INSTANCE_CREATE_ENUMERATE_PORTABILITY_BIT_KHR

// What the calls below know; Vulkan's calls carry no pointer of ours.
struct FakeDrivers {
    PFN_vkGetInstanceProcAddr real = nullptr;
    bool enumerable = false, subset = false; ///< what is listed
    VkInstanceCreateFlags flags = 0;
    std::set<std::string> of_instance{}, of_device{}; ///< extensions that were asked for
};
FakeDrivers g_drivers;

VkResult list(bool listed, const char* name, std::uint32_t* count, VkExtensionProperties* extensions) {
    *count = listed ? 1 : 0;
    if (extensions != nullptr && listed)
        std::strcpy(extensions->extensionName, name);
    return VK_SUCCESS;
}

VkResult VKAPI_CALL list_of_instance(const char*, std::uint32_t* count, VkExtensionProperties* extensions) {
    return list(g_drivers.enumerable, k_enumeration, count, extensions);
}

VkResult VKAPI_CALL list_of_device(VkPhysicalDevice, const char*, std::uint32_t* count, VkExtensionProperties* extensions) {
    return list(g_drivers.subset, k_subset, count, extensions);
}

// Keeps the names, and takes the fake one out for the real call.
template <class CreateInfo>
std::vector<const char*> take_names(CreateInfo& info, const char* fake, std::set<std::string>& names) {
    std::vector<const char*> real;
    for (std::uint32_t n = 0; n < info.enabledExtensionCount; ++n) {
        names.insert(info.ppEnabledExtensionNames[n]);
        if (std::strcmp(info.ppEnabledExtensionNames[n], fake) != 0)
            real.push_back(info.ppEnabledExtensionNames[n]);
    }
    info.enabledExtensionCount = static_cast<std::uint32_t>(real.size());
    info.ppEnabledExtensionNames = real.data();
    return real;
}

VkResult VKAPI_CALL make_instance(const VkInstanceCreateInfo* info, const VkAllocationCallbacks* callbacks, VkInstance* made) {
    VkInstanceCreateInfo own = *info;
    g_drivers.flags = std::exchange(own.flags, 0);
    const std::vector<const char*> names = take_names(own, k_enumeration, g_drivers.of_instance);
    return reinterpret_cast<PFN_vkCreateInstance>(g_drivers.real(nullptr, "vkCreateInstance"))(&own, callbacks, made);
}

VkInstance g_instance = VK_NULL_HANDLE; // the last that asked for vkCreateDevice

VkResult VKAPI_CALL make_device(VkPhysicalDevice physical_device, const VkDeviceCreateInfo* info,
                                const VkAllocationCallbacks* callbacks, VkDevice* made) {
    VkDeviceCreateInfo own = *info;
    const std::vector<const char*> names = take_names(own, k_subset, g_drivers.of_device);
    const auto real = reinterpret_cast<PFN_vkCreateDevice>(g_drivers.real(g_instance, "vkCreateDevice"));
    return real(physical_device, &own, callbacks, made);
}

PFN_vkVoidFunction VKAPI_CALL fake_call(VkInstance instance, const char* name) {
    const auto is = [name](const char* call) { return std::strcmp(name, call) == 0; };
    if (is("vkEnumerateInstanceExtensionProperties"))
        return reinterpret_cast<PFN_vkVoidFunction>(&list_of_instance);
    if (is("vkEnumerateDeviceExtensionProperties"))
        return reinterpret_cast<PFN_vkVoidFunction>(&list_of_device);
    if (is("vkCreateInstance"))
        return reinterpret_cast<PFN_vkVoidFunction>(&make_instance);
    if (is("vkCreateDevice")) {
        g_instance = instance;
        return reinterpret_cast<PFN_vkVoidFunction>(&make_device);
    }
    return g_drivers.real(instance, name);
}

class Portability : public testing::TestWithParam<bool> {
  protected:
    void SetUp() override {
        auto opened = Loader::open();
        ASSERT_TRUE(opened) << opened.error();
        loader = *std::move(opened);
    }

    // A device of a loader and a driver that list what is named.
    void make(bool enumerable, bool subset) {
        g_drivers = {.real = loader.get_instance_proc_addr(), .enumerable = enumerable, .subset = subset};
        const auto own = OwnDevice::create({.validation = GetParam(), .get_instance_proc_addr = &fake_call});
        ASSERT_TRUE(own) << own.error();
        EXPECT_EQ((*own)->host().get_instance_proc_addr, &fake_call);
        EXPECT_EQ((*own)->messages(), 0);
        EXPECT_EQ(g_drivers.of_instance.contains(VK_EXT_DEBUG_UTILS_EXTENSION_NAME), GetParam());
    }

    Loader loader;
};

TEST_P(Portability, IsAskedOfALoaderThatListsIt) {
    for (const bool listed : {true, false}) {
        make(listed, false);
        EXPECT_EQ(g_drivers.of_instance.contains(k_enumeration), listed);
        EXPECT_EQ(g_drivers.flags, listed ? k_enumerate : 0u);
        EXPECT_TRUE(g_drivers.of_device.empty());
    }
}

TEST_P(Portability, OfADeviceThatListsItsSubsetIsEnabled) {
    for (const bool listed : {true, false}) {
        make(true, listed);
        EXPECT_EQ(g_drivers.of_device, listed ? std::set<std::string>{k_subset} : std::set<std::string>{});
    }
}

INSTANTIATE_TEST_SUITE_P(UnderValidation, Portability, testing::Bool());

// --- The loader --------------------------------------------------------------------------------------------------------------

TEST(Loaders, AreMovedAndClosedOnce) {
    EXPECT_EQ(Loader().get_instance_proc_addr(), nullptr);
    auto opened = Loader::open();
    ASSERT_TRUE(opened) << opened.error();
    Loader loader = *std::move(opened);
    EXPECT_EQ(opened->get_instance_proc_addr(), nullptr);
    EXPECT_NE(loader.get_instance_proc_addr()(nullptr, "vkCreateInstance"), nullptr);
    loader = Loader();
    EXPECT_EQ(loader.get_instance_proc_addr(), nullptr);
}

} // namespace
} // namespace windrow::vulkan
