// The turbulent air over rough surfaces: stress at the ground and mixing in the column above it.
//
//   du/dt = d/dy (tau(u) - tau(A)),   tau = l^2 |du/dy| du/dy between cells,   tau = C |u| u over a surface
//
// of the horizontal components, at the faces across y. C = (kappa / log(1 + z / z0))^2, z the height of the lowest cell's centre;
// l = kappa h / log((z + h + z0) / (z + z0)) between the heights z and z + h: with it tau is the same at all faces of a log profile,
// to rounding, for cells of any size. tau(A) is that of the ambient wind in its own profile over its own ground: the stress acts on
// what differs from it, so that an empty box stays ambient, gusts too.
//
// Implicit in each column, about the wind u at the start of the step: |s| s of the new difference s' is taken as |s| (2 s' - s).
// |s| s' alone overshoots where a step is long, and with 2 it is Newton's for a change along s. Where the wind's own
// |s_A| is the larger by so much that tau(A) would give still air more than half of A in a step, as much of (|s_A| - |s|) (s' - s)
// is added: still air goes to A at most, and is not kicked beyond it, however long the step. First order in time.
// Based on: Prandtl 1925 (mixing length); Kalnay & Kanamitsu 1988, Monthly Weather Review 116 (schemes for such diffusion).
#pragma once

#include "fluid/allocator.h"
#include "fluid/ambient.h"
#include "fluid/api.h"
#include "fluid/box.h"
#include "fluid/parallel.h"
#include "fluid/roughness.h"
#include "fluid/solids/solids.h"
#include "fluid/window.h"

#include <optional>
#include <span>
#include <vector>

namespace windrow {

inline constexpr float k_smoothest = 1e-6f; ///< [m] as Roughness::length
/// [m] Roughness length at a place in the world.
[[nodiscard]] WINDROW_INTERNAL float roughness_at(const Roughness& roughness, glm::dvec3 place);

class WINDROW_INTERNAL SurfaceLayer {
  public:
    SurfaceLayer(const Box& box, const Roughness& roughness);

    /// For the ambient wind and the window of now. `solids` may be null; `placed`: they were placed anew.
    void renew(const AmbientWind& around, const Window& window, const Boundaries& boundaries, const Solids* solids, bool placed,
               const ParallelFor& parallel_for);

    /// Of the faces across y, from the box's low end, one more than the cells; x fastest, then y, then z. Above 0 the square of the
    /// mixing length over the distance between the two rows; below 0, of a face that a surface closes, its drag coefficient C with the opposite sign,
    /// for the cell above; 0 where nothing passes.
    [[nodiscard]] std::span<const float> faces() const { return faces_; }
    /// The same of the ambient wind, whose ground is level, one a row of faces; empty where it has no profile.
    [[nodiscard]] std::span<const float> wind_mixing() const { return wind_mixing_; }
    /// C of the ambient wind where a surface is below a row of cells; 0 where it has none.
    [[nodiscard]] std::span<const float> wind_drag() const { return wind_drag_; }
    /// Changes whenever they do.
    [[nodiscard]] std::uint64_t version() const { return version_; }
    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    /// What the faces depend on beside the obstacles.
    struct Place {
        CellIndex origin_cells{0};
        double ground = 0.0;
        BoundaryKind low{}, high{};
        friend bool operator==(const Place&, const Place&) = default;
    };
    void renew_wind(const AmbientWind& around, const Window& window);
    void renew_plane(const Window& window, const Solids* solids, int plane);
    /// No obstacle is in a column.
    [[nodiscard]] bool leaves_free(const Solids& solids, int i, int k) const;
    [[nodiscard]] float over_grounds(const Solids& solids, glm::ivec3 cell) const;
    [[nodiscard]] float distance_above(int row) const;
    [[nodiscard]] float mixing(int row, float height, float roughness) const;
    [[nodiscard]] float height_of(int row, int first, float height) const;

    Box box_;
    const Roughness& roughness_; ///< of the wind's config, whose map moves with the world's origin
    std::optional<Place> place_;
    std::uint64_t version_ = 0;
    float wind_height_ = 0.0f; ///< [m] of the lowest cells over the ambient wind's ground
    detail::HostVector<float> faces_, wind_mixing_, wind_drag_;
};

} // namespace windrow
