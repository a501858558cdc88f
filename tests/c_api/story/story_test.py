#!/usr/bin/env python3
"""story_test.py --library FILE --cpp PROGRAM --c PROGRAM --work DIR

One story in C++, C, Python, C# and Rust, through the C library but in C++: each prints the hash of the wind that it leaves, and all are
equal. A language whose compiler is not installed is left out, with a sentence.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent.parent


def run(command, environment):
    done = subprocess.run([str(word) for word in command], env=environment, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} ends with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout.strip()


def main():
    parser = argparse.ArgumentParser()
    for name in ("library", "cpp", "c", "work"):
        parser.add_argument(f"--{name}", type=pathlib.Path, required=True)
    args = parser.parse_args()
    args.work.mkdir(parents=True, exist_ok=True)
    environment = dict(os.environ, LD_LIBRARY_PATH=str(args.library.parent), WINDROW_LIBRARY=str(args.library),
                       PYTHONPATH=str(ROOT / "bindings/python"))
    hashes = {"C++": run([args.cpp], environment), "C": run([args.c], environment),
              "Python": run([sys.executable, "-B", HERE / "story.py"], environment)}
    if shutil.which("mcs") and shutil.which("mono"):
        program = args.work / "story.exe"
        folder = ROOT / "examples/csharp"
        run(["mcs", "-warnaserror", f"-out:{program}", HERE / "Story.cs", folder / "Windrow.cs", *sorted((folder / "windrow_c").glob("*.cs"))],
            environment)
        hashes["C#"] = run(["mono", program], environment)
    else:
        print("C# is left out: install mono-mcs and mono-runtime")
    if shutil.which("rustc"):
        program = args.work / "story"
        run(["rustc", "--edition", "2021", "-D", "warnings", "-L", args.library.parent, "-o", program, HERE / "story.rs"], environment)
        hashes["Rust"] = run([program], environment)
    else:
        print("Rust is left out: install rustc")
    for language, value in hashes.items():
        print(f"{language}: {value}")
    if len(set(hashes.values())) != 1 or len(hashes["C++"]) != 16:
        sys.exit("the winds differ")


if __name__ == "__main__":
    main()
