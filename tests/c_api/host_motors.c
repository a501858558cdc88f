/* Each kind of motor: added, read back, replaced, moved, removed; and ids that are stale. */
#include "host.h"

/* Of one kind: what was added comes back to the bit, with the direction normalised where it has one. */
#define CHECK_KIND(kind, number, wind, motor, id)                                                                                \
    do {                                                                                                                         \
        windrow_##kind##_motor got;                                                                                              \
        windrow_motor_kind which = -1;                                                                                           \
        CHECK_OK(windrow_wind_add_##kind(wind, &(motor), &(id)));                                                                \
        CHECK_OK(windrow_wind_motor_kind(wind, id, &which));                                                                     \
        CHECK(which == (number));                                                                                                \
        CHECK_OK(windrow_##kind##_motor_init(&got, sizeof got));                                                                 \
        CHECK_OK(windrow_wind_get_##kind(wind, id, &got));                                                                       \
        CHECK(memcmp(&got, &(motor), sizeof got) == 0);                                                                          \
        CHECK_OK(windrow_wind_set_##kind(wind, id, &(motor)));                                                                   \
    } while (0)

void check_motors(void) {
    windrow_config config = small_config();
    windrow_wind *wind = NULL, *other = NULL;
    windrow_directional_motor fan;
    windrow_wake_motor wake;
    windrow_jet_motor jet;
    windrow_vortex_motor vortex;
    windrow_omni_motor omni;
    windrow_pressure_motor burst;
    windrow_motor_id fan_id, wake_id, jet_id, vortex_id, omni_id, burst_id;
    windrow_motor_kind kind;
    windrow_vec3 before, after;
    int n;

    CHECK_OK(windrow_wind_create(&config, &wind));
    CHECK_OK(windrow_directional_motor_init(&fan, sizeof fan));
    CHECK(fan.region.kind == WINDROW_REGION_SPHERE && fan.law.kind == WINDROW_LAW_DRIVE && fan.envelope.hold > 1e30f);
    fan.position = dvec3(0.0, 3.0, 0.0);
    fan.direction = vec3(0.0f, 0.0f, 1.0f);
    fan.region = windrow_region_cone(vec3(0.0f, 0.0f, 4.0f), 1.0f, 2.0f);
    fan.law = windrow_law_force(25.0f);
    CHECK_OK(windrow_wake_motor_init(&wake, sizeof wake));
    wake.law = windrow_wake_law_drive(20.0f, 0.9f);
    CHECK_OK(windrow_jet_motor_init(&jet, sizeof jet));
    jet.position = dvec3(2.0, 4.0, 2.0);
    CHECK_OK(windrow_vortex_motor_init(&vortex, sizeof vortex));
    vortex.lift = 0.5f;
    CHECK_OK(windrow_omni_motor_init(&omni, sizeof omni));
    omni.position = dvec3(-4.0, 3.0, 1.0);
    CHECK_OK(windrow_pressure_motor_init(&burst, sizeof burst));
    burst.duration = 0.02f; /* it ends within a second */

    CHECK_OK(windrow_wind_velocity(wind, dvec3(0.0, 3.0, 2.0), &before));
    CHECK_KIND(directional, WINDROW_MOTOR_DIRECTIONAL, wind, fan, fan_id);
    CHECK_KIND(wake, WINDROW_MOTOR_WAKE, wind, wake, wake_id);
    CHECK_KIND(jet, WINDROW_MOTOR_JET, wind, jet, jet_id);
    CHECK_KIND(vortex, WINDROW_MOTOR_VORTEX, wind, vortex, vortex_id);
    CHECK_KIND(omni, WINDROW_MOTOR_OMNI, wind, omni, omni_id);
    CHECK_KIND(pressure, WINDROW_MOTOR_PRESSURE, wind, burst, burst_id);
    CHECK(windrow_wind_motor_count(wind) == 6);
    for (n = 0; n < 15; ++n) {
        CHECK_OK(windrow_wind_move_motor(wind, wake_id, dvec3(0.3 * n, 1.0, 0.0)));
        CHECK_OK(windrow_wind_advance(wind, 1.0 / 30.0, NULL, NULL));
    }
    CHECK_OK(windrow_wind_velocity(wind, dvec3(0.0, 3.0, 2.0), &after));
    CHECK(after.z > before.z + 1.0f);

    CHECK_FAILS(windrow_wind_motor_kind(wind, burst_id, &kind), WINDROW_STALE, "was removed, has ended");
    CHECK_OK(windrow_wind_remove_motor(wind, fan_id));
    CHECK(windrow_wind_motor_count(wind) == 4);
    CHECK_FAILS(windrow_wind_remove_motor(wind, fan_id), WINDROW_STALE, ".");
    CHECK_FAILS(windrow_wind_move_motor(wind, fan_id, dvec3(0.0, 0.0, 0.0)), WINDROW_STALE, ".");
    CHECK_FAILS(windrow_wind_set_jet(wind, fan_id, &jet), WINDROW_STALE, ".");
    CHECK_FAILS(windrow_wind_get_jet(wind, wake_id, &jet), WINDROW_REJECTED, "windrow_wind_motor_kind");
    CHECK_OK(windrow_wind_create(&config, &other));
    CHECK_FAILS(windrow_wind_remove_motor(other, jet_id), WINDROW_STALE, ".");
    windrow_wind_destroy(other);

    CHECK_OK(windrow_wind_set_omni(wind, jet_id, &omni)); /* the kind changes */
    CHECK_OK(windrow_wind_motor_kind(wind, jet_id, &kind));
    CHECK(kind == WINDROW_MOTOR_OMNI);
    omni.radius = -1.0f;
    CHECK_FAILS(windrow_wind_add_omni(wind, &omni, NULL), WINDROW_REJECTED, "radius is -1");
    fan.region.kind = 12;
    CHECK_FAILS(windrow_wind_add_directional(wind, &fan, NULL), WINDROW_REJECTED, "region.kind is 12");
    fan.region = windrow_region_capsule(vec3(1.0f, 0.0f, 0.0f), 1.0f);
    CHECK_OK(windrow_wind_add_directional(wind, &fan, NULL));
    fan.region = windrow_region_box(vec3(1.0f, 1.0f, 1.0f));
    fan.law = windrow_law_drive(6.0f, 2.0f);
    CHECK_OK(windrow_wind_add_directional(wind, &fan, NULL));
    wake.law = windrow_wake_law_force(2.0f);
    CHECK_OK(windrow_wind_add_wake(wind, &wake, NULL));
    windrow_wind_destroy(wind);
}
