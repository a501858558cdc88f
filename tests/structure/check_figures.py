#!/usr/bin/env python3
"""check_figures.py ROOT [--run figures.txt]: each bound and figure that README.md and docs/*.md print is the tests'.

A comment behind a paragraph, an item or in a table's row names what holds the numbers that are read there:

    <!-- figure: wind_parity.walk < 8.5e-7 <= 1e-5; sleep_jump_m_per_s <= 2e-3 as "2 mm/s" -->
    <!-- test: AirParity.EveryKindOfBoxAgreesAfterOneStepAndAfterAHundred <= 1e-5 -->
    <!-- test: cases/parity_story.h <= 1e-4 -->             a file; "case: jet_spreading" is a case of `windrow verify`
    <!-- none: measured once on an H200 -->                 no test can hold it; behind a table it is for all rows

`<= B` and `>= B` are bounds: the test's source must hold the figure to B. `= V`, `< V`, `> V` are what a run measured: V, at most V,
at least V, each within a fifth; `< V` of a V below 1e-5 within ten times, since rounding differs by processor. With --run they are
compared with the lines `[figure] name value bound` of a run, which ./dev test keeps in build/release/figures.txt. `*` in a name is anything; a bound is then that of one of them at least, `= V` the largest. Each
number must be read in that paragraph or row, as such, as a percentage, or as the words after `as`. A fault is also a bound, or a
number such as 2e-7, without such a comment; `Suite.Test` or `Suite*` in a page that no test has; a row of docs/systems.md that
names nothing that shows it.
"""
import argparse
import pathlib
import re
import sys

import check_words
import test_sources

COMMENT = re.compile(r"<!--\s*(figure|test|case|none):(.*?)-->", re.DOTALL)
CLAIM = re.compile(r'(?:(figure|test|case):)?\s*(?P<name>[^<>=]+?)(?P<limits>(?:\s*(?:<=|>=|=|<|>)\s*[-\d.e+/]+)*)(?:\s+as\s+"(?P<words>[^"]+)")?\s*$')
READ = re.compile(r"(?<![\w.])-?(?:\d{1,3}(?:,\d{3})+|\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?(?:\s*%)?")
# What no page may print without naming its test.
STATED = re.compile(r"(?<![\w.])([\d.]+e-\d+)|\bbounds?\b(?: of| is)? (\.?\d[\d.,]*(?:e-\d+)?)")
MADE = ("scene_keys.md", "report.md", "pipelines.md") # by commands, from tables of the sources or of a compiler
NAMED = re.compile(r"`([A-Z]\w*?)(?:\.([A-Z]\w*)?)?(\*?)`")
SHOWN = re.compile(r"\]\(|`[\w/]+\.(?:json|md|h)`|_bench|`windrow \w+`|not systems to show|not built")


def blocks(text):
    """(first line, last line, what is read, is a row) of each paragraph, item and row."""
    found = []
    for number, line, is_row, begins in check_words.prose(text):
        if is_row or begins or not found or found[-1][3]:
            found.append([number, number, line, is_row])
        else:
            found[-1][1], found[-1][2] = number, found[-1][2] + " " + line
    return found


def of_comment(all_blocks, line, kind):
    """The blocks that a comment on this line is for."""
    before = [block for block in all_blocks if block[0] <= line]
    if not before:
        return []
    chosen = [before[-1]]
    while kind == "none" and line > chosen[0][1] and chosen[0][3] and len(before) > len(chosen) and \
            before[-len(chosen) - 1][3] and before[-len(chosen) - 1][1] == chosen[0][0] - 1:
        chosen.insert(0, before[-len(chosen) - 1])
    return chosen


def values(text):
    found = set()
    for one in READ.findall(text):
        bare = float(one.rstrip("% ").replace(",", ""))
        found |= {bare, bare / 100.0} if one.endswith("%") else {bare}
    return found


def near(a, b):
    return abs(a - b) <= 1e-6 * max(abs(a), abs(b))


def quantity(text):
    top, _, bottom = text.partition("/")
    return float(top) / float(bottom) if bottom else float(top)


def measured(run, name):
    return [value for one, value in run if test_sources.meet(name, one)]


def off(sign, value, text):
    """Whether a run's value is outside of what a page prints for it."""
    stated = quantity(text)
    digits = re.sub(r"e.*", "", text).partition(".")[2]
    unit = 10.0 ** (int((re.search(r"e([+-]?\d+)", text) or [0, "0"])[1]) - len(digits)) # of the last digit that is printed
    slack = 9.0 * abs(stated) if sign == "<" and abs(stated) < 1e-5 else 0.2 * abs(stated)
    apart = (value - stated) / max(slack, unit)
    return abs(apart) > 1.0 if sign == "=" else apart > 1.0 if sign == "<" else apart < -1.0


