"""The bake: a frame at a time, into PC2 files that Blender's own Mesh Cache modifier plays, with the state to go on from.

Blades get their vertices. Points get an object NAME.wind whose vertices are the wind [m/s] at theirs, for geometry nodes to read by index.
"""

import hashlib
import json
import pathlib
import re
import struct

import bpy
import numpy as np
import windrow

from .air import Air, to_blender, to_wind
from .blades import Meadow

EVERY = 10  # frames between two states
HEAD = struct.Struct("<12siiffi")


class Cache:
    """A PC2 file: a head, then the points of each frame."""

    def __init__(self, file: pathlib.Path, points: int, start: int, frames: int) -> None:
        self.file, self.points = file, points
        self.head = HEAD.pack(b"POINTCACHE2\0", 1, points, float(start), 1.0, frames)

    def write(self, n: int, points: np.ndarray) -> None:
        with open(self.file, "r+b" if n else "wb") as file:
            if n == 0:
                file.write(self.head)
            file.seek(HEAD.size + 12 * self.points * n)
            file.write(np.ascontiguousarray(points, "<f4").tobytes())
            file.truncate()


def play(thing, file: pathlib.Path, start: int) -> None:
    """Lets Blender's own modifier play the file."""
    modifier = thing.modifiers.get("Wind") or thing.modifiers.new("Wind", "MESH_CACHE")
    modifier.cache_format = "PC2"
    modifier.filepath = bpy.path.relpath(str(file)) if bpy.data.filepath else str(file)  # a saved project can be moved
    modifier.frame_start = start
    modifier.forward_axis, modifier.up_axis = "POS_Y", "POS_Z"
    modifier.show_viewport = modifier.show_render = True


def stop_playing(thing) -> None:
    """While its file is written."""
    modifier = thing.modifiers.get("Wind")
    if modifier:
        modifier.show_viewport = modifier.show_render = False


class Volume:
    """The cells of each frame as OpenVDB files, z up, and an object that shows them."""

    def __init__(self, folder: pathlib.Path, first: int, frames: int) -> None:
        if not windrow.has_part("vdb"):
            raise windrow.WindrowError("VDB files need a library that was built with OpenVDB: clear VDB files, or set WINDROW_LIBRARY to one.")
        self.folder, self.first, self.frames = folder, first, frames

    def file(self, frame: int) -> pathlib.Path:
        return self.folder / f"wind_{frame:04d}.vdb"

    def write(self, wind: windrow.Wind, frame: int, time: float) -> None:
        wind.write_vdb(self.file(frame), up="z", half=True, time=time, frame=frame)

    def show(self) -> None:
        volume = bpy.data.volumes.get("Wind") or bpy.data.volumes.new("Wind")
        file = self.file(self.first)
        volume.filepath = bpy.path.relpath(str(file)) if bpy.data.filepath else str(file)
        volume.is_sequence = self.frames > 1
        volume.frame_start, volume.frame_duration, volume.frame_offset = self.first, self.frames, self.first - 1
        volume.velocity_unit = "SECOND"
        shown = bpy.data.objects.get("Wind") or bpy.data.objects.new("Wind", volume)
        if shown.name not in bpy.context.scene.objects:
            bpy.context.scene.collection.objects.link(shown)


class Points:
    """The wind at the vertices of an object."""

    def __init__(self, thing) -> None:
        self.thing = thing
        self.count = len(self._places())
        name = f"{thing.name}.wind"
        mesh = bpy.data.meshes.get(name) or bpy.data.meshes.new(name)
        if len(mesh.vertices) != self.count:
            mesh.clear_geometry()
            mesh.vertices.add(self.count)
        self.shown = bpy.data.objects.get(name) or bpy.data.objects.new(name, mesh)
        if self.shown.name not in bpy.context.scene.objects:
            bpy.context.scene.collection.objects.link(self.shown)
        self.shown.hide_viewport = self.shown.hide_render = True

    def _places(self) -> np.ndarray:
        evaluated = self.thing.evaluated_get(bpy.context.evaluated_depsgraph_get())
        places = np.empty(3 * len(evaluated.data.vertices), np.float32)
        evaluated.data.vertices.foreach_get("co", places)
        return places.reshape(-1, 3)

    def wind(self, wind: windrow.Wind) -> np.ndarray:
        places = self._places()
        if len(places) != self.count:
            raise windrow.WindrowError(f"{self.thing.name} has {len(places)} vertices and had {self.count}: their number must stay.")
        world = np.array(self.thing.matrix_world)
        return to_blender(wind.sample(to_wind(places @ world[:3, :3].T + world[:3, 3])))


