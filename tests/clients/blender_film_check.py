#!/usr/bin/env python3
"""blender_film_check.py WINDROW: plays examples/scenes/film.json, sets it up by tools/blender_sequence.py, and looks at the result.

The .blend that was saved is opened again: unit, frames, numbers and grids are those of the film, and a small picture of it shows the
wind in several colours. Needs Debian's blender.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
FIRST, FRAMES = 1001, 5

# Within Blender: facts of the scene that was saved, and of the picture.
LOOK = """
import bpy, json, sys
scene = bpy.context.scene
volume = bpy.data.objects["wind"].data
facts = {"unit": volume.velocity_unit, "fps": scene.render.fps / scene.render.fps_base, "start": scene.frame_start, "end": scene.frame_end}
shown = []
for frame in (scene.frame_start, scene.frame_end):
    scene.frame_set(frame)
    volume.grids.load()
    shown.append(volume.grids.frame)
facts["shown"] = shown
facts["velocity"] = volume.velocity_grid
facts["grids"] = sorted(grid.name for grid in volume.grids)
facts["bodies"] = len(bpy.data.objects["obstacles"].evaluated_get(bpy.context.evaluated_depsgraph_get()).data.vertices)
picture = bpy.data.images.load(sys.argv[sys.argv.index("--") + 1])
pixels = list(picture.pixels)
colours = {tuple(int(8 * value) for value in pixels[n : n + 3]) for n in range(0, len(pixels), 4)}
facts["colours"] = len(colours)
facts["blue"] = sum(b > 1.25 * r and b > 1.1 * g for r, g, b in zip(pixels[0::4], pixels[1::4], pixels[2::4])) / (len(pixels) / 4)
print("FACTS " + json.dumps(facts))
"""


def run(*words):
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(str(word) for word in words[:6])} ... ended with {done.returncode}:\n{done.stdout}")
    return done.stdout


def check(windrow):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        vdbs, blend, picture = folder / "film", folder / "film.blend", folder / "film.png"
        run(windrow, "run", ROOT / "examples/scenes/film.json", "--vdb", "--from", "4", "--frames", FRAMES, "--first-frame", FIRST, "--out", vdbs)
        tool = ["blender", "-b", "--factory-startup", "--python", ROOT / "tools/blender_sequence.py", "--"]
        run(*tool, vdbs, "--save", blend, "--render", picture, "--size", "192x108", "--samples", "4")
        look = folder / "look.py"
        look.write_text(LOOK, encoding="utf-8")
        text = run("blender", "-b", blend, "--python", look, "--", picture)
        facts = json.loads(text.split("FACTS ")[1].splitlines()[0])
        wanted = {"unit": "SECOND", "start": FIRST, "end": FIRST + FRAMES - 1, "shown": [FIRST, FIRST + FRAMES - 1], "velocity": "vel",
                  "grids": ["density", "obstacle", "speed", "vel"]}
        wrong = [f"{key} is {facts[key]}, not {value}" for key, value in wanted.items() if facts[key] != value]
        if abs(facts["fps"] - 24.0) > 1e-3:
            wrong.append(f"fps is {facts['fps']}, not 24")
        if facts["bodies"] < 8:
            wrong.append("the house has no mesh")
        if facts["colours"] < 20 or facts["blue"] < 0.02:
            wrong.append(f"the picture shows {facts['colours']} colours, {facts['blue']:.3f} of it blue: the wind is not seen")
        # A folder without files is a sentence and an exit code of 2.
        empty = folder / "empty"
        empty.mkdir()
        said = subprocess.run([str(word) for word in (*tool, empty)], capture_output=True, text=True, check=False)
        if said.returncode != 2 or "holds no files" not in said.stderr:
            wrong.append(f"an empty folder ends with {said.returncode}: {said.stderr}")
        print(json.dumps(facts))
        return wrong


if len(sys.argv) != 2:
    sys.exit(__doc__)
found = check(pathlib.Path(sys.argv[1]).resolve())
sys.exit("\n".join(found) if found else 0)
