"""Dataclasses of the Python package from the structs of the C interface and the tables of settings: bindings/python/windrow/settings.py.

A field has the default of its table; what a table does not hold is below. tests/bindings compares all defaults with the library's.
"""
import re
import textwrap

import mirrors

# Structs of C without a mark in the headers, and those of the marks that the package has no use for yet.
BESIDE = {"windrow_roughness_map": "RoughnessMap", "windrow_advance": None, "windrow_box": None, "windrow_obstacle_force": None,
          "windrow_drag_force": None}
LEFT_OUT = {"windrow_tree_classes", "windrow_tree_part", "windrow_flutter_class", "windrow_cascade_config", "windrow_ground_config",
            "windrow_ambient_settings"}
# Structs that forms.py has, as unions.
FORMS = {"windrow_region": "Region", "windrow_law": "Law", "windrow_wake_law": "WakeLaw", "windrow_shape": "Shape"}
HANDLES = {"windrow_gust_tile": "GustTile", "windrow_height_map": "HeightMap"}
NUMBERS = {"float": ("float", "0.0"), "double": ("float", "0.0"), "int32_t": ("int", "0"), "uint32_t": ("int", "0"), "int64_t": ("int", "0")}
VECTORS = {"vec2": "Vec2", "vec3": "Vec3", "dvec3": "Vec3", "ivec3": "IVec3", "quat": "Quat"}
# Defaults that no table holds.
DEFAULTS = {
    "DirectionalMotor.region": "Sphere()", "DirectionalMotor.law": "Drive()", "WakeMotor.law": "WakeDrive()",
    "JetMotor.law": "Drive(12.0, 8.0)", "VortexMotor.law": "Drive(8.0, 8.0)", "Obstacle.shape": "Block()",
    "Obstacle.orientation": "(0.0, 0.0, 0.0, 1.0)", "RoughnessMap.scale": "(1.0, 1.0, 1.0)",
    "WakeMotor.turbulence": "Turbulence(intensity=0.0)", "Config.follow_axes": "None", "Config.relaxation_time": "None",
    "Config.stages": "Stage.ALL",
}
# Fields that Python has in another form, with what they then say.
OTHER_FORMS = {
    "Config.follow_axes": ("str | None", 'Axes along which the box follows, such as "xz". Default None: those with two open boundaries; '
                                         "others cannot."),
    "Config.relaxation_time": ("float | None", None),
    "Config.stages": ("Stage", "Stages that run."),
}
# Fields without a comment of their own.
FIELDS = {"Box.cells": "Cells along x, y, z.", "Box.boundaries": "Conditions at its six faces.", "ObstacleForce.in_box":
          "1; 0: no part of it was in the box, and all else is 0."}
# Classes that no header describes.
SAID = {"Boundary": "Condition at one face of the box.", "Boundaries": "Conditions at the six faces of the box.",
        "Config": "Settings of a wind: 32 x 16 x 32 cells of 1 m, open air, no wind.", "SpringClass": "Class of plants that swing.",
        "Obstacle": "A body that the air flows around.", "BladeSettings": "Blades of grass of one class.",
        "ShellSettings": "Layers of fur or grass over a skin.", "StageTimes": "[ms] Wall-clock time of one step by stage.", "GroundConfig": "Settings of a ground's memory."}
HEAD = '''"""Settings and reports: a dataclass for each struct of the library, with its defaults.

{made} Lengths are metres, times
seconds; a range and a unit stand before the meaning. Values are checked where they are used: by the library, in one sentence.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import ClassVar, Literal

from . import _c
from ._library import library
from ._values import IVec3, Quat, Settings, Stage, Vec2, Vec3, metre
from .forms import {forms}

infinity = float("inf")
'''
OPEN_OVER_FLOOR = '''
    @staticmethod
    def all(kind: BoundaryKind) -> Boundaries:
        """All six of one kind."""
        return Boundaries(**{face: Boundary(kind=kind) for face in ("x_low", "x_high", "y_low", "y_high", "z_low", "z_high")})

    @staticmethod
    def open_over_floor() -> Boundaries:
        """Open air over a free-slip floor."""
        return Boundaries._from_c(library.windrow_boundaries_open_over_floor())
'''


