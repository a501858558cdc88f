#include "fluid/core/validation.h"
#include "vegetation/fur/mesh_grid.h"
#include "vegetation/fur/mesh_weld.h"
#include "vegetation/fur/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace windrow::vegetation::fur {
namespace {

// A wing's outline and section at u along the span, v along the chord.
class WingForm {
  public:
    explicit WingForm(const Wing& wing) : wing_(wing) {}

    /// `side`: 1 the upper skin, -1 the lower; both meet where the thickness ends.
    [[nodiscard]] glm::vec3 at(float u, float v, float side) const {
        const float chord = chord_at(u);
        const float arm = 4.0f * u * (1.0f - u) * 0.08f; // the wrist stands higher and farther forward than root and tip
        const float camber = 0.28f * v * (1.0f - v);
        const float half = 0.5f * wing_.thickness * section(v) * (1.0f - 0.8f * u);
        return {wing_.span * u, wing_.span * (arm - wing_.droop * u * u) + chord * (camber + side * half),
                wing_.span * (0.9f * arm - wing_.sweep * u * u) - chord * v};
    }

  private:
    // [m] Full to the wrist, round at the tip, notched between the feathers of the hand.
    [[nodiscard]] float chord_at(float u) const {
        const float outline = std::sqrt(std::max(1.0f - std::pow(u, 3.2f), 0.0f));
        const float notch = std::abs(std::sin(std::numbers::pi_v<float> * static_cast<float>(wing_.feathers) * u));
        const float depth = wing_.feathers > 0 ? 0.05f + 0.3f * u * u : 0.0f;
        return wing_.chord * std::max(outline, 0.1f) * (1.0f - depth * (1.0f - std::sqrt(notch)));
    }
    // 1 at a fifth of the chord; round in front, a wedge behind, with a rim: of a knife's edge the normals of both sides cancel.
    static float section(float v) {
        constexpr float k_thickest = 0.2f, k_rim = 0.25f;
        if (v < k_thickest)
            return std::sqrt(v / k_thickest * (2.0f - v / k_thickest));
        return k_rim + (1.0f - k_rim) * (1.0f - v) / (1.0f - k_thickest);
    }

    const Wing& wing_;
};

} // namespace

void check_rules(windrow::detail::Reasons& reasons, const windrow::detail::FieldPath& path, const Wing& wing) {
    if (wing.chord > wing.span)
        reasons.add(windrow::detail::FieldPath{&path, "chord"}, " is ", wing.chord, " m: give at most the span, ", wing.span,
                    " m.");
}

Result<Mesh> wing(const Wing& settings) {
    if (const auto valid = windrow::detail::validate_settings(settings, "wing"); !valid)
        return valid.failure();

    const WingForm form(settings);
    Mesh mesh;
    mesh.has_uv = true;
    const auto columns = static_cast<std::uint32_t>(settings.columns) + 1, rows = static_cast<std::uint32_t>(settings.rows) + 1;
    for (const float side : {1.0f, -1.0f})
        for (std::uint32_t row = 0; row < rows; ++row)
            for (std::uint32_t column = 0; column < columns; ++column) {
                const glm::vec2 uv{static_cast<float>(column) / static_cast<float>(settings.columns),
                                   static_cast<float>(row) / static_cast<float>(settings.rows)};
                mesh.vertices.push_back({.position = form.at(uv.x, uv.y, side), .normal = glm::vec3(0.0f), .uv = uv});
            }
    // Both skins share the leading edge's places; strips close the other three.
    const std::uint32_t lower = rows * columns;
    for (std::uint32_t row = 0; row + 1 < rows; ++row)
        for (std::uint32_t column = 0; column + 1 < columns; ++column) {
            const std::uint32_t a = row * columns + column;
            add_cell(mesh, a, a + 1, a + columns + 1, a + columns);
            add_cell(mesh, lower + a, lower + a + columns, lower + a + columns + 1, lower + a + 1);
        }
    const auto strip = [&](std::uint32_t from, std::uint32_t to) { // of the upper skin
        add_cell(mesh, from, to, lower + to, lower + from);
    };
    for (std::uint32_t row = 0; row + 1 < rows; ++row) {
        const std::uint32_t root = row * columns, tip = root + columns - 1;
        strip(root, root + columns);
        strip(tip + columns, tip);
    }
    for (std::uint32_t column = 0; column + 1 < columns; ++column)
        strip((rows - 1) * columns + column, (rows - 1) * columns + column + 1);
    // Where the leading edge meets them, two corners of a strip's cell are one place.
    const std::vector<std::uint32_t> place = same_positions(mesh.vertices);
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const std::uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
        if (place[a] != place[b] && place[b] != place[c] && place[c] != place[a])
            kept.insert(kept.end(), {a, b, c});
    }
    mesh.indices = std::move(kept);
    if (settings.left) {
        for (MeshVertex& vertex : mesh.vertices)
            vertex.position.x = -vertex.position.x;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
            std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    }
    smooth_normals(mesh);
    finish(mesh, "wing");
    return mesh;
}

} // namespace windrow::vegetation::fur
