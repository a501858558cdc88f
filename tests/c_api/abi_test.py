#!/usr/bin/env python3
"""abi_test.py ROOT --cmake PROGRAM --compiler PROGRAM --work DIR [--accept]: the binary interface of windrow::c, by abidiff.

Makes a library of the functions of the headers, which do nothing, and compares it with c_api/abi/libwindrow.abi. The library's own
sources compile against the same headers, and library_test.py compares their symbols, so its interface is this one. A copy of the
headers with one field more must be reported. --accept writes the file: after a change of the interface, with its line in CHANGELOG.md.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys

BREAK = ("config.h", "    float blend_width;", "    float deliberate_break;\n    float blend_width;")


def run(command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def must(command):
    code, said = run(command)
    if code != 0:
        sys.exit(f"{' '.join(map(str, command))} ends with {code}:\n{said}")
    return said


def library(args, headers, name):
    """A library with the interface of these headers, whose folder is named c_api."""
    source, out = args.work / f"{name}.cpp", args.work / f"{name}.so"
    script = args.work / f"{name}.cmake"
    files = " ".join(sorted(path.name for path in headers.glob("*.h")))
    script.write_text(f"cmake_minimum_required(VERSION 3.25)\ninclude({args.root}/c_api/stubs.cmake)\n"
                      f"windrow_c_write_stubs(nothing {headers} {source} {files})\n", encoding="utf-8")
    must([args.cmake, "-P", script])
    must([args.compiler, "-std=c++20", "-g", "-O0", "-shared", "-fPIC", "-fvisibility=hidden", "-I", headers.parent, "-I", args.root, source,
          "-o", out, f"-Wl,--version-script={args.root}/c_api/symbols.map"])
    return out


def interface(args, of):
    """What abidw says of a library, without the places of declarations: they are no part of the interface."""
    said = must(["abidw", "--headers-dir", args.root / "c_api", "--drop-private-types", "--no-corpus-path", "--no-comp-dir-path",
                 "--short-locs", of])
    said = re.sub(r" line='\d+' column='\d+'", " line='1' column='1'", said)
    return re.sub(r"'[\w/.]*\.cpp'", "'windrow.cpp'", said)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--cmake", default="cmake")
    parser.add_argument("--compiler", default="g++")
    parser.add_argument("--work", type=pathlib.Path, required=True)
    parser.add_argument("--accept", action="store_true")
    args = parser.parse_args()
    if shutil.which("abidiff") is None:
        sys.exit("abidiff is not installed: install abigail-tools")
    args.root = args.root.resolve()
    args.work.mkdir(parents=True, exist_ok=True)
    args.work = args.work.resolve()
    abi = args.root / "c_api" / "abi" / "libwindrow.abi"

    now = library(args, args.root / "c_api", "now")
    if args.accept:
        abi.write_text(interface(args, now), encoding="utf-8")
        print(f"{abi}: {len(abi.read_text(encoding='utf-8').splitlines())} lines")
    code, said = run(["abidiff", abi, now])
    print(f"abidiff of the file and the headers ends with {code}: {said.strip() or 'silent'}")
    faults = [] if code == 0 and not said.strip() else [
        "The binary interface changed. Where that was meant: tests/c_api/abi_test.py . --work build/abi --accept, and a line in CHANGELOG.md."]

    broken = args.work / "broken"
    shutil.rmtree(broken, ignore_errors=True)
    shutil.copytree(args.root / "c_api", broken / "c_api", ignore=shutil.ignore_patterns("source", "abi"))
    shutil.copytree(args.root / "fluid", broken / "fluid", ignore=shutil.ignore_patterns("*.cpp"))
    file = broken / "c_api" / BREAK[0]
    text = file.read_text(encoding="utf-8")
    if BREAK[1] not in text:
        faults.append(f"{BREAK[0]} has no '{BREAK[1]}' to break")
    file.write_text(text.replace(BREAK[1], BREAK[2], 1), encoding="utf-8")
    code, said = run(["abidiff", abi, library(args, broken / "c_api", "broken")])
    print(f"abidiff of the file and broken headers ends with {code}: {len(said.splitlines())} lines")
    if code == 0 or "deliberate_break" not in said:
        faults.append("A field in the midst of windrow_config is not reported.")
    print("\n".join(faults))
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
