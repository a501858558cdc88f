// The box of a body's mesh, which sets the size of its wake: from the keys of the mesh and, of a mesh in a file, from its places.
//
// Both programs ask this reader, so that a body has one wake. Shapes of formulas have the box of the ideal form: a sphere's, a
// beast's to 2 %, a wing's to a quarter.
#pragma once

#include "fluid/files/input_budget.h"
#include "fluid/result.h"
#include "scene/json_object.h"
#include "scene/mesh_load.h"

#include <filesystem>
#include <glm/vec3.hpp>

namespace windrow::scene {

/// [m] Before the body's place and scale.
struct BodyBox {
    glm::vec3 low{0.0f}, high{0.0f};
};

/// The box of a mesh in a file that is no OBJ. The file must be in `folder` and takes its part of the budget.
using MeshBoxReader = Result<BodyBox> (*)(const std::filesystem::path& file, const MeshLoad& load,
                                          const std::filesystem::path& folder, detail::InputBudget& budget);

/// Reads the value of a body's `mesh`, and nothing of it that does not change the box. Rejected keys are noted in the object's log; a
/// file without a usable mesh is an error. `meshes` may be null: OBJ alone.
[[nodiscard]] Result<BodyBox> read_body_box(JsonObject mesh, const std::filesystem::path& folder, MeshBoxReader meshes);

} // namespace windrow::scene
