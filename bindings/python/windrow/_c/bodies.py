"""Made by ./dev schema from the headers of c_api, where units, ranges and defaults are. Do not edit."""
import ctypes as c

from .air import *

P = c.POINTER
REGION_SPHERE = 0; REGION_CAPSULE = 1; REGION_BOX = 2; REGION_CONE = 3
LAW_FORCE = 0; LAW_DRIVE = 1
MOTOR_DIRECTIONAL = 0; MOTOR_WAKE = 1; MOTOR_JET = 2; MOTOR_VORTEX = 3; MOTOR_OMNI = 4; MOTOR_PRESSURE = 5
SHAPE_SPHERE = 0; SHAPE_CAPSULE = 1; SHAPE_BLOCK = 2; SHAPE_CYLINDER = 3; SHAPE_PLATE = 4; SHAPE_MESH = 5;
SHAPE_VOXELS = 6; SHAPE_GROUND = 7
BEYOND_EDGE = 0; BEYOND_NOTHING = 1
SURFACE_FREE_SLIP = 0; SURFACE_NO_SLIP = 1
DRAG_PLANT = 0; DRAG_BELT = 1


class MotorId(c.Structure):
    _fields_ = [("slot", c.c_uint32), ("generation", c.c_uint32), ("owner", c.c_uint32)]


class Region(c.Structure):
    _fields_ = [("kind", c.c_int32), ("radius", c.c_float), ("half_axis", Vec3), ("half_size", Vec3), ("axis", Vec3),
                ("start_radius", c.c_float), ("end_radius", c.c_float)]


class Law(c.Structure):
    _fields_ = [("kind", c.c_int32), ("acceleration", c.c_float), ("speed", c.c_float), ("rate", c.c_float)]


class WakeLaw(c.Structure):
    _fields_ = [("kind", c.c_int32), ("strength", c.c_float), ("per_metre", c.c_float), ("entrainment", c.c_float)]


class Envelope(c.Structure):
    _fields_ = [("attack", c.c_float), ("hold", c.c_float), ("decay", c.c_float), ("delay", c.c_float)]


class Turbulence(c.Structure):
    _fields_ = [("intensity", c.c_float), ("length", c.c_float), ("seed", c.c_uint32)]


class DirectionalMotor(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("direction", Vec3), ("position", DVec3), ("region", Region), ("law", Law),
                ("envelope", Envelope), ("turbulence", Turbulence)]


class WakeMotor(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("radius", c.c_float), ("position", DVec3), ("law", WakeLaw),
                ("envelope", Envelope), ("turbulence", Turbulence), ("reserved", c.c_uint32)]


class JetMotor(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("direction", Vec3), ("position", DVec3), ("length", c.c_float),
                ("start_radius", c.c_float), ("end_radius", c.c_float), ("law", Law), ("envelope", Envelope),
                ("turbulence", Turbulence)]


class VortexMotor(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("axis", Vec3), ("position", DVec3), ("radius", c.c_float),
                ("half_length", c.c_float), ("lift", c.c_float), ("law", Law), ("envelope", Envelope),
                ("reserved", c.c_uint32)]


class OmniMotor(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("radius", c.c_float), ("position", DVec3), ("speed", c.c_float),
                ("envelope", Envelope), ("reserved", c.c_uint32)]


class PressureMotor(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("radius", c.c_float), ("position", DVec3), ("speed", c.c_float),
                ("duration", c.c_float)]


class Shape(c.Structure):
    _fields_ = [("kind", c.c_int32), ("radius", c.c_float), ("half_length", c.c_float), ("cell_size", c.c_float),
                ("half_size", Vec3), ("half_axis", Vec3), ("scale", Vec3), ("beyond", c.c_int32), ("mesh", c.c_void_p),
                ("voxels", c.c_void_p), ("heights", c.c_void_p)]


class Obstacle(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("surface", c.c_int32), ("position", DVec3), ("orientation", Quat),
                ("shape", Shape)]


class ObstacleId(c.Structure):
    _fields_ = [("slot", c.c_uint32), ("generation", c.c_uint32), ("owner", c.c_uint32)]


class ObstacleForce(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("force", Vec3), ("moment", Vec3), ("pressure", c.c_float),
                ("in_box", c.c_int32)]


class DragId(c.Structure):
    _fields_ = [("slot", c.c_uint32), ("generation", c.c_uint32), ("owner", c.c_uint32)]


