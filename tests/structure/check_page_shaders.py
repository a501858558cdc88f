#!/usr/bin/env python3
"""check_page_shaders.py --compiler glslangValidator: each shader of the page is GLSL ES 3.00, with the formulas that it includes.

A formula that takes another argument than the page gives is found here; the page itself is opened by ./dev test all alone.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))
from make_web import shader_texts


def assembled(texts, name, seen):
    """As bindings/web/page/gl.js does it: each include once."""
    seen.add(name)
    return re.sub(r'^#include "(.*)"$', lambda found: "" if found.group(1) in seen else assembled(texts, found.group(1), seen),
                  texts[name], flags=re.MULTILINE)


def faults(texts, compiler):
    """One for each shader that does not compile."""
    with tempfile.TemporaryDirectory() as folder:
        for name in texts:
            if name.endswith((".vert", ".frag")):
                file = pathlib.Path(folder) / name
                file.write_text(assembled(texts, name, set()), encoding="utf-8")
                done = subprocess.run([compiler, file], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
                if done.returncode != 0:
                    yield f"bindings/web/page/shaders/{name}:\n{done.stdout}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--compiler", required=True)
    arguments = parser.parse_args()
    texts = shader_texts()
    found = list(faults(texts, arguments.compiler))
    # A formula with one argument more must be found.
    wrong = {**texts, "blade.vert": texts["blade.vert"].replace("windrow_grass_row(", "windrow_grass_row(0, ", 1)}
    if not list(faults({name: text for name, text in wrong.items() if name == "blade.vert" or not name.endswith((".vert", ".frag"))},
                       arguments.compiler)):
        found.append("a call with an argument too many is not found")
    print("\n".join(found) or f"{sum(name.endswith(('.vert', '.frag')) for name in texts)} shaders of the page compile")
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
