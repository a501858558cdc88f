#!/usr/bin/env python3
"""solved_test.py TOOLS: what captions say of the solver is in their scenes, and tools/solved.py finds what is not."""
import pathlib
import subprocess
import sys
import unittest

TOOLS = pathlib.Path(sys.argv.pop(1)).resolve()
sys.path.insert(0, str(TOOLS))
import solved  # noqa: E402

STILL = {"air": {"ambient": [3, 0, 4], "gusts": {"intensity": 0.3}}}
WALK = {"paths": {"way": {"points": [[0, 0, 0, 0], [2, 4, 0, 0]]}}, "picture": {"walkers": [{"path": "way"}]}}


class Solved(unittest.TestCase):
    def test_the_pages_and_scenes_keep_it(self):
        run = subprocess.run([sys.executable, "-B", TOOLS / "solved.py", "--check"], capture_output=True, text=True, check=False)
        self.assertEqual((run.returncode, run.stderr), (0, ""))

    def test_the_gallery_is_the_scenes(self):
        import make_gallery
        self.assertEqual(make_gallery.text(), make_gallery.PAGE.read_text(encoding="utf-8"), "run tools/make_gallery.py")

    def test_prescribed_wind_alone_is_nothing_solved(self):
        self.assertEqual(solved.solved(STILL), [])
        self.assertEqual(solved.sentence(STILL), "Solved: nothing. Prescribed: a mean wind of 5.0 m/s, gusts.")

    def test_each_part_is_named(self):
        scene = {"air": {"canopy": {"height": 0.5}, "roughness": {}}, "obstacles": [{}, {}],
                 "motors": [{"kind": "jet", "name": "fan"}, {"kind": "vortex"}, {"kind": "vortex"}, {"kind": "omni"}],
                 "picture": {"ground": {"in_air": True}}}
        self.assertEqual(solved.solved(scene), ["a jet (fan)", "2 vortices", "a source", "the drag of 0.5 m of plants", "the drag of rough ground",
                                                "the flow around 2 bodies", "the flow over the hills"])

    def test_wakes_of_bodies_are_those_of_the_program(self):
        self.assertEqual(solved.solved(WALK), ["the wake of the way"])
        off = {**WALK, "picture": {"walkers": [{"path": "way", "wake": False}]}}
        self.assertEqual(solved.solved(off), [])
        self.assertEqual(solved.solved({**WALK, "obstacles": [{"path": "way"}]}), ["the flow around a body"])
        self.assertEqual(solved.solved({**WALK, "motors": [{"kind": "wake", "path": "way"}]}), ["a wake"])
        self.assertEqual(solved.solved({**WALK, "paths": {"way": {"points": [[0, 1, 0, 1]]}}}), [])
        bare = {**WALK, "picture": {"bodies": [{"name": "wolf", "motion": {"path": "way"}}]}}
        self.assertEqual(solved.solved(bare), [])
        bare["picture"]["bodies"][0]["coats"] = [{}]
        self.assertEqual(solved.solved(bare), ["the wake of the wolf"])

    def test_false_claims_are_found(self):
        known = {"fur/bear.json": STILL, "fur/fan.json": {"motors": [{"kind": "jet"}]}}
        for page, count in (("| `fur/bear.json` in the air of the solver |", 1), ("| `bear.json` in the fluid; `fan.json` |", 1),
                            ("`fur/fan.json` in the solver; `fur/bear.json` in gusts", 0), ("`fur/bear.json`: nothing solved", 0)):
            self.assertEqual(len(list(solved.false_claims(page, "page", known))), count, page)


if __name__ == "__main__":
    unittest.main()
