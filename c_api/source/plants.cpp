// Calls of plants.h.
#include "c_api/plants.h"

#include "c_api/source/plant_tables.h"
#include "coupling/plant_classes.h"
#include "fluid/core/message.h"

#include <array>

using namespace windrow;
using namespace windrow::c_api;

struct windrow_blades {
    Blades blades;
};
struct windrow_shells {
    Shells shells;
};
struct windrow_tree {
    Tree tree;
};

namespace {

constexpr std::array<Drag (*)(), 8> k_plants{grass, wheat, reed, leaf, twig, branch, small_trunk, large_trunk};

Shells::Skin skin_of(const windrow_skin& skin) {
    return {span_of<const glm::vec4>(skin.positions, skin.count), span_of<const glm::vec4>(skin.normals, skin.count)};
}
Error no_skin() {
    return Error{"skin has no positions or no normals: give an entry for each of its vertices."};
}
bool lacks_arrays(const windrow_skin& skin) {
    return skin.count > 0 && (skin.positions == nullptr || skin.normals == nullptr);
}

TreePart part_of(const windrow_tree_part* part) {
    return part != nullptr ? plain(*part) : TreePart{};
}

} // namespace

WINDROW_C_INIT(windrow_drag)
WINDROW_C_INIT(windrow_blade_settings)
WINDROW_C_INIT(windrow_shell_settings)
WINDROW_C_INIT(windrow_tree_classes)

// --- Drag --------------------------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_result windrow_drag_of(windrow_plant plant, windrow_drag* drag) {
    return call({{drag, "drag"}}, [&]() -> windrow_result {
        if (plant < 0 || plant >= static_cast<int>(k_plants.size()))
            return fail(WINDROW_REJECTED, detail::message("plant is ", plant, ": give 0 to ", k_plants.size() - 1, "."));
        if (const windrow_result outcome = check_output(drag); outcome != WINDROW_OK)
            return outcome;
        give_cpp(k_plants[static_cast<std::size_t>(plant)](), drag);
        return WINDROW_OK;
    });
}
WINDROW_EXPORT windrow_result windrow_drag_validate(const windrow_drag* drag) {
    return call({{drag, "drag"}}, [&] { return with(drag, [](const Drag& wanted) { return validate(wanted); }); });
}

namespace {
/// Runs use(drag) on valid properties.
template <class Use>
windrow_result with_drag(const windrow_drag* drag, const void* out, const Use& use) {
    return call({{drag, "drag"}, {out, "the result"}}, [&] {
        return with(drag, [&](const Drag& wanted) {
            const Result<void> valid = validate(wanted);
            if (valid)
                use(wanted);
            return valid;
        });
    });
}
} // namespace

WINDROW_EXPORT windrow_result windrow_drag_block_of(const windrow_drag* drag, windrow_drag_block* block) {
    return with_drag(drag, block, [&](const Drag& wanted) { copy_block(windrow::block(wanted), block); });
}
WINDROW_EXPORT windrow_result windrow_cauchy_number(const windrow_drag* drag, double speed, double* number) {
    return with_drag(drag, number, [&](const Drag& wanted) { *number = cauchy_number(wanted, speed); });
}
WINDROW_EXPORT windrow_result windrow_bend_angle(const windrow_drag* drag, float speed, float* angle) {
    return with_drag(drag, angle, [&](const Drag& wanted) { *angle = bend_angle(wanted, speed); });
}
WINDROW_EXPORT float windrow_rectangle_rigidity(float young, float width, float thickness) {
    return rectangle_rigidity(young, width, thickness);
}
WINDROW_EXPORT float windrow_folded_rigidity(float young, float width, float thickness, float depth) {
    return folded_rigidity(young, width, thickness, depth);
}
WINDROW_EXPORT float windrow_rod_rigidity(float young, float diameter) {
    return rod_rigidity(young, diameter);
}
WINDROW_EXPORT float windrow_tube_rigidity(float young, float outer_diameter, float inner_diameter) {
    return tube_rigidity(young, outer_diameter, inner_diameter);
}

WINDROW_EXPORT windrow_plant_key windrow_place_key(float x, float z) {
    const PlantKey key = place_key(x, z);
    return {key.x, key.y};
}
WINDROW_EXPORT float windrow_plant_yaw(windrow_plant_key key) {
    return plant_yaw(to_cpp(key));
}
WINDROW_EXPORT float windrow_plant_stiffness(windrow_plant_key key, float spread) {
    return plant_stiffness(to_cpp(key), spread);
}

