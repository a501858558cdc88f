"""Made by ./dev schema from the headers of c_api, where units, ranges and defaults are. Do not edit."""
import ctypes as c

from .air import *
from .bodies import *
from .operators import *
from .plants import *

P = c.POINTER
VDB_ONE_VECTOR = 0; VDB_THREE_SCALARS = 1
VDB_FULL = 0; VDB_HALF = 1
VDB_UP_Y = 0; VDB_UP_Z = 1
VDB_OPENVDB = 0; VDB_NANOVDB = 1
VULKAN_VECTORS = 0; VULKAN_AXES = 1; VULKAN_BOTH = 2
VULKAN_READ_NONE = 0; VULKAN_READ_CELLS = 1; VULKAN_READ_HALVES = 2; VULKAN_READ_BOX = 3; VULKAN_READ_POINTS = 4
VULKAN_MAX_BINDINGS = 8
LEANS_EVERYWHERE = 0; LEANS_EACH_TEXEL = 1


class VdbOptions(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("form", c.c_int32), ("name", c.c_char_p), ("precision", c.c_int32),
                ("up", c.c_int32), ("time", c.c_double), ("frame", c.c_int32), ("format", c.c_int32)]


class VdbScalar(c.Structure):
    _fields_ = [("name", c.c_char_p), ("units", c.c_char_p), ("values", P(c.c_float)), ("outside", c.c_float),
                ("reserved", c.c_uint32)]


class VdbVector(c.Structure):
    _fields_ = [("name", c.c_char_p), ("units", c.c_char_p), ("values", P(Vec4))]


class VdbGrid(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("cells", IVec3), ("origin", DVec3), ("outside", Vec3),
                ("cell_size", c.c_float), ("count", c.c_uint64), ("field", P(Vec4)), ("obstacle", P(c.c_float)),
                ("cell_height", c.c_float), ("scalar_count", c.c_uint32), ("vector_count", c.c_uint32),
                ("reserved", c.c_uint32), ("scalars", P(VdbScalar)), ("vectors", P(VdbVector))]


class VdbFilm(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("has_region", c.c_int32), ("low", DVec3), ("high", DVec3),
                ("margin", c.c_double), ("voxel_size", c.c_float), ("speed", c.c_int32), ("vorticity", c.c_int32),
                ("scalar_count", c.c_uint32), ("scalars", P(VdbScalar))]


class VulkanMemory(c.Structure):
    _fields_ = [("memory", c.c_uint64), ("offset", c.c_uint64), ("mapped", c.c_void_p), ("user", c.c_uint64)]

VulkanFunction = c.CFUNCTYPE(None)

VulkanGetInstanceProcAddr = c.CFUNCTYPE(VulkanFunction, c.c_void_p, c.c_char_p)

VulkanAllocate = c.CFUNCTYPE(c.c_int32, c.c_uint64, c.c_uint64, c.c_uint32, c.c_uint32, P(VulkanMemory), c.c_void_p)

VulkanRelease = c.CFUNCTYPE(None, P(VulkanMemory), c.c_void_p)

VulkanPipelineCreated = c.CFUNCTYPE(None, c.c_char_p, c.c_uint64, c.c_void_p)


class VulkanHost(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("queue_family", c.c_uint32), ("instance", c.c_void_p),
                ("physical_device", c.c_void_p), ("device", c.c_void_p),
                ("get_instance_proc_addr", VulkanGetInstanceProcAddr), ("allocation_callbacks", c.c_void_p),
                ("pipeline_cache", c.c_uint64), ("pipeline_store", c.c_void_p),
                ("reader_queue_families", P(c.c_uint32)), ("reader_queue_family_count", c.c_uint32),
                ("reader_stages", c.c_uint32), ("shared_bytes", c.c_uint32), ("pipeline_flags", c.c_uint32),
                ("allocate", VulkanAllocate), ("release", VulkanRelease), ("memory_user", c.c_void_p),
                ("pipeline_created", VulkanPipelineCreated), ("pipeline_user", c.c_void_p)]


class VulkanRequirements(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("api_version", c.c_uint32), ("shared_bytes", c.c_uint32),
                ("invocations", c.c_uint32), ("storage_buffers", c.c_uint32), ("storage_images", c.c_uint32)]


