#!/usr/bin/env python3
"""make_docs.py BUILD [--accept]: a site of static files, BUILD/site, from README, docs/ and the installed headers. ./dev docs runs it.

    BUILD/site/index.html  README, with the page of a meadow where BUILD/web/windrow.html is there (./dev web)
    BUILD/site/docs        the pages of docs/, in the order of README's table "What to read next" (docs_nav.py)
    BUILD/site/api         the reference of C++ and C, by doxygen, from headers that docs_headers.py makes ready
    BUILD/site/search      the index of both, as a script, because a page on a disk can fetch no file

The site names no other server and opens from a disk. BUILD/docs has what mkdocs and doxygen read. The tool fails where doxygen or
mkdocs warns, and where a link, an anchor, a picture or a script of the site leads nowhere (docs_links.py). It also fails where a header
has another number of declarations without a comment of their own than tools/docs/undocumented.txt says; --accept writes that file.
"""
import argparse
import collections
import json
import logging
import os
import pathlib
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import docs_headers
import docs_links
import docs_nav

ROOT = pathlib.Path(__file__).resolve().parent.parent
LOOK = ROOT / "tools/docs"
PICTURES = (".png", ".jpg", ".webp", ".svg")
TEXTS = ("LICENSE", "NOTICE")
PLAY = """
<figure class="play" data-play="play/index.html"><img src="docs/web.jpg" alt="A meadow in the wind, with a fan and a stone">
<a class="md-button md-button--primary" href="play/index.html">Stroke the meadow</a>
<figcaption>The library in this page, as WebAssembly: stroke the grass with a finger or the mouse.
<a href="docs/web.html">What hands do.</a></figcaption></figure>
"""
NO_PLAY = """
[![A meadow in the wind, with a fan and a stone](docs/web.jpg)](docs/web.md)

*The meadow of [the page](docs/web.md), which `./dev web` makes.*
"""


class Fault(Exception):
    """A sentence for the one who made a page."""


# --- Pages -----------------------------------------------------------------------------------------------------------------


def outside_of_code(text, change):
    """The text with change(part) for each part that is no fenced block."""
    parts = re.split(r"(^ *```.*?^ *```[^\n]*$)", text, flags=re.MULTILINE | re.DOTALL)
    return "".join(part if n % 2 else change(part) for n, part in enumerate(parts))


def blank_before_blocks(text):
    """As GitHub reads lists, tables and fences behind a line of text; Python's Markdown wants a blank line before them."""
    lines, kind = [], ""
    for line in text.split("\n"):
        begins = "item" if re.match(r"(?:[-*]|\d+\.) ", line) else "row" if line.startswith("|") else ""
        if begins and kind and kind != begins:
            lines.append("")
        kind = begins or (kind if kind == "item" and line.startswith(" ") else "text" if line.strip() else "")
        lines.append(line)
    return "\n".join(lines)


