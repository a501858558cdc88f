#include "coupling/tree.h"

#include "coupling/checks.h"
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

// A part of a list, with the wind that it feels.
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

Result<void> validate(const TreeSettings& settings) {
    detail::Checks checks("tree");
    checks.add(validate(settings.trunk, "tree.trunk"));
    checks.add(validate(settings.branch, "tree.branch"));
    checks.add(validate(settings.leaf, "tree.leaf"));
    return checks.outcome();
}

Result<void> validate(const TreePart& part, const char* name) {
    detail::Checks checks(name);
    if (part.stiffness == 0.0f)
        return checks.outcome(); // there is no such part
    for (int axis = 0; axis < 3; ++axis)
        checks.between(".root", part.root[axis], -1e6f, 1e6f, "m");
    const float length = glm::length(part.axis);
    if (!(std::abs(length - 1.0f) <= 1e-3f))
        checks.between(".axis has a length that", length, 0.999f, 1.001f, "");
    checks.between(".length", part.length, 1e-4f, 200.0f, "m");
    checks.between(".stiffness", part.stiffness, 1e-6f, 1e6f, "");
    return checks.outcome();
}

Result<Tree> Tree::create(const TreeSettings& settings) {
    if (auto valid = validate(settings); !valid)
        return Error{valid.error()};
    return Tree(settings);
}

Tree::Tree(const TreeSettings& settings) : settings_(settings) {
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

Result<void> Tree::vertices(std::span<const TreePart> parts, std::span<const glm::vec4> winds, const Mesh& mesh,
                            std::span<glm::vec4> positions, std::span<glm::vec4> normals, const ParallelFor& parallel_for) const {
    detail::Checks checks("tree.vertices");
    const std::size_t count = mesh.positions.size();
    checks.same_size(".winds", winds.size(), parts.size());
    checks.same_size(".mesh.normals", mesh.normals.size(), count);
    checks.same_size(".mesh.bearers", mesh.bearers.size(), count);
    checks.same_size(".positions", positions.size(), count);
    checks.same_size(".normals", normals.size(), count);
    for (std::size_t n = 0; n < parts.size(); ++n)
        if (!validate(parts[n]))
            checks.add(validate(parts[n], detail::message("tree.vertices.parts[", n, "]").c_str()));
    checks.add(known(mesh.bearers, parts.size()));
    if (auto outcome = checks.outcome(); !outcome)
        return outcome;

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
