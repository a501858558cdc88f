"""Made by ./dev schema from the headers of c_api, where units, ranges and defaults are. Do not edit."""
import ctypes as c

P = c.POINTER
PART_COUPLING = 0; PART_VDB = 1; PART_VULKAN = 2; PART_SCENE = 3
OK = 0; REJECTED = -1; STALE = -2; OUT_OF_MEMORY = -3; CANNOT_WRITE = -4; DISK_FULL = -5; UNSUPPORTED = -6;
NOT_READY = -7; DEVICE_LOST = -9; UNEXPECTED = -8
SEVERITY_WARNING = 0; SEVERITY_ERROR = 1
AXES_Y_UP_RIGHT = 0; AXES_Y_UP_LEFT = 1; AXES_Z_UP_RIGHT = 2; AXES_Z_UP_LEFT = 3
BOUNDARY_OPEN = 0; BOUNDARY_FREE_SLIP = 1; BOUNDARY_NO_SLIP = 2; BOUNDARY_PERIODIC = 3
SCHEME_SECOND_ORDER = 0; SCHEME_STABLE_FLUIDS = 1
INTERPOLATION_LINEAR = 0; INTERPOLATION_CUBIC = 1; INTERPOLATION_CUBIC_32 = 2
SIMD_BEST = 0; SIMD_BASELINE = 1; SIMD_AVX2 = 2; SIMD_AVX512 = 3
FOLLOW_DEFAULT = -1; FOLLOW_X = 1; FOLLOW_Y = 2; FOLLOW_Z = 4
STAGE_SOURCES = 1; STAGE_RELAXATION = 2; STAGE_DIFFUSION = 4; STAGE_ADVECTION = 8; STAGE_PROJECTION = 16; STAGE_ALL = 31
MAX_ROWS = 128
DIFFUSION_NONE = 0; DIFFUSION_ONE_PASS = 1; DIFFUSION_IMPLICIT = 2
FRAME_NOW = 0; FRAME_PREVIOUS = 1
NUMBER_FLOAT = 0; NUMBER_DOUBLE = 1
TEXEL_HALF = 0; TEXEL_FLOAT = 1
FIELD_FGA = 0; FIELD_VF = 1; FIELD_RAW = 2; FIELD_NPZ = 3; FIELD_VTI = 4
DEBUG_BOX = 0; DEBUG_MOTOR = 1; DEBUG_OBSTACLE = 2; DEBUG_ARROW = 3


class Vec2(c.Structure):
    _fields_ = [("x", c.c_float), ("y", c.c_float)]


class Vec3(c.Structure):
    _fields_ = [("x", c.c_float), ("y", c.c_float), ("z", c.c_float)]


class Vec4(c.Structure):
    _fields_ = [("x", c.c_float), ("y", c.c_float), ("z", c.c_float), ("w", c.c_float)]


class Quat(c.Structure):
    _fields_ = [("x", c.c_float), ("y", c.c_float), ("z", c.c_float), ("w", c.c_float)]


class DVec2(c.Structure):
    _fields_ = [("x", c.c_double), ("y", c.c_double)]


class DVec3(c.Structure):
    _fields_ = [("x", c.c_double), ("y", c.c_double), ("z", c.c_double)]


class DVec4(c.Structure):
    _fields_ = [("x", c.c_double), ("y", c.c_double), ("z", c.c_double), ("w", c.c_double)]


class IVec2(c.Structure):
    _fields_ = [("x", c.c_int32), ("y", c.c_int32)]


class IVec3(c.Structure):
    _fields_ = [("x", c.c_int32), ("y", c.c_int32), ("z", c.c_int32)]


class UVec2(c.Structure):
    _fields_ = [("x", c.c_uint32), ("y", c.c_uint32)]

Task = c.CFUNCTYPE(None, c.c_void_p, c.c_int32)

Run = c.CFUNCTYPE(None, c.c_void_p, c.c_int32, Task, c.c_void_p)


class ParallelFor(c.Structure):
    _fields_ = [("run", Run), ("context", c.c_void_p)]


