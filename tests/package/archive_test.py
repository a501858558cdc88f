#!/usr/bin/env python3
"""archive_test.py ROOT --work DIR --cxx COMPILER --cc COMPILER: makes the archives of this machine and uses them as one who has nothing else.

Unpacked, README's program in C++ and that of docs/c_api.md in C compile and run with what is there, by CMake too; the command plays a
scene; the Debian package has the same; the list of parts names what is compiled in; equal files make equal archives.
"""
import argparse
import hashlib
import json
import os
import pathlib
import re
import shutil
import sys
import tarfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "tools"))
from make_wheel import run

CMAKE = """cmake_minimum_required(VERSION 3.25)
project(game LANGUAGES CXX)
find_package(windrow 0.1 REQUIRED COMPONENTS fluid)
add_executable(game game.cpp)
target_link_libraries(game PRIVATE windrow::fluid)
"""


def expect(holds, sentence):
    if not holds:
        sys.exit(sentence)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("root", type=pathlib.Path)
    for name in ("work", "cxx", "cc"):
        parser.add_argument(f"--{name}", type=pathlib.Path, required=True)
    args = parser.parse_args()
    root, work = args.root.resolve(), args.work.resolve()
    shutil.rmtree(work, ignore_errors=True)
    for name in ("first", "second"):
        run([sys.executable, "-B", root / "tools/make_package.py", "--out", work / name])
    sums = (work / "first/SHA256SUMS").read_text(encoding="utf-8")
    expect(sums == (work / "second/SHA256SUMS").read_text(encoding="utf-8"), "two archives of the same files differ")
    for line in sums.splitlines():
        digest, name = line.split()
        expect(hashlib.sha256((work / "first" / name).read_bytes()).hexdigest() == digest, f"{name} is not what SHA256SUMS says")

    with tarfile.open(next((work / "first").glob("*.tar.gz"))) as archive:
        archive.extractall(work)
    there = next(work.glob("windrow-*"))
    leaks = [path for path in there.rglob("*") if path.is_file() and path.suffix in (".cmake", ".pc", ".h", ".json") and
             str(root) in path.read_text(encoding="utf-8", errors="replace")]
    expect(not leaks, f"{leaks} names the folder of the sources")

    # C++: README's program, by pkg-config and by CMake. GLM is the archive's own.
    program = work / "game"
    program.mkdir()
    cpp = re.search(r"\n```cpp\n(#include.*?)```", (root / "README.md").read_text(encoding="utf-8"), re.DOTALL).group(1)
    (program / "game.cpp").write_text(cpp, encoding="utf-8")
    (program / "CMakeLists.txt").write_text(CMAKE, encoding="utf-8")
    environment = dict(os.environ, PKG_CONFIG_PATH=str(there / "lib/pkgconfig"))
    flags = run(["pkg-config", "--cflags", "--libs", "windrow-fluid"], env=environment).split()
    run([args.cxx, "-std=c++20", program / "game.cpp", *flags, "-o", program / "by_hand"])
    run(["cmake", "-S", program, "-B", program / "build", f"-DCMAKE_PREFIX_PATH={there}", f"-DCMAKE_CXX_COMPILER={args.cxx}",
         "-DCMAKE_BUILD_TYPE=Release"])
    expect(f"glm_DIR:PATH={there}" in (program / "build/CMakeCache.txt").read_text(encoding="utf-8"), "CMake took another GLM")
    run(["cmake", "--build", program / "build"])
    # C: the program of docs/c_api.md.
    c = re.search(r"```c\n(#include <windrow/windrow.h>.*?)```", (root / "docs/c_api.md").read_text(encoding="utf-8"), re.DOTALL).group(1)
    (program / "game.c").write_text(c, encoding="utf-8")
    run([args.cc, "-std=c99", program / "game.c", f"-I{there}/include", f"-L{there}/lib", "-lwindrow", f"-Wl,-rpath,{there}/lib", "-o",
         program / "in_c"])
    for name in ("by_hand", "build/game", "in_c"):
        said = run([program / name])
        expect(name == "in_c" or said == "3.19 m/s at the leaf\n", f"README's program prints {said}")

    # The command and its scenes, in the archive and in the Debian package.
    run(["dpkg-deb", "--extract", next((work / "first").glob("*.deb")), work / "deb"])
    for tree in (there, work / "deb/usr"):
        said = run(["env", "-i", tree / "bin/windrow", "run", tree / "share/windrow/scenes/walk.json", "--csv", "--out", work / "out"])
        expect("timings.csv" in said, f"the command says {said}")
        needed = run(["readelf", "-d", tree / "bin/windrow", tree / "lib/libwindrow.so"])
        others = set(re.findall(r"\(NEEDED\).*\[(.*)\]", needed)) - {"libc.so.6", "libm.so.6", "ld-linux-x86-64.so.2"}
        expect(not others, f"what is in {tree} needs {sorted(others)}")
        symbols = run(["readelf", "-W", "--dyn-syms", tree / "bin/windrow", tree / "lib/libwindrow.so"])
        newest = max(tuple(map(int, found)) for found in re.findall(r"GLIBC_(\d+)\.(\d+)", symbols))
        expect(newest <= (2, 34), f"what is in {tree} needs glibc {newest}")
    expect("libc6 (>= 2.34)" in run(["dpkg-deb", "--field", next((work / "first").glob("*.deb")), "Depends"]), "the package depends on less")

    parts = json.loads((there / "sbom.spdx.json").read_text(encoding="utf-8"))
    ids = [package["SPDXID"] for package in parts["packages"]]
    expect(parts["spdxVersion"] == "SPDX-2.3" and len(set(ids)) == len(ids) >= 6, "sbom.spdx.json lacks parts")
    expect({relation["relatedSpdxElement"] for relation in parts["relationships"]} == set(ids), "sbom.spdx.json has parts of nothing")
    sizes = {path.name: path.stat().st_size for path in sorted((work / "first").glob("windrow*"))}
    print("\n".join(f"{name}: {size} bytes" for name, size in sizes.items()))


if __name__ == "__main__":
    main()
