/*
 * A Vulkan device for winds and grounds: the host's own, or one that the library opens (fluid/vulkan/host.h, own_device.h).
 *
 * No header of Vulkan is needed. Dispatchable handles (VkInstance, VkDevice, VkQueue, VkCommandBuffer) are void*; others are uint64_t.
 * A host with C++ or C headers of Vulkan casts its handles.
 */
#ifndef WINDROW_C_API_VULKAN_HOST_H
#define WINDROW_C_API_VULKAN_HOST_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* PFN_vkVoidFunction and PFN_vkGetInstanceProcAddr. */
typedef void (*windrow_vulkan_function)(void);
typedef windrow_vulkan_function (*windrow_vulkan_get_instance_proc_addr)(void* instance, const char* name);

/* A block of device memory from the host's own allocator. */
typedef struct windrow_vulkan_memory {
    uint64_t memory; /* VkDeviceMemory */
    uint64_t offset; /* [bytes] */
    void* mapped;    /* address of the block where host-visible memory was asked for */
    uint64_t user;   /* the host's own; given back with the block */
} windrow_vulkan_memory;
/* Returns a VkResult. */
typedef int32_t (*windrow_vulkan_allocate)(uint64_t size, uint64_t alignment, uint32_t memory_type_bits, uint32_t type_index,
                                           windrow_vulkan_memory* memory, void* user);
typedef void (*windrow_vulkan_release)(const windrow_vulkan_memory* memory, void* user);
/* Called for each pipeline that was created, with the name of its pass. */
typedef void (*windrow_vulkan_pipeline_created)(const char* name, uint64_t pipeline, void* user);

/* Compute pipelines for all winds of a device. */
typedef struct windrow_vulkan_pipeline_store windrow_vulkan_pipeline_store;

/* The host's device. All of it outlives what is made from it. */
typedef struct windrow_vulkan_host {
    uint32_t struct_size;
    uint32_t queue_family; /* of the queue that runs the command buffers */
    void* instance;
    void* physical_device;
    void* device;
    windrow_vulkan_get_instance_proc_addr get_instance_proc_addr;
    const void* allocation_callbacks;                    /* VkAllocationCallbacks; null: the driver's own */
    uint64_t pipeline_cache;                             /* VkPipelineCache; 0: none */
    const windrow_vulkan_pipeline_store* pipeline_store; /* null: each wind makes its own */
    const uint32_t* reader_queue_families;               /* other families whose queues sample the textures */
    uint32_t reader_queue_family_count;
    uint32_t reader_stages;           /* VkPipelineStageFlags that sample; 0: vertex, fragment and compute */
    uint32_t shared_bytes;            /* 0: the device's limit */
    uint32_t pipeline_flags;          /* VkPipelineCreateFlags */
    windrow_vulkan_allocate allocate; /* the host's allocator: both or neither */
    windrow_vulkan_release release;
    void* memory_user;
    windrow_vulkan_pipeline_created pipeline_created; /* null: not wanted */
    void* pipeline_user;
} windrow_vulkan_host;
WINDROW_C_API windrow_result windrow_vulkan_host_init(windrow_vulkan_host* host, uint32_t struct_size);

/* Requirements of the device, for its creation; no extension is needed. */
typedef struct windrow_vulkan_requirements {
    uint32_t struct_size;
    uint32_t api_version;
    uint32_t shared_bytes;    /* maxComputeSharedMemorySize */
    uint32_t invocations;     /* maxComputeWorkGroupInvocations */
    uint32_t storage_buffers; /* maxPerStageDescriptorStorageBuffers */
    uint32_t storage_images;  /* maxPerStageDescriptorStorageImages */
} windrow_vulkan_requirements;
/* Fills it with them. */
WINDROW_C_API windrow_result windrow_vulkan_requirements_init(windrow_vulkan_requirements* requirements, uint32_t struct_size);
/* Enables what is required in a VkPhysicalDeviceFeatures; leaves the rest. */
WINDROW_C_API windrow_result windrow_vulkan_require_features(void* features);
/* All reasons why a physical device cannot run the wind, one per line. */
WINDROW_C_API windrow_result windrow_vulkan_check(void* instance, void* physical_device,
                                                  windrow_vulkan_get_instance_proc_addr get_instance_proc_addr);
/* Name of a VkResult. */
WINDROW_C_API const char* windrow_vulkan_result_name(int32_t result);

WINDROW_C_API windrow_result windrow_vulkan_pipeline_store_create(const windrow_vulkan_host* host,
                                                                  windrow_vulkan_pipeline_store** store);
/* What uses the store keeps it. */
WINDROW_C_API void windrow_vulkan_pipeline_store_destroy(windrow_vulkan_pipeline_store* store);
WINDROW_C_API uint64_t windrow_vulkan_pipeline_store_count(const windrow_vulkan_pipeline_store* store);

/* --- A device of the library's own, for tools, tests and hosts without Vulkan -------------------------------------------- */

