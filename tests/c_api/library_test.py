#!/usr/bin/env python3
"""library_test.py HEADERS LIBRARY: the shared library against its headers.

- It exports the functions of the headers and no other symbol.
- Each call with every pointer null is rejected with a sentence, or returns 0, and none crashes.
- No struct has padding at its end, which an older host would hand over as a field of a newer one.
"""
import ctypes
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "tools"))
from c_header import Header

# Calls that mean something with every pointer null.
MEANT = {
    "windrow_set_allocator": "the library's own allocator",
}


def exported(library):
    lines = subprocess.run(["nm", "--dynamic", "--defined-only", library], check=True, capture_output=True, text=True).stdout.splitlines()
    return {line.split()[-1].split("@")[0] for line in lines}


def main():
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
    print(f"{len(functions)} functions, {len(header.structs)} structs, {rejected} calls rejected with a sentence")
    if len(functions) < 200 or rejected < 150:
        faults.append("the headers are not read as they were meant to be")
    print("\n".join(faults))
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
