"""Plants on the CPU: blades of grass and shells of fur that bend in a wind, and the springs on which they swing."""
from __future__ import annotations

import ctypes
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from . import _c
from ._library import Handle, WindrowError, check, library
from ._values import Floats, Vec3, _choice, _numbers, as_array, number, of_class, whole
from .settings import BladeSettings, Drag, ShellSettings, SpringClass
from .wind import ThreadPool, loop_of

Plant = Literal["grass", "wheat", "reed", "leaf", "twig", "branch", "small_trunk", "large_trunk"]
SpringPlant = Literal["grass", "wheat", "alfalfa", "reed", "leaf", "twig", "branch", "trunk"]
_PLANTS = ("grass", "wheat", "reed", "leaf", "twig", "branch", "small_trunk", "large_trunk")
_SPRINGS = ("grass", "wheat", "alfalfa", "reed", "leaf", "twig", "branch", "trunk")
_VECTORS = ctypes.POINTER(_c.Vec4)


def drag_of(plant: Plant) -> Drag:
    """The predefined class of a plant."""
    struct = Drag()._to_c([])
    check(library.windrow_drag_of(_choice("plant", plant, _PLANTS), ctypes.byref(struct)))
    return Drag._from_c(struct)


def spring_of(plant: SpringPlant) -> SpringClass:
    """How a plant swings."""
    struct = _c.SpringClass()
    check(library.windrow_spring_class_of(_choice("plant", plant, _SPRINGS), ctypes.byref(struct)))
    return SpringClass._from_c(struct)


def bend_angle(drag: Drag, speed: float) -> float:
    """[rad] Lean of the tip in a steady wind [m/s]."""
    angle = ctypes.c_float()
    struct = of_class("drag", drag, Drag)._to_c([])
    check(library.windrow_bend_angle(ctypes.byref(struct), number("speed", speed), ctypes.byref(angle)))
    return angle.value


def plant_keys(places: npt.ArrayLike) -> npt.NDArray[np.uint32]:
    """The keys of plants that stand at x, z (n, 2): the seeds of their random numbers, (n, 2)."""
    points = as_array("places", places).astype(np.float32)
    if points.ndim != 2 or points.shape[1] != 2:
        raise WindrowError(f"places have shape {points.shape}: give (n, 2), x and z.")
    keys = [library.windrow_place_key(float(x), float(z)) for x, z in points]
    return np.array([(key.x, key.y) for key in keys], np.uint32).reshape(-1, 2)


def _vectors(name: str, values: npt.ArrayLike, count: int) -> Floats:
    """(n, 3) or (n, 4) as the library reads it."""
    given = as_array(name, values).astype(np.float32)
    if given.ndim != 2 or given.shape[0] != count or given.shape[1] not in (3, 4):
        raise WindrowError(f"{name} have shape {given.shape}: give ({count}, 3) or ({count}, 4).")
    room = np.zeros((count, 4), np.float32)
    room[:, :given.shape[1]] = given
    return room


def _keys(keys: npt.ArrayLike) -> npt.NDArray[np.uint32]:
    given = as_array("keys", keys)
    if given.ndim != 2 or given.shape[1] != 2 or given.dtype.kind not in "iu":
        raise WindrowError(f"keys is {given.shape} of {given.dtype}: give what plant_keys returns, (n, 2) of uint32.")
    return np.ascontiguousarray(given, np.uint32)


def _at(array: Floats) -> Any:
    return array.ctypes.data_as(_VECTORS)


class Blades:
    """Blades of grass of one class, named by the keys of `plant_keys`."""

    def __init__(self, settings: BladeSettings | None = None) -> None:
        keep: list[Any] = []
        struct = (BladeSettings() if settings is None else of_class("settings", settings, BladeSettings))._to_c(keep)
        self._handle = Handle(lambda out: library.windrow_blades_create(ctypes.byref(struct), out), "windrow_blades_destroy")

    def loads(self, keys: npt.NDArray[np.uint32], winds: npt.ArrayLike, pool: ThreadPool | None = None) -> Floats:
        """[rad] Bends (n, 4) that winds (n, 3) [m/s] hold: what a blade's spring has as its target."""
        names = _keys(keys)
        wind = _vectors("winds", winds, len(names))
        result = np.empty((len(names), 4), np.float32)
        check(library.windrow_blades_loads(self._handle.pointer, len(names), names.ctypes.data_as(ctypes.POINTER(_c.UVec2)), _at(wind),
                                           _at(result), loop_of(pool)))
        return result

    def vertices(self, keys: npt.NDArray[np.uint32], roots: npt.ArrayLike, loads: npt.ArrayLike,
                 heights: npt.ArrayLike = (0.0, 0.5, 1.0), view: Vec3 = (0.0, 0.0, 0.0),
                 pool: ThreadPool | None = None) -> tuple[Floats, Floats]:
        """Positions [m] and normals (n, rows, 2, 4): blade by blade, row by row, left then right.

        `heights` of the rows are 0 at the root to 1 at the tip; `view` is the unit vector from the eye, for BladeSettings.view_bend.
        """
        names = _keys(keys)
        count = len(names)
        root, load = _vectors("roots", roots, count), _vectors("loads", loads, count)
        rows = np.ascontiguousarray(as_array("heights", heights), np.float32).reshape(-1)
        positions, normals = (np.empty((count, rows.size, 2, 4), np.float32) for _ in range(2))
        check(library.windrow_blades_vertices(
            self._handle.pointer, count, names.ctypes.data_as(ctypes.POINTER(_c.UVec2)), _at(root), _at(load), rows.size,
            rows.ctypes.data_as(ctypes.POINTER(ctypes.c_float)), _numbers("view", view, _c.Vec3), _at(positions), _at(normals),
            loop_of(pool)))
        return positions, normals


