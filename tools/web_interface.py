#!/usr/bin/env python3
"""web_interface.py FOLDER: what JavaScript needs of the C interface, from the headers of c_api.

Writes FOLDER/package_exports.txt, the functions of a build without Vulkan and VDB, for the linker; FOLDER/page_exports.txt, those of
them that bindings/web names; and FOLDER/interface.json: each struct with
size, alignment and fields (type, offset, length of an array) as a 32-bit machine lays them out, and the values of the choices.
"""
import json
import pathlib
import re
import sys

from c_header import SCALARS, Header

ROOT = pathlib.Path(__file__).resolve().parent.parent
LEFT_OUT = ("vdb.h", "vulkan_ground.h", "vulkan_host.h", "vulkan_wind.h")
SIZES = {"float": 4, "double": 8, "int32_t": 4, "uint32_t": 4, "int64_t": 8, "uint64_t": 8, "uint16_t": 2, "uint8_t": 1, "size_t": 4}


class Layout:
    """Sizes and offsets by the rules of C, with pointers of 4 bytes."""

    def __init__(self, header):
        self.header, self.structs = header, {}

    def base(self, name):
        """The scalar, "pointer" or struct that a type stands for."""
        name = name.removeprefix("const ")
        if "*" in name or name in self.header.callbacks:
            return "pointer"
        while name not in SCALARS and name not in self.header.structs:
            name = self.header.types[name]
        return name

    def size_and_alignment(self, name):
        base = self.base(name)
        if base == "pointer":
            return 4, 4
        if base in SIZES:
            return SIZES[base], SIZES[base]
        struct = self.struct(base)
        return struct["size"], struct["align"]

    def struct(self, name):
        if name not in self.structs:
            at, most, fields = 0, 1, {}
            for kind, field, length in self.header.structs[name]:
                size, align = self.size_and_alignment(kind)
                at = -(-at // align) * align
                fields[field] = [self.base(kind), at] + ([length] if length else [])
                at += size * max(length, 1)
                most = max(most, align)
            self.structs[name] = {"size": -(-at // most) * most, "align": most, "fields": fields}
        return self.structs[name]


def interface(header):
    layout = Layout(header)
    for name in sorted(header.structs):
        if header.file_of[name] not in LEFT_OUT:
            layout.struct(name)
    choices = {name: value for kind, values in header.choices.items() if header.file_of[kind] not in LEFT_OUT for name, value in values}
    return {"structs": layout.structs, "choices": choices}


def exports(header):
    return sorted(name for name in header.functions if header.file_of[name] not in LEFT_OUT)


def called(header, names):
    """Those that the page calls by their whole names; of `windrow_wind_add_${kind}` and the like those of the kinds that it makes; defaults
    of settings."""
    text = "".join(path.read_text(encoding="utf-8") for folder in ("page", "package") for path in (ROOT / "bindings/web" / folder).glob("*.js"))
    words = set(re.findall(r"windrow_\w+(?:\$\{\w+\})?\w*", text))
    kinds = "|".join(kind for kind in set(re.findall(r'kind: "(\w+)"', text)) if f"windrow_{kind}_motor" in header.structs)
    forms = [re.compile(re.sub(r"\$\{\w+\}", f"({kinds})", word) + "$") for word in words if "$" in word]
    structs = {f"{word}_init" for word in words}
    defaults = {name for name in names if name.endswith("_init") and header.file_of[name] in ("config.h", "motors.h")}
    return [name for name in names if name in words | structs | defaults or any(form.match(name) for form in forms)]


def without_axes(names):
    """The page has the library's own axes: of calls that convert, those behind the conversion."""
    behind = set(re.findall(r"#define (\w+) own_", (ROOT / "c_api/source/axes_names.inl").read_text()))
    return [f"own_{name}" if name in behind else name for name in names]


def main():
    folder = pathlib.Path(sys.argv[1])
    header = Header(ROOT / "c_api")
    names = exports(header)
    for file, chosen in (("package", names), ("page", without_axes(called(header, names)))):
        (folder / f"{file}_exports.txt").write_text("".join(f"_{name}\n" for name in [*chosen, "malloc", "free"]))
    (folder / "interface.json").write_text(json.dumps(interface(header), separators=(",", ":")))


if __name__ == "__main__":
    main()
