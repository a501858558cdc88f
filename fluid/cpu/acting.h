// Forces, drives and canopy drag of a second-order step on the CPU (shaders/numerics/splitting.glsl).
//
// Trajectories follow the undriven wind u, so the change at departure is added to the carried field alone. It is written into the
// history, which the advection subtracts: R = u - s (q - change / s).
#pragma once

#include "fluid/core/cell_storage.h"
#include "fluid/core/numerics.h"
#include "fluid/cpu/sources.h"
#include "fluid/parallel.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace windrow::cpu {

/// Drag of a step, by rows of x: the canopy's, and that of deposits. Rows without any are not visited.
struct DragRows {
    CanopyRows canopy{};
    DragCells deposits{};
    glm::ivec3 cells{0};

    [[nodiscard]] bool any() const { return canopy.drag > 0.0f || deposits.any(); }
    struct Row {
        int low = 0, high = 0; ///< cells with any
        float canopy = 0.0f;   ///< [1/m]
        DragCells::Run run{};
        const float* deposits = nullptr; ///< [1/m] in `run`
        [[nodiscard]] float of(int i) const { return i >= run.low && i < run.high ? canopy + deposits[i] : canopy; }
    };
    [[nodiscard]] Row at(int j, int k) const {
        Row row{.canopy = canopy.drag_of(j)};
        if (deposits.any()) {
            const std::size_t index = static_cast<std::size_t>(k) * cells.y + j;
            row.run = deposits.runs[index];
            row.deposits = deposits.drag.data() + index * cells.x;
        }
        const bool whole = row.canopy > 0.0f;
        row.low = whole ? 0 : row.run.low;
        row.high = whole ? cells.x : row.run.high;
        return row;
    }
};

class Acting {
  public:
    struct Settings {
        glm::ivec3 cells{0};
        float dt = 0.0f; ///< [s] of the sub-step
        int substeps = 1;
        CanopyRows plants{}; ///< drag 0: none
        DragCells deposits{};
        const ParallelFor* parallel_for = nullptr;
    };
    Acting(SourceField& sources, const Settings& settings)
        : sources_(sources), settings_(settings), drag_{settings.plants, settings.deposits, settings.cells} {}

    [[nodiscard]] bool any() const { return sources_.any_force() || sources_.any_drive() || drag_.any(); }

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
                const DragRows::Row drag = drag_.at(j, k);
                int low = force != nullptr ? 0 : drag.low, high = force != nullptr ? cells.x : drag.high;
                if (driven.low < driven.high) {
                    low = low < high ? std::min<int>(low, driven.low) : driven.low;
                    high = std::max<int>(high, driven.high);
                }
                if (force == nullptr && driven.low >= driven.high) { // drag alone
                    for (int i = low; i < high; ++i)
                        if (const float way = half * drag.of(i); way > 0.0f)
                            visit(first + static_cast<std::size_t>(i), {i, j, k}, glm::vec3(0.0f), {glm::vec4(0.0f), way});
                    continue;
                }
                for (int i = low; i < high; ++i) {
                    const glm::vec3 push = force != nullptr ? half * glm::vec3(force[i]) : glm::vec3(0.0f);
                    const float way = half * drag.of(i);
                    const bool drives_here = i >= driven.low && i < driven.high;
                    if (force == nullptr && !(way > 0.0f) && !(drives_here && drives[i].w > 0.0f))
                        continue;
                    visit(first + static_cast<std::size_t>(i), {i, j, k}, push,
                          {drives_here ? part * drives[i] : glm::vec4(0.0f), way});
                }
            }
        });
    }

    SourceField& sources_;
    Settings settings_;
    DragRows drag_;
};

} // namespace windrow::cpu
