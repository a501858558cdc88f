"""Made by ./dev schema from the headers of c_api, where units, ranges and defaults are. Do not edit."""
import ctypes as c

from .air import *
from .bodies import *
from .operators import *

P = c.POINTER
PLANT_GRASS = 0; PLANT_WHEAT = 1; PLANT_REED = 2; PLANT_LEAF = 3; PLANT_TWIG = 4; PLANT_BRANCH = 5;
PLANT_SMALL_TRUNK = 6; PLANT_LARGE_TRUNK = 7
SPRING_GRASS = 0; SPRING_WHEAT = 1; SPRING_ALFALFA = 2; SPRING_REED = 3; SPRING_LEAF = 4; SPRING_TWIG = 5;
SPRING_BRANCH = 6; SPRING_TRUNK = 7


class Drag(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("length", c.c_float), ("width", c.c_float), ("rigidity", c.c_float),
                ("drag_coefficient", c.c_float), ("air_density", c.c_float), ("vogel_exponent", c.c_float),
                ("vogel_speed", c.c_float), ("max_bend", c.c_float)]


class PlantVertex(c.Structure):
    _fields_ = [("position", Vec3), ("normal", Vec3), ("tangent", Vec3)]


class BladeSettings(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("reserved", c.c_uint32), ("stalk", P(Drag)), ("length_spread", c.c_float),
                ("width", c.c_float), ("tip_width", c.c_float), ("taper", c.c_float), ("along_wind", c.c_float),
                ("stiffness_spread", c.c_float), ("rest_bend", c.c_float), ("rest_bend_spread", c.c_float),
                ("rest_curve", c.c_float), ("view_bend", c.c_float), ("twist", c.c_float), ("reserved_2", c.c_uint32)]


class ShellSettings(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("shells", c.c_int32), ("reaches_tip", c.c_int32), ("length", c.c_float),
                ("spacing", c.c_float), ("bias", c.c_float), ("push", c.c_float), ("push_exponent", c.c_float),
                ("droop", c.c_float), ("droop_shape", c.c_float), ("sag", c.c_float), ("down", Vec3),
                ("strand", P(Drag))]


class Skin(c.Structure):
    _fields_ = [("count", c.c_uint64), ("positions", P(Vec4)), ("normals", P(Vec4))]


class TreeClasses(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("reserved", c.c_uint32), ("trunk", P(Drag)), ("branch", P(Drag)),
                ("leaf", P(Drag))]


class TreePart(c.Structure):
    _fields_ = [("root", Vec3), ("axis", Vec3), ("length", c.c_float), ("stiffness", c.c_float)]


class TreeBearers(c.Structure):
    _fields_ = [("trunk", c.c_uint32), ("branch", c.c_uint32), ("leaf", c.c_uint32)]


class SpringClass(c.Structure):
    _fields_ = [("frequency_hz", c.c_double), ("damping", c.c_double)]


class SpringStep(c.Structure):
    _fields_ = [("place_place", c.c_double), ("place_velocity", c.c_double), ("place_target", c.c_double),
                ("velocity_place", c.c_double), ("velocity_velocity", c.c_double), ("velocity_target", c.c_double)]


class FlutterClass(c.Structure):
    _fields_ = [("frequency_hz", c.c_double), ("most", c.c_float), ("onset", c.c_float)]


class SpringBatch(c.Structure):
    _fields_ = [("count", c.c_uint64), ("place", c.c_void_p), ("velocity", c.c_void_p), ("target_before", c.c_void_p),
                ("target_now", c.c_void_p), ("place_remainder", c.c_void_p), ("velocity_remainder", c.c_void_p),
                ("place_previous", c.c_void_p)]


class CascadeBatch(c.Structure):
    _fields_ = [("rows", c.c_uint64), ("value", c.c_void_p), ("body_before", c.c_void_p), ("body_now", c.c_void_p),
                ("remainder", c.c_void_p)]


class Pose(c.Structure):
    _fields_ = [("position", DVec3), ("rotation", DVec4), ("scale", c.c_double)]


class CascadeConfig(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("stages", c.c_int32), ("lag", c.c_double)]


class GroundConfig(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("texels", c.c_int32), ("spring", SpringClass), ("texel_size", c.c_float),
                ("push", c.c_float), ("trail_fraction", c.c_float), ("trail_time", c.c_float),
                ("trample_time", c.c_float), ("clearance", c.c_float), ("blend_width", c.c_float),
                ("jump_speed", c.c_float), ("max_walkers", c.c_int32), ("reserved", c.c_uint32)]


class GroundWalker(c.Structure):
    _fields_ = [("position", DVec3), ("previous", DVec3), ("foot_height", c.c_float),
                ("previous_foot_height", c.c_float), ("radius", c.c_float), ("weight", c.c_float)]


