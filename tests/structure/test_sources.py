"""The figures and tests of the C++ sources, and the bounds that they hold: read from the text, without a build.

A figure is a call of CALLS. Its name may be composed: what is no literal becomes `*`. Its bound may be an expression: it stands for
its value and for each number in it; names of constants are looked up, and for what a test computes all numbers of its file stand.
"""
import math
import re

CALLS = re.compile(r"\b(WINDROW_EXPECT_FIGURE|figure|expect_at_most|expect_at_least|expect_orders|expect_case|judge|print|report)\(")
# Helpers that print under another name: {} is the argument. The bound's place among the arguments.
HELPERS = {"judge": ("stability/{}/*_steps/*", 1), "print": ("stability/{}/*_steps/*", 1), "expect_orders": ("{}.*", 2),
           "expect_case": ("{}.*", None)}
NUMBER = re.compile(r"(?<![\w.])(?:0x[0-9a-fA-F.]+(?:p[+-]?\d+)?|(?:\d[\d']*\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)")
NAME = re.compile(r"(?<![\w.:>])[A-Za-z_]\w*(?![\w(:])")
TEST = re.compile(r"\bTEST(?:_F|_P)?\(\s*(\w+)\s*,\s*(\w+)\s*\)\s*\{")
FOLDERS = ("tests", "vegetation/tests", "cases")


def number(text):
    text = text.replace("'", "")
    return float.fromhex(text) if text.startswith("0x") else float(text)


def numbers(text):
    return {number(found) for found in NUMBER.findall(re.sub(r'"(?:[^"\\]|\\.)*"', '""', text))}


def closing(text, start):
    """The place of the bracket that closes the one at `start`, and the commas between at its own depth."""
    depth, commas, at = 0, [], start
    while at < len(text):
        letter = text[at]
        if letter == '"' or letter == "'" and not (text[at - 1].isdigit() and text[at + 1].isdigit()):
            at = re.compile(r"(?:[^%s\\]|\\.)*%s" % (letter, letter)).match(text, at + 1).end() - 1
        elif letter in "([{":
            depth += 1
        elif letter in ")]}":
            depth -= 1
            if depth == 0:
                return at, commas
        elif letter == "," and depth == 1:
            commas.append(at)
        at += 1
    return at, commas


def arguments(text, start):
    end, commas = closing(text, start)
    cuts = [start, *commas, end]
    return [text[a + 1:b].strip() for a, b in zip(cuts, cuts[1:])]


def parts(expression):
    """Operands of the sum at depth 0."""
    found, depth, last = [], 0, 0
    for at in re.finditer(r'"(?:[^"\\]|\\.)*"|\'.\'|[-+()\[\]{}]', expression):
        letter = at.group(0)
        depth += (letter in "([{") - (letter in ")]}")
        if letter == "+" and depth == 0:
            found.append(expression[last:at.start()].strip())
            last = at.end()
    return found + [expression[last:].strip()]


CHOICE = re.compile(r'[^+"]*\?\s*("(?:[^"\\]|\\.)*")\s*:\s*("(?:[^"\\]|\\.)*")')


def choices(expression):
    """One expression a way that `which ? "this" : "that"` may go."""
    for part in parts(expression):
        inner = re.sub(r"^(?:std::string)?\((.*)\)$", r"\1", part, flags=re.DOTALL).strip()
        if found := CHOICE.fullmatch(inner):
            return [way for taken in found.groups() for way in choices(expression.replace(part, taken, 1))]
    return [expression]


def meet(a, b):
    """Whether two names, each with `*` for anything, have a name in common."""
    if not a or not b:
        return not (a or b).strip("*")
    if a[0] == "*":
        return meet(a[1:], b) or meet(a, b[1:])
    if b[0] == "*":
        return meet(a, b[1:]) or meet(a[1:], b)
    return a[0] == b[0] and meet(a[1:], b[1:])


