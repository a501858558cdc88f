"""A scene file, played: the same air as that of `windrow run`."""
from __future__ import annotations

import ctypes
import os

from . import _c
from ._library import Handle, check, library, taken_bytes
from .settings import Advance, Diagnostics
from ._values import data, number, text as encoded
from .wind import MotorId, ObstacleId, ThreadPool, Wind, loop_of


class Scene:
    """The air of a scene file. Motors and obstacles come, move and go as the file says; `wind` takes more of them.

        scene = windrow.Scene("fan.json")
        while scene.time < scene.duration:
            scene.step()
        scene.wind.velocity(leaf)

    `wind` has the scene's air, and keeps it while it is used; its own `step` and `advance` would leave the scene's clock behind. `outer`
    has the winds around it (`air.outer`), from the nearest out. A file
    needs nothing but what differs from the defaults:

        {"duration": 5, "air": {"ambient": [3, 0, 0]}, "motors": [{"name": "fan", "kind": "jet", "position": [0, 1, 0]}]}
    """

    def __init__(self, path: str | os.PathLike[str], *, text: str | None = None, pool: ThreadPool | None = None) -> None:
        """Reads a file, or, where `text` is given, that text of JSON, as if it stood in the file `path`."""
        loop, place = loop_of(pool), encoded("path", path)
        keeps = [pool._handle] if pool else []
        if text is None:
            self._handle = Handle(lambda out: library.windrow_scene_load(place, loop, out), "windrow_scene_destroy", *keeps)
        else:
            said = encoded("text", text)
            self._handle = Handle(lambda out: library.windrow_scene_parse(said, len(said), place, loop, out), "windrow_scene_destroy", *keeps)
        self._scene = self._handle.pointer
        self.wind = Wind._of(library.windrow_scene_wind(self._scene), self._handle)
        count = library.windrow_scene_outer_count(self._scene)
        self.outer = tuple(Wind._of(library.windrow_scene_outer_wind(self._scene, place), self._handle) for place in range(count))
        for inner, around in zip((self.wind, *self.outer), self.outer):
            inner._outer = around

    def step(self) -> Diagnostics:
        """One step, as `windrow run` makes it: at most a tick of the scene, so that frames are at the ends of steps."""
        report = Diagnostics()._to_c([])
        check(library.windrow_scene_step(self._scene, ctypes.byref(report)))
        return Diagnostics._from_c(report)

    def advance(self, dt: float) -> Advance:
        """A frame of dt [s] in the fixed ticks of the wind. Either this or steps."""
        report = Advance()._to_c([])
        check(library.windrow_scene_advance(self._scene, number("dt", dt), ctypes.byref(report)))
        return Advance._from_c(report)

    @property
    def time(self) -> float:
        """[s]"""
        return float(library.windrow_scene_time(self._scene))

    @property
    def duration(self) -> float:
        """[s]"""
        return float(library.windrow_scene_duration(self._scene))

    @property
    def frames_per_second(self) -> float:
        """Of the files that `windrow run` writes."""
        return float(library.windrow_scene_frames_per_second(self._scene))

    @property
    def motor_names(self) -> list[str]:
        """In the order of the file."""
        count = library.windrow_scene_motor_count(self._scene)
        return [library.windrow_scene_motor_name(self._scene, n).decode() for n in range(count)]

    @property
    def obstacle_names(self) -> list[str]:
        """In the order of the file."""
        count = library.windrow_scene_obstacle_count(self._scene)
        return [library.windrow_scene_obstacle_name(self._scene, n).decode() for n in range(count)]

    def motor(self, name: str) -> MotorId | None:
        """The motor that acts under a name; None: not at this time. A name that the scene does not have is an error."""
        found = _c.MotorId()
        result = library.windrow_scene_motor(self._scene, encoded("name", name), ctypes.byref(found))
        if result == _c.STALE:
            return None
        check(result)
        return MotorId(found)

    def obstacle(self, name: str) -> ObstacleId | None:
        """The obstacle that stands under a name; None: not at this time. A name that the scene does not have is an error."""
        found = _c.ObstacleId()
        result = library.windrow_scene_obstacle(self._scene, encoded("name", name), ctypes.byref(found))
        if result == _c.STALE:
            return None
        check(result)
        return ObstacleId(found)

    def save(self) -> bytes:
        """The clock and the air."""
        return taken_bytes(lambda out: library.windrow_scene_save(self._scene, out))

    def restore(self, saved: bytes) -> None:
        """Goes on where `save` was called, in a scene of the same file."""
        kept = data("saved", saved)
        check(library.windrow_scene_restore(self._scene, kept, len(kept)))
