#!/usr/bin/env python3
"""make_bindings.py [--check]: the C interface and its mirrors from the tables of settings, c_api/tables.json. `./dev schema` runs it.

A comment in a header of c_api, before a struct or a choice, names the struct or the enumeration of C++ that it is made from:

    /* Made by ./dev schema from Canopy. */
    typedef struct windrow_canopy {

A row of the table that the C struct lacks becomes a field at its end; the comments of fields are those of the rows. Fields keep their
order for good, since it is the binary interface. "by hand: NAME, NAME" lists rows and fields that are left alone: what C has in
another form. From the headers follow the lists of fields in c_api/source, the mirrors in Python, C# and Rust (mirrors.py), and the settings of
the Python package (python_classes.py).
--check writes nothing and names the files that differ.
"""
import argparse
import ctypes
import json
import pathlib
import re
import sys
import textwrap

import c_kinds
import mirrors
import python_classes
from c_header import Header, common, fields_of

ROOT = pathlib.Path(__file__).resolve().parent.parent
WIDTH = 130
MARK = r"/\* Made by \./dev schema from ([\w:]+)(?:; by hand: ([\w, ]+))?\. \*/\n"
STRUCT = re.compile(MARK + r"typedef struct (windrow_\w+) \{\n(.*?)\} \3;\n", re.DOTALL)
CHOICE = re.compile(MARK + r"typedef int32_t (windrow_\w+);\nenum \{(.*?)\};\n", re.DOTALL)
LISTS = {"tables.h": ("config.h", "ambient.h", "wind.h", "motors.h", "obstacles.h", "drag.h"), "plant_tables.h": ("plants.h", "motion.h")}
BEGIN, END = "// --- Made by ./dev schema ", "// --- End of what ./dev schema makes "
NUMBERS = {"bool": "int32_t", "int32": "int32_t", "int64": "int64_t", "uint32": "uint32_t", "float": "float", "double": "double"}


class Fault(Exception):
    """The tables ask for what C cannot have, or what would break its binary interface."""


def snake(name):
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name.replace("::", "")).lower()


def comment(text, indent="    "):
    """A comment on lines of its own."""
    lines = textwrap.wrap(text, WIDTH - len(indent) - 6, break_long_words=False, break_on_hyphens=False)
    return "".join(f"{indent}{'   ' if n else '/* '}{line}" + ("\n" if n + 1 < len(lines) else " */\n") for n, line in enumerate(lines))


