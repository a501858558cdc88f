#include "cases/reference/plain_query.h"

#include "fluid/core/ambient_numerics.h"
#include "fluid/core/numerics.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace windrow::reference {
namespace {

constexpr float k_never_fades = 1e30f;

bool finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

float kind_number(const Boundary& side) {
    return side.kind == BoundaryKind::open ? 0.0f : side.kind == BoundaryKind::periodic ? 2.0f : 1.0f;
}

numerics::TileView tile_of(const AmbientWind& wind) {
    return {wind.tile() ? wind.tile()->texels().data() : nullptr};
}

} // namespace

glm::vec3 plain_ambient(const AmbientWind& wind, glm::dvec3 position) {
    if (wind.uniform() || !finite(position))
        return wind.mean();
    return numerics::windrow_ambient(tile_of(wind), std::bit_cast<numerics::WindrowAmbient>(wind.block(position)),
                                     glm::vec3(0.0f));
}

glm::vec3 plain_felt(const AmbientWind& wind, glm::vec3 velocity, glm::dvec3 position, const Sampling& sampling) {
    if (!(sampling.detail > 0.0f) || !finite(position))
        return numerics::windrow_limited(velocity, sampling.strength, sampling.limit);
    return numerics::windrow_felt(tile_of(wind), std::bit_cast<numerics::WindrowAmbient>(wind.block(position, sampling)),
                                  velocity, glm::vec3(0.0f));
}

glm::vec3 plain_velocity(const WindView& view, glm::dvec3 position) {
    const Box& box = view.box();
    const BlendZone blend_zone = view.blend_zone();
    glm::dvec3 exact = view.window().local(position);
    if (!finite(exact))
        return view.ambient().mean();
    for (int axis = 0; axis < 3; ++axis)
        if (box.boundaries.periodic(axis))
            exact[axis] = std::fmod(exact[axis], static_cast<double>(box.cells[axis]));
    const glm::vec3 local(exact);
    float share = 1.0f;
    glm::ivec3 low(0), high(0);
    glm::vec3 between(0.0f);
    for (int axis = 0; axis < 3 && share > 0.0f; ++axis) {
        const auto cells = static_cast<float>(box.cells[axis]);
        const float low_kind = kind_number(box.boundaries.at(axis, 0)), high_kind = kind_number(box.boundaries.at(axis, 1));
        float from_low = local[axis], from_high = cells - local[axis];
        if (box.rows && axis == 1) {
            const double over = position.y - view.origin().y, h = static_cast<double>(box.cell_size);
            from_low = static_cast<float>(over / h);
            from_high = static_cast<float>((box.rows->top() - over) / h);
        }
        share *= numerics::windrow_edge_share(low_kind == 0.0f ? 1.0f + from_low : k_never_fades,
                                              high_kind == 0.0f ? 1.0f + from_high : k_never_fades, 0.0f);
        if (const float reach = blend_zone.reach[axis]; reach > 0.0f) {
            const auto from_point =
                static_cast<float>((position[axis] - blend_zone.point[axis]) / static_cast<double>(box.cell_size));
            share *= numerics::windrow_edge_share((reach + from_point) / blend_zone.width,
                                                  (reach - from_point) / blend_zone.width, 1.0f);
        }
        const float sample = numerics::windrow_axis_sample(local[axis], cells, low_kind) - 0.5f;
        const float below = std::floor(sample);
        between[axis] = sample - below;
        low[axis] = static_cast<int>(below);
        high[axis] = low[axis] + 1;
        if (low_kind == 2.0f) {
            low[axis] = (low[axis] + box.cells[axis]) % box.cells[axis];
            high[axis] = high[axis] % box.cells[axis];
        }
        low[axis] = std::clamp(low[axis], 0, box.cells[axis] - 1);
        high[axis] = std::clamp(high[axis], 0, box.cells[axis] - 1);
    }
    glm::vec3 ambient(0.0f);
    if (share != 1.0f)
        ambient = plain_ambient(view.ambient(), position);
    if (share <= 0.0f)
        return ambient;
    const auto cell = [&](int i, int j, int k) { return glm::vec3(view.field()[box.index(i, j, k)]); };
    const auto line = [&](int j, int k) { return glm::mix(cell(low.x, j, k), cell(high.x, j, k), between.x); };
    const auto plane = [&](int k) { return glm::mix(line(low.y, k), line(high.y, k), between.y); };
    const glm::vec3 inside = glm::mix(plane(low.z), plane(high.z), between.z);
    return share == 1.0f ? inside : glm::mix(ambient, inside, share);
}

} // namespace windrow::reference
