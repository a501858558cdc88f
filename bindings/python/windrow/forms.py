"""Regions and laws of motors, shapes of obstacles, and what many of them share: meshes, voxels, height maps, gust tiles."""
from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import Any, Literal, Union

import numpy as np
import numpy.typing as npt

from . import _c
from ._library import Handle, WindrowError, library, taken_bytes
from ._values import Floats, Form, Vec2, Vec3, _choice, _numbers, as_array, data, metre, number, of_class, view, whole

_ONE = _c.Vec3(1.0, 1.0, 1.0)


# --- What many winds may share ---------------------------------------------------------------------------------------------

class Shared(Form):
    """An object of the library that does not change; what uses one keeps it."""

    _handle: Handle

    def _as_shared(self) -> Handle:
        return self._handle

    def __copy__(self) -> Shared:
        return self

    def __deepcopy__(self, _memo: Any) -> Shared:
        return self


class TriangleMesh(Shared):
    """A closed mesh of triangles, counter-clockwise from outside: `vertices` [m] is (n, 3), `triangles` (m, 3) of their numbers.

    Open edges are rejected, with their number.
    """

    def __init__(self, vertices: npt.ArrayLike, triangles: npt.ArrayLike) -> None:
        corners = np.ascontiguousarray(as_array("vertices", vertices), np.float32)
        given = as_array("triangles", triangles)
        if given.size and given.dtype.kind not in "iu":
            raise WindrowError(f"triangles is an array of {given.dtype}: give whole numbers, those of vertices.")
        if corners.ndim != 2 or corners.shape[1] != 3 or given.ndim != 2 or given.shape[1] != 3:
            raise WindrowError(f"vertices have shape {corners.shape}, triangles {given.shape}: give (n, 3) and (m, 3).")
        if given.size and (given.min() < 0 or given.max() >= len(corners)):
            raise WindrowError(f"triangles name vertices {given.min()} to {given.max()}: there are {len(corners)}, from 0 on.")
        numbers = np.ascontiguousarray(given, np.uint32)
        self._handle = Handle(lambda out: library.windrow_mesh_create(
            corners.ctypes.data_as(ctypes.POINTER(_c.Vec3)), len(corners), numbers.ctypes.data_as(ctypes.POINTER(ctypes.c_uint32)),
            len(numbers), out), "windrow_mesh_destroy")

    def save(self) -> bytes:
        """All that the constructor finds; `load` makes the mesh again in a fraction of the time, with the same bits."""
        return taken_bytes(lambda out: library.windrow_mesh_save(self._handle.pointer, out))

    @classmethod
    def load(cls, saved: bytes) -> TriangleMesh:
        """A mesh from what `save` returned. Damaged bytes and those of another version are rejected."""
        kept, mesh = data("saved", saved), cls.__new__(cls)
        mesh._handle = Handle(lambda out: library.windrow_mesh_load(kept, len(kept), out), "windrow_mesh_destroy")
        return mesh

    def distance(self, point: Vec3) -> float:
        """[m] From a point to its surface, negative inside."""
        return float(library.windrow_mesh_distance(self._handle.pointer, _numbers("point", point, _c.Vec3)))


class VoxelGrid(Shared):
    """Closed cells of a grid: an array indexed [z, y, x], in which what is not 0 is closed."""

    def __init__(self, closed: npt.ArrayLike) -> None:
        cells = np.ascontiguousarray(as_array("closed", closed) != 0, np.uint8)
        if cells.ndim != 3:
            raise WindrowError(f"closed has shape {cells.shape}: give three axes, [z, y, x].")
        size = _c.IVec3(*cells.shape[::-1])
        self._handle = Handle(lambda out: library.windrow_voxels_create(
            size, cells.ctypes.data_as(ctypes.POINTER(ctypes.c_uint8)), cells.size, out), "windrow_voxels_destroy")