typedef struct windrow_vulkan_device_facts {
    uint32_t struct_size;
    int32_t software;        /* 1: it runs on the CPU */
    const char* name;        /* the strings are good as long as the list or the device */
    const char* driver;      /* name and version */
    const char* api_version; /* "1.3.230" */
    const char* trouble;     /* why it cannot run the wind; empty: it can */
} windrow_vulkan_device_facts;
WINDROW_C_API windrow_result windrow_vulkan_device_facts_init(windrow_vulkan_device_facts* facts, uint32_t struct_size);

typedef struct windrow_vulkan_device_list windrow_vulkan_device_list;
/* The devices of this machine; an error where there is no loader, no driver or no device. */
WINDROW_C_API windrow_result windrow_vulkan_device_list_create(windrow_vulkan_device_list** list);
WINDROW_C_API void windrow_vulkan_device_list_destroy(windrow_vulkan_device_list* list);
WINDROW_C_API int32_t windrow_vulkan_device_list_count(const windrow_vulkan_device_list* list);
WINDROW_C_API windrow_result windrow_vulkan_device_list_get(const windrow_vulkan_device_list* list, int32_t index,
                                                            windrow_vulkan_device_facts* facts);
/* 1 if this machine has the validation layer. */
WINDROW_C_API int32_t windrow_vulkan_has_validation_layer(void);

/* Called for each message of the validation layer. */
typedef void (*windrow_vulkan_message)(const char* text, void* user);
typedef struct windrow_vulkan_device_settings {
    uint32_t struct_size;
    int32_t device; /* index in the list; -1, the default: the first hardware device, else the first */
    /* 1: core and synchronisation checks of the validation layer, rejected where it is absent. Default 0. */
    int32_t validation;
    /* 1: and GPU-assisted ones. Default 0. */
    int32_t gpu_validation;
    uint32_t queue;         /* VkQueueFlags that the queue has; default VK_QUEUE_COMPUTE_BIT */
    uint32_t queue_without; /* and has not; default 0 */
    int32_t compute_queue;  /* 1: a second queue for the wind; default 0 */
    /* Number of `extensions`. Default 0. */
    uint32_t extension_count;
    const char* const* extensions; /* of the device; one that it lacks is rejected */
    const void* wished;            /* VkPhysicalDeviceFeatures that are enabled where the device has them; null: none */
    const void* next;              /* chained to VkDeviceCreateInfo; null: none */
    windrow_vulkan_get_instance_proc_addr get_instance_proc_addr; /* null: the system's loader is opened */
    windrow_vulkan_message on_message;                            /* null: to the logger, as warnings */
    /* Handed to `on_message`. */
    void* message_user;
    const char* const* instance_extensions; /* of the instance, such as those of a window's surface; null: none */
    uint32_t instance_extension_count;      /* default 0: a device that draws on no window needs none */
    uint32_t reserved;                      /* 0 */
} windrow_vulkan_device_settings;
WINDROW_C_API windrow_result windrow_vulkan_device_settings_init(windrow_vulkan_device_settings* settings, uint32_t struct_size);

typedef struct windrow_vulkan_device windrow_vulkan_device;
WINDROW_C_API windrow_result windrow_vulkan_device_create(const windrow_vulkan_device_settings* settings,
                                                          windrow_vulkan_device** device);
/* After all that was made from it. */
WINDROW_C_API void windrow_vulkan_device_destroy(windrow_vulkan_device* device);
/* `compute` 1: of a wind on the second queue. */
WINDROW_C_API windrow_result windrow_vulkan_device_host(const windrow_vulkan_device* device, int32_t compute,
                                                        windrow_vulkan_host* host);
WINDROW_C_API void* windrow_vulkan_device_queue(const windrow_vulkan_device* device, int32_t compute);
WINDROW_C_API windrow_result windrow_vulkan_device_get_facts(const windrow_vulkan_device* device,
                                                             windrow_vulkan_device_facts* facts);
/* The VkPhysicalDeviceFeatures that are enabled. */
WINDROW_C_API const void* windrow_vulkan_device_features(const windrow_vulkan_device* device);
/* Messages of the validation layer so far. */
WINDROW_C_API int32_t windrow_vulkan_device_messages(const windrow_vulkan_device* device);

/* Records commands into a VkCommandBuffer. */
typedef void (*windrow_vulkan_record)(void* commands, void* user);
/* Records, submits and waits. */
WINDROW_C_API windrow_result windrow_vulkan_device_run(windrow_vulkan_device* device, windrow_vulkan_record record, void* user);
/* Records and submits; each slot has a command buffer of its own, whose work is waited for first. */
WINDROW_C_API windrow_result windrow_vulkan_device_submit(windrow_vulkan_device* device, int32_t slot,
                                                          windrow_vulkan_record record, void* user);
/* Until nothing is in flight. */
WINDROW_C_API windrow_result windrow_vulkan_device_wait(windrow_vulkan_device* device);

#ifdef __cplusplus
}
#endif

#endif