class Interface:
    """The headers of c_api by name, with the tables that they are made from."""

    def __init__(self, tables, headers):
        self.tables, self.headers = tables, dict(headers)
        marks = [found for text in headers.values() for form in (STRUCT, CHOICE) for found in form.finditer(text)]
        self.c_names = {found.group(1): found.group(3) for found in marks}
        if len(marks) != sum(text.count("Made by ./dev schema from") for text in headers.values()):
            raise Fault("a comment 'Made by ./dev schema from ...' in c_api/*.h has no struct or choice behind it")
        for found in marks:
            if found.group(1) not in {**tables["structs"], **tables["choices"]}:
                raise Fault(f"{found.group(3)} is made from {found.group(1)}, which has no table: add it to tests/c_api/tables_test.cpp")
        self.parsed = Header(self.headers)
        for form, remake in ((CHOICE, self._choice), (STRUCT, self._struct)):
            for name, text in self.headers.items():
                self.headers[name] = form.sub(remake, text)
            self.parsed = Header(self.headers)

    # --- Choices ---------------------------------------------------------------------------------------------------------
    def _choice(self, found):
        cpp, _, c_name, body = found.groups()
        there = re.findall(r"(\w+) = (\d+),?\s*(?:/\* (.*?) \*/)?", body)
        prefix = common([name for name, _, _ in there])
        values = [prefix + word.upper() for word in self.tables["choices"][cpp]]
        for name, value, _ in there:
            if int(value) >= len(values) or values[int(value)] != name:
                raise Fault(f"{name} = {value} is not value {value} of {cpp}: values are for good, new ones come last")
        said = {name: text for name, _, text in there if text}
        rows = [f"{name} = {n}" + ("," if n + 1 < len(values) else "") for n, name in enumerate(values)]
        line = f"enum {{ {' '.join(rows)} }};\n"
        if said or len(line) > WIDTH + 1:
            wide = max(map(len, rows))
            rows = [f"    {row:{wide}} /* {said[name]} */" if name in said else "    " + row for row, name in zip(rows, values)]
            line = "enum {\n" + "\n".join(rows) + "\n};\n"
        return found.group(0).partition("typedef")[0] + f"typedef int32_t {c_name};\n" + line

    # --- Structs ---------------------------------------------------------------------------------------------------------
    def _struct(self, found):
        cpp, by_hand, c_name, body = found.groups()
        by_hand = set(re.split(r",\s*", by_hand)) if by_hand else set()
        rows = {row["name"]: row for row in self.tables["structs"][cpp]}
        text, there = "", []
        for declaration, said in declarations(body):
            kind, name, length = next(iter(fields_of(declaration)))
            there.append(name)
            row = rows.get(name) if name not in by_hand else None
            if row is None and name not in by_hand and name != "struct_size" and not name.startswith("reserved"):
                raise Fault(f"{c_name}.{name} has no row in {cpp}: fields are for good: list it in 'by hand', call it reserved, or delete it "
                            "if no release has it")
            row = row or self._part_of(name, rows)
            said = self.meaning(row, kind) if row else said
            text += (comment(said) if said else "") + f"    {declaration};\n"
        for name in (name for name in rows if name not in there and name not in by_hand):
            if there[0] != "struct_size":
                raise Fault(f"{c_name} has no struct_size and cannot grow: list {name} in 'by hand'")
            text = self._grown(c_name, text, self.c_type(rows[name]["type"], f"{cpp}::{name}"), rows[name])
        made = found.group(0).partition("typedef")[0] + f"typedef struct {c_name} {{\n{text}}} {c_name};\n"
        if there[0] == "struct_size" and f"{c_name}_init" not in self.parsed.functions:
            made += f"WINDROW_C_API windrow_result {c_name}_init({c_name}* {c_name.split('_')[-1]}, uint32_t struct_size);\n"
        return made

    def _part_of(self, name, rows):
        """The row of ticks.hz for the field ticks_hz."""
        for owner in rows.values():
            for row in self.tables["structs"].get(owner["type"], ()):
                if name == f"{owner['name']}_{row['name']}":
                    return row
        return None

    def _grown(self, c_name, text, kind, row):
        """The fields with one more at the end, where fields named reserved leave no padding."""
        field = comment(self.meaning(row, kind)) + f"    {kind} {row['name']};\n"
        for text in (text, text + self._reserved(text)):
            grown = text + field
            if self._bytes(grown)[0] == self._bytes(text)[0] + ctypes.sizeof(self.parsed.ctype(kind)):
                break
        else:
            raise Fault(f"{c_name} would have a gap before {row['name']}")
        used, whole = self._bytes(grown)
        return grown + (self._reserved(grown) if whole > used else "")

    def _bytes(self, text):
        """Where the last of some fields ends, and the size of their struct."""
        parsed = Header({**self.headers, "": f"typedef struct windrow_made {{\n{text}}} windrow_made;\n"})
        kind = parsed.ctype("windrow_made")
        last = getattr(kind, kind._fields_[-1][0])
        return last.offset + last.size, ctypes.sizeof(kind)

    @staticmethod
    def _reserved(text):
        count = len(re.findall(r"\breserved\w*;", text))
        return f"    /* 0 */\n    uint32_t reserved{f'_{count + 1}' if count else ''};\n"

    def c_type(self, kind, place):
        if kind in NUMBERS:
            return NUMBERS[kind]
        if re.fullmatch(r"[diu]?vec\d|quat", kind):
            return f"windrow_{kind}"
        struct = kind.removeprefix("optional ")
        c_name = self.c_names.get(struct)
        if c_name and struct in self.tables["structs"]:
            versioned = self.parsed.structs[c_name][0][1] == "struct_size"
            if versioned or kind == struct:
                return f"const {c_name}*" if versioned else c_name
        if c_name is None or kind != struct:
            raise Fault(f"{place} is of a type that C has no form of ({kind}): convert it by hand and list it in 'by hand'")
        return c_name

    def meaning(self, row, kind):
        """Unit, range, default and meaning of a row, for C."""
        head = [row["range"]] if "range" in row else ["0 or 1"] if row["type"] == "bool" else []
        if "default" in row:
            head.append(f"default {self._default(row)}")
        head = ", ".join(head)
        init = f"{kind.removeprefix('const ').rstrip('*')}_init"
        said = re.sub(r"\{\} for ", f"{init} for ", row["meaning"])
        said = re.sub(r"\b(\w+)::(\w+)(?:\(\))?", self._named, said)
        if kind.endswith("*") and row["type"] != "other":
            said += " Null: none." if row["type"].startswith("optional") else " Null: the defaults."
        unit = f"[{row['unit']}] " if "unit" in row else ""
        return unit + (f"{head[0].upper()}{head[1:]}. " if head else "") + said

    def _named(self, found):
        """The function or the field of C that a member of C++ is."""
        owner = f"windrow_{snake(found.group(1))}"
        if f"{owner}_{found.group(2)}" in self.parsed.functions:
            return f"{owner}_{found.group(2)}"
        return f"{owner}.{found.group(2)}" if owner in self.parsed.structs else found.group(0)

    def _default(self, row):
        value = row["default"]
        if row["type"] in self.c_names:
            values = self.parsed.choices[self.c_names[row["type"]]]
            return values[self.tables["choices"][row["type"]].index(value)][0]
        text = json.dumps(int(value) if isinstance(value, bool) else value).strip('"')
        return re.sub(r"e-0", "e-", f"({text[1:-1]})" if isinstance(value, list) else text)

    # --- Lists of fields -------------------------------------------------------------------------------------------------
    def lists(self, headers):
        """The rows of c_api/source for the structs of these headers."""
        text = ""
        for header in headers:
            text += f"// {header}\n"
            for cpp, by_hand, c_name, _ in STRUCT.findall(self.headers[header]):
                rows = [row["name"] for row in self.tables["structs"][cpp]]
                names = [name for name in rows if name not in re.split(r",\s*", by_hand)]
                others = len(rows) - len(names)
                begin = f"WINDROW_C_STRUCT_BUT({others}, " if others else "WINDROW_C_STRUCT("
                text += textwrap.fill(f"{begin}{c_name}, {cpp}, {', '.join(names)});", WIDTH, break_long_words=False,
                                      subsequent_indent=" " * (begin.index("(") + 1)) + "\n"
        return text