// --- Blades --------------------------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_result windrow_blades_create(const windrow_blade_settings* settings, windrow_blades** blades) {
    return create_from(settings, blades, [](const BladeSettings& wanted) { return Blades::create(wanted); });
}
WINDROW_EXPORT void windrow_blades_destroy(windrow_blades* blades) {
    delete blades;
}
WINDROW_EXPORT windrow_result windrow_blades_block(const windrow_blades* blades, windrow_blade_block* block) {
    return call({{blades, "blades"}, {block, "block"}}, [&]() -> windrow_result {
        copy_block(blades->blades.block(), block);
        return WINDROW_OK;
    });
}
WINDROW_EXPORT float windrow_blades_length(const windrow_blades* blades, windrow_plant_key key) {
    return value_of(blades, "blades", [&] { return blades->blades.length(to_cpp(key)); });
}
WINDROW_EXPORT windrow_vec3 windrow_blades_load(const windrow_blades* blades, windrow_plant_key key, windrow_vec3 wind) {
    return value_of(blades, "blades", [&] { return to_c(blades->blades.load(to_cpp(key), to_cpp(wind))); });
}
WINDROW_EXPORT windrow_result windrow_blades_vertex(const windrow_blades* blades, windrow_plant_key key, windrow_vec3 load,
                                                    float h, float side, windrow_vec3 view, windrow_plant_vertex* vertex) {
    return call({{blades, "blades"}, {vertex, "vertex"}}, [&]() -> windrow_result {
        *vertex = plain_c<windrow_plant_vertex>(blades->blades.vertex(to_cpp(key), to_cpp(load), h, side, to_cpp(view)));
        return WINDROW_OK;
    });
}
WINDROW_EXPORT windrow_result windrow_blades_loads(const windrow_blades* blades, uint64_t count, const windrow_plant_key* keys,
                                                   const windrow_vec4* winds, windrow_vec4* loads,
                                                   const windrow_parallel_for* parallel_for) {
    return call({{blades, "blades"}, {keys, "keys"}, {winds, "winds"}, {loads, "loads"}}, [&] {
        return blades->blades.loads(span_of<const PlantKey>(keys, count), span_of<const glm::vec4>(winds, count),
                                    span_of<glm::vec4>(loads, count), loop_of(parallel_for));
    });
}
WINDROW_EXPORT windrow_result windrow_blades_vertices(const windrow_blades* blades, uint64_t count, const windrow_plant_key* keys,
                                                      const windrow_vec4* roots, const windrow_vec4* loads, uint64_t rows,
                                                      const float* heights, windrow_vec3 view, windrow_vec4* positions,
                                                      windrow_vec4* normals, const windrow_parallel_for* parallel_for) {
    return call(
        {{blades, "blades"}, {keys, "keys"}, {roots, "roots"}, {loads, "loads"}, {heights, "heights"}, {positions, "positions"}},
        [&]() -> Result<void> {
            if (rows > 65536 || count > (std::uint64_t{1} << 40)) // so that the product below is no other number
                return Error{detail::message("rows is ", rows, " for ", count, " blades: give at most 65536 rows.")};
            const std::uint64_t vertices = count * rows * 2;
            return blades->blades.vertices(span_of<const PlantKey>(keys, count), span_of<const glm::vec4>(roots, count),
                                           span_of<const glm::vec4>(loads, count), span_of<const float>(heights, rows),
                                           {span_of<glm::vec4>(positions, vertices), span_of<glm::vec4>(normals, vertices)},
                                           to_cpp(view), loop_of(parallel_for));
        });
}

// --- Shells --------------------------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_result windrow_shells_create(const windrow_shell_settings* settings, windrow_shells** shells) {
    return create_from(settings, shells, [](const ShellSettings& wanted) { return Shells::create(wanted); });
}
WINDROW_EXPORT void windrow_shells_destroy(windrow_shells* shells) {
    delete shells;
}
WINDROW_EXPORT windrow_result windrow_shells_block(const windrow_shells* shells, windrow_shell_block* block) {
    return call({{shells, "shells"}, {block, "block"}}, [&]() -> windrow_result {
        copy_block(shells->shells.block(), block);
        return WINDROW_OK;
    });
}
WINDROW_EXPORT float windrow_shells_height(const windrow_shells* shells, int32_t shell) {
    return value_of(shells, "shells", [&] { return shells->shells.height(shell); });
}
WINDROW_EXPORT windrow_vec3 windrow_shells_load(const windrow_shells* shells, windrow_vec3 normal, float map, windrow_vec3 wind) {
    return value_of(shells, "shells", [&] { return to_c(shells->shells.load(to_cpp(normal), map, to_cpp(wind))); });
}
WINDROW_EXPORT windrow_vec3 windrow_shells_bent(const windrow_shells* shells, windrow_vec3 position, windrow_vec3 normal, float h,
                                                float map, windrow_vec3 load) {
    return value_of(shells, "shells",
                    [&] { return to_c(shells->shells.bent(to_cpp(position), to_cpp(normal), h, map, to_cpp(load))); });
}
WINDROW_EXPORT windrow_vec3 windrow_shells_translated(const windrow_shells* shells, windrow_vec3 position, windrow_vec3 normal,
                                                      float h, float map, windrow_vec3 direction) {
    return value_of(shells, "shells",
                    [&] { return to_c(shells->shells.translated(to_cpp(position), to_cpp(normal), h, map, to_cpp(direction))); });
}

