#!/usr/bin/env python3
"""Plants faults in small sites, pages and headers, and asks the tools of ./dev docs and the comments of fields to find each."""
import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import docs_headers
import docs_links
import docs_nav
import field_comments
import make_docs

README = "# Windrow\n\n## What to read next\n| you are | start here | then |\n|---|---|---|\n| an analyst | {} | [air](docs/air.md) |\n"


def folder(files):
    root = tempfile.TemporaryDirectory()
    for name, text in files.items():
        path = pathlib.Path(root.name) / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return root


class Links(unittest.TestCase):
    def faults(self, body, **files):
        page = f'<html><body><h2 id="here">Here</h2><p>{body}</p></body></html>'
        with folder({"index.html": page, "api/wind.html": '<a id="step"></a>', "a.png": "", **{f"{name}.css": text for name, text in files.items()}}) as root:
            return docs_links.faults_of(root)

    def test_a_sound_site_has_no_fault(self):
        self.assertEqual(self.faults('<a href="api/wind.html#step">a</a> <a href="#here">b</a> <img src="a.png"> '
                                     '<a href="https://example.org/x">c</a> <code>| a |</code>'), [])

    def test_each_fault_is_found(self):
        for body in ('<a href="api/none.html">a</a>', '<a href="api/wind.html#walk">a</a>', '<a href="#there">a</a>', '<img src="b.png">',
                     '<script src="https://example.org/x.js"></script>', '<img src="//example.org/x.png">', '<a href="../outside.html">a</a>',
                     '</p><figure data-play="play/index.html"></figure><p>', "text\n- an item that is none", "text\n| a | row |", "[a](b.md)"):
            with self.subTest(body):
                self.assertEqual(len(self.faults(body)), 1, self.faults(body))

    def test_a_style_of_another_server_is_found(self):
        self.assertEqual(len(self.faults("", site='@import "https://example.org/font.css"; a { background: url(//example.org/x.png); }')), 2)
        self.assertEqual(self.faults("", site="/* https://example.org */ a { background: url(x.png); }"), [])


class Navigation(unittest.TestCase):
    PAGES = {"CONTRIBUTING.md": "# Contributing", "CHANGELOG.md": "# Changes", "SECURITY.md": "# Security", "docs/air.md": "# The air: how",
             "docs/decisions/README.md": "# Decisions\n\n| [two](02-b.md) |\n| [one](01-a.md) |\n", "docs/decisions/01-a.md": "# 01 A",
             "docs/decisions/02-b.md": "# 02 B"}
    NAMED = "[a](CONTRIBUTING.md), [b](CHANGELOG.md), [c](SECURITY.md), [d](docs/decisions/README.md), [e](docs/air.md#how)"

    def navigation(self, named=NAMED, **more):
        with folder({"README.md": README.format(named), **self.PAGES, **more}) as root:
            return docs_nav.navigation(pathlib.Path(root))

    def test_pages_are_in_the_order_of_the_table(self):
        found = self.navigation()
        self.assertEqual([next(iter(part)) for part in found], ["Windrow", "Analyst", "Reference"])
        self.assertEqual([next(iter(page)) for page in found[1]["Analyst"]], ["Contributing", "Changes", "Security", "Decisions", "The air"])
        self.assertEqual(found[1]["Analyst"][3]["Decisions"][1:], [{"02 B": "docs/decisions/02-b.md"}, {"01 A": "docs/decisions/01-a.md"}])

    def test_a_page_in_no_row_a_row_without_a_page_and_no_table_are_found(self):
        for text, arguments in (("docs/new.md", {"docs/new.md": "# New"}), ("docs/old.md", {"named": self.NAMED + ", [x](docs/old.md)"}),
                                ("no heading", {"docs/air.md": "no heading"}), ("What to read next", {"README.md": "# Windrow\n"}),
                                ("03-c.md", {"docs/decisions/03-c.md": "# 03 C"})):
            with self.subTest(text), self.assertRaisesRegex(docs_nav.Fault, text):
                self.navigation(**arguments)


