#!/usr/bin/env python3
"""field_files_test.py: the files of engines and analysts, read by readers of their published descriptions, against the wind itself; and the
tables of probes and forces.

The library of WINDROW_LIBRARY writes them, and the command of WINDROW_COMMAND where there is one.
"""
import csv
import json
import os
import pathlib
import re
import struct
import subprocess
import tempfile
import unittest

import numpy as np

import windrow


def read_fga(file):
    """Unreal's: numbers with commas: the size, the two corners, then vectors, x fastest."""
    numbers = [float(word) for word in file.read_text(encoding="ascii").replace("\n", "").split(",") if word]
    size = tuple(map(int, numbers[:3]))
    return size, numbers[3:6], numbers[6:9], np.array(numbers[9:]).reshape(size[2], size[1], size[0], 3)


def read_vf(file):
    """Unity's: VF_V, three sizes of 16 bits, then vectors, x fastest."""
    data = file.read_bytes()
    assert data[:4] == b"VF_V"
    size = struct.unpack("<3H", data[4:10])
    return np.frombuffer(data[10:], "<f4").reshape(size[2], size[1], size[0], 3)


def read_raw(file):
    words = json.loads(pathlib.Path(f"{file}.json").read_text(encoding="utf-8"))
    assert words["format"] == "rgba16f"
    return words, np.frombuffer(file.read_bytes(), "<f2").reshape(*words["size"][::-1], 4)


def read_vti(file):
    """VTK's XML of ImageData: arrays at offsets behind the underscore of the appended data, each after its length of 64 bits."""
    data = file.read_bytes()
    head, _, appended = data.partition(b'<AppendedData encoding="raw">\n_')
    head = head.decode("ascii")
    attribute = lambda name: [float(word) for word in re.search(rf'{name}="([^"]*)"', head).group(1).split()]
    x, y, z = (int(n) for n in attribute("WholeExtent")[1::2])
    arrays = {}
    for kind, name, offset in re.findall(r'<DataArray type="(\w+)" Name="(\w+)"[^>]*format="appended" offset="(\d+)"', head):
        length, = struct.unpack_from("<Q", appended, int(offset))
        array = np.frombuffer(appended, {"Float32": "<f4", "UInt8": "u1"}[kind], length // {"Float32": 4, "UInt8": 1}[kind], int(offset) + 8)
        arrays[name] = array.reshape(z, y, x, -1).squeeze(-1) if name == "obstacle" else array.reshape(z, y, x, 3)
    assert data.endswith(b"</VTKFile>\n")
    return attribute("Origin"), attribute("Spacing"), float(re.search(r"TimeValue.*?>([^<]*)<", head).group(1)), arrays


def windy(**changes):
    config = windrow.Config(cells=(9, 6, 7), cell_size=0.5, centre=(10, 0, -3), boundaries=windrow.Boundaries.open_over_floor(),
                            ambient=(3, 0, 1), **changes)
    wind = windrow.Wind(config)
    wind.motors.add(windrow.JetMotor(position=(9, 1, -3), direction=(0, 0.5, 1)))
    wind.obstacles.add(windrow.Obstacle(position=(10.5, 0.6, -3), shape=windrow.Block((0.7, 0.6, 0.7))))
    for _ in range(12):
        wind.step(1 / 30)
    return wind


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)


