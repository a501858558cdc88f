#!/usr/bin/env python3
"""rename_scene.py FILE...: gives the keys of scene files the names that they have now (scene/renamed_keys.inl).

Everything else of a file stays as it is, layout included. A file that would change is written again beside itself and then renamed.
"""
import json
import os
import pathlib
import re
import sys

TABLE = pathlib.Path(__file__).resolve().parent.parent / "scene" / "renamed_keys.inl"


def renamed_keys():
    return dict(re.findall(r'^\{"(\w+)", "(\w+)"\},$', TABLE.read_text(encoding="utf-8"), re.MULTILINE))


def rename(text, names):
    """The text with each old key replaced; strings that are values stay."""
    count = 0

    def key(found):
        nonlocal count
        new = names.get(found.group(1))
        count += new is not None
        return f'"{new}"{found.group(2)}' if new else found.group(0)

    return re.sub(r'"((?:[^"\\]|\\.)*)"(\s*:)?', lambda found: key(found) if found.group(2) else found.group(0), text), count


def main():
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        print(__doc__, file=sys.stderr)
        return 2
    status = 0
    for name in sys.argv[1:]:
        file = pathlib.Path(name)
        try:
            text = file.read_text(encoding="utf-8")
            json.loads(text)
        except (OSError, ValueError) as error:
            print(f"{name}: is not a scene: {error}", file=sys.stderr)
            status = 2
            continue
        now, count = rename(text, renamed_keys())
        if now != text:
            part = file.with_name(file.name + ".part")
            part.write_text(now, encoding="utf-8")
            os.replace(part, file)
        print(f"{name}: {count} key{'' if count == 1 else 's'} renamed")
    return status


if __name__ == "__main__":
    sys.exit(main())
