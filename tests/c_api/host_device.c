/* The wind and the ground on a device that the library opens: no header of Vulkan. Where there is none, the reason is printed. */
#include "host.h"

#include <math.h>

typedef struct recording {
    windrow_wind* wind;
    windrow_vulkan_frame frame;
    windrow_vulkan_ground* ground;
    windrow_ground_step step;
    int saves;
    windrow_result result;
} recording;

static void record(void* commands, void* user) {
    recording* what = (recording*)user;
    if (what->wind != NULL)
        what->result = windrow_vulkan_wind_record_step(what->wind, commands, &what->frame, NULL);
    else
        what->result = windrow_vulkan_ground_record(what->ground, commands, &what->step, WINDROW_LEANS_EVERYWHERE);
    if (what->saves && what->result == WINDROW_OK)
        what->result = windrow_vulkan_ground_record_save(what->ground, commands);
}

static windrow_result run(windrow_vulkan_record record_frame, void* argument, void* user) {
    return windrow_vulkan_device_run((windrow_vulkan_device*)user, record_frame, argument);
}

static void check_device_wind(windrow_vulkan_device* device) {
    windrow_config config = small_config();
    windrow_vulkan_host host;
    windrow_vulkan_settings settings;
    windrow_vulkan_textures now, before;
    windrow_vulkan_pipeline_store* store = NULL;
    windrow_wind *wind = NULL, *cpu = NULL, *loaded = NULL;
    windrow_directional_motor fan;
    windrow_motor_id fan_id, cpu_id;
    windrow_diagnostics diagnostics;
    windrow_query query;
    windrow_dvec3 points[2];
    windrow_vec3 on_device[2], on_cpu[2];
    windrow_bytes* bytes = NULL;
    windrow_event_log* log = NULL;
    windrow_frame_block block;
    uint64_t memory = 0, reserved = 0;
    recording what;
    int n;
    memset(&what, 0, sizeof what);
    CHECK_OK(windrow_vulkan_host_init(&host, sizeof host));
    CHECK_OK(windrow_vulkan_device_host(device, 0, &host));
    CHECK(host.device != NULL && host.get_instance_proc_addr != NULL && windrow_vulkan_device_queue(device, 0) != NULL);
    CHECK_OK(windrow_vulkan_check(host.instance, host.physical_device, host.get_instance_proc_addr));
    CHECK_OK(windrow_vulkan_pipeline_store_create(&host, &store));
    host.pipeline_store = store;
    CHECK_OK(windrow_vulkan_settings_init(&settings, sizeof settings));
    settings.queries = WINDROW_VULKAN_READ_CELLS;
    settings.frames_in_flight = 1;
    CHECK_OK(windrow_vulkan_wind_required_bytes(&host, &config, &settings, &memory, &reserved));
    CHECK_OK(windrow_vulkan_wind_create(&host, &config, &settings, &wind));
    CHECK(windrow_wind_memory_bytes(wind) == memory && windrow_vulkan_wind_reserved_bytes(wind) == reserved);
    CHECK(windrow_vulkan_pipeline_store_count(store) > 0);
    CHECK_OK(windrow_wind_create(&config, &cpu));

    /* the same motors; the calls of the CPU alone name the ones of the device */
    CHECK_OK(windrow_directional_motor_init(&fan, sizeof fan));
    fan.position = dvec3(0.0, 3.0, 0.0);
    CHECK_OK(windrow_wind_add_directional(wind, &fan, &fan_id));
    CHECK_OK(windrow_wind_add_directional(cpu, &fan, &cpu_id));
    CHECK_FAILS(windrow_wind_step(wind, 0.1, NULL), WINDROW_UNSUPPORTED, "windrow_wind_step is for winds on the CPU");
    CHECK_FAILS(windrow_vulkan_wind_forget(cpu), WINDROW_UNSUPPORTED, "windrow_vulkan_wind_create");
    CHECK_OK(windrow_query_init(&query, sizeof query));
    points[0] = dvec3(1.0, 3.0, 0.0);
    points[1] = dvec3(-2.5, 2.0, 4.0);
    query.count = 2;
    query.positions = points;
    query.velocities = &on_device[0].x;
    CHECK_FAILS(windrow_wind_sample(wind, &query), WINDROW_NOT_READY, "no cells have come back yet");

    CHECK_OK(windrow_event_log_create(&log));
    CHECK_OK(windrow_wind_record_to(wind, log));
    what.wind = wind;
    CHECK_OK(windrow_vulkan_frame_init(&what.frame, sizeof what.frame));
    what.frame.dt = 0.02;
    what.frame.slot = 0;
    for (n = 0; n < 5; ++n) {
        what.frame.save = n == 4;
        CHECK_OK(windrow_vulkan_device_run(device, record, &what));
        CHECK_OK(what.result);
        CHECK(windrow_vulkan_wind_collect(wind, 0) == 1);
        CHECK_OK(windrow_wind_step(cpu, 0.02, NULL));
    }
    CHECK_OK(windrow_wind_record_to(wind, NULL));
    CHECK_OK(windrow_wind_sample(wind, &query));
    query.velocities = &on_cpu[0].x;
    CHECK_OK(windrow_wind_sample(cpu, &query));
    for (n = 0; n < 2; ++n) /* design: 1e-4 of the largest speed */
        CHECK(fabs((double)(on_device[n].x - on_cpu[n].x)) < 1e-3 && fabs((double)(on_device[n].y - on_cpu[n].y)) < 1e-3);
    CHECK_OK(windrow_diagnostics_init(&diagnostics, sizeof diagnostics));
    CHECK_OK(windrow_vulkan_wind_reported(wind, &diagnostics));
    CHECK(diagnostics.stepped == 1 && windrow_vulkan_wind_dispatches(wind) > 0 && windrow_vulkan_wind_barriers(wind) > 0);
    CHECK_OK(windrow_vulkan_wind_textures(wind, WINDROW_FRAME_NOW, &now));
    CHECK_OK(windrow_vulkan_wind_textures(wind, WINDROW_FRAME_PREVIOUS, &before));
    CHECK(now.vectors.image != 0 && now.vectors.view != 0 && before.vectors.image != now.vectors.image && now.axes[0].image == 0);
    CHECK(windrow_vulkan_wind_gust_buffer(wind) != 0);
    CHECK_OK(windrow_wind_frame_block(wind, dvec3(0.0, 0.0, 0.0), NULL, &block));
    CHECK(block.window.cells.x == 24.0f);

    CHECK_OK(windrow_vulkan_wind_saved(wind, &bytes));
    CHECK_OK(windrow_vulkan_wind_load(&host, windrow_bytes_data(bytes), windrow_bytes_size(bytes), &settings, &loaded));
    windrow_wind_destroy(loaded);
    CHECK_OK(windrow_wind_load(windrow_bytes_data(bytes), windrow_bytes_size(bytes), NULL, &loaded)); /* and on the CPU */
    windrow_wind_destroy(loaded);
    windrow_bytes_destroy(bytes);
    CHECK_OK(windrow_vulkan_wind_create(&host, &config, &settings, &loaded));
    CHECK_OK(windrow_wind_add_directional(loaded, &fan, NULL));
    CHECK_OK(windrow_vulkan_wind_replay(log, loaded, run, device));
    CHECK(windrow_vulkan_wind_collect(loaded, 0) >= 0);
    query.velocities = &on_cpu[0].x;
    CHECK_OK(windrow_wind_sample(loaded, &query));
    CHECK(memcmp(on_cpu, on_device, sizeof on_cpu) == 0); /* to the bit */
    windrow_wind_destroy(loaded);
    windrow_event_log_destroy(log);
    windrow_vulkan_pipeline_store_destroy(store);
    windrow_wind_destroy(wind);
    windrow_wind_destroy(cpu);
}

