// Batches of blades (lanes.h). The blocks are cut the same way for any number of threads.
#include "coupling/blade.h"
#include "coupling/blade_numerics.h"
#include "coupling/lanes.h"

namespace windrow {
namespace {

using detail::k_lanes;
using detail::k_up;
using detail::Lanes;
using detail::Lanes3;

struct KeyLanes {
    std::uint32_t x[k_lanes], y[k_lanes];

    [[nodiscard]] PlantKey operator[](std::size_t i) const { return {x[i], y[i]}; }
};

void gather(KeyLanes& lanes, const PlantKey* keys, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        lanes.x[i] = keys[i].x;
        lanes.y[i] = keys[i].y;
    }
}

// An upright blade: the fields of a WindrowBladePlant that are not the class's.
struct PlantLanes {
    Lanes facing_x, facing_z, twist, load_x, load_z, own_x, own_z, reach, sharpness;
};

// Classes are passed by value: the outputs cannot alias them.
WINDROW_LEVELS void load_lanes(Lanes3& loads, numerics::WindrowBlade blade, const KeyLanes& keys, const Lanes3& winds) {
    const auto bend = [&](std::size_t i) {
        loads.set(i, numerics::windrow_blade_load(blade, k_up, numerics::windrow_plant_hash(keys[i]), winds[i]));
    };
    if (blade.drag.load.y < 0.0f) { // a power has no vector instruction
        for (std::size_t i = 0; i < k_lanes; ++i)
            bend(i);
        return;
    }
    blade.drag.load.y = 0.0f;
    for (std::size_t i = 0; i < k_lanes; ++i)
        bend(i);
}

WINDROW_LEVELS void plant_lanes(PlantLanes& plants, numerics::WindrowBlade blade, const KeyLanes& keys, const Lanes3& loads,
                                glm::vec3 view) {
    for (std::size_t i = 0; i < k_lanes; ++i) {
        const numerics::WindrowBladePlant plant =
            numerics::windrow_blade_plant(blade, k_up, numerics::windrow_plant_hash(keys[i]), loads[i], view);
        plants.facing_x.at[i] = plant.facing.x;
        plants.facing_z.at[i] = plant.facing.z;
        plants.twist.at[i] = plant.twist;
        plants.load_x.at[i] = plant.stem.load.x;
        plants.load_z.at[i] = plant.stem.load.z;
        plants.own_x.at[i] = plant.stem.own.x;
        plants.own_z.at[i] = plant.stem.own.z;
        plants.reach.at[i] = plant.stem.reach;
        plants.sharpness.at[i] = plant.stem.sharpness;
    }
}

// Both vertices of a row of each blade, and their common normal.
struct RowLanes {
    Lanes3 left, right, normal;
};

WINDROW_LEVELS void row_lanes(RowLanes& row, const PlantLanes& plants, float curve, float h, float half_width) {
    for (std::size_t i = 0; i < k_lanes; ++i) {
        numerics::WindrowBladePlant plant;
        plant.facing = {plants.facing_x.at[i], 0.0f, plants.facing_z.at[i]};
        plant.width = glm::cross(k_up, plant.facing);
        plant.twist = plants.twist.at[i];
        plant.stem.axis = k_up;
        plant.stem.reach = plants.reach.at[i];
        plant.stem.load = {plants.load_x.at[i], 0.0f, plants.load_z.at[i]};
        plant.stem.sharpness = plants.sharpness.at[i];
        plant.stem.own = {plants.own_x.at[i], 0.0f, plants.own_z.at[i]};
        plant.stem.curve = curve;
        const numerics::WindrowVertex left = numerics::windrow_blade_point(plant, h, -half_width);
        row.left.set(i, left.position);
        row.right.set(i, numerics::windrow_blade_point(plant, h, half_width).position);
        row.normal.set(i, left.normal);
    }
}

} // namespace

Result<void> Blades::loads(std::span<const PlantKey> keys, std::span<const glm::vec4> winds, std::span<glm::vec4> loads,
                           const ParallelFor& parallel_for) const {
    detail::Reasons reasons;
    detail::check_size(reasons, {nullptr, "blades.loads.winds"}, winds.size(), keys.size());
    detail::check_size(reasons, {nullptr, "blades.loads.loads"}, loads.size(), keys.size());
    if (!reasons.empty())
        return reasons.outcome();
    const numerics::WindrowBlade blade = detail::shared(block_);
    detail::for_blocks(keys.size(), parallel_for, [&](std::size_t first, std::size_t count) {
        KeyLanes key_lanes{};
        Lanes3 wind_lanes{}, out{};
        gather(key_lanes, keys.data() + first, count);
        gather(wind_lanes, winds.data() + first, count);
        load_lanes(out, blade, key_lanes, wind_lanes);
        scatter(loads.data() + first, out, 0.0f, count);
    });
    return {};
}

Result<void> Blades::vertices(std::span<const PlantKey> keys, std::span<const glm::vec4> roots, std::span<const glm::vec4> loads,
                              std::span<const float> heights, const Vertices& out, glm::vec3 view,
                              const ParallelFor& parallel_for) const {
    detail::Reasons reasons;
    const std::size_t rows = heights.size();
    detail::check_size(reasons, {nullptr, "blades.vertices.roots"}, roots.size(), keys.size());
    detail::check_size(reasons, {nullptr, "blades.vertices.loads"}, loads.size(), keys.size());
    detail::check_size(reasons, {nullptr, "blades.vertices.out.positions"}, out.positions.size(), 2 * rows * keys.size());
    if (!out.normals.empty())
        detail::check_size(reasons, {nullptr, "blades.vertices.out.normals"}, out.normals.size(), 2 * rows * keys.size());
    for (const float h : heights)
        detail::check_value(reasons, {nullptr, "blades.vertices.heights"}, h, k_fraction_range);
    if (!reasons.empty())
        return reasons.outcome();

    const numerics::WindrowBlade blade = detail::shared(block_);
    detail::for_blocks(keys.size(), parallel_for, [&](std::size_t first, std::size_t count) {
        KeyLanes key_lanes{};
        Lanes3 bends{};
        PlantLanes plants;
        gather(key_lanes, keys.data() + first, count);
        gather(bends, loads.data() + first, count);
        plant_lanes(plants, blade, key_lanes, bends, view);
        for (std::size_t r = 0; r < rows; ++r) {
            RowLanes row;
            row_lanes(row, plants, blade.form.w, heights[r], numerics::windrow_blade_half_width(blade, heights[r]));
            for (std::size_t i = 0; i < count; ++i) {
                const std::size_t at = 2 * ((first + i) * rows + r);
                const glm::vec3 root{roots[first + i]};
                out.positions[at] = glm::vec4(root + row.left[i], heights[r]);
                out.positions[at + 1] = glm::vec4(root + row.right[i], heights[r]);
                if (!out.normals.empty())
                    out.normals[at] = out.normals[at + 1] = glm::vec4(row.normal[i], 0.0f);
            }
        }
    });
    return {};
}

} // namespace windrow
