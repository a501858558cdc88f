#!/usr/bin/env python3
"""wheel_test.py ROOT --work DIR: makes the wheel of this machine and uses it as one who has nothing else of the project.

The wheel is installed without a network into a folder; README's lines and the tests of the package run from there. The library alone is
loaded too: what it needs of the system, that it starts no thread, and that it can be let go.
"""
import argparse
import os
import pathlib
import re
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "tools"))
from make_wheel import run

MOST_BYTES = 1_500_000
OF_THE_SYSTEM = {"libc.so.6", "libm.so.6", "ld-linux-x86-64.so.2"}
# In a process of its own: the library alone, without numpy, whose BLAS has threads.
ALONE = """
import ctypes, os, sys, _ctypes
def maps():
    return {line.split()[-1] for line in open("/proc/self/maps") if line.rstrip().endswith(".so") or ".so." in line}
place, before = sys.argv[1], maps()
for _ in range(100):
    library = ctypes.CDLL(place)
    config = (ctypes.c_uint32 * 200)()
    assert library.windrow_config_init(config, ctypes.c_uint32(800 // 2)) == 0
    wind = ctypes.c_void_p()
    library.windrow_wind_create.argtypes = [ctypes.c_void_p, ctypes.c_void_p]
    library.windrow_wind_destroy.argtypes = [ctypes.c_void_p]
    assert library.windrow_wind_create(config, ctypes.byref(wind)) == 0, ctypes.cast(library.windrow_last_error, ctypes.c_void_p)
    while_loaded, tasks = maps() - before, len(os.listdir("/proc/self/task"))
    library.windrow_wind_destroy(wind)
    _ctypes.dlclose(library._handle)
    assert not any("windrow" in name for name in maps()), "it stays loaded"
assert tasks == 1, f"{tasks} threads"
print(" ".join(sorted(os.path.basename(name) for name in while_loaded)))
"""


def expect(holds, sentence):
    if not holds:
        sys.exit(sentence)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--work", type=pathlib.Path, required=True)
    args = parser.parse_args()
    args.root = args.root.resolve()
    shutil.rmtree(args.work, ignore_errors=True)
    args.work.mkdir(parents=True)
    python = sys.executable
    wheels = []
    for name in ("first", "second"):  # equal files make an equal wheel
        run([python, "-B", args.root / "tools/make_wheel.py", "--out", args.work / name])
        wheels += (args.work / name).glob("*.whl")
    expect(wheels[0].read_bytes() == wheels[1].read_bytes(), "two wheels of the same files differ")
    size = wheels[0].stat().st_size
    print(f"[figure] wheel_bytes = {size} (bound {MOST_BYTES})")
    expect(size <= MOST_BYTES, f"the wheel has {size} bytes: more than {MOST_BYTES}")

    there = args.work / "installed"
    run([python, "-m", "pip", "install", "--quiet", "--no-index", "--no-deps", "--target", there, wheels[0]])
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("WINDROW", "PYTHON", "LD_"))}
    environment["PYTHONPATH"] = str(there)
    for block in re.findall(r"```python\n(.*?)```", (args.root / "bindings/python/README.md").read_text(encoding="utf-8"), re.DOTALL):
        said = run([python, "-B", "-c", block], cwd=args.work, env=environment)
        print(said.strip())
        if "at the leaf" in block:
            expect(said == "3.19 m/s at the leaf\n", f"README's lines print {said}")
    for tests in ("python_test.py", "python_settings_test.py", "python_costs_test.py"):
        print(run([python, "-B", args.root / "tests/bindings" / tests], cwd=args.work, env=environment).strip())

    times = [float(run([python, "-B", "-c", "import time, numpy, dataclasses, enum, typing; t = time.perf_counter(); import windrow; "
                        "print(1e3 * (time.perf_counter() - t))"], cwd=args.work, env=environment)) for _ in range(7)]
    print(f"[figure] python_import = {min(times):.1f} ms beyond numpy's own (bound 30)")
    expect(min(times) <= 30.0, f"importing takes {min(times)} ms beyond numpy's own")

    library = there / "windrow/libwindrow.so"
    needed = set(re.findall(r"\(NEEDED\).*\[(.*)\]", run(["readelf", "-d", library])))
    expect(needed <= OF_THE_SYSTEM, f"the library needs {sorted(needed - OF_THE_SYSTEM)}")
    symbols = run(["readelf", "-W", "--dyn-syms", library])
    newest = max(tuple(map(int, found)) for found in re.findall(r"GLIBC_(\d+)\.(\d+)", symbols))
    expect(newest <= (2, 34), f"the library needs glibc {newest}, and the wheel's name says 2.34")
    expect(" UNIQUE " not in symbols, "a unique symbol keeps the library loaded for ever")
    loaded = run([python, "-B", "-c", ALONE, library], cwd=args.work)
    expect(set(loaded.split()) - {"libwindrow.so"} <= OF_THE_SYSTEM, f"loading it loads {loaded}")
    print(f"The library alone: one thread, {', '.join(sorted(needed))}, let go 100 times")


if __name__ == "__main__":
    main()
