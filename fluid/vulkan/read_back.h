// What comes back to the host with each frame besides the report, and views of it. The views read the memory that the device
// wrote; only beside surfaces, where cells are sampled otherwise than they are, the first query of a frame copies them on the host.
// They are valid until the next recording, or a `collect` that takes one.
#pragma once

#include "../api.h"
#include "../view.h"

#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

namespace windrow::vulkan {

/// What is read back. All of it is as old as the frames in flight.
enum class ReadBack : std::uint8_t {
    none,   ///< the report alone: 64 bytes a frame
    cells,  ///< all cells as floats, 16 bytes each: Wind::queried
    halves, ///< all cells as halves, 8 bytes each: Wind::queried_halves
    box,    ///< a box of cells around Frame::around, 16 bytes each: Wind::queried
    points  ///< the wind at Frame::points, 16 bytes each: Wind::queried_points
};

/// The wind of a frame as halves (IEEE binary16: 11 bits, at most 65504). Cheap to copy.
class WINDROW_API HalfView {
  public:
    /// `place` has no cells of its own, and those that are sampled where `samples` is true.
    HalfView(const WindView& place, std::span<const glm::u16vec4> cells, bool samples = false)
        : place_(place), cells_(cells), samples_(samples) {}

    /// [m/s] As WindView::velocity.
    [[nodiscard]] glm::vec3 velocity(glm::dvec3 position) const;
    /// The cells, laid out as box.h says: x, y, z and 0.
    [[nodiscard]] std::span<const glm::u16vec4> field() const { return cells_; }
    [[nodiscard]] glm::dvec3 origin() const { return place_.origin(); }
    [[nodiscard]] const Box& box() const { return place_.box(); }
    [[nodiscard]] const AmbientWind& ambient() const { return place_.ambient(); }

  private:
    WindView place_;
    std::span<const glm::u16vec4> cells_;
    bool samples_;
};

/// [m/s] Of a cell of halves.
[[nodiscard]] inline glm::vec4 vector_of(glm::u16vec4 cell) {
    return {from_half(cell.x), from_half(cell.y), from_half(cell.z), 0.0f};
}

/// The wind at the points of one frame, in their order.
struct PointWinds {
    std::span<const glm::dvec3> positions; ///< [m] world, as given
    std::span<const glm::vec4> velocities; ///< [m/s] w = 0
};

} // namespace windrow::vulkan
