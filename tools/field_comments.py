#!/usr/bin/env python3
"""field_comments.py [--check]: writes the comments of fields in the public headers of C++, which an editor shows on hover, from the
tables of settings, c_api/tables.json. `./dev schema` runs it.

A row of a struct's settings() or rows() whose name is that of its member gives the comment on the lines before the field: unit, range,
default and meaning. A row of another name is about a file of a scene: the field has a comment by hand.
--check writes nothing and names the fields whose comment is missing or another one.
"""
import argparse
import json
import pathlib
import re
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parent.parent
WIDTH = 130
TABLE = re.compile(r"^( *)(?:///.*\n *)?static constexpr auto (?:settings|rows)\(\) \{", re.MULTILINE)
OWNER = re.compile(r"^( *)(?:struct|class) (?:WINDROW_API )?(\w+)(?: final)?(?: : [^{;]*)? \{$", re.MULTILINE)
ROW = re.compile(r'(?:Setting|ReportRow)[({]\s*"(\w+)",\s*&(?:\w+::)*(\w+)')
FIELD = re.compile(r"(?P<before>(?:^ *///[^\n]*\n)*)^(?P<line>(?P<indent> +)[\w:<>, *&]+ (?P<name>\w+)(?: = [^;]*|\{[^;]*\})?;)"
                   r"(?P<behind> *///<[^\n]*(?:\n +///<[^\n]*)*)?$", re.MULTILINE)


class Fault(Exception):
    """A header and the tables do not fit."""


def default_of(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    text = json.dumps(value).strip('"')
    return re.sub(r"e-0", "e-", f"({text[1:-1]})" if isinstance(value, list) else text)


def comment_of(row, indent):
    """Unit, range, default and meaning, as lines."""
    head = [row["range"]] if "range" in row else []
    if "default" in row:
        head.append(f"default {default_of(row['default'])}")
    head = ", ".join(head)
    said = (f"[{row['unit']}] " if "unit" in row else "") + (f"{head[0].upper()}{head[1:]}. " if head else "") + row["meaning"]
    lines = textwrap.wrap(said, WIDTH - len(indent) - 4, break_long_words=False, break_on_hyphens=False)
    return "".join(f"{indent}/// {line}\n" for line in lines)


def end_of_braces(text, begin):
    depth, at = 1, begin
    while depth:
        token = re.compile(r'"(?:\\.|[^"\\])*"|//[^\n]*|[{}]').search(text, at)
        depth += {"{": 1, "}": -1}.get(token[0], 0)
        at = token.end()
    return at


def with_comments(text, tables, header, missing):
    """The header with the comments of its tables; `missing` gets a line for each field that a comment by hand lacks."""
    parts, done = [], 0
    for table in TABLE.finditer(text):
        rows = dict(ROW.findall(text[table.end():end_of_braces(text, table.end())]))
        owners = [owner for owner in OWNER.finditer(text, 0, table.start()) if end_of_braces(text, owner.end()) > table.start()]
        name = "::".join(owner[2] for owner in owners)
        if name not in tables:
            raise Fault(f"{header}: {name} has no table in c_api/tables.json: add it to tests/c_api/tables_test.cpp")
        values, members = {row["name"]: row for row in tables[name]}, {member: row for row, member in rows.items()}
        begin, indent, seen = owners[-1].end(), owners[-1][1] + "    ", set()

        def change(found):
            row = members.get(found["name"])
            if row is None or found["indent"] != indent:
                return found[0]
            seen.add(found["name"])
            if row != found["name"]:
                if not found["before"] and not found["behind"]:
                    missing.append(f"{header}: {name}::{found['name']} has no comment: write one, its row '{row}' is about scene files")
                return found[0]
            made = comment_of(values[row], indent) + found["line"]
            if made != found[0]:
                missing.append(f"{header}: the comment of {name}::{row} is not that of its row: run ./dev schema")
            return made

        parts += [text[done:begin], FIELD.sub(change, text[begin:table.start()])]
        done = table.start()
        if seen != set(members):
            raise Fault(f"{header}: {name} has no field {', '.join(sorted(set(members) - seen))} on a line of its own before its table")
    return "".join(parts) + text[done:]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--root", type=pathlib.Path, default=ROOT)
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    tables = json.loads((options.root / "c_api/tables.json").read_text(encoding="utf-8"))["structs"]
    names = (options.root / "cmake/public_headers.txt").read_text(encoding="utf-8").splitlines()
    missing = []
    try:
        for name in (name for name in names if name.endswith(".h") and not name.startswith("#") and name != "fluid/setting.h"):
            path = options.root / name
            text = path.read_text(encoding="utf-8")
            made = with_comments(text, tables, name, missing)
            if made != text and not options.check:
                path.write_text(made, encoding="utf-8")
                print(f"{name}: {len(made.splitlines())} lines")
    except Fault as fault:
        sys.exit(f"field_comments.py: {fault}")
    left = [line for line in missing if options.check or "by hand" in line or "has no comment" in line]
    print("\n".join(left), end="\n" if left else "")
    sys.exit(1 if left else 0)


if __name__ == "__main__":
    main()
