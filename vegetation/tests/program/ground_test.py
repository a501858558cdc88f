#!/usr/bin/env python3
"""ground_test.py MAKE_GROUND: makes the meadow's ground from the survey and compares the two; then rejections.

Needs the survey (Debian: python-matplotlib-data); without it the test fails.
"""
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import zipfile

PROGRAM = ""
SURVEY = "/usr/share/matplotlib/mpl-data/sample_data/jacksboro_fault_dem.npz"
SCALE, SPACING = 15.0, 4.0  # as make_ground.py tells in its first lines
STEPS = (74.405, 92.6626)  # [m] between samples of the survey along x and z: 3 arc seconds at 36.5896 degrees north


def survey():
    data = zipfile.ZipFile(SURVEY).read("elevation.npy")
    (length,) = struct.unpack_from("<H", data, 8)
    return struct.unpack("<138632h", data[10 + length:])  # 344 rows of 403


class Ground(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_program(self, *arguments):
        return subprocess.run([sys.executable, "-B", PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)

    def test_the_ground_is_the_survey_scaled(self):
        file = self.folder / "ground.pgm"
        run = self.run_program(SURVEY, file)
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertIn('"extent": [1992, 2116], "low": 0, "high": 55.672', run.stdout)
        magic, size, most, body = file.read_bytes().split(b"\n", 3)
        columns, rows = map(int, size.split())
        self.assertEqual((magic, most, len(body)), (b"P5", b"65535", 2 * columns * rows))
        ground = struct.unpack(f">{columns * rows}H", body)
        heights, off = survey(), []
        for row in range(1, 342, 3):  # between the ground's samples: bilinear, where the survey has one
            for column in range(1, 401, 3):
                x, z = column * STEPS[0] / SCALE / SPACING, row * STEPS[1] / SCALE / SPACING
                if x >= columns - 1 or z >= rows - 1:
                    continue
                c, r = int(x), int(z)
                u, v = x - c, z - r
                near, far = (((1 - u) * ground[k * columns + c] + u * ground[k * columns + c + 1]) for k in (r, r + 1))
                height = ((1 - v) * near + v * far) * 55.672 / 65535
                off.append(height - heights[403 * row + column] / SCALE)
        middle = sum(off) / len(off)  # where its 0 lies
        # Between two of its samples a line misses a peak of the survey by less than the survey's own steepest step.
        steepest = max(abs(heights[n + 1] - heights[n]) for n in range(len(heights) - 1) if n % 403 < 402) / SCALE
        worst = max(abs(value - middle) for value in off)
        mean = (sum((value - middle) ** 2 for value in off) / len(off)) ** 0.5
        print(f"[figure] examples/ground/off_survey_m {worst:.3f} {steepest:.3f}")
        print(f"[figure] examples/ground/off_survey_mean_m {mean:.3f} 0.1")
        self.assertGreater(len(off), 10000)
        self.assertLess(worst, steepest)
        self.assertLess(mean, 0.1)  # read half a sample aside it is 0.44

    def test_what_is_no_survey_is_rejected(self):
        other = self.folder / "other.npz"
        target = self.folder / "ground.pgm"
        whole = pathlib.Path(SURVEY).read_bytes()
        for content, word in ((b"", "is no such survey"), (b"PK\x03\x04 and more", "is no such survey"), (whole[:5000], "is no such survey")):
            other.write_bytes(content)
            run = self.run_program(other, target)
            self.assertEqual(run.returncode, 2, run.stdout)
            self.assertIn(word, run.stdout)
        run = self.run_program(self.folder / "none.npz", target)
        self.assertEqual(run.returncode, 3, run.stdout)
        self.assertIn("does not exist", run.stdout)
        run = self.run_program(SURVEY, self.folder / "no" / "ground.pgm")
        self.assertEqual(run.returncode, 2, run.stdout)
        self.assertIn("cannot be written", run.stdout)
        self.assertEqual(self.run_program("-x").returncode, 2)
        self.assertFalse(target.exists() or any(self.folder.glob("*.part")), "nothing half written")


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