class FieldFiles(InFolder):
    def check_all(self, wind, velocity, obstacle, cell_size, exact):
        origin, size = np.array(wind.box.origin), velocity.shape[2::-1]
        for suffix in ("fga", "vf", "raw", "npz", "vti"):
            wind.write_field(self.folder / f"w.{suffix}", time=0.4)
        same = (lambda a, b: np.array_equal(a, b)) if exact else (lambda a, b: np.allclose(a, b, atol=2e-6))

        found, low, high, vectors = read_fga(self.folder / "w.fga")  # x, z, y here; centimetres
        self.assertEqual(found, (size[0], size[2], size[1]))
        self.assertTrue(np.allclose(low, 100 * origin[[0, 2, 1]]))
        self.assertTrue(np.allclose(high, 100 * (origin + cell_size * size)[[0, 2, 1]]))
        self.assertTrue(np.allclose(vectors[..., [0, 2, 1]].transpose(1, 0, 2, 3), 100 * velocity, rtol=2e-6, atol=1e-4))

        self.assertTrue(same(read_vf(self.folder / "w.vf")[::-1] * (1, 1, -1), velocity))  # z mirrored

        words, texels = read_raw(self.folder / "w.raw")
        self.assertEqual((tuple(words["size"]), words["time"]), (size, 0.4))
        self.assertTrue(np.allclose(words["origin"], origin) and np.allclose(words["cell_size"], cell_size))
        self.assertTrue(np.allclose(texels[..., :3], velocity, rtol=1e-3, atol=1e-5) and not texels[..., 3].any())

        with np.load(self.folder / "w.npz") as arrays:
            self.assertTrue(same(arrays["velocity"], velocity) and np.array_equal(arrays["obstacle"], obstacle))
            self.assertTrue(np.allclose(arrays["origin"], origin) and np.allclose(arrays["cell_size"], cell_size))
            self.assertEqual(arrays["time"], 0.4)

        low, spacing, time, arrays = read_vti(self.folder / "w.vti")
        self.assertTrue(np.allclose(low, origin) and np.allclose(spacing, cell_size))
        self.assertTrue(same(arrays["velocity"], velocity) and np.array_equal(arrays["obstacle"] != 0, obstacle))
        self.assertEqual(time, 0.4)

    def test_each_format_holds_the_cells(self):
        wind = windy()
        self.assertTrue(wind.inside_obstacles().any())
        self.check_all(wind, wind.field()[..., :3].copy(), wind.inside_obstacles(), np.full(3, 0.5), exact=True)

    def test_rows_of_unequal_thickness_are_sampled(self):
        heights = (0.1, 0.3, 0.55, 0.9, 1.3, 1.9)
        wind = windy(rows=windrow.Rows(heights=heights))
        box = wind.box
        rows = round(box.size[1] / 0.5)
        cell_size = np.array([0.5, box.size[1] / rows, 0.5])
        axes = [box.origin[n] + (np.arange(count) + 0.5) * cell_size[n] for n, count in enumerate((9, rows, 7))]
        z, y, x = np.meshgrid(axes[2], axes[1], axes[0], indexing="ij")
        thick = wind.inside_obstacles()
        nearest = np.abs(np.array(heights)[None, :] - (axes[1] - box.origin[1])[:, None]).argmin(axis=1)
        self.check_all(wind, wind.sample(np.stack([x, y, z], axis=-1)), thick[:, nearest], cell_size, exact=False)

    def test_what_cannot_be_written_is_a_sentence(self):
        wind = windrow.Wind(windrow.Config(cells=(4, 4, 4)))
        with self.assertRaises(windrow.WindrowError) as caught:
            wind.write_field(self.folder / "no" / "w.fga")
        self.assertEqual(caught.exception.kind, "cannot write")
        self.assertIn("w.fga cannot be written", str(caught.exception))
        with self.assertRaises(windrow.WindrowError) as caught:
            wind.write_field(self.folder / "w.obj")
        self.assertIn("format is 'obj': give 'fga'", str(caught.exception))
        self.assertEqual(list(self.folder.iterdir()), [])