def file_name(name: str) -> str:
    """Of an object's name, on every system."""
    return re.sub(r"[^\w. -]", "_", name)


class Bake:
    """Frames of a scene into its folder. `for n in bake.frames(): ...` bakes one a round; what was baked before is gone on from."""

    def __init__(self, scene, restart: bool = False) -> None:
        self.scene = scene
        self.folder = pathlib.Path(bpy.path.abspath(scene.windrow.folder))
        self.folder.mkdir(parents=True, exist_ok=True)
        self.first, self.last = scene.frame_start, scene.frame_end
        self.state_file = self.folder / "state.npz"
        self.targets = sorted((thing for thing in scene.objects if thing.windrow.role in ("BLADES", "POINTS") and thing.type == "MESH"),
                              key=lambda thing: thing.name)
        self.volume = Volume(self.folder, self.first, self.last - self.first + 1) if scene.windrow.vdb else None
        if not self.targets and self.volume is None:
            raise windrow.WindrowError("nothing is baked: give an object the role Blades or Points, or choose VDB files.")
        scene.frame_set(self.first)
        self._make(None)
        self.fingerprint = self._fingerprint()
        self.done = 0
        saved = None if restart else self._saved()
        if saved is not None:
            scene.frame_set(self.first + saved["done"] - 1)
            self._make(saved["air"])
            self.done = saved["done"]
            for meadow, (place, velocity, target) in zip(self.meadows, saved["springs"]):
                meadow.springs.place, meadow.springs.velocity, meadow.springs._target = place, velocity, target
        self.notes = self.air.notes

    def _make(self, saved) -> None:
        self.air = Air(self.scene, saved)
        if saved is None:  # where blades stand is of the first frame
            self.meadows = [Meadow(thing) for thing in self.targets if thing.windrow.role == "BLADES"]
            self.points = [Points(thing) for thing in self.targets if thing.windrow.role == "POINTS"]
            self.shown = [*(meadow.thing for meadow in self.meadows), *(points.shown for points in self.points)]
            counts = [*(len(meadow.thing.data.vertices) for meadow in self.meadows), *(points.count for points in self.points)]
            self.caches = [Cache(self.folder / f"{file_name(thing.name)}.pc2", count, self.first, self.last - self.first + 1)
                           for thing, count in zip(self.shown, counts)]
            if len({cache.file for cache in self.caches}) < len(self.caches):
                raise windrow.WindrowError("two targets have one file: give them names that differ in letters.")

    def _fingerprint(self) -> str:
        meadows = [(meadow.thing.name, meadow.settings, meadow.thing.windrow.plant, hashlib.sha256(meadow.roots.tobytes()).hexdigest())
                   for meadow in self.meadows]
        said = repr((windrow.__version__, self.air.parts(), self.first, self.last, meadows, [(cache.file.name, cache.points) for cache in self.caches],
                     self.volume is not None))
        return hashlib.sha256(said.encode()).hexdigest()

    def _saved(self):
        """The state of the same bake; None: there is none, or of other settings, or it cannot be read."""
        try:
            with np.load(self.state_file, allow_pickle=False) as kept:
                words = json.loads(kept["words"].tobytes())
                if words["fingerprint"] != self.fingerprint or not all(cache.file.exists() for cache in self.caches):
                    return None
                springs = [tuple(kept[f"springs_{n}"]) for n in range(len(self.meadows))]
                return {"done": words["done"], "springs": springs,
                        "air": {"wind": kept["wind"].tobytes(), "motors": words["motors"], "obstacles": words["obstacles"]}}
        except (OSError, ValueError, KeyError):
            return None

    def save(self) -> None:
        """What the next bake goes on from."""
        air = self.air.save()
        words = {"fingerprint": self.fingerprint, "done": self.done, "motors": air["motors"], "obstacles": air["obstacles"]}
        arrays = {f"springs_{n}": np.stack([meadow.springs.place, meadow.springs.velocity, meadow.springs._target])
                  for n, meadow in enumerate(self.meadows)}
        part = self.state_file.with_name("state.part.npz")
        np.savez(part, words=np.frombuffer(json.dumps(words).encode(), np.uint8), wind=np.frombuffer(air["wind"], np.uint8), **arrays)
        part.replace(self.state_file)

    def frames(self):
        """Bakes; yields how many frames are done."""
        count = self.last - self.first + 1
        for thing in self.shown:
            stop_playing(thing)
        if self.done == 0:
            for _ in range(self.scene.windrow.warm_up):
                self.air.step()
                for meadow in self.meadows:
                    meadow.advance(self.air.wind, self.air.dt)
        while self.done < count:
            self.scene.frame_set(self.first + self.done)
            self.air.step()
            written = []
            for meadow in self.meadows:
                meadow.advance(self.air.wind, self.air.dt)
                written.append(meadow.vertices())
            written += [points.wind(self.air.wind) for points in self.points]
            for cache, points in zip(self.caches, written):
                cache.write(self.done, points)
            if self.volume:
                self.volume.write(self.air.wind, self.first + self.done, self.done * self.air.dt)
            self.done += 1
            if self.done % EVERY == 0 or self.done == count:
                self.save()
            yield self.done

    def play(self) -> None:
        """What is baked so far."""
        for thing, cache in zip(self.shown, self.caches):
            if cache.file.exists():
                play(thing, cache.file, self.first)
        if self.volume and self.done:
            self.volume.show()


