#!/usr/bin/env python3
"""solved.py [--check]: what of each scene's wind the solver makes, and what is prescribed, into docs/scenes.md.

Read from the scene files, so that no page can claim more than they hold. The mean wind, its profile, gusts and the ripples below a cell are
prescribed: they cross the box as they are outside. What motors, wakes of bodies, plants that slow the wind, rough ground and obstacles make of
it is solved.

With --check nothing is written: the table must be the scenes', and no description, nor a clause of docs/gallery.md, docs/scenes.md or
docs/systems.md that names a scene, may speak of the solver where that scene has nothing solved in it. Exit code 1 and a line each otherwise.
"""
import json
import math
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
BEGIN, END = "<!-- solved.py: begin -->", "<!-- solved.py: end -->"
CLAIM = re.compile(r"\b(solver|solved|solves|fluid)\b", re.IGNORECASE)
NAMED = re.compile(r"`((?:[a-z0-9_]+/)?[a-z0-9_]+\.json)`")
KINDS = {"omni": "source", "pressure": "blast", "directional": "directional motor"}


def counted(count, what, many=None):
    """a jet; 3 jets"""
    if count == 1:
        return f"{'an' if what[0] in 'aeiou' else 'a'} {what}"
    return f"{count} {many or what + 's'}"


def leads(path):
    points = path.get("points")
    return points is None or any(point[1:] != points[0][1:] for point in points)


def wakes_of_bodies(scene):
    """Names of what the picture moves along a path that no wake and no obstacle of the scene is on (scene/picture_air.h)."""
    picture, paths = scene.get("picture", {}), scene.get("paths", {})
    taken = {motor.get("path") for motor in scene.get("motors", []) if motor.get("kind") == "wake"}
    taken |= {obstacle.get("path") for obstacle in scene.get("obstacles", [])}
    names = []
    bodies = [(body.get("name", "body"), body.get("motion", {})) for body in picture.get("bodies", []) if body.get("coats")]
    for name, motion in bodies + [(walker["path"], walker) for walker in picture.get("walkers", [])]:
        path = motion.get("path")
        if path is None or path in taken or not motion.get("wake", True) or not leads(paths.get(path, {})):
            continue
        taken.add(path)
        names.append(name)
    return names


def solved(scene):
    """Parts of the wind that the solver makes; none: it carries the prescribed wind alone."""
    air, parts, kinds = scene.get("air", {}), [], {}
    for motor in scene.get("motors", []):
        kind = KINDS.get(motor["kind"], motor["kind"])
        kinds.setdefault(kind, []).append(motor.get("name", kind))
    for kind, names in kinds.items():
        own = f" ({names[0]})" if len(names) == 1 and names[0] != kind else ""
        parts.append(counted(len(names), kind, "vortices" if kind == "vortex" else None) + own)
    parts += [f"the wake of the {name}" for name in wakes_of_bodies(scene)]
    if "canopy" in air:
        parts.append(f"the drag of {air['canopy'].get('height', 0.8):g} m of plants")
    if scene.get("drag"):
        parts.append("the drag of " + counted(len(scene["drag"]), "deposit"))
    if any(stand.get("slows_air", True) for stand in scene.get("picture", {}).get("trees", [])):
        parts.append("the drag of its trees")
    if "roughness" in air:
        parts.append("the drag of rough ground")
    count = len(scene.get("obstacles", []))
    if count:
        parts.append("the flow around " + ("a body" if count == 1 else f"{count} bodies"))
    if scene.get("picture", {}).get("ground", {}).get("in_air"):
        parts.append("the flow over the hills")
    return parts


def prescribed(scene):
    air, parts = scene.get("air", {}), []
    speed = math.hypot(*air.get("ambient", [0]))
    if speed > 0:
        parts.append(f"a mean wind of {speed:.1f} m/s" + (" with a log profile" if "profile" in air else ""))
    gusts = air.get("gusts", {})
    if gusts and gusts.get("intensity", 0.25) > 0:
        parts.append("gusts")
    if scene.get("picture", {}).get("sampling", {}).get("detail", 0) > 0:
        parts.append("ripples below a cell")
    return parts


def sentence(scene):
    return f"Solved: {', '.join(solved(scene)) or 'nothing'}. Prescribed: {', '.join(prescribed(scene)) or 'still air'}."


def scenes():
    """Name below examples/scenes, without the ending, and content; single motors are the subject of docs/motors.md."""
    folder = ROOT / "examples" / "scenes"
    for file in sorted(folder.rglob("*.json")):
        name = file.relative_to(folder).as_posix().removesuffix(".json")
        if name != "scene.schema" and not name.startswith("motors/"):
            yield name, json.loads(file.read_text(encoding="utf-8"))


def table():
    lines = [BEGIN, "", "| scene | solved | prescribed |", "|---|---|---|"]
    lines += [f"| `{name}.json` | {', '.join(solved(scene)) or 'nothing'} | {', '.join(prescribed(scene)) or 'still air'} |"
              for name, scene in scenes()]
    return "\n".join([*lines, "", END])


def with_table(text):
    return text[:text.index(BEGIN)] + table() + text[text.index(END) + len(END):]


def false_claims(text, where, known):
    """Clauses of a page that name a scene and speak of the solver where nothing is solved."""
    own = text[text.index(END):] if END in text else text
    before = text[:text.index(BEGIN)] if BEGIN in text else ""
    for line in (before + own).splitlines():
        for clause in re.split(r"[;:,|] |\. ", line):
            if CLAIM.search(clause) and not re.search(r"\b(nothing|no)\b", clause):
                for name in NAMED.findall(clause):
                    scene = next((known[key] for key in (name, f"fur/{name}", f"looks/{name}") if key in known), None)
                    if scene is not None and not solved(scene):
                        yield f"{where}: \"{clause.strip()}\" names {name}, in which nothing is solved: say what moves it."


def faults():
    known = {f"{name}.json": scene for name, scene in scenes()}
    for name, scene in known.items():
        if CLAIM.search(scene.get("description", "")) and not solved(scene):
            yield f"examples/scenes/{name}: the description speaks of the solver, and nothing is solved in it: say what moves it."
    for page in ("gallery", "scenes", "systems"):
        yield from false_claims((ROOT / "docs" / f"{page}.md").read_text(encoding="utf-8"), f"docs/{page}.md", known)


def main():
    page = ROOT / "docs" / "scenes.md"
    text = page.read_text(encoding="utf-8")
    found = list(faults())
    if sys.argv[1:] == ["--check"]:
        if with_table(text) != text:
            found.append("docs/scenes.md: its table of what is solved is not the scenes': run tools/solved.py.")
    elif len(sys.argv) > 1:
        print("solved.py: usage: solved.py [--check]", file=sys.stderr)
        sys.exit(2)
    else:
        page.write_text(with_table(text), encoding="utf-8")
    for fault in found:
        print(fault, file=sys.stderr)
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
