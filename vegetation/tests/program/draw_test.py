#!/usr/bin/env python3
"""draw_test.py PROGRAM SCENES REFERENCES LEFT [SCENE]: windrow-draw on the scenes with a picture below the folder SCENES.

With SCENE, a file, that one draws a frame of 128 x 72 px under the validation layer, which checks each call and the synchronisation
between them; whatever it says lands in the output, which must be the program's own lines. The picture is held to the one below
REFERENCES that was looked at and accepted; what was drawn, and the difference where it is another, are below the folder LEFT.

    WINDROW_ACCEPT_IMAGES=1 ctest --test-dir build/release -R '^program\\.draw\\.'        accepts all pictures again
    WINDROW_ACCEPT_IMAGES=1 ctest --test-dir build/release -R '^program\\.draw\\.wheat$'   accepts one

Without SCENE, every scene keeps the schema and has its reference, and the program rejects bad input with exit code 2 and one
sentence. Needs the layer (Debian: vulkan-validationlayers), a driver and jsonschema (python3-jsonschema); without one of them it fails.
"""
import json
import math
import os
import pathlib
import re
import resource
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

import jsonschema
import small_png

PROGRAM = ""
SCENES = REFERENCES = LEFT = pathlib.Path()
SCENE = None
SIZE = (128, 72)
# [s] A moment at which fans blow, walkers have moved and coats have come along. All pictures together have 90 s of two cores, and a
# software device takes many of them for what plants prepare in each frame before the picture.
MOMENT = 0.5
# Who walks or runs there comes later, as does what is blown.
MOMENTS = {"wolf": 1.3, "downwash": 1.3, "looks/tall": 1.0, "looks/path": 1.0, "wake": 1.0}
LONGEST_FRAME = 0.7  # [s]
# As in golden_test.cpp, on one device: the software one. One machine draws the same bytes each time, with 1 or 2 threads.
# Instructions of a processor without AVX are a mean of 3.6e-4 (looks/wind); other compilers round otherwise as well, hence fifty
# times that. A sun turned by 3 degrees is 0.98 (looks/low) to 1.9 (looks/wind), a wind turned by 10 degrees 0.32 (a breath of
# 1.9 m/s, looks/low) to 5.8.
MAX_MEAN = 0.02  # [8-bit steps]
MAX_FAR = 0.0005  # four pixels
LAYER_SETTINGS = """khronos_validation.enables = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT
khronos_validation.report_flags = error,warn,perf
khronos_validation.debug_action = VK_DBG_LAYER_ACTION_LOG_MSG
"""
LINES = re.compile(r".+: 1 pictures of 128 x 72 px in [\d.]+ s, in .+\nmemory: .+\n"
                   r"(this device has no timestamps: no stage is timed\n|ms +mean .+\n(\w+ +[\d. ]+\n)+)")


def scenes_with_pictures():
    """Path and text of each."""
    for file in sorted(SCENES.rglob("*.json")):
        if file.name != "scene.schema.json":
            scene = json.loads(file.read_text(encoding="utf-8"))
            if "picture" in scene:
                yield file, scene


def reference_of(scene):
    return REFERENCES / scene.relative_to(SCENES).with_suffix(".png")


def name_of(scene):
    return scene.relative_to(SCENES).with_suffix("").as_posix()


def flags_of_the_moment(scene):
    """In as few frames as may be."""
    moment = MOMENTS.get(name_of(scene), MOMENT)
    return "--warm-up", 0, "--fps", math.ceil(moment / LONGEST_FRAME) / moment, "--from", moment


def how_to_accept(scene):
    return ("look at the picture, then accept it by WINDROW_ACCEPT_IMAGES=1 ctest --test-dir build/release -R "
            f"'^program\\.draw\\.{name_of(scene)}$', and add {reference_of(scene)} to the commit.")