class HeightMap(Shared):
    """Heights [m] at the corners of a grid, indexed [z, x] (a host with z up: [y, x]), `spacing` apart; None: 1 m.

    `holes`, indexed [z, x] too, is a grid of cells that covers the map whole: what is not 0 has no ground to any depth.
    """

    def __init__(self, heights: npt.ArrayLike, spacing: float | None = None, holes: npt.ArrayLike | None = None) -> None:
        numbers = np.ascontiguousarray(as_array("heights", heights), np.float32)
        spacing = metre() if spacing is None else number("spacing", spacing)
        if numbers.ndim != 2:
            raise WindrowError(f"heights have shape {numbers.shape}: give two axes, [z, x].")
        corners = _c.IVec2(*numbers.shape[::-1])
        first = numbers.ctypes.data_as(ctypes.POINTER(ctypes.c_float))
        if holes is None:
            self._handle = Handle(lambda out: library.windrow_height_map_create(corners, spacing, first, numbers.size, out),
                                  "windrow_height_map_destroy")
            return
        open_cells = np.ascontiguousarray(as_array("holes", holes) != 0, np.uint8)
        if open_cells.ndim != 2:
            raise WindrowError(f"holes have shape {open_cells.shape}: give two axes, [z, x].")
        self._handle = Handle(lambda out: library.windrow_height_map_create_with_holes(
            corners, spacing, first, numbers.size, _c.IVec2(*open_cells.shape[::-1]),
            open_cells.ctypes.data_as(ctypes.POINTER(ctypes.c_uint8)), open_cells.size, out), "windrow_height_map_destroy")

    def height(self, place: Vec2) -> float:
        """[m] At x, z from the first corner."""
        return float(library.windrow_height_map_height(self._handle.pointer, _numbers("place", place, _c.Vec2)))


class GustTile(Shared):
    """The pattern of gusts of a seed, for many winds to use one."""

    def __init__(self, seed: int = 1) -> None:
        value = whole("seed", seed, 0, 2**32 - 1)
        self._handle = Handle(lambda out: library.windrow_gust_tile_bake(value, out), "windrow_gust_tile_destroy")

    def save(self) -> bytes:
        """Its seed and a checksum of its texels."""
        return taken_bytes(lambda out: library.windrow_gust_tile_save(self._handle.pointer, out))

    @classmethod
    def load(cls, saved: bytes) -> GustTile:
        """The tile again, baked in some 5 ms and compared with the checksum. Damaged bytes are rejected."""
        kept, tile = data("saved", saved), cls.__new__(cls)
        tile._handle = Handle(lambda out: library.windrow_gust_tile_load(kept, len(kept), out), "windrow_gust_tile_destroy")
        return tile

    def texels(self) -> Floats:
        """A view of its 128 x 16 x 128 texels of four floats."""
        count = ctypes.c_uint64()
        first = library.windrow_gust_tile_texels(self._handle.pointer, ctypes.byref(count))
        return view(ctypes.cast(first, ctypes.c_void_p).value or 0, (128, 16, 128, 4), ctypes.c_float, self._handle)


# --- Regions of motors -----------------------------------------------------------------------------------------------------

@dataclass(slots=True)
class Sphere(Form):
    """A ball: a region of a motor, or a shape of an obstacle. `radius` in metres."""

    radius: float = 2.0

    def _to_c(self, keep: list[Any]) -> Any:
        return _c.Region(kind=_c.REGION_SPHERE, radius=self.radius)

    def _shape(self, keep: list[Any]) -> Any:
        return _c.Shape(kind=_c.SHAPE_SPHERE, radius=self.radius, scale=_ONE)


@dataclass(slots=True)
class Capsule(Form):
    """A ball drawn out along a segment, from the centre - half_axis to + half_axis: a region or a shape. [m]"""

    half_axis: Vec3 = (2.0, 0.0, 0.0)
    radius: float = 1.0

    def _to_c(self, keep: list[Any]) -> Any:
        return _c.Region(kind=_c.REGION_CAPSULE, half_axis=_numbers("half_axis", self.half_axis, _c.Vec3), radius=self.radius)

    def _shape(self, keep: list[Any]) -> Any:
        return _c.Shape(kind=_c.SHAPE_CAPSULE, half_axis=_numbers("half_axis", self.half_axis, _c.Vec3), radius=self.radius, scale=_ONE)


@dataclass(slots=True)
class AlignedBox(Form):
    """A region: a box along the axes, `half_size` [m] from the centre to the faces."""

    half_size: Vec3 = (2.0, 2.0, 2.0)

    def _to_c(self, keep: list[Any]) -> Any:
        return _c.Region(kind=_c.REGION_BOX, half_size=_numbers("half_size", self.half_size, _c.Vec3))


@dataclass(slots=True)
class Cone(Form):
    """A region: a cone from the motor's position along `axis` [m], with its radii at both ends."""

    axis: Vec3 = (6.0, 0.0, 0.0)
    start_radius: float = 0.5
    end_radius: float = 2.0

    def _to_c(self, keep: list[Any]) -> Any:
        return _c.Region(kind=_c.REGION_CONE, axis=_numbers("axis", self.axis, _c.Vec3), start_radius=self.start_radius,
                         end_radius=self.end_radius)


Region = Union[Sphere, Capsule, AlignedBox, Cone]


# --- Laws of motors --------------------------------------------------------------------------------------------------------

