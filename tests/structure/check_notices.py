#!/usr/bin/env python3
"""check_notices.py ROOT BUILD --program PATH... [--library PATH...]: what the installed programs and libraries are made of is in
NOTICE, and none of it is under the GPL alone.

The list is the build's: the libraries that the linker wrote into each file (readelf), and the system's headers that their objects
were compiled with (ninja). Debian's dpkg names the source package of each; NOTICE has a row for it. `windrow info --licences`
prints LICENSE and NOTICE, and what FFTW solves names the program that has it. Without dpkg or ninja only the names of libraries under the GPL are looked for."""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys

FIELDS = ("Name", "Source", "Licence", "In")
GPL = re.compile(r"^lib(fftw3|gsl|readline|x264|x265|gmp)")
# Objects of the installed files; tests, benchmarks and examples are not installed, nor is FFTW's reference.
NOT_INSTALLED = re.compile(r"(^|/)(tests|bench|examples|CMakeFiles/windrow_fftw\.dir)/|^tests")


def rows_of(text):
    """The rows of NOTICE: blocks of lines "Field: value"."""
    rows = []
    for block in re.split(r"\n\s*\n", text):
        fields = dict(re.findall(r"^(\w+): +(.*)$", block, re.M))
        if "Source" in fields:
            rows.append(fields)
    return rows


def linked(path):
    found = subprocess.run(["readelf", "-d", path], capture_output=True, text=True, check=True).stdout
    return re.findall(r"\(NEEDED\).*\[(.*)\]", found)


def place_of(library, path):
    found = subprocess.run(["ldd", path], capture_output=True, text=True).stdout
    match = re.search(rf"{re.escape(library)} => (\S+)", found)
    return str(pathlib.Path(match[1]).resolve()) if match else None


def headers_of(build):
    headers, installed = set(), False
    for line in subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True).stdout.splitlines():
        if line and not line[0].isspace():
            installed = not NOT_INSTALLED.search(line.split(":")[0])
        elif installed and line.strip().startswith("/usr/"):
            headers.add(str(pathlib.Path(line.strip()).resolve()))
    return headers


def sources_of(files):
    """The Debian source package of each file: {package: a file of it}."""
    files = sorted(files)
    found = subprocess.run(["dpkg-query", "-S", *files], capture_output=True, text=True).stdout
    package_of = {path: name.split(",")[0] for name, path in re.findall(r"^(\S.*?): (/.*)$", found, re.M)}
    names = sorted(set(package_of.values()))
    lines = subprocess.run(["dpkg-query", "-W", "-f", "${binary:Package} ${Package} ${source:Package}\n", *names],
                           capture_output=True, text=True).stdout.splitlines()
    source = {}
    for line in lines:
        binary, package, name = line.split()
        source[binary] = source[package] = re.sub(r"-\d+$", "", name) if name.startswith("gcc-") else name
    return {source[package]: path for path, package in package_of.items() if package in source}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("build")
    parser.add_argument("--program", action="append", default=[])
    parser.add_argument("--library", action="append", default=[])
    given = parser.parse_args()
    faults, files = [], set()
    for path in given.program + given.library:
        for library in linked(path):
            if GPL.match(library):
                faults.append(f"{path} links {library}, which is under the GPL: link it in a program that is not installed.")
            if place := place_of(library, path):
                files.add(place)

    notice = given.root / "NOTICE"
    text = notice.read_text() if notice.exists() else ""
    rows = rows_of(text)
    known = {}
    for row in rows:
        faults += [f"NOTICE: the row of {row['Source']} has no {field}." for field in FIELDS if not row.get(field)]
        known.update({source.strip(): row for source in row["Source"].split(",")})
    if shutil.which("dpkg-query") and shutil.which("ninja"):
        found = sources_of(files | headers_of(given.build))
        if len(found) < 4:
            faults.append("the build gave no list of headers: is its folder a finished build by Ninja?")
        for source, path in sorted(found.items()):
            if source not in known:
                faults.append(f"NOTICE has no row of {source}, which the build uses ({path}).")
    for row in rows:
        if re.match(r"GPL", row.get("Licence", "")) and "exception" not in row["Licence"].lower():
            faults.append(f"NOTICE: {row['Source']} is under the GPL.")

    for program in given.program:
        if pathlib.Path(program).name.startswith("windrow-draw"):
            continue
        printed = subprocess.run([program, "info", "--licences"], capture_output=True, text=True)
        for file in (given.root / "LICENSE", notice):
            if not file.exists() or file.read_text().strip() not in printed.stdout:
                faults.append(f"`{pathlib.Path(program).name} info --licences` does not print {file.name}: {printed.stderr.strip()}")
        asked = subprocess.run([program, "verify", "--case", "taylor_green_3d"], capture_output=True, text=True)
        if asked.returncode != 2 or "windrow-fftw" not in asked.stderr:
            faults.append(f"a case that needs FFTW does not name the program that has it: {asked.stderr.strip()}")
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
