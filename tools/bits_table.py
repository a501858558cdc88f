#!/usr/bin/env python3
"""bits_table.py [--page FILE] [NAME...]: plays the stories of tests/bits on every platform and prints a table of their hashes.

Each build is in build/bits/NAME: gcc and clang at -O1 and -O3 on this machine, MinGW-w64 run by Wine, GCC for ARM64 run by qemu. That
of WebAssembly, run by node, is ./dev web's. The
hash of a row is that of all hashes that a level gives, without those of snapshots, which hold the level's name. The last column
compares every hash, those too, with tests/bits/bits.txt. --page writes the table into FILE, between its two marks. The exit code is
1 where a platform differs.
"""
import argparse
import hashlib
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BEGIN, END = "<!-- made by ./dev bits -->\n", "<!-- end -->\n"
O1 = ("-DCMAKE_BUILD_TYPE=RelWithDebInfo", "-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O1 -DNDEBUG")
O3 = ("-DCMAKE_BUILD_TYPE=Release",)
STORIES_ALONE = ("-DWINDROW_FOREIGN_TESTS=OFF",)


def toolchain(name):
    return (f"-DCMAKE_TOOLCHAIN_FILE={ROOT}/cmake/toolchains/{name}.cmake",)


# Name, platform, compiler (its command), options.
BUILDS = (
    ("gcc-O1", "Linux x86-64", "GCC", "c++", " -O1", STORIES_ALONE + O1),
    ("gcc-O3", "Linux x86-64", "GCC", "c++", " -O3", STORIES_ALONE + O3),
    ("clang-O1", "Linux x86-64", "Clang", "clang++", " -O1", STORIES_ALONE + O1 + ("-DCMAKE_CXX_COMPILER=clang++",)),
    ("clang-O3", "Linux x86-64", "Clang", "clang++", " -O3", STORIES_ALONE + O3 + ("-DCMAKE_CXX_COMPILER=clang++",)),
    ("windows", "Windows x86-64 (Wine)", "MinGW-w64 GCC", "x86_64-w64-mingw32-g++-posix", " -O3", O3 + toolchain("windows")),
    ("arm64", "Linux ARM64 (qemu)", "GCC", "aarch64-linux-gnu-g++", " -O3", O3 + toolchain("arm64")),
    ("wasm", "WebAssembly (node)", "Emscripten Clang", "em++", " -Oz, SIMD", toolchain("emscripten")),
    ("wasm-plain", "WebAssembly (node)", "Emscripten Clang", "em++", " -Oz", toolchain("emscripten") + ("-DWINDROW_WASM_SIMD=OFF",)),
)
# Source and build of those that are not of tests/foreign.
ELSEWHERE = {"wasm": ("bindings/web", "build/web/simd"), "wasm-plain": ("bindings/web", "build/web/plain")}


def run(*command):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{done.stdout}\n{' '.join(str(word) for word in command)} ended with {done.returncode}")
    return done.stdout


def rows_of(text):
    return dict(line.split() for line in text.splitlines() if line.strip())


def hashes_of(name, options):
    source, build = ELSEWHERE.get(name, ("tests/foreign", f"build/bits/{name}"))
    folder = ROOT / build
    run("cmake", "-S", ROOT / source, "-B", folder, "-G", "Ninja", *options)
    run("cmake", "--build", folder, "--target", "windrow_hashes", "--parallel", os.environ.get("WINDROW_JOBS", os.cpu_count()))
    return rows_of((folder / "hashes.txt").read_text())


def table_of(names, pinned):
    lines = ["| platform | compiler | level | hash | pinned hashes |", "|---|---|---|---|---|"]
    differing = []
    for name, platform, family, command, level_of_code, options in BUILDS:
        if names and name not in names:
            continue
        found = hashes_of(name, options)
        version = run(command, "-dumpversion" if "Clang" in family else "-dumpfullversion").strip()
        compiler = f"{family} {version}{level_of_code}"
        for level in dict.fromkeys(key.split("/")[0] for key in found):
            rows = {key: value for key, value in found.items() if key.startswith(level + "/")}
            wanted = {key: value for key, value in pinned.items() if key.startswith(level + "/")}
            air = "".join(f"{key.partition('/')[2]} {rows[key]}\n" for key in sorted(rows) if "/snapshot" not in key)
            wrong = sorted(key for key in rows.keys() | wanted.keys() if rows.get(key) != wanted.get(key))
            differing += [f"{name}: {key} {rows.get(key, 'is missing')}, pinned {wanted.get(key, 'nowhere')}" for key in wrong]
            verdict = f"{len(rows)} equal" if not wrong else f"**{len(wrong)} of {len(wanted)} differ**"
            lines.append(f"| {platform} | {compiler} | {level} | `{hashlib.sha256(air.encode()).hexdigest()[:16]}` | {verdict} |")
            print(lines[-1], flush=True)
    return "\n".join(lines) + "\n", differing


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", choices=[[], *(build[0] for build in BUILDS)], metavar="NAME")
    parser.add_argument("--page", type=pathlib.Path)
    arguments = parser.parse_args()
    table, differing = table_of(arguments.names, rows_of((ROOT / "tests/bits/bits.txt").read_text()))
    if arguments.page:
        before, _, rest = arguments.page.read_text().partition(BEGIN)
        arguments.page.write_text(before + BEGIN + table + END + rest.partition(END)[2])
    print("\n".join(differing) if differing else "The same bits on all of them.")
    sys.exit(1 if differing else 0)


if __name__ == "__main__":
    main()
