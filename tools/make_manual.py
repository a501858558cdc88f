#!/usr/bin/env python3
"""make_manual.py BUILD [--out FILE]: the page of the manual, docs/windrow.1, from what the programs in BUILD say with --help.

A test makes it again and compares, so that an option is described once, where it is parsed.
"""
import argparse
import pathlib
import re
import subprocess

HEAD = """.\\" Made by tools/make_manual.py from --help; change the text there.
.TH WINDROW 1 "" "Windrow" "User Commands"
.SH NAME
windrow, windrow\\-draw \\- wind for plants: play scenes, export VDB files, measure and draw
"""
FILES = """.SH FILES
Scenes to begin with are in share/windrow/scenes, their schema for editors beside them, and all keys in
share/doc/windrow/docs/scene_keys.md.
.SH ENVIRONMENT
The Vulkan loader's own variables choose drivers: see VK_DRIVER_FILES in its documentation.
.SH EXAMPLE
.nf
windrow run share/windrow/scenes/walk.json \\-\\-images \\-\\-vdb
.fi
"""
ENTRY = re.compile(r"^  (\S.*?)(?:  +(\S.*))?$")


def roff(text):
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + text if text[:1] in (".", "'") else text


def help_of(program, *words):
    return subprocess.run([program, *words, "--help"], check=True, capture_output=True, text=True).stdout


def sections_of(text):
    """The description, the usage, and each heading with its entries: pairs of a name and what it does."""
    description, usage, sections = [], "", {}
    heading = None
    for line in text.splitlines():
        if line.startswith("Usage: "):
            usage = line.removeprefix("Usage: ")
        elif re.fullmatch(r"\S.*:", line):
            heading = sections.setdefault(line[:-1], [])
        elif heading is not None and (entry := ENTRY.match(line)):
            heading.append([entry.group(1), entry.group(2) or ""])
        elif heading is not None and heading and line.startswith("   "):
            heading[-1][1] = f"{heading[-1][1]} {line.strip()}".strip()
        elif line.strip():
            if heading is None and not usage:
                description.append(line)
            else:
                sections.setdefault("Notes", []).append([line, ""])
    return " ".join(description), usage, sections


def page_of(title, text):
    description, usage, sections = sections_of(text)
    lines = [f".SH {title.upper()}", ".B " + roff(usage), ".PP", roff(description)]
    for heading, entries in sections.items():
        if heading in ("Subcommands", "Notes"):
            continue
        for name, what in entries:
            if name != "-h,--help":
                lines += [".TP", ".B " + roff(name.replace(",", ", ")), roff(what)]
    return lines


def manual(build):
    windrow = help_of(build / "windrow")
    _, usage, sections = sections_of(windrow)
    lines = [".SH SYNOPSIS", ".B " + roff(usage), ".br", ".B " + roff("windrow-draw [OPTIONS] scene..."), ".SH COMMANDS"]
    for name, what in sections["Subcommands"]:
        lines += [".TP", ".B " + roff(name), roff(what)]
    for name, _ in sections["Subcommands"]:
        lines += page_of(f"windrow {name}", help_of(build / "windrow", name))
    if (build / "windrow-draw").exists():
        lines += page_of("windrow-draw", help_of(build / "windrow-draw"))
    lines += [".SH EXIT STATUS"] + [roff(name) for name, _ in sections["Notes"]]
    return HEAD + "\n".join(lines) + "\n" + FILES


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parent.parent / "docs" / "windrow.1")
    arguments = parser.parse_args()
    arguments.out.write_text(manual(arguments.build), encoding="utf-8")


if __name__ == "__main__":
    main()