class GroundStep(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("wind_lean", Vec2), ("reserved", c.c_uint32), ("duration", c.c_double),
                ("walker_count", c.c_uint64), ("walkers", P(GroundWalker))]


class GroundSample(c.Structure):
    _fields_ = [("lean", Vec2), ("trample", c.c_float), ("trail", c.c_float)]


# Each function with the types of its result and of its arguments.
PLANTS = [
    ("windrow_drag_init", c.c_int32, P(Drag), c.c_uint32),
    ("windrow_drag_of", c.c_int32, c.c_int32, P(Drag)),
    ("windrow_drag_validate", c.c_int32, P(Drag)),
    ("windrow_drag_block_of", c.c_int32, P(Drag), P(DragBlock)),
    ("windrow_cauchy_number", c.c_int32, P(Drag), c.c_double, P(c.c_double)),
    ("windrow_bend_angle", c.c_int32, P(Drag), c.c_float, P(c.c_float)),
    ("windrow_rectangle_rigidity", c.c_float, c.c_float, c.c_float, c.c_float),
    ("windrow_folded_rigidity", c.c_float, c.c_float, c.c_float, c.c_float, c.c_float),
    ("windrow_rod_rigidity", c.c_float, c.c_float, c.c_float),
    ("windrow_tube_rigidity", c.c_float, c.c_float, c.c_float, c.c_float),
    ("windrow_place_key", UVec2, c.c_float, c.c_float),
    ("windrow_plant_yaw", c.c_float, UVec2),
    ("windrow_plant_stiffness", c.c_float, UVec2, c.c_float),
    ("windrow_blade_settings_init", c.c_int32, P(BladeSettings), c.c_uint32),
    ("windrow_blades_create", c.c_int32, P(BladeSettings), P(c.c_void_p)),
    ("windrow_blades_destroy", None, c.c_void_p),
    ("windrow_blades_block", c.c_int32, c.c_void_p, P(BladeBlock)),
    ("windrow_blades_length", c.c_float, c.c_void_p, UVec2),
    ("windrow_blades_load", Vec3, c.c_void_p, UVec2, Vec3),
    ("windrow_blades_vertex", c.c_int32, c.c_void_p, UVec2, Vec3, c.c_float, c.c_float, Vec3, P(PlantVertex)),
    ("windrow_blades_loads", c.c_int32, c.c_void_p, c.c_uint64, P(UVec2), P(Vec4), P(Vec4), P(ParallelFor)),
    ("windrow_blades_vertices", c.c_int32, c.c_void_p, c.c_uint64, P(UVec2), P(Vec4), P(Vec4), c.c_uint64, P(c.c_float),
     Vec3, P(Vec4), P(Vec4), P(ParallelFor)),
    ("windrow_shell_settings_init", c.c_int32, P(ShellSettings), c.c_uint32),
    ("windrow_shells_create", c.c_int32, P(ShellSettings), P(c.c_void_p)),
    ("windrow_shells_destroy", None, c.c_void_p),
    ("windrow_shells_block", c.c_int32, c.c_void_p, P(ShellBlock)),
    ("windrow_shells_height", c.c_float, c.c_void_p, c.c_int32),
    ("windrow_shells_load", Vec3, c.c_void_p, Vec3, c.c_float, Vec3),
    ("windrow_shells_bent", Vec3, c.c_void_p, Vec3, Vec3, c.c_float, c.c_float, Vec3),
    ("windrow_shells_translated", Vec3, c.c_void_p, Vec3, Vec3, c.c_float, c.c_float, Vec3),
    ("windrow_shells_loads_many", c.c_int32, c.c_void_p, P(Skin), P(Vec4), P(Vec4), P(ParallelFor)),
    ("windrow_shells_bent_many", c.c_int32, c.c_void_p, P(Skin), c.c_float, P(Vec4), P(Vec4), P(ParallelFor)),
    ("windrow_shells_translated_many", c.c_int32, c.c_void_p, P(Skin), c.c_float, P(Vec4), P(Vec4), P(ParallelFor)),
    ("windrow_tree_classes_init", c.c_int32, P(TreeClasses), c.c_uint32),
    ("windrow_tree_create", c.c_int32, P(TreeClasses), P(c.c_void_p)),
    ("windrow_tree_destroy", None, c.c_void_p),
    ("windrow_tree_block_of", c.c_int32, c.c_void_p, P(TreeBlock)),
    ("windrow_tree_vertex", c.c_int32, c.c_void_p, P(TreePart), P(TreePart), P(TreePart), Vec3, P(PlantVertex),
     P(PlantVertex)),
    ("windrow_tree_vertices", c.c_int32, c.c_void_p, c.c_uint64, P(TreePart), P(Vec4), c.c_uint64, P(Vec4), P(Vec4),
     P(TreeBearers), P(Vec4), P(Vec4), P(ParallelFor)),
    ("windrow_spring_class_of", c.c_int32, c.c_int32, P(SpringClass)),
    ("windrow_spring_step_make", c.c_int32, P(SpringClass), c.c_double, P(SpringStep)),
    ("windrow_spring_step_block", c.c_int32, P(SpringStep), P(SpringBlock)),
    ("windrow_swing_step_make", c.c_int32, P(SpringClass), c.c_double, P(SwingBlock)),
    ("windrow_spring_bands", c.c_int32, P(SpringClass), P(SpringClass)),
    ("windrow_swing_steps_make", c.c_int32, P(SpringClass), c.c_double, P(SwingBlock)),
    ("windrow_flutter_step_make", c.c_int32, P(FlutterClass), c.c_double, c.c_double, P(FlutterBlock)),
    ("windrow_springs_advance_float", c.c_int32, P(SpringStep), P(SpringBatch), P(ParallelFor)),
    ("windrow_springs_advance_double", c.c_int32, P(SpringStep), P(SpringBatch), P(ParallelFor)),
    ("windrow_cascade_step_create", c.c_int32, c.c_int32, P(c.c_void_p)),
    ("windrow_cascade_step_destroy", None, c.c_void_p),
    ("windrow_cascade_step_set", c.c_int32, c.c_void_p, c.c_double, c.c_double),
    ("windrow_cascades_advance_float", c.c_int32, c.c_void_p, P(CascadeBatch), P(ParallelFor)),
    ("windrow_cascades_advance_double", c.c_int32, c.c_void_p, P(CascadeBatch), P(ParallelFor)),
    ("windrow_cascade_config_init", c.c_int32, P(CascadeConfig), c.c_uint32),
    ("windrow_cascade_create", c.c_int32, P(CascadeConfig), P(Pose), P(c.c_void_p)),
    ("windrow_cascade_destroy", None, c.c_void_p),
    ("windrow_cascade_save", c.c_int32, c.c_void_p, P(c.c_void_p)),
    ("windrow_cascade_load", c.c_int32, c.c_void_p, c.c_uint64, P(c.c_void_p)),
    ("windrow_cascade_advance", c.c_int32, c.c_void_p, c.c_double, P(Pose)),
    ("windrow_cascade_reset", c.c_int32, c.c_void_p, P(Pose)),
    ("windrow_cascade_move", c.c_int32, c.c_void_p, DVec3),
    ("windrow_cascade_at", c.c_int32, c.c_void_p, c.c_double, P(Pose)),
    ("windrow_cascade_previous_at", c.c_int32, c.c_void_p, c.c_double, P(Pose)),
    ("windrow_cascade_shader_poses", c.c_int32, c.c_void_p, DVec3, P(P(PoseBlock)), P(c.c_uint64)),
    ("windrow_cascade_previous_shader_poses", c.c_int32, c.c_void_p, DVec3, P(P(PoseBlock)), P(c.c_uint64)),
    ("windrow_ground_config_init", c.c_int32, P(GroundConfig), c.c_uint32),
    ("windrow_ground_step_init", c.c_int32, P(GroundStep), c.c_uint32),
    ("windrow_ground_create", c.c_int32, P(GroundConfig), P(ParallelFor), P(c.c_void_p)),
    ("windrow_ground_destroy", None, c.c_void_p),
    ("windrow_ground_save", c.c_int32, c.c_void_p, P(c.c_void_p)),
    ("windrow_ground_load", c.c_int32, c.c_void_p, c.c_uint64, P(ParallelFor), P(c.c_void_p)),
    ("windrow_ground_follow", c.c_int32, c.c_void_p, DVec3),
    ("windrow_ground_shift_origin", c.c_int32, c.c_void_p, DVec3),
    ("windrow_ground_advance", c.c_int32, c.c_void_p, P(GroundStep), P(Vec2), c.c_uint64),
    ("windrow_ground_walkers_left_out", c.c_int32, c.c_void_p),
    ("windrow_ground_next_centre", DVec2, c.c_void_p, IVec2),
    ("windrow_ground_at", c.c_int32, c.c_void_p, DVec3, P(GroundSample)),
    ("windrow_ground_previous_at", c.c_int32, c.c_void_p, DVec3, P(GroundSample)),
    ("windrow_ground_texels", P(Vec4), c.c_void_p, P(c.c_uint64)),
    ("windrow_ground_previous_texels", P(Vec4), c.c_void_p, P(c.c_uint64)),
    ("windrow_ground_block_of", c.c_int32, c.c_void_p, DVec3, P(GroundBlock)),
]
