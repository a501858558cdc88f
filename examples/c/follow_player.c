/*
 * Tutorial: the README's ten lines in C89. A dog runs beside a player through a breeze, and a leaf feels its wake.
 *
 *     follow_player_c         prints the wind at the leaf after a second
 *
 * 1. Fill a config with defaults by its init function, then set what differs.
 * 2. Every call returns WINDROW_OK or a negative class; windrow_last_error has the sentence: field, value, fix.
 * 3. The box follows the player; a wake acts while its body moves; `advance` runs fixed ticks.
 * 4. Destroy what was created. Compile with a C or a C++ compiler, with or without exceptions and RTTI.
 */
#include <stdio.h>
#include <windrow/windrow.h>

static int fail(void) {
    fprintf(stderr, "%s\n", windrow_last_error());
    return 2;
}

static windrow_dvec3 at(double x, double y, double z) {
    windrow_dvec3 place;
    place.x = x;
    place.y = y;
    place.z = z;
    return place;
}

int main(void) {
    windrow_config config;
    windrow_wake_motor wake;
    windrow_wind* wind = NULL;
    windrow_motor_id dog;
    windrow_vec3 velocity;
    int frame;

    windrow_config_init(&config, sizeof config);
    config.boundaries = windrow_boundaries_open_over_floor();
    config.ambient.x = 3.0f;
    if (windrow_wind_create(&config, &wind) != WINDROW_OK)
        return fail();

    windrow_wake_motor_init(&wake, sizeof wake);
    wake.position = at(0.0, 0.5, 1.0);
    wake.radius = 0.6f;
    if (windrow_wind_add_wake(wind, &wake, &dog) != WINDROW_OK)
        return fail();

    for (frame = 0; frame < 60; ++frame) {
        windrow_wind_follow(wind, at(frame / 20.0, 1.0, 0.0));
        windrow_wind_move_motor(wind, dog, at(frame / 8.0, 0.5, 1.0));
        if (windrow_wind_advance(wind, 1.0 / 60.0, NULL, NULL) != WINDROW_OK)
            return fail();
    }
    if (windrow_wind_velocity(wind, at(4.0, 0.5, 1.0), &velocity) != WINDROW_OK)
        return fail();
    printf("%.2f m/s at the leaf\n", (double)velocity.x);
    windrow_wind_destroy(wind);
    return 0;
}
