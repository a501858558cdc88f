// What each case of this suite watches in every step: that every cell holds a number, the energy, the largest speed, and that
// the step reports what it did. At the end it prints and judges two figures a case:
//
//     [figure] stability/<case>/<steps>_steps/energy <largest energy over the measure> <bound>
//     [figure] stability/<case>/<steps>_steps/max    <largest |u| over the measure> <bound>
//
// The measure is the start, where nothing acts, or what was put in (input.h). A cell without a number makes both infinite.
#pragma once

#include "tests/stability/input.h"
#include "tests/stability/report_check.h"
#include "tests/tier.h"
#include "tests/winds.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <string>

namespace windrow::test {

/// Steps that a run takes (tier.h): 500 at least, so that what grows has time to, and 20 under a sanitizer.
[[nodiscard]] inline int shortened(int steps) {
    return sampled(steps, k_sanitized ? 20 : 120);
}

inline constexpr BoundaryKind k_kinds[] = {BoundaryKind::open, BoundaryKind::free_slip, BoundaryKind::no_slip,
                                           BoundaryKind::periodic};
inline constexpr const char* k_kind_names[] = {"open", "free_slip", "no_slip", "periodic"};

/// Of motors that oppose each other: jets that meet squeeze air aside faster than either blew. Up to 1.8 times was seen, of a
/// chaotic flow. Wakes that turn in every raw step reach 2.6; they have the bound of input.h.
inline constexpr double k_opposed_factor = 2.5;

/// A fan as hard as a fan can be: its cells hold its speed after a millisecond.
inline MotorId drive(Wind& wind, glm::dvec3 position, glm::vec3 direction, float speed, float radius = 2.0f, float rate = 1e6f) {
    return added(wind, DirectionalMotor{.position = position,
                                        .direction = direction,
                                        .region = Sphere{radius},
                                        .law = Drive{speed, rate},
                                        .turbulence = k_steady});
}

struct GrowthBounds {
    double energy;
    double max;
};

class Watch {
  public:
    /// Measures by the wind's air as it is now.
    explicit Watch(Wind& wind) : wind_(&wind), energy_(energy_of(wind.field())), speed_(largest_speed(wind.field())) {}
    /// Measures by all of the box's air at `speed` [m/s].
    Watch(Wind& wind, double speed)
        : wind_(&wind), energy_(0.5 * speed * speed * static_cast<double>(wind.field().size())), speed_(speed) {}

    Diagnostics step(double dt, std::int64_t broken = 0) {
        const Diagnostics report = wind_->step(dt);
        ++steps_;
        const std::span<const glm::vec4> field = wind_->field();
        ratio_ = nonfinite_cells(field) == 0 ? energy_of(field) / energy_ : std::numeric_limits<double>::infinity();
        largest_energy_ = std::max(largest_energy_, ratio_);
        const double speed = std::isfinite(ratio_) ? largest_speed(field) / speed_ : ratio_;
        largest_speed_ = std::max(largest_speed_, speed);
        if (complaint_.empty() && std::isfinite(ratio_))
            if (const std::string found = disagreement(*wind_, report, {dt, broken, was_asleep_}); !found.empty())
                complaint_ = "step " + std::to_string(steps_) + ": " + found;
        was_asleep_ = report.asleep;
        max_substeps_ = std::max(max_substeps_, report.substeps);
        capped_ += report.substeps_capped ? 1 : 0;
        return report;
    }

    /// shortened(steps) steps of dt [s], or of dt(n) for step n.
    void run(int steps, double dt) {
        for (int n = 0; n < shortened(steps); ++n)
            step(dt);
    }
    template <class StepLength>
    void run(int steps, const StepLength& dt) {
        for (int n = 0; n < shortened(steps); ++n)
            step(dt(n));
    }

    [[nodiscard]] double energy() const { return ratio_; }                  ///< after the last step, over the measure
    [[nodiscard]] double largest_energy() const { return largest_energy_; } ///< of all steps
    [[nodiscard]] double largest_max() const { return largest_speed_; }
    [[nodiscard]] int steps() const { return steps_; }
    [[nodiscard]] int max_substeps() const { return max_substeps_; }
    [[nodiscard]] int capped_steps() const { return capped_; }
    [[nodiscard]] const std::string& complaint() const { return complaint_; }

    void judge(const std::string& name, GrowthBounds bounds) const;

  private:
    Wind* wind_;
    double energy_, speed_;
    double ratio_ = 1.0, largest_energy_ = 0.0, largest_speed_ = 0.0;
    int steps_ = 0, max_substeps_ = 0, capped_ = 0;
    bool was_asleep_ = false;
    std::string complaint_;
};

inline void take_steps(Watch& watch, int count, double dt) {
    for (int n = 0; n < count; ++n)
        watch.step(dt);
}

/// The worst of several runs that one case is made of.
class Worst {
  public:
    void meet(const Watch& watch) {
        energy_ = std::max(energy_, watch.largest_energy());
        max_ = std::max(max_, watch.largest_max());
        steps_ += watch.steps();
        EXPECT_EQ(watch.complaint(), "");
    }
    [[nodiscard]] double energy() const { return energy_; }
    [[nodiscard]] double max() const { return max_; }

    void judge(const std::string& name, GrowthBounds bounds) const {
        const std::string full = "stability/" + name + '/' + std::to_string(steps_) + "_steps/";
        WINDROW_EXPECT_FIGURE(full + "energy", energy_, bounds.energy);
        WINDROW_EXPECT_FIGURE(full + "max", max_, bounds.max);
    }

  private:
    double energy_ = 0.0, max_ = 0.0;
    int steps_ = 0;
};

inline void Watch::judge(const std::string& name, GrowthBounds bounds) const {
    Worst worst;
    worst.meet(*this);
    worst.judge(name, bounds);
}

} // namespace windrow::test
