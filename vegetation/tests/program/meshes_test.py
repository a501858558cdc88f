#!/usr/bin/env python3
"""meshes_test.py MAKE_MESHES MAKE_MAPS: what the looks of shells name is made whole, the same each time, or rejected.

Copies need glmark2-data; where it is not there, only the bear is looked at.
"""
import collections
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

MESHES = MAPS = ""
PACKAGE = pathlib.Path("/usr/share/glmark2/models")


class Made(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_program(self, program, *arguments):
        return subprocess.run([sys.executable, "-B", program, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, check=False)

    def test_the_bear_is_closed_and_faces_outward(self):
        self.run_program(MESHES, "--out", self.folder)
        vertices, faces, parts = [], [], {}
        for line in (self.folder / "bear.obj").read_text().splitlines():
            words = line.split()
            if words[0] == "v":
                vertices.append(tuple(map(float, words[1:])))
            elif words[0] == "usemtl":
                part = parts.setdefault(words[1], [])
            elif words[0] == "f":
                face = [int(word.split("/")[0]) - 1 for word in words[1:]]
                faces.append(face)
                part.append(face)
        # Where two sheets meet in one cell of the grid, four faces share an edge; its two directions are still even.
        edges = collections.Counter(edge for face in faces for edge in zip(face, face[1:] + face[:1]))
        self.assertEqual(sum(count != edges[(b, a)] for (a, b), count in list(edges.items())), 0, "edges with one side only")
        volume = 0.0
        for face in faces:
            for second, third in zip(face[1:], face[2:]):
                a, b, c = (vertices[n] for n in (face[0], second, third))
                volume += sum(a[k] * (b[(k + 1) % 3] * c[(k + 2) % 3] - b[(k + 2) % 3] * c[(k + 1) % 3]) for k in range(3)) / 6.0
        print(f"[figure] examples/meshes/bear_volume {volume:.1f} 20")
        self.assertGreater(volume, 20.0)  # units cubed; inward faces make it negative
        self.assertGreater(len(parts["coat"]), 50 * len(parts["nose"]))
        self.assertGreater(len(parts["nose"]), 0)
        self.assertIn("\nfur 48 0.419 2.753 11\n", (self.folder / "bear.mtl").read_text())

    def test_the_bunny_and_the_horse_are_the_packages(self):
        if not PACKAGE.is_dir():
            self.skipTest("glmark2-data is not installed")
        run = self.run_program(MESHES, "--out", self.folder)
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertEqual((self.folder / "bunny.obj").read_bytes(), (PACKAGE / "bunny.obj").read_bytes())
        lines = [line.split() for line in (self.folder / "horse.obj").read_text().splitlines()]
        count = collections.Counter(words[0] for words in lines)
        self.assertEqual((count["v"], count["vt"], count["f"], count["usemtl"]), (3582, 3582, 7172, 1))
        horse = (PACKAGE / "horse.3ds").read_bytes()
        # Exact: the floats lie in the package's file as they are.
        for words in lines:
            if words[0] in ("v", "vt"):
                self.assertIn(struct.pack(f"<{len(words) - 1}f", *map(float, words[1:])), horse)

    def test_the_same_each_time(self):
        for program in (MESHES, MAPS):
            made = []
            for name in ("one", "other"):
                (self.folder / name).mkdir(exist_ok=True)
                self.run_program(program, "--out", self.folder / name)
                made.append({file.name: file.read_bytes() for file in (self.folder / name).iterdir()})
            self.assertEqual(*made)
            self.assertGreaterEqual(len(made[0]), 2)

    def test_maps_are_pictures(self):
        run = self.run_program(MAPS, "--out", self.folder)
        self.assertEqual(run.returncode, 0, run.stdout)
        for file in self.folder.iterdir():
            magic, size, most, body = file.read_bytes().split(b"\n", 3)
            columns, rows = map(int, size.split())
            self.assertEqual((most, len(body)), (b"255", columns * rows * {b"P5": 1, b"P6": 3}[magic]), file.name)
            self.assertGreater(len(set(body)), 1, f"{file.name} is one colour")

    def test_missing_folders_are_told(self):
        run = self.run_program(MESHES, "--from", self.folder / "none", "--out", self.folder)
        self.assertEqual(run.returncode, 3, run.stdout)
        self.assertIn("has no bunny.obj", run.stdout)
        for program in (MESHES, MAPS):
            run = self.run_program(program, "--out", self.folder / "no" / "folder")
            self.assertEqual(run.returncode, 2, run.stdout)
            self.assertIn("cannot be written", run.stdout)
        self.assertFalse(any(self.folder.glob("*.part")), "nothing half written")


if __name__ == "__main__":
    MESHES, MAPS = sys.argv.pop(1), sys.argv.pop(1)
    unittest.main()
