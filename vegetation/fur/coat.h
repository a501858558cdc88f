// A coat on a mesh in the renderer: fur, grass, feathers, spikes or clouds as layers, in the wind.
//
//     const fur::CoatPictures pictures;                                       // maps: none
//     auto coat = fur::Coat::create(device, renderer.draw_targets(), mesh, {}, settings, pictures, body, anchor);
//     renderer.add(**coat);
//     (void)(*coat)->move(frame_seconds, body, fur::pose(skeleton, time));   // before each frame that is recorded
//
// In each frame: a compute pass puts the mesh's vertices into the body's pose and asks the wind what it does to the strands
// there; then one instanced draw of the mesh, an instance a layer, in the colour pass and one in each shadow. A coat that neither
// the eye nor a shadow sees draws nothing. vegetation/shaders/fur/shell_strand.glsl has the walk of a fragment between layers.
#pragma once

#include "../../coupling/cascade.h"
#include "../render/drawable.h"
#include "../vulkan/frames.h"
#include "coat_block.h"
#include "coat_pictures.h"
#include "coat_room.h"

#include <array>
#include <glm/mat4x4.hpp>
#include <memory>
#include <optional>
#include <span>

namespace windrow::vegetation::fur {

/// Figures of the last frame.
struct CoatCounts {
    int layers = 0;             ///< in the colour pass, 0: not seen
    int skipped = 0;            ///< empty ones, above every strand
    std::uint64_t vertices = 0; ///< that the colour pass's draws name: indices times layers, twice with depth_first
    float divisor = 1.0f;       ///< of a layer's number (coat_levels.h)
};

/// Pose of a body shortly after that of the frame, for the velocity of its skin in the wind.
struct CoatAhead {
    double seconds = 2e-3; ///< above 0; short enough for a straight path, long enough for floats to resolve it
    windrow::Pose body{};
    std::span<const glm::mat4> bones{};
};

class Coat final : public render::Drawable {
  public:
    /// `parts` of the mesh are drawn, all of it if there are none. Rejects what `validate` rejects of settings, mesh, pictures
    /// and body, and parts that are not the mesh's. `anchor` [m] is the renderer's.
    [[nodiscard]] static Result<std::unique_ptr<Coat>> create(engine::Device& device, const render::DrawTargets& targets,
                                                              const Mesh& mesh, std::span<const MeshPart> parts,
                                                              const CoatSettings& settings, const CoatPictures& pictures,
                                                              const windrow::Pose& body, glm::dvec3 anchor);

    /// The body is at `body` now, `seconds` after the last call; 0: it was put there, and has no speed. `bones` are from the
    /// mesh's space at rest to that of its pose, one each that the mesh's vertices name, or none. Rejects what is not finite;
    /// then nothing has changed. Without `ahead` the skin's speed is that of the way since the last frame: half a frame late.
    /// Tips lag behind a straight way from call to call: call it in several steps a frame where the way is curved.
    Result<void> move(double seconds, const windrow::Pose& body, std::span<const glm::mat4> bones = {},
                      const std::optional<CoatAhead>& ahead = {});
    /// At most k_max_lamps; rejects what `validate` rejects.
    Result<void> set_lamps(std::span<const Lamp> lamps);
    /// Feet that press strands aside, from the next frame on; at most k_max_feet. Rejects what `validate` rejects.
    Result<void> set_feet(std::span<const Foot> feet);
    /// [s] of the animated cells; default 0. What is not finite counts as 0.
    void set_time(double seconds);
    /// [m] by which the air has carried the pattern so far, along x and z of the world. Only where CoatSettings::drifts.
    void drift(glm::dvec2 metres);

    Result<void> prepare(const render::PassContext& context) override;
    void draw(const render::PassContext& context) override;

    [[nodiscard]] const CoatCounts& counts() const { return counts_; }
    [[nodiscard]] const CoatBlock& block() const { return block_; }
    [[nodiscard]] const CoatSettings& settings() const { return settings_; }
    /// Vertices of the last prepared frame, once it is done: those that the drawn parts use, in the order of first
    /// use. Waits for the device.
    [[nodiscard]] Result<std::vector<CoatSkinBlock>> skin() const;

  private:
    struct PartMesh {
        std::vector<CoatVertexBlock> vertices;
        std::vector<std::uint32_t> indices;
        std::uint32_t drawn = 0; // vertices; the others are of the body's other parts
        std::vector<CoatPatchBlock> patches;
        std::vector<std::uint32_t> narrow;
        std::uint32_t bones = 0; // that vertices name
        glm::vec3 middle{0.0f};
        float radius = 0.0f;
    };
    static PartMesh part_mesh(const Mesh& mesh, std::span<const MeshPart> parts, const CoatSettings& settings);

    Coat(engine::Device& device, const render::DrawTargets& targets, const Mesh& mesh, PartMesh part,
         const CoatSettings& settings, const CoatPictures& pictures, const windrow::Pose& body,
         std::optional<windrow::Cascade> cascade, glm::dvec3 anchor);
    void make_pipelines(const render::DrawTargets& targets);
    void fill_buffers(const render::DrawTargets& targets, const PackedPictures& pictures, const PartMesh& part);
    void find_seen(const render::ViewBlock& frame);
    void place_pattern();
    [[nodiscard]] Result<void> judge_bones(std::span<const glm::mat4> bones) const;
    void write_motion(std::size_t slot);

    engine::Objects objects_;
    CoatSettings settings_;
    glm::dvec3 anchor_{0.0};
    windrow::ShellBlock shells_{}; // of scale 1
    CoatBlock block_{};
    CoatCounts counts_{};
    std::optional<windrow::Cascade> cascade_{};
    windrow::Pose body_{};
    std::vector<glm::mat4> bones_{}, bones_ahead_{};
    windrow::Pose ahead_{};
    Mesh box_{}; // of the mesh: its box alone
    glm::dvec2 drift_{0.0}, drift_before_{0.0};
    double evolved_ = 0.0;
    std::uint32_t vertex_count_ = 0, skin_count_ = 0, index_count_ = 0; // drawn; of the body, as far as the coat needs it
    glm::vec3 middle_{0.0f};
    float radius_ = 0.0f, posed_radius_ = 0.0f, top_ = 1.0f;
    double since_ = 0.0; // [s] moved since the last frame
    bool first_ = true;
    std::array<bool, 3> seen_{};

    VkDescriptorSetLayout own_ = VK_NULL_HANDLE;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline skin_ = VK_NULL_HANDLE, colour_ = VK_NULL_HANDLE, depth_ = VK_NULL_HANDLE, shadow_ = VK_NULL_HANDLE;
    std::array<VkDescriptorSet, engine::k_frames_in_flight> sets_{};
    engine::FrameBuffers blocks_{}, poses_{}, bone_buffers_{};
    engine::Buffer skins_{}, indices_{};
    std::optional<CoatRoom> room_{};
};

} // namespace windrow::vegetation::fur