class SavedPart(c.Structure):
    _fields_ = [("name", c.c_char_p), ("bytes", c.c_void_p), ("size", c.c_uint64)]


class Boundary(c.Structure):
    _fields_ = [("kind", c.c_int32), ("wall_velocity", Vec3)]


class Boundaries(c.Structure):
    _fields_ = [("x_low", Boundary), ("x_high", Boundary), ("y_low", Boundary), ("y_high", Boundary),
                ("z_low", Boundary), ("z_high", Boundary)]


class LogProfile(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("roughness_length", c.c_float), ("reference_height", c.c_float)]


class Gusts(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("intensity", c.c_float), ("length", c.c_float), ("seed", c.c_uint32),
                ("tile", c.c_void_p)]


class Canopy(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("height", c.c_float), ("drag", c.c_float)]


class RoughnessMap(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("reserved", c.c_uint32), ("lengths", c.c_void_p), ("position", DVec3),
                ("scale", Vec3), ("reserved_2", c.c_uint32)]


class Roughness(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("length", c.c_float), ("longest_mixing", c.c_float),
                ("reserved", c.c_uint32), ("map", P(RoughnessMap))]


class Rows(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("first", c.c_float), ("uniform", c.c_int32), ("ratio", c.c_float),
                ("top", c.c_float), ("height_count", c.c_uint32), ("heights", P(c.c_float))]


class Config(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("cells", IVec3), ("cell_size", c.c_float), ("boundaries", Boundaries),
                ("follow_axes", c.c_int32), ("centre", DVec3), ("ambient", Vec3), ("reserved", c.c_uint32),
                ("profile", P(LogProfile)), ("gusts", P(Gusts)), ("canopy", P(Canopy)), ("roughness", P(Roughness)),
                ("rows", P(Rows)), ("blend_width", c.c_float), ("viscosity", c.c_float), ("relaxation_time", c.c_float),
                ("sleep_speed", c.c_float), ("scheme", c.c_int32), ("interpolation", c.c_int32), ("max_cfl", c.c_float),
                ("max_substeps", c.c_int32), ("pressure_solves", c.c_int32), ("stages", c.c_uint32),
                ("ticks_hz", c.c_double), ("ticks_max_per_call", c.c_int32), ("simd", c.c_int32),
                ("parallel_for", ParallelFor), ("floor", c.c_double), ("jump_speed", c.c_float),
                ("reserved_2", c.c_uint32)]


class Sampling(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("strength", c.c_float), ("limit", c.c_float), ("detail", c.c_float),
                ("detail_length", c.c_float)]


class AmbientSettings(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("mean", Vec3), ("profile", P(LogProfile)), ("gusts", P(Gusts)),
                ("ground", c.c_double)]


class UniformGust(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("mean", c.c_float), ("amplitude", c.c_float), ("period", c.c_float),
                ("direction", Vec3), ("reserved", c.c_uint32)]


class WindowBlock(c.Structure):
    _fields_ = [("origin", Vec3), ("cell_size", c.c_float), ("cells", Vec3), ("factor", c.c_float),
                ("previous_origin", Vec3), ("rows", c.c_float), ("ambient", Vec3), ("height", c.c_float),
                ("low_boundaries", Vec3), ("wall_per_length", c.c_float), ("high_boundaries", Vec3),
                ("wall_per_log", c.c_float), ("blend_centre", Vec3), ("blend_width", c.c_float), ("blend_reach", Vec3),
                ("wall_lowest", c.c_float), ("previous_blend_centre", Vec3), ("wall_fall", c.c_float)]


class AxisBlock(c.Structure):
    _fields_ = [("texture_scale", c.c_float), ("texture_offset", c.c_float), ("inner_scale", c.c_float),
                ("inner_offset", c.c_float), ("edge_scale", c.c_float), ("low_edge", c.c_float),
                ("high_edge", c.c_float), ("smoothness", c.c_float)]


class PlaceBlock(c.Structure):
    _fields_ = [("x", AxisBlock), ("y", AxisBlock), ("z", AxisBlock)]