def page_text(name, text, headers):
    """A page as the site has it: no comments for tests, and links to headers lead to the reference."""
    up = os.path.relpath(".", os.path.dirname(name) or ".")

    def link(found):
        label, target = found.groups()
        if "://" in target or target.startswith("#"):
            return found[0]
        target, mark, anchor = target.partition("#")
        path = os.path.normpath(os.path.join(os.path.dirname(name), target))
        if path in headers:
            return f"[{label}]({up}/api/{headers[path]})"
        if path in TEXTS:
            return f"[{label}]({up}/{path}.txt)"
        if path.endswith((".md", *PICTURES)):
            return found[0]
        if not (ROOT / path).exists():
            raise Fault(f"{name}: there is no {target}")
        return label   # a file of the repository that is no page

    def change(part):
        part = re.sub(r"[ \t]*<!--.*?-->", "", part, flags=re.DOTALL)
        # Code has no links; the name of a header is one.
        spans = [f"[{span}]({up}/api/{headers[span[1:-1]]})" if span[1:-1] in headers else span for span in re.findall(r"`[^`\n]*`", part)]
        part = re.sub(r"`[^`\n]*`", "\0", blank_before_blocks(part))
        part = re.sub(r"(?<!!)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)", link, part)
        return re.sub("\0", lambda _: spans.pop(0), part)
    return outside_of_code(re.sub(r"^<!--.*?-->\n", "", text, flags=re.MULTILINE | re.DOTALL), change)


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def stage(source, build, headers):
    """The pages, pictures and texts of the site, as mkdocs reads them."""
    for path in docs_nav.pages(ROOT):
        name = path.relative_to(ROOT).as_posix()
        text = page_text(name, path.read_text(encoding="utf-8"), headers)
        if name == "README.md":
            there = (build / "web/windrow.html").exists()
            head, mark, rest = text.partition("\n## ")
            first = head.index("\n\n", head.index("\n\n") + 2)   # below the title and its line
            text = head[:first] + "\n" + (PLAY if there else NO_PLAY) + head[first:] + mark + rest
            if there:
                (source / "play").mkdir(parents=True)
                shutil.copy(build / "web/windrow.html", source / "play/index.html")
            else:
                print(f"make_docs.py: {build / 'web/windrow.html'} is not there: the first page links no playground; ./dev web makes it")
        write(source / name, text)
    for path in sorted((ROOT / "docs").rglob("*")):
        if path.suffix in PICTURES:
            target = source / path.relative_to(ROOT)
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, target)
    for name in TEXTS:
        shutil.copy(ROOT / name, source / f"{name}.txt")
    for package in ("mkdocs-material", "doxygen"):   # their scripts and styles are in the site
        notice = pathlib.Path("/usr/share/doc", package, "copyright")
        if notice.exists():
            write(source / "assets" / f"{package}_copyright.txt", notice.read_text(encoding="utf-8"))
        else:
            print(f"make_docs.py: {notice} is not there: add the notice of {package} to the site before you publish it")
    for name in ("site.css", "site.js"):
        shutil.copy(LOOK / name, source / name)


# --- Reference -------------------------------------------------------------------------------------------------------------


