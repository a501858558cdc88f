// Ambient wind at every cell of a box and of its halo.
#pragma once

#include "fluid/ambient.h"
#include "fluid/cpu/aligned.h"
#include "fluid/cpu/kernels/kernels.h"
#include "fluid/parallel.h"
#include "fluid/window.h"

#include <cstddef>

namespace windrow::cpu {

/// Layout of the advection's padded fields: four floats a cell (x, y, z, 0), cells + k_halo an axis, x fastest, then y, then z.
/// Box cell (i, j, k) is at (i, j, k) + k_halo_low.
class AmbientField {
  public:
    AmbientField() = default;
    /// Allocates for a box of these cells; all zero until `fill`.
    explicit AmbientField(glm::ivec3 cells);

    /// The wind of now at the cells' centres. The window must have the cells of the constructor. Does not allocate. The result
    /// does not depend on the threads.
    void fill(const AmbientWind& wind, const Window& window, const ParallelFor& parallel_for);

    [[nodiscard]] const float* data() const { return values_.data(); }
    [[nodiscard]] glm::ivec3 cells() const { return cells_; }
    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    /// Column of blended texels of a cell, in floats from the row's first, and the distance to the next.
    struct Column {
        int first = 0;
        float fraction = 0.0f;
    };
    /// The two layers of the tile around a cell, -1 or 1 for the sign of their vertical component, and the wind's factors
    /// there.
    struct Layer {
        int low = 0, high = 0;
        float low_sign = 1.0f, high_sign = 1.0f, fraction = 0.0f;
        float mean_fraction = 1.0f, gust_fraction = 1.0f;
    };
    /// The two slices of the tile around a plane.
    struct Slice {
        int low = 0, high = 0;
        float fraction = 0.0f;
    };

    void make_tables(const AmbientWind& wind, const Window& window);
    void fill_plane(const AmbientWind& wind, int plane);

    glm::ivec3 cells_{0};
    Buffer<float> values_;
    Buffer<Column> columns_;
    Buffer<Layer> layers_;
    Buffer<Slice> slices_;
    int first_texel_ = 0;   ///< of the row's first column, 0 to 127
    int texel_columns_ = 0; ///< columns of texels that a row covers, at most a whole tile and the first again
};

} // namespace windrow::cpu
