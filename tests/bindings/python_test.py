#!/usr/bin/env python3
"""python_test.py: the Python package against the library of WINDROW_LIBRARY, used as its reader would. What it costs: python_costs_test.py."""
import copy
import csv
import ctypes
import gc
import math
import os
import pathlib
import pickle
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np

import windrow
from windrow import _c, _library


def over_floor(**changes):
    return windrow.Config(boundaries=windrow.Boundaries.open_over_floor(), ambient=(3, 0, 0), **changes)


def periodic(n, dimensions=2):
    cells = (n, n, 1) if dimensions == 2 else (n, n, n)
    return windrow.Config(cells=cells, cell_size=1 / n, boundaries=windrow.Boundaries.all("periodic"))


def sentence_of(test, call):
    with test.assertRaises(windrow.WindrowError) as caught:
        call()
    return str(caught.exception)


class Winds(unittest.TestCase):
    def test_views_are_the_winds_own_memory(self):
        wind = windrow.Wind(over_floor(cells=(8, 4, 6)))
        cells = ctypes.POINTER(_c.Vec4)()
        count = ctypes.c_uint64()
        field = wind.field()
        _library.check(_library.library.windrow_wind_field(wind._wind, 0, ctypes.byref(cells), ctypes.byref(count), None))
        self.assertEqual(field.ctypes.data, ctypes.addressof(cells.contents))
        self.assertEqual((field.shape, field.dtype, count.value), ((6, 4, 8, 4), np.float32, 6 * 4 * 8))
        self.assertFalse(field.flags.writeable)
        with self.assertRaises(ValueError):
            field[0, 0, 0, 0] = 1.0
        del wind
        gc.collect()
        self.assertEqual(field[0, 0, 0].tolist(), [3.0, 0.0, 0.0, 0.0])  # it holds the wind

    def test_views_outlast_what_the_wind_does(self):
        wind = windrow.Wind(over_floor(cells=(64, 32, 64)))
        views = []
        for _ in range(3):
            wind.advance(1 / 60)
            views += [wind.field(), wind.field("previous")]
            wind.step(1 / 60)  # ends the frames
            views.append(wind.field())
            np.zeros(4 * 64 * 32 * 64, np.float32)
            self.assertTrue(all(np.isfinite(view).all() for view in views))
        log = windrow.EventLog()
        wind.record_to(log)
        motors = wind.motors
        del wind, log
        gc.collect()
        for _ in range(100):
            motors.add(windrow.JetMotor())
        scene = windrow.Scene("played.json", text=SCENE)
        saved = scene.save()
        field = scene.wind.field()
        scene.restore(saved)
        gc.collect()
        self.assertTrue(np.isfinite(field).all())

    def test_copies_are_winds_of_their_own(self):
        wind = windrow.Wind(over_floor(cells=(8, 4, 6)))
        fan = wind.motors.add(windrow.JetMotor())
        wind.step(1 / 60)
        for other in (copy.copy(wind), copy.deepcopy(wind), pickle.loads(pickle.dumps(wind))):
            self.assertEqual(other.save(), wind.save())
            other.step(1 / 60)
            self.assertNotEqual(other.save(), wind.save())
            self.assertIn(fan, other.motors)
        self.assertEqual(pickle.loads(pickle.dumps(fan)), fan)
        self.assertEqual({fan: 1}[windrow.MotorId.from_numbers(fan.numbers)], 1)
        with self.assertRaises(TypeError):
            pickle.dumps(windrow.Blades())
        tile = windrow.GustTile()
        self.assertIs(copy.deepcopy(windrow.Gusts(tile=tile)).tile, tile)

    def test_warnings_are_pythons(self):
        wind = windrow.Wind(windrow.Config(cells=(4, 4, 4)))
        wind.set_field(np.full((4, 4, 4, 3), math.nan))
        with self.assertWarnsRegex(windrow.WindrowWarning, "not finite"):
            self.assertEqual(wind.step(1 / 60).repaired_cells, 64)

    def test_arrays_of_any_form(self):
        wind = windrow.Wind(over_floor(profile=windrow.LogProfile(), gusts=windrow.Gusts(intensity=0.3)))
        points = np.random.default_rng(5).uniform(-10, 10, (6, 3))
        expected = wind.sample(points)
        for form in (points.astype(">f8"), np.asfortranarray(points), points[::1].tolist(), np.repeat(points, 2, axis=0)[::2],
                     points.astype(object).astype(np.longdouble)):
            self.assertTrue(np.allclose(wind.sample(form), expected, atol=1e-6))
        self.assertTrue(np.allclose(wind.sample(points.astype(">f4")), expected, atol=1e-4))
        for size in (0.1, 0.3, 1.7):
            self.assertEqual(windrow.Wind(windrow.Config(cell_size=size)).centres().shape, (32, 16, 32, 3))

    def test_sampling_is_the_velocity_at_each_point(self):
        wind = windrow.Wind(over_floor(gusts=windrow.Gusts(intensity=0.3)))
        wind.motors.add(windrow.JetMotor())
        for _ in range(20):
            wind.advance(1 / 40)
        points = np.random.default_rng(1).uniform(-20, 20, (5, 7, 3))
        one_by_one = [wind.velocity(point) for point in points.reshape(-1, 3)]
        self.assertTrue(np.array_equal(wind.sample(points).reshape(-1, 3), np.array(one_by_one, np.float32)))
        room = np.empty(points.shape, np.float32)
        self.assertIs(wind.sample(points, out=room), room)
        felt = wind.sample(points, windrow.Sampling(strength=0.5))
        self.assertTrue(np.allclose(felt, 0.5 * room, atol=1e-5))
        self.assertTrue(np.array_equal(felt[0, 0], np.array(wind.felt(points[0, 0], windrow.Sampling(strength=0.5)), np.float32)))
        self.assertTrue(np.allclose(wind.sample(points.astype(np.float32)), room, atol=1e-3))
        self.assertEqual(wind.sample(np.empty((0, 3))).shape, (0, 3))
        self.assertEqual(sentence_of(self, lambda: wind.sample(np.zeros((2, 2)))), "positions have shape (2, 2): give (..., 3).")
        self.assertIn("give a writable, contiguous array (1, 3) of float32", sentence_of(self, lambda: wind.sample([[0, 0, 0]], out=room)))
        for odd in (math.nan, math.inf, 1e300):
            wind.velocity((odd, 0, 0))  # no crash; the library's own tests say what it gives
            wind.sample([[0, odd, 0]])

    def test_a_saved_wind_and_a_replayed_one_go_on_with_the_same_bits(self):
        log = windrow.EventLog()
        wind = windrow.Wind(over_floor(cells=(12, 8, 12), profile=windrow.LogProfile()))
        start = wind.save()
        wind.record_to(log)
        pool = windrow.ThreadPool(2)
        fan = wind.motors.add(windrow.DirectionalMotor(position=(2, 1, 0), region=windrow.Capsule((1, 0, 0), 1.5)))
        wind.obstacles.add(windrow.Obstacle(position=(-2, 0.5, 1)))
        for _ in range(10):
            wind.step(1 / 60)
        saved = wind.save()
        wind.motors.move(fan, (2.5, 1, 0))
        wind.step(1 / 60)
        again = windrow.Wind.load(start, pool=pool)
        windrow.EventLog(log.to_bytes()).replay(again)
        self.assertEqual(again.save(), wind.save())
        self.assertGreater(len(log), 11)
        loaded = windrow.Wind.load(saved)
        loaded.motors.move(fan, (2.5, 1, 0))
        loaded.step(1 / 60)
        self.assertTrue(np.array_equal(loaded.field(), wind.field()))
        self.assertIn("snapshot", sentence_of(self, lambda: windrow.Wind.load(b"no wind")))

    def test_motors_and_obstacles_by_name(self):
        wind = windrow.Wind(over_floor())
        kinds = {}
        for motor in (windrow.DirectionalMotor(region=windrow.Cone(), law=windrow.Force()), windrow.WakeMotor(law=windrow.WakeForce()),
                      windrow.JetMotor(), windrow.VortexMotor(), windrow.OmniMotor(), windrow.PressureMotor()):
            name = wind.motors.add(motor)
            kinds[name] = wind.motors.kind(name)
        self.assertEqual(list(kinds.values()), ["directional", "wake", "jet", "vortex", "omni", "pressure"])
        first = next(iter(kinds))
        wind.motors.set(first, windrow.OmniMotor(speed=2))
        self.assertEqual(wind.motors.kind(first), "omni")
        wind.motors.remove(first)
        self.assertNotIn(first, wind.motors)
        self.assertNotIn(3, wind.motors)
        self.assertEqual(len(wind.motors), 5)
        with self.assertRaises(windrow.WindrowError) as stale:
            wind.motors.move(first, (0, 0, 0))
        self.assertEqual(stale.exception.kind, "stale")

        tetrahedron = windrow.TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
        hills = windrow.HeightMap(np.fromfunction(lambda z, x: np.sin(x / 3), (9, 9)), 4.0, holes=np.eye(9))
        shapes = [windrow.Sphere(1.5), windrow.Capsule(), windrow.Block(), windrow.Cylinder(), windrow.Plate((3, 2)),
                  windrow.MeshShape(tetrahedron), windrow.VoxelShape(windrow.VoxelGrid(np.ones((2, 3, 4)))),
                  windrow.Ground(hills, beyond="nothing")]
        del hills
        names = [wind.obstacles.add(windrow.Obstacle(shape=shape, position=(4, 1, 0))) for shape in shapes]
        self.assertEqual(len(wind.obstacles), len(shapes))
        for name in names[1:]:
            self.assertIn(name, wind.obstacles)
            wind.obstacles.remove(name)
            self.assertNotIn(name, wind.obstacles)
        wind.obstacles.move(names[0], (4.2, 1, 0), orientation=(0, 0, 0, 1), spin=(0, 1, 0))
        for _ in range(30):
            wind.step(1 / 30)
        force = wind.obstacles.force_on(names[0])
        self.assertTrue(force.in_box)
        self.assertGreater(force.force[0], 1.0)
        inside = wind.inside_obstacles()
        self.assertTrue(inside.any() and np.all(np.linalg.norm(wind.centres()[inside] - (4.2, 1, 0), axis=-1) <= 1.5))
        self.assertGreater(np.ptp(wind.pressure()), 0.1)

    def test_plants_slow_the_air(self):
        wind = windrow.Wind(windrow.Config(cells=(16, 8, 16), ambient=(4, 0, 0)))
        bush = wind.drag.add(windrow.PlantDrag(position=(0, -2, 0), radius=2, height=4, area=12))
        wind.drag.set(wind.drag.add(windrow.BeltDrag()), windrow.PlantDrag())
        self.assertEqual((len(wind.drag.add_plants([windrow.PlantDrag()] * 3)), len(wind.drag), bush in wind.drag), (3, 5, True))
        wind.step(1 / 30)
        self.assertGreater(wind.drag.force_on(bush).force[0], 10.0)
        self.assertIn("give a base below", sentence_of(self, lambda: wind.drag.add(windrow.PlantDrag(base=5))))

    def test_meshes_and_maps_that_do_not_fit_are_sentences(self):
        for make, expected in ((lambda: windrow.TriangleMesh([[0, 0, 0]], [[0, 1, 2]]), "triangles name vertices 0 to 2: there are 1, from 0 on."),
                               (lambda: windrow.TriangleMesh([0, 0], [[0, 0, 0]]), "give (n, 3) and (m, 3)"),
                               (lambda: windrow.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]), "open"),
                               (lambda: windrow.TriangleMesh([[0, 0, 0]], [[-1, 0, 0]]), "triangles name vertices -1"),
                               (lambda: windrow.VoxelGrid([1, 2]), "give three axes"),
                               (lambda: windrow.HeightMap([1, 2]), "give two axes"),
                               (lambda: windrow.HeightMap([[0, 1], [2, math.nan]]), "nan"),
                               (lambda: windrow.HeightMap(np.zeros((2, 2)), holes=[1]), "holes have shape (1,)")):
            self.assertIn(expected, sentence_of(self, make))

    def test_python_runs_during_a_call(self):
        wind = windrow.Wind(windrow.Config(cells=(96, 48, 96), ambient=(3, 0, 0)))
        wind.motors.add(windrow.JetMotor())
        counted, begun = 0, threading.Event()
        def step():
            begun.set()
            wind.step(1 / 60)
        thread = threading.Thread(target=step)
        switch = sys.getswitchinterval()
        sys.setswitchinterval(10.0)  # a thread gives way where it waits, or in a call that lets others run
        try:
            thread.start()
            begun.wait()
            while thread.is_alive():
                counted += 1
                time.sleep(0)
        finally:
            sys.setswitchinterval(switch)
            thread.join()
        self.assertGreater(counted, 100)

    def test_a_field_is_set_and_read_as_it_is(self):
        wind = windrow.Wind(windrow.Config(cells=(5, 3, 4)))
        given = np.random.default_rng(2).normal(size=(4, 3, 5, 3)).astype(np.float32)
        wind.set_field(given)
        self.assertTrue(np.array_equal(wind.field()[..., :3], given))
        self.assertTrue(np.array_equal(wind.half_vectors()[..., :3], given.astype(np.float16)))
        x, y, z = wind.centres()[1, 2, 3]
        self.assertTrue(np.allclose(wind.velocity((x, y, z)), given[1, 2, 3], atol=1e-6))
        wind.reset()
        wind.ambient = (1, 0, 2)
        self.assertEqual(wind.ambient, (1.0, 0.0, 2.0))
        self.assertEqual(sentence_of(self, lambda: wind.set_field(np.zeros((5, 3, 4, 3)))),
                         "velocity has shape (5, 3, 4, 3): give (4, 3, 5, 3) or (4, 3, 5, 4), indexed [z, y, x, component].")

    def test_parts_are_there_or_an_error(self):
        self.assertTrue(windrow.has_part("coupling"))
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "wind.vdb"
            if windrow.has_part("vdb"):
                wind, options = windrow.Wind(windrow.Config(cells=(4, 5, 6))), ({}, {"up": "z"}, {"half": True}, {"name": "v"}, {"time": 1.5}, {"frame": 3})
                self.assertEqual(len({wind.write_vdb(file, **some) or file.read_bytes() for some in options}), 6)
                self.assertIn("up is 'x'", sentence_of(self, lambda: wind.write_vdb(file, up="x")))
            else:
                with self.assertRaises(windrow.WindrowError) as missing:
                    windrow.Wind().write_vdb(file)
                self.assertEqual(missing.exception.kind, "unsupported")
        self.assertIn("part is 'x'", sentence_of(self, lambda: windrow.has_part("x")))


