// Plan of a tick: as many sub-steps as keep the Courant number below its limit, or the maximal number with limited speeds. Where
// fewer are recorded, the remaining time is carried over to the next tick. Made from the plan of the last tick and from what the
// passes before have found of this one's, so that many invocations may derive it; one keeps it.
#include "numerics/diffusion.glsl"
#include "numerics/substeps.glsl"

WindrowPlan planned() {
    const float dt = tick.duration, h = tick.cell_size, max_cfl = tick.max_cfl, behind = control.behind;
    WindrowPlan plan;
    plan.fastest_component = is_on(WINDROW_COUNTED) ? control.left_fastest : control.fastest_component;
    plan.fastest_in_rows = is_on(WINDROW_COUNTED) ? control.left_in_rows : control.fastest_in_rows;
    plan.largest_force = control.largest_force;
    plan.nonfinite_cells = control.nonfinite_cells;
    const float cfl = windrow_courant(uintBitsToFloat(plan.fastest_component), uintBitsToFloat(plan.largest_force), dt, h);
    const bool catches_up = behind > 0.0f;
    const float time = dt + behind; // [s] from where the air is to the tick's end
    const bool capped =
        is_on(WINDROW_ADVECTS) && windrow_wanted_substeps(cfl, max_cfl) > float(tick.max_substeps) && is_on(WINDROW_LIMITS);
    int substeps = 1;
    float part = time;
    if (tick.forced_substeps > 0) {
        substeps = tick.forced_substeps;
        part = time / float(substeps);
    } else if (is_on(WINDROW_ADVECTS)) {
        // Courant numbers of all this time, once speeds are cut.
        const float courant =
            min(catches_up ? cfl * (time / dt) : cfl, capped ? max_cfl * float(tick.max_substeps) * (time / dt) : 3.0e38f);
        substeps = windrow_substeps(windrow_wanted_substeps(courant, max_cfl), tick.recorded_substeps);
        part = courant > windrow_speed_rounding * max_cfl * float(substeps) ? time * (max_cfl / courant) : time / float(substeps);
    }
    plan.first_slot = control.next_slot;
    plan.substeps = substeps;
    plan.capped = capped ? 1 : 0;
    plan.undiffused_time = control.last_undiffused; // plan.comp has more of it
    plan.begin = -behind;
    plan.carried_time = part * float(substeps) < 0.99999f * time ? time - part * float(substeps) : 0.0f;
    plan.previous_duration = control.last_duration;
    plan.substep_duration = part;
    plan.max_speed = capped ? windrow_fastest_carried(max_cfl, tick.max_substeps, h, dt) : 1.0e30f;
    plan.cfl = cfl;
    plan.unused_a = plan.unused_b = 0u;
    return plan;
}

// By one invocation, for the passes to come.
void count_repaired(uint nonfinite_cells) {
    const bool first = is_on(WINDROW_FIRST_TICK);
    control.repaired_cells = nonfinite_cells + (first ? 0u : control.repaired_cells);
    if (first)
        control.limited_cells = 0u;
}

#ifdef WINDROW_MAY_PLAN
// First of all in `main`. `keeps`: this invocation keeps a plan that no pass has made. Without viscosity and cut speeds the rest of
// it is as it was.
void find_plan(bool keeps) {
    if (!is_on(WINDROW_PLANS)) {
        own_plan = control.plan;
        return;
    }
    own_plan = planned();
    if (!keeps)
        return;
    control.plan.substep_duration = own_plan.substep_duration;
    control.plan.previous_duration = own_plan.previous_duration;
    control.plan.cfl = own_plan.cfl;
    control.plan.first_slot = own_plan.first_slot;
    control.plan.substeps = own_plan.substeps;
    control.plan.carried_time = own_plan.carried_time;
    control.plan.begin = own_plan.begin;
    control.plan.capped = 0;
    control.plan.fastest_component = own_plan.fastest_component;
    control.plan.fastest_in_rows = own_plan.fastest_in_rows;
    control.plan.largest_force = own_plan.largest_force;
    control.plan.nonfinite_cells = own_plan.nonfinite_cells;
    count_repaired(own_plan.nonfinite_cells);
}
#endif
