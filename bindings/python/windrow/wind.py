"""The wind in a box that follows a player, with its motors, obstacles and deposits of drag."""
from __future__ import annotations

import ctypes
import os
from collections.abc import Sequence
from typing import Any, Literal, TypeVar, Union

import numpy as np
import numpy.typing as npt

from . import _c
from ._library import Handle, WindrowError, check, fail, library, taken_bytes
from .axes import matrix, own_order
from ._values import Floats, Quat, Vec3, _choice, _numbers, as_array, data, field, number, of_class, pointer, text, view, whole
from .settings import (Advance, BeltDrag, Boundaries, Box, Config, Diagnostics, DirectionalMotor, DragForce, Gusts, JetMotor,
                       Obstacle, ObstacleForce, OmniMotor, PlantDrag, PressureMotor, Sampling, VortexMotor, WakeMotor)

Motor = Union[DirectionalMotor, WakeMotor, JetMotor, VortexMotor, OmniMotor, PressureMotor]
Frame = Literal["now", "previous"]
FieldFormat = Literal["fga", "vf", "raw", "npz", "vti"]
_FRAMES = ("now", "previous")
_MOTORS = {DirectionalMotor: "directional", WakeMotor: "wake", JetMotor: "jet", VortexMotor: "vortex", OmniMotor: "omni",
           PressureMotor: "pressure"}
_DEPOSITS = {PlantDrag: "plant", BeltDrag: "belt"}
_KINDS = tuple(_MOTORS.values())
I = TypeVar("I", bound="_Id")


class ThreadPool:
    """Threads that many winds may share, the caller's among them; 0: one a core. Results do not depend on their number."""

    def __init__(self, threads: int = 0) -> None:
        count = whole("threads", threads, 0, 1024)
        self._handle = Handle(lambda out: library.windrow_thread_pool_create(count, out), "windrow_thread_pool_destroy")

    def __len__(self) -> int:
        return int(library.windrow_thread_pool_size(self._handle.pointer))

    @property
    def _loop(self) -> Any:
        return library.windrow_thread_pool_parallel_for(self._handle.pointer)


def loop_of(pool: ThreadPool | None) -> Any:
    """For a call that takes a loop or null."""
    return None if pool is None else ctypes.byref(of_class("pool", pool, ThreadPool)._loop)


class _Id:
    __slots__ = ("_id",)
    _struct: Any

    def __init__(self, name: Any) -> None:
        self._id = name

    @property
    def numbers(self) -> tuple[int, int, int]:
        """To be kept beside what `Wind.save` returns: it names the same in the wind that is loaded."""
        return (self._id.slot, self._id.generation, self._id.owner)

    @classmethod
    def from_numbers(cls: type[I], numbers: Sequence[int]) -> I:
        return cls(cls._struct(*numbers))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, type(self)) and other.numbers == self.numbers

    def __hash__(self) -> int:
        return hash(self.numbers)

    def __repr__(self) -> str:
        return f"{type(self).__name__}.from_numbers({self.numbers})"

    def __reduce__(self) -> Any:
        return (type(self).from_numbers, (self.numbers,))


class MotorId(_Id):
    """Names a motor of one wind."""

    __slots__ = ()
    _struct = _c.MotorId


class ObstacleId(_Id):
    """Names an obstacle of one wind."""

    __slots__ = ()
    _struct = _c.ObstacleId


