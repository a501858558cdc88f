#!/usr/bin/env python3
"""check_languages_test.py ROOT --compiler glslangValidator --cross spirv-cross --dis spirv-dis: planted faults are found."""
import pathlib
import shutil
import sys
import tempfile
import unittest

import check_languages
from msl_faults import msl_faults

ROOT, TOOLS = ".", {}

GOOD = """#include <metal_stdlib>
using namespace metal;

constant uint lanes_tmp [[function_constant(0)]];
constant uint lanes = is_function_constant_defined(lanes_tmp) ? lanes_tmp : 4u;

struct Window
{
    float3 origin;
    float cell_size;
};

struct main0_out
{
    float3 before [[user(locn0)]];
    float4 gl_Position [[position]];
};

static inline __attribute__((always_inline))
float3 at(thread const Window& window, thread const float3& p)
{
    return (p - window.origin) / float3(window.cell_size);
}

static inline __attribute__((always_inline))
float3 wind(texture3d<float> volume, sampler volumeSmplr, constant Window& block, thread const float3& p)
{
    Window copy;
    copy.origin = block.origin;
    float3 local = at(copy, p);
    return volume.sample(volumeSmplr, clamp(local, float3(0.0), float3(1.0)), level(0.0)).xyz;
}

vertex main0_out main0(constant Window& block [[buffer(0)]], texture3d<float> volume [[texture(0)]], sampler volumeSmplr [[sampler(0)]])
{
    main0_out out = {};
    float3 p = float3(1.0);
    out.before = wind(volume, volumeSmplr, block, p);
    out.gl_Position = float4(out.before, 1.0);
    return out;
}
"""

# What is replaced, by what, and a word of the fault.
PLANTED = [
    ("float3 p = float3(1.0);", "double p = 1.0;", "64-bit"),
    ("float cell_size;", "unsupported-built-in-type cell_size;", "could not say"),
    ("copy.origin = block.origin;", "spvArrayCopyFromConstantToStack1(copy, block);", "between address spaces"),
    ("    Window copy;", "    spvUnsafeArray<float, 2> copy;", "as a value"),
    ("float cell_size;", "float cell_size[];", "without a size"),
    ("float cell_size;", "float cell_size[0];", "no elements"),
    ("float3 local = at(copy, p);", "float3 local = as_type<float3>(int(p.x) & (-2147483648));", "bit cast"),
    ("float3 local = at(copy, p);", "float3 local = dfdx(p);", "derivative"),
    ("    Window copy;", "    float lines[lanes];\n    Window copy;", "function constant"),
    ("float3 local = at(copy, p);", "float3 vertex = at(copy, p);", "word of MSL"),
    ("return (p - window.origin)", "return at(window, p)", "calls itself"),
    ("thread const float3& p)\n{\n    return", "const float3& p)\n{\n    return", "no address space"),
    ("at(copy, p)", "at(block, p)", "is in constant"),
    ("clamp(local,", "mod(local,", "neither defined"),
    (", level(0.0))", ")", "without a level"),
    ("texture3d<float> volume [[texture(0)]]", "texture3d<float> volume [[texture(0)]], texture3d<float> other [[texture(0)]]",
     "taken twice"),
    ("float3 before [[user(locn0)]];", "bool before [[user(locn0)]];", "between stages"),
    ("vertex main0_out main0(", "main0_out main0(", "no entry point"),
]


class CheckLanguages(unittest.TestCase):
    def test_good_msl_passes(self):
        self.assertEqual(msl_faults(GOOD), [])

    def test_each_planted_fault_of_msl_is_found(self):
        for old, new, word in PLANTED:
            with self.subTest(word):
                self.assertEqual(GOOD.count(old), 1, old)
                faults = msl_faults(GOOD.replace(old, new))
                self.assertTrue(any(word in fault for fault in faults), faults)

    def faults_of(self, file, old, new):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            shutil.copytree(pathlib.Path(ROOT) / "shaders", root / "shaders")
            text = (root / file).read_text()
            self.assertEqual(text.count(old), 1, old)
            (root / file).write_text(text.replace(old, new))
            return " ".join(check_languages.check(root, **TOOLS)[1])

    def test_a_function_that_hlsl_lacks_is_a_fault(self):
        faults = self.faults_of("shaders/coupling/windrow_sampling.glsl", "wind = outside + share * (wind - outside);",
                                "wind = mix(outside, wind, share);")
        self.assertIn("windrow_wind.hlsl", faults)
        self.assertNotIn("windrow_wind.glsl", faults)

    def test_a_block_that_hlsl_packs_otherwise_is_a_fault(self):
        faults = self.faults_of("shaders/coupling/windrow_sampling.glsl", "    vec3 previous_blend_centre;\n",
                                "    float odd[2];\n    float next;\n    vec3 previous_blend_centre;\n")
        self.assertIn("the block lies otherwise", faults)


if __name__ == "__main__":
    for name in ("compiler", "cross", "dis"):
        if f"--{name}" in sys.argv:
            at = sys.argv.index(f"--{name}")
            TOOLS[name] = sys.argv[at + 1]
            del sys.argv[at:at + 2]
    ROOT = sys.argv.pop(1) if len(sys.argv) > 1 else ROOT
    unittest.main()
