// Shells of fur or grass on the CPU: the vertices of each layer. Shaders use the same source
// (shaders/coupling/windrow_plants.glsl); the equations and the forms of the literature are in shaders/numerics/shell.glsl.
//
//     auto fur = windrow::Shells::create({.shells = 40, .length = 0.03f});
//     for (int i = 0; i < 40; ++i)
//         p[i] = fur->bent(skin, normal, fur->height(i), 1.0f, fur->load(normal, 1.0f, wind - velocity));
//
// Two forms: `bent`, in which strands keep their length, and `translated`, the push and droop of the shell literature. Neither
// moves a vertex into the surface, and no shell passes the next. Positions and normals come after skinning.
#pragma once

#include "../fluid/api.h"
#include "../fluid/parallel.h"
#include "../fluid/result.h"
#include "drag.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

namespace windrow {

/// Shells of a coat and their strands. The default strand is a bundle of hairs that a light wind moves, 15 degrees at 3 m/s.
struct ShellSettings {
    /// 2 to 4096, default 32. Number of layers. Of a mesh from a file, the default is that of the material's fur line.
    int shells = 32;
    /// Default true. Whether the outermost layer is at the tip, layer i at i / (N - 1), so that the look does not depend on N;
    /// else layer i is at i / N.
    bool reaches_tip = true;
    /// [m] 1e-6 to 100, default 0.03. Length of the longest strands; 0.03 is long fur. Of a mesh from a file, the default is that
    /// of the material's fur line.
    float length = 0.03f;
    /// A number above 0, at most 10, default 1. Heights are (i / d)^spacing: above 1 layers gather at the skin.
    float spacing = 1.0f;
    /// 0 to 1, default 0. Fraction of the length by which all layers are lifted: a little lifts shell 0 off a skin that is drawn
    /// too.
    float bias = 0.0f;
    /// [m] -100 to 100, default 0.015. Displacement of the tip for a direction of length 1, in the translated form.
    float push = 0.015f;
    /// A number above 0, at most 10, default 2. The push grows as height^this: at 2 roots stay upright and tips lean.
    float push_exponent = 2.0f;
    /// [m] 0 to 100, default 0. Droop of the tip, in the translated form.
    float droop = 0.0f;
    /// 0.001 to 1000, default 3. p of the droop (p^h - 1) / (p - 1): above 1 it bends toward the tip, 1 is linear.
    float droop_shape = 3.0f;
    /// [rad] 0 to 1.5707964, default 0.3. Sag of the tip of a horizontal strand, in the bent form. Strands that a map shortens
    /// sag by its cube.
    float sag = 0.3f;
    /// A finite vector that is not 0, default (0, -1, 0). Direction of gravity, of any length above 0.
    glm::vec3 down{0.0f, -1.0f, 0.0f};
    /// Strand of the bent form; its length is that of the layers.
    Drag strand{.length = 0.03f, .width = 2e-4f, .rigidity = 2.6e-8f, .drag_coefficient = 1.5f};