SCENE = """{
    "duration": 1, "tick_hz": 60, "frames_per_second": 7,
    "air": {"cells": [12, 8, 12], "ambient": [2, 0, 0], "boundaries": {"y_low": "free_slip"}},
    "paths": {"way": {"points": [[0, -4, 1, 0], [1, 4, 1, 0]]}},
    "motors": [{"name": "fan", "kind": "directional", "from": 0.5}, {"name": "runner", "kind": "wake", "path": "way"}],
    "obstacles": [{"name": "house", "position": [1, 1, 2], "shape": {"block": {"half_size": [1, 1, 1]}}}]
}"""


class Scenes(unittest.TestCase):
    def test_a_scene_is_played(self):
        scene = windrow.Scene("played.json", text=SCENE)
        self.assertEqual((scene.time, scene.duration, scene.frames_per_second), (0.0, 1.0, 7.0))
        self.assertEqual((scene.motor_names, scene.obstacle_names), (["fan", "runner"], ["house"]))
        self.assertIsNone(scene.motor("fan"))
        self.assertIn("the scene has no motor 'fun'", sentence_of(self, lambda: scene.motor("fun")))
        while scene.time < 0.7:
            self.assertTrue(scene.step().stepped)
        self.assertEqual(scene.wind.motors.kind(scene.motor("fan")), "directional")
        self.assertGreater(scene.wind.obstacles.force_on(scene.obstacle("house")).force[0], 0.5)
        self.assertTrue(scene.wind.inside_obstacles().any())

        saved = scene.save()
        other = windrow.Scene("played.json", text=SCENE)
        other.restore(saved)
        for played in (scene, other):
            while played.time < 1.0:
                played.step()
        self.assertEqual(scene.save(), other.save())
        self.assertEqual(other.wind.motors.kind(other.motor("fan")), "directional")
        self.assertNotEqual(saved, scene.save())
        wind = other.wind
        del other
        gc.collect()
        self.assertEqual(len(wind.motors), 2)  # it holds the scene

    @unittest.skipUnless("WINDROW_COMMAND" in os.environ, "no command was built")
    def test_its_air_is_that_of_the_command(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "played.json"
            file.write_text(SCENE, encoding="utf-8")
            subprocess.run([os.environ["WINDROW_COMMAND"], "run", file, "--csv", "--out", folder], check=True, capture_output=True)
            with open(next(pathlib.Path(folder).glob("*.csv")), encoding="utf-8", newline="") as table:
                rows = list(csv.DictReader(table))
        self.assertGreater(len(rows), 50)
        scene = windrow.Scene("played.json", text=SCENE)
        for row in rows:
            report = scene.step()
            self.assertAlmostEqual(float(row["time_s"]), scene.time, places=9)
            self.assertAlmostEqual(float(row["energy_m5_s2"]) / report.energy, 1.0, places=8)
            self.assertAlmostEqual(float(row["max_speed_m_s"]) / report.max_speed, 1.0, places=5)

    def test_frames_in_ticks(self):
        scene = windrow.Scene("played.json", text=SCENE)
        ticks = sum(scene.advance(1 / 50).ticks for _ in range(50))
        self.assertAlmostEqual(scene.time, 1.0)
        self.assertEqual(ticks, 30)  # Config.ticks_hz is the wind's own

    def test_faults_are_sentences(self):
        for text, expected in (("{", "played.json"), (SCENE.replace('"fan"', '"fan", "fan": 1'), "$.motors[0].fan is not a known key"),
                               (SCENE.replace("[12, 8, 12]", "[0, 8, 12]"), "$.air.cells")):
            self.assertIn(expected, sentence_of(self, lambda: windrow.Scene("played.json", text=text)))
        self.assertIn("no/such.json", sentence_of(self, lambda: windrow.Scene("no/such.json")))
        scene = windrow.Scene("played.json", text=SCENE)
        self.assertTrue(sentence_of(self, lambda: scene.restore(b"nothing")))
        before = scene.save()
        self.assertIn("scene", sentence_of(self, lambda: scene.restore(windrow.Scene("few.json", text="{}").save())))
        self.assertEqual(scene.save(), before)


class Operators(unittest.TestCase):
    """The slopes of theory, as a reader would find them."""

    def _errors(self, error):
        found = [error(n) for n in (16, 32, 64)]
        return found, [math.log2(a / b) for a, b in zip(found, found[1:])]

    def test_what_the_projection_leaves_falls_by_the_square_of_the_cell(self):
        def left(n):
            work = windrow.Workspace(periodic(n))
            x = 2 * np.pi * (np.arange(n) + 0.5) / n
            velocity = np.zeros((1, n, n, 3))
            velocity[0, ..., 0] = np.sin(x)[None, :] * np.cos(x)[:, None]
            velocity[0, ..., 1] = np.sin(2 * x)[:, None]
            before = velocity.copy()
            free = work.project(velocity)
            self.assertTrue(np.array_equal(velocity, before))
            return np.abs(work.divergence(free)).max() / np.abs(work.divergence(velocity)).max()
        errors, slopes = self._errors(left)
        self.assertTrue(all(slope > 1.9 for slope in slopes), (errors, slopes))

    def test_advection_is_of_third_order_and_the_scalar_too(self):
        def error(n, scalar):
            work = windrow.Workspace(periodic(n))
            x = 2 * np.pi * (np.arange(n) + 0.5) / n
            wave = lambda shift: (np.sin(x - shift)[None, :] * np.cos(x + shift)[:, None])[None]
            wind = np.zeros((1, n, n, 4), np.float32)
            wind[..., 0], wind[..., 1] = 1.0, -1.0
            steps = 3 * n // 4
            field = wave(0.0)
            for _ in range(steps):
                if scalar:
                    field = work.advect_scalar(field, wind, 0.7 / n)
                else:
                    carried = np.zeros((1, n, n, 3))
                    carried[..., 0] = field
                    field = work.advect(carried, wind, 0.7 / n)[..., 0]
            return np.abs(field - wave(2 * np.pi * steps * 0.7 / n)).max()
        for scalar in (False, True):
            errors, slopes = self._errors(lambda n: error(n, scalar))
            self.assertTrue(all(slope > 2.7 for slope in slopes), (scalar, errors, slopes))

    def test_diffusion_takes_the_factor_of_its_method(self):
        n, dt = 32, 0.01
        work = windrow.Workspace(periodic(n))
        x = 2 * np.pi * (np.arange(n) + 0.5) / n
        velocity = np.zeros((1, n, n, 3))
        velocity[..., 1] = np.sin(3 * x)
        s = math.sin(3 * math.pi / n) ** 2
        for viscosity, method, factor in ((1e-8, "none", lambda r: 1.0), (0.005, "one_pass", lambda r: 1 - 4 * r * s),
                                          (0.5, "implicit", lambda r: 1 / (1 + 4 * r * s))):
            result, taken = work.diffuse_and_method(velocity, viscosity, dt)
            self.assertEqual(taken, method)
            self.assertTrue(np.allclose(result[..., 1], factor(viscosity * dt * n * n) * velocity[..., 1], atol=2e-6), method)

    def test_poisson_is_solved(self):
        def error(n):
            x = 2 * np.pi * (np.arange(n) + 0.5) / n
            rhs = np.broadcast_to(np.sin(x), (1, n, n))
            return np.abs(windrow.Workspace(periodic(n)).solve_poisson(rhs) + rhs / (2 * np.pi) ** 2).max()
        errors, slopes = self._errors(error)
        self.assertTrue(all(slope > 1.9 for slope in slopes), (errors, slopes))

    def test_sources_and_obstacles(self):
        work = windrow.Workspace(windrow.Config(cells=(16, 12, 16), ambient=(1, 0, 0)))
        wind = np.zeros((16, 12, 16, 3), np.float32)
        wind[..., 0] = 1.0
        expansion = np.zeros((16, 12, 16))
        expansion[8, 6, 4] = 2.0
        grown = work.divergence(work.project(wind, expansion))
        self.assertEqual(np.unravel_index(grown.argmax(), grown.shape), (8, 6, 4))
        work.set_obstacles([windrow.Obstacle(position=(8, 6, 8), shape=windrow.Block((2, 2, 2)))])
        around = work.project(wind)
        self.assertLess(np.abs(around[7:9, 5:7, 7:9]).max(), 1e-6)
        push = work.impulse_on(0)
        self.assertGreater(push[0], 10.0)
        self.assertLess(abs(push[1]) + abs(push[2]), 1e-3 * push[0])
        work.set_obstacles([windrow.Obstacle(position=(8, 6, 8), shape=windrow.Block((2, 2, 2)))], velocities=[(1, 0, 0)])
        self.assertTrue(np.allclose(work.project(wind)[7:9, 5:7, 7:9, 0], 1.0, atol=1e-5))
        work.set_obstacles([])
        self.assertIn("the workspace has 0", sentence_of(self, lambda: work.impulse_on(0)))
        self.assertIn("velocities has 1 entries: give 0", sentence_of(self, lambda: work.set_obstacles([], velocities=[(0, 0, 0)])))

    def test_obstacles_stay_where_boundaries_change(self):
        closed = windrow.Boundaries(x_low=windrow.Boundary(kind="free_slip"))  # arrays of another pitch
        work = windrow.Workspace(windrow.Config(cells=(16, 24, 24), boundaries=closed, ambient=(1, 0, 0)))
        body = [windrow.Obstacle(position=(8, 12, 12), shape=windrow.Sphere(3))]
        work.set_obstacles(body)
        work.set_boundaries(windrow.Boundaries())
        fresh = windrow.Workspace(windrow.Config(cells=(16, 24, 24), ambient=(1, 0, 0)))
        fresh.set_obstacles(body)
        wind = np.zeros((24, 24, 16, 3))
        wind[..., 0] = 1.0
        self.assertTrue(np.array_equal(work.project(wind), fresh.project(wind)))
        self.assertEqual(work.impulse_on(0), fresh.impulse_on(0))

    def test_fields_that_do_not_fit_are_sentences(self):
        work = windrow.Workspace(windrow.Config(cells=(4, 3, 2)))
        wind = np.zeros((2, 3, 4, 3))
        for call, expected in ((lambda: work.project(np.zeros((4, 3, 2, 3))), "velocity has shape (4, 3, 2, 3): give (2, 3, 4, 3)"),
                               (lambda: work.advect_scalar(wind, wind, 0.1), "carried has shape (2, 3, 4, 3): give (2, 3, 4)"),
                               (lambda: work.advect(wind, wind, -1.0), "dt is -1 s"),
                               (lambda: work.diffuse(wind, math.nan, 1.0), "viscosity is nan"),
                               (lambda: work.advect(wind, wind, 0.1, interpolation="spline"), "give 'linear', 'cubic' or 'cubic_32'"),
                               (lambda: work.set_ambient((math.nan, 0, 0)), "ambient is")):
            self.assertIn(expected, sentence_of(self, call))
        self.assertIn("transport.outside is nan", sentence_of(self, lambda: work.advect_scalar(wind[..., 0], wind, 0.1, outside=math.nan)))
        odd = np.full((2, 3, 4, 3), math.nan)  # no crash
        work.advect(wind, odd, 0.1)
        work.advect_scalar(wind[..., 0], 1e30 * np.ones_like(wind), 0.1)


class Plants(unittest.TestCase):
    def test_blades_bend_as_their_class(self):
        keys = windrow.plant_keys([[0, 0], [1, 0], [3, 7]])
        self.assertEqual(len({tuple(key) for key in keys}), 3)
        blades = windrow.Blades(windrow.BladeSettings(length_spread=0, stiffness_spread=0, rest_bend=0, rest_bend_spread=0))
        loads = blades.loads(keys, [[6, 0, 0]] * 3)
        self.assertTrue(np.allclose(np.linalg.norm(loads[:, :3], axis=-1), windrow.bend_angle(windrow.Drag(), 6.0), rtol=1e-4))
        positions, normals = blades.vertices(keys, [[0, 0, 0], [1, 0, 0], [3, 0, 7]], loads, heights=np.linspace(0, 1, 5))
        self.assertEqual((positions.shape, normals.shape), ((3, 5, 2, 4), (3, 5, 2, 4)))
        self.assertTrue(np.all(positions[:, -1, :, 0].mean(axis=1) > [0, 1, 3]))  # the tips lean with the wind
        self.assertEqual(windrow.drag_of("grass"), windrow.Drag())
        self.assertEqual(windrow.bend_angle(windrow.Drag(), 1e30), windrow.bend_angle(windrow.Drag(), 1e6))

        for wrong in (np.arange(6, dtype=np.uint32), np.zeros((3, 1), np.uint32), np.random.random((3, 2))):
            self.assertIn("give what plant_keys returns", sentence_of(self, lambda: blades.loads(wrong, np.ones((3, 3)))))

    def test_shells_bend(self):
        shells = windrow.Shells()
        place, normal = np.zeros((2, 3)), np.array([[0, 1, 0], [0, 0, 1]])
        loads = shells.loads(place, normal, [[10, 0, 0], [10, 0, 0]])
        tip = shells.bent(place, normal, 1.0, loads)
        self.assertTrue(np.all(tip[:, 0] > 0.005))
        self.assertEqual(shells.height(0), 0.0)

    def test_a_spring_swings_at_its_frequency(self):
        spring = windrow.Springs(windrow.SpringClass(frequency_hz=2.0, damping=0.0), np.ones(3))
        spring.advance(0.0, 1e-9)
        places = [spring.advance(0.0, 0.01)[0].item() for _ in range(100)]
        expected = [math.cos(2 * math.pi * 2.0 * 0.01 * (n + 1)) for n in range(100)]
        self.assertTrue(np.allclose(places, expected, atol=1e-6))
        target = np.arange(12.0).reshape(3, 4)
        ordered = windrow.Springs("grass", np.zeros((4, 3)).T)  # of Fortran's order
        ordered.advance(target, 60.0)
        ordered.advance(target, 60.0)
        self.assertTrue(np.allclose(ordered.place, target, atol=1e-6))
        kept, fresh, moved = (windrow.Springs("grass", np.zeros(2)) for _ in range(3))
        same = np.zeros(2)
        for n in range(5):
            same[:] = n
            kept.advance(same, 0.1)
            fresh.advance(np.full(2, float(n)), 0.1)
        self.assertTrue(np.array_equal(kept.place, fresh.place))
        moved.place = [3, 4]
        self.assertEqual(moved.place.tolist(), [3.0, 4.0])
        with self.assertRaises(windrow.WindrowError):
            moved.place = np.zeros(3)
        self.assertAlmostEqual(windrow.Springs("grass", 0.0).spring.damping, windrow.spring_of("grass").damping)


if __name__ == "__main__":
    unittest.main()
