"""Made by ./dev schema from the headers of c_api, where units, ranges and defaults are. Do not edit."""
import ctypes as c

from .air import *
from .bodies import *

P = c.POINTER


class Transport(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("dt", c.c_float), ("carried", P(Vec4)), ("velocity", P(Vec4)),
                ("velocity_old", P(Vec4)), ("history", P(Vec4)), ("history_scale", c.c_float),
                ("extrapolation", c.c_float), ("relaxation", c.c_float), ("interpolation", c.c_int32)]


class ScalarTransport(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("dt", c.c_float), ("carried", P(c.c_float)), ("velocity", P(Vec4)),
                ("outside", c.c_float), ("clamped", c.c_int32), ("interpolation", c.c_int32), ("reserved", c.c_uint32)]


# Each function with the types of its result and of its arguments.
OPERATORS = [
    ("windrow_workspace_create", c.c_int32, P(Config), P(c.c_void_p)),
    ("windrow_workspace_destroy", None, c.c_void_p),
    ("windrow_workspace_cell_count", c.c_uint64, c.c_void_p),
    ("windrow_workspace_memory_bytes", c.c_uint64, c.c_void_p),
    ("windrow_workspace_set_boundaries", c.c_int32, c.c_void_p, P(Boundaries)),
    ("windrow_workspace_set_ambient", c.c_int32, c.c_void_p, Vec3),
    ("windrow_workspace_set_obstacles", c.c_int32, c.c_void_p, P(Obstacle), P(Vec3), P(Vec3), c.c_uint64),
    ("windrow_workspace_impulse_on", c.c_int32, c.c_void_p, c.c_uint64, P(Vec3)),
    ("windrow_transport_init", c.c_int32, P(Transport), c.c_uint32),
    ("windrow_advect", c.c_int32, c.c_void_p, P(Transport), P(Vec4), c.c_uint64),
    ("windrow_scalar_transport_init", c.c_int32, P(ScalarTransport), c.c_uint32),
    ("windrow_advect_scalar", c.c_int32, c.c_void_p, P(ScalarTransport), P(c.c_float), c.c_uint64),
    ("windrow_diffuse", c.c_int32, c.c_void_p, P(Vec4), c.c_float, c.c_float, P(Vec4), P(c.c_int32), c.c_uint64),
    ("windrow_workspace_reserve_diffusion", c.c_int32, c.c_void_p),
    ("windrow_divergence", c.c_int32, c.c_void_p, P(Vec4), P(c.c_float), c.c_uint64),
    ("windrow_solve_poisson", c.c_int32, c.c_void_p, P(c.c_float), c.c_uint64),
    ("windrow_project", c.c_int32, c.c_void_p, P(Vec4), P(Vec4), P(c.c_float), c.c_uint64),
    ("windrow_scene_load", c.c_int32, c.c_char_p, P(ParallelFor), P(c.c_void_p)),
    ("windrow_scene_parse", c.c_int32, c.c_char_p, c.c_uint64, c.c_char_p, P(ParallelFor), P(c.c_void_p)),
    ("windrow_scene_destroy", None, c.c_void_p),
    ("windrow_scene_wind", c.c_void_p, c.c_void_p),
    ("windrow_scene_outer_count", c.c_int32, c.c_void_p),
    ("windrow_scene_outer_wind", c.c_void_p, c.c_void_p, c.c_int32),
    ("windrow_wind_write_scene", c.c_int32, c.c_void_p, c.c_char_p, c.c_double, c.c_double),
    ("windrow_scene_step", c.c_int32, c.c_void_p, P(Diagnostics)),
    ("windrow_scene_advance", c.c_int32, c.c_void_p, c.c_double, P(Advance)),
    ("windrow_scene_time", c.c_double, c.c_void_p),
    ("windrow_scene_duration", c.c_double, c.c_void_p),
    ("windrow_scene_frames_per_second", c.c_double, c.c_void_p),
    ("windrow_scene_motor_count", c.c_int32, c.c_void_p),
    ("windrow_scene_motor_name", c.c_char_p, c.c_void_p, c.c_int32),
    ("windrow_scene_obstacle_count", c.c_int32, c.c_void_p),
    ("windrow_scene_obstacle_name", c.c_char_p, c.c_void_p, c.c_int32),
    ("windrow_scene_motor", c.c_int32, c.c_void_p, c.c_char_p, P(MotorId)),
    ("windrow_scene_obstacle", c.c_int32, c.c_void_p, c.c_char_p, P(ObstacleId)),
    ("windrow_scene_save", c.c_int32, c.c_void_p, P(c.c_void_p)),
    ("windrow_scene_restore", c.c_int32, c.c_void_p, c.c_void_p, c.c_uint64),
]
