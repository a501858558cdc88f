#!/usr/bin/env python3
"""draw_test.py PROGRAM SCENES [SCENE]: windrow-draw on the scenes with a picture below the folder SCENES.

With SCENE, a file, that one draws a small frame under the validation layer, which checks each call and the synchronisation between
them; whatever it says lands in the output, which must be the program's own lines. Without it, every scene keeps the schema, and the
program rejects bad input with exit code 2 and one sentence. Needs the layer (Debian: vulkan-validationlayers), a driver and jsonschema (python3-jsonschema); without one of them it fails.
"""
import json
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest

import jsonschema

PROGRAM = ""
SCENES = pathlib.Path()
SCENE = None
LAYER_SETTINGS = """khronos_validation.enables = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT
khronos_validation.report_flags = error,warn,perf
khronos_validation.debug_action = VK_DBG_LAYER_ACTION_LOG_MSG
"""
LINES = re.compile(r".+: 1 pictures of 64 x 36 px in [\d.]+ s, in .+\nmemory: .+\n"
                   r"(this device has no timestamps: no stage is timed\n|ms +mean .+\n(\w+ +[\d. ]+\n)+)")


def scenes_with_pictures():
    """Path and text of each."""
    for file in sorted(SCENES.rglob("*.json")):
        if file.name != "scene.schema.json":
            scene = json.loads(file.read_text(encoding="utf-8"))
            if "picture" in scene:
                yield file, scene


class UnderTheLayer(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "vk_layer_settings.txt").write_text(LAYER_SETTINGS)
        (self.folder / "small.json").write_text('{"duration": 1, "air": {"cells": [8, 8, 8]}, "picture": {"size": [64, 36], "warm_up": 0}}')

    def run_program(self, *arguments):
        environment = {**os.environ, "VK_INSTANCE_LAYERS": "VK_LAYER_KHRONOS_validation", "VK_LAYER_SETTINGS_PATH": str(self.folder)}
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)


class OneScene(UnderTheLayer):
    def test_it_draws_a_frame_without_a_word_from_the_layer(self):
        # Each step of the wind before the picture is recorded as the one before it.
        settle = () if os.environ.get("WINDROW_TIER") == "all" else ("--warm-up", 0.1)
        run = self.run_program(SCENE, "--frames", 1, "--size", "64x36", "--out", "drawn", *settle)
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertTrue(LINES.fullmatch(run.stdout), run.stdout)
        picture = (self.folder / "drawn" / "frame_0000.png").read_bytes()
        self.assertEqual(struct.unpack(">II", picture[16:24]), (64, 36))


class AllScenes(UnderTheLayer):
    def test_every_scene_keeps_the_schema(self):
        schema = json.loads((SCENES / "scene.schema.json").read_text(encoding="utf-8"))
        judge = jsonschema.validators.validator_for(schema)(schema)
        files = [file for file, scene in scenes_with_pictures() if not judge.validate(scene)]
        self.assertGreaterEqual({file.stem for file in files},
                                {"meadow", "tall", "short", "violet", "path", "yellow", "wind", "composition"})

    def test_several_scenes_make_a_sheet(self):
        (self.folder / "other.json").write_text((self.folder / "small.json").read_text())
        run = self.run_program("small.json", "other.json", "--frames", 1, "--out", "both", "--sheet", "sheet.png")
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertEqual(sorted(made.name for made in (self.folder / "both").iterdir()), ["other", "small"])
        # Two of 64 px with margins of 6.
        self.assertEqual(struct.unpack(">II", (self.folder / "sheet.png").read_bytes()[16:24]), (6 + 2 * (64 + 6), 6 + 36 + 6))

    def rejected(self, *arguments):
        """What it says: one line that begins with its name."""
        run = self.run_program(*arguments)
        self.assertEqual(run.returncode, 2, (arguments, run.stdout))
        self.assertRegex(run.stdout, r"\Awindrow-draw: [^\n]+\n\Z", arguments)
        return run.stdout

    def test_bad_flags_are_rejected(self):
        for flag, values in {"--frames": ("0", "-1", "1e9", "nan", "x"), "--from": ("-1", "nan", "inf", "x", "99"),
                             "--warm-up": ("-1", "nan", "x", "4000"), "--fps": ("0", "nan", "inf", "-5", "1e9"), "--samples": ("0", "2", "x"), "--show": ("zebra", "3"),
                             "--size": ("64", "0x0", "64x", "9999x9999", "-64x36", "64x36x2", "nanxnan")}.items():
            for value in values:
                with self.subTest((flag, value)):
                    self.assertIn(flag, self.rejected("small.json", "--frames=1", f"{flag}={value}"))
        self.assertIn("--zebra", self.rejected("small.json", "--zebra"))
        self.assertIn("scene", self.rejected())

    def test_missing_and_faulty_scenes_are_rejected(self):
        self.assertIn("none.json", self.rejected("none.json"))
        (self.folder / "cut.json").write_text('{"picture": ')
        self.assertIn("cut.json", self.rejected("cut.json"))
        (self.folder / "bad.json").write_text('{"picture": {"sun": {"haze": 7}}}')
        self.assertIn("$.picture.sun.haze is 7", self.rejected("bad.json"))

    def test_folders_that_cannot_be_made_are_told(self):
        (self.folder / "file").write_text("")
        self.assertIn("--out file/folder", self.rejected("small.json", "--frames", 1, "--out", "file/folder"))
        run = self.run_program("small.json", "--frames", 1, "--sheet", "file/sheet.png")
        self.assertEqual(run.returncode, 2)
        self.assertIn("file/sheet.png", run.stdout)


if __name__ == "__main__":
    PROGRAM, SCENES, *scene = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    SCENE = scene[0] if scene else None
    unittest.main(argv=[sys.argv[0], "OneScene" if SCENE else "AllScenes"])
