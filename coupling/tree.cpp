#include "coupling/tree.h"

#include "coupling/lanes.h"
#include "coupling/plant_numerics.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace windrow {
namespace {

constexpr std::size_t k_block = 256; // vertices a task

numerics::WindrowTree shared(const TreeBlock& block) {
    return {{block.trunk.load}, {block.branch.load}, {block.leaf.load}};
}

numerics::WindrowPart shared(const TreePart& part) {
    return {part.root, part.axis, part.length, part.stiffness};
}

// A part of a list, with its wind.
struct Part {
    numerics::WindrowPart part{};
    glm::vec3 wind{0.0f};
};

// The first vertex whose bearers name a part beyond the list.
Result<void> known(std::span<const Tree::PartIndices> bearers, std::size_t parts) {
    for (std::size_t n = 0; n < bearers.size(); ++n) {
        const std::pair<const char*, std::uint32_t> named[] = {
            {"trunk", bearers[n].trunk}, {"branch", bearers[n].branch}, {"leaf", bearers[n].leaf}};
        for (const auto& [role, index] : named)
            if (index != Tree::PartIndices::k_none && index >= parts)
                return Error{detail::message("tree.vertices.mesh.bearers[", n, "].", role, " is ", index, ", of a list of ",
                                             parts, " parts: give an index below ", parts, ", or k_none.")};
    }
    return {};
}

} // namespace

Result<void> validate(const TreeClasses& settings) {
    return detail::validate_settings(settings, "tree");
}

Result<void> validate(const TreePart& part, const char* name) {
    if (part.stiffness == 0.0f)
        return {}; // there is no such part
    return detail::validate_settings(part, name);
}

Result<Tree> Tree::create(const TreeClasses& settings) {
    if (auto valid = validate(settings); !valid)
        return valid.failure();
    return Tree(settings);
}

Tree::Tree(const TreeClasses& settings) : settings_(settings) {
    block_ = {windrow::block(settings.trunk), windrow::block(settings.branch), windrow::block(settings.leaf)};
}

PlantVertex Tree::vertex(const TreeBearers& bearers, glm::vec3 wind, const PlantVertex& rest) const {
    const auto bent = [&](glm::vec3 direction) {
        return numerics::windrow_tree_vertex(shared(block_), shared(bearers.trunk), shared(bearers.branch), shared(bearers.leaf),
                                             wind, {rest.position, direction});
    };
    const numerics::WindrowTreeVertex vertex = bent(rest.normal);
    return {vertex.position, vertex.normal, bent(rest.tangent).normal};
}

Result<void> Tree::vertices(std::span<const TreePart> parts, std::span<const glm::vec4> winds, const RestMesh& mesh,
                            std::span<glm::vec4> positions, std::span<glm::vec4> normals, const ParallelFor& parallel_for) const {
    detail::Reasons reasons;
    const std::size_t count = mesh.positions.size();
    detail::check_size(reasons, {nullptr, "tree.vertices.winds"}, winds.size(), parts.size());
    detail::check_size(reasons, {nullptr, "tree.vertices.mesh.normals"}, mesh.normals.size(), count);
    detail::check_size(reasons, {nullptr, "tree.vertices.mesh.bearers"}, mesh.bearers.size(), count);
    detail::check_size(reasons, {nullptr, "tree.vertices.positions"}, positions.size(), count);
    detail::check_size(reasons, {nullptr, "tree.vertices.normals"}, normals.size(), count);
    for (std::size_t n = 0; n < parts.size(); ++n)
        if (!validate(parts[n]))
            reasons.add_all_of(validate(parts[n], detail::message("tree.vertices.parts[", n, "]").c_str()));
    reasons.add_all_of(known(mesh.bearers, parts.size()));
    if (!reasons.empty())
        return reasons.outcome();

    const numerics::WindrowTree tree = shared(block_);
    const auto at = [&](std::uint32_t index) {
        return index == PartIndices::k_none ? Part{} : Part{shared(parts[index]), glm::vec3(winds[index])};
    };
    parallel_for(static_cast<int>((count + k_block - 1) / k_block), [&](int block) {
        const std::size_t first = static_cast<std::size_t>(block) * k_block;
        for (std::size_t i = first; i < std::min(first + k_block, count); ++i) {
            const Part trunk = at(mesh.bearers[i].trunk), branch = at(mesh.bearers[i].branch), leaf = at(mesh.bearers[i].leaf);
            const numerics::WindrowTreeLoads loads =
                numerics::windrow_tree_loads(tree, trunk.part, branch.part, leaf.part, trunk.wind, branch.wind, leaf.wind);
            const numerics::WindrowTreeVertex vertex = numerics::windrow_tree_bent(
                tree, trunk.part, branch.part, leaf.part, loads, {glm::vec3(mesh.positions[i]), glm::vec3(mesh.normals[i])});
            positions[i] = glm::vec4(vertex.position, 1.0f);
            normals[i] = glm::vec4(vertex.normal, 0.0f);
        }
    });
    return {};
}

} // namespace windrow
