#!/usr/bin/env python3
"""check_manual.py ROOT BUILD: docs/windrow.1 is what the programs in BUILD say, and the completion for bash offers the same words."""
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "tools"))
import make_manual

COMPLETE = """source "$1"; shift
compopt() { :; }
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=(); _windrow; printf '%s\\n' "${COMPREPLY[@]}"
"""


def completed(script, *words):
    done = subprocess.run(["bash", "-c", COMPLETE, "bash", script, *words], check=True, capture_output=True, text=True)
    return sorted(done.stdout.split())


def options_in(text):
    _, _, sections = make_manual.sections_of(text)
    return sorted(word for entries in sections.values() for name, _ in entries for part in name.split(",") for word in part.split()[:1]
                  if word.startswith("--"))


def check(root, build):
    if (root / "docs" / "windrow.1").read_text(encoding="utf-8") != make_manual.manual(build):
        yield "docs/windrow.1 is not what the programs say: run ./dev schema"
    script = root / "tools" / "completion" / "windrow.bash"
    program = str(build / "windrow")
    commands = sorted(name for name, _ in make_manual.sections_of(make_manual.help_of(program))[2]["Subcommands"])
    if completed(script, program, "") != commands:
        yield f"completion offers {completed(script, program, '')} where the commands are {commands}"
    for command in commands:
        expected = [option.partition("{")[0] for option in options_in(make_manual.help_of(program, command))]
        if completed(script, program, command, "--") != expected or "--help" not in expected:
            yield f"completion offers {completed(script, program, command, '--')} where {command} has {expected}"


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    found = list(check(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
    print("\n".join(found) if found else "the manual and completion are as the programs say")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
