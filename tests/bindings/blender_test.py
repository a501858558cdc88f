#!/usr/bin/env python3
"""blender_test.py: the add-on in Blender without a window, by the library of WINDROW_LIBRARY; and its archive, installed in a Blender that
has nothing else of the project. Started by Python it starts Blender."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT / "bindings/python"), str(ROOT / "bindings/blender")]

INSTALLED = """
import bpy
bpy.ops.preferences.addon_enable(module="windrow_wind")
import windrow
assert "windrow_wind/lib" in windrow.__file__, windrow.__file__
bpy.ops.mesh.primitive_plane_add()
bpy.ops.windrow.add_blades(density=5)
bpy.context.scene.frame_end = 3
bpy.context.scene.windrow.folder = "cache"
assert bpy.ops.windrow.bake() == {"FINISHED"}
"""

try:
    import bpy
except ImportError:
    blender = shutil.which("blender")
    if blender is None:
        sys.exit("blender is not installed: install blender")
    # Blender's Python takes its modules from beside the first python3 of PATH: Debian's.
    environment = dict(os.environ, PATH=os.pathsep.join([str(pathlib.Path(blender).parent), os.environ["PATH"]]))
    done = subprocess.run([blender, "-b", "--factory-startup", "--python-exit-code", "1", "--python", __file__], capture_output=True,
                          text=True, check=False, env=environment)
    print(done.stdout[-6000:], done.stderr[-6000:])
    if done.returncode or "OK" not in done.stderr + done.stdout:
        sys.exit(1)
    with tempfile.TemporaryDirectory() as work:
        subprocess.run([sys.executable, "-B", ROOT / "tools/make_wheel.py", "--blender", "--out", work], check=True)
        addons = pathlib.Path(work) / "scripts/addons"
        shutil.unpack_archive(next(pathlib.Path(work).glob("windrow_addon-*.zip")), addons)
        environment = {name: value for name, value in environment.items() if not name.startswith(("WINDROW", "PYTHON"))}
        done = subprocess.run([blender, "-b", "--factory-startup", "--python-exit-code", "1", "--python-expr", INSTALLED], text=True,
                              capture_output=True, check=False, cwd=work, env=dict(environment, BLENDER_USER_SCRIPTS=f"{work}/scripts"))
        print(done.stdout[-2000:], done.stderr[-2000:])
        sys.exit(done.returncode or not (pathlib.Path(work) / "cache/Plane blades.pc2").exists())

import numpy as np
import windrow
import windrow_wind
from windrow_wind import air, bake, panel

windrow_wind.register()


def made(operator, name, role="NONE", **options):
    operator(**options)
    thing = bpy.context.object
    thing.name = name
    thing.windrow.role = role
    return thing


class InBlender(unittest.TestCase):
    def setUp(self):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.scene = bpy.context.scene
        self.wind = self.scene.windrow
        self.wind.folder = str(self.folder / "cache")
        self.wind.centre = (0, 0, 4)
        self.wind.config.cells = (16, 16, 8)
        self.wind.config.ambient = (3, 1, 0)
        self.scene.frame_start, self.scene.frame_end = 1, 24

    def meadow(self):
        """Two bodies, one of which moves, a jet, blades, points."""
        ground = made(bpy.ops.mesh.primitive_plane_add, "Ground", size=6)
        bpy.ops.windrow.add_blades(density=12)
        blades = self.scene.objects["Ground blades"]
        made(bpy.ops.mesh.primitive_monkey_add, "Suzanne", "OBSTACLE", location=(2, 0, 1))
        box = made(bpy.ops.mesh.primitive_cube_add, "Box", "OBSTACLE", location=(-3, 0, 1), size=1)
        box.keyframe_insert("location", frame=1)
        box.location = (-1, 2, 1)
        box.rotation_euler = (0, 0, 1)
        box.keyframe_insert("location", frame=24)
        jet = made(bpy.ops.object.empty_add, "Fan", "MOTOR", type="SINGLE_ARROW", location=(-4, 0, 0.6), rotation=(0, np.pi / 2, 0))
        jet.windrow.motor = "JET"
        points = made(bpy.ops.mesh.primitive_grid_add, "Leaves", "POINTS", size=4, location=(0, 0, 1), x_subdivisions=4, y_subdivisions=4)
        return ground, blades, points

    def files(self):
        return {file.name: file.read_bytes() for file in sorted(pathlib.Path(self.wind.folder).glob("*.pc2"))}

    def test_the_panel_has_the_tables(self):
        group = self.wind.config
        fresh = bpy.data.scenes.new("fresh")
        self.assertEqual(air.config_of(fresh).cells, windrow.Config().cells)
        for name, value in panel.values_of(windrow.Config, fresh.windrow.config).items():
            if name == "cells":  # z up
                continue
            self.assertEqual(tuple(value) if isinstance(value, (tuple, list)) else value, getattr(windrow.Config(), name), name)
        said = group.bl_rna.properties["cell_size"]
        self.assertIn("Edge of a cell", said.description)
        self.assertAlmostEqual(said.hard_max, 1e6)
        self.assertEqual([item.identifier for item in group.bl_rna.properties["scheme"].enum_items], ["second_order", "stable_fluids"])
        group.use_gusts = True
        group.gusts.intensity = 0.25
        self.assertAlmostEqual(air.config_of(self.scene).gusts.intensity, 0.25)
        self.assertEqual(air.config_of(self.scene).cells, (16, 8, 16))  # z up here, y up there
        self.assertTrue(np.allclose(air.config_of(self.scene).ambient, (3, 0, -1)))
        for kind in panel.MOTORS.values():
            self.assertIn(kind, panel.GROUPS)

    def test_bodies_stand_where_blender_has_them(self):
        self.wind.config.cell_size = 0.25
        self.wind.config.cells = (32, 32, 24)
        self.wind.centre = (0, 0, 3)
        cube = made(bpy.ops.mesh.primitive_cube_add, "Cube", "OBSTACLE", size=2, location=(1, 2, 1.5))
        cube.scale = (-0.5, 1.0, 0.75)  # mirrored
        cube.rotation_euler = (0, 0, 0.5)
        self.check_inside("Cube", lambda local: np.all(np.abs(local) <= 1.0, axis=-1), 0.0)
        cube.windrow.role = "NONE"
        monkey = made(bpy.ops.mesh.primitive_monkey_add, "Suzanne", "OBSTACLE", size=3, location=(-1, 0, 2), rotation=(0, 0.4, 1))
        graph = bpy.context.evaluated_depsgraph_get()
        corners = np.array([corner[:] for corner in monkey.bound_box])
        inside = self.check_inside("Suzanne", lambda local: np.all((local >= corners.min(0) - 0.15) & (local <= corners.max(0) + 0.15), -1), None)
        self.assertGreater(inside, 200)
        self.assertIn("Suzanne is open", air.Air(self.scene).notes[0])
        del graph

    def check_inside(self, name, holds, wrong):
        """The cells that the air has inside, by the object's own axes."""
        there = air.Air(self.scene)
        there.place()
        there.wind.step(1 / 60)
        inside = there.wind.inside_obstacles()
        centres = air.to_blender(there.wind.centres())
        world = np.linalg.inv(np.array(self.scene.objects[name].matrix_world))
        expected = holds(centres @ world[:3, :3].T + world[:3, 3])
        self.assertTrue(inside.any())
        if wrong is None:
            self.assertFalse((inside & ~expected).any())
        else:
            self.assertEqual(np.count_nonzero(inside != expected), wrong)
        return np.count_nonzero(inside)

    def test_sheets_and_cloths(self):
        sheet = made(bpy.ops.mesh.primitive_grid_add, "Sail", "OBSTACLE", size=3, location=(0, 0, 2), rotation=(0, np.pi / 2, 0),
                     x_subdivisions=6, y_subdivisions=6)
        sheet.shape_key_add(name="Basis")
        key = sheet.shape_key_add(name="bulge")
        for point in key.data:
            point.co.z += 0.6 * np.cos(point.co.x) * np.cos(point.co.y)
        key.value = 0.0
        key.keyframe_insert("value", frame=1)
        key.value = 1.0
        key.keyframe_insert("value", frame=20)
        self.wind.config.ambient = (5, 0, 0)
        there = air.Air(self.scene)
        self.assertIn("Sail is a sheet", there.notes[0])
        for frame in range(1, 13):
            self.scene.frame_set(frame)
            self.assertTrue(there.step().stepped)
        force = there.wind.obstacles.force_on(there.bodies[0].id)
        self.assertGreater(force.force[0], 10.0)

    def test_bakes_are_equal_and_go_on(self):
        _, blades, points = self.meadow()
        self.assertEqual(bpy.ops.windrow.bake(), {"FINISHED"})
        whole = self.files()
        self.assertEqual(sorted(whole), ["Ground blades.pc2", "Leaves.wind.pc2"])
        self.assertEqual(bpy.ops.windrow.bake(restart=True), {"FINISHED"})
        self.assertEqual(self.files(), whole)
        for stop, saves in ((13, True), (17, False)):  # Escape, and a process that ended
            shutil.rmtree(self.wind.folder)
            part = bake.Bake(self.scene)
            for done in part.frames():
                if done == stop:
                    break
            if saves:
                part.save()
            self.assertEqual(bpy.ops.windrow.bake(), {"FINISHED"})
            self.assertEqual(self.files(), whole, f"stopped after {stop}")
        state = (pathlib.Path(self.wind.folder) / "state.npz").read_bytes()
        for change in (lambda: setattr(self.wind.config, "ambient", (3, 0, 0)), lambda: setattr(self.scene.objects["Fan"].windrow.jet, "speed", 9.0),
                       lambda: setattr(blades.windrow.blades, "rest_bend", 1.0), lambda: setattr(blades.windrow, "plant", "reed"),
                       lambda: setattr(self.scene.objects["Suzanne"].data.vertices[0].co, "x", 5.0),
                       lambda: (pathlib.Path(self.wind.folder) / "state.npz").write_bytes(b"nothing")):
            before = self.files()
            change()
            self.assertEqual(bpy.ops.windrow.bake(), {"FINISHED"})
            if (pathlib.Path(self.wind.folder) / "state.npz").read_bytes() == state:
                self.fail("it was not baked anew")
        self.assertEqual(self.files(), before)
        self.assertNotEqual(self.files(), whole)
        made(bpy.ops.mesh.primitive_plane_add, "More: leaves", "POINTS", location=(0, 0, 2))
        self.assertEqual(bpy.ops.windrow.bake(), {"FINISHED"})
        self.assertIn("More_ leaves.wind.pc2", self.files())

        # The modifier plays it without the library.
        self.scene.frame_set(20)
        cache = np.frombuffer(self.files()["Ground blades.pc2"], "<f4", offset=bake.HEAD.size).reshape(24, -1, 3)
        shown = blades.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
        self.assertTrue(np.allclose([vertex.co[:] for vertex in shown.vertices], cache[19], atol=1e-5))
        self.assertGreater(np.abs(cache[19] - cache[0]).max(), 0.02)
        # The wind at the points is that of the same story in the library.
        self.scene.frame_set(1)
        there = air.Air(self.scene)
        for frame in range(1, 25):
            self.scene.frame_set(frame)
            there.step()
        local = np.array([vertex.co[:] for vertex in points.data.vertices])
        world = np.array(points.matrix_world)
        expected = air.to_blender(there.wind.sample(air.to_wind(local @ world[:3, :3].T + world[:3, 3])))
        wind = np.frombuffer(self.files()["Leaves.wind.pc2"], "<f4", offset=bake.HEAD.size).reshape(24, -1, 3)
        self.assertTrue(np.allclose(wind[23], expected, atol=1e-5))

    def test_vdb_files_are_the_cells_of_each_frame(self):
        self.scene.frame_end = 3
        self.wind.vdb = True
        if not windrow.has_part("vdb"):
            with self.assertRaisesRegex(windrow.WindrowError, "built with OpenVDB"):
                bake.Bake(self.scene)
            return
        self.assertEqual(bpy.ops.windrow.bake(), {"FINISHED"})
        files = sorted(file.name for file in pathlib.Path(self.wind.folder).glob("*.vdb"))
        self.assertEqual(files, ["wind_0001.vdb", "wind_0002.vdb", "wind_0003.vdb"])
        shown = bpy.data.objects["Wind"]
        self.scene.frame_set(3)
        volume = shown.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
        self.assertTrue(volume.grids.load(), volume.grids.error_message)
        self.assertEqual([(grid.name, grid.data_type) for grid in volume.grids], [("vel", "VECTOR_FLOAT")])
        self.assertEqual(volume.velocity_grid, "vel")
        low, high = (np.array([corner[:] for corner in shown.bound_box]).min(0), np.array([corner[:] for corner in shown.bound_box]).max(0))
        # The centres of the outermost cells.
        self.assertTrue(np.allclose(low, (-7.5, -7.5, 0.5), atol=1e-4) and np.allclose(high, (7.5, 7.5, 7.5), atol=1e-4), (low, high))

    def test_a_frame_is_drawn(self):
        self.meadow()
        self.assertEqual(bpy.ops.windrow.bake(), {"FINISHED"})
        bpy.ops.object.camera_add(location=(5, -5, 3), rotation=(1.1, 0, 0.8))
        self.scene.camera = bpy.context.object
        bpy.ops.object.light_add(type="SUN", location=(0, 0, 5))
        self.scene.world = bpy.data.worlds.new("sky")
        self.scene.render.engine = "CYCLES"
        self.scene.cycles.samples = 4
        self.scene.cycles.use_denoising = False
        self.scene.render.resolution_x, self.scene.render.resolution_y = 96, 54
        self.scene.render.filepath = str(self.folder / "frame.png")
        self.scene.frame_set(20)
        bpy.ops.render.render(write_still=True)
        picture = bpy.data.images.load(self.scene.render.filepath)
        pixels = np.array(picture.pixels[:]).reshape(54, 96, 4)[..., :3]
        self.assertGreater(pixels.std(), 0.03)

    def test_what_is_missing_is_a_sentence(self):
        with self.assertRaises(RuntimeError) as caught:
            bpy.ops.windrow.bake()
        self.assertIn("nothing is baked: give an object the role Blades or Points, or choose VDB files.", str(caught.exception))


if __name__ == "__main__":
    result = unittest.main(argv=[__file__], exit=False).result
    sys.exit(not result.wasSuccessful())
