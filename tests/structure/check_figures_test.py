#!/usr/bin/env python3
"""Plants faults in a small tree of pages and tests and asks the checker of figures to find each."""
import pathlib
import tempfile
import unittest

import check_figures

TEST = """// A comment with 7e-7.
constexpr double k_bound = 2e-3;
void judged(const std::string& name, double value) { WINDROW_EXPECT_FIGURE("helped/" + name, value, 4e-4); }
TEST(Air, IsFast) {
    const std::string name = std::string("air/") + kind.name;
    WINDROW_EXPECT_FIGURE(name + "/largest", worst, 1e-5);
    WINDROW_EXPECT_FIGURE("air/slowest", worst, k_bound);
    expect_at_least("air/order", order, 1.9);
    figure("air/seen", value);
    report(many ? "many" : "one", pair, 5e-5);
    judged("walk", 1.0);
}
TEST(Air, IsStill) { EXPECT_LE(speed, 2 * 1'000.0 + 0.25); }
"""
CASE = 'VerifyCase{.name = "cavity", .run = falling_bound(0.048, 64, 1.5, size)};\n'
CLEAN = """# Air

It is off by 3.1e-6 (bound 1e-5), and the slowest by 0.2 %. An order of 1.9 is asked (`Air.IsFast`, `Air*`).
<!-- figure: air/*/largest < 3.1e-6 <= 1e-5; air/slowest <= 2e-3; air/order >= 1.9 -->

- Speeds reach 1,000 m/s.
  <!-- test: Air.IsStill <= 1000; case: cavity <= .048 as "m/s" -->

| what | figure |
|---|---|
| two winds | 5e-5 <!-- figure: wind_parity.many <= 5e-5; wind_parity.one <= 5e-5 --> |
| in words | four ten-thousandths <!-- figure: helped/* <= 4e-4 as "four ten-thousandths" --> |

| once | 8e-8 |
|---|---|
| twice | 9e-9 |
<!-- none: measured by hand -->
"""


class Figures(unittest.TestCase):
    def faults(self, page, run=(), systems=""):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in {"tests/parity/air_test.cpp": TEST, "cases/cavity.cpp": CASE, "docs/page.md": page,
                               "docs/systems.md": systems, "README.md": "", "CONTRIBUTING.md": "", "CHANGELOG.md": ""}.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return check_figures.check(root, run)

    def test_a_clean_page_has_no_fault(self):
        self.assertEqual(self.faults(CLEAN), [])

    def test_each_fault_is_found(self):
        for old, new, said in (
                ("(bound 1e-5)", "(bound 1e-6)", "1e-5 of air/*/largest is not what is read there"),
                ("<= 1e-5; air/slowest", "<= 1e-6; air/slowest", "the tests do not hold air/*/largest to 1e-6, but to 1e-05"),
                ("air/slowest <= 2e-3", "air/slowest <= 3e-3", "the tests do not hold air/slowest to 3e-3"),
                ("air/order >= 1.9", "air/order <= 1.9", "the tests do not hold air/order to 1.9"),
                ("air/slowest", "air/quickest", "no test prints a figure named air/quickest"),
                ("Air.IsStill <=", "Air.IsLoud <=", "no test is named Air.IsLoud"),
                ("`Air.IsFast`", "`Air.IsNot`", "there is no test `Air.IsNot`"),
                ("cavity <= .048", "cavity <= .066", "the tests do not hold cavity to .066"),
                ("case: cavity", "case: none", "no case is named none"),
                ("<!-- none: measured by hand -->", "", "8e-8 names no test"),
                (" <!-- figure: wind_parity.many <= 5e-5; wind_parity.one <= 5e-5 -->", "", "5e-5 names no test"),
                ('as "four ten-thousandths"', 'as "five"', "'five' of helped/* is not read there"),
                ("air/slowest <= 2e-3;", "air/slowest;; air/seen =;", "is no claim")):
            with self.subTest(new):
                found = self.faults(CLEAN.replace(old, new))
                self.assertTrue(any(said in fault for fault in found), found)

    def test_a_run_is_compared(self):
        measured = [("air/thick/largest", 2e-6), ("air/thin/largest", 3.4e-6)]
        self.assertEqual(self.faults(CLEAN, measured), [])
        found = self.faults(CLEAN, [*measured, ("air/thin/largest", 4e-5)])
        self.assertEqual(len(found), 1, found)
        self.assertIn("a run measured 4e-05 for air/*/largest, the page prints 3.1e-6", found[0])
        page = "It is 0.02.\n<!-- figure: air/seen = 0.02 -->\n"
        self.assertEqual([len(self.faults(page, [("air/seen", value)])) for value in (0.02, 0.012, 0.028, 0.05, 0.005)], [0, 0, 0, 1, 1])

    def test_lines_of_a_run_are_read(self):
        with tempfile.NamedTemporaryFile("w", suffix=".txt") as file:
            file.write("[figure] air/a b 1.5e-06 1e-05\n[figure] seen 3 -\n[figure] air.order                2.1  >= 1.9\n"
                       "[figure] told      0.25  reported \nother\n")
            file.flush()
            self.assertEqual(check_figures.read_run(pathlib.Path(file.name)),
                             [("air/a b", 1.5e-6), ("seen", 3.0), ("air.order", 2.1), ("told", 0.25)])

    def test_rows_of_systems_name_what_shows_them(self):
        row = "| system | here | falls short |\n|---|---|---|\n| grass | {} | |\n"
        for text, count in (("`Air*`", 0), ("`looks/low.json`", 0), ("[air](air.md)", 0), ("it waves", 1), ("`Wave*`", 1)):
            with self.subTest(text):
                self.assertEqual(len(self.faults(CLEAN, systems=row.format(text))), count)


if __name__ == "__main__":
    unittest.main()
