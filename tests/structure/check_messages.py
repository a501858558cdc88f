#!/usr/bin/env python3
"""check_messages.py ROOT [--accept]: every message of the library and the command, against tests/structure/messages.txt, and that an
error is handed on whole.

The file is the list that a person has reviewed: each message once, sorted, with `<>` for each value between its words. A value at
either end is left out. --accept writes the file. Exits with 1 where the messages differ from it and prints the lines that do.
"""
import argparse
import pathlib
import re
import sys

FOLDERS = ("gpu", "fluid", "coupling", "c_api", "scene", "pictures", "vegetation", "cases", "cli")
NOT_SHIPPED = ("vegetation/tests/", "vegetation/bench/")
CALLS = re.compile(r"\b(?:Error\{|(?:reasons_?|errors?_?)\.add\(|detail::message\(|message\(|reject\w*\(|sentence\("
                   r"|fail\w*\(|fault\w*\(|require\w*\(|give_up\(|usage_error\()")
STRING = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
COMMENT_OR_STRING = re.compile(STRING.pattern + r"|//[^\n]*")
# Words, and the point or colon of a sentence: neither a heading nor a part of one.
SENTENCE = re.compile(r"[a-z]{2}.* .*(?:\.|: .*)$")


def arguments(text, begin):
    """The arguments of the call whose opening bracket ends at `begin`."""
    depth, start, at, parts = 1, begin, begin, []
    while at < len(text) and depth > 0:
        found = STRING.match(text, at)
        if found:
            at = found.end()
            continue
        if text[at] == "'" and text[at + 2:at + 3] == "'":
            at += 3
            continue
        if text[at] in "({[":
            depth += 1
        elif text[at] in ")}]":
            depth -= 1
        elif text[at] == "," and depth == 1:
            parts.append(text[start:at])
            start = at + 1
        at += 1
    return parts + [text[start:at - 1]]


def words_of(argument):
    """The literals of an argument, with <> for the code between them."""
    words, at = "", 0
    for found in STRING.finditer(argument):
        words += ("<>" if argument[at:found.start()].strip() else "") + found.group(1)
        at = found.end()
    return words + ("<>" if argument[at:].strip() else "")


def messages(text):
    """The messages of a source file, without the values at their ends."""
    text = COMMENT_OR_STRING.sub(lambda found: "" if found.group(0).startswith("//") else found.group(0), text)
    for found in CALLS.finditer(text):
        line = ""
        for argument in arguments(text, found.end()):
            words = words_of(argument)
            # A place and what is wrong there come as two arguments: fault("$.floor", "is empty").
            line += (" " if re.search(r"\w$", line) and re.match(r"\w", words) else "") + words
        line = re.sub(r"(?:<>)+", "<>", line.replace("\\n", " ").replace('\\"', '"'))
        while line != (bare := line.strip().removeprefix("<>").removesuffix("<>")):
            line = bare
        if SENTENCE.search(line):
            yield line


# An error that is made of another one's sentence loses its class: `failure()` hands on both.
HANDED_ON = re.compile(r"\bError\{[\w.>*\[\]()-]*\.error\(\)\}|\bError\{(?:detail::)?message\([^;]*\.error\(\)\)\}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--accept", action="store_true", help="write messages.txt")
    options = parser.parse_args()
    found, bare = set(), []
    for folder in FOLDERS:
        for path in (options.root / folder).rglob("*"):
            if path.suffix in (".h", ".cpp", ".inl") and not path.relative_to(options.root).as_posix().startswith(NOT_SHIPPED):
                text = path.read_text(encoding="utf-8")
                found |= {f"{folder}: {line}" for line in messages(text)}
                bare += [f"{path.relative_to(options.root)}: {match.group(0)}" for match in HANDED_ON.finditer(text)]
    file = options.root / "tests/structure/messages.txt"
    if options.accept:
        file.write_text("".join(line + "\n" for line in sorted(found)), encoding="utf-8")
    reviewed = set(file.read_text(encoding="utf-8").splitlines())
    for line in sorted(reviewed - found):
        print("no longer a message:", line)
    for line in sorted(found - reviewed):
        print("not reviewed:", line)
    print(f"{len(found)} messages")
    if bare:
        sys.exit("\n".join(bare) + "\nHand on the whole error: `failure()`, or `failure().after(place)`.")
    if found != reviewed:
        sys.exit("Review the lines by the rule of CONTRIBUTING.md, then run check_messages.py . --accept.")


if __name__ == "__main__":
    main()
