// Ambient wind on a padded box.
//
// Trilinear blending is separable. A row of cells has one y and one z. The four rows of texels around it are blended first, once
// for each texel that the row covers. This includes the gusts' strength, their axes, the profile and the mean. A cell then
// costs one blend along x. Indices and weights come from one small table per axis. Where cells are so large that a row covers
// more texels than it reads, only the texels read are blended.
#include "fluid/cpu/ambient_field.h"

#include <algorithm>
#include <cassert>

namespace windrow::cpu {
namespace {

constexpr int k_side = GustTile::k_side, k_height = GustTile::k_height;

typedef float Cell __attribute__((vector_size(16)));
typedef float CellUnaligned __attribute__((vector_size(16), aligned(4), may_alias));

inline Cell load(const float* p) {
    return *reinterpret_cast<const CellUnaligned*>(p);
}
inline void store(float* p, Cell value) {
    *reinterpret_cast<CellUnaligned*>(p) = value;
}
inline Cell splat(float value) {
    return Cell{value, value, value, value};
}
inline Cell blended(Cell a, Cell b, float t) {
    return a + splat(t) * (b - a);
}

// Four rows of texels and their weights, strength and signs included; `base` is the wind without gusts.
struct TexelRows {
    const float* rows[4];
    Cell weights[4];
    Cell base;

    Cell at(int texel) const {
        Cell sum = base;
        for (int n = 0; n < 4; ++n)
            sum += weights[n] * load(rows[n] + 4 * texel);
        return sum;
    }
};

} // namespace

AmbientField::AmbientField(glm::ivec3 cells)
    : cells_(cells), columns_(cells.x + k_halo), layers_(cells.y + k_halo), slices_(cells.z + k_halo) {
    values_ = Buffer<float>(4 * columns_.size() * layers_.size() * slices_.size());
}

void AmbientField::fill(const AmbientWind& wind, const Window& window, const ParallelFor& parallel_for) {
    assert(window.cells == cells_);
    make_tables(wind, window);
    parallel_for(cells_.z + k_halo, [&](int plane) { fill_plane(wind, plane); });
}

void AmbientField::make_tables(const AmbientWind& wind, const Window& window) {
    const bool gusting = wind.gusting();
    const auto centre = [&](int axis, std::size_t padded) {
        const int cell = static_cast<int>(padded) - k_halo_low;
        return window.centre(cell, cell, cell)[axis];
    };
    const float strength = wind.gust_strength();
    for (std::size_t j = 0; j < layers_.size(); ++j) {
        const double height = centre(1, j);
        Layer layer;
        layer.mean_fraction = wind.profile_at(height);
        layer.gust_fraction = strength * std::min(layer.mean_fraction, 1.0f);
        if (gusting) {
            const auto [texel, fraction] = wind.gust_place(1, height);
            const auto mirrored = [](int y, int& row, float& sign) {
                const int within = y & (2 * k_height - 1);
                sign = within < k_height ? 1.0f : -1.0f;
                row = within < k_height ? within : 2 * k_height - 1 - within;
            };
            mirrored(texel, layer.low, layer.low_sign);
            mirrored(texel + 1, layer.high, layer.high_sign);
            layer.fraction = fraction;
        }
        layers_[j] = layer;
    }
    if (!gusting)
        return;
    for (std::size_t k = 0; k < slices_.size(); ++k) {
        const auto [texel, fraction] = wind.gust_place(2, centre(2, k));
        slices_[k] = {texel & (k_side - 1), (texel + 1) & (k_side - 1), fraction};
    }
    texel_columns_ = 0;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        const auto [texel, fraction] = wind.gust_place(0, centre(0, i));
        if (i == 0)
            first_texel_ = texel & (k_side - 1);
        const int along = (texel - first_texel_) & (k_side - 1);
        columns_[i] = {4 * along, fraction};
        texel_columns_ = std::max(texel_columns_, along + 2);
    }
}

void AmbientField::fill_plane(const AmbientWind& wind, int plane) {
    const std::size_t row_cells = columns_.size();
    const glm::vec3 mean = wind.mean(), axes = wind.gust_axes();
    const bool gusting = wind.gusting();
    const bool sparse = static_cast<std::size_t>(texel_columns_) > 2 * row_cells;
    alignas(64) float texels[4 * (k_side + 1)];
    for (std::size_t j = 0; j < layers_.size(); ++j) {
        const Layer& layer = layers_[j];
        float* const row = values_.data() + 4 * row_cells * (plane * layers_.size() + j);
        TexelRows around{};
        around.base = splat(layer.mean_fraction) * Cell{mean.x, mean.y, mean.z, 0.0f};
        if (!gusting) {
            for (std::size_t i = 0; i < row_cells; ++i)
                store(row + 4 * i, around.base);
            continue;
        }
        const Slice& slice = slices_[plane];
        const auto set_row = [&](int n, int y, float y_sign, float y_weight, int z, float z_weight) {
            around.rows[n] = &wind.tile()->texels()[static_cast<std::size_t>(z * k_height + y) * k_side].x;
            around.weights[n] = splat(layer.gust_fraction * y_weight * z_weight) * Cell{axes.x, y_sign * axes.y, axes.z, 0.0f};
        };
        set_row(0, layer.low, layer.low_sign, 1.0f - layer.fraction, slice.low, 1.0f - slice.fraction);
        set_row(1, layer.high, layer.high_sign, layer.fraction, slice.low, 1.0f - slice.fraction);
        set_row(2, layer.low, layer.low_sign, 1.0f - layer.fraction, slice.high, slice.fraction);
        set_row(3, layer.high, layer.high_sign, layer.fraction, slice.high, slice.fraction);
        if (sparse) {
            for (std::size_t i = 0; i < row_cells; ++i) {
                const int texel = first_texel_ + columns_[i].first / 4;
                store(row + 4 * i,
                      blended(around.at(texel & (k_side - 1)), around.at((texel + 1) & (k_side - 1)), columns_[i].fraction));
            }
            continue;
        }
        const int before_wrap = std::min(texel_columns_, k_side - first_texel_);
        for (int n = 0; n < before_wrap; ++n)
            store(texels + 4 * n, around.at(first_texel_ + n));
        for (int n = before_wrap; n < texel_columns_; ++n)
            store(texels + 4 * n, around.at(first_texel_ + n - k_side));
        for (std::size_t i = 0; i < row_cells; ++i) {
            const float* const low = texels + columns_[i].first;
            store(row + 4 * i, blended(load(low), load(low + 4), columns_[i].fraction));
        }
    }
}

std::size_t AmbientField::memory_bytes() const {
    return values_.bytes() + columns_.bytes() + layers_.bytes() + slices_.bytes();
}

} // namespace windrow::cpu