@unittest.skipUnless("WINDROW_COMMAND" in os.environ, "no command was built")
class Command(InFolder):
    def run_command(self, *arguments):
        done = subprocess.run([os.environ["WINDROW_COMMAND"], "run", self.folder / "s.json", "--out", self.folder / "out", *arguments],
                              capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr

    def test_frames_of_a_run(self):
        (self.folder / "s.json").write_text(json.dumps({
            "duration": 0.3, "frames_per_second": 10, "air": {"cells": [8, 6, 5], "ambient": [2, 0, 0]},
            "obstacles": [{"shape": {"block": {"half_size": [1, 1, 1]}}}]}), encoding="utf-8")
        code, said = self.run_command("--fields", "npz,raw,npz")
        self.assertEqual((code, "files of fields (wind_*.npz, wind_*.raw)" in said), (0, True), said)
        names = sorted(path.name for path in (self.folder / "out").iterdir())
        self.assertEqual(names, [f"wind_{n:04}.{suffix}" for n in range(4) for suffix in ("npz", "raw", "raw.json")])
        first, last = (np.load(self.folder / f"out/wind_000{n}.npz") for n in (0, 3))
        self.assertTrue(first["obstacle"].any() and not first["velocity"][first["obstacle"]].any())
        self.assertAlmostEqual(float(last["time"]), 0.3)
        self.assertTrue(np.abs(last["velocity"] - first["velocity"]).max() > 0.1)
        scene = windrow.Scene(self.folder / "s.json")
        while scene.time < 0.3 - 1e-9:
            scene.step()
        self.assertTrue(np.array_equal(last["velocity"], scene.wind.field()[..., :3]))
        self.run_command("--fields", "raw", "--frames", "2")  # a part of a film leaves the frames of others
        self.assertEqual(len(list((self.folder / "out").iterdir())), 12)

    def rows(self, name):
        with open(self.folder / "out" / name, encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def test_probes_and_forces(self):
        text = json.dumps({"duration": 0.2, "frames_per_second": 10, "tick_hz": 30, "air": {"cells": [12, 8, 9], "ambient": [4, 0, 0]},
                           "obstacles": [{"name": "house", "position": [1, 0, 0], "shape": {"block": {}}},
                                         {"name": "car", "from": 0.1, "position": [3, 1, 2], "shape": {"sphere": {}}}]})
        (self.folder / "s.json").write_text(text, encoding="utf-8")
        code, said = self.run_command("--probe", "mast=-2,1,0.5", "--probe", "lee=2.5,0,0:5,0,0:3", "--forces")
        self.assertEqual((code, "probes.csv, forces.csv" in said), (0, True), said)
        scene = windrow.Scene("s.json", text=text)
        probes, forces = self.rows("probes.csv"), self.rows("forces.csv")
        self.assertEqual(len(probes), 4 * 7)  # at the start, and after each of six steps
        places = [(-2, 1, 0.5), (2.5, 0, 0), (3.75, 0, 0), (5, 0, 0)]
        for step in range(7):
            if step > 0:
                scene.step()
            for place, row in zip(places, probes[4 * step:4 * step + 4]):
                self.assertAlmostEqual(float(row["time_s"]), scene.time)
                self.assertEqual(tuple(float(row[f"{axis}_m"]) for axis in "xyz"), place)
                self.assertTrue(np.allclose([float(row[f"{axis}_m_s"]) for axis in "uvw"], scene.wind.velocity(place), atol=1e-6))
        self.assertEqual([row["probe"] + row["point"] for row in probes[:4]], ["mast0", "lee0", "lee1", "lee2"])
        force = scene.wind.obstacles.force_on(scene.obstacle("house"))
        last = [row for row in forces if row["name"] == "house"][-1]
        self.assertTrue(np.allclose([float(last[f"f{axis}_n"]) for axis in "xyz"], force.force, rtol=1e-5, atol=1e-5))
        self.assertAlmostEqual(float(last["pressure_pa"]), force.pressure, places=4)
        self.assertEqual({row["name"] for row in forces}, {"house", "car"})
        self.assertLess(len([row for row in forces if row["name"] == "car"]), 6)

    def test_a_device_keeps_the_same(self):
        (self.folder / "s.json").write_text(json.dumps({
            "duration": 0.2, "frames_per_second": 10, "tick_hz": 30, "air": {"cells": [12, 8, 9], "ambient": [4, 0, 0]},
            "obstacles": [{"name": "house", "position": [1, 0, 0], "shape": {"block": {}}}]}), encoding="utf-8")
        kept = {}
        for backend in ("cpu", "vulkan"):
            code, said = self.run_command("--backend", backend, "--fields", "npz", "--probe", "lee=3,0,0", "--forces")
            if code == 3 or "built without" in said or "is not built in" in said:
                self.skipTest(said)
            self.assertEqual(code, 0, said)
            with np.load(self.folder / "out/wind_0002.npz") as arrays:
                kept[backend] = (arrays["velocity"], arrays["obstacle"], self.rows("probes.csv")[-1], self.rows("forces.csv")[-1])
        self.assertTrue(np.allclose(kept["cpu"][0], kept["vulkan"][0], atol=1e-4))
        self.assertTrue(kept["cpu"][1].any() and np.array_equal(kept["cpu"][1], kept["vulkan"][1]))
        for row in (2, 3):
            for name, value in kept["cpu"][row].items():
                other = kept["vulkan"][row][name]
                self.assertTrue(value == other or abs(float(value) - float(other)) < 1e-3 * max(1.0, abs(float(value))), name)

    def test_probes_that_do_not_fit(self):
        (self.folder / "s.json").write_text("{}", encoding="utf-8")
        for words in ("mast", "=1,2,3", "a,b=1,2,3", "m=1,2", "m=1,2,x", "m=1,2,3:4,5,6", "m=1,2,3:4,5,6:0", "m=1,2,1e13"):
            code, said = self.run_command("--probe", words)
            self.assertEqual(code, 2, said)
            self.assertIn("--probe", said)

    def test_flags_that_do_not_fit(self):
        (self.folder / "s.json").write_text("{}", encoding="utf-8")
        for words in ("fgb", "", "fga,"):
            code, said = self.run_command("--fields", words)
            self.assertEqual(code, 2, said)
            self.assertRegex(said, r"--fields (has|is)")


class OtherKeeping(unittest.TestCase):
    def sentence_of(self, call):
        with self.assertRaises(windrow.WindrowError) as caught:
            call()
        return str(caught.exception)

    def test_debug_lines_scenes_and_tiles_of_a_wind(self):
        wind = windrow.Wind(windrow.Config(cells=(12, 8, 10), boundaries=windrow.Boundaries.open_over_floor(), ambient=(3, 0, 0)))
        ends, kinds, speeds = wind.debug_lines(arrows=2, seconds=0.5)
        self.assertEqual((ends.shape, np.bincount(kinds, minlength=4).tolist()), ((24, 2, 3), [12, 0, 0, 12]))
        np.testing.assert_allclose(ends[12, 1] - ends[12, 0], (1.5, 0, 0), atol=1e-6)
        self.assertEqual(speeds[12], 3)
        self.assertIn("arrows is 257", self.sentence_of(lambda: wind.debug_lines(arrows=257)))
        with tempfile.TemporaryDirectory() as folder:
            wind.write_scene(f"{folder}/wind.json", duration=2)
            self.assertEqual(windrow.Scene(f"{folder}/wind.json").duration, 2)
            self.assertIn("$.duration is -1", self.sentence_of(lambda: wind.write_scene(f"{folder}/wind.json", duration=-1)))
        tile = windrow.GustTile(5)
        np.testing.assert_array_equal(windrow.GustTile.load(tile.save()).texels(), tile.texels())
        self.assertIn("not a Windrow gust tile", self.sentence_of(lambda: windrow.GustTile.load(b"x")))


if __name__ == "__main__":
    unittest.main()
