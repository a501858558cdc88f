#!/usr/bin/env python3
"""check_languages.py ROOT --compiler glslangValidator --cross spirv-cross --dis spirv-dis: the wind's include in other languages.

HLSL: shaders/coupling/windrow_wind.hlsl and each examples/shaders/*.hlsl compile (glslangValidator -D), and the block lies as in
GLSL under HLSL's own packing rules. MSL: what spirv-cross makes of windrow_wind.glsl in a vertex shader holds nothing that Metal
rejects (msl_faults.py). Nothing here runs a compiler of Metal or DXC.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

from msl_faults import msl_faults

DEFINES = ([], ["WINDROW_EXACT"], ["WINDROW_THREE_TEXTURES"], ["WINDROW_EXACT", "WINDROW_THREE_TEXTURES"])
GLSL = """#version 450
#extension GL_GOOGLE_include_directive : require
{defines}
#include "coupling/windrow_wind.glsl"
layout(location = 0) in vec3 place;
layout(location = 0) out vec3 before;
layout(location = 1) out vec3 felt;
void main() {{
    vec3 u = windrow_velocity(place);
    before = windrow_velocity_previous(place);
    felt = windrow_apparent(u, place, vec3(1.0, 0.0, 0.0)) + windrow_apparent_previous(before, place, vec3(0.0));
    gl_Position = vec4(u, 1.0);
}}
"""
HLSL = """{defines}
#include "coupling/windrow_wind.hlsl"
float4 main(float3 place : POSITION0, out float3 before : TEXCOORD0, out float3 felt : TEXCOORD1) : SV_Position {{
    float3 u = windrow_velocity(place);
    before = windrow_velocity_previous(place);
    felt = windrow_apparent(u, place, float3(1.0f, 0.0f, 0.0f)) + windrow_apparent_previous(before, place, float3(0.0f, 0.0f, 0.0f));
    return float4(u, 1.0f);
}}
"""
BLOCK = ("WindrowWindow", "WindrowAmbient", "WindrowFrame")


def ran(command):
    """Output of a command and whether it succeeded."""
    run = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    return run.stdout, run.returncode == 0


class Tools:
    def __init__(self, compiler, cross, dis, shaders, folder):
        self.compiler, self.cross, self.dis, self.shaders, self.folder = compiler, cross, dis, shaders, pathlib.Path(folder)
        self.spirv = self.folder / "shader.spv"

    def compiled(self, source, *options):
        """What the compiler says against a shader, a file or a text that begins with its stage; empty if all is well."""
        if isinstance(source, tuple):
            name, text = source
            source = self.folder / name
            source.write_text(text)
        language = ["-D", "-e", "main"] if source.suffix == ".hlsl" else []
        said, done = ran([self.compiler, "--quiet", "-V", *language, *options, "--target-env", "vulkan1.1", f"-I{self.shaders}",
                          "-o", self.spirv, source])
        return "" if done else said.strip() or "the compiler failed without a word"

    def offsets(self):
        """{(struct, member): offset} of the wind's block in the shader compiled last."""
        text, _ = ran([self.dis, "--no-color", self.spirv])
        names = {(struct, number): name for struct, number, name in re.findall(r'OpMemberName %(\w+) (\d+) "(\w+)"', text)}
        found = {}
        for struct, number, offset in re.findall(r"OpMemberDecorate %(\w+) (\d+) Offset (\d+)", text):
            name = re.sub(r"_\d+$", "", struct)
            if name in BLOCK:
                found[name, names[struct, number]] = int(offset)
        return found

    def msl(self):
        """MSL 2.1 of the shader compiled last, and whether there is one."""
        return ran([self.cross, "--msl", "--msl-version", "20100", self.spirv])


def check(root, compiler="glslangValidator", cross="spirv-cross", dis="spirv-dis"):
    """The number of shaders and their faults."""
    root = pathlib.Path(root).resolve()
    with tempfile.TemporaryDirectory() as folder:
        return faults_of(root, Tools(compiler, cross, dis, root / "shaders", folder))


def faults_of(root, tools):
    faults, count, layouts = [], 0, {}

    def compiles(name, source, *options):
        nonlocal count
        count += 1
        said = tools.compiled(source, *options)
        if said:
            faults.append(f"{name}:\n{said}")
        return not said

    for names in DEFINES:
        defines = "\n".join(f"#define {name}" for name in names)
        title = f"windrow_wind.glsl {' '.join(names)}".strip()
        if compiles(title, ("wind.vert", GLSL.format(defines=defines))):
            layouts[title] = tools.offsets()
            text, made = tools.msl()
            faults.extend(f"{title} as MSL: {fault}" for fault in (msl_faults(text) if made else [text.strip()]))
        if "WINDROW_THREE_TEXTURES" in names: # HLSL has one texture
            continue
        title = title.replace(".glsl", ".hlsl")
        if compiles(title, ("wind.vert.hlsl", HLSL.format(defines=defines)), "--hlsl-offsets"):
            layouts[title] = tools.offsets()
    for file in sorted((root / "examples" / "shaders").glob("*.hlsl")):
        compiles(file.relative_to(root).as_posix(), file)
    for title, layout in layouts.items():
        if layout != layouts.get("windrow_wind.glsl") or not layout:
            faults.append(f"{title}: the block lies otherwise than in windrow_wind.glsl")
    return count, faults


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("root")
    parser.add_argument("--compiler", default="glslangValidator")
    parser.add_argument("--cross", default="spirv-cross")
    parser.add_argument("--dis", default="spirv-dis")
    arguments = parser.parse_args()
    count, faults = check(arguments.root, arguments.compiler, arguments.cross, arguments.dis)
    print("\n".join([f"{count} shaders, {len(faults)} faults", *faults]))
    sys.exit(1 if faults or count == 0 else 0)


if __name__ == "__main__":
    main()
