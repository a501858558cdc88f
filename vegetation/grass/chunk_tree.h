// Quadtree over the chunks of a field, for culling. Its nodes hold where grass is and the height range of the ground.
//
//   level 0     chunks; a node of level n has the four of level n - 1 below it; the highest level is one node
//   a node      [m] lowest and highest ground, for what of it has grass; nothing where nothing grows
//
// A walk goes from the highest node down and leaves a node out whose box, widened by a blade's reach, is beyond a plane or the
// distance. Only chunks are ever drawn, so each blade place is drawn once or not at all.
#pragma once

#include "../../fluid/shapes/height_map.h"
#include "grass_settings.h"
#include "grass_view.h"
#include "placement_mask.h"

#include <span>
#include <vector>

namespace windrow::vegetation::grass {

struct Chunk {
    glm::ivec2 at{0}; ///< along x and z
    bool operator==(const Chunk&) const = default;
};

struct ChunkBox {
    glm::vec3 low{0.0f}, high{0.0f}; ///< [m] from the field's corner
};

class ChunkTree {
  public:
    /// A field of whole cells that fit into the heights' extent. `reach` [m]: how far a blade goes from its root.
    ChunkTree(const HeightMap& heights, const PlacementMask& mask, const GrassSettings& settings, float reach);

    /// Looks at ground and mask again, where a stroke touched them.
    void refresh(const HeightMap& heights, const PlacementMask& mask, const Touched& touched);

    /// The chunks with grass that reach into the planes and are nearer to the eye [m from the field's corner] than `distance`
    /// [m], the box of the chunk that is, the nearest first. Replaces what `found` held; allocates nothing once it has grown.
    void visible(const Planes& planes, glm::vec3 eye, float distance, std::vector<Chunk>& found) const;

    [[nodiscard]] glm::ivec2 chunks() const { return chunks_; }
    /// Cells of the field along x and z.
    [[nodiscard]] glm::ivec2 cells() const { return cells_; }
    [[nodiscard]] bool grows(Chunk chunk) const { return node(0, chunk.at).grows(); }
    /// Widened by a blade's reach.
    [[nodiscard]] ChunkBox box(Chunk chunk) const { return box_of(0, chunk.at); }

  private:
    struct Node {
        float low = 1.0f, high = 0.0f;
        [[nodiscard]] bool grows() const { return low <= high; }
    };
    struct Level {
        glm::ivec2 size{0};
        std::vector<Node> nodes{};
    };
    [[nodiscard]] const Node& node(int level, glm::ivec2 at) const;
    [[nodiscard]] ChunkBox box_of(int level, glm::ivec2 at) const;
    void walk(int level, glm::ivec2 at, const Planes& planes, glm::vec3 eye, float distance, std::vector<Chunk>& found) const;

    glm::ivec2 cells_{0}, chunks_{0};
    float chunk_side_ = 0.0f, reach_ = 0.0f;
    glm::vec2 edge_{0.0f}; // [m] the field's last cell ends here
    std::vector<Level> levels_{};
};

/// Whole cells of a field along x and z: those that fit into the heights' extent, one at least.
[[nodiscard]] glm::ivec2 cells_of(const HeightMap& heights, const GrassSettings& settings);
/// [m] Distance from a point to a box, 0 inside.
[[nodiscard]] float distance_to(const ChunkBox& box, glm::vec3 point);
/// False only where no point of the box is inside of all planes.
[[nodiscard]] bool may_see(const Planes& planes, const ChunkBox& box);

} // namespace windrow::vegetation::grass
