#!/usr/bin/env python3
"""draw_grass_test.py PROGRAM: runs the example draw_grass under the validation layer and looks at what it draws.

The layer checks each call and the synchronisation between them; whatever it says lands in the output, which must be the program's own
lines. Needs the layer (Debian: vulkan-validationlayers) and a driver; without either it fails.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM = ""
LAYER_SETTINGS = """khronos_validation.enables = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT
khronos_validation.report_flags = error,warn,perf
khronos_validation.debug_action = VK_DBG_LAYER_ACTION_LOG_MSG
"""
LINES = re.compile(r".+: (\d+) frames of 640 x 360 px, [1-9]\d* chunks of grass, [\d.]+ MiB beside the wind's [\d.]+ MiB, in (.+)\n"
                   r"((?:\w+ +\d+ us\n)*)")
STAGES = ["wind", "prepare", "shadow", "colour", "tone", "copy"]
WIDTH, HEIGHT = 640, 360


def pixels_of(ppm):
    """Rows of an 8-bit RGB picture."""
    magic, size, most, body = ppm.split(b"\n", 3)
    assert (magic, size, most, len(body)) == (b"P6", b"640 360", b"255", 3 * WIDTH * HEIGHT)
    return [body[row:row + 3 * WIDTH] for row in range(0, len(body), 3 * WIDTH)]


def mean(rows):
    """Mean red, green and blue."""
    whole = b"".join(rows)
    return [sum(whole[channel::3]) / (len(whole) / 3) for channel in range(3)]


class DrawGrass(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "vk_layer_settings.txt").write_text(LAYER_SETTINGS)

    def run_program(self, *arguments):
        environment = {**os.environ, "VK_INSTANCE_LAYERS": "VK_LAYER_KHRONOS_validation", "VK_LAYER_SETTINGS_PATH": str(self.folder)}
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)

    def test_sky_and_grass_and_wind_that_moves_it(self):
        run = self.run_program(4, "drawn")
        self.assertEqual(run.returncode, 0, run.stdout)
        told = LINES.fullmatch(run.stdout)
        self.assertTrue(told, run.stdout)
        self.assertEqual(told.group(1, 2), ("4", "drawn"))
        if told.group(3):  # a queue may count no time
            self.assertEqual([line.split()[0] for line in told.group(3).splitlines()], STAGES)
        drawn = sorted(file.name for file in (self.folder / "drawn").iterdir())
        self.assertEqual(drawn, [f"frame_{n:04}.ppm" for n in range(1, 5)])

        early, late = (pixels_of((self.folder / "drawn" / f"frame_{n:04}.ppm").read_bytes()) for n in (1, 4))
        red, _, blue = mean([row[3 * WIDTH // 2:] for row in late[:60]])
        self.assertGreater(blue, 1.1 * red, "the sky away from the sun is blue")
        red, green, blue = mean(late[200:])
        print(f"grass ({red:.0f}, {green:.0f}, {blue:.0f})")
        self.assertTrue(green > red > blue and 20 < green < 200, "the ground is green, neither black nor white")
        # The sky has no wind; the camera steps aside by 25 mm, which moves the far hills by less than a pixel.
        moved = sum(abs(a - b) > 8 for old, new in zip(early[200:], late[200:]) for a, b in zip(old[1::3], new[1::3]))
        self.assertGreater(moved, 0.05 * 160 * WIDTH)
        still = sum(abs(a - b) > 8 for old, new in zip(early[:90], late[:90]) for a, b in zip(old, new))
        self.assertEqual(still, 0)

    def test_the_same_run_gives_the_same_picture(self):
        for name in ("one", "other"):
            self.assertEqual(self.run_program(2, name).returncode, 0)
        one, other = ((self.folder / name / "frame_0002.ppm").read_bytes() for name in ("one", "other"))
        self.assertEqual(pixels_of(one), pixels_of(other))

    def test_wrong_use_is_rejected(self):
        for arguments in (("0",), ("many",), ("3x",), ("3", "folder", "more")):
            with self.subTest(arguments):
                run = self.run_program(*arguments)
                self.assertEqual(run.returncode, 2)
                self.assertIn("usage: draw_grass", run.stdout)

    def test_a_folder_that_cannot_be_made_is_told(self):
        (self.folder / "file").write_text("")
        run = self.run_program(1, "file/folder")
        self.assertEqual(run.returncode, 2)
        self.assertIn("file/folder", run.stdout)


if __name__ == "__main__":
    PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
