#!/usr/bin/env python3
"""film_test.py PROGRAM MAKE_FILM: a film of two small shots that is killed and goes on, both shots at a time, has the bytes of one
drawn shot by shot.

PROGRAM is windrow-draw, MAKE_FILM tools/make_film.py. With ffmpeg the shots are cut together, too.
"""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = MAKE_FILM = pathlib.Path()
FRAMES = {"01_low": range(4, 14), "02_low": range(0, 3)}  # at 24 a second
# The first shot moves so fast that its pictures are blurred.
EDIT = {"small": {"fade": 1 / 24, "shots": [
    {"scene": "looks/low", "from": 4 / 24, "seconds": 10 / 24, "set": {"duration": 1},
     "camera": {"from": [-8, 1.55, 0], "to": [8, 1.55, 0]}, "target": {"from": [-8, -0.55, -10], "to": [8, -0.55, -10]}},
    {"scene": "looks/low", "from": 0, "seconds": 3 / 24}]}}


class Film(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.edit = self.folder / "edit.json"
        self.edit.write_text(json.dumps(EDIT))

    def command(self, out, *flags):
        return [sys.executable, "-B", str(MAKE_FILM), str(PROGRAM), "small", "--edit", str(self.edit), "--size", "64x36",
                "--out", str(self.folder / out), *map(str, flags)]

    def run_film(self, out, *flags):
        return subprocess.run(self.command(out, *flags), check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def pictures(self, out):
        return {shot: {file.name: file.read_bytes() for file in (self.folder / out / "frames" / shot).glob("frame_*.png")} for shot in FRAMES}

    def test_a_film_that_was_killed_goes_on_to_the_same_bytes(self):
        run = self.run_film("whole", "--frames-only", "--jobs", 1)
        self.assertEqual(run.returncode, 0, run.stdout)
        whole = self.pictures("whole")
        for shot, frames in FRAMES.items():
            self.assertEqual(sorted(whole[shot]), [f"frame_{n:04d}.png" for n in frames])

        killed = subprocess.Popen(self.command("cut", "--frames-only", "--jobs", 2), start_new_session=True, stdout=subprocess.DEVNULL)
        first = self.folder / "cut" / "frames" / "01_low"
        until = time.monotonic() + 60
        while len(list(first.glob("frame_*.png"))) < 3 and time.monotonic() < until:
            time.sleep(0.01)
        os.killpg(killed.pid, signal.SIGKILL)
        killed.wait()
        there = {file.name: file.stat().st_mtime_ns for file in first.glob("frame_*.png")}
        self.assertTrue(3 <= len(there) < len(FRAMES["01_low"]), f"{len(there)} pictures were there when it was killed")
        run = self.run_film("cut", "--frames-only", "--jobs", 2)
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertIn(f"10 frames, {len(there)} are there", run.stdout)
        self.assertEqual({name: (first / name).stat().st_mtime_ns for name in there}, there, "pictures that were there are kept")
        cut = self.pictures("cut")
        self.assertEqual({shot: sorted(files) for shot, files in cut.items()}, {shot: sorted(files) for shot, files in whole.items()})
        other = [f"{shot}/{name}" for shot, files in whole.items() for name, data in files.items() if cut[shot][name] != data]
        self.assertEqual(other, [], "pictures of other bytes than those of the unbroken film")

        EDIT["small"]["shots"][1]["set"] = {"description": "another scene"}
        self.edit.write_text(json.dumps(EDIT))
        run = self.run_film("cut", *([] if shutil.which("ffmpeg") else ["--frames-only"]))
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertIn("10 frames, 10 are there", run.stdout)
        self.assertRegex(run.stdout, r"02_low: 3 frames\n", "a shot whose scene has changed is drawn anew")
        if shutil.which("ffmpeg"):
            self.assertIn("windrow.mp4: 0.5 s", run.stdout)  # 10 + 3 - 1 frames
            self.assertGreater((self.folder / "cut" / "windrow.mp4").stat().st_size, 1000)

    def test_wrong_use_is_one_sentence(self):
        (self.folder / "long.json").write_text('{"small": {"fade": 0.5, "shots": [{"scene": "looks/low", "from": 2, "seconds": 1.5}]}}')
        for flags in (("--edit", str(self.folder / "long.json")), ("--size", "64"), ("--size", "65x37"), ("--fps", "0"), ("--fps", "x"), ("--jobs", "0"), ("--edit", str(self.folder / "bad.json"))):
            with self.subTest(flags):
                (self.folder / "bad.json").write_text('{"small": {"fade": 0.5, "shots": [{"scene": "none", "from": 0, "seconds": 2}]}}')
                run = self.run_film("wrong", "--frames-only", *flags)
                self.assertEqual(run.returncode, 2, run.stdout)
                self.assertRegex(run.stdout, r"\Amake_film\.py: [^\n]+\n\Z")


if __name__ == "__main__":
    PROGRAM, MAKE_FILM = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    unittest.main(argv=[sys.argv[0]])
