#!/usr/bin/env python3
"""check_shader_text.py SHADERS --compiler glslangValidator [--root ROOT]: the formulas under SHADERS/numerics are GLSL.

ROOT is the folder from which includes "shaders/..." and "vegetation/shaders/..." count; default: the one that holds SHADERS.

Each file is compiled alone, so that it includes what it uses, and then all together, so that they do not clash. C++ compiles
the same text; here the macro WINDROW_FN, which marks a function for C++, is empty.
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile

SHADER = """#version 450
#extension GL_GOOGLE_include_directive : require
#define WINDROW_FN
{includes}
layout(local_size_x = 1) in;
void main() {{}}
"""


def compile_errors(compiler, shaders, root, files):
    """What the compiler says of a compute shader that includes these files; empty if all is well."""
    includes = "\n".join(f'#include "{file.relative_to(shaders).as_posix()}"' for file in files)
    with tempfile.TemporaryDirectory() as folder:
        shader = pathlib.Path(folder) / "all.comp"
        shader.write_text(SHADER.format(includes=includes))
        # As users do: the folder that holds numerics/ is an include folder, and so is the root.
        run = subprocess.run(
            [compiler, "--quiet", "-V", "--target-env", "vulkan1.2", f"-I{shaders}", f"-I{root}",
             "-o", str(shader.with_suffix(".spv")), str(shader)],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    return run.stdout.strip() or "the compiler failed without a word" if run.returncode else ""


def check(compiler, shaders, root=None):
    """The number of files and the faults of the files under shaders/numerics."""
    shaders = pathlib.Path(shaders).resolve()
    root = pathlib.Path(root).resolve() if root else shaders.parent
    files = sorted((shaders / "numerics").rglob("*.glsl"))
    faults = []
    for file in files:
        errors = compile_errors(compiler, shaders, root, [file])
        if errors:
            faults.append(f"{file.relative_to(shaders.parent)} alone:\n{errors}")
    if files and not faults:
        errors = compile_errors(compiler, shaders, root, files)
        if errors:
            faults.append(f"all {len(files)} files together:\n{errors}")
    return len(files), faults


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("shaders")
    parser.add_argument("--compiler", default="glslangValidator")
    parser.add_argument("--root")
    arguments = parser.parse_args()
    count, faults = check(arguments.compiler, arguments.shaders, arguments.root)
    print("\n\n".join([f"{count} files, {len(faults)} faults", *faults]))
    sys.exit(1 if faults or count == 0 else 0)


if __name__ == "__main__":
    main()