class VulkanDeviceFacts(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("software", c.c_int32), ("name", c.c_char_p), ("driver", c.c_char_p),
                ("api_version", c.c_char_p), ("trouble", c.c_char_p)]

VulkanMessage = c.CFUNCTYPE(None, c.c_char_p, c.c_void_p)


class VulkanDeviceSettings(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("device", c.c_int32), ("validation", c.c_int32),
                ("gpu_validation", c.c_int32), ("queue", c.c_uint32), ("queue_without", c.c_uint32),
                ("compute_queue", c.c_int32), ("extension_count", c.c_uint32), ("extensions", P(c.c_char_p)),
                ("wished", c.c_void_p), ("next", c.c_void_p), ("get_instance_proc_addr", VulkanGetInstanceProcAddr),
                ("on_message", VulkanMessage), ("message_user", c.c_void_p), ("instance_extensions", P(c.c_char_p)),
                ("instance_extension_count", c.c_uint32), ("reserved", c.c_uint32)]


class VulkanSettings(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("texel", c.c_int32), ("textures", c.c_int32),
                ("frames_in_flight", c.c_int32), ("gusts", c.c_int32), ("timestamps", c.c_int32),
                ("queries", c.c_int32), ("read_cells", IVec3), ("read_points", c.c_int32), ("forces", c.c_int32),
                ("export_textures", c.c_uint32), ("obstacles", c.c_int32)]


class VulkanFrame(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("slot", c.c_int32), ("dt", c.c_double), ("around", P(DVec3)),
                ("point_count", c.c_uint64), ("points", P(DVec3)), ("save", c.c_int32), ("reserved", c.c_uint32)]


class VulkanTexture(c.Structure):
    _fields_ = [("image", c.c_uint64), ("view", c.c_uint64)]


class VulkanTextures(c.Structure):
    _fields_ = [("vectors", VulkanTexture), ("axes", VulkanTexture * 3)]


class VulkanExportedImage(c.Structure):
    _fields_ = [("image", c.c_uint64), ("memory", c.c_uint64), ("offset", c.c_uint64), ("size", c.c_uint64),
                ("handle_type", c.c_uint32), ("format", c.c_int32), ("width", c.c_uint32), ("height", c.c_uint32),
                ("depth", c.c_uint32), ("reserved", c.c_uint32)]


class VulkanSetContent(c.Structure):
    _fields_ = [("now", VulkanTextures), ("before", VulkanTextures), ("sampler", c.c_uint64), ("block", c.c_uint64),
                ("block_offset", c.c_uint64), ("tile", c.c_uint64)]


class VulkanPass(c.Structure):
    _fields_ = [("name", c.c_char_p), ("dispatches", c.c_int32), ("reserved", c.c_uint32), ("us", c.c_double)]

VulkanRecord = c.CFUNCTYPE(None, c.c_void_p, c.c_void_p)

VulkanRun = c.CFUNCTYPE(c.c_int32, VulkanRecord, c.c_void_p, c.c_void_p)


