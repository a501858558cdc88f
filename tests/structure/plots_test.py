#!/usr/bin/env python3
"""tools/plots.py on small CSV files: fronts, labels, what it prints without matplotlib, and its pictures where matplotlib is."""
import contextlib
import importlib.util
import io
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "tools"))
import plots  # noqa: E402

PARETO = """backend,scheme,advection,pressure,grid,cfl,case,error,order,step_ms,cost_vs_stam40,threads,ms_per_second,machine
cpu,second_order,cubic,direct,8x4x8,1,jet,0.1,,1,1,2,10,"a < b & c, best"
cpu,second_order,cubic,direct,16x8x16,1,jet,0.02,2.3,8,1,2,160,"a < b & c, best"
cpu,stable_fluids,linear,jacobi20,16x8x16,1,jet,inf,,4,1,2,80,"a < b & c, best"
"""


def run(*arguments):
    """Exit code and stderr of the script."""
    err = io.StringIO()
    with mock.patch.object(sys, "argv", ["plots.py", *map(str, arguments)]), contextlib.redirect_stderr(err), \
            contextlib.redirect_stdout(io.StringIO()):
        return plots.main(), err.getvalue()


class Plots(unittest.TestCase):
    def test_a_front_holds_what_nothing_beats(self):
        points = [(1, 5), (2, 5), (2, 3), (2, 3), (3, 4), (4, float("nan")), (5, 1), (6, float("inf"))]
        self.assertEqual(plots.front_of(points), [0, 2, 3, 6])

    def test_labels_stay_in_their_room_and_apart(self):
        labels = plots.Labels((0, 0, 600, 400))
        for n in range(12):  # a crowded front, to the corner of the room
            labels.find("64x32x64, CFL 1", 150 + 36 * n, 320 - 25 * n)
        taken = [thing[:4] for thing in labels.things]
        self.assertEqual(len(taken), 12)
        for n, (left, low, right, high) in enumerate(taken):
            self.assertTrue(left >= -2 and low >= -2 and right <= 602 and high <= 402, n)
            for other in taken[:n]:
                self.assertTrue(right - 2 <= other[0] + 2 or other[2] - 2 <= left + 2 or
                                high - 2 <= other[1] + 2 or other[3] - 2 <= low + 2, n)

    def test_a_folder_without_figures_is_wrong_use(self):
        with tempfile.TemporaryDirectory() as folder:
            code, err = run(folder)
        self.assertEqual(code, 2)
        self.assertIn("run windrow pareto, plants or verify --plots first.", err)

    def test_without_matplotlib_a_sentence_says_where_the_figures_are(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "pareto.csv")
            file.write_text(PARETO, encoding="utf-8")
            with mock.patch.dict(sys.modules, {"matplotlib": None}):
                code, err = run(folder)
        self.assertEqual(code, 3)
        self.assertEqual(err, f"plots: the figures are in {file}; install python3-matplotlib to have them drawn.\n")

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "python3-matplotlib is not installed")
    def test_each_file_becomes_its_pictures(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "pareto.csv").write_text(PARETO, encoding="utf-8")
            rows = ["bend,,grass", "blades,bent,0.5", "blades,translated,0.5", "shells,stems,shell 0", "shells,stems,strand 0",
                    "spring,,1000 Hz", "spring,,15 Hz", 'cascade,,"20 shells, lerp per frame"']
            head = "plot,panel,line,x,y\n"
            (folder / "plants.csv").write_text(head + "".join(f"{row},0,0\n{row},1,0.5\n" for row in rows), encoding="utf-8")
            (folder / "jet_spreading.csv").write_text(head + "jet_spreading,mean,2.5 cells a radius,1,1\n", encoding="utf-8")
            self.assertEqual(run(folder, "--to", folder), (0, ""))
            for plot in ("pareto.svg", "pareto.png", "bend.svg", "blades.svg", "shells.svg", "spring.svg", "cascade.svg", "jets.svg"):
                self.assertGreater((folder / plot).stat().st_size, 1000, plot)
            fronts = (folder / "pareto.svg").read_text(encoding="utf-8")
            for words in ("computing time for one second of flow (2 threads)", "error of the velocity at the end", "16x8x16, CFL 1",
                          "second-order step, cubic advection", "multigrid, 2 cycles", "a &lt; b &amp; c, best."):
                self.assertIn(words, fronts)


if __name__ == "__main__":
    unittest.main()
