#!/usr/bin/env python3
"""check_shader_text_test.py --compiler glslangValidator: check_shader_text.py passes good text and finds planted faults."""
import pathlib
import sys
import tempfile
import unittest

import check_shader_text

COMPILER = "glslangValidator"

GOOD = {
    "ball.glsl": "#ifndef WINDROW_BALL\n#define WINDROW_BALL\nWINDROW_FN float ball(float s) { return max(0.0f, 1.0f - s * s); }\n#endif\n",
    "fan.glsl": '#ifndef WINDROW_FAN\n#define WINDROW_FAN\n#include "ball.glsl"\nWINDROW_FN float fan(vec3 x) { return ball(length(x)); }\n'
                "#endif\n",
}


class CheckShaderText(unittest.TestCase):
    def faults(self, **extra):
        with tempfile.TemporaryDirectory() as folder:
            numerics = pathlib.Path(folder) / "shaders" / "numerics"
            numerics.mkdir(parents=True)
            for name, text in {**GOOD, **{f"{key}.glsl": text for key, text in extra.items()}}.items():
                (numerics / name).write_text(text)
            count, faults = check_shader_text.check(COMPILER, numerics.parent)
            self.assertEqual(count, len(GOOD) + len(extra))
            return faults

    def test_good_text_passes(self):
        self.assertEqual(self.faults(), [])

    def test_text_that_only_cpp_reads_is_a_fault(self):
        faults = self.faults(jet="WINDROW_FN float jet(const vec3& x) { return x.x; }\n")
        self.assertEqual(len(faults), 1, faults)
        self.assertIn("jet.glsl alone", faults[0])

    def test_a_missing_include_is_a_fault(self):
        faults = self.faults(jet="WINDROW_FN float jet(float s) { return ball(s); }\n")
        self.assertEqual(len(faults), 1, faults)

    def test_two_files_that_clash_are_a_fault(self):
        faults = self.faults(jet="WINDROW_FN float ball(float s) { return s; }\n")
        self.assertEqual(len(faults), 1, faults)
        self.assertIn("together", faults[0])


if __name__ == "__main__":
    if "--compiler" in sys.argv:
        at = sys.argv.index("--compiler")
        COMPILER = sys.argv[at + 1]
        del sys.argv[at:at + 2]
    unittest.main()
