#!/usr/bin/env python3
"""cpu_textures_test.py PROGRAM: runs the example cpu_textures under the validation layer; compares what the shader sampled.

The program prints how far the shader's samples are from the CPU's, and what rounding may make of it. The picture must show the fan's
jet and the wake of the house. Needs the layer (Debian: vulkan-validationlayers) and a driver; without
either it fails.
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
LINE = re.compile(r".+: the shader is within ([\d.]+) m/s of the CPU at 3600 places, where ([\d.]+) may be rounding; "
                  r"air up to ([\d.]+) m/s, (.+)\n")
WIDTH, HEIGHT = 1280, 720
HALF_WIDTH, HALF_HEIGHT = 20.0, 11.25  # [m] of the picture


class CpuTextures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "vk_layer_settings.txt").write_text(LAYER_SETTINGS)

    def run_program(self, *arguments):
        environment = {**os.environ, "VK_INSTANCE_LAYERS": "VK_LAYER_KHRONOS_validation", "VK_LAYER_SETTINGS_PATH": str(self.folder)}
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)

    def test_the_shader_samples_the_cells_of_the_cpu(self):
        run = self.run_program("air.ppm")
        self.assertEqual(run.returncode, 0, run.stdout)
        print(run.stdout, end="")
        told = LINE.fullmatch(run.stdout)
        self.assertTrue(told, run.stdout)
        apart, bound, fastest = map(float, told.group(1, 2, 3))
        # Half of a texel's 11 bits, and a texture unit that weighs with 8 bits or more: a fiftieth of the fastest air at most.
        self.assertLess(bound, 0.02 * fastest)
        self.assertLessEqual(apart, bound)
        if run.stdout.startswith("llvmpipe"):  # its weights are floats: halves alone are rounded, and places
            self.assertLessEqual(apart, fastest / 2048 + 1e-4)
        self.assertGreater(apart, 0.0)
        self.assertGreater(fastest, 7.0)  # beside the tower and in the fan's jet

        header = f"P6\n{WIDTH} {HEIGHT}\n255\n".encode()
        content = (self.folder / "air.ppm").read_bytes()
        self.assertEqual(content[:len(header)], header)
        self.assertEqual(len(content), len(header) + 3 * WIDTH * HEIGHT)

        def redness(x, z):
            """Mean of red around a place [m]: the colours of fast air have more of it."""
            column = round((x / HALF_WIDTH + 1) * WIDTH / 2)
            row = round((z / HALF_HEIGHT + 1) * HEIGHT / 2)
            reds = [content[len(header) + 3 * (r * WIDTH + c)] for r in range(row - 12, row + 12) for c in range(column - 12, column + 12)]
            return sum(reds) / len(reds)

        jet, behind_house, upwind = redness(-6.0, 5.5), redness(4.2, 1.5), redness(-17.0, 3.0)
        print(f"red: {jet:.0f} in the jet, {upwind:.0f} in free air, {behind_house:.0f} behind the house")
        self.assertGreater(jet, 1.25 * upwind)
        self.assertLess(behind_house, 0.8 * upwind)

    def test_wrong_use_is_rejected(self):
        for arguments in (("--help",), ("picture.ppm", "more")):
            with self.subTest(arguments):
                run = self.run_program(*arguments)
                self.assertEqual(run.returncode, 2)
                self.assertIn("usage: cpu_textures", run.stdout)

    def test_a_file_that_cannot_be_written_is_told(self):
        run = self.run_program("no/such/folder/air.ppm")
        self.assertEqual(run.returncode, 2)
        self.assertIn("no/such/folder/air.ppm", run.stdout)


if __name__ == "__main__":
    PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
