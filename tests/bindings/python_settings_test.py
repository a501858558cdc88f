#!/usr/bin/env python3
"""python_settings_test.py: the settings of the Python package, which are made from the library's tables, and what cannot be one."""
import ctypes
import dataclasses
import math
import pathlib
import pickle
import unittest

import numpy as np

import windrow
from windrow import _library, settings

REPORTS = {"Advance", "Box", "Diagnostics", "ObstacleForce"}  # filled by the library


def sentence_of(test, call):
    with test.assertRaises(windrow.WindrowError) as caught:
        call()
    return str(caught.exception)


class Settings(unittest.TestCase):
    def test_each_default_is_the_librarys(self):
        compared = 0
        for name in settings.__all__:
            kind = getattr(settings, name)
            if not getattr(kind, "_init", "") or name in REPORTS:
                continue
            initial = kind._struct()
            _library.check(getattr(_library.library, kind._init)(ctypes.byref(initial), ctypes.sizeof(initial)))
            given = kind()._to_c([])
            for field, of in kind._struct._fields_:
                with self.subTest(f"{name}.{field}"):
                    if issubclass(of, ctypes.Structure):
                        self.assertEqual(numbers_of(getattr(given, field)), numbers_of(getattr(initial, field)))
                    elif not hasattr(of, "contents"):
                        self.assertEqual(getattr(given, field), getattr(initial, field))
                    compared += 1
        self.assertGreater(compared, 140)

    def test_a_changed_field_reaches_the_library(self):
        for change, expected in ((dict(cell_size=-2.0), "cell_size is -2 m: give 1e-6 to 1e6 m."),
                                 (dict(gusts=windrow.Gusts(intensity=7)), "gusts.intensity is 7: give 0 (none) to 1."),
                                 (dict(boundaries=windrow.Boundaries(x_low=windrow.Boundary(kind="periodic"))), "boundaries.x_high is not periodic"),
                                 (dict(rows=windrow.Rows(heights=[1.0, 0.5])), "rows.heights"),
                                 (dict(relaxation_time=-2.0), "relaxation_time"), (dict(follow_axes="y"), None)):
            with self.subTest(change):
                if expected is None:
                    windrow.Wind(windrow.Config(**change))
                else:
                    self.assertIn(expected, sentence_of(self, lambda: windrow.Wind(windrow.Config(**change))))

    def test_what_a_field_cannot_be_is_one_sentence(self):
        for change, expected in ((dict(scheme="euler"), "Config.scheme is 'euler': give 'second_order' or 'stable_fluids'."),
                                 (dict(cells=(1, 2)), "Config.cells is (1, 2): give 3 whole numbers."),
                                 (dict(cells=7), "Config.cells is 7: give 3 whole numbers."),
                                 (dict(cells=(1.5, 2, 3)), "Config.cells is (1.5, 2, 3): give 3 whole numbers."),
                                 (dict(cell_size="1"), "Config.cell_size is '1': give a number."),
                                 (dict(max_substeps=1.5), "Config.max_substeps is 1.5: give a whole number."),
                                 (dict(follow_axes="xw"), "Config.follow_axes is 'w': give 'x', 'y' or 'z'."),
                                 (dict(profile=windrow.Gusts()), "Config.profile is Gusts(intensity=0.0, length=24.0, seed=1, tile=None): give a LogProfile, or None."),
                                 (dict(rows=3), "Config.rows is 3: give a Rows, or None.")):
            with self.subTest(change):
                self.assertEqual(sentence_of(self, lambda: windrow.Wind(windrow.Config(**change))), expected)
        wind = windrow.Wind()
        for motor, expected in ((windrow.DirectionalMotor(region=windrow.Block()), "DirectionalMotor.region is a Block, which is no Region."),
                                (windrow.WakeMotor(law=windrow.Drive()), "WakeMotor.law is a Drive, which is no WakeLaw."),
                                (windrow.JetMotor(envelope=3), "JetMotor.envelope is 3: give an Envelope.")):
            self.assertEqual(sentence_of(self, lambda: wind.motors.add(motor)), expected)
        tile, map_ = windrow.GustTile(), windrow.HeightMap(np.ones((3, 3)))
        for call, expected in (
                (lambda: windrow.Wind(windrow.Config(gusts=windrow.Gusts(tile=5))), "Gusts.tile is 5: give a GustTile, or None."),
                (lambda: windrow.Wind(windrow.Config(gusts=windrow.Gusts(tile=map_))), "give a GustTile, or None."),
                (lambda: wind.obstacles.add(windrow.Obstacle(shape=windrow.MeshShape(map_))), "give a TriangleMesh."),
                (lambda: wind.obstacles.add(windrow.Obstacle(shape=windrow.Ground(tile))), "give a HeightMap."),
                (lambda: wind.obstacles.add(windrow.Obstacle(shape=windrow.VoxelShape(None))), "give a VoxelGrid."),
                (lambda: wind.obstacles.add(windrow.Block()), "obstacle is Block(half_size=(1.0, 1.0, 1.0)): give an Obstacle."),
                (lambda: wind.obstacles.add(windrow.Obstacle(shape=3)), "Obstacle.shape is 3: give a shape, such as Block()."),
                (lambda: wind.obstacles.add(windrow.Obstacle(shape=windrow.Sphere("a"))), "Obstacle.shape is Sphere(radius='a'): give numbers."),
                (lambda: wind.motors.move(wind.obstacles.add(windrow.Obstacle()), (0, 0, 0)), "give a MotorId."),
                (lambda: wind.record_to(wind), "give an EventLog, or"), (lambda: windrow.Wind(3), "config is 3: give a Config."),
                (lambda: windrow.Wind(pool=3), "pool is 3: give a ThreadPool."), (lambda: wind.step(None), "dt is None: give a number."),
                (lambda: wind.step("1"), "dt is '1': give a number."), (lambda: wind.step(1e39), "dt is 1e+39 s"),
                (lambda: windrow.Wind.load(7), "saved is an int: give bytes."), (lambda: wind.velocity((1, 2)), "position is (1, 2): give 3 numbers."),
                (lambda: wind.velocity({}), "give 3 numbers."), (lambda: wind.felt((0, 0, 0), windrow.Sampling(strength=-1)), "strength is -1"),
                (lambda: wind.sample([[0, 0, 0]], windrow.Sampling(limit=math.nan)), "limit is nan"),
                (lambda: windrow.Wind(windrow.Config(cells=(2**32 + 8, 8, 8))), "give 3 whole numbers."),
                (lambda: windrow.Wind(windrow.Config(gusts=windrow.Gusts(seed=-1))), "Gusts.seed is -1: give 0 to 4294967295."),
                (lambda: windrow.Wind(windrow.Config(relaxation_time=-1.0)), "Config.relaxation_time is -1.0: give 0 or more, or None."),
                (lambda: windrow.Wind(windrow.Config(max_substeps=2**40)), "Config.max_substeps is 1099511627776"),
                (lambda: windrow.GustTile(1.5), "seed is 1.5: give a whole number."), (lambda: wind.write_field("a\0b.npz"), "character of number 0"),
                (lambda: wind.write_field("a.npz", time=math.nan), "time is nan s"), (lambda: wind.sample([[0, 0], [1]]), "positions is no array"),
                (lambda: wind.sample("abc"), "give numbers"), (lambda: windrow.Shells().height(32), "shell is 32: give 0 to 31.")):
            with self.subTest(expected):
                self.assertIn(expected.removesuffix(", or"), sentence_of(self, call))
        with self.assertRaises(AttributeError):
            windrow.Config().ambiant = (3, 0, 0)
        self.assertIn("give a DirectionalMotor", sentence_of(self, lambda: wind.motors.add(3)))
        self.assertEqual(sentence_of(self, lambda: wind.obstacles.add(windrow.Obstacle(shape=windrow.Cone()))),
                         "Obstacle.shape is a Cone, which is no Shape.")

    def test_each_setting_says_what_it_is(self):
        text = pathlib.Path(settings.__file__).read_text(encoding="utf-8")
        for name in settings.__all__:
            kind = getattr(settings, name)
            if dataclasses.is_dataclass(kind):
                said = kind.describe()
                self.assertNotRegex(said, r"Made by|::|windrow_|\.h\b|\bnull\b", name)
                self.assertGreater(len(said.splitlines()), len(dataclasses.fields(kind)))
                self.assertTrue(kind.__doc__ and not kind.__doc__.startswith(f"{name}("), name)
                body = text.partition(f"class {name}(")[2].partition("\n\n\n")[0]
                for field in dataclasses.fields(kind):
                    self.assertRegex(body, rf'    {field.name}: [^\n]*\n    """', f"{name}.{field.name}")

    def test_a_wind_inside_another(self):
        floor = windrow.Boundaries.open_over_floor()
        around = windrow.Wind(windrow.Config(cells=(16, 6, 16), cell_size=2, boundaries=floor, ambient=(4, 0, 1)))
        around.motors.add(windrow.DirectionalMotor(position=(-9, 3, 0), region=windrow.Sphere(4)))
        inside = windrow.Config(cells=(12, 6, 12), boundaries=floor)
        wind, alone = windrow.Wind(inside, outer=around), windrow.Wind(windrow.Config(cells=(12, 6, 12), boundaries=floor, ambient=(4, 0, 1)))
        for _ in range(20):
            for one in (around, wind, alone):
                one.advance(1 / 30)
        self.assertEqual(wind.ambient, (4, 0, 1))
        self.assertGreater(np.abs(wind.field() - alone.field()).max(), 0.5)
        self.assertEqual(wind.velocity((-9, 3, 0)), around.velocity((-9, 3, 0)))
        again = pickle.loads(pickle.dumps(wind))  # with the wind around it
        loaded = windrow.Wind.load(wind.save(), outer=windrow.Wind.load(around.save()))
        del around
        self.assertTrue(np.array_equal(again.field(), wind.field()) and np.array_equal(loaded.field(), wind.field()))
        self.assertIn("saved with an outer wind", sentence_of(self, lambda: windrow.Wind.load(wind.save())))
        self.assertIn("outer", sentence_of(self, lambda: windrow.Wind(inside, outer="wind")))
        self.assertIn("levels", sentence_of(self, lambda: windrow.Wind(windrow.Config(ambient=(1, 0, 0)), outer=wind)))

    def test_the_winds_around_that_of_a_scene(self):
        scene = windrow.Scene("nested.json", text='''{"duration": 1,
            "air": {"cells": [10, 6, 10], "ambient": [3, 0, 0], "outer": {"cells": [12, 5, 12], "cell_size": 3}},
            "motors": [{"kind": "omni", "position": [-9, 0, 0], "radius": 4}]}''')
        self.assertEqual([one.box.cell_size for one in scene.outer], [3])
        for _ in range(8):
            scene.step()
        self.assertEqual(scene.wind.velocity((-9, 1, 2)), scene.outer[0].velocity((-9, 1, 2)))
        self.assertGreater(np.abs(scene.outer[0].field()[..., 0] - 3).max(), 0.5)  # the motor is in it
        again = pickle.loads(pickle.dumps(scene.wind))  # with the wind around it
        self.assertTrue(np.array_equal(again.field(), scene.wind.field()))
        self.assertEqual(windrow.Scene("alone.json", text="{}").outer, ())


def numbers_of(struct):
    """What a struct holds, without its pointers."""
    found = []
    for name, kind in struct._fields_:
        value = getattr(struct, name)
        found.append(numbers_of(value) if isinstance(value, ctypes.Structure) else value if isinstance(value, (int, float)) else None)
    return found


if __name__ == "__main__":
    unittest.main()