typedef struct device_heap {
    int calls;
} device_heap;

/* A host's allocator that has no memory. */
static int32_t no_memory(uint64_t size, uint64_t alignment, uint32_t types, uint32_t type, windrow_vulkan_memory* memory,
                         void* user) {
    CHECK(size > 0 && alignment > 0 && (types >> type & 1) == 1 && memory->memory == 0);
    ((device_heap*)user)->calls += 1;
    return -2; /* VK_ERROR_OUT_OF_DEVICE_MEMORY */
}
static void give_nothing_back(const windrow_vulkan_memory* memory, void* user) {
    CHECK(memory != NULL && user != NULL);
}

/* A frame of a wind that reads back in one way. */
static windrow_wind* one_frame(windrow_vulkan_device* device, windrow_vulkan_read_back queries, const windrow_dvec3* points) {
    windrow_config config = small_config();
    windrow_vulkan_host host;
    windrow_vulkan_settings settings;
    recording what;
    memset(&what, 0, sizeof what);
    CHECK_OK(windrow_vulkan_host_init(&host, sizeof host));
    CHECK_OK(windrow_vulkan_device_host(device, 0, &host));
    CHECK_OK(windrow_vulkan_settings_init(&settings, sizeof settings));
    settings.queries = queries;
    settings.timestamps = 1;
    settings.textures = WINDROW_VULKAN_AXES;
    CHECK_OK(windrow_vulkan_wind_create(&host, &config, &settings, &what.wind));
    CHECK_OK(windrow_vulkan_frame_init(&what.frame, sizeof what.frame));
    what.frame.slot = 0;
    what.frame.dt = 0.02;
    what.frame.points = points;
    what.frame.point_count = points != NULL ? 2 : 0;
    CHECK_OK(windrow_vulkan_device_submit(device, 0, record, &what));
    CHECK_OK(what.result);
    CHECK_OK(windrow_vulkan_device_wait(device));
    CHECK(windrow_vulkan_wind_collect(what.wind, 0) == 1);
    return what.wind;
}

