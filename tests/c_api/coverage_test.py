#!/usr/bin/env python3
"""coverage_test.py ROOT: every public function of the C++ API has a function of the C API, or a reason in coverage.txt. Every number of a
call has a kind for hosts of other axes (tools/c_kinds.py), and every call that converts is in a story of axes_*_test.cpp."""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "tools"))
import c_kinds
from c_header import Header
from make_bindings import comments_of

NO_NAMES = {"if", "while", "for", "return", "sizeof", "alignof", "static_assert", "requires", "noexcept", "defined", "operator", "decltype",
            "explicit", "assert"}


def plain(text):
    text = re.sub(r"//[^\n]*|/\*.*?\*/", " ", text, flags=re.DOTALL)
    text = re.sub(r"^\s*#.*$", " ", text, flags=re.MULTILINE)
    text = re.sub(r"\bWINDROW_(?:API|HIDDEN|INTERNAL)\b", " ", text)
    return re.sub(r'"(?:[^"\\\n]|\\.)*"', '""', text)


def body(text, begin):
    """The text between the brace that opens after `begin` and its end."""
    start = text.index("{", begin) + 1
    depth, at = 1, start
    while depth > 0:
        depth += {"{": 1, "}": -1}.get(text[at], 0)
        at += 1
    return text[start:at - 1]


def top_level(text, open_namespaces):
    """What is outside of braces and round brackets; braces of namespaces count as none."""
    out, depth, round_depth = [], 0, 0
    at = 0
    while at < len(text):
        if open_namespaces and depth == 0:
            found = re.compile(r"\bnamespace(?:\s+[\w:]+)?\s*\{").match(text, at)
            if found:
                inner = body(text, at)
                if "detail" not in found.group(0):
                    out.append(top_level(inner, True))
                at += len(found.group(0)) + len(inner) + 1
                continue
        letter = text[at]
        if letter == "{":
            depth += 1
        elif letter == "}":
            depth -= 1
            out.append(" ; ")
        elif letter == "(" and depth == 0:
            if round_depth == 0:
                out.append("(")
            round_depth += 1
        elif letter == ")" and depth == 0:
            round_depth -= 1
        elif depth == 0 and round_depth == 0:
            out.append(letter)
        at += 1
    return "".join(out)


def public_part(text):
    """Of a class: its public members."""
    parts = re.split(r"\b(public|private|protected):", "private: " + text)
    return " ".join(parts[n + 1] for n in range(1, len(parts), 2) if parts[n] == "public")


def members(text, name):
    """Names of the functions that a class, or the namespace of a header, offers."""
    text = plain(text)
    if name == "namespace":
        found = top_level(text, True)
    else:
        begin = re.search(rf"\bclass(?:\s+\[\[\w+\]\])?\s+{name}\b[^;{{]*\{{", text)
        found = top_level(public_part(body(text, begin.start())), False)
    names = {word for word in re.findall(r"(\w+)\s*\(", found)}
    return {word for word in names - NO_NAMES if word != name and re.match(r"[a-z]", word) and not word.endswith("_") and not word.startswith(("check_rules", "check_s"))}


def check(root, text):
    functions, faults, count = set(Header(root / "c_api").functions), [], 0
    for section in re.split(r"\n\n+", "\n".join(line for line in text.splitlines() if not line.startswith("#")).strip()):
        lines = section.strip().splitlines()
        name, header = lines[0].split()
        there = members((root / header).read_text(encoding="utf-8"), name)
        listed = {}
        for line in lines[1:]:
            member, rest = line.split(" ", 1)
            listed[member] = rest
            if not rest.startswith("- "):
                faults += [f"{header}: {name}::{member}: there is no {function} in C" for function in rest.split() if function not in functions]
        faults += [f"{header}: {name}::{member} has no function in C: write one, or a reason into tests/c_api/coverage.txt"
                   for member in sorted(there - set(listed))]
        if name != "namespace":  # functions within structs are not looked for
            faults += [f"{header}: {name}::{member} is listed, and is not there" for member in sorted(set(listed) - there)]
        count += len(there)
    return count, faults


def converted(root, more=""):
    """Faults of the calls that convert to the host's axes. `more`: text of one header more."""
    headers = {path.name: path.read_text(encoding="utf-8") for path in sorted((root / "c_api").glob("*.h"))} | {"more.h": more}
    try:
        calls = c_kinds.Kinds(Header(headers), comments_of(headers)).calls()
    except c_kinds.Fault as fault:
        return [str(fault)]
    stories = "".join(path.read_text(encoding="utf-8") for path in sorted((root / "tests/c_api").glob("axes*")))
    return [f"{call} converts to the host's axes, and no story of tests/c_api/axes_*_test.cpp calls it"
            for call in [*calls, *c_kinds.HAND_CALLS] if f"{call}(" not in stories]


def main():
    root = pathlib.Path(sys.argv[1])
    text = (pathlib.Path(__file__).parent / "coverage.txt").read_text(encoding="utf-8")
    count, faults = check(root, text)
    # The checker sees a call that is missing.
    blind = [] if check(root, text.replace("\nset_floor windrow_wind_set_floor\n", "\n", 1))[1] else ["a missing line is not found"]
    faults += converted(root)
    for what, more in {"a number": "WINDROW_C_API windrow_result windrow_new(float mystery);", "a result": "WINDROW_C_API float windrow_new(void);",
                       "a field": "typedef struct windrow_made {\n    windrow_vec3 mystery;\n} windrow_made;\n",
                       "a call without a story": "WINDROW_C_API windrow_result windrow_new(float radius);"}.items():
        blind += [] if converted(root, more) else [f"{what} without a kind is not found"]
    print(f"{count} functions of C++")
    print("\n".join(faults + blind))
    sys.exit(1 if faults or blind else 0)


if __name__ == "__main__":
    main()
