// A window to draw to: GLFW's, with a device that presents to it, and its images.
//
//     auto window = view::Window::create({.size = {1280, 720}, .title = "meadow"});
//     while (!(*window)->closed()) {
//         glfwPollEvents();
//         if (!*(*window)->match()) continue;                                  // it has no size
//         const engine::Frame frame = *frames.begin();
//         const auto target = (*window)->acquire(frame.slot);                  // none: match again
//         (*window)->copy(frame.commands, **target, screen);                   // an image of format() and extent()
//         (void)frames.submit(frame, (**target).signals);
//         (void)(*window)->show(**target);
//     }
#pragma once

#include "vegetation/vulkan/device.h"
#include "vegetation/vulkan/frames.h"

#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>

struct GLFWwindow;

namespace windrow::vegetation::view {

struct WindowSettings {
    glm::ivec2 size{1280, 720}; ///< [px]
    std::string title = "windrow";
    bool validation = false; ///< engine::DeviceSettings::validation
    std::function<void(const std::string& text)> on_message{};
};

class Window {
  public:
    /// An error of Fault::system_lacks where there is no display, no driver, or no device that presents.
    [[nodiscard]] static Result<std::unique_ptr<Window>> create(const WindowSettings& settings);
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;
    /// Nothing else that was made on the device is left.
    ~Window();

    [[nodiscard]] GLFWwindow* handle() const;
    [[nodiscard]] engine::Device& device();
    [[nodiscard]] bool closed() const;
    /// Makes the images as large as the window, where they are not. False: it has no size, and nothing can be drawn.
    [[nodiscard]] Result<bool> match();
    [[nodiscard]] VkExtent2D extent() const;
    /// The sRGB format whose bytes are those of the window's images.
    [[nodiscard]] VkFormat format() const;

    struct Target {
        std::uint32_t index = 0;
        VkImage image = VK_NULL_HANDLE;
        engine::Signals signals{};
    };
    /// The next image; none where the window has changed since `match`.
    [[nodiscard]] Result<std::optional<Target>> acquire(int slot);
    /// Copies an image of the same size in VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL.
    void copy(VkCommandBuffer commands, const Target& target, VkImage from) const;
    /// After the submission.
    [[nodiscard]] Result<void> show(const Target& target);
    /// Times that the images were made.
    [[nodiscard]] int remade() const;

  private:
    struct State;
    explicit Window(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace windrow::vegetation::view