    static constexpr auto settings() {
        return std::tuple{
            Setting("shells", &ShellSettings::shells, {2.0, 4096.0},
                    "Number of layers. Of a mesh from a file, the default is that of the material's fur line."),
            Setting("reaches_tip", &ShellSettings::reaches_tip,
                    "Whether the outermost layer is at the tip, layer i at i / (N - 1), so that the look does not depend on N; "
                    "else layer i "
                    "is at i / N."),
            Setting("length", &ShellSettings::length, {1e-6, 100.0, "m"},
                    "Length of the longest strands; 0.03 is long fur. Of a mesh from a file, the default is that of the "
                    "material's fur "
                    "line."),
            Setting("spacing", &ShellSettings::spacing, Range::above(0.0, 10.0),
                    "Heights are (i / d)^spacing: above 1 layers gather at the skin."),
            Setting(
                "bias", &ShellSettings::bias, k_fraction_range,
                "Fraction of the length by which all layers are lifted: a little lifts shell 0 off a skin that is drawn too."),
            Setting("push", &ShellSettings::push, {-100.0, 100.0, "m"},
                    "Displacement of the tip for a direction of length 1, in the translated form."),
            Setting("push_exponent", &ShellSettings::push_exponent, Range::above(0.0, 10.0),
                    "The push grows as height^this: at 2 roots stay upright and tips lean."),
            Setting("droop", &ShellSettings::droop, {0.0, 100.0, "m"}, "Droop of the tip, in the translated form."),
            Setting("droop_shape", &ShellSettings::droop_shape, {1e-3, 1e3},
                    "p of the droop (p^h - 1) / (p - 1): above 1 it bends toward the tip, 1 is linear."),
            Setting("sag", &ShellSettings::sag, {0.0, 1.5707964, "rad"},
                    "Sag of the tip of a horizontal strand, in the bent form. Strands that a map shortens sag by its cube."),
            Setting("down", &ShellSettings::down, Range::direction(), "Direction of gravity, of any length above 0."),
            Setting("strand", &ShellSettings::strand, "Strand of the bent form; its length is that of the layers."),
        };
    }
};

/// Shader block: WindrowShells of shaders/numerics/shell.glsl, a std140 block of four vec4.
struct ShellBlock {
    glm::vec4 form{0.0f}; ///< x [m] L; y a; z bias; w divisor of i
    glm::vec4 push{0.0f}; ///< x s; y c; z [m] droop; w ln p, taken in double
    glm::vec4 sag{0.0f};  ///< xyz down; w [rad] sag
    DragBlock drag{};
};
static_assert(sizeof(ShellBlock) == 64);

[[nodiscard]] WINDROW_API Result<void> validate(const ShellSettings& settings);
/// Leaves out the strand's length, which is replaced.
WINDROW_API void check_settings(detail::Reasons& reasons, const detail::FieldPath& path, const ShellSettings& settings);

class WINDROW_API Shells {
  public:
    /// Rejects what `validate` rejects, with every reason.
    [[nodiscard]] static Result<Shells> create(const ShellSettings& settings);

    [[nodiscard]] const ShellSettings& settings() const { return settings_; }
    [[nodiscard]] const ShellBlock& block() const { return block_; }

    /// h of shell i, 0 to N - 1.
    [[nodiscard]] float height(int shell) const;
    /// [rad] The bend of a strand on the normal n, with `map` of its length, 0 to 1, that a wind [m/s] holds. In a
    /// light wind it goes as the map's cube.
    [[nodiscard]] glm::vec3 load(glm::vec3 normal, float map, glm::vec3 wind) const;
    /// [m] A vertex of the skin with its unit normal, on the layer of height h, where strands have `map` of their length, 0 to 1.
    /// The skin is taken as level: no strand enters a body that is level or bulges, but in hollows tips do. In a wind of 20 m/s they
    /// enter where a hollow's radius is below 0.9 of the length of strands of 3 cm, 1.6 of those of 6 cm, 2.6 of those of 10 cm; on a
    /// bumpy body of 0.6 m across 1.3 % of the tips of 6 cm are inside then, 10 % of their length deep in the mean. Draw the body before
    /// its layers, so that the depth test hides them, or raise `bias`.
    [[nodiscard]] glm::vec3 bent(glm::vec3 position, glm::vec3 normal, float h, float map, glm::vec3 load) const;
    /// [m] The translate form; `direction` [1] is multiplied by `push`: wind or -velocity times a factor, or a direction memory.
    [[nodiscard]] glm::vec3 translated(glm::vec3 position, glm::vec3 normal, float h, float map, glm::vec3 direction) const;

    /// A mesh's vertices, one entry each; w of `positions` is the map.
    struct Skin {
        std::span<const glm::vec4> positions; ///< xyz [m]; w length of strands there, 0 to 1
        std::span<const glm::vec4> normals;   ///< xyz unit vectors
    };
    /// `load`, `bent` and `translated` for one layer of a whole mesh. Spans have one entry a vertex; rejects others and touches
    /// nothing then. The result does not depend on the number of threads.
    Result<void> loads(const Skin& skin, std::span<const glm::vec4> winds, std::span<glm::vec4> loads,
                       const ParallelFor& parallel_for = {}) const;
    Result<void> bent(const Skin& skin, float h, std::span<const glm::vec4> loads, std::span<glm::vec4> out,
                      const ParallelFor& parallel_for = {}) const;
    Result<void> translated(const Skin& skin, float h, std::span<const glm::vec4> directions, std::span<glm::vec4> out,
                            const ParallelFor& parallel_for = {}) const;

  private:
    explicit Shells(const ShellSettings& settings);

    ShellSettings settings_;
    ShellBlock block_;
};

} // namespace windrow