class Motors:
    """The motors of a wind, at most 4096. A call with the id of a motor that ended or was removed fails with the kind "stale"."""

    def __init__(self, handle: Handle) -> None:
        self._handle = handle

    def _call(self, what: str, motor: Motor) -> tuple[Any, Any]:
        kind = _MOTORS.get(type(motor))
        if kind is None:
            raise WindrowError(f"motor is {motor!r}: give a DirectionalMotor, WakeMotor, JetMotor, VortexMotor, OmniMotor "
                               "or PressureMotor.")
        keep: list[Any] = []
        return getattr(library, f"windrow_wind_{what}_{kind}"), motor._to_c(keep)

    def add(self, motor: Motor) -> MotorId:
        """Begins a motor; the id names it in the calls below."""
        call, struct = self._call("add", motor)
        name = _c.MotorId()
        check(call(self._handle.pointer, ctypes.byref(struct), ctypes.byref(name)))
        return MotorId(name)

    def set(self, motor: MotorId, to: Motor) -> None:
        """Replaces a motor whole; its kind may change."""
        call, struct = self._call("set", to)
        check(call(self._handle.pointer, of_class("motor", motor, MotorId)._id, ctypes.byref(struct)))

    def move(self, motor: MotorId, position: Vec3) -> None:
        """To where it is at the end of the coming step or frame."""
        check(library.windrow_wind_move_motor(self._handle.pointer, of_class("motor", motor, MotorId)._id,
                                              _numbers("position", position, _c.DVec3)))

    def remove(self, motor: MotorId) -> None:
        """Ends a motor at once."""
        check(library.windrow_wind_remove_motor(self._handle.pointer, of_class("motor", motor, MotorId)._id))

    def kind(self, motor: MotorId) -> str:
        """"directional", "wake", "jet", "vortex", "omni" or "pressure"."""
        kind = ctypes.c_int32()
        check(library.windrow_wind_motor_kind(self._handle.pointer, of_class("motor", motor, MotorId)._id, ctypes.byref(kind)))
        return _KINDS[kind.value]

    def __contains__(self, motor: object) -> bool:
        if not isinstance(motor, MotorId):
            return False
        kind = ctypes.c_int32()
        return bool(library.windrow_wind_motor_kind(self._handle.pointer, motor._id, ctypes.byref(kind)) == _c.OK)

    def __len__(self) -> int:
        return int(library.windrow_wind_motor_count(self._handle.pointer))


class Obstacles:
    """The obstacles of a wind, at most 16384: bodies, buildings and grounds that the air flows around."""

    def __init__(self, handle: Handle) -> None:
        self._handle = handle

    def add(self, obstacle: Obstacle) -> ObstacleId:
        """Puts a body into the air; the id names it in the calls below."""
        of_class("obstacle", obstacle, Obstacle)
        keep: list[Any] = []
        name = _c.ObstacleId()
        check(library.windrow_wind_add_obstacle(self._handle.pointer, ctypes.byref(obstacle._to_c(keep)), ctypes.byref(name)))
        return ObstacleId(name)

    def set(self, obstacle: ObstacleId, to: Obstacle) -> None:
        """Replaces it whole; it pushes no air on the way."""
        keep: list[Any] = []
        struct = of_class("to", to, Obstacle)._to_c(keep)
        check(library.windrow_wind_set_obstacle(self._handle.pointer, of_class("obstacle", obstacle, ObstacleId)._id, ctypes.byref(struct)))

    def move(self, obstacle: ObstacleId, position: Vec3, orientation: Quat | None = None, spin: Vec3 | None = None) -> None:
        """To where it is at the end of the coming step or frame. None: it keeps its orientation.

        `spin` [rad/s] about its position along the world's axes is that of a wheel or a propeller, which two poses do not tell; None: by
        the poses, the shorter way.
        """
        turned = None if orientation is None else ctypes.byref(_numbers("orientation", orientation, _c.Quat))
        spun = None if spin is None else ctypes.byref(_numbers("spin", spin, _c.Vec3))
        check(library.windrow_wind_move_obstacle(self._handle.pointer, of_class("obstacle", obstacle, ObstacleId)._id,
                                                 _numbers("position", position, _c.DVec3), turned, spun))

    def remove(self, obstacle: ObstacleId) -> None:
        """Takes a body out of the air at once."""
        check(library.windrow_wind_remove_obstacle(self._handle.pointer, of_class("obstacle", obstacle, ObstacleId)._id))

    def __contains__(self, obstacle: object) -> bool:
        if not isinstance(obstacle, ObstacleId):
            return False
        struct = _c.Obstacle()
        check(library.windrow_obstacle_init(ctypes.byref(struct), ctypes.sizeof(struct)))
        return bool(library.windrow_wind_get_obstacle(self._handle.pointer, obstacle._id, ctypes.byref(struct)) == _c.OK)

    def force_on(self, obstacle: ObstacleId) -> ObstacleForce:
        """What the pressure of the air did to it in the last step."""
        struct = ObstacleForce()._to_c([])
        check(library.windrow_wind_force_on(self._handle.pointer, of_class("obstacle", obstacle, ObstacleId)._id, ctypes.byref(struct)))
        return ObstacleForce._from_c(struct)

    def __len__(self) -> int:
        return int(library.windrow_wind_obstacle_count(self._handle.pointer))


