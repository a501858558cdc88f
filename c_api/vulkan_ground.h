/* The memory of the ground on a device, inside the host's renderer (coupling/vulkan/ground_memory.h). Settings and walkers are those of
   motion.h. It submits nothing and waits for nothing. */
#ifndef WINDROW_C_API_VULKAN_GROUND_H
#define WINDROW_C_API_VULKAN_GROUND_H

#include "motion.h"
#include "vulkan_wind.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef int32_t windrow_wind_leans;
enum { WINDROW_LEANS_EVERYWHERE = 0, WINDROW_LEANS_EACH_TEXEL = 1 };
typedef struct windrow_vulkan_ground windrow_vulkan_ground;
WINDROW_C_API windrow_result windrow_vulkan_ground_create(const windrow_vulkan_host* host, const windrow_ground_config* config,
                                                          windrow_texel texel, windrow_vulkan_ground** ground);
/* No recording of it is in flight. */
WINDROW_C_API void windrow_vulkan_ground_destroy(windrow_vulkan_ground* ground);
WINDROW_C_API windrow_result windrow_vulkan_ground_follow(windrow_vulkan_ground* ground, windrow_dvec3 point);
/* As windrow_ground_shift_origin. */
WINDROW_C_API windrow_result windrow_vulkan_ground_shift_origin(windrow_vulkan_ground* ground, windrow_dvec3 offset);
WINDROW_C_API windrow_result windrow_vulkan_ground_record(windrow_vulkan_ground* ground, void* commands,
                                                          const windrow_ground_step* step, windrow_wind_leans leans);
/* Records a copy of all of it as the last record left it; when its commands have run, `saved` returns the bytes of windrow_ground_save,
   once. They load here and by windrow_ground_load. */
WINDROW_C_API windrow_result windrow_vulkan_ground_record_save(windrow_vulkan_ground* ground, void* commands);
WINDROW_C_API windrow_result windrow_vulkan_ground_saved(windrow_vulkan_ground* ground, windrow_bytes** bytes);
/* The textures hold nothing before the first record. */
WINDROW_C_API windrow_result windrow_vulkan_ground_load(const windrow_vulkan_host* host, const void* bytes, uint64_t size,
                                                        windrow_texel texel, windrow_vulkan_ground** ground);
/* VkBuffer of two floats a slot, for WINDROW_LEANS_EACH_TEXEL. */
WINDROW_C_API uint64_t windrow_vulkan_ground_lean_buffer(const windrow_vulkan_ground* ground);
WINDROW_C_API int32_t windrow_vulkan_ground_walkers_left_out(const windrow_vulkan_ground* ground);
WINDROW_C_API windrow_result windrow_vulkan_ground_next_place(const windrow_vulkan_ground* ground, windrow_dvec3 anchor,
                                                              windrow_ground_place_block* place);
WINDROW_C_API windrow_result windrow_vulkan_ground_texture(const windrow_vulkan_ground* ground, windrow_frame frame,
                                                           windrow_vulkan_texture* texture);
WINDROW_C_API windrow_result windrow_vulkan_ground_block(const windrow_vulkan_ground* ground, windrow_dvec3 anchor,
                                                         windrow_ground_block* block);
WINDROW_C_API uint64_t windrow_vulkan_ground_memory_bytes(const windrow_vulkan_ground* ground);
WINDROW_C_API uint64_t windrow_vulkan_ground_reserved_bytes(const windrow_vulkan_ground* ground);

#ifdef __cplusplus
}
#endif

#endif
