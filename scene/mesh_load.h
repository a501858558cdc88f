// How a mesh of a file stands in a scene: its axes turned, its size set.
#pragma once

#include "fluid/setting.h"

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <tuple>

namespace windrow::scene {

enum class UpAxis { x, y, z };

/// What `size` is the length of.
enum class SizeOf { longest_edge, height };

/// More than a coat can be drawn on.
inline constexpr std::size_t k_max_mesh_vertices = 2'000'000, k_max_mesh_triangles = 4'000'000;
/// [byte] Of one file; a mesh of `k_max_mesh_triangles` as text is about as long.
inline constexpr std::size_t k_max_mesh_bytes = std::size_t{512} << 20;

struct MeshLoad {
    UpAxis up = UpAxis::y;
    float size = 1.0f;
    SizeOf size_of = SizeOf::longest_edge;
    float yaw_deg = 0.0f;
    std::size_t max_triangles = k_max_mesh_triangles;

    static constexpr auto settings() {
        return std::tuple{
            Setting("up", &MeshLoad::up, "Axis of the file that points up: y of glTF and of most OBJ files, z of CAD programs."),
            Setting("size", &MeshLoad::size, {1e-3, 1e3, "m"},
                    "Size to which the mesh is scaled, and a fur line's height with it."),
            Setting("size_of", &MeshLoad::size_of, "The length that `size` sets."),
            Setting("yaw_deg", &MeshLoad::yaw_deg, {-360.0, 360.0, "deg"}, "Turn about y, seen from above counter-clockwise."),
            Setting("max_triangles", &MeshLoad::max_triangles, {4.0, k_max_mesh_triangles}, "Files with more are simplified."),
        };
    }
};

/// The file's axes to the scene's, and the yaw.
class MeshTurn {
  public:
    explicit MeshTurn(const MeshLoad& load);
    [[nodiscard]] glm::vec3 operator()(const glm::vec3& v) const;

  private:
    UpAxis up_;
    float cosine_, sine_;
};

/// Where the box of a turned mesh stands: on y = 0, centred in x and z, scaled to the size.
struct MeshStand {
    glm::vec3 foot{0.0f}; ///< of the turned mesh; becomes the origin
    float scale = 1.0f;   ///< [m] that one of the file's units becomes

    /// `low` and `high`: of the turned mesh.
    MeshStand(const MeshLoad& load, const glm::vec3& low, const glm::vec3& high);
    [[nodiscard]] glm::vec3 operator()(const glm::vec3& v) const { return (v - foot) * scale; }
};

} // namespace windrow::scene

template <>
inline constexpr std::array<const char*, 3> windrow::k_words<windrow::scene::UpAxis>{"x", "y", "z"};
template <>
inline constexpr std::array<const char*, 2> windrow::k_words<windrow::scene::SizeOf>{"longest_edge", "height"};
