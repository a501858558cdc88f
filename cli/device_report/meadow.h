// A meadow in the wind, drawn by a report: a walker and a fan in gusts over blades that the vertex stage makes.
#pragma once

#include "cli/device_report/draw_host.h"

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <memory>

namespace windrow::cli {

/// Vertices of a blade.
inline constexpr std::uint32_t k_blade_vertices = 7;

class Meadow {
  public:
    [[nodiscard]] static Result<std::unique_ptr<Meadow>> create(vulkan::OwnDevice& own, vulkan::Device& device);

    /// Steps the wind until the walker has come halfway, at most `steps` times. Ends early where `stopped` returns true.
    [[nodiscard]] Result<void> blow(int steps, const std::function<bool()>& stopped);

    enum class Eye { walking, above };
    /// What the next draws show. Nothing that draws is in flight.
    [[nodiscard]] Result<void> look(Eye eye, VkExtent2D extent, std::uint32_t blades);

    /// Blades before the sky.
    [[nodiscard]] Result<std::vector<DrawHost::Draw>> frame(const DrawHost::Target& target, std::uint32_t blades);
    /// Their vertices alone.
    [[nodiscard]] Result<std::vector<DrawHost::Draw>> vertices(const DrawHost::Target& target, std::uint32_t blades);
    /// Speeds as colours, from the side and from above.
    [[nodiscard]] Result<std::vector<DrawHost::Draw>> slices(const DrawHost::Target& target);

    [[nodiscard]] DrawHost& host() { return *host_; }

  private:
    Meadow(vulkan::OwnDevice& own, std::unique_ptr<DrawHost> host, WindBindings bindings, vulkan::Buffer scene, vulkan::Wind wind)
        : own_(own), host_(std::move(host)), bindings_(std::move(bindings)), scene_(std::move(scene)), wind_(std::move(wind)) {}

    vulkan::OwnDevice& own_;
    std::unique_ptr<DrawHost> host_;
    WindBindings bindings_;
    vulkan::Buffer scene_;
    vulkan::Wind wind_;
    MotorId walker_{};
    glm::dvec3 feet_{0.0};
};

} // namespace windrow::cli
