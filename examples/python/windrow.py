#!/usr/bin/env python3
"""Tutorial: the README's ten lines in Python, by ctypes, and a small class to take along.

    windrow.py          prints the wind at a leaf after a second

1. Load the shared library: the one of WINDROW_LIBRARY, else the system's.
2. Mirror the structs that you use, with all fields in their order (c_api/config.h, c_api/motors.h). The init functions fill them
   with defaults, so only what differs is set.
3. Every call returns 0 or a negative class of error; `Windrow.check` makes an exception of it, with the library's sentence.
"""
import ctypes as c
import os
import sys


class Vec3(c.Structure):
    _fields_ = [("x", c.c_float), ("y", c.c_float), ("z", c.c_float)]


class DVec3(c.Structure):
    _fields_ = [("x", c.c_double), ("y", c.c_double), ("z", c.c_double)]


class Boundary(c.Structure):
    _fields_ = [("kind", c.c_int32), ("wall_velocity", Vec3)]


class Boundaries(c.Structure):
    _fields_ = [(name, Boundary) for name in ("x_low", "x_high", "y_low", "y_high", "z_low", "z_high")]


class Config(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("cells", c.c_int32 * 3), ("cell_size", c.c_float), ("boundaries", Boundaries),
                ("follow_axes", c.c_int32), ("centre", DVec3), ("ambient", Vec3), ("reserved", c.c_uint32), ("profile", c.c_void_p),
                ("gusts", c.c_void_p), ("canopy", c.c_void_p), ("roughness", c.c_void_p), ("rows", c.c_void_p),
                ("blend_width", c.c_float), ("viscosity", c.c_float), ("relaxation_time", c.c_float), ("sleep_speed", c.c_float),
                ("scheme", c.c_int32), ("interpolation", c.c_int32), ("max_cfl", c.c_float), ("max_substeps", c.c_int32),
                ("pressure_solves", c.c_int32), ("stages", c.c_uint32), ("ticks_hz", c.c_double), ("ticks_max_per_call", c.c_int32),
                ("simd", c.c_int32), ("run", c.c_void_p), ("context", c.c_void_p)]


class WakeMotor(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("radius", c.c_float), ("position", DVec3), ("law_kind", c.c_int32),
                ("strength", c.c_float), ("per_metre", c.c_float), ("entrainment", c.c_float), ("attack", c.c_float),
                ("hold", c.c_float), ("decay", c.c_float), ("delay", c.c_float), ("turbulence_intensity", c.c_float),
                ("turbulence_length", c.c_float), ("turbulence_seed", c.c_uint32), ("reserved", c.c_uint32)]


class MotorId(c.Structure):
    _fields_ = [("slot", c.c_uint32), ("generation", c.c_uint32), ("owner", c.c_uint32)]


library = c.CDLL(os.environ.get("WINDROW_LIBRARY", "libwindrow.so.0.1"))
library.windrow_last_error.restype = c.c_char_p
library.windrow_boundaries_open_over_floor.restype = Boundaries
library.windrow_wind_destroy.argtypes = [c.c_void_p]
library.windrow_wind_follow.argtypes = [c.c_void_p, DVec3]
library.windrow_wind_add_wake.argtypes = [c.c_void_p, c.POINTER(WakeMotor), c.POINTER(MotorId)]
library.windrow_wind_move_motor.argtypes = [c.c_void_p, MotorId, DVec3]
library.windrow_wind_advance.argtypes = [c.c_void_p, c.c_double, c.c_void_p, c.c_void_p]
library.windrow_wind_velocity.argtypes = [c.c_void_p, DVec3, c.POINTER(Vec3)]


class WindrowError(Exception):
    pass


def check(result):
    if result != 0:
        raise WindrowError(library.windrow_last_error().decode())


def defaults(kind, init):
    """A struct with the library's defaults."""
    value = kind()
    check(init(c.byref(value), c.sizeof(value)))
    return value


class Wind:
    """The wind in a box that follows a player."""

    def __init__(self, config):
        self._wind = c.c_void_p()
        check(library.windrow_wind_create(c.byref(config), c.byref(self._wind)))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        library.windrow_wind_destroy(self._wind)
        self._wind = None

    def add_wake(self, motor):
        name = MotorId()
        check(library.windrow_wind_add_wake(self._wind, c.byref(motor), c.byref(name)))
        return name

    def follow(self, x, y, z):
        check(library.windrow_wind_follow(self._wind, DVec3(x, y, z)))

    def move(self, motor, x, y, z):
        check(library.windrow_wind_move_motor(self._wind, motor, DVec3(x, y, z)))

    def advance(self, seconds):
        check(library.windrow_wind_advance(self._wind, seconds, None, None))

    def velocity(self, x, y, z):
        velocity = Vec3()
        check(library.windrow_wind_velocity(self._wind, DVec3(x, y, z), c.byref(velocity)))
        return velocity.x, velocity.y, velocity.z


def main():
    config = defaults(Config, library.windrow_config_init)
    config.boundaries = library.windrow_boundaries_open_over_floor()
    config.ambient.x = 3.0
    if "wrong" in sys.argv:  # to see the library's sentence
        config.cell_size = -1.0
    with Wind(config) as wind:
        wake = defaults(WakeMotor, library.windrow_wake_motor_init)
        wake.position, wake.radius = DVec3(0.0, 0.5, 1.0), 0.6
        dog = wind.add_wake(wake)
        for frame in range(60):
            wind.follow(frame / 20, 1.0, 0.0)
            wind.move(dog, frame / 8, 0.5, 1.0)
            wind.advance(1 / 60)
        print(f"{wind.velocity(4.0, 0.5, 1.0)[0]:.2f} m/s at the leaf")


if __name__ == "__main__":
    try:
        main()
    except WindrowError as error:
        print(error, file=sys.stderr)
        sys.exit(2)