@dataclass(slots=True)
class Force(Form):
    """A constant acceleration [m/s^2] along the motor's direction."""

    acceleration: float = 10.0

    def _to_c(self, keep: list[Any]) -> Any:
        return _c.Law(kind=_c.LAW_FORCE, acceleration=self.acceleration)


@dataclass(slots=True)
class Drive(Form):
    """Pulls the air toward a speed [m/s] along the motor's direction, at a rate [1/s]."""

    speed: float = 8.0
    rate: float = 4.0

    def _to_c(self, keep: list[Any]) -> Any:
        return _c.Law(kind=_c.LAW_DRIVE, speed=self.speed, rate=self.rate)


@dataclass(slots=True)
class WakeForce(Form):
    """Pushes: the same impulse for each metre that the body passes; `strength` [1/s] is the speed that a metre adds."""

    strength: float = 1.0

    def _to_c(self, keep: list[Any]) -> Any:
        return _c.WakeLaw(kind=_c.LAW_FORCE, strength=self.strength)


@dataclass(slots=True)
class WakeDrive(Form):
    """Drags: pulls the air toward `entrainment` times the body's velocity, 63 % of the way within 1 / per_metre metres."""

    per_metre: float = 0.5
    entrainment: float = 1.0

    def _to_c(self, keep: list[Any]) -> Any:
        return _c.WakeLaw(kind=_c.LAW_DRIVE, per_metre=self.per_metre, entrainment=self.entrainment)


Law = Union[Force, Drive]
WakeLaw = Union[WakeForce, WakeDrive]


# --- Shapes of obstacles ---------------------------------------------------------------------------------------------------

@dataclass(slots=True)
class Block(Form):
    """A box with its own axes: a house, a wall. `half_size` [m] from the centre to the faces."""

    half_size: Vec3 = (1.0, 1.0, 1.0)

    def _shape(self, keep: list[Any]) -> Any:
        return _c.Shape(kind=_c.SHAPE_BLOCK, half_size=_numbers("half_size", self.half_size, _c.Vec3), scale=_ONE)


@dataclass(slots=True)
class Cylinder(Form):
    """A cylinder along its own y axis: a trunk, a tower. [m]"""

    radius: float = 1.0
    half_length: float = 1.0

    def _shape(self, keep: list[Any]) -> Any:
        return _c.Shape(kind=_c.SHAPE_CYLINDER, radius=self.radius, half_length=self.half_length, scale=_ONE)


@dataclass(slots=True)
class Plate(Form):
    """A rectangle without thickness, across its own z axis: a fence, a sail, a door. `half_size` [m] along its x and y."""

    half_size: Vec2 = (1.0, 1.0)

    def _shape(self, keep: list[Any]) -> Any:
        return library.windrow_shape_plate(_numbers("half_size", self.half_size, _c.Vec2))


@dataclass(slots=True)
class MeshShape(Form):
    """A closed mesh of triangles: a house, a statue, a vehicle."""

    mesh: TriangleMesh
    scale: float = 1.0

    def _shape(self, keep: list[Any]) -> Any:
        mesh = of_class("MeshShape.mesh", self.mesh, TriangleMesh)
        keep.append(mesh)
        return _c.Shape(kind=_c.SHAPE_MESH, scale=_c.Vec3(self.scale, 1.0, 1.0), mesh=mesh._handle.pointer)


@dataclass(slots=True)
class VoxelShape(Form):
    """Closed cells of a grid, which is centred: a building of a voxel game. `cell_size` in metres."""

    grid: VoxelGrid
    cell_size: float = 1.0

    def _shape(self, keep: list[Any]) -> Any:
        grid = of_class("VoxelShape.grid", self.grid, VoxelGrid)
        keep.append(grid)
        return _c.Shape(kind=_c.SHAPE_VOXELS, scale=_ONE, cell_size=self.cell_size, voxels=grid._handle.pointer)


@dataclass(slots=True)
class Ground(Form):
    """All below a height map: hills, a valley, a dam. The position is that of height 0 at the map's first corner.

    `scale`: factors on the map's size along x and z, and, y, on its heights. `beyond` "nothing" makes it a tile of several.
    """

    heights: HeightMap
    scale: Vec3 = (1.0, 1.0, 1.0)
    beyond: Literal["edge", "nothing"] = "edge"

    def _shape(self, keep: list[Any]) -> Any:
        heights = of_class("Ground.heights", self.heights, HeightMap)
        keep.append(heights)
        return _c.Shape(kind=_c.SHAPE_GROUND, scale=_numbers("scale", self.scale, _c.Vec3), heights=heights._handle.pointer,
                        beyond=_choice("beyond", self.beyond, ("edge", "nothing")))


Shape = Union[Sphere, Capsule, Block, Cylinder, Plate, MeshShape, VoxelShape, Ground]
