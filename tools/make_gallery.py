#!/usr/bin/env python3
"""make_gallery.py PROGRAM [NAME ...]: draws the looks into out/gallery and writes docs/gallery.md with their small pictures.

PROGRAM is the program build/release/windrow-draw. With names only those looks are drawn again; the page always lists all whose
picture is in docs/gallery. A look that cannot be drawn, since its mesh is missing, is reported and left out, and the
exit code is 1. Needs Python alone; ./dev gallery makes what the scenes name first.
"""
import json
import pathlib
import subprocess
import sys

import solved

ROOT = pathlib.Path(__file__).resolve().parents[1]
SCENES = ROOT / "examples" / "scenes"
PAGE = ROOT / "docs" / "gallery.md"
SMALL = ROOT / "docs" / "gallery"
SIZE = "1280x720"

# Heading; then scene, moment [s], what to look at.
LOOKS = (
    ("The fluid", (
        ("wolf", 1.7, "the wheat behind the wolf bows after it; what its wake has not reached stands in a light wind."),
        ("downwash", 2.0, "calm under the hub, then a ring of grass that is laid outward; farther off the mean wind leans it."),
        ("fur/fan", 1.0, "fur is pressed flat on the side of the fan and loose behind; the lane in the lawn parts around the bunny."),
        ("wheat", 3.0, "bands where the air dips into the wheat, and the still ones between."),
    )),
    ("Fur", (
        ("fur/bunny", 0.6, "the fur trails behind its turn; bare inner ear, short face; no layers on the outline."),
        ("fur/horse", 0.6, "mane and tail stream with the wind, the legs' hair does not; hooves are bare."),
        ("fur/bear", 0.6, "shells, length, thickness and density are the fur line of bear.mtl: the scene names none of them."),
        ("fur/beast", 1.0, "long tufts from close below: dark at the root, light through the tips against the sun."),
    )),
    ("Grass and floors", (
        ("fur/grass16", 1.0, "the lane that the fan blows: only a solver gives it. Below, the same grass without one."),
        ("fur/grass16_uniform", 1.0, "every blade leans alike, by one vector."),
        ("fur/field", 1.0, "bands of lighter green are moving gusts."),
        ("fur/carpet", 0.6, "the mesh has four vertices; the draught and what the ball presses are read at each root."),
        ("fur/snow", 0.6, "short strands that merge are powder; boulders are bare below by a spot."),
    )),
    ("Feathers, paper, spikes", (
        ("fur/wings", 0.6, "ovals overlap like tiles, each with its shaft; their ends lift."),
        ("fur/strips", 0.6, "strips of uv's cells in rows; the colour is a map."),
        ("fur/king", 0.6, "Voronoi's edges make the spikes; two lamps and the sun add up; tips come after the hop."),
    )),
    ("Clouds", (
        ("fur/clouds128", 1.0, "the same heaps as below, with 128 shells: no steps."),
        ("fur/clouds16", 1.0, "16 shells and four levels of light."),
    )),
    ("Where it began", (
        ("fur/naive", 0.6, "the baseline that docs/fur_cost.md measures against."),
        ("fur/hecomi", 0.6, "layers that are pushed and droop, the form of the shell literature."),
        ("fur/spheres18", 0.6, "the fan at the left blows through the middle row alone."),
        ("fur/step1_chance", 0.2, "one number a cell."),
        ("fur/step2_cylinders", 0.2, "what is above the layer's height stays."),
        ("fur/step3_cones", 0.2, "the radius falls with height."),
        ("fur/step4_sphere", 0.6, "along the normals, with the wind."),
    )),
    ("Meadows", tuple((f"looks/{name}", 1.5, text) for name, text in (
        ("tall", "seed heads above clumps; the grass behind the runner leans after him."),
        ("short", "a lawn with daisies; the lane before the fan, where blades and daisies are down."),
        ("violet", "violet and blue against a low sun; leaves point away from the blast."),
        ("path", "leaves that hang over; those beside the path turn after the runner."),
        ("yellow", "straw with ears; it turns with the whirl, one way before it and the other behind."),
        ("wind", "gusts run through, and stop behind the bales."),
        ("composition", "grass, straw, flowers, trees; the tufts at the left turn about the whirl.")))),
)


def draw(program, names):
    """Names of looks that could not be drawn."""
    SMALL.mkdir(parents=True, exist_ok=True)
    failed = []
    for _, looks in LOOKS:
        for look, moment, _ in looks:
            name = look.split("/")[-1]
            if names and name not in names:
                continue
            print(f"== {name}", flush=True)
            run = subprocess.run([program, str(SCENES / f"{look}.json"), "--frames", "1", "--from", str(moment), "--fps", "10", "--size", SIZE,
                                  "--out", str(ROOT / "out" / "gallery" / name), "--jpeg", str(SMALL)], check=False)
            if run.returncode != 0:
                failed.append(name)
    return failed


def text():
    """The page, of all looks that have a picture."""
    lines = ["# Gallery", "", "Fur and meadows in the wind. Each picture is one scene file of `examples/scenes`. Below each: what of its wind the",
             "solver makes, and what is prescribed and crosses the box as it is outside. To draw all of them:",
             "", "    ./dev gallery", ""]
    for heading, looks in LOOKS:
        shown = [(look, text) for look, _, text in looks if (SMALL / f"{look.split('/')[-1]}.jpg").is_file()]
        if shown:
            lines += [f"## {heading}", "", "| picture | scene, and what to look at |", "|---|---|"]
        for look, text in shown:
            name = look.split("/")[-1]
            scene = json.loads((SCENES / f"{look}.json").read_text(encoding="utf-8"))
            lines += [f"| ![{name}](gallery/{name}.jpg) | `{look}.json`: {scene.get('description', '')} Look at: {text}<br>*{solved.sentence(scene)}* |"]
        lines += [""] if shown else []
    return "\n".join(lines[:-1]) + "\n"


def main():
    names = sys.argv[2:]
    known = {look.split("/")[-1] for _, looks in LOOKS for look, _, _ in looks}
    unknown = [name for name in names if name not in known]
    if len(sys.argv) < 2 or unknown:
        fault = f"{unknown[0]} is not a look; give some of: {', '.join(sorted(known))}." if unknown else "usage: make_gallery.py PROGRAM [NAME ...]"
        print(f"make_gallery.py: {fault}", file=sys.stderr)
        sys.exit(2)
    failed = draw(sys.argv[1], names)
    PAGE.write_text(text(), encoding="utf-8")
    false = list(solved.faults())
    for fault in false:
        print(f"make_gallery.py: {fault}", file=sys.stderr)
    print(f"{PAGE.relative_to(ROOT)}: {sum(1 for _ in SMALL.glob('*.jpg'))} pictures")
    if failed:
        print(f"make_gallery.py: not drawn: {', '.join(failed)}; see above.", file=sys.stderr)
    if failed or false:
        sys.exit(1)


if __name__ == "__main__":
    main()