class PlantDrag(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("radius", c.c_float), ("position", DVec3), ("base", c.c_float),
                ("height", c.c_float), ("area", c.c_float), ("reserved", c.c_uint32)]


class BeltDrag(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("width", c.c_float), ("start", DVec3), ("end", DVec3),
                ("height", c.c_float), ("resistance", c.c_float)]


class DragForce(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("force", Vec3), ("in_box", c.c_float)]


# Each function with the types of its result and of its arguments.
BODIES = [
    ("windrow_region_sphere", Region, c.c_float),
    ("windrow_region_capsule", Region, Vec3, c.c_float),
    ("windrow_region_box", Region, Vec3),
    ("windrow_region_cone", Region, Vec3, c.c_float, c.c_float),
    ("windrow_law_force", Law, c.c_float),
    ("windrow_law_drive", Law, c.c_float, c.c_float),
    ("windrow_wake_law_force", WakeLaw, c.c_float),
    ("windrow_wake_law_drive", WakeLaw, c.c_float, c.c_float),
    ("windrow_directional_motor_init", c.c_int32, P(DirectionalMotor), c.c_uint32),
    ("windrow_wake_motor_init", c.c_int32, P(WakeMotor), c.c_uint32),
    ("windrow_jet_motor_init", c.c_int32, P(JetMotor), c.c_uint32),
    ("windrow_vortex_motor_init", c.c_int32, P(VortexMotor), c.c_uint32),
    ("windrow_omni_motor_init", c.c_int32, P(OmniMotor), c.c_uint32),
    ("windrow_pressure_motor_init", c.c_int32, P(PressureMotor), c.c_uint32),
    ("windrow_wind_add_directional", c.c_int32, c.c_void_p, P(DirectionalMotor), P(MotorId)),
    ("windrow_wind_add_wake", c.c_int32, c.c_void_p, P(WakeMotor), P(MotorId)),
    ("windrow_wind_add_jet", c.c_int32, c.c_void_p, P(JetMotor), P(MotorId)),
    ("windrow_wind_add_vortex", c.c_int32, c.c_void_p, P(VortexMotor), P(MotorId)),
    ("windrow_wind_add_omni", c.c_int32, c.c_void_p, P(OmniMotor), P(MotorId)),
    ("windrow_wind_add_pressure", c.c_int32, c.c_void_p, P(PressureMotor), P(MotorId)),
    ("windrow_wind_set_directional", c.c_int32, c.c_void_p, MotorId, P(DirectionalMotor)),
    ("windrow_wind_set_wake", c.c_int32, c.c_void_p, MotorId, P(WakeMotor)),
    ("windrow_wind_set_jet", c.c_int32, c.c_void_p, MotorId, P(JetMotor)),
    ("windrow_wind_set_vortex", c.c_int32, c.c_void_p, MotorId, P(VortexMotor)),
    ("windrow_wind_set_omni", c.c_int32, c.c_void_p, MotorId, P(OmniMotor)),
    ("windrow_wind_set_pressure", c.c_int32, c.c_void_p, MotorId, P(PressureMotor)),
    ("windrow_wind_get_directional", c.c_int32, c.c_void_p, MotorId, P(DirectionalMotor)),
    ("windrow_wind_get_wake", c.c_int32, c.c_void_p, MotorId, P(WakeMotor)),
    ("windrow_wind_get_jet", c.c_int32, c.c_void_p, MotorId, P(JetMotor)),
    ("windrow_wind_get_vortex", c.c_int32, c.c_void_p, MotorId, P(VortexMotor)),
    ("windrow_wind_get_omni", c.c_int32, c.c_void_p, MotorId, P(OmniMotor)),
    ("windrow_wind_get_pressure", c.c_int32, c.c_void_p, MotorId, P(PressureMotor)),
    ("windrow_wind_motor_kind", c.c_int32, c.c_void_p, MotorId, P(c.c_int32)),
    ("windrow_wind_move_motor", c.c_int32, c.c_void_p, MotorId, DVec3),
    ("windrow_wind_remove_motor", c.c_int32, c.c_void_p, MotorId),
    ("windrow_wind_motor_count", c.c_int32, c.c_void_p),
    ("windrow_mesh_create", c.c_int32, P(Vec3), c.c_uint64, P(c.c_uint32), c.c_uint64, P(c.c_void_p)),
    ("windrow_mesh_destroy", None, c.c_void_p),
    ("windrow_mesh_save", c.c_int32, c.c_void_p, P(c.c_void_p)),
    ("windrow_mesh_load", c.c_int32, c.c_void_p, c.c_uint64, P(c.c_void_p)),
    ("windrow_mesh_distance", c.c_float, c.c_void_p, Vec3),
    ("windrow_voxels_create", c.c_int32, IVec3, P(c.c_uint8), c.c_uint64, P(c.c_void_p)),
    ("windrow_voxels_destroy", None, c.c_void_p),
    ("windrow_height_map_create", c.c_int32, IVec2, c.c_float, P(c.c_float), c.c_uint64, P(c.c_void_p)),
    ("windrow_height_map_create_with_holes", c.c_int32, IVec2, c.c_float, P(c.c_float), c.c_uint64, IVec2, P(c.c_uint8),
     c.c_uint64, P(c.c_void_p)),
    ("windrow_height_map_destroy", None, c.c_void_p),
    ("windrow_height_map_height", c.c_float, c.c_void_p, Vec2),
    ("windrow_height_map_normal", Vec3, c.c_void_p, Vec2),
    ("windrow_shape_sphere", Shape, c.c_float),
    ("windrow_shape_capsule", Shape, Vec3, c.c_float),
    ("windrow_shape_block", Shape, Vec3),
    ("windrow_shape_cylinder", Shape, c.c_float, c.c_float),
    ("windrow_shape_plate", Shape, Vec2),
    ("windrow_shape_mesh", Shape, c.c_void_p, c.c_float),
    ("windrow_shape_voxels", Shape, c.c_void_p, c.c_float),
    ("windrow_shape_ground", Shape, c.c_void_p, Vec3),
    ("windrow_obstacle_init", c.c_int32, P(Obstacle), c.c_uint32),
    ("windrow_wind_add_obstacle", c.c_int32, c.c_void_p, P(Obstacle), P(ObstacleId)),
    ("windrow_wind_set_obstacle", c.c_int32, c.c_void_p, ObstacleId, P(Obstacle)),
    ("windrow_wind_get_obstacle", c.c_int32, c.c_void_p, ObstacleId, P(Obstacle)),
    ("windrow_wind_move_obstacle", c.c_int32, c.c_void_p, ObstacleId, DVec3, P(Quat), P(Vec3)),
    ("windrow_wind_remove_obstacle", c.c_int32, c.c_void_p, ObstacleId),
    ("windrow_wind_obstacle_count", c.c_int32, c.c_void_p),
    ("windrow_obstacle_force_init", c.c_int32, P(ObstacleForce), c.c_uint32),
    ("windrow_wind_force_on", c.c_int32, c.c_void_p, ObstacleId, P(ObstacleForce)),
    ("windrow_plant_drag_init", c.c_int32, P(PlantDrag), c.c_uint32),
    ("windrow_belt_drag_init", c.c_int32, P(BeltDrag), c.c_uint32),
    ("windrow_wind_add_plant_drag", c.c_int32, c.c_void_p, P(PlantDrag), P(DragId)),
    ("windrow_wind_add_belt_drag", c.c_int32, c.c_void_p, P(BeltDrag), P(DragId)),
    ("windrow_wind_add_plants", c.c_int32, c.c_void_p, P(PlantDrag), c.c_uint64, P(DragId)),
    ("windrow_wind_set_plant_drag", c.c_int32, c.c_void_p, DragId, P(PlantDrag)),
    ("windrow_wind_set_belt_drag", c.c_int32, c.c_void_p, DragId, P(BeltDrag)),
    ("windrow_wind_get_plant_drag", c.c_int32, c.c_void_p, DragId, P(PlantDrag)),
    ("windrow_wind_get_belt_drag", c.c_int32, c.c_void_p, DragId, P(BeltDrag)),
    ("windrow_wind_drag_kind", c.c_int32, c.c_void_p, DragId, P(c.c_int32)),
    ("windrow_wind_remove_drag", c.c_int32, c.c_void_p, DragId),
    ("windrow_wind_drag_count", c.c_int32, c.c_void_p),
    ("windrow_drag_force_init", c.c_int32, P(DragForce), c.c_uint32),
    ("windrow_wind_drag_force_on", c.c_int32, c.c_void_p, DragId, P(DragForce)),
]