namespace {
/// Runs use(skin, in, out) on a mesh and two arrays of an entry a vertex.
template <class Use>
windrow_result with_skin(const windrow_shells* shells, const windrow_skin* skin, const windrow_vec4* in, windrow_vec4* out,
                         const Use& use) {
    return call({{shells, "shells"}, {skin, "skin"}, {in, "the input"}, {out, "the output"}}, [&]() -> Result<void> {
        if (lacks_arrays(*skin))
            return no_skin();
        return use(skin_of(*skin), span_of<const glm::vec4>(in, skin->count), span_of<glm::vec4>(out, skin->count));
    });
}
} // namespace

WINDROW_EXPORT windrow_result windrow_shells_loads_many(const windrow_shells* shells, const windrow_skin* skin,
                                                        const windrow_vec4* winds, windrow_vec4* loads,
                                                        const windrow_parallel_for* parallel_for) {
    return with_skin(shells, skin, winds, loads, [&](const auto& mesh, auto in, auto out) {
        return shells->shells.loads(mesh, in, out, loop_of(parallel_for));
    });
}
WINDROW_EXPORT windrow_result windrow_shells_bent_many(const windrow_shells* shells, const windrow_skin* skin, float h,
                                                       const windrow_vec4* loads, windrow_vec4* positions,
                                                       const windrow_parallel_for* parallel_for) {
    return with_skin(shells, skin, loads, positions, [&](const auto& mesh, auto in, auto out) {
        return shells->shells.bent(mesh, h, in, out, loop_of(parallel_for));
    });
}
WINDROW_EXPORT windrow_result windrow_shells_translated_many(const windrow_shells* shells, const windrow_skin* skin, float h,
                                                             const windrow_vec4* directions, windrow_vec4* positions,
                                                             const windrow_parallel_for* parallel_for) {
    return with_skin(shells, skin, directions, positions, [&](const auto& mesh, auto in, auto out) {
        return shells->shells.translated(mesh, h, in, out, loop_of(parallel_for));
    });
}

// --- Trees ---------------------------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_result windrow_tree_create(const windrow_tree_classes* classes, windrow_tree** tree) {
    return create_from(classes, tree, [](const TreeClasses& wanted) { return Tree::create(wanted); });
}
WINDROW_EXPORT void windrow_tree_destroy(windrow_tree* tree) {
    delete tree;
}
WINDROW_EXPORT windrow_result windrow_tree_block_of(const windrow_tree* tree, windrow_tree_block* block) {
    return call({{tree, "tree"}, {block, "block"}}, [&]() -> windrow_result {
        copy_block(tree->tree.block(), block);
        return WINDROW_OK;
    });
}
WINDROW_EXPORT windrow_result windrow_tree_vertex(const windrow_tree* tree, const windrow_tree_part* trunk,
                                                  const windrow_tree_part* branch, const windrow_tree_part* leaf,
                                                  windrow_vec3 wind, const windrow_plant_vertex* rest,
                                                  windrow_plant_vertex* bent) {
    return call({{tree, "tree"}, {rest, "rest"}, {bent, "bent"}}, [&]() -> Result<void> {
        const TreeBearers bearers{part_of(trunk), part_of(branch), part_of(leaf)};
        for (const TreePart* part : {&bearers.trunk, &bearers.branch, &bearers.leaf})
            if (part->stiffness != 0.0f)
                if (Result<void> valid = validate(*part); !valid)
                    return valid;
        *bent = plain_c<windrow_plant_vertex>(tree->tree.vertex(bearers, to_cpp(wind), plain(*rest)));
        return {};
    });
}
WINDROW_EXPORT windrow_result windrow_tree_vertices(const windrow_tree* tree, uint64_t part_count, const windrow_tree_part* parts,
                                                    const windrow_vec4* winds, uint64_t count, const windrow_vec4* rest_positions,
                                                    const windrow_vec4* rest_normals, const windrow_tree_bearers* bearers,
                                                    windrow_vec4* positions, windrow_vec4* normals,
                                                    const windrow_parallel_for* parallel_for) {
    return call({{tree, "tree"},
                 {parts, "parts"},
                 {winds, "winds"},
                 {rest_positions, "rest_positions"},
                 {rest_normals, "rest_normals"},
                 {bearers, "bearers"},
                 {positions, "positions"},
                 {normals, "normals"}},
                [&] {
                    return tree->tree.vertices(
                        span_of<const TreePart>(parts, part_count), span_of<const glm::vec4>(winds, part_count),
                        {span_of<const glm::vec4>(rest_positions, count), span_of<const glm::vec4>(rest_normals, count),
                         span_of<const Tree::PartIndices>(bearers, count)},
                        span_of<glm::vec4>(positions, count), span_of<glm::vec4>(normals, count), loop_of(parallel_for));
                });
}
