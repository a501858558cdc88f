"""The installed headers as doxygen reads them. Their own comments are plain: `//` at the head of a file, `/* */` in C. A copy has the
marks that doxygen asks for, on the same lines, without the tables of settings, whose rows are the fields' comments already."""
import re

HEAD = re.compile(r"\A(?:// ?(.*)\n)+")


def installed(root):
    lines = (root / "cmake/public_headers.txt").read_text(encoding="utf-8").splitlines()
    return sorted(line for line in lines if line and not line.startswith("#"))


def sentence(text):
    """The first sentence of a header's head."""
    lines = []
    comment = re.match(r"/\*(.*?)\*/", text, flags=re.DOTALL)
    if comment:
        lines = [re.sub(r"^ ?\* ?", "", line).strip() for line in comment[1].strip().splitlines()]
    else:
        lines = [line.lstrip("/").strip() for line in HEAD.match(text)[0].splitlines()]
    paragraph = " ".join(lines).split("  ")[0]
    return re.match(r".*?(?:[.:](?= |$)|$)", paragraph)[0].rstrip(":.") + "."


def without_word_links(text):
    """A word such as Wind begins a sentence more often than it names the class; Wind::step and WindView are links."""
    def mark(found):
        parts = re.split(r"(`[^`]*`)", found[0])
        return "".join(part if n % 2 else re.sub(r"(?<![\w:%.<>*])[A-Z][a-z]+(?![\w<(]|::)", r"%\g<0>", part) for n, part in enumerate(parts))
    return re.sub(r"///<? (?!    ).*", mark, text)


def without_tables(text):
    """Blank lines in place of settings() and rows()."""
    while found := re.search(r"^ *static constexpr auto (?:settings|rows)\(\) \{", text, flags=re.MULTILINE):
        depth, end = 1, found.end()
        while depth:
            token = re.compile(r'"(?:\\.|[^"\\])*"|[{}]').search(text, end)
            depth += {"{": 1, "}": -1}.get(token[0], 0)
            end = token.end()
        text = text[:found.start()] + "\n" * text.count("\n", found.start(), end) + text[end:]
    return text


def cpp(text, name):
    head = HEAD.match(text)
    marked = re.sub(r"^// ?", "/// ", head[0], flags=re.MULTILINE).replace("/// ", f"/// \\file {name}\n/// ", 1)
    text = re.sub(r'^ *#include ".*\.glsl"$', "", text[head.end():], flags=re.MULTILINE)   # formulas of shaders, not for users
    text = re.sub(r"^ *static constexpr const char\* k_(?:name|meaning) = .*;$", "", text, flags=re.MULTILINE)   # of scene files
    text = re.sub(r"^ *friend .*$", "", text, flags=re.MULTILINE)   # doxygen links friends without a comment, and writes none
    return without_tables(without_word_links(marked + text))


def c(text, name):
    def mark(found):
        before = text[text.rfind("\n", 0, found.start()) + 1:found.start()]
        words = re.sub(r"#(?=\w)", r"\\#", found[0][2:])   # a directive is no link
        if found.start() == 0:
            return f"/** \\file {name}\n{words}"
        if "Made by ./dev schema" in words or words.startswith(" ---"):
            return found[0]
        return ("/**< " if before.strip() else "/** ") + words.lstrip()
    return re.sub(r"/\*(.*?)\*/", mark, text, flags=re.DOTALL)


def write(root, folder):
    """Writes the copies below folder/windrow; {header: the first sentence of its head}."""
    found = {}
    for name in installed(root):
        text = (root / name).read_text(encoding="utf-8")
        found[name] = sentence(text)
        copy = folder / "windrow" / name
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text((c if text.startswith("/*") else cpp)(text, f"windrow/{name}"), encoding="utf-8")
    return found