class Pages(unittest.TestCase):
    def text(self, text, name="docs/air.md"):
        return make_docs.page_text(name, text, {"fluid/box.h": "box_8h.html"})

    def test_lists_and_tables_behind_text_have_a_blank_line(self):
        self.assertEqual(self.text("Two:\n- one\n  goes on\n- two\n\nThen:\n| a |\n|---|\n"), "Two:\n\n- one\n  goes on\n- two\n\nThen:\n\n| a |\n|---|\n")
        self.assertEqual(self.text("```\na\n- b\n```\n"), "```\na\n- b\n```\n")

    def test_comments_for_tests_are_left_out(self):
        self.assertEqual(self.text("0.1 <!-- figure: a < 1 -->, said.\n<!-- cpp\nint x;\n-->\n`<!-- kept`\n"), "0.1, said.\n`<!-- kept`\n")

    def test_links_lead_to_pages_of_the_site(self):
        self.assertEqual(self.text("[box](../fluid/box.h), `fluid/box.h`, [n](../NOTICE), [air](air.md#a), `[](wake)`"),
                         "[box](../api/box_8h.html), [`fluid/box.h`](../api/box_8h.html), [n](../NOTICE.txt), [air](air.md#a), `[](wake)`")
        self.assertEqual(self.text("[stories](../tests/bits)"), "stories")
        with self.assertRaisesRegex(make_docs.Fault, "no ../tests/none"):
            self.text("[x](../tests/none)")


class Headers(unittest.TestCase):
    def test_heads_tables_and_comments_of_c(self):
        made = docs_headers.cpp('// Air: moves.\n// So.\n#pragma once\nstruct A {\n    static constexpr auto settings() {\n        return "}";\n    }\n};\n', "a.h")
        self.assertEqual(made, "/// \\file a.h\n/// %Air: moves.\n/// %So.\n#pragma once\nstruct A {\n\n\n\n};\n")
        self.assertEqual(docs_headers.c("/* Air. */\n/* Made by ./dev schema from A. */\nint a; /* [m] */\n/* #if */\nint b;\n", "a.h"),
                         "/** \\file a.h\n Air. */\n/* Made by ./dev schema from A. */\nint a; /**< [m] */\n/** \\#if */\nint b;\n")
        self.assertEqual(docs_headers.sentence("// Air: moves.\n// So.\n"), "Air.")


class Undocumented(unittest.TestCase):
    XML = """<doxygen><memberdef id="a" kind="function" prot="public"><name>a</name><location file="windrow/a.h"/></memberdef>
        <memberdef kind="variable" prot="public"><briefdescription>Said.</briefdescription><location file="windrow/a.h"/></memberdef>
        <memberdef kind="function" prot="private"><location file="windrow/a.h"/></memberdef></doxygen>"""

    def test_public_declarations_without_a_comment_are_counted(self):
        with folder({"a.xml": self.XML, "b.xml": self.XML}) as root:
            self.assertEqual(make_docs.undocumented(pathlib.Path(root)), {"a.h": 1})

    def test_more_and_fewer_than_listed_are_found(self):
        self.assertEqual(make_docs.other_counts({"a.h": 1}, {"a.h": 1}), [])
        self.assertRegex(make_docs.other_counts({"a.h": 2}, {"a.h": 1})[0], "comment the new ones")
        self.assertRegex(make_docs.other_counts({"a.h": 1}, {"a.h": 1, "b.h": 1})[0], "b.h: 0 declarations .* --accept")


class FieldComments(unittest.TestCase):
    TABLES = {"Air": [{"name": "speed", "meaning": "Mean.", "unit": "m/s", "range": "0 to 9", "default": 3}, {"name": "file", "meaning": "A file."}]}
    HEADER = ("struct Air {\n    /// [m/s] 0 to 9, default 3. Mean.\n    float speed = 3.0f;\n    Map map{}; ///< null: none\n\n"
              "    static constexpr auto settings() {\n        return std::tuple{Setting(\"speed\", &Air::speed, {0.0, 9.0}, \"Mean.\"),\n"
              "                          Setting(\"file\", &Air::map, \"A file.\")};\n    }\n};\n")

    def made(self, header):
        missing = []
        return field_comments.with_comments(header, self.TABLES, "air.h", missing), missing

    def test_a_sound_header_stays(self):
        self.assertEqual(self.made(self.HEADER), (self.HEADER, []))

    def test_missing_and_other_comments_are_found_and_made(self):
        line = "    /// [m/s] 0 to 9, default 3. Mean.\n"
        for planted in (self.HEADER.replace(line, ""), self.HEADER.replace("default 3", "default 4"),
                        self.HEADER.replace(line, "").replace("3.0f;", "3.0f; ///< Mean.")):
            made, missing = self.made(planted)
            self.assertEqual((made, len(missing)), (self.HEADER, 1))
        self.assertRegex(self.made(self.HEADER.replace(" ///< null: none", ""))[1][0], "Air::map has no comment")

    def test_a_struct_or_a_field_that_is_not_there_is_a_fault(self):
        for old, new in (("Air", "Sea"), ("Map map{};", "Map other{};")):
            with self.subTest(old), self.assertRaises(field_comments.Fault):
                self.made(self.HEADER.replace(old, new))


if __name__ == "__main__":
    unittest.main()