class Classes:
    def __init__(self, interface, declarations):
        self.interface, self.declarations = interface, declarations
        self.header, self.tables = interface.parsed, interface.tables
        self.cpp = {c_name: cpp for cpp, c_name in interface.c_names.items() if c_name in self.header.structs}
        self.words = {c_name: self.tables["choices"][cpp] for cpp, c_name in interface.c_names.items() if c_name not in self.header.structs}
        self.order = []
        for name in [*self.cpp, *BESIDE]:
            self._put(name)

    def _put(self, name):
        if name in self.order or name in LEFT_OUT or not (name in self.cpp or name in BESIDE):
            return
        for kind, _, _ in self.header.structs[name]:
            self._put(re.sub(r"const |\*", "", kind))
        self.order.append(name)

    def _rows(self, name):
        cpp = self.cpp.get(name) or BESIDE.get(name)
        return {row["name"]: row for row in self.tables["structs"].get(cpp, ())}

    def _comment(self, name):
        """What the header says before a struct."""
        text = self.interface.headers[self.header.file_of[name]]
        found = re.search(rf"/\* ((?:(?!\*/).)*) \*/\n(?:/\* Made by [^\n]*\n)?typedef struct {name} \{{", text, flags=re.DOTALL)
        said = " ".join(found.group(1).split()) if found else ""
        said = SAID.get(mirrors.title(name)) or said
        if not said or "./dev schema" in said:
            raise ValueError(f"{name} has no comment: add it to SAID")
        return re.sub(r" \(fluid/\w+\.h\)", "", said.replace("windrow_wind_advance", "Wind.advance"))

    def _type(self, kind, row):
        """(annotation, default, whether the default is made anew for each object)."""
        inner = kind.removeprefix("const ").rstrip("*")
        if row and row["type"] == "bool":
            return "bool", {0: "False", 1: "True"}.get(row.get("default", 0)), False
        if inner in NUMBERS and "*" in kind:
            return "Sequence[float]", "()", False
        if kind in NUMBERS:
            annotation, none = NUMBERS[kind]
            value = row["default"] if row and "default" in row else None
            return annotation, none if value is None else self._number(value, annotation), False
        if kind in self.words:
            words = self.words[kind]
            return mirrors.title(kind), f'"{row["default"] if row and "default" in row else words[0]}"', False
        short = inner.removeprefix("windrow_")
        if short in VECTORS:
            value = row.get("default") if row else None
            number = "int" if short == "ivec3" else "float"
            zeros = [0] * int(short[-1]) if short != "quat" else [0, 0, 0, 1]
            return VECTORS[short], f"({', '.join(self._number(v, number) for v in value or zeros)})", False
        if inner in HANDLES:
            return f"{HANDLES[inner]} | None", "None", False
        if "*" in kind:
            return f"{mirrors.title(inner)} | None", "None", False
        if inner in FORMS:
            return FORMS[inner], None, True
        return mirrors.title(inner), f"{mirrors.title(inner)}()", True

    @staticmethod
    def _number(value, annotation):
        if annotation == "int":
            return str(int(value))
        return "infinity" if value == "infinity" else repr(float(value))

    def _said(self, row, comment):
        if not row:
            return comment
        said = row["meaning"].replace("{} for ", f"{row['type'].removeprefix('optional ')}() for ").replace("::", ".")
        unit = f"[{row['unit']}] " if "unit" in row else ""
        said = said.replace("AmbientWind.tile", "GustTile")
        span = row.get("range", "")
        if "vec" not in row["type"]:
            span = span.removeprefix("each component ")
        return unit + (f"{span[0].upper()}{span[1:]}. " if span else "") + said

    def _class(self, name):
        title = mirrors.title(name)
        rows = self._rows(name)
        text = f'\n\n@dataclass(kw_only=True, slots=True)\nclass {title}(Settings):\n'
        text += f'    """{self._comment(name)}"""\n\n    _struct: ClassVar = _c.{title}\n'
        if f"{name}_init" in self.header.functions:
            text += f'    _init: ClassVar = "{name}_init"\n'
        words = {}
        fields = ""
        body = re.search(rf"typedef struct {name} \{{\n(.*?)\}} {name};", self.interface.headers[self.header.file_of[name]],
                         flags=re.DOTALL).group(1)
        said = {declaration.split()[-1].lstrip("*"): comment for declaration, comment in self.declarations(body)}
        for kind, field, _ in self.header.structs[name]:
            if field in ("struct_size", "parallel_for", "height_count") or field.startswith("reserved"):
                continue
            row = rows.get(field) or self.interface._part_of(field, rows)
            annotation, default, made = self._type(kind, row)
            if kind in self.words:
                words[field] = tuple(self.words[kind])
            annotation = OTHER_FORMS.get(f"{title}.{field}", (annotation,))[0]
            if f"{title}.{field}" in DEFAULTS:
                default = DEFAULTS[f"{title}.{field}"]
                made = "(" in default and not default.startswith("(")
            if made:
                default = re.sub(r"^Drive\((\S+), ", r"Drive(\1 * metre(), ", default)  # a speed, in the host's unit
                default = f"field(default_factory={default[:-2]})" if default.endswith("()") else f"field(default_factory=lambda: {default})"
            fields += f"    {field}: {annotation} = {default}\n"
            comment = self._said(row, said.get(field, ""))
            if f"{title}.{field}" in OTHER_FORMS:
                comment = OTHER_FORMS[f"{title}.{field}"][1] or comment
            comment = FIELDS.get(f"{title}.{field}") or re.sub(r"\bnull\b", "None", comment)
            if comment:
                fields += textwrap.fill(f'"""{comment}"""', 116, initial_indent="    ", subsequent_indent="    ",
                                        break_long_words=False, break_on_hyphens=False) + "\n"
        shared = [(field, kind) for field, kind in re.findall(r"    (\w+): (\w+) \| None = None\n", fields) if kind in HANDLES.values()]
        if shared:
            text += "    _shared: ClassVar = {" + ", ".join(f'"{field}": {kind}' for field, kind in shared) + "}\n"
        if "relaxation_time" in fields:
            text += '    _not_negative: ClassVar = ("relaxation_time",)\n'
        if "follow_axes" in fields:
            text += '    _letters: ClassVar = {"follow_axes": "xyz"}\n'
        if words:
            rows = "".join(f"        {field!r}: {values!r},\n" for field, values in words.items()).replace("'", '"')
            text += f"    _words: ClassVar = {{\n{rows}    }}\n"
        return text + "\n" + fields + (OPEN_OVER_FLOOR if title == "Boundaries" else "")

    def text(self):
        used = "".join(self._class(name) for name in self.order)
        forms = sorted({word for word in [*FORMS.values(), *HANDLES.values(), "Block", "Drive", "Sphere", "WakeDrive"]})
        said = HEAD.format(made="Made by ./dev schema from the headers of c_api and the tables of settings. Do not edit.",
                           forms=", ".join(forms))
        for c_name, choices in sorted(self.words.items()):
            if f": {mirrors.title(c_name)} =" in used:
                said += f"{mirrors.title(c_name)} = Literal[{', '.join(chr(34) + word + chr(34) for word in choices)}]\n"
        words = [mirrors.title(name) for name in sorted(self.words) if f": {mirrors.title(name)} =" in used]
        names = [f'"{name}"' for name in [*map(mirrors.title, self.order), *words]]
        listed = textwrap.fill(", ".join(names), 116, initial_indent="    ", subsequent_indent="    ")
        return said + f"\n__all__ = [\n{listed},\n]\n" + used


def version(root):
    """The text of _version.py."""
    said = re.search(r'WINDROW_VERSION_STRING "(.*)"', (root / "fluid/version.h").read_text(encoding="utf-8")).group(1)
    return f'"""Made by ./dev schema from fluid/version.h. Do not edit."""\n__version__ = "{said}"\n'
