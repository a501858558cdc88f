#!/usr/bin/env python3
"""check_examples.py ROOT [--compiler CXX --headers FOLDER] [--program PATH]...: what README.md, CONTRIBUTING.md and docs/*.md show works.

C++: each ```cpp block compiles, as a program or as a function's body, all in one translation unit. What a block needs before it is in
an HTML comment above it, <!-- cpp ... -->. A program is run with --link, and prints what a comment below it says,
<!-- prints: REGULAR EXPRESSION -->. Commands: `windrow ...`, `windrow-draw ...` and `./dev ...` in code name existing
subcommands and options, by the help of each PATH; docs/scenes.md names every option of `windrow run`. Links: files and headings exist. Without --compiler, --link or --program that
part is left out.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

BLOCK = re.compile(r"(?:<!-- cpp\n(?P<before>.*?)-->\s*)?^```cpp\n(?P<code>.*?)^```", re.DOTALL | re.MULTILINE)
OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]*")


def pages(root):
    return [root / name for name in ("README.md", "CONTRIBUTING.md")] + sorted((root / "docs").rglob("*.md"))


def line_of(text, place):
    return text.count("\n", 0, place) + 1


# --- C++ -------------------------------------------------------------------------------------------------------------------


def translation_unit(examples):
    """C++ of all (page, line of the block, what comes before it, block)."""
    includes, body = [], []
    for number, (page, line, before, code) in enumerate(examples):
        for text in (before, code):
            includes += [include for include in re.findall(r"^#include .*$", text, re.MULTILINE) if include not in includes]
        before, code = (re.sub(r"^#include .*$", "", text, flags=re.MULTILINE) for text in (before, code))
        shown = f'#line {line} "{page}"\n{code}'
        function = shown if "int main(" in code else f"[[maybe_unused]] int example() {{\n{shown}\nreturn 0;\n}}\n"
        body.append(f"namespace example_{number} {{\n{before}\n{function}\n}}\n")
    return "\n".join(includes + body)


def check_code(compiler, folders, texts, faults):
    examples = [(page, line_of(text, found.start("code")), found["before"] or "", found["code"])
                for page, text in texts.items() for found in BLOCK.finditer(text)]
    run = subprocess.run([compiler, "-std=c++20", "-fsyntax-only", "-Werror=unused-result", *(f"-I{folder}" for folder in folders), "-x", "c++", "-"],
                         input=translation_unit(examples), capture_output=True, text=True, check=False)
    if run.returncode != 0:
        errors = [line for line in run.stderr.splitlines() if "error:" in line]
        faults += errors or [run.stderr]
    return len(examples)


def run_programs(compiler, folders, libraries, texts, faults):
    """Runs each block that is a program of the core alone."""
    count = 0
    for page, text in texts.items():
        for found in BLOCK.finditer(text):
            if "int main(" not in found["code"]:
                continue
            where = f"{page}:{line_of(text, found.start('code'))}"
            wanted = re.match(r"\s*<!-- prints: (.*?) ?-->", text[found.end():])
            if not wanted:
                faults.append(f"{where}: say what the program prints, in <!-- prints: ... --> below it")
                continue
            count += 1
            with tempfile.TemporaryDirectory() as folder:
                program = pathlib.Path(folder) / "program"
                made = subprocess.run([compiler, "-std=c++20", "-O1", *(f"-I{each}" for each in folders), "-x", "c++", "-", "-x", "none",
                                       *libraries, "-pthread", "-o", program],
                                      input=(found["before"] or "") + found["code"], capture_output=True, text=True, check=False)
                ran = made if made.returncode else subprocess.run([program], capture_output=True, text=True, check=False, timeout=60)
                if ran.returncode or not re.fullmatch(wanted[1], ran.stdout.strip()):
                    faults.append(f"{where}: prints '{ran.stdout.strip()}', not '{wanted[1]}' {ran.stderr}")
    return count


# --- Commands --------------------------------------------------------------------------------------------------------------


def code_of(text):
    """(line number, code, is a span within a line) of each line of a block and of each span."""
    fenced, block, begun = False, True, None
    for number, line in enumerate(text.splitlines(), 1):
        if line.lstrip().startswith("```"):
            fenced, block = not fenced, True
        elif fenced or (block and line.startswith("    ")):
            begun = (begun[0], begun[1] + line.strip()) if begun else (number, line.strip())
            if begun[1].endswith("\\"):
                begun = (begun[0], begun[1][:-1])
                continue
            yield *begun, False
            begun = None
        else:
            block = not line.strip() or line.startswith("#")
            for span in re.findall(r"`([^`]+)`", line):
                yield number, span, True


def help_of(*command):
    return subprocess.run([*command, "--help"], capture_output=True, text=True, check=True).stdout


def known_options(program):
    """Options by subcommand, of the program itself under ''."""
    text = help_of(program)
    subcommands = re.search(r"^Subcommands:\n((?: +.*\n)+)", text, re.MULTILINE)
    names = re.findall(r"^  ([\w-]+)", subcommands[1], re.MULTILINE) if subcommands else []
    return {"": set(OPTION.findall(text)), **{name: set(OPTION.findall(help_of(program, name))) for name in names}}


def check_commands(texts, programs, dev, faults):
    """`programs`: options by program's name; `dev`: the script's text."""
    every = set(OPTION.findall(dev)).union(*(options for known in programs.values() for options in known.values()))
    subcommands = {name for known in programs.values() for name in known if name}
    count = 0
    for page, text in texts.items():
        for number, line, is_span in code_of(text):
            for command in re.split(r"&&|;|\||#", line):
                words = command.split()
                name = words[0].rsplit("/", 1)[-1] if words else ""
                if name in subcommands and OPTION.match("".join(words[1:2])):
                    words, name = ["windrow", *words], "windrow"  # `verify --case NAME`
                if name == "dev" and len(words) > 1 and not re.search(rf"^\./dev {words[1]}\b", dev, re.MULTILINE):
                    faults.append(f"{page}:{number}: ./dev has no command '{words[1]}'")
                elif name in programs and len(words) > 1:
                    count += 1
                    known = programs[name]
                    subcommand = "" if len(known) == 1 or words[1].startswith("-") else words[1]
                    unknown = [option for option in OPTION.findall(command) if option not in known.get(subcommand, ())]
                    if subcommand not in known:
                        faults.append(f"{page}:{number}: {name} has no command '{subcommand}'")
                    elif unknown:
                        faults.append(f"{page}:{number}: {name} {subcommand} has no option '{unknown[0]}'")
                elif is_span and OPTION.match(name) and OPTION.match(name)[0] not in every:
                    faults.append(f"{page}:{number}: no program has an option '{name}'")
    return count


def check_options(program, known, text, page, faults):
    """A page that lists the options of a command lists them all."""
    flags = {word for span in re.findall(r"`([^`\n]+)`|^ {4}(.*)$", text, re.MULTILINE) for part in span for word in OPTION.findall(part)}
    faults.extend(f"{page}: {program} has the option {option}, and the page does not" for option in sorted(known - flags - {"--help"}))


# --- Links -----------------------------------------------------------------------------------------------------------------


def anchors(text):
    """Those that GitHub gives to headings."""
    return {re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-") for heading in re.findall(r"^#+ (.*)$", text, re.MULTILINE)}


def check_links(root, texts, faults):
    for page, text in texts.items():
        for found in re.finditer(r"\]\(([^)\s]+)\)", re.sub(r"`[^`\n]*`", lambda code: " " * len(code[0]), text)):
            target, _, anchor = found[1].partition("#")
            file = (root / page).parent / target if target else root / page
            if "://" in target:
                continue
            if not file.exists():
                faults.append(f"{page}:{line_of(text, found.start())}: there is no {target}")
            elif anchor and anchor not in anchors(file.read_text(encoding="utf-8")):
                faults.append(f"{page}:{line_of(text, found.start())}: {file.name} has no heading '{anchor}'")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--compiler")
    parser.add_argument("--headers", type=pathlib.Path, help="folder in which the public headers are windrow/...")
    parser.add_argument("--link", action="append", default=[], help="a library of the core")
    parser.add_argument("--program", action="append", default=[], help="windrow or windrow-draw")
    options = parser.parse_args()
    root = options.root.resolve()
    texts = {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8") for path in pages(root)}
    faults, done = [], []
    check_links(root, texts, faults)
    if options.compiler:
        done.append(f"{check_code(options.compiler, (options.headers, root), texts, faults)} blocks of C++")
    if options.link:
        done.append(f"{run_programs(options.compiler, (options.headers, root), options.link, texts, faults)} programs run")
    if options.program:
        programs = {pathlib.Path(program).name: known_options(program) for program in options.program}
        check_options("windrow run", programs.get("windrow", {}).get("run", set()), texts["docs/scenes.md"], "docs/scenes.md", faults)
        done.append(f"{check_commands(texts, programs, (root / 'dev').read_text(encoding='utf-8'), faults)} commands")
    print("\n".join(faults) if faults else f"no fault in the links{''.join(f', {part}' for part in done)}")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
