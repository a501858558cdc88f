// Damped oscillators that follow a target, for plants on the CPU, and the step coefficients for shaders.
//
//     const auto step = windrow::spring_step(windrow::springs::wheat, frame_seconds);    // once a frame and class
//     (void)windrow::advance_springs<float>(*step, {places, velocities, targets_before, targets_now});
//
// The equation and its exact solution: shaders/numerics/spring.glsl. A step has any length; its result does not depend on how the
// time was cut, as long as targets are linear between the cuts.
#pragma once

#include "../fluid/api.h"
#include "../fluid/parallel.h"
#include "../fluid/result.h"
#include "../fluid/setting.h"
#include "motion_blocks.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace windrow {

/// Frequency and damping of a class of plants.
struct SpringClass {
    /// [Hz] 1e-4 to 1000, default 2.5. Natural frequency without damping. A lower one follows gusts later.
    double frequency_hz = 2.5;
    /// 0 to 1000, default 0.12. Damping ratio. 0: undamped; below 1: decaying oscillation; 1: critical; above 1: slow return.
    /// Crops and trees have 0.12, drag of the leaves included.
    double damping = 0.12;

    static constexpr auto settings() {
        return std::tuple{
            // A swing of three hours at the least: below, omega^2 would vanish beside 1.
            Setting("frequency_hz", &SpringClass::frequency_hz, {1e-4, 1000.0, "Hz"},
                    "Natural frequency without damping. A lower one follows gusts later."),
            Setting(
                "damping", &SpringClass::damping, {0.0, 1000.0},
                "Damping ratio. 0: undamped; below 1: decaying oscillation; 1: critical; above 1: slow return. Crops and trees "
                "have 0.12, drag of the leaves included."),
        };
    }
};

/// Predefined classes. docs/plants_motion.md names the source of each figure, and which of them are our choice.
namespace springs {
inline constexpr SpringClass grass{3.5, 0.2};
inline constexpr SpringClass wheat{2.5, 0.12};
inline constexpr SpringClass alfalfa{1.05, 0.12};
inline constexpr SpringClass reed{0.9, 0.1};
inline constexpr SpringClass leaf{6.0, 0.2};
inline constexpr SpringClass twig{3.0, 0.12};
inline constexpr SpringClass branch{1.2, 0.1};
inline constexpr SpringClass trunk{0.3, 0.08};
} // namespace springs

/// Rejects a frequency or a damping that is out of range or NaN.
[[nodiscard]] WINDROW_API Result<void> validate(const SpringClass& spring);

/// Springs of plants of one class: its frequency times 2^(-3/8), 2^(-1/8), 2^(1/8) and 2^(3/8), kept within a class's range, and its
/// damping. Plants of one class then do not swing in unison; windrow_spring_band of shaders/numerics/spring.glsl says which one a plant
/// has. Rejects as `validate`.
[[nodiscard]] WINDROW_API Result<std::array<SpringClass, 4>> spring_bands(const SpringClass& spring);

/// The six coefficients of a step (spring.glsl), in double.
struct WINDROW_API SpringStep {
    double place_place = 0.0;       ///< A - 1
    double place_velocity = 0.0;    ///< [s] B
    double place_target = 0.0;      ///< 1 + E
    double velocity_place = 0.0;    ///< [1/s^2] -omega^2 B
    double velocity_velocity = 0.0; ///< D - 1
    double velocity_target = 0.0;   ///< [1/s] (1 - A) / h

    /// For shaders.
    [[nodiscard]] SpringBlock block() const;
};

/// The step of `duration` [s], 0 or more: 0 leaves all as it is, a huge one ends at the target. Rejects what `validate` rejects,
/// and a duration that is negative or not finite.
[[nodiscard]] WINDROW_API Result<SpringStep> spring_step(const SpringClass& spring, double duration);

/// A frame of `duration` [s] for plants that swing on a device (windrow_blade_swing of shaders/coupling/windrow_plants.glsl): its
/// parts, at most 1/60 s each and at most 8, and a part's step. Ripples of the detail pass a filter first, up to 6/7 of the
/// spring's frequency, 3 Hz for grass; or to 0.15 of the frame rate where that is lower, as below 20 a second: what faster ones do
/// would be seen as noise. Rejects as `spring_step`.
[[nodiscard]] WINDROW_API Result<SwingBlock> swing_step(const SpringClass& spring, double duration);
/// The same of the class's four bands, in their order; one filter for all, that of the class.
[[nodiscard]] WINDROW_API Result<std::array<SwingBlock, 4>> swing_steps(const SpringClass& spring, double duration);

