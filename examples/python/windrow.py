#!/usr/bin/env python3
"""Tutorial: the README's ten lines in Python, by ctypes, and a small class to take along.

    windrow.py          prints the wind at a leaf after a second

1. Load the shared library: the one of WINDROW_LIBRARY, else the system's.
2. windrow_c, beside this file, has all structs, choices and functions of the C headers. The init functions fill a struct with
   defaults, so only what differs is set.
3. Every call returns 0 or a negative class of error; `Windrow.check` makes an exception of it, with the library's sentence.
"""
import ctypes as c
import os
import sys

from windrow_c import Config, DVec3, MotorId, Vec3, WakeMotor, bind

library = bind(c.CDLL(os.environ.get("WINDROW_LIBRARY", "libwindrow.so.0.1")))


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
