// Forces, drives and canopy drag of a second-order step on the CPU (shaders/numerics/splitting.glsl).
//
// Trajectories follow the undriven wind u, so the change at departure is added to the carried field alone. It is written into the
// history, which the advection subtracts: R = u - s (q - change / s).
#pragma once

#include "fluid/core/cell_storage.h"
#include "fluid/core/numerics.h"
#include "fluid/cpu/kernels/kernels.h"
#include "fluid/cpu/sources.h"
#include "fluid/parallel.h"

#include <algorithm>
#include <array>
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
        const float* deposits = nullptr; ///< [1/m] of all cells, 0 outside of `run`; null: none in the box
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
        const Kernels* kernels = nullptr;
        const ParallelFor* parallel_for = nullptr;
    };
    Acting(SourceField& sources, const Settings& settings)
        : sources_(sources), settings_(settings), drag_{settings.plants, settings.deposits, settings.cells} {}

    [[nodiscard]] bool any() const { return sources_.any_force() || sources_.any_drive() || drag_.any(); }

    /// Air that relaxes to one wind, with nothing prescribed: `rest` + `left` (`carried` - `rest`).
    struct EvenAir {
        const glm::vec4* carried = nullptr; ///< of all cells; null: the air is not so
        float left = 1.0f;                  ///< 1: it does not relax
        glm::vec4 rest{0.0f};               ///< [m/s]
    };

    /// Adds the change at departure to the history. `air(n, cell, winds)` writes the total wind [m/s] of cells of a row, from
    /// number n at `cell` on; it returns false, and writes nothing, where that is 0. `even`: the same air; `scale`: s.
    template <class Air>
    void depart(const Air& air, const EvenAir& even, float scale, std::span<glm::vec4> history) const {
        const std::span<glm::vec4> kept = sources_.kept();
        const float inverse = 1.0f / scale;
        for_each_row(
            [&](std::size_t n, glm::ivec3 cell, glm::vec3 push, const numerics::WindrowHold& hold) {
                glm::vec4 wind(0.0f);
                (void)air(n, cell, std::span(&wind, 1));
                const glm::vec3 u(wind);
                kept[n] = history[n];
                history[n] -= inverse * glm::vec4(push + (numerics::windrow_held_departing(u, hold) - u), 0.0f);
            },
            [&](std::size_t n, glm::ivec3 cell, std::span<glm::vec4> winds) {
                return even.carried == nullptr && air(n, cell, winds);
            },
            [&](DragTask task, std::size_t n) {
                task.scale = inverse;
                task.carried = even.carried != nullptr ? &even.carried[n].x : nullptr;
                task.left = even.left;
                task.rest = &even.rest.x;
                task.history = &history[n].x;
                task.kept = &kept[n].x;
                settings_.kernels->drag_departs(task);
            });
    }
    /// Restores the history and applies the half at arrival. `prescribed`, as `air`, writes all that is at arrival. The fourth
    /// components stay.
    template <class Prescribed>
    void arrive(const Prescribed& prescribed, float scale, std::span<glm::vec4> history, std::span<glm::vec4> arrived) const {
        const std::span<glm::vec4> kept = sources_.kept();
        for_each_row(
            [&](std::size_t n, glm::ivec3 cell, glm::vec3 push, const numerics::WindrowHold& hold) {
                history[n] = kept[n];
                glm::vec3 u = glm::vec3(arrived[n]) + push;
                if (hold.drives.w > 0.0f || hold.way > 0.0f) {
                    glm::vec4 wind(0.0f);
                    (void)prescribed(n, cell, std::span(&wind, 1));
                    const glm::vec3 rest(wind);
                    u = numerics::windrow_held_arriving(u + rest, scale * glm::vec3(history[n]), hold) - rest;
                }
                arrived[n] = glm::vec4(u, arrived[n].w);
            },
            prescribed,
            [&](DragTask task, std::size_t n) {
                task.scale = scale;
                task.history = &history[n].x;
                task.kept = &kept[n].x;
                task.arrived = &arrived[n].x;
                settings_.kernels->drag_arrives(task);
            });
    }

  private:
    // visit(n, cell, (dt/2) f, hold) for each cell with a force, a drive or drag in a row that has forces or drives; drag(task, n)
    // for cells from n on in rows that have drag alone, with the winds that `wind` writes of them.
    template <class Visit, class Wind, class Drag>
    void for_each_row(const Visit& visit, const Wind& wind, const Drag& drag) const {
        const glm::ivec3 cells = settings_.cells;
        (*settings_.parallel_for)(cells.z, [&](int k) {
            for (int j = 0; j < cells.y; ++j) {
                const std::size_t row = static_cast<std::size_t>(k) * cells.y + j;
                const DragRows::Row dragged = drag_.at(j, k);
                const glm::vec4* const force = sources_.force_row(row);
                const SourceField::Range driven = sources_.driven(row);
                if (force == nullptr && driven.low >= driven.high)
                    drag_row(dragged, {0, j, k}, wind, drag);
                else
                    hold_row(dragged, force, driven, {0, j, k}, visit);
            }
        });
    }

    template <class Wind, class Drag>
    void drag_row(const DragRows::Row& row, glm::ivec3 cell, const Wind& wind, const Drag& drag) const {
        constexpr int k_most = 64;
        std::array<glm::vec4, k_most> winds;
        const std::size_t first = row_begin(cell);
        for (int low = row.low; low < row.high; low += k_most) {
            const int count = std::min(row.high - low, k_most);
            cell.x = low;
            const bool any =
                wind(first + static_cast<std::size_t>(low), cell, std::span(winds).first(static_cast<std::size_t>(count)));
            drag({.count = count,
                  .deposits = row.deposits != nullptr ? row.deposits + low : nullptr,
                  .canopy = row.canopy,
                  .half = 0.5f * settings_.dt,
                  .wind = any ? &winds[0].x : nullptr},
                 first + static_cast<std::size_t>(low));
        }
    }

    template <class Visit>
    void hold_row(const DragRows::Row& drag, const glm::vec4* force, SourceField::Range driven, glm::ivec3 cell,
                  const Visit& visit) const {
        const float half = 0.5f * settings_.dt, part = 1.0f / static_cast<float>(settings_.substeps);
        const std::size_t first = row_begin(cell);
        const glm::vec4* const drives = sources_.drive_row(first / settings_.cells.x);
        int low = force != nullptr ? 0 : drag.low, high = force != nullptr ? settings_.cells.x : drag.high;
        if (driven.low < driven.high) {
            low = low < high ? std::min<int>(low, driven.low) : driven.low;
            high = std::max<int>(high, driven.high);
        }
        for (int i = low; i < high; ++i) {
            const glm::vec3 push = force != nullptr ? half * glm::vec3(force[i]) : glm::vec3(0.0f);
            const float way = half * drag.of(i);
            const bool drives_here = i >= driven.low && i < driven.high;
            if (force == nullptr && !(way > 0.0f) && !(drives_here && drives[i].w > 0.0f))
                continue;
            cell.x = i;
            visit(first + static_cast<std::size_t>(i), cell, push,
                  numerics::WindrowHold{drives_here ? part * drives[i] : glm::vec4(0.0f), way});
        }
    }

    // Number of a row's first cell.
    [[nodiscard]] std::size_t row_begin(glm::ivec3 cell) const {
        return (static_cast<std::size_t>(cell.z) * settings_.cells.y + cell.y) * settings_.cells.x;
    }

    SourceField& sources_;
    Settings settings_;
    DragRows drag_;
};

} // namespace windrow::cpu