class DragId(_Id):
    """Names a deposit of drag of one wind."""

    __slots__ = ()
    _struct = _c.DragId


class DragField:
    """The deposits of a wind, at most 262144: plants, hedges, fences and nets that slow the air."""

    def __init__(self, handle: Handle) -> None:
        self._handle = handle

    def _call(self, what: str, deposit: PlantDrag | BeltDrag) -> tuple[Any, Any]:
        kind = _DEPOSITS.get(type(deposit))
        if kind is None:
            raise WindrowError(f"deposit is {deposit!r}: give a PlantDrag or a BeltDrag.")
        return getattr(library, f"windrow_wind_{what}_{kind}_drag"), deposit._to_c([])

    def add(self, deposit: PlantDrag | BeltDrag) -> DragId:
        """Adds a deposit; the id names it in the calls below."""
        call, struct = self._call("add", deposit)
        name = _c.DragId()
        check(call(self._handle.pointer, ctypes.byref(struct), ctypes.byref(name)))
        return DragId(name)

    def add_plants(self, plants: Sequence[PlantDrag]) -> list[DragId]:
        """Adds many plants in one call: all of them or, where one is rejected, none."""
        plants = [of_class("plant", plant, PlantDrag) for plant in list(plants)]
        structs = (_c.PlantDrag * len(plants))(*[plant._to_c([]) for plant in plants])
        names = (_c.DragId * len(plants))()
        check(library.windrow_wind_add_plants(self._handle.pointer, structs, len(plants), names))
        return [DragId(_c.DragId(name.slot, name.generation, name.owner)) for name in names]

    def set(self, deposit: DragId, to: PlantDrag | BeltDrag) -> None:
        """Replaces a deposit whole; its kind may change."""
        call, struct = self._call("set", to)
        check(call(self._handle.pointer, of_class("deposit", deposit, DragId)._id, ctypes.byref(struct)))

    def remove(self, deposit: DragId) -> None:
        """Takes a deposit out of the air."""
        check(library.windrow_wind_remove_drag(self._handle.pointer, of_class("deposit", deposit, DragId)._id))

    def __contains__(self, deposit: object) -> bool:
        if not isinstance(deposit, DragId):
            return False
        kind = ctypes.c_int32()
        return bool(library.windrow_wind_drag_kind(self._handle.pointer, deposit._id, ctypes.byref(kind)) == _c.OK)

    def force_on(self, deposit: DragId) -> DragForce:
        """What the air does to it, by the cells as they are after the last step."""
        struct = DragForce()._to_c([])
        check(library.windrow_wind_drag_force_on(self._handle.pointer, of_class("deposit", deposit, DragId)._id, ctypes.byref(struct)))
        return DragForce._from_c(struct)

    def __len__(self) -> int:
        return int(library.windrow_wind_drag_count(self._handle.pointer))


class EventLog:
    """Every accepted call that changed a wind, to repeat them: `wind.record_to(log)`, then `log.replay(another)`."""

    def __init__(self, saved: bytes | None = None) -> None:
        kept = b"" if saved is None else data("saved", saved)
        self._handle = Handle(library.windrow_event_log_create if saved is None else
                              lambda out: library.windrow_event_log_from_bytes(kept, len(kept), out), "windrow_event_log_destroy")

    def replay(self, wind: Wind) -> None:
        """Repeats all calls on a wind in the state in which the log began."""
        check(library.windrow_event_log_replay(self._handle.pointer, of_class("wind", wind, Wind)._handle.pointer))

    def to_bytes(self) -> bytes:
        """`EventLog(bytes)` has the same events."""
        return taken_bytes(lambda out: library.windrow_event_log_to_bytes(self._handle.pointer, out))

    def clear(self) -> None:
        """Forgets all events."""
        check(library.windrow_event_log_clear(self._handle.pointer))

    def __len__(self) -> int:
        return int(library.windrow_event_log_count(self._handle.pointer))