class UnderTheLayer(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "vk_layer_settings.txt").write_text(LAYER_SETTINGS)
        (self.folder / "small.json").write_text('{"duration": 1, "air": {"cells": [8, 8, 8]}, "picture": {"size": [64, 36], "warm_up": 0}}')

    def run_program(self, *arguments, most_bytes=None, **variables):
        """`most_bytes`: of a file that the system takes; beyond it a write fails as on a full disk."""
        # References are the software device's: a GPU rounds otherwise. Whoever names a driver has it.
        chosen = {} if {"VK_ICD_FILENAMES", "VK_DRIVER_FILES"} & os.environ.keys() else {"VK_LOADER_DRIVERS_SELECT": "*lvp*"}
        environment = {**chosen, **os.environ, "VK_INSTANCE_LAYERS": "VK_LAYER_KHRONOS_validation", "VK_LAYER_SETTINGS_PATH": str(self.folder),
                       **variables}
        def limit():
            if most_bytes is not None: # Python ignores the signal of a file that is too large, and so does its child
                resource.setrlimit(resource.RLIMIT_FSIZE, (most_bytes, most_bytes))
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False, preexec_fn=limit, restore_signals=most_bytes is None)


class OneScene(UnderTheLayer):
    def draw(self, *moment):
        """The picture's file, drawn without a word from the layer."""
        run = self.run_program(SCENE, "--frames", 1, "--size", "%dx%d" % SIZE, "--out", "drawn", *moment)
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertTrue(LINES.fullmatch(run.stdout), run.stdout)
        return next((self.folder / "drawn").glob("frame_*.png"))

    def test_it_draws_the_accepted_picture_without_a_word_from_the_layer(self):
        drawn, reference = self.draw(*flags_of_the_moment(SCENE)), reference_of(SCENE)
        if os.environ.get("WINDROW_ACCEPT_IMAGES"):
            reference.parent.mkdir(parents=True, exist_ok=True)
            small_png.write(reference, small_png.read(drawn))
            print(f"accepted: {reference}")
            return
        here = (LEFT / SCENE.relative_to(SCENES)).with_suffix(".png")
        here.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(drawn, here)
        apart_file = here.with_suffix(".difference.png")
        apart_file.unlink(missing_ok=True)
        self.assertTrue(reference.is_file(), f"{SCENE} has no reference; it was drawn to {here}: {how_to_accept(SCENE)}")
        seen, wanted = small_png.read(here), small_png.read(reference)
        self.assertEqual(seen[:2], wanted[:2], f"{reference} is of another size: {how_to_accept(SCENE)}")
        mean, far = small_png.apart(seen, wanted)
        name = f"images/examples/{name_of(SCENE)}"
        print(f"[figure] {name}/mean {mean:.6g} {MAX_MEAN:g}\n[figure] {name}/far_fraction {far:.6g} {MAX_FAR:g}")
        if mean > MAX_MEAN or far > MAX_FAR:
            small_png.write(apart_file, small_png.difference(seen, wanted))
            self.fail(f"{SCENE} is not {reference}: a mean of {mean:.4g} with at most {MAX_MEAN}, {far:.4g} of the pixels far off with at "
                      f"most {MAX_FAR}. Drawn: {here}; the difference, times 8: {apart_file}. If it is meant, {how_to_accept(SCENE)}")

    @unittest.skipUnless(os.environ.get("WINDROW_TIER") == "all", "each step of the wind is recorded as the one before it")
    def test_the_layer_is_silent_after_the_whole_time_before_the_picture(self):
        self.draw()


