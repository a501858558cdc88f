#!/usr/bin/env python3
"""check_windows.py ROOT --shaders FOLDER [--compiler NAME] [--headers FOLDER]: the library compiles for Windows.

Compiles each .cpp of fluid, fluid/cpu, fluid/vulkan and c_api with MinGW, without code and with the project's warnings as errors.
Nothing is linked or run here; ./dev bits runs the core. FOLDER of --shaders holds the shader_words of the build. Prints what the compiler
says and exits with 1 if it rejects a file, and with a sentence if there is no compiler.
"""
import argparse
import concurrent.futures
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

FOLDERS = ("gpu", "fluid", "fluid/cpu", "fluid/vulkan", "c_api/source", "c_api/source/vulkan")
# Of this machine, and the same for each; all of its other headers would stand before MinGW's.
HEADERS = ("glm", "vulkan", "vk_video", "nlohmann")
OPTIONS = ("-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Wno-sign-conversion", "-Werror",
           "-DVK_NO_PROTOTYPES", "-DWINDROW_C_BUILDS", "-DWINDROW_C_COUPLING=1", "-DWINDROW_C_VDB=1", "-DWINDROW_C_VULKAN=1", "-DWINDROW_C_SCENE=1")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--shaders", type=pathlib.Path, required=True)
    parser.add_argument("--compiler", default="x86_64-w64-mingw32-g++-posix")
    parser.add_argument("--headers", type=pathlib.Path, default=pathlib.Path("/usr/include"))
    arguments = parser.parse_args()
    if shutil.which(arguments.compiler) is None:
        sys.exit(f"{arguments.compiler} was not found: install it (Debian: g++-mingw-w64-x86-64-posix).")
    files = [file for folder in FOLDERS for file in sorted((arguments.root / folder).glob("*.cpp"))]
    if len(files) < 50:
        sys.exit(f"only {len(files)} files in {', '.join(FOLDERS)}: the check reads too little")
    with tempfile.TemporaryDirectory() as headers:
        for name in HEADERS:
            (pathlib.Path(headers) / name).symlink_to(arguments.headers / name)

        def said(file):
            command = [arguments.compiler, *OPTIONS, "-I", arguments.root, "-I", arguments.shaders, "-isystem", headers, file]
            run = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                 check=False)
            return run.stdout if run.returncode != 0 else ""

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            faults = [text for text in pool.map(said, files) if text]
    print("".join(faults) + f"{len(files)} files, {len(faults)} rejected by {arguments.compiler}")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
