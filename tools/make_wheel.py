#!/usr/bin/env python3
"""make_wheel.py [PLATFORM...] [--out FOLDER]: wheels of the Python package with the library in them, for every Python from 3.10 on.

PLATFORM: linux (x86-64, the default), arm64 (Linux, cross-compiled), windows (x86-64, by MinGW-w64). The library in a wheel has plants
and no OpenVDB and no Vulkan: it needs numpy and the system's C library alone. Builds are in build/wheel/PLATFORM.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
OFF = ("VDB", "VULKAN", "IMAGES", "FFTW", "CLI", "VEGETATION", "EXAMPLES", "TESTS")
OPTIONS = ["-DCMAKE_BUILD_TYPE=Release", "-DWINDROW_UNITY=8", "-DWINDROW_PORTABLE=ON", "-DCMAKE_SHARED_LINKER_FLAGS=-s", *(f"-DWINDROW_{part}=OFF" for part in OFF)]
PLATFORMS = {
    "linux": ("manylinux_2_34_x86_64", "libwindrow.so", []),
    "arm64": ("manylinux_2_34_aarch64", "libwindrow.so", [f"-DCMAKE_TOOLCHAIN_FILE={ROOT}/cmake/toolchains/arm64.cmake"]),
    "windows": ("win_amd64", "libwindrow.dll", [f"-DCMAKE_TOOLCHAIN_FILE={ROOT}/cmake/toolchains/windows.cmake"]),
}


def run(command, **options):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"{done.stdout}\n{' '.join(map(str, command))} ended with {done.returncode}")
    return done.stdout


def make(platform, out):
    tag, library, options = PLATFORMS[platform]
    folder = ROOT / "build/wheel" / platform
    run(["cmake", "-S", ROOT, "-B", folder / "build", "-G", "Ninja", *OPTIONS, *options])
    run(["cmake", "--build", folder / "build", "--target", "windrow_c", "--parallel", os.environ.get("WINDROW_JOBS", os.cpu_count())])
    found = next(path for path in (folder / "build" / "c_api" / library, folder / "build" / library) if path.exists())

    stage = folder / "package"  # what a build of setuptools leaves behind stays out of the sources
    shutil.rmtree(stage, ignore_errors=True)
    shutil.copytree(ROOT / "bindings/python", stage, ignore=shutil.ignore_patterns("__pycache__", ".mypy_cache", "*.so", "*.dll"))
    for name in ("LICENSE", "NOTICE"):
        if (ROOT / name).exists():
            shutil.copy2(ROOT / name, stage / name)
    shutil.copyfile(found.resolve(), stage / "windrow" / library)
    out.mkdir(parents=True, exist_ok=True)
    # The time of each file in the archive: equal files make an equal wheel.
    environment = dict(os.environ, SOURCE_DATE_EPOCH=os.environ.get("SOURCE_DATE_EPOCH", "1700000000"))
    # Debian's own Python: it sees Debian's setuptools.
    python = "/usr/bin/python3" if pathlib.Path("/usr/bin/python3").exists() else sys.executable
    run([python, "setup.py", "-q", "bdist_wheel", "--plat-name", tag, "--dist-dir", out.resolve()], cwd=stage, env=environment)
    wheel = max(out.glob(f"windrow-*-py3-none-{tag}.whl"), key=lambda path: path.stat().st_mtime)
    print(f"{wheel}: {wheel.stat().st_size} bytes", flush=True)
    return wheel


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("platforms", nargs="*", metavar="PLATFORM", default=["linux"], choices=[*PLATFORMS, ["linux"]])
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out/wheels")
    options = parser.parse_args()
    for platform in options.platforms if isinstance(options.platforms, list) else [options.platforms]:
        make(platform, options.out)


if __name__ == "__main__":
    main()