class AllScenes(UnderTheLayer):
    def test_every_scene_keeps_the_schema(self):
        schema = json.loads((SCENES / "scene.schema.json").read_text(encoding="utf-8"))
        judge = jsonschema.validators.validator_for(schema)(schema)
        files = [file for file, scene in scenes_with_pictures() if not judge.validate(scene)]
        self.assertGreaterEqual({file.stem for file in files},
                                {"meadow", "tall", "short", "violet", "path", "yellow", "wind", "composition"})

    def test_every_scene_has_its_reference_and_every_reference_its_scene(self):
        wanted = {reference_of(file): file for file, _ in scenes_with_pictures()}
        for reference, scene in wanted.items():
            with self.subTest(scene):
                self.assertTrue(reference.is_file() or os.environ.get("WINDROW_ACCEPT_IMAGES"), f"{scene} has no reference: {how_to_accept(scene)}")
        self.assertLessEqual(MOMENTS.keys(), {name_of(scene) for scene in wanted.values()})
        for reference in REFERENCES.rglob("*.png"):
            self.assertIn(reference, wanted, f"{reference} is of a scene that is gone; remove it.")

    def test_the_air_of_either_backend_is_drawn_without_a_word_from_the_layer(self):
        """A runner in gusts, with a ground that remembers; trees and grass that swing."""
        for scene in "looks/path", "looks/composition":
            wind = {}
            for backend in "cpu", "vulkan":
                run = self.run_program(SCENES / f"{scene}.json", "--frames", 2, "--warm-up", 0, "--fps", 8, "--from", 0.25, "--size", "64x36",
                                       "--backend", backend, "--out", backend)
                self.assertEqual(run.returncode, 0, run.stdout)
                self.assertRegex(run.stdout, r"\A.+: 2 pictures .+\nmemory: .+\n(ms|this device)", run.stdout)
                wind[backend] = float(re.search(r"([\d.]+) wind", run.stdout)[1])
            self.assertGreater(wind["vulkan"], 1.2 * wind["cpu"], "the solver's fields are on the device alone with vulkan")

    def test_several_scenes_make_a_sheet(self):
        (self.folder / "other.json").write_text((self.folder / "small.json").read_text())
        run = self.run_program("small.json", "other.json", "--frames", 1, "--out", "both", "--sheet", "sheet.png")
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertEqual(sorted(made.name for made in (self.folder / "both").iterdir()), ["other", "small"])
        # Two of 64 px with margins of 6.
        self.assertEqual(struct.unpack(">II", (self.folder / "sheet.png").read_bytes()[16:24]), (6 + 2 * (64 + 6), 6 + 36 + 6))

    def test_no_driver_is_the_machines_fault(self):
        run = self.run_program("small.json", "--frames", 1, VK_DRIVER_FILES="/none", VK_ICD_FILENAMES="/none")
        self.assertEqual(run.returncode, 3, run.stdout)
        self.assertRegex(run.stdout, r"\Awindrow-draw: small.json: no Vulkan driver is installed: [^\n]+\n\Z")

    def test_a_file_that_does_not_fit_is_the_machines_fault(self):
        run = self.run_program("small.json", "--frames", 1, "--out", "out", most_bytes=512)
        self.assertEqual(run.returncode, 3, run.stdout)
        self.assertRegex(run.stdout, r"windrow-draw: picture out/frame_0000.png cannot be written \(File too large\); [^\n]+\n\Z")
        self.assertEqual([file.name for file in (self.folder / "out").iterdir()], [])

    def test_a_whole_scene_takes_the_place_of_a_longer_one(self):
        """A part of a scene leaves what is there."""
        left = {"frame_0007.png", "frame_0005.exr", "frame_00012.png", "frame_9.png", "other_0009.png"}
        made = {f"frame_{n:04d}.png" for n in range(5)} | {"contact_sheet.png", "times.csv"}
        (self.folder / "out").mkdir()
        for name in left:
            (self.folder / "out" / name).write_text("old")
        part = self.run_program("small.json", "--fps", 4, "--frames", 5, "--out", "out")
        self.assertEqual(part.returncode, 0, part.stdout)
        self.assertIn("out holds 2 frames of another run, which this run does not replace", part.stdout)
        self.assertEqual({file.name for file in (self.folder / "out").iterdir()}, left | made)
        whole = self.run_program("small.json", "--fps", 4, "--resume", "--exr", "--out", "out")
        self.assertEqual(whole.returncode, 0, whole.stdout)
        self.assertIn("removed 3 frames of a longer run, from out/frame_00012.png on.", whole.stdout)
        made |= {f"frame_{n:04d}.exr" for n in range(5)}  # of pictures that were there too
        self.assertEqual({file.name for file in (self.folder / "out").iterdir()}, {"frame_9.png", "other_0009.png"} | made)

    def test_a_run_that_goes_on_leaves_what_an_unbroken_one_does(self):
        """A camera that moves, air of unequal rows. The table of times alone has other figures."""
        (self.folder / "go.json").write_text(json.dumps(
            {"duration": 1, "paths": {"way": {"points": [[0, 0, 1.7, 0], [1, 1, 1.7, -2]]}},
             "air": {"cells": [8, 12, 8], "rows": {"first": 0.3, "uniform": 2, "top": 12}},
             "picture": {"size": [64, 36], "warm_up": 0, "camera": {"path": "way"}, "ground_memory": {"max_walkers": 1},
                         "walkers": 2 * [{"path": "way", "figure": False, "wake": False}]}}))
        for folder in "pages", "pages2":
            (self.folder / folder).mkdir()
        whole, cut = self.folder / "whole", self.folder / "cut"

        def draw(folder, *flags):
            run = self.run_program("go.json", "--fps", 4, "--exr", "--out", folder, *flags)
            self.assertEqual(run.returncode, 0, run.stdout)
            return run.stdout

        def go_on(expected):
            self.assertIn(expected, draw(cut, "--resume", "--sheet", "sheet2.png", "--jpeg", "pages2"))
            left = {file.name for file in whole.iterdir()}
            self.assertEqual({file.name for file in cut.iterdir()}, left)
            pairs = [(cut / name, whole / name) for name in left - {"times.csv"}]
            pairs += [(self.folder / "sheet2.png", self.folder / "sheet.png"), (self.folder / "pages2" / "go.jpg", self.folder / "pages" / "go.jpg")]
            self.assertEqual([str(here) for here, there in pairs if here.read_bytes() != there.read_bytes()], [])
            rows = [[line.split(",")[0] for line in (folder / "times.csv").read_text().splitlines()] for folder in (cut, whole)]
            self.assertEqual(*rows)

        draw(whole, "--sheet", "sheet.png", "--jpeg", "pages")
        shutil.copytree(whole, cut)
        go_on("5 pictures were there")
        (cut / "frame_0003.png").unlink()
        (cut / "frame_0002.exr").unlink()
        go_on("2 pictures were there")
        (cut / "frame_0002.exr").unlink()
        self.assertIn("frame_0002.exr is missing", self.rejected("go.json", "--fps", 4, "--exr", "--out", "cut", "--join"))
        self.assertIn("is 64 x 36 px, and this run draws 66 x 36 px", self.rejected("go.json", "--fps", 4, "--size", "66x36", "--out", "cut", "--resume"))
        # The first frame moves as in the whole run, whose first stands still and so takes less room.
        said = draw("from", "--from", 0.5, "--frames", 1)
        self.assertIn("go.json: the ground's memory left out 1 walkers of a frame; raise $.picture.ground_memory.max_walkers.", said)
        moving = whole / "frame_0002.exr"
        self.assertTrue((self.folder / "from" / moving.name).read_bytes() == moving.read_bytes(), "other light or motion")
        self.assertGreater(moving.stat().st_size, 1.05 * (whole / "frame_0000.exr").stat().st_size)
        draw("calm", "--no-wind", "--frames", 1)  # which has fewer cells than the rows ask for

    def rejected(self, *arguments):
        """What it says: one line that begins with its name."""
        run = self.run_program(*arguments)
        self.assertEqual(run.returncode, 2, (arguments, run.stdout))
        self.assertRegex(run.stdout, r"\Awindrow-draw: [^\n]+\n\Z", arguments)
        return run.stdout

    def test_bad_flags_are_rejected(self):
        for flag, values in {"--frames": ("0", "-1", "1e9", "nan", "x"), "--from": ("-1", "nan", "inf", "x", "99"),
                             "--warm-up": ("-1", "nan", "x", "4000"), "--fps": ("0", "nan", "inf", "-5", "1e9"), "--samples": ("0", "2", "x"), "--show": ("zebra", "3"), "--backend": ("gpu", "1"), "--shutter": ("-1", "nan", "x", "361"),
                             "--size": ("64", "0x0", "64x", "9999x9999", "-64x36", "64x36x2", "nanxnan")}.items():
            for value in values:
                with self.subTest((flag, value)):
                    self.assertIn(flag, self.rejected("small.json", "--frames=1", f"{flag}={value}"))
        self.assertIn("unknown option --zebra: see windrow-draw --help.", self.rejected("small.json", "--zebra"))
        self.assertIn("unknown option --flim (did you mean --film?): see windrow-draw --help.", self.rejected("small.json", "--flim", "a.webp"))
        self.assertIn("(did you mean streaks?)", self.rejected("small.json", "--show", "strekas"))
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
    PROGRAM, SCENES, REFERENCES, LEFT, *scene = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    SCENE = scene[0] if scene else None
    unittest.main(argv=[sys.argv[0], "OneScene" if SCENE else "AllScenes"])
