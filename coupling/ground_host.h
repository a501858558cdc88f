// Backend-independent part of a ground memory: position of the window, parameters of a step, and its bytes.
#pragma once

#include "coupling/ground_config.h"
#include "coupling/motion_blocks.h"
#include "coupling/motion_numerics.h"
#include "fluid/api.h"
#include "fluid/core/archive.h"

#include <array>
#include <cmath>
#include <cstddef>
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
    Result<void> shift_origin(glm::dvec3 offset);
    /// [m] World place (x, z) of the texel that `slot` will hold in the next step.
    [[nodiscard]] glm::dvec2 next_centre(glm::ivec2 slot) const;

    /// Moves the window and says what the texels do. Rejects what is not finite or out of range; nothing has changed then.
    [[nodiscard]] Result<numerics::WindrowGroundStep> begin(const GroundStep& step, WindLeans leans);
    /// Of the step that was begun last: those whose sweep may touch the window, the first of them where there are more than the
    /// config has room for.
    [[nodiscard]] std::span<const numerics::WindrowWalker> walkers() const { return std::span(walkers_).first(walker_count_); }
    /// Number of further ones.
    [[nodiscard]] int left_out() const { return left_out_; }

    /// To bytes and back, beside the config: a function for both (fluid/core/archive.h).
    template <class Archive, class Host>
    static void fields(Archive& archive, Host& host);

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
    [[nodiscard]] static bool is_in_reach(glm::dvec2 point);
    /// [m] From the origin that texels count from.
    [[nodiscard]] glm::dvec2 own_place(glm::dvec3 world) const { return glm::dvec2(world.x, world.z) - origin_; }
    [[nodiscard]] Texel corner_about(glm::dvec2 point) const;
    [[nodiscard]] glm::ivec2 slot_of(Texel corner) const;
    [[nodiscard]] GroundPlaceBlock place_block(const Place& place, glm::dvec3 anchor) const;
    [[nodiscard]] std::optional<numerics::WindrowWalker> local(const GroundWalker& walker, double duration, Texel corner) const;

    GroundConfig config_;
    glm::dvec2 origin_{0.0}; // [m] in the world: texels and all places below count from it, so that a shift moves none of them
    glm::dvec2 point_{0.0};
    Place now_, before_;
    bool begun_ = false;
    std::vector<numerics::WindrowWalker> walkers_; // as many as there is room for: a copy has the room too
    std::size_t walker_count_ = 0;
    int left_out_ = 0;
};

template <class Archive, class Host>
void GroundHost::fields(Archive& archive, Host& host) {
    archive(host.origin_, host.point_, host.begun_, host.left_out_);
    constexpr bool reads = Reading<Archive>;
    if constexpr (reads)
        archive.require(is_in_reach(host.origin_) && is_in_reach(host.point_) && host.left_out_ >= 0,
                        "the point that it follows is out of range.");
    for (auto* place : {&host.now_, &host.before_}) {
        if (!host.begun_) // they have none
            return;
        archive(place->point, place->lean);
        if constexpr (reads) {
            archive.require(is_in_reach(place->point) && std::abs(place->lean.x) <= WINDROW_GROUND_MOST_LEAN &&
                                std::abs(place->lean.y) <= WINDROW_GROUND_MOST_LEAN,
                            "its window, or the wind there, is out of range.");
            if (!archive.rejected())
                place->corner = host.corner_about(place->point);
        }
    }
}

// --- Bytes (saved_ground.cpp) ------------------------------------------------------------------------------------------------

/// A ground memory between its bytes and a backend: those of a device load on the CPU and the other way.
struct WINDROW_INTERNAL SavedGround {
    /// At rest, before any step.
    explicit SavedGround(const GroundConfig& config)
        : host(config), texels(host.texel_count()), leans_before(host.texel_count()), shown_before(host.texel_count()) {}

    GroundHost host;
    bool stepped = false;
    std::vector<numerics::WindrowGround> texels;
    std::vector<glm::vec2> leans_before; ///< [rad] of the wind, a step ago
    std::vector<glm::vec4> shown_before; ///< what was sampled a step ago; what is sampled now follows from the texels
};

[[nodiscard]] WINDROW_INTERNAL Result<std::vector<std::byte>> to_bytes(const SavedGround& ground);
/// Rejects bytes that `to_bytes` did not return.
[[nodiscard]] WINDROW_INTERNAL Result<SavedGround> ground_of(std::span<const std::byte> bytes);

} // namespace windrow::detail
