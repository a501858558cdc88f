// Read-only view of the wind at one time, for sampling: the box's cells, their position, and the ambient wind around them.
//
// Inside the box the wind is trilinear between cell centres. Near an open boundary of an axis that follows a point it fades to
// the ambient wind over a blend zone. The weight depends on the distance from the point itself, which moves smoothly while the
// box moves by whole cells, so a shift of the box changes no value. Other open boundaries fade over the one cell beyond them.
// Beyond a wall the wind is that at the wall.
//
// Beside a surface the wind is that of the air next to it, along the surface, whatever cells the surface cuts: half a cell above it and
// two and a half cells below it, so that a plant's foot a little under the ground does not jump. Deeper inside it is the body's own
// velocity. Over rough ground the wind falls to 0 by the law of the wall; below the ground it is 0.
#pragma once

#include "ambient.h"
#include "api.h"
#include "box.h"
#include "simd.h"
#include "textures.h"
#include "window.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

namespace windrow {

class SurfaceReading;

/// The law of the wall over rough ground, between and below the centres of cells (shaders/numerics/wall_law.glsl). All 0: none.
struct WallLaw {
    float per_length = 0.0f; ///< [1/m] one over the roughness length; the longest one where lengths differ by place
    float per_log = 0.0f;    ///< one over the law's logarithm at its reach; 0: no law acts
    float reach = 0.0f;      ///< [m] height from which on it changes nothing
    float lowest = 0.0f;     ///< [m] of the lowest centres over the box's floor; -1e30 without a floor
    float fall = 0.0f;       ///< 1; 0 where lengths differ by place

    [[nodiscard]] bool acts() const { return per_log > 0.0f; }
    /// Part of the wind at its reach that the law leaves at a height [m].
    [[nodiscard]] WINDROW_API float fraction(float height) const;
};

/// Cells as they are sampled near surfaces (fluid/solids/reading.h), where they are not the field's own.
struct ShownCells {
    std::span<const glm::vec4> cells{}; ///< empty: the field; with a law w is the height over the surface
    WallLaw law{};
    const SurfaceReading* reading = nullptr; ///< null: none
    glm::ivec3 low{0};                       ///< of the field in the reading's box
    int rows_low = 0;                        ///< the same of its rows over the floor
};

/// Blend zone of a box, over which its wind fades to the ambient wind.
struct BlendZone {
    glm::dvec3 point{0.0}; ///< [m] world; what the box follows
    glm::vec3 reach{0.0f}; ///< [cells] from the point, where the box's wind has faded; 0: no blend zone on that axis
    float width = 1.0f;    ///< [cells]
};

class Wind;

/// The wind around a view's box where that is another wind; null: the ambient one.
struct ViewAround {
    const Wind* outer = nullptr;
    bool before = false; ///< as it was in the frame before
};

/// View of a Wind's own memory: cheap to copy, valid until the next change of the wind.
class WINDROW_API WindView {
  public:
    /// `simd`: of the queries, a level that this machine runs.
    WindView(const Box& box, const Window& window, const BlendZone& blend_zone, const AmbientWind& ambient,
             std::span<const glm::vec4> field, Simd simd = Simd::best, const ShownCells& shown = {}, ViewAround around = {})
        : box_(&box), window_(window), blend_zone_(blend_zone), ambient_(&ambient), field_(field), shown_(shown), simd_(simd),
          around_(around) {}

    /// [m/s] Wind at a world point: beyond the box and in its blend zone that of the outer wind, which may be advanced no further than
    /// this one. A point that is not finite gets the mean wind.
    [[nodiscard]] glm::vec3 velocity(glm::dvec3 position) const;
    /// The same for many points; `velocities` holds as many. Vector instructions work on 16 points, so that a point takes a tenth
    /// of the time of the call above. Lists in which neighbours are near each other are fastest: their cells are in the
    /// cache. The bits of a point are those of the call above, in any list and on any SIMD level.
    void velocity(std::span<const glm::dvec3> positions, std::span<glm::vec3> velocities) const;
    /// The same as four floats each, w = 0: as plants take winds (Blades::loads, Shells::loads).
    void velocity(std::span<const glm::dvec3> positions, std::span<glm::vec4> velocities) const;
    /// [m/s] Wind that acts on a plant there: scaled, limited, with small-scale detail; see Sampling.
    [[nodiscard]] glm::vec3 felt(glm::dvec3 position, const Sampling& sampling) const;
    /// The same for many points, as `velocity` takes them.
    void felt(std::span<const glm::dvec3> positions, const Sampling& sampling, std::span<glm::vec3> velocities) const;
    void felt(std::span<const glm::dvec3> positions, const Sampling& sampling, std::span<glm::vec4> velocities) const;
    /// [m/s] The air's own cells, laid out as box.h says; w = 0, or over rough ground the lee of plants (shaders/numerics/lee.glsl).
    /// What is sampled is filled beside surfaces.
    [[nodiscard]] std::span<const glm::vec4> field() const { return field_; }
    /// One texture of four components, as float or half: x, y, z of the velocity and 0, as it is sampled. Over rough ground x, y, z are
    /// the wind over the fraction that the law of the wall leaves and w [m] is the height, as windrow_wind.glsl reads them. The span holds four numbers for each of
    /// box().cell_count() texels, or the call is rejected. As windrow_wind.glsl samples it by default.
    Result<void> write_vectors(std::span<float> texels) const;
    Result<void> write_vectors(std::span<std::uint16_t> texels) const;
    /// Three textures, one an axis, as float or half, without the law of the wall; each span holds box().cell_count() texels or the call is rejected. For
    /// WINDROW_THREE_TEXTURES, which takes 6 bytes a cell in half in place of 8.
    Result<void> write_axes(std::span<float> x, std::span<float> y, std::span<float> z) const;
    Result<void> write_axes(std::span<std::uint16_t> x, std::span<std::uint16_t> y, std::span<std::uint16_t> z) const;
    /// [m] World position of the box's low corner.
    [[nodiscard]] glm::dvec3 origin() const { return window_.origin(); }
    [[nodiscard]] Window window() const { return window_; }
    [[nodiscard]] const Box& box() const { return *box_; }
    [[nodiscard]] BlendZone blend_zone() const { return blend_zone_; }
    /// The ambient wind around the box at the time of the view.
    [[nodiscard]] const AmbientWind& ambient() const { return *ambient_; }
    /// The wind around the box.
    [[nodiscard]] const ViewAround& around() const { return around_; }
    /// Position of the textures, relative to `anchor` [m]; the fields of the frame before are those of this one.
    [[nodiscard]] WindowBlock block(glm::dvec3 anchor) const;

  private:
    const Box* box_;
    Window window_;
    BlendZone blend_zone_;
    const AmbientWind* ambient_;
    [[nodiscard]] std::span<const glm::vec4> shown() const { return shown_.cells.empty() ? field_ : shown_.cells; }
    template <class Texel>
    Result<void> write_texels(std::span<Texel> x, std::span<Texel> y, std::span<Texel> z) const;

    template <class Velocity>
    void read(const Sampling* felt, std::span<const glm::dvec3> positions, std::span<Velocity> velocities) const;

    std::span<const glm::vec4> field_;
    ShownCells shown_;
    Simd simd_;
    ViewAround around_;
};

} // namespace windrow
