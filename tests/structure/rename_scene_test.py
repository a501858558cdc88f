#!/usr/bin/env python3
"""tools/rename_scene.py: keys are renamed, everything else of a file stays, and no old name is a key of today."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOL = ROOT / "tools" / "rename_scene.py"
sys.path.insert(0, str(TOOL.parent))
import rename_scene


def keys_of(schema, found):
    if isinstance(schema, dict):
        found.update(schema.get("properties", {}))
        for value in schema.values():
            keys_of(value, found)
    elif isinstance(schema, list):
        for value in schema:
            keys_of(value, found)
    return found


class RenameScene(unittest.TestCase):
    def run_on(self, text):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "a.json"
            file.write_text(text, encoding="utf-8")
            done = subprocess.run([sys.executable, "-B", str(TOOL), str(file)], capture_output=True, text=True, check=False)
            return done, file.read_text(encoding="utf-8"), sorted(path.name for path in pathlib.Path(folder).iterdir())

    def test_keys_change_and_nothing_else(self):
        done, text, names = self.run_on('{"air": {\n  "sides" : {"y_low": {}},\t"rim": 3},\n "name": "sides", "list": ["rim"]}')
        self.assertEqual(text, '{"air": {\n  "boundaries" : {"y_low": {}},\t"blend_width": 3},\n "name": "sides", "list": ["rim"]}')
        self.assertEqual((done.returncode, names), (0, ["a.json"]))
        self.assertIn("2 keys renamed", done.stdout)

    def test_what_is_no_scene_stays(self):
        done, text, _ = self.run_on('{"sides": ')
        self.assertEqual((done.returncode, text), (2, '{"sides": '))
        self.assertIn("is not a scene", done.stderr)

    def test_old_and_new_names(self):
        keys = keys_of(json.loads((ROOT / "examples" / "scenes" / "scene.schema.json").read_text(encoding="utf-8")), set())
        names = rename_scene.renamed_keys()
        self.assertGreater(len(names), 10)
        self.assertEqual([old for old in names if old in keys], [], "an old name is a key of today")
        self.assertEqual([new for new in names.values() if new not in keys], [], "a new name is no key")


if __name__ == "__main__":
    unittest.main()
