/*
 * The wind on a device, inside the host's renderer (fluid/vulkan/wind.h).
 *
 *     windrow_vulkan_wind_create(&host, &config, NULL, &wind);
 *     windrow_wind_follow(wind, player);                           the calls of wind.h, motors.h and obstacles.h are the same
 *     windrow_vulkan_frame_init(&frame, sizeof frame);
 *     frame.dt = frame_seconds;
 *     windrow_vulkan_wind_record(wind, command_buffer, &frame, NULL, NULL);
 *
 * It submits nothing and waits for nothing.
 */
#ifndef WINDROW_C_API_VULKAN_WIND_H
#define WINDROW_C_API_VULKAN_WIND_H

#include "event_log.h"
#include "vulkan_host.h"
#include "wind.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef int32_t windrow_vulkan_texture_set;
enum { WINDROW_VULKAN_VECTORS = 0, WINDROW_VULKAN_AXES = 1, WINDROW_VULKAN_BOTH = 2 };
typedef int32_t windrow_vulkan_read_back;
enum {
    WINDROW_VULKAN_READ_NONE = 0,
    WINDROW_VULKAN_READ_CELLS = 1,  /* all cells: the reading calls of wind.h */
    WINDROW_VULKAN_READ_HALVES = 2, /* windrow_wind_velocity, windrow_vulkan_wind_halves */
    WINDROW_VULKAN_READ_BOX = 3,    /* a box of cells: the reading calls of wind.h */
    WINDROW_VULKAN_READ_POINTS = 4  /* windrow_vulkan_wind_points */
};
typedef struct windrow_vulkan_settings {
    uint32_t struct_size;
    /* Bits of a component in the textures. Default halves. */
    windrow_texel texel;
    /* Textures that each frame writes; others are not created. Default WINDROW_VULKAN_VECTORS: one fetch a sample. */
    windrow_vulkan_texture_set textures;
    /* Frames that the host keeps in flight, 1 to 8: as many read-backs wait for their turn. Default 2. */
    int32_t frames_in_flight;
    /* 1: room for gusts that begin later than the wind (16 bytes a cell). Default 0: only where the config has them. */
    int32_t gusts;
    /* 1: times each pass on the device. Default 0: it costs two timestamps a dispatch. */
    int32_t timestamps;
    /* What comes back to the host with each frame. Default WINDROW_VULKAN_READ_NONE. */
    windrow_vulkan_read_back queries;
    /* [cells] Size of WINDROW_VULKAN_READ_BOX, at most the wind's box. Default (8, 8, 8): a body and its surroundings. */
    windrow_ivec3 read_cells;
    /* Most points of a frame with WINDROW_VULKAN_READ_POINTS, 1 to 4096. Default 64. */
    int32_t read_points;
    /* Most obstacles in the box whose forces come back with each frame, 0 to 16384. Default 0: none. */
    int32_t forces;
    /* VkExternalMemoryHandleTypeFlagBits that the textures' memory can be exported as. Default 0: none. */
    uint32_t export_textures;
    /* 1: makes the passes for obstacles on creation. Default 0: with the first obstacle in the box. */
    int32_t obstacles;
} windrow_vulkan_settings;
WINDROW_C_API windrow_result windrow_vulkan_settings_init(windrow_vulkan_settings* settings, uint32_t struct_size);

/* A frame to record. */
typedef struct windrow_vulkan_frame {
    uint32_t struct_size;
    int32_t slot;                /* of the frame in flight; -1: the one after the last */
    double dt;                   /* [s] */
    const windrow_dvec3* around; /* centre of WINDROW_VULKAN_READ_BOX; null: the point that the box follows */
    uint64_t point_count;
    const windrow_dvec3* points; /* of WINDROW_VULKAN_READ_POINTS */
    int32_t save;                /* 1: windrow_vulkan_wind_saved returns this recording's state */
    uint32_t reserved;           /* 0 */
} windrow_vulkan_frame;
WINDROW_C_API windrow_result windrow_vulkan_frame_init(windrow_vulkan_frame* frame, uint32_t struct_size);

/* --- Life: `settings` may be null ---------------------------------------------------------------------------------------- */

