#!/usr/bin/env python3
"""embed_vulkan_test.py PROGRAM: runs the example embed_vulkan under the validation layer and looks at what it draws.

The layer checks each call and the synchronisation between them; whatever it says lands in the output, which must be one line.
Needs the layer (Debian: vulkan-validationlayers) and a driver; without either it fails.
"""
import math
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
LINE = re.compile(r".+: (\d+) frames, ([\d.]+) dispatches a frame, "
                  r"wind at the walker \((-?[\d.]+), (-?[\d.]+), (-?[\d.]+)\) m/s as of (\d+) ms ago, (.+)\n")
WIDTH, HEIGHT = 1280, 720
# Grass in the foreground, out of reach of walker and fan: columns and rows.
LEFT, TOP, RIGHT, BOTTOM = 400, 560, 1280, 720


class EmbedVulkan(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "vk_layer_settings.txt").write_text(LAYER_SETTINGS)

    def run_program(self, *arguments):
        environment = {**os.environ, "VK_INSTANCE_LAYERS": "VK_LAYER_KHRONOS_validation", "VK_LAYER_SETTINGS_PATH": str(self.folder)}
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)

    def picture(self, frames):
        """Draws so many frames; the last one's grass in the foreground."""
        name = f"{frames}.ppm"
        run = self.run_program(frames, name)
        self.assertEqual(run.returncode, 0, run.stdout)
        told = LINE.fullmatch(run.stdout)
        self.assertTrue(told, run.stdout)
        self.assertEqual(told.group(1), str(frames))
        self.assertGreater(float(told.group(2)), 0.0)
        # The mean wind at 0.8 m is 1.8 m/s, a gust 0.6 m/s more or less, and the wake pulls toward 4 m/s.
        self.assertTrue(0.5 < math.hypot(*map(float, told.group(3, 4, 5))) < 10.0, run.stdout)
        # Two frames of 1/60 s in flight, and ticks of 1/30 s.
        self.assertTrue(1000 / 30 - 1 <= int(told.group(6)) <= 1000 / 30 + 1000 / 30 + 1, run.stdout)
        self.assertEqual(told.group(7), name)

        header = f"P6\n{WIDTH} {HEIGHT}\n255\n".encode()
        content = (self.folder / name).read_bytes()
        self.assertEqual(content[:len(header)], header)
        pixels = content[len(header):]
        self.assertEqual(len(pixels), 3 * WIDTH * HEIGHT)
        rows = [pixels[3 * (row * WIDTH + LEFT):3 * (row * WIDTH + RIGHT)] for row in range(TOP, BOTTOM)]
        return b"".join(rows)

    def test_the_grass_moves_with_the_wind(self):
        early, late = self.picture(3), self.picture(12)
        # Nothing else moves there: neither the eye nor the sun. In still air both pictures would be the same to the bit.
        moved = sum(abs(a - b) > 8 for a, b in zip(early[1::3], late[1::3]))
        print(f"{moved / (len(early) / 3):.0%} of the pixels changed")
        self.assertGreater(moved, 0.05 * len(early) / 3)

    def test_wrong_use_is_rejected(self):
        for arguments in (("2",), ("many",), ("3x",), ("3", "picture.ppm", "more")):
            with self.subTest(arguments):
                run = self.run_program(*arguments)
                self.assertEqual(run.returncode, 2)
                self.assertIn("usage: embed_vulkan", run.stdout)

    def test_a_file_that_cannot_be_written_is_told(self):
        run = self.run_program(3, "no/such/folder/picture.ppm")
        self.assertEqual(run.returncode, 2)
        self.assertIn("no/such/folder/picture.ppm", run.stdout)


if __name__ == "__main__":
    PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
