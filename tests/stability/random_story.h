// Random stories for rapidcheck: any box, sides, motors, steps, shifts and changes that a host may hand in. They shrink: to fewer
// events, then to the first of each choice's range, so that a failure is reported in its simplest form.
#pragma once

#include "tests/stability/story.h"

#include <rapidcheck.h>

namespace windrow::test {

/// A story of all kinds of events, in which motors push.
[[nodiscard]] rc::Gen<Story> any_story();
/// The same without motors, in still air between still walls. `config` draws the box and the solver; a step takes at most
/// `max_cells` (at the start's speed).
[[nodiscard]] rc::Gen<Story> calm_story(Config (*config)(), double max_cells);

/// Any box and solver.
[[nodiscard]] Config any_config();

// --- Choices, for callers of rapidcheck's `exec` and within properties ---------------------------------------------------

/// In [low, high], both included; shrinks toward `low`. Whatever the size that rapidcheck asks for.
[[nodiscard]] int pick(int low, int high);
[[nodiscard]] double real(double low, double high);
/// Uniform in the logarithm.
[[nodiscard]] double spread(double low, double high);
[[nodiscard]] Boundaries some_sides(double wall_speed);

} // namespace windrow::test
