#!/usr/bin/env python3
"""check_words.py ROOT [--code]: the language of README.md, CONTRIBUTING.md, CHANGELOG.md and docs/*.md.

A sentence has 40 words at most and a page 18 in the mean; a line has 120 characters at most; the words of INSTEAD do not occur.
Tables may have longer lines. Code, headings, tables and pictures are no sentences, and code is not searched for words. --code
searches the comments of public headers and the messages of all production code too. --figures prints each page's figures.
"""
import argparse
import pathlib
import re
import sys

LONGEST_LINE, LONGEST_SENTENCE, LONGEST_MEAN = 120, 40, 18.0
CODE_FOLDERS = ("gpu", "fluid", "coupling", "c_api", "scene", "pictures", "vegetation", "cases", "cli")

INSTEAD = {
    r"sides|kinds? of side|(?:open|periodic) side": "boundary conditions, boundary kind",
    r"settl(?:e|es|ed|ing)": "relaxation to the ambient wind, relaxation time",
    r"rims?": "blend zone; of a region, edge",
    r"pieces?": "operators; parts",
    r"sources? of air|lets? air in": "volume source",
    r"given flow|solved part": "prescribed background wind, perturbation velocity",
    r"owe[sd]?": "accumulated diffusion time",
    r"surveys?|broken cells?": "reduction; non-finite cells; of land, elevation model",
    r"shares?": "fraction, weight; parts",
    r"tells?|told|says? so": "reported, returns, documented",
    r"refus(?:e|es|ed|ing|als?)": "rejects; validation error",
    r"whole files? or none|whole or not at all": "atomic write",
    r"deals?|folds?|folded": "interleave, even-odd split",
    # Values and functions are not persons, and a sentence is no riddle.
    r"knows?|lies|lets|lives": "returns, stores, is, holds",
    r"but for|at the moment|by chance": "except; now; random",
}
# A name after a point is a field in a code sample, {.share = 0.6f}; after < a tag of a format.
WORDS = re.compile("|".join(f"(?P<w{n}>(?<![.<])(?<!</)\\b(?:{words})\\b)" for n, words in enumerate(INSTEAD)), re.IGNORECASE)
# A point after these ends no sentence.
ABBREVIATIONS = re.compile(r"\b(?:al|e\.g|i\.e|cf|vs|eq|Fig|No|[A-Z])\.$")
ITEM = re.compile(r"^\s*(?:[-*+]|\d+\.)\s+")


def pages(root):
    return [root / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")] + sorted((root / "docs").rglob("*.md"))


def prose(text):
    """(line number, text, is a table's row, begins a paragraph) of each line outside of code, without links' and pictures' addresses."""
    text = re.sub(r"<!--.*?-->", lambda found: "\n" * found.group(0).count("\n"), text, flags=re.DOTALL)
    text = re.sub(r"!\[[^\]]*\]\([^)]*\)", lambda found: "\n" * found.group(0).count("\n"), text)
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    fenced, blank = False, True
    for number, line in enumerate(text.splitlines(), 1):
        if line.lstrip().startswith("```"):
            fenced, blank = not fenced, True
        elif fenced or (blank and line.startswith("    ") and not ITEM.match(line)):
            pass  # code; an indented block goes on as if its lines were blank
        elif not line.strip():
            blank = True
        else:
            heading = line.startswith("#")
            yield number, line, line.lstrip().startswith("|") or heading, blank or heading or bool(ITEM.match(line))
            blank = heading


def sentences(text):
    """(line number, words) of each sentence: from a paragraph's or an item's begin, or a sentence's end, to the next end."""
    words, start = [], 0
    for number, line, is_table, begins in prose(text):
        if (begins or is_table) and words:
            yield start, words
            words = []
        if is_table:
            continue
        line = re.sub(r"`[^`]*`", "code", ITEM.sub("", line, count=1))
        for token in re.sub(r"[*_]", "", line).split():
            if not words:
                start = number
            if any(letter.isalnum() for letter in token):
                words.append(token)
            bare = token.rstrip(")\"'")
            if words and bare.endswith((".", "!", "?")) and not ABBREVIATIONS.search(bare):
                yield start, words
                words = []
    if words:
        yield start, words


def words_to_replace(text):
    """The word and what to write instead, for each in this line outside of code spans and addresses."""
    for found in WORDS.finditer(re.sub(r"`[^`]*`", " ", text)):
        yield found.group(0), list(INSTEAD.values())[int(found.lastgroup[1:])]


def check_page(name, text, faults):
    """Mean and longest sentence of a page, in words."""
    table_lines = {number for number, _, is_table, _ in prose(text) if is_table}
    for number, line in enumerate(text.splitlines(), 1):
        bare = re.sub(r"\]\([^)]*\)", "]()", line)
        if len(bare) > LONGEST_LINE and number not in table_lines:
            faults.append(f"{name}:{number}: {len(bare)} characters: break the line at {LONGEST_LINE}.")
    for number, line, _, _ in prose(text):
        for word, instead in words_to_replace(line):
            faults.append(f"{name}:{number}: '{word}': write {instead}.")
    lengths = []
    for number, sentence in sentences(text):
        lengths.append(len(sentence))
        if len(sentence) > LONGEST_SENTENCE:
            faults.append(f"{name}:{number}: a sentence of {len(sentence)} words ('{' '.join(sentence[:6])} ...'): "
                          f"{LONGEST_SENTENCE} at most.")
    mean = sum(lengths) / len(lengths) if lengths else 0.0
    if mean > LONGEST_MEAN:
        faults.append(f"{name}: {mean:.1f} words a sentence in the mean: {LONGEST_MEAN:.0f} at most.")
    return mean, max(lengths, default=0), len(text.splitlines())


def check_code(root, faults):
    """Comments of public headers, and string literals of several words in all production code."""
    public = [line for line in (root / "cmake/public_headers.txt").read_text(encoding="utf-8").split("\n")
              if line and not line.startswith("#")]
    for path in sorted(path for folder in CODE_FOLDERS for path in (root / folder).rglob("*") if path.suffix in (".h", ".cpp", ".inl")):
        name = path.relative_to(root).as_posix()
        if name.startswith(("vegetation/tests/", "vegetation/bench/")):
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            texts = [text for text in re.findall(r'"((?:[^"\\]|\\.)*)"', line) if " " in text and "#include" not in line]
            if name in public and "//" in line:
                texts.append(line.split("//", 1)[1])
            for text in texts:
                for word, instead in words_to_replace(text):
                    faults.append(f"{name}:{number}: '{word}': write {instead}.")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--code", action="store_true", help="search public headers and messages too")
    parser.add_argument("--figures", action="store_true", help="print mean, longest sentence and lines of each page")
    options = parser.parse_args()
    faults = []
    for path in pages(options.root):
        name = path.relative_to(options.root).as_posix()
        mean, longest, lines = check_page(name, path.read_text(encoding="utf-8"), faults)
        if options.figures:
            print(f"{name:28} mean {mean:5.1f}, longest {longest:3d} words, {lines:4d} lines")
    if options.code:
        check_code(options.root, faults)
    print("\n".join(faults) if faults else "no fault")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