def check_claim(kind, claim, text, sources, run):
    """Sentences of what is wrong with one claim."""
    parsed = CLAIM.fullmatch(claim.strip())
    if not parsed:
        return [f"'{claim.strip()}' is no claim: write figure: NAME < 8e-7 <= 1e-5."]
    name, limits = parsed["name"].strip(), re.findall(r"(<=|>=|=|<|>)\s*([-\d.e+/]+)", parsed["limits"])
    faults = []
    for _, limit in limits:
        if not parsed["words"] and not any(near(quantity(limit), value) for value in values(text)):
            faults.append(f"{limit} of {name} is not what is read there.")
    if parsed["words"] and parsed["words"] not in re.sub(r"\s+", " ", text):
        faults.append(f"'{parsed['words']}' of {name} is not read there.")
    if kind == "case":
        held = [(None, test_sources.numbers(one.text)) for one in sources.files
                if one.name.startswith("cases/") and f'"{name}"' in one.text]
    elif kind == "test" and "/" in name:
        file = sources.root / name
        if not file.exists():
            return [*faults, f"there is no {name}."]
        held = [(False, test_sources.numbers(file.read_text(encoding="utf-8")))]
    elif kind == "test":
        held = [(None, numbers) for test, numbers in sources.tests.items() if test_sources.meet(name, test)]
    else:
        held = [(least, bounds) for one, least, bounds, _ in sources.figures if test_sources.meet(name, one)]
    if not held:
        return [*faults, f"no {'test prints a figure' if kind == 'figure' else kind + ' is'} named {name}."]
    for sign, limit in limits:
        if sign in ("<=", ">="):
            bounds = [numbers for least, numbers in held if numbers and (least is None or least != (sign == "<="))]
            if not any(near(quantity(limit), bound) for numbers in bounds for bound in numbers):
                some = sorted({f"{bound:g}" for numbers in bounds if len(numbers) < 6 for bound in numbers})
                faults.append(f"the tests do not hold {name} to {limit}" + (f", but to {' or '.join(some)}." if some else "."))
        found = measured(run, name) if kind == "figure" and sign in "=<>" else []
        for value in [max(found)] if found and sign == "=" else found: # of several figures the page has the largest
            if off(sign, value, limit):
                faults.append(f"a run measured {value:g} for {name}, the page prints {limit}.")
    return faults


def check_page(name, text, sources, run, faults):
    all_blocks = blocks(text)
    held = {} # first line of a block: the numbers that are named, nothing where none has to be
    for comment in COMMENT.finditer(text):
        line = text.count("\n", 0, comment.start()) + 1
        chosen = of_comment(all_blocks, line, comment.group(1))
        kind = comment.group(1)
        if kind == "none":
            held |= {block[0]: None for block in chosen}
            continue
        for claim in re.split(r";\s*", re.sub(r"\s+", " ", comment.group(2)).strip().rstrip(";")):
            kind = (re.match(r"(figure|test|case):", claim) or [0, kind])[1]
            faults += [f"{name}:{line}: {fault}" for fault in check_claim(kind, claim, chosen[-1][2] if chosen else "", sources, run)]
            if chosen and held.setdefault(chosen[-1][0], set()) is not None:
                held[chosen[-1][0]] |= values(claim)
    for first, _, read, is_row in all_blocks:
        bare = re.sub(r"`[^`]*`", "", read)
        named = held.get(first, set())
        for one in STATED.finditer(bare) if named is not None and name.startswith(("README", "docs/")) else []:
            stated = (one[1] or one[2]).rstrip(".,")
            if not any(near(quantity(stated.replace(",", "")) / part, value) for part in (1.0, 100.0) for value in named):
                faults.append(f"{name}:{first}: {stated} names no test: add <!-- figure: NAME <= BOUND -->.")
        for suite, test, star in NAMED.findall(read):
            if (test or star) and not any(test_sources.meet(f"{suite}{'*' if star and not test else ''}.{test or '*'}{star}", one)
                                          for one in sources.tests):
                faults.append(f"{name}:{first}: there is no test `{suite}{'.' + test if test else ''}{star}`.")
        if name.endswith("systems.md") and is_row and not read.startswith(("| system |", "|---", "#")):
            tests = any(test or star for _, test, star in NAMED.findall(read))
            if not tests and first not in held and not SHOWN.search(text.splitlines()[first - 1]):
                faults.append(f"{name}:{first}: the row names no figure, test, scene or page that shows it.")


def check(root, run=()):
    sources = test_sources.Sources(root)
    faults = []
    for path in check_words.pages(root):
        if path.name not in MADE:
            check_page(path.relative_to(root).as_posix(), path.read_text(encoding="utf-8"), sources, run, faults)
    return faults


def read_run(path):
    """(name, value) of each line `[figure] name value bound` of a run."""
    lines = re.findall(r"^\[figure\] (.+?)\s+([-+\d.einfa]+)\s+(?:(?:<=|>=)\s+\S+|reported|\S+)\s*$",
                       path.read_text(encoding="utf-8"), re.MULTILINE)
    return [(name, float(value)) for name, value in lines]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--run", type=pathlib.Path, help="lines of figures that a run of the tests printed")
    options = parser.parse_args()
    faults = check(options.root, read_run(options.run) if options.run and options.run.exists() else ())
    print("\n".join(faults) if faults else "no fault")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
