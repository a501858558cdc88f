/* What the parts of the C89 host share: it is compiled as C89 and, without exceptions and RTTI, as C++. */
#ifndef WINDROW_TESTS_C_API_HOST_H
#define WINDROW_TESTS_C_API_HOST_H

#include <stdio.h>
#include <string.h>
#include <windrow/windrow.h>

extern int failures;

#define CHECK(condition)                                                                                                         \
    do {                                                                                                                         \
        if (!(condition)) {                                                                                                      \
            printf("%s:%d: %s fails; last error: %s\n", __FILE__, __LINE__, #condition, windrow_last_error());                   \
            ++failures;                                                                                                          \
        }                                                                                                                        \
    } while (0)
#define CHECK_OK(call) CHECK((call) == WINDROW_OK)
/* The call fails with this class, and the sentence has these words. */
#define CHECK_FAILS(call, result, words)                                                                                         \
    do {                                                                                                                         \
        CHECK((call) == (result));                                                                                               \
        CHECK(strstr(windrow_last_error(), words) != NULL);                                                                      \
    } while (0)

windrow_vec3 vec3(float x, float y, float z);
windrow_dvec3 dvec3(double x, double y, double z);
/* Whether two winds have the same cells, to the bit. */
int same_cells(const windrow_wind* a, const windrow_wind* b);
/* 24 x 12 x 24 cells of 1 m over a floor, 3 m/s along x. */
windrow_config small_config(void);

void check_wind(void);
void check_motors(void);
void check_obstacles(void);
void check_drag(void);
void check_errors(void);
void check_files(const char* folder);
void check_plants(void);
void check_motion(void);
void check_device(void);

#endif
