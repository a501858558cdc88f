/* host FOLDER: a host in C89 that calls every part of the API. Returns 1 where a check fails. Files go into the folder. */
#include "host.h"

#include <stdlib.h>

int failures = 0;

windrow_vec3 vec3(float x, float y, float z) {
    windrow_vec3 vector;
    vector.x = x;
    vector.y = y;
    vector.z = z;
    return vector;
}
windrow_dvec3 dvec3(double x, double y, double z) {
    windrow_dvec3 vector;
    vector.x = x;
    vector.y = y;
    vector.z = z;
    return vector;
}

int same_cells(const windrow_wind* a, const windrow_wind* b) {
    const windrow_vec4 *cells_a = NULL, *cells_b = NULL;
    uint64_t count_a = 0, count_b = 1;
    CHECK_OK(windrow_wind_field(a, WINDROW_FRAME_NOW, &cells_a, &count_a, NULL));
    CHECK_OK(windrow_wind_field(b, WINDROW_FRAME_NOW, &cells_b, &count_b, NULL));
    return count_a == count_b && memcmp(cells_a, cells_b, (size_t)count_a * sizeof *cells_a) == 0;
}

windrow_config small_config(void) {
    windrow_config config;
    CHECK_OK(windrow_config_init(&config, sizeof config));
    config.cells.x = 24;
    config.cells.y = 12;
    config.cells.z = 24;
    config.boundaries = windrow_boundaries_open_over_floor();
    config.ambient = vec3(3.0f, 0.0f, 0.0f);
    return config;
}

/* --- Hooks --------------------------------------------------------------------------------------------------------------- */

typedef struct heap {
    int64_t held, calls;
} heap;

static void* heap_allocate(size_t bytes, size_t alignment, void* user) {
    heap* counts = (heap*)user;
    char* start = (char*)malloc(bytes + alignment + sizeof(void*));
    char* block;
    if (start == NULL)
        return NULL;
    block = start + sizeof(void*);
    block += alignment - (uintptr_t)block % alignment;
    memcpy(block - sizeof(void*), &start, sizeof start);
    counts->held += (int64_t)bytes;
    ++counts->calls;
    return block;
}
static void heap_release(void* memory, size_t bytes, size_t alignment, void* user) {
    void* start;
    memcpy(&start, (char*)memory - sizeof(void*), sizeof start);
    ((heap*)user)->held -= (int64_t)bytes;
    CHECK((uintptr_t)memory % alignment == 0);
    free(start);
}

/* As malloc is on many platforms: it does not keep to the alignment. */
static void* crooked_allocate(size_t bytes, size_t alignment, void* user) {
    return (char*)heap_allocate(bytes + 16, alignment, user) + 16;
}
static void crooked_release(void* memory, size_t bytes, size_t alignment, void* user) {
    heap_release((char*)memory - 16, bytes + 16, alignment, user);
}

typedef struct log_lines {
    int errors, warnings;
    char last[200];
} log_lines;

static void log_line(windrow_severity severity, const char* sentence, void* user) {
    log_lines* lines = (log_lines*)user;
    *(severity == WINDROW_SEVERITY_ERROR ? &lines->errors : &lines->warnings) += 1;
    strncpy(lines->last, sentence, sizeof lines->last - 1);
}

