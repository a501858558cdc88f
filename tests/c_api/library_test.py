#!/usr/bin/env python3
"""library_test.py HEADERS LIBRARY: the shared library against its headers.

- It exports the functions of the headers and no other symbol.
- Each call with every pointer null is rejected with a sentence, or returns 0, and none crashes.
- No struct has padding at its end, which an older host would hand over as a field of a newer one.
- It needs the libraries of C and C++ alone, starts no thread, and is gone after dlclose, again and again.
- OpenVDB is opened by the first call that writes a file; without its library beside it, that call says so.
"""
import ctypes
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "tools"))
from c_header import Header

# Calls that mean something with every pointer null.
MEANT = {
    "windrow_set_allocator": "the library's own allocator",
}


def exported(library):
    lines = subprocess.run(["nm", "--dynamic", "--defined-only", library], check=True, capture_output=True, text=True).stdout.splitlines()
    return {line.split()[-1].split("@")[0] for line in lines}


# What a program of C++ has loaded anyway.
LANGUAGE = re.compile(r"(libc|libm|libstdc\+\+|libgcc_s|ld-linux-[\w-]+)\.so\.\d+")


def needed(library):
    said = subprocess.run(["readelf", "--dynamic", "--wide", library], check=True, capture_output=True, text=True).stdout
    return re.findall(r"\(NEEDED\).*\[(.*)\]", said)


def threads():
    return len(os.listdir("/proc/self/task"))


def loaded(name):
    return name in pathlib.Path("/proc/self/maps").read_text(encoding="utf-8")


def live(path, header):
    """A life of the library in this process: an error, a wind, a step. Returns the handle for dlclose."""
    library = ctypes.CDLL(path)
    header.bind(library)
    assert library.windrow_wind_create(None, None) != 0 and library.windrow_last_error()
    config, wind = header.ctype("windrow_config")(), ctypes.c_void_p()
    assert library.windrow_config_init(ctypes.byref(config), ctypes.sizeof(config)) == 0
    assert library.windrow_wind_create(ctypes.byref(config), ctypes.byref(wind)) == 0
    assert library.windrow_wind_step(wind, ctypes.c_double(1 / 60), None) == 0
    library.windrow_wind_destroy(wind)
    return library


def alone(header, path):
    """Faults of the library as a guest in a host's process; run in a process of its own."""
    name, before, close = pathlib.Path(path).resolve().name, threads(), ctypes.CDLL(None).dlclose
    close.argtypes = [ctypes.c_void_p]
    for time in range(100):
        library = live(path, header)
        if not loaded(name):
            yield f"{name} is not in /proc/self/maps under its name: the check below sees nothing"
        if threads() != before:
            yield f"{threads() - before} threads more after a step"
        close(library._handle)
        if loaded(name):
            yield f"{name} is still loaded after dlclose number {time + 1}"
            return


def vdb(header, path, work):
    """Faults of the calls that write VDB files, with OpenVDB's library beside it and without."""
    beside, lone = pathlib.Path(path).resolve(), pathlib.Path(work) / "libwindrow_lone.so"
    shutil.copyfile(beside, lone)
    for file, wanted in ((lone, -6), (beside, 0)):
        library = live(str(file), header)
        config, wind = header.ctype("windrow_config")(), ctypes.c_void_p()
        library.windrow_config_init(ctypes.byref(config), ctypes.sizeof(config))
        library.windrow_wind_create(ctypes.byref(config), ctypes.byref(wind))
        if loaded("libopenvdb"):
            yield "OpenVDB is loaded before any call of vdb.h"
        answer = library.windrow_vdb_write(wind, str(pathlib.Path(work) / "wind.vdb").encode(), None)
        sentence = library.windrow_last_error().decode()
        if answer != wanted or (wanted and "put it beside libwindrow" not in sentence):
            yield f"windrow_vdb_write of {file.name} returns {answer}: {sentence}"
        library.windrow_wind_destroy(wind)
    if not (pathlib.Path(work) / "wind.vdb").exists():
        yield "windrow_vdb_write wrote no file"


def guest(folder, path):
    """All faults of the library in a process that nothing else has touched."""
    header = Header(folder)
    faults = [f"{path} needs {other}: a host has the libraries of C and C++ alone" for other in needed(path) if not LANGUAGE.fullmatch(other)]
    faults += alone(header, path)
    with tempfile.TemporaryDirectory() as work:
        library = ctypes.CDLL(path)
        if not faults and library.windrow_has_part(1):
            faults += vdb(header, path, work)
    return faults


def main():
    if sys.argv[1] == "--guest":
        faults = guest(*sys.argv[2:])
        print("\n".join(faults))
        sys.exit(1 if faults else 0)
    folder, path = sys.argv[1:]
    header, faults = Header(folder), []
    symbols, functions = exported(path), set(header.functions)
    faults += [f"exported, but in no header: {name}" for name in sorted(symbols - functions)]
    faults += [f"in a header, but not exported: {name}" for name in sorted(functions - symbols)]

    for name, fields in header.structs.items():
        kind = header.ctype(name)
        of, last, length = fields[-1]
        if fields[0][1] == "struct_size" and getattr(kind, last).offset + getattr(kind, last).size != ctypes.sizeof(kind):
            faults.append(f"{name} has padding after {last}: fill it with a reserved field")

    library = ctypes.CDLL(path)
    header.bind(library)
    rejected = 0
    for name, (result, parameters) in sorted(header.functions.items()):
        if name in symbols and any(kind.endswith("*") for kind, _ in parameters):
            types = [header.ctype(kind) for kind, _ in parameters]
            arguments = [None if kind is ctypes.c_void_p else kind() for kind in types]
            print(name, flush=True)  # the one that crashes is the last line
            answer = getattr(library, name)(*arguments)
            sentence = library.windrow_last_error().decode()
            if result == "windrow_result":
                rejected += 1
                if (answer == 0) != (name in MEANT):
                    faults.append(f"{name} with null pointers returns {answer}")
                elif answer != 0 and not (sentence.endswith(".") and "null" in sentence or answer == -6):
                    faults.append(f"{name} with null pointers: '{sentence}'")
    visit = subprocess.run([sys.executable, "-B", __file__, "--guest", folder, path], capture_output=True, text=True)
    if visit.returncode != 0:
        faults.append(f"as a guest: {visit.stdout}{visit.stderr}")
    print(f"{len(functions)} functions, {len(header.structs)} structs, {rejected} calls rejected with a sentence")
    if len(functions) < 200 or rejected < 150:
        faults.append("the headers are not read as they were meant to be")
    print("\n".join(faults))
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