def declarations(body):
    """(declaration, comment) of each field; a comment is on the lines before it, or behind it."""
    found = []
    pending = ""
    for token in re.finditer(r"/\*(.*?)\*/|([^;/]+);", body, flags=re.DOTALL):
        if token.group(2):
            found += [[f"{kind} {name}" + (f"[{length}]" if length else ""), pending] for kind, name, length in fields_of(token.group(2))]
            pending = ""
        else:
            text = " ".join(token.group(1).split())
            if found and "\n" not in body[body.rfind(";", 0, token.start()):token.start()]:
                found[-1][1] = text
            else:
                pending = text
    return found


def comments_of(headers):
    """{struct.field: comment} of the texts of headers."""
    return {f"{found.group(1)}.{next(iter(fields_of(declaration)))[1]}": said for text in headers.values()
            for found in re.finditer(r"typedef struct (windrow_\w+) \{\n(.*?)\} \1;\n", text, flags=re.DOTALL)
            for declaration, said in declarations(found.group(2))}


def between(text, made, name):
    """A text with what is between its marks replaced."""
    found = re.fullmatch(rf"(.*\n{re.escape(BEGIN)}[^\n]*\n).*?(\n?{re.escape(END)}.*)", text, flags=re.DOTALL)
    if not found:
        raise Fault(f"{name} has no marks of what ./dev schema makes")
    return found.group(1) + made + found.group(2).lstrip("\n")


def made_files(root, tables=None):
    """{path: text} of all that is made."""
    tables = tables or json.loads((root / "c_api/tables.json").read_text(encoding="utf-8"))
    headers = {path.name: path.read_text(encoding="utf-8") for path in sorted((root / "c_api").glob("*.h"))}
    interface = Interface(tables, headers)
    files = {root / "c_api" / name: text for name, text in interface.headers.items()}
    for name, parts in LISTS.items():
        path = root / "c_api/source" / name
        files[path] = between(path.read_text(encoding="utf-8"), interface.lists(parts), name)
    for name, text in c_kinds.made(interface.parsed, comments_of(interface.headers)).items():
        files[root / "c_api/source" / name] = text
    for name, text in mirrors.mirrors(interface.parsed).items():
        files[root / name] = text
    package = root / "bindings/python/windrow"
    files[package / "settings.py"] = python_classes.Classes(interface, declarations).text()
    files[package / "_version.py"] = python_classes.version(root)
    return files


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--root", type=pathlib.Path, default=ROOT)
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    try:
        files = made_files(options.root)
    except (Fault, c_kinds.Fault) as fault:
        sys.exit(f"make_bindings.py: {fault}")
    other = [path for path, text in files.items() if not path.exists() or path.read_text(encoding="utf-8") != text]
    for path in other:
        if options.check:
            print(f"{path.relative_to(options.root)} is not what the tables give: run ./dev schema")
        else:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text := files[path], encoding="utf-8")
            print(f"{path.relative_to(options.root)}: {len(text.splitlines())} lines")
    sys.exit(1 if options.check and other else 0)


if __name__ == "__main__":
    main()