/* A step allocates nothing, and all that a wind holds comes back. */
static void check_hooks(heap* counts) {
    windrow_wind* wind = NULL;
    windrow_config config = small_config();
    windrow_gusts gusts;
    windrow_omni_motor buried;
    windrow_obstacle vast;
    windrow_vec3 felt;
    log_lines lines;
    int64_t calls;
    int n;
    memset(&lines, 0, sizeof lines);
    CHECK_OK(windrow_gusts_init(&gusts, sizeof gusts));
    gusts.intensity = 0.2f;
    config.gusts = &gusts;
    CHECK_OK(windrow_wind_create(&config, &wind));
    printf("%.2f %% of the wind's memory is the host's\n",
           100.0 * (double)counts->held / (double)windrow_wind_memory_bytes(wind));
    CHECK((double)counts->held >= 0.99 * (double)windrow_wind_memory_bytes(wind));
    CHECK((uint64_t)counts->held == windrow_allocated_bytes());
    CHECK_FAILS(windrow_set_allocator(NULL, NULL, NULL), WINDROW_REJECTED, "bytes are held");
    CHECK_OK(windrow_wind_advance(wind, 0.1, NULL, NULL));
    calls = counts->calls;
    for (n = 0; n < 10; ++n) {
        CHECK_OK(windrow_wind_follow(wind, dvec3(0.5 * n, 0.0, 0.0)));
        CHECK_OK(windrow_wind_advance(wind, 0.05, NULL, NULL));
    }
    for (n = 0; n < 10; ++n)
        CHECK_OK(windrow_wind_step(wind, 0.02, NULL));
    CHECK(counts->calls == calls);

    windrow_set_logger(log_line, &lines);
    CHECK(windrow_wind_follow(NULL, dvec3(0.0, 0.0, 0.0)) == WINDROW_REJECTED);
    CHECK(lines.errors == 1 && strcmp(lines.last, windrow_last_error()) == 0);
    CHECK_OK(windrow_omni_motor_init(&buried, sizeof buried));
    buried.position = dvec3(0.0, -1000.0, 0.0);
    CHECK_OK(windrow_wind_add_omni(wind, &buried, NULL));
    for (n = 0; n < 12; ++n) /* a line in all, also of frames without a tick */
        CHECK_OK(windrow_wind_advance(wind, 1.0 / 144.0, NULL, NULL));
    CHECK(lines.warnings == 1 && strstr(lines.last, "under the ground") != NULL);
    CHECK_OK(windrow_obstacle_init(&vast, sizeof vast));
    vast.shape = windrow_shape_sphere(1000.0f);
    CHECK_OK(windrow_wind_add_obstacle(wind, &vast, NULL));
    for (n = 0; n < 3; ++n)
        CHECK_OK(windrow_wind_step(wind, 0.02, NULL));
    CHECK(lines.warnings == 2 && strstr(lines.last, "more than half of the box") != NULL);
    CHECK_OK(windrow_wind_set_ambient(wind, vec3(600.0f, 0.0f, 0.0f))); /* 6 m/s, of a host that has centimetres */
    for (n = 0; n < 3; ++n)
        CHECK_OK(windrow_wind_felt(wind, dvec3(0.0, 0.0, 0.0), NULL, &felt));
    CHECK(lines.warnings == 3 && strstr(lines.last, "sampling.limit is below the mean wind") != NULL);
    windrow_set_logger(NULL, NULL);
    CHECK(windrow_wind_follow(NULL, dvec3(0.0, 0.0, 0.0)) == WINDROW_REJECTED && lines.errors == 1);

    windrow_wind_destroy(wind);
    CHECK(counts->held == 0 && windrow_allocated_bytes() == 0);
}

int main(int count, char** arguments) {
    heap counts;
    memset(&counts, 0, sizeof counts);
    CHECK(windrow_version() == WINDROW_VERSION && strcmp(windrow_version_string(), WINDROW_VERSION_STRING) == 0);
    CHECK(strcmp(windrow_last_error(), "") == 0);
    CHECK_FAILS(windrow_set_allocator(heap_allocate, NULL, NULL), WINDROW_REJECTED, "give allocate and release");
    CHECK_FAILS(windrow_set_allocator(crooked_allocate, crooked_release, &counts), WINDROW_REJECTED, "multiple of 64");
    CHECK_OK(windrow_set_allocator(heap_allocate, heap_release, &counts));

    check_hooks(&counts);
    check_wind();
    check_motors();
    check_obstacles();
    check_drag();
    check_errors();
    check_files(count > 1 ? arguments[1] : ".");
    if (windrow_has_part(WINDROW_PART_COUPLING)) {
        check_plants();
        check_motion();
    }
    if (windrow_has_part(WINDROW_PART_VULKAN))
        check_device();

    CHECK(counts.held == 0);
    CHECK_OK(windrow_set_allocator(NULL, NULL, NULL));
    printf("%d checks failed\n", failures);
    return failures > 0;
}
