#!/usr/bin/env python3
"""make_wheel.py [PLATFORM...] [--out FOLDER] [--blender]: wheels of the Python package with the library in them, for every Python from 3.10 on.

PLATFORM: linux (x86-64, the default), arm64 (Linux, cross-compiled), windows (x86-64, by MinGW-w64). The library in a wheel has plants
and no OpenVDB and no Vulkan: it needs numpy and the system's C library alone. Builds are in build/wheel/PLATFORM. --blender: the add-on
too, with the wheel in it, as a zip for Blender 3.4 to 4.1 (windrow_addon) and as an extension for 4.2 and later (windrow_extension).
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import zipfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
OFF = ("VDB", "VULKAN", "IMAGES", "FFTW", "CLI", "VEGETATION", "EXAMPLES", "TESTS")
OPTIONS = ["-DCMAKE_BUILD_TYPE=Release", "-DWINDROW_UNITY=8", "-DWINDROW_PORTABLE=ON", "-DCMAKE_SHARED_LINKER_FLAGS=-s", *(f"-DWINDROW_{part}=OFF" for part in OFF)]
PLATFORMS = {
    "linux": ("manylinux_2_34_x86_64", "libwindrow.so", []),
    "arm64": ("manylinux_2_34_aarch64", "libwindrow.so", [f"-DCMAKE_TOOLCHAIN_FILE={ROOT}/cmake/toolchains/arm64.cmake"]),
    "windows": ("win_amd64", "libwindrow.dll", [f"-DCMAKE_TOOLCHAIN_FILE={ROOT}/cmake/toolchains/windows.cmake"]),
}


EXTENSION_PLATFORMS = {"linux": "linux-x64", "arm64": "linux-arm64", "windows": "windows-x64"}


def run(command, **options):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"{done.stdout}\n{' '.join(map(str, command))} ended with {done.returncode}")
    return done.stdout


def make(platform, out):
    tag, library, options = PLATFORMS[platform]
    if platform == "linux" and os.uname().machine != "x86_64":
        sys.exit(f"linux is x86-64, and this machine is {os.uname().machine}: give arm64 there, or build the library by CMake")
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


def make_addons(wheel, platform, out):
    """The add-on with the package unpacked in it, and as an extension that names the wheel."""
    version = wheel.name.split("-")[1]
    sources = ROOT / "bindings/blender/windrow_wind"
    files = [path for path in sorted(sources.glob("*.py"))]
    addon, extension = (out / f"windrow_{form}-{version}-{platform}.zip" for form in ("addon", "extension"))
    with zipfile.ZipFile(addon, "w", zipfile.ZIP_DEFLATED) as packed, zipfile.ZipFile(wheel) as package:
        for path in files:
            packed.writestr(entry(f"windrow_wind/{path.name}"), path.read_bytes())
        for name in package.namelist():
            if name.startswith("windrow/"):
                packed.writestr(entry(f"windrow_wind/lib/{name}"), package.read(name))
        for name in ("LICENSE", "NOTICE"):
            packed.writestr(entry(f"windrow_wind/{name}"), (ROOT / name).read_bytes())
    manifest = f"""schema_version = "1.0.0"
id = "windrow_wind"
version = "{version}"
name = "Windrow wind"
tagline = "Wind for plants: motors, obstacles, blades of grass, baked"
maintainer = "Windrow"
type = "add-on"
blender_version_min = "4.2.0"
license = ["SPDX:Apache-2.0"]
platforms = ["{EXTENSION_PLATFORMS[platform]}"]
wheels = ["./wheels/{wheel.name}"]

[permissions]
files = "Writes caches beside the scene"
"""
    with zipfile.ZipFile(extension, "w", zipfile.ZIP_DEFLATED) as packed:
        packed.writestr(entry("blender_manifest.toml"), manifest)
        for path in files:
            packed.writestr(entry(path.name), path.read_bytes())
        packed.writestr(entry(f"wheels/{wheel.name}"), wheel.read_bytes())
        for name in ("LICENSE", "NOTICE"):
            packed.writestr(entry(name), (ROOT / name).read_bytes())
    for path in (addon, extension):
        print(f"{path}: {path.stat().st_size} bytes", flush=True)


def entry(name):
    made = zipfile.ZipInfo(name, (2023, 11, 14, 22, 13, 20))
    made.compress_type = zipfile.ZIP_DEFLATED
    made.external_attr = 0o644 << 16
    return made


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("platforms", nargs="*", metavar="PLATFORM", default=["linux"], choices=[*PLATFORMS, ["linux"]])
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out/wheels")
    parser.add_argument("--blender", action="store_true")
    options = parser.parse_args()
    for platform in options.platforms if isinstance(options.platforms, list) else [options.platforms]:
        wheel = make(platform, options.out)
        if options.blender:
            make_addons(wheel, platform, options.out)


if __name__ == "__main__":
    main()
