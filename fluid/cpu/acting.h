// Forces, drives and canopy drag of a second-order step on the CPU (shaders/numerics/splitting.glsl).
//
// Trajectories follow the undriven wind u, so the change at departure is added to the carried field alone. It is written into the
// history, which the advection subtracts: R = u - s (q - change / s).
#pragma once

#include "fluid/core/cell_storage.h"
#include "fluid/core/numerics.h"
#include "fluid/cpu/sources.h"
#include "fluid/parallel.h"

#include <span>

namespace windrow::cpu {

class Acting {
  public:
    struct Settings {
        glm::ivec3 cells{0};
        float dt = 0.0f; ///< [s] of the sub-step
        int substeps = 1;
        CanopyRows plants{}; ///< drag 0: none
        const ParallelFor* parallel_for = nullptr;
    };
    Acting(SourceField& sources, const Settings& settings) : sources_(sources), settings_(settings) {}

    [[nodiscard]] bool any() const { return sources_.any_force() || sources_.any_drive() || settings_.plants.drag > 0.0f; }

    /// Adds the change at departure to the history. `air(n, cell)`: total wind [m/s] of a cell; `scale`: s.
    template <class Air>
    void depart(const Air& air, float scale, std::span<glm::vec4> history) const {
        const std::span<glm::vec4> kept = sources_.kept();
        const float inverse = 1.0f / scale;
        for_each_cell([&](std::size_t n, glm::ivec3 cell, glm::vec3 push, const numerics::WindrowHold& hold) {
            const glm::vec3 u = air(n, cell);
            kept[n] = history[n];
            history[n] -= inverse * glm::vec4(push + (numerics::windrow_held_departing(u, hold) - u), 0.0f);
        });
    }
    /// Restores the history and applies the half at arrival. `prescribed(n, cell)`: all that is [m/s], at arrival.
    template <class Prescribed>
    void arrive(const Prescribed& prescribed, float scale, std::span<glm::vec4> history, std::span<glm::vec4> arrived) const {
        const std::span<const glm::vec4> kept = sources_.kept();
        for_each_cell([&](std::size_t n, glm::ivec3 cell, glm::vec3 push, const numerics::WindrowHold& hold) {
            history[n] = kept[n];
            glm::vec3 u = glm::vec3(arrived[n]) + push;
            if (hold.drives.w > 0.0f || hold.way > 0.0f) {
                const glm::vec3 rest = prescribed(n, cell);
                u = numerics::windrow_held_arriving(u + rest, scale * glm::vec3(history[n]), hold) - rest;
            }
            arrived[n] = glm::vec4(u, 0.0f);
        });
    }

  private:
    // visit(n, cell, (dt/2) f, hold) for each cell with a force, a drive or drag.
    template <class Visit>
    void for_each_cell(const Visit& visit) const {
        const glm::ivec3 cells = settings_.cells;
        const float half = 0.5f * settings_.dt, part = 1.0f / static_cast<float>(settings_.substeps);
        (*settings_.parallel_for)(cells.z, [&](int k) {
            for (int j = 0; j < cells.y; ++j) {
                const std::size_t row = static_cast<std::size_t>(k) * cells.y + j, first = row * cells.x;
                const glm::vec4* const force = sources_.force_row(row);
                const glm::vec4* const drives = sources_.drive_row(row);
                const SourceField::Range driven = sources_.driven(row);
                const float way = half * settings_.plants.drag_of(j);
                const bool whole = force != nullptr || way > 0.0f;
                for (int i = whole ? 0 : driven.low, end = whole ? cells.x : driven.high; i < end; ++i) {
                    const glm::vec3 push = force != nullptr ? half * glm::vec3(force[i]) : glm::vec3(0.0f);
                    const bool drives_here = i >= driven.low && i < driven.high;
                    if (!whole && !(drives[i].w > 0.0f))
                        continue;
                    visit(first + static_cast<std::size_t>(i), {i, j, k}, push,
                          {drives_here ? part * drives[i] : glm::vec4(0.0f), way});
                }
            }
        });
    }

    SourceField& sources_;
    Settings settings_;
};

} // namespace windrow::cpu
