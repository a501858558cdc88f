// Trees on the CPU: trunk, branch and leaf, each bent as a blade is. The equations are in shaders/numerics/tree.glsl.
//
//     auto oak = windrow::Tree::create({});
//     windrow::TreePart trunk{.length = 8.0f, .stiffness = 1.0f};
//     windrow::TreePart bough{.root = {0, 5, 0}, .axis = {1, 0, 0}, .length = 2.5f, .stiffness = 1.0f};
//     windrow::PlantVertex bark = oak->vertex({trunk, bough, {}}, wind, {.position = {2.4f, 5.1f, 0.0f}}); // {}: on no leaf
#pragma once

#include "../fluid/api.h"
#include "../fluid/parallel.h"
#include "../fluid/result.h"
#include "drag.h"
#include "plant_classes.h"
#include "plant_vertex.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

namespace windrow {

/// Classes of a tree's parts. Defaults: a small tree in leaf; plant_classes.h has the sources of the figures.
struct TreeClasses {
    /// The trunk.
    Drag trunk = small_trunk();
    /// Each branch.
    Drag branch = windrow::branch();
    /// Each leaf.
    Drag leaf = windrow::leaf();

    static constexpr auto settings() {
        return std::tuple{
            Setting("trunk", &TreeClasses::trunk, "The trunk."),
            Setting("branch", &TreeClasses::branch, "Each branch."),
            Setting("leaf", &TreeClasses::leaf, "Each leaf."),
        };
    }
};

/// Shader block: WindrowTree of shaders/numerics/tree.glsl, a std140 block of three vec4.
struct TreeBlock {
    DragBlock trunk{}, branch{}, leaf{};
};
static_assert(sizeof(TreeBlock) == 48);

/// A straight part of a tree at rest, relative to the trunk's base. The default is no part, here and in lists alike.
struct TreePart {
    /// [m] Each component -1e6 to 1e6, default (0, 0, 0). Point at which it is held: on its bearer's axis, or beside it on the
    /// bark.
    glm::vec3 root{0.0f};
    /// A length of 0.999 to 1.001, default (0, 1, 0). Unit vector along it.
    glm::vec3 axis{0.0f, 1.0f, 0.0f};
    /// [m] 1e-4 to 200, default 1. The class's stiffness does not depend on it: a short part needs a higher `stiffness`.
    float length = 1.0f;
    /// 1e-6 to 1e6, default 0. Factor on the class's stiffness: 1 is the class's own. 0, outside of the range, is for a part that
    /// does not exist.
    float stiffness = 0.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("root", &TreePart::root, {-1e6, 1e6, "m"},
                    "Point at which it is held: on its bearer's axis, or beside it on the bark."),
            Setting("axis", &TreePart::axis, Range::length(0.999, 1.001, ""), "Unit vector along it."),
            Setting("length", &TreePart::length, {1e-4, 200.0, "m"},
                    "The class's stiffness does not depend on it: a short part needs a higher `stiffness`."),
            Setting("stiffness", &TreePart::stiffness, {1e-6, 1e6},
                    "Factor on the class's stiffness: 1 is the class's own. 0, outside of the range, is for a part that does not "
                    "exist."),
        };
    }
};

/// Bearers of a vertex: the last existing one bends by the vertex's own height, those before it carry it as a rigid body.
struct TreeBearers {
    TreePart trunk{}, branch{}, leaf{};
};

[[nodiscard]] WINDROW_API Result<void> validate(const TreeClasses& settings);
[[nodiscard]] WINDROW_API Result<void> validate(const TreePart& part, const char* name = "part");

class WINDROW_API Tree {
  public:
    /// Rejects what `validate` rejects, with every reason.
    [[nodiscard]] static Result<Tree> create(const TreeClasses& settings);

    [[nodiscard]] const TreeClasses& settings() const { return settings_; }
    [[nodiscard]] const TreeBlock& block() const { return block_; }

    /// A vertex of the tree at rest, its normal and tangent, in a wind [m/s]; positions relative to the trunk's base. Bearers
    /// must be valid.
    [[nodiscard]] PlantVertex vertex(const TreeBearers& bearers, glm::vec3 wind, const PlantVertex& rest) const;

    /// Indices of the parts that bear a vertex. Default k_none: no part, as an entry of stiffness 0 is.
    struct PartIndices {
        static constexpr std::uint32_t k_none = 0xffffffffu;
        std::uint32_t trunk = k_none, branch = k_none, leaf = k_none;
    };
    /// A tree's vertices. Spans of vertices have one entry each; `winds` [m/s] one a part, so that each feels its own. Rejects
    /// sizes that do not fit, parts that are not valid and indices beyond the list, by their number, and touches nothing then.
    struct RestMesh {
        std::span<const glm::vec4> positions; ///< xyz [m] from the trunk's base
        std::span<const glm::vec4> normals;   ///< xyz unit vectors
        std::span<const PartIndices> bearers;
    };
    Result<void> vertices(std::span<const TreePart> parts, std::span<const glm::vec4> winds, const RestMesh& mesh,
                          std::span<glm::vec4> positions, std::span<glm::vec4> normals,
                          const ParallelFor& parallel_for = {}) const;

  private:
    explicit Tree(const TreeClasses& settings);

    TreeClasses settings_;
    TreeBlock block_;
};

} // namespace windrow