/// Class of leaves that oscillate about their stalks (shaders/numerics/flutter.glsl).
struct FlutterClass {
    /// [Hz] 1e-4 to 1000, default 6. Of the leaf's torsion; leaves differ by up to 30 %. The default is that of springs::leaf.
    double frequency_hz = 6.0;
    /// [rad] 0 to 1.5, default 0.6. Largest turn to either side. 0: none.
    float most = 0.6f;
    /// [m/s] 0 to 100, default 1.6. Wind from which on they flutter; 1.6 is where Beaufort's force 2 begins, at which leaves
    /// rustle.
    float onset = 1.6f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("frequency_hz", &FlutterClass::frequency_hz, {1e-4, 1000.0, "Hz"},
                    "Of the leaf's torsion; leaves differ by up to 30 %. The default is that of springs::leaf."),
            Setting("most", &FlutterClass::most, {0.0, 1.5, "rad"}, "Largest turn to either side. 0: none."),
            Setting("onset", &FlutterClass::onset, {0.0, 100.0, "m/s"},
                    "Wind from which on they flutter; 1.6 is where Beaufort's force 2 begins, at which leaves rustle."),
        };
    }
};

[[nodiscard]] WINDROW_API Result<void> validate(const FlutterClass& flutter);

/// Block of a frame that ends at `time` [s] and lasts `duration` [s]. The angles do not depend on the frame rate. Rejects a class out of range, a
/// time or a duration that is not finite and a negative duration.
[[nodiscard]] WINDROW_API Result<FlutterBlock> flutter_step(const FlutterClass& flutter, double time, double duration);

/// Springs side by side: component i of each array belongs to spring i. A vector's components are springs of their own.
template <class Real>
struct SpringBatch {
    std::span<Real> place;
    std::span<Real> velocity;            ///< [1/s]
    std::span<const Real> target_before; ///< at the start of the step
    std::span<const Real> target_now;    ///< at its end; may be the same array: a target that stays
    std::span<Real> place_remainder{};   ///< of as many: what rounding took, given back in the next step; 0 at first. Empty: none
    std::span<Real> velocity_remainder{}; ///< likewise; both or neither
    std::span<Real> place_previous{};     ///< receives the old `place`, for motion vectors. Empty: not needed
};

/// The springs of a batch after a step as bytes: place, velocity, target_now, and what it has of remainders and place_previous.
/// `Real` float or double. Rejects arrays of different lengths.
template <class Real>
[[nodiscard]] Result<std::vector<std::byte>> save_springs(const SpringBatch<Real>& batch);
/// Fills the arrays of a batch, and `target` with what is target_before in the next step: they go on to the bit. Rejects bytes that
/// save_springs did not return, and arrays that are not as many or as long as those saved; nothing has changed then.
template <class Real>
[[nodiscard]] Result<void> load_springs(std::span<const std::byte> bytes, const SpringBatch<Real>& batch, std::span<Real> target);

/// Advances all springs by one step, `Real` float or double. What falls below 1e-20 is 0. Rejects arrays of different lengths.
/// Any number of threads gives the same bits. In float a step rounds each place once: after thousands of short steps some 1e-6 of
/// the largest place. With the remainders, or in double, it is below that.
template <class Real>
Result<void> advance_springs(const SpringStep& step, const SpringBatch<Real>& batch, ParallelFor parallel_for = {});

extern template Result<std::vector<std::byte>> save_springs<float>(const SpringBatch<float>&);
extern template Result<std::vector<std::byte>> save_springs<double>(const SpringBatch<double>&);
extern template Result<void> load_springs<float>(std::span<const std::byte>, const SpringBatch<float>&, std::span<float>);
extern template Result<void> load_springs<double>(std::span<const std::byte>, const SpringBatch<double>&, std::span<double>);
extern template Result<void> advance_springs<float>(const SpringStep&, const SpringBatch<float>&, ParallelFor);
extern template Result<void> advance_springs<double>(const SpringStep&, const SpringBatch<double>&, ParallelFor);

} // namespace windrow
