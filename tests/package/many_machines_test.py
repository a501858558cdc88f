#!/usr/bin/env python3
"""many_machines_test.py SOURCE PROGRAMS: the scripts of docs/many_machines.md, run as the page has them, on two processes."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest


def script(word):
    """The block of the page whose comment begins with the word."""
    blocks = re.findall(r"\n```sh\n(.*?)```", (SOURCE / "docs/many_machines.md").read_text(encoding="utf-8"), re.DOTALL)
    return next(block for block in blocks if f"\n# {word}" in block)


class Scripts(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        # Things that swing, a wind that changes: what a frame keeps from those before it.
        (self.folder / "scene.json").write_text(json.dumps(
            {"duration": 2, "frames_per_second": 4, "floor": 0,
             "air": {"cells": [16, 8, 16], "ambient": [6, 0, 0], "gusts": {"intensity": 0.3, "length": 12}, "boundaries": {"y_low": "free_slip"}},
             "motors": [{"kind": "directional", "position": [0, 1, 0], "law": {"drive": {"speed": 8, "rate": 8}}}],
             "picture": {"size": [64, 36], "warm_up": 0, "grass": [{}], "camera": {"position": [0, 2, 6]}}}))

    def run_words(self, *words, **variables):
        environment = {**os.environ, "PATH": f"{PROGRAMS}:{os.environ['PATH']}", **variables}
        run = subprocess.run([str(word) for word in words], cwd=self.folder, env=environment, check=False, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, text=True)
        self.assertEqual(run.returncode, 0, run.stdout)
        return run.stdout

    def bytes_in(self, folder, pattern):
        return {file.name: file.read_bytes() for file in (self.folder / folder).glob(pattern)}

    def write(self, word):
        (self.folder / "script.sh").write_text(script(word))

    def test_parts_by_gnu_parallel_are_the_film_of_one_process(self):
        if shutil.which("parallel") is None:
            self.skipTest("GNU parallel is not installed: apt-get install parallel")
        self.write("GNU parallel")
        self.run_words("sh", "script.sh", "scene.json", "parts", 2)
        self.run_words("windrow-draw", "scene.json", "--out", "whole", "--film", "whole.webp")
        whole = self.bytes_in("whole", "*.png")
        self.assertEqual(len(whole), 9 + 1)
        self.assertGreater(len(set(whole.values())), 8, "frames differ")
        self.assertEqual(self.bytes_in("parts", "*.png"), whole)
        self.assertEqual((self.folder / "parts/film.webp").read_bytes(), (self.folder / "whole.webp").read_bytes())
        for folder in "parts", "whole":
            rows = (self.folder / folder / "times.csv").read_text().splitlines()
            self.assertEqual([row.split(",")[0] for row in rows], ["frame", *map(str, range(9))])

    def test_a_slurm_array_draws_each_part_once(self):
        self.write("Slurm: one task")
        for task in 2, 1:
            said = self.run_words("sh", "script.sh", "scene.json", "parts", SLURM_ARRAY_TASK_ID=str(task), SLURM_ARRAY_TASK_COUNT="2")
            self.assertIn(f": {[4, 5][task - 1]} pictures of 64 x 36", said)
        self.assertEqual(len(self.bytes_in("parts", "frame_*.png")), 9)
        # A picture that is missing is drawn by its part, and found by --join.
        (self.folder / "parts/frame_0006.png").unlink()
        run = subprocess.run([PROGRAMS / "windrow-draw", "scene.json", "--out", "parts", "--join"], cwd=self.folder, check=False,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual((run.returncode, run.stdout),
                         (2, "windrow-draw: parts/frame_0006.png is missing: draw the part that has this frame, with --part, before --join.\n"))

    def test_wrong_parts_are_rejected(self):
        for words, sentence in ((("--part", "3/2"), '--part is "3/2": give K/N, part K of N, such as 1/8; N is 10000 at most.'),
                                (("--part", "1/2", "--join"), "--join is made of all parts: give it without --part, once they are drawn."),
                                (("--part", "1/2", "--film", "a.webp"),
                                 "--film is made of all parts: give it without --part, once they are drawn."),
                                (("--join", "--resume"), "--join draws nothing that --resume could go on with: drop one of them.")):
            run = subprocess.run([PROGRAMS / "windrow-draw", "scene.json", *words], cwd=self.folder, check=False,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            self.assertEqual((run.returncode, run.stdout), (2, f"windrow-draw: {sentence}\n"))

    def test_a_slurm_run_goes_on(self):
        self.write("Slurm: a run")
        self.run_words("sh", "script.sh", "scene.json", "out")
        self.assertEqual(len(self.bytes_in("out", "vel_*.vdb")), 9)
        self.assertFalse((self.folder / "out/run.snapshot").exists())

    def test_fuzzing_of_two_machines_joins(self):
        """Two folders with the counts of a parser each, and one with the same again."""
        for name, text in (("here", "scene,fuzz,10,5,50.0,1.0,10"), ("there", "scene,fuzz,30,5,16.7,2.0,15\nobj,fuzz,7,7,100.0,1.0,7")):
            corpus = self.folder / name / "build/fuzz-corpus"
            (corpus / "scene").mkdir(parents=True)
            (corpus / "scene" / f"input_of_{name}").write_text(name)
            (corpus / "counts.csv").write_text("parser,preset,executions,accepted,accepted_percent,seconds,per_second\n" + text + "\n")
        (self.folder / "there/build/fuzz-findings").mkdir()
        (self.folder / "there/build/fuzz-findings/obj-crash-1").write_text("x")
        (self.folder / "here/tools").mkdir()
        shutil.copy(SOURCE / "tools/fuzz.py", self.folder / "here/tools")
        join = [sys.executable, "-B", "here/tools/fuzz.py", "fuzz", "--join", "there/build"]
        said = self.run_words(*join)
        self.assertIn("there/build: 2 inputs and the counts of 2 rows", said)
        self.assertEqual((self.folder / "here/build/fuzz-corpus/counts.csv").read_text().splitlines()[1:],
                         ["obj,fuzz,7,7,100.0,1.0,7", "scene,fuzz,40,10,25.0,3.0,13"])
        self.assertTrue((self.folder / "here/build/fuzz-corpus/scene/input_of_there").is_file())
        self.assertTrue((self.folder / "here/build/fuzz-findings/obj-crash-1").is_file())
        again = subprocess.run(join, cwd=self.folder, check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual((again.returncode, again.stdout), (2, "fuzz.py: there/build was joined before: its counts would be added twice\n"))


if __name__ == "__main__":
    SOURCE, PROGRAMS = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    unittest.main(argv=sys.argv[:1])