/* [bytes] Device memory before it is made. */
WINDROW_C_API windrow_result windrow_vulkan_wind_required_bytes(const windrow_vulkan_host* host, const windrow_config* config,
                                                                const windrow_vulkan_settings* settings, uint64_t* memory,
                                                                uint64_t* reserved);
/* The same inside a wind on the CPU. */
WINDROW_C_API windrow_result windrow_vulkan_wind_required_bytes_inside(const windrow_vulkan_host* host,
                                                                       const windrow_config* config,
                                                                       const windrow_vulkan_settings* settings,
                                                                       const windrow_wind* outer, uint64_t* memory,
                                                                       uint64_t* reserved);
WINDROW_C_API windrow_result windrow_vulkan_wind_create(const windrow_vulkan_host* host, const windrow_config* config,
                                                        const windrow_vulkan_settings* settings, windrow_wind** wind);
/* Inside a wind on the CPU: windrow_wind_create_inside. The host samples `outer` for each tick, and uploads 16 bytes for each cell of
   the box and its halo. */
WINDROW_C_API windrow_result windrow_vulkan_wind_create_inside(const windrow_vulkan_host* host, const windrow_config* config,
                                                               const windrow_vulkan_settings* settings, const windrow_wind* outer,
                                                               windrow_wind** wind);
/* From bytes of either backend. */
WINDROW_C_API windrow_result windrow_vulkan_wind_load(const windrow_vulkan_host* host, const void* bytes, uint64_t size,
                                                      const windrow_vulkan_settings* settings, windrow_wind** wind);
WINDROW_C_API windrow_result windrow_vulkan_wind_load_inside(const windrow_vulkan_host* host, const void* bytes, uint64_t size,
                                                             const windrow_vulkan_settings* settings, const windrow_wind* outer,
                                                             windrow_wind** wind);
/* The state of the last recording with frame.save; WINDROW_NOT_READY until its slot is done. */
WINDROW_C_API windrow_result windrow_vulkan_wind_saved(windrow_wind* wind, windrow_bytes** bytes);

/* --- Frames -------------------------------------------------------------------------------------------------------------- */

/* Records the ticks that are due into a VkCommandBuffer. `advance` and `last` may be null. */
WINDROW_C_API windrow_result windrow_vulkan_wind_record(windrow_wind* wind, void* commands, const windrow_vulkan_frame* frame,
                                                        windrow_advance* advance, windrow_diagnostics* last);
/* Records one step of frame.dt. */
WINDROW_C_API windrow_result windrow_vulkan_wind_record_step(windrow_wind* wind, void* commands,
                                                             const windrow_vulkan_frame* frame, windrow_diagnostics* diagnostics);
/* Takes the read-back of a slot that the host has waited for; 0 where there is none. */
WINDROW_C_API int32_t windrow_vulkan_wind_collect(windrow_wind* wind, int32_t slot);
/* After a recording that is never submitted. */
WINDROW_C_API windrow_result windrow_vulkan_wind_forget(windrow_wind* wind);
/* Records with `record`, submits and waits; WINDROW_OK or an error of the host's. */
typedef windrow_result (*windrow_vulkan_run)(windrow_vulkan_record record, void* argument, void* user);
WINDROW_C_API windrow_result windrow_vulkan_wind_replay(const windrow_event_log* log, windrow_wind* wind, windrow_vulkan_run run,
                                                        void* user);

/* --- For shaders --------------------------------------------------------------------------------------------------------- */

typedef struct windrow_vulkan_texture {
    uint64_t image; /* VkImage */
    uint64_t view;  /* VkImageView */
} windrow_vulkan_texture;
/* What the settings leave out is 0. */
typedef struct windrow_vulkan_textures {
    windrow_vulkan_texture vectors;
    windrow_vulkan_texture axes[3];
} windrow_vulkan_textures;
WINDROW_C_API windrow_result windrow_vulkan_wind_textures(const windrow_wind* wind, windrow_frame frame,
                                                          windrow_vulkan_textures* textures);
