#!/usr/bin/env python3
"""python_axes_test.py: set_axes of the Python package, by the library of WINDROW_LIBRARY."""
import unittest

import numpy as np

import windrow


class Axes(unittest.TestCase):
    """Blender in centimetres, beside the library's own metres with y up."""

    def tearDown(self):
        windrow.set_axes()

    @staticmethod
    def story(place, length, cells):
        config = windrow.Config(cells=cells, boundaries=windrow.Boundaries.open_over_floor(), ambient=place(3, 0, 1))
        wind = windrow.Wind(config)
        wind.motors.add(windrow.JetMotor(position=place(-2, 2, 1), direction=place(1, 0.5, -0.25)))
        wind.obstacles.add(windrow.Obstacle(position=place(2, 1.5, 0), shape=windrow.Plate((length(2), length(1)))))
        wind.obstacles.add(windrow.Obstacle(position=place(1, 1, 2)))  # a block by default
        ground = windrow.HeightMap(np.full((3, 4), length(0.25)))
        # Its first corner: that of the rows along z, or along Blender's y, which goes the other way.
        corner = place(4, 0, 0) if length(1) == 1 else place(4, 0, 2)
        wind.obstacles.add(windrow.Obstacle(position=corner, shape=windrow.Ground(ground)))
        for _ in range(4):
            report = wind.step(1 / 16)
        return wind, report

    def test_a_host_in_centimetres_with_z_up_scales_nothing(self):
        plain, before = self.story(lambda x, y, z: (x, y, z), lambda metres: metres, (16, 8, 12))
        at_cells = plain.sample(plain.centres())
        windrow.set_axes("z_up_right", 0.01)
        self.assertEqual(windrow.WakeMotor().radius, 50.0)
        self.assertEqual(windrow.Block().half_size, (100.0, 100.0, 100.0))
        self.assertEqual(windrow.ShellSettings().down, (0.0, 0.0, -1.0))
        config = windrow.Config()
        self.assertEqual((config.cells, config.cell_size, config.blend_width), ((32, 32, 16), 100.0, 2.0))
        self.assertAlmostEqual(config.viscosity, 0.15, delta=1e-6)
        wind, report = self.story(lambda x, y, z: (100 * x, -100 * z, 100 * y), lambda metres: 100 * metres, (16, 12, 8))
        self.assertEqual(wind.box.cells, (16, 12, 8))
        self.assertAlmostEqual(report.max_speed, 100 * before.max_speed, delta=0.1)
        self.assertTrue(np.allclose(wind.field(), plain.field(), atol=2e-4))
        x, y, z = wind.velocity((150, -50, 125))
        windrow.set_axes()
        self.assertTrue(np.allclose((x / 100, z / 100, -y / 100), plain.velocity((1.5, 1.25, 0.5)), atol=2e-4))
        self.assertTrue(np.allclose(plain.sample(plain.centres()), at_cells))
        windrow.set_axes("z_up_right", 0.01)
        centres = wind.centres()
        self.assertEqual(centres.shape, (12, 8, 16, 3))
        self.assertTrue(np.allclose(wind.sample(centres) / 100 @ [[1, 0, 0], [0, 0, -1], [0, 1, 0]], at_cells, atol=2e-4))
        windrow.set_axes()
        self.assertEqual((windrow.WakeMotor().radius, windrow.Config(), windrow.Cone()),
                         (0.5, windrow.Config(cell_size=1.0, cells=(32, 16, 32)), windrow.Cone((6.0, 0.0, 0.0), 0.5, 2.0)))

    def test_words_and_units_are_checked(self):
        with self.assertRaisesRegex(windrow.WindrowError, "z_up_left"):
            windrow.set_axes("up", 1.0)
        with self.assertRaisesRegex(windrow.WindrowError, "give 1e-6 to 1e6"):
            windrow.set_axes("z_up_left", 0.0)
        windrow.set_axes("z_up_left", 2.0)
        self.assertTrue(np.array_equal(windrow.matrix() @ [1, 2, 3, 1], [2, 6, 4, 1]))


if __name__ == "__main__":
    unittest.main()
