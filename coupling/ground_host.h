// Backend-independent part of a ground memory: position of the window, and parameters of a step.
#pragma once

#include "coupling/ground_config.h"
#include "coupling/motion_blocks.h"
#include "coupling/motion_numerics.h"
#include "fluid/api.h"

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

namespace windrow::detail {

class WINDROW_INTERNAL GroundHost {
  public:
    /// A valid config. The window lies about the origin.
    explicit GroundHost(const GroundConfig& config) : config_(config), walkers_(static_cast<std::size_t>(config.max_walkers)) {}

    [[nodiscard]] const GroundConfig& config() const { return config_; }
    [[nodiscard]] std::size_t texel_count() const {
        return static_cast<std::size_t>(config_.texels) * static_cast<std::size_t>(config_.texels);
    }

    Result<void> follow(glm::dvec3 point);
    /// [m] World place (x, z) of the texel that `slot` will hold in the next step.
    [[nodiscard]] glm::dvec2 next_centre(glm::ivec2 slot) const;

    /// Moves the window and says what the texels do. Rejects what is not finite or out of range; nothing has changed then.
    [[nodiscard]] Result<numerics::WindrowGroundStep> begin(const GroundStep& step, WindLeans leans);
    /// Of the step that was begun last: those whose sweep may touch the window, the first of them where there are more than the
    /// config has room for.
    [[nodiscard]] std::span<const numerics::WindrowWalker> walkers() const { return std::span(walkers_).first(walker_count_); }
    /// Number of further ones.
    [[nodiscard]] int left_out() const { return left_out_; }

    [[nodiscard]] GroundBlock block(glm::dvec3 anchor) const;
    /// `now` of the next step.
    [[nodiscard]] GroundPlaceBlock next_place(glm::dvec3 anchor) const;

  private:
    using Texel = glm::vec<2, std::int64_t>;
    struct Place {
        Texel corner{0};
        glm::dvec2 point{0.0}; // that the rim follows
        glm::vec2 lean{0.0f};
    };
    [[nodiscard]] Texel corner_about(glm::dvec2 point) const;
    [[nodiscard]] glm::ivec2 slot_of(Texel corner) const;
    [[nodiscard]] GroundPlaceBlock place_block(const Place& place, glm::dvec3 anchor) const;
    [[nodiscard]] std::optional<numerics::WindrowWalker> local(const GroundWalker& walker, double duration, Texel corner) const;

    GroundConfig config_;
    glm::dvec2 point_{0.0};
    Place now_, before_;
    bool begun_ = false;
    std::vector<numerics::WindrowWalker> walkers_; // as many as there is room for: a copy has the room too
    std::size_t walker_count_ = 0;
    int left_out_ = 0;
};

} // namespace windrow::detail