static void check_read_backs(windrow_vulkan_device* device) {
    windrow_dvec3 points[2];
    const windrow_dvec3* positions = NULL;
    const windrow_vec4* velocities = NULL;
    const uint16_t* halves = NULL;
    windrow_vulkan_pass passes[64];
    windrow_vulkan_textures textures;
    windrow_vec3 velocity;
    uint64_t count = 0;
    uint32_t pass_count = 0;
    double whole_us = 0.0;
    windrow_wind* wind;
    points[0] = dvec3(1.0, 3.0, 0.0);
    points[1] = dvec3(2.0, 3.0, 0.0);
    wind = one_frame(device, WINDROW_VULKAN_READ_POINTS, points);
    CHECK_OK(windrow_vulkan_wind_points(wind, &positions, &velocities, &count));
    CHECK(count == 2 && positions[1].x == 2.0 && fabs((double)velocities[0].x - 3.0) < 1e-3);
    CHECK_FAILS(windrow_vulkan_wind_halves(wind, &halves, &count, NULL), WINDROW_NOT_READY, "halves");
    CHECK_OK(windrow_vulkan_wind_pass_times(wind, &whole_us, NULL, NULL, NULL, &pass_count));
    CHECK(whole_us > 0.0 && pass_count > 3 && pass_count <= 64);
    CHECK_OK(windrow_vulkan_wind_pass_times(wind, NULL, NULL, NULL, passes, &pass_count));
    CHECK(passes[0].name != NULL && passes[0].dispatches > 0);
    CHECK_OK(windrow_vulkan_wind_textures(wind, WINDROW_FRAME_NOW, &textures));
    CHECK(textures.vectors.image == 0 && textures.axes[2].view != 0);
    CHECK(windrow_vulkan_wind_query_age(wind) == 0.0);
    windrow_wind_destroy(wind);

    wind = one_frame(device, WINDROW_VULKAN_READ_HALVES, NULL);
    CHECK_OK(windrow_vulkan_wind_halves(wind, &halves, &count, NULL));
    CHECK(count == 24 * 12 * 24 && fabs((double)windrow_from_half(halves[0]) - 3.0) < 0.01);
    CHECK_OK(windrow_wind_velocity(wind, points[0], &velocity));
    CHECK(fabs((double)velocity.x - 3.0) < 0.01);
    CHECK_FAILS(windrow_vulkan_wind_points(wind, &positions, &velocities, &count), WINDROW_NOT_READY, "points");
    windrow_wind_destroy(wind);
}

static void check_device_memory(windrow_vulkan_device* device) {
    windrow_config config = small_config();
    windrow_vulkan_host host;
    windrow_wind* wind = NULL;
    device_heap heap;
    heap.calls = 0;
    CHECK_OK(windrow_vulkan_host_init(&host, sizeof host));
    CHECK_OK(windrow_vulkan_device_host(device, 0, &host));
    host.allocate = no_memory;
    CHECK_FAILS(windrow_vulkan_wind_create(&host, &config, NULL, &wind), WINDROW_REJECTED, "memory");
    host.release = give_nothing_back;
    host.memory_user = &heap;
    CHECK_FAILS(windrow_vulkan_wind_create(&host, &config, NULL, &wind), WINDROW_OUT_OF_MEMORY, "VK_ERROR_OUT_OF_DEVICE_MEMORY");
    CHECK(wind == NULL && heap.calls > 0);
}

