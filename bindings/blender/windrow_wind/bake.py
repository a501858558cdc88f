"""The bake: a frame at a time, into PC2 files that Blender's own Mesh Cache modifier plays, with the state to go on from.

Blades get their vertices. Points get an object NAME.wind whose vertices are the wind [m/s] at theirs, for geometry nodes to read by index.
"""

import pathlib
import pickle
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
    modifier.filepath = str(file)
    modifier.frame_start = start
    modifier.forward_axis, modifier.up_axis = "POS_Y", "POS_Z"
    modifier.show_viewport = modifier.show_render = True


def stop_playing(thing) -> None:
    """While its file is written."""
    modifier = thing.modifiers.get("Wind")
    if modifier:
        modifier.show_viewport = modifier.show_render = False


class Points:
    """The wind at the vertices of an object."""

    def __init__(self, thing) -> None:
        self.thing = thing
        name = f"{thing.name}.wind"
        mesh = bpy.data.meshes.get(name) or bpy.data.meshes.new(name)
        count = len(thing.data.vertices)
        if len(mesh.vertices) != count:
            mesh.clear_geometry()
            mesh.vertices.add(count)
        self.shown = bpy.data.objects.get(name) or bpy.data.objects.new(name, mesh)
        if self.shown.name not in bpy.context.scene.objects:
            bpy.context.scene.collection.objects.link(self.shown)
        self.shown.hide_viewport = self.shown.hide_render = True

    def wind(self, wind: windrow.Wind) -> np.ndarray:
        evaluated = self.thing.evaluated_get(bpy.context.evaluated_depsgraph_get())
        places = np.empty(3 * len(evaluated.data.vertices), np.float32)
        evaluated.data.vertices.foreach_get("co", places)
        world = np.array(self.thing.matrix_world)
        return to_blender(wind.sample(to_wind(places.reshape(-1, 3) @ world[:3, :3].T + world[:3, 3])))


class Bake:
    """Frames of a scene into its folder. `for n in bake.frames(): ...` bakes one a round; what was baked before is gone on from."""

    def __init__(self, scene, restart: bool = False) -> None:
        self.scene = scene
        self.folder = pathlib.Path(bpy.path.abspath(scene.windrow.folder))
        self.folder.mkdir(parents=True, exist_ok=True)
        self.first, self.last = scene.frame_start, scene.frame_end
        self.done = 0
        self.state_file = self.folder / "state.windrow"
        targets = sorted((thing for thing in scene.objects if thing.windrow.role in ("BLADES", "POINTS") and thing.type == "MESH"),
                         key=lambda thing: thing.name)
        if not targets:
            raise windrow.WindrowError("nothing is baked: give an object the role Blades or Points.")
        scene.frame_set(self.first)
        saved = None if restart else self._saved()
        if saved is not None:
            scene.frame_set(self.first + saved["done"] - 1)
        self.air = Air(scene, saved and saved["air"])
        self.meadows = [Meadow(thing) for thing in targets if thing.windrow.role == "BLADES"]
        self.points = [Points(thing) for thing in targets if thing.windrow.role == "POINTS"]
        if saved is not None and saved["fingerprint"] == self.fingerprint():
            self.done = saved["done"]
            for meadow, (place, velocity, target) in zip(self.meadows, saved["springs"]):
                meadow.springs.place[:], meadow.springs.velocity[:], meadow.springs._target = place, velocity, target
        elif saved is not None:  # of other settings
            scene.frame_set(self.first)
            self.air = Air(scene)
        frames = self.last - self.first + 1
        self.caches = [Cache(self.folder / f"{thing.name}.pc2", count, self.first, frames) for thing, count in
                       [*((meadow.thing, len(meadow.thing.data.vertices)) for meadow in self.meadows),
                        *((points.shown, len(points.shown.data.vertices)) for points in self.points)]]
        self.notes = self.air.notes

    def _saved(self):
        try:
            return pickle.loads(self.state_file.read_bytes())
        except (OSError, pickle.UnpicklingError, EOFError, KeyError):
            return None

    def fingerprint(self) -> str:
        return f"{self.air.fingerprint()} {self.first} {self.last} {[(meadow.thing.name, len(meadow.roots)) for meadow in self.meadows]}"

    def _save(self) -> None:
        state = {"fingerprint": self.fingerprint(), "done": self.done, "air": self.air.save(),
                 "springs": [(meadow.springs.place.copy(), meadow.springs.velocity.copy(), meadow.springs._target) for meadow in self.meadows]}
        part = self.state_file.with_suffix(".part")
        part.write_bytes(pickle.dumps(state))
        part.replace(self.state_file)

    def frames(self):
        """Bakes; yields how many frames are done."""
        count = self.last - self.first + 1
        shown = [*(meadow.thing for meadow in self.meadows), *(points.shown for points in self.points)]
        for thing in shown:
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
            self.done += 1
            if self.done % EVERY == 0 or self.done == count:
                self._save()
            yield self.done
        for thing, cache in zip(shown, self.caches):
            play(thing, cache.file, self.first)


class WINDROW_OT_bake(bpy.types.Operator):
    """Bakes the wind of the scene's frames; Escape stops it, and the next bake goes on from there"""

    bl_idname = "windrow.bake"
    bl_label = "Bake wind"

    restart: bpy.props.BoolProperty(name="Restart", default=False, description="From the first frame, whatever was baked before")

    def _begin(self, context) -> bool:
        try:
            self._bake = Bake(context.scene, self.restart)
        except windrow.WindrowError as error:
            self.report({"ERROR"}, str(error))
            return False
        for note in self._bake.notes:
            self.report({"INFO"}, note)
        self._frames = self._bake.frames()
        return True

    def execute(self, context):
        if not self._begin(context):
            return {"CANCELLED"}
        try:
            for _ in self._frames:
                pass
        except windrow.WindrowError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}

    def invoke(self, context, event):
        if not self._begin(context):
            return {"CANCELLED"}
        manager = context.window_manager
        manager.progress_begin(0, self._bake.last - self._bake.first + 1)
        self._timer = manager.event_timer_add(0.0, window=context.window)
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC":
            return self._end(context, {"CANCELLED"})
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        try:
            done = next(self._frames, None)
        except windrow.WindrowError as error:
            self.report({"ERROR"}, str(error))
            return self._end(context, {"CANCELLED"})
        if done is None:
            return self._end(context, {"FINISHED"})
        context.window_manager.progress_update(done)
        return {"RUNNING_MODAL"}

    def _end(self, context, result):
        if result == {"CANCELLED"} and self._bake.done:
            self._bake._save()
        context.window_manager.event_timer_remove(self._timer)
        context.window_manager.progress_end()
        return result


def register() -> None:
    bpy.utils.register_class(WINDROW_OT_bake)


def unregister() -> None:
    bpy.utils.unregister_class(WINDROW_OT_bake)
