#!/usr/bin/env python3
"""compute_queue_test.py PROGRAM: runs the example compute_queue under the validation layer and compares what it drew and read back.

The layer checks each call and, across the submissions, their synchronisation; its messages would be more lines than the two.
Needs the layer (Debian: vulkan-validationlayers) and a driver; without either it fails.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM = ""
LAYER_SETTINGS = """khronos_validation.enables = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT,\
VALIDATION_CHECK_ENABLE_SYNCHRONIZATION_VALIDATION_QUEUE_SUBMIT
khronos_validation.report_flags = error,warn,perf
khronos_validation.debug_action = VK_DBG_LAYER_ACTION_LOG_MSG
"""
VECTOR = r"\((-?[\d.]+), (-?[\d.]+), (-?[\d.]+)\) m/s"
LINES = re.compile(r".+ draws on queue family \d+ and blows on (family \d+, which computes|a second queue of it|"
                   r"the same queue: it has no other)\n"
                   rf"(\d+) frames in (\d+) submissions: wind {VECTOR} drawn, {VECTOR} read back\n")
AMBIENT = (3.0, 0.0, -2.0)
A_BYTE = 16.0 / 255.0  # [m/s] of a colour


class ComputeQueue(unittest.TestCase):
    def run_program(self, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "vk_layer_settings.txt").write_text(LAYER_SETTINGS)
            environment = {**os.environ, "VK_INSTANCE_LAYERS": "VK_LAYER_KHRONOS_validation", "VK_LAYER_SETTINGS_PATH": folder}
            return subprocess.run([PROGRAM, *map(str, arguments)], cwd=folder, env=environment, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, check=False)

    def test_one_queue_samples_what_the_other_computed(self):
        run = self.run_program(31)
        self.assertEqual(run.returncode, 0, run.stdout)
        print(run.stdout, end="")
        told = LINES.fullmatch(run.stdout)
        self.assertTrue(told, run.stdout)
        self.assertEqual(told.group(2, 3), ("31", "62"))
        drawn, read = [tuple(map(float, told.group(first, first + 1, first + 2))) for first in (4, 7)]
        for axis in range(3):
            self.assertAlmostEqual(drawn[axis], read[axis], delta=A_BYTE)
        # The vortex beside it has moved the air.
        self.assertGreater(max(abs(a - b) for a, b in zip(read, AMBIENT)), 0.5)

    def test_wrong_use_is_rejected(self):
        for arguments in (("0",), ("many",), ("3x",), ("3", "more")):
            with self.subTest(arguments):
                run = self.run_program(*arguments)
                self.assertEqual(run.returncode, 2)
                self.assertIn("usage: compute_queue", run.stdout)


if __name__ == "__main__":
    PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
