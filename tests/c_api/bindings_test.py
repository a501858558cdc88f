#!/usr/bin/env python3
"""bindings_test.py ROOT --compiler CC: the C interface and its mirrors are what the tables give, and a new setting reaches all of them.

The mirror in Python is laid out as a C compiler lays out the headers; languages_test.py compares C# with it, and Rust has asserts.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "bindings/python/windrow")]
import make_bindings
from c_header import Header
from mirrors import mirrors, title

COMPILER = "cc"
LAG = {"name": "lag", "type": "float", "meaning": "Lag of the air.", "unit": "s", "range": "0 to 9", "default": 0.5}
FIELD = "    /* [s] 0 to 9, default 0.5. Lag of the air. */\n    float lag;\n"
HEADER = """/* Made by ./dev schema from Form. */
typedef int32_t windrow_form;
enum { WINDROW_FORM_ROUND = 0, WINDROW_FORM_FLAT = 1 };
typedef struct windrow_ivec2 {
    int32_t x, y;
} windrow_ivec2;
/* Made by ./dev schema from Flame. */
typedef struct windrow_flame {
    double heat;
} windrow_flame;
/* Made by ./dev schema from Candle; by hand: marks, bits. */
typedef struct windrow_candle {
    uint32_t struct_size;
    float height; /* replaced */
    uint32_t bits; /* kept */
} windrow_candle;
"""


def tables():
    return {"structs": {"Candle": [{"name": "marks", "type": "other", "meaning": ""},
                                   {"name": "height", "type": "float", "meaning": "Height.", "default": 2}],
                        "Flame": [{"name": "heat", "type": "double", "meaning": "Heat."}]},
            "choices": {"Form": ["round", "flat"]}}


class Headers(unittest.TestCase):
    def fields(self, *rows):
        """The fields of windrow_candle with more rows."""
        changed = tables()
        changed["structs"]["Candle"][1:1] = rows
        made = make_bindings.Interface(changed, {"base.h": HEADER})
        self.assertEqual(make_bindings.Interface(changed, made.headers).headers, made.headers)  # made again it is the same
        self.assertIn("WINDROW_C_STRUCT_BUT(1, windrow_candle, Candle, ", made.lists(["base.h"]))
        return made.headers["base.h"].partition("struct windrow_candle {\n")[2].partition("}")[0]

    def fault(self, change):
        changed = tables()
        change(changed)
        with self.assertRaises(make_bindings.Fault) as caught:
            make_bindings.Interface(changed, {"base.h": HEADER})
        return str(caught.exception)

    def test_comments_are_those_of_the_rows(self):
        self.assertEqual(self.fields(), "    uint32_t struct_size;\n    /* Default 2. Height. */\n"
                                        "    float height;\n    /* kept */\n    uint32_t bits;\n")

    def test_a_new_field_is_last_and_leaves_no_padding(self):
        self.assertTrue(self.fields(LAG).endswith("    uint32_t bits;\n" + FIELD))
        heat = {"name": "flame", "type": "Flame", "meaning": "A."}
        self.assertTrue(self.fields(heat).endswith("    uint32_t bits;\n    /* 0 */\n    uint32_t reserved;\n"
                                                   "    /* A. */\n    windrow_flame flame;\n"))
        self.assertTrue(self.fields(heat, LAG).endswith("    windrow_flame flame;\n" + FIELD + "    /* 0 */\n    uint32_t reserved_2;\n"))

    def test_types_of_new_fields(self):
        for kind, declaration in (("bool", "int32_t new"), ("uint32", "uint32_t new"), ("ivec2", "windrow_ivec2 new"),
                                  ("Form", "windrow_form new"), ("Flame", "windrow_flame new"),
                                  ("optional Candle", "const windrow_candle* new"), ("Candle", "const windrow_candle* new")):
            with self.subTest(kind):
                self.assertIn(f"    {declaration};\n", self.fields({"name": "new", "type": kind, "meaning": "New."}))

    def test_a_new_word_is_a_value(self):
        changed = tables()
        changed["choices"]["Form"].append("bent")
        made = make_bindings.Interface(changed, {"base.h": HEADER})
        self.assertIn("enum { WINDROW_FORM_ROUND = 0, WINDROW_FORM_FLAT = 1, WINDROW_FORM_BENT = 2 };", made.headers["base.h"])
        said = mirrors(made.parsed)
        for path, value in (("bindings/python/windrow/_c/air.py", "FORM_BENT = 2"), ("examples/csharp/windrow_c/Air.cs", "Bent = 2"),
                            ("examples/rust/windrow_c/air.rs", "pub const FORM_BENT: Form = 2;")):
            self.assertIn(value, said[path])

    def test_what_would_break_the_interface_is_rejected(self):
        self.assertIn("windrow_candle.height has no row", self.fault(lambda changed: changed["structs"]["Candle"].pop()))
        self.assertIn("windrow_flame has no struct_size", self.fault(lambda changed: changed["structs"]["Flame"].append(LAG)))
        self.assertIn("WINDROW_FORM_ROUND = 0", self.fault(lambda changed: changed["choices"]["Form"].reverse()))
        self.assertIn("Candle::new is of a type", self.fault(
            lambda changed: changed["structs"]["Candle"].append({"name": "new", "type": "other", "meaning": ""})))
        self.assertIn("is made from Flame", self.fault(lambda changed: changed["structs"].pop("Flame")))


class Bindings(unittest.TestCase):
    def test_a_new_setting_reaches_the_interface_and_each_mirror(self):
        said = json.loads((ROOT / "c_api/tables.json").read_text(encoding="utf-8"))
        said["structs"]["Config"].insert(1, LAG)
        made = {path.relative_to(ROOT).as_posix(): text for path, text in make_bindings.made_files(ROOT, said).items()}
        changed = {path: text for path, text in made.items() if (ROOT / path).read_text(encoding="utf-8") != text}
        for path, there in (("c_api/config.h", FIELD), ("c_api/source/tables.h", "Config, cells, lag, cell_size,"),
                            ("bindings/python/windrow/_c/air.py", '("lag", c.c_float)'),
                            ("bindings/python/windrow/settings.py", "    lag: float = "),
                            ("examples/csharp/windrow_c/Air.cs", "Lag"), ("examples/rust/windrow_c/air.rs", "pub lag: f32,")):
            self.assertIn(there, changed.pop(path))
        self.assertEqual(changed, {})
        config = Header(ROOT / "c_api").structs["windrow_config"]
        headers = {path.removeprefix("c_api/"): text for path, text in made.items() if path.endswith(".h") and path.count("/") == 1}
        grown = Header(headers).structs["windrow_config"]
        self.assertEqual(grown[:len(config) + 1], [*config, ("float", "lag", 0)])

    def test_a_file_that_differs_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "fluid").mkdir()
            shutil.copy2(ROOT / "fluid/version.h", root / "fluid")
            for name in ("c_api", "bindings/python", "examples/csharp", "examples/rust"):
                shutil.copytree(ROOT / name, root / name)
            command = [sys.executable, "-B", ROOT / "tools/make_bindings.py", "--root", root, "--check"]
            done = subprocess.run(command, capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stdout + done.stderr), (0, ""))  # of the committed files too
            for name, old, new in (("c_api/config.h", "/* [m", "/* [k"), ("c_api/source/tables.h", "(windrow_", "( windrow_"),
                                   ("examples/rust/windrow_c/air.rs", "pub struct", "struct"),
                                   ("examples/csharp/windrow_c/Bodies.cs", "float", "double"),
                                   ("bindings/python/windrow/_c/air.py", "c_float", "c_double"),
                                   ("bindings/python/windrow/settings.py", "cell_size: float = 1.0", "cell_size: float = 2.0")):
                text = (root / name).read_text(encoding="utf-8")
                self.assertIn(old, text, name)
                (root / name).write_text(text.replace(old, new, 1), encoding="utf-8")
                done = subprocess.run(command, capture_output=True, text=True)
                self.assertEqual(done.returncode, 1, name)
                self.assertIn(name, done.stdout)
                (root / name).write_text(text, encoding="utf-8")


class Coverage(unittest.TestCase):
    def test_each_mirror_has_each_name(self):
        header = Header(ROOT / "c_api")
        texts = {language: "".join(path.read_text(encoding="utf-8") for path in sorted((ROOT / folder).glob(f"*.{language}")))
                 for language, folder in (("py", "bindings/python/windrow/_c"), ("cs", "examples/csharp/windrow_c"),
                                          ("rs", "examples/rust/windrow_c"))}
        for name in header.functions:
            for language, form in (("py", f'("{name}",'), ("cs", f" {name}("), ("rs", f"pub fn {name}(")):
                self.assertIn(form, texts[language])
        for name in header.structs:
            for language, form in (("py", f"class {title(name)}(c.Structure)"), ("cs", f"partial struct {title(name)}\n"),
                                   ("rs", f"pub struct {title(name)} {{")):
                self.assertIn(form, texts[language])
        values = [value for choice in header.choices.values() for value, _ in choice]
        for value in values:
            for language in ("py", "rs"):
                self.assertIn(value.removeprefix("WINDROW_"), texts[language])
        self.assertGreater(len(header.functions) + len(header.structs) + len(values), 560)


class Layout(unittest.TestCase):
    def test_python_is_laid_out_as_c(self):
        import _c
        structs = Header(ROOT / "c_api").structs
        lines = [f'printf("{name} %lu\\n", (unsigned long)sizeof({name}));' for name in structs]
        lines += [f'printf("{name}.{field} %lu\\n", (unsigned long)offsetof({name}, {field}));'
                  for name, fields in structs.items() for _, field, _ in fields]
        with tempfile.TemporaryDirectory() as folder:
            source, program = pathlib.Path(folder) / "layout.c", pathlib.Path(folder) / "layout"
            text = '#include "c_api/windrow.h"\n#include <stdio.h>\nint main(void) {\n' + "\n".join(lines) + "\nreturn 0;\n}\n"
            source.write_text(text, encoding="utf-8")
            subprocess.run([COMPILER, "-I", ROOT, "-o", program, source], check=True)
            said = subprocess.run([program], check=True, capture_output=True, text=True).stdout.split()
        for name, number in zip(said[::2], map(int, said[1::2])):
            struct, _, field = name.partition(".")
            mirror = getattr(_c, title(struct))
            self.assertEqual(getattr(mirror, field).offset if field else _c.air.c.sizeof(mirror), number, name)
        self.assertGreater(len(said), 2 * 600)


if __name__ == "__main__":
    if "--compiler" in sys.argv:
        at = sys.argv.index("--compiler")
        COMPILER = sys.argv[at + 1]
        del sys.argv[at:at + 2]
    ROOT = pathlib.Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else ROOT
    unittest.main()
