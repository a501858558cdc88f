// A level cut through the cells of the air, coloured by a figure that the solver works with, over the picture.
#pragma once

#include "fluid/operators.h"
#include "fluid/wind_control.h"
#include "fluid/wind_reader.h"
#include "vegetation/view/eye.h"

#include <optional>
#include <vector>

namespace windrow::vegetation::view {

enum class SliceOf { nothing, pressure, divergence };
inline constexpr int k_slices = 3;

class Slice {
  public:
    /// Works the figure out for the row of cells at a height [m] above the box's low face. Pressure costs a solve; a device has none
    /// of it. `step`: a number of the air's moment: the same moment is not worked out again.
    Result<void> look(SliceOf what, double height, double step, const WindControl& control, WindReader& reader);
    /// Colours the cells, behind panels, and writes the legend at a place of the window [px].
    void draw(const Projection& projection, glm::vec2 legend) const;
    /// The largest amount of the row, in the unit of the legend.
    [[nodiscard]] float most() const { return most_; }
    [[nodiscard]] const char* unit() const { return what_ == SliceOf::pressure ? "Pa" : "1/s"; }
    /// Of the row, x fastest.
    [[nodiscard]] const std::vector<float>& values() const { return values_; }

  private:
    Result<void> find(std::vector<float>& cells, const WindControl& control, WindReader& reader);

    SliceOf what_ = SliceOf::nothing;
    double height_ = 0.0, step_ = -1.0;
    glm::ivec2 cells_{0};
    glm::dvec3 corner_{0.0};
    double cell_ = 1.0;
    std::vector<float> values_{};
    float most_ = 0.0f;
    std::optional<Workspace> work_{};
};

} // namespace windrow::vegetation::view
