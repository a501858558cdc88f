// Two feet on a path: each stands where it was set down while the body passes over it, then swings to its next place.
//
//     const Gait gait(scene.paths[0].path);
//     const Gait::Foot left = gait.foot(0, time);          // left.way does not change while left.planted
//     const glm::dvec2 place = gait.at(left.way);
//
// With the way s gone on the level and a stride S (two steps), foot n (0 or 1) is in its cycle at u = s / S - n / 2, k = floor(u),
// f = u - k. It stands for f < b, at the way (k + n / 2 + c b) S: it lands c b S ahead of the body and leaves the ground behind it.
// Then it swings to the next such place, g = (f - b) / (1 - b), by the smoothstep of g. Everything depends on the way alone: who
// stops stops in mid-step, and no frame rate makes a foot slide.
// S = 1.25 m (V / (1 m/s))^0.6 of the mean speed V while it moves: 1.5 m at 1.4 m/s, 3.3 m at 5 m/s, as people do. b is 0.62 in a
// walk and 0.36 in a run, which begins at 2.2 m/s, and never more than 0.95 m of the way, which a leg spans. c is 0.4 and 0.35.
// Based on: Alexander 1976, Estimates of speeds of dinosaurs (strides grow by a power of the speed); Margaria 1976, Biomechanics
// and energetics of muscular exercise (walk and run part near 2.2 m/s).
#pragma once

#include "scene/motion_path.h"

#include <glm/vec2.hpp>
#include <vector>

namespace windrow::vegetation::program {

class Gait {
  public:
    explicit Gait(const windrow::scene::MotionPath& path);

    struct Foot {
        double way = 0.0;   ///< [m] where along the path it is
        double stood = 0.0; ///< 0 to 1 of its stand; 1 in the air
        double swung = 0.0; ///< 0 to 1 of its swing; 0 on the ground
        bool planted = true;
    };
    /// Foot 0 is the left one, 1 the right.
    [[nodiscard]] Foot foot(int n, double time) const;
    /// [m] Gone on the level at a time [s].
    [[nodiscard]] double way(double time) const;
    /// [m] x and z of the path there; before it the first, beyond it the last place.
    [[nodiscard]] glm::dvec2 at(double way) const;
    /// [rad] About the vertical, from +z, over 0.4 m of the way: a corner of the path is no snap.
    [[nodiscard]] double heading(double way) const;
    /// [m/s] In the mean while it moves; 0: it stands.
    [[nodiscard]] double speed() const { return speed_; }
    /// [m] Of two steps.
    [[nodiscard]] double stride() const { return stride_; }
    [[nodiscard]] bool runs() const { return stand_ < 0.5; }

  private:
    struct Mark {
        double time = 0.0, way = 0.0;
        glm::dvec2 place{0.0};
    };
    template <class Value>
    [[nodiscard]] Value between(double at, double Mark::*key, Value Mark::*value) const;

    std::vector<Mark> marks_{}; ///< points of the path
    double speed_ = 0.0, stride_ = 1.0, stand_ = 0.62, ahead_ = 0.4;
};

} // namespace windrow::vegetation::program
