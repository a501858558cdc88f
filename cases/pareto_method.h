// The methods that `windrow pareto` compares: each time scheme with each interpolation and each pressure solve.
#pragma once

#include "cases/backend_wind.h"
#include "cases/pareto_flow.h"
#include "cases/reference/other_solve.h"

#include <array>
#include <string>
#include <vector>

namespace windrow::cases {

using reference::Pressure;

struct Method {
    Scheme scheme = Scheme::second_order;
    Interpolation interpolation = Interpolation::cubic;
    Pressure pressure = Pressure::direct;
    friend bool operator==(const Method&, const Method&) = default;
};

inline constexpr std::array k_schemes = {Scheme::second_order, Scheme::stable_fluids};
inline constexpr std::array k_advections = {Interpolation::cubic, Interpolation::linear};
inline constexpr std::array k_pressures = {Pressure::direct, Pressure::multigrid, Pressure::jacobi80, Pressure::jacobi40,
                                           Pressure::jacobi20};

/// What a Wind does by default.
inline constexpr Method k_default_method{Scheme::second_order, Interpolation::cubic, Pressure::direct}; // as Config says: tested

enum class Solves : std::uint8_t { direct, voxels, all };

/// Those of a wind, which solves directly; these and the classic step, linear with Jacobi sweeps, whose obstacles are whole cells; or
/// all.
[[nodiscard]] std::vector<Method> pareto_methods(Solves solves);
/// On a device, and for what only a Wind computes: direct. Around obstacles: voxels.
[[nodiscard]] Solves solves_of(const ParetoFlow& flow, BackendKind backend);

/// Whether reference::VoxelStep takes the place of a wind's step.
[[nodiscard]] inline bool has_voxels(const ParetoFlow& flow, const Method& method) {
    return !flow.obstacles.empty() && method.pressure != Pressure::direct;
}

[[nodiscard]] const char* name_of(Scheme scheme);
[[nodiscard]] const char* name_of(Interpolation advection);
[[nodiscard]] const char* name_of(Pressure pressure);
/// "second_order cubic direct"
[[nodiscard]] std::string name_of(const Method& method);

} // namespace windrow::cases