def run_doxygen(work, source):
    """Makes source/api and work/xml from the headers in work/headers. Any warning fails."""
    layout = subprocess.run(["doxygen", "-l", "/dev/stdout"], stdout=subprocess.PIPE, text=True, check=True).stdout
    tab = '<tab type="user" url="../api.html" title="Documentation"/>\n    <tab type="mainpage" visible="no" title=""/>'
    write(work / "layout.xml", re.sub(r'<tab type="mainpage"[^>]*/>', tab, layout))
    write(work / "headers/index.md", "# Reference {#mainpage}\n\nThe <a href=\"../api.html\">list of headers</a> is its first page.\n")
    settings = (LOOK / "Doxyfile").read_text(encoding="utf-8")
    version = re.search(r'WINDROW_VERSION_STRING "([^"]+)"', (ROOT / "fluid/version.h").read_text(encoding="utf-8"))
    settings += f"""
INPUT = {work / "headers"}
STRIP_FROM_PATH = {work / "headers"}
STRIP_FROM_INC_PATH = {work / "headers"}
OUTPUT_DIRECTORY = {work}
HTML_OUTPUT = {source / "api"}
XML_OUTPUT = {work / "xml"}
LAYOUT_FILE = {work / "layout.xml"}
HTML_EXTRA_STYLESHEET = {LOOK / "api.css"}
WARN_LOGFILE = {work / "doxygen.txt"}
PROJECT_NUMBER = {version[1] if version else ""}
"""
    ran = subprocess.run(["doxygen", "-"], input=settings, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    said = (work / "doxygen.txt").read_text(encoding="utf-8") + ran.stderr
    if ran.returncode or said:
        raise Fault(f"doxygen warns (exit code {ran.returncode}):\n{said.replace(f'{work}/headers/windrow/', '')}")
    for page in (source / "api").glob("*.html"):
        text = page.read_text(encoding="utf-8")
        write(page, re.sub(r'(?<=<div class="summary">\n).*?(?=  </div>)', lambda found: summary(found[0], text), text, flags=re.DOTALL))


def summary(links, text):
    """The links to a page's sections, without those to sections that doxygen left out: private classes, macros without a value."""
    kept = [link for link in re.findall(r'<a href="#[\w-]+">[^<]*</a>', links) if f'name="{link[10:link.index(chr(34), 10)]}"' in text]
    return " &#124;\n".join(kept)


def words(element):
    return " ".join("".join(element.itertext()).split()) if element is not None else ""


def reference(xml):
    """({header: its page}, [entry of the search index]) of what doxygen wrote."""
    pages, entries = {}, []
    for compound in ElementTree.parse(xml / "index.xml").getroot():
        kind, page = compound.get("kind"), compound.get("refid") + ".html"
        if kind not in ("file", "class", "struct", "union"):
            continue
        whole = ElementTree.parse(xml / f"{compound.get('refid')}.xml").getroot().find("compounddef")
        name = words(whole.find("compoundname"))
        if kind == "file":
            name = whole.find("location").get("file")
            pages[name.removeprefix("windrow/")] = page
        short = name.removeprefix("windrow::")
        said = [" ".join((words(whole.find("briefdescription")), words(whole.find("detaileddescription"))))]
        places = [{"location": f"api/{page}#top", "title": short, "text": said[0]}]
        for member in whole.iter("memberdef"):
            at, _, anchor = member.get("id").rpartition("_1")
            if member.get("prot") == "public" and f"{at}.html" == page:
                own = words(member.find("name"))
                said.append(" ".join((words(member.find("type")), own + words(member.find("argsstring")) + ".",
                                      words(member.find("briefdescription")), words(member.find("detaileddescription")))))
                # A class's own names, such as profile, are not ahead of headings that explain them.
                places.append({"location": f"api/{page}#{anchor}", "title": own if kind == "file" else f"{short}::{own}", "text": said[-1]})
        # The search finds a place where it finds the page too, and shows the first place as the page.
        entries += [{"location": f"api/{page}", "title": short, "text": " ".join(said)}, *places]
    return pages, entries


def undocumented(xml):
    """{header: its number of public functions and fields without a comment of their own}."""
    found = {}   # by its id: a function of a namespace is on two pages
    for path in sorted(xml.glob("*.xml")):
        for member in ElementTree.parse(path).getroot().iter("memberdef"):
            said = "".join(words(member.find(part)) for part in ("briefdescription", "detaileddescription", "inbodydescription"))
            if member.get("prot") == "public" and member.get("kind") in ("function", "variable") and not said:
                found[member.get("id")] = member.find("location").get("file").removeprefix("windrow/")
    return collections.Counter(found.values())


def other_counts(found, listed):
    """A line for each header whose number is another one."""
    return [f"{header}: {found.get(header, 0)} declarations have no comment, tools/docs/undocumented.txt has {listed.get(header, 0)}: "
            f"{'comment the new ones' if found.get(header, 0) > listed.get(header, 0) else 'write the file again, with --accept'}"
            for header in sorted({*found, *listed}) if found.get(header, 0) != listed.get(header, 0)]


def check_undocumented(xml, accept):
    file = LOOK / "undocumented.txt"
    found = undocumented(xml)
    if accept:
        write(file, "".join(f"{header} {count}\n" for header, count in sorted(found.items())))
    lines = file.read_text(encoding="utf-8").splitlines() if file.exists() else []
    other = other_counts(found, {line.split()[0]: int(line.split()[1]) for line in lines})
    if other:
        raise Fault("comments are missing:\n" + "\n".join(other))


def api_page(pages, sentences):
    """The first page of the reference: each installed header with its sentence."""
    text = "# Reference of C++ and C\n\nThe installed headers, as doxygen reads them. C++ programs include them as\n" \
           "`<windrow/...>`. [The C interface](docs/c_api.md) has the same calls for other languages.\n" \
           "[All classes](api/annotated.html) and [all functions of C](api/globals_func.html) are listed by name.\n"
    parts = {"The wind (`windrow::fluid`)": r"fluid/(?!vdb/|vulkan/)", "Plants (`windrow::coupling`)": r"coupling/",
             "On a GPU (`windrow::vulkan`)": r"fluid/vulkan/", "Export to OpenVDB (`windrow::vdb`)": r"fluid/vdb/", "C (`windrow::c`)": r"c_api/"}
    for title, form in parts.items():
        text += f"\n## {title}\n\n| header | what it has |\n|---|---|\n"
        for header in (header for header in sentences if re.match(form, header)):
            text += f"| [{header}](api/{pages[header]}) | {sentences[header].replace('|', chr(92) + '|')} |\n"
    return text


# --- The site --------------------------------------------------------------------------------------------------------------


def run_mkdocs(source, site):
    sys.path.insert(0, str(ROOT / "tests/structure"))
    from check_examples import anchors   # GitHub's, to which the links of the pages lead

    from mkdocs import config as settings
    from mkdocs.commands import build
    from mkdocs.exceptions import Abort, MkDocsException

    def slug(title, _):
        return next(iter(anchors(f"# {title}")))

    extensions = ["tables", {"toc": {"slugify": slug, "permalink": True, "toc_depth": 3}}, "pymdownx.superfences",
                  {"pymdownx.highlight": {"guess_lang": False}}]
    logging.basicConfig(format="%(levelname)s: %(message)s", level=logging.WARNING)
    try:
        build.build(settings.load_config(str(LOOK / "mkdocs.yml"), docs_dir=str(source), site_dir=str(site), strict=True,
                                         nav=docs_nav.navigation(ROOT), markdown_extensions=extensions))
    except (Abort, MkDocsException) as fault:
        raise Fault(f"mkdocs stopped: {fault}") from fault
    for name in ("sitemap.xml", "sitemap.xml.gz"):   # of a site with an address
        (site / name).unlink()


def write_index(site, entries):
    """The index of pages and reference, as a script."""
    file = site / "search/search_index.json"
    index = json.loads(file.read_text(encoding="utf-8"))
    index["docs"] += entries
    text = json.dumps(index, ensure_ascii=False, separators=(",", ":"))
    file.unlink()
    # JSON in a string is read faster than as a script's own values.
    (site / "search/search_index.js").write_text(f"__search = {{index: Promise.resolve(JSON.parse({json.dumps(text)}))}};\n", encoding="utf-8")
    return len(index["docs"])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--accept", action="store_true", help="write tools/docs/undocumented.txt")
    options = parser.parse_args()
    build = options.build.resolve()
    work, site = build / "docs", build / "site"
    source = work / "pages"
    shutil.rmtree(work, ignore_errors=True)
    source.mkdir(parents=True)
    try:
        sentences = docs_headers.write(ROOT, work / "headers")
        run_doxygen(work, source)
        check_undocumented(work / "xml", options.accept)
        pages, entries = reference(work / "xml")
        stage(source, build, pages)
        write(source / "api.md", api_page(pages, sentences))
        run_mkdocs(source, site)
        count = write_index(site, entries)
        faults = docs_links.faults_of(site)
        if faults:
            raise Fault("links that lead nowhere:\n" + "\n".join(faults))
    except (Fault, docs_nav.Fault) as fault:
        sys.exit(f"make_docs.py: {fault}")
    size = sum(path.stat().st_size for path in site.rglob("*") if path.is_file())
    print(f"{site}: {sum(1 for _ in site.rglob('*.html'))} pages, {count} entries in the search, {size / 1e6:.0f} MB")


if __name__ == "__main__":
    main()
