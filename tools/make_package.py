#!/usr/bin/env python3
"""make_package.py [PLATFORM...] [--out FOLDER]: archives to unpack, with all that a host needs.

PLATFORM: linux (x86-64, the default): library, headers, the command `windrow`, scenes, pages; tar.gz and a Debian package. arm64 (Linux)
and windows (MinGW-w64): library, headers, scenes, pages; tar.gz and zip. The libraries of C++ are within, GLM's headers beside. Neither
OpenVDB nor pictures: those are Debian's, for a build of one's own. Beside the archives: an SPDX list of what they are made of, SHA256SUMS.
"""
import argparse
import gzip
import hashlib
import json
import os
import pathlib
import re
import shutil
import sys
import tarfile
import time
import zipfile

from make_wheel import run

ROOT = pathlib.Path(__file__).resolve().parent.parent
OFF = ("VDB", "IMAGES", "FFTW", "VEGETATION", "EXAMPLES", "TESTS")
LIBRARY_ALONE = ("VULKAN", "CLI")
# Times in archives: equal files make equal archives.
EPOCH = int(os.environ.get("SOURCE_DATE_EPOCH", "1700000000"))
PLATFORMS = {
    "linux": ("linux-x86_64", ()),
    "arm64": ("linux-aarch64", LIBRARY_ALONE),
    "windows": ("windows-x86_64", LIBRARY_ALONE),
}
# GLM's headers of the archive are found after a host's own.
GLM_FOLDER = "share/windrow/glm"
GLM_CONFIG = """# GLM's headers of this archive.
if(NOT TARGET glm::glm)
  add_library(glm::glm INTERFACE IMPORTED)
  get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
  set_target_properties(glm::glm PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${root}/share/windrow/glm")
endif()
"""
GLM_VERSION = """set(PACKAGE_VERSION "VERSION")
if(NOT PACKAGE_VERSION VERSION_LESS PACKAGE_FIND_VERSION)
  set(PACKAGE_VERSION_COMPATIBLE TRUE)
endif()
"""
# Of NOTICE, by its field In; and the compiler's own, which is linked in.
COMPILED_IN = {"GLM": None, "JSON for Modern C++": None, "CLI11": "CLI", "Vulkan headers and loader": "VULKAN"}  # with which option
GCC_LICENCE = "GPL-3.0-or-later WITH GCC-exception-3.1"
RUNTIME = [{"Name": "GCC runtime libraries (libstdc++, libgcc)", "Source": "gcc", "Licence": GCC_LICENCE}]
MINGW = [*RUNTIME, {"Name": "MinGW-w64 runtime and winpthreads", "Source": "mingw-w64", "Licence": "ZPL-2.1 AND MIT"}]


def version():
    return re.search(r'WINDROW_VERSION_STRING "(.*)"', (ROOT / "fluid/version.h").read_text(encoding="utf-8")).group(1)


def spdx(name, without):
    """The list of an archive's parts as SPDX 2.3; `without`: options that are off."""
    blocks = re.split(r"\n\s*\n", (ROOT / "NOTICE").read_text(encoding="utf-8"))
    wanted = [part for part, option in COMPILED_IN.items() if option not in without]
    rows = [row for row in (dict(re.findall(r"^(\w+): +(.*)$", block, re.M)) for block in blocks) if row.get("Name") in wanted]
    if len(rows) != len(wanted):
        sys.exit(f"NOTICE lacks a row of {', '.join(wanted)}")
    packages = [{"SPDXID": "SPDXRef-windrow", "name": "windrow", "versionInfo": version(), "licenseDeclared": "Apache-2.0",
                 "licenseConcluded": "Apache-2.0", "downloadLocation": "NOASSERTION", "filesAnalyzed": False, "copyrightText": "NOASSERTION"}]
    for row in [*rows, *(MINGW if "windows" in name else RUNTIME)]:
        packages.append({"SPDXID": "SPDXRef-" + re.sub(r"[^A-Za-z0-9]+", "-", row["Source"]), "name": row["Name"],
                         "sourceInfo": f"Debian source package {row['Source']}", "licenseDeclared": row["Licence"].split(";")[0],
                         "licenseConcluded": "NOASSERTION", "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
                         "copyrightText": "NOASSERTION"})
    relations = [{"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": "SPDXRef-windrow"}]
    relations += [{"spdxElementId": "SPDXRef-windrow", "relationshipType": "CONTAINS", "relatedSpdxElement": package["SPDXID"]}
                  for package in packages[1:]]
    return json.dumps({"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": name,
                       "documentNamespace": f"https://spdx.org/spdxdocs/{name}-{EPOCH}",
                       "creationInfo": {"created": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(EPOCH)), "creators": ["Tool: windrow-make_package"]},
                       "packages": packages, "relationships": relations}, indent=2) + "\n"


def files_of(folder):
    return sorted(path for path in folder.rglob("*") if path.is_file() or path.is_symlink())


def write_tar(folder, archive):
    def plain(entry):
        entry.uid = entry.gid = 0
        entry.uname = entry.gname = "root"
        entry.mtime = EPOCH
        entry.mode = 0o755 if entry.isdir() or entry.mode & 0o100 else 0o644
        return entry
    with open(archive, "wb") as file, gzip.GzipFile("", "wb", 9, file, mtime=0) as packed, \
            tarfile.open(fileobj=packed, mode="w", format=tarfile.PAX_FORMAT) as tar:
        for path in files_of(folder):
            tar.add(path, path.relative_to(folder.parent), recursive=False, filter=plain)


