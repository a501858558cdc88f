#include "vegetation/view/window.h"

#include "fluid/core/message.h"
#include "vegetation/vulkan/calls.h"
#include "vegetation/vulkan/objects.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>
#include <array>
#include <vector>

namespace windrow::vegetation::view {
namespace {

using detail::message;

// Of VK_KHR_surface and VK_KHR_swapchain, and what only a window needs.
// clang-format off
#define WINDROW_WINDOW_CALLS(each) \
    each(vkDestroySurfaceKHR) \
    each(vkGetPhysicalDeviceSurfaceSupportKHR) \
    each(vkGetPhysicalDeviceSurfaceCapabilitiesKHR) \
    each(vkGetPhysicalDeviceSurfaceFormatsKHR) \
    each(vkCreateSwapchainKHR) \
    each(vkDestroySwapchainKHR) \
    each(vkGetSwapchainImagesKHR) \
    each(vkAcquireNextImageKHR) \
    each(vkQueuePresentKHR) \
    each(vkCmdCopyImage) \
    each(vkCreateSemaphore) \
    each(vkDestroySemaphore)
// clang-format on

Error lacking(const std::string& sentence) {
    return {std::string(sentence), Fault::system_lacks};
}

void turn(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to, VkAccessFlags access) {
    VkImageMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
    barrier.srcAccessMask = from == VK_IMAGE_LAYOUT_UNDEFINED ? 0 : VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.dstAccessMask = access;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT,
                         access != 0 ? VK_PIPELINE_STAGE_TRANSFER_BIT : VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, 0, 0, nullptr, 0,
                         nullptr, 1, &barrier);
}

} // namespace

struct Window::State {
    struct WindowCalls {
#define WINDROW_DECLARE(name) PFN_##name name = nullptr;
        WINDROW_WINDOW_CALLS(WINDROW_DECLARE)
#undef WINDROW_DECLARE
    };
    bool begun = false; // GLFW
    GLFWwindow* window = nullptr;
    std::unique_ptr<engine::Device> device{};
    WindowCalls calls{};
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    VkSurfaceFormatKHR format{};
    VkSwapchainKHR swapchain = VK_NULL_HANDLE;
    VkExtent2D extent{};
    std::vector<VkImage> images{};
    std::array<VkSemaphore, engine::k_frames_in_flight> free{}; ///< the image of a slot's frame
    std::vector<VkSemaphore> drawn{};                           ///< of each image
    bool stale = true;
    int made = 0;

    ~State() {
        if (device)
            vkDeviceWaitIdle(device->handle());
        end_images();
        for (const VkSemaphore semaphore : free)
            end(semaphore);
        if (surface != VK_NULL_HANDLE)
            calls.vkDestroySurfaceKHR(device->host().instance, surface, nullptr);
        device.reset();
        if (window != nullptr)
            glfwDestroyWindow(window);
        if (begun)
            glfwTerminate();
    }

    void end(VkSemaphore semaphore) const {
        if (semaphore != VK_NULL_HANDLE)
            calls.vkDestroySemaphore(device->handle(), semaphore, nullptr);
    }
    void end_images() {
        for (const VkSemaphore semaphore : drawn)
            end(semaphore);
        drawn.clear();
        if (swapchain != VK_NULL_HANDLE)
            calls.vkDestroySwapchainKHR(device->handle(), swapchain, nullptr);
        swapchain = VK_NULL_HANDLE;
    }
    [[nodiscard]] VkSemaphore semaphore() const {
        VkSemaphoreCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
        VkSemaphore made_one = VK_NULL_HANDLE;
        engine::must(calls.vkCreateSemaphore(device->handle(), &info, nullptr, &made_one), "vkCreateSemaphore");
        return made_one;
    }

    [[nodiscard]] Result<void> load() {
        const vulkan::Host& host = device->host();
        bool complete = true;
#define WINDROW_FETCH(name)                                                                                                      \
    calls.name = reinterpret_cast<PFN_##name>(host.get_instance_proc_addr(host.instance, #name));                                \
    complete = complete && calls.name != nullptr;
        WINDROW_WINDOW_CALLS(WINDROW_FETCH)
#undef WINDROW_FETCH
        return complete ? Result<void>{} : lacking(device->name() + " does not draw to windows: update its driver.");
    }

