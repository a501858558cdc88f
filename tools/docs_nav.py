#!/usr/bin/env python3
"""docs_nav.py [ROOT]: the order of the site's pages. It fails where a page is missing in it.

The order is that of README's table "What to read next": a row is a section, and a page is in the first row that names it. The pages
of docs/decisions follow docs/decisions/README.md, in the order of its table. A page's title is its first heading up to a colon.
"""
import pathlib
import re
import sys

LINK = re.compile(r"\[[^\]]*\]\(([^)#\s]+\.md)\)")
DECISIONS = "docs/decisions/README.md"


class Fault(Exception):
    """A sentence for the one who wrote a page."""


def pages(root):
    """All pages of the site but that of the reference."""
    return [root / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md")] + sorted((root / "docs").rglob("*.md"))


def title_of(path):
    found = re.search(r"^# ([^:\n]+)", path.read_text(encoding="utf-8"), flags=re.MULTILINE)
    if not found:
        raise Fault(f"{path}: there is no heading; begin the page with '# Title'")
    return found[1].strip().replace("`", "")


def sections(readme):
    """[(title, [page])] of the rows of the table."""
    table = re.search(r"^## What to read next\n+\|.*\n\|[-|]+\n((?:\|.*\n)+)", readme, flags=re.MULTILINE)
    if not table:
        raise Fault("README.md has no table below the heading 'What to read next', which gives the pages their order")
    found, taken = [], set()
    for row in table[1].splitlines():
        reader, rest = row.strip("| ").split("|", 1)
        names = [name for name in dict.fromkeys(LINK.findall(rest)) if name not in taken]
        taken.update(names)
        reader = re.sub(r"^an? ", "", reader.strip())
        found.append((reader[0].upper() + reader[1:], names))
    return found


def navigation(root):
    """As mkdocs takes it."""
    found = []
    named = {"README.md"}

    def entry(name):
        if not (root / name).exists():
            raise Fault(f"README.md names {name} in 'What to read next': there is no such page")
        named.add(name)
        if name != DECISIONS:
            return {title_of(root / name): name}
        parts = dict.fromkeys(f"docs/decisions/{other}" for other in LINK.findall((root / name).read_text(encoding="utf-8")) if "/" not in other)
        return {title_of(root / name): [name] + [entry(part) for part in parts]}

    for title, names in sections((root / "README.md").read_text(encoding="utf-8")):
        found.append({title: [entry(name) for name in names]})
    left = [path.relative_to(root).as_posix() for path in pages(root) if path.relative_to(root).as_posix() not in named]
    if left:
        raise Fault(f"no row of README's table 'What to read next' names {', '.join(left)}: add each where its readers look")
    return [{"Windrow": "README.md"}] + found + [{"Reference": "api.md"}]


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent.parent)
    try:
        navigation(root)
    except Fault as fault:
        sys.exit(f"docs_nav.py: {fault}")
    print(f"{len(pages(root))} pages are in the navigation")


if __name__ == "__main__":
    main()
