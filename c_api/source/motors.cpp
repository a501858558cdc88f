// Calls of motors.h.
#include "c_api/motors.h"

#include "c_api/source/tables.h"
#include "fluid/core/message.h"

using namespace windrow;
using namespace windrow::c_api;

namespace {

windrow_result fail_stale(const std::string& why) {
    return fail(WINDROW_STALE, why);
}

template <class C>
windrow_result add(windrow_wind* wind, const C* motor, windrow_motor_id* id) {
    return call({{wind, "wind"}, {motor, "motor"}}, [&] {
        return with(motor, [&](const auto& wanted) -> windrow_result {
            const Result<MotorId> added = wind->control->motors().add(wanted);
            if (added && id != nullptr)
                *id = {added->slot, added->generation, added->owner};
            return done(added);
        });
    });
}

/// The outcome of a call with an id; its class is WINDROW_STALE where the id names nothing.
windrow_result done_with(const windrow_wind* wind, MotorId id, const Result<void>& outcome) {
    if (!outcome && wind->control->motors().find(id) == nullptr)
        return fail_stale(outcome.error());
    return done(outcome);
}

template <class C>
windrow_result set(windrow_wind* wind, windrow_motor_id id, const C* motor) {
    return call({{wind, "wind"}, {motor, "motor"}}, [&] {
        return with(motor, [&](const auto& wanted) {
            const auto named = id_of<MotorId>(id);
            return done_with(wind, named, wind->control->motors().set(named, wanted));
        });
    });
}

/// Runs use(motor) on the motor that an id names.
template <class Use>
windrow_result with_motor(const windrow_wind* wind, windrow_motor_id id, const Use& use) {
    const Motor* const motor = wind->control->motors().find(id_of<MotorId>(id));
    if (motor == nullptr)
        return fail_stale("the motor's id names none: it was removed, has ended, or another wind gave it; drop the id.");
    return use(*motor);
}

template <class C>
windrow_result get(const windrow_wind* wind, windrow_motor_id id, C* out) {
    return call({{wind, "wind"}, {out, "motor"}}, [&]() -> windrow_result {
        if (const windrow_result outcome = check_output(out); outcome != WINDROW_OK)
            return outcome;
        return with_motor(wind, id, [&](const Motor& motor) -> windrow_result {
            const auto* const kind = std::get_if<typename Fields<C>::Cpp>(&motor);
            if (kind == nullptr)
                return fail(WINDROW_REJECTED, detail::message("the motor is not a ", std::string_view(Fields<C>::k_name),
                                                              ": ask windrow_wind_motor_kind first."));
            give_cpp(*kind, out);
            return WINDROW_OK;
        });
    });
}

template <class Choice, class Kind>
Choice made(std::int32_t kind, const Kind& fill) {
    Choice choice{};
    choice.kind = kind;
    fill(choice);
    return choice;
}

} // namespace

WINDROW_EXPORT windrow_region windrow_region_sphere(float radius) {
    return made<windrow_region>(WINDROW_REGION_SPHERE, [&](auto& region) { region.radius = radius; });
}
WINDROW_EXPORT windrow_region windrow_region_capsule(windrow_vec3 half_axis, float radius) {
    return made<windrow_region>(WINDROW_REGION_CAPSULE, [&](auto& region) {
        region.half_axis = half_axis;
        region.radius = radius;
    });
}
WINDROW_EXPORT windrow_region windrow_region_box(windrow_vec3 half_size) {
    return made<windrow_region>(WINDROW_REGION_BOX, [&](auto& region) { region.half_size = half_size; });
}
WINDROW_EXPORT windrow_region windrow_region_cone(windrow_vec3 axis, float start_radius, float end_radius) {
    return made<windrow_region>(WINDROW_REGION_CONE, [&](auto& region) {
        region.axis = axis;
        region.start_radius = start_radius;
        region.end_radius = end_radius;
    });
}
WINDROW_EXPORT windrow_law windrow_law_force(float acceleration) {
    return {WINDROW_LAW_FORCE, acceleration, 0.0f, 0.0f};
}
WINDROW_EXPORT windrow_law windrow_law_drive(float speed, float rate) {
    return {WINDROW_LAW_DRIVE, 0.0f, speed, rate};
}
WINDROW_EXPORT windrow_wake_law windrow_wake_law_force(float strength) {
    return {WINDROW_LAW_FORCE, strength, 0.0f, 0.0f};
}
WINDROW_EXPORT windrow_wake_law windrow_wake_law_drive(float per_metre, float entrainment) {
    return {WINDROW_LAW_DRIVE, 0.0f, per_metre, entrainment};
}

#define WINDROW_MOTOR(kind)                                                                                                      \
    WINDROW_C_INIT(windrow_##kind##_motor)                                                                                       \
    WINDROW_EXPORT windrow_result windrow_wind_add_##kind(windrow_wind* wind, const windrow_##kind##_motor* motor,               \
                                                          windrow_motor_id* id) {                                                \
        return add(wind, motor, id);                                                                                             \
    }                                                                                                                            \
    WINDROW_EXPORT windrow_result windrow_wind_set_##kind(windrow_wind* wind, windrow_motor_id id,                               \
                                                          const windrow_##kind##_motor* motor) {                                 \
        return set(wind, id, motor);                                                                                             \
    }                                                                                                                            \
    WINDROW_EXPORT windrow_result windrow_wind_get_##kind(const windrow_wind* wind, windrow_motor_id id,                         \
                                                          windrow_##kind##_motor* motor) {                                       \
        return get(wind, id, motor);                                                                                             \
    }
WINDROW_MOTOR(directional)
WINDROW_MOTOR(wake)
WINDROW_MOTOR(jet)
WINDROW_MOTOR(vortex)
WINDROW_MOTOR(omni)
WINDROW_MOTOR(pressure)

WINDROW_EXPORT windrow_result windrow_wind_motor_kind(const windrow_wind* wind, windrow_motor_id id, windrow_motor_kind* kind) {
    return call({{wind, "wind"}, {kind, "kind"}}, [&] {
        return with_motor(wind, id, [&](const Motor& motor) -> windrow_result {
            *kind = static_cast<windrow_motor_kind>(motor.index());
            return WINDROW_OK;
        });
    });
}
WINDROW_EXPORT windrow_result windrow_wind_move_motor(windrow_wind* wind, windrow_motor_id id, windrow_dvec3 position) {
    return call({{wind, "wind"}}, [&] {
        const auto named = id_of<MotorId>(id);
        return done_with(wind, named, wind->control->motors().move(named, to_cpp(position)));
    });
}
WINDROW_EXPORT windrow_result windrow_wind_remove_motor(windrow_wind* wind, windrow_motor_id id) {
    return call({{wind, "wind"}}, [&] {
        const auto named = id_of<MotorId>(id);
        return done_with(wind, named, wind->control->motors().remove(named));
    });
}
WINDROW_EXPORT int32_t windrow_wind_motor_count(const windrow_wind* wind) {
    return value_of(wind, "wind", [&] { return wind->control->motors().count(); });
}
