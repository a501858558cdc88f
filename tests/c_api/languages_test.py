#!/usr/bin/env python3
"""languages_test.py LANGUAGE --examples DIR --library FILE --truth PROGRAM --c PROGRAM --work DIR

Compiles and runs the example of a language against the shared library. It must print the line that the README's program prints, and
end with 2 and the library's sentence where a setting is wrong (argument `wrong`).
"""
import argparse
import ctypes
import os
import pathlib
import shutil
import subprocess
import sys


def run(command, **options):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    return done.returncode, done.stdout, done.stderr


def build(command):
    code, out, err = run(command)
    if code != 0:
        sys.exit(f"{' '.join(map(str, command))} ends with {code}:\n{out}{err}")


def tool(name, package):
    path = shutil.which(name)
    if path is None:
        sys.exit(f"{name} is not installed: install {package}")
    return path


def example(language, args):
    """The command that runs the example."""
    if language == "c":
        return [args.c]
    if language == "python":
        return [sys.executable, "-B", args.examples / "python" / "follow_player.py"]
    if language == "csharp":
        program = args.work / "follow_player.exe"
        build([tool("mcs", "mono-mcs"), "-warnaserror", f"-out:{program}", *sorted((args.examples / "csharp").rglob("*.cs"))])
        return [tool("mono", "mono-runtime"), program]
    program = args.work / "follow_player"
    build([tool("rustc", "rustc"), "--edition", "2021", "-D", "warnings", "-O", "-L", args.library.parent, "-o", program,
           args.examples / "rust" / "windrow.rs"])
    return [program]


def check_csharp_layout(args):
    """Each struct of C# is laid out as that of Python, which bindings_test.py compares with C."""
    program = args.work / "layout.exe"
    sources = [path for path in (args.examples / "csharp").rglob("*.cs") if path.name != "FollowPlayer.cs"]
    build([tool("mcs", "mono-mcs"), "-warnaserror", f"-out:{program}", pathlib.Path(__file__).with_name("Layout.cs"), *sources])
    sys.path.insert(0, str(args.examples.parent / "bindings/python/windrow"))
    import _c
    structs = [kind for kind in vars(_c).values() if isinstance(kind, type) and issubclass(kind, ctypes.Structure)]
    expected = {f"{kind.__name__} {ctypes.sizeof(kind)} " + " ".join(str(getattr(kind, name).offset) for name, _ in kind._fields_)
                for kind in structs}
    said = set(run([tool("mono", "mono-runtime"), program])[1].splitlines())
    if said != expected or len(said) < 90:
        sys.exit(f"structs of C# are laid out otherwise: {sorted(said ^ expected)}")
    print(f"{len(said)} structs of C# are laid out as those of Python")


def check_csharp_axes(args, environment):
    """A host in an engine's axes and unit: windrow_set_axes against the files that engines read."""
    program = args.work / "engines.exe"
    sources = [path for path in (args.examples / "csharp").rglob("*.cs") if path.name != "FollowPlayer.cs"]
    build([tool("mcs", "mono-mcs"), "-warnaserror", f"-out:{program}", pathlib.Path(__file__).with_name("Engines.cs"), *sources])
    code, out, err = run([tool("mono", "mono-runtime"), program, args.work], env=environment)
    print(out, end="")
    if code != 0 or out.count("well: ") != 8:
        sys.exit(f"engines.exe ends with {code}: {err}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("language", choices=("c", "python", "csharp", "rust"))
    for name in ("examples", "library", "truth", "c", "work"):
        parser.add_argument(f"--{name}", type=pathlib.Path, required=True)
    args = parser.parse_args()
    args.work.mkdir(parents=True, exist_ok=True)
    environment = dict(os.environ, LD_LIBRARY_PATH=str(args.library.parent), WINDROW_LIBRARY=str(args.library),
                       PYTHONPATH=str(args.examples.parent / "bindings/python"))

    truth = run([args.truth])
    command = example(args.language, args)
    said = run(command, env=environment)
    print(f"C++: {truth[1].strip()}; {args.language}: {said[1].strip()}")
    if truth[0] != 0 or " m/s at the leaf" not in truth[1] or said[:2] != truth[:2]:
        sys.exit(f"{args.language} ends with {said[0]}: {said[1]}{said[2]}")
    if args.language != "c":  # which keeps to the ten lines
        wrong = run([*command, "wrong"], env=environment)
        if wrong[0] != 2 or "cell_size is -1" not in wrong[2]:
            sys.exit(f"a wrong setting ends with {wrong[0]}, not with 2 and the sentence: {wrong[1]}{wrong[2]}")
        print(f"a wrong setting: {wrong[2].strip()}")
    if args.language == "csharp":
        check_csharp_layout(args)
        check_csharp_axes(args, environment)


if __name__ == "__main__":
    main()
