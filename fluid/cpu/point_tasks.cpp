#include "fluid/cpu/point_tasks.h"

#include "fluid/gust_tile.h"
#include "fluid/setting.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace windrow::cpu {
namespace {

static_assert(k_tile_side == GustTile::k_side && k_tile_height == GustTile::k_height);

namespace text {
#include "fluid/cpu/kernels/wrap.inl"
}

void copy(glm::vec3 from, float (&to)[4]) {
    for (int axis = 0; axis < 3; ++axis)
        to[axis] = from[axis];
    to[3] = 0.0f;
}

const float* texels(const AmbientWind& wind) {
    return wind.tile() ? &wind.tile()->texels().data()->x : nullptr;
}

} // namespace

Period period_of(double whole) {
    return text::period_of(whole);
}

TileAxis tile_axis(const AmbientWind& wind, int axis, int repeats) {
    const int texels = axis == 1 ? 2 * k_tile_height : k_tile_side;
    const double texel = static_cast<double>(wind.settings().gusts.length) / GustTile::k_gust_texels;
    return {.origin = axis == 1 ? wind.ground() : 0.0,
            .phase = wind.phase()[axis],
            .texel = texel,
            .repeats = static_cast<double>(repeats),
            .period = period_of(texels * texel),
            .texels = period_of(texels)};
}

AmbientWind::TilePlace tile_place(const TileAxis& axis, double coordinate) {
    const text::TilePlace place = text::place_of_wrapped(axis, text::wrapped(coordinate - axis.origin, axis.period));
    return {static_cast<int>(place.texel), static_cast<float>(place.fraction)};
}

int detail_repeats(const AmbientWind& wind, const Sampling& sampling) {
    const double fit =
        std::round(static_cast<double>(wind.settings().gusts.length) / static_cast<double>(sampling.detail_length));
    return fit >= 1.0 ? static_cast<int>(std::min(fit, 1e9)) : 1; // NaN too
}

void set_ambient(AmbientTask& task, const AmbientWind& wind) {
    const AmbientWind::Settings& settings = wind.settings();
    copy(settings.mean, task.mean);
    task.roughness_length = task.gust_strength = 0.0f;
    if (settings.profile) {
        task.roughness_length = settings.profile->roughness_length;
        task.reference_height = settings.profile->reference_height;
        task.ground = settings.ground;
        task.lowest = k_world_range.min;
        task.highest = k_world_range.max;
    }
    if (settings.gusts.intensity == 0.0f || !wind.tile())
        return;
    task.gust_strength = wind.gust_strength();
    copy(wind.gust_axes(), task.gust_axes);
    task.tile = texels(wind);
    for (int axis = 0; axis < 3; ++axis)
        task.gusts[axis] = tile_axis(wind, axis, 1);
}

Sampling usable(Sampling sampling) {
    for_each_setting(sampling, [](const auto& field, float& value) {
        if (!field.range.holds(value))
            value = Sampling{}.*field.member;
    });
    return sampling;
}

FeltTask felt_task(const AmbientWind& wind, const Sampling& asked) {
    const Sampling sampling = usable(asked);
    FeltTask task;
    task.detail_amount = 0.0f;
    task.strength = sampling.strength;
    task.limit = sampling.limit;
    if (!(sampling.detail > 0.0f) || !wind.tile())
        return task;
    task.detail_amount = sampling.detail;
    task.longest = wind.tile()->bound();
    task.tile = texels(wind);
    const int repeats = detail_repeats(wind, sampling);
    for (int axis = 0; axis < 3; ++axis)
        task.detail[axis] = tile_axis(wind, axis, repeats);
    return task;
}

} // namespace windrow::cpu