static void check_device_ground(windrow_vulkan_device* device) {
    windrow_vulkan_host host;
    windrow_ground_config config;
    windrow_vulkan_texture texture;
    windrow_ground_block block;
    windrow_bytes* bytes = NULL;
    windrow_ground* on_cpu = NULL;
    windrow_vulkan_ground* again = NULL;
    recording what;
    memset(&what, 0, sizeof what);
    CHECK_OK(windrow_vulkan_host_init(&host, sizeof host));
    CHECK_OK(windrow_vulkan_device_host(device, 0, &host));
    CHECK_OK(windrow_ground_config_init(&config, sizeof config));
    CHECK_FAILS(windrow_vulkan_ground_create(&host, &config, 5, &what.ground), WINDROW_REJECTED, "texel is 5");
    CHECK_OK(windrow_vulkan_ground_create(&host, &config, WINDROW_TEXEL_HALF, &what.ground));
    CHECK_OK(windrow_vulkan_ground_follow(what.ground, dvec3(3.0, 0.0, 0.0)));
    CHECK_OK(windrow_ground_step_init(&what.step, sizeof what.step));
    what.step.duration = 0.1;
    CHECK_OK(windrow_vulkan_device_run(device, record, &what));
    CHECK_OK(what.result);
    CHECK_FAILS(windrow_vulkan_ground_saved(what.ground, &bytes), WINDROW_REJECTED, "has nothing");
    what.saves = 1;
    CHECK_OK(windrow_vulkan_device_run(device, record, &what));
    CHECK_OK(what.result);
    CHECK_OK(windrow_vulkan_ground_saved(what.ground, &bytes));
    CHECK_OK(windrow_ground_load(windrow_bytes_data(bytes), windrow_bytes_size(bytes), NULL, &on_cpu));
    CHECK_OK(windrow_vulkan_ground_load(&host, windrow_bytes_data(bytes), windrow_bytes_size(bytes), WINDROW_TEXEL_HALF, &again));
    windrow_bytes_destroy(bytes);
    windrow_ground_destroy(on_cpu);
    windrow_vulkan_ground_destroy(again);
    CHECK_OK(windrow_vulkan_ground_texture(what.ground, WINDROW_FRAME_NOW, &texture));
    CHECK_OK(windrow_vulkan_ground_block(what.ground, dvec3(0.0, 0.0, 0.0), &block));
    CHECK(texture.view != 0 && block.now.corner.w == 128.0f && windrow_vulkan_ground_memory_bytes(what.ground) > 0);
    windrow_vulkan_ground_destroy(what.ground);
}

void check_device(void) {
    windrow_vulkan_device_list* list = NULL;
    windrow_vulkan_device_settings settings;
    windrow_vulkan_device_facts facts;
    windrow_vulkan_requirements requirements;
    windrow_vulkan_device* device = NULL;
    const char *const surface = "VK_KHR_surface", *const no_such = "VK_KHR_no_such_extension";
    CHECK_OK(windrow_vulkan_requirements_init(&requirements, sizeof requirements));
    CHECK(requirements.shared_bytes == 16384 && strcmp(windrow_vulkan_result_name(0), "VK_SUCCESS") == 0);
    if (windrow_vulkan_device_list_create(&list) != WINDROW_OK) {
        printf("no device: %s\n", windrow_last_error());
        return;
    }
    CHECK_OK(windrow_vulkan_device_facts_init(&facts, sizeof facts));
    CHECK(windrow_vulkan_device_list_count(list) > 0);
    CHECK_OK(windrow_vulkan_device_list_get(list, 0, &facts));
    printf("device 0: %s, Vulkan %s\n", facts.name, facts.api_version);
    CHECK_FAILS(windrow_vulkan_device_list_get(list, 99, &facts), WINDROW_REJECTED, "index is 99");
    windrow_vulkan_device_list_destroy(list);
    CHECK_OK(windrow_vulkan_device_settings_init(&settings, sizeof settings));
    settings.validation = windrow_vulkan_has_validation_layer();
    /* of the instance: one that no driver has is rejected, one that all have is taken */
    settings.instance_extension_count = 1;
    CHECK_FAILS(windrow_vulkan_device_create(&settings, &device), WINDROW_REJECTED, "instance_extensions is null");
    settings.instance_extensions = &no_such;
    CHECK(windrow_vulkan_device_create(&settings, &device) != WINDROW_OK && device == NULL);
    settings.instance_extensions = &surface;
    CHECK_OK(windrow_vulkan_device_create(&settings, &device));
    check_device_wind(device);
    check_read_backs(device);
    check_device_memory(device);
    if (windrow_has_part(WINDROW_PART_COUPLING))
        check_device_ground(device);
    CHECK(windrow_vulkan_device_messages(device) == 0);
    windrow_vulkan_device_destroy(device);
}
