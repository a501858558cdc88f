#!/usr/bin/env python3
"""film_test.py PROGRAM MAKE_FILM: a film of two small shots that is killed and goes on, both shots at a time, has the bytes of one
drawn shot by shot. The film of a page (tools/webp_film.py) is decoded and compared with its pictures.

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
        self.assertRegex(run.stdout, r"02_low: 3 frames\n", "a shot whose scene has changed is drawn again")
        if shutil.which("ffmpeg"):
            self.assertIn("windrow.mp4: 0.5 s", run.stdout)  # 10 + 3 - 1 frames
            film = self.folder / "cut" / "windrow.mp4"
            self.assertGreater(film.stat().st_size, 1000)
            keys = subprocess.run(["ffprobe", "-v", "error", "-skip_frame", "nokey", "-show_entries", "frame=pts_time", "-of", "csv=p=0", film],
                                  check=True, stdout=subprocess.PIPE, text=True).stdout.replace(",", "").split()
            for cut in (9 / 24, 10 / 24):  # where the dissolve begins and ends
                self.assertTrue(any(abs(float(key) - cut) < 0.02 for key in keys), f"no key frame at {cut:.3f} s of {keys}")

    def test_wrong_use_is_one_sentence(self):
        (self.folder / "long.json").write_text('{"small": {"fade": 0.5, "shots": [{"scene": "looks/low", "from": 2, "seconds": 1.5}]}}')
        for flags in (("--edit", str(self.folder / "long.json")), ("--size", "64"), ("--size", "65x37"), ("--fps", "0"), ("--fps", "x"), ("--jobs", "0"), ("--edit", str(self.folder / "bad.json"))):
            with self.subTest(flags):
                (self.folder / "bad.json").write_text('{"small": {"fade": 0.5, "shots": [{"scene": "none", "from": 0, "seconds": 2}]}}')
                run = self.run_film("wrong", "--frames-only", *flags)
                self.assertEqual(run.returncode, 2, run.stdout)
                self.assertRegex(run.stdout, r"\Amake_film\.py: [^\n]+\n\Z")


    def test_the_film_of_a_page_may_go_where_the_film_goes(self):
        """As `./dev demo` asks for it, on a machine that has drawn nothing yet; the edit's fault is found after the flags'."""
        (self.folder / "bad.json").write_text('{"small": {"fade": 0.5, "shots": [{"scene": "none", "from": 0, "seconds": 2}]}}')
        for folder, fault in (("new", "none"), ("elsewhere", "in no folder")):
            command = self.command("new", "--edit", self.folder / "bad.json", "--webp", self.folder / folder / "page.webp")
            run = subprocess.run([python_with_pillow(), *command[1:]], check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            self.assertEqual(run.returncode, 2, run.stdout)
            self.assertEqual("in no folder" in run.stdout, fault == "in no folder", run.stdout)


def python_with_pillow():
    """Debian's, where the first in the PATH lacks Debian's modules."""
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", "import PIL.Image"], check=False, stderr=subprocess.DEVNULL).returncode == 0:
            return python
    raise RuntimeError("Pillow is not installed: Debian's python3-pil")


class FilmOfOnesOwnScene(unittest.TestCase):
    """windrow-draw --film."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for name, height in (("one", 1.5), ("two", 9)):
            (self.folder / f"{name}.json").write_text(json.dumps(
                {"duration": 1, "frames_per_second": 5, "air": {"cells": [8, 8, 8]},
                 "picture": {"size": [66, 36], "warm_up": 0, "camera": {"position": [0, height, 8]}}}))

    def draw(self, *flags, path=None):
        environment = {**os.environ, "PATH": str(path)} if path else os.environ
        return subprocess.run([PROGRAM, *map(str, flags)], cwd=self.folder, env=environment, check=False, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True)

    def check(self, film, *pictures):
        return subprocess.run([python_with_pillow(), "-B", str(MAKE_FILM.with_name("webp_film.py")), str(film), *map(str, pictures), "--fps", "5",
                               "--check"], check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def test_a_webp_shows_its_pictures(self):
        run = self.draw("one.json", "two.json", "--out", "out", "--film", "film.webp")
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertRegex(run.stdout, r"film\.webp: 2\.4 s, 0\.\d\d MB\n\Z")
        pictures = [self.folder / "out" / scene / f"frame_{n:04d}.png" for scene in ("one", "two") for n in range(6)]
        checked = self.check(self.folder / "film.webp", *pictures)
        self.assertEqual(checked.returncode, 0, checked.stdout)
        self.assertNotEqual(self.check(self.folder / "film.webp", *reversed(pictures)).returncode, 0)
        # Of a part, and of pictures that were there.
        run = self.draw("two.json", "--out", "out/two", "--from", 0.4, "--frames", 2, "--resume", "--film", "part.webp")
        self.assertEqual(run.returncode, 0, run.stdout)
        checked = self.check(self.folder / "part.webp", *pictures[8:10])
        self.assertEqual(checked.returncode, 0, checked.stdout)

    def test_an_mp4_is_ffmpegs(self):
        """The words that ffmpeg gets, by one that keeps them."""
        programs = self.folder / "programs"
        programs.mkdir()
        (programs / "ffmpeg").write_text('#!/bin/sh\nprintf "%s\\n" "$@" > words\nfor last; do :; done\n/bin/echo film > "$last"\n')
        (programs / "ffmpeg").chmod(0o755)
        run = self.draw("one.json", "two.json", "--out", "50%", "--film", "film.mp4", path=programs)
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertEqual((self.folder / "film.mp4").read_text(), "film\n")
        words = (self.folder / "words").read_text().split("\n")
        for first, second in (("-i", "50%%/one/frame_%04d.png"), ("-i", "50%%/two/frame_%04d.png"), ("-crf", "18"), ("-framerate", "5"),
                              ("-force_key_frames", "1.15"), ("-start_number", "0")):
            self.assertIn((first, second), list(zip(words, words[1:])))
        (programs / "ffmpeg").write_text("#!/bin/sh\nexit 1\n")
        run = self.draw("one.json", "--frames", 1, "--film", "film.mp4", path=programs)
        self.assertEqual(run.returncode, 2, run.stdout)
        self.assertIn("film.mp4 was not made by ffmpeg", run.stdout)
        self.assertEqual((self.folder / "film.mp4").read_text(), "film\n", "what was there stays")
        self.assertFalse((self.folder / "part_film.mp4").exists())

    @unittest.skipUnless(shutil.which("ffmpeg"), "needs ffmpeg")
    def test_an_mp4_has_a_key_frame_at_the_cut(self):
        run = self.draw("one.json", "two.json", "--out", "out", "--film", "film.mp4")
        self.assertEqual(run.returncode, 0, run.stdout)
        keys = subprocess.run(["ffprobe", "-v", "error", "-skip_frame", "nokey", "-show_entries", "frame=pts_time", "-of", "csv=p=0",
                               self.folder / "film.mp4"], check=True, stdout=subprocess.PIPE, text=True).stdout.replace(",", "").split()
        self.assertEqual([round(float(key), 2) for key in keys], [0, 1.2])

    def test_what_cannot_be_made_is_said_before_anything_is_drawn(self):
        for code, flags, words in ((2, ("--film", "a.gif"), "ends in .webp or .mp4"), (2, ("--film", "none/a.webp"), "does not exist"),
                                   (3, ("--film", "a.mp4"), "ffmpeg, which is not in the PATH")):
            with self.subTest(flags):
                run = self.draw("one.json", *flags, path=self.folder)
                self.assertEqual(run.returncode, code, run.stdout)
                self.assertRegex(run.stdout, r"\Awindrow-draw: --film [^\n]+\n\Z")
                self.assertIn(words, run.stdout)
                self.assertFalse((self.folder / "out").exists())
        (self.folder / "two.json").write_text((self.folder / "two.json").read_text().replace("66", "64"))
        run = self.draw("one.json", "two.json", "--frames", 1, "--film", "a.webp")
        self.assertEqual(run.returncode, 2, run.stdout)
        self.assertIn("--film: two.json has 64 x 36 px and 5 frames a second, the film 66 x 36 and 5; give --size and --fps for all.", run.stdout)


# Run by a python that has Pillow: a slow dissolve of two smooth pictures, written as a page has it and with few key frames.
DISSOLVE = """
import pathlib, random, sys
sys.path.insert(0, sys.argv[1])
import webp_film
from PIL import Image
def clouds(seed, colour):
    chance, picture = random.Random(seed), Image.new("RGB", (6, 4))
    picture.putdata([tuple(level + chance.randrange(40) for level in colour) for _ in range(6 * 4)])
    return picture.resize((192, 128), Image.Resampling.BICUBIC)
first, last, folder, files = clouds(1, (60, 120, 40)), clouds(2, (150, 170, 210)), pathlib.Path(sys.argv[2]), []
for number in range(30):
    files.append(folder / f"{number:02d}.png")
    Image.blend(first, last, min(max((number - 1) / 28, 0), 1)).save(files[-1])
print("key frames alone:", *webp_film.write(files, folder / "page.webp", 12, most=12_000, best=75))
try:
    webp_film.write(files, folder / "bad.webp", 12, most=12_000, best=75, farthest_key=1000)
    print("few key frames: no fault")
except webp_film.Fault as fault:
    print("few key frames:", fault)
"""


class FilmOfAPage(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.python = python_with_pillow()

    def tool(self, *arguments):
        return subprocess.run([self.python, "-B", str(MAKE_FILM.with_name("webp_film.py")), *map(str, arguments)], check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def test_a_slow_dissolve_keeps_to_its_pictures(self):
        run = subprocess.run([self.python, "-B", "-c", DISSOLVE, str(MAKE_FILM.parent), str(self.folder)], check=False,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertRegex(run.stdout, r"key frames alone: \d+ [0-2]\.\d")
        self.assertRegex(run.stdout, r"few key frames: \S+ differs from \S+ by .* levels in the mean")
        self.assertFalse((self.folder / "bad.webp").exists())
        pictures = sorted(self.folder.glob("*.png"))
        self.assertEqual(self.tool(self.folder / "page.webp", *pictures, "--check").returncode, 0)
        text = self.folder / "no_picture.png"
        text.write_text("none")
        for wrong in ((self.folder / "page.webp", *pictures[:-1], "--check"), (self.folder / "page.webp", *reversed(pictures), "--check"),
                      (self.folder / "page.webp", text, "--check"), (self.folder / "none" / "a.webp", *pictures[:2]),
                      (self.folder / "a.webp", pictures[0])):
            run = self.tool(*wrong)
            self.assertEqual(run.returncode, 2, run.stdout)
            self.assertRegex(run.stdout, r"\Awebp_film\.py: [^\n]+\n\Z")
        self.assertEqual([file.name for file in self.folder.glob("*.webp")], ["page.webp"])

    def test_the_pages_films_have_key_frames_alone(self):
        """Each frame of docs/*.webp covers the canvas and shows nothing of the frame before."""
        films = sorted((MAKE_FILM.parents[1] / "docs").glob("*.webp"))
        self.assertGreaterEqual(len(films), 2)
        for film in films:
            data, at, frames = film.read_bytes(), 12, 0
            while at < len(data):
                kind, size = data[at:at + 4], int.from_bytes(data[at + 4:at + 8], "little")
                body = data[at + 8:at + 8 + size]
                if kind == b"VP8X":
                    canvas = body[4:10]
                elif kind == b"ANMF":
                    frames += 1
                    self.assertEqual((body[0:6], body[6:12]), (bytes(6), canvas), f"{film.name}, frame {frames}: a part of the picture")
                    self.assertTrue(body[15] & 2, f"{film.name}, frame {frames}: blended with the frame before")
                at += 8 + size + size % 2
            self.assertGreater(frames, 10, film.name)
            self.assertLessEqual(len(data), 4_000_000, film.name)


if __name__ == "__main__":
    PROGRAM, MAKE_FILM = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    unittest.main(argv=[sys.argv[0]])