class Wind:
    """The wind in a box of cells that follows a player: right-handed, y up, metres and seconds.

        wind = windrow.Wind(windrow.Config(ambient=(3, 0, 0)))
        wind.follow(player)
        wind.advance(1 / 60)
        wind.velocity(leaf)

    One thread at a time may use a wind; other threads of Python run during its calls. `pool`: threads for its own loops; None: the
    caller's alone. `outer`: a larger wind around the box in place of the ambient one; advance it first in each frame. The config
    then gives no mean wind, profile or gusts: they are those of `outer`.
    """

    _outer: Wind | None

    def __init__(self, config: Config | None = None, *, pool: ThreadPool | None = None, outer: Wind | None = None) -> None:
        keep: list[Any] = []
        struct = (Config() if config is None else of_class("config", config, Config))._to_c(keep)
        if pool is not None:
            struct.parallel_for = of_class("pool", pool, ThreadPool)._loop
        around = None if outer is None else of_class("outer", outer, Wind)._handle
        self._take(Handle(lambda out: library.windrow_wind_create(ctypes.byref(struct), out) if around is None else
                          library.windrow_wind_create_inside(ctypes.byref(struct), around.pointer, out), "windrow_wind_destroy",
                          *([pool._handle] if pool else []), around))
        self._outer = outer

    @classmethod
    def load(cls, saved: bytes, *, pool: ThreadPool | None = None, outer: Wind | None = None) -> Wind:
        """A wind that goes on from what `save` returned. One that is inside another wind needs that, loaded before it, as `outer`."""
        loop, kept = loop_of(pool), data("saved", saved)
        around = None if outer is None else of_class("outer", outer, Wind)._handle
        wind = cls.__new__(cls)
        wind._take(Handle(lambda out: library.windrow_wind_load(kept, len(kept), loop, out) if around is None else
                          library.windrow_wind_load_inside(kept, len(kept), loop, around.pointer, out), "windrow_wind_destroy",
                          *([pool._handle] if pool else []), around))
        wind._outer = outer
        return wind

    @classmethod
    def _again(cls, saved: bytes, outer: Wind | None) -> Wind:
        return cls.load(saved, outer=outer)

    @classmethod
    def _of(cls, pointer: int, owner: Handle) -> Wind:
        """The wind of another object."""
        wind = cls.__new__(cls)
        wind._take(Handle.part_of(owner, pointer))
        wind._copies = True
        return wind

    def _take(self, handle: Handle) -> None:
        self._handle = handle
        self._wind = handle.pointer
        self._found = _c.Vec3()
        self._found_at = ctypes.byref(self._found)
        self._velocity = library.windrow_wind_velocity
        self._query = _c.Query()
        self._query_at = ctypes.byref(self._query)
        check(library.windrow_query_init(self._query_at, ctypes.sizeof(self._query)))
        self._velocities_at = ctypes.c_void_p.from_buffer(self._query, _c.Query.velocities.offset)
        self._copies = False
        self._outer = None
        self.motors = Motors(handle)
        self.obstacles = Obstacles(handle)
        self.drag = DragField(handle)
        self._cells = own_order(self.box.cells)  # for good

    def __reduce__(self) -> Any:
        """Copies and pickles are winds of their own, which go on from here, without a pool and a log. With the wind around them."""
        return (Wind.load, (self.save(),)) if self._outer is None else (Wind._again, (self.save(), self._outer))

    def __repr__(self) -> str:
        box = self.box
        return f"<windrow.Wind of {box.cells} cells of {box.cell_size} m at {box.origin}>"

    # --- Time
    def step(self, dt: float) -> Diagnostics:
        """Advances by dt [s] at once; reads then give the air after the step."""
        report = Diagnostics()._to_c([])
        check(library.windrow_wind_step(self._wind, number("dt", dt), ctypes.byref(report)))
        return Diagnostics._from_c(report)

    def advance(self, dt: float) -> Advance:
        """Advances by a frame of dt [s] in fixed ticks (Config.ticks_hz); reads then give the air at the frame, between two ticks."""
        report = Advance()._to_c([])
        check(library.windrow_wind_advance(self._wind, number("dt", dt), ctypes.byref(report), None))
        return Advance._from_c(report)

    # --- Place and ambient wind
    def follow(self, point: Vec3) -> None:
        """Centres the box on a point, to whole cells."""
        check(library.windrow_wind_follow(self._wind, _numbers("point", point, _c.DVec3)))

    def set_floor(self, height: float) -> None:
        """[m] Height of the box's low y face, to whole cells."""
        check(library.windrow_wind_set_floor(self._wind, number("height", height)))

    def shift_origin(self, offset: Vec3) -> None:
        """The origin of the world has moved: all places that the wind holds move by whole cells [m], and no air changes."""
        check(library.windrow_wind_shift_origin(self._wind, _numbers("offset", offset, _c.DVec3)))

    @property
    def box(self) -> Box:
        """Where the box of air is now, and its cells."""
        struct = Box()._to_c([])
        check(library.windrow_wind_box(self._wind, ctypes.byref(struct)))
        return Box._from_c(struct)

    def centres(self) -> npt.NDArray[np.float64]:
        """[m] World positions of the cells' centres, indexed [z, y, x, component] as a field. Rows of one thickness alone."""
        box, turn = self.box, matrix()[:3, :3]
        if not np.allclose(box.size, np.multiply(box.cell_size, box.cells), rtol=1e-5):
            raise WindrowError("the box has rows of unequal thickness: centres are those of Config.rows.")
        cells = self._grid()[::-1]
        ends = np.array([box.origin, np.add(box.origin, box.size)]) @ turn.T  # two opposite corners in the library's own axes [m]
        low, step = ends.min(axis=0), np.ptp(ends, axis=0) / cells
        axes = [low[n] + (np.arange(cells[n]) + 0.5) * step[n] for n in range(3)]
        z, y, x = np.meshgrid(axes[2], axes[1], axes[0], indexing="ij")
        places: npt.NDArray[np.float64] = np.stack([x, y, z], axis=-1) @ np.linalg.inv(turn).T
        return places

    @property
    def ambient(self) -> tuple[float, float, float]:
        """[m/s] The mean wind; may be set."""
        mean = library.windrow_wind_ambient(self._wind)
        return (mean.x, mean.y, mean.z)

    @ambient.setter
    def ambient(self, mean: Vec3) -> None:
        check(library.windrow_wind_set_ambient(self._wind, _numbers("ambient", mean, _c.Vec3)))

    def set_gusts(self, gusts: Gusts) -> None:
        """Other gusts from now on; an intensity of 0 ends them."""
        keep: list[Any] = []
        check(library.windrow_wind_set_gusts(self._wind, ctypes.byref(of_class("gusts", gusts, Gusts)._to_c(keep))))

    def set_boundaries(self, boundaries: Boundaries) -> None:
        """Other conditions at the faces of the box from now on."""
        check(library.windrow_wind_set_boundaries(self._wind, ctypes.byref(of_class("boundaries", boundaries, Boundaries)._to_c([]))))

    # --- Setting the air
    def set_field(self, velocity: npt.ArrayLike) -> None:
        """All cells [m/s], indexed [z, y, x, component], of three components or four.

        Cells that are no numbers become the ambient wind in the next step, which counts them (Diagnostics.repaired_cells).
        """
        cells, _ = field("velocity", velocity, self._grid())
        check(library.windrow_wind_set_field(self._wind, cells.ctypes.data_as(ctypes.POINTER(_c.Vec4)), cells.size // 4))

    def reset(self) -> None:
        """All cells become the ambient wind."""
        check(library.windrow_wind_reset(self._wind))

    # --- Reading the air
    def velocity(self, position: Vec3) -> tuple[float, float, float]:
        """[m/s] At a world point, within the box or beyond it."""
        try:
            x, y, z = position
            place = _c.DVec3(x, y, z)
        except (TypeError, ValueError):
            place = _numbers("position", position, _c.DVec3)
        result = self._velocity(self._wind, place, self._found_at)
        if result:
            fail(result)
        found = self._found
        return (found.x, found.y, found.z)

    def felt(self, position: Vec3, sampling: Sampling | None = None) -> tuple[float, float, float]:
        """[m/s] That acts on a plant there."""
        found = _c.Vec3()
        struct = _checked(sampling or Sampling())
        check(library.windrow_wind_felt(self._wind, _numbers("position", position, _c.DVec3), ctypes.byref(struct), ctypes.byref(found)))
        return (found.x, found.y, found.z)

    def sample(self, positions: npt.ArrayLike, sampling: Sampling | None = None, *, frame: Frame = "now",
               out: Floats | None = None) -> Floats:
        """[m/s] At many world points: an array (..., 3) of floats or doubles. With `sampling` what acts on plants there.

        `out`, an array of float32 of the same shape, receives the result and is returned.
        """
        points = np.asarray(positions, order="C") if isinstance(positions, np.ndarray) else as_array("positions", positions)
        if points.dtype.char not in "fd" or not points.dtype.isnative:
            points = as_array("positions", points).astype(np.float64)
        if points.ndim == 0 or points.shape[-1] != 3:
            raise WindrowError(f"positions have shape {points.shape}: give (..., 3).")
        if out is None:
            out = np.empty(points.shape, np.float32)
        elif (not isinstance(out, np.ndarray) or out.shape != points.shape or out.dtype.char != "f" or not out.dtype.isnative
              or not out.flags.c_contiguous or not out.flags.writeable):
            raise WindrowError(f"out is {getattr(out, 'shape', type(out).__name__)} of {getattr(out, 'dtype', 'no array')}: give a writable, "
                               f"contiguous array {points.shape} of float32.")
        query = self._query
        query.frame = _choice("frame", frame, _FRAMES)
        query.count = points.size // 3
        query.positions = points.ctypes.data
        query.number = _c.NUMBER_FLOAT if points.dtype.char == "f" else _c.NUMBER_DOUBLE
        self._velocities_at.value = out.ctypes.data
        query.sampling = None if sampling is None else ctypes.pointer(_checked(sampling))
        result = library.windrow_wind_sample(self._wind, self._query_at)
        if result:
            fail(result)
        return out

    def field(self, frame: Frame = "now") -> Floats:
        """A view of the cells [m/s], indexed [z, y, x, component] with x, y, z, 0; it cannot be written to.

        It shows the wind's own memory: after the next change of the wind its content is that of some later moment. Copy what must stay. Of
        a scene's wind it is a copy, since `Scene.restore` puts another wind in its place.
        """
        cells = ctypes.POINTER(_c.Vec4)()
        count = ctypes.c_uint64()
        check(library.windrow_wind_field(self._wind, _choice("frame", frame, _FRAMES), ctypes.byref(cells), ctypes.byref(count), None))
        shown = view(ctypes.addressof(cells.contents), (*self._grid(), 4), ctypes.c_float, self._handle)
        return shown.copy() if self._copies else shown

    def half_vectors(self, frame: Frame = "now") -> npt.NDArray[np.float16]:
        """One texture of x, y, z, 0 as halfs, indexed [z, y, x, component]: what a shader samples."""
        texels = np.empty((*self._grid(), 4), np.float16)
        check(library.windrow_wind_write_vectors(self._wind, _choice("frame", frame, _FRAMES), _c.TEXEL_HALF, pointer(texels), texels.size))
        return texels

    def inside_obstacles(self) -> npt.NDArray[np.bool_]:
        """Which cells have their centre inside an obstacle, indexed [z, y, x]."""
        cells = np.empty(self._grid(), np.float32)
        check(library.windrow_wind_write_obstacles(self._wind, cells.ctypes.data_as(ctypes.POINTER(ctypes.c_float)), cells.size))
        inside: npt.NDArray[np.bool_] = cells != 0.0
        return inside

    def pressure(self) -> Floats:
        """[m^2/s^2] Pressure over the air's density at the end of the last step, indexed [z, y, x]."""
        cells = np.empty(self._grid(), np.float32)
        check(library.windrow_wind_write_pressure(self._wind, cells.ctypes.data_as(ctypes.POINTER(ctypes.c_float)), cells.size))
        return cells

    # --- Keeping
    def save(self) -> bytes:
        """The whole state; `Wind.load` goes on from there with the same bits."""
        return taken_bytes(lambda out: library.windrow_wind_save(self._wind, out))

    def record_to(self, log: EventLog | None) -> None:
        """Notes every accepted call that changes the wind; None: no longer."""
        check(library.windrow_wind_record_to(self._wind, None if log is None else of_class("log", log, EventLog)._handle.pointer))
        self._handle.log = log
        for owner in self._handle._keeps:  # the wind of a scene lives as long as that
            if isinstance(owner, Handle):
                owner.log = log

    def write_vdb(self, path: str | os.PathLike[str], *, name: str = "vel", up: Literal["y", "z"] = "y", half: bool = False,
                  time: float = 0.0, frame: int = 0) -> None:
        """Writes the cells as an OpenVDB file, with those inside obstacles; metres, whatever `set_axes` says.

        `name` of the grid of velocities: Blender and Houdini look for "vel". `up`: "z" for Blender. `half`: 16 bits a number. `time` [s] and
        `frame` are kept in the file. A library without OpenVDB fails with the kind "unsupported" (windrow.has_part("vdb")).
        """
        options, kept = _c.VdbOptions(), text("name", name)
        check(library.windrow_vdb_options_init(ctypes.byref(options), ctypes.sizeof(options)))
        options.name, options.up, options.precision = kept, _choice("up", up, ("y", "z")), int(half)
        options.time, options.frame = number("time", time), whole("frame", frame, -2**31)
        check(library.windrow_vdb_write(self._wind, text("path", path), ctypes.byref(options)))

    def write_field(self, path: str | os.PathLike[str], format: FieldFormat | None = None, *, time: float = 0.0) -> None:
        """Writes the cells as a file of an engine or an analyst; None: the format of the path's suffix.

        fga: Unreal Engine, z up, left-handed, centimetres. vf: Unity, y up, left-handed. raw: a 3D texture of halfs x, y, z, 0, with its
        size and place in NAME.raw.json. npz: numpy. vti: ParaView. The last three have the axes of the library. A box with rows of
        unequal thickness is sampled at the centres of equal cells.
        """
        words = ("fga", "vf", "raw", "npz", "vti")
        place = text("path", path)
        chosen = os.path.splitext(os.fsdecode(place))[1][1:].lower() if format is None else format
        check(library.windrow_wind_write_field(self._wind, place, _choice("format", chosen, words), number("time", time)))

    def write_scene(self, path: str | os.PathLike[str], *, duration: float = 10.0, tick_hz: float = 60.0) -> None:
        """Writes a scene file that `windrow run` and `Scene` play: settings, motors, obstacles and drag as they are now, from time 0 on.

        The air of this moment is not in it (`save`). `duration` [s] above 0, default 10, that of most examples; `tick_hz`: steps a second
        at least. Wakes, meshes, voxel grids, grounds and maps of roughness are rejected: a scene has paths or files for them.
        """
        check(library.windrow_wind_write_scene(self._wind, text("path", path), number("duration", duration), number("tick_hz", tick_hz)))

    def debug_lines(self, *, box: bool = True, motors: bool = True, obstacles: bool = True, arrows: int = 16, seconds: float = 0.2,
                    height: float | None = None) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int32], npt.NDArray[np.float32]]:
        """Lines of a debug view: ends [m] of shape (n, 2, 3), what each belongs to, and the speed [m/s] of the wind at an arrow's foot.

        0 is the box, 1 a motor, 2 an obstacle, 3 an arrow. `arrows` along the longer level axis, 0 (none) to 256; `seconds`: an arrow is as
        long as the way of the air in this time, above 0; `height` [m] of the arrows above the box's low face; None: 1 m.
        """
        wanted = _c.DebugView()
        check(library.windrow_debug_view_init(ctypes.byref(wanted), ctypes.sizeof(wanted)))
        wanted.box, wanted.motors, wanted.obstacles = int(box), int(motors), int(obstacles)
        wanted.arrows, wanted.seconds = whole("arrows", arrows, 0, 256), number("seconds", seconds)
        if height is not None:
            wanted.height = number("height", height)
        ends: list[tuple[float, ...]] = []
        kinds: list[int] = []
        speeds: list[float] = []

        def draw(_user: object, line: Any) -> None:
            one = line.contents
            ends.append((one.begin.x, one.begin.y, one.begin.z, one.end.x, one.end.y, one.end.z))
            kinds.append(one.kind)
            speeds.append(one.speed)

        check(library.windrow_wind_debug_lines(self._wind, ctypes.byref(wanted), _c.DebugDraw(draw), None))
        return (np.array(ends, np.float64).reshape(-1, 2, 3), np.array(kinds, np.int32), np.array(speeds, np.float32))

    @property
    def memory_bytes(self) -> int:
        """That the wind has allocated."""
        return int(library.windrow_wind_memory_bytes(self._wind))

    def _grid(self) -> tuple[int, int, int]:
        return self._cells


def _checked(sampling: Sampling) -> Any:
    struct = of_class("sampling", sampling, Sampling)._to_c([])
    check(library.windrow_sampling_validate(ctypes.byref(struct)))
    return struct