class WINDROW_OT_bake(bpy.types.Operator):
    """Bakes the wind of the scene's frames; Escape stops it, and the next bake goes on from there"""

    bl_idname = "windrow.bake"
    bl_label = "Bake wind"

    restart: bpy.props.BoolProperty(name="Restart", default=False, description="From the first frame, whatever was baked before")

    def _begin(self, context) -> bool:
        try:
            self._bake = Bake(context.scene, self.restart)
        except (windrow.WindrowError, OSError) as error:
            self.report({"ERROR"}, str(error))
            return False
        for note in self._bake.notes:
            self.report({"INFO"}, note)
        self._frames = self._bake.frames()
        return True

    def _next(self):
        """How many frames are done; None: all, or an error, which is reported."""
        try:
            return next(self._frames, None)
        except (windrow.WindrowError, OSError) as error:
            self.report({"ERROR"}, str(error))
            self._failed = True
        return None

    def execute(self, context):
        self._failed = False
        if not self._begin(context):
            return {"CANCELLED"}
        while self._next() is not None:
            pass
        self._bake.play()
        return {"CANCELLED"} if self._failed else {"FINISHED"}

    def invoke(self, context, event):
        self._failed = False
        if not self._begin(context):
            return {"CANCELLED"}
        manager = context.window_manager
        manager.progress_begin(0, self._bake.last - self._bake.first + 1)
        self._timer = manager.event_timer_add(0.0, window=context.window)
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type not in ("ESC", "TIMER"):
            return {"PASS_THROUGH"}
        done = None
        if event.type == "TIMER":
            done = self._next()
            if done is not None:
                context.window_manager.progress_update(done)
                return {"RUNNING_MODAL"}
        elif self._bake.done:
            self._bake.save()
        context.window_manager.event_timer_remove(self._timer)
        context.window_manager.progress_end()
        self._bake.play()
        return {"CANCELLED"} if self._failed or event.type == "ESC" else {"FINISHED"}


def register() -> None:
    bpy.utils.register_class(WINDROW_OT_bake)


def unregister() -> None:
    bpy.utils.unregister_class(WINDROW_OT_bake)
