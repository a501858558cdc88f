#!/usr/bin/env python3
"""Plants faults in small documents and asks the checkers of words, messages and examples to find each."""
import argparse
import pathlib
import tempfile
import unittest

import check_examples
import check_messages
import check_words

COMPILER = None
CLEAN = """# Wind

The box follows the player. It has a `rim` in code, and [a link](docs/shares.md#of-the-rim) in whose address no word is searched.

- One item
- another item, of which no fact is missing

| a table of any width | whose cells are no sentences, however many words they hold, so that nobody counts them at all, in any line |
|---|---|

    windrow run rim.json --frames 3        # settles, in code

```cpp
rim();
```
"""
WORDS = {"sides": "Open the sides.", "open side": "Beyond an open side.", "settling time": "The settling time.", "rim": "Near its rim.",
         "pieces": "The pieces of a step.", "source of air": "A source of air.", "lets": "It lets air in.", "owed": "It is owed.",
         "survey": "The survey.", "share": "A share of it.", "told": "It is told.", "says so": "It says so.", "refuses": "It refuses.",
         "whole or not": "Whole or not at all.", "fold": "They fold.", "knows": "It knows.", "but for": "None but for one.",
         "table": "| a rim | in a table |", "two lines": "It has\nsides."}


def faults_of(text):
    faults = []
    check_words.check_page("page.md", text, faults)
    return faults


class Words(unittest.TestCase):
    def test_a_clean_page_has_no_fault(self):
        self.assertEqual(faults_of(CLEAN), [])

    def test_each_word_to_avoid_is_found(self):
        for name, text in WORDS.items():
            with self.subTest(name):
                self.assertEqual(len(faults_of(text + "\n")), 1, faults_of(text))

    def test_long_lines_sentences_and_means_are_found(self):
        self.assertEqual(len(faults_of("word " * 25 + "\n")), 2)                                # the line, the mean
        self.assertEqual(len(faults_of(("one " * 20 + "\n") * 2 + "end.\n\nIt is. It has. It can.\n")), 1)    # 41 words; the mean is below
        self.assertEqual(faults_of(("one " * 20 + "\n") * 2 + "\n\nIt is. It has. It can.\n"), [])
        self.assertEqual(faults_of(("one " * 10 + "end.\n") + "- " + "two " * 10 + "\n- " + "three " * 10 + "\n"), [])
        self.assertEqual(faults_of("    " + "code " * 40 + "\n"), ["page.md:1: 204 characters: break the line at 120."])

    def test_a_number_ends_a_sentence_and_an_abbreviation_does_not(self):
        self.assertEqual([len(words) for _, words in check_words.sentences("It has 128. Ghia et al. have 3. `x.` is 1 word\n")], [3, 5, 4])

    def test_comments_and_messages_are_searched_on_request(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "cmake").mkdir()
            (root / "fluid").mkdir()
            (root / "cmake/public_headers.txt").write_text("# made by hand\nfluid/wind.h\n")
            (root / "fluid/wind.h").write_text('int rim; ///< near the rim\n//     create({.share = 1});\n#include "fluid/a share.h"\n')
            (root / "fluid/wind.cpp").write_text('// a rim\nerror("rim"); error("the rim is wide");\n')
            faults = []
            check_words.check_code(root, faults)
        self.assertEqual([fault.split(": ")[0] for fault in faults], ["fluid/wind.cpp:2", "fluid/wind.h:1"])


class Messages(unittest.TestCase):
    def test_messages_are_sentences_with_their_values_left_out(self):
        text = """reasons.add(path, " is ", value, // a comment "with. words"
                              ": give v//vn.");
        return fault("$.floor", "is \\"none\\": add it.\\n");
        console.out << message("one heading ", value);"""
        self.assertEqual(list(check_messages.messages(text)), ["is <>: give v//vn.", '$.floor is "none": add it.'])


class Examples(unittest.TestCase):
    PROGRAMS = {"windrow": {"": {"--help"}, "run": {"--frames", "--out"}}, "windrow-draw": {"": {"--size"}}}

    def commands(self, text):
        faults = []
        check_examples.check_commands({"page.md": text}, self.PROGRAMS, "./dev build   builds\n", faults)
        return len(faults)

    def test_commands_name_what_exists(self):
        self.assertEqual(self.commands("`windrow run a.json --frames 3` and `build/release/windrow-draw a.json --size 1x1`, `run --out a`\n"
                                       "# Then\n    ./dev build && windrow --help   # --none\n`--out DIR`, windrow none --none\n"), 0)
        for text in ("`windrow run --frame 3`", "```\nwindrow walk a.json\n```", "\n    windrow-draw a.json \\\n        --sizes 1x1\n",
                     "`windrow --frames 3`", "`run --none`", "`./dev bild`", "`--none`"):
            with self.subTest(text):
                self.assertEqual(self.commands(text + "\n"), 1)

    def test_links_lead_somewhere(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "other.md").write_text("# Of the side, and `more`\n")
            for text, count in (("[a](other.md#of-the-side-and-more) [b](https://x.y/z)", 0), ("[a](none.md)", 1), ("[a](other.md#more)", 1),
                                ("![a](none.png)", 1)):
                faults = []
                check_examples.check_links(root, {"page.md": text}, faults)
                self.assertEqual(len(faults), count, text)

    def test_code_compiles(self):
        if not COMPILER:
            self.skipTest("no compiler is given")
        good = "<!-- cpp\n#include <vector>\nextern std::vector<int> list;\n-->\n```cpp\nif (list.empty())\n    return 1;\n```\n"
        program = "```cpp\n#include <cstdio>\nint main() {\n    std::puts(\"\");\n}\n```\n"
        faults = []
        self.assertEqual(check_examples.check_code(COMPILER, (), {"a.md": good + program, "b.md": program}, faults), 3)
        self.assertEqual(faults, [])
        check_examples.check_code(COMPILER, (), {"a.md": good, "b.md": "\n```cpp\nint a = 1;\nwide b;\n```\n"}, faults)
        self.assertEqual([fault.split(":")[:2] for fault in faults], [["b.md", "4"]])


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--compiler")
    options, rest = parser.parse_known_args()
    COMPILER = options.compiler
    unittest.main(argv=["check_documents_test.py", *rest])
