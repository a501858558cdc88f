"""Blades of grass on the faces of a mesh: strips of quads that the bake bends."""

import bpy
import numpy as np
import windrow

from . import panel
from .air import to_blender, to_wind

ROWS = 4
MOST = 1_000_000


def scattered(mesh, density: float, seed: int) -> np.ndarray:
    """Points on the faces of a mesh, evenly by area, in its own axes."""
    mesh.calc_loop_triangles()
    corners = np.array([[mesh.vertices[v].co for v in triangle.vertices] for triangle in mesh.loop_triangles])
    if not len(corners):
        return np.empty((0, 3))
    areas = 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    random = np.random.default_rng(seed)
    count = int(round(areas.sum() * density))
    if not 1 <= count <= MOST:
        return np.empty((count if count < 1 else MOST + 1, 0))
    of = corners[random.choice(len(areas), count, p=areas / areas.sum())]
    u, v = random.random((2, count, 1))
    flip = u + v > 1.0
    u, v = np.where(flip, 1.0 - u, u), np.where(flip, 1.0 - v, v)
    return of[:, 0] + u * (of[:, 1] - of[:, 0]) + v * (of[:, 2] - of[:, 0])


class Meadow:
    """The blades of an object: their roots are kept in it as `windrow_roots`, in its own axes."""

    def __init__(self, thing) -> None:
        self.thing = thing
        if "windrow_roots" not in thing:
            raise windrow.WindrowError(f"{thing.name} has no blades: make them by Add blades on a mesh.")
        roots = np.array(thing["windrow_roots"], np.float64).reshape(-1, 3)
        if len(thing.data.vertices) != 2 * ROWS * len(roots):
            raise windrow.WindrowError(f"{thing.name} was edited: its {len(thing.data.vertices)} vertices are not those of {len(roots)} blades.")
        world = np.array(thing.matrix_world)
        self.roots = to_wind(roots @ world[:3, :3].T + world[:3, 3])
        self.keys = windrow.plant_keys(self.roots[:, [0, 2]])
        self.settings = windrow.BladeSettings(**panel.values_of(windrow.BladeSettings, thing.windrow.blades))
        self.blades = windrow.Blades(self.settings)
        self.springs = windrow.Springs(thing.windrow.plant, np.zeros((len(self.roots), 3)))
        self.heights = np.linspace(0.0, 1.0, ROWS)
        self.to_object = np.linalg.inv(world)

    def advance(self, wind: windrow.Wind, dt: float) -> None:
        half = 0.5 * self.settings.stalk.length if self.settings.stalk else 0.15
        acting = wind.sample(self.roots + (0.0, half, 0.0), windrow.Sampling())
        self.springs.advance(self.blades.loads(self.keys, acting)[:, :3], dt)

    def vertices(self) -> np.ndarray:
        """(n, 3) in the object's own axes: blade by blade, row by row, left then right."""
        positions, _ = self.blades.vertices(self.keys, self.roots, self.springs.place, self.heights)
        world = to_blender(positions[..., :3].reshape(-1, 3))
        return (world @ self.to_object[:3, :3].T + self.to_object[:3, 3]).astype(np.float32)


class WINDROW_OT_add_blades(bpy.types.Operator):
    """Makes blades of grass on the faces of this mesh"""

    bl_idname = "windrow.add_blades"
    bl_label = "Add blades"
    bl_options = {"REGISTER", "UNDO"}

    density: bpy.props.FloatProperty(name="Density", description="Blades a square metre", default=200.0, min=0.01, max=1e5)
    seed: bpy.props.IntProperty(name="Seed", default=1, min=0)

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.type == "MESH"

    def execute(self, context):
        ground = context.object
        mesh = ground.evaluated_get(context.evaluated_depsgraph_get()).to_mesh()
        mesh.transform(ground.matrix_world)
        roots = scattered(mesh, self.density, self.seed)
        ground.evaluated_get(context.evaluated_depsgraph_get()).to_mesh_clear()
        if not 1 <= len(roots) <= MOST:
            self.report({"ERROR"}, f"The mesh would have {'no' if len(roots) < 1 else 'too many'} blades: give a density that makes 1 to {MOST:,}.")
            return {"CANCELLED"}
        thing = bpy.data.objects.new(f"{ground.name} blades", bpy.data.meshes.new(f"{ground.name} blades"))
        context.collection.objects.link(thing)
        thing["windrow_roots"] = roots.reshape(-1).tolist()
        thing.windrow.role = "BLADES"
        count = len(roots)
        first = (np.arange(count)[:, None] * 2 * ROWS + np.arange(ROWS - 1)[None, :] * 2).reshape(-1)
        quads = np.stack([first, first + 1, first + 3, first + 2], axis=1)
        thing.data.from_pydata(np.zeros((2 * ROWS * count, 3)).tolist(), [], quads.tolist())
        thing.data.vertices.foreach_set("co", Meadow(thing).vertices().reshape(-1))
        thing.data.update()
        return {"FINISHED"}


def register() -> None:
    bpy.utils.register_class(WINDROW_OT_add_blades)


def unregister() -> None:
    bpy.utils.unregister_class(WINDROW_OT_add_blades)