class AmbientBlock(c.Structure):
    _fields_ = [("mean", Vec3), ("gust_strength", c.c_float), ("roughness_length", c.c_float),
                ("reference_height", c.c_float), ("anchor_height", c.c_float), ("felt_strength", c.c_float),
                ("gust_texel", Vec3), ("gust_texels", c.c_float), ("gust_fraction", Vec3), ("longest_gust", c.c_float),
                ("gust_axes", Vec3), ("felt_limit", c.c_float), ("detail_texel", Vec3), ("detail_texels", c.c_float),
                ("detail_fraction", Vec3), ("detail_amount", c.c_float)]


class FrameBlock(c.Structure):
    _fields_ = [("window", WindowBlock), ("place", PlaceBlock), ("previous_place", PlaceBlock),
                ("ambient", AmbientBlock), ("previous_ambient", AmbientBlock), ("heights", c.c_float * 128)]


class DragBlock(c.Structure):
    _fields_ = [("load", Vec4)]


class BladeBlock(c.Structure):
    _fields_ = [("size", Vec4), ("form", Vec4), ("own", Vec4), ("drag", DragBlock)]


class ShellBlock(c.Structure):
    _fields_ = [("form", Vec4), ("push", Vec4), ("sag", Vec4), ("drag", DragBlock)]


class TreeBlock(c.Structure):
    _fields_ = [("trunk", DragBlock), ("branch", DragBlock), ("leaf", DragBlock)]


class SpringBlock(c.Structure):
    _fields_ = [("place", Vec4), ("velocity", Vec4)]


class SwingBlock(c.Structure):
    _fields_ = [("spring", SpringBlock), ("smoothing", SpringBlock), ("parts", Vec4)]


class FlutterBlock(c.Structure):
    _fields_ = [("motion", Vec4), ("now", Vec4), ("before", Vec4)]


class PoseBlock(c.Structure):
    _fields_ = [("place", Vec4), ("rotation", Vec4)]


class GroundPlaceBlock(c.Structure):
    _fields_ = [("corner", Vec4), ("blend_zone", Vec4), ("slot", Vec4)]


class GroundBlock(c.Structure):
    _fields_ = [("now", GroundPlaceBlock), ("before", GroundPlaceBlock)]


class StageTimes(c.Structure):
    _fields_ = [("sources", c.c_double), ("ambient", c.c_double), ("diffusion", c.c_double), ("advection", c.c_double),
                ("projection", c.c_double), ("obstacles", c.c_double), ("report", c.c_double), ("total", c.c_double)]


class Diagnostics(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("stepped", c.c_int32), ("out_of_memory", c.c_int32),
                ("regridded", c.c_int32), ("max_speed", c.c_float), ("cfl", c.c_float), ("substeps", c.c_int32),
                ("substeps_capped", c.c_int32), ("carried_time", c.c_float), ("motors_in_reach", c.c_int32),
                ("limited_cells", c.c_int64), ("repaired_cells", c.c_int64), ("diffusion", c.c_int32),
                ("pressure_residual", c.c_float), ("pressure_solves", c.c_int32), ("sealed_sources", c.c_int32),
                ("divergence_rms", c.c_double), ("energy", c.c_double), ("asleep", c.c_int32),
                ("motors_lost", c.c_int32), ("times_ms", StageTimes), ("jumps", c.c_int32), ("reserved", c.c_uint32),
                ("fast_turns", c.c_int32), ("reserved_2", c.c_uint32), ("filling_obstacles", c.c_int32),
                ("reserved_3", c.c_uint32), ("sealed_rooms", c.c_int32), ("reserved_4", c.c_uint32)]


class Advance(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("ticks", c.c_int32), ("dropped", c.c_double), ("factor", c.c_float),
                ("reserved", c.c_uint32)]


class Box(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("cells", IVec3), ("cell_size", c.c_float), ("size", Vec3),
                ("origin", DVec3), ("boundaries", Boundaries)]


class Query(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("frame", c.c_int32), ("count", c.c_uint64), ("positions", c.c_void_p),
                ("number", c.c_int32), ("position_stride", c.c_uint32), ("anchor", DVec3), ("velocities", P(c.c_float)),
                ("velocity_stride", c.c_uint32), ("reserved", c.c_uint32), ("sampling", P(Sampling))]


