#!/usr/bin/env python3
"""pipeline_tables.py PAGE NAME=REPORT...: writes docs/pipelines.md from report.json files of `windrow device-report --only pipelines`.

./dev pipelines runs it for two families of AMD, whose compiler Mesa has without a device.
"""
import json
import pathlib
import sys

COLUMNS = {"VGPRs": "VGPRs", "SGPRs": "SGPRs", "Spilled VGPRs": "spilled VGPRs", "Spilled SGPRs": "spilled SGPRs",
           "LDS size": "shared memory, bytes", "Code size": "code, bytes", "Instructions": "instructions",
           "Subgroups per SIMD": "subgroups a SIMD"}

HEAD = """# What a compiler makes of the passes

Registers, spills, shared memory and instructions of every pipeline, as Mesa's compiler for AMD (RADV, ACO) reports
them. No device is needed, and nothing here was measured on a GPU. The columns are the driver's own statistics.
`./dev pipelines` writes this page. `windrow device-report --only pipelines` prints the same for any device whose driver
has `VK_KHR_pipeline_executable_properties`.

The last three rows are a shader that samples the wind (docs/vulkan.md), the same for winds of equal rows, and the same
without the sample.
A pass that does not depend on the size of the box has one row. Subgroups a SIMD are the most that its registers and
shared memory leave room for.
"""


def key(row):
    return tuple(row.get(column) for column in COLUMNS)


def table(rows):
    """Rows of equal figures as one, with all their grids."""
    merged = {}
    for row in rows:
        merged.setdefault((row["pipeline"], key(row)), []).append(row["grid"])
    grids = list(dict.fromkeys(row["grid"] for row in rows if row["grid"] != "any" and " with " not in row["grid"]))
    lines = ["| pass | box | " + " | ".join(COLUMNS.values()) + " |", "|---|---|" + "---|" * len(COLUMNS)]
    passes = list(dict.fromkeys(row["pipeline"] for row in rows))
    for (name, figures), of in sorted(merged.items(), key=lambda item: passes.index(item[0][0])):
        box = "any" if set(grids) <= set(of) or of == ["any"] else ", ".join(of)
        lines.append(f"| {name} | {box} | " + " | ".join("-" if figure is None else str(figure) for figure in figures) + " |")
    return "\n".join(lines)


def main():
    page, *named = sys.argv[1:]
    text = HEAD
    for one in named:
        name, _, file = one.partition("=")
        report = json.loads(pathlib.Path(file).read_text())
        facts, rows = report["sections"]["facts"], report["sections"]["pipelines"]["pipelines"]
        spilled = sum(row.get("Spilled VGPRs", 0) + row.get("Spilled SGPRs", 0) for row in rows)
        words = "No pass spills." if spilled == 0 else f"{spilled} registers are spilled in all."
        text += f"\n## {name}\n{facts['driver']}. {words}\n\n"
        text += table(rows) + "\n"
    pathlib.Path(page).write_text(text)


if __name__ == "__main__":
    main()