    [[nodiscard]] Result<void> choose_format() {
        const VkPhysicalDevice physical = device->host().physical_device;
        VkBool32 presents = VK_FALSE;
        std::uint32_t count = 0;
        if (calls.vkGetPhysicalDeviceSurfaceSupportKHR(physical, device->host().queue_family, surface, &presents) != VK_SUCCESS ||
            presents != VK_TRUE)
            return lacking(device->name() + " does not draw to this display: use one that is connected to it.");
        (void)calls.vkGetPhysicalDeviceSurfaceFormatsKHR(physical, surface, &count, nullptr);
        std::vector<VkSurfaceFormatKHR> formats(count);
        (void)calls.vkGetPhysicalDeviceSurfaceFormatsKHR(physical, surface, &count, formats.data());
        for (const VkFormat wanted :
             {VK_FORMAT_B8G8R8A8_SRGB, VK_FORMAT_R8G8B8A8_SRGB, VK_FORMAT_B8G8R8A8_UNORM, VK_FORMAT_R8G8B8A8_UNORM})
            for (const VkSurfaceFormatKHR& one : formats)
                if (one.format == wanted && one.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR) {
                    format = one;
                    return {};
                }
        return lacking(device->name() + " has no window format of 8 bits a colour: use another device.");
    }

    void make_images(VkExtent2D size, const VkSurfaceCapabilitiesKHR& can) {
        vkDeviceWaitIdle(device->handle());
        VkSwapchainCreateInfoKHR info{};
        info.sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR;
        info.surface = surface;
        info.minImageCount = std::max(can.minImageCount, 3u);
        if (can.maxImageCount > 0)
            info.minImageCount = std::min(info.minImageCount, can.maxImageCount);
        info.imageFormat = format.format;
        info.imageColorSpace = format.colorSpace;
        info.imageExtent = size;
        info.imageArrayLayers = 1;
        info.imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT;
        info.imageSharingMode = VK_SHARING_MODE_EXCLUSIVE;
        info.preTransform = can.currentTransform;
        info.compositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR;
        info.presentMode = VK_PRESENT_MODE_FIFO_KHR; // every device has it
        info.clipped = VK_TRUE;
        info.oldSwapchain = swapchain;
        VkSwapchainKHR next = VK_NULL_HANDLE;
        engine::must(calls.vkCreateSwapchainKHR(device->handle(), &info, nullptr, &next), "vkCreateSwapchainKHR");
        end_images();
        swapchain = next;
        extent = size;
        std::uint32_t count = 0;
        engine::must(calls.vkGetSwapchainImagesKHR(device->handle(), swapchain, &count, nullptr), "vkGetSwapchainImagesKHR");
        images.resize(count);
        engine::must(calls.vkGetSwapchainImagesKHR(device->handle(), swapchain, &count, images.data()),
                     "vkGetSwapchainImagesKHR");
        for (std::uint32_t n = 0; n < count; ++n)
            drawn.push_back(semaphore());
        stale = false;
        ++made;
    }
};

Window::Window(std::unique_ptr<State> state) : state_(std::move(state)) {}
Window::~Window() = default;

Result<std::unique_ptr<Window>> Window::create(const WindowSettings& settings) {
    auto state = std::make_unique<State>();
    glfwSetErrorCallback(nullptr);
    state->begun = glfwInit() == GLFW_TRUE;
    if (!state->begun)
        return lacking("windrow view needs a display, and none answers: set DISPLAY, or draw files by windrow-draw.");
    std::uint32_t count = 0;
    const char** const names = glfwGetRequiredInstanceExtensions(&count);
    if (names == nullptr)
        return lacking("no Vulkan driver draws to windows here: install your GPU's, or mesa-vulkan-drivers.");
    auto device = engine::Device::create({.validation = settings.validation,
                                          .on_message = settings.on_message,
                                          .extensions = {VK_KHR_SWAPCHAIN_EXTENSION_NAME},
                                          .instance_extensions = {names, names + count}});
    if (!device)
        return lacking(device.error());
    state->device = *std::move(device);
    if (auto loaded = state->load(); !loaded)
        return loaded.failure();
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    state->window = glfwCreateWindow(settings.size.x, settings.size.y, settings.title.c_str(), nullptr, nullptr);
    if (state->window == nullptr ||
        glfwCreateWindowSurface(state->device->host().instance, state->window, nullptr, &state->surface) != VK_SUCCESS)
        return lacking(message("no window of ", settings.size.x, " x ", settings.size.y, " can be opened on this display."));
    if (auto chosen = state->choose_format(); !chosen)
        return chosen.failure();
    return engine::guarded([&] {
        for (VkSemaphore& semaphore : state->free)
            semaphore = state->semaphore();
        return std::unique_ptr<Window>(new Window(std::move(state)));
    });
}

