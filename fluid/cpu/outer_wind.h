// The wind around a box where that is another, larger wind.
//
//   U = A + D,  D = u_outer - A at the outer cells' centres,  p the outer wind's kinematic pressure [m^2/s^2]
//
// A is the ambient wind, one for all levels. D and p are read at each cell of the inner box and of its halo, linearly between the
// outer centres. D is interpolated, never u: so the log profile below the lowest outer row stays as it is. Where the outer box
// ends D fades to 0, as its own wind fades to the ambient one, or to that of the level around it. In a step they go linearly from
// what the last step ended with to the outer wind of now, which is up to a tick of its own late. U takes the place of the ambient
// wind, and beyond open boundaries stand
//
//   carried ghosts     U - (dt/2) grad p       at the start of the sub-step
//   trajectories       U                       at its end
//   pressure           phi = c p, c = dt/2     at its end; c = dt in a step without a past
//   divergence         the edge cell's own wind plus W(ghost) - W(cell), W = D + c grad p
//
// One way: the outer wind does not feel the inner one. Second order, as the step, where both levels are refined together.
// Based on: Davies 1976, Quarterly Journal 102; Skamarock & Klemp 2008, Journal of Computational Physics 227 (one-way nesting).
#pragma once

#include "fluid/core/outer_air.h"
#include "fluid/cpu/aligned.h"
#include "fluid/cpu/sources.h"
#include "fluid/parallel.h"
#include "fluid/window.h"

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <initializer_list>
#include <memory>
#include <vector>

namespace windrow::cpu {

class Cells;

class OuterWind final : public OuterAir {
  public:
    /// Of a box inside the cells of the outer wind, which outlive it and keep their pressure from now on.
    OuterWind(const Box& box, Cells& outer);

    void renew(const Window& window, const ParallelFor& parallel_for) override;
    [[nodiscard]] bool holds(const Window& window) const override { return holds_ && origin_ == window.origin_cells; }
    void move_to(const Window& window, const ParallelFor& parallel_for) override;
    /// A step of `parts` sub-steps begins, which goes `way` of the way to the outer wind of now.
    void begin_step(const Window& window, float way, const ParallelFor& parallel_for) override;
    void begin_part(int part, int parts, const ParallelFor& parallel_for);
    void end_step() override;

    /// [m/s] D of a cell at the start of the sub-step; between steps, of now.
    [[nodiscard]] glm::vec4 at(int i, int j, int k) const;
    /// [m^2/s^2] p of a cell between steps.
    [[nodiscard]] float pressure_at(int i, int j, int k) const;

    /// The ambient wind without D, four floats a padded cell; null: `everywhere`.
    struct Ambient {
        const float* cells = nullptr;
        glm::vec3 everywhere{0.0f};
    };
    /// What a sub-step of dt [s] reads beyond its box. `relaxes`: all cells are read, not the halo alone; `fresh`: no past.
    struct Around {
        Ambient carried, traced;
        float dt = 0.0f;
        bool fresh = false, relaxes = true;
    };
    void compose(const Around& around, const ParallelFor& parallel_for);
    [[nodiscard]] const float* carried() const { return &carried_.data()->x; }
    [[nodiscard]] const float* traced() const { return &traced_.data()->x; }

    /// The pressure and the divergence beyond open boundaries, of the sub-step that was composed.
    class Sides final : public Beyond {
      public:
        explicit Sides(const OuterWind& outer) : outer_(outer) {}
        [[nodiscard]] float potential(glm::ivec3 cell, int axis, int end) const override;
        [[nodiscard]] float rise(glm::ivec3 cell, int axis, int end) const override;

      private:
        const OuterWind& outer_;
    };

    [[nodiscard]] std::size_t memory_bytes() const;
    [[nodiscard]] Cells& cells() const { return outer_; }
    /// For snapshots: the values of now, and the box that they are of.
    [[nodiscard]] std::span<const glm::vec4> values() const override { return now_; }
    [[nodiscard]] std::span<const glm::vec4> values_at_end() const override { return end_; }
    [[nodiscard]] CellIndex origin() const override { return origin_; }
    void restore(std::span<const float> values, CellIndex origin) override;
    void shift_origin(CellIndex by) override { origin_ += by; }

  private:
    /// A padded cell along one axis, between two outer centres.
    struct Place {
        int low = 0; ///< outer cell; not wrapped
        float between = 0.0f;
        float share = 1.0f; ///< of D
    };
    OuterWind(const Box& box, Cells& outer, std::initializer_list<Buffer<glm::vec4>*> fields);
    void place(const Window& window, const class AirOfNow& air);
    void blend(const AirOfNow& air, Buffer<glm::vec4>& to, const ParallelFor& parallel_for);
    [[nodiscard]] bool reaches_beyond() const;
    void add_further(const Window& window, Buffer<glm::vec4>& to, const ParallelFor& parallel_for);
    void fill_brick(const AirOfNow& air);
    void sample(const Window& window, Buffer<glm::vec4>& to, const ParallelFor& parallel_for);
    [[nodiscard]] float slope(const Buffer<glm::vec4>& of, glm::ivec3 at, int axis) const;
    [[nodiscard]] float height(int row) const;

    Box box_;
    Cells& outer_;
    CellIndex origin_{0};
    bool holds_ = false;                      ///< any outer wind yet
    float factor_ = 0.0f;                     ///< c of the sub-step
    Buffer<glm::vec4> now_, end_, from_, to_; ///< D and p of padded cells
    const Buffer<glm::vec4>* start_ = &now_;  ///< of the sub-step
    const Buffer<glm::vec4>* next_ = &now_;
    Buffer<glm::vec4> carried_, traced_;
    std::array<std::vector<Place>, 3> places_;
    std::vector<glm::vec4> brick_; ///< D and p of the outer cells around the box
    glm::ivec3 brick_low_{0}, brick_cells_{0};
    std::vector<glm::dvec3> points_; ///< scratch: a row of the brick
    std::vector<glm::vec3> winds_, winds_before_;
    std::unique_ptr<OuterWind> further_; ///< the wind around the outer wind, sampled alone; null: none
};

} // namespace windrow::cpu
