#!/usr/bin/env python3
"""docs_links.py SITE: the faults of a site of static files: links, anchors, pictures and scripts that lead nowhere, anything that
another server would bring, and Markdown that was not understood."""
import html.parser
import pathlib
import re
import sys
import urllib.parse

BRINGS = {("img", "src"), ("script", "src"), ("link", "href"), ("iframe", "src"), ("source", "src"), ("figure", "data-play")}
# A list or a table that Python's Markdown took for text, and a link that it left.
LEFT = re.compile(r"(?:^|\n)\s*(?:[-*] |\|.*\|)|\]\([\w./#-]+\)|^```", re.MULTILINE)


class Page(html.parser.HTMLParser):
    """What a page has and where it leads."""

    def __init__(self, text):
        super().__init__()
        self.anchors, self.links, self.left = set(), [], []
        self.inside, self.code, self.text = None, 0, ""
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors.update(values[key] for key in ("id", "name") if values.get(key))
        for key, value in attributes:
            if value and ((tag, key) in BRINGS or (tag, key) in (("a", "href"), ("area", "href"))):
                self.links.append((self.getpos()[0], value, (tag, key) in BRINGS))
        if tag == "p":
            self.inside, self.text = self.getpos()[0], ""
        self.code += tag in ("code", "pre", "script")

    def handle_endtag(self, tag):
        self.code -= tag in ("code", "pre", "script")
        if tag == "p" and self.inside:
            found = LEFT.search(self.text)
            if found:
                self.left.append((self.inside, found[0].strip()))
            self.inside = None

    def handle_data(self, data):
        if self.inside and not self.code:
            self.text += data


def faults_of(site):
    site = pathlib.Path(site).resolve()
    files = {path.relative_to(site).as_posix() for path in site.rglob("*") if path.is_file()}
    # The playground is one file that was tested by itself.
    pages = {name: Page((site / name).read_text(encoding="utf-8")) for name in sorted(files) if name.endswith(".html") and not name.startswith("play/")}
    faults = []
    for name, page in pages.items():
        if name != "404.html" and not name.startswith("api/"):
            faults += [f"{name}:{line}: Markdown is left as text: '{text}'" for line, text in page.left]
        for line, link, brings in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme in ("data", "javascript") or (parts.scheme in ("http", "https", "mailto") and not brings):
                continue
            if parts.scheme or parts.netloc:
                faults.append(f"{name}:{line}: another server would bring {link}")
                continue
            path = urllib.parse.unquote(parts.path)
            # A page of errors is shown at any address and names files from the root.
            target = path.lstrip("/") if path.startswith("/") else (pathlib.PurePosixPath(name).parent / path).as_posix() if path else name
            target = "/".join(resolved(target.split("/")))
            target = target or "index.html"
            if target not in files:
                faults.append(f"{name}:{line}: there is no {target}")
            elif parts.fragment and target in pages and urllib.parse.unquote(parts.fragment) not in pages[target].anchors:
                faults.append(f"{name}:{line}: {target} has no anchor '{parts.fragment}'")
    for name in sorted(files):
        if name.endswith(".css"):
            style = re.sub(r"/\*.*?\*/", "", (site / name).read_text(encoding="utf-8"), flags=re.DOTALL)
            faults += [f"{name}: another server would bring {found}" for found in re.findall(r"(?:url\(|@import )[\"']?((?:https?:)?//[^\"')]*)", style)]
    return faults


def resolved(parts):
    found = []
    for part in parts:
        if part == ".." and found:
            found.pop()
        elif part not in (".", "", ".."):
            found.append(part)
        elif part == "..":
            found.append("..")   # outside of the site
    return found


def main():
    faults = faults_of(sys.argv[1])
    print("\n".join(faults) if faults else "no fault in the links")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