class Source:
    def __init__(self, name, text):
        self.name = name
        text = re.sub(r'R"(\w*)\(.*?\)\1"', '""', text, flags=re.DOTALL)
        self.text = re.sub(r'("(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)\')|//[^\n]*', lambda found: found.group(1) or "", text)
        self.constants = {}
        for found in re.finditer(r"\bconstexpr\b[^;=({]*?(\bk_\w+(?:\[\])?\s*=[^;]*);", self.text):
            for part in re.findall(r"(\bk_\w+)(?:\[\])?\s*=\s*((?:[^,({]|\([^)]*\)|\{.*\})+)", found.group(1), re.DOTALL):
                self.constants[part[0]] = part[1]

    def definition(self, name, before):
        """What the last local of this name before that place is made of."""
        found = list(re.finditer(r"\b%s\s*(?:=|\(|\{)\s*" % re.escape(name), self.text[:before]))
        for one in reversed(found):
            head = self.text[max(0, one.start() - 60):one.start()]
            if re.search(r"(?:std::string|char\s*\*(?:\s*const)?|auto|double|float|int|bool)\s*&?\s*$", head):
                if one.group(0).rstrip()[-1] == "=":
                    depth, at = 0, one.end()
                    while self.text[at] != ";" or depth:
                        depth += (self.text[at] in "([{") - (self.text[at] in ")]}")
                        at += 1
                    return self.text[one.end():at], one.start()
                return self.text[one.end():closing(self.text, one.end() - 1)[0]], one.start()
        return None

    def pattern(self, expression, before, depth=0):
        """The name that an expression makes, `*` for what only a run shows."""
        made = ""
        for part in parts(expression):
            part = re.sub(r'^std::string\((.*)\)$', r"\1", part, flags=re.DOTALL).strip()
            if re.fullmatch(r'"(?:[^"\\]|\\.)*"', part) or re.fullmatch(r"'.'", part):
                made += part[1:-1]
            elif re.fullmatch(r"\w+", part) and depth < 4 and (found := self.definition(part, before)):
                made += self.pattern(*found, depth + 1)
            else:
                made += "*"
        return re.sub(r"\*+", "*", made)

    def bound(self, expression, before, constants, depth=0):
        """The numbers that an expression may hold a figure to."""
        values, words = numbers(expression), expression
        for name in NAME.findall(re.sub(r'"(?:[^"\\]|\\.)*"', "", re.sub(r"[A-Z]\w*::\w+|std::\w+|\.\w+\s*=", " ", expression))):
            if name in constants and depth < 4:
                inner = self.bound(constants[name], before, constants, depth + 1)
            elif depth < 4 and (found := self.definition(name, before)):
                inner = self.bound(*found, constants, depth + 1)
            else:
                inner = numbers(self.text)
            values |= inner
            if len(inner) == 1:
                words = re.sub(r"\b%s\b" % name, repr(next(iter(inner))), words)
        words = re.sub(r"\bstd::(pow|exp|log|sqrt)\b|static_cast<\w+>", lambda found: found.group(1) or "", words)
        try: # arithmetic of numbers alone
            values.add(float(eval(words.replace("'", ""), {"__builtins__": {}}, vars(math))))
        except (SyntaxError, NameError, TypeError, ValueError, ZeroDivisionError, AttributeError, OverflowError):
            pass
        return values

    def figures(self, constants):
        """(name with `*`, whether its bound is the least, bounds or nothing) of each figure."""
        for found in CALLS.finditer(self.text):
            call, given = found.group(1), arguments(self.text, found.end() - 1)
            form, place = HELPERS.get(call, ("{}", 2))
            if call == "report":
                form = "wind_parity.{}" if len(given) == 3 else "{}"
            if not given or '"' not in given[0] and not re.fullmatch(r"\w+", given[0]):
                continue
            bounds = None
            if place is not None and len(given) > place:
                bounds = self.bound(given[place], found.start(), constants)
            for way in choices(given[0]):
                name = re.sub(r"\*+", "*", form.format(self.pattern(way, found.start())))
                # Where all of it is a parameter, any name is printed, and its callers have the bound.
                named = len(re.sub(r"stability/|_steps/|energy$|max$|wind_parity\.|[\W\d_]", "", name)) > 2
                if named or name != "*":
                    least = None if call == "figure" else call in ("expect_at_least", "expect_orders")
                    yield name, least, bounds if named else None

    def tests(self):
        """(suite, name, its text, with that of the functions of this file which it calls)."""
        for found in TEST.finditer(self.text):
            body = self.text[found.end() - 1:closing(self.text, found.end() - 1)[0]]
            for called in sorted(set(re.findall(r"\b([a-z_]\w*)(?:<[^<>;]*>)?\(", body))):
                for made in re.finditer(r"\b%s\([^;{}]*\)[^;{}()]*\{" % called, self.text):
                    body += self.text[made.start():closing(self.text, made.end() - 1)[0]]
            yield found.group(1), found.group(2), body


class Sources:
    def __init__(self, root):
        self.root = root
        files = sorted(path for folder in FOLDERS for path in (root / folder).rglob("*") if path.suffix in (".cpp", ".h"))
        self.files = [Source(path.relative_to(root).as_posix(), path.read_text(encoding="utf-8")) for path in files]
        shared = {name: value for one in self.files if one.name.endswith(".h") for name, value in one.constants.items()}
        self.figures, self.tests = [], {}
        for one in self.files:
            constants = {**shared, **one.constants}
            self.figures += [(*figure, one.name) for figure in one.figures(constants)]
            for suite, name, body in one.tests():
                held = numbers(body)
                for word in set(re.findall(r"\bk_\w+\b", body)) & set(constants):
                    held |= one.bound(constants[word], 0, constants)
                self.tests[f"{suite}.{name}"] = held