class Shells:
    """Layers of fur or grass over a skin."""

    def __init__(self, settings: ShellSettings | None = None) -> None:
        keep: list[Any] = []
        struct = (ShellSettings() if settings is None else of_class("settings", settings, ShellSettings))._to_c(keep)
        self._count = struct.shells
        self._handle = Handle(lambda out: library.windrow_shells_create(ctypes.byref(struct), out), "windrow_shells_destroy")

    def height(self, shell: int) -> float:
        """0 to 1, of shell 0 to N - 1."""
        return float(library.windrow_shells_height(self._handle.pointer, whole("shell", shell, 0, self._count - 1)))

    def loads(self, positions: npt.ArrayLike, normals: npt.ArrayLike, winds: npt.ArrayLike) -> Floats:
        """[rad] Bends (n, 4) that winds (n, 3) [m/s] hold. A fourth component of `positions` is the map of the strands' length; 1 without."""
        skin, _keep, count = self._skin(positions, normals)
        wind = _vectors("winds", winds, count)
        result = np.empty((count, 4), np.float32)
        check(library.windrow_shells_loads_many(self._handle.pointer, ctypes.byref(skin), _at(wind), _at(result), None))
        return result

    def bent(self, positions: npt.ArrayLike, normals: npt.ArrayLike, height: float, loads: npt.ArrayLike) -> Floats:
        """[m] The skin's vertices on the layer of a height, (n, 4)."""
        skin, _keep, count = self._skin(positions, normals)
        load = _vectors("loads", loads, count)
        result = np.empty((count, 4), np.float32)
        check(library.windrow_shells_bent_many(self._handle.pointer, ctypes.byref(skin), number("height", height), _at(load), _at(result), None))
        return result

    @staticmethod
    def _skin(positions: npt.ArrayLike, normals: npt.ArrayLike) -> tuple[Any, list[Floats], int]:
        given = as_array("positions", positions).astype(np.float32)
        count = len(given) if given.ndim else 0
        place, normal = _vectors("positions", given, count), _vectors("normals", normals, count)
        if given.shape[1] == 3:
            place[:, 3] = 1.0
        return _c.Skin(count=count, positions=_at(place), normals=_at(normal)), [place, normal], count


class Springs:
    """Springs side by side: `place` follows a target as plants of a class do, exactly for any step. An array of any shape."""

    def __init__(self, spring: SpringClass | SpringPlant, start: npt.ArrayLike) -> None:
        self._spring = spring if isinstance(spring, SpringClass) else spring_of(spring)
        self._place = np.array(as_array("start", start), np.float64, order="C")
        self._velocity = np.zeros_like(self._place)
        self._target = self._place.copy()
        self._step = _c.SpringStep()
        self._duration: float | None = None

    @property
    def spring(self) -> SpringClass:
        """The class that it was made with."""
        return self._spring

    @property
    def place(self) -> npt.NDArray[np.float64]:
        """The memory of the springs, which `advance` changes. What is assigned is copied into it."""
        return self._place

    @place.setter
    def place(self, values: npt.ArrayLike) -> None:
        self._place[...] = self._fitting("place", values)

    @property
    def velocity(self) -> npt.NDArray[np.float64]:
        """[1/s] As `place`."""
        return self._velocity

    @velocity.setter
    def velocity(self, values: npt.ArrayLike) -> None:
        self._velocity[...] = self._fitting("velocity", values)

    def advance(self, target: npt.ArrayLike, duration: float) -> npt.NDArray[np.float64]:
        """Moves by `duration` [s], in which the target goes evenly from that of the last call to this one; returns `place`."""
        now = self._fitting("target", target)
        length = number("duration", duration)
        if length != self._duration:
            struct = self._spring._to_c([])
            check(library.windrow_spring_step_make(ctypes.byref(struct), length, ctypes.byref(self._step)))
            self._duration = length
        batch = _c.SpringBatch(count=self._place.size, place=self._place.ctypes.data, velocity=self._velocity.ctypes.data,
                               target_before=self._target.ctypes.data, target_now=now.ctypes.data)
        check(library.windrow_springs_advance_double(ctypes.byref(self._step), ctypes.byref(batch), None))
        self._target = now
        return self._place

    def _fitting(self, name: str, values: npt.ArrayLike) -> npt.NDArray[np.float64]:
        given = as_array(name, values).astype(np.float64)
        try:
            return np.array(np.broadcast_to(given, self._place.shape), order="C")
        except ValueError:
            raise WindrowError(f"{name} has shape {given.shape}: give {self._place.shape}, or what numpy repeats to it.") from None