def write_zip(folder, archive):
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as packed:
        for path in files_of(folder):
            entry = zipfile.ZipInfo(str(path.relative_to(folder.parent)), time.gmtime(EPOCH)[:6])
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if os.access(path, os.X_OK) else 0o644) << 16
            packed.writestr(entry, path.read_bytes())


def write_deb(build, folder, archive):
    shutil.rmtree(folder, ignore_errors=True)
    run(["cmake", "--install", build, "--prefix", "/usr", "--strip"], env=dict(os.environ, DESTDIR=str(folder)))
    size = sum(path.stat().st_size for path in files_of(folder) if path.is_file()) // 1024
    control = folder / "DEBIAN/control"
    control.parent.mkdir()
    control.write_text(f"""Package: windrow
Version: {version()}
Architecture: amd64
Maintainer: Windrow <windrow@example.org>
Installed-Size: {size}
Depends: libc6 (>= 2.34)
Recommends: libglm-dev
Section: libdevel
Priority: optional
Description: wind for plants: a voxel fluid around a player
 The library for C and C++, the command windrow and its scenes. The libraries of
 C++ are within; C++ hosts need GLM's headers.
""", encoding="utf-8")
    for path in [folder, *folder.rglob("*")]:
        os.utime(path, (EPOCH, EPOCH), follow_symlinks=False)
        if not path.is_symlink():
            path.chmod(0o755 if path.is_dir() or os.access(path, os.X_OK) else 0o644)
    run(["dpkg-deb", "--root-owner-group", "-Zxz", "--build", folder, archive], env=dict(os.environ, SOURCE_DATE_EPOCH=str(EPOCH)))


def make(platform, out):
    suffix, without = PLATFORMS[platform]
    name = f"windrow-{version()}-{suffix}"
    build, stage = ROOT / "build/package" / platform, ROOT / "build/package/stage" / name
    options = ["-DCMAKE_BUILD_TYPE=Release", "-DWINDROW_UNITY=8", "-DWINDROW_PORTABLE=ON", "-DCMAKE_INSTALL_LIBDIR=lib"]
    options += [f"-DWINDROW_{part}=OFF" for part in (*OFF, *without)]
    if platform != "linux":
        options.append(f"-DCMAKE_TOOLCHAIN_FILE={ROOT}/cmake/toolchains/{platform}.cmake")
    run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", *options])
    run(["cmake", "--build", build, "--parallel", os.environ.get("WINDROW_JOBS", os.cpu_count())])

    shutil.rmtree(stage, ignore_errors=True)
    run(["cmake", "--install", build, "--prefix", stage, "--strip"])
    glm = next(path for path in map(pathlib.Path, ("/usr/include/glm", "/usr/local/include/glm")) if path.exists())
    shutil.copytree(glm, stage / GLM_FOLDER / "glm", ignore=shutil.ignore_patterns("CMakeLists.txt", "*.cpp", "*.cppm"))
    numbers = re.findall(r"define GLM_VERSION_(?:MAJOR|MINOR|PATCH|REVISION)\s+(\d+)", (glm / "detail/setup.hpp").read_text(encoding="utf-8"))
    (stage / "lib/cmake/glm").mkdir()
    (stage / "lib/cmake/glm/glmConfig.cmake").write_text(GLM_CONFIG, encoding="utf-8")
    (stage / "lib/cmake/glm/glmConfigVersion.cmake").write_text(GLM_VERSION.replace("VERSION\")", ".".join(numbers[:4]) + "\")", 1), encoding="utf-8")
    for words in (stage / "lib/pkgconfig").glob("windrow-fluid.pc"):
        said = words.read_text(encoding="utf-8")
        words.write_text(re.sub(r"(?m)^(Cflags: .*)$", rf"\1 -idirafter ${{prefix}}/{GLM_FOLDER}", said), encoding="utf-8")
    (stage / "sbom.spdx.json").write_text(spdx(name, without), encoding="utf-8")
    for page in ("LICENSE", "NOTICE", "README.md"):
        shutil.copy2(ROOT / page, stage / page)

    out.mkdir(parents=True, exist_ok=True)
    archives = [out / f"{name}.zip"] if platform == "windows" else [out / f"{name}.tar.gz"]
    (write_zip if platform == "windows" else write_tar)(stage, archives[0])
    if platform == "linux" and shutil.which("dpkg-deb"):
        archives.append(out / f"windrow_{version()}_amd64.deb")
        write_deb(build, ROOT / "build/package/stage/deb", archives[-1])
    return archives


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("platforms", nargs="*", metavar="PLATFORM", default=["linux"], choices=[*PLATFORMS, ["linux"]])
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out/packages")
    options = parser.parse_args()
    for platform in options.platforms:
        for archive in make(platform, options.out):
            print(f"{archive}: {archive.stat().st_size} bytes", flush=True)
    sums = "".join(f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n" for path in sorted(options.out.glob("windrow*"))
                   if path.suffix != ".txt")
    (options.out / "SHA256SUMS").write_text(sums, encoding="utf-8")


if __name__ == "__main__":
    main()