class DebugLine(c.Structure):
    _fields_ = [("begin", DVec3), ("end", DVec3), ("kind", c.c_int32), ("speed", c.c_float)]


class DebugView(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("box", c.c_int32), ("motors", c.c_int32), ("obstacles", c.c_int32),
                ("arrows", c.c_int32), ("seconds", c.c_float), ("height", c.c_double)]

Logger = c.CFUNCTYPE(None, c.c_int32, c.c_char_p, c.c_void_p)

Allocate = c.CFUNCTYPE(c.c_void_p, c.c_size_t, c.c_size_t, c.c_void_p)

Release = c.CFUNCTYPE(None, c.c_void_p, c.c_size_t, c.c_size_t, c.c_void_p)

VelocityAt = c.CFUNCTYPE(None, c.c_void_p, P(DVec3), P(Vec3))

DebugDraw = c.CFUNCTYPE(None, c.c_void_p, P(DebugLine))


# Each function with the types of its result and of its arguments.
AIR = [
    ("windrow_version", c.c_uint32),
    ("windrow_version_string", c.c_char_p),
    ("windrow_has_part", c.c_int32, c.c_int32),
    ("windrow_last_error", c.c_char_p),
    ("windrow_set_logger", None, Logger, c.c_void_p),
    ("windrow_set_allocator", c.c_int32, Allocate, Release, c.c_void_p),
    ("windrow_allocated_bytes", c.c_uint64),
    ("windrow_set_axes", c.c_int32, c.c_int32, c.c_double),
    ("windrow_axes_matrix", c.c_int32, P(c.c_double)),
    ("windrow_thread_pool_create", c.c_int32, c.c_int32, P(c.c_void_p)),
    ("windrow_thread_pool_destroy", None, c.c_void_p),
    ("windrow_thread_pool_size", c.c_int32, c.c_void_p),
    ("windrow_thread_pool_parallel_for", ParallelFor, c.c_void_p),
    ("windrow_bytes_data", P(c.c_uint8), c.c_void_p),
    ("windrow_bytes_size", c.c_uint64, c.c_void_p),
    ("windrow_bytes_destroy", None, c.c_void_p),
    ("windrow_parts_join", c.c_int32, P(SavedPart), c.c_uint64, P(c.c_void_p)),
    ("windrow_parts_find", c.c_int32, c.c_void_p, c.c_uint64, c.c_char_p, P(c.c_void_p), P(c.c_uint64)),
    ("windrow_boundaries_all", Boundaries, c.c_int32),
    ("windrow_boundaries_open_over_floor", Boundaries),
    ("windrow_log_profile_init", c.c_int32, P(LogProfile), c.c_uint32),
    ("windrow_gusts_init", c.c_int32, P(Gusts), c.c_uint32),
    ("windrow_canopy_init", c.c_int32, P(Canopy), c.c_uint32),
    ("windrow_roughness_map_init", c.c_int32, P(RoughnessMap), c.c_uint32),
    ("windrow_roughness_init", c.c_int32, P(Roughness), c.c_uint32),
    ("windrow_rows_init", c.c_int32, P(Rows), c.c_uint32),
    ("windrow_simd_runs", c.c_int32, c.c_int32),
    ("windrow_simd_name", c.c_char_p, c.c_int32),
    ("windrow_config_init", c.c_int32, P(Config), c.c_uint32),
    ("windrow_config_validate", c.c_int32, P(Config)),
    ("windrow_sampling_init", c.c_int32, P(Sampling), c.c_uint32),
    ("windrow_sampling_validate", c.c_int32, P(Sampling)),
    ("windrow_gust_tile_bake", c.c_int32, c.c_uint32, P(c.c_void_p)),
    ("windrow_gust_tile_destroy", None, c.c_void_p),
    ("windrow_gust_tile_save", c.c_int32, c.c_void_p, P(c.c_void_p)),
    ("windrow_gust_tile_load", c.c_int32, c.c_void_p, c.c_uint64, P(c.c_void_p)),
    ("windrow_gust_tile_texels", P(Vec4), c.c_void_p, P(c.c_uint64)),
    ("windrow_ambient_settings_init", c.c_int32, P(AmbientSettings), c.c_uint32),
    ("windrow_ambient_wind_create", c.c_int32, P(AmbientSettings), P(c.c_void_p)),
    ("windrow_ambient_wind_of", c.c_int32, c.c_void_p, c.c_int32, P(c.c_void_p)),
    ("windrow_ambient_wind_destroy", None, c.c_void_p),
    ("windrow_ambient_wind_advance", c.c_int32, c.c_void_p, c.c_double),
    ("windrow_ambient_wind_set_mean", c.c_int32, c.c_void_p, Vec3),
    ("windrow_ambient_wind_set_ground", c.c_int32, c.c_void_p, c.c_double),
    ("windrow_ambient_wind_set_phase", c.c_int32, c.c_void_p, DVec3),
    ("windrow_ambient_wind_phase", DVec3, c.c_void_p),
    ("windrow_ambient_wind_period", c.c_double, c.c_void_p),
    ("windrow_ambient_wind_mean", Vec3, c.c_void_p),
    ("windrow_ambient_wind_ground", c.c_double, c.c_void_p),
    ("windrow_ambient_wind_profile_at", c.c_float, c.c_void_p, c.c_double),
    ("windrow_ambient_wind_velocity", c.c_int32, c.c_void_p, DVec3, P(Vec3)),
    ("windrow_ambient_wind_felt", c.c_int32, c.c_void_p, DVec3, P(Sampling), P(Vec3)),
    ("windrow_ambient_wind_block", c.c_int32, c.c_void_p, DVec3, P(Sampling), P(AmbientBlock)),
    ("windrow_ambient_wind_tile", c.c_int32, c.c_void_p, P(c.c_void_p)),
    ("windrow_uniform_gust_init", c.c_int32, P(UniformGust), c.c_uint32),
    ("windrow_uniform_gust_velocity", c.c_int32, P(UniformGust), c.c_double, P(Vec3)),
    ("windrow_diagnostics_init", c.c_int32, P(Diagnostics), c.c_uint32),
    ("windrow_advance_init", c.c_int32, P(Advance), c.c_uint32),
    ("windrow_box_init", c.c_int32, P(Box), c.c_uint32),
    ("windrow_wind_create", c.c_int32, P(Config), P(c.c_void_p)),
    ("windrow_wind_create_inside", c.c_int32, P(Config), c.c_void_p, P(c.c_void_p)),
    ("windrow_wind_destroy", None, c.c_void_p),
    ("windrow_wind_save", c.c_int32, c.c_void_p, P(c.c_void_p)),
    ("windrow_wind_load", c.c_int32, c.c_void_p, c.c_uint64, P(ParallelFor), P(c.c_void_p)),
    ("windrow_wind_load_inside", c.c_int32, c.c_void_p, c.c_uint64, P(ParallelFor), c.c_void_p, P(c.c_void_p)),
    ("windrow_wind_record_to", c.c_int32, c.c_void_p, c.c_void_p),
    ("windrow_wind_config", c.c_int32, c.c_void_p, P(Config)),
    ("windrow_wind_memory_bytes", c.c_uint64, c.c_void_p),
    ("windrow_wind_step", c.c_int32, c.c_void_p, c.c_double, P(Diagnostics)),
    ("windrow_wind_advance", c.c_int32, c.c_void_p, c.c_double, P(Advance), P(Diagnostics)),
    ("windrow_wind_follow", c.c_int32, c.c_void_p, DVec3),
    ("windrow_wind_set_floor", c.c_int32, c.c_void_p, c.c_double),
    ("windrow_wind_shift_origin", c.c_int32, c.c_void_p, DVec3),
    ("windrow_wind_box", c.c_int32, c.c_void_p, P(Box)),
    ("windrow_wind_origin", DVec3, c.c_void_p),
    ("windrow_wind_cell_count", c.c_uint64, c.c_void_p),
    ("windrow_wind_set_ambient", c.c_int32, c.c_void_p, Vec3),
    ("windrow_wind_ambient", Vec3, c.c_void_p),
    ("windrow_wind_set_gusts", c.c_int32, c.c_void_p, P(Gusts)),
    ("windrow_wind_set_boundaries", c.c_int32, c.c_void_p, P(Boundaries)),
    ("windrow_wind_set_velocity", c.c_int32, c.c_void_p, VelocityAt, c.c_void_p),
    ("windrow_wind_set_field", c.c_int32, c.c_void_p, P(Vec4), c.c_uint64),
    ("windrow_wind_reset", c.c_int32, c.c_void_p),
    ("windrow_wind_velocity", c.c_int32, c.c_void_p, DVec3, P(Vec3)),
    ("windrow_wind_felt", c.c_int32, c.c_void_p, DVec3, P(Sampling), P(Vec3)),
    ("windrow_query_init", c.c_int32, P(Query), c.c_uint32),
    ("windrow_wind_sample", c.c_int32, c.c_void_p, P(Query)),
    ("windrow_wind_write_vectors", c.c_int32, c.c_void_p, c.c_int32, c.c_int32, c.c_void_p, c.c_uint64),
    ("windrow_wind_write_axes", c.c_int32, c.c_void_p, c.c_int32, c.c_int32, c.c_void_p, c.c_void_p, c.c_void_p,
     c.c_uint64),
    ("windrow_wind_write_obstacles", c.c_int32, c.c_void_p, P(c.c_float), c.c_uint64),
    ("windrow_wind_write_pressure", c.c_int32, c.c_void_p, P(c.c_float), c.c_uint64),
    ("windrow_wind_field", c.c_int32, c.c_void_p, c.c_int32, P(P(Vec4)), P(c.c_uint64), P(DVec3)),
    ("windrow_wind_write_field", c.c_int32, c.c_void_p, c.c_char_p, c.c_int32, c.c_double),
    ("windrow_to_half", c.c_uint16, c.c_float),
    ("windrow_from_half", c.c_float, c.c_uint16),
    ("windrow_debug_view_init", c.c_int32, P(DebugView), c.c_uint32),
    ("windrow_wind_debug_lines", c.c_int32, c.c_void_p, P(DebugView), DebugDraw, c.c_void_p),
    ("windrow_wind_window_block", c.c_int32, c.c_void_p, DVec3, P(WindowBlock)),
    ("windrow_wind_frame_block", c.c_int32, c.c_void_p, DVec3, P(Sampling), P(FrameBlock)),
    ("windrow_event_log_create", c.c_int32, P(c.c_void_p)),
    ("windrow_event_log_destroy", None, c.c_void_p),
    ("windrow_event_log_count", c.c_uint64, c.c_void_p),
    ("windrow_event_log_complete", c.c_int32, c.c_void_p),
    ("windrow_event_log_clear", c.c_int32, c.c_void_p),
    ("windrow_event_log_to_bytes", c.c_int32, c.c_void_p, P(c.c_void_p)),
    ("windrow_event_log_from_bytes", c.c_int32, c.c_void_p, c.c_uint64, P(c.c_void_p)),
    ("windrow_event_log_replay", c.c_int32, c.c_void_p, c.c_void_p),
    ("windrow_tracer_create", c.c_int32, c.c_void_p, P(ParallelFor), P(c.c_void_p)),
    ("windrow_tracer_destroy", None, c.c_void_p),
    ("windrow_tracer_save", c.c_int32, c.c_void_p, P(c.c_void_p)),
    ("windrow_tracer_load", c.c_int32, c.c_void_p, c.c_uint64, c.c_void_p, P(ParallelFor), P(c.c_void_p)),
    ("windrow_tracer_step", c.c_int32, c.c_void_p, c.c_void_p, c.c_double),
    ("windrow_tracer_blow", c.c_int32, c.c_void_p, DVec3, c.c_float),
    ("windrow_tracer_cells", P(c.c_float), c.c_void_p, P(c.c_uint64)),
]