GLFWwindow* Window::handle() const {
    return state_->window;
}
engine::Device& Window::device() {
    return *state_->device;
}
bool Window::closed() const {
    return glfwWindowShouldClose(state_->window) == GLFW_TRUE;
}
VkExtent2D Window::extent() const {
    return state_->extent;
}
int Window::remade() const {
    return state_->made;
}
VkFormat Window::format() const {
    switch (state_->format.format) {
    case VK_FORMAT_B8G8R8A8_UNORM:
        return VK_FORMAT_B8G8R8A8_SRGB;
    case VK_FORMAT_R8G8B8A8_UNORM:
        return VK_FORMAT_R8G8B8A8_SRGB;
    default:
        return state_->format.format;
    }
}

Result<bool> Window::match() {
    return engine::guarded([&] {
        VkSurfaceCapabilitiesKHR can{};
        engine::must(state_->calls.vkGetPhysicalDeviceSurfaceCapabilitiesKHR(state_->device->host().physical_device,
                                                                             state_->surface, &can),
                     "vkGetPhysicalDeviceSurfaceCapabilitiesKHR");
        VkExtent2D size = can.currentExtent;
        if (size.width == 0xffff'ffffu) { // the window takes what it is given
            glm::ivec2 asked{};
            glfwGetFramebufferSize(state_->window, &asked.x, &asked.y);
            size.width = std::clamp(static_cast<std::uint32_t>(asked.x), can.minImageExtent.width, can.maxImageExtent.width);
            size.height = std::clamp(static_cast<std::uint32_t>(asked.y), can.minImageExtent.height, can.maxImageExtent.height);
        }
        if (size.width == 0 || size.height == 0)
            return false;
        if (state_->stale || size.width != state_->extent.width || size.height != state_->extent.height)
            state_->make_images(size, can);
        return true;
    });
}

Result<std::optional<Window::Target>> Window::acquire(int slot) {
    return engine::guarded([&]() -> std::optional<Target> {
        const VkSemaphore free = state_->free[static_cast<std::size_t>(slot)];
        Target target;
        const VkResult result = state_->calls.vkAcquireNextImageKHR(state_->device->handle(), state_->swapchain, UINT64_MAX, free,
                                                                    VK_NULL_HANDLE, &target.index);
        if (result == VK_ERROR_OUT_OF_DATE_KHR) {
            state_->stale = true;
            return std::nullopt;
        }
        if (result != VK_SUBOPTIMAL_KHR)
            engine::must(result, "vkAcquireNextImageKHR");
        target.image = state_->images[target.index];
        target.signals = {.wait = free, .done = state_->drawn[target.index]};
        return target;
    });
}

void Window::copy(VkCommandBuffer commands, const Target& target, VkImage from) const {
    turn(commands, target.image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_ACCESS_TRANSFER_WRITE_BIT);
    VkImageCopy whole{};
    whole.srcSubresource = whole.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    whole.extent = {state_->extent.width, state_->extent.height, 1};
    state_->calls.vkCmdCopyImage(commands, from, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target.image,
                                 VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &whole);
    turn(commands, target.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR, 0);
}

Result<void> Window::show(const Target& target) {
    return engine::guarded([&] {
        VkPresentInfoKHR info{};
        info.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR;
        info.waitSemaphoreCount = 1;
        info.pWaitSemaphores = &target.signals.done;
        info.swapchainCount = 1;
        info.pSwapchains = &state_->swapchain;
        info.pImageIndices = &target.index;
        const VkResult result = state_->calls.vkQueuePresentKHR(state_->device->queue(), &info);
        if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR)
            state_->stale = true;
        else
            engine::must(result, "vkQueuePresentKHR");
    });
}

} // namespace windrow::vegetation::view
