"""Windrow in Blender: empties blow, meshes stand in the wind, blades and points are baked.

The add-on holds the package `windrow` beside it (folder lib); without one, Blender's own Python must find it.
"""
bl_info = {
    "name": "Windrow wind",
    "author": "Windrow",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "Scene properties > Wind, Object properties > Wind",
    "description": "Wind for plants: motors, obstacles, blades of grass, baked to caches that play without the add-on",
    "category": "Physics",
}

import pathlib
import sys

_LIB = pathlib.Path(__file__).with_name("lib")
if _LIB.exists() and str(_LIB) not in sys.path:
    sys.path.append(str(_LIB))

from . import bake, blades, panel  # noqa: E402


def register() -> None:
    panel.register()
    blades.register()
    bake.register()


def unregister() -> None:
    bake.unregister()
    blades.unregister()
    panel.unregister()
