/* A host of MSVC: compiled for its ABI, linked with windrow_c.lib, without a C library. The DLL is MinGW-w64's. */
#include <windrow/windrow.h>

int _fltused = 0; /* MSVC's word that the program has floats */

int start(void) {
    windrow_config config;
    windrow_wind* wind = 0;
    windrow_dvec3 leaf;
    windrow_vec3 velocity;
    int frame;
    if (windrow_version() != WINDROW_VERSION || windrow_config_init(&config, sizeof config) != WINDROW_OK)
        return 1;
    config.ambient.x = 3.0f;
    config.cell_size = -1.0f;
    if (windrow_wind_create(&config, &wind) == WINDROW_OK || windrow_last_error()[0] == '\0')
        return 2;
    config.cell_size = 1.0f;
    if (windrow_wind_create(&config, &wind) != WINDROW_OK)
        return 3;
    leaf.x = 1e6;
    leaf.y = 0.5;
    leaf.z = -1e6;
    for (frame = 0; frame < 8; ++frame)
        if (windrow_wind_follow(wind, leaf) != WINDROW_OK || windrow_wind_advance(wind, 1.0 / 60.0, 0, 0) != WINDROW_OK)
            return 4;
    if (windrow_wind_velocity(wind, leaf, &velocity) != WINDROW_OK || !(velocity.x > 2.9f && velocity.x < 3.1f))
        return 5;
    windrow_wind_destroy(wind);
    return 0;
}
