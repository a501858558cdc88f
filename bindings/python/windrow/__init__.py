"""Windrow: the wind for plants. A voxel fluid in a box that follows a player, what acts on plants in it, and its operators on arrays.

    import windrow

    config = windrow.Config(boundaries=windrow.Boundaries.open_over_floor(), ambient=(3, 0, 0))
    wind = windrow.Wind(config)
    dog = wind.motors.add(windrow.WakeMotor(position=(0, 0.5, 1), radius=0.6))
    for frame in range(60):
        wind.follow((frame / 20, 1, 0))
        wind.motors.move(dog, (frame / 8, 0.5, 1))
        wind.advance(1 / 60)
    print(wind.velocity((4, 0.5, 1)))

Right-handed, y up, metres and seconds, unless `set_axes` says otherwise. Fields are arrays of numpy's, indexed [z, y, x, component]. What cannot be done is a WindrowError
with one sentence.
"""
from ._library import WindrowError, WindrowWarning, library as _c_library
from ._values import Stage
from ._version import __version__
from .axes import matrix, set_axes
from .forms import (AlignedBox, Block, Capsule, Cone, Cylinder, Drive, Force, Ground, GustTile, HeightMap, MeshShape, Plate, Sphere,
                    TriangleMesh, VoxelGrid, VoxelShape, WakeDrive, WakeForce)
from .operators import Workspace
from .plants import Blades, Shells, Springs, bend_angle, drag_of, plant_keys, spring_of
from .scene import Scene
from .settings import *  # noqa: F403
from .wind import DragField, DragId, EventLog, MotorId, Motors, ObstacleId, Obstacles, ThreadPool, Wind


def has_part(part: str) -> bool:
    """Whether the library was built with "coupling" (plants), "scene", "vdb" or "vulkan"."""
    parts = ("coupling", "vdb", "vulkan", "scene")
    if part not in parts:
        raise WindrowError(f"part is {part!r}: give 'coupling', 'scene', 'vdb' or 'vulkan'.")
    return bool(_c_library.windrow_has_part(parts.index(part)))