# Each function with the types of its result and of its arguments.
DEVICE = [
    ("windrow_vdb_has_nanovdb", c.c_int32),
    ("windrow_vdb_options_init", c.c_int32, P(VdbOptions), c.c_uint32),
    ("windrow_vdb_write", c.c_int32, c.c_void_p, c.c_char_p, P(VdbOptions)),
    ("windrow_vdb_write_frame", c.c_int32, c.c_void_p, c.c_char_p, c.c_char_p, c.c_int32, c.c_int32, c.c_double,
     P(VdbOptions)),
    ("windrow_vdb_grid_init", c.c_int32, P(VdbGrid), c.c_uint32),
    ("windrow_vdb_write_grid", c.c_int32, P(VdbGrid), c.c_char_p, P(VdbOptions)),
    ("windrow_vdb_film_init", c.c_int32, P(VdbFilm), c.c_uint32),
    ("windrow_vdb_write_film", c.c_int32, c.c_void_p, P(VdbFilm), c.c_char_p, P(VdbOptions)),
    ("windrow_vulkan_host_init", c.c_int32, P(VulkanHost), c.c_uint32),
    ("windrow_vulkan_requirements_init", c.c_int32, P(VulkanRequirements), c.c_uint32),
    ("windrow_vulkan_require_features", c.c_int32, c.c_void_p),
    ("windrow_vulkan_check", c.c_int32, c.c_void_p, c.c_void_p, VulkanGetInstanceProcAddr),
    ("windrow_vulkan_result_name", c.c_char_p, c.c_int32),
    ("windrow_vulkan_pipeline_store_create", c.c_int32, P(VulkanHost), P(c.c_void_p)),
    ("windrow_vulkan_pipeline_store_destroy", None, c.c_void_p),
    ("windrow_vulkan_pipeline_store_count", c.c_uint64, c.c_void_p),
    ("windrow_vulkan_device_facts_init", c.c_int32, P(VulkanDeviceFacts), c.c_uint32),
    ("windrow_vulkan_device_list_create", c.c_int32, P(c.c_void_p)),
    ("windrow_vulkan_device_list_destroy", None, c.c_void_p),
    ("windrow_vulkan_device_list_count", c.c_int32, c.c_void_p),
    ("windrow_vulkan_device_list_get", c.c_int32, c.c_void_p, c.c_int32, P(VulkanDeviceFacts)),
    ("windrow_vulkan_has_validation_layer", c.c_int32),
    ("windrow_vulkan_device_settings_init", c.c_int32, P(VulkanDeviceSettings), c.c_uint32),
    ("windrow_vulkan_device_create", c.c_int32, P(VulkanDeviceSettings), P(c.c_void_p)),
    ("windrow_vulkan_device_destroy", None, c.c_void_p),
    ("windrow_vulkan_device_host", c.c_int32, c.c_void_p, c.c_int32, P(VulkanHost)),
    ("windrow_vulkan_device_queue", c.c_void_p, c.c_void_p, c.c_int32),
    ("windrow_vulkan_device_get_facts", c.c_int32, c.c_void_p, P(VulkanDeviceFacts)),
    ("windrow_vulkan_device_features", c.c_void_p, c.c_void_p),
    ("windrow_vulkan_device_messages", c.c_int32, c.c_void_p),
    ("windrow_vulkan_device_run", c.c_int32, c.c_void_p, VulkanRecord, c.c_void_p),
    ("windrow_vulkan_device_submit", c.c_int32, c.c_void_p, c.c_int32, VulkanRecord, c.c_void_p),
    ("windrow_vulkan_device_wait", c.c_int32, c.c_void_p),
    ("windrow_vulkan_settings_init", c.c_int32, P(VulkanSettings), c.c_uint32),
    ("windrow_vulkan_frame_init", c.c_int32, P(VulkanFrame), c.c_uint32),
    ("windrow_vulkan_wind_required_bytes", c.c_int32, P(VulkanHost), P(Config), P(VulkanSettings), P(c.c_uint64),
     P(c.c_uint64)),
    ("windrow_vulkan_wind_required_bytes_inside", c.c_int32, P(VulkanHost), P(Config), P(VulkanSettings), c.c_void_p,
     P(c.c_uint64), P(c.c_uint64)),
    ("windrow_vulkan_wind_create", c.c_int32, P(VulkanHost), P(Config), P(VulkanSettings), P(c.c_void_p)),
    ("windrow_vulkan_wind_create_inside", c.c_int32, P(VulkanHost), P(Config), P(VulkanSettings), c.c_void_p,
     P(c.c_void_p)),
    ("windrow_vulkan_wind_load", c.c_int32, P(VulkanHost), c.c_void_p, c.c_uint64, P(VulkanSettings), P(c.c_void_p)),
    ("windrow_vulkan_wind_load_inside", c.c_int32, P(VulkanHost), c.c_void_p, c.c_uint64, P(VulkanSettings), c.c_void_p,
     P(c.c_void_p)),
    ("windrow_vulkan_wind_saved", c.c_int32, c.c_void_p, P(c.c_void_p)),
    ("windrow_vulkan_wind_record", c.c_int32, c.c_void_p, c.c_void_p, P(VulkanFrame), P(Advance), P(Diagnostics)),
    ("windrow_vulkan_wind_record_step", c.c_int32, c.c_void_p, c.c_void_p, P(VulkanFrame), P(Diagnostics)),
    ("windrow_vulkan_wind_collect", c.c_int32, c.c_void_p, c.c_int32),
    ("windrow_vulkan_wind_forget", c.c_int32, c.c_void_p),
    ("windrow_vulkan_wind_replay", c.c_int32, c.c_void_p, c.c_void_p, VulkanRun, c.c_void_p),
    ("windrow_vulkan_wind_textures", c.c_int32, c.c_void_p, c.c_int32, P(VulkanTextures)),
    ("windrow_vulkan_wind_gust_buffer", c.c_uint64, c.c_void_p),
    ("windrow_vulkan_wind_exported_images", c.c_int32, c.c_void_p, P(VulkanExportedImage), P(c.c_uint32)),
    ("windrow_vulkan_sampler_info", c.c_int32, P(Boundaries), c.c_void_p),
    ("windrow_vulkan_set_bindings", c.c_uint32, c.c_int32, c.c_uint32, c.c_uint32, c.c_void_p),
    ("windrow_vulkan_set_writes_create", c.c_int32, c.c_uint64, P(VulkanSetContent), c.c_int32, c.c_uint32,
     P(c.c_void_p)),
    ("windrow_vulkan_set_writes_destroy", None, c.c_void_p),
    ("windrow_vulkan_set_writes_data", c.c_void_p, c.c_void_p),
    ("windrow_vulkan_set_writes_count", c.c_uint32, c.c_void_p),
    ("windrow_vulkan_wind_halves", c.c_int32, c.c_void_p, P(P(c.c_uint16)), P(c.c_uint64), P(DVec3)),
    ("windrow_vulkan_wind_points", c.c_int32, c.c_void_p, P(P(DVec3)), P(P(Vec4)), P(c.c_uint64)),
    ("windrow_vulkan_wind_query_age", c.c_double, c.c_void_p),
    ("windrow_vulkan_wind_reported", c.c_int32, c.c_void_p, P(Diagnostics)),
    ("windrow_vulkan_wind_dispatches", c.c_int32, c.c_void_p),
    ("windrow_vulkan_wind_barriers", c.c_int32, c.c_void_p),
    ("windrow_vulkan_wind_reserved_bytes", c.c_uint64, c.c_void_p),
    ("windrow_vulkan_wind_pass_times", c.c_int32, c.c_void_p, P(c.c_double), P(c.c_double), P(c.c_int32), P(VulkanPass),
     P(c.c_uint32)),
    ("windrow_vulkan_ground_create", c.c_int32, P(VulkanHost), P(GroundConfig), c.c_int32, P(c.c_void_p)),
    ("windrow_vulkan_ground_destroy", None, c.c_void_p),
    ("windrow_vulkan_ground_follow", c.c_int32, c.c_void_p, DVec3),
    ("windrow_vulkan_ground_shift_origin", c.c_int32, c.c_void_p, DVec3),
    ("windrow_vulkan_ground_record", c.c_int32, c.c_void_p, c.c_void_p, P(GroundStep), c.c_int32),
    ("windrow_vulkan_ground_record_save", c.c_int32, c.c_void_p, c.c_void_p),
    ("windrow_vulkan_ground_saved", c.c_int32, c.c_void_p, P(c.c_void_p)),
    ("windrow_vulkan_ground_load", c.c_int32, P(VulkanHost), c.c_void_p, c.c_uint64, c.c_int32, P(c.c_void_p)),
    ("windrow_vulkan_ground_lean_buffer", c.c_uint64, c.c_void_p),
    ("windrow_vulkan_ground_walkers_left_out", c.c_int32, c.c_void_p),
    ("windrow_vulkan_ground_next_place", c.c_int32, c.c_void_p, DVec3, P(GroundPlaceBlock)),
    ("windrow_vulkan_ground_texture", c.c_int32, c.c_void_p, c.c_int32, P(VulkanTexture)),
    ("windrow_vulkan_ground_block", c.c_int32, c.c_void_p, DVec3, P(GroundBlock)),
    ("windrow_vulkan_ground_memory_bytes", c.c_uint64, c.c_void_p),
    ("windrow_vulkan_ground_reserved_bytes", c.c_uint64, c.c_void_p),
]
