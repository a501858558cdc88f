// Streaks of the wind: the ways of bits of air in the last moments, long where it is fast, none where it is calm.
//
//     auto streaks = render::WindStreaks::create(device, renderer->draw_targets(), {}, {anchor, low, extent});
//     renderer->add(**streaks);
//     (*streaks)->advance(dt, wind_at, is_blocked);                     // each frame, before the renderer's recording
#pragma once

#include "../vulkan/frames.h"
#include "drawable.h"

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace windrow::vegetation::render {

struct WindStreakSettings {
    int count = 2400;
    float seconds = 1.5f;
    float life = 5.0f;
    float lowest = 0.8f;
    float highest = 8.0f;
    float width = 0.05f;
    glm::vec3 colour{0.95f, 0.96f, 0.97f};

    static constexpr auto settings() {
        return std::tuple{
            Setting("count", &WindStreakSettings::count, {1.0, 100000.0}, "Streaks in the box."),
            Setting("seconds", &WindStreakSettings::seconds, Range::above(0.0, 60.0, "s"),
                    "A streak is as long as the way in this time."),
            Setting("life", &WindStreakSettings::life, Range::above(0.0, 600.0, "s"), "After it one begins again elsewhere."),
            Setting("lowest", &WindStreakSettings::lowest, {-1e4, 1e4, "m"},
                    "Height above the box's low face at which streaks begin; most do near it."),
            Setting("highest", &WindStreakSettings::highest, {-1e4, 1e4, "m"}, "Highest such height, at least lowest."),
            Setting("width", &WindStreakSettings::width, Range::above(0.0, 10.0, "m"),
                    "At the head; the tail is a point. Never thinner than a pixel and a half."),
            Setting("colour", &WindStreakSettings::colour, {0.0, 1.0}, "Linear albedo."),
        };
    }
};
[[nodiscard]] windrow::Result<void> validate(const WindStreakSettings& settings);
void check_rules(windrow::detail::Reasons& reasons, const windrow::detail::FieldPath& path, const WindStreakSettings& settings);

/// The box that holds them, in the world [m].
struct StreakBox {
    glm::dvec3 low{0.0}, extent{1.0};
};

/// The ways themselves, without a device.
class StreakWays {
  public:
    static constexpr int k_points = 15; ///< of a way, the newest first

    using Velocity = std::function<void(std::span<const glm::dvec3>, std::span<glm::vec3>)>;
    /// Whether a body is on the way or at its end.
    using Blocked = std::function<bool(const glm::dvec3& from, const glm::dvec3& to)>;

    StreakWays(const WindStreakSettings& settings, const StreakBox& box);
    /// Advances by dt [s]. One that leaves the box, comes to a body or ends begins again.
    void advance(double dt, const Velocity& velocity, const Blocked& blocked);
    /// The box has moved. A way that is outside of it begins again, in the next `advance`.
    void follow(glm::dvec3 low) { box_.low = low; }

    struct Way {
        std::array<glm::dvec3, k_points> points{}; ///< [m] world: the head, then where it was, as long apart at any frame rate
        int used = 0;
        double since = 0.0; ///< [s] from the second point to the head
        double age = 0.0;   ///< [s]
    };
    [[nodiscard]] std::span<const Way> ways() const { return ways_; }
    /// A point of a way as it is drawn: the last of a whole one is where the head was `seconds` ago.
    struct Point {
        glm::dvec3 place{0.0};
        double share = 1.0; ///< of the width: 1 at the head, 0 after `seconds`
    };
    [[nodiscard]] Point point(const Way& way, int number) const;
    /// 0 to 1: a way fades in, and out.
    [[nodiscard]] float strength(const Way& way) const;

  private:
    void begin(Way& way, double age);
    /// [s] Between two points behind the head: as many as cover `seconds`, with one that the tail comes from.
    [[nodiscard]] double apart() const { return static_cast<double>(settings_.seconds) / (k_points - 2); }

    WindStreakSettings settings_;
    StreakBox box_;
    std::vector<Way> ways_;
    std::vector<glm::dvec3> heads_;
    std::vector<glm::vec3> velocities_;
    std::uint32_t begun_ = 0;
};

/// A normal as near to the upright as faces an eye in this direction (unit vector): solids turn one that looks away, and a streak
/// above the eye would have the ground's light alone.
[[nodiscard]] glm::vec3 upright_normal(glm::vec3 to_eye);

class WindStreaks final : public Drawable {
  public:
    /// Rejects what `validate` rejects.
    [[nodiscard]] static Result<std::unique_ptr<WindStreaks>> create(engine::Device& device, const DrawTargets& targets,
                                                                     const WindStreakSettings& settings, const StreakBox& box);

    void advance(double dt, const StreakWays::Velocity& velocity, const StreakWays::Blocked& blocked) {
        ways_.advance(dt, velocity, blocked);
    }
    void follow(glm::dvec3 low) { ways_.follow(low); }
    Result<void> prepare(const PassContext& context) override;
    void draw(const PassContext& context) override;

  private:
    WindStreaks(engine::Device& device, const DrawTargets& targets, const WindStreakSettings& settings, const StreakBox& box);

    engine::Objects objects_;
    WindStreakSettings settings_;
    StreakWays ways_;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
    std::array<VkDescriptorSet, engine::k_frames_in_flight> sets_{};
    engine::FrameBuffers vertices_{};
    std::uint32_t drawn_ = 0; ///< vertices of this frame
};

} // namespace windrow::vegetation::render
