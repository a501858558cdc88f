/* Deposits of drag in C. */
#include "host.h"

#include <string.h>

void check_drag(void) {
    windrow_config config = small_config();
    windrow_wind* wind = NULL;
    windrow_plant_drag bush, got, plants[3];
    windrow_belt_drag hedge;
    windrow_drag_force force;
    windrow_drag_id planted, strip, ids[3];
    windrow_drag_kind kind = -1;
    windrow_vec3 lee;
    int n;

    CHECK_OK(windrow_wind_create(&config, &wind));
    CHECK_OK(windrow_plant_drag_init(&bush, sizeof bush));
    CHECK_OK(windrow_belt_drag_init(&hedge, sizeof hedge));
    bush.radius = 2.0f;
    bush.area = 8.0f;
    hedge.start = dvec3(6.0, 0.0, -8.0);
    hedge.end = dvec3(6.0, 0.0, 8.0);
    CHECK_OK(windrow_wind_add_plant_drag(wind, &bush, &planted));
    CHECK_OK(windrow_wind_add_belt_drag(wind, &hedge, &strip));
    for (n = 0; n < 3; ++n) {
        plants[n] = bush;
        plants[n].position = dvec3(-6.0, 0.0, 4.0 * n);
    }
    CHECK_OK(windrow_wind_add_plants(wind, plants, 3, ids));
    CHECK_OK(windrow_wind_add_plants(wind, plants, 1, NULL));
    CHECK_OK(windrow_wind_add_plants(wind, NULL, 0, NULL));
    CHECK(windrow_wind_drag_count(wind) == 6);
    plants[1].height = -1.0f;
    CHECK_FAILS(windrow_wind_add_plants(wind, plants, 3, ids), WINDROW_REJECTED, "height is -1");
    plants[1].struct_size = 8;
    CHECK_FAILS(windrow_wind_add_plants(wind, plants, 3, ids), WINDROW_REJECTED, "plants[1] has struct_size 8");
    CHECK(windrow_wind_drag_count(wind) == 6);

    for (n = 0; n < 40; ++n)
        CHECK_OK(windrow_wind_step(wind, 0.05, NULL));
    CHECK_OK(windrow_wind_velocity(wind, dvec3(1.0, 1.0, 0.0), &lee));
    CHECK(lee.x < 2.7f); /* 3 m/s came */
    CHECK_OK(windrow_drag_force_init(&force, sizeof force));
    CHECK_OK(windrow_wind_drag_force_on(wind, planted, &force));
    CHECK(force.force.x > 1.0f && force.in_box > 0.999f);

    CHECK_OK(windrow_wind_drag_kind(wind, strip, &kind));
    CHECK(kind == WINDROW_DRAG_BELT);
    CHECK_OK(windrow_plant_drag_init(&got, sizeof got));
    CHECK_OK(windrow_wind_get_plant_drag(wind, ids[2], &got));
    CHECK(got.position.z == 8.0 && got.area == 8.0f);
    CHECK_FAILS(windrow_wind_get_plant_drag(wind, strip, &got), WINDROW_REJECTED, "windrow_wind_drag_kind");
    CHECK_OK(windrow_wind_set_belt_drag(wind, planted, &hedge));
    CHECK_OK(windrow_wind_set_plant_drag(wind, strip, &bush));
    CHECK_OK(windrow_wind_get_belt_drag(wind, planted, &hedge));
    CHECK_OK(windrow_wind_remove_drag(wind, planted));
    CHECK_FAILS(windrow_wind_remove_drag(wind, planted), WINDROW_STALE, ".");
    CHECK_FAILS(windrow_wind_drag_force_on(wind, planted, &force), WINDROW_STALE, ".");
    CHECK_FAILS(windrow_wind_drag_kind(wind, planted, &kind), WINDROW_STALE, "drop the id");
    windrow_wind_destroy(wind);
}