/* VkBuffer of the gust tile. */
WINDROW_C_API uint64_t windrow_vulkan_wind_gust_buffer(const windrow_wind* wind);
typedef struct windrow_vulkan_exported_image {
    uint64_t image;                /* VkImage */
    uint64_t memory;               /* VkDeviceMemory */
    uint64_t offset, size;         /* [bytes] */
    uint32_t handle_type;          /* VkExternalMemoryHandleTypeFlagBits */
    int32_t format;                /* VkFormat */
    uint32_t width, height, depth; /* [texels] */
    uint32_t reserved;
} windrow_vulkan_exported_image;
/* `count`: room in `images`; receives their number. `images` may be null to ask for it. */
WINDROW_C_API windrow_result windrow_vulkan_wind_exported_images(const windrow_wind* wind, windrow_vulkan_exported_image* images,
                                                                 uint32_t* count);

enum { WINDROW_VULKAN_MAX_BINDINGS = 8 };
/* Fills a VkSamplerCreateInfo for the textures. */
WINDROW_C_API windrow_result windrow_vulkan_sampler_info(const windrow_boundaries* boundaries, void* sampler_info);
/* Fills at most 8 VkDescriptorSetLayoutBinding for windrow_wind.glsl; returns their number. `stages` is VkShaderStageFlags. */
WINDROW_C_API uint32_t windrow_vulkan_set_bindings(windrow_vulkan_texture_set textures, uint32_t stages, uint32_t first,
                                                   void* bindings);
/* Contents of a set. */
typedef struct windrow_vulkan_set_content {
    windrow_vulkan_textures now, before;
    uint64_t sampler;      /* VkSampler; 0: immutable ones */
    uint64_t block;        /* VkBuffer of a windrow_frame_block */
    uint64_t block_offset; /* [bytes] */
    uint64_t tile;         /* VkBuffer: windrow_vulkan_wind_gust_buffer, or any of 16 bytes */
} windrow_vulkan_set_content;
/* The writes of a VkDescriptorSet, for vkUpdateDescriptorSets or push descriptors. */
typedef struct windrow_vulkan_set_writes windrow_vulkan_set_writes;
WINDROW_C_API windrow_result windrow_vulkan_set_writes_create(uint64_t set, const windrow_vulkan_set_content* content,
                                                              windrow_vulkan_texture_set textures, uint32_t first,
                                                              windrow_vulkan_set_writes** writes);
WINDROW_C_API void windrow_vulkan_set_writes_destroy(windrow_vulkan_set_writes* writes);
/* Array of VkWriteDescriptorSet. */
WINDROW_C_API const void* windrow_vulkan_set_writes_data(const windrow_vulkan_set_writes* writes);
WINDROW_C_API uint32_t windrow_vulkan_set_writes_count(const windrow_vulkan_set_writes* writes);

/* --- What was read back: good until the next recording or a collect that takes one --------------------------------------- */

/* Cells as halves: x, y, z and 0 each. `count`: cells. `origin` may be null. */
WINDROW_C_API windrow_result windrow_vulkan_wind_halves(const windrow_wind* wind, const uint16_t** cells, uint64_t* count,
                                                        windrow_dvec3* origin);
WINDROW_C_API windrow_result windrow_vulkan_wind_points(const windrow_wind* wind, const windrow_dvec3** positions,
                                                        const windrow_vec4** velocities, uint64_t* count);
/* [s] Time of the frames recorded since. */
WINDROW_C_API double windrow_vulkan_wind_query_age(const windrow_wind* wind);
/* Of the last tick that was read back. */
WINDROW_C_API windrow_result windrow_vulkan_wind_reported(windrow_wind* wind, windrow_diagnostics* diagnostics);
WINDROW_C_API int32_t windrow_vulkan_wind_dispatches(const windrow_wind* wind);
WINDROW_C_API int32_t windrow_vulkan_wind_barriers(const windrow_wind* wind);
WINDROW_C_API uint64_t windrow_vulkan_wind_reserved_bytes(const windrow_wind* wind);
typedef struct windrow_vulkan_pass {
    const char* name;
    int32_t dispatches;
    uint32_t reserved;
    double us; /* [us] */
} windrow_vulkan_pass;
/* Times of the last recording that was read back. `count`: room in `passes`, receives their number; `passes` may be null. */
WINDROW_C_API windrow_result windrow_vulkan_wind_pass_times(const windrow_wind* wind, double* whole_us, double* read_back_us,
                                                            int32_t* untimed, windrow_vulkan_pass* passes, uint32_t* count);

#ifdef __cplusplus
}
#endif

#endif
