#!/usr/bin/env python3
"""draw_trees_test.py PROGRAM: runs the example draw_trees under the validation layer.

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
LINE = re.compile(r".+: (\d+) frames in trees, (\d+) vertices in the last one\n")


class DrawTrees(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "vk_layer_settings.txt").write_text(LAYER_SETTINGS)

    def run_program(self, *arguments):
        environment = {**os.environ, "VK_INSTANCE_LAYERS": "VK_LAYER_KHRONOS_validation", "VK_LAYER_SETTINGS_PATH": str(self.folder)}
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)

    def test_a_grove_of_all_kinds_is_drawn_without_a_word_from_the_layer(self):
        run = self.run_program("all", 8, 3)
        self.assertEqual(run.returncode, 0, run.stdout)
        told = LINE.fullmatch(run.stdout)
        self.assertTrue(told, run.stdout)
        self.assertEqual(told.group(1), "3")
        # 300 trees afar and four near ones.
        self.assertTrue(300 * 20 < int(told.group(2)) < 300 * 200 + 4 * 30000, told.group(2))
        frames = [(self.folder / "trees" / f"frame_{n:04}.ppm").read_bytes() for n in (1, 3)]
        self.assertNotEqual(*frames)  # they move

    def test_the_same_run_gives_the_same_picture(self):
        pictures = []
        for _ in range(2):
            self.assertEqual(self.run_program("bush", 8, 2).returncode, 0)
            pictures.append((self.folder / "trees" / "frame_0002.ppm").read_bytes())
        self.assertEqual(*pictures)

    def test_wrong_use_is_rejected(self):
        for arguments in (("oak", "fast"), ("oak", "-1"), ("oak", "nan"), ("oak", 3, 0), ("oak", 3, 1, "more")):
            with self.subTest(arguments):
                run = self.run_program(*arguments)
                self.assertEqual(run.returncode, 2)
                self.assertIn("usage: draw_trees", run.stdout)
        run = self.run_program("palm")
        self.assertEqual(run.returncode, 2)
        self.assertIn("give one of oak, birch, spruce, bush", run.stdout)

    def test_a_folder_that_cannot_be_made_is_told(self):
        (self.folder / "trees").write_text("")
        run = self.run_program("bush")
        self.assertEqual(run.returncode, 2)
        self.assertIn("trees/frame_0001.ppm cannot be written", run.stdout)


if __name__ == "__main__":
    PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
