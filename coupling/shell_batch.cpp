// A layer of shells over a whole mesh (lanes.h). The blocks are cut the same way for any number of threads.
#include "coupling/lanes.h"
#include "coupling/shell.h"
#include "coupling/shell_numerics.h"

namespace windrow {
namespace {

using detail::k_lanes;
using detail::Lanes;
using detail::Lanes3;

Result<void> fits(const char* call, const Shells::Skin& skin, const char* what, std::size_t given, const char* result,
                  std::size_t out, float h = 0.0f) {
    detail::Reasons reasons;
    const detail::FieldPath path{nullptr, call};
    detail::check_value(reasons, {&path, "h"}, h, k_fraction_range);
    detail::check_size(reasons, {&path, "skin.normals"}, skin.normals.size(), skin.positions.size());
    detail::check_size(reasons, {&path, what}, given, skin.positions.size());
    detail::check_size(reasons, {&path, result}, out, skin.positions.size());
    return reasons.outcome();
}

struct SkinLanes {
    Lanes3 positions{}, normals{};
    Lanes map{};

    SkinLanes(const Shells::Skin& skin, std::size_t first, std::size_t count) {
        gather(positions, skin.positions.data() + first, count);
        gather(normals, skin.normals.data() + first, count);
        for (std::size_t i = 0; i < count; ++i)
            map.at[i] = skin.positions[first + i].w;
    }
};

WINDROW_LEVELS void load_lanes(Lanes3& loads, numerics::WindrowShells shells, const SkinLanes& skin, const Lanes3& winds) {
    const auto bend = [&](std::size_t i) {
        loads.set(i, numerics::windrow_shell_load(shells, skin.normals[i], skin.map.at[i], winds[i]));
    };
    if (shells.drag.load.y < 0.0f) { // a power has no vector instruction
        for (std::size_t i = 0; i < k_lanes; ++i)
            bend(i);
        return;
    }
    shells.drag.load.y = 0.0f;
    for (std::size_t i = 0; i < k_lanes; ++i)
        bend(i);
}

WINDROW_LEVELS void bend_lanes(Lanes3& out, numerics::WindrowShells shells, const SkinLanes& skin, float h, const Lanes3& loads) {
    for (std::size_t i = 0; i < k_lanes; ++i)
        out.set(i, numerics::windrow_shell_bent(shells, skin.positions[i], skin.normals[i], h, skin.map.at[i], loads[i]));
}

// Values of the translate form common to all shells of a layer.
struct Layer {
    float h, push;
    glm::vec3 droop;
};

WINDROW_LEVELS void push_lanes(Lanes3& out, numerics::WindrowShells shells, const SkinLanes& skin, Layer layer,
                               const Lanes3& directions) {
    for (std::size_t i = 0; i < k_lanes; ++i)
        out.set(i, numerics::windrow_shell_moved(skin.positions[i], skin.normals[i],
                                                 numerics::windrow_shell_distance(shells, layer.h, skin.map.at[i]),
                                                 directions[i] * layer.push, layer.droop));
}

} // namespace

Result<void> Shells::loads(const Skin& skin, std::span<const glm::vec4> winds, std::span<glm::vec4> loads,
                           const ParallelFor& parallel_for) const {
    if (auto outcome = fits("shells.loads", skin, "winds", winds.size(), "loads", loads.size()); !outcome)
        return outcome;
    const numerics::WindrowShells shells = detail::shared(block_);
    detail::for_blocks(loads.size(), parallel_for, [&](std::size_t first, std::size_t count) {
        const SkinLanes skin_lanes(skin, first, count);
        Lanes3 wind_lanes{}, out{};
        gather(wind_lanes, winds.data() + first, count);
        load_lanes(out, shells, skin_lanes, wind_lanes);
        scatter(loads.data() + first, out, 0.0f, count);
    });
    return {};
}

Result<void> Shells::bent(const Skin& skin, float h, std::span<const glm::vec4> loads, std::span<glm::vec4> out,
                          const ParallelFor& parallel_for) const {
    if (auto outcome = fits("shells.bent", skin, "loads", loads.size(), "out", out.size(), h); !outcome)
        return outcome;
    const numerics::WindrowShells shells = detail::shared(block_);
    detail::for_blocks(out.size(), parallel_for, [&](std::size_t first, std::size_t count) {
        const SkinLanes skin_lanes(skin, first, count);
        Lanes3 bends{}, moved{};
        gather(bends, loads.data() + first, count);
        bend_lanes(moved, shells, skin_lanes, h, bends);
        scatter(out.data() + first, moved, h, count);
    });
    return {};
}

Result<void> Shells::translated(const Skin& skin, float h, std::span<const glm::vec4> directions, std::span<glm::vec4> out,
                                const ParallelFor& parallel_for) const {
    if (auto outcome = fits("shells.translated", skin, "directions", directions.size(), "out", out.size(), h); !outcome)
        return outcome;
    const numerics::WindrowShells shells = detail::shared(block_);
    const Layer layer{h, shells.push.x * numerics::windrow_mask_power(h, shells.push.y),
                      numerics::windrow_shell_droop(shells, h)};
    detail::for_blocks(out.size(), parallel_for, [&](std::size_t first, std::size_t count) {
        const SkinLanes skin_lanes(skin, first, count);
        Lanes3 pushes{}, moved{};
        gather(pushes, directions.data() + first, count);
        push_lanes(moved, shells, skin_lanes, layer, pushes);
        scatter(out.data() + first, moved, h, count);
    });
    return {};
}

} // namespace windrow
