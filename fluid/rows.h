// Rows of cells of unequal thickness: thin near the ground, where the wind bends, and thick aloft.
//
//     auto wind = windrow::Wind::create({.cells = {64, 32, 64}, .cell_size = 2.0f,
//                                        .boundaries = windrow::Boundaries::open_over_floor(),
//                                        .rows = windrow::Rows{.first = 0.5f, .uniform = 8, .ratio = 1.12f}});
//
// The centres of rows lie anywhere, as long as neighbours are of like thickness; a face between two rows is half way between their
// centres. Then the pair of divergence and gradient stays adjoint, and the projection adds no energy, whatever the heights.
// x and z keep cells of one size, so that a shift of the box loses nothing.
#pragma once

#include "api.h"
#include "result.h"
#include "setting.h"

#include <memory>
#include <span>
#include <tuple>
#include <vector>

namespace windrow {

/// Heights of the rows of a box, by a law or one by one.
struct Rows {
    /// [m] A number above 0, at most 1e6, default 0.5. Thickness of the lowest rows. The lowest cell's centre is at half of it:
    /// .3 m resolves a log profile among grass.
    float first = 0.5f;
    /// 1 to 2048, default 4. How many rows are that thick. Over hills as many as reach the highest ground, so that all ground is
    /// met by cells of one size.
    int uniform = 4;
    /// 1 to 1.5, default 1.1. Distance between two rows above these over the distance below. Up to 1.15 the error stays that of
    /// equal rows of the mean thickness.
    float ratio = 1.1f;
    /// [m] 0 (by the ratio) to 1e6, default 0. Height of the box. The ratio follows from it. With heights: where the box ends
    /// above the last one.
    float top = 0.0f;
    /// [m] Each component a number above 0, at most 1e6. Heights of the rows' centres over the floor of the box, one a row, in
    /// place of the law. A distance between two is at most twice the distance beside it. Default none.
    std::vector<float> heights{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("first", &Rows::first, Range::above(0.0, 1e6, "m"),
                    "Thickness of the lowest rows. The lowest cell's centre is at half of it: .3 m resolves a log profile among "
                    "grass."),
            Setting("uniform", &Rows::uniform, {1.0, 2048.0},
                    "How many rows are that thick. Over hills as many as reach the highest ground, so that all ground is met by "
                    "cells of one size."),
            Setting(
                "ratio", &Rows::ratio, {1.0, 1.5},
                "Distance between two rows above these over the distance below. Up to 1.15 the error stays that of equal rows "
                "of the mean thickness."),
            Setting("top", &Rows::top, {.min = 0.0, .max = 1e6, .unit = "m", .zero = "by the ratio"},
                    "Height of the box. The ratio follows from it. With heights: where the box ends above the last one."),
            Setting(
                "heights", &Rows::heights, Range::above(0.0, 1e6, "m"),
                "Heights of the rows' centres over the floor of the box, one a row, in place of the law. A distance between two "
                "is at most twice the distance beside it. Default none."),
        };
    }
};

/// Most rows of a wind: shaders that sample its textures hold a table of their heights.
inline constexpr int k_max_rows = 128;

/// All reasons why they are invalid, one per line.
[[nodiscard]] WINDROW_API Result<void> validate(const Rows& rows);
namespace detail {
class Reasons;
struct FieldPath;
} // namespace detail
WINDROW_API void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const Rows& rows);

/// The rows of one box as numbers. Heights are in m over the low boundary; row j is between faces j and j + 1.
class WINDROW_API RowTable {
  public:
    /// `count` rows in a box of cells of `cell_size` [m] along x and z. Rejects what `validate` does, another number of heights than
    /// rows, fewer than 2 rows or more than k_max_rows, and a top that no ratio from 1 to 1.5 reaches.
    [[nodiscard]] static Result<std::shared_ptr<const RowTable>> create(const Rows& rows, int count, float cell_size);

    [[nodiscard]] int count() const { return static_cast<int>(heights_.size()) - 2; }
    /// [m] Of a row's centre. Beyond the box rows go on, mirrored below the low boundary, at equal distances above the high one.
    [[nodiscard]] double height(int row) const;
    /// [m] Of the face below a row.
    [[nodiscard]] double face(int row) const { return 0.5 * (height(row - 1) + height(row)); }
    [[nodiscard]] double thickness(int row) const { return face(row + 1) - face(row); }
    /// [m] Of the box.
    [[nodiscard]] double top() const { return face(count()); }
    /// A height in rows from the low boundary: j + 1/2 at the centre of row j, linear between centres.
    [[nodiscard]] double place(double height) const;
    /// The inverse.
    [[nodiscard]] double height_at(double place) const;
    /// [m] The thinnest row, or the least distance between two.
    [[nodiscard]] float finest() const { return finest_; }
    /// [m] The thickest row, or the largest distance.
    [[nodiscard]] float coarsest() const { return coarsest_; }
    /// Rows of a box that has moved up by `rise` [m], in rows of the box before: places to read at, one a row; NaN where a row is
    /// beyond that box.
    [[nodiscard]] double place_before(int row, double rise) const;
    /// [m] Step by which such a box moves up and down: the thickness of its lowest row.
    [[nodiscard]] double step() const { return thickness(0); }

    /// By row: cell size over thickness.
    [[nodiscard]] std::span<const float> scales() const { return scales_; }
    /// By face, from the low boundary: cell size over the distance between the centres below and above it.
    [[nodiscard]] std::span<const float> links() const { return links_; }
    /// [m] The heights of rows -1 to count().
    [[nodiscard]] std::span<const double> heights() const { return heights_; }
    /// [m] By row: the heights as floats.
    [[nodiscard]] std::span<const float> centres() const { return centres_; }

  private:
    RowTable(std::vector<double> heights, float cell_size);

    std::vector<double> heights_; ///< of rows -1 to count
    std::vector<float> scales_, links_, centres_;
    float finest_ = 0.0f, coarsest_ = 0.0f;
};

} // namespace windrow
